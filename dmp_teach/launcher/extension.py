"""What Jupyter's server gains where this package is: prompt panels, private notebooks and kernels.

`config/jupyter_server_config.d` enables it. Our launcher names that folder, and the wheel puts its
files into the environment's etc/jupyter, so that the servers of a hub need not be told. The files
in `config/labconfig` are JupyterLab's settings: announcements are off; the busy icon, the kernel's
status and the progress in the toolbar are off, since they are drawn anew twice in every step of a
slider; panels stay in a saved notebook; and comms go without subshells, with which panels are deaf
after a restart that another window asked for.
"""

from __future__ import annotations

import atexit
import logging
import os
import re
import shutil
import tempfile
from pathlib import Path
from typing import Any

from traitlets.config import Config

from dmp_teach.ink import PICTURES_STAY_OUT
from dmp_teach.launcher.lab import EXTENSIONS, NOTEBOOKS, WINDOWS
from dmp_teach.launcher.notebook_privacy import without_ink
from dmp_teach.launcher.work import copy_lessons

# The folder of a pupil's lessons, "~/lessons"; a hub's settings name it.
LESSONS = "DMP_TEACH_LESSONS"
SETTINGS = {
    "ServerApp": {
        "kernel_websocket_connection_class": "dmp_teach.launcher.server.PromptConnection"
    },
    # Every account of a computer can listen to a port; a socket in a folder is its owner's.
    "KernelManager": {"transport": "tcp" if WINDOWS else "ipc"},
    "LabApp": {
        "extra_labextensions_path": [str(EXTENSIONS)],
        # The default manager queries an index on the network.
        "extension_manager": "readonly",
        "check_for_updates_class": "jupyterlab.NeverCheckForUpdate",
        "news_url": None,
    },
    # It would start npm to look for language servers.
    "LanguageServerManager": {"autodetect": False},
}
# Folders of sockets begin so; the number of the server follows.
_SOCKETS = "dmp-teach-"
FOR_KERNELS = {
    # What a browser sets need not be told back to it.
    "JUPYTER_WIDGETS_ECHO": "0",
    PICTURES_STAY_OUT: "1",
}


def _jupyter_server_extension_points() -> list[dict[str, str]]:
    return [{"module": __name__}]


# Any: Jupyter's application; its class would bring all of the server with it.
def _link_jupyter_server_extension(server: Any) -> None:
    """Set what is not set otherwise, before the server makes its parts; give a pupil lessons."""
    settings = Config(SETTINGS)
    settings.merge(server.config)
    if LESSONS in os.environ:
        # What a pupil writes, in a kernel too, is nobody else's.
        os.umask(0o077)
        settings.ServerApp.root_dir = _give_lessons(server, Path(os.environ[LESSONS]).expanduser())
    server.update_config(settings)
    os.environ.update(FOR_KERNELS | os.environ)


# Any: as above.
def _load_jupyter_server_extension(server: Any) -> None:
    """Save no ink, log no token; put the sockets of kernels where nobody else can open them."""
    server.contents_manager.register_pre_save_hook(without_ink)
    for handler in server.log.handlers:
        handler.addFilter(_hide_token)
    if not WINDOWS:
        _sweep_sockets()
        # The path of a socket has at most 103 characters: a home folder may be too long.
        folder = tempfile.mkdtemp(prefix=f"{_SOCKETS}{os.getpid()}-", dir="/tmp")
        atexit.register(shutil.rmtree, folder, ignore_errors=True)
        server.kernel_manager.connection_dir = folder


def _sweep_sockets() -> None:
    """Remove the folders of this account's servers that were killed."""
    for folder in Path("/tmp").glob(f"{_SOCKETS}*-*"):
        try:
            os.kill(int(folder.name.removeprefix(_SOCKETS).split("-")[0]), 0)
        except ProcessLookupError:
            # What another account has left is refused by the system.
            shutil.rmtree(folder, ignore_errors=True)
        except (ValueError, OSError):
            continue


# Any: as above.
def _give_lessons(server: Any, folder: Path) -> str:
    """Bring a pupil's copies of the lessons up to date, and return where the server begins."""
    try:
        copy_lessons(NOTEBOOKS, folder)
        folder.chmod(0o700)
    except OSError as error:
        # With a full disk there must still be a way to make room.
        server.log.error("The lessons cannot be copied to %s: %s.", folder, error)
    return str(folder if folder.is_dir() else Path.home())


def _hide_token(record: logging.LogRecord) -> bool:
    """Blot the token out of an address: Jupyter does so in some of its lines, tornado in none."""
    if "token=" in f"{record.msg} {record.args}":
        record.msg, record.args = re.sub(r"\btoken=[^&\s]+", "token=...", record.getMessage()), ()
    return True
