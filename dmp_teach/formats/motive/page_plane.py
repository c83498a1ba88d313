"""The page: its plane and its frame, found in the writing itself.

Nobody told the cameras where the paper lay, and it was tilted by up to 29 degrees. While the pen
writes it stays near one plane; in the air it does not, and it is never under the paper.
"""

from __future__ import annotations

import numpy as np

from dmp_teach.errors import RecordingError
from dmp_teach.segmentation import find_strokes, lowpass_hertz, straightened
from dmp_teach.trajectory import Array

DIRECTIONS = {
    sign + axis: s * np.eye(3)[k]
    for sign, s in (("+", 1.0), ("-", -1.0))
    for k, axis in enumerate("xyz")
}
MARKER_WANDER = 0.004  # how far the marker strays from its plane while the pen is down [m]
LIKELY_SLOPE = 0.3  # papers are rarely steeper than this, which decides where the ink says little
SLOPE_WEIGHT = 0.02  # and how much that counts
STEEPEST_PAGE = np.radians(50)  # steeper than this, `up` was wrong
UNDER_PAPER = 0.010  # a pen is never this far under the paper [m]
SUNK_COST = 3.0  # of a share of the samples under the paper, beside one that is off it
# Another plane must cost this much less before `up` is doubted: a steep one, or one from below.
STEEP_COST = 0.35
FLIPPED_COST = 0.1
PLANE_DRAWS = 300
PLANE_REFITS = 3


def level_axes(up: str = "+y", right: str = "-x") -> Array:
    """Return the axes of a level page (3, 3): columns right, up the page, out of the paper.

    Args:
        up: The direction out of the paper, one of +x -x +y -y +z -z.
        right: The direction to the right on the page, not along `up`.

    Raises:
        RecordingError: Not such a direction, or both along one axis.
    """
    for name, value in (("up", up), ("right", right)):
        if not isinstance(value, str) or value not in DIRECTIONS:
            raise RecordingError(
                f"{name} is {value!r}, but must be one of {', '.join(map(repr, DIRECTIONS))}."
            )
    if up[1] == right[1]:
        raise RecordingError(
            f"up is {up!r} and right is {right!r}, but they must lie along two different axes."
        )
    return np.column_stack(
        [DIRECTIONS[right], np.cross(DIRECTIONS[up], DIRECTIONS[right]), DIRECTIONS[up]]
    )


def on_page(t: Array, points: Array, up: str = "+y", right: str = "-x") -> Array:
    """Return a pen in the frame of the page that it wrote on, z out of it, shape (T, 3) [m].

    The plane is first the one that most moving samples are near (RANSAC with fixed draws), then the
    one through the strokes that it gives. Where the ink says little (a single bar), the page is
    taken for level. The origin is some point of the plane. Arguments as `written`.

    Raises:
        RecordingError: Nothing was written, the directions cannot be, or the ink lies far from
            level.
    """
    level = level_axes(up, right)
    flat = straightened(t, points, least=UNDER_PAPER) @ level
    page = _laid(points, level, _near_best_plane(_moving(t, flat), level, up))
    for _ in range(PLANE_REFITS):
        ink = np.concatenate([flat[a:b] for a, b in find_strokes(t, page)])
        page = _laid(points, level, ink)
    return page


def _moving(t: Array, flat: Array) -> Array:
    """Return the samples that move (K, 3): a rest of seconds must not outvote the ink."""
    dt = float(np.median(np.diff(t)))
    speed = np.linalg.norm(np.gradient(lowpass_hertz(flat, dt, 10.0), t, axis=0), axis=1)
    return flat[speed >= 0.2 * np.sqrt(np.mean(speed**2))]


def _near_best_plane(flat: Array, level: Array, up: str) -> Array:
    """Return the samples (K, 3) near the plane that the fewest of them are off or under.

    Planes are level, or go through three samples drawn by lot, but always the same ones.

    Raises:
        RecordingError: A steep plane, or a gentle one from below, explains the samples far better.
    """
    a, b, c = flat[np.random.default_rng(0).integers(0, len(flat), (3, PLANE_DRAWS))]
    drawn = np.cross(b - a, c - a)
    length = np.linalg.norm(drawn, axis=1)
    heights = np.quantile(flat[:, 2], np.linspace(0, 0.6, 20))[:, None] * [0.0, 0.0, 1.0]
    points = np.vstack([heights, a[length > 0]])
    out = np.tile([0.0, 0.0, 1.0], (20, 1))
    normals = np.vstack([out, drawn[length > 0] / length[length > 0, None]])
    normals *= np.where(normals[:, 2:] < 0, -1.0, 1.0)
    miss = normals @ flat.T - (normals * points).sum(axis=1)[:, None]
    off = np.minimum((miss / MARKER_WANDER) ** 2, 1).mean(axis=1)
    cost, flipped = (off + SUNK_COST * (side * miss > UNDER_PAPER).mean(axis=1) for side in (-1, 1))
    is_gentle = normals[:, 2] > np.cos(STEEPEST_PAGE)
    others = np.where(is_gentle, flipped + FLIPPED_COST, np.minimum(cost, flipped) + STEEP_COST)
    other = int(np.argmin(others))
    if others[other] < cost[is_gentle].min():
        normal = level @ normals[other] * (1 if cost[other] < flipped[other] else -1)
        tilt = np.degrees(np.arccos(np.clip(normal @ DIRECTIONS[up], -1, 1)))
        best = max(DIRECTIONS, key=lambda name: float(normal @ DIRECTIONS[name]))
        opposite = {"+": "-", "-": "+"}[best[0]] + best[1]
        is_sure = abs(cost[other] - flipped[other]) > FLIPPED_COST
        raise RecordingError(
            f"The page lies {tilt:.0f} degrees from level, so up={up!r} cannot be right; try "
            f"up={best!r}{'' if is_sure else f' or {opposite!r}'}."
        )
    flatness = normals[:, 2]
    slope = np.sqrt(1 - np.minimum(flatness, 1) ** 2) / np.maximum(flatness, 1e-9)
    cost = np.where(is_gentle, cost + SLOPE_WEIGHT * (slope / LIKELY_SLOPE) ** 2, np.inf)
    return flat[np.abs(miss[np.argmin(cost)]) < MARKER_WANDER]


def _fit(flat: Array) -> tuple[Array, float]:
    """Fit a plane to samples (K, 3) of ink: its slopes (2,), and its height at the origin [m].

    Least squares along the two main directions of the ink. A direction in which the ink is hardly
    wider than the marker wanders says little, and its slope is drawn towards 0.
    """
    middle = flat.mean(axis=0)
    away = flat - middle
    _, spread, directions = np.linalg.svd(away[:, :2], full_matrices=False)
    along = away[:, :2] @ directions.T
    slopes = (along * away[:, 2:]).sum(axis=0) / np.maximum((along**2).sum(axis=0), 1e-12)
    wander = np.std(away[:, 2] - along @ slopes) / LIKELY_SLOPE
    slopes = directions.T @ (slopes * spread**2 / (spread**2 + len(flat) * wander**2 + 1e-12))
    return slopes, float(middle[2] - middle[:2] @ slopes)


def _laid(points: Array, level: Array, ink: Array) -> Array:
    """Return points (T, 3) of the cameras' world on the plane of samples (K, 3) of ink.

    Its right is the level page's right, laid down on the plane.
    """
    slopes, height = _fit(ink)
    out = np.array([-slopes[0], -slopes[1], 1.0])
    out /= np.linalg.norm(out)
    right = np.array([1.0, 0.0, 0.0]) - out[0] * out
    right /= np.linalg.norm(right)
    axes = level @ np.column_stack([right, np.cross(out, right), out])
    return (points - level @ np.array([0.0, 0.0, height])) @ axes
