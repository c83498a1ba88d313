"""A motion as it met the paper: joints, ink and force, and how far that is from the plan."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np
import scipy

from dmp_teach.robot.motion import BoolArray, Motion
from dmp_teach.robot.page import Page
from dmp_teach.trajectory import Array, Trajectory
from dmp_teach.values import Value, locked

INK_COVER = 0.002
"""Ink this near to a place of the letter covers it [m]."""

FORCE_BAND = (0.2, 1.2)
"""Good pressing: between these two forces [N]."""

BREAKING_FORCE = 10.0
"""A pen does not survive more than this [N]."""

# So much of the letter may lack ink, or be pressed too hard, before anything is said.
_SPARE = 0.01
# Ink that is this far from the letter on average is worth a word [m].
_ASTRAY = 0.002
_PLAN_AGAIN = "Plan again for the page as it lies."


@dataclass(frozen=True, eq=False, repr=False)
class Run(Value):
    """A motion as physics let it happen.

    Args:
        motion: As it happened: `q` holds the joints where they were (with `pen_slide_joint` last,
            for a sprung pen), `tip` where the pen's tip was, `page` where the sheet really lay;
            `target`, `pen_down` and `strokes` are the plan's.
        planned: The motion as it was planned.
        ink: The strokes on the page, one for each time that the nib touched the paper, with the
            times at which it was there (page frame, origin at its centre) [s], [m].
        nib: The place of the ball at the tip that is nearest to the paper, in the page's frame,
            shape (T, 3) [m].
        force: With which the nib pressed on the paper during the step before each sample, shape
            (T,) [N].
        contact: True where that left ink, shape (T,).
        effort: Of the motors in that step, shape (T, J) [N m, N].
        limits: The greatest efforts of the joints, shape (J,) [N m, N].
        pen: "sprung" or "rigid".
        motors: "ideal" or "real".
        stopped: True where the simulation was interrupted; then all this ends there.
    """

    motion: Motion
    planned: Motion
    ink: tuple[Trajectory, ...]
    nib: Array
    force: Array
    contact: BoolArray
    effort: Array
    limits: Array
    pen: str = "sprung"
    motors: str = "ideal"
    stopped: bool = False

    def __post_init__(self) -> None:
        object.__setattr__(self, "ink", tuple(self.ink))
        super().__post_init__()

    @property
    def t(self) -> Array:
        """Times, shape (T,) [s]."""
        return self.motion.t

    @property
    def page(self) -> Page:
        """Where the sheet really lay."""
        return self.motion.page

    @property
    def duration(self) -> float:
        """From the first sample to the last [s]."""
        return self.motion.duration

    @cached_property
    def letter(self) -> Array:
        """Where ink was meant to be on the page, sample by sample, shape (N, 2) [m]."""
        return self.planned.page.to_page(self.planned.target[self.planned.pen_down])[:, :2]

    @property
    def writing(self) -> BoolArray:
        """True where the pen was meant to write and did, shape (T,)."""
        return self.contact & self.motion.pen_down

    @cached_property
    def distances(self) -> Array:
        """Distances of the samples with `writing` from the planned letter, shape (K,) [m]."""
        return locked(measure_distances(self.nib[self.writing, :2], self.planned))

    @property
    def shape_error(self) -> float:
        """Root mean square of `distances` [m]; nan where there is no ink."""
        if not self.writing.any():
            return float("nan")
        return float(np.sqrt(np.mean(self.distances**2)))

    @property
    def force_band(self) -> tuple[float, float]:
        """Forces between which the pen pressed for nine tenths of the writing: 5 and 95 % [N]."""
        pressed = self.force[self.motion.pen_down]
        low, high = np.percentile(pressed, [5, 95]) if len(pressed) else (0.0, 0.0)
        return float(low), float(high)

    @cached_property
    def missing(self) -> BoolArray:
        """True at each place of `letter` until now that has no ink within 2 mm, shape (N,)."""
        places = self.letter[: int(self.motion.pen_down.sum())]
        if not self.writing.any():
            return np.ones(len(places), bool)
        return scipy.spatial.cKDTree(self.nib[self.writing, :2]).query(places)[0] > INK_COVER

    @cached_property
    def ink_in_the_air(self) -> float:
        """Length of ink drawn with the pen up, over 2 mm from the letter [m]."""
        drawn = self.contact[1:] & self.contact[:-1] & ~self.motion.pen_down[1:]
        far = drawn.copy()
        far[drawn] = measure_distances(self.nib[1:][drawn, :2], self.planned) > INK_COVER
        steps = np.linalg.norm(np.diff(self.nib[:, :2], axis=0), axis=1)
        return float(steps[far].sum())

    @property
    def greatest_force(self) -> float:
        """The greatest force on the paper [N]."""
        return float(self.force.max(initial=0.0))

    @property
    def findings(self) -> tuple[str, ...]:
        """What went wrong, in sentences with the cure; empty where nothing did."""
        stopped = (
            f"Stopped after {self.duration:.2f} s of {self.planned.duration:.2f} s; what was "
            "written until then is kept."
        )
        checks = (
            _describe_missing_ink,
            _describe_force,
            _describe_stray_ink,
            _describe_tired_joint,
        )
        found = [sentence for check in checks for sentence in check(self)]
        return (stopped, *found) if self.stopped else tuple(found)

    def __repr__(self) -> str:
        low, high = self.force_band
        ink = "no ink"
        if self.writing.any():
            ink = f"ink {1000 * self.shape_error:.2f} mm rms from the letter"
        kind = f"{self.motors} motors, {self.pen} pen"
        stopped = ", stopped" if self.stopped else ""
        return f"Run({self.duration:.2f} s, {kind}, {ink}, {low:.2f} to {high:.2f} N{stopped})"


def measure_distances(points: Array, planned: Motion) -> Array:
    """Return the distances of points of the page (K, 2) from the planned letter, (K,) [m]."""
    down = planned.pen_down
    letter = planned.page.to_page(planned.target)[:, :2]
    starts = np.flatnonzero(down[:-1] & down[1:])
    if not len(points) or not down.any():
        return np.full(len(points), np.nan)
    if not len(starts):
        return scipy.spatial.cKDTree(letter[down]).query(points)[0]
    a, b = letter[starts], letter[starts + 1]
    middles = scipy.spatial.cKDTree((a + b) / 2)
    nearest = middles.query(points, k=min(8, len(starts)))[1].reshape(len(points), -1)
    a, along = a[nearest], (b - a)[nearest]
    offset = points[:, None] - a
    part = np.clip((offset * along).sum(-1) / np.maximum((along**2).sum(-1), 1e-18), 0, 1)
    return np.linalg.norm(offset - part[..., None] * along, axis=-1).min(axis=1)


def _describe_missing_ink(run: Run) -> Iterator[str]:
    """Say where ink is missing, and how far the pen was from the paper there."""
    down = run.motion.pen_down
    gap = 1000 * np.maximum(run.nib[down, 2], 0.0)
    if down.any() and not run.writing.any():
        yield (
            f"No ink: the pen's tip stayed {gap.min():.1f} to {gap.max():.1f} mm over the paper. "
            f"{_PLAN_AGAIN}"
        )
    elif down.any() and (share := run.missing.mean()) >= _SPARE:
        where = describe_part(run.letter[: len(run.missing)], run.missing)
        over = gap[run.missing].max(initial=0.0)
        yield (
            f"{_percent(share)} of the letter has no ink, {where}: there the tip is up to "
            f"{over:.1f} mm over the paper. {_PLAN_AGAIN}"
        )


def _describe_force(run: Run) -> Iterator[str]:
    """Say where the pen was pressed too hard, and whether it survives."""
    hard = run.force[run.motion.pen_down] > FORCE_BAND[1]
    most = run.greatest_force
    if run.pen == "rigid" and most > BREAKING_FORCE:
        yield (
            f"The pen would break: it is pushed with {most:.0f} N, and {BREAKING_FORCE:.0f} N are "
            "enough to break one. A rigid pen cannot give way: use the pen with a spring."
        )
    elif hard.any() and hard.mean() >= _SPARE:
        where = describe_part(run.letter[: len(hard)], hard)
        cure = "Use the pen with a spring." if run.pen == "rigid" else _PLAN_AGAIN
        fate = f", and {BREAKING_FORCE:.0f} N would break the pen" if most > BREAKING_FORCE else ""
        yield (
            f"Pressed too hard, {where}: up to {most:.1f} N, where {FORCE_BAND[1]} N are "
            f"enough{fate}. {cure}"
        )


def _describe_stray_ink(run: Run) -> Iterator[str]:
    """Say how far the ink is beside the letter, and how much lies between the strokes."""
    if run.writing.any() and run.shape_error > _ASTRAY:
        yield (
            f"The ink is {1000 * run.shape_error:.1f} mm from the letter on average: the arm could "
            "not follow. Write more slowly: letter.write(duration=...)."
        )
    if run.ink_in_the_air > 0.0005:
        yield (
            f"{1000 * run.ink_in_the_air:.0f} mm of ink lie between the strokes, where the pen was "
            f"meant to be up. {_PLAN_AGAIN}"
        )


def _describe_tired_joint(run: Run) -> Iterator[str]:
    """Say which joint gave all it has, or had to give more, and not just for a moment."""
    share = (np.abs(run.effort) >= 0.999 * run.limits).mean(axis=0)
    if share.max(initial=0.0) >= _SPARE and run.greatest_force <= BREAKING_FORCE:
        worst = int(np.argmax(share))
        name = run.planned.joint_names[worst]
        limit = run.limits[worst]
        most = np.abs(run.effort[:, worst]).max()
        unit = "N" if name == "torso_lift_joint" else "N m"
        does = "needs up to" if most > 1.001 * limit else "gives all of"
        yield (
            f"{name} {does} {most:.0f} {unit} for {_percent(share[worst])} of the time; it has "
            f"{limit:.0f}. Write more slowly, or move the page nearer to the robot."
        )


def describe_part(letter: Array, chosen: BoolArray) -> str:
    """Say where on a letter (N, 2) the chosen points (N,) are: "at its top", "all over it"."""
    low, high = letter.min(axis=0), letter.max(axis=0)
    side = np.maximum(high - low, 1e-9)
    x, y = (letter[chosen].mean(axis=0) - (low + high) / 2) / side
    words = []
    if abs(y) > 0.15:
        words.append("at its top" if y > 0 else "at its bottom")
    if abs(x) > 0.15:
        words.append("on its right" if x > 0 else "on its left")
    if words:
        return " and ".join(words)
    return "all over it" if chosen.mean() > 0.5 else "in its middle"


def _percent(share: float) -> str:
    """Return a share in per cent, never rounded to nothing."""
    return f"{max(1, round(100 * share))} %"
