"""Between two keys the browser may interpolate without leaving the motion."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation, Slerp

from dmp_teach.robot.model.kinematics import Model
from dmp_teach.views.scene.keyframes import find_key_rows
from dmp_teach.views.scene.stage import Stage, load_robot_model
from dmp_teach.views.scene.tracks import build_joint_track
from tests.views.moves import sway


def played(stage, t):
    """Where the links are at times t, as three.js plays the tracks."""
    model, poses = Model.load(), {}
    times, q = stage.keys
    tracks = {
        n: build_joint_track(model.joint(n), times, c)
        for n, c in zip(stage.joint_names, q.T, strict=True)
    }
    poses[model.root] = np.broadcast_to(np.eye(4), (len(t), 4, 4))
    still = model.link_poses(np.zeros((1, 0)), ())
    for joint in model.joints:
        X = np.repeat(np.linalg.inv(still[joint.parent]) @ still[joint.child], len(t), axis=0)
        if joint.name in tracks:
            track = tracks[joint.name]
            if track.kind == "quaternion":
                X[:, :3, :3] = Slerp(track.times, Rotation.from_quat(track.values))(t).as_matrix()
            else:
                X[:, :3, 3] = np.column_stack(
                    [np.interp(t, track.times, column) for column in track.values.T]
                )
        poses[joint.child] = poses[joint.parent] @ X
    return poses


def test_at_a_key_every_link_is_where_the_model_says_to_a_twentieth_of_a_millimetre(motion):
    stage = Stage(motion)
    rows = find_key_rows(load_robot_model(), motion)
    truth = Model.load().link_poses(motion.q[rows], motion.joint_names)
    shown = played(stage, motion.t[rows])
    for name, X in truth.items():
        np.testing.assert_allclose(shown[name], X, atol=5e-5)


@settings(max_examples=10, deadline=None)
@given(size=st.floats(0.01, 0.3), seconds=st.floats(1.0, 3.0), rate=st.sampled_from([120, 240]))
def test_between_keys_no_link_leaves_the_motion_by_a_fifth_of_a_millimetre(size, seconds, rate):
    motion = sway(seconds, rate, size)
    stage = Stage(motion)
    truth = Model.load().link_poses(motion.q, motion.joint_names)
    shown = played(stage, motion.t)
    off = [np.linalg.norm((shown[name] - X)[:, :3, 3], axis=1).max() for name, X in truth.items()]
    assert max(off) < 0.0002


def test_a_slow_arm_needs_no_more_than_fifteen_keys_a_second():
    motion = sway(seconds=3.0, size=0.002)
    rows = find_key_rows(load_robot_model(), motion)
    assert len(rows) == pytest.approx(45, abs=2)
    assert (rows[0], rows[-1]) == (0, len(motion.t) - 1)
    assert (np.diff(rows) > 0).all()
