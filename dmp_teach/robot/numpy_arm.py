"""The arm solved in NumPy alone, where there is no PlaCo: the same steps, to the last digits."""

# ruff: noqa: D102 (`Solver` says what each method does)
from __future__ import annotations

import numpy as np

from dmp_teach.robot.arm import JOINTS, STEP_COST, Solver
from dmp_teach.robot.model.urdf import Joint
from dmp_teach.trajectory import Array

# What PlaCo adds to the cost of a step.
_PLACO_COST = 1e-8
# A joint at its bound that pulls inwards by less may stay.
_SLACK = 1e-12
# So often joints are stopped or let go at most, and all at once, though that is no better.
_TURNS = 200
_PATIENCE = 3


class NumpySolver(Solver):
    """The chain from the root to the pen's tip, seen from frames that turn or slide along their z.

    A step is a least-squares problem with bounds.
    """

    name = "NumPy"

    def __init__(self) -> None:
        super().__init__()
        self._fixed, self._end = self._chain()
        self._slides = np.array([self.model.joint(name).type == "prismatic" for name in JOINTS])
        self._liking = 0.0
        self._whole_turn = np.where(self.turning, 2 * np.pi, 0.0)
        self._poses: dict[str, Array] = {}
        self.bound(None)
        self.place(np.zeros(len(JOINTS)), np.array([0.0, 0.0, -1.0]), True, 1.0)

    def place(self, q: Array, down: Array, torso: bool, upright: float) -> None:
        self._q = q.copy()
        self._liked = q.copy()
        self._down = down
        self._upright = np.sqrt(upright)
        self._free = slice(0 if torso else 1, None)
        self._update()

    def prefer(self, weight: float) -> None:
        self._liking = weight

    def bound(self, seconds: float | None) -> None:
        self._farthest = None if seconds is None else self.fastest * seconds

    def go(self, target: Array, steps: int) -> None:
        for _ in range(steps):
            self._q[self._free] += self._step(target)
            # As PlaCo keeps them: a posture half a turn away pulls from there, not all around.
            self._q -= np.round(self._q / (2 * np.pi)) * self._whole_turn
            self._update()

    def joints(self) -> Array:
        return self._q.copy()

    def pen(self) -> Array:
        return self._tip.copy()

    def place_of(self, link: str) -> Array:
        if not self._poses:
            self._poses = self.model.link_poses(self._q, JOINTS)
        return self._poses[link][0, :3, 3]

    def jacobian(self) -> Array:
        return self._J.copy()

    def _chain(self) -> tuple[Array, Array]:
        """Return each joint's frame in the one before (J, 4, 4), and the tip's in the last."""
        carried = {joint.child: joint for joint in self.model.joints}
        chain: list[Joint] = []
        link = "pen_tip"
        while link in carried:
            chain.insert(0, carried[link])
            link = carried[link].parent
        fixed = []
        X = np.eye(4)
        for joint in chain:
            X = X @ joint.X_parent_joint
            if joint.name in JOINTS:
                along = _frame_along(joint.axis)
                fixed.append(X @ along)
                X = along.T
        return np.array(fixed), X

    def _update(self) -> None:
        """Compute the tip's pose and Jacobian where the joints are now."""
        turned = self._q * ~self._slides
        c, s = np.cos(turned)[:, None], np.sin(turned)[:, None]
        x, y = self._fixed[:, :, 0], self._fixed[:, :, 1]
        X = self._fixed.copy()
        X[:, :, 0] = c * x + s * y
        X[:, :, 1] = c * y - s * x
        X[:, :, 3] += (self._q * self._slides)[:, None] * X[:, :, 2]
        for number in range(1, len(X)):
            X[number] = X[number - 1] @ X[number]
        self._tip = X[-1] @ self._end
        self._poses = {}
        axis = X[:, :3, 2].T
        ax, ay, az = axis
        dx, dy, dz = self._tip[:3, 3, None] - X[:, :3, 3].T
        self._J = J = np.empty((6, len(JOINTS)))
        J[0], J[1], J[2] = ay * dz - az * dy, az * dx - ax * dz, ax * dy - ay * dx
        J[3:] = axis
        J[:3, self._slides] = axis[:, self._slides]
        J[3:, self._slides] = 0.0

    def _step(self, target: Array) -> Array:
        """Return by how much the free joints go in the best step (F,)."""
        free = self._free
        across = self._upright * self._tip[:3, :2].T
        J = self._J[:, free]
        A = np.concatenate([J[:3], across @ J[3:]])
        missing = np.concatenate([target - self._tip[:3, 3], across @ self._turn_down()])
        q = self._q[free]
        H = A.T @ A
        H.flat[:: len(q) + 1] += STEP_COST + _PLACO_COST + self._liking
        g = missing @ A + self._liking * (self._liked[free] - q)
        low, high = self.lower[free] - q, self.upper[free] - q
        if self._farthest is not None:
            far = self._farthest[free]
            low, high = np.maximum(low, -far), np.minimum(high, far)
        return _least(H, g, low, high)

    def _turn_down(self) -> Array:
        """Return the rotation vector that turns the pen's axis to where it should look (3,)."""
        (x, y, z), (u, v, w) = self._tip[:3, 2], self._down
        cross = np.array([y * w - z * v, z * u - x * w, x * v - y * u])
        sine = np.sqrt(cross @ cross)
        cosine = x * u + y * v + z * w
        if sine > 1e-12:
            return cross * (np.arctan2(sine, cosine) / sine)
        # Of all ways to the exact opposite, any one.
        return np.pi * self._tip[:3, 0] if cosine < 0 else np.zeros(3)


def _least(H: Array, g: Array, low: Array, high: Array) -> Array:
    """Return the x (F,) within bounds that makes x H x / 2 - g x least.

    By block principal pivoting (Judice and Pires 1994): all joints that are beyond their bounds are
    stopped, and all that pull inwards let go; or one alone, where that has not helped for a while.
    """
    x = np.asarray(np.linalg.solve(H, g), dtype=float)
    side = np.zeros(len(g))
    fewest, patience = len(g) + 1, _PATIENCE
    for _ in range(_TURNS):
        wrong = (x < low - _SLACK) | (x > high + _SLACK) | (side * (H @ x - g) > _SLACK)
        count = int(np.count_nonzero(wrong))
        if not count:
            break
        patience = _PATIENCE if count < fewest else patience - 1
        fewest = min(fewest, count)
        if patience < 0:
            wrong[: np.flatnonzero(wrong)[-1]] = False
        beyond = np.where(x > high, 1.0, -1.0)
        side = np.where(wrong, np.where(side == 0, beyond, 0.0), side)
        x = np.where(side > 0, high, low)
        free = side == 0
        rest = g[free] - H[free][:, ~free] @ x[~free]
        x[free] = np.linalg.solve(H[free][:, free], rest)
    return np.clip(x, low, high)


def _frame_along(axis: Array) -> Array:
    """Return a frame whose z is an axis (3,), shape (4, 4)."""
    X = np.eye(4)
    x = np.cross(axis, np.eye(3)[np.abs(axis).argmin()])
    X[:3, 0] = x / np.linalg.norm(x)
    X[:3, 1] = np.cross(axis, X[:3, 0])
    X[:3, 2] = axis
    return X
