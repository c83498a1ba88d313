"""Find a posture of the arm from which it reaches a part of a page.

A solver never says that a page is out of reach; its answer is then a wrong pose, up to 0.8 m off.
So a posture is judged by where the pen really ends up.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import islice

import numpy as np

from dmp_teach.robot.arm import JOINTS, Solver
from dmp_teach.robot.clearance import get_plain_name
from dmp_teach.robot.page import Page
from dmp_teach.robot.pen_path import HOVER
from dmp_teach.robot.slices import Slices
from dmp_teach.trajectory import Array
from dmp_teach.values import locked

TIP_TOLERANCE = 0.0003
"""The pen's tip must come this near to where it should be [m]."""

PEN_TILT_TOLERANCE = np.radians(1.0)
"""The pen must stand this upright on the paper [rad]."""

SWIFT_WRITING = 0.6
"""As fast as a hand writes [m/s]."""

# Torso, shoulder pan and lift, upper arm's roll, elbow, forearm's roll, wrist flex and roll
# [m, rad]. The elbow is out: straight ahead, the joints need many times their speed.
_TABLE = np.array([0.386, -0.11, -0.45, -0.37, 1.53, -1.39, -0.88, 0.82])
_BOARD = np.array([0.17, -0.47, 0.04, 1.44, 1.59, -0.78, -1.56, -0.92])
_MIRROR = np.array([1, -1, 1, -1, 1, -1, 1, -1])
START_POSTURES = locked(np.array([_TABLE, _TABLE * _MIRROR, _BOARD, _BOARD * _MIRROR]))
"""Where the search for a posture starts, before some random ones, shape (4, J)."""

STRAINED_EFFORT = 2.5
"""A posture that asks more than this of a joint's speed limit is nearly stretched out."""

# Of a joint's limit, at SWIFT_WRITING in the worst place: good enough to stop looking.
_COMFORTABLE = 1.6
# This near to its stop a joint is at it [rad], and then the effort is at least so much.
_STOP = 0.02
_JAMMED = STRAINED_EFFORT - 0.01
# Postures that are tried where the arm is stretched out, and random ones where it cannot stand at
# all: near the body one in ten finds a way past it.
_FEW = 9
_RANDOM = 25
# The forearm's radius, and a little [m].
_FOREARM_RADIUS = 0.055
_FOREARM = (
    "elbow_flex_link",
    "forearm_roll_link",
    "wrist_flex_link",
    "wrist_roll_link",
    "gripper_link",
)
# An arm that is still so far from its place never gets there [m].
_LOST = 0.1
# The pen leans a little, and its circle is tried at some places [m].
_SLACK = 0.01
_STUCK = "The arm cannot get from one end of the ink to the other without changing its posture."
# How near the fingers and the pen come is seen when the motion is planned.
_FINGERS_AND_PEN = ("l_gripper", "r_gripper", "pen")
# Where no page can lie: the base's cylinder and the torso's box [m].
_BASE_RADIUS = 0.29
_BASE_HEIGHT = 0.38
_TORSO = np.array([0.36, 0.36, 0.95])
_TORSO_MIDDLE = np.array([-0.09, 0.0, 0.775])


@dataclass(frozen=True, eq=False)
class ArmPosture:
    """How the arm stands over the middle of the ink.

    Args:
        q: Joint positions there, shape (J,) [rad, m]; the torso stays as it is here.
        effort: The greatest share of a joint's speed limit that a pen at `SWIFT_WRITING` asks
            for; inf where the arm cannot write.
        trouble: Why the arm cannot write here; empty where it can.
        collides: Whether that is because it touches the robot or what the page lies on.
    """

    q: Array
    effort: float = np.inf
    trouble: str = ""
    collides: bool = False

    @property
    def strained(self) -> bool:
        """Whether the arm is nearly stretched out, so that its joints must hurry."""
        return self.effort >= STRAINED_EFFORT


def find_posture(
    solver: Solver, page: Page, low: Array, high: Array, ease: float = np.inf
) -> Slices[ArmPosture]:
    """Find a posture for a part of a page from `low` to `high` (2,), each one once, in slices.

    A search for one that asks for less than `ease` ends with it, and may find trouble where there
    is none: it knows fewer postures and leaves each as soon as it asks for more.
    """
    key = (*(part.tobytes() for part in (page.X_world_page, page.size, low, high)), ease)
    if key not in solver.verdicts:
        posture = yield from _search(solver, page, low, high, ease)
        if len(solver.verdicts) > 200:
            solver.verdicts.clear()
        solver.verdicts[key] = posture
    return solver.verdicts[key]


def measure_gap(solver: Solver, page: Page, places: Iterable[Array]) -> Array:
    """Return how much too short a straight arm is for an upright pen at places (N,), at least [m].

    The pen may turn about itself: its tip sees the wrist somewhere on a circle, and the shoulder
    goes round the pan axis and up with the torso.
    """
    poses = solver.model.link_poses(np.zeros(1), JOINTS[:1])
    shoulder, wrist, pan = (
        poses[f"{name}_link"][0, :3, 3] for name in ("shoulder_lift", "wrist_flex", "shoulder_pan")
    )
    across, along = np.hypot(*(seen := _see(poses["pen_tip"][0], wrist))[:2]), seen[2]
    angles = np.linspace(0, 2 * np.pi, 256, endpoint=False)
    circle = np.stack([across * np.cos(angles), across * np.sin(angles), 0 * angles - along])
    points = page.to_world(np.array(list(places))[:, None] + circle.T)
    round_pan = np.linalg.norm(points[..., :2] - pan[:2], axis=-1) - (shoulder - pan)[0]
    above = points[..., 2] - shoulder[2]
    above -= np.clip(above, solver.lower[0], solver.upper[0])
    return np.hypot(round_pan, above).min(axis=1) - np.linalg.norm(wrist - shoulder) - _SLACK


def _see(X: Array, point: Array) -> Array:
    """Return where a frame (4, 4) sees a point (3,)."""
    return X[:3, :3].T @ (point - X[:3, 3])


def _search(solver: Solver, page: Page, low: Array, high: Array, ease: float) -> Slices[ArmPosture]:
    """Return the first comfortable posture, or else the one that asks least of the joints."""
    best = ArmPosture(START_POSTURES[0], trouble=describe_obstacle(page))
    if best.trouble:
        return best
    if measure_gap(solver, page, list_rim_places(low, high).values()).max() > 0:
        return ArmPosture(START_POSTURES[0], trouble=_STUCK)
    quick = ease < np.inf
    for number, start in enumerate(islice(_starts(solver, page), _FEW if quick else None)):
        yield "reach", 0.0
        posture = _try_posture(solver, start, page, (low, high), ease)
        if quick and not posture.trouble:
            return posture
        if number == 0 or (bool(posture.trouble), posture.effort) < (
            bool(best.trouble),
            best.effort,
        ):
            best = posture
        if not best.trouble and (best.effort < _COMFORTABLE or number + 1 >= _FEW):
            break
    return best


def describe_obstacle(page: Page) -> str:
    """Say how deep the page would lie in the robot's body or the floor; empty where it does not."""
    x, y = (np.linspace(-side / 2, side / 2, 2 + int(side / 0.05)) for side in page.size)
    points = page.to_world(np.stack(np.meshgrid(x, y), axis=-1)).reshape(-1, 3)
    beside = _BASE_RADIUS - np.hypot(points[:, 0], points[:, 1])
    above = _BASE_HEIGHT / 2 - np.abs(points[:, 2] - _BASE_HEIGHT / 2)
    depths = {
        "base": np.minimum(beside, above).max(),
        "torso": (_TORSO / 2 - np.abs(points - _TORSO_MIDDLE)).min(axis=1).max(),
    }
    part, depth = max(depths.items(), key=lambda item: item[1])
    if depth > 0:
        return (
            f"The page would go through the robot's body: from 0.00 s on, it and the robot's "
            f"{part} would overlap by {max(1000 * depth, 1):.0f} mm."
        )
    depth = -points[:, 2].min()
    return f"The page would go {1000 * depth:.0f} mm into the floor." if depth > 0.0005 else ""


def _starts(solver: Solver, page: Page) -> Iterator[Array]:
    """Yield the fixed postures, those for such a page first, and random ones, always the same."""
    yield from START_POSTURES if page.normal[2] > 0.7 else START_POSTURES[[2, 3, 0, 1]]
    low, high = np.maximum(solver.lower, -np.pi), np.minimum(solver.upper, np.pi)
    yield from np.random.default_rng(0).uniform(low, high, (_RANDOM, len(low)))


def _try_posture(
    solver: Solver, start: Array, page: Page, area: tuple[Array, Array], ease: float
) -> ArmPosture:
    """Go to the middle with the torso, then along the rim and up to the hover without it."""
    low, high = area
    middle = np.append((low + high) / 2, 0.0)
    solver.stand(start, page.normal, torso=True)
    solver.approach(page.to_world(middle))
    if np.linalg.norm(solver.pen()[:3, 3] - page.to_world(middle)) > _LOST:
        return ArmPosture(solver.joints(), trouble=_STUCK)
    solver.settle(page.to_world(middle))
    q = solver.joints()
    if trouble := _find_loss(solver, page, middle) or _find_touch(solver, [q]):
        return ArmPosture(q, np.inf, *trouble)
    solver.stand(q, page.normal, torso=False)
    joints: list[Array] = []
    effort = 0.0
    places = [*list_rim_places(low, high).values(), middle]
    for spot in (spot for place in places for spot in (place, place + np.array([0, 0, HOVER]))):
        solver.glide(page.to_world(spot))
        if trouble := _find_loss(solver, page, spot):
            break
        joints.append(solver.joints())
        effort = max(effort, _effort_at(solver, page, solver.joints(), solver.jacobian()))
        if effort >= ease:
            return ArmPosture(q, effort, _STUCK)
    # What is touched on the way comes before what is lost at its end.
    if trouble := _find_touch(solver, joints) or trouble:
        return ArmPosture(q, np.inf, *trouble)
    effort = max(effort, _effort_between(solver, np.array(places), np.array(joints[1::2])))
    return ArmPosture(q, effort, _STUCK if effort >= ease else "")


def _effort_between(solver: Solver, places: Array, q: Array) -> float:
    """Return what ways between places (N, 3) ask of joints (N, J), in parts of their limits.

    Only here shows an arm that is straight between two, or a joint that passes half a turn.
    """
    far = np.linalg.norm(np.diff(places, axis=0), axis=1)
    speeds = SWIFT_WRITING * np.abs(np.diff(q, axis=0)[:, 1:]) / solver.fastest[1:]
    asked = speeds.max(axis=1) / np.maximum(far, 1e-3)
    return float(asked[far > 1e-3].max(initial=0.0))


def list_rim_places(low: Array, high: Array) -> dict[str, Array]:
    """Return eight places around a part of a page, each beside the next, (3,) [m]."""
    left, bottom = low
    right, top = high
    x, y = (low + high) / 2
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


def _find_loss(solver: Solver, page: Page, spot: Array) -> tuple[str, bool] | None:
    """Return what is wrong with the pen or the page where the arm is, and whether it collides."""
    X = solver.pen()
    miss = np.linalg.norm(X[:3, 3] - page.to_world(spot))
    tilt = np.arccos(np.clip(-X[:3, 2] @ page.normal, -1, 1))
    if not (miss <= TIP_TOLERANCE and tilt <= PEN_TILT_TOLERANCE):
        return _STUCK, False
    for link in _FOREARM:
        if page.to_page(solver.place_of(link))[2] < _FOREARM_RADIUS:
            return f"The arm's {get_plain_name(link)} would go through what the page lies on.", True
    return None


def _find_touch(solver: Solver, q: list[Array]) -> tuple[str, bool] | None:
    """Return which part touches the robot first at some joint positions; None if none does."""
    for pairs in solver.proximity.touching(np.array(q)) if q else ():
        for other, link in sorted((other, link) for link, other in pairs):
            if not link.startswith(_FINGERS_AND_PEN):
                parts = f"its {get_plain_name(other)} and its {get_plain_name(link)}"
                return f"The arm would touch the robot: {parts}.", True
    return None


def _effort_at(solver: Solver, page: Page, q: Array, J: Array) -> float:
    """Return what a pen at `SWIFT_WRITING` asks of joints (J,), in parts of their limits.

    Their speeds are J^+ v, where J holds the tip's velocity and the tilting of the pen; the torso
    stays. A joint at its stop leaves the others a jolt: such a posture is the last to be taken.
    """
    q = q[1:]
    J = J[:, 1:]
    R = page.X_world_page[:3, :3]
    stopped = np.minimum(q - solver.lower[1:], solver.upper[1:] - q) < _STOP
    turns = np.concatenate([J[:3], R[:, :2].T @ J[3:]])
    ways = np.linalg.pinv(turns, rcond=1e-9)[:, :3] @ R[:, :2]
    effort = float((SWIFT_WRITING * np.linalg.norm(ways, axis=1) / solver.fastest[1:]).max())
    return max(_JAMMED, effort) if stopped.any() else effort
