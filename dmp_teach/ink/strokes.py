"""Where the pen touched the paper, told from its height alone."""

from dmp_teach.trajectory import Array


def find_strokes(t: Array, position: Array, theta: float = 0.10, sigma: float = 0.006) -> tuple[tuple[int, int], ...]:
    """Strokes as runs of samples `start:end`; to come."""
    raise NotImplementedError("strokes from the height are not built yet")
