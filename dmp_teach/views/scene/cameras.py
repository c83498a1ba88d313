"""Three cameras, found from the pose of the page and of the robot."""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import product

import numpy as np
from numpy.typing import ArrayLike

from dmp_teach.errors import SettingError
from dmp_teach.robot import Page
from dmp_teach.trajectory import Array
from dmp_teach.views.scene.sight import MovingBoxes

CAMERA_NAMES = ("whole robot", "over the shoulder", "page from above")
"""A view opens over the shoulder, because the letter can be read from there."""

FITTED_ASPECT = 1.5
"""Width over height of the picture that the cameras are fitted to."""

SMALL_PAGE_CORNER = (0.4, 0.05)
"""Right of and below this lies the small page, in halves of the picture from its middle."""

_FIELD_OF_VIEW = 34.0
_SIDE_ANGLES = np.radians([0, 15, -15, 30, -30, 45, -45, 60, -60, 75, -75])
_RISE_ANGLES = np.radians([15, 25, 35, 45, 55, 65])

# How much of the way from the letter's box to the sheet's corners is seen over the shoulder.
_SHEET_SHARE = 0.6
_HAND = ("forearm_roll", "wrist_flex", "wrist_roll", "gripper", "l_gripper_finger", "pen")
HAND_LINKS = tuple(f"{name}_link" for name in _HAND)
"""What is wholly in the picture over the shoulder."""

ARM_LINKS = (*HAND_LINKS, "elbow_flex_link", "upperarm_roll_link", "shoulder_lift_link")
# Where the picture is cut into rays to count what the robot covers of it.
_GRID = np.array([(x, y) for x in np.linspace(-1, 1, 13) for y in np.linspace(-1, 1, 9)])


@dataclass(frozen=True)
class Camera:
    """A place to look from, in the world.

    Args:
        eye: Where the camera is (3,) [m].
        target: What is in the middle of the picture (3,) [m].
        up: What points up in the picture (3,).
        wide: Tangent of half of the angle that must be seen from left to right.
        high: Tangent of half of the angle that must be seen from bottom to top.
        pen_only: True where the pen is drawn without the arm, which would hide the page.
    """

    eye: tuple[float, float, float]
    target: tuple[float, float, float]
    up: tuple[float, float, float]
    wide: float
    high: float
    pen_only: bool = False

    def slope(self, aspect: float) -> float:
        """Return the tangent of half of the field of view, from bottom to top.

        Args:
            aspect: Width over height of the picture.
        """
        return max(self.high, self.wide / aspect)


def check_camera_name(name: str) -> str:
    """Return the name of a camera in small letters.

    Raises:
        SettingError: No camera of that name; lists those that there are.
    """
    if str(name).lower() not in CAMERA_NAMES:
        raise SettingError(
            f"camera is {name!r}, but must be one of: {', '.join(map(repr, CAMERA_NAMES))}."
        )
    return str(name).lower()


def fit_cameras(page: Page, robot: MovingBoxes, letter: Array, table: Array) -> dict[str, Camera]:
    """Find the three cameras for a page.

    Args:
        page: The sheet.
        robot: Boxes round the robot's pieces at a few moments; the last is the end.
        letter: Points of the letter in the world, shape (L, 3), L at least 1 [m].
        table: Points of the sheet and of what carries it, shape (N, 3) [m].

    Returns:
        A `Camera` for each name in `CAMERA_NAMES`.
    """
    corners = page.to_world(
        [(x * page.width / 2, y * page.height / 2) for x in (-1, 1) for y in (-1, 1)]
    )
    sheet = _SHEET_SHARE * corners + (1 - _SHEET_SHARE) * _find_letter_box(page, letter)
    everything = np.vstack([robot.corners.reshape(-1, 3), table])
    return {
        "whole robot": _fit_whole_robot(everything, page.normal),
        "over the shoulder": _fit_over_shoulder(page, robot, letter, sheet),
        "page from above": _fit_from_above(page, corners),
    }


def _fit_whole_robot(points: Array, normal: Array) -> Camera:
    """Look from the front and the right, or from where the page does not show its back."""
    turns = np.radians([-52, -70, -90, -110, -130])
    directions = [_turn_and_lift((1, 0, 0), turn, np.radians(15)) for turn in turns]
    seen = next((direction for direction in directions if direction @ normal > 0.15), directions[0])
    return _fit_camera((points.min(axis=0) + points.max(axis=0)) / 2, seen, (0, 0, 1), points, 1.06)


def _fit_from_above(page: Page, corners: Array) -> Camera:
    """Look straight at the page, its up pointing up."""
    centre = page.X_world_page[:3, 3]
    straight = _fit_camera(centre, page.normal, page.X_world_page[:3, 1], corners, 1.15)
    return replace(straight, pen_only=True)


def _find_letter_box(page: Page, letter: Array) -> Array:
    """Return the corners of the letter's box in the world, in the order of the page's corners."""
    on_page = page.to_page(letter)
    low = on_page.min(axis=0)
    high = on_page.max(axis=0)
    return page.to_world([(x, y) for x in (low[0], high[0]) for y in (low[1], high[1])])


def _fit_over_shoulder(page: Page, robot: MovingBoxes, letter: Array, sheet: Array) -> Camera:
    """Look from behind at the hand and the sheet, where the letter is read best.

    Args:
        page: The sheet.
        robot: Boxes round its pieces while it writes, and last at the end.
        letter: Points of the letter in the world, shape (L, 3) [m].
        sheet: What must be seen of the sheet, shape (4, 3) [m].
    """
    middle = sheet.mean(axis=0)
    behind = np.array([*-middle[:2], 0.0]) / (np.hypot(*middle[:2]) or 1.0)
    hand = robot.of(np.isin(robot.links, HAND_LINKS)).corners.reshape(-1, 3)
    cameras = [
        _fit_camera(
            middle, _turn_and_lift(behind, side, rise), (0, 0, 1), np.vstack([hand, sheet]), 1.04
        )
        for rise, side in product(_RISE_ANGLES, _SIDE_ANGLES)
    ]
    return min(cameras, key=lambda camera: _find_cost(camera, page, robot, letter))


def _find_cost(camera: Camera, page: Page, robot: MovingBoxes, letter: Array) -> float:
    """Weigh what is hidden of the letter, how small it is, how turned, and what the robot covers.

    A letter is read in the end above all. An arm that covers too little is no robot, and a body
    that covers much is a wall.
    """
    eye = np.array(camera.eye)
    R = _find_axes(eye, np.array(camera.target), np.array(camera.up))
    half_height = camera.slope(FITTED_ASPECT)
    half = np.array([FITTED_ASPECT * half_height, half_height])
    right, high, back = R @ (letter - eye).T
    places = np.column_stack([right, high]) / -back[:, None] / half
    under_small_page = (places[:, 0] > SMALL_PAGE_CORNER[0]) & (places[:, 1] < SMALL_PAGE_CORNER[1])
    hidden = robot.hide(eye, letter).any(axis=1) | under_small_page
    read = 1 - hidden.mean(axis=1)

    is_arm = np.isin(robot.links, ARM_LINKS)
    covers = robot.hide(eye, eye + 100 * (_GRID * half @ R[:2] - R[2]))
    arm = covers[:, is_arm].any(axis=1).mean(axis=1)
    body = covers[:, ~is_arm].any(axis=1).mean(axis=1)
    size = np.sqrt(np.prod(np.ptp(places, axis=0) + 1e-3))
    across, up = R[:2] @ page.X_world_page[:3, 1]
    return float(
        8 * max(0.97 - read[-1], 0)
        + 4 * max(0.9 - read.mean(), 0)
        + 2 * max(0.6 - read.min(), 0)
        - np.log(size)
        + 0.8 * np.arctan2(across, up) ** 2
        + 8 * max(0.25 - R[2] @ page.normal, 0)
        + 8 * max(0.14 - arm.min(), 0)
        + 4 * max(arm.max() - 0.4, 0)
        + 4 * max(body.max() - 0.12, 0)
    )


def _turn_and_lift(ahead: ArrayLike, side: float, rise: float) -> Array:
    """Turn the level vector `ahead` by `side` about the world's z, then lift it by `rise` [rad]."""
    up = np.array([0.0, 0.0, 1.0])
    forward = np.asarray(ahead, float)
    level = np.cos(side) * forward + np.sin(side) * np.cross(up, forward)
    return np.cos(rise) * level + np.sin(rise) * up


def _find_axes(eye: Array, target: Array, up: Array) -> Array:
    """Return right, up and backwards of a camera as rows, shape (3, 3)."""
    back = (eye - target) / np.linalg.norm(eye - target)
    right = np.cross(up, back)
    right /= np.linalg.norm(right)
    return np.array([right, np.cross(back, right), back])


def _fit_camera(
    target: Array, direction: Array, up: ArrayLike, points: Array, margin: float
) -> Camera:
    """Return the nearest camera in a direction that has all points in the middle of its picture."""
    upwards = np.asarray(up, float)
    R = _find_axes(target + direction, target, upwards)
    slope = np.tan(np.radians(_FIELD_OF_VIEW / 2))
    for _ in range(4):
        right, high, near = R @ (points - target).T
        distance = np.max(
            near + margin * np.maximum(np.abs(high), np.abs(right) / FITTED_ASPECT) / slope
        )
        in_picture = np.array([right, high]) / (distance - near)
        target = target + distance * (in_picture.max(axis=1) + in_picture.min(axis=1)) / 2 @ R[:2]
    wide, high = margin * np.abs(R[:2] @ (points - target).T / (distance - near)).max(axis=1)
    return Camera(
        eye=_as_tuple(target + distance * direction),
        target=_as_tuple(target),
        up=_as_tuple(upwards),
        wide=float(wide),
        high=float(high),
    )


def _as_tuple(vector: Array) -> tuple[float, float, float]:
    """Return a vector (3,) as plain numbers."""
    x, y, z = vector.tolist()
    return x, y, z
