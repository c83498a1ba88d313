"""How far boxes, cylinders and balls are from each other, for many pairs at once.

By the algorithm of Gilbert, Johnson and Keerthi (1988): the distance of two bodies is that of the
origin from the set of all differences of their points, and is found on triangles of that set whose
corners lie ever nearer. Where two bodies overlap, the direction in which they are apart the soonest
is searched for among many.
"""

from __future__ import annotations

from functools import lru_cache
from itertools import product
from typing import NamedTuple
from xml.etree import ElementTree as ET

import numpy as np
from numpy.typing import NDArray

from dmp_teach.files import ASSETS
from dmp_teach.robot.model.rotation import cross, inner, rotate
from dmp_teach.robot.model.urdf import read_origin
from dmp_teach.trajectory import Array

ShapeRows = NDArray[np.int_]

# As exact as a distance is, and so many steps to get there at most [m].
_EXACT = 1e-7
_STEPS = 50
# Half of the directions to the sides, edges and corners of a cube, shape (13, 3).
_AROUND = np.array([each for each in product((0, 1, -1), repeat=3) if each > (0, 0, 0)], float)
_AROUND /= np.linalg.norm(_AROUND, axis=1, keepdims=True)
# How often the best direction out is made better, by halves of the way to the next.
_HALVINGS = 12


class Shapes(NamedTuple):
    """N boxes (`half`), cylinders along z (`half` and `disc`) or balls (`ball`) in poses.

    Each is the sum of a box, a flat disc and a ball, two of which have no size.

    Args:
        R: Their axes, shape (N, 3, 3).
        p: Their middles, shape (N, 3) [m].
        half: Half the sides of the box, shape (N, 3) [m].
        disc: Radius of the disc, shape (N,) [m].
        ball: Radius of the ball, shape (N,) [m].
    """

    R: Array
    p: Array
    half: Array
    disc: Array
    ball: Array

    def take(self, rows: ShapeRows) -> Shapes:
        """Return some of them, in this order."""
        return Shapes(*(each[rows] for each in self))

    def joined(self, more: Shapes) -> Shapes:
        """Return them and some more."""
        return Shapes(*map(np.concatenate, zip(self, more, strict=True)))

    def grown(self, by: float) -> Shapes:
        """Return them larger on every side [m]."""
        half = np.where(self.half > 0, self.half + by, 0.0)
        disc = np.where(self.disc > 0, self.disc + by, 0.0)
        return self._replace(half=half, disc=disc, ball=np.where(self.ball > 0, self.ball + by, 0))

    def radius(self) -> Array:
        """Return the radii of the balls around them, shape (N,) [m]."""
        flat = np.hypot(self.half[:, 0], self.half[:, 1]) + self.disc
        return np.hypot(flat, self.half[:, 2]) + self.ball

    def moved(self, X: Array) -> Shapes:
        """Return them carried by frames in poses (N, 4, 4)."""
        R = X[:, :3, :3]
        return self._replace(R=R @ self.R, p=rotate(R, self.p) + X[:, :3, 3])


@lru_cache(maxsize=1)
def read_shapes() -> tuple[tuple[str, ...], Shapes]:
    """Return the links of the robot's collision shapes (N), and the shapes in their links."""
    links, poses, sizes = [], [], []
    for link in ET.parse(ASSETS / "fetch.urdf").getroot().iter("link"):
        for element in link.findall("collision"):
            links.append(link.attrib["name"])
            poses.append(read_origin(element))
            size = [0.0] * 5
            for box in element.iterfind("geometry/box"):
                size[:3] = [float(side) / 2 for side in box.attrib["size"].split()]
            for cylinder in element.iterfind("geometry/cylinder"):
                size[2] = float(cylinder.attrib["length"]) / 2
                size[3] = float(cylinder.attrib["radius"])
            for sphere in element.iterfind("geometry/sphere"):
                size[4] = float(sphere.attrib["radius"])
            sizes.append(size)
    X, all_sizes = np.array(poses), np.array(sizes)
    half, disc, ball = all_sizes[:, :3], all_sizes[:, 3], all_sizes[:, 4]
    return tuple(links), Shapes(X[:, :3, :3], X[:, :3, 3], half, disc, ball)


def measure_gaps(one: Shapes, other: Shapes, enough: Array, depth: bool = True) -> Array:
    """Return the distances of N pairs (N,) [m], less than 0 where they overlap.

    Of a pair that is farther apart than `enough` (N,) it is only said that it is. Without `depth`
    all that overlap are -inf apart.
    """
    far = np.maximum(_beside(one, other), _beside(other, one))
    rows = np.flatnonzero(far < enough)
    one, other = one.take(rows), other.take(rows)
    balls = one.ball + other.ball
    pairs = _Pairs.between(one, other)
    gaps = _from_origin(pairs, enough[rows] + balls)
    inside = np.flatnonzero(gaps == 0)
    gaps[inside] = _escape(pairs.take(inside)) if depth else -np.inf
    far[rows] = gaps - balls
    return far


class _Pairs(NamedTuple):
    """Pairs of shapes without their balls, seen from the first: all differences of their points."""

    R: Array
    p: Array
    half: Array
    disc: Array
    other_half: Array
    other_disc: Array

    @classmethod
    def between(cls, one: Shapes, other: Shapes) -> _Pairs:
        back = np.swapaxes(one.R, 1, 2)
        p = rotate(back, other.p - one.p)
        return cls(back @ other.R, p, one.half, one.disc, other.half, other.disc)

    def take(self, rows: ShapeRows) -> _Pairs:
        """Return some of them."""
        return _Pairs(*(each[rows] for each in self))

    def nearest(self, v: Array) -> Array:
        """Return the difference (N, 3) that goes least far along v (N, 3)."""
        seen = rotate(np.swapaxes(self.R, 1, 2), v)
        farthest = _corner(seen, self.other_half, self.other_disc)
        return -_corner(v, self.half, self.disc) - self.p - rotate(self.R, farthest)


def _corner(v: Array, half: Array, disc: Array) -> Array:
    """Return the points of shapes that are farthest along v (N, 3), shape (N, 3)."""
    point = np.copysign(half, v)
    flat = np.sqrt(v[:, 0] ** 2 + v[:, 1] ** 2)
    point[:, :2] += v[:, :2] * (disc / np.maximum(flat, 1e-300))[:, None]
    return point


def _from_origin(pairs: _Pairs, enough: Array) -> Array:
    """Return how far the differences are from the origin (N,), 0 where it is one of them."""
    found = np.zeros(len(enough))
    rows = np.arange(len(enough))
    v = pairs.nearest(-pairs.p)
    corners = np.repeat(v[:, None], 3, axis=1)
    low = np.full(len(rows), -np.inf)
    for _ in range(_STEPS):
        size = np.sqrt(inner(v, v))
        new = pairs.nearest(v)
        low = np.maximum(low, inner(v, new) / np.maximum(size, 1e-300))
        found[rows] = size
        inside = _holds_origin(corners, new) | (size < 1e-9)
        found[rows[inside]] = 0.0
        on = np.flatnonzero(~inside & (size - low > _EXACT) & (low < enough))
        if not len(on):
            break
        rows, low, enough, pairs = rows[on], low[on], enough[on], pairs.take(on)
        corners, v = _closest(corners[on], new[on])
    return found


def _holds_origin(corners: Array, new: Array) -> NDArray[np.bool_]:
    """Return whether the origin is in tetrahedra of triangles (N, 3, 3) and points (N, 3)."""
    a, b, c = np.moveaxis(corners, 1, 0)
    ab = cross(a, b)
    sides = np.stack([inner(ab, new), inner(cross(b, c), new), inner(cross(c, a), new)], axis=1)
    whole = -inner(ab, c)
    return ((sides > 0).all(axis=1) & (whole > 0)) | ((sides < 0).all(axis=1) & (whole < 0))


def _closest(corners: Array, new: Array) -> tuple[Array, Array]:
    """Return the triangle of each tetrahedron that comes nearest to the origin, and its point.

    Only those at the new corner (N, 3) can be nearer than the triangle (N, 3, 3) was.
    """
    w = np.repeat(new[:, None], 3, axis=1)
    next_corners = corners[:, [1, 2, 0]]
    a, b = corners - w, next_corners - w
    aa, bb, ab = inner(a, a), inner(b, b), inner(a, b)
    wa, wb = -inner(w, a), -inner(w, b)
    along = np.clip(wa / np.maximum(aa, 1e-300), 0, 1)
    area = aa * bb - ab * ab
    flat = area <= 1e-14 * aa * bb
    area = np.where(flat, 1.0, area)
    s, t = (bb * wa - ab * wb) / area, (aa * wb - ab * wa) / area
    outside = flat | (s < 0) | (t < 0) | (s + t > 1)
    points = np.concatenate([w + along[..., None] * a, w + s[..., None] * a + t[..., None] * b], 1)
    far = inner(points, points)
    far[:, 3:][outside] = np.inf
    best = far.argmin(axis=1)
    n = np.arange(len(new))
    second = np.where((best < 3)[:, None], new, next_corners[n, best % 3])
    return np.stack([corners[n, best % 3], second, new], axis=1), points[n, best]


def _escape(pairs: _Pairs) -> Array:
    """Return how far shapes that overlap must move to be apart, as a negative distance (N,).

    The way out is often along a side of one, or across an edge of each; others lie between.
    """
    axes = np.swapaxes(pairs.R, 1, 2)
    across = np.cross(np.eye(3)[:, None], axes[:, None]).reshape(-1, 9, 3)
    sides = np.concatenate([axes, across, np.broadcast_to(_AROUND, (len(axes), 13, 3))], axis=1)
    best, way = _best(pairs, np.concatenate([sides, -sides], axis=1))
    around = np.concatenate([_AROUND, -_AROUND])
    for wide in 0.5 ** np.arange(1, _HALVINGS):
        found, better = _best(pairs, way[:, None] + wide * around)
        way = np.where((found > best)[:, None], better, way)
        best = np.maximum(found, best)
    return best


def _best(pairs: _Pairs, ways: Array) -> tuple[Array, Array]:
    """Return how far apart the shapes are along the best of directions (N, K, 3), and which."""
    # The cross product of parallel axes is no way.
    length = np.linalg.norm(ways, axis=2, keepdims=True)
    ways = np.where(length > 1e-6, ways / np.maximum(length, 1e-6), [0.0, 0.0, 1.0])
    rows = np.repeat(np.arange(len(ways)), ways.shape[1])
    flat = ways.reshape(-1, 3)
    apart = inner(pairs.take(rows).nearest(flat), flat).reshape(ways.shape[:2])
    best = apart.argmax(axis=1)
    n = np.arange(len(ways))
    return apart[n, best], ways[n, best]


def _beside(one: Shapes, other: Shapes) -> Array:
    """Return less than the distance of each pair: from the first to the ball around the second."""
    beyond = rotate(np.swapaxes(one.R, 1, 2), other.p - one.p)
    beyond = np.maximum(np.abs(beyond) - one.half, 0)
    flat = np.maximum(np.hypot(beyond[:, 0], beyond[:, 1]) - one.disc, 0)
    return np.hypot(flat, beyond[:, 2]) - one.ball - other.radius()
