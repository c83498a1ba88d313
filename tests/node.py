"""What npm brings for tests: linters, a check of accessibility, and JupyterHub's proxy."""

import shutil
import subprocess
from contextlib import contextmanager
from pathlib import Path

import pytest

try:
    from fcntl import LOCK_EX, flock
except ImportError:  # Windows
    flock = None

FOLDER = Path(__file__).parent / "javascript"


def command(name):
    """The path of a program; where it is missing the test is left out."""
    path = shutil.which(name)
    if path is None:
        pytest.skip(f"{name} is not installed: with Node.js 18 or newer this is tested, too")
    return path


@contextmanager
def alone():
    """Let no other process of the tests in, where the system knows such locks."""
    with (FOLDER / "package-lock.json").open() as door:
        if flock:
            flock(door, LOCK_EX)
        yield


def modules():
    """The folder of what `package-lock.json` names; fetched where it is not there as it says."""
    locks = FOLDER / "package-lock.json", FOLDER / "node_modules" / ".package-lock.json"
    npm = command("npm")
    with alone():
        if not locks[1].exists() or locks[1].stat().st_mtime < locks[0].stat().st_mtime:
            fetched = subprocess.run(
                [npm, "ci", "--no-audit", "--no-fund", "--fetch-retries=1"],
                cwd=FOLDER,
                capture_output=True,
                text=True,
                timeout=300,
                check=False,
            )
            if fetched.returncode != 0:
                pytest.skip(f"npm cannot fetch these; is this computer online?\n{fetched.stderr}")
            locks[1].touch()
    return FOLDER / "node_modules"
