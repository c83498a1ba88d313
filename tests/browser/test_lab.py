"""JupyterLab as our launcher starts it, in a browser: a notebook with a slider and a counter."""

import json

import pytest

from tests.browser.conftest import sockets_of_kernels

COUNTER = '''\
import anywidget, traitlets, ipywidgets
class Counter(anywidget.AnyWidget):
    _esm = """export default { render({ model, el }) {
      const button = document.createElement("button");
      const show = () => { button.textContent = `count is ${model.get("count")}`; };
      button.onclick = () => { model.set("count", model.get("count") + 1); model.save_changes(); };
      model.on("change:count", show); show(); el.append(button); } }"""
    count = traitlets.Int(3).tag(sync=True)
counter, slider = Counter(), ipywidgets.IntSlider(value=5, min=0, max=10, description="how many")
ipywidgets.VBox([slider, counter])
'''


def notebook_of(*sources):
    cells = [
        {
            "cell_type": "code",
            "id": f"c{n}",
            "metadata": {},
            "source": source,
            "outputs": [],
            "execution_count": None,
        }
        for n, source in enumerate(sources)
    ]
    kernel = {"kernelspec": {"name": "python3", "display_name": "Python 3", "language": "python"}}
    return json.dumps({"cells": cells, "metadata": kernel, "nbformat": 4, "nbformat_minor": 5})


@pytest.fixture
def small(lab):
    (lab.folder / "small.ipynb").write_text(notebook_of("1 + 1", COUNTER))
    return "small.ipynb"


def test_a_slider_moved_by_keyboard_moves_in_python(open_notebook, small, ask, shot):
    page = open_notebook(small)
    handle = page.locator(".noUi-handle")
    handle.focus()
    handle.press("ArrowRight")
    page.wait_for_function("() => document.querySelector('.widget-readout').textContent === '6'")
    assert ask(page, "slider.value") == "6"
    shot(page, "lab_slider")


def test_an_anywidget_talks_both_ways(open_notebook, small, ask):
    page = open_notebook(small)
    page.get_by_role("button", name="count is 3").click()
    page.get_by_role("button", name="count is 4").wait_for()
    assert ask(page, "counter.count") == "4"
    assert ask(page, "setattr(counter, 'count', 40)") == "None"
    page.get_by_role("button", name="count is 40").wait_for()


def test_nobody_is_asked_about_news(open_notebook, small):
    page = open_notebook(small)
    page.wait_for_timeout(2000)
    assert "news" not in page.locator("body").inner_text().lower()
    assert page.locator(".Toastify__toast, .jp-Dialog").count() == 0


def test_a_cell_error_does_not_pass_unseen(open_notebook, lab):
    (lab.folder / "broken.ipynb").write_text(notebook_of("1 / 0"))
    page = open_notebook("broken.ipynb")
    page.expects.append("cell error: ZeroDivisionError")


def test_a_request_to_another_computer_does_not_pass_unseen(open_notebook, small):
    page = open_notebook(small, run=False)
    page.expects += ["request to another computer: http://nobody.invalid/", "request failed"]
    with page.expect_event("requestfailed"):
        page.evaluate("() => { new Image().src = 'http://nobody.invalid/picture.png'; }")


def test_a_socket_does_not_pass_unseen_and_stock_meshcat_opens_some(open_notebook, lab, ask):
    (lab.folder / "stock.ipynb").write_text(
        notebook_of("import meshcat\nstock = meshcat.Visualizer()")
    )
    page = open_notebook("stock.ipynb")
    seen = sockets_of_kernels(lab.process)
    assert len([line for line in seen if line.endswith("LISTEN")]) >= 2, "of pictures, of commands"
    process = "stock.window.server_proc"
    ask(page, f"{process}.kill(), {process}.wait(), stock.window.zmq_socket.close(0)")
