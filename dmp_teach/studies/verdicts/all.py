"""The paper's claims in the order of its pages, a row each."""

from __future__ import annotations

from concurrent.futures import Executor

from dmp_teach.arguments import checked
from dmp_teach.studies.inputs import RecordingsLike
from dmp_teach.studies.parallel import Progress, run
from dmp_teach.studies.readings import READINGS, Reading
from dmp_teach.studies.verdicts import accuracy, goals, kernels, letters
from dmp_teach.studies.verdicts.claim import Claims
from dmp_teach.studies.verdicts.evidence import Evidence, evidence_of

ALL_CLAIMS = (
    kernels.narrow_kernels,
    kernels.best_width,
    kernels.wide_kernels,
    kernels.truncation,
    kernels.gaps_between_kernels,
    kernels.four_widths_on_a,
    kernels.fewer_kernels,
    kernels.number_of_kernels,
    accuracy.linear_decay,
    accuracy.accuracy_and_efficiency,
    accuracy.state_of_the_art,
    goals.goal_on_start,
    goals.huge_accelerations,
    goals.decay_term,
    goals.goal_changes,
    letters.strokes_from_height,
    letters.redrawn_letters,
    letters.d_becomes_p,
    letters.writing_style,
    letters.any_ink,
    letters.any_scale,
)


@checked
def claims(
    recordings: RecordingsLike | Evidence = None,
    *,
    labels: str | None = None,
    readings: tuple[Reading, ...] = READINGS,
    executor: Executor | None = None,
    progress: Progress | None = None,
) -> Claims:
    r"""Compute every claim of the paper with its verdict, from recordings.

    Each row has `.name`, `.claim`, `.verdict` ("HOLDS", "DOES NOT HOLD" or "DEPENDS ON"), `.figure`
    (the numbers, as a sentence), `.depends_on`, `.n` (of how many), `.warning` (letters that were
    not recorded, and what was taken instead) and `.call`, the line that computes the figure again.
    Claims about DMP* have a verdict `.by_reading` of the paper, too, and HOLD if they do by all.
    The thresholds of a verdict stand in the docstring of the function that the call names.

        teach.claims("recordings", labels=r"(?P<character>\w)_(?P<writer>\w+)")

    Args:
        recordings: Recordings, files, folders of them or strokes, or `Evidence`; None takes our own
            alphabets.
        labels: A pattern (regular expression) that finds letter and writer in a file's name, by a
            group `character`, a group `writer`, or both; of a folder it takes the files that match.
            Names of people become "writer-1" and so on.
        readings: By which claims about DMP* are judged: ours, the text mended, the authors'
            program, and as printed, unless given.
        executor: Any `concurrent.futures.Executor`; the studies send it one stroke at a time.
        progress: Called as `progress(done, total)` after each claim; it may raise to stop. None
            draws a bar after a second.

    Raises:
        RecordingError: Something that no letter can be read from, or a stroke that is not 2-D.
        SettingError: Readings that are none.
    """
    evidence = evidence_of(recordings, executor, labels, readings)
    judged = run(lambda claim: claim(evidence), ALL_CLAIMS, progress=progress, words="claims")
    return Claims(tuple(judged))
