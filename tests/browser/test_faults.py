"""What goes wrong in a class: killed kernels, closed windows, second tabs, a network cut."""

import os
import signal

import psutil
import pytest

from tests.browser.conftest import PATIENCE, STATE, TOKEN, listen
from tests.browser.test_lab import notebook_of

NOTEBOOK = "faults.ipynb"
BUMPS = "How many bumps"
WRITE = "Robot, write it"
SHOWS = "n => document.querySelector('.dt-knobs output')?.textContent.trim() === String(n)"
SAVED = "() => !jupyterapp.shell.currentWidget.context.model.dirty"
# Before any script of the page: keep its sockets, to cut them all at once.
HOLD_SOCKETS = """
const Socket = WebSocket;
window.sockets = [];
window.WebSocket = class extends Socket {
    constructor(...all) { super(...all); window.sockets.push(this); }
};"""


@pytest.fixture
def page(open_notebook, lab):
    (lab.folder / NOTEBOOK).write_text(notebook_of("import dmp_teach as teach\nteach.explore()"))
    page = open_notebook(NOTEBOOK, run=False, view="doc")
    page.wait_for_selector(".dt-explore[data-dt-drawing]")
    return page


def refuse(route):
    """What the server answers where a folder cannot be written."""
    if route.request.method == "PUT":
        route.fulfill(status=403, json={"message": f"Permission denied: {NOTEBOOK}"})
    else:
        route.continue_()


def press_to(page, key, bumps):
    """Press a key at the slider, and wait till the kernel has drawn so many bumps."""
    page.get_by_role("slider", name=BUMPS).press(key)
    page.wait_for_function(SHOWS, arg=bumps)


def bumps_of(page):
    return int(page.locator(".dt-knobs output").first.inner_text())


def again(page, lab):
    """The notebook in a browser of somebody who has not seen it before."""
    other = page.context.browser.new_context(viewport={"width": 1280, "height": 1400}).new_page()
    listen(other)
    other.goto(f"{lab.url}/doc/tree/notebooks/{NOTEBOOK}?token={TOKEN}")
    other.wait_for_function(f"() => ({STATE})()?.status === 'idle'", timeout=PATIENCE)
    other.wait_for_selector(".dt-explore[data-dt-drawing]")
    return other


def test_a_kernel_that_is_killed_while_the_robot_plans_leaves_nothing_and_run_all_mends(page, ask):
    kernel = psutil.Process(int(ask(page, "__import__('os').getpid()")))
    bumps = bumps_of(page)
    page.get_by_role("button", name=WRITE).click()
    page.locator(".dt-work:not([hidden])").wait_for()
    family = [kernel, *kernel.children(recursive=True)]
    os.kill(kernel.pid, signal.SIGKILL)
    psutil.wait_procs(family, timeout=10)
    assert [each for each in family if each.is_running()] == []
    page.locator(".jp-Dialog").get_by_role("button", name="Ok").click(timeout=PATIENCE)
    page.get_by_text("The robot does not answer").wait_for(timeout=PATIENCE)
    page.evaluate("() => jupyterapp.commands.execute('notebook:run-all-cells')")
    page.get_by_text("The robot does not answer").wait_for(state="hidden")
    press_to(page, "ArrowRight", bumps + 1)
    page.get_by_role("button", name=WRITE).click()
    page.wait_for_selector(".dt-scene[data-dt-state='playing']", timeout=PATIENCE)


def test_a_notebook_in_two_tabs_is_one_panel_that_outlives_both(page, lab, ask):
    bumps = bumps_of(page)
    press_to(page, "ArrowRight", bumps + 1)
    # The lesson view has saved it.
    page.wait_for_function(SAVED)
    other = again(page, lab)
    assert bumps_of(other) == bumps + 1
    press_to(other, "ArrowRight", bumps + 2)
    line = "() => document.querySelector('.dt-paper .dt-robot-line').getAttribute('d')"
    page.wait_for_function(f"drawn => ({line})() === drawn", arg=other.evaluate(line))
    page.wait_for_function(SHOWS, arg=bumps + 2)
    press_to(page, "ArrowLeft", bumps + 1)
    other.wait_for_function(SHOWS, arg=bumps + 1)
    press_to(other, "ArrowRight", bumps + 2)
    assert ask(page, "_.n_kernels") == str(bumps + 2)
    other.context.close()
    third = again(page, lab)
    assert bumps_of(third) == bumps + 2
    assert third.troubles == []
    third.context.close()


def test_after_a_network_that_was_cut_the_panel_goes_on_where_it_was(page, ask):
    bumps = bumps_of(page)
    page.allows += ["console error", "request failed, net::ERR_INTERNET_DISCONNECTED"]
    page.add_init_script(HOLD_SOCKETS)
    page.reload()
    page.wait_for_selector(".dt-explore[data-dt-drawing]")
    page.context.set_offline(True)
    assert page.evaluate("() => window.sockets.map(each => each.close()).length") > 0
    page.wait_for_function(f"() => ({STATE})()?.status === 'unknown'")
    page.context.set_offline(False)
    page.wait_for_function(f"() => ({STATE})()?.status === 'idle'", timeout=PATIENCE)
    press_to(page, "ArrowRight", bumps + 1)
    assert ask(page, "_.n_kernels") == str(bumps + 1)


def test_a_notebook_that_cannot_be_saved_is_told_and_what_was_set_stays(page):
    bumps = bumps_of(page)
    page.wait_for_function(SAVED)
    page.expects += ["request answered 403", "page error: Permission denied"]
    page.route("**/api/contents/**", refuse)
    page.evaluate("() => void jupyterapp.commands.execute('docmanager:save')")
    told = page.locator(".jp-Dialog", has_text=f"File Save Error for {NOTEBOOK}")
    told.get_by_role("button", name="Close").click()
    press_to(page, "ArrowRight", bumps + 1)
    page.unroute("**/api/contents/**")
    page.evaluate("() => jupyterapp.commands.execute('docmanager:save')")
    page.wait_for_function(SAVED)
    page.reload()
    page.wait_for_selector(".dt-explore[data-dt-drawing]")
    assert bumps_of(page) == bumps + 1
