"""Whose is a made letter, among real letters of its kind? A P made of a D, beside the Ps that people wrote."""

from __future__ import annotations

import string
from collections.abc import Sequence
from concurrent.futures import Executor
from typing import Any

import numpy as np

from dmp_teach.errors import LetterError, SettingError
from dmp_teach.letters import Letter, Shelf, letters_needed, make_letter, recipes
from dmp_teach.scoring import letter_distances
from dmp_teach.studies.authorship.answers import Answers, Attributions, luck_of_takes
from dmp_teach.studies.authorship.made import WAYS, Take, takes_of
from dmp_teach.studies.inputs import Written, letters_of, own_recordings
from dmp_teach.studies.parallel import Progress, run
from dmp_teach.trajectory import Array

MOVED = "only moved"

Job = tuple[str, list[tuple[int, str, Take]], list[tuple[str, Written]]]
"""A character, the takes (number, writer, letters) that it may be made of, and the real ones (writer, letter)."""
Asked = tuple[int, str, str | None]
"""The number of a take, who wrote it, and who was named."""
Answered = tuple[dict[str, list[Asked]], list[float]]
"""Of one character: what was asked in each way, and a guesser's chance for each take."""


def attribute_among_real(
    recordings: Any = None, *, executor: Executor | None = None, progress: Progress | None = None
) -> Attributions:
    """Made letters given to whoever wrote the nearest real letter of that kind.

    Every letter for which there is a recipe is made of every take that has what it needs, if two writers or more wrote
    it, the maker among them. So, other than in `attribute_made_letters`, a P is compared with no stroke that it is made of: it is
    right only if the writer's own P looks like it more than everybody else's does. The distance is
    `letter_distance(upright=False)`. There is a question for each way in which strokes are led to other ends (P, R and
    B), and one for letters whose strokes are only moved, which ask little of a primitive.

    Args:
        recordings: Recordings, files or strokes; our own alphabets where nothing can be asked of what was given.
        executor: Any `concurrent.futures.Executor`; a piece of work is one character.
        progress: Called as `progress(done, total)`.

    Raises:
        LetterError: A letter that is not flat, or all in one place.
    """
    found = [] if recordings is None else _found(letters_of(recordings), executor, progress)
    borrowed = not found
    if borrowed:
        found = _found(
            letters_of(own_recordings(string.ascii_letters + string.digits)), executor, progress
        )
    return Attributions(
        tuple(_question(way, found) for way in (*WAYS, MOVED)), borrowed and recordings is not None
    )


def _found(
    letters: Sequence[Written], executor: Executor | None, progress: Progress | None
) -> list[Answered]:
    """The answers for each character about which something can be asked."""
    return [each for each in run(_answered, _jobs(letters), executor, progress) if each is not None]


def _jobs(letters: Sequence[Written]) -> list[Job]:
    """A piece of work for each character that can be made, and that two writers wrote."""
    takes = [(number, writer, take) for number, (writer, take) in enumerate(takes_of(letters))]
    jobs = []
    for character in dict.fromkeys(made for made, _ in recipes()):
        real = [(writer, take[character]) for _, writer, take in takes if character in take]
        whose = {writer for writer, _ in real}
        able = [each for each in takes if each[1] in whose and _hows(character, each[2])]
        if len(whose) > 1 and able:
            jobs.append((character, able, real))
    return jobs


def _hows(character: str, take: Take) -> list[str]:
    """The recipes for a character whose letters a take has."""
    return [how for _, how in recipes(character) if set(letters_needed(how)) <= take.keys()]


def _answered(job: Job) -> Answered | None:
    """One character; None where it can be made of no take."""
    character, takes, real = job
    whose = np.array([writer for writer, _ in real])
    there = [letter.strokes for _, letter in real]
    led = any("lead" in how.split() for _, how in recipes(character))
    ways = WAYS if led else {MOVED: WAYS["DMP*"]}
    answers: dict[str, list[Asked]] = {way: [] for way in ways}
    chance = []
    for number, writer, take in takes:
        drawn = {way: _drawn(character, take, *how) for way, how in ways.items()}
        if all(letter is None for letter in drawn.values()):
            continue  # a D without a corner, say: nobody can make a P of it
        chance.append(float(np.mean(whose == writer)))
        for way, letter in drawn.items():
            answers[way].append(
                (number, writer, None if letter is None else _nearest(letter, there, whose))
            )
    return (answers, chance) if chance else None


def _drawn(character: str, take: Take, settings: Any, transform: str | None) -> Letter | None:
    """The made letter, or None where it cannot be made so."""
    wanted = {letter for how in _hows(character, take) for letter in letters_needed(how)}
    try:
        shelf = Shelf.of({letter: take[letter].strokes for letter in wanted}, settings)
        return make_letter(character, shelf, transform)
    except (LetterError, SettingError):
        return None


def _nearest(letter: Letter, real: Sequence[Any], whose: Array) -> str | None:
    """Who wrote the real letter that is nearest; None where the made one is too wild to be compared."""
    try:
        return str(whose[int(np.argmin(letter_distances([letter], real, upright=False)))])
    except LetterError:
        return None


def _question(way: str, found: Sequence[Answered]) -> Answers:
    """All characters that were made in this way."""
    there = [(answers[way], chances) for answers, chances in found if way in answers]
    asked = [each for answers, _ in there for each in answers]
    chance = (
        float(np.mean([each for _, chances in there for each in chances]))
        if there
        else float("nan")
    )
    return Answers(
        f"{way}, among real ones", tuple(each[1:] for each in asked), chance, luck_of_takes(asked)
    )
