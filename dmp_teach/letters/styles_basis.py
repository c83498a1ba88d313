"""Letters of one class learned alike, so that weights add up: the same strokes and kernels."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

import numpy as np
import scipy

from dmp_teach.dmp import DMP, TRANSFORMATIONS, Settings, as_settings
from dmp_teach.errors import LetterError, SettingError
from dmp_teach.letters.letter import Letter
from dmp_teach.scoring import match_strokes
from dmp_teach.trajectory import Array, Trajectory, all_points

# Lifts are kept as logarithms, so none is shorter than this [s].
LEAST_LIFT = 1e-3
# A letter that is wider than this many times its height is measured by its width.
WIDEST_BY_HEIGHT = 4


def learn_alike(
    letters: Sequence[Letter], settings: Settings | None = None, same_size: bool = True
) -> list[Letter]:
    """Learn letters again with the same order of strokes, kernels, samples and stiffness.

    The fit is linear in the demonstration where these agree, so the mean of such letters' weights
    draws the mean of the letters. Their middles are moved together, and their heights scaled to the
    geometric mean unless size is kept.

    Raises:
        LetterError: Fewer than two letters, or letters that are not made of the same strokes.
        SettingError: The original transformation, whose weights mean something else every time.
    """
    settings = as_settings(settings)
    if not TRANSFORMATIONS[settings.transform].weights_fit_any_goal:
        raise SettingError(
            f"Letters cannot be blended with transform={settings.transform!r}: its weights are "
            "divided by each letter's own way from start to goal. Use Settings.star()."
        )
    if len(letters) < 2:
        raise LetterError(
            f"A style is what several letters share, but got {len(letters)}; give at least 2."
        )
    ordered = [_reordered(letter, letters[0], number) for number, letter in enumerate(letters)]
    ink = _superposed(ordered, same_size)
    shown, learned = [], []
    for strokes in zip(*ink, strict=True):
        mean = float(np.mean([stroke.duration for stroke in strokes]))
        samples = max(len(stroke) for stroke in strokes)
        common = settings.resolved(mean, samples)
        shown.append([_resampled(stroke, samples) for stroke in strokes])
        learned.append([DMP.imitate(stroke, common) for stroke in shown[-1]])
    return list(map(Letter, zip(*shown, strict=True), zip(*learned, strict=True)))


def letter_to_row(letter: Letter) -> Array:
    """Return a letter as a row of numbers in which its rollout is linear but for time, (P,).

    Of each stroke the weights, biases, start, goal and start velocity times duration [m]; then the
    logarithms of all durations, and of the lifts [s].
    """
    parts = [part.ravel() for p in letter.primitives for part in _linear_parts(p)]
    lifts = [max(b.t[0] - a.t[-1], LEAST_LIFT) for a, b in pairwise(letter.strokes)]
    return np.concatenate([*parts, np.log([p.duration for p in letter.primitives]), np.log(lifts)])


def letter_from_row(row: Array, kind: Letter) -> Letter:
    """Return the letter that a row (P,) stands for, with the kernels and settings of `kind`."""
    count, primitives, begin = len(kind.primitives), [], 0.0
    clock = np.exp(row[len(row) - 2 * count + 1 :])
    durations, lifts = clock[:count], np.append(clock[count:], 0.0)
    for primitive, duration, lift in zip(kind.primitives, durations, lifts, strict=True):
        values, row = _split_off(row, _linear_parts(primitive))
        *forcing, start, goal, velocity = values
        changed = replace(
            primitive,
            weights=forcing[0],
            biases=forcing[1] if len(forcing) > 1 else None,
            start=start,
            goal=goal,
            start_velocity=velocity / duration,
            duration=float(duration),
            times=begin + np.linspace(0, duration, len(primitive.times)),
            notes=(),
        )
        primitives.append(changed)
        begin += duration + lift
    return Letter(tuple(p.rollout() for p in primitives), tuple(primitives))


def _linear_parts(primitive: DMP) -> list[Array]:
    """Return what of a primitive is blended."""
    p = primitive
    forcing = [p.weights] if p.biases is None else [p.weights, p.biases]
    return [*forcing, p.start, p.goal, p.start_velocity * p.duration]


def _split_off(row: Array, like: Sequence[Array]) -> tuple[list[Array], Array]:
    """Return arrays of these shapes from the beginning of a row, and the rest of it."""
    found = []
    for part in like:
        found.append(row[: part.size].reshape(part.shape))
        row = row[part.size :]
    return found, row


def _reordered(letter: Letter, first: Letter, number: int) -> tuple[Trajectory, ...]:
    """Return the strokes of a letter in the order and direction of the first letter's."""
    match = match_strokes(letter.strokes, first.strokes)
    merged = any(len(pair.strokes) + len(pair.others) > 2 for pair in match.pairs)
    if match.extra or match.missing or merged:
        raise LetterError(
            f"Letter {number} has {len(letter.strokes)} stroke{'s' * (len(letter.strokes) > 1)} "
            f"and letter 0 has {len(first.strokes)}, and they are not the same parts. Blend "
            "letters that are made of the same strokes, in any order."
        )
    found, begin = [], 0.0
    pauses = [b.t[0] - a.t[-1] for a, b in pairwise(letter.strokes)]
    for pair, pause in zip(match.pairs, [*pauses, 0.0], strict=True):
        stroke = letter.strokes[pair.strokes[0]]
        path = stroke.position[::-1] if pair.alignment.backwards else stroke.position
        t = stroke.t[-1] - stroke.t[::-1] if pair.alignment.backwards else stroke.t - stroke.t[0]
        found.append(Trajectory(begin + t, path))
        begin += stroke.duration + max(pause, LEAST_LIFT)
    return tuple(found)


def _superposed(
    letters: Sequence[Sequence[Trajectory]], same_size: bool
) -> list[tuple[Trajectory, ...]]:
    """Return the letters moved to their mean middle and, if wanted, scaled to their mean size."""
    boxes = np.array([(p.min(axis=0), p.max(axis=0)) for p in map(all_points, letters)])
    middles, (wide, high) = boxes.mean(axis=1), (boxes[:, 1] - boxes[:, 0]).T
    sizes = np.maximum(high, wide / WIDEST_BY_HEIGHT)
    factors = np.exp(np.log(sizes).mean()) / sizes if same_size else np.ones(len(sizes))
    place = middles.mean(axis=0)
    return [
        tuple(Trajectory(s.t, place + factor * (s.position - middle)) for s in strokes)
        for strokes, middle, factor in zip(letters, middles, factors, strict=True)
    ]


def _resampled(stroke: Trajectory, samples: int) -> Trajectory:
    """Return a stroke at `samples` even times."""
    t = np.linspace(stroke.t[0], stroke.t[-1], samples)
    return Trajectory(t, scipy.interpolate.PchipInterpolator(stroke.t, stroke.position)(t))
