"""The start panel as a child meets it: in a real JupyterLab, by keyboard and by mouse."""

import re

import numpy as np
import pytest

import dmp_teach
from tests.browser.test_lab import notebook_of
from tests.formats.motive_csv import lab as in_the_lab
from tests.formats.motive_csv import motive

NOTEBOOK = "explore.ipynb"
GOAL_2 = "Goal of stroke 2"


KERNEL = "window.jupyterapp.shell.currentWidget.sessionContext.session.kernel"
COUNT_SENT = f"""() => {{
    window.sent = 0;
    {KERNEL}.anyMessage.connect((_, {{ msg, direction }}) => {{
        // The still picture for print follows by itself, a second after the last drawing.
        const isStill = msg.content?.data?.content?.kind === 'still';
        if (direction === 'send' && msg.header.msg_type === 'comm_msg' && !isStill)
            window.sent += 1;
    }});
}}"""


@pytest.fixture(scope="module")
def notebook(lab):
    (lab.folder / NOTEBOOK).write_text(notebook_of("import dmp_teach as teach\nteach.explore()"))


@pytest.fixture
def panel(open_notebook, notebook):
    page = open_notebook(NOTEBOOK, again=True)
    page.locator(".dt-explore").scroll_into_view_if_needed()
    page.wait_for_selector(".dt-explore[data-dt-drawing]")
    page.wait_for_selector(".dt-robot img")
    return page


def line(page, stroke=0):
    return page.locator(".dt-paper .dt-robot-line").nth(stroke).get_attribute("d")


def pixels(page, place):
    return page.locator(place).screenshot()


def slider(page, name):
    return page.locator(".dt-knobs").get_by_role("slider", name=name)


def choose(page, letter):
    page.get_by_role("radio", name=f"the letter {letter}").check(force=True)
    page.wait_for_function(
        f"document.querySelector('.dt-paper title').textContent.includes('letter {letter}:')"
    )


def changed(page, get, before):
    """What `get` gives as soon as it differs from `before`."""
    for _ in range(100):
        now = get()
        if now != before:
            return now
        page.wait_for_timeout(50)
    raise AssertionError("nothing changed within 5 s")


def settled(page, get):
    """What `get` gives once it has stayed the same for a second."""
    before, now = None, get()
    while now != before:
        page.wait_for_timeout(1000)
        before, now = now, get()
    return now


def wait_for_writing(page):
    page.wait_for_selector(".dt-scene[data-dt-state='playing']", timeout=60_000)
    page.wait_for_selector(".dt-scene[data-dt-state='ready']", timeout=60_000)


@pytest.mark.parametrize(
    ("name", "key"), [("How many bumps", "ArrowRight"), ("How wide each bump is", "ArrowLeft")]
)
def test_a_slider_moved_by_keyboard_changes_the_robots_letter_its_number_and_its_pixels(
    panel, shot, name, key
):
    shot(panel, "start")
    knob, number = slider(panel, name), panel.locator(".dt-number")
    before = (line(panel), number.inner_text())
    seen = pixels(panel, ".dt-paper")
    knob.focus()
    for _ in range(6):
        panel.keyboard.press(key)
    changed(panel, lambda: line(panel), before[0])
    changed(panel, number.inner_text, before[1])
    assert changed(panel, lambda: pixels(panel, ".dt-paper"), seen)
    assert knob.evaluate(
        "node => node === document.activeElement"
    )  # JupyterLab has not taken the keys


def test_ds_second_goal_moved_up_the_bar_makes_a_p_that_the_robot_writes(panel, shot, ask):
    choose(panel, "D")
    count = slider(panel, "How many bumps")
    count.focus()
    for _ in range(24):
        panel.keyboard.press("ArrowRight")
    width = slider(panel, "How wide each bump is")
    width.focus()
    while not width.get_attribute("aria-valuetext").startswith("1.0,"):
        panel.keyboard.press("ArrowLeft")
    bar, bowl = settled(panel, lambda: (line(panel, 0), line(panel, 1)))
    badge = panel.locator(".dt-goal").nth(1).locator(".dt-badge").bounding_box()
    x, y = badge["x"] + badge["width"] / 2, badge["y"] + badge["height"] / 2
    far = panel.locator(".dt-paper").bounding_box()["height"] * 0.36
    panel.mouse.move(x, y)
    panel.mouse.down()
    panel.mouse.move(x, y - far / 2, steps=4)
    panel.mouse.move(x, y - far, steps=4)
    panel.mouse.up()
    assert changed(panel, lambda: line(panel, 1), bowl)
    assert line(panel, 0) == bar
    panel.wait_for_function(
        "document.querySelector('.dt-sentence').textContent.includes('goal of stroke 2')"
    )
    shot(panel, "p_on_paper")
    robot = pixels(panel, ".dt-robot")
    panel.get_by_role("button", name="Robot, write it").click()
    panel.get_by_role("progressbar").first.wait_for()
    wait_for_writing(panel)
    shot(panel, "p_written")
    assert pixels(panel, ".dt-robot") != robot
    assert int(panel.locator(".dt-scene").get_attribute("data-dt-ink")) > 0
    assert panel.locator(".dt-table .dt-caption").inner_text().endswith("Fetch")
    slider(panel, "How many bumps").press("ArrowLeft")
    panel.get_by_text("older letter").wait_for()


def test_a_ring_takes_focus_arrows_move_it_a_millimetre_and_home_puts_it_back(panel):
    choose(panel, "D")
    ring = panel.locator(".dt-paper").get_by_role("slider", name=GOAL_2)
    before = settled(panel, lambda: line(panel, 1))
    ring.focus()
    panel.keyboard.press("ArrowUp")
    panel.keyboard.press("Shift+ArrowRight")
    changed(panel, lambda: line(panel, 1), before)
    assert ring.get_attribute("aria-valuetext") == "1.0 centimetres right, 0.1 centimetres up"
    panel.keyboard.press("Home")
    panel.wait_for_function(
        "document.querySelectorAll('.dt-goal')[1].getAttribute('aria-valuetext') === 'as written'"
    )
    assert changed(panel, lambda: line(panel, 1) == before, False)


def test_every_control_has_a_name_and_is_reached_by_the_tab_key(panel):
    choose(panel, "D")
    names = panel.locator(".dt-explore").aria_snapshot()
    for name in (
        "Letter",
        "Goal of stroke 1",
        GOAL_2,
        "How many bumps",
        "Goal, left and right",
        "Robot, write it",
    ):
        assert re.search(rf'(radiogroup|group|slider|button) "{name}', names), name
    panel.get_by_role("radio", name="the letter D").focus()
    reached = []
    for _ in range(16):
        panel.keyboard.press("Tab")
        reached.append(
            panel.evaluate(
                "document.activeElement.getAttribute('aria-label') "
                "?? document.activeElement.innerText"
            )
        )
    assert any(GOAL_2 in name for name in reached)
    assert any("Robot, write it" in name for name in reached)


def test_a_recording_of_ones_own_is_opened_and_a_wrong_file_gets_a_sentence(panel, shot, tmp_path):
    chooser = panel.locator("input[type=file]")
    chooser.set_input_files(
        {"name": "notes.csv", "mimeType": "text/csv", "buffer": b"shopping,list\nmilk,2\n"}
    )
    warning = panel.get_by_role("alert")
    warning.wait_for()
    assert "notes.csv" in warning.inner_text()
    shot(panel, "wrong_file")
    ours = dmp_teach.recording_of("b")
    chooser.set_input_files(motive(tmp_path / "b_w77.csv", ours.t, in_the_lab(ours.position)))
    panel.get_by_role("radio", name="your own b").wait_for(state="attached")
    panel.wait_for_function(
        "document.querySelector('.dt-paper title').textContent.startsWith('Your own b:')"
    )
    assert panel.get_by_role("radio", name="your own b").is_checked()
    assert warning.is_hidden()


def sent(page):
    """How many messages of widgets have gone to the kernel since the count began."""
    return page.evaluate("window.sent")


def drag(page, place, way, steps=20):
    """Press in the middle of a place and move; every line that was seen on the way."""
    box = page.locator(place).bounding_box()
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    page.mouse.move(x, y)
    page.mouse.down()
    seen = []
    for step in range(1, steps + 1):
        page.mouse.move(x + way[0] * step / steps, y + way[1] * step / steps)
        seen.append(line(page))
    return seen


def places(page):
    """The points of the robot's line as they are drawn [px]."""
    return np.array(re.findall(r"-?[\d.]+", line(page)), dtype=float)


def test_while_a_goal_is_held_the_kernel_hears_nothing_and_then_once(panel, ask):
    panel.evaluate(COUNT_SENT)
    answered = panel.locator(".dt-explore").get_attribute("data-dt-drawing")
    assert len(set(drag(panel, ".dt-goal .dt-ring", (60, -40)))) == 20
    assert sent(panel) == 0
    mine = places(panel)
    panel.mouse.up()
    panel.wait_for_selector(f".dt-explore:not([data-dt-drawing='{answered}'])")
    assert sent(panel) == 1
    assert np.abs(places(panel) - mine).max() <= 0.011  # both are rounded to 0.01 px
    goal = slider(panel, "Goal, left and right")
    for control, key in ((panel.locator(".dt-goal"), "ArrowUp"), (goal, "ArrowLeft")):
        control.focus()
        before = (line(panel), sent(panel))
        seen = []
        for _ in range(3):
            panel.keyboard.down(key)
            seen.append(line(panel))
        assert len({before[0], *seen}) == 4
        assert sent(panel) == before[1]
        panel.keyboard.up(key)
        assert changed(panel, lambda: sent(panel), before[1]) == before[1] + 1
    before = sent(panel)
    middle = ".dt-slider:has-text('Goal, down and up') input"
    assert len(set(drag(panel, middle, (60, 0), steps=5))) == 5
    assert sent(panel) == before
    panel.mouse.up()
    assert changed(panel, lambda: sent(panel), before) == before + 1
    assert ask(panel, "1") == "1"


def test_a_goal_moves_while_the_kernel_computes_and_when_there_is_none(panel):
    panel.allows.append("console error: Could not send widget sync message")
    panel.evaluate(f"{KERNEL}.requestExecute({{code: 'import time; time.sleep(5)'}}) && null")
    assert len(set(drag(panel, ".dt-goal .dt-ring", (-50, 30)))) == 20
    panel.mouse.up()
    panel.evaluate("window.jupyterapp.shell.currentWidget.sessionContext.shutdown()")
    assert len(set(drag(panel, ".dt-goal .dt-ring", (50, 30)))) == 20
    panel.mouse.up()
    panel.get_by_text("The robot does not answer").wait_for()
    assert len(set(drag(panel, ".dt-goal .dt-ring", (20, 30)))) == 20
