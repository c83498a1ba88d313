from dataclasses import replace
from xml.etree import ElementTree as ET

import numpy as np
import pytest

from dmp_teach.errors import JointError, ReachError
from dmp_teach.files.writing import ASSETS
from dmp_teach.robot.arm import JOINTS
from dmp_teach.robot.fetch import Fetch
from dmp_teach.robot.model.kinematics import REST, Model
from dmp_teach.robot.model.reduced import load_reduced_robot
from dmp_teach.robot.model.urdf import read_origin
from dmp_teach.robot.page import Page
from dmp_teach.robot.simulation.bullet import open_world
from dmp_teach.robot.simulation.world import SLIDE_JOINT, World
from dmp_teach.robot.solvers import get_solver
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


def test_too_much_torque_is_slowed_and_said():
    hasty = tuple(Trajectory(s.t / 8, s.position) for s in LETTER)
    rash = planned(hasty, Page.table(), np.full(len(JOINTS), 1e4))
    motion = Fetch().write(hasty, Page.table(), size=0.15)
    assert (np.abs(rash.torque) > EFFORTS).any()
    assert (np.abs(motion.torque) <= EFFORTS).all()
    assert motion.duration > rash.duration
    assert motion.notes[0].startswith("slowed from ")


def planned(letter, page, efforts):
    """What is planned for a robot with other motors."""
    solver = get_solver()
    given = dict(zip(JOINTS, efforts, strict=True))
    ours = solver.model
    joints = [replace(each, effort=given.get(each.name, each.effort)) for each in ours.joints]
    solver.model = replace(ours, joints=tuple(joints))
    try:
        return Fetch().write(letter, page, size=0.15)
    finally:
        solver.model = ours


def test_a_weight_that_is_too_much_is_refused_with_a_page_that_works():
    weak = np.where(np.array(JOINTS) == "shoulder_lift_joint", 46.0, EFFORTS)
    with pytest.raises(
        ReachError, match=r"^shoulder_lift_joint needs 48\.\d N m for the arm's weight alone after"
    ) as caught:
        planned(LETTER, Page.table(x=0.8), weak)
    assert (np.abs(planned(LETTER, caught.value.cure, weak).torque) <= weak).all()


def test_an_unknown_joint_is_refused():
    with pytest.raises(JointError, match="elbow_flex_joint"):
        load_reduced_robot(("elbow_flex",))
