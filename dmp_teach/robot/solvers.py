"""Which solver there is: PlaCo's where it can be imported, and else ours."""

from __future__ import annotations

import os
import threading
from collections.abc import Iterator
from contextlib import contextmanager

from dmp_teach.errors import SettingError
from dmp_teach.robot.arm import Solver
from dmp_teach.robot.numpy_arm import NumpySolver

_here = threading.local()


def get_solver() -> Solver:
    """Return the solver of this thread: PlaCo's must not be shared, and each one leaks 0.35 MB.

    `DMP_TEACH_SOLVER=NumPy` in the environment asks for ours where there is PlaCo, too.
    """
    with borrow_solver() as solver:
        return solver


@contextmanager
def borrow_solver() -> Iterator[Solver]:
    """Lend a solver of this thread to work in slices: others move an arm of their own between."""
    wanted = os.environ.get("DMP_TEACH_SOLVER", "").lower()
    if wanted not in ("", "placo", "numpy"):
        raise SettingError(f"DMP_TEACH_SOLVER is {wanted!r}, but must be NumPy, PlaCo or nothing.")
    idle = _here.__dict__.setdefault(wanted, [])
    solver = idle.pop() if idle else NumpySolver() if wanted == "numpy" else build_solver()
    try:
        yield solver
    finally:
        idle.append(solver)


def build_solver() -> Solver:
    """Return a new solver of PlaCo's, or ours where it cannot be imported."""
    try:
        from dmp_teach.robot.placo_arm import PlacoSolver  # noqa: PLC0415 (heavy)
    except (ImportError, OSError):
        return NumpySolver()
    return PlacoSolver()
