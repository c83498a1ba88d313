"""A D that becomes a P by another goal of its bowl (the paper's figure 9), and what makes it a P."""

from __future__ import annotations

from collections.abc import Mapping
from concurrent.futures import Executor
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from dmp_teach.dmp import Settings, knob_of, named_settings
from dmp_teach.errors import SettingError
from dmp_teach.letters import Letter, cut_at_corners, find_bar_and_bowl
from dmp_teach.studies.inputs import Written, letters_of, own_recordings
from dmp_teach.studies.parallel import Progress, run
from dmp_teach.studies.tables import Rows, Tabled
from dmp_teach.trajectory import Array, Trajectory

JOINED = 0.05  # the bowl ends this near to where it should, in parts of the bar
LEG = 0.2  # this part of the bar is free under the bowl
SIDE = 0.8  # this part of the bowl is on its side of the bar
SPREAD = 1.5  # no part of the bowl is farther from the bar than this, in parts of the bar


@dataclass(frozen=True, eq=False)
class MadeLetter:
    """A P, made from somebody's D.

    Args:
        source: The D.
        made_with: Words for the transformation.
        bar: The number of the stroke that is the bar, counted from 0.
        bowl: The number of the stroke that is the bowl.
        target: Where the lower end of the bowl was sent: the middle of the bar, shape (2,) [m].
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
        return (
            np.inf
            if self.strokes is None
            else max(0.0, float(self.target[1] - self._drawn[:, 1].min()))
        )

    @property
    def recognisable(self) -> bool:
        """Whether it is built like a P: joined at the bar, a free leg, the bowl on its side and of its size."""
        if self.strokes is None:
            return False
        foot, top = self._bar
        height = float(np.linalg.norm(top - foot))
        along = (top - foot) / height
        place, off = _from_bar(self._drawn, foot, along)
        _, shown = _from_bar(self.source.strokes[self.bowl].position, foot, along)
        side = np.sign(np.median(shown))
        ends = np.linalg.norm(self._drawn[[0, -1]] - self.target, axis=1).min()
        return bool(
            ends <= JOINED * height
            and place.min() >= LEG * height
            and np.mean(side * off > -0.02 * height) >= SIDE
            and np.abs(off).max() <= SPREAD * height
        )

    @property
    def ideal(self) -> tuple[Trajectory, ...]:
        """The D's own strokes, the bowl turned and scaled so that it fits the new ends: a P without any shear."""
        bowl = self.source.strokes[self.bowl]
        z = bowl.position @ np.array([1, 1j])
        far = np.linalg.norm(
            bowl.position[[0, -1]] - _ends(self.source.strokes[self.bar])[0], axis=1
        )
        kept, sent = (z[-1], z[0]) if far[0] < far[1] else (z[0], z[-1])
        target = self.target @ np.array([1, 1j])
        fitted = kept + (z - kept) * ((target - kept) / (sent - kept) if sent != kept else 1.0)
        drawn = Trajectory(bowl.t, np.column_stack([fitted.real, fitted.imag]))
        return tuple(
            drawn if k == self.bowl else stroke for k, stroke in enumerate(self.source.strokes)
        )

    @property
    def shear(self) -> float:
        """How far the bowl is from the D's own bowl turned and scaled, root mean square at equal times [m]."""
        if self.strokes is None:
            return np.inf
        apart = self._drawn - self.ideal[self.bowl].position
        return float(np.sqrt((apart**2).sum(axis=1).mean()))

    @property
    def height(self) -> float:
        """How long the bar is [m]."""
        foot, top = self._bar
        return float(np.linalg.norm(top - foot))

    @property
    def _drawn(self) -> Array:
        return self.strokes[self.bowl].position

    @property
    def _bar(self) -> tuple[Array, Array]:
        return _ends(self.source.strokes[self.bar])


@dataclass(frozen=True, eq=False)
class MadeLetters(Tabled):
    """The Ps of everybody, by every transformation.

    Args:
        items: Writers' Ps, all of one transformation, then all of the next.
        borrowed: Whether no D of two strokes was given, so that our own were taken.
    """

    items: tuple[MadeLetter, ...]
    borrowed: bool = False

    def by(self, made_with: str) -> tuple[MadeLetter, ...]:
        """Those that one transformation made."""
        return tuple(item for item in self.items if item.made_with == made_with)

    @property
    def ways(self) -> tuple[str, ...]:
        """The transformations."""
        return tuple(dict.fromkeys(item.made_with for item in self.items))

    def rows(self) -> Rows:
        """One for each P."""
        return tuple(
            {
                "from": item.source.name,
                "made with": item.made_with,
                "a P": item.recognisable,
                "overshoot [mm]": 1e3 * item.overshoot,
                "shear [mm]": 1e3 * item.shear,
                "shear [% of bar]": 100 * item.shear / item.height,
            }
            for item in self.items
        )


def transforms() -> dict[str, Settings]:
    """The transformations that a goal can be changed with, each by its name."""
    named = {"DMP*": Settings.star(), "original": Settings.original()}
    if "similarity" in knob_of("transform").choices:
        named["similarity"] = Settings.star(transform="similarity")
    return named


def make_p_from_d(
    recordings: Any = None,
    settings: Mapping[str, Settings] | None = None,
    *,
    executor: Executor | None = None,
    progress: Progress | None = None,
) -> MadeLetters:
    """Every D (bar and bowl, in any order) made into a P: the bowl's lower end goes to the middle of the bar.

    A D that was drawn without a lift is cut at its corner, where it has one.

    Args:
        recordings: Recordings, files or strokes; our own D where none has a bar and a bowl.
        settings: How, by name; `transforms()` unless given.
        executor: Any `concurrent.futures.Executor`; a piece of work is one D.
        progress: Called as `progress(done, total)`.
    """
    named = named_settings(settings, transforms())
    given = [letter for letter in map(_taken_apart, letters_of(recordings)) if _is_d(letter)]
    pieces = [(letter, named) for letter in given or letters_of(own_recordings("D"))]
    found = run(_made, pieces, executor, progress)
    return MadeLetters(tuple(item for way in zip(*found, strict=True) for item in way), not given)


def _taken_apart(letter: Written) -> Written:
    """The letter, cut at its corners if it was drawn without a lift."""
    return (
        letter
        if len(letter.strokes) > 1
        else replace(letter, strokes=cut_at_corners(letter.strokes[0]))
    )


def _is_d(letter: Written) -> bool:
    return letter.character == "D" and len(letter.strokes) >= 2


def _made(piece: tuple[Written, Mapping[str, Settings]]) -> tuple[MadeLetter, ...]:
    """One D in all ways."""
    letter, named = piece
    bar, bowl = find_bar_and_bowl(letter.strokes)
    foot, top = _ends(letter.strokes[bar])
    ends = letter.strokes[bowl].position[[0, -1]]
    target = foot + (top - foot) / 2
    at_start = np.linalg.norm(ends[0] - foot) < np.linalg.norm(ends[1] - foot)
    change = {"starts" if at_start else "goals": {bowl: target}}
    made = []
    for name, settings in named.items():
        try:
            strokes = Letter.learn(letter.strokes, settings).write(**change)
        except SettingError:
            strokes = None
        made.append(MadeLetter(letter, name, bar, bowl, target, strokes))
    return tuple(made)


def _ends(bar: Trajectory) -> tuple[Array, Array]:
    """The lower end of the bar, and the upper one."""
    first, last = bar.position[[0, -1]]
    return (first, last) if first[1] < last[1] else (last, first)


def _from_bar(path: Array, foot: Array, along: Array) -> tuple[Array, Array]:
    """How far up the bar, and how far beside it, every point is [m]."""
    off = path - foot
    return off @ along, off @ np.array([along[1], -along[0]])
