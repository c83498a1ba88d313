"""The paper's figures by their own numbers, from anybody's recordings, in one call each."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from matplotlib.figure import Figure

from dmp_teach import studies
from dmp_teach.errors import SettingError
from dmp_teach.ink import Recording, recording_of
from dmp_teach.letters import Letter
from dmp_teach.robot import Fetch, Page
from dmp_teach.views import figures


def figure(
    number: int, recordings: studies.RecordingsLike = None, *, labels: str | None = None
) -> Figure:
    """Draw one of the paper's figures again, by its own number.

    1 the robot writing an a, in frames; 2 the kinds of kernel; 3 the pipeline, ours; 4 error
    against kernel width; 5 four widths on an a; 6 error against the number of kernels; 7 a goal
    that moves by 0.01 m, one coordinate over time; 8 one that moves by 0.1 m to where the original
    form mirrors the letter, on paper; 9 a, b, e and m drawn again; 10 a D that becomes a P. Figures
    4 and 6 have the paper's Euclidean error beside the root mean square.

    Args:
        number: 1 to 10.
        recordings: Recordings, files, folders or strokes; None takes our own alphabets. Where no a
            was recorded, figures of one letter take the first that was; ours are in figure 3 where
            only strokes are given, and in figure 10 where nobody wrote a D of bar and bowl.
        labels: How letters and writers are read off the names of files, as in `claims`.

    Raises:
        SettingError: No such figure.
        RecordingError: Something that no letter can be read from, or a stroke that is not 2-D.
        MissingPartError: For figure 1, pybullet is not installed.
    """
    if type(number) is not int or number not in FIGURES:
        raise SettingError(
            f"number is {number!r}, but the paper's figures are 1 to {len(FIGURES)}."
        )
    given = studies.list_recordings(recordings, labels)
    studies.list_letters_on_page(given)
    return FIGURES[number](given)


def _robot(given: Sequence) -> Figure:
    letter = Letter.learn(_letter(given).strokes)
    return figures.draw_writing(Fetch().write(letter.write(), Page.table()))


def _pipeline(given: Sequence) -> Figure:
    captured = [each for each in given if isinstance(each, Recording)]
    of_a = [each for each in captured if each.character == "a"]
    recording = next(iter(of_a or captured), recording_of("a"))
    letter = Letter.learn(recording)
    return figures.draw_pipeline(recording, letter, Fetch().write(letter.write(), Page.table()))


def _moved_goal(given: Sequence) -> Figure:
    letter = _letter(given)
    name = f"{letter.character}, x"
    return figures.draw_goal_change_over_time(
        studies.trace_goal_change(letter.strokes[0], name=name)
    )


def _mirrored_letter(given: Sequence) -> Figure:
    """Draw the goal to the side on which the original form mirrors the letter, where one is."""
    letter = _letter(given)
    shifts = 0.1 * np.array([[1, 0], [-1, 0], [0, 1], [0, -1]])
    paths = [
        studies.draw_goal_change(letter.strokes[0], tuple(s), letter.character) for s in shifts
    ]

    def mirrors(path: studies.GoalPaths) -> bool:
        return "original" in path.paths and bool(path.factor.min() < 0)

    return figures.draw_goal_paths(next(filter(mirrors, paths), paths[0]))


def _letter(given: Sequence) -> studies.Written:
    """Return the first a, or the first letter where there is none."""
    letters = studies.list_letters(given)
    return next((each for each in letters if each.character == "a"), letters[0])


FIGURES: dict[int, Callable[[Sequence], Figure]] = {
    1: _robot,
    2: lambda _: figures.draw_kernel_types(),
    3: _pipeline,
    4: lambda given: figures.draw_error_over_width(studies.sweep_kernel_width(given)),
    5: lambda given: figures.draw_four_widths(studies.redraw_at_widths(given)),
    6: lambda given: figures.draw_error_over_number(studies.sweep_kernel_number(given)),
    7: _moved_goal,
    8: _mirrored_letter,
    9: lambda given: figures.draw_redrawn_letters(studies.redraw_letters(given)),
    10: lambda given: figures.draw_d_to_p(studies.make_p_from_d(given)),
}
