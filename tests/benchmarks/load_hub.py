"""A JupyterHub with the teachers' settings for a load: no accounts, no password, one computer."""

import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import psutil

from dmp_teach.launcher import lab as launcher
from tests.node import modules

ROOT = Path(__file__).parents[2]
MB = 1e6
# Below it the load ends: it must never take a computer down [bytes].
LEAST_FREE = 1.5e9
# The teachers' settings, in a folder and at ports of its own.
OF_ITS_OWN = """
load_subconfig({teachers!r})
c = get_config()
c.JupyterHub.bind_url = {url!r}
c.JupyterHub.hub_port = {hub_port}
c.JupyterHub.db_url = "sqlite://"
c.JupyterHub.cookie_secret_file = {folder!r} + "/cookie"
c.ConfigurableHTTPProxy.api_url = "http://127.0.0.1:{api_port}"
c.ConfigurableHTTPProxy.command = [{proxy!r}]
c.Spawner.cmd = [{python!r}, *c.Spawner.cmd[1:]]
c.Spawner.pre_spawn_hook.__globals__["PLACES"] = {places}
# What the wheel puts into etc/jupyter.
c.Spawner.environment.update({{"JUPYTER_CONFIG_PATH": {config!r}}})
"""
FOR_A_LOAD = """
c.JupyterHub.authenticator_class = "dummy"
c.DummyAuthenticator.allow_all = True
c.JupyterHub.spawner_class = "simple"
c.SimpleLocalProcessSpawner.home_dir_template = {folder!r} + "/{{username}}"
c.Spawner.args = ["--ServerApp.allow_root=True", "--LabApp.expose_app_in_browser=True"]
c.Spawner.environment.update({{"PYTHONPATH": {root!r}}})
"""


class NoRoomError(Exception):
    """The computer has too little free memory to go on."""


@dataclass(frozen=True)
class Hub:
    """A hub that runs; `process` is its own, whose children are proxy and servers."""

    folder: Path
    url: str
    process: psutil.Process

    def proxy(self) -> psutil.Process:
        """Return the process through which all that pupils send goes."""
        return next(each for each in self.process.children() if "proxy" in " ".join(each.cmdline()))

    def server(self, pupil: str) -> psutil.Process:
        """Return a pupil's server, whose children are kernels."""
        return next(
            each
            for each in self.process.children()
            if each.environ().get("JUPYTERHUB_USER") == pupil
        )


def hub_command(folder: Path, places: int, more: str) -> tuple[list[str], int]:
    """Write a hub's settings into a folder, and return what starts it, and its port."""
    port = launcher.free_port()
    settings = (OF_ITS_OWN + more).format(
        teachers=str(ROOT / "docs" / "class_hub.py"),
        url=f"http://127.0.0.1:{port}",
        hub_port=launcher.free_port(),
        api_port=launcher.free_port(),
        folder=str(folder),
        proxy=str(modules() / ".bin" / "configurable-http-proxy"),
        python=sys.executable,
        config=str(launcher.CONFIG),
        root=str(ROOT),
        places=places,
    )
    (folder / "settings.py").write_text(settings)
    return [sys.executable, "-m", "jupyterhub", "-f", str(folder / "settings.py")], port


@contextmanager
def serve_class(folder: Path, places: int = 1) -> Iterator[Hub]:
    """Run a hub with so many places, which keeps all in a folder, and end all that came of it."""
    command, port = hub_command(folder, places, FOR_A_LOAD)
    with (folder / "log").open("wb") as log:
        process = subprocess.Popen(command, cwd=folder, stdout=log, stderr=log, **launcher.apart())
    try:
        deadline = time.monotonic() + 60
        while not launcher.is_up(port):
            if process.poll() is not None or time.monotonic() > deadline:
                raise RuntimeError((folder / "log").read_text())
            time.sleep(0.1)
        yield Hub(folder, f"http://127.0.0.1:{port}", psutil.Process(process.pid))
    finally:
        launcher.end_family(sys.executable, process)


def memory_of(process: psutil.Process) -> float:
    """Return what would be free without the process [MB]."""
    return process.memory_full_info().uss / MB


def processor_time(*processes: psutil.Process) -> float:
    """Return what processes and their ended children have used of processor cores [s]."""
    return sum(sum(each.cpu_times()[:4]) for each in processes)


def check_room() -> None:
    """Raise NoRoomError where memory becomes short."""
    free = psutil.virtual_memory().available
    if free < LEAST_FREE:
        raise NoRoomError(f"Only {free / MB:.0f} MB of memory are free: the load ends.")
