"""What a pupil lands in: one lesson, its panel awake, the strip of lessons, and no Jupyter."""

import json
import urllib.request

import pytest

from tests.browser.conftest import PATIENCE, TOKEN, run_all
from tests.browser.test_lab import notebook_of

START = "00_start_here.ipynb"
OTHER = "01_an_other_lesson.ipynb"
PANEL = ".dt-lesson[data-dt-drawing]"
JUPYTERS = ".jp-NotebookPanel-toolbar, #jp-menu-panel, #jp-top-panel, .jp-SideBar, #jp-bottom-panel"
STARTS_KERNEL = """() => [...jupyterapp.shell.widgets("main")]
    .find(each => each.context.path.endsWith("00_start_here.ipynb")).sessionContext.session?.kernel
"""
IS_GRASPED = """node => {
    const { left, top, height } = node.getBoundingClientRect();
    return node.contains(document.elementFromPoint(left + 8, top + height / 2));
}"""


@pytest.fixture
def lesson(lab, open_notebook):
    """Open a lesson as the launcher does, beside another one of a cell that is not ours."""
    other = lab.folder / OTHER
    other.write_text(notebook_of("import os\nstarted = True"))
    yield lambda name, **context: open_notebook(name, run=False, view="doc", **context)
    other.unlink()


@pytest.mark.parametrize(("width", "height"), [(1366, 768), (1280, 800), (820, 1180)])
def test_a_lesson_wakes_by_itself_and_stands_alone_until_the_menus_are_wanted(
    lesson, shot, width, height
):
    page = lesson(START, viewport={"width": width, "height": height}, shared=True)
    page.wait_for_selector(PANEL, timeout=PATIENCE)
    shot(page, f"lesson_view_{width}")
    assert page.locator(JUPYTERS).locator("visible=true").count() == 0
    here = page.get_by_role("navigation", name="Lessons").locator("[aria-current=page]")
    assert here.inner_text().split("\n") == ["00", "Start here"]
    seen = page.locator(".dt-body").bounding_box()
    assert seen["y"] >= 52, "below the strip"
    assert seen["y"] + seen["height"] - 12 < height + 1, "and all of it in sight, without a scroll"
    first = page.locator(".dt-step-bar label").first
    assert first.evaluate(IS_GRASPED), "its left end, where JupyterLab has a button without a look"
    menus = page.get_by_role("button", name="Menus")
    menus.click()
    page.get_by_role("menuitem", name="Kernel").wait_for()
    assert menus.get_attribute("aria-pressed") == "true"
    menus.click()
    page.get_by_role("menuitem", name="Kernel").wait_for(state="hidden")
    assert page.locator(JUPYTERS).locator("visible=true").count() == 0


def test_a_panel_lives_on_when_its_page_is_loaded_anew(lesson, ask, shot):
    page = lesson(START)
    page.wait_for_selector(PANEL, timeout=PATIENCE)
    happened = page.get_by_role("heading", name="What happened")
    happened.wait_for(state="hidden")
    page.locator("[data-dt-why]").scroll_into_view_if_needed()
    shot(page, "lesson_view_why")
    page.get_by_role("radio", name="about 40", exact=True).check(force=True)
    page.wait_for_function(
        "!document.querySelector('.dt-card .dt-main').getAttribute('aria-disabled')"
    )
    page.wait_for_function("!jupyterapp.shell.currentWidget.context.model.dirty")
    page.reload()
    page.wait_for_selector(PANEL, timeout=PATIENCE)
    assert page.get_by_role("radio", name="about 40", exact=True).is_checked()
    assert ask(page, "len(Out)") == "1"
    page.get_by_role("button", name="Lay the truth over it").click()
    happened.wait_for()


def test_a_link_opens_a_lesson_in_which_only_a_press_runs_what_is_not_ours(lesson, ask):
    """The kernel of the lesson that is left ends; on return its work is taken up by another one."""
    page = lesson(START)
    page.wait_for_selector(PANEL, timeout=PATIENCE)
    page.get_by_role("radio", name="about 40", exact=True).check(force=True)
    page.get_by_role("button", name="Lay the truth over it", disabled=False).click()
    page.get_by_role("button", name="Now try it").wait_for()
    page.get_by_role("link", name="01 An other lesson").click()
    page.wait_for_url("**/01_an_other_lesson.ipynb*")
    page.get_by_role("link", name="01 An other lesson").and_(
        page.locator("[aria-current=page]")
    ).wait_for()
    ready = "jupyterapp.shell.currentWidget.sessionContext.session?.kernel.status === 'idle'"
    page.wait_for_function(ready)
    page.wait_for_timeout(2000)
    assert ask(page, "'started' in globals()") == "False"
    page.get_by_role("button", name="Run").click()
    page.wait_for_function("jupyterapp.shell.currentWidget.content.widgets[0].model.executionCount")
    assert ask(page, "started") == "True"
    # JupyterLab's debugger may ask a kernel that just ends.
    page.allows.append("console error: Could not restore the debugger state")
    page.wait_for_function(f"!({STARTS_KERNEL})()")
    page.get_by_role("link", name="00").click()
    page.wait_for_function(f"({STARTS_KERNEL})()?.status === 'idle'")
    page.get_by_role("button", name="Now try it").click()
    page.locator(".dt-tasks").wait_for()
    assert ask(page, "len(Out)") == "1"
    page.get_by_role("link", name="01 An other lesson").click()
    page.wait_for_function(f"!({STARTS_KERNEL})()")
    assert ask(page, "started") == "True", "a kernel that holds more lives on"


def test_panels_answer_after_a_restart_from_elsewhere(lab, open_notebook, ask):
    (lab.folder / "explore.ipynb").write_text(
        notebook_of("import dmp_teach as teach\nteach.explore()")
    )
    page = open_notebook("explore.ipynb")
    page.wait_for_selector(".dt-explore[data-dt-drawing]")
    kernel = page.evaluate("jupyterapp.shell.currentWidget.sessionContext.session.kernel.id")
    urllib.request.urlopen(
        urllib.request.Request(
            f"{lab.url}/api/kernels/{kernel}/restart",
            method="POST",
            headers={"Authorization": f"token {TOKEN}"},
        )
    )
    page.wait_for_timeout(1000)
    run_all(page)
    page.wait_for_selector(".dt-explore[data-dt-drawing]")
    slider = page.get_by_role("slider", name="How many bumps")
    for bumps in (13, 14):
        slider.press("ArrowRight")
        page.wait_for_function(
            f"document.querySelector('.dt-knobs output')?.textContent.trim() === '{bumps}'"
        )
        page.wait_for_timeout(1000)
        assert page.get_by_text("The robot does not answer").locator("visible=true").count() == 0
        assert json.loads(ask(page, "_.n_kernels")) == bumps
