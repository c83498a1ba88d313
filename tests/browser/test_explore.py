"""The start panel as a child meets it: in a real JupyterLab, by keyboard and by mouse."""

import pytest

NOTEBOOK = "00_start_here.ipynb"


@pytest.fixture
def panel(open_notebook):
    page = open_notebook(NOTEBOOK)
    page.locator(".dt-explore").scroll_into_view_if_needed()
    page.wait_for_function("document.querySelector('.dt-explore')?.dataset.dtDrawing > 0")
    page.wait_for_selector(".dt-scene[data-dt-awake='true']")
    return page


def line(page):
    return page.locator(".dt-explore .dt-robot-line").first.get_attribute("d")


def test_look(panel, shot):
    shot(panel, "start")
    panel.get_by_role("radio", name="the letter D").check(force=True)
    panel.wait_for_timeout(500)
    panel.get_by_role("slider", name="How many bumps").focus()
    for _ in range(28): panel.keyboard.press("ArrowRight")
    panel.get_by_role("slider", name="How wide").focus()
    for _ in range(30): panel.keyboard.press("ArrowLeft")
    panel.wait_for_timeout(500)
    ring = panel.locator(".dt-goal").nth(1).locator(".dt-badge")
    box = ring.bounding_box()
    panel.mouse.move(box["x"]+14, box["y"]+14); panel.mouse.down(); panel.mouse.move(box["x"]+14, box["y"]-60, steps=5); panel.mouse.move(box["x"]+14, box["y"]-130, steps=5); panel.mouse.up()
    panel.wait_for_timeout(500)
    shot(panel, "d_to_p")
    panel.get_by_role("button", name="Robot, write it").click()
    panel.wait_for_timeout(300)
    shot(panel, "working")
    panel.wait_for_selector(".dt-scene[data-dt-state='playing']")
    shot(panel, "playing")
    panel.wait_for_selector(".dt-scene[data-dt-state='ready']")
    shot(panel, "written")
