"""Draw the robot that rests at its page, which panels show until the robot is asked to write.

    python assets/make_resting.py

Writes `dmp_teach/classroom/panels/resting_robot.webp`, on no ground, for pages by day and by night.
"""

from __future__ import annotations

import io
from pathlib import Path

import numpy as np
from PIL import Image

from dmp_teach.views.scene.picture import render_png
from dmp_teach.views.scene.stage import Stage

HERE = Path(__file__).parent
TARGET = HERE.parent / "dmp_teach" / "classroom" / "panels" / "resting_robot.webp"
SIZE = (1800, 1200)
"""Of the picture that is drawn [pixels]; what is kept is half as large, and cut to the robot."""


def cut_out(picture: Image.Image) -> Image.Image:
    """Return what stands before the sky, which is the same along every row."""
    pixels = np.asarray(picture.convert("RGB"), dtype=int)
    is_sky = np.abs(pixels - pixels[:, :1]).max(axis=-1) == 0
    shape = Image.fromarray(np.dstack([pixels, 255 * ~is_sky]).astype(np.uint8))
    return shape.crop(shape.getbbox()).reduce(2)


if __name__ == "__main__":
    drawn = render_png(Stage(), 0.0, "whole robot", *SIZE)
    cut_out(Image.open(io.BytesIO(drawn))).save(TARGET, quality=82, method=6)
    print(TARGET.name, TARGET.stat().st_size, "bytes")
