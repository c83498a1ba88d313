"""Strokes found as the paper prints it, beside the rule of the local foot."""

from concurrent.futures import Executor
from dataclasses import dataclass
from typing import Any

import numpy as np

from dmp_teach.errors import RecordingError
from dmp_teach.ink.recording import Recording
from dmp_teach.ink.strokes import runs
from dmp_teach.studies.material import recordings_of
from dmp_teach.studies.tables import Rows, Tabled
from dmp_teach.studies.work import Progress, run
from dmp_teach.trajectory import Array

THETA, SIGMA = 0.10, 0.006
NEAR = 0.05  # an end is right if it is this near to the true one [s]
PATIENT = tuple((0.10, s) for s in (0.003, 0.006, 0.009, 0.012)) + tuple((0.08, s) for s in (0.003, 0.006, 0.010))
"""Settings of the local rule over which its count should not change: theta [m/s], sigma [m]."""


@dataclass(frozen=True)
class Lifts:
    """One recording of which somebody lifted the pen.

    Args:
        name: Letter and writer.
        strokes: How many strokes it has.
        known: Whether the strokes are known from the source; else they are those of the local rule.
        printed: How many the printed rule finds, the inequality turned round so that it can find any.
        right: Whether the printed rule gets the count and every end right, to 0.05 s.
        literal: Whether it does with the inequality as printed, |z - mu_z| < sigma.
        steady: Whether the local rule gives the same count for every theta and sigma of `PATIENT`.
    """

    name: str
    strokes: int
    known: bool
    printed: int
    right: bool
    literal: bool
    steady: bool


@dataclass(frozen=True, eq=False)
class Segmentation(Tabled):
    """The recordings of more than one stroke."""

    items: tuple[Lifts, ...]

    def rows(self) -> Rows:
        """One for each recording."""
        return tuple(
            {
                "recording": item.name,
                "strokes": item.strokes,
                "as printed": item.printed,
                "ends right": item.right,
                "literally": item.literal,
                "local rule steady": item.steady,
            }
            for item in self.items
        )


def segmentation(
    recordings: Any = None, *, executor: Executor | None = None, progress: Progress | None = None
) -> Segmentation:
    """The paper's rule for strokes (its equations 12 and 13) on every recording with a lift, beside the local one.

    A stroke ends, as printed, where dz/dt > theta; or z is far from the plane, where the paper prints |z - mu_z| <
    sigma with the mean height mu_z of the whole recording and means the opposite. Both readings are tried.

    Args:
        recordings: Recordings or files (strokes have no height and are left out); None takes our own alphabets.
        executor: Any `concurrent.futures.Executor`; a piece of work is one recording.
        progress: Called as `progress(done, total)`.
    """
    given = [each for each in recordings_of(recordings) if isinstance(each, Recording)]
    found = run(_compared, given, executor, progress)
    return Segmentation(tuple(item for item in found if item is not None))


def printed_strokes(recording: Recording, literal: bool = False) -> tuple[tuple[int, int], ...]:
    """Runs of samples that the printed rule takes for strokes.

    Args:
        recording: With a height.
        literal: The inequality as printed.

    Returns:
        Pairs (start, end) of samples, end not included; runs of one sample are left out.
    """
    z = recording.position[:, 2]
    rising = np.gradient(z, recording.t) > THETA
    off = np.abs(z - z.mean())
    lifted = rising & (off < SIGMA) if literal else rising | (off > SIGMA)
    return tuple((a, b) for a, b in runs(~lifted) if b - a >= 2)


def _compared(recording: Recording) -> Lifts | None:
    """One recording; None where the pen was never lifted."""
    truth = recording.strokes()
    flat = bool(np.ptp(recording.position[:, 2]) < 1e-9)
    if len(truth) < 2 or flat:
        return None
    name = f"{recording.character or '?'} {recording.writer or '?'}"
    printed = printed_strokes(recording)
    right = _agrees(recording.t, printed, truth)
    literal = _agrees(recording.t, printed_strokes(recording, literal=True), truth)
    known = recording.given_strokes is not None
    return Lifts(name, len(truth), known, len(printed), right, literal, _steady(recording, len(truth)))


def _agrees(t: Array, spans: tuple[tuple[int, int], ...], truth: tuple) -> bool:
    """Whether the count and all ends are right."""
    if len(spans) != len(truth):
        return False
    ends = [(t[a] - s.t[0], t[b - 1] - s.t[-1]) for (a, b), s in zip(spans, truth, strict=True)]
    return bool(np.abs(ends).max() <= NEAR)


def _steady(recording: Recording, count: int) -> bool:
    """Whether the local rule gives this count everywhere."""
    plain = Recording(recording.t, recording.position)
    try:
        return all(len(plain.strokes(theta, sigma)) == count for theta, sigma in PATIENT)
    except RecordingError:
        return False
