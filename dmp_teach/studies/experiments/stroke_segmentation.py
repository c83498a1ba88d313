"""Strokes by the rule of the local foot, beside the readings of the paper's rule."""

from __future__ import annotations

from concurrent.futures import Executor
from dataclasses import dataclass

import numpy as np

from dmp_teach.errors import RecordingError
from dmp_teach.ink import Recording
from dmp_teach.segmentation import RULES
from dmp_teach.studies.inputs import RecordingsLike, list_recordings
from dmp_teach.studies.parallel import Progress, run
from dmp_teach.studies.tables import Columns, Tabled
from dmp_teach.trajectory import Trajectory
from dmp_teach.values import Value

# An end is right if it is this near to the true one [s].
END_TOLERANCE = 0.05
STEADY_THRESHOLDS = (
    *((0.10, sigma) for sigma in (0.003, 0.006, 0.009, 0.012)),
    *((0.08, sigma) for sigma in (0.003, 0.006, 0.010)),
)
"""Settings of the local rule over which its count should not change: theta [m/s], sigma [m]."""


@dataclass(frozen=True)
class RuleResult:
    """How many strokes one rule finds, and whether that and every end is right, to 0.05 s.

    Where the number is right, `off` is how far the worst end is from the true one [m].
    """

    strokes: int
    right: bool
    off: float = float("inf")


@dataclass(frozen=True, eq=False, repr=False)
class SegmentationCase(Value):
    """One recording in which the pen was lifted.

    Args:
        name: Letter and writer.
        strokes: How many strokes it has.
        known: Whether they are known from the source or cut by hand; else the local rule is right.
        foot: By the rule of the local foot.
        meant: By the paper's rule with its second inequality turned round.
        authors: As the authors' program cuts it, with its fixed numbers.
        printed: By the paper's rule to the letter.
        steady: Whether the local rule gives the same count for all `STEADY_THRESHOLDS`.
    """

    name: str
    strokes: int
    known: bool
    foot: RuleResult
    meant: RuleResult
    authors: RuleResult
    printed: RuleResult
    steady: bool


@dataclass(frozen=True, eq=False, repr=False)
class Segmentation(Tabled):
    """The recordings of more than one stroke."""

    items: tuple[SegmentationCase, ...]

    @property
    def columns(self) -> Columns:
        """A row for each recording: strokes by each rule, and whether all ends are right."""
        found: dict[str, list[object]] = {
            "recording": [item.name for item in self.items],
            "strokes": [item.strokes for item in self.items],
            "source": ["known" if item.known else "local rule" for item in self.items],
        }
        for rule in RULES:
            results = [getattr(item, rule) for item in self.items]
            found[rule] = [each.strokes for each in results]
            found[f"{rule}: ends right"] = [each.right for each in results]
        return found | {"local rule steady": [item.steady for item in self.items]}


def compare_segmentation(
    recordings: RecordingsLike = None,
    *,
    executor: Executor | None = None,
    progress: Progress | None = None,
) -> Segmentation:
    """Compare the paper's rule for strokes (its equations 12 and 13) with the local one.

    A stroke ends, as printed, where dz/dt > theta; or z is far from the plane, where the paper
    prints |z - mu_z| < sigma and means the opposite. Both readings are tried, and the authors'
    program; `dmp_teach.segmentation.paper_rules` says how.

    Args:
        recordings: Recordings or files (strokes have no height and are left out); None takes our
            own alphabets.
        executor: As in `claims`; a piece of work is one recording.
        progress: As in `claims`.
    """
    given = [each for each in list_recordings(recordings) if isinstance(each, Recording)]
    found = run(_compare, given, executor, progress)
    return Segmentation(tuple(item for item in found if item is not None))


def _compare(recording: Recording) -> SegmentationCase | None:
    """Return one recording by every rule; None where the pen was never lifted."""
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


def _found(plain: Recording, rule: str, truth: tuple[Trajectory, ...]) -> RuleResult:
    """Return what a rule finds, judged by the true strokes."""
    try:
        strokes = plain.strokes(rule=rule)
    except RecordingError:
        return RuleResult(0, False)
    if len(strokes) != len(truth):
        return RuleResult(len(strokes), False)
    ends = [
        (s.t[0] - other.t[0], s.t[-1] - other.t[-1])
        for s, other in zip(strokes, truth, strict=True)
    ]
    off = [
        float(np.linalg.norm(s.position[end] - other.position[end]))
        for s, other in zip(strokes, truth, strict=True)
        for end in (0, -1)
    ]
    return RuleResult(len(strokes), bool(np.abs(ends).max() <= END_TOLERANCE), max(off))


def _steady(plain: Recording, count: int) -> bool:
    """Return whether the local rule gives this count for all thresholds."""
    try:
        return all(len(plain.strokes(*each)) == count for each in STEADY_THRESHOLDS)
    except RecordingError:
        return False
