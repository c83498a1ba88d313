"""JupyterLab, started so that a class can use it: on this computer alone, quiet, and gone when it is ended.

The launcher runs this before anything is installed: standard library only, in words that Python 3.6 understands.
"""

import json
import os
import secrets
import signal
import socket
import subprocess
import sys
import time
import urllib.error
import urllib.request
from pathlib import Path

from dmp_teach.errors import SetupError

ROOT = Path(__file__).resolve().parent.parent.parent
STATE = (
    ROOT / ".jupyter"
)  # Jupyter's settings, tabs and log: ours, so that nobody's own are read or changed
FIRST_NOTEBOOK = "notebooks/00_start_here.ipynb"
WINDOWS = os.name == "nt"

# Ends a process and all that it has started; psutil lives in the environment, so the environment's Python runs it.
END_FAMILY = """
import psutil, sys, time

def lives(process):
    try:
        return process.is_running() and process.status() != psutil.STATUS_ZOMBIE
    except psutil.NoSuchProcess:
        return False

first = psutil.Process(int(sys.argv[1]))
family = [first, *first.children(recursive=True)]
first.terminate()
patience = time.monotonic() + 10
while any(map(lives, family)) and time.monotonic() < patience:
    time.sleep(0.05)
for straggler in filter(lives, family):
    straggler.kill()
"""


def answer_signals(how):
    """Set what Ctrl-C and its kin do; set, not inherited: a shell's background jobs ignore Ctrl-C."""
    for name in ("SIGINT", "SIGTERM", "SIGHUP"):
        if hasattr(signal, name):
            signal.signal(getattr(signal, name), how)


def say(line):
    """One line for the person at the keyboard."""
    print(line, flush=True)


def lab(python, port=None, browser=True):
    """Run JupyterLab until somebody ends it; returns the exit code."""
    port, token = free_port(port), secrets.token_urlsafe(24)
    STATE.mkdir(exist_ok=True)
    say("Starting JupyterLab ...")
    with open(str(STATE / "lab.log"), "w+b") as log:
        process = subprocess.Popen(
            [*lab_command(python, ROOT, port), "--ServerApp.open_browser={}".format(browser)],
            cwd=str(ROOT),
            env=lab_environment(STATE, token),
            stdin=subprocess.DEVNULL,
            stdout=log,
            stderr=subprocess.STDOUT,
            **apart(),
        )
        try:
            return watch(process, port, token)
        except KeyboardInterrupt:
            say("Ending JupyterLab ...")
            return 0
        finally:
            answer_signals(signal.SIG_IGN)  # impatience does not leave kernels behind
            end_family(python, process)


def lab_command(python, root, port):
    """What starts the server, as a list of words. The token is not among them: other people can read these."""
    settings = {
        "ServerApp.ip": "127.0.0.1",
        "ServerApp.port": port,
        "ServerApp.port_retries": 0,
        "ServerApp.root_dir": root,
        "ServerApp.log_level": "WARN",
        "ServerApp.allow_root": True,
        "ServerApp.kernel_websocket_connection_class": "dmp_teach.launcher.server.PromptConnection",
        "FileContentsManager.pre_save_hook": "dmp_teach.launcher.notebook_privacy.without_ink",
        "LabApp.default_url": "/lab/tree/" + FIRST_NOTEBOOK,
        "LabApp.extension_manager": "readonly",  # the other one asks an index on the network
        "LabApp.check_for_updates_class": "jupyterlab.NeverCheckForUpdate",
        "LabApp.news_url": None,
        "LanguageServerManager.autodetect": False,  # it would start npm to look for language servers
    }
    return [python, "-m", "jupyterlab"] + ["--{}={}".format(*pair) for pair in settings.items()]


def lab_environment(state, token):
    """The server's surroundings: a settings folder of its own.

    In it Jupyter's question about news is switched off, and panels stay in a saved notebook: as a sentence that says
    how to wake them, without their ink (`saving.py`).
    """
    off = {"@jupyterlab/apputils-extension:announcements": True}
    settle(
        state,
        "page_config.json",
        {"disabledExtensions": off, "buildCheck": False, "buildAvailable": False},
    )
    widgets = {"@jupyter-widgets/jupyterlab-manager:plugin": {"saveState": True}}
    settle(state, "default_setting_overrides.json", widgets)
    return clean_environment(
        JUPYTER_CONFIG_DIR=str(state),
        JUPYTER_TOKEN=token,
        IPYTHONDIR=str(Path(str(state)) / "ipython"),
    )


def settle(state, name, content):
    """Write a file of JupyterLab's settings, unless there is one."""
    file = Path(str(state)) / "labconfig" / name
    if not file.exists():
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(json.dumps(content))


def watch(process, port, token):
    """Say once where JupyterLab is, show its errors and nothing else, until it ends by itself."""
    said = False
    with open(str(STATE / "lab.log"), errors="replace") as errors:
        while process.poll() is None:
            if not said and is_up(port):
                address = "http://127.0.0.1:{}/lab/tree/{}?token={}".format(
                    port, FIRST_NOTEBOOK, token
                )
                say("JupyterLab is at {}  (Ctrl-C ends it)".format(address))
                said = True
            show_errors(errors)
            time.sleep(0.2)
        show_errors(errors)
    if not said:
        raise SetupError("JupyterLab did not start. What it said is in .jupyter/lab.log.")
    return process.returncode


def show_errors(log):
    """Pass on the log's lines that are errors: they begin with [E or [C."""
    for line in log:
        if line.startswith(("[E ", "[C ")):
            sys.stderr.write(line)


def is_up(port):
    """Whether the server answers, asked past any proxy."""
    try:
        opener = urllib.request.build_opener(urllib.request.ProxyHandler({}))
        return opener.open("http://127.0.0.1:{}/api".format(port), timeout=2).getcode() == 200
    except (urllib.error.URLError, OSError):
        return False


def free_port(wanted=None):
    """A port of this computer that nobody uses."""
    with socket.socket() as door:
        if (
            not WINDOWS
        ):  # there it would allow a port in use; here it allows one that was used a moment ago
            door.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            door.bind(("127.0.0.1", wanted or 0))
        except (OSError, OverflowError) as error:
            raise SetupError(
                "Port {} cannot be used; leave --port out and any free one is.".format(wanted)
            ) from error
        return door.getsockname()[1]


def apart():
    """Start a process away from our Ctrl-C, so that we can end it in order."""
    return {"creationflags": 0x200} if WINDOWS else {"start_new_session": True}


def end_family(python, process):
    """End a process and every process that it has started, gently and then firmly."""
    if process.poll() is None:
        subprocess.call([python, "-c", END_FAMILY, str(process.pid)], **apart())
    process.wait()


def clean_environment(**more):
    """Our surroundings without other people's packages: robots' shells often put theirs on the PYTHONPATH."""
    kept = {
        name: value
        for name, value in os.environ.items()
        if name not in ("PYTHONPATH", "PYTHONHOME")
    }
    kept.update(PYTHONNOUSERSITE="1", **more)
    return kept
