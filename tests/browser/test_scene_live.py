"""The view in a cell of its own, and as a child of another widget, in a real JupyterLab."""

import json

import pytest

from dmp_teach.views.scene.stage import Stage, load_robot_model
from dmp_teach.views.scene.tracks import find_link_paths
from tests.views.moves import sway

FRAME = """
import anywidget, traitlets
from ipywidgets import widget_serialization


class Frame(anywidget.AnyWidget):
    _esm = '''
    async function render({ model, el, signal }) {
      const id = model.get("scene").slice("IPY_MODEL_".length);
      const child = await model.widget_manager.get_model(id);
      const view = await model.widget_manager.create_view(child);
      el.append(view.el);
      return () => view.remove();
    }
    export default { render };
    '''
    scene = traitlets.Any().tag(sync=True, **widget_serialization)


frame = Frame(scene=SceneView(compact=True))
frame
"""
CELLS = [
    "from dmp_teach.views.scene.view import SceneView, view\nfrom tests.views.moves import sway",
    "shown = view(sway())\nshown",
]
ROOT = ".dt-scene"
TIP = """path => {
    const { viewer } = [...globalThis.__dtScenesAwake][0];
    viewer.scene.updateMatrixWorld(true);
    const place = viewer.scene_tree.find(path).object.matrixWorld.elements;
    return [place[12], -place[14], place[13]];
}"""


def notebook(*cells):
    code = {"cell_type": "code", "metadata": {}, "execution_count": None, "outputs": []}
    body = [code | {"source": source, "id": f"cell{n}"} for n, source in enumerate(cells)]
    kernel = {"name": "python3", "display_name": "Python 3", "language": "python"}
    return json.dumps(
        {"cells": body, "metadata": {"kernelspec": kernel}, "nbformat": 4, "nbformat_minor": 5}
    )


@pytest.fixture
def show(lab, open_notebook):
    """A notebook of these cells, run; awake when all its views are."""

    def show_it(*cells, **context):
        again = list(cells) == CELLS
        path = lab.folder / ("sway.ipynb" if again else "view.ipynb")
        if not (again and path.exists()):
            path.write_text(notebook(*cells), encoding="utf-8")
        page = open_notebook(path.name, again=again, **context)
        page.locator(ROOT).first.scroll_into_view_if_needed()
        page.wait_for_selector(f"{ROOT}[data-dt-awake='true']")
        return page

    return show_it


def data(page, name):
    return page.locator(ROOT).first.get_attribute(f"data-dt-{name}")


def settles(page, ask, expression, value):
    """Python knows it soon: a busy machine may take its time."""
    for _ in range(50):
        if ask(page, expression) == value:
            return
        page.wait_for_timeout(100)
    assert ask(page, expression) == value


def at_rest(page):
    page.wait_for_selector(f"{ROOT}[data-dt-state='ready']")


def test_the_robot_writes_when_it_is_shown_and_python_hears_of_the_end(show, ask, shot):
    page = show(*CELLS)
    at_rest(page)
    assert float(data(page, "time")) == pytest.approx(2.4, abs=0.001)
    assert int(data(page, "ink")) > 100
    settles(page, ask, "(shown.playing, round(shown.time, 3))", "(False, 2.4)")
    shot(page, "scene_live")


def test_keys_move_the_time_and_the_ink_both_ways(show, ask):
    page = show(*CELLS)
    at_rest(page)
    whole = int(data(page, "ink"))
    slider = page.get_by_role("slider", name="Time")
    slider.press("Home")
    assert (float(data(page, "time")), data(page, "ink")) == (0, "0")
    slider.press("ArrowRight")
    assert float(data(page, "time")) == pytest.approx(0.1)
    assert slider.get_attribute("aria-valuetext") == "0.1 of 2.4 seconds"
    for _ in range(11):
        slider.press("ArrowRight")
    assert 0 < int(data(page, "ink")) < whole
    slider.press("End")
    assert int(data(page, "ink")) == whole
    settles(page, ask, "round(shown.time, 3)", "2.4")
    assert page.evaluate("document.querySelectorAll('.jp-Cell').length") == 2


def test_the_camera_is_chosen_by_arrow_keys_and_python_can_choose_it_too(show, ask):
    page = show(*CELLS)
    page.get_by_role("radio", name="Over the shoulder").focus()
    page.keyboard.press("ArrowLeft")
    settles(page, ask, "shown.camera", "'whole robot'")
    ask(page, "setattr(shown, 'camera', 'page from above')")
    page.wait_for_function("document.querySelector('input[value=\"page from above\"]').checked")


def test_another_motion_comes_into_the_same_view_and_the_camera_stays(show, ask):
    page = show(*CELLS)
    at_rest(page)
    page.get_by_role("radio", name="Whole robot").check(force=True)
    ask(page, "shown.show(sway(seconds=1.2))")
    page.wait_for_function("Number(document.querySelector('.dt-scene').dataset.dtTime) === 1.2")
    at_rest(page)
    assert page.get_by_role("radio", name="Whole robot").is_checked()
    ask(page, "shown.show(None)")
    page.wait_for_selector(f"{ROOT}[data-dt-state='empty']")
    assert data(page, "ink") == "0"


def test_the_view_stands_inside_another_widget(show, ask, shot):
    page = show(CELLS[0], FRAME)
    assert data(page, "state") == "empty"
    ask(page, "frame.scene.show(sway())")
    at_rest(page)
    assert int(data(page, "ink")) > 100
    assert page.get_by_role("combobox", name="Camera").is_visible()
    shot(page, "scene_inside")


def test_the_pen_in_the_browser_is_where_the_motion_has_it_also_after_another_motion(show, ask):
    page = show(*CELLS)
    path = ["meshcat", *find_link_paths()["pen_tip"].split("/")]
    for motion, name in (
        (sway(), "sway()"),
        (sway(seconds=1.2, size=0.1), "sway(seconds=1.2, size=0.1)"),
        (None, "None"),
    ):
        ask(page, f"shown.show({name}, play=False)")
        stage = Stage(motion)
        page.wait_for_function(
            "document.querySelector('.dts-bar output').textContent"
            f".endsWith('{stage.duration:.1f} s')"
        )
        for time in (0.4, 1.1, 0.4) if motion else (0.0,):
            ask(page, f"setattr(shown, 'time', {time})")
            page.wait_for_selector(f"{ROOT}[data-dt-time='{time:.3f}']")
            tip = load_robot_model().frame("pen_tip", stage.joints(time), stage.joint_names)[
                0, :3, 3
            ]
            assert page.evaluate(TIP, path) == pytest.approx(tip.tolist(), abs=1e-4)


def test_people_who_ask_for_less_movement_get_three_stills(show):
    page = show(*CELLS, reduced_motion="reduce")
    assert float(data(page, "time")) == pytest.approx(2.4)
    button = page.get_by_role("button", name="Next picture")
    times = []
    for _ in range(3):
        button.press("Space")
        times.append(float(data(page, "time")))
    assert times == pytest.approx([0.8, 1.6, 2.4], abs=0.001)
    assert data(page, "state") == "ready"


def test_many_views_share_the_few_drawing_contexts_of_a_browser(show):
    page = show(CELLS[0], *["view(sway(seconds=0.5))"] * 18)
    for number in (17, 0, 9):
        page.locator(ROOT).nth(number).scroll_into_view_if_needed()
        page.wait_for_function(
            f"document.querySelectorAll('.dt-scene')[{number}]?.dataset.dtAwake === 'true'"
        )
    assert page.evaluate("globalThis.__dtScenesAwake.size") <= 8
