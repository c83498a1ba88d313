"""What the pad does when the pen is lifted, as a child sees it."""

from tests.browser.pads import PAD, Sheet, by_mouse, into_sight, letter, press, strokes
from tests.browser.test_lab import notebook_of

GHOST = ".dt-stage > div:first-child .dt-rest"
ROBOTS = ".dt-stage > div:first-child .dt-robot-line"


def write(page, way):
    by_mouse(page, way, pause=10)
    page.mouse.up()


def test_a_missed_stroke_is_shown_and_then_written_by_the_robot(open_notebook, lab, ask, shot):
    (lab.folder / "lift.ipynb").write_text(notebook_of(PAD.replace("pad()", "pad('t')")))
    page = open_notebook("lift.ipynb")
    page.wait_for_selector(".dt-pad[data-dt-drawing]")
    into_sight(page)
    sheet = Sheet(page, ask)
    ways = [sheet.on_screen(letter("t", stroke)) for stroke in (0, 1)]
    write(page, ways[0])
    strokes(page, 1)
    for miss in range(1, 4):
        write(page, ways[1][::-1])
        page.locator(".dt-sentence", has_text="starts at the wrong end").wait_for()
        page.wait_for_timeout(500)
        assert page.locator(GHOST).count() == (miss >= 2)
        shot(page, f"lift_miss_{miss}")
    press(page, "Why?")
    page.wait_for_selector(".dt-pad[data-dt-showing]")
    page.wait_for_timeout(300)
    shot(page, "lift_why")
    page.wait_for_selector(".dt-pad:not([data-dt-showing])")
    write(page, ways[1][::-1])
    page.get_by_text("the robot wrote it for you").wait_for()
    assert page.locator(ROBOTS).count() == 1
    page.wait_for_timeout(400)
    shot(page, "lift_robot")
