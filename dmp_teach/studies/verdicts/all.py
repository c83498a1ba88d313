"""The paper's claims in the order of its pages, a row each."""

from __future__ import annotations

from concurrent.futures import Executor

from dmp_teach.studies.inputs import RecordingsLike
from dmp_teach.studies.parallel import Progress, run
from dmp_teach.studies.verdicts import goals, kernels, letters
from dmp_teach.studies.verdicts.claim import Claims
from dmp_teach.studies.verdicts.evidence import Evidence, evidence_of

ALL_CLAIMS = (
    kernels.narrow_kernels,
    kernels.best_width,
    kernels.wide_kernels,
    kernels.truncation,
    kernels.gaps_between_kernels,
    kernels.four_widths_on_a,
    kernels.number_of_kernels,
    letters.accuracy_and_efficiency,
    goals.goal_on_start,
    goals.huge_accelerations,
    goals.decay_term,
    goals.goal_changes,
    letters.strokes_from_height,
    letters.redrawn_letters,
    letters.d_becomes_p,
    letters.writing_style,
    letters.any_ink,
)


def claims(
    recordings: RecordingsLike | Evidence = None,
    *,
    executor: Executor | None = None,
    progress: Progress | None = None,
) -> Claims:
    """Compute every claim of the paper with its verdict, from recordings.

    Each row has `.name`, `.claim`, `.verdict` ("HOLDS", "DOES NOT HOLD" or "DEPENDS ON"), `.figure`
    (the numbers, as a sentence), `.depends_on` and `.call`, the line that computes the figure
    again. The thresholds of a verdict stand in the docstring of the function that the call names.

    Args:
        recordings: Recordings, files or strokes, or `Evidence`; None takes our own alphabets.
        executor: Any `concurrent.futures.Executor`; the studies send it one stroke at a time.
        progress: Called as `progress(done, total)` after each claim, such as
            `teach.progress_bar("claims")`.

    Raises:
        RecordingError: Something that no letter can be read from.
    """
    evidence = evidence_of(recordings, executor)
    return Claims(tuple(run(lambda claim: claim(evidence), ALL_CLAIMS, progress=progress)))
