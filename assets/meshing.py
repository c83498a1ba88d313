"""Closed triangle meshes from outlines: turned, lofted through sections, extruded with bevels."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

Array = NDArray[np.float64]
CREASE = np.cos(np.radians(50.0))  # faces that meet more sharply than this keep their edge


@dataclass(frozen=True, eq=False)
class Mesh:
    """Triangles, counter-clockwise seen from outside: vertices (V, 3) [m], faces (F, 3)."""

    vertices: Array
    faces: NDArray[np.int64]

    def __add__(self, other: "Mesh") -> "Mesh":
        """Both, side by side."""
        shifted = other.faces + len(self.vertices)
        return Mesh(np.vstack([self.vertices, other.vertices]), np.vstack([self.faces, shifted]))

    def at(self, *xyz: float) -> "Mesh":
        """Return the same, moved."""
        return Mesh(self.vertices + np.array(xyz), self.faces)

    def turned(self, axes: str) -> "Mesh":
        """Return the same with its axes renamed: "zxy" has the old z as x, x as y, y as z."""
        faces = self.faces if axes in ("xyz", "yzx", "zxy") else self.faces[:, ::-1]
        return Mesh(self.vertices[:, ["xyz".index(axis) for axis in axes]], faces)

    def mirrored(self, axis: str) -> "Mesh":
        """Return the same as in a mirror across that axis."""
        sign = np.where(np.arange(3) == "xyz".index(axis), -1.0, 1.0)
        return Mesh(self.vertices * sign, self.faces[:, ::-1])


def loft(rings: ArrayLike) -> Mesh:
    """Return a skin over rings (S, N, 3) of points, closed by a lid at each end."""
    rings = np.asarray(rings, dtype=float)
    count, around = rings.shape[:2]
    first = np.arange(count * around).reshape(count, around)
    a, b, c, d = first[:-1], np.roll(first, -1, 1)[:-1], first[1:], np.roll(first, -1, 1)[1:]
    sides = np.concatenate(
        [np.stack(corners, -1).reshape(-1, 3) for corners in ((a, b, d), (a, d, c))]
    )
    start, end = count * around, count * around + 1
    lids = [
        np.stack([np.full(around, start), np.roll(first[0], -1), first[0]], -1),
        np.stack([np.full(around, end), first[-1], np.roll(first[-1], -1)], -1),
    ]
    middles = rings[[0, -1]].mean(axis=1)
    return _outward(*_welded(np.vstack([rings.reshape(-1, 3), middles]), np.vstack([sides, *lids])))


def lathe(profile: Sequence[tuple[float, float]], around: int = 32) -> Mesh:
    """Return a profile of (radius, height) turned about z."""
    angles = np.arange(around) * 2 * np.pi / around
    circle = np.stack([np.cos(angles), np.sin(angles)], -1)
    return loft(
        [np.column_stack([radius * circle, np.full(around, height)]) for radius, height in profile]
    )


def superellipse(a: float, b: float, power: float = 2.0, around: int = 32) -> Array:
    """Return an outline (N, 2) between an ellipse (power 2) and a box (large power).

    Its half axes are a and b; the points crowd where it bends.
    """
    angles = np.arange(around) * 2 * np.pi / around
    c, s = np.round([np.cos(angles), np.sin(angles)], 12)
    return np.stack(
        [a * np.sign(c) * np.abs(c) ** (2 / power), b * np.sign(s) * np.abs(s) ** (2 / power)], -1
    )


def rounded(
    low: tuple[float, float], high: tuple[float, float], radii: Sequence[float], steps: int = 4
) -> Array:
    """Return a rectangle with round corners, counter-clockwise, shape (4 (steps + 1), 2)."""
    points = []
    for corner, radius in enumerate(np.broadcast_to(radii, 4)):
        sx, sy = ((1, 1), (-1, 1), (-1, -1), (1, -1))[corner]
        centre = np.array(
            [high[0] if sx > 0 else low[0], high[1] if sy > 0 else low[1]]
        ) - radius * np.array([sx, sy])
        angles = np.pi / 2 * (corner + np.linspace(0, 1, steps + 1))
        points.append(centre + radius * np.stack([np.cos(angles), np.sin(angles)], -1))
    return np.concatenate(points)


def extrude(outline: Array, profile: Sequence[tuple[float, float]]) -> Mesh:
    """Return an outline (N, 2) raised along z through (inset, height) [m]."""
    edge = np.roll(outline, -1, 0) - outline
    normal = np.stack([edge[:, 1], -edge[:, 0]], -1) / np.linalg.norm(edge, axis=1, keepdims=True)
    corner = normal + np.roll(normal, 1, 0)
    corner = corner / (0.5 * (corner**2).sum(axis=1, keepdims=True))
    return loft(
        [
            np.column_stack([outline - inset * corner, np.full(len(outline), h)])
            for inset, h in profile
        ]
    )


def sections(rows: Iterable[tuple[float, ...]], around: int = 32) -> Mesh:
    """Return a loft along x: rows of x, the middle's y and z, half width and height, a power."""
    rings = []
    for x, y, z, half_y, half_z, power in rows:
        outline = superellipse(half_y, half_z, power, around) + np.array([y, z])
        rings.append(np.column_stack([np.full(around, x), outline]))
    return loft(rings)


def shaded(mesh: Mesh) -> tuple[Array, Array, NDArray[np.int64]]:
    """Return vertices, normals and faces for drawing; corners are split at sharp edges."""
    faces, count = mesh.faces, len(mesh.faces)
    corners = mesh.vertices[faces]
    area = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    flat = area / np.linalg.norm(area, axis=1, keepdims=True)
    edges = np.stack([faces, np.roll(faces, -1, 1)], -1).reshape(-1, 2)
    order = np.lexsort(np.sort(edges, axis=1).T)
    key = np.sort(edges, axis=1)[order]
    pair = np.flatnonzero((key[1:] == key[:-1]).all(axis=1))
    one, two = order[pair], order[pair + 1]
    smooth = (flat[one // 3] * flat[two // 3]).sum(axis=1) > CREASE
    one, two = one[smooth], two[smooth]
    after_one, after_two = one - one % 3 + (one + 1) % 3, two - two % 3 + (two + 1) % 3
    joined = (np.concatenate([one, after_one]), np.concatenate([after_two, two]))
    graph = coo_array((np.ones(2 * len(one)), joined), shape=(3 * count, 3 * count))
    total, label = connected_components(graph, directed=False)
    normals = np.zeros((total, 3))
    np.add.at(normals, label, np.repeat(area, 3, axis=0))
    vertices = np.zeros((total, 3))
    vertices[label] = corners.reshape(-1, 3)
    return vertices, normals / np.linalg.norm(normals, axis=1, keepdims=True), label.reshape(-1, 3)


def write_obj(mesh: Mesh, path: Path) -> None:
    """Return a Wavefront file: hundredths of a millimetre, a normal for each vertex."""
    vertices, normals, faces = shaded(mesh)
    lines = ["# Made by make_fetch.py"]
    lines += [f"v {x:.5f} {y:.5f} {z:.5f}" for x, y, z in _settled(vertices, 5)]
    lines += [f"vn {x:.3f} {y:.3f} {z:.3f}" for x, y, z in _settled(normals, 3)]
    lines += ["f " + " ".join(f"{corner}//{corner}" for corner in face) for face in faces + 1]
    path.write_text("\n".join(lines) + "\n", encoding="ascii", newline="\n")


def _settled(values: Array, digits: int) -> Array:
    """Round in two steps, so that the last bit of a machine changes nothing; no minus zero."""
    return np.round(np.round(values, digits + 5), digits) + 0.0


def _welded(vertices: Array, faces: NDArray[np.int64]) -> tuple[Array, NDArray[np.int64]]:
    """Points at one place made one, and triangles without area dropped."""
    _, first, where = np.unique(
        np.round(vertices, 7) + 0.0, axis=0, return_index=True, return_inverse=True
    )
    faces = where.reshape(-1)[faces]
    keep = (faces != np.roll(faces, 1, axis=1)).all(axis=1)
    return vertices[first], faces[keep]


def _outward(vertices: Array, faces: NDArray[np.int64]) -> Mesh:
    """Turn a mesh inside out if its volume is negative."""
    a, b, c = vertices[faces].transpose(1, 0, 2)
    return Mesh(vertices, faces if (a * np.cross(b, c)).sum() > 0 else faces[:, ::-1])
