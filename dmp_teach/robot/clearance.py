"""Find where a motion comes too near to the robot or to what the page lies on, and say so."""

from __future__ import annotations

from operator import attrgetter

from dmp_teach.robot.model.proximity import Near, Proximity
from dmp_teach.robot.page import Page
from dmp_teach.robot.pen_path import MOTION_RATE
from dmp_teach.texts import gettext as _
from dmp_teach.texts import marked
from dmp_teach.trajectory import Array

LEAST_CLEARANCE = 0.010
"""The arm keeps this far from the robot and from what the page lies on [m]."""

THIN_CLEARANCE = 0.020
"""Less than this is worth a note [m]."""

PAGE_SURROUND = 0.2
"""What the page lies on is thought to go on for so far beyond it, on every side [m]."""

_WORDS = {
    "torso_fixed_link": marked("torso"),
    "torso_lift_link": marked("torso"),
    "head_pan_link": marked("head"),
    "head_tilt_link": marked("head"),
    "shoulder_pan_link": marked("shoulder"),
    "shoulder_lift_link": marked("shoulder"),
    "upperarm_roll_link": marked("upper arm"),
    "elbow_flex_link": marked("elbow"),
    "forearm_roll_link": marked("forearm"),
    "wrist_flex_link": marked("wrist"),
    "wrist_roll_link": marked("wrist"),
    "r_gripper_finger_link": marked("right finger"),
    "l_gripper_finger_link": marked("left finger"),
    "pen_tip": marked("pen"),
    "page": marked("what the page lies on"),
}


def find_nearest(
    q: Array, joint_names: tuple[str, ...], page: Page, within: float = THIN_CLEARANCE
) -> tuple[Near | None, Near | None]:
    """Find the first moment nearer than `LEAST_CLEARANCE`, and the one at which all is nearest.

    Only the pen may come near to the page. What stays farther away than `within` [m] does not
    count: where nothing does, both are None. The distance of the first is the least that its pair
    ever has.
    """
    near = Proximity(joint_names, page, PAGE_SURROUND).approaches(q, within)
    closest = min(near, key=attrgetter("distance", "row"), default=None)
    if closest is None or closest.distance >= LEAST_CLEARANCE:
        return None, closest
    first = min((each for each in near if each.distance < LEAST_CLEARANCE), key=attrgetter("row"))
    same = [each.distance for each in near if (each.link, each.other) == (first.link, first.other)]
    return first._replace(distance=min(same)), closest


def describe_collision(near: Near) -> str:
    """Say what would happen where the arm comes too near."""
    what = _describe_other(near)
    if near.distance < 0:
        happens = f"would go into {what}, {-1000 * near.distance:.0f} mm deep"
    else:
        happens = f"would come within {1000 * near.distance:.0f} mm of {what}"
    if 0 <= near.distance < LEAST_CLEARANCE:
        happens += f"; {1000 * LEAST_CLEARANCE:.0f} mm must stay between them"
    moment = f"{near.row / MOTION_RATE:.2f} s the arm's {get_plain_name(near.link)} {happens}."
    if near.other == "page":
        return f"After {moment}"
    touch = "touch" if near.distance < LEAST_CLEARANCE else "come too near to"
    return f"The arm would {touch} the robot: after {moment}"


def describe_thin_margin(near: Near) -> str:
    """Note how near the arm comes where it may stay so."""
    note = _("after {t:.2f} s the arm's {part} comes within {mm:.0f} mm of the robot's {other}")
    if near.other == "page":
        note = _("after {t:.2f} s the arm's {part} comes within {mm:.0f} mm of {other}")
    part, other = (_(get_plain_name(link)) for link in (near.link, near.other))
    t = near.row / MOTION_RATE
    return note.format(t=t, part=part, mm=1000 * near.distance, other=other)


def get_plain_name(link: str) -> str:
    """Return what people call a link."""
    return _WORDS.get(link, link.removesuffix("_link"))


def _describe_other(near: Near) -> str:
    """Return what the arm's part comes near to."""
    name = get_plain_name(near.other)
    return name if near.other == "page" else f"the robot's {name}"
