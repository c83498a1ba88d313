"""Start JupyterLab for a class: on this computer alone, quiet, and gone when it is ended.

The launcher runs this before anything is installed: standard library only, in the syntax of
Python 3.6.
"""

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
from dmp_teach.launcher.work import copy_lessons

ROOT = Path(__file__).resolve().parent.parent.parent
# In a clone, which has them; an installed copy holds the lessons itself.
PINS = ROOT / "environment.txt"
NOTEBOOKS = (ROOT if PINS.exists() else ROOT / "dmp_teach") / "notebooks"
# Copies of the notebooks: beside ours, where a teacher finds them, and unseen by git.
WORK = (ROOT if PINS.exists() else Path.cwd()) / "work"
# Jupyter's settings, tabs and log, so that a user's own are neither read nor changed.
STATE = ".jupyter"
FIRST_NOTEBOOK = "00_start_here.ipynb"
CONFIG = Path(__file__).resolve().parent / "config"
EXTENSIONS = Path(__file__).resolve().parent / "labextensions"
WINDOWS = os.name == "nt"

# Ends a process and its children; run by the environment's Python, which has psutil.
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
    """Set the handler of Ctrl-C and its kin, which a shell's background jobs ignore by default."""
    for name in ("SIGINT", "SIGTERM", "SIGHUP"):
        if hasattr(signal, name):
            signal.signal(getattr(signal, name), how)


def say(line):
    """Print one line at once."""
    print(line, flush=True)


def lab(python, port=None, browser=True, *, work=WORK, fresh=(), full=False):
    """Run JupyterLab on copies of the lessons until it is ended, and return the exit code.

    See `copy_lessons` for `work` and `fresh`; `full` shows all of JupyterLab around a lesson.
    """
    port = free_port(port)
    token = secrets.token_urlsafe(24)
    start = ("/lab/tree/" if full else "/doc/tree/") + FIRST_NOTEBOOK
    state = work / STATE
    prepare_work(work, fresh)
    say("Starting JupyterLab ...")
    with open(str(state / "lab.log"), "w+b") as log:
        process = subprocess.Popen(
            [
                *lab_command(python, work, port),
                "--LabApp.default_url={}".format(start),
                "--ServerApp.open_browser={}".format(browser),
            ],
            cwd=str(work),
            env=lab_environment(state, token),
            stdin=subprocess.DEVNULL,
            stdout=log,
            stderr=subprocess.STDOUT,
            **apart(),
        )
        try:
            return watch(process, state / "lab.log", port, start, token)
        except KeyboardInterrupt:
            say("Ending JupyterLab ...")
            return 0
        finally:
            # A second Ctrl-C must not leave kernels behind.
            answer_signals(signal.SIG_IGN)
            end_family(python, process)


def run_site(python, folder, of="static_site"):
    """Make the lessons, or the docs by `of="docs_site"`, a site; return the exit code."""
    command = [python, "-m", "dmp_teach.launcher." + of, str(folder)]
    return subprocess.call(command, env=clean_environment())


def prepare_work(work, fresh=()):
    """Copy the lessons, and name those that stay as somebody has changed them."""
    try:
        behind = copy_lessons(NOTEBOOKS, work, fresh)
        (work / STATE).mkdir(exist_ok=True)
    except OSError as error:
        raise SetupError("The lessons cannot be copied to {}: {}.".format(work, error)) from error
    if behind:
        names = ", ".join(behind)
        say("There is a newer version of {}. Yours stays; lab --fresh begins anew.".format(names))


def lab_command(python, root, port):
    """Return the command of the server, without the token: other users can read commands."""
    settings = {
        "ServerApp.ip": "127.0.0.1",
        "ServerApp.port": port,
        "ServerApp.port_retries": 0,
        "ServerApp.root_dir": root,
        "ServerApp.log_level": "WARN",
        "ServerApp.allow_root": True,
    }
    # -P: a pupil's random.py beside the lessons is not Python's.
    start = [python, "-P", "-m", "dmp_teach.launcher.quick_start", "jupyterlab"]
    return start + ["--{}={}".format(*pair) for pair in settings.items()]


def lab_environment(state, token):
    """Return the environment variables of the server, which lead it to `extension.py`.

    What somebody has changed in the folder `state` goes before our settings.
    """
    return clean_environment(
        JUPYTER_CONFIG_DIR=str(state),
        JUPYTER_CONFIG_PATH=os.pathsep.join([str(state), str(CONFIG)]),
        JUPYTER_TOKEN=token,
        IPYTHONDIR=str(Path(str(state)) / "ipython"),
    )


def watch(process, log, port, start, token):
    """Print where JupyterLab is and its errors, until it ends by itself."""
    said = False
    with open(str(log), errors="replace") as errors:
        while process.poll() is None:
            if not said and is_up(port):
                address = "http://127.0.0.1:{}{}?token={}".format(port, start, token)
                say("JupyterLab is at {}  (Ctrl-C ends it)".format(address))
                said = True
            show_errors(errors)
            time.sleep(0.2)
        show_errors(errors)
    if not said:
        raise SetupError("JupyterLab did not start. What it said is in {}.".format(log))
    return process.returncode


def show_errors(log):
    """Print the log's lines that are errors: they begin with [E or [C."""
    for line in log:
        if line.startswith(("[E ", "[C ")):
            sys.stderr.write(line)


def is_up(port):
    """Return whether the server answers, past any proxy."""
    try:
        opener = urllib.request.build_opener(urllib.request.ProxyHandler({}))
        return opener.open("http://127.0.0.1:{}/api".format(port), timeout=2).getcode() == 200
    except (urllib.error.URLError, OSError):
        return False


def free_port(wanted=None):
    """Return a free port of this computer, or the wanted one if it is free."""
    with socket.socket() as door:
        if not WINDOWS:
            # Allows a port that was used a moment ago; on Windows it would allow one in use.
            door.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            door.bind(("127.0.0.1", wanted or 0))
        except (OSError, OverflowError) as error:
            raise SetupError(
                "Port {} cannot be used; leave --port out and any free one is.".format(wanted)
            ) from error
        return door.getsockname()[1]


def apart():
    """Return the options of Popen that keep our Ctrl-C from a process."""
    return {"creationflags": 0x200} if WINDOWS else {"start_new_session": True}


def end_family(python, process):
    """Terminate a process and its children, then kill what is left."""
    if process.poll() is None:
        subprocess.call([python, "-c", END_FAMILY, str(process.pid)], **apart())
    process.wait()


def clean_environment(**more):
    """Return our environment variables without foreign packages, which ROS puts on PYTHONPATH."""
    kept = {
        name: value
        for name, value in os.environ.items()
        if name not in ("PYTHONPATH", "PYTHONHOME")
    }
    kept.update(PYTHONNOUSERSITE="1", **more)
    return kept
