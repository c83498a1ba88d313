"""What newcomers stumbled over: small screens, many presses, a new kernel, own colours."""

import numpy as np
import pytest

from tests.browser.test_lab import notebook_of

NOTEBOOK = "explore.ipynb"
LAPTOP = {"viewport": {"width": 1366, "height": 768}}
WRITE = "Robot, write it"


@pytest.fixture(scope="module")
def notebook(lab):
    (lab.folder / NOTEBOOK).write_text(notebook_of("import dmp_teach as teach\nteach.explore()"))


@pytest.fixture
def panel(open_notebook, notebook):
    def open_panel(**context):
        page = open_notebook(NOTEBOOK, again=True, **context)
        page.wait_for_selector(".dt-explore[data-dt-drawing]")
        page.locator(".dt-stage").evaluate("node => node.scrollIntoView({ block: 'start' })")
        page.wait_for_selector(".dt-robot img")
        return page

    return open_panel


def box(page, place):
    found = page.locator(place).first.bounding_box()
    return found["x"], found["y"], found["x"] + found["width"], found["y"] + found["height"]


def apart(a, b):
    return a[2] <= b[0] or b[2] <= a[0] or a[3] <= b[1] or b[3] <= a[1]


def test_on_a_small_laptop_sheet_robot_number_and_sliders_are_seen_together(panel, shot):
    page = panel(**LAPTOP)
    top, bottom = box(page, ".jp-NotebookPanel-notebook")[1::2]
    for place in (
        ".dt-paper",
        ".dt-robot img",
        ".dt-number",
        ".dt-write",
        ".dt-knobs input >> nth=1",
    ):
        assert box(page, place)[1] >= top - 1, place
        assert box(page, place)[3] <= bottom, place
    shot(page, "small_laptop")


def test_the_numbers_of_ds_goals_keep_off_the_ruler_and_nothing_jumps_while_one_is_dragged(panel):
    page = panel(**LAPTOP)
    page.get_by_role("radio", name="the letter D, capital").check(force=True)
    page.wait_for_function("document.querySelectorAll('.dt-goal').length === 2")
    page.wait_for_timeout(300)
    ruler = box(page, ".dt-paper g > .dt-small")
    badges = page.locator(".dt-goal .dt-badge")
    for n in range(2):
        assert apart(box(page, f".dt-goal >> nth={n} >> .dt-badge"), ruler)
    rows = [".dt-stage", ".dt-number", ".dt-sentence", ".dt-knobs", ".dt-more"]

    def places():
        """Where the rows are in the panel, whatever JupyterLab scrolls."""
        left, top = box(page, ".dt-explore")[:2]
        return [
            (x0 - left, y0 - top, x1 - left, y1 - top)
            for x0, y0, x1, y1 in (box(page, row) for row in rows)
        ]

    before = places()
    held = badges.nth(1).bounding_box()
    x, y = held["x"] + held["width"] / 2, held["y"] + held["height"] / 2
    page.mouse.move(x, y)
    page.mouse.down()
    for far in (20, 80, 2000, -2000):
        page.mouse.move(x + far / 3, y - far)
        page.wait_for_timeout(150)
        assert np.allclose(places(), before, atol=0.5)
    page.mouse.up()


def test_a_finger_drags_a_ring_and_scrolls_the_notebook_only_beside_it(panel):
    page = panel(**LAPTOP, has_touch=True)
    page.wait_for_timeout(500)
    hand = page.context.new_cdp_session(page)

    def swipe(x, y, dx, dy):
        """Where the notebook was scrolled to, before and after."""
        scrolled = "document.querySelector('.jp-WindowedPanel-outer').scrollTop"
        before = page.evaluate(scrolled)
        hand.send(
            "Input.dispatchTouchEvent", {"type": "touchStart", "touchPoints": [{"x": x, "y": y}]}
        )
        for part in np.linspace(0.1, 1, 10):
            points = [{"x": x + float(part) * dx, "y": y + float(part) * dy}]
            hand.send("Input.dispatchTouchEvent", {"type": "touchMove", "touchPoints": points})
            page.wait_for_timeout(20)
        hand.send("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})
        page.wait_for_timeout(500)
        return before, page.evaluate(scrolled)

    ring = box(page, ".dt-goal .dt-ring")
    before, after = swipe((ring[0] + ring[2]) / 2, (ring[1] + ring[3]) / 2, -60, -80)
    assert before == after
    moved = box(page, ".dt-goal .dt-ring")
    assert np.allclose(np.subtract(moved, ring), [-60, -80, -60, -80], atol=3)
    left, top = box(page, ".dt-paper")[:2]
    before, after = swipe(left + 30, top + 200, 0, -80)
    assert after > before + 20
    assert page.locator(".dt-goal").get_attribute("aria-valuetext") != "as written"


def test_stop_is_one_button_from_the_first_report_to_the_last(panel):
    page = panel()
    page.evaluate("""() => {
        const seen = new Set();
        const work = document.querySelector('.dt-work');
        const look = () => work.querySelectorAll('button').forEach((button) => seen.add(button));
        new MutationObserver(look).observe(work, { childList: true, subtree: true });
        window.buttonsSeen = seen;
    }""")
    page.get_by_role("button", name=WRITE).click()
    page.wait_for_selector(".dt-scene[data-dt-state='playing']", timeout=60_000)
    assert page.evaluate("window.buttonsSeen.size") == 1
    assert "plan" in page.locator(".dt-table .dt-spoken").inner_text()


def test_a_kernel_that_was_started_anew_does_not_answer_and_the_picture_stays(panel):
    page = panel()
    line = page.locator(".dt-paper .dt-robot-line").get_attribute("d")
    page.evaluate("() => jupyterapp.shell.currentWidget.sessionContext.session.kernel.restart()")
    page.wait_for_timeout(1000)
    page.get_by_role("button", name=WRITE).click()
    page.get_by_text("The robot does not answer").wait_for(timeout=10_000)
    assert page.locator(".dt-paper .dt-robot-line").get_attribute("d") == line


def test_in_colours_of_ones_own_the_line_stands_out_from_the_sheet_in_both_themes(panel):
    page = panel()
    page.emulate_media(forced_colors="active")
    for light in ("true", "false"):
        page.evaluate(f"() => document.body.dataset.jpThemeLight = '{light}'")
        line = page.locator(".dt-paper .dt-robot-line").evaluate(
            "node => getComputedStyle(node).stroke"
        )
        sheet = page.locator(".dt-paper").evaluate("node => getComputedStyle(node).backgroundColor")
        assert {line, sheet} == {"rgb(0, 0, 0)", "rgb(255, 255, 255)"}
