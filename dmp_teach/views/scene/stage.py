"""What is to be seen of a motion, computed once for every way of showing it: live, as a file, as a picture."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np

from dmp_teach.robot import PENS, Model, Motion, Page, Run
from dmp_teach.trajectory import Array, Trajectory
from dmp_teach.views.scene import pressing
from dmp_teach.views.scene.cameras import Camera, cameras
from dmp_teach.views.scene.keyframes import key_rows
from dmp_teach.views.scene.ribbon import MOST_DOTS, Ribbon, inked, ribbon
from dmp_teach.views.scene.shapes import Shape, around

REST = {
    "torso_lift_joint": 0.386,
    "shoulder_pan_joint": -0.11,
    "shoulder_lift_joint": -0.45,
    "upperarm_roll_joint": -0.37,
    "elbow_flex_joint": 1.53,
    "forearm_roll_joint": -1.39,
    "wrist_flex_joint": -0.88,
    "wrist_roll_joint": 0.82,
}
"""How the robot waits for something to write [rad, m]."""

INK_WIDTH, INK_HEIGHT = 0.0022, 0.0006
PLAN_WIDTH, PLAN_HEIGHT = 0.0008, 0.0003
_MOMENTS = 6
_POINTS = 1500


@lru_cache(maxsize=2)
def robot_model(pen: str = "rigid") -> Model:
    """The Fetch with its pen, read once: held fast, as in a plan, or on a spring."""
    return Model.load(PENS[pen])


@dataclass(frozen=True, eq=False)
class Stage:
    """The robot, its page and the ink; without a motion the robot waits at an empty page.

    Args:
        motion: What the robot does, or None.
        run: What became of it, if that is to be seen; then `motion` is its motion.
    """

    motion: Motion | None = None
    run: Run | None = None

    @property
    def model(self) -> Model:
        """The robot, with the pen that it holds here."""
        return robot_model() if self.run is None else robot_model(self.run.pen)

    @property
    def page(self) -> Page:
        """The sheet; the one on the table where there is no motion."""
        return Page.table() if self.motion is None else self.motion.page

    @property
    def duration(self) -> float:
        """Of the motion [s]; 0 without one."""
        return 0.0 if self.motion is None else self.motion.duration

    @property
    def joint_names(self) -> tuple[str, ...]:
        """Names of the columns of `keys`."""
        return tuple(REST) if self.motion is None else self.motion.joint_names

    @cached_property
    def keys(self) -> tuple[Array, Array]:
        """Times from 0 (K,) [s], and joint positions at them (K, J) [rad, m]."""
        if self.motion is None:
            return np.zeros(1), np.array([list(REST.values())])
        rows = key_rows(self.model, self.motion)
        return self.motion.t[rows] - self.motion.t[0], self.motion.q[rows]

    @cached_property
    def ink(self) -> Ribbon:
        """What the nib has written in the end, in the order in which it does; of a run as wide as it was pressed."""
        if self.run is not None:
            return ribbon(self._inked(), lambda t: pressing.width(self._force(t)), INK_HEIGHT)
        strokes = () if self.motion is None else inked(self.motion)
        return ribbon(strokes, INK_WIDTH, INK_HEIGHT)

    @cached_property
    def shades(self) -> Array | None:
        """Of a run, the number of the shade of ink at each dot of `ink`, shape (P,)."""
        return None if self.run is None else pressing.shade(self._force(self.ink.t))

    @cached_property
    def plan(self) -> Ribbon:
        """The letter that was asked for."""
        strokes = () if self.motion is None else self.motion.strokes
        return ribbon(strokes, PLAN_WIDTH, PLAN_HEIGHT, spacing=0.002, most=MOST_DOTS // 2)

    @cached_property
    def around(self) -> tuple[Shape, ...]:
        """The sheet and what carries it."""
        return around(self.page)

    @cached_property
    def cameras(self) -> dict[str, Camera]:
        """The three cameras, by name."""
        letter = self.ink.dots if len(self.ink.dots) else self.plan.dots
        letter = letter[:: len(letter) // 80 + 1] if len(letter) else np.zeros((1, 2))
        carried = np.vstack([shape.vertices for shape in self.around])
        return cameras(self.page, self._robot_points(), self.page.to_world(letter), carried)

    def facts(self) -> dict[str, object]:
        """What the browser needs to know besides the scene: numbers, sentences, and the small page in [mm]."""
        strokes = len(self.plan.first.nonzero()[0])
        does = f"It writes {strokes} stroke{'' if strokes == 1 else 's'} in {self.duration:.1f} s."
        return {
            "duration": self.duration,
            "cameras": {name: camera.as_dict() for name, camera in self.cameras.items()},
            "page": [*self.page.X_world_page.ravel().tolist(), self.page.width, self.page.height],
            "plan": _dots(self.plan),
            "ink": _dots(self.ink, self.shades),
            "force": None if self.run is None else pressing.strip(self.run),
            "label": f"A Fetch robot with a pen at its page. {does if strokes else 'It waits for a letter.'}",
            "notes": " ".join(() if self.motion is None else self.motion.notes),
        }

    def joints(self, t: float) -> Array:
        """Joint positions at time `t` [s], as the browser shows them: even from key to key, shape (J,) [rad, m]."""
        times, q = self.keys
        return np.array([np.interp(t, times, column) for column in q.T])

    def robot(self, t: float, pen_only: bool = False) -> tuple[Shape, ...]:
        """The robot's shell in the world at time `t` [s], or the pen alone."""
        model = self.model
        poses = model.link_poses(self.joints(t), self.joint_names)
        pieces = (
            (
                Shape(f"{v.link} {n}", v.vertices, v.normals, v.faces, tuple(v.color)),
                poses[v.link][0] @ v.X_link_visual,
            )
            for n, v in enumerate(model.visuals)
            if not pen_only or v.link.startswith("pen_")
        )
        return tuple(shape.moved(X) for shape, X in pieces)

    def _inked(self) -> tuple[Trajectory, ...]:
        """The ink of the run, its clock from 0."""
        return tuple(
            Trajectory(stroke.t - self.run.t[0], stroke.position) for stroke in self.run.ink
        )

    def _force(self, t: Array) -> Array:
        """With which the pen pressed at times (P,) [s], where it left ink [N]."""
        run = self.run
        if not run.contact.any():
            return np.zeros(len(t))
        return np.interp(t, run.t[run.contact] - run.t[0], run.force[run.contact])

    def _robot_points(self) -> Array:
        """Some points of the shell at some moments of the writing, shape (M, P, 3) [m]."""
        ink = self.ink.t if len(self.ink.t) else np.zeros(1)
        moments = np.interp(np.linspace(0, 1, _MOMENTS), np.linspace(0, 1, len(ink)), ink)
        shells = [np.vstack([shape.vertices for shape in self.robot(t)]) for t in moments]
        return np.stack([shell[:: len(shell) // _POINTS + 1] for shell in shells])


def _dots(line: Ribbon, shades: Array | None = None) -> list[list[float]]:
    """Time [s], right and up [mm], 1 where a stroke begins, and the shade, for each dot; of a long text for some."""
    kept = (
        line.first
        | np.roll(line.first, -1)
        | (np.arange(len(line.t)) % (len(line.t) // 800 + 1) == 0)
    )
    columns = np.round(line.t, 3), *np.round(1000 * line.dots.T, 1), line.first.astype(int)
    return np.column_stack(columns if shades is None else (*columns, shades))[kept].tolist()
