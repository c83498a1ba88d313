"""What a server has of us, however it was started: by our launcher, or by a hub."""

import json
import logging
import os
import subprocess
import sys
import tempfile
from importlib.metadata import version
from pathlib import Path
from types import SimpleNamespace

import pytest
from jupyter_server.extension.manager import ExtensionPoint
from jupyter_server.serverapp import ServerApp
from jupyter_server.services.config import ConfigManager
from traitlets.config import Config

from dmp_teach.launcher import lab

MODULE = "dmp_teach.launcher.extension"
WIDGETS = "@jupyter-widgets/jupyterlab-manager:plugin"


@pytest.fixture
def point(monkeypatch):
    """Our extension, as Jupyter finds it by the settings of the environment."""
    for name in ("JUPYTER_WIDGETS_ECHO", "DMP_TEACH_PICTURES_STAY_OUT", "DMP_TEACH_LESSONS"):
        monkeypatch.setenv(name, "")
        monkeypatch.delenv(name)
    (file,) = (lab.CONFIG / "jupyter_server_config.d").iterdir()
    ((module, enabled),) = json.loads(file.read_text())["ServerApp"]["jpserver_extensions"].items()
    assert enabled
    before = os.umask(0)
    os.umask(before)
    yield ExtensionPoint(metadata={"module": module})
    os.umask(before)


def test_a_server_is_set_by_us_but_where_somebody_has_set_it(point):
    server = ServerApp(config=Config(LabApp={"news_url": "theirs"}, KernelManager={"x": 1}))
    point.link(server)
    assert server.kernel_websocket_connection_class.__name__ == "PromptConnection"
    assert server.config.LabApp.news_url == "theirs"
    assert server.config.LabApp.extension_manager == "readonly"
    assert dict(server.config.KernelManager) == {"x": 1, "transport": "ipc"}
    assert os.environ["JUPYTER_WIDGETS_ECHO"] == "0"


def test_a_pupils_server_does_without_numpy():
    code = f"import sys, {MODULE}; sys.exit('numpy' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


@pytest.mark.skipif(sys.platform == "win32", reason="a script that stands for Node.js")
def test_a_server_starts_without_node_and_without_a_grammar_that_it_never_needs(tmp_path):
    node = tmp_path / "node"
    node.write_text(f"#!/bin/sh\ntouch {tmp_path}/started")
    node.chmod(0o755)
    around = {**os.environ, "PATH": f"{tmp_path}{os.pathsep}{os.environ['PATH']}"}
    start = [sys.executable, "-X", "importtime", "-m", "dmp_teach.launcher.quick_start"]
    done = subprocess.run(
        [*start, "jupyterlab", "--version"], env=around, capture_output=True, text=True, check=True
    )
    assert done.stdout.strip() == version("jupyterlab")
    assert "jupyter_server" in done.stderr
    assert "lark" not in done.stderr
    assert not (tmp_path / "started").exists()


def test_jupyterlab_is_set_by_us_but_where_somebody_has_set_it(tmp_path, monkeypatch):
    around = lab.lab_environment(tmp_path, "secret")
    assert around["JUPYTER_TOKEN"] == "secret"
    for name in ("JUPYTER_CONFIG_DIR", "JUPYTER_CONFIG_PATH"):
        monkeypatch.setenv(name, around[name])
    settings = ConfigManager(config_dir_name="labconfig")
    off = settings.get("page_config")["disabledExtensions"]
    assert off["@jupyterlab/apputils-extension:announcements"]
    assert settings.get("default_setting_overrides")[WIDGETS] == {"saveState": True}
    settings.set("default_setting_overrides", {WIDGETS: {"saveState": False}})
    changed = settings.get("default_setting_overrides")
    assert changed[WIDGETS] == {"saveState": False}
    assert len(changed) > 1


def test_a_pupil_of_a_hub_begins_in_a_folder_of_lessons_that_nobody_else_can_open(
    point, tmp_path, monkeypatch
):
    monkeypatch.setenv("HOME", str(tmp_path))
    monkeypatch.setenv("DMP_TEACH_LESSONS", "~/lessons")
    server = ServerApp()
    point.link(server)
    folder = tmp_path / "lessons"
    assert server.root_dir == str(folder)
    assert (folder / lab.FIRST_NOTEBOOK).exists()
    (folder / "new").touch()
    assert (folder.stat().st_mode | (folder / "new").stat().st_mode) & 0o077 == 0


def test_a_pupil_whose_lessons_cannot_be_copied_has_a_server_all_the_same(
    point, tmp_path, monkeypatch, caplog
):
    (tmp_path / "file").touch()
    monkeypatch.setenv("HOME", str(tmp_path))
    monkeypatch.setenv("DMP_TEACH_LESSONS", "~/file/lessons")
    server = ServerApp(log=logging.getLogger())
    point.link(server)
    assert server.root_dir == str(tmp_path)
    assert "lessons cannot be copied to" in caplog.text


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no sockets in folders for kernels")
def test_kernels_meet_their_server_in_a_folder_of_its_owner(point):
    hooks, kernels = [], SimpleNamespace()
    contents = SimpleNamespace(register_pre_save_hook=hooks.append)
    log = SimpleNamespace(handlers=[])
    gone = subprocess.Popen([sys.executable, "-c", ""])
    gone.wait()
    left, used = (
        Path(tempfile.mkdtemp(prefix=f"dmp-teach-{pid}-", dir="/tmp"))
        for pid in (gone.pid, os.getpid())
    )
    point.load(SimpleNamespace(contents_manager=contents, kernel_manager=kernels, log=log))
    assert [hook.__name__ for hook in hooks] == ["without_ink"]
    assert (left.exists(), used.exists()) == (False, True), "a killed server's is swept"
    used.rmdir()
    assert os.stat(kernels.connection_dir).st_mode & 0o077 == 0
    assert len(kernels.connection_dir) + len(f"/kernel-{'-' * 36}-ipc-5") < 104
