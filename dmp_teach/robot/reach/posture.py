"""How the arm stands at a page, if it can: judged by where the pen really ends up, from several postures.

PlaCo never says that a page is out of reach; its answer is then a wrong pose, up to 0.8 m off.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import islice

import numpy as np

from dmp_teach.robot.arm import Solver
from dmp_teach.robot.model.proximity import plain
from dmp_teach.robot.model.solids import Solid
from dmp_teach.robot.page import Page
from dmp_teach.robot.pen_path import HOVER
from dmp_teach.trajectory import Array, locked

TIP = 0.0003
"""The pen's tip must come this near to where it should be [m]."""

TILT = np.radians(1.0)
"""The pen must stand this upright on the paper [rad]."""

SWIFT = 0.6
"""As fast as a hand writes [m/s]."""

# Torso, shoulder pan and lift, upper arm's roll, elbow, forearm's roll, wrist flex and roll [m, rad]. The elbow is
# out: straight ahead, the joints need many times their speed.
_TABLE = (0.386, -0.11, -0.45, -0.37, 1.53, -1.39, -0.88, 0.82)
_BOARD = (0.17, -0.47, 0.04, 1.44, 1.59, -0.78, -1.56, -0.92)
_MIRROR = (1, -1, 1, -1, 1, -1, 1, -1)
POSTURES = locked([_TABLE, np.multiply(_TABLE, _MIRROR), _BOARD, np.multiply(_BOARD, _MIRROR)])
"""Where the search for a stance starts, and then from a few random postures, shape (4, J)."""

STRAINED = 2.5
"""A stance that asks more than this of a joint's speed limit is nearly stretched out."""

_COMFORTABLE = 1.6  # of a joint's limit, at SWIFT in the worst place: good enough to stop looking
_STOP = 0.02  # this near to its stop a joint is at it [rad], and then ...
_JAMMED = STRAINED - 0.01  # ... the effort is at least this
_FEW = 9  # postures are tried where the arm is stretched out ...
_RANDOM = (
    25  # ... and these as well where it cannot stand: near the body one in ten finds a way past it
)
_CLEAR = 0.055  # the forearm's radius, and a little [m]
_FOREARM = (
    "elbow_flex_link",
    "forearm_roll_link",
    "wrist_flex_link",
    "wrist_roll_link",
    "gripper_link",
)
_CHAIN = (
    "torso_lift",
    "shoulder_pan",
    "shoulder_lift",
    "upperarm_roll",
    *(name[:-5] for name in _FOREARM),
)
_BULK = {  # where no page can lie: solids that stand upright, and their middles in the world [m]
    Solid("base_link", "cylinder", (0.29, 0.38), np.eye(4)): (0.0, 0.0, 0.19),
    Solid("torso_fixed_link", "box", (0.36, 0.36, 0.95), np.eye(4)): (-0.09, 0.0, 0.775),
}
_BODY = ("base", "torso_fixed", "torso_lift", "head_pan", "head_tilt")


@dataclass(frozen=True, eq=False)
class Stance:
    """How the arm stands over the middle of the ink.

    Args:
        q: Joint positions there, shape (J,) [rad, m]; the torso stays as it is here.
        middle: The middle, on the page, shape (3,) [m].
        effort: The greatest speed of a joint as a part of its limit where a pen at `SWIFT` asks most of it.
        trouble: Why the arm cannot write here; empty where it can.
        notes: What the writer should know.
        collides: Whether the trouble is that the arm touches the robot or what the page lies on.
    """

    q: Array
    middle: Array
    effort: float
    trouble: str = ""
    notes: tuple[str, ...] = ()
    collides: bool = False


def examined(solver: Solver, page: Page, low: Array, high: Array, quick: bool = False) -> Stance:
    """The verdict on a part of a page from `low` to `high` (2,); a page is examined once.

    A quick one knows fewer postures: it may find trouble where there is none, and never the other way round.
    """
    key = (*(part.tobytes() for part in (page.X_world_page, page.size, low, high)), quick)
    if key not in solver.verdicts:
        if len(solver.verdicts) > 200:
            solver.verdicts.clear()
        solver.verdicts[key] = _examine(solver, page, low, high, _FEW if quick else None)
    return solver.verdicts[key]


def _examine(solver: Solver, page: Page, low: Array, high: Array, most: int | None) -> Stance:
    """The first comfortable stance, or the one that asks least of the joints, or what the trouble is."""
    best = None
    if trouble := in_the_body(page):
        return Stance(POSTURES[0], np.zeros(3), np.inf, trouble)
    for number, posture in enumerate(islice(_postures(solver, page), most)):
        stance = _tried(solver, posture, page, low, high)
        if best is None or (bool(stance.trouble), stance.effort) < (
            bool(best.trouble),
            best.effort,
        ):
            best = stance
        if not best.trouble and (best.effort < _COMFORTABLE or number + 1 >= _FEW):
            break
    return best


def in_the_body(page: Page) -> str:
    """How deep the page would lie in the robot's base or torso, if it would."""
    x, y = (np.linspace(-side / 2, side / 2, 2 + int(side / 0.05)) for side in page.size)
    sheet = page.to_world(np.stack(np.meshgrid(x, y), axis=-1)).reshape(-1, 3)
    depths = {solid.link: -solid.distance(sheet - middle).min() for solid, middle in _BULK.items()}
    link = max(depths, key=depths.get)
    if depths[link] <= 0:
        return ""
    return (
        f"The page would go through the robot's body: from 0.00 s on, it and the robot's {plain(link)} would overlap "
        f"by {max(1000 * depths[link], 1):.0f} mm."
    )


def _postures(solver: Solver, page: Page) -> Iterator[Array]:
    """The fixed postures, those for such a page first, and some random ones: always the same."""
    yield from POSTURES if page.normal[2] > 0.7 else POSTURES[[2, 3, 0, 1]]
    low, high = np.maximum(solver.lower, -np.pi), np.minimum(solver.upper, np.pi)
    yield from np.random.default_rng(0).uniform(low, high, (_RANDOM, len(low)))


def _tried(solver: Solver, posture: Array, page: Page, low: Array, high: Array) -> Stance:
    """One posture: to the middle with the torso, then along the rim and up to the hover without it."""
    middle = np.append((low + high) / 2, 0.0)
    solver.stand(posture, page.normal, torso=True)
    solver.approach(page.to_world(middle))
    solver.settle(page.to_world(middle))
    q = solver.joints()
    if trouble := _trouble(solver, page, middle):
        return Stance(q, middle, np.inf, *trouble)
    solver.stand(q, page.normal, torso=False)
    effort, before, joints, jacobians = 0.0, None, [], []
    for place in [*rim(low, high).values(), middle]:
        for spot in (place, place + np.array([0, 0, HOVER])):
            solver.glide(page.to_world(spot))
            if trouble := _trouble(solver, page, spot):
                return Stance(q, middle, np.inf, *trouble)
            joints.append(solver.joints())
            jacobians.append(solver.jacobian())
        here = place, joints[-1]
        if before is not None:
            effort = max(effort, _hurry(solver, before, here))
        before = here
    return Stance(
        q, middle, max(effort, _effort(solver, page, np.array(joints), np.array(jacobians)))
    )


def _hurry(solver: Solver, one: tuple[Array, Array], other: tuple[Array, Array]) -> float:
    """What the joints must do on the way from one place to another (place, joints), at `SWIFT`, in parts of limits.

    An arm that is straight between the two, and bent at both, shows in nothing else. Nor does a joint that passes half
    a turn: its angle starts again from the other side, and PlaCo would pull it all the way back to its posture.
    """
    far = np.linalg.norm(other[0] - one[0])
    turned = np.abs(other[1] - one[1])[1:]
    return float((SWIFT * turned / solver.fastest[1:]).max() / far) if far > 1e-3 else 0.0


def rim(low: Array, high: Array) -> dict[str, Array]:
    """Eight places around a part of a page, each beside the next, (3,) [m]."""
    (left, bottom), (right, top) = low, high
    x, y = (left + right) / 2, (bottom + top) / 2
    return {
        "upper left corner": np.array([left, top, 0]),
        "upper edge": np.array([x, top, 0]),
        "upper right corner": np.array([right, top, 0]),
        "right edge": np.array([right, y, 0]),
        "lower right corner": np.array([right, bottom, 0]),
        "lower edge": np.array([x, bottom, 0]),
        "lower left corner": np.array([left, bottom, 0]),
        "left edge": np.array([left, y, 0]),
    }


def _trouble(solver: Solver, page: Page, spot: Array) -> tuple[str, tuple[str, ...], bool] | None:
    """What is wrong where the arm stands now: a sentence, no notes, and whether it collides; None if nothing is."""
    X = solver.pen()
    miss = np.linalg.norm(X[:3, 3] - page.to_world(spot))
    tilt = np.arccos(np.clip(-X[:3, 2] @ page.normal, -1, 1))
    if not (miss <= TIP and tilt <= TILT):
        return (
            "The arm cannot get from one end of the ink to the other without changing its posture.",
            (),
            False,
        )
    for link in _FOREARM:
        if page.to_page(solver.place_of(link))[2] < _CLEAR:
            return f"The arm's {plain(link)} would go through what the page lies on.", (), True
    for pair in sorted(solver.touching()):
        if not _neighbours(*(link.removesuffix("_link") for link in pair)):
            return (
                f"The arm would touch the robot: its {plain(pair[0])} and its {plain(pair[1])}.",
                (),
                True,
            )
    return None


def _neighbours(one: str, other: str) -> bool:
    """Whether two links are joined, so that their solids always touch."""
    if one in _CHAIN and other in _CHAIN:
        return abs(_CHAIN.index(one) - _CHAIN.index(other)) <= 1
    return one in _BODY and other in _BODY


def _effort(solver: Solver, page: Page, q: Array, J: Array) -> float:
    """What a pen at `SWIFT` in any direction on the page asks of the joints, as a part of their speed limits.

    The joints' speeds are J^+ v, where J (5, J) holds the tip's velocity and the tilting of the pen; the torso stays.
    A joint that comes up against its stop leaves the others a jolt: such a stance is taken only if there is no other.

    Args:
        solver: This thread's solver.
        page: The sheet.
        q: Joints where the pen has been, shape (N, J) [rad, m].
        J: The `Solver.jacobian` there, shape (N, 6, J).
    """
    q, J, R = q[:, 1:], J[:, :, 1:], page.X_world_page[:3, :3]
    least = (
        _JAMMED if (np.minimum(q - solver.lower[1:], solver.upper[1:] - q) < _STOP).any() else 0.0
    )
    turns = np.concatenate([J[:, :3], R[:, :2].T @ J[:, 3:]], axis=1)
    ways = np.linalg.pinv(turns, rcond=1e-9)[:, :, :3] @ R[:, :2]
    return max(least, float((SWIFT * np.linalg.norm(ways, axis=2) / solver.fastest[1:]).max()))
