"""How the pad looks and sounds: on tablets, small laptops, and to a screen reader."""

import numpy as np
import pytest

import dmp_teach
from tests.browser.pads import (
    Sheet,
    by_mouse,
    caught,
    into_sight,
    letter,
    open_pad,
    press,
    strokes,
)

LEFT, RIGHT = (f".dt-stage > div:{which}-child" for which in ("first", "last"))
ONE_LINE = 1.7  # of its font's size: what is higher has wrapped
LINES = """nodes => nodes.map((node) => {
    const range = document.createRange();
    range.selectNodeContents(node);
    return range.getBoundingClientRect().height / parseFloat(getComputedStyle(node).fontSize);
})"""


@pytest.fixture
def panel(open_notebook, lab):
    return lambda again=True, **context: open_pad(open_notebook, lab, again=again, **context)


def write(page, ask, size=1.0, number=1):
    by_mouse(page, Sheet(page, ask).on_screen(letter(step=12, size=size)), pause=5)
    page.mouse.up()
    strokes(page, number)


def again(page):
    press(page, "Start again")
    strokes(page, 0)
    into_sight(page)


def test_on_tablets_no_heading_breaks_and_the_sheets_stand_side_by_side(panel, ask, shot):
    page = panel(viewport={"width": 1280, "height": 1200})
    page.evaluate("() => jupyterapp.shell.collapseLeft()")
    page.wait_for_timeout(400)
    into_sight(page)
    write(page, ask)
    for width in (690, 720, 780, 800, 880):
        page.set_viewport_size({"width": width, "height": 1200})
        page.wait_for_timeout(400)
        assert page.locator(".dt-stage .dt-choice").bounding_box()["height"] < 48
        sheets = [page.locator(f"{side} .dt-sheet").bounding_box() for side in (LEFT, RIGHT)]
        captions = [page.locator(f"{side} .dt-caption").bounding_box() for side in (LEFT, RIGHT)]
        assert sheets[0]["y"] == sheets[1]["y"]
        for sheet, caption in zip(sheets, captions, strict=True):
            assert caption["y"] + caption["height"] <= sheet["y"]
        inside = page.locator(f"{RIGHT} .dt-caption > *").evaluate_all(
            "all => all.map((n) => n.getBoundingClientRect().bottom)"
        )
        assert max(inside) <= sheets[1]["y"]
        shot(page, f"pad_{width}")


def test_yours_lies_on_the_robots_own_letter_where_the_number_compares_them(panel, ask, shot):
    page = panel()
    pixels = Sheet(page, ask).on_screen(np.add(letter(step=12), (0.012, 0.01)))
    by_mouse(page, pixels, pause=5)
    page.mouse.up()
    strokes(page, 1)
    assert page.get_by_role("radio", name="The robot’s own letter").is_checked()
    dots = page.locator(f"{RIGHT} .dt-child-dots")
    dots.wait_for(state="attached")
    page.locator(".dt-told", has_text="with your dots on it").wait_for()
    boxes = [place.bounding_box() for place in (dots, page.locator(f"{RIGHT} .dt-robot-line"))]
    assert np.allclose(*[[box["x"], box["y"]] for box in boxes], atol=5), (
        "shifted to where the robot's is"
    )
    assert (
        "Your letter and the robot’s own are this far apart"
        in page.locator(".dt-sentence").inner_text()
    )
    shot(page, "pad_own")
    again(page)
    assert dots.count() == 0


def test_six_tries_stand_in_line_and_between_tries_nothing_jumps(panel, ask, shot):
    page = panel(viewport={"width": 1400, "height": 1400})
    for size in (1.0, 0.5, 0.7, 1.3, 1.0, 1.2):
        write(page, ask, size)
        below = (
            page.locator(".dt-footer").bounding_box()["y"]
            - page.locator(".dt-stage").bounding_box()["y"]
        )
        again(page)
        waits = (
            page.locator(".dt-footer").bounding_box()["y"]
            - page.locator(".dt-stage").bounding_box()["y"]
        )
        assert abs(below - waits) < 2
    shot(page, "pad_six")
    for width in (1400, 1000, 700):
        page.set_viewport_size({"width": width, "height": 1400})
        page.wait_for_timeout(300)
        for what in (".dt-tries .dt-caption > *", ".dt-tries li > span"):
            assert max(page.locator(what).evaluate_all(LINES)) < ONE_LINE
    page.locator(".dt-letters input[value='']").check(force=True)
    page.wait_for_function("document.querySelectorAll('.dt-tries li').length === 0")
    gap = page.locator(".dt-footer").bounding_box()["y"]
    gap -= sum(page.locator(".dt-says").bounding_box()[side] for side in ("y", "height"))
    assert gap < 24, "no hole where the rows were"


def test_what_is_read_aloud_is_read_once(panel, ask):
    page = panel()
    page.evaluate("""() => {
        window.heard = [];
        const box = document.querySelector('.dt-box .dt-spoken');
        const all = { childList: true, characterData: true, subtree: true };
        new MutationObserver(() => window.heard.push(box.textContent)).observe(box, all);
    }""")
    page.wait_for_timeout(800)
    page.evaluate("window.heard.length = 0")
    press(page, "Undo")
    press(page, "Start again")
    page.wait_for_timeout(1000)
    assert page.evaluate("window.heard") == []
    write(page, ask)
    page.wait_for_function("window.heard.length === 1")
    assert "far apart on average" in page.evaluate("window.heard[0]")


def test_the_list_of_letters_has_groups_and_tells_small_ones_from_capitals(panel):
    page = panel()
    groups = page.locator(".dt-pad select optgroup").evaluate_all(
        "all => all.map((group) => group.label)"
    )
    assert groups == ["Small letters", "Capitals", "Digits", "With accents"]
    names = page.locator(".dt-pad select option").evaluate_all(
        "all => all.map((option) => option.ariaLabel)"
    )
    assert {
        "the letter b, small",
        "the letter B, capital",
        "the digit 7",
        "the letter \u00e4, small",
    } <= set(names)
    page.locator(".dt-pad select").select_option("B")
    page.wait_for_function(
        "document.querySelector('.dt-hint').textContent.startsWith('Write a B here')"
    )


def test_a_stroke_that_is_being_written_does_not_come_onto_the_sheet_of_another_letter(panel, ask):
    page = panel()
    pixels = Sheet(page, ask).on_screen(letter(step=12))
    by_mouse(page, pixels[:10])
    assert ask(page, "setattr(pad, 'character', 'i')") == "None"
    page.wait_for_function("document.querySelector('.dt-hint').textContent.includes('an i')")
    for place in pixels[10:]:
        page.mouse.move(*place)
    page.mouse.up()
    page.wait_for_timeout(300)
    strokes(page, 0)
    assert ask(page, "pad.recordings") == "()"


def test_a_pen_that_leaves_the_sheet_is_told_so(panel, ask):
    page = panel()
    sheet = page.locator(".dt-ink").bounding_box()
    middle, below = sheet["x"] + sheet["width"] / 2, sheet["y"] + sheet["height"] + 30
    by_mouse(
        page,
        [
            (middle, below - 120),
            *((middle + 8 * k, below) for k in range(6)),
            (middle + 40, below - 90),
        ],
    )
    page.mouse.up()
    strokes(page, 1)
    page.locator(
        ".dt-caught", has_text="Your pen left the sheet: write a little smaller."
    ).wait_for()
    bottom = float(ask(page, "pad.sheet[1]"))
    assert caught(page, ask)[:, 1].min() < bottom - 0.005, "the ink is where the pen was"


def test_on_a_small_laptop_the_letter_the_sentence_and_the_robot_are_seen_together(
    panel, ask, shot
):
    page = panel(again=False, viewport={"width": 1366, "height": 768})
    assert len(dmp_teach.recording_of("a").strokes()) == 1
    write(page, ask)
    press(page, "Robot, write it")
    page.wait_for_selector(".dt-scene[data-dt-state='playing']", timeout=60_000)
    page.wait_for_timeout(300)
    room = page.locator(".jp-NotebookPanel-notebook").bounding_box()
    dots, words, scene = (
        page.locator(place).bounding_box()
        for place in (f"{LEFT} .dt-child-dots", ".dt-says", ".dt-scene")
    )
    assert dots["y"] + 0.5 * dots["height"] > room["y"], "most of the letter"
    assert dots["y"] < words["y"] < scene["y"]
    assert scene["y"] + scene["height"] <= room["y"] + room["height"] + 1
    shot(page, "pad_laptop")
