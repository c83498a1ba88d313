"""Made letters attributed among real letters of their kind: a P made of a D beside real Ps."""

from __future__ import annotations

import string
from collections.abc import Sequence
from typing import Any, Unpack

import numpy as np
from numpy.typing import NDArray

from dmp_teach.dmp import Settings
from dmp_teach.errors import LetterError, SettingError
from dmp_teach.letters import Letter, Shelf, letters_needed, make_letter, recipes
from dmp_teach.scoring import letter_distances
from dmp_teach.studies.authorship.answers import Answers, Attributions, takes_luck
from dmp_teach.studies.authorship.made import LED_WITH, OneTake, sort_takes
from dmp_teach.studies.inputs import Written, list_letters, own_recordings
from dmp_teach.studies.parallel import RunOptions, run
from dmp_teach.trajectory import Trajectory

ONLY_MOVED = "only moved"

CharacterJob = tuple[str, list[tuple[int, str, OneTake]], list[tuple[str, Written]]]
"""A character, takes (number, writer, letters) to make it of, and real ones (writer, letter)."""
Answer = tuple[int, str, str | None]
"""The number of a take, who wrote it, and who was named."""
JobResult = tuple[dict[str, list[Answer]], list[float]]
"""Of one character: the answers by transformation, and the chance of a guess for each take."""


def attribute_among_real(recordings: Any = None, **options: Unpack[RunOptions]) -> Attributions:
    """Attribute made letters to whoever wrote the nearest real letter of that kind.

    Every letter for which there is a recipe is made of every take that has what it needs, if two
    writers or more wrote it, the maker among them. So, other than in `attribute_made_letters`, a P
    is compared with no stroke that it is made of: it is right only if the writer's own P is nearer
    than everybody else's. The distance is `letter_distance(upright=False)`. There is a question for
    each transformation of strokes to other ends (P, R and B), and one for letters whose strokes are
    only moved, which demand little of a primitive.

    Args:
        recordings: Recordings, files or strokes; our own alphabets where nothing can be asked of
            what was given.
        **options: `executor` and `progress` (`RunOptions`); a piece of work is one character.

    Raises:
        LetterError: A letter that is not flat, or all in one place.
    """
    found = [] if recordings is None else _results(list_letters(recordings), options)
    borrowed = not found
    if borrowed:
        ours = list_letters(own_recordings(string.ascii_letters + string.digits))
        found = _results(ours, options)
    answers = tuple(_answers(way, found) for way in (*LED_WITH, ONLY_MOVED))
    return Attributions(answers, borrowed and recordings is not None)


def _results(letters: Sequence[Written], options: RunOptions) -> list[JobResult]:
    """Return the answers for each character about which something can be asked."""
    return [each for each in run(_do_job, _jobs(letters), **options) if each is not None]


def _jobs(letters: Sequence[Written]) -> list[CharacterJob]:
    """Return a piece of work for each character that can be made, and that two writers wrote."""
    takes = [(number, writer, take) for number, (writer, take) in enumerate(sort_takes(letters))]
    jobs = []
    for character in dict.fromkeys(made for made, _ in recipes()):
        real = [(writer, take[character]) for _, writer, take in takes if character in take]
        whose = {writer for writer, _ in real}
        able = [each for each in takes if each[1] in whose and _hows(character, each[2])]
        if len(whose) > 1 and able:
            jobs.append((character, able, real))
    return jobs


def _hows(character: str, take: OneTake) -> list[str]:
    """Return the recipes for a character whose letters a take has."""
    return [how for _, how in recipes(character) if set(letters_needed(how)) <= take.keys()]


def _do_job(job: CharacterJob) -> JobResult | None:
    """Return the answers about one character; None where it can be made of no take."""
    character, takes, real = job
    whose = np.array([writer for writer, _ in real])
    there = [letter.strokes for _, letter in real]
    led = any("lead" in how.split() for _, how in recipes(character))
    ways = LED_WITH if led else {ONLY_MOVED: LED_WITH["DMP*"]}
    answers: dict[str, list[Answer]] = {way: [] for way in ways}
    chance = []
    for number, writer, take in takes:
        drawn = {way: _drawn(character, take, *how) for way, how in ways.items()}
        if all(letter is None for letter in drawn.values()):
            # No P can be made of a D without a corner.
            continue
        chance.append(float(np.mean(whose == writer)))
        for way, letter in drawn.items():
            named = None if letter is None else _nearest(letter, there, whose)
            answers[way].append((number, writer, named))
    return (answers, chance) if chance else None


def _drawn(
    character: str, take: OneTake, settings: Settings, transform: str | None
) -> Letter | None:
    """Return the made letter, or None where it cannot be made so."""
    wanted = {letter for how in _hows(character, take) for letter in letters_needed(how)}
    try:
        shelf = Shelf.of({letter: take[letter].strokes for letter in wanted}, settings)
        return make_letter(character, shelf, transform)
    except (LetterError, SettingError):
        return None


def _nearest(
    letter: Letter, real: Sequence[Sequence[Trajectory]], whose: NDArray[np.str_]
) -> str | None:
    """Return who wrote the nearest real letter; None where the made one cannot be compared."""
    try:
        return str(whose[int(np.argmin(letter_distances([letter], real, upright=False)))])
    except LetterError:
        return None


def _answers(way: str, found: Sequence[JobResult]) -> Answers:
    """Return the answers about all characters that were made in this way."""
    there = [(answers[way], chances) for answers, chances in found if way in answers]
    every = [each for answers, _ in there for each in answers]
    chances = [each for _, chances in there for each in chances]
    chance = float(np.mean(chances)) if chances else float("nan")
    items = tuple((writer, named) for _, writer, named in every)
    return Answers(f"{way}, among real ones", items, chance, takes_luck(every))
