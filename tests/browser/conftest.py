"""A real JupyterLab in a real Chromium, for tests that look at what a child sees.

    def test_something(open_notebook, ask, shot):
        page = open_notebook("00_start_here.ipynb")  # every cell has been run, the kernel is idle
        page.get_by_role("slider", name="...").press("ArrowRight")
        assert ask(page, "panel.width") == "1.5"  # what Python thinks: the repr of an expression
        shot(page, "start")  # a PNG, where DMP_TEACH_SHOTS names a folder

When the test ends, no page error, console error, failed request, request to another computer, cell
error, broken widget or socket of a kernel may have been seen, unless the test names its beginning:
`page.expects.append("cell error: ZeroDiv")`.
"""

import json
import os
import shutil
import subprocess
import sys
import time
from contextlib import contextmanager, suppress
from pathlib import Path
from types import SimpleNamespace
from urllib.parse import urlsplit

import psutil
import pytest

from dmp_teach.launcher import lab as launcher

ROOT = Path(__file__).parents[2]
TOKEN = "a-token-for-tests"
PATIENCE = 60_000  # [ms] for what may be slow on a busy machine
FLAGS = [
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--disable-gpu-compositing",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1, EXCLUDE localhost",
]

STATE = """() => {
    const panel = window.jupyterapp?.shell?.currentWidget;
    const kernel = panel?.sessionContext?.session?.kernel;
    if (!panel?.content?.model || !kernel) return null;
    const isCode = c => c.type === 'code' && c.sharedModel.source.trim();
    const cells = [...panel.content.model.cells].filter(isCode);
    const outputs = cells.flatMap(c => c.outputs.toJSON());
    return {
        status: kernel.status,
        todo: cells.filter(c => c.executionCount === null || c.executionState === 'running').length,
        errors: outputs.filter(o => o.output_type === 'error')
            .map(o => `cell error: ${o.ename}: ${o.evalue}`),
    };
}"""

FORGET = "__import__('dmp_teach.classroom.panels.kept', fromlist=['kept']).forget_all('')"
CLEAR = """() => {
    window.jupyterapp.commands.execute('notebook:clear-all-cell-outputs');
    window.jupyterapp.shell.currentWidget.content.activeCellIndex = 0;
}"""

# Another notebook in the same JupyterLab, its kernel new and nothing remembered.
OPEN = """async (path) => {
    const { shell, commands } = window.jupyterapp;
    const old = shell.currentWidget;
    await old.sessionContext.shutdown();
    old.dispose();
    sessionStorage.clear();
    await commands.execute('docmanager:open', { path, factory: 'Notebook' });
}"""

ASK = """async (code) => {
    const kernel = window.jupyterapp.shell.currentWidget.sessionContext.session.kernel;
    const request = {code: '', silent: true, user_expressions: {it: code}};
    // Playwright would wait for ever.
    const late = new Promise((_, refuse) => setTimeout(refuse, 60000, Error("no answer")));
    const reply = await Promise.race([kernel.requestExecute(request).done, late]);
    const it = reply.content.user_expressions.it;
    return it.status === 'ok' ? it.data['text/plain'] : `${it.ename}: ${it.evalue}`;
}"""


def chromium_path():
    names = ("chromium", "chromium-browser", "google-chrome", "chrome")
    return os.environ.get("DMP_TEACH_CHROMIUM") or next(
        filter(None, map(shutil.which, names)), None
    )


@pytest.fixture(scope="package")
def chromium():
    """The system's Chromium under Playwright, for all tests of this folder and none of another,
    which may want an event loop; nothing is ever downloaded."""
    path = chromium_path()
    if path is None:
        pytest.skip("no Chromium here: install it, or set DMP_TEACH_CHROMIUM to one")
    sync_api = pytest.importorskip("playwright.sync_api")
    flags = [*FLAGS, "--no-sandbox"] if hasattr(os, "geteuid") and os.geteuid() == 0 else FLAGS
    with sync_api.sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=path, args=flags)
        yield browser
        browser.close()


@contextmanager
def running(command, home, surroundings, is_up):
    """Run a server in a folder until the test is over; what it says is in its file `log`."""
    with open(home / "log", "wb") as log:
        process = subprocess.Popen(
            command,
            cwd=home,
            env=surroundings,
            stdin=subprocess.DEVNULL,
            stdout=log,
            stderr=log,
            **launcher.apart(),
        )
    try:
        deadline = time.monotonic() + PATIENCE / 1000
        while not is_up():
            if process.poll() is not None or time.monotonic() > deadline:
                raise RuntimeError((home / "log").read_text())
            time.sleep(0.1)
        yield process
    finally:
        launcher.end_family(sys.executable, process)


@contextmanager
def serve(home, notebooks):
    """Run our server in a folder on notebooks, name: text; .url, .folder, .process, .log()."""
    folder = home / "notebooks"
    folder.mkdir()
    for name, text in notebooks.items():
        (folder / name).write_text(text, encoding="utf-8")
    port = launcher.free_port()
    command = launcher.lab_command(sys.executable, home, port)
    command += ["--ServerApp.open_browser=False", "--LabApp.expose_app_in_browser=True"]
    surroundings = launcher.lab_environment(home / ".jupyter", TOKEN)
    surroundings.update(PYTHONPATH=str(ROOT), JUPYTER_DATA_DIR=str(home / "data"))
    with running(command, home, surroundings, lambda: launcher.is_up(port)) as process:
        yield SimpleNamespace(
            url=f"http://127.0.0.1:{port}",
            folder=folder,
            process=process,
            command=command,
            surroundings=surroundings,
            log=(home / "log").read_text,
        )


def bare(notebook):
    """A notebook of ours as text, its cells not yet run."""
    content = json.loads(notebook.read_text(encoding="utf-8"))
    for cell in content["cells"]:
        if cell["cell_type"] == "code":
            cell.update(execution_count=None, outputs=[])
    return json.dumps(content)


@pytest.fixture(scope="session")
def lab(tmp_path_factory):
    """Our server on a copy of the notebooks."""
    ours = {each.name: bare(each) for each in sorted((ROOT / "notebooks").glob("*.ipynb"))}
    with serve(tmp_path_factory.mktemp("lab"), ours) as served:
        yield served


def listen(page):
    """Gather all that goes wrong on a page into `page.troubles`."""
    page.troubles = troubles = []
    page.expects = []
    # Troubles that may be seen and need not: Jupyter saves outputs that a new kernel does not know,
    # and asks a kernel that ends for its debugger.
    page.allows = [
        "console error: Error: widget model not found",
        "console error: Could not restore the debugger state",
    ]

    def visit(address):
        parts = urlsplit(address)
        if parts.scheme not in ("data", "blob") and parts.hostname not in (
            "127.0.0.1",
            "localhost",
        ):
            troubles.append(f"request to another computer: {address}")

    def answer(response):
        if response.status >= 400:
            troubles.append(f"request answered {response.status}: {response.url}")

    def console(message):
        if message.type == "error" and "Failed to load resource" not in message.text:
            troubles.append(f"console error: {message.text}")

    def failed(request):
        if "ERR_ABORTED" not in str(request.failure):
            troubles.append(f"request failed, {request.failure}: {request.url}")

    page.on("pageerror", lambda error: troubles.append(f"page error: {error}"))
    page.on("console", console)
    page.on("request", lambda request: visit(request.url))
    page.on("websocket", lambda socket: visit(socket.url))
    page.on("response", answer)
    page.on("requestfailed", failed)


def seen_in_cells(page):
    """The errors among the outputs of the cells, and widgets that cannot be shown."""
    state = page.evaluate(STATE)
    broken = page.locator(".jupyter-widgets-error-widget").count()
    return (state["errors"] if state else []) + ["a widget that cannot be shown"] * broken


def sockets_of_kernels(server):
    """Ports and connections of the kernels and of what they started, as the system has them, but
    for ipykernel's one port: what is sent there is dropped without a secret, nothing is heard."""
    found = []
    for process in psutil.Process(server.pid).children(recursive=True):
        with suppress(psutil.Error):
            own = [
                f"socket of {process.name()}: {each.laddr.ip}:{each.laddr.port} {each.status}"
                for each in process.net_connections("inet")
            ]
            theirs = "ipykernel_launcher" in process.cmdline()
            own.sort(key=lambda line: not ("127.0.0.1" in line and "LISTEN" in line))
            found += own[1:] if theirs else own
    return found


def run_all(page):
    """Run all cells from the menu; wait until every code cell has run and the kernel rests."""
    page.get_by_role("menuitem", name="Run", exact=True).click()
    page.get_by_role("menuitem", name="Run All Cells", exact=True).click()
    page.wait_for_function(
        f"() => {{ const s = ({STATE})(); return s && s.status === 'idle' && s.todo === 0; }}",
        timeout=PATIENCE,
    )


@pytest.fixture(scope="module")
def kept():
    """Pages that tests of one file share: (view, its window) -> page."""
    pages = {}
    yield pages
    for page in pages.values():
        close(page)


def close(page):
    page.evaluate("() => window.jupyterapp?.shell?.currentWidget?.sessionContext?.shutdown()")
    page.context.close()


@pytest.fixture
def open_notebook(chromium, lab, shot, kept):
    """Open a notebook of the copy in JupyterLab, run its cells, and watch it to the end.

    With `shared` it opens in the JupyterLab of another test of the file, its kernel new; with
    `again` the kernel is the one in which these cells have run, too: for tests that change nothing
    beyond what the cells make.
    """
    pages = []

    def open_it(name, run=True, view="lab", again=False, shared=False, **context):
        surroundings = {"viewport": {"width": 1280, "height": 1400}, **context}
        size = surroundings.pop("viewport")
        key = (view, str(surroundings)) if again or shared else None
        page = kept.pop(key, None)
        if page:
            page.set_viewport_size(size)
        if page and again and page.shows == name:
            page.evaluate(CLEAR)
            page.evaluate(ASK, FORGET)
        elif page:
            page.evaluate(OPEN, f"notebooks/{name}")
        else:
            # Another page with this notebook would save it, too, sooner or later.
            for other in [other for other, old in kept.items() if old.shows == name]:
                close(kept.pop(other))
            page = chromium.new_context(viewport=size, **surroundings).new_page()
            listen(page)
            page.set_default_timeout(PATIENCE / 4)
            page.goto(f"{lab.url}/{view}/tree/notebooks/{name}?reset&token={TOKEN}")
        page.shows = name
        pages.append((page, key))
        try:
            page.wait_for_function(f"() => ({STATE})()?.status === 'idle'", timeout=PATIENCE)
            if run:
                run_all(page)
        except Exception:
            shot(page, "trouble")
            raise
        return page

    yield open_it
    found = []
    for number, (page, key) in enumerate(pages):
        troubles = page.troubles + seen_in_cells(page) + sockets_of_kernels(lab.process)
        unexpected = [
            trouble for trouble in troubles if not trouble.startswith((*page.expects, *page.allows))
        ]
        missing = [
            f"not seen: {start}"
            for start in page.expects
            if not any(t.startswith(start) for t in troubles)
        ]
        if unexpected or missing:
            shot(page, f"trouble_{number}")
        if key and not troubles:
            kept[key] = page
        else:
            close(page)
        found += unexpected + missing
    assert found == []


@pytest.fixture
def opened(chromium, file, request):
    """Open the module's `file` in a browser without network; no trouble and no request may have
    been seen at the end.

    The module's VIEWPORT is the size of the window, unless a test gives another. READY is what is
    waited for.
    """
    ready = getattr(request.module, "READY", ".dt-scene[data-dt-awake='true']")
    contexts, seen = [], []

    def open_it(script="", **options):
        context = chromium.new_context(**{"viewport": request.module.VIEWPORT, **options})
        contexts.append(context)
        context.add_init_script(script)
        context.set_offline(True)
        page = context.new_page()
        page.on("request", lambda request: seen.append(request.url))
        page.on("pageerror", lambda error: seen.append(f"page error: {error}"))
        page.on(
            "console",
            lambda message: message.type == "error" and seen.append(f"console: {message.text}"),
        )
        page.goto(file.as_uri())
        page.wait_for_selector(ready)
        return page

    yield open_it
    for context in contexts:
        context.close()
    assert [url for url in seen if not url.startswith(("blob:", file.as_uri()))] == []


@pytest.fixture
def ask():
    """What Python answers in the notebook's kernel: the repr of an expression."""
    return lambda page, expression: page.evaluate(ASK, expression)


@pytest.fixture
def shot():
    """Save a picture of the page where DMP_TEACH_SHOTS names a folder."""

    def save(page, name):
        if os.environ.get("DMP_TEACH_SHOTS"):
            folder = Path(os.environ["DMP_TEACH_SHOTS"])
            folder.mkdir(parents=True, exist_ok=True)
            page.screenshot(path=folder / f"{name}.png")

    return save
