"""A panel in Jupyter Notebook 7, in voila and in marimo, each started for real.

Where one of them is not installed its test is skipped; `test` does not run them (CONTRIBUTING.md).
"""

import json
import sys
import urllib.error
import urllib.request
from contextlib import contextmanager

import pytest

from dmp_teach.launcher import lab as launcher
from tests.browser.conftest import PATIENCE, ROOT, TOKEN, running

pytestmark = pytest.mark.thorough
SOURCE = "import dmp_teach as teach\n\npanel = teach.explore()\npanel"
CELL = {"cell_type": "code", "id": "panel", "metadata": {}, "outputs": [], "source": SOURCE}
NOTEBOOK = {
    "cells": [{**CELL, "execution_count": None}],
    "metadata": {"kernelspec": {"display_name": "Python", "language": "python", "name": "python3"}},
    "nbformat": 4,
    "nbformat_minor": 5,
}
APP = """import marimo

app = marimo.App()


@app.cell
def _():
    import dmp_teach as teach

    panel = teach.explore()
    panel
    return
"""


def is_up(url):
    """Whether a server answers, whatever it says."""
    try:
        urllib.request.build_opener(urllib.request.ProxyHandler({})).open(url, timeout=5)
    except urllib.error.HTTPError:
        return True
    except OSError:
        return False
    return True


@contextmanager
def serve(home, command, port):
    """Run a server in a folder until the test is over; the address of its front page."""
    surroundings = launcher.clean_environment(
        JUPYTER_CONFIG_DIR=str(home / ".jupyter"),
        JUPYTER_TOKEN=TOKEN,
        IPYTHONDIR=str(home / ".ipython"),
    )
    surroundings["PYTHONPATH"] = str(ROOT)
    url = f"http://127.0.0.1:{port}"
    command = [sys.executable, "-m", *command]
    with running(command, home, surroundings, lambda: is_up(url + "/api")):
        yield url


def see(page, shot, name):
    """An arrow key changes the sentence, and the robot writes in sight."""
    page.wait_for_selector(".dt-panel[data-dt-drawing]")
    says = page.locator(".dt-says")
    said = says.text_content()
    assert says.filter(has_text=said).count() == 1
    page.get_by_role("slider", name="How many bumps").press("ArrowLeft")
    says.filter(has_not_text=said).wait_for()
    page.get_by_role("button", name="Robot, write it").click()
    page.wait_for_selector(".dt-scene[data-dt-awake='true']")
    shot(page, name)


@contextmanager
def opened(chromium):
    """Open an empty page until the test is over, before its server ends."""
    context = chromium.new_context(viewport={"width": 1366, "height": 1000})
    page = context.new_page()
    page.set_default_timeout(PATIENCE)
    yield page
    context.close()


def run_by_hand(page):
    """Run the notebook's cells as its menu does."""
    page.locator(".jp-Notebook-ExecutionIndicator[data-status=idle]").wait_for()
    page.get_by_role("menuitem", name="Run", exact=True).click()
    page.get_by_role("menuitem", name="Run All Cells", exact=True).click()


@pytest.mark.parametrize("program", ["notebook", "voila", "marimo"])
def test_a_panel_lives(chromium, shot, tmp_path, program):
    pytest.importorskip(program)
    (tmp_path / "small.ipynb").write_text(json.dumps(NOTEBOOK))
    (tmp_path / "app.py").write_text(APP)
    port = launcher.free_port()
    options = {
        "notebook": ["--no-browser", "--ServerApp.allow_root=True"],
        "voila": ["small.ipynb", "--no-browser"],
        "marimo": ["run", "app.py", "--headless", "--no-token"],
    }
    command = [program, *options[program], f"--port={port}"]
    with serve(tmp_path, command, port) as url, opened(chromium) as page:
        if program == "notebook":
            page.goto(f"{url}/notebooks/small.ipynb?token={TOKEN}")
            run_by_hand(page)
        else:
            page.goto(url)
        see(page, shot, f"other_{program}")
