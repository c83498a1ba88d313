"""An installed copy works without the clone: the wheel holds all that it reads."""

import os
import subprocess
import sys
import sysconfig
import venv
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
pytestmark = pytest.mark.slow

PIP = [sys.executable, "-m", "pip", "--disable-pip-version-check"]
QUICK_START = """
import pathlib, sys
import dmp_teach as teach
from dmp_teach.classroom import RESTING_SCRIPT

assert sys.prefix in teach.__file__, teach.__file__
assert not any((pathlib.Path(place) / "environment.txt").exists() for place in sys.path)
assert (pathlib.Path(teach.__file__).parent / "environment.txt").exists()
letter = teach.Letter.learn(teach.recording_of("a"))
strokes = letter.write(goal_shifts={0: (0.03, 0.00)})
teach.write_recording(strokes, "a.json")
assert teach.read_recordings("a.json")[0].strokes()[0].duration == strokes[0].duration
assert teach.recording_of("a", "slanted").character == "a"
assert "export" in RESTING_SCRIPT
assert len(teach.claims([teach.recording_of("l")])) > 15
teach.lesson("03").panel().html("lesson.html")
teach.view(teach.Fetch().write(strokes, teach.Page.table())).html("view.html")
print(letter)
"""


@pytest.fixture(scope="module")
def wheel(tmp_path_factory):
    """The wheel, built without a network."""
    folder = tmp_path_factory.mktemp("wheel")
    options = ["--no-build-isolation", "--no-deps", "--no-index", "--quiet"]
    subprocess.check_call([*PIP, "wheel", str(ROOT), *options, "-w", str(folder)])
    (file,) = folder.glob("*.whl")
    return file


@pytest.fixture(scope="module")
def installed(wheel, tmp_path_factory):
    """The Python of an environment with the wheel and what it depends on, but not the clone."""
    folder = tmp_path_factory.mktemp("environment")
    venv.create(folder, with_pip=False)
    python = folder / ("Scripts/python.exe" if sys.platform == "win32" else "bin/python")
    subprocess.check_call(
        [*PIP, "--python", str(python), "install", "--no-deps", "--no-index", "-q", str(wheel)]
    )
    ask = [str(python), "-c", "import sysconfig; print(sysconfig.get_path('purelib'))"]
    packages = Path(subprocess.check_output(ask, text=True).strip())
    # A .pth in a folder that a .pth names is not followed: the clone stays out, but PlaCo comes in.
    places = {sysconfig.get_path("purelib"), sysconfig.get_path("platlib")}
    places.update(place for place in sys.path if "cmeel" in place)
    (packages / "dependencies.pth").write_text("\n".join(places), encoding="utf-8")
    return str(python)


def run(python, code, folder):
    answer = subprocess.run(
        [python, "-I", "-c", code], cwd=folder, capture_output=True, text=True, check=False
    )
    assert answer.returncode == 0, answer.stderr
    return answer.stdout


def test_the_quick_start_works_in_an_installed_copy(installed, tmp_path):
    assert run(installed, QUICK_START, tmp_path).startswith("Letter(1 stroke")


def test_tab_completes_a_letter_in_an_installed_copy(installed, tmp_path):
    code = """
import jedi
code = "import dmp_teach as teach; teach.Letter."
print(*(found.name for found in jedi.Script(code).complete()))
"""
    assert {"learn", "write", "save"} <= set(run(installed, code, tmp_path).split())


def test_every_server_of_the_environment_has_our_settings_and_the_lessons(installed, tmp_path):
    code = """
from jupyter_core.paths import jupyter_config_path
from jupyter_server.extension.config import ExtensionConfigManager
from jupyter_server.services.config import ConfigManager
from dmp_teach.launcher.lab import FIRST_NOTEBOOK, NOTEBOOKS

settings = ExtensionConfigManager(read_config_path=jupyter_config_path())
assert settings.get_jpserver_extensions()["dmp_teach.launcher.extension"]
for name in ("page_config", "default_setting_overrides"):
    assert ConfigManager(config_dir_name="labconfig").get(name)
assert (NOTEBOOKS / FIRST_NOTEBOOK).exists()
"""
    run(installed, code, tmp_path)


def test_lab_copies_the_lessons_of_an_installed_copy_and_overwrites_nothing(installed, tmp_path):
    work, share = tmp_path / "lessons", str(Path(sys.prefix) / "share" / "jupyter")
    work.mkdir()
    (work / "03_bump_width.ipynb").write_text("mine")
    lab = subprocess.Popen(
        [installed, "-I", "-m", "dmp_teach", "lab", "--no-browser", "--work", str(work)],
        cwd=tmp_path,
        # Here Jupyter's own files are not in the environment that the wheel is installed in.
        env={**os.environ, "JUPYTERLAB_DIR": f"{share}/lab", "JUPYTER_PATH": share},
        stdout=subprocess.PIPE,
        text=True,
    )
    try:
        assert lab.stdout.readline() == (
            "There is a newer version of 03_bump_width.ipynb. Yours stays; "
            "lab --fresh begins anew.\n"
        )
        assert lab.stdout.readline() == "Starting JupyterLab ...\n"
        assert lab.stdout.readline().startswith("JupyterLab is at http://127.0.0.1:")
    finally:
        lab.terminate()
        assert lab.communicate(timeout=30)[0] == "Ending JupyterLab ...\n"
    given = {path.name for path in (ROOT / "notebooks").glob("*.ipynb")}
    assert {path.name for path in work.glob("*.ipynb")} == given
    assert (work / "03_bump_width.ipynb").read_text() == "mine"
    assert [path.name for path in tmp_path.iterdir()] == ["lessons"]


def test_every_file_that_is_read_is_in_the_wheel(wheel):
    inside = set(zipfile.ZipFile(wheel).namelist())
    kinds = {".py", ".pyi", ".js", ".css", ".typed", ".po", ".pot"}
    package = [path for path in (ROOT / "dmp_teach").rglob("*") if path.suffix in kinds]
    assets = [*(ROOT / "assets").glob("*.urdf"), *(ROOT / "assets" / "meshes").iterdir()]
    assets += [
        *(ROOT / "assets" / "alphabets").rglob("*.json"),
        *(ROOT / "assets" / "pupils").iterdir(),
    ]
    wanted = {path.relative_to(ROOT).as_posix() for path in package}
    wanted |= {f"dmp_teach/{path.relative_to(ROOT).as_posix()}" for path in assets}
    assert {name for name in wanted if "__pycache__" not in name} - inside == set()
    assert not [name for name in inside if name.startswith("dmp_teach/assets/") and "make" in name]
