"""Colours of the shells, and two small helpers that all of them use."""

import numpy as np
from meshing import Array

BLUE, WHITE, RED = (0.086, 0.506, 0.767), (0.96, 0.96, 0.96), (0.8, 0.02, 0.02)
GREY, DARK, BLACK, LENS = (
    (0.356, 0.361, 0.376),
    (0.16, 0.165, 0.175),
    (0.05, 0.05, 0.055),
    (0.22, 0.25, 0.30),
)


def smooth(x: float) -> float:
    """From 0 to 1 without corners."""
    x = min(max(x, 0.0), 1.0)
    return x * x * (3 - 2 * x)


def table(text: str) -> Array:
    """Numbers in rows and columns; what follows a # is a remark."""
    lines = [line.partition("#")[0].split() for line in text.splitlines()]
    return np.array([line for line in lines if line], dtype=float)
