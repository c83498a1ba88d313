"""Letters drawn again: as they were shown, and with four kernel widths."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from concurrent.futures import Executor
from contextlib import suppress
from dataclasses import dataclass, replace

import numpy as np

from dmp_teach.arguments import checked
from dmp_teach.dmp import DMP, Settings, as_settings, named_settings
from dmp_teach.errors import SettingError
from dmp_teach.letters import rms_distance
from dmp_teach.studies.inputs import RecordingsLike, Written, list_letters
from dmp_teach.studies.parallel import Progress, run
from dmp_teach.studies.tables import Columns, Tabled
from dmp_teach.trajectory import Array, Trajectory
from dmp_teach.values import Value

FIGURE_5_WIDTHS = (1.0, 10.0, np.inf, 2 / 3)
"""The kernel widths of the paper's figure 5 [1/N], best first as the paper gives their errors."""


@dataclass(frozen=True, eq=False, repr=False)
class Redrawn(Value):
    """One letter as it was shown, and as it was drawn.

    Args:
        letter: As it was shown.
        drawn: Its strokes as they were drawn, or None where the settings refused it.
        settings: Words for how it was drawn.
    """

    letter: Written
    drawn: tuple[Trajectory, ...] | None
    settings: str

    @property
    def error(self) -> float:
        """The rms distance at equal times [m]; infinite where there is no drawing."""
        return np.inf if self.drawn is None else rms_distance(self.letter.strokes, self.drawn)

    @property
    def euclidean(self) -> float:
        """The paper's Euclidean error, the sum of the distances of all samples [m]."""
        return sum(float(distances.sum()) for distances in self._distances())

    @property
    def largest(self) -> float:
        """The largest distance at equal times [m]; infinite where there is no drawing."""
        return max(float(distances.max()) for distances in self._distances())

    def _distances(self) -> list[Array]:
        """Return the distance of every sample, by stroke [m]."""
        if self.drawn is None:
            return [np.array([np.inf])]
        pairs = zip(self.letter.strokes, self.drawn, strict=True)
        return [np.linalg.norm(p.position - q.position, axis=1) for p, q in pairs]


@dataclass(frozen=True, eq=False, repr=False)
class Redrawings(Tabled):
    """Letters as they were drawn."""

    items: tuple[Redrawn, ...]

    @property
    def columns(self) -> Columns:
        """A row for each letter."""
        return {
            "letter": [item.letter.name for item in self.items],
            "drawn with": [item.settings for item in self.items],
            "size [mm]": [1e3 * item.letter.size for item in self.items],
            "rms [mm]": [1e3 * item.error for item in self.items],
            "largest [mm]": [1e3 * item.largest for item in self.items],
            "sum of distances [m]": [item.euclidean for item in self.items],
            "rms [% of size]": [100 * item.error / item.letter.size for item in self.items],
        }


@checked
def redraw_letters(
    recordings: RecordingsLike = None,
    letters: str = "abem",
    settings: Settings | Mapping[str, Settings] | None = None,
    *,
    executor: Executor | None = None,
    progress: Progress | None = None,
) -> Redrawings:
    """Draw these letters again to their own goals (the paper's figure 9).

    Args:
        recordings: Recordings, files or strokes; None takes our own alphabets.
        letters: Which letters to draw; where none of them was recorded, all that were.
        settings: How, one or several by name; `Settings.star()` unless given.
        executor: As in `claims`; a piece of work is one letter.
        progress: As in `claims`.
    """
    own = settings if isinstance(settings, Mapping) else {"DMP*": as_settings(settings)}
    named = named_settings(own, {})
    given = list_letters(recordings)
    wanted = [letter for letter in given if letter.character in letters] or given
    found = run(_redraw, [(letter, tuple(named.items())) for letter in wanted], executor, progress)
    return Redrawings(tuple(item for items in found for item in items))


@checked
def redraw_at_widths(
    recordings: RecordingsLike = None,
    letters: str = "a",
    widths: Sequence[float] = FIGURE_5_WIDTHS,
    settings: Settings | None = None,
    *,
    executor: Executor | None = None,
    progress: Progress | None = None,
) -> Redrawings:
    """Draw a letter with four kernel widths (the paper's figure 5).

    Args:
        recordings: Recordings, files or strokes; None takes our own alphabets.
        letters: Which letters; where none of them was recorded, all that were.
        widths: Kernel widths [1/N].
        settings: All but the width; DMP* with Gaussians of sigma 4/N and N = 12 a second unless
            given.
        executor: As in `claims`; a piece is one letter, all widths.
        progress: As in `claims`.
    """
    base = as_settings(settings, lambda: Settings.star(kernel_sigma=4.0, sharpen=False))
    named = {width_name(width): replace(base, kernel_width=float(width)) for width in widths}
    return redraw_letters(recordings, letters, named, executor=executor, progress=progress)


def width_name(width: float) -> str:
    """Return a name such as "1/N", "2/3N" or "full Gaussian"."""
    if np.isinf(width):
        return "full Gaussian"
    return "2/3N" if np.isclose(width, 2 / 3) else f"{width:g}/N"


def _redraw(piece: tuple[Written, tuple[tuple[str, Settings], ...]]) -> list[Redrawn]:
    """Return one letter with all settings."""
    letter, named = piece
    found = []
    for name, settings in named:
        strokes: tuple[Trajectory, ...] | None = None
        with suppress(SettingError):
            strokes = tuple(DMP.imitate(stroke, settings).rollout() for stroke in letter.strokes)
        found.append(Redrawn(letter, strokes, name))
    return found
