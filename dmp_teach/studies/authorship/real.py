"""Can writers be told apart at all? Real letters, each given to the writer whose other letters are nearest."""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import Executor
from typing import Any

import numpy as np

from dmp_teach.scoring import letter_distances, measure_movement, resample, to_strokes
from dmp_teach.studies.authorship.answers import Answers, Attributions, luck_of
from dmp_teach.studies.inputs import Written, letters_of
from dmp_teach.studies.parallel import Progress, run
from dmp_teach.trajectory import Array, Trajectory

AGAIN = 0.01  # a take that is nearer to another than this is the same take: two by one hand are 0.05 to 0.3 apart
POINTS = 128  # over all the ink, for a signature
DIRECTIONS = 12  # in which half a turn is parted
TAKES, SHAPE, HAND = "other takes", "other letters, by shape", "other letters, by movement"


def classify_writers(
    recordings: Any = None, *, executor: Executor | None = None, progress: Progress | None = None
) -> Attributions:
    """Real letters given to writers by the nearest neighbour, each left out of what it is compared with.

    "other takes", where a writer has several of a letter: the nearest of all other takes of that letter by anybody, by
    `letter_distance(upright=False)`, in which lean counts, and size and place do not.

    "other letters, by shape": the writer whose other letters have the nearest signature. A signature is how a letter
    differs from the mean of everybody's same letter in the directions of its ink (an edge-direction distribution,
    Bulacu and Schomaker 2007), and in the lean and the width to height of its ellipse of inertia: what different
    letters share. The three count alike.

    "other letters, by movement": the same with slant, size, pace and unevenness of pace (`hand`), no shape at all.

    Args:
        recordings: Recordings, files or strokes; None takes our own alphabets.
        executor: Any `concurrent.futures.Executor`; a piece of work is one letter with all its takes.
        progress: Called as `progress(done, total)`.

    Raises:
        LetterError: A letter that is not flat, or all in one place.
    """
    letters = letters_of(recordings)
    groups = [
        [each for each in letters if each.character == c]
        for c in dict.fromkeys(x.character for x in letters)
    ]
    looked = run(_looked_at, groups, executor, progress)
    return Attributions(
        (_by_takes(looked), _by_letters(SHAPE, looked, 2), _by_letters(HAND, looked, 3))
    )


def hand(strokes: Sequence[Trajectory]) -> Array:
    """Slant, log of size [m], log of pace [m/s], unevenness of pace, shape (4,)."""
    movement = measure_movement(strokes)
    speed = np.concatenate(
        [np.linalg.norm(np.diff(s.position, axis=0), axis=1) / np.diff(s.t) for s in strokes]
    )
    size = max(movement.width, movement.height)
    slant = np.tan(np.radians(movement.slant))
    return np.array(
        [slant, np.log(size), np.log(movement.pace), speed.std() / max(speed.mean(), 1e-12)]
    )


def signature(strokes: Sequence[Trajectory]) -> Array:
    """Square roots of how much ink goes in each direction, then lean and log of width to height, shape (14,)."""
    ink = resample(strokes, POINTS)
    place, along = ink.points, ink.directions
    middles = (np.arange(DIRECTIONS) + 0.5) * np.pi / DIRECTIONS
    turn = np.angle(np.exp(2j * (np.arctan2(along[:, 1], along[:, 0])[:, None] - middles))) / 2
    share = np.exp(-0.5 * (turn * DIRECTIONS / np.pi) ** 2)
    share = (share / share.sum(axis=1, keepdims=True)).mean(axis=0)
    (wide, both), (_, high) = np.cov(place.T)
    floor = 1e-6 * (wide + high)
    return np.concatenate(
        [np.sqrt(share), [both / max(high, floor), np.log(max(wide, floor) / max(high, floor)) / 2]]
    )


def fresh(takes: Sequence[Written]) -> list[Written]:
    """One writer's takes of one letter, without those that are in it twice, such as one take exported in two ways.

    Raises:
        LetterError: A letter that is not flat, or all in one place.
    """
    for each in takes:
        to_strokes(each.strokes, each.name)
    far = (
        letter_distances(*[[each.strokes for each in takes]] * 2, upright=False)
        if len(takes) > 1
        else np.ones((1, 1))
    )
    return [take for k, take in enumerate(takes) if k == 0 or far[k, :k].min() >= AGAIN]


def _looked_at(
    letters: Sequence[Written],
) -> tuple[list[str], Array, dict[str, Array], dict[str, Array]]:
    """One letter with all its takes: whose, their distances, and every writer's mean signature and hand."""
    whose = dict.fromkeys(letter.writer for letter in letters)
    of = {
        w: [each.strokes for each in fresh([letter for letter in letters if letter.writer == w])]
        for w in whose
    }
    far = letter_distances(
        *[[strokes for takes in of.values() for strokes in takes]] * 2, upright=False
    )
    shapes = {
        writer: np.mean([signature(each) for each in takes], axis=0) for writer, takes in of.items()
    }
    hands = {
        writer: np.mean([hand(each) for each in takes], axis=0) for writer, takes in of.items()
    }
    marks = _scaled(shapes, (slice(0, -2), slice(-2, -1), slice(-1, None)))
    names = [writer for writer, takes in of.items() for _ in takes]
    return names, far, marks, _scaled(hands, [slice(k, k + 1) for k in range(4)])


def _scaled(rows: dict[str, Array], parts: Sequence[slice]) -> dict[str, Array]:
    """Every writer's difference from the mean, each part divided by its spread over the writers."""
    x = np.array(list(rows.values()))
    x = x - x.mean(axis=0)
    for part in parts:
        x[:, part] /= max(float(np.sqrt((x[:, part] ** 2).sum(axis=1).mean())), 1e-9)
    return dict(zip(rows, x, strict=True))


def _by_takes(looked: Sequence[tuple]) -> Answers:
    """The nearest other take of the same letter."""
    whose, nearest, strata, asked, chance = [], [], [], [], []
    for number, (names, far, _, _) in enumerate(looked):
        if len(set(names)) < 2:
            continue
        first = len(whose)
        nearest += list(first + np.argmin(far + np.diag(np.full(len(far), np.inf)), axis=1))
        asked += [first + k for k, name in enumerate(names) if names.count(name) > 1]
        chance += [
            (names.count(name) - 1) / (len(names) - 1) for name in names if names.count(name) > 1
        ]
        whose += names
        strata += [number] * len(names)
    name, near = np.array(whose), np.array(nearest, dtype=int)
    items = tuple((whose[k], whose[near[k]]) for k in asked)
    if not items:
        return Answers(TAKES, (), float("nan"), 1.0)

    def hits(order: np.ndarray) -> int:
        return int((name[order] == name[order][near]).sum())

    return Answers(TAKES, items, float(np.mean(chance)), luck_of(hits, strata))


def _by_letters(question: str, looked: Sequence[tuple], which: int) -> Answers:
    """The nearest writer by the mean signature of his other letters."""
    of = [each[which] for each in looked if len(each[which]) > 1]
    writers = [
        w for w in sorted({w for each in of for w in each}) if sum(w in each for each in of) > 1
    ]
    marks = [
        (n, writers.index(w), mark)
        for n, each in enumerate(of)
        for w, mark in each.items()
        if w in writers
    ]
    if len(writers) < 2:
        return Answers(question, (), float("nan"), 1.0)
    strata, whose = np.array([n for n, _, _ in marks]), np.array([w for _, w, _ in marks])
    x = np.array([mark for _, _, mark in marks])
    named = _nearest(x, strata, whose)
    items = tuple((writers[w], writers[k]) for w, k in zip(whose, named, strict=True))

    def hits(order: np.ndarray) -> int:
        return int((_nearest(x, strata, whose[order]) == whose[order]).sum())

    return Answers(question, items, 1 / len(writers), luck_of(hits, strata))


def _nearest(x: Array, strata: np.ndarray, whose: np.ndarray) -> np.ndarray:
    """Whose mean over all other letters is nearest to each mark x (M, F), if these writers made them, shape (M,)."""
    marks = np.zeros((strata.max() + 1, whose.max() + 1, x.shape[1]))
    there = np.zeros(marks.shape[:2])
    marks[strata, whose], there[strata, whose] = x, 1.0
    others = there.sum(axis=0) - there
    means = (marks.sum(axis=0) - marks) / np.maximum(others, 1)[:, :, None]
    far = ((means[strata] - x[:, None]) ** 2).sum(axis=2)
    return np.argmin(np.where(others[strata] > 0, far, np.inf), axis=1)
