"""The static site in a browser that reaches nothing else: lessons wake, figures come."""

import functools
import json
import threading
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

import pytest

from dmp_teach.launcher.static_site import make_site
from tests.browser.conftest import PATIENCE, listen, seen_in_cells

ROOT = Path(__file__).parents[2]
LESSONS = sorted(path.name for path in (ROOT / "notebooks").glob("[0-9]*.ipynb"))
PANEL = ".dt-lesson[data-dt-drawing]"
# Those of the large packages that are still on the server.
LATE = "sorted({'matplotlib', 'scipy'} & __import__('piplite.piplite').piplite.LATE.keys())"
LARGEST = 60e6  # [bytes]
# This kernel evaluates no expressions of a request.
ASK = """async (code) => {
    const kernel = jupyterapp.shell.currentWidget.sessionContext.session.kernel;
    const request = { code: `print(repr(${code}))`, store_history: false };
    const future = kernel.requestExecute(request);
    let said = "";
    future.onIOPub = ({ content }) => { said += content.text ?? content.evalue ?? ""; };
    await future.done;
    return said.trim();
}"""
RUN = """async (source) => {
    const { content } = jupyterapp.shell.currentWidget;
    content.activeCellIndex = content.widgets.findLastIndex(cell => cell.model.type === "code");
    content.activeCell.model.sharedModel.setSource(source);
    await jupyterapp.commands.execute("notebook:run-cell");
}"""
SAVE = "() => jupyterapp.shell.currentWidget.context.save()"
# What the browser would know of a lesson that is corrected since.
AGE = """name => {
    const place = Object.keys(localStorage).find(each => each.startsWith("dmp_teach lessons"));
    const known = JSON.parse(localStorage.getItem(place));
    localStorage.setItem(place, JSON.stringify({ ...known, [name]: "older" }));
}"""
# All that the browser keeps of notebooks, as one text.
KEPT = """async () => {
    const asked = request => new Promise((done, fail) => {
        request.onsuccess = () => done(request.result);
        request.onerror = () => fail(request.error);
    });
    const kept = [];
    for (const { name } of await indexedDB.databases()) {
        const base = await asked(indexedDB.open(name));
        for (const store of base.objectStoreNames)
            kept.push(...await asked(base.transaction(store).objectStore(store).getAll()));
        base.close();
    }
    return JSON.stringify(kept);
}"""
pytestmark = pytest.mark.slow


class Quiet(SimpleHTTPRequestHandler):
    """Any web server would do."""

    def log_message(self, *_):
        """Say nothing."""


@pytest.fixture(scope="module")
def site(tmp_path_factory):
    """Where the site is served; an address of this computer."""
    folder = tmp_path_factory.mktemp("site") / "lessons"
    assert make_site(folder) < LARGEST
    settings = folder / "jupyter-lite.json"
    content = json.loads(settings.read_text())
    content["jupyter-config-data"]["exposeAppInBrowser"] = True
    settings.write_text(json.dumps(content))
    answer = functools.partial(Quiet, directory=folder)
    with ThreadingHTTPServer(("127.0.0.1", 0), answer) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_port}/"
        server.shutdown()


@pytest.fixture(scope="module")
def visitor(site, chromium):
    """A browser that keeps what it has fetched from one lesson to the next."""
    context = chromium.new_context(viewport={"width": 1366, "height": 768})
    yield context
    context.close()


@pytest.fixture
def page(site, visitor):
    page = visitor.new_page()
    listen(page)
    page.set_default_timeout(2 * PATIENCE)
    yield page
    troubles = page.troubles + seen_in_cells(page)
    page.close()
    assert [each for each in troubles if not each.startswith(tuple(page.allows))] == []


def see_lesson(page, shot, name):
    page.wait_for_selector(PANEL)
    shot(page, f"site_{name[:2]}")
    here = page.get_by_role("navigation", name="Lessons").locator("[aria-current=page]")
    assert here.inner_text().split()[0] == name[:2]
    assert page.locator("#jp-menu-panel, .jp-SideBar").locator("visible=true").count() == 0


@pytest.mark.thorough
@pytest.mark.parametrize("name", LESSONS)
def test_a_lesson_wakes_alone_in_sight(page, site, shot, name):
    page.goto(f"{site}lab/index.html?path={name}")
    see_lesson(page, shot, name)


def test_a_visit_keeps_the_bet_and_no_ink_and_fetches_what_is_used(page, site, shot):
    """A page loaded anew shows the bet, and a corrected lesson instead of the pupil's copy."""
    page.goto(site)
    coming = page.get_by_role("progressbar", name="The robot is getting ready.")
    coming.wait_for()
    see_lesson(page, shot, LESSONS[0])
    coming.wait_for(state="hidden")
    assert page.evaluate(ASK, LATE) == "['matplotlib', 'scipy']", "a panel needs neither"
    bet = page.locator(".dt-card .dt-choice input").first
    bet.press("Space")
    page.wait_for_selector(".dt-card .dt-main:not([aria-disabled])")
    figure = "teach.figures.draw_worksheet([teach.recording_of('a')])"
    assert "Figure size" in page.evaluate(ASK, figure)
    page.evaluate(ASK, "__import__('scipy.interpolate')")
    assert page.evaluate(ASK, LATE) == "[]"
    page.evaluate(RUN, "import dmp_teach as teach\n\npad = teach.pad('a')\npad")
    page.wait_for_selector(".dt-pad")
    page.evaluate(SAVE)
    before = page.evaluate(KEPT)
    assert "teach.pad('a')" in before
    points = "[[n / 100, 0.02 + n / 9999, 0.02 + n / 7777, 0.5] for n in range(400)]"
    page.evaluate(ASK, f"pad.add_stroke({points})")
    assert page.evaluate(ASK, "len(pad.recording.strokes())") == "1"
    page.evaluate(SAVE)
    assert len(page.evaluate(KEPT)) < len(before) + 1000
    page.evaluate(AGE, LESSONS[0])
    page.reload()
    see_lesson(page, shot, LESSONS[0])
    page.wait_for_function("bet => bet.checked", arg=bet.element_handle())
    assert "teach.pad('a')" not in page.evaluate(KEPT)
