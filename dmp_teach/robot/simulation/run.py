"""What happened when a motion met the paper: joints, ink and force, and how far that is from what was planned."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.spatial import cKDTree

from dmp_teach.robot.motion import Motion
from dmp_teach.robot.page import Page
from dmp_teach.robot.simulation.findings import findings
from dmp_teach.trajectory import Array, Trajectory, locked

INKED = 0.002
"""Ink this near to a place of the letter covers it [m]."""


@dataclass(frozen=True, eq=False)
class Run:
    """A motion as physics let it happen.

    Args:
        motion: As it happened: `q` holds the joints where they were (with `pen_slide_joint` last, for a sprung pen),
            `tip` where the pen's tip was, `page` where the sheet really lay; `target`, `pen_down` and `strokes` are
            the plan's.
        planned: The motion that was asked for.
        ink: The strokes on the page, one for each time that the nib touched the paper, with the times at which it
            was there (page frame, origin at its centre) [s], [m].
        nib: The place of the ball at the tip that is nearest to the paper, in the page's frame, shape (T, 3) [m].
        force: With which the nib pressed on the paper during the step before each sample, shape (T,) [N].
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
    contact: Array
    effort: Array
    limits: Array
    pen: str = "sprung"
    motors: str = "ideal"
    stopped: bool = False

    def __post_init__(self) -> None:
        """Lock every array and tuple."""
        object.__setattr__(self, "ink", tuple(self.ink))
        object.__setattr__(self, "contact", locked(self.contact, dtype=bool))
        for name in ("nib", "force", "effort", "limits"):
            object.__setattr__(self, name, locked(getattr(self, name)))

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
        """Where ink was meant to be, at every sample with the pen down, on the page, shape (N, 2) [m]."""
        return self.planned.page.to_page(self.planned.target[self.planned.pen_down])[:, :2]

    @property
    def writing(self) -> Array:
        """True where the pen was meant to write and did, shape (T,)."""
        return self.contact & self.motion.pen_down

    @cached_property
    def offsets(self) -> Array:
        """How far each sample with `writing` is from where the pen was meant to be just then, shape (K,) [m]."""
        meant = self.planned.page.to_page(self.motion.target[self.writing])[:, :2]
        return np.linalg.norm(self.nib[self.writing, :2] - meant, axis=1)

    @cached_property
    def distances(self) -> Array:
        """How far each sample with `writing` is from the nearest place of the planned letter, shape (K,) [m]."""
        return distances(self.nib[self.writing, :2], self.planned)

    @property
    def time_error(self) -> float:
        """Root mean square of `offsets` [m]; nan where there is no ink."""
        return _rms(self.offsets)

    @property
    def shape_error(self) -> float:
        """Root mean square of `distances` [m]; nan where there is no ink."""
        return _rms(self.distances)

    @property
    def force_band(self) -> tuple[float, float]:
        """Between which forces the pen pressed for nine tenths of the writing: 5 and 95 % [N]."""
        pressed = self.force[self.motion.pen_down]
        low, high = np.percentile(pressed, [5, 95]) if len(pressed) else (0.0, 0.0)
        return float(low), float(high)

    @property
    def contact_fraction(self) -> float:
        """Which part of the time in which the pen was meant to write it did, 0 to 1."""
        down = self.motion.pen_down
        return float(self.contact[down].mean()) if down.any() else 0.0

    @cached_property
    def missing(self) -> Array:
        """True at each place of `letter` that was to be written by now and has no ink within 2 mm, shape (N,)."""
        places = self.letter[: int(self.motion.pen_down.sum())]
        if not self.writing.any():
            return np.ones(len(places), bool)
        return cKDTree(self.nib[self.writing, :2]).query(places)[0] > INKED

    @cached_property
    def ink_in_the_air(self) -> float:
        """How much ink is where none was meant to be: drawn with the pen up, over 2 mm from the letter [m]."""
        drawn = self.contact[1:] & self.contact[:-1] & ~self.motion.pen_down[1:]
        far = drawn.copy()
        far[drawn] = distances(self.nib[1:][drawn, :2], self.planned) > INKED
        steps = np.linalg.norm(np.diff(self.nib[:, :2], axis=0), axis=1)
        return float(steps[far].sum())

    @property
    def greatest_force(self) -> float:
        """The greatest force on the paper [N]."""
        return float(self.force.max(initial=0.0))

    @property
    def findings(self) -> tuple[str, ...]:
        """What went wrong, in sentences with the cure; empty where nothing did."""
        return findings(self)

    def __repr__(self) -> str:
        """In one line, without the numbers."""
        low, high = self.force_band
        ink = (
            f"ink {1000 * self.shape_error:.2f} mm rms from the letter, "
            if self.writing.any()
            else "no ink, "
        )
        stopped = ", stopped" if self.stopped else ""
        return f"Run({self.duration:.2f} s, {self.motors} motors, {self.pen} pen, {ink}{low:.2f} to {high:.2f} N{stopped})"


def distances(points: Array, planned: Motion) -> Array:
    """How far points of the page (K, 2) are from the nearest place of the planned letter, shape (K,) [m].

    The letter is a chain of straight pieces from sample to sample; of these, those near the point are tried.
    """
    down = planned.pen_down
    letter = planned.page.to_page(planned.target)[:, :2]
    starts = np.flatnonzero(down[:-1] & down[1:])
    if not len(points) or not down.any():
        return np.full(len(points), np.nan)
    if not len(starts):
        return cKDTree(letter[down]).query(points)[0]
    a, b = letter[starts], letter[starts + 1]
    nearest = cKDTree((a + b) / 2).query(points, k=min(8, len(starts)))[1].reshape(len(points), -1)
    a, along = a[nearest], (b - a)[nearest]
    offset = points[:, None] - a
    part = np.clip((offset * along).sum(-1) / np.maximum((along**2).sum(-1), 1e-18), 0, 1)
    return np.linalg.norm(offset - part[..., None] * along, axis=-1).min(axis=1)


def _rms(values: Array) -> float:
    """Root mean square; nan of nothing."""
    return float(np.sqrt(np.mean(values**2))) if len(values) else float("nan")
