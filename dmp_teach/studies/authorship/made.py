"""Is a style kept? Made letters, given to the writer whose own strokes they look most like."""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import Executor
from dataclasses import dataclass
from typing import Any

import numpy as np

from dmp_teach.dmp import Settings
from dmp_teach.errors import LetterError, SettingError
from dmp_teach.letters import (
    Piece,
    Shelf,
    follow_recipe,
    letters_needed,
    recipes,
    resample_evenly,
    strokes_in_role,
)
from dmp_teach.studies.authorship.answers import Answers, Attributions, luck_of_takes
from dmp_teach.studies.authorship.real import fresh
from dmp_teach.studies.inputs import OURS, Written, letters_of, own_recordings
from dmp_teach.studies.parallel import Progress, run
from dmp_teach.trajectory import Array

STEPS = 39  # between points at equal ways along a stroke
VARIATIONS = 20
FAR = 0.1  # how far starts and goals vary, one standard deviation in each direction, in parts of the stroke's size
WAYS = {
    "DMP*": (Settings.star(), "star"),
    "similarity": (Settings.star(), "similarity"),
    "original": (Settings.original(), None),
}
"""How strokes are learned, and what leads them to other ends."""


Take = dict[str, Written]
"""One take of each letter that one writer wrote."""


@dataclass(frozen=True, eq=False)
class _Bowl:
    """A bowl that a recipe leads, by everybody: T takes with the bowl as written (T, F), and made (T, ways, V, F)."""

    takes: tuple[int, ...]
    writers: tuple[str, ...]
    real: Array
    made: Array

    def neighbours(self) -> np.ndarray:
        """Which real bowls each made one may be given to: its own source only if its writer has no other, (T, T)."""
        whose = np.array(self.writers)
        several = (whose[:, None] == whose).sum(axis=1) > 1
        return ~(np.eye(len(whose), dtype=bool) & several)

    def named(self, way: int, variations: slice, less: bool) -> list[list[str | None]]:
        """Whose bowl is nearest to each made one, for each take and variation; None where nothing was drawn."""
        made, real = self.made[:, way, variations], self.real
        if less:
            drawn = np.isfinite(made[:, :, 0])
            mean = (
                np.where(drawn[:, :, None], made, 0).sum(axis=0)
                / np.maximum(drawn.sum(axis=0), 1)[:, None]
            )
            made, real = made - mean, real - real.mean(axis=0)
        far = np.linalg.norm(made[:, :, None] - real, axis=3)
        near = np.where(self.neighbours()[:, None], far, np.inf)
        return [
            [
                self.writers[int(np.argmin(each))] if np.isfinite(each).any() else None
                for each in row
            ]
            for row in np.where(np.isnan(near), np.inf, near)
        ]


def attribute_made_letters(
    recordings: Any = None,
    variations: int = VARIATIONS,
    *,
    executor: Executor | None = None,
    progress: Progress | None = None,
) -> Attributions:
    """Made letters given to the writer whose real stroke is nearest.

    Every recipe that leads a stroke to other ends (D to P, R and B, B to P) is made from every writer's letters. What
    was only moved is the writer's own stroke and would be right for nothing, and a bar whose ends are both given is a
    line: neither is asked about. What is asked are bowls that were led. Their neighbours are the bowls that
    all writers wrote themselves, in the same role: other takes by the same writer, and only if there is none the
    stroke that the made one comes from. In that case the question is whether the primitive changes a shape less than
    writers differ, and nothing more.

    The distance is the root mean square difference of the directions of the ink at 40 equal ways along: place and size
    do not count, lean does. Every question is asked "as drawn", and "less the mean": the mean of everybody's strokes
    is taken from both sides first, as what a recipe does to everybody's bowl (a P's is half as high as a D's) says
    nothing about whose it is. "varied" moves starts and goals by chance as well, the same for everybody.

    Args:
        recordings: Recordings, files or strokes; our own letters where there are no bowls by two writers in it.
        variations: How often starts and goals are moved, by a tenth of the stroke's size (normal, in each direction).
        executor: Any `concurrent.futures.Executor`; a piece of work is one take by one writer.
        progress: Called as `progress(done, total)`.

    Raises:
        LetterError: A letter that is not flat, or all in one place.
        SettingError: No number of variations.
    """
    if isinstance(variations, bool) or not isinstance(variations, int) or variations < 1:
        raise SettingError(
            f"variations is {variations!r}, but must be a whole number of at least 1."
        )
    found = _bowls(letters_of(recordings), variations, executor, progress)
    borrowed = not found
    if borrowed:
        found = _bowls(letters_of(own_recordings(OURS)), variations, executor, progress)
    asked = [
        _asked(found, way, varied, less)
        for way in WAYS
        for varied in (False, True)
        for less in (True, False)
    ]
    return Attributions(tuple(asked), borrowed)


def question(way: str, varied: bool, less: bool) -> str:
    """The words for a question, such as "DMP*, varied, less the mean"."""
    return f"{way}{', varied' * varied}, {'less the mean' if less else 'as drawn'}"


def directions(path: Array) -> Array:
    """The direction of the ink at equal ways along it, from its upper end on, as unit vectors, shape (2 * STEPS,)."""
    points, _ = resample_evenly(path if path[0, 1] >= path[-1, 1] else path[::-1], STEPS + 1)
    step = np.diff(points, axis=0)
    return (
        step / np.maximum(np.linalg.norm(step, axis=1, keepdims=True), 1e-12)
    ).ravel() / np.sqrt(STEPS)


def _bowls(
    letters: Sequence[Written],
    variations: int,
    executor: Executor | None,
    progress: Progress | None,
) -> list:
    """Every bowl that a recipe leads, as far as two writers or more have it."""
    takes = takes_of(letters)
    table = [how.replace(" alike", "") for _, how in recipes()]  # every way is asked for by name
    hows = dict.fromkeys(
        ",".join(how.split(",")[: number + 1]) for how in table for number in _led(how)
    )
    made = run(_made, [(take, tuple(hows), variations) for _, take in takes], executor, progress)
    found = []
    for bowl in zip(*made, strict=True):
        there = tuple(number for number, each in enumerate(bowl) if each is not None)
        writers = tuple(takes[number][0] for number in there)
        if len(set(writers)) > 1:
            real, drawn = (np.array([bowl[number][side] for number in there]) for side in (0, 1))
            found.append(_Bowl(there, writers, real, drawn))
    return found


def _led(how: str) -> list[int]:
    """The numbers of the strokes, other than bars, that a recipe leads to other ends."""
    items = [item.split() for item in how.split(",")]
    return [
        number
        for number, (_, role, *words) in enumerate(items)
        if "lead" in words and role != "bar"
    ]


def takes_of(letters: Sequence[Written]) -> list[tuple[str, Take]]:
    """The first take of each of a writer's letters, then the second, as far as there are."""
    groups: dict[tuple[str, str], list[Written]] = {}
    for letter in letters:
        groups.setdefault((letter.writer, letter.character), []).append(letter)
    takes: dict[tuple[str, int], Take] = {}
    for (writer, character), group in groups.items():
        for number, letter in enumerate(fresh(group)):
            takes.setdefault((writer, number), {})[character] = letter
    return [(writer, take) for (writer, _), take in takes.items()]


def _made(piece: tuple[Take, Sequence[str], int]) -> list[tuple[Array, Array] | None]:
    """What one take gives for the last stroke of each recipe."""
    take, hows, variations = piece
    return [
        _last(take, how, variations) if set(letters_needed(how)) <= take.keys() else None
        for how in hows
    ]


def _last(take: Take, how: str, variations: int) -> tuple[Array, Array] | None:
    """The last stroke of a recipe, real (F,) and made (ways, 1 + variations, F); None where this D has none.

    What cannot be drawn is NaN.
    """
    letter, role = how.rsplit(",", maxsplit=1)[-1].split()[:2]
    try:
        (real,) = (
            piece.shown.position
            for piece in strokes_in_role(role, _shelf(take, how, Settings.star())[letter])
        )
    except LetterError:
        return None
    made = np.full((len(WAYS), 1 + variations, 2 * STEPS), np.nan)
    for row, (settings, transform) in zip(made, WAYS.values(), strict=True):
        try:
            led = follow_recipe(how, _shelf(take, how, settings), transform)[-1]
        except (SettingError, LetterError):
            continue
        size = float(np.ptp(real, axis=0).max())
        for number in range(1 + variations):
            row[number] = directions(_varied(led, size, number).drawn.position)
    return directions(real), made


def _shelf(take: Take, how: str, settings: Settings) -> Shelf:
    return Shelf.of(
        {character: take[character].strokes for character in letters_needed(how)}, settings
    )


def _varied(piece: Piece, size: float, number: int) -> Piece:
    """The stroke with its start and goal moved by chance; as it is for number 0."""
    if not number:
        return piece
    start, goal = FAR * size * np.random.default_rng(number).normal(size=(2, 2))
    return piece.led(start=piece.at("start") + start, goal=piece.at("goal") + goal)


def _asked(bowls: Sequence[_Bowl], way: str, varied: bool, less: bool) -> Answers:
    """One question with its answers."""
    asked, guess = [], []
    for bowl in bowls:
        named = bowl.named(list(WAYS).index(way), slice(1, None) if varied else slice(1), less)
        asked += [
            (take, writer, name)
            for take, writer, row in zip(bowl.takes, bowl.writers, named, strict=True)
            for name in row
        ]
        same, allowed = np.array(bowl.writers)[:, None] == np.array(bowl.writers), bowl.neighbours()
        guess += list((same & allowed).sum(axis=1) / allowed.sum(axis=1))
    items = tuple((writer, name) for _, writer, name in asked)
    return Answers(question(way, varied, less), items, float(np.mean(guess)), luck_of_takes(asked))
