"""Made letters, each attributed to the writer whose own strokes are nearest."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from dmp_teach.arguments import checked
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
from dmp_teach.studies.authorship.answers import Answers, Attributions, takes_luck
from dmp_teach.studies.authorship.real import distinct_takes
from dmp_teach.studies.inputs import RecordingsLike, Written, list_letters
from dmp_teach.studies.parallel import Progress, run
from dmp_teach.trajectory import Array

# Between points at equal arc length along a stroke.
DIRECTION_STEPS = 39
DEFAULT_VARIATIONS = 20
# The standard deviation of varied starts and goals, as a share of the stroke's size.
END_VARIATION = 0.1
LED_WITH: dict[str, tuple[Settings, str | None]] = {
    "DMP*": (Settings.star(), "star"),
    "similarity": (Settings.star(), "similarity"),
    "original": (Settings.original(), None),
}
"""The settings that strokes are learned with, and the transformation to other ends."""

OneTake = dict[str, Written]
"""One take of each letter that one writer wrote."""


LedWith = Mapping[str, tuple[Settings, str | None]]


@dataclass(frozen=True, eq=False)
class _Bowl:
    """A bowl that a recipe leads, of T takes: as written (T, F), and made (T, ways, V, F)."""

    letter: str
    takes: tuple[int, ...]
    writers: tuple[str, ...]
    real: Array
    made: Array

    def shown(self, less: bool) -> Array:
        """Return the real bowls, less everybody's mean where asked for, shape (T, F)."""
        return self.real - self.real.mean(axis=0) * less

    def drawn(self, way: int, variations: slice, less: bool) -> Array:
        """Return the made ones alike, NaN where nothing was drawn, shape (T, V, F)."""
        made = self.made[:, way, variations]
        there = np.isfinite(made[:, :, 0])
        total = np.where(there[:, :, None], made, 0).sum(axis=0)
        return made - total / np.maximum(there.sum(axis=0), 1)[:, None] * less


@dataclass(frozen=True, eq=False)
class _References:
    """Real bowls (R, F), whose they are, and which a made one may be given to (T, R)."""

    shown: Array
    writers: NDArray[np.str_]
    allowed: NDArray[np.bool_]

    @classmethod
    def of(cls, bowl: _Bowl, bowls: Sequence[_Bowl], less: bool) -> _References:
        """Return other takes of the bowl, and where its writer has none bowls of other letters."""
        others = list({each.letter: each for each in bowls if each.letter != bowl.letter}.values())
        shown = np.concatenate([each.shown(less) for each in (bowl, *others)])
        writers = np.array([name for each in (bowl, *others) for name in each.writers])
        whose, T = np.array(bowl.writers), len(bowl.writers)
        several = (whose[:, None] == whose).sum(axis=1) > 1
        known = np.isin(whose, writers[T:])
        allowed = np.empty((T, len(writers)), dtype=bool)
        allowed[:, :T] = ~np.eye(T, dtype=bool) & several[:, None]
        allowed[:, T:] = (~several & known)[:, None]
        return cls(shown, writers, allowed)

    def named(self, drawn: Array, take: int) -> list[str | None]:
        """Return whose bowl is nearest to each made one (V, F); None where nothing was drawn."""
        far = np.linalg.norm(drawn[:, None] - self.shown, axis=2)
        far = np.where(self.allowed[take] & np.isfinite(far), far, np.inf)
        return [str(self.writers[row.argmin()]) if np.isfinite(row).any() else None for row in far]


@checked
def attribute_made_letters(
    recordings: RecordingsLike = None,
    variations: int = DEFAULT_VARIATIONS,
    led_with: LedWith | None = None,
    *,
    executor: Executor | None = None,
    progress: Progress | None = None,
) -> Attributions:
    """Attribute made letters to the writer whose real stroke is nearest.

    Every recipe that leads a stroke to other ends (D to P, R and B, B to P) is made from every
    writer's letters. Strokes that were only moved are the writer's own, and a bar whose ends are
    both given is a line: only bowls that were led are asked about. Their neighbours are the bowls
    that all writers wrote themselves, in the same role, but never the stroke that the made one
    comes from. Where its writer has no other take of it, they are the bowls of all other letters,
    and where there are none of these, nothing is asked.

    The distance is the root mean square difference of the directions of the ink at 40 points of
    equal arc length: place and size do not count, lean does. Every question is asked "as drawn",
    and "less the mean": the mean of everybody's strokes is subtracted from both sides first, as
    what a recipe does to everybody's bowl (a P's is half as high as a D's) says nothing about whose
    it is. "varied" moves starts and goals at random as well, the same for everybody.

    Args:
        recordings: Recordings, files or strokes; our own letters where there are no bowls by two
            writers in it.
        variations: How often starts and goals are moved, by a tenth of the stroke's size (normal,
            in each direction).
        led_with: By the name of a way, the settings that strokes are learned with, and the
            transformation to other ends; `LED_WITH` unless given.
        executor: As in `claims`; a piece is one take by one writer.
        progress: As in `claims`.

    Raises:
        LetterError: A letter that is not flat, or all in one place.
        SettingError: No number of variations.
    """
    if isinstance(variations, bool) or not isinstance(variations, int) or variations < 1:
        raise SettingError(
            f"variations is {variations!r}, but must be a whole number of at least 1."
        )
    ways = dict(LED_WITH if led_with is None else led_with)
    found = _bowls(list_letters(recordings), variations, ways, executor, progress)
    borrowed = not found
    if borrowed:
        found = _bowls(list_letters(), variations, ways, executor, progress)
    answers = [
        _answers(found, (number, way), varied, less)
        for number, way in enumerate(ways)
        for varied in (False, True)
        for less in (True, False)
    ]
    return Attributions(tuple(answers), borrowed)


def question(way: str, varied: bool, less: bool) -> str:
    """Return the words for a question, such as "DMP*, varied, less the mean"."""
    return f"{way}{', varied' * varied}, {'less the mean' if less else 'as drawn'}"


@checked
def ink_directions(path: Array) -> Array:
    """Return the directions of ink at equal arc length, from its upper end on, shape (78,)."""
    downwards = path if path[0, 1] >= path[-1, 1] else path[::-1]
    step = np.diff(resample_evenly(downwards, DIRECTION_STEPS + 1)[0], axis=0)
    unit = step / np.maximum(np.linalg.norm(step, axis=1, keepdims=True), 1e-12)
    return unit.ravel() / np.sqrt(DIRECTION_STEPS)


def _bowls(
    letters: Sequence[Written],
    variations: int,
    ways: LedWith,
    executor: Executor | None,
    progress: Progress | None,
) -> list[_Bowl]:
    """Return every bowl that a recipe leads, as far as two writers or more can be named."""
    takes = sort_takes(letters)
    # Every transformation is asked for by name.
    table = [how.replace(" alike", "") for _, how in recipes()]
    hows = dict.fromkeys(
        ",".join(how.split(",")[: number + 1]) for how in table for number in _led(how)
    )
    pieces = [(take, tuple(hows), variations, ways) for _, take in takes]
    made = run(_make, pieces, executor, progress)
    found = []
    for how, bowl in zip(hows, zip(*made, strict=True), strict=True):
        there = tuple(number for number, each in enumerate(bowl) if each is not None)
        writers = tuple(takes[number][0] for number in there)
        if len(set(writers)) > 1:
            real, drawn = (np.array([bowl[number][side] for number in there]) for side in (0, 1))
            found.append(_Bowl(_led_stroke(how)[0], there, writers, real, drawn))
    can_be_asked = (_References.of(each, found, less=False).allowed.any() for each in found)
    return found if any(can_be_asked) else []


def _led(how: str) -> list[int]:
    """Return the numbers of the strokes, other than bars, that a recipe leads to other ends."""
    items = [item.split() for item in how.split(",")]
    return [
        number
        for number, (_, role, *words) in enumerate(items)
        if "lead" in words and role != "bar"
    ]


def sort_takes(letters: Sequence[Written]) -> list[tuple[str, OneTake]]:
    """Return writers with the first take of each letter, then the second, as far as there are."""
    groups: dict[tuple[str, str], list[Written]] = {}
    for letter in letters:
        groups.setdefault((letter.writer, letter.character), []).append(letter)
    takes: dict[tuple[str, int], OneTake] = {}
    for (writer, character), group in groups.items():
        for number, letter in enumerate(distinct_takes(group)):
            takes.setdefault((writer, number), {})[character] = letter
    return [(writer, take) for (writer, _), take in takes.items()]


def _led_stroke(how: str) -> list[str]:
    """Return letter and role of the last stroke of a recipe."""
    return how.rsplit(",", maxsplit=1)[-1].split()[:2]


def _make(
    piece: tuple[OneTake, Sequence[str], int, LedWith],
) -> list[tuple[Array, Array] | None]:
    """Return what one take gives for the last stroke of each recipe."""
    take, hows, variations, ways = piece
    return [
        _last(take, how, variations, ways) if set(letters_needed(how)) <= take.keys() else None
        for how in hows
    ]


def _last(take: OneTake, how: str, variations: int, ways: LedWith) -> tuple[Array, Array] | None:
    """Return the last stroke of a recipe, real (F,) and made (ways, 1 + variations, F).

    None where this D has no such stroke; NaN where it cannot be drawn.
    """
    letter, role = _led_stroke(how)
    try:
        (piece,) = strokes_in_role(role, _shelf(take, how, Settings.star())[letter])
    except LetterError:
        return None
    real = piece.shown.position
    made = np.full((len(ways), 1 + variations, 2 * DIRECTION_STEPS), np.nan)
    for row, (settings, transform) in zip(made, ways.values(), strict=True):
        try:
            led = follow_recipe(how, _shelf(take, how, settings), transform)[-1]
        except (SettingError, LetterError):
            continue
        size = float(np.ptp(real, axis=0).max())
        for number in range(1 + variations):
            row[number] = ink_directions(_varied(led, size, number).drawn.position)
    return ink_directions(real), made


def _shelf(take: OneTake, how: str, settings: Settings) -> Shelf:
    return Shelf.of({each: take[each].strokes for each in letters_needed(how)}, settings)


def _varied(piece: Piece, size: float, number: int) -> Piece:
    """Return the stroke with its start and goal moved at random; as it is for number 0."""
    if not number:
        return piece
    start, goal = END_VARIATION * size * np.random.default_rng(number).normal(size=(2, 2))
    return piece.led(start=piece.at("start") + start, goal=piece.at("goal") + goal)


def _answers(bowls: Sequence[_Bowl], way: tuple[int, str], varied: bool, less: bool) -> Answers:
    """Return one question with its answers."""
    which = slice(1, None) if varied else slice(1)
    found: list[tuple[int, str, str | None]] = []
    guess: list[float] = []
    for bowl in bowls:
        references, drawn = _References.of(bowl, bowls, less), bowl.drawn(way[0], which, less)
        for k, (take, writer) in enumerate(zip(bowl.takes, bowl.writers, strict=True)):
            allowed = references.allowed[k]
            if allowed.any():
                found += [(take, writer, name) for name in references.named(drawn[k], k)]
                guess.append(float((references.writers[allowed] == writer).mean()))
    items = tuple((writer, name) for _, writer, name in found)
    chance = float(np.mean(guess)) if guess else float("nan")
    return Answers(question(way[1], varied, less), items, chance, takes_luck(found))
