"""A class on a JupyterHub: two pupils with accounts of the computer, kept apart."""

import json
import os
import shlex
import subprocess
import sys
import time
from ast import literal_eval
from collections import Counter
from pathlib import Path
from types import SimpleNamespace

import psutil
import pytest

import dmp_teach as teach
from dmp_teach.launcher import lab as launcher
from tests.benchmarks.load_hub import hub_command
from tests.browser.conftest import PATIENCE, ROOT, listen
from tests.browser.test_lessons import press, turn

PASSWORDS = {"w01": "first-secret-of-a-test", "w02": "second-secret-of-a-test"}
ONE, TWO = PASSWORDS
LATE = "w03"
SETTINGS = """
c.Spawner.args = ["--LabApp.expose_app_in_browser=True"]
"""
RUN = """async (code) => {
    const kernel = window.jupyterapp.shell.currentWidget.sessionContext.session.kernel;
    const request = {code, store_history: false, user_expressions: {it: "answer"}};
    const reply = await kernel.requestExecute(request).done;
    const {status, user_expressions, ename, evalue} = reply.content;
    return status === "ok" ? user_expressions.it.data["text/plain"] : `${ename}: ${evalue}`;
}"""
# What a pupil tries on the files, the kernel and the server of somebody, with all facts known.
TRIES = """
import os, urllib.request, zmq
def get(url, token=None):
    headers = {{"Authorization": f"token {{token}}"}} if token else {{}}
    opener = urllib.request.build_opener(urllib.request.ProxyHandler({{}}))
    return opener.open(urllib.request.Request(url, headers=headers), timeout=10).status
def outcome(act, *arguments):
    try:
        act(*arguments)
        return "done"
    except Exception as error:
        return getattr(error, "status", type(error).__name__)
ear = zmq.Context.instance().socket(zmq.SUB)
ear.subscribe(b"")
ear.connect("ipc://{stem}-{iopub}")
for port in {ports}:
    ear.connect(f"tcp://127.0.0.1:{{port}}")
contents = "http://127.0.0.1:{server}/user/{who}/api/contents"
answer = [
    outcome(open, "{home}/lessons/00_start_here.ipynb"),
    outcome(os.listdir, "{home}/lessons"),
    outcome(open, "{stem}.json"),
    outcome(open, "/proc/{pid}/environ"),
    outcome(os.kill, {pid}, 0),
    outcome(get, contents),
    outcome(get, contents, os.environ["JUPYTERHUB_API_TOKEN"]),
]
"""
SAYS_SOMETHING_ELSE = """before => {
    const shown = [...document.querySelectorAll(".dt-sentence")];
    return !shown.some(each => each.checkVisibility() && each.innerText === before);
}"""
HEARD = "answer = bool(ear.poll(1000)); ear.close(0)"


def closed_folders(*needed):
    """The folders above what pupils need that only root may pass, with what is needed in them."""
    closed = {}
    for path in map(Path, needed):
        shut = [each for each in path.parents if not each.stat().st_mode & 1]
        if shut:
            closed.setdefault(shut[-1], []).append(path)
    return closed


def accounts():
    """The shell's lines that make the pupils' accounts, as `docs/a_class_on_a_hub.md` says."""
    lines = ["set -e", "umask 022", "groupadd pupils"]
    for who, password in {**PASSWORDS, LATE: LATE}.items():
        lines += [f"useradd --create-home --groups pupils {who}", f"echo {who}:{password}|chpasswd"]
    return lines


def hidden(folder):
    """The shell's lines that hide accounts and homes from the machine, and open closed folders."""
    (folder / "home").mkdir()
    lines = ["set -e", f"cp -a /etc {folder}/etc"]
    lines += [f"mount --bind {folder}/{name} /{name}" for name in ("etc", "home")]
    needed = closed_folders(sys.base_prefix, sys.prefix, ROOT)
    for n, (shut, paths) in enumerate(needed.items()):
        kept = [(shlex.quote(str(path)), f"{folder}/{n}-{m}") for m, path in enumerate(paths)]
        lines += [f"mkdir {copy}; mount --bind {path} {copy}" for path, copy in kept]
        lines += [f"mount -t tmpfs -o mode=755 tmpfs {shlex.quote(str(shut))}"]
        lines += [f"mkdir -p {path}; mount --bind {copy} {path}" for path, copy in kept]
    return lines


@pytest.fixture(scope="module")
def hub(tmp_path_factory):
    """A JupyterHub with the teachers' settings; what it does to the machine, it does unseen."""
    if sys.platform != "linux" or os.geteuid() != 0:
        pytest.skip("only root on Linux can give pupils accounts")
    unseen = subprocess.run(["unshare", "--mount", "true"], capture_output=True, check=False)
    if unseen.returncode != 0 and "CI" not in os.environ:
        pytest.skip("accounts cannot be hidden from this machine")
    pytest.importorskip("jupyterhub")
    folder = tmp_path_factory.mktemp("hub")
    command, port = hub_command(folder, 2, SETTINGS)
    lines = (hidden(folder) if unseen.returncode == 0 else []) + accounts()
    script = "\n".join([*lines, "exec " + shlex.join(command)])
    way = ["unshare", "--mount"] if unseen.returncode == 0 else []
    with (folder / "log").open("wb") as log:
        process = subprocess.Popen([*way, "sh", "-c", script], cwd=folder, stdout=log, stderr=log)
    try:
        deadline = time.monotonic() + PATIENCE / 1000
        while not launcher.is_up(port):
            assert process.poll() is None, (folder / "log").read_text()
            assert time.monotonic() < deadline, (folder / "log").read_text()
            time.sleep(0.1)
        yield SimpleNamespace(
            url=f"http://127.0.0.1:{port}",
            process=psutil.Process(process.pid),
            log=(folder / "log").read_text,
            end=lambda: launcher.end_family(sys.executable, process),
        )
    finally:
        launcher.end_family(sys.executable, process)


def sign_in(page, hub, who, password):
    page.goto(hub.url)
    page.get_by_label("Username").fill(who)
    page.get_by_label("Password").fill(password)
    page.get_by_role("button", name="Sign in").click(no_wait_after=True)


@pytest.fixture(scope="module")
def pupils(hub, chromium):
    """Two pupils who have signed in, each in a browser of one's own: name -> page."""
    pages = {}
    for who, password in PASSWORDS.items():
        page = chromium.new_context(viewport={"width": 1366, "height": 768}).new_page()
        pages[who] = page
        listen(page)
        page.asked = []
        page.on("request", lambda request, page=page: page.asked.append(request.url))
        page.on("websocket", lambda socket, page=page: page.asked.append(socket.url))
        page.set_default_timeout(PATIENCE)
        sign_in(page, hub, who, password)
    for who, page in pages.items():
        page.wait_for_url(f"{hub.url}/user/{who}/doc/tree/00_start_here.ipynb")
        page.asked.clear()
    yield pages
    for page in pages.values():
        page.context.close()


def family(hub, who=None):
    """The processes of the hub, or those of a pupil, the server first."""
    found = hub.process.children(recursive=True)
    if who is None:
        return [hub.process, *found]
    return [each for each in found if each.environ().get("USER") == who]


def ports_of(process):
    return [each.laddr for each in process.net_connections() if each.status == "LISTEN"]


def facts_about(hub, who):
    """What somebody who knew all would know about a pupil's server and first kernel."""
    server, kernel, *_ = family(hub, who)
    file = Path(kernel.cmdline()[-1])
    told = json.loads(file.read_text())
    assert told["transport"] == "ipc"
    return {
        "who": who,
        "home": server.environ()["HOME"],
        "server": ports_of(server)[0].port,
        "pid": kernel.pid,
        "stem": str(file.with_suffix("")),
        "iopub": f"ipc-{told['iopub_port']}",
        "ports": [port for process in (server, kernel) for port in ports_of(process)],
    }


@pytest.mark.parametrize("number", ["00", "08"])
def test_sliders_and_robot_work_for_both_at_once(pupils, number, shot):
    spec = teach.lesson(number)
    for page in pupils.values():
        lessons = page.get_by_role("navigation", name="Lessons")
        lessons.get_by_role("link", name=number).click()
    for page in pupils.values():
        page.wait_for_selector(".dt-lesson[data-dt-drawing] >> visible=true")
        page.locator(".dt-step-bar").get_by_role("radio", name="3 Challenge").check(force=True)
        before = page.locator(".dt-sentence >> visible=true").first.inner_text()
        turn(page, spec, spec.solution)
        page.wait_for_function(SAYS_SOMETHING_ELSE, arg=before)
        press(page, "Check")
        press(page, "Robot, write it")
    for who, page in pupils.items():
        page.wait_for_selector(".dt-scene[data-dt-ink]:not([data-dt-ink='0']) >> visible=true")
        shot(page, f"hub_{number}_{who}")
        assert [each for each in page.troubles if not each.startswith(tuple(page.allows))] == []


def test_neither_reaches_the_files_the_kernel_or_the_server_of_the_other(hub, pupils):
    about = facts_about(hub, ONE)
    about["ports"] = [port.port for port in about["ports"]]
    tries = TRIES.format(**about)
    refused = ["PermissionError"] * 5 + [403, 403]
    own = ["done"] * 5 + [403, "done"]
    answers = {who: literal_eval(page.evaluate(RUN, tries)) for who, page in pupils.items()}
    assert answers == {ONE: own, TWO: refused}
    pupils[ONE].evaluate(RUN, "print('a secret'); answer = 0")
    heard = {who: page.evaluate(RUN, HEARD) for who, page in pupils.items()}
    assert heard == {ONE: "True", TWO: "False"}
    for path in ("api/contents", "api/kernels", "lab", "doc/tree/00_start_here.ipynb"):
        url = f"{hub.url}/user/{ONE}/{path}"
        assert [page.request.get(url).status for page in pupils.values()] == [200, 403], path


def test_nothing_listens_but_what_the_docs_name_and_that_to_this_computer_alone(hub, pupils):
    open_ports = [(each, port) for each in family(hub) for port in ports_of(each)]
    assert {port.ip for _, port in open_ports} == {"127.0.0.1"}
    listeners = Counter(process.pid for process, _ in open_ports)
    servers = {family(hub, who)[0].pid for who in pupils}
    kernels = {each.pid for who in pupils for each in family(hub, who)[1:]}
    assert listeners.pop(hub.process.pid) == 1, "the hub, for the proxy and the servers"
    assert {listeners.pop(pid) for pid in servers} == {1}
    assert {listeners.pop(pid) for pid in kernels & listeners.keys()} == {1}, "ipykernel's"
    assert list(listeners.values()) == [2], "the proxy: for the network, and for the hub"


def test_no_request_leaves_the_prefix_and_no_secret_is_logged(hub, pupils):
    for who, page in pupils.items():
        own = f"{hub.url}/user/{who}/".removeprefix("http")
        asked = [url for url in page.asked if not url.startswith(("data:", "blob:"))]
        assert len(asked) > 50
        assert [url for url in asked if own not in url] == []
    said = hub.log()
    tokens = [family(hub, who)[0].environ()["JUPYTERHUB_API_TOKEN"] for who in pupils]
    assert all(len(token) >= 32 for token in tokens)
    assert [word for word in [*tokens, *PASSWORDS.values()] if word in said] == []


def test_one_pupil_too_many_reads_that_the_class_is_full(hub, pupils, chromium, shot):
    page = chromium.new_page()
    sign_in(page, hub, LATE, LATE)
    page.get_by_role("heading", name="The class is full").wait_for()
    assert page.get_by_text("try again when somebody has left").is_visible()
    shot(page, "hub_full")
    assert family(hub, LATE) == []
    page.close()


def test_a_hub_that_ends_leaves_no_process_and_no_socket(hub, pupils):
    everybody = family(hub)
    sockets = {Path(facts_about(hub, who)["stem"]).parent for who in pupils}
    hub.end()
    psutil.wait_procs(everybody, timeout=15)
    assert [each for each in everybody if each.is_running()] == []
    assert [folder for folder in sockets if folder.exists()] == []
