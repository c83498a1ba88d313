"""Real letters, each attributed to the writer whose other letters are nearest."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from dmp_teach.scoring import letter_distances, measure_movement, resample, to_strokes
from dmp_teach.studies.authorship.answers import Answers, Attributions, permutation_luck
from dmp_teach.studies.inputs import RecordingsLike, Written, list_letters
from dmp_teach.studies.parallel import Progress, run
from dmp_teach.trajectory import Array, Trajectory

# A take nearer to another than this is the same take: two by one hand are 0.05 to 0.3 apart.
SAME_TAKE_DISTANCE = 0.01
# Over all the ink of a signature, and the bins of half a turn.
SIGNATURE_POINTS = 128
DIRECTION_BINS = 12
BY_TAKES = "other takes"
BY_SHAPE = "other letters, by shape"
BY_MOVEMENT = "other letters, by movement"

Indices = NDArray[np.int_]
Marks = dict[str, Array]
"""A row of features for each writer."""


def classify_writers(
    recordings: RecordingsLike = None,
    *,
    executor: Executor | None = None,
    progress: Progress | None = None,
) -> Attributions:
    """Attribute real letters to writers by the nearest neighbour, each left out of its neighbours.

    "other takes", where a writer has several of a letter: the nearest of all other takes of that
    letter by anybody, by `letter_distance(upright=False)`, in which lean counts, and size and place
    do not.

    "other letters, by shape": the writer whose other letters have the nearest signature. A
    signature is how a letter differs from the mean of everybody's same letter in the directions of
    its ink (an edge-direction distribution, Bulacu and Schomaker 2007), and in the lean and the
    width to height of its ellipse of inertia: what different letters share. The three count alike.

    "other letters, by movement": the same with slant, size, pace and unevenness of pace, no shape.

    Args:
        recordings: Recordings, files or strokes; None takes our own alphabets.
        executor: As in `claims`; a piece is one letter with its takes.
        progress: As in `claims`.

    Raises:
        LetterError: A letter that is not flat, or all in one place.
    """
    groups: dict[str, list[Written]] = {}
    for letter in list_letters(recordings):
        groups.setdefault(letter.character, []).append(letter)
    found = run(_compare_takes, groups.values(), executor, progress)
    by_shape = _by_letters(BY_SHAPE, [each.shapes for each in found])
    by_movement = _by_letters(BY_MOVEMENT, [each.movements for each in found])
    return Attributions((_by_takes(found), by_shape, by_movement))


@dataclass(frozen=True, eq=False)
class _Takes:
    """One letter with its takes: whose (T,), their distances (T, T), and every writer's marks."""

    whose: list[str]
    distances: Array
    shapes: Marks
    movements: Marks


def movement_features(strokes: Sequence[Trajectory]) -> Array:
    """Return slant, log of size [m], log of pace [m/s], unevenness of pace, shape (4,)."""
    movement = measure_movement(strokes)
    speed = np.concatenate(
        [np.linalg.norm(np.diff(s.position, axis=0), axis=1) / np.diff(s.t) for s in strokes]
    )
    size = max(movement.width, movement.height)
    slant = np.tan(np.radians(movement.slant))
    return np.array(
        [slant, np.log(size), np.log(movement.pace), speed.std() / max(speed.mean(), 1e-12)]
    )


def shape_features(strokes: Sequence[Trajectory]) -> Array:
    """Return square roots of ink by direction, lean and log of width to height, shape (14,)."""
    ink = resample(strokes, SIGNATURE_POINTS)
    place, along = ink.points, ink.directions
    middles = (np.arange(DIRECTION_BINS) + 0.5) * np.pi / DIRECTION_BINS
    turn = np.angle(np.exp(2j * (np.arctan2(along[:, 1], along[:, 0])[:, None] - middles))) / 2
    share = np.exp(-0.5 * (turn * DIRECTION_BINS / np.pi) ** 2)
    share = (share / share.sum(axis=1, keepdims=True)).mean(axis=0)
    (wide, both), (_, high) = np.cov(place.T)
    floor = 1e-6 * (wide + high)
    lean = both / max(high, floor)
    ratio = np.log(max(wide, floor) / max(high, floor)) / 2
    return np.concatenate([np.sqrt(share), [lean, ratio]])


def distinct_takes(takes: Sequence[Written]) -> list[Written]:
    """Return one writer's takes of one letter without repeats, such as one exported in two ways."""
    for each in takes:
        to_strokes(each.strokes, each.name)
    if len(takes) < 2:
        return list(takes)
    ink = [each.strokes for each in takes]
    far = letter_distances(ink, ink, upright=False)
    return [
        take for k, take in enumerate(takes) if k == 0 or far[k, :k].min() >= SAME_TAKE_DISTANCE
    ]


def _compare_takes(letters: Sequence[Written]) -> _Takes:
    """Return what is compared of one letter with all its takes."""
    takes: dict[str, list[tuple[Trajectory, ...]]] = {}
    for writer in dict.fromkeys(letter.writer for letter in letters):
        own = distinct_takes([letter for letter in letters if letter.writer == writer])
        takes[writer] = [each.strokes for each in own]
    ink = [strokes for own in takes.values() for strokes in own]
    shape_parts = [slice(0, -2), slice(-2, -1), slice(-1, None)]
    return _Takes(
        [writer for writer, own in takes.items() for _ in own],
        letter_distances(ink, ink, upright=False),
        _scaled_means(takes, shape_features, shape_parts),
        _scaled_means(takes, movement_features, [slice(k, k + 1) for k in range(4)]),
    )


def _scaled_means(
    takes: Mapping[str, Sequence[Sequence[Trajectory]]],
    features: Callable[[Sequence[Trajectory]], Array],
    parts: Sequence[slice],
) -> Marks:
    """Return writers' mean features less everybody's mean, each part divided by its spread."""
    rows = {w: np.mean([features(each) for each in own], axis=0) for w, own in takes.items()}
    x = np.array(list(rows.values()))
    x = x - x.mean(axis=0)
    for part in parts:
        x[:, part] /= max(float(np.sqrt((x[:, part] ** 2).sum(axis=1).mean())), 1e-9)
    return dict(zip(rows, x, strict=True))


def _by_takes(found: Sequence[_Takes]) -> Answers:
    """Return the answers by the nearest other take of the same letter."""
    whose: list[str] = []
    nearest: list[int] = []
    strata: list[int] = []
    repeated: list[int] = []
    chance: list[float] = []
    for number, takes in enumerate(found):
        names, far = takes.whose, takes.distances
        if len(set(names)) < 2:
            continue
        first = len(whose)
        nearest += list(first + np.argmin(far + np.diag(np.full(len(far), np.inf)), axis=1))
        for k, name in enumerate(names):
            if names.count(name) > 1:
                repeated.append(first + k)
                chance.append((names.count(name) - 1) / (len(names) - 1))
        whose += names
        strata += [number] * len(names)
    names_of, near = np.array(whose), np.array(nearest, dtype=int)
    items = tuple((whose[k], whose[near[k]]) for k in repeated)
    if not items:
        return Answers(BY_TAKES, (), float("nan"), 1.0)

    def hits(order: Indices) -> int:
        return int((names_of[order] == names_of[order][near]).sum())

    return Answers(BY_TAKES, items, float(np.mean(chance)), permutation_luck(hits, strata))


def _by_letters(question: str, found: Sequence[Marks]) -> Answers:
    """Return the answers by the nearest mean of writers' marks over all other letters."""
    several = [marks for marks in found if len(marks) > 1]
    everybody = sorted({writer for marks in several for writer in marks})
    writers = [w for w in everybody if sum(w in marks for marks in several) > 1]
    if len(writers) < 2:
        return Answers(question, (), float("nan"), 1.0)
    rows = [
        (number, writers.index(writer), mark)
        for number, marks in enumerate(several)
        for writer, mark in marks.items()
        if writer in writers
    ]
    strata, whose = (np.array([row[k] for row in rows], dtype=int) for k in (0, 1))
    x = np.array([mark for _, _, mark in rows])
    named = _nearest(x, strata, whose)
    items = tuple((writers[w], writers[k]) for w, k in zip(whose, named, strict=True))

    def hits(order: Indices) -> int:
        return int((_nearest(x, strata, whose[order]) == whose[order]).sum())

    return Answers(question, items, 1 / len(writers), permutation_luck(hits, strata.tolist()))


def _nearest(x: Array, strata: Indices, whose: Indices) -> Indices:
    """Return whose mean over other letters is nearest to each mark x (M, F), shape (M,)."""
    marks = np.zeros((strata.max() + 1, whose.max() + 1, x.shape[1]))
    there = np.zeros(marks.shape[:2])
    marks[strata, whose], there[strata, whose] = x, 1.0
    others = there.sum(axis=0) - there
    means = (marks.sum(axis=0) - marks) / np.maximum(others, 1)[:, :, None]
    far = ((means[strata] - x[:, None]) ** 2).sum(axis=2)
    return np.argmin(np.where(others[strata] > 0, far, np.inf), axis=1)
