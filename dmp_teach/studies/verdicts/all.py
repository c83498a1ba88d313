"""The paper's claims in the order of its pages, a row each."""

from __future__ import annotations

from concurrent.futures import Executor
from typing import Any

from dmp_teach.studies.parallel import Progress, run
from dmp_teach.studies.verdicts import kernels as on_kernels
from dmp_teach.studies.verdicts import letters as on_letters
from dmp_teach.studies.verdicts.claim import Claims
from dmp_teach.studies.verdicts.evidence import evidence_of

ALL = (
    on_kernels.narrow_kernels,
    on_kernels.best_width,
    on_kernels.wide_kernels,
    on_kernels.truncation,
    on_kernels.gaps_between_kernels,
    on_kernels.four_widths_on_a,
    on_kernels.number_of_kernels,
    on_letters.accuracy_and_efficiency,
    on_letters.goal_on_start,
    on_letters.huge_accelerations,
    on_letters.decay_term,
    on_letters.goal_changes,
    on_letters.strokes_from_height,
    on_letters.redrawn_letters,
    on_letters.d_becomes_p,
    on_letters.writing_style,
    on_letters.any_ink,
)


def claims(
    recordings: Any = None, *, executor: Executor | None = None, progress: Progress | None = None
) -> Claims:
    """Every claim of the paper with its verdict, computed from recordings.

    Each row has `.name`, `.claim`, `.verdict` ("HOLDS", "DOES NOT HOLD" or "DEPENDS ON"), `.figure` (the numbers, as a
    sentence), `.depends_on` and `.call`, the line that computes the figure again. The thresholds of a verdict stand in
    the docstring of the function that the call names.

    Args:
        recordings: Recordings, files or strokes, or `Evidence`; None takes our own alphabets.
        executor: Any `concurrent.futures.Executor`; the studies send it one stroke at a time.
        progress: Called as `progress(done, total)` after each claim, such as `teach.progress_bar("claims")`.

    Raises:
        RecordingError: Something that no letter can be read from.
    """
    evidence = evidence_of(recordings, executor)
    return Claims(tuple(run(lambda claim: claim(evidence), ALL, progress=progress)))
