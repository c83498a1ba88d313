"""The paper's real recordings, where this machine has them: they may not be published."""

import os
from pathlib import Path

import pytest

FOLDER = Path(
    os.environ.get("DMP_TEACH_RECORDINGS", Path(__file__).parents[2] / "shared" / "data" / "mocap")
)
RECORDINGS = sorted(FOLDER.glob("*.csv"))

needs_recordings = pytest.mark.skipif(
    not RECORDINGS,
    reason="no recordings here: set DMP_TEACH_RECORDINGS to a folder of Motive CSV files",
)
