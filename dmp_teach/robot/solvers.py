"""Which solver there is: PlaCo's where it can be imported, and else ours."""

from __future__ import annotations

import os
import threading

from dmp_teach.robot.arm import Solver
from dmp_teach.robot.numpy_arm import NumpySolver

_here = threading.local()


def get_solver(use: str = "") -> Solver:
    """Return the solver of this thread: PlaCo's must not be shared, and each one leaks 0.35 MB.

    What works in slices has a `use` of its own: between two of them others may move their arm.

    `DMP_TEACH_SOLVER=NumPy` in the environment asks for ours where there is PlaCo, too.
    """
    wanted = os.environ.get("DMP_TEACH_SOLVER", "").lower()
    solvers = _here.__dict__
    key = f"{wanted} {use}"
    if key not in solvers:
        solvers[key] = NumpySolver() if wanted == "numpy" else build_solver()
    return solvers[key]


def build_solver() -> Solver:
    """Return a new solver of PlaCo's, or ours where it cannot be imported."""
    try:
        from dmp_teach.robot.placo_arm import PlacoSolver  # noqa: PLC0415 (heavy)
    except (ImportError, OSError):
        return NumpySolver()
    return PlacoSolver()
