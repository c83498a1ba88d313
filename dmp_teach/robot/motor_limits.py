"""How much longer the arm must take where its motors, or the limits of its speed, are too weak."""

from __future__ import annotations

import numpy as np

from dmp_teach.robot.arm import JOINTS, Solver
from dmp_teach.robot.model.reduced import load_reduced_robot
from dmp_teach.robot.motion import compute_torques
from dmp_teach.robot.pen_path import MOTION_RATE
from dmp_teach.robot.reach.check import Unreachable
from dmp_teach.robot.time_scaling import SPEED_SHARE
from dmp_teach.trajectory import Array

# A motor has this part of its torque left beside the weight, or the weight is too much for it.
_LEFT = 0.02


def find_strain(solver: Solver, q: Array) -> Array:
    """Return how much longer each sample of a plan (T, J) must last, above 1, (T - 1, J).

    First for the joints' speeds, and where all are slow enough for their torques.

    Raises:
        Unreachable: The weight of the arm alone is too much for a motor.
    """
    speeds = solver.speeds(q) / SPEED_SHARE
    if (speeds > 1).any():
        return speeds
    torques = compute_torques(q, np.arange(len(q)) / MOTION_RATE, JOINTS)
    limits = np.array([solver.model.joint(name).effort for name in JOINTS])
    longer = np.zeros(q.shape)
    rows = np.flatnonzero((np.abs(torques) > limits).any(axis=1))
    over, still = torques[rows], np.zeros((len(rows), len(JOINTS)))
    weight = load_reduced_robot(JOINTS).torques(q[rows], still, still) * np.sign(over)
    left = limits - weight
    strained = np.abs(over) > limits
    if (strained & (left < _LEFT * limits)).any():
        row, joint = np.argwhere(strained & (left < _LEFT * limits))[0]
        unit = "N" if JOINTS[joint] == "torso_lift_joint" else "N m"
        raise Unreachable(
            f"{JOINTS[joint]} needs {weight[row, joint]:.1f} {unit} for the arm's weight alone "
            f"after {rows[row] / MOTION_RATE:.2f} s, but its motor gives {limits[joint]:g} {unit}."
        )
    # What is not weight goes with the square of the speed.
    longer[rows] = np.sqrt(np.where(strained, (np.abs(over) - weight) / left, 0))
    return np.maximum(longer[1:], longer[:-1])
