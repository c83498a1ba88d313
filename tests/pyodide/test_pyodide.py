"""A page's Python is enough: all works here without what a page has not."""

import subprocess
import sys
from pathlib import Path

import pytest

CLONE = Path(__file__).parents[2]
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
