"""What is to be seen of a motion, computed once for the live view, the file and the picture."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from functools import cached_property, lru_cache

import numpy as np
from numpy.typing import NDArray

from dmp_teach.robot import (
    BREAKING_FORCE,
    JOINTS,
    PENS,
    START_POSTURES,
    Model,
    Motion,
    Page,
    Run,
    Visual,
)
from dmp_teach.texts import gettext as _
from dmp_teach.texts import ngettext
from dmp_teach.trajectory import Array, Trajectory
from dmp_teach.views.scene.cameras import Camera, fit_cameras
from dmp_teach.views.scene.keyframes import find_key_rows
from dmp_teach.views.scene.pen_force import describe_force, find_ink_width, find_shade
from dmp_teach.views.scene.ribbon import MAX_DOTS, Ribbon, build_ribbon, find_inked_strokes
from dmp_teach.views.scene.shapes import ColoredMesh, build_surroundings
from dmp_teach.views.scene.sight import MovingBoxes

INK_WIDTH = 0.0022
INK_HEIGHT = 0.0006
PLAN_WIDTH = 0.0008
PLAN_HEIGHT = 0.0003

BROKEN_PEN = np.array(
    [[1, 0, 0, 0], [0, 0.6, -0.8, 0], [0, 0.8, 0.6, 0], [0, 0, 0, 1]], dtype=float
)
"""How a broken pen hangs in its holder, a pose (4, 4)."""

# What cameras are fitted to: moments of the writing, and points of the letter.
_MOMENTS = 7
_MAX_LETTER_POINTS = 40
_MAX_FACT_DOTS = 800


@lru_cache(maxsize=2)
def load_robot_model(pen: str = "rigid") -> Model:
    """Read the Fetch with its pen once: held fast, as in a plan, or on a spring."""
    return Model.load(PENS[pen])


def build_visual(visual: Visual, name: str) -> ColoredMesh:
    """Return a piece of the robot's shell in its own frame."""
    red, green, blue, opacity = visual.color.tolist()
    color = (red, green, blue, opacity)
    return ColoredMesh(name, visual.vertices, visual.normals, visual.faces, color)


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
        return load_robot_model() if self.run is None else load_robot_model(self.run.pen)

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
        return JOINTS if self.motion is None else self.motion.joint_names

    @cached_property
    def keys(self) -> tuple[Array, Array]:
        """Times from 0 (K,) [s], and joint positions at them (K, J) [rad, m]."""
        if self.motion is None:
            return np.zeros(1), START_POSTURES[:1]
        rows = find_key_rows(self.model, self.motion)
        return self.motion.t[rows] - self.motion.t[0], self.motion.q[rows]

    @cached_property
    def breaks_at(self) -> float:
        """When a rigid pen is pushed harder than it survives [s]; infinity: never."""
        if self.run is None or self.run.pen != "rigid":
            return np.inf
        hard = self.run.t[self.run.force > BREAKING_FORCE]
        return float(hard[0] - self.run.t[0]) if len(hard) else np.inf

    @cached_property
    def ink(self) -> Ribbon:
        """The nib's ink in its order, as wide as a run was pressed, until the pen breaks."""
        run = self.run
        if run is None:
            strokes = () if self.motion is None else find_inked_strokes(self.motion)
            return build_ribbon(strokes, INK_WIDTH, INK_HEIGHT)
        begin, last = run.t[0], run.t[0] + self.breaks_at
        whole = [(each, int(np.searchsorted(each.t, last))) for each in run.ink]
        strokes = tuple(
            Trajectory(each.t[:count] - begin, each.position[:count])
            for each, count in whole
            if count > 1
        )
        return build_ribbon(strokes, lambda t: find_ink_width(_find_force(run, t)), INK_HEIGHT)

    @cached_property
    def shades(self) -> NDArray[np.int_] | None:
        """Of a run, the number of the shade of ink at each dot of `ink`, shape (P,)."""
        return None if self.run is None else find_shade(_find_force(self.run, self.ink.t))

    @cached_property
    def plan(self) -> Ribbon:
        """The planned letter."""
        strokes = () if self.motion is None else self.motion.strokes
        return build_ribbon(strokes, PLAN_WIDTH, PLAN_HEIGHT, 0.002, MAX_DOTS // 2)

    @cached_property
    def surroundings(self) -> tuple[ColoredMesh, ...]:
        """The sheet and what carries it."""
        return build_surroundings(self.page)

    @cached_property
    def cameras(self) -> dict[str, Camera]:
        """The three cameras, by name."""
        letter = self.ink.dots if len(self.ink.dots) else self.plan.dots
        letter = letter[:: len(letter) // _MAX_LETTER_POINTS + 1]
        if not len(letter):
            letter = np.zeros((1, 2))
        table = np.vstack([shape.vertices for shape in self.surroundings])
        return fit_cameras(self.page, self._sample_boxes(), self.page.to_world(letter), table)

    def facts(self) -> dict[str, object]:
        """Return the browser's numbers, sentences, and the small page in [mm]."""
        strokes = len(self.plan.first.nonzero()[0])
        action = _("It waits for a letter.")
        if strokes:
            action = ngettext(
                "It writes {n} stroke in {seconds:.1f} s.",
                "It writes {n} strokes in {seconds:.1f} s.",
                strokes,
            ).format(n=strokes, seconds=self.duration)
        return {
            "duration": self.duration,
            "cameras": {name: asdict(camera) for name, camera in self.cameras.items()},
            "page": [*self.page.X_world_page.ravel().tolist(), self.page.width, self.page.height],
            "plan": _list_dots(self.plan),
            "ink": _list_dots(self.ink, self.shades),
            "force": None if self.run is None else describe_force(self.run),
            "label": f"{_('A Fetch robot with a pen at its page.')} {action}",
            "notes": " ".join(() if self.motion is None else self.motion.notes),
        }

    def joints(self, t: float) -> Array:
        """Return joint positions at time `t` [s], even from key to key, shape (J,) [rad, m]."""
        times, q = self.keys
        return np.array([np.interp(t, times, column) for column in q.T])

    def robot(self, t: float, pen_only: bool = False) -> tuple[ColoredMesh, ...]:
        """Return the robot's shell in the world at time `t` [s], or the pen alone."""
        model = self.model
        poses = model.link_poses(self.joints(t), self.joint_names)
        if t >= self.breaks_at:
            X = poses["pen_link"]
            broken = X @ BROKEN_PEN @ np.linalg.inv(X)
            poses |= {link: broken @ poses[link] for link in ("pen_link", "pen_tip")}
        return tuple(
            build_visual(visual, f"{visual.link} {number}").moved(
                poses[visual.link][0] @ visual.X_link_visual
            )
            for number, visual in enumerate(model.visuals)
            if not pen_only or visual.link.startswith("pen_")
        )

    def _sample_boxes(self) -> MovingBoxes:
        """Return boxes round the shell at moments of the writing, and at the end."""
        inked = self.ink.t if len(self.ink.t) else np.zeros(1)
        moments = np.linspace(inked[0], inked[-1], _MOMENTS)
        q = np.array([self.joints(t) for t in (*moments, self.duration)])
        poses = self.model.link_poses(q, self.joint_names)
        visuals = self.model.visuals
        pieces = [build_visual(each, each.link).moved(each.X_link_visual) for each in visuals]
        return MovingBoxes(
            tuple(each.link for each in visuals),
            np.array([piece.vertices.min(axis=0) for piece in pieces]),
            np.array([piece.vertices.max(axis=0) for piece in pieces]),
            np.stack([np.broadcast_to(poses[each.link], (len(q), 4, 4)) for each in visuals], 1),
        )


def _find_force(run: Run, t: Array) -> Array:
    """Return the pen's force at times (P,) [s], where it left ink [N]."""
    if not run.contact.any():
        return np.zeros(len(t))
    return np.interp(t, run.t[run.contact] - run.t[0], run.force[run.contact])


def _list_dots(line: Ribbon, shades: NDArray[np.int_] | None = None) -> list[list[float]]:
    """Return time [s], right and up [mm], whether a stroke begins, and the shade, of each dot.

    Of a long text only some dots are listed.
    """
    every = len(line.t) // _MAX_FACT_DOTS + 1
    kept = line.first | np.roll(line.first, -1) | (np.arange(len(line.t)) % every == 0)
    columns = [np.round(line.t, 3), *np.round(1000 * line.dots.T, 1), line.first.astype(int)]
    if shades is not None:
        columns.append(shades)
    return np.column_stack(columns)[kept].tolist()
