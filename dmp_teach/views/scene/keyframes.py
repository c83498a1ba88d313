"""Keys of a motion between which a browser may interpolate without leaving it."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from dmp_teach.robot import Model, Motion
from dmp_teach.trajectory import Array, interpolate_points

KEYS_PER_SECOND = 15

KEY_TOLERANCE = 0.0001
"""How far any point of the robot may be from its place between two keys [m]."""

MAX_KEYS = 1200
"""A long text is shown a little less exactly, so that its file stays small."""

_PROBES = np.array([[0, 0, 0, 1], [0.1, 0, 0, 1], [0, 0.1, 0, 1], [0, 0, 0.1, 1]]).T
"""Four points on each link: its origin and one decimetre along each axis, as columns [m]."""


def find_key_rows(
    model: Model, motion: Motion, tolerance: float = KEY_TOLERANCE
) -> NDArray[np.int_]:
    """Return the rows of a motion's keys: 15 a second, and more where the arm is too quick.

    Between two keys every joint moves evenly, which is what three.js does with the quaternions of
    a joint that turns about a fixed axis. A stretch on which a probe leaves its place by more than
    the tolerance [m] is cut in half. The first and the last row are always keys.
    """
    truth = _place_probes(model, motion, motion.q)
    rows = _halve_to_tolerance(model, motion, truth, tolerance)
    while len(rows) > MAX_KEYS and tolerance < 0.01:
        tolerance *= 1.6
        rows = _halve_to_tolerance(model, motion, truth, tolerance)
    return rows


def _halve_to_tolerance(
    model: Model, motion: Motion, truth: Array, tolerance: float
) -> NDArray[np.int_]:
    """Return the rows of the keys that keep the tolerance [m]."""
    last = len(motion.t) - 1
    stride = 1
    if motion.duration > 0:
        stride = max(1, round(last / (motion.duration * KEYS_PER_SECOND)))
    rows = np.unique(np.append(np.arange(0, last + 1, stride), last))
    while len(rows) > 1:
        probes = _place_probes(model, motion, _interpolate_joints(motion, rows))
        off = np.linalg.norm(probes - truth, axis=-1).max(axis=1)
        worst = np.maximum.reduceat(off, rows)[:-1]
        middle = (rows[:-1] + rows[1:]) // 2
        new = middle[(worst > tolerance) & (middle > rows[:-1])]
        if not len(new):
            break
        rows = np.union1d(rows, new)
    return rows


def _interpolate_joints(motion: Motion, rows: NDArray[np.int_]) -> Array:
    """Return joints that move evenly from key to key, at every sample (T, J) [rad, m]."""
    return interpolate_points(motion.t, motion.t[rows], motion.q[rows])


def _place_probes(model: Model, motion: Motion, q: Array) -> Array:
    """Return all probes on all links, shape (T, L * 4, 3) [m]."""
    poses = model.link_poses(q, motion.joint_names)
    return np.concatenate([np.swapaxes(X @ _PROBES, 1, 2)[..., :3] for X in poses.values()], axis=1)
