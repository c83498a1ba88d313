"""Read a URDF into values: joints, and the pieces of the shell."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations_with_replacement
from pathlib import Path
from typing import NamedTuple
from xml.etree import ElementTree as ET

import numpy as np
from numpy.typing import NDArray

from dmp_teach.robot.model.rotation import turn_about
from dmp_teach.trajectory import Array
from dmp_teach.values import Value


@dataclass(frozen=True, eq=False, repr=False)
class Joint(Value):
    """What holds a link to the one before it, and how it may move.

    Args:
        name: As in the URDF.
        type: "fixed", "revolute", "continuous" or "prismatic".
        parent: The link before.
        child: The link that moves.
        X_parent_joint: Pose of the child in the parent when the joint is at 0, shape (4, 4) [m].
        axis: Unit vector in the child's frame, shape (3,); the joint turns about it or slides along
            it.
        lower: Least position; minus infinity where there is none [rad or m].
        upper: Greatest position; infinity where there is none [rad or m].
        velocity: Greatest speed [rad/s or m/s].
        effort: Greatest torque or force [N m or N].
    """

    name: str
    type: str
    parent: str
    child: str
    X_parent_joint: Array
    axis: Array
    lower: float = -np.inf
    upper: float = np.inf
    velocity: float = np.inf
    effort: float = np.inf

    def pose(self, q: Array) -> Array:
        """Return the pose of the child in the parent at q (T,) [rad or m], shape (T, 4, 4)."""
        X = np.tile(self.X_parent_joint, (len(q), 1, 1))
        if self.type == "prismatic":
            X[:, :3, 3] += q[:, None] * (self.X_parent_joint[:3, :3] @ self.axis)
        elif self.type in ("revolute", "continuous"):
            X[:, :3, :3] = self.X_parent_joint[:3, :3] @ turn_about(self.axis, q)
        return X


class Body(NamedTuple):
    """What a link weighs: its mass [kg], the middle (3,) [m] and inertia (3, 3) [kg m^2] there.

    Both are in the link's axes.
    """

    mass: float
    centre: Array
    inertia: Array

    def seen_from(self, X: Array) -> Body:
        """Return it in other axes, in which its own have the pose X (4, 4)."""
        R = X[:3, :3]
        return Body(self.mass, R @ self.centre + X[:3, 3], R @ self.inertia @ R.T)

    @classmethod
    def joined(cls, parts: Sequence[Body]) -> Body:
        """Return bodies, all in the same axes, as one (the theorem of Steiner)."""
        mass = sum(part.mass for part in parts)
        centre = np.sum([part.mass * part.centre for part in parts], axis=0) / mass
        inertia = np.zeros((3, 3))
        for part in parts:
            d = part.centre - centre
            inertia += part.inertia + part.mass * (d @ d * np.eye(3) - np.outer(d, d))
        return cls(mass, centre, inertia)


@dataclass(frozen=True, eq=False, repr=False)
class Visual(Value):
    """A piece of a link's shell, of one colour.

    Args:
        link: The link that carries it.
        X_link_visual: Its pose in the link, shape (4, 4) [m].
        vertices: Corners, in the piece's own frame, shape (V, 3) [m].
        normals: The shell's outward direction at each corner, shape (V, 3).
        faces: Triangles by the numbers of their corners, counter-clockwise seen from outside, shape
            (F, 3).
        color: Red, green, blue, opacity between 0 and 1, shape (4,).
    """

    link: str
    X_link_visual: Array
    vertices: Array
    normals: Array
    faces: NDArray[np.int_]
    color: Array


def read_robot(path: Path) -> tuple[str, tuple[str, ...], tuple[Joint, ...]]:
    """Read the robot's name, links and joints, in the order of the file."""
    root = ET.parse(path).getroot()
    links = tuple(link.attrib["name"] for link in root.iter("link"))
    joints = tuple(_joint(element) for element in root.findall("joint"))
    return root.attrib.get("name", path.stem), links, joints


def read_bodies(path: Path) -> dict[str, Body]:
    """Read what each link weighs, those left out that weigh nothing."""
    found = {}
    for link in ET.parse(path).getroot().iter("link"):
        for element in link.findall("inertial"):
            (mass,) = _numbers(element.find("mass"), "value", "0")
            inertia = np.zeros((3, 3))
            for row, column in combinations_with_replacement(range(3), 2):
                axes = f"i{'xyz'[row]}{'xyz'[column]}"
                (moment,) = _numbers(element.find("inertia"), axes, "0")
                inertia[row, column] = inertia[column, row] = moment
            body = Body(float(mass), np.zeros(3), inertia)
            found[link.attrib["name"]] = body.seen_from(read_origin(element))
    return found


def read_visuals(path: Path) -> Iterator[Visual]:
    """Yield the pieces of the shell, their meshes read from beside the URDF."""
    for link in ET.parse(path).getroot().iter("link"):
        for piece in link.findall("visual"):
            (mesh,) = piece.iterfind("geometry/mesh")
            shell = read_obj(path.parent / mesh.attrib["filename"])
            color = _numbers(piece.find("material/color"), "rgba", "0.7 0.7 0.7 1")
            yield Visual(link.attrib["name"], read_origin(piece), *shell, color)


def _numbers(element: ET.Element | None, name: str, default: str) -> Array:
    """Return the numbers in an attribute of an element that may be absent."""
    return np.array(
        (default if element is None else element.attrib.get(name, default)).split(), dtype=float
    )


def read_origin(element: ET.Element) -> Array:
    """Read the pose in an <origin>: a place, and turns about the fixed x, y and z, in order."""
    found = element.find("origin")
    X = np.eye(4)
    for axis, angle in zip(np.eye(3), _numbers(found, "rpy", "0 0 0"), strict=True):
        X[:3, :3] = turn_about(axis, angle) @ X[:3, :3]
    X[:3, 3] = _numbers(found, "xyz", "0 0 0")
    return X


def _joint(element: ET.Element) -> Joint:
    """Read a <joint>."""
    parent, child = element.find("parent"), element.find("child")
    axis = _numbers(element.find("axis"), "xyz", "1 0 0")
    limit = element.find("limit")
    bounds = {} if limit is None else {key: float(value) for key, value in limit.attrib.items()}
    if element.attrib["type"] in ("revolute", "prismatic"):
        bounds = {"lower": 0.0, "upper": 0.0} | bounds
    return Joint(
        name=element.attrib["name"],
        type=element.attrib["type"],
        parent="" if parent is None else parent.attrib["link"],
        child="" if child is None else child.attrib["link"],
        X_parent_joint=read_origin(element),
        axis=axis / (np.linalg.norm(axis) or 1.0),
        **bounds,
    )


def read_obj(path: Path) -> tuple[Array, Array, NDArray[np.int_]]:
    """Read vertices (V, 3) [m], normals (V, 3), one for each, and triangles (F, 3) of Wavefront."""
    rows: dict[str, list[list[str]]] = {"v": [], "vn": [], "f": []}
    for line in path.read_text(encoding="utf-8").splitlines():
        kind, *values = line.split() or [""]
        if kind in rows:
            rows[kind].append(values)
    faces = [[int(corner.split("/")[0]) - 1 for corner in row] for row in rows["f"]]
    return np.array(rows["v"], dtype=float), np.array(rows["vn"], dtype=float), np.array(faces)
