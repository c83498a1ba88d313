"""The two commands: an environment made once, a JupyterLab that ends whole, every test."""

import ast
import json
import os
import shutil
import signal
import socket
import subprocess
import sys
import urllib.error
import urllib.request
import zipfile
from pathlib import Path

import psutil
import pytest

from dmp_teach import __main__ as launcher
from dmp_teach.errors import SetupError
from dmp_teach.launcher import lab

ROOT = Path(__file__).parents[2]
LINTERS = ["ruff check .", "ruff format --check ."]
ALL = "pytest -n logical --maxprocesses 8 --dist loadfile --no-loadscope-reorder"


@pytest.fixture(autouse=True)
def signals_as_before():
    """The launcher sets what Ctrl-C does; here that is pytest's business."""
    numbers = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)
    before = [signal.getsignal(number) for number in numbers]
    yield
    for number, handler in zip(numbers, before, strict=True):
        signal.signal(number, handler)


@pytest.fixture
def clone(tmp_path, monkeypatch):
    """An empty clone with one pin: a wheel of three files, so that no network is needed."""
    wheel = tmp_path / "tiny-1.0-py3-none-any.whl"
    with zipfile.ZipFile(wheel, "w") as archive:
        archive.writestr("tiny.py", "WORD = 'installed'\n")
        archive.writestr(
            "tiny-1.0.dist-info/METADATA", "Metadata-Version: 2.1\nName: tiny\nVersion: 1.0\n"
        )
        archive.writestr(
            "tiny-1.0.dist-info/WHEEL",
            "Wheel-Version: 1.0\nRoot-Is-Purelib: true\nTag: py3-none-any\n",
        )
        archive.writestr("tiny-1.0.dist-info/RECORD", "")
    (tmp_path / "ours.py").write_text("WORD = 'ours'\n")
    (tmp_path / "environment.txt").write_text(f"{wheel}\n")
    monkeypatch.setattr(launcher, "ROOT", tmp_path)
    monkeypatch.setattr(launcher, "VENV", tmp_path / ".venv")
    monkeypatch.setattr(launcher, "PINS", tmp_path / "environment.txt")
    which = shutil.which
    monkeypatch.setattr(shutil, "which", lambda name: None if name == "uv" else which(name))
    return tmp_path


def forbid(*arguments, **more):
    raise RuntimeError("this start must not do that")


def test_the_first_start_installs_and_the_second_does_not(clone, monkeypatch, capsys):
    python = launcher.prepare()
    words = subprocess.check_output(
        [python, "-c", "import tiny, ours; print(tiny.WORD, ours.WORD)"], cwd="/", text=True
    )
    assert words == "installed ours\n"
    assert "Setting up in .venv (once" in capsys.readouterr().out
    monkeypatch.setattr(subprocess, "Popen", forbid)
    assert launcher.prepare() == python
    assert capsys.readouterr().out == ""


def pretend(clone, monkeypatch):
    """Steps that only say that they were taken; the list of them."""
    steps = []
    bin_folder = clone / ".venv" / "bin"

    def make():
        steps.append("make")
        bin_folder.mkdir(parents=True, exist_ok=True)
        (bin_folder / "python").exists() or (bin_folder / "python").symlink_to(sys.executable)

    monkeypatch.setattr(launcher, "make_venv", make)
    monkeypatch.setattr(launcher, "install", lambda python: steps.append("install"))
    monkeypatch.setattr(subprocess, "check_output", lambda *a, **k: str(clone / ".venv").encode())
    return steps


def test_an_interrupted_installation_is_begun_again(clone, monkeypatch):
    steps = pretend(clone, monkeypatch)

    def cut(python):
        raise KeyboardInterrupt

    with monkeypatch.context() as now:
        now.setattr(launcher, "install", cut)
        with pytest.raises(KeyboardInterrupt):
            launcher.prepare()
    launcher.prepare()
    launcher.prepare()
    assert steps == ["make", "make", "install"]


def test_new_pins_are_installed_into_the_old_environment(clone, monkeypatch):
    steps = pretend(clone, monkeypatch)
    launcher.prepare()
    (clone / "environment.txt").write_text("another==1.0\n")
    launcher.prepare()
    assert steps == ["make", "install", "install"]


def test_uv_is_used_where_it_is(clone, monkeypatch):
    said = []
    monkeypatch.setattr(shutil, "which", lambda name: "/bin/uv" if name == "uv" else None)
    monkeypatch.setattr(subprocess, "call", lambda command, **more: said.append(command) or 0)
    monkeypatch.setattr(launcher, "find_python", lambda: None)
    launcher.make_venv()
    assert said[0][:2] == ["uv", "venv"]
    assert "3.11" in said[0], "uv fetches a Python where there is none"


def test_without_a_python_that_works_one_sentence_says_what_to_do(clone, monkeypatch, capsys):
    monkeypatch.setattr(launcher, "find_python", lambda: None)
    assert launcher.main(["lab"]) == 1
    assert "dmp_teach needs 3.11, 3.12, 3.13. Install one of them, or uv" in capsys.readouterr().err


def test_without_venv_one_sentence_says_what_to_type(clone, monkeypatch, capsys):
    monkeypatch.setattr(subprocess, "call", lambda command, **more: 1)
    monkeypatch.setattr(launcher, "find_python", lambda: sys.executable)
    assert launcher.main(["test"]) == 1
    version = "{}.{}".format(*sys.version_info[:2])
    assert (
        f"Type  sudo apt install python{version}-venv  and then this again."
        in capsys.readouterr().err
    )


def test_a_shim_with_nothing_behind_it_is_no_python(tmp_path):
    shim = tmp_path / "python3.12"
    shim.write_text("#!/bin/sh\nexit 127\n")
    shim.chmod(0o755)
    assert not launcher.answers([str(shim)], "3.12")
    assert not launcher.answers([str(tmp_path / "nothing")], "3.12")
    assert launcher.answers([sys.executable], "{}.{}".format(*sys.version_info[:2]))


@pytest.mark.parametrize(
    ("heard", "told"),
    [
        ("OSError: [Errno 28] No space left on device", "The disk is full"),
        (
            "NewConnectionError(...) ERROR: No matching distribution found for anyio",
            "is this computer online?",
        ),
        ("error: Failed to fetch: simple/anyio", "is this computer online?"),
        ("ERROR: No matching distribution found for anyio==99", "the lines above say which"),
    ],
)
def test_a_failed_installation_is_explained(heard, told):
    assert told in launcher.advice(heard)


def test_what_the_installer_says_is_passed_on(clone):
    (clone / "environment.txt").write_text(f"{clone / 'absent-1.0-py3-none-any.whl'}\n")
    with pytest.raises(SetupError, match=r"absent-1.0(.|\n)*the lines above say which"):
        launcher.prepare()
    assert not (clone / ".venv" / "dmp_teach.stamp").exists()


@pytest.mark.parametrize(
    "name",
    [
        "__init__.py",
        "__main__.py",
        "errors.py",
        "launcher/__init__.py",
        "launcher/lab.py",
        "launcher/work.py",
    ],
)
def test_an_old_python_understands_the_launcher(name):
    tree = ast.parse(
        (ROOT / "dmp_teach" / name).read_text(encoding="utf-8"), feature_version=(3, 6)
    )
    notes = [node.returns for node in ast.walk(tree) if isinstance(node, ast.FunctionDef)]
    assert not [note for note in notes if isinstance(note, ast.Subscript | ast.BinOp)]
    assert not [
        node
        for node in ast.walk(tree)
        if isinstance(node, ast.ImportFrom) and node.module == "__future__"
    ]


class Server:
    """`lab --no-browser` as somebody would type it, in the environment that the tests run in."""

    def __init__(self, home, *options):
        arguments = ["lab", "--no-browser", "--work", str(home / "work"), *options]
        words = (
            "import sys, dmp_teach.__main__ as launcher\n"
            "launcher.prepare = lambda: sys.executable\n"
            f"sys.exit(launcher.main({arguments!r}))"
        )
        self.process = subprocess.Popen(
            [sys.executable, "-c", words],
            cwd=ROOT,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
        )
        assert self.process.stdout.readline() == "Starting JupyterLab ...\n"
        self.line = self.process.stdout.readline()
        assert self.line.startswith("JupyterLab is at http://127.0.0.1:"), (
            self.line + self.process.stdout.read()
        )
        self.address, self.token = self.line.split()[3].split("?token=")

    def ask(self, path, data=None, token=None, method=None):
        url = self.address.split("/doc/")[0] + path
        request = urllib.request.Request(url, data=data, method=method)
        request.add_header("Authorization", f"token {token or self.token}")
        opener = urllib.request.build_opener(urllib.request.ProxyHandler({}))
        return json.loads(opener.open(request, timeout=20).read())

    def family(self):
        return [
            psutil.Process(self.process.pid),
            *psutil.Process(self.process.pid).children(recursive=True),
        ]


@pytest.mark.parametrize("how", ["SIGINT", "SIGTERM"])
def test_the_lab_says_where_it_is_and_ends_with_all_its_children(tmp_path, how):
    server = Server(tmp_path)
    try:
        assert server.address.endswith("/doc/tree/00_start_here.ipynb")
        assert server.ask("/api/contents/00_start_here.ipynb?content=0")["path"]
        with pytest.raises(urllib.error.HTTPError, match="404"):
            server.ask(f"/api/contents/nothing?token={server.token}")
        assert len(server.token) >= 32
        with pytest.raises(urllib.error.HTTPError, match="403"):
            server.ask("/api/contents", token="somebody-else")
        server.ask("/api/kernels", data=b"{}")
        family = server.family()
        assert len(family) == 3, "the launcher, the server, the kernel"
        assert not [
            word for process in family for word in process.cmdline() if server.token in word
        ]
        doors = [
            door
            for process in family
            for door in process.net_connections()
            if door.status == "LISTEN"
        ]
        assert doors
        assert {door.laddr.ip for door in doors} == {"127.0.0.1"}
        server.process.send_signal(getattr(signal, how))
        said = server.process.communicate(timeout=30)[0]
        log = (tmp_path / "work" / ".jupyter" / "lab.log").read_text()
        assert "/api/contents/nothing" in log
        assert [line for line in log.splitlines() if server.token in line] == []
        assert server.process.returncode == 0
        assert said == "Ending JupyterLab ...\n"
        assert not [process for process in family if process.is_running()]
    finally:
        for process in server.family() if server.process.poll() is None else []:
            process.kill()


def test_a_server_that_cannot_start_is_explained(tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(
        lab, "lab_command", lambda *a: [sys.executable, "-c", "print('[C no such thing]'); exit(1)"]
    )
    with pytest.raises(SetupError, match=r"did not start. What it said is in .*lab\.log"):
        lab.lab(sys.executable, browser=False, work=tmp_path)
    assert "[C no such thing]" in capsys.readouterr().err


def test_full_shows_all_of_jupyterlab_and_a_folder_that_cannot_be_made_is_explained(
    tmp_path, monkeypatch, capsys
):
    words = "import sys; print('[C ' + ' '.join(sys.argv)); exit(1)"
    monkeypatch.setattr(lab, "lab_command", lambda *a: [sys.executable, "-c", words])
    for options, start in (((), "/doc/tree/"), (("--full",), "/lab/tree/")):
        assert launcher.main(["lab", "--no-browser", "--work", str(tmp_path / "w"), *options]) == 1
        assert f"--LabApp.default_url={start}00_start_here.ipynb" in capsys.readouterr().err
    (tmp_path / "file").touch()
    assert launcher.main(["lab", "--work", str(tmp_path / "file" / "work")]) == 1
    assert "lessons cannot be copied to" in capsys.readouterr().err


def test_a_port_in_use_is_refused():
    with socket.create_server(("127.0.0.1", 0)) as other:
        port = other.getsockname()[1]
        with pytest.raises(SetupError, match=f"Port {port} cannot be used; leave --port out"):
            lab.free_port(port)


def test_other_peoples_packages_stay_outside(monkeypatch):
    monkeypatch.setenv("PYTHONPATH", "/somewhere/ros")
    assert "PYTHONPATH" not in lab.clean_environment()


def test_an_unknown_word_is_refused(capsys):
    with pytest.raises(SystemExit):
        launcher.main(["lab", "--brwoser"])
    assert "lab does not know --brwoser" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("arguments", "codes", "commands", "code"),
    [
        ([], [0, 0, 0], [*LINTERS, ALL], 0),
        ([], [0, 1, 0], [*LINTERS, ALL], 1),
        (["--quick"], [0, 0, 0], [*LINTERS, "pytest -m quick tests"], 0),
        (["--quick", "tests/dmp"], [0], ["pytest -m quick tests/dmp"], 0),
        (["tests/dmp", "-k", "law"], [2], ["pytest tests/dmp -k law"], 2),
    ],
)
def test_what_follows_test_goes_to_pytest(monkeypatch, arguments, codes, commands, code):
    said, left = [], list(codes)

    class Process:
        def __init__(self, command, **more):
            said.append(" ".join(command[2:]))

        def wait(self):
            return left.pop(0)

    monkeypatch.setattr(launcher, "prepare", lambda: "python")
    monkeypatch.setattr(launcher, "answer_signals", lambda how: None)
    monkeypatch.setattr(subprocess, "Popen", Process)
    assert launcher.main(["test", *arguments]) == code
    assert said == commands


@pytest.mark.parametrize(
    ("ci", "summary"), [("true", "1 failed, 1 skipped, 1 error in"), ("", "3 skipped in")]
)
def test_nothing_is_skipped_in_continuous_integration(tmp_path, ci, summary):
    shutil.copy(ROOT / "tests" / "conftest.py", tmp_path)
    (tmp_path / "test_a.py").write_text(
        "import pytest\n"
        "def test_browser(): pytest.skip('no Chromium here')\n"
        "def test_recordings(): pytest.skip('no recordings here: set DMP_TEACH_RECORDINGS')\n"
    )
    (tmp_path / "test_b.py").write_text("import pytest\npytest.importorskip('no_such_library')\n")
    words = "-m pytest -q -p no:cacheprovider -p no:hypothesispytest -p no:nbval "
    words += "--continue-on-collection-errors"
    answer = subprocess.run(
        [sys.executable, *words.split(), str(tmp_path)],
        env={**os.environ, "CI": ci},
        capture_output=True,
        text=True,
        check=False,
    )
    assert summary in answer.stdout.strip().splitlines()[-1], answer.stdout
    assert (answer.returncode == 0) == (ci == "")
