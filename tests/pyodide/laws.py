"""For Pyodide alone: quick tests of primitive, ink and letters, and all that a page does."""

import os
from pathlib import Path
from tempfile import mkdtemp

import pytest

from tests.pyodide.in_a_page import main

DMP = "primitive laws stepping responses spring"
FILES = [f"tests/dmp/test_{name}.py" for name in DMP.split()]
FILES += [f"tests/ink/test_{name}.py" for name in ("json", "pad", "pen_lifts")]
FILES += [f"tests/letters/test_{name}.py" for name in ("letter", "saved")]
os.chdir("/clone")
options = ["-q", "-m", "quick", "-o", "addopts=--import-mode=importlib", "-o", "filterwarnings="]
assert pytest.main([*options, "-p", "no:cacheprovider", "--tb=short", *FILES]) == 0
await main(Path(mkdtemp()))  # noqa: F704, PLE1142 (Pyodide has a loop)
