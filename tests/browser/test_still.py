"""A panel that cannot live: in an exported page, and in a notebook that is opened again."""

import nbformat
import pytest
from nbconvert import HTMLExporter

from tests.browser.conftest import PATIENCE, TOKEN
from tests.browser.test_lab import notebook_of

SAVE = "() => jupyterapp.commands.execute('docmanager:save')"
SHUT_DOWN = "() => jupyterapp.shell.currentWidget.sessionContext.shutdown()"
STILL = ".dt-stand-in"


@pytest.fixture
def saved(lab, open_notebook, ask):
    """A notebook with a panel whose letter was changed, and then saved."""
    path = lab.folder / "still.ipynb"
    path.write_text(notebook_of("import dmp_teach as teach", "panel = teach.explore()\npanel"))
    page = open_notebook(path.name)
    page.wait_for_selector(".dt-explore[data-dt-drawing]")
    first = page.locator(".dt-number").inner_text()
    page.get_by_role("slider", name="How many bumps").press("Home")
    page.wait_for_function(f"document.querySelector('.dt-number').innerText !== {first!r}")
    number = ask(page, "panel.message['number']").strip("'")
    outputs = "jupyterapp.shell.currentWidget.content.model.cells.get(1).outputs.toJSON()"
    page.wait_for_function(f"JSON.stringify({outputs}).includes('>{number} mm<')")
    page.evaluate(SAVE)
    return page, path, number


def test_a_still_stands_in_for_the_panel_in_a_page_and_in_a_notebook_without_a_kernel(
    saved, lab, chromium, tmp_path, shot
):
    page, path, number = saved
    assert page.locator(STILL).count() == 1
    assert page.locator(STILL).locator("visible=true").count() == 0, "the panel lives"
    exported = tmp_path / "still.html"
    exported.write_text(HTMLExporter().from_notebook_node(nbformat.read(path, 4))[0])
    context = chromium.new_context(offline=True)
    offline = context.new_page()
    offline.goto(exported.as_uri(), wait_until="domcontentloaded")
    offline.locator(f"{STILL} img").wait_for(state="visible")
    assert number in offline.locator(STILL).inner_text()
    shot(offline, "still_exported")
    context.close()
    page.evaluate(SHUT_DOWN)
    page.goto(f"{lab.url}/lab/tree/notebooks/{path.name}?token={TOKEN}")
    page.locator(f"{STILL} img").wait_for(state="visible", timeout=PATIENCE)
    page.get_by_text("This panel is resting").wait_for()
    assert number in page.locator(STILL).inner_text()
    assert page.get_by_text("model not found").count() == 0
    shot(page, "still_resting")
