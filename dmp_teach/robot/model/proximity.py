"""How near the arm comes to the robot's body, to its own parts and to what the page lies on."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from dmp_teach.robot.model.convex import ShapeRows, Shapes, measure_gaps, read_shapes
from dmp_teach.robot.model.kinematics import Model
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


# A span of samples is cut into so many pieces, down to one sample.
_PIECES = 8
# So many pairs of shapes are measured at once.
_BATCH = 20_000


class Near(NamedTuple):
    """A sample (row) at which the arm's `link` comes near to `other`, a link or "page" [m]."""

    row: int
    distance: float
    link: str
    other: str


class Proximity:
    """The distances between the arm's links and what each of them could meet.

    Args:
        joint_names: The J joints that move.
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
        self._model = Model.load()
        self._joint_names = joint_names
        links, shapes = read_shapes()
        self._shapes = shapes.grown(grown)
        reach = self._reach(links)
        if page is not None:
            links = (*links, "page")
            self._shapes = self._shapes.joined(_page_block(page, around))
            reach = np.vstack([reach, 0 * reach[:1]])
        self._links = tuple(dict.fromkeys(links))
        self._carriers = np.array([self._links.index(link) for link in links])
        self._met = np.array(_shape_pairs(links))
        self._named = [(links[one], links[other]) for one, other in self._met]
        self.pairs = tuple(dict.fromkeys(self._named))
        """The L pairs of a link and what it could meet."""
        self._firsts = [self._named.index(pair) for pair in self.pairs]
        reach = reach[self._met]
        # A joint that carries both does not bring them nearer to each other.
        self._sweep = np.where((reach > 0).all(axis=1), 0.0, reach.sum(axis=1))

    def distances(self, q: Array) -> Array:
        """Return the least distances of the `pairs` (T, L) [m], less than 0 where they overlap."""
        return self._least(q, np.inf)

    def touching(self, q: Array) -> list[list[tuple[str, str]]]:
        """Return those of the `pairs` that overlap at each row of q (T, J) [rad, m]."""
        overlaps = self._least(q, 0.0) < 0
        return [[self.pairs[number] for number in np.flatnonzero(row)] for row in overlaps]

    def approaches(self, q: Array, within: float) -> list[Near]:
        """Find every sample of q (T, J) at which a link is within [m] of what it could meet.

        In a span of samples a point moves no further than its distance from each joint times the
        turn of that joint: most spans are settled by the distances in their middle, only the others
        are cut into pieces. Only the pen may come near to the page.
        """
        pairs = np.array([n for n, pair in enumerate(self._named) if not _is_writing(*pair)])
        spans = np.zeros_like(pairs)
        length = _PIECES ** int(np.ceil(np.log(max(len(q), 2)) / np.log(_PIECES)))
        while True:
            rows = np.minimum(np.arange(-(-len(q) // length) * length), len(q) - 1)
            middles = rows[length // 2 :: length]
            turned = abs(q[rows].reshape(len(middles), length, -1) - q[middles, None]).max(axis=1)
            enough = within + (turned[spans] * self._sweep[pairs]).sum(axis=1)
            gaps = self._gaps(q, middles[spans], pairs, enough, length == 1)
            near = gaps < enough
            spans, pairs, gaps = spans[near], pairs[near], gaps[near]
            if length == 1:
                found = zip(spans, gaps, pairs, strict=True)
                return [Near(int(row), float(gap), *self._named[n]) for row, gap, n in found]
            length //= _PIECES
            spans = (_PIECES * spans[:, None] + np.arange(_PIECES)).ravel()
            inside = spans * length < len(q)
            spans, pairs = spans[inside], np.repeat(pairs, _PIECES)[inside]

    def _least(self, q: Array, enough: float) -> Array:
        """Return the least distances of the `pairs` (T, L), where they are not `enough` [m]."""
        rows, pairs = np.indices((len(q), len(self._named))).reshape(2, -1)
        gaps = self._gaps(q, rows, pairs, np.full(len(rows), enough), enough > 0)
        return np.minimum.reduceat(gaps.reshape(len(q), -1), self._firsts, axis=1)

    def _gaps(
        self, q: Array, rows: ShapeRows, pairs: ShapeRows, enough: Array, depth: bool
    ) -> Array:
        """Return the distances of some pairs of shapes, each at its row of q (N,) [m]."""
        used, rows = np.unique(rows, return_inverse=True)
        placed = self._placed(q[used])
        one, other = self._met[pairs].T + rows * len(self._carriers)
        gaps = np.empty(len(rows))
        for first in range(0, len(rows), _BATCH):
            some = slice(first, first + _BATCH)
            gaps[some] = measure_gaps(
                placed.take(one[some]), placed.take(other[some]), enough[some], depth
            )
        return gaps

    def _placed(self, q: Array) -> Shapes:
        """Return all shapes where they are at one row of q after the other (T G)."""
        poses = self._model.link_poses(q, self._joint_names)
        fixed = np.broadcast_to(np.eye(4), (len(q), 4, 4))
        X = np.stack([poses.get(link, fixed) for link in self._links], axis=1)
        every = np.tile(np.arange(len(self._carriers)), len(q))
        return self._shapes.take(every).moved(X[:, self._carriers].reshape(-1, 4, 4))

    def _reach(self, links: tuple[str, ...]) -> Array:
        """Return how far a unit of each joint moves a point of each shape at most, (G, J)."""
        carried = {joint.child: joint for joint in self._model.joints}
        far = np.linalg.norm(self._shapes.p, axis=1) + self._shapes.radius()
        reach = np.zeros((len(links), len(self._joint_names)))
        for number, link in enumerate(links):
            joint = carried.get(link)
            while joint is not None:
                if joint.name in self._joint_names:
                    column = self._joint_names.index(joint.name)
                    reach[number, column] = 1.0 if joint.type == "prismatic" else far[number]
                far[number] += np.linalg.norm(joint.X_parent_joint[:3, 3])
                joint = carried.get(joint.parent)
        return reach


def _page_block(page: Page, around: float) -> Shapes:
    """Return what a page lies on, fixed in the world."""
    half = np.array([page.width / 2 + around, page.height / 2 + around, _PAGE_DEPTH / 2])
    middle = page.to_world((0.0, 0.0, -_PAGE_DEPTH / 2))
    return Shapes(page.X_world_page[None, :3, :3], middle[None], half[None], *np.zeros((2, 1)))


def _is_writing(link: str, other: str) -> bool:
    """Whether it is the pen at the page."""
    return other == "page" and link.startswith("pen")


def _shape_pairs(links: tuple[str, ...]) -> list[tuple[int, int]]:
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
