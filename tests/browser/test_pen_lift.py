"""What the pad does when the pen is lifted, as a left-handed child sees it."""

import time

from tests.browser.pads import (
    PAD,
    Sheet,
    by_mouse,
    caught,
    farthest,
    into_sight,
    letter,
    press,
    strokes,
)
from tests.browser.test_lab import notebook_of

GHOST = ".dt-stage > div:first-child .dt-rest"
ROBOTS = ".dt-stage > div:first-child .dt-robot-line"


def write(page, way):
    by_mouse(page, way, pause=5)
    page.mouse.up()


def test_on_turned_paper_a_missed_stroke_is_shown_and_then_written_by_the_robot(
    open_notebook, lab, ask, shot
):
    (lab.folder / "lift.ipynb").write_text(
        notebook_of(PAD.replace("pad()", "pad('t', hand='left')"))
    )
    page = open_notebook("lift.ipynb")
    page.wait_for_selector(".dt-pad[data-dt-drawing]")
    into_sight(page)
    sheet = Sheet(page, ask)
    stem, bar = (sheet.on_screen(letter("t", stroke)) for stroke in (0, 1))
    assert stem[-1][0] < stem[0][0] - 50, "a line downwards leads to the left: with the clock"
    for miss in range(1, 4):
        write(page, stem[::-1])
        page.locator(".dt-sentence", has_text="starts at the wrong end").wait_for()
        page.wait_for_timeout(500)
        assert page.locator(GHOST).count() == (miss >= 2)
        shot(page, f"lift_miss_{miss}")
    assert farthest(caught(page, ask), sheet.in_metres(stem)) < 0.001
    for turn in ("once", "and again"):
        begun = time.monotonic()
        press(page, "Why?")
        page.wait_for_selector(".dt-pad[data-dt-showing]")
        if turn == "once":
            page.wait_for_timeout(300)
            shot(page, "lift_why")
        page.wait_for_selector(".dt-pad:not([data-dt-showing])")
        assert time.monotonic() - begun > 2, turn
    write(page, stem[::-1])
    page.get_by_text("the robot wrote it for you").wait_for()
    assert page.locator(ROBOTS).count() == 1
    write(page, bar[::-1])
    strokes(page, 2)
    page.locator(".dt-sentence", has_text="The robot wrote stroke 1 for you").wait_for()
    page.wait_for_timeout(400)
    shot(page, "lift_robot")
