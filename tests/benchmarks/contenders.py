"""Who is measured: our presets, and two other libraries where they are installed.

Each contender learns the same letter from its arrays and draws it, with as many kernels as ours.
Other libraries are measured at their defaults, apart from what the task itself sets (the number of
kernels, the duration and the time between samples), and at the settings of theirs that we found to
be fastest and most accurate.
"""

import warnings
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from dmp_teach.dmp.primitive import DMP
from dmp_teach.dmp.settings import Settings
from dmp_teach.trajectory import Array, Trajectory

HOW_TO_INSTALL = (
    "Not installed: {names}. To compare with them, in an environment of their own (pydmps is GPL, "
    'and nothing of ours may depend on it): pip install -e ".[benchmark]"'
)


@dataclass(frozen=True)
class Contender:
    """A way to learn and draw a letter.

    Args:
        name: As it is printed.
        learn: From a letter to whatever `draw` takes, with nothing kept from one time to the next.
        draw: The path (T, D) to a goal (D,), or to the demonstrated one for None.
        bound: The least ratio of our default, fit and rollout; 0 where it is only reported.
        bound_for_goal: The same, with only the goal changed.
    """

    name: str
    learn: Callable[[Trajectory], Any]
    draw: Callable[[Any, Array | None], Array]
    bound: float = 0.0
    bound_for_goal: float = 0.0


def ours(kernels: int) -> list[Contender]:
    """Our presets; first the default, `star`, then the same with all checks of its input."""

    def contender(name: str, learn: Callable[[Trajectory], Any]) -> Contender:
        return Contender(
            f"dmp_teach {name}",
            learn,
            lambda primitive, goal: primitive.rollout(goal=goal).position,
        )

    def with_settings(settings: Settings) -> Callable[[Trajectory], Any]:
        return lambda letter: DMP.imitate(letter, settings)

    def from_arrays(letter: Trajectory) -> Any:
        return DMP.imitate(Trajectory(letter.t, letter.position), Settings.star(n_kernels=kernels))

    star, *more = [
        (name, getattr(Settings, name)(n_kernels=kernels)) for name in ("star", "joint", "plus")
    ]
    first = [
        contender("star", with_settings(star[1])),
        contender("star, all checks too", from_arrays),
    ]
    return first + [contender(name, with_settings(settings)) for name, settings in more]


def others(kernels: int) -> tuple[list[Contender], list[str]]:
    """The other libraries at their settings, and the names of those that are not installed."""
    found, missing = [], []
    for name, family in (("movement_primitives", _movement_primitives), ("pydmps", _pydmps)):
        try:
            found += family(kernels)
        except ImportError:
            missing.append(name)
    return found, missing


def _movement_primitives(kernels: int) -> list[Contender]:
    """movement_primitives (BSD), with its Cython steps."""
    from movement_primitives.dmp import DMP as Theirs  # noqa: PLC0415, N811 (only where it is installed)
    from movement_primitives.dmp_fast import dmp_step  # noqa: F401, PLC0415 (without Cython it is far slower)

    def contender(
        name: str, stepper: str, least: float = 0, for_goal: float = 0, **about: Any
    ) -> Contender:
        def learn(letter: Trajectory) -> Any:
            settings = {
                key: value(letter) if callable(value) else value for key, value in about.items()
            }
            primitive = Theirs(
                letter.dimensions, letter.duration, own_step(letter), kernels, **settings
            )
            primitive.imitate(letter.t, letter.position)
            return primitive

        def draw(primitive: Any, goal: Array | None) -> Array:
            if goal is not None:
                primitive.configure(goal_y=goal)
            return primitive.open_loop(step_function=stepper)[1]

        return Contender(f"movement_primitives {name}", learn, draw, least, for_goal)

    def own_step(letter: Trajectory) -> float:
        return letter.duration / (len(letter) - 1)

    return [
        contender("default", "rk4-cython", 50, 800),
        contender("fastest", "euler-cython", int_dt=own_step),
        contender("most accurate", "euler-cython", int_dt=0.0002, alpha_y=60.0, beta_y=15.0),
    ]


def _pydmps(kernels: int) -> list[Contender]:
    """pydmps (GPL): measured, and imported nowhere else."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # its own
        from pydmps.dmp_discrete import DMPs_discrete  # noqa: PLC0415 (only where it is installed)

    def contender(
        name: str, least: float = 0, for_goal: float = 0, narrower: float = 1.0
    ) -> Contender:
        def learn(letter: Trajectory) -> Any:
            step = 1 / len(letter)  # its movements last 1 s
            primitive = DMPs_discrete(n_dmps=letter.dimensions, n_bfs=kernels, dt=step)
            if narrower != 1.0:
                primitive.h = narrower * primitive.h
            primitive.imitate_path(y_des=letter.position.T)
            return primitive

        def draw(primitive: Any, goal: Array | None) -> Array:
            if goal is not None:
                primitive.goal = np.array(goal)
            return primitive.rollout()[0]

        return Contender(f"pydmps {name}", learn, draw, least, for_goal)

    return [contender("default", 40, 800), contender("most accurate", narrower=100.0)]
