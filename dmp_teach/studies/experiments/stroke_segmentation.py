"""Strokes found by the rule of the local foot, beside the two readings of the paper's rule."""

from __future__ import annotations

from concurrent.futures import Executor
from dataclasses import dataclass
from typing import Any

import numpy as np

from dmp_teach.errors import RecordingError
from dmp_teach.ink import Recording
from dmp_teach.segmentation import RULES
from dmp_teach.studies.inputs import recordings_of
from dmp_teach.studies.parallel import Progress, run
from dmp_teach.studies.tables import Rows, Tabled
from dmp_teach.trajectory import Trajectory

NEAR = 0.05  # an end is right if it is this near to the true one [s]
PATIENT = tuple((0.10, s) for s in (0.003, 0.006, 0.009, 0.012)) + tuple(
    (0.08, s) for s in (0.003, 0.006, 0.010)
)
"""Settings of the local rule over which its count should not change: theta [m/s], sigma [m]."""


@dataclass(frozen=True)
class Found:
    """What one rule says of one recording.

    Args:
        strokes: How many strokes it finds.
        right: Whether that count and every end is right, to 0.05 s.
    """

    strokes: int
    right: bool


@dataclass(frozen=True)
class SegmentationCase:
    """One recording of which somebody lifted the pen.

    Args:
        name: Letter and writer.
        strokes: How many strokes it has.
        known: Whether the strokes are known from the source or cut by hand; else they are those of the local rule,
            which is then right by definition.
        foot: What the rule of the local foot finds.
        authors: What the paper's rule finds with its second inequality turned round.
        printed: What it finds to the letter.
        steady: Whether the local rule gives the same count for every theta and sigma of `PATIENT`.
    """

    name: str
    strokes: int
    known: bool
    foot: Found
    authors: Found
    printed: Found
    steady: bool


@dataclass(frozen=True, eq=False)
class Segmentation(Tabled):
    """The recordings of more than one stroke."""

    items: tuple[SegmentationCase, ...]

    def rows(self) -> Rows:
        """One for each recording: strokes by each rule, and whether all of its ends are right."""
        return tuple(
            {
                "recording": item.name,
                "strokes": item.strokes,
                "source": "known" if item.known else "local rule",
                **{
                    column: value
                    for name in RULES
                    for column, value in (
                        (name, getattr(item, name).strokes),
                        (f"{name}: ends right", getattr(item, name).right),
                    )
                },
                "local rule steady": item.steady,
            }
            for item in self.items
        )


def compare_segmentation(
    recordings: Any = None, *, executor: Executor | None = None, progress: Progress | None = None
) -> Segmentation:
    """The paper's rule for strokes (its equations 12 and 13) on every recording with a lift, beside the local one.

    A stroke ends, as printed, where dz/dt > theta; or z is far from the plane, where the paper prints |z - mu_z| <
    sigma and means the opposite. Both readings are tried, `dmp_teach.segmentation.paper_rules` says how.

    Args:
        recordings: Recordings or files (strokes have no height and are left out); None takes our own alphabets.
        executor: Any `concurrent.futures.Executor`; a piece of work is one recording.
        progress: Called as `progress(done, total)`.
    """
    given = [each for each in recordings_of(recordings) if isinstance(each, Recording)]
    found = run(_compared, given, executor, progress)
    return Segmentation(tuple(item for item in found if item is not None))


def _compared(recording: Recording) -> SegmentationCase | None:
    """One recording; None where the pen was never lifted."""
    truth = recording.strokes()
    flat = bool(np.ptp(recording.position[:, 2]) < 1e-9)
    if len(truth) < 2 or flat:
        return None
    name = f"{recording.character or '?'} {recording.writer or '?'}"
    plain = recording.with_strokes(None)
    found = {rule: _found(plain, rule, truth) for rule in RULES}
    return SegmentationCase(
        name,
        len(truth),
        recording.given_strokes is not None,
        **found,
        steady=_steady(plain, len(truth)),
    )


def _found(plain: Recording, rule: str, truth: tuple[Trajectory, ...]) -> Found:
    """What a rule says, judged by the true strokes."""
    try:
        strokes = plain.strokes(rule=rule)
    except RecordingError:
        return Found(0, False)
    if len(strokes) != len(truth):
        return Found(len(strokes), False)
    ends = [
        (s.t[0] - other.t[0], s.t[-1] - other.t[-1])
        for s, other in zip(strokes, truth, strict=True)
    ]
    return Found(len(strokes), bool(np.abs(ends).max() <= NEAR))


def _steady(plain: Recording, count: int) -> bool:
    """Whether the local rule gives this count everywhere."""
    try:
        return all(len(plain.strokes(theta, sigma)) == count for theta, sigma in PATIENT)
    except RecordingError:
        return False
