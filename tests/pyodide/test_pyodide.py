"""A page's Python is enough: in Pyodide under Node.js, and here without what a page has not."""

import shutil
import subprocess
import sys
import zipfile
from importlib.metadata import distribution, version
from pathlib import Path

import pytest

from dmp_teach.errors import SetupError
from dmp_teach.launcher import site_packages
from dmp_teach.launcher.static_site import CACHE

HERE = Path(__file__).parent
# The test of the site may fetch at the same time.
OWN_CACHE = CACHE / "tests"
CLONE = HERE.parents[1]
FOR_TESTS = ["pytest", "pluggy", "iniconfig", "sortedcontainers"]
# It has native code: a page needs another wheel than the one that is installed here.
HYPOTHESIS = f"hypothesis=={version('hypothesis')}"
FOR_PAGE = ["--python-version", "3.14", "--platform", "pyemscripten_2026_0_wasm32"]
FOR_PAGE += ["--only-binary", ":all:"]
ABSENT = "placo pinocchio coal pybullet meshcat tornado zmq psutil rosbags jupyter_server apsw lxml"
ABSENT += " zxingcpp sklearn hmmlearn"
# Nothing that a page has not is found.
WITHOUT = f"""
import asyncio, pathlib, sys
from importlib.machinery import PathFinder

class Finder(PathFinder):
    @classmethod
    def find_spec(cls, name, path=None, target=None):
        absent = name.partition(".")[0] in {ABSENT!r}.split()
        return None if absent else super().find_spec(name, path, target)

sys.meta_path[:] = [Finder if finder is PathFinder else finder for finder in sys.meta_path]
from tests.pyodide.in_a_page import main
asyncio.run(main(pathlib.Path(sys.argv[1])))
"""
pytestmark = pytest.mark.slow


def run(*command, timeout):
    done = subprocess.run(
        command, cwd=CLONE, capture_output=True, text=True, timeout=timeout, check=False
    )
    assert done.returncode == 0, done.stdout[-3000:] + done.stderr[-3000:]
    return done.stdout


def test_panels_scores_figures_view_and_robot_need_no_native_part(tmp_path):
    assert "All works in a page." in run(sys.executable, "-c", WITHOUT, str(tmp_path), timeout=300)


@pytest.fixture
def page(tmp_path):
    """Pyodide, and a folder of what a page has, and what tests need beside it."""
    try:
        OWN_CACHE.mkdir(parents=True, exist_ok=True)
        pyodide = site_packages.fetch_pyodide(OWN_CACHE)
        built = site_packages.fetch_built(OWN_CACHE, pyodide)
        fetch = [sys.executable, "-m", "pip", "install", "-q", "--no-deps", *FOR_PAGE]
        site_packages.call([*fetch, "--target", str(tmp_path), HYPOTHESIS])
    except SetupError as error:
        pytest.skip(f"Pyodide cannot be fetched: {error}")
    for wheel in built.iterdir():
        with zipfile.ZipFile(wheel) as packed:
            files = [name for name in packed.namelist() if "/tests/" not in name]
            packed.extractall(tmp_path, files)
    for name in [*site_packages.UNPACKED, *site_packages.PACKED, *FOR_TESTS]:
        for file in distribution(name).files:
            if file.parts[0] != ".." and file.suffix in (".py", ".js", ".css", ""):
                (tmp_path / file.parent).mkdir(parents=True, exist_ok=True)
                shutil.copy(file.locate(), tmp_path / file)
    return pyodide, tmp_path


def test_primitive_ink_letters_and_panels_work_in_pyodide(page):
    said = run("node", HERE / "run.mjs", *page, CLONE, HERE / "laws.py", timeout=600)
    assert "passed" in said
    assert "All works in a page." in said
