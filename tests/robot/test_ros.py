import dataclasses
import sys
from functools import cache

import numpy as np
import pytest
from scipy.interpolate import CubicSpline
from scipy.spatial import cKDTree
from scipy.spatial.transform import Rotation

from dmp_teach.errors import (
    JointError,
    MissingPartError,
    PathError,
    ReachError,
    SettingError,
    TrajectoryError,
)
from dmp_teach.robot.arm import JOINTS, SAFETY_SHELL
from dmp_teach.robot.fetch import Fetch
from dmp_teach.robot.model.proximity import Proximity
from dmp_teach.robot.page import Page
from dmp_teach.robot.time_scaling import SPEED_SHARE
from dmp_teach.ros import bag as ros
from dmp_teach.ros.bag import GOAL_TOPIC, PATH_TOPIC, write_rosbag
from dmp_teach.ros.schedule import APPROACH_PACE, LEAD, make_schedule
from dmp_teach.ros.untuck import TUCKED
from tests.conftest import STRICT
from tests.robot.ink import LETTER
from tests.robot.ros_world import HAS_ROS, play_on_a_real_roscore
from tests.robot.sound import LIMITS, MODEL

rosbag1 = pytest.importorskip("rosbags.rosbag1")

FETCH_GROUP = [
    "torso_lift_joint",
    "shoulder_pan_joint",
    "shoulder_lift_joint",
    "upperarm_roll_joint",
    "elbow_flex_joint",
    "forearm_roll_joint",
    "wrist_flex_joint",
    "wrist_roll_joint",
]
GOAL = "control_msgs/msg/FollowJointTrajectoryActionGoal"
PATH = "nav_msgs/msg/Path"
SPEEDS = np.array([joint.velocity for joint in LIMITS])
TURNS = np.array([joint.type == "continuous" for joint in LIMITS])
PAGES = [
    Page.table(),
    Page.board(),
    Page.table(x=0.62, y=0.15, z=0.6),
    Page.board(x=0.7, y=-0.15, z=0.85),
]


@cache
def scheduled(page):
    """The letter on a page, and its schedule: each is searched for once."""
    motion = Fetch().write(LETTER, page, size=0.1)
    return motion, make_schedule(motion)


@pytest.fixture(scope="module")
def motion():
    return scheduled(Page.table())[0]


@pytest.fixture(scope="module")
def plan():
    return scheduled(Page.table())[1]


@pytest.fixture(scope="module")
def bag(motion, tmp_path_factory):
    return write_rosbag(motion, tmp_path_factory.mktemp("bag") / "letter.bag")


def read(path):
    """All messages of a bag: topic -> (connection, time [ns], message)."""
    store = ros.ros_types()
    with rosbag1.Reader(path) as reader:
        return {
            line.topic: (line, at, store.deserialize_ros1(raw, line.msgtype))
            for line, at, raw in reader.messages()
        }


def points_of(message):
    """Times [s], positions and velocities of a goal."""
    points = message.goal.trajectory.points
    t = np.array(
        [point.time_from_start.sec + 1e-9 * point.time_from_start.nanosec for point in points]
    )
    return (
        t,
        np.array([point.positions for point in points]),
        np.array([point.velocities for point in points]),
    )


def stamps_of(value):
    """Every stamp inside a message [s]."""
    if dataclasses.is_dataclass(value):
        if "Time" in type(value).__name__:
            yield value.sec + 1e-9 * value.nanosec
        yield from (
            s for field in dataclasses.fields(value) for s in stamps_of(getattr(value, field.name))
        )
    elif isinstance(value, list):
        yield from (stamp for item in value for stamp in stamps_of(item))


def test_what_is_read_back_is_what_was_planned(plan, bag):
    goal = read(bag)[GOAL_TOPIC][2]
    t, q, velocity = points_of(goal)
    assert goal.goal.trajectory.joint_names == FETCH_GROUP == list(JOINTS)
    np.testing.assert_allclose(t, plan.t, rtol=0, atol=1e-9)
    np.testing.assert_array_equal(q, plan.q)
    np.testing.assert_array_equal(velocity, plan.velocity)


def test_the_writing_is_the_motion_itself_later(motion, plan, bag):
    first = plan.writing
    t, q, _ = points_of(read(bag)[GOAL_TOPIC][2])
    np.testing.assert_allclose(t[first:] - t[first], motion.t, rtol=0, atol=2e-9)
    turns = (q[first:] - motion.q) / (2 * np.pi)
    np.testing.assert_allclose(turns, np.round(turns[:1]).repeat(len(motion.t), axis=0), atol=1e-12)
    assert (turns[0][~TURNS] == 0).all()


def test_velocities_are_the_slope_of_the_positions(bag):
    t, q, velocity = points_of(read(bag)[GOAL_TOPIC][2])
    assert t[0] == LEAD
    assert (np.diff(t) > 0).all()
    np.testing.assert_allclose(velocity, CubicSpline(t, q, bc_type="clamped")(t, 1), atol=1e-9)
    np.testing.assert_allclose(
        (q[2:] - q[:-2]) / (t[2:] - t[:-2])[:, None], velocity[1:-1], atol=0.02
    )
    assert (velocity[[0, -1]] == 0).all()


@pytest.mark.parametrize("page", PAGES, ids=repr)
def test_the_arm_goes_from_tucked_to_the_page_within_its_limits(page):
    _, plan = scheduled(page)
    np.testing.assert_array_equal(plan.q[0], TUCKED)
    way, writing = np.split(np.abs(plan.velocity) / SPEEDS, [plan.writing])
    assert way.max() <= APPROACH_PACE + 0.001
    assert writing.max() <= SPEED_SHARE + 0.01
    assert (plan.q >= [joint.lower - 1e-9 for joint in LIMITS]).all()
    assert (plan.q <= [joint.upper + 1e-9 for joint in LIMITS]).all()
    assert np.abs(np.diff(plan.q, axis=0)).max() < 0.1, "no joint jumps by a turn"


@pytest.mark.parametrize("page", PAGES, ids=repr)
def test_the_arm_touches_nothing_on_its_way(page):
    _, plan = scheduled(page)
    proximity = Proximity(JOINTS, grown=SAFETY_SHELL)

    def touching(q):
        return [
            {pair for pair in pairs if not pair[0].startswith(("pen", "r_grip", "l_grip"))}
            for pairs in proximity.touching(q)
        ]

    # The shapes are coarse: tucked, they overlap by millimetres where the shells do not.
    tucked, arrived = touching(np.array([TUCKED, plan.q[plan.writing]]))
    assert tucked <= {
        ("gripper_link", "torso_lift_link"),
        ("shoulder_lift_link", "torso_lift_link"),
    }
    assert all(pairs <= tucked for pairs in touching(plan.q[: plan.writing : 3]))
    assert arrived == set()
    places = MODEL.link_poses(plan.q[: plan.writing], JOINTS)
    for link in (
        "elbow_flex_link",
        "forearm_roll_link",
        "wrist_flex_link",
        "wrist_roll_link",
        "pen_link",
        "pen_tip",
    ):
        spot = page.to_page(places[link][:, :3, 3])
        over = (np.abs(spot[:, :2]) < page.size / 2).all(axis=1) & (spot[:, 2] > -0.6)
        assert (spot[over, 2] > (0.018 if link.startswith("pen") else 0.05)).all(), link


def shell(link):
    """Points on a link's shell in its own frame, shape (N, 3) [m]."""
    corners = [piece.vertices[piece.faces] for piece in MODEL.visuals if piece.link == link]
    ways = [
        (1, 0, 0),
        (0, 1, 0),
        (0, 0, 1),
        (0.5, 0.5, 0),
        (0, 0.5, 0.5),
        (0.5, 0, 0.5),
        (1 / 3, 1 / 3, 1 / 3),
    ]
    return np.concatenate([way @ piece for piece in corners for way in np.array(ways)])


def test_where_the_coarse_solids_overlap_the_shells_do_not(plan):
    places = MODEL.link_poses(plan.q[: plan.writing : 8], JOINTS)
    for body in ("torso_lift_link", "shoulder_pan_link"):
        tree = cKDTree(shell(body))
        for hand in ("gripper_link", "pen_link"):
            points = shell(hand)
            for X in np.linalg.inv(places[body]) @ places[hand]:
                near = tree.query(points @ X[:3, :3].T + X[:3, 3], distance_upper_bound=0.015)[0]
                assert np.isinf(near).all(), (hand, body)


def test_the_controller_takes_its_time_to_the_first_point_from_any_height_of_the_torso():
    torso = LIMITS[0]
    assert 1.5 * (torso.upper - torso.lower) / LEAD <= 1.0 * torso.velocity
    assert 1.5 * max(torso.upper - TUCKED[0], TUCKED[0]) / LEAD <= SPEED_SHARE * torso.velocity


def test_without_a_start_only_the_letter_is_written(motion):
    plan = make_schedule(motion, start=None)
    assert plan.writing == 0
    np.testing.assert_array_equal(plan.q, motion.q)
    np.testing.assert_allclose(plan.t, LEAD + motion.t, atol=1e-9)


def test_a_start_of_ones_own_is_where_it_starts(motion):
    start = [0.2, 1.32, 0.0, -1.4, 1.72, 0.0, 1.66, 0.0]
    plan = make_schedule(motion, start=start)
    np.testing.assert_array_equal(plan.q[0], start)
    np.testing.assert_allclose(np.exp(1j * plan.q[-1]), np.exp(1j * motion.q[-1]), atol=1e-12)


def test_the_pen_path_is_the_tip_in_the_robots_own_frame(motion, bag):
    line, _, path = read(bag)[PATH_TOPIC]
    assert line.ext.latching == 1
    assert (
        {path.header.frame_id, *(pose.header.frame_id for pose in path.poses)}
        == {"base_link"}
        == {MODEL.root}
    )
    places = [(p.pose.position.x, p.pose.position.y, p.pose.position.z) for p in path.poses]
    np.testing.assert_array_equal(places, motion.tip)
    o = [
        (p.pose.orientation.x, p.pose.orientation.y, p.pose.orientation.z, p.pose.orientation.w)
        for p in path.poses
    ]
    assert (Rotation.from_quat(o).as_matrix()[:, :, 2] @ motion.page.normal < -0.999).all()


def test_the_goal_is_not_latched_and_comes_after_the_path(bag):
    found = read(bag)
    assert found[GOAL_TOPIC][0].ext.latching == 0
    assert found[GOAL_TOPIC][1] - found[PATH_TOPIC][1] >= 1_000_000_000


def test_stamps_that_say_when_to_begin_say_now_and_no_stamp_is_a_time_of_day(bag):
    found = read(bag)
    assert set(stamps_of(found[GOAL_TOPIC][2])) == {0.0}
    assert max(stamps_of(found[PATH_TOPIC][2])) < 3600
    assert max(at for _, at, _ in found.values()) < 3600e9


def test_the_types_are_those_of_noetic(bag):
    """Sums of control_msgs 1.5 and nav_msgs 1.13, as their own headers state them."""
    found = read(bag)
    assert found[GOAL_TOPIC][0].digest == "cff5c1d533bf2f82dd0138d57f4304bb"
    assert found[PATH_TOPIC][0].digest == "6227e2b7e9cce15051f669a5e197bbf7"
    sums = {"FollowJointTrajectoryGoal": "69636787b6ecbde4d61d711979bc7ecb"}
    for name, digest in sums.items():
        assert ros.ros_types().generate_msgdef(f"control_msgs/msg/{name}")[1] == digest


def test_the_controller_is_given_no_tolerances_of_ours(bag):
    goal = read(bag)[GOAL_TOPIC][2]
    assert goal.goal.path_tolerance == goal.goal.goal_tolerance == []
    assert goal.goal_id.id == "dmp_teach"


def test_the_same_motion_gives_the_same_file(motion, bag, tmp_path):
    assert write_rosbag(motion, tmp_path / "again.bag").read_bytes() == bag.read_bytes()


def test_a_place_that_cannot_be_written_is_refused_before_the_work(motion, tmp_path):
    # Before the work, which asks for a start.
    with pytest.raises(PathError, match=r"its name must end with \.bag: try 'a\.bag'"):
        write_rosbag(motion, tmp_path / "a.txt", start="none")
    with pytest.raises(
        PathError, match=r"There is no folder '.*nowhere' for 'a\.bag'; make it first"
    ):
        write_rosbag(motion, tmp_path / "nowhere" / "a.bag", start=None)


@pytest.mark.parametrize(
    ("start", "words"),
    [
        (
            "folded",
            r"start is 'folded', but must be \"tucked\", None, or the positions of the 8 joints "
            "torso",
        ),
        ([0.0] * 7, r"must be .*the 8 joints"),
        ([np.nan] * 8, r"must be .*the 8 joints"),
        (
            [0.5, *[0.0] * 7],
            "start has torso_lift_joint at 0.5, but it must be between 0 and 0.38615",
        ),
    ],
)
def test_a_start_that_is_none_is_a_sentence(motion, tmp_path, start, words):
    with pytest.raises(SettingError, match=words):
        write_rosbag(motion, tmp_path / "a.bag", start=start)
    assert list(tmp_path.iterdir()) == []


def test_a_page_where_the_tucked_arm_is_is_refused(motion, tmp_path):
    here = dataclasses.replace(motion, page=Page.table(x=0.15, z=0.9))
    with pytest.raises(ReachError, match=r"No way was found .* Move the page away .*start=None"):
        write_rosbag(here, tmp_path / "a.bag")
    write_rosbag(here, tmp_path / "a.bag", start=None)


def test_what_is_no_motion_of_this_arm_is_refused(motion, tmp_path):
    with pytest.raises(TrajectoryError, match="A bag is written from a Motion, as Fetch"):
        write_rosbag(LETTER, tmp_path / "a.bag")
    with pytest.raises(
        JointError, match=r"The motion moves wrist_roll_joint, .*; the arm's controller takes"
    ):
        write_rosbag(dataclasses.replace(motion, joint_names=JOINTS[::-1]), tmp_path / "a.bag")


def altered(motion, joint, change):
    q = motion.q.copy()
    q[:, JOINTS.index(joint)] += change
    return dataclasses.replace(motion, q=q)


def test_nothing_beyond_the_robots_limits_is_sent(motion, tmp_path):
    high = altered(motion, "shoulder_pan_joint", 2.0)
    with pytest.raises(
        TrajectoryError, match=r"position of shoulder_pan_joint is 1\.\d+ rad after 6\.00 s, but"
    ):
        write_rosbag(high, tmp_path / "a.bag", start=None)
    shaken = altered(motion, "wrist_flex_joint", 0.1 * np.sin(60 * motion.t))
    with pytest.raises(
        TrajectoryError,
        match=r"speed of wrist_flex_joint is -?\d\.\d+ rad/s after .* plan the motion",
    ):
        write_rosbag(shaken, tmp_path / "a.bag", start=None)
    jerky = altered(motion, "shoulder_pan_joint", 2e-4 * (np.arange(len(motion.t)) % 2))
    with pytest.raises(TrajectoryError, match=r"torque of shoulder_pan_joint is .* N m after"):
        write_rosbag(jerky, tmp_path / "a.bag", start=None)
    sunk = altered(motion, "torso_lift_joint", -0.06)
    with pytest.raises(ReachError, match=r"would .* what the page lies on.* plan the motion again"):
        write_rosbag(sunk, tmp_path / "a.bag", start=None)
    with pytest.raises(TrajectoryError, match=r"(?s)position\[0\] is .* nan .*must be finite"):
        write_rosbag(altered(motion, "wrist_flex_joint", np.nan), tmp_path / "a.bag", start=None)


def test_where_rosbags_is_missing_the_sentence_says_what_to_do(motion, tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "rosbags.typesys", None)
    ros.ros_types.cache_clear()
    with pytest.raises(
        MissingPartError, match=r"written by rosbags, which is not here .*pip install rosbags"
    ):
        write_rosbag(motion, tmp_path / "a.bag")


def test_turns_of_the_joints_that_turn_for_ever_make_no_detour(motion, plan):
    turned = dataclasses.replace(motion, q=motion.q + 2 * np.pi * 3 * TURNS)
    np.testing.assert_allclose(make_schedule(turned).q, plan.q, atol=1e-12)


@pytest.mark.skipif(not HAS_ROS and not STRICT, reason="no ROS 1 here; .ci/run installs Debian's")
def test_a_real_roscore_delivers_every_point(motion, plan, bag, tmp_path):
    heard = play_on_a_real_roscore(bag, [GOAL_TOPIC, PATH_TOPIC], tmp_path)
    assert (heard[GOAL_TOPIC]["type"], heard[GOAL_TOPIC]["latched"]) == (
        GOAL.replace("/msg", ""),
        False,
    )
    assert heard[GOAL_TOPIC]["md5"] == "cff5c1d533bf2f82dd0138d57f4304bb"
    assert (heard[PATH_TOPIC]["type"], heard[PATH_TOPIC]["latched"]) == (
        PATH.replace("/msg", ""),
        True,
    )
    goal = ros.ros_types().deserialize_ros1(heard[GOAL_TOPIC]["data"], GOAL)
    t, q, velocity = points_of(goal)
    assert goal.goal.trajectory.joint_names == FETCH_GROUP
    np.testing.assert_allclose(t, plan.t, rtol=0, atol=1e-9)
    np.testing.assert_allclose(q, plan.q, rtol=0, atol=1e-9)
    np.testing.assert_allclose(velocity, plan.velocity, rtol=0, atol=1e-9)
    path = ros.ros_types().deserialize_ros1(heard[PATH_TOPIC]["data"], PATH)
    assert len(path.poses) == len(motion.t)
