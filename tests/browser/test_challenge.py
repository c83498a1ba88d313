"""The example of a teacher's own lesson, from two misses and a hint to the green card."""

import re

from tests.browser.conftest import PATIENCE

EXAMPLE = "a_lesson_of_your_own.ipynb"
CARD = ".dt-challenge .dt-card"
TOO_FAR = re.compile(r"The e: \d\.\d+ mm\. It must be at most 1 mm\.")


def test_the_example_turns_green_and_shows_only_what_the_teacher_chose(open_notebook, ask, shot):
    page = open_notebook(EXAMPLE, viewport={"width": 820, "height": 1180})
    panel, card = page.locator(".dt-explore"), page.locator(CARD)
    card.wait_for(timeout=PATIENCE)
    assert panel.get_by_role("slider").locator("visible=true").count() == 1
    assert (
        panel.locator(".dt-goal, .dt-table, .dt-letters, .dt-write").locator("visible=true").count()
        == 0
    )
    panel.scroll_into_view_if_needed()
    shot(page, "own_panel")
    check = card.get_by_role("button", name="Check")
    for _ in range(2):
        assert card.get_by_role("button", name="Show a hint").count() == 0
        check.press("Enter")
        card.locator(".dt-reason", has_text=TOO_FAR).wait_for()
    card.get_by_role("button", name="Show a hint").press("Enter")
    card.locator(".dt-hints", has_text="Look where the line").wait_for()
    card.scroll_into_view_if_needed()
    shot(page, "own_hint")
    slider = panel.get_by_role("slider", name="How many bumps")
    for _ in range(9):
        slider.press("ArrowRight")
    page.wait_for_function("parseFloat(document.querySelector('.dt-number').innerText) < 1")
    check.press("Enter")
    page.wait_for_selector(".dt-challenge .dt-passed")
    said = card.locator(".dt-ask").inner_text()
    assert re.search(r"You did it: the e 0\.\d+ mm, bumps 14\.$", said), said
    assert ask(page, "card.progress['passed'], panel.answer['n_kernels']") == "(True, 14)"
    card.scroll_into_view_if_needed()
    shot(page, "own_green")
