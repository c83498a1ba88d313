from dataclasses import replace
from xml.etree import ElementTree as ET

import numpy as np
import pytest

from dmp_teach.errors import JointError
from dmp_teach.files.writing import ASSETS
from dmp_teach.robot.arm import JOINTS
from dmp_teach.robot.fetch import Fetch
from dmp_teach.robot.model.kinematics import REST, Model
from dmp_teach.robot.model.reduced import load_reduced_robot
from dmp_teach.robot.model.urdf import read_origin
from dmp_teach.robot.motion import describe_overloads
from dmp_teach.robot.page import Page
from dmp_teach.robot.simulation.bullet import open_world
from dmp_teach.robot.simulation.world import SLIDE_JOINT, World
from dmp_teach.trajectory import Trajectory
from tests.robot.ink import LETTER
from tests.robot.sound import LIMITS, MODEL

EFFORTS = np.array([joint.effort for joint in LIMITS])
RNG = np.random.default_rng(3)
LOW = np.array([max(joint.lower, -np.pi) for joint in LIMITS])
HIGH = np.array([min(joint.upper, np.pi) for joint in LIMITS])


def bodies(path=ASSETS / "fetch.urdf"):
    """Mass and centre (4,) of every link."""
    for link in ET.parse(path).getroot().iter("link"):
        if (inertial := link.find("inertial")) is not None:
            yield (
                link.attrib["name"],
                float(inertial.find("mass").attrib["value"]),
                read_origin(inertial)[:, 3],
            )


def height_energy(q):
    poses = MODEL.link_poses(q, JOINTS)
    return sum(9.81 * mass * (poses[name] @ centre)[:, 2] for name, mass, centre in bodies())


def test_at_rest_a_motor_holds_what_lifting_would_gain():
    """Another route: gravity's torque is the slope of the energy of height, by our kinematics."""
    q, still, step = RNG.uniform(LOW, HIGH, (20, len(JOINTS))), np.zeros((20, len(JOINTS))), 1e-5
    needed = load_reduced_robot(JOINTS).torques(q, still, still)
    for joint in range(len(JOINTS)):
        by = step * np.eye(len(JOINTS))[joint]
        slope = (height_energy(q + by) - height_energy(q - by)) / (2 * step)
        np.testing.assert_allclose(needed[:, joint], slope, atol=1e-6)


def test_in_motion_it_agrees_with_pybullet():
    """Another library, another algorithm, the same URDF, the pen and the fingers included."""
    pytest.importorskip("pybullet", reason="pybullet is not on this platform")
    motion = Fetch().write(LETTER, Page.board())
    v = np.gradient(motion.q, motion.t, axis=0)
    a = np.gradient(v, motion.t, axis=0)
    rows = slice(None, None, 40)
    with open_world() as (bullet, number):
        world = World(bullet, number, motion, motion.page, "rigid")
        felt, mass = by_pybullet(world, motion.q[rows], v[rows], a[rows])
    np.testing.assert_allclose(motion.torque[rows], felt, atol=1e-3 * EFFORTS.min())
    np.testing.assert_allclose(load_reduced_robot(JOINTS).inertia(motion.q[rows]), mass, atol=1e-5)


def by_pybullet(world, *moments):
    """The torques (T, J) and mass matrices (T, J, J) of the arm, all other joints at rest."""
    moving = [fact for fact in world.facts if fact[2] != world.bullet.JOINT_FIXED]
    columns = [[fact[0] for fact in moving].index(number) for number in world.arm]
    full = np.zeros((len(moments[0]), 3, len(moving)))
    full[:, 0] = [REST.get(fact[1].decode(), 0.0) for fact in moving]
    full[:, :, columns] = np.stack(moments, axis=1)
    torques, masses = [], []
    for q, v, a in full.tolist():
        torques.append(world.call("calculateInverseDynamics", world.robot, q, v, a))
        masses.append(world.call("calculateMassMatrix", world.robot, q))
    return np.array(torques)[:, columns], np.array(masses)[:, columns][:, :, columns]


def test_the_torque_of_a_motion_is_one_row_a_sample_locked_and_made_once():
    motion = Fetch().write(LETTER, Page.table())
    assert motion.torque.shape == motion.q.shape
    assert not motion.torque.flags.writeable
    assert motion.torque is motion.torque
    assert (np.abs(motion.torque) < 0.8 * EFFORTS).all()
    assert not [note for note in motion.notes if "its motor gives" in note]


def test_the_sprung_pens_slide_has_a_force_too():
    sprung = Model.load(ASSETS / "fetch_sprung.urdf")
    names = (*JOINTS, SLIDE_JOINT)
    q = np.zeros((1, len(names)))
    needed = load_reduced_robot(names).torques(q, 0 * q, 0 * q)[0]
    carried = {sprung.joint(SLIDE_JOINT).child}
    for joint in sprung.joints:
        carried |= {joint.child} if joint.parent in carried else set()
    mass = sum(mass for name, mass, _ in bodies(ASSETS / "fetch_sprung.urdf") if name in carried)
    up = (
        sprung.frame(sprung.joint(SLIDE_JOINT).child, q, names)[0, 2, :3]
        @ sprung.joint(SLIDE_JOINT).axis
    )
    assert needed[-1] == pytest.approx(9.81 * mass * up, rel=1e-9)
    assert needed[-1] != 0


def test_more_than_a_motor_gives_is_said_with_the_moment_and_the_cure():
    hasty = tuple(Trajectory(s.t / 8, s.position) for s in LETTER)
    motion = Fetch().write(hasty, Page.table(), size=0.15)
    share = np.abs(motion.torque) / EFFORTS
    told = [note for note in motion.notes if "its motor gives" in note]
    assert len(told) == (share.max(axis=0) > 1).sum() == 1
    row, joint = np.unravel_index(share.argmax(), share.shape)
    assert told[0].startswith(
        f"{JOINTS[joint]} needs {abs(motion.torque[row, joint]):.1f} N m "
        f"after {motion.t[row]:.2f} s, but its motor gives {EFFORTS[joint]:g} N m. "
        "Write slower: there the pen must take "
    )


def test_a_weight_that_is_too_much_is_not_cured_by_patience():
    motion = Fetch().write(LETTER, Page.table())
    feeble = replace(
        MODEL, joints=tuple(replace(joint, effort=joint.effort / 2) for joint in MODEL.joints)
    )
    (note,) = describe_overloads(motion, feeble)
    assert note.startswith("torso_lift_joint needs ")
    assert note.endswith(
        ", but its motor gives 225 N. The weight of the arm alone is too much: "
        "move the page nearer."
    )


def test_an_unknown_joint_is_refused():
    with pytest.raises(JointError, match="elbow_flex_joint"):
        load_reduced_robot(("elbow_flex",))
