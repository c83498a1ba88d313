"""What must hold for every motion, judged without PlaCo."""

import numpy as np

from dmp_teach.robot.arm import JOINTS
from dmp_teach.robot.model.kinematics import Model
from dmp_teach.robot.pen_path import MOTION_RATE
from dmp_teach.robot.time_scaling import SPEED_SHARE

MODEL = Model.load()
LIMITS = [MODEL.joint(name) for name in JOINTS]


def assert_sound(motion):
    """Tip, pen, limits and clock, by the model's own kinematics and finite differences."""
    X = MODEL.frame("pen_tip", motion.q, motion.joint_names)
    np.testing.assert_allclose(motion.tip, X[:, :3, 3], atol=1e-12)
    miss = np.linalg.norm(motion.tip - motion.target, axis=1)
    assert np.sqrt((miss**2).mean()) < 2e-5
    assert miss.max() < 5e-5
    upright = np.linalg.norm(np.cross(X[:, :3, 2], motion.page.normal), axis=1)
    assert np.degrees(upright.max()) < 0.1
    assert (X[:, :3, 2] @ motion.page.normal).max() < 0
    assert (motion.q >= [joint.lower - 1e-9 for joint in LIMITS]).all()
    assert (motion.q <= [joint.upper + 1e-9 for joint in LIMITS]).all()
    speed = (
        np.abs(np.diff(motion.q, axis=0)).max(axis=0)
        * MOTION_RATE
        / [joint.velocity for joint in LIMITS]
    )
    assert speed.max() <= SPEED_SHARE + 1e-9
    assert (np.abs(motion.torque) <= [joint.effort for joint in LIMITS]).all()
    np.testing.assert_allclose(motion.t, np.arange(len(motion.t)) / MOTION_RATE)
    assert (
        len(motion.q)
        == len(motion.tip)
        == len(motion.target)
        == len(motion.pen_down)
        == len(motion.t)
    )
