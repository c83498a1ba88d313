"""How near the arm comes to the robot's body, to its own parts and to what the page lies on.

Distances of boxes, cylinders and spheres are coal's, which PlaCo brings with pinocchio.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, NamedTuple

import numpy as np

from dmp_teach.robot.model.reduced import load_pinocchio, load_reduced_robot
from dmp_teach.robot.page import Page
from dmp_teach.trajectory import Array

_PAGE_DEPTH = 0.7
"""What the page lies on is this thick [m]: a table down to the floor, a board and its wall."""

_BODY = (
    "base_link",
    "torso_fixed_link",
    "torso_lift_link",
    "head_pan_link",
    "head_tilt_link",
    "shoulder_pan_link",
)
_ARM = tuple(
    f"{name}_link"
    for name in (
        "shoulder_lift",
        "upperarm_roll",
        "elbow_flex",
        "forearm_roll",
        "wrist_flex",
        "wrist_roll",
    )
)
_HAND = ("gripper_link", "r_gripper_finger_link", "l_gripper_finger_link", "pen_link", "pen_tip")


class Near(NamedTuple):
    """A sample (row) at which the arm's `link` comes near to `other`, a link or "page" [m]."""

    row: int
    distance: float
    link: str
    other: str


class Proximity:
    """The distances between the arm's links and what each of them could meet.

    Args:
        joint_names: The J joints that move, as for `ReducedRobot`.
        page: What the arm must not go through; None: nothing but the robot itself.
        around: How far what the page lies on goes on beyond the page [m].
        grown: By how much each shape is larger than it is, on every side [m].
    """

    def __init__(
        self,
        joint_names: tuple[str, ...],
        page: Page | None = None,
        around: float = 0.0,
        grown: float = 0.0,
    ) -> None:
        self._pinocchio = pinocchio = load_pinocchio()
        self._robot = load_reduced_robot(joint_names)
        self._geometry = self._robot.geometry.copy()
        if grown:
            for shape in self._geometry.geometryObjects:
                shape.geometry = _grow(shape.geometry, grown)
        links = list(self._robot.links)
        if page is not None:
            self._geometry.addGeometryObject(_page_block(page, around))
            links.append("page")
        pairs = _shape_pairs(links)
        for one, other in pairs:
            self._geometry.addCollisionPair(pinocchio.CollisionPair(one, other))
        self._named = [(links[one], links[other]) for one, other in pairs]
        self.pairs = tuple(dict.fromkeys(self._named))
        """The L pairs of a link and what it could meet."""
        self._firsts = [self._named.index(pair) for pair in self.pairs]
        reach = self._reach()[np.array(pairs)]
        # A joint that carries both does not bring them nearer to each other.
        self._sweep = np.where((reach > 0).all(axis=1), 0.0, reach.sum(axis=1))
        self._data = self._robot.model.createData()
        self._found = pinocchio.GeometryData(self._geometry)

    def distances(self, q: Array) -> Array:
        """Return the least distances of the `pairs` (T, L) [m], less than 0 where they overlap."""
        found = [
            self._at(moment, range(len(self._named))) for moment in self._robot.configurations(q)
        ]
        return np.minimum.reduceat(np.array(found), self._firsts, axis=1)

    def touching(self, q: Array) -> list[tuple[str, str]]:
        """Return those of the `pairs` that overlap at joint positions q (J,) [rad, m]."""
        overlap = self.distances(q[None])[0] < 0
        return [pair for pair, overlaps in zip(self.pairs, overlap, strict=True) if overlaps]

    def approaches(self, q: Array, within: float) -> list[Near]:
        """Find every sample of q (T, J) at which a link is within [m] of what it could meet.

        In a span of samples a point moves no further than its distance from each joint times the
        turn of that joint: most spans are settled by the distances in their middle, only the others
        are halved. Only the pen may come near to the page.
        """
        counts = [
            number
            for number, (link, other) in enumerate(self._named)
            if not (other == "page" and link.startswith("pen"))
        ]
        near = []
        configurations = self._robot.configurations(q)
        spans = [(np.arange(len(q)), np.array(counts))]
        while spans:
            rows, pairs = spans.pop()
            middle = len(rows) // 2
            row = rows[middle]
            distances = self._at(configurations[row], pairs)
            for pair in np.flatnonzero(distances < within):
                near.append(Near(int(row), float(distances[pair]), *self._named[pairs[pair]]))
            turned = np.abs(q[rows] - q[row]).max(axis=0)
            doubtful = pairs[distances - self._sweep[pairs] @ turned < within]
            halves = (rows[:middle], rows[middle + 1 :])
            spans += [(half, doubtful) for half in halves if len(half) and len(doubtful)]
        return near

    def _at(self, configuration: Array, pairs: Iterable[int]) -> Array:
        """Return the distances of some pairs of shapes in one configuration [m]."""
        measure = self._pinocchio.computeDistance
        self._pinocchio.updateGeometryPlacements(
            self._robot.model, self._data, self._geometry, self._found, configuration
        )
        return np.array([measure(self._geometry, self._found, int(n)).min_distance for n in pairs])

    def _reach(self) -> Array:
        """Return how far a unit of each joint moves a point of each shape at most, (G, J)."""
        model = self._robot.model
        reach = np.zeros((self._geometry.ngeoms, len(self._robot.joint_ids)))
        for number, shape in enumerate(self._geometry.geometryObjects):
            shape.geometry.computeLocalAABB()
            middle = shape.placement.act(shape.geometry.aabb_center)
            far = np.linalg.norm(middle) + shape.geometry.aabb_radius
            joint = shape.parentJoint
            while joint:
                slides = model.joints[joint].shortname().startswith("JointModelP")
                reach[number, self._robot.joint_ids.index(joint)] = 1.0 if slides else far
                far += np.linalg.norm(model.jointPlacements[joint].translation)
                joint = model.parents[joint]
        return reach


# Any: coal has no types.
def _grow(shape: Any, by: float) -> Any:
    """Return one of coal's shapes, larger on every side [m]."""
    import coal  # noqa: PLC0415

    if isinstance(shape, coal.Box):
        return coal.Box(*(2 * (shape.halfSide + by)))
    if isinstance(shape, coal.Cylinder):
        return coal.Cylinder(shape.radius + by, 2 * (shape.halfLength + by))
    return coal.Sphere(shape.radius + by)


def _page_block(page: Page, around: float) -> Any:
    """Return what a page lies on, as pinocchio's geometry, fixed in the world."""
    import coal  # noqa: PLC0415

    pinocchio = load_pinocchio()
    size = (page.width + 2 * around, page.height + 2 * around, _PAGE_DEPTH)
    middle = page.to_world((0.0, 0.0, -_PAGE_DEPTH / 2))
    X = pinocchio.SE3(page.X_world_page[:3, :3], middle)
    return pinocchio.GeometryObject("page", 0, X, coal.Box(*size))


def _shape_pairs(links: list[str]) -> list[tuple[int, int]]:
    """Return the numbers of shapes that could meet, those of a pair of links together."""
    moving = (*_ARM, *_HAND)
    met = [(link, other) for link in moving for other in (*_BODY, *moving)]
    met = [pair for pair in met if _may_meet(*pair)]
    met += [(link, "page") for link in moving[1:]]
    shapes = {link: [n for n, each in enumerate(links) if each == link] for link in links}
    return [
        (one, another)
        for link, other in met
        for one in shapes[link]
        for another in shapes.get(other, ())
    ]


def _may_meet(link: str, other: str) -> bool:
    """Whether two links could meet: neighbours always do, and the hand and the pen are one."""
    chain = ("shoulder_pan_link", *_ARM)
    place = {name: number for number, name in enumerate(chain)}
    place |= dict.fromkeys(_HAND, len(chain))
    return other not in place or place[link] - place[other] > 1
