"""A D that becomes a P by another goal of its bowl (the paper's figure 10)."""

from __future__ import annotations

from collections.abc import Mapping
from concurrent.futures import Executor
from contextlib import suppress
from dataclasses import dataclass, replace

import numpy as np

from dmp_teach.arguments import checked
from dmp_teach.dmp import Settings, named_settings
from dmp_teach.errors import SettingError
from dmp_teach.letters import Letter, cut_at_corners, find_bar_and_bowl
from dmp_teach.studies.inputs import RecordingsLike, Written, list_letters, own_recordings
from dmp_teach.studies.parallel import Progress, run
from dmp_teach.studies.tables import Columns, Tabled
from dmp_teach.trajectory import Array, Trajectory, rms
from dmp_teach.values import Value

# What makes a P, in parts of the bar: the bowl ends near the middle of the bar, leaves a leg free
# below it, and is nowhere farther from the bar; and most of it is on its side of the bar.
BOWL_END_DISTANCE = 0.05
FREE_LEG = 0.2
BOWL_SIDE_SHARE = 0.8
WIDEST_BOWL = 1.5


@dataclass(frozen=True, eq=False, repr=False)
class MadeLetter(Value):
    """A P, made from somebody's D.

    Args:
        source: The D.
        made_with: Words for the transformation.
        bar: The number of the stroke that is the bar, counted from 0.
        bowl: The number of the stroke that is the bowl.
        target: The new lower end of the bowl: the middle of the bar, shape (2,) [m].
        strokes: The P, or None where the settings refused it.
    """

    source: Written
    made_with: str
    bar: int
    bowl: int
    target: Array
    strokes: tuple[Trajectory, ...] | None

    @property
    def overshoot(self) -> float:
        """How far the bowl dips under its own end [m]; infinite where there is no drawing."""
        if self.strokes is None:
            return np.inf
        lowest = self.strokes[self.bowl].position[:, 1].min()
        return max(0.0, float(self.target[1] - lowest))

    @property
    def recognisable(self) -> bool:
        """Whether it is joined at the bar, with a free leg and the bowl on its side."""
        if self.strokes is None:
            return False
        drawn = self.strokes[self.bowl].position
        foot, top = _ends(self.source.strokes[self.bar])
        height = float(np.linalg.norm(top - foot))
        along = (top - foot) / height
        place, off = _from_bar(drawn, foot, along)
        _, shown = _from_bar(self.source.strokes[self.bowl].position, foot, along)
        side = np.sign(np.median(shown))
        ends = np.linalg.norm(drawn[[0, -1]] - self.target, axis=1).min()
        return bool(
            ends <= BOWL_END_DISTANCE * height
            and place.min() >= FREE_LEG * height
            and np.mean(side * off > -0.02 * height) >= BOWL_SIDE_SHARE
            and np.abs(off).max() <= WIDEST_BOWL * height
        )

    @property
    def ideal(self) -> tuple[Trajectory, ...]:
        """The D's own strokes, the bowl turned and scaled to the new ends: a P without shear."""
        bowl, foot = self.source.strokes[self.bowl], _ends(self.source.strokes[self.bar])[0]
        # The plane as complex numbers: a turn and scale is one product.
        z, target = bowl.position @ np.array([1, 1j]), self.target @ np.array([1, 1j])
        far = np.linalg.norm(bowl.position[[0, -1]] - foot, axis=1)
        kept, sent = (z[-1], z[0]) if far[0] < far[1] else (z[0], z[-1])
        fitted = kept + (z - kept) * ((target - kept) / (sent - kept) if sent != kept else 1.0)
        strokes = list(self.source.strokes)
        strokes[self.bowl] = Trajectory(bowl.t, np.column_stack([fitted.real, fitted.imag]))
        return tuple(strokes)

    @property
    def shear(self) -> float:
        """The rms distance of the bowl from the D's own turned and scaled, at equal times [m]."""
        if self.strokes is None:
            return np.inf
        return rms(self.strokes[self.bowl].position - self.ideal[self.bowl].position)

    @property
    def height(self) -> float:
        """How long the bar is [m]."""
        foot, top = _ends(self.source.strokes[self.bar])
        return float(np.linalg.norm(top - foot))


@dataclass(frozen=True, eq=False, repr=False)
class MadeLetters(Tabled):
    """The Ps of everybody, by every transformation.

    Args:
        items: Writers' Ps, all of one transformation, then all of the next.
        borrowed: Whether no D of two strokes was given, so that our own were taken.
    """

    items: tuple[MadeLetter, ...]
    borrowed: bool = False

    @checked
    def by(self, made_with: str) -> tuple[MadeLetter, ...]:
        """Return those that one transformation made."""
        return tuple(item for item in self.items if item.made_with == made_with)

    @property
    def ways(self) -> tuple[str, ...]:
        """The transformations."""
        return tuple(dict.fromkeys(item.made_with for item in self.items))

    @property
    def columns(self) -> Columns:
        """A row for each letter."""
        return {
            "from": [item.source.name for item in self.items],
            "made with": [item.made_with for item in self.items],
            "a P": [item.recognisable for item in self.items],
            "overshoot [mm]": [1e3 * item.overshoot for item in self.items],
            "shear [mm]": [1e3 * item.shear for item in self.items],
            "shear [% of bar]": [100 * item.shear / item.height for item in self.items],
        }


def goal_transforms() -> dict[str, Settings]:
    """Return the transformations that a goal can be changed with, each by its name."""
    similarity = Settings.star(transform="similarity")
    return {"DMP*": Settings.star(), "original": Settings.original(), "similarity": similarity}


@checked
def make_p_from_d(
    recordings: RecordingsLike = None,
    settings: Mapping[str, Settings] | None = None,
    *,
    executor: Executor | None = None,
    progress: Progress | None = None,
) -> MadeLetters:
    """Make every D into a P: the bowl's lower end goes to the middle of the bar.

    Bar and bowl may come in any order. A D that was drawn without a lift is cut at its corner.

    Args:
        recordings: Recordings, files or strokes; our own D where none has a bar and a bowl.
        settings: How, by name; `goal_transforms()` unless given.
        executor: As in `claims`; a piece of work is one D.
        progress: As in `claims`.
    """
    named = named_settings(settings, goal_transforms())
    cut = (
        each if len(each.strokes) > 1 else replace(each, strokes=cut_at_corners(each.strokes[0]))
        for each in list_letters(recordings)
        if each.character == "D"
    )
    given = [letter for letter in cut if len(letter.strokes) > 1]
    pieces = [(letter, named) for letter in given or list_letters(own_recordings("D"))]
    found = run(_make, pieces, executor, progress)
    return MadeLetters(tuple(item for way in zip(*found, strict=True) for item in way), not given)


def _make(piece: tuple[Written, Mapping[str, Settings]]) -> tuple[MadeLetter, ...]:
    """Return one D made into a P with all settings."""
    letter, named = piece
    bar, bowl = find_bar_and_bowl(letter.strokes)
    foot, top = _ends(letter.strokes[bar])
    ends = letter.strokes[bowl].position[[0, -1]]
    target = foot + (top - foot) / 2
    at_start = np.linalg.norm(ends[0] - foot) < np.linalg.norm(ends[1] - foot)
    made = []
    for name, settings in named.items():
        strokes: tuple[Trajectory, ...] | None = None
        with suppress(SettingError):
            learned, moved = Letter.learn(letter.strokes, settings), {bowl: target}
            strokes = learned.write(starts=moved) if at_start else learned.write(goals=moved)
        made.append(MadeLetter(letter, name, bar, bowl, target, strokes))
    return tuple(made)


def _ends(bar: Trajectory) -> tuple[Array, Array]:
    """Return the lower end of the bar, and the upper one."""
    first, last = bar.position[[0, -1]]
    return (first, last) if first[1] < last[1] else (last, first)


def _from_bar(path: Array, foot: Array, along: Array) -> tuple[Array, Array]:
    """Return how far up the bar, and how far beside it, every point is [m]."""
    off = path - foot
    return off @ along, off @ np.array([along[1], -along[0]])
