"""Whether the arm stays clear of the robot and of what the page lies on, at every sample of a motion.

At some samples all pairs of solids are looked at; between them a link moves by so much and no more, which settles most
pairs. What is left is looked at sample by sample.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np

from dmp_teach.robot.model.solids import Clearances, balls
from dmp_teach.robot.page import Page
from dmp_teach.robot.pen_path import RATE
from dmp_teach.trajectory import Array

LEAST = 0.010
"""The arm keeps this far from the robot and from what the page lies on [m]."""

THIN = 0.020
"""Less than this is worth a note [m]."""

AROUND = 0.2
"""What the page lies on is thought to go on for so far beyond it, on every side [m]."""

_EVERY = 12  # samples, of which one is looked at first

_WORDS = {
    "base_link": "base",
    "torso_fixed_link": "torso",
    "torso_lift_link": "torso",
    "head_pan_link": "head",
    "head_tilt_link": "head",
    "shoulder_pan_link": "shoulder",
    "shoulder_lift_link": "shoulder",
    "upperarm_roll_link": "upper arm",
    "elbow_flex_link": "elbow",
    "forearm_roll_link": "forearm",
    "wrist_flex_link": "wrist",
    "wrist_roll_link": "wrist",
    "gripper_link": "gripper",
    "r_gripper_finger_link": "right finger",
    "l_gripper_finger_link": "left finger",
    "pen_link": "pen",
    "pen_tip": "pen",
    "page": "what the page lies on",
}


@dataclass(frozen=True)
class Near:
    """A moment at which the arm comes near to something.

    Args:
        row: The sample.
        distance: How near, less than 0 where the two would overlap [m].
        link: The arm's part.
        other: A part of the robot, or "page" for what the page lies on.
    """

    row: int
    distance: float
    link: str
    other: str

    def __str__(self) -> str:
        """A sentence for those who must change something."""
        if self.distance < 0:
            return f"{self._when} would go into {self._what}, {-1000 * self.distance:.0f} mm deep."
        least = f"; {1000 * LEAST:.0f} mm must stay between them" if self.distance < LEAST else ""
        return (
            f"{self._when} would come within {1000 * self.distance:.0f} mm of {self._what}{least}."
        )

    @property
    def note(self) -> str:
        """The same where it may stay so."""
        return f"a{self._when[1:]} comes within {1000 * self.distance:.0f} mm of {self._what}"

    @property
    def _when(self) -> str:
        """The moment and the arm's part."""
        return f"After {self.row / RATE:.2f} s the arm's {plain(self.link)}"

    @property
    def _what(self) -> str:
        """What the part comes near to."""
        return plain(self.other) if self.other == "page" else f"the robot's {plain(self.other)}"


def plain(link: str) -> str:
    """What people call a link."""
    return _WORDS.get(link, link.removesuffix("_link").replace("_", " "))


def nearest(
    poses: Mapping[str, Array], page: Page, within: float = THIN
) -> tuple[Near | None, Near | None]:
    """The first moment at which something is nearer than `LEAST`, and the one at which something is nearest.

    Args:
        poses: X_world_link of every link, each of shape (T, 4, 4): see `Model.link_poses`.
        page: The sheet. Only the pen may come near to it.
        within: What is farther away than this does not count [m].

    Returns:
        Both None where nothing counts.
    """
    clearances = Clearances(page, AROUND)
    first = closest = None
    for number, rows, distances in _near(clearances, poses, within):
        link, other = clearances.pairs[number]
        row = int(distances.argmin())
        if closest is None or distances[row] < closest.distance:
            closest = Near(int(rows[row]), float(distances[row]), link, other)
        touching = np.flatnonzero(distances < LEAST)
        if len(touching) and (first is None or rows[touching[0]] < first.row):
            first = Near(int(rows[touching[0]]), float(distances[row]), link, other)
    return first, closest


def _near(
    clearances: Clearances, poses: Mapping[str, Array], within: float
) -> Iterator[tuple[int, Array, Array]]:
    """For each pair that comes within a distance: its number, at which samples, and how near (n,) [m]."""
    steps = len(next(iter(poses.values())))
    starts = np.arange(0, steps, _EVERY)
    looked = np.minimum(starts + _EVERY // 2, steps - 1)
    some = {link: X[looked] if X.strides[0] else X[: len(looked)] for link, X in poses.items()}
    centres, moves = _moves(poses, starts, looked)
    spared = np.column_stack(
        [moves[link] + moves.get(other, 0.0) for link, other in clearances.pairs]
    )
    doubtful = clearances.at_least(some, centres[looked]) - spared < within
    for number in np.flatnonzero(doubtful.any(axis=0)):
        pair = clearances.pairs[number]
        if pair[1] == "page" and pair[0].startswith("pen"):
            continue
        spans = np.flatnonzero(doubtful[:, number])
        away = clearances.apart(number, {link: some[link][spans] for link in some if link in pair})
        spans = spans[away - spared[spans, number] < within]
        rows = (starts[spans, None] + np.arange(_EVERY)).ravel()
        rows = rows[rows < steps]
        distances = clearances.apart(
            number, {link: poses[link][rows] for link in poses if link in pair}
        )
        if (distances < within).any():
            yield int(number), rows, distances


def _moves(
    poses: Mapping[str, Array], starts: Array, looked: Array
) -> tuple[Array, dict[str, Array]]:
    """The links' middles (T, L, 3), and how far a point of each is at most, in each span, from where it is looked at.

    A point at r from the middle goes no further than the middle, and r times the norm of the change of the turn.
    """
    centres, moves = [], {}
    beside = np.repeat(looked, np.diff(np.append(starts, len(next(iter(poses.values()))))))
    for link, middle, radius in zip(*balls(), strict=True):
        R = poses[link][:, :3, :3]
        centres.append(R @ middle + poses[link][:, :3, 3])
        gone, turned = centres[-1] - centres[-1][beside], R - R[beside]
        far = np.sqrt(np.einsum("ti,ti->t", gone, gone)) + radius * np.sqrt(
            np.einsum("tij,tij->t", turned, turned)
        )
        moves[link] = np.maximum.reduceat(far, starts)
    return np.stack(centres, axis=1), moves
