"""Write a motion as a ROS 1 bag that a real Fetch's controller understands, without ROS.

The bag holds one goal for the arm's trajectory controller, and the way of the pen to look at in
rviz. Facts of the Fetch's controller (robot_controllers, `follow_joint_trajectory`) that shape the
goal:

- a stamp of 0 means "now". Any other would be in the past when the bag is played, and the arm would
  jump to where it should be by then. So no stamp in the bag is a time of day, and the same motion
  gives the same file, byte for byte;
- it goes from where it is to the first point in that point's time: `LEAD`, long enough for the
  torso from any height;
- between points it draws cubics through positions and velocities. With ours it draws the very
  spline they come from;
- all goals carry the same id, so that a bag played twice does not cut into itself: an id that is
  known is left alone.
"""

from __future__ import annotations

import tempfile
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike
from scipy.spatial.transform import Rotation

from dmp_teach.arguments import checked
from dmp_teach.errors import MissingPartError
from dmp_teach.files import check_path, told_as_path_error, write_whole
from dmp_teach.progress import Progress, reporter
from dmp_teach.robot import JOINTS, Model, Motion
from dmp_teach.ros.schedule import Schedule, make_schedule

GOAL_TOPIC = "/arm_with_torso_controller/follow_joint_trajectory/goal"
PATH_TOPIC = "/dmp_teach/pen_path"

# Times in the bag [s]: the goal comes later, when all who listen have found its player.
_PATH_AT = 1.0
_GOAL_AT = 3.0

# Of control_msgs, which rosbags does not bring; the order and names of fields make their md5 sums.
_MESSAGES = {
    "JointTolerance": "string name\nfloat64 position\nfloat64 velocity\nfloat64 acceleration\n",
    "FollowJointTrajectoryGoal": (
        "trajectory_msgs/JointTrajectory trajectory\nJointTolerance[] path_tolerance\n"
        "JointTolerance[] goal_tolerance\nduration goal_time_tolerance\n"
    ),
    "FollowJointTrajectoryActionGoal": (
        "Header header\nactionlib_msgs/GoalID goal_id\nFollowJointTrajectoryGoal goal\n"
    ),
}
_GOAL = "control_msgs/msg/FollowJointTrajectoryActionGoal"
_PATH = "nav_msgs/msg/Path"


@checked
def write_rosbag(
    motion: Motion,
    path: str | Path,
    start: str | ArrayLike | None = "tucked",
    progress: Progress | None = None,
) -> Path:
    """Write a motion as a ROS 1 bag that makes a real Fetch write it.

    `rosbag play` sends the goal (control_msgs/FollowJointTrajectoryActionGoal on `GOAL_TOPIC`) and
    the way of the nib (nav_msgs/Path in base_link, latched, on `PATH_TOPIC`). The arm unfolds,
    writes, and stays with the pen lifted off the page. What stands around the robot is not known
    here: keep a hand on its stop button.

    Args:
        motion: What to write, from `Fetch().write`.
        path: Where to, ending with .bag; its folder must exist. A file that is there is replaced in
            one step.
        start: How the arm stands before: "tucked" as the Fetch folds it to drive (`TUCKED`), or its
            eight joint positions in the order of `JOINTS` (8,) [m, rad]. From there it goes to the
            page without touching the robot or what the page lies on. None: the arm is at the
            motion's start already, brought there by other means.
        progress: Called as `progress(done, total)` with the legs of ways to the page that have been
            tried, of all there are. It may raise to stop. None draws a bar after a second.

    Returns:
        The path.

    Raises:
        MissingPartError: rosbags is not installed.
        TrajectoryError: Not a motion, or one that the Fetch's limits do not allow.
        JointError: A motion of other joints.
        SettingError: A start that is none, or out of the joints' limits.
        ReachError: No way from the start to the page, or a motion that touches something.
        PathError: A path that cannot be written; what was there before stays.
    """
    path, store = check_path(path, ".bag"), ros_types()
    points = make_schedule(motion, start, reporter(progress, "ways to the page"))
    with told_as_path_error(path), tempfile.TemporaryDirectory() as folder:
        part = Path(folder) / "part.bag"
        _write(store, part, _goal(store, points), _pen_path(store, motion, points))
        data = part.read_bytes()
    return write_whole(path, data, ".bag")


@cache
def ros_types() -> Any:
    """Return the types of ROS Noetic's messages, and of control_msgs that a goal is made of.

    They are made at run time, and so they and their messages are Any.
    """
    try:
        from rosbags.typesys import Stores, get_types_from_msg, get_typestore  # noqa: PLC0415
    except ImportError as error:
        raise MissingPartError(
            f"A bag for the real robot is written by rosbags, which is not here ({error}). All "
            "else works without it. To get it: python3 -m pip install rosbags"
        ) from None
    store = get_typestore(Stores.ROS1_NOETIC)
    found: dict[str, Any] = {}
    for name, text in _MESSAGES.items():
        found |= get_types_from_msg(text, f"control_msgs/msg/{name}")
    store.register(found)
    return store


def _write(store: Any, path: Path, goal: Any, pen_path: Any) -> None:
    """Write both messages; the goal is not latched, lest an old one sends off who connects late."""
    from rosbags.rosbag1 import Writer  # noqa: PLC0415

    with Writer(path) as bag:
        for topic, kind, message, at, latched in (
            (PATH_TOPIC, _PATH, pen_path, _PATH_AT, 1),
            (GOAL_TOPIC, _GOAL, goal, _GOAL_AT, 0),
        ):
            line = bag.add_connection(
                topic, kind, typestore=store, callerid="/dmp_teach", latching=latched
            )
            bag.write(line, int(at * 1e9), store.serialize_ros1(message, kind))


def _goal(store: Any, points: Schedule) -> Any:
    """Return the goal, its tolerances empty: the controller refuses any that are given."""
    kinds = store.types
    none = np.empty(0)
    point = kinds["trajectory_msgs/msg/JointTrajectoryPoint"]
    now = _time(store, 0.0)
    trajectory = kinds["trajectory_msgs/msg/JointTrajectory"](
        header=_header(store, 0.0),
        joint_names=list(JOINTS),
        points=[
            point(q, velocity, none, none, _time(store, t, "Duration"))
            for t, q, velocity in zip(points.t, points.q, points.velocity, strict=True)
        ],
    )
    return kinds[_GOAL](
        header=_header(store, 0.0),
        goal_id=kinds["actionlib_msgs/msg/GoalID"](stamp=now, id="dmp_teach"),
        goal=kinds["control_msgs/msg/FollowJointTrajectoryGoal"](
            trajectory, [], [], _time(store, 0.0, "Duration")
        ),
    )


def _pen_path(store: Any, motion: Motion, points: Schedule) -> Any:
    """Return the way of the nib while it writes, in the robot's frame, on the goal's clock."""
    kinds = store.types
    pose = kinds["geometry_msgs/msg/Pose"]
    posed = kinds["geometry_msgs/msg/PoseStamped"]
    place = kinds["geometry_msgs/msg/Point"]
    turned = kinds["geometry_msgs/msg/Quaternion"]
    turns = Rotation.from_matrix(
        Model.load().frame("pen_tip", motion.q, motion.joint_names)[:, :3, :3]
    ).as_quat()
    return kinds[_PATH](
        header=_header(store, 0.0),
        poses=[
            posed(_header(store, t), pose(place(*tip.tolist()), turned(*turn.tolist())))
            for t, tip, turn in zip(points.t[points.writing :], motion.tip, turns, strict=True)
        ],
    )


def _header(store: Any, t: float) -> Any:
    """Return a header in the robot's own frame: a motion's world has its origin in the base."""
    return store.types["std_msgs/msg/Header"](seq=0, stamp=_time(store, t), frame_id="base_link")


def _time(store: Any, t: float, kind: str = "Time") -> Any:
    """Return a time or a duration of ROS."""
    return store.types[f"builtin_interfaces/msg/{kind}"](*divmod(round(1e9 * t), 10**9))
