"""Letters of one class learned alike, so that their weights can be added: the same strokes, kernels and samples."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise
from typing import Any

import numpy as np
from scipy.interpolate import PchipInterpolator

from dmp_teach.dmp import DMP, Settings, as_settings
from dmp_teach.errors import LetterError, SettingError
from dmp_teach.letters.letter import Letter
from dmp_teach.scoring import match_strokes
from dmp_teach.trajectory import Array, Trajectory

_SHORTEST_LIFT = 1e-3  # [s]
_FLAT = 4  # a letter that is so many times as wide as high is measured by its width


def learned_alike(
    letters: Sequence[Letter], settings: Settings | None = None, same_size: bool = True
) -> list[Letter]:
    """The letters learned again with the same strokes in the same order, kernels, samples and stiffness.

    The fit is linear in the demonstration wherever these agree, so the mean of such letters' weights draws the mean of
    the letters. Their middles are moved together, and their heights made equal (to the geometric mean), or kept.

    Args:
        letters: At least two, of one class.
        settings: `Settings.star()` unless given.
        same_size: Whether size is taken away.

    Raises:
        LetterError: Fewer than two letters, or letters that are not made of the same strokes.
        SettingError: The original transformation, in which a weight means something else for every letter.
    """
    settings = as_settings(settings)
    if settings.transform == "original":
        raise SettingError(
            "Letters cannot be blended with transform='original': its weights are divided by each letter's own way "
            "from start to goal. Use Settings.star()."
        )
    if len(letters) < 2:
        raise LetterError(
            f"A style is what several letters share, but got {len(letters)}; give at least 2."
        )
    ink = _together(
        [_ordered(letter, letters[0], number) for number, letter in enumerate(letters)], same_size
    )
    found = []
    for strokes in zip(*ink, strict=True):
        mean = float(np.mean([stroke.duration for stroke in strokes]))
        samples = max(len(stroke) for stroke in strokes)
        common = settings.resolved(mean, samples)
        found.append([DMP.imitate(_resampled(stroke, samples), common) for stroke in strokes])
    return [
        Letter(strokes, primitives)
        for strokes, primitives in zip(ink, zip(*found, strict=True), strict=True)
    ]


def row_of(letter: Letter) -> Array:
    """A letter as one row of numbers, in which what it draws is linear but for its clock, shape (P,).

    Of each stroke the weights, biases, start, goal and start velocity times duration [m]; then the logarithms of all
    durations, and of the lifts [s].
    """
    parts = [part.ravel() for p in letter.primitives for part in _parts(p)]
    lifts = [max(b.t[0] - a.t[-1], _SHORTEST_LIFT) for a, b in pairwise(letter.strokes)]
    return np.concatenate([*parts, np.log([p.duration for p in letter.primitives]), np.log(lifts)])


def letter_of(row: Array, kind: Letter) -> Letter:
    """The letter that a row stands for.

    Args:
        row: Shape (P,).
        kind: Any letter that was learned alike: its kernels, samples and settings.
    """
    count, primitives, begin = len(kind.primitives), [], 0.0
    clock = np.exp(row[len(row) - 2 * count + 1 :])
    durations, lifts = clock[:count], np.append(clock[count:], 0.0)
    for primitive, duration, lift in zip(kind.primitives, durations, lifts, strict=True):
        values, row = _taken(row, _parts(primitive))
        *forcing, start, goal, way = values
        times = begin + np.linspace(0, duration, len(primitive.times))
        weights, biases = (*forcing, None)[:2]
        change = {
            "weights": weights,
            "biases": biases,
            "start": start,
            "goal": goal,
            "start_velocity": way / duration,
        }
        primitives.append(
            replace(primitive, **change, duration=float(duration), times=times, notes=())
        )
        begin += duration + lift
    return Letter(tuple(p.rollout() for p in primitives), tuple(primitives))


def path_of(letter: Letter) -> Array:
    """All that a letter draws, at its own samples, shape (Q, 2) [m]."""
    return np.concatenate([p.rollout().position for p in letter.primitives])


def _parts(primitive: DMP) -> list[Array]:
    """What of a primitive is blended."""
    forcing = (
        [primitive.weights] if primitive.biases is None else [primitive.weights, primitive.biases]
    )
    return [
        *forcing,
        primitive.start,
        primitive.goal,
        primitive.start_velocity * primitive.duration,
    ]


def _taken(row: Array, like: Sequence[Array]) -> tuple[list[Array], Array]:
    """Arrays of these shapes from the beginning of a row, and the rest of it."""
    found = []
    for part in like:
        found.append(row[: part.size].reshape(part.shape))
        row = row[part.size :]
    return found, row


def _ordered(letter: Letter, first: Letter, number: int) -> tuple[Trajectory, ...]:
    """The strokes of a letter in the order and direction of the first letter's; its own clock is given to them."""
    match = match_strokes(letter.strokes, first.strokes)
    pairs = match.pairs
    if (
        match.extra
        or match.missing
        or any(len(pair.strokes) + len(pair.others) > 2 for pair in pairs)
    ):
        raise LetterError(
            f"Letter {number} has {len(letter.strokes)} stroke{'s' * (len(letter.strokes) > 1)} and letter 0 has "
            f"{len(first.strokes)}, and they are not the same parts. Blend letters that are made of the same strokes, "
            "in any order."
        )
    found, begin = [], 0.0
    pauses = [b.t[0] - a.t[-1] for a, b in pairwise(letter.strokes)]
    for pair, pause in zip(pairs, [*pauses, 0.0], strict=True):
        stroke = letter.strokes[pair.strokes[0]]
        path = stroke.position[::-1] if pair.alignment.backwards else stroke.position
        t = stroke.t[-1] - stroke.t[::-1] if pair.alignment.backwards else stroke.t - stroke.t[0]
        found.append(Trajectory(begin + t, path))
        begin += stroke.duration + max(pause, _SHORTEST_LIFT)
    return tuple(found)


def _together(
    letters: Sequence[Sequence[Trajectory]], same_size: bool
) -> list[tuple[Trajectory, ...]]:
    """The letters moved to their mean middle and, if asked, scaled to their mean size."""
    boxes = np.array([_box(strokes) for strokes in letters])
    middles, (wide, high) = boxes.mean(axis=1), (boxes[:, 1] - boxes[:, 0]).T
    sizes = np.maximum(high, wide / _FLAT)
    factors = np.exp(np.log(sizes).mean()) / sizes if same_size else np.ones(len(sizes))
    place = middles.mean(axis=0)
    return [
        tuple(Trajectory(s.t, place + factor * (s.position - middle)) for s in strokes)
        for strokes, middle, factor in zip(letters, middles, factors, strict=True)
    ]


def _box(strokes: Sequence[Trajectory]) -> Array:
    """Lower left and upper right corner of the ink, shape (2, 2) [m]."""
    points = np.concatenate([stroke.position for stroke in strokes])
    return np.array([points.min(axis=0), points.max(axis=0)])


def _resampled(stroke: Trajectory, samples: int) -> Trajectory:
    """A stroke at so many even times."""
    t = np.linspace(stroke.t[0], stroke.t[-1], samples)
    return Trajectory(t, PchipInterpolator(stroke.t, stroke.position)(t))


def as_letter(given: Any) -> Letter:
    """A letter, learned unless it is one already."""
    return given if isinstance(given, Letter) else Letter.learn(given)
