"""Panels as files: opened from disk, with the network cut, and alive where no kernel is needed."""

import re

import numpy as np
import pytest

import dmp_teach as teach
from tests.browser.test_explore import drag

READY = ".dt-panel[data-dt-drawing]"
VIEWPORT = {"width": 1366, "height": 768}
# Lines are drawn to a hundredth of a pixel; here they are wanted as they were computed.
EXACTLY = "Number.prototype.toFixed = function () { return String(Number(this)); };"
RESTS = "What is grey needs a running notebook."
GREY = ("the letter a, small", "How many bumps", "How wide each bump is", "Open your own recording")


@pytest.fixture(scope="module")
def panels():
    return {"explore": teach.explore("a"), "lesson": teach.lesson("05").panel()}


@pytest.fixture
def file(panels, request, tmp_path):
    return panels[request.param].html(tmp_path / "panel.html")


def line(page):
    """The points of the robot's line as they are drawn [px], shape (N, 2)."""
    paths = page.locator(".dt-paper .dt-robot-line").evaluate_all(
        "nodes => nodes.map(node => node.getAttribute('d')).join('')"
    )
    return np.array(re.findall(r"-?[\d.]+", paths), dtype=float).reshape(-1, 2)


@pytest.mark.parametrize("file", ["explore"], indirect=True)
def test_a_dragged_goal_takes_the_line_where_the_kernel_would_and_the_rest_rests(
    opened, panels, shot
):
    page = opened(EXACTLY, color_scheme="dark")
    page.wait_for_selector(".dt-paper .dt-robot-line[d]")
    learned = panels["explore"].learned
    taught = np.concatenate([stroke.position for stroke in learned.write()])
    before = line(page)
    scale = np.ptp(taught[:, 1]) / np.ptp(before[:, 1]) * np.array([1, -1])
    assert len(set(drag(page, ".dt-goal .dt-ring", (60, -40)))) == 20
    page.mouse.up()
    drawn = taught[0] + (line(page) - before[0]) * scale
    shift = (drawn - taught)[-1].round(4)
    assert np.linalg.norm(shift) > 0.01
    expected = np.concatenate([each.position for each in learned.write(goal_shifts={0: shift})])
    assert np.abs(drawn - expected).max() < 1e-6 * np.ptp(taught)
    assert page.get_by_text(RESTS).is_visible()
    controls = [page.get_by_label(name).first for name in GREY]
    for control in (*controls, page.get_by_role("button", name="Robot, write it")):
        assert control.is_disabled()
    shot(page, "explore_file")
    page.get_by_role("button", name="Put the goals back").click()
    assert np.abs(line(page) - before).max() < 1e-6
    page.wait_for_timeout(4200)
    assert page.get_by_text("does not answer").is_hidden()


@pytest.mark.parametrize("file", ["lesson"], indirect=True)
def test_a_bet_is_drawn_the_truth_laid_over_it_and_the_ring_leads_the_letter(opened, shot):
    page = opened(viewport={"width": 820, "height": 1180})
    assert not len(line(page)), "the truth is hidden"
    handle = page.locator(".dt-handle").first
    handle.focus()
    handle.press("ArrowDown")
    page.get_by_role("button", name="Lay the truth over it").press("Enter")
    assert len(line(page))
    assert page.locator(".dt-paper .dt-bet-line").first.get_attribute("d")
    shot(page, "lesson_file_truth")
    page.get_by_role("button", name="Now try it").press("Enter")
    assert len(set(drag(page, ".dt-goal .dt-ring", (-40, 30)))) == 20
    page.mouse.up()
    assert page.get_by_role("radio", name="3 Challenge").is_disabled()
    assert page.get_by_role("slider", name="When the goal moves").is_disabled()
    shot(page, "lesson_file_try")
