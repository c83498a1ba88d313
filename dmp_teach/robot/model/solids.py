"""How near the arm comes to the robot's own body and to what the page lies on, from simple solids. No PlaCo needed."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache, reduce
from itertools import product
from xml.etree import ElementTree as ET

import numpy as np

from dmp_teach.files import ASSETS
from dmp_teach.robot.model.urdf import origin
from dmp_teach.robot.page import Page
from dmp_teach.trajectory import Array, locked

_SPACING = 0.03
"""Points on the arm's surface lie about this far apart [m]."""

_BODY = (
    "base_link",
    "torso_fixed_link",
    "torso_lift_link",
    "head_pan_link",
    "head_tilt_link",
    "shoulder_pan_link",
)
_ARM = ("shoulder_lift", "upperarm_roll", "elbow_flex", "forearm_roll", "wrist_flex", "wrist_roll")
_HAND = ("gripper_link", "r_gripper_finger_link", "l_gripper_finger_link", "pen_link", "pen_tip")
_MOVING = (*(f"{name}_link" for name in _ARM), *_HAND)

_UNDER = 0.7
"""What the page lies on is this thick [m]: a table down to the floor, a board and its wall."""


@dataclass(frozen=True, eq=False)
class Solid:
    """A box, cylinder or sphere that stands for a part of a link.

    Args:
        link: The link that carries it.
        kind: "box", "cylinder" (along its z) or "sphere".
        size: Three sides, or radius and length, or radius [m].
        X_link_solid: Its pose in the link, shape (4, 4) [m].
    """

    link: str
    kind: str
    size: Array
    X_link_solid: Array

    def __post_init__(self) -> None:
        """Lock the arrays."""
        object.__setattr__(self, "size", locked(self.size))
        object.__setattr__(self, "X_link_solid", locked(self.X_link_solid))

    def distance(self, points: Array) -> Array:
        """How far points (..., 3) of the solid's frame are from its surface, less than 0 inside, shape (...) [m]."""
        return _distance(self.kind, self.size, points)

    def surface(self) -> Array:
        """Points all over the surface, in the link's frame, shape (P, 3) [m]."""
        if self.kind == "sphere":
            points = self.size[0] * np.vstack([np.eye(3), -np.eye(3)])
        elif self.kind == "box":
            ticks = [
                np.linspace(-side / 2, side / 2, 1 + int(np.ceil(side / _SPACING)))
                for side in self.size
            ]
            points = np.array(list(product(*ticks)))
            points = points[(np.abs(points) >= self.size / 2 - 1e-12).any(axis=1)]
        else:
            radius, length = self.size
            turns = (
                np.arange(max(6, int(np.ceil(2 * np.pi * radius / _SPACING)))) * _SPACING / radius
            )
            turns *= 2 * np.pi / (len(turns) * _SPACING / radius)
            ticks = np.linspace(-length / 2, length / 2, 1 + int(np.ceil(length / _SPACING)))
            points = [(radius * np.cos(a), radius * np.sin(a), z) for a, z in product(turns, ticks)]
            points = np.array([*points, (0, 0, ticks[0]), (0, 0, ticks[-1])])
        return points @ self.X_link_solid[:3, :3].T + self.X_link_solid[:3, 3]


@lru_cache(maxsize=4)
def solids_of(urdf: str = "fetch.urdf") -> tuple[Solid, ...]:
    """The solids of all links of a robot among the assets."""
    found = []
    for link in ET.parse(ASSETS / urdf).getroot().iter("link"):
        for element in link.findall("collision"):
            (shape,) = element.find("geometry")
            names = {"box": ("size",), "cylinder": ("radius", "length"), "sphere": ("radius",)}[
                shape.tag
            ]
            size = [float(number) for name in names for number in shape.attrib[name].split()]
            found.append(Solid(link.attrib["name"], shape.tag, size, origin(element)))
    return tuple(found)


def bare_urdf(grown: float) -> str:
    """The robot's URDF without shells, and with solids only where the arm could touch, `grown` on every side [m]."""
    root = ET.parse(ASSETS / "fetch.urdf").getroot()
    solid = (
        "base",
        "torso",
        "head",
        "shoulder",
        "upperarm",
        "elbow",
        "forearm",
        "wrist",
        "gripper_link",
    )
    for link in root.iter("link"):
        for kind in ("visual", "collision"):
            for element in link.findall(kind):
                if kind == "visual" or not link.attrib["name"].startswith(solid):
                    link.remove(element)
    for sides in ("radius", "length", "size"):
        for element in root.iterfind(f".//collision/geometry/*[@{sides}]"):
            more = grown if sides == "radius" else 2 * grown
            element.set(
                sides,
                " ".join(f"{float(side) + more:.6g}" for side in element.attrib[sides].split()),
            )
    return ET.tostring(root, encoding="unicode")


class Clearances:
    """The distances between each part of the arm and each part of the body, and the arm's own other parts.

    Args:
        page: What the arm must not go through, with `around` of it on every side; None: nothing but itself.
        around: How far what the page lies on is thought to go beyond the page [m].
    """

    def __init__(self, page: Page | None = None, around: float = 0.0) -> None:
        self._points, self._solids, self.pairs = _points(), dict(_solids_by_link()), list(_pairs())
        if page is not None:
            size = (page.width + 2 * around, page.height + 2 * around, _UNDER)
            under = np.eye(4)
            under[2, 3] = -_UNDER / 2
            self._solids["page"] = [Solid("page", "box", size, page.X_world_page @ under)]
            self.pairs += [(link, "page") for link in _MOVING[1:]]
        self.page = [number for number, (_, other) in enumerate(self.pairs) if other == "page"]

    def __call__(self, poses: Mapping[str, Array]) -> Array:
        """The least distance of each pair, less than 0 where they overlap.

        Args:
            poses: X_world_link of every link, each of shape (T, 4, 4) [m]: see `Model.link_poses`.

        Returns:
            Distances, shape (T, P) for P `pairs` [m].
        """
        return np.column_stack([self.apart(number, poses) for number in range(len(self.pairs))])

    def apart(self, number: int, poses: Mapping[str, Array]) -> Array:
        """The least distance of one of the `pairs`, shape (T,) [m]: from points on the link to the other's solids."""
        link, other = self.pairs[number]
        away = [
            solid.distance(_moved(X @ poses[link], self._points[link])).min(axis=1)
            for solid, X in zip(self._solids[other], self._seen_from(other, poses), strict=True)
        ]
        return np.min(away, axis=0)

    def at_least(self, poses: Mapping[str, Array], centres: Array) -> Array:
        """Less than the least distance of each pair, quickly: to the ball around its link, shape (T, P) [m].

        Args:
            poses: X_world_link of every link, each of shape (T, 4, 4) [m].
            centres: Of the `balls`, in the world, shape (T, L, 3) [m].
        """
        links, _, radii = balls()
        solids = [solid for each in self._solids.values() for solid in each]
        poses = {**poses, "page": np.broadcast_to(np.eye(4), (len(centres), 4, 4))}
        X = np.stack([poses[solid.link] for solid in solids], axis=1) @ [
            solid.X_link_solid for solid in solids
        ]
        spots = (centres[:, None] - X[:, :, None, :3, 3]) @ X[..., :3, :3]
        far = np.empty(spots.shape[:3])
        for kind in ("box", "cylinder", "sphere"):
            alike = [number for number, solid in enumerate(solids) if solid.kind == kind]
            sizes = np.array([solids[number].size for number in alike])[:, None]
            far[:, alike] = _distance(kind, sizes, spots[:, alike])
        firsts = np.cumsum([0, *map(len, self._solids.values())])[:-1]
        nearest = np.minimum.reduceat(far, firsts, axis=1) - radii
        others = list(self._solids)
        return nearest[
            :,
            *np.transpose([(others.index(other), links.index(link)) for link, other in self.pairs]),
        ]

    def _seen_from(self, other: str, poses: Mapping[str, Array]) -> list[Array]:
        """The world seen from each of a link's solids, each of shape (T, 4, 4), or (1, 4, 4) where it stands still."""
        X = np.eye(4)[None] if other == "page" else poses[other]
        X = X if X.strides[0] else X[:1]
        return [_undone(X @ solid.X_link_solid) for solid in self._solids[other]]


@lru_cache(maxsize=1)
def balls() -> tuple[tuple[str, ...], Array, Array]:
    """A ball around each link that moves: the links' names, its centre in the link (L, 3) and its radius (L,) [m]."""
    points = _points()
    centres = [(each.min(axis=0) + each.max(axis=0)) / 2 for each in points.values()]
    radii = [
        np.linalg.norm(each - centre, axis=1).max()
        for each, centre in zip(points.values(), centres, strict=True)
    ]
    return tuple(points), locked(centres), locked(radii)


@lru_cache(maxsize=1)
def _solids_by_link() -> dict[str, list[Solid]]:
    """The solids of each link that counts."""
    return {
        link: [solid for solid in solids_of() if solid.link == link] for link in (*_BODY, *_MOVING)
    }


@lru_cache(maxsize=1)
def _pairs() -> tuple[tuple[str, str], ...]:
    """A link that moves, and a link that it could meet."""
    return tuple(
        (link, other) for link in _MOVING for other in (*_BODY, *_MOVING) if _may_meet(link, other)
    )


@lru_cache(maxsize=1)
def _points() -> dict[str, Array]:
    """Points all over the surface of each link that moves, in its frame, each of shape (P, 3) [m]."""
    return {
        link: np.concatenate([solid.surface() for solid in solids_of() if solid.link == link])
        for link in _MOVING
    }


def _may_meet(link: str, other: str) -> bool:
    """Whether two links could meet: neighbours always do, and the hand and the pen are one."""
    chain = ("shoulder_pan_link", *_MOVING[: len(_ARM)])
    if other not in _MOVING and other not in chain:
        return True
    place = {name: number for number, name in enumerate(chain)} | dict.fromkeys(_HAND, len(chain))
    return place[link] - place[other] > 1


def _distance(kind: str, size: Array, points: Array) -> Array:
    """See `Solid.distance`; sizes (..., k) and points (..., 3) may be of many solids of a kind."""
    x, y, z = np.moveaxis(points, -1, 0)
    if kind == "sphere":
        return np.sqrt(x * x + y * y + z * z) - size[..., 0]
    if kind == "box":
        beyond = [np.abs(along) - size[..., axis] / 2 for axis, along in enumerate((x, y, z))]
    else:
        beyond = [np.sqrt(x * x + y * y) - size[..., 0], np.abs(z) - size[..., 1] / 2]
    outside = np.sqrt(sum(np.maximum(each, 0) ** 2 for each in beyond))
    return outside + np.minimum(reduce(np.maximum, beyond), 0)


def _undone(X: Array) -> Array:
    """The inverses of poses (T, 4, 4)."""
    back = np.zeros_like(X)
    back[:, :3, :3] = X[:, :3, :3].transpose(0, 2, 1)
    back[:, :3, 3] = -np.einsum("tij,tj->ti", back[:, :3, :3], X[:, :3, 3])
    back[:, 3, 3] = 1
    return back


def _moved(X: Array, points: Array) -> Array:
    """Points (P, 3) under poses (T, 4, 4), shape (T, P, 3)."""
    return points @ X[:, :3, :3].transpose(0, 2, 1) + X[:, None, :3, 3]
