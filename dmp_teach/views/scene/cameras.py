"""Three cameras, found from the pose of the page and of the robot."""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import product
from operator import itemgetter

import numpy as np
from numpy.typing import ArrayLike, NDArray

from dmp_teach.errors import SettingError
from dmp_teach.robot import Page
from dmp_teach.trajectory import Array

CAMERA_NAMES = ("whole robot", "over the shoulder", "page from above")
"""A view opens over the shoulder, because the letter can be read from there."""

FITTED_ASPECT = 1.5
"""Width over height of the picture that the cameras are fitted to."""

_FIELD_OF_VIEW = 34.0
_SIDE_ANGLES = np.radians([0, 15, -15, 30, -30, 45, -45, 60, -60, 75, -75])
_RISE_ANGLES = np.radians([0, -10, 10, 20])
_MAX_RISE = np.radians(75)
_HEAD_POSITION = np.array([0.1, 0.0, 1.45])
_SHOULDER_MARGIN = 1.6

_SHEET_SHARE = 0.25
"""How much of the way from the letter's box to the sheet's corners is seen over the shoulder."""

_MAX_HIDDEN_SHARE = 0.3
"""An arm that hides more of the letter than this at some moment is drawn faintly."""

_CELLS = 24
"""Half the width of the coarse picture in which the hidden part of a letter is counted."""


@dataclass(frozen=True)
class Camera:
    """A place to look from, in the world.

    Args:
        eye: Where the camera is (3,) [m].
        target: What is in the middle of the picture (3,) [m].
        up: What points up in the picture (3,).
        wide: Tangent of half of the angle that must be seen from left to right.
        high: Tangent of half of the angle that must be seen from bottom to top.
        see_through: True where the arm is drawn faintly, because it would hide the page, or much
            of the letter.
    """

    eye: tuple[float, float, float]
    target: tuple[float, float, float]
    up: tuple[float, float, float]
    wide: float
    high: float
    see_through: bool = False

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


def fit_cameras(page: Page, robot: Array, letter: Array, table: Array) -> dict[str, Camera]:
    """Find the three cameras for a page.

    Args:
        page: The sheet.
        robot: Points all over the robot at a few moments, shape (M, P, 3) [m].
        letter: Points of the letter in the world, shape (L, 3), L at least 1 [m].
        table: Points of the sheet and of what carries it, shape (N, 3) [m].

    Returns:
        A `Camera` for each name in `CAMERA_NAMES`.
    """
    corners = page.to_world(
        [(x * page.width / 2, y * page.height / 2) for x in (-1, 1) for y in (-1, 1)]
    )
    read_area = _SHEET_SHARE * corners + (1 - _SHEET_SHARE) * _find_letter_box(page, letter)
    return {
        "whole robot": _fit_whole_robot(np.vstack([robot.reshape(-1, 3), table]), page.normal),
        "over the shoulder": _fit_over_shoulder(page, robot, letter, read_area),
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
    return replace(straight, see_through=True)


def _find_letter_box(page: Page, letter: Array) -> Array:
    """Return the corners of the letter's box in the world, in the order of the page's corners."""
    on_page = page.to_page(letter)
    low = on_page.min(axis=0)
    high = on_page.max(axis=0)
    return page.to_world([(x, y) for x in (low[0], high[0]) for y in (low[1], high[1])])


def _fit_over_shoulder(page: Page, robot: Array, letter: Array, corners: Array) -> Camera:
    """Look from about the robot's eyes, the page's up pointing up.

    Of many directions take that from which the arm hides least of the letter, above all in the
    end, when it is read. Where the hand is above it whatever the direction, the arm is drawn
    faintly.
    """
    centre = corners.mean(axis=0)
    ahead = _HEAD_POSITION - centre
    rise = np.arctan2(ahead[2], np.hypot(*ahead[:2]))
    level = np.array([*ahead[:2], 0.0]) / (np.hypot(*ahead[:2]) or 1.0)
    over = [moment[(moment - centre) @ page.normal > 0.005] for moment in robot]
    candidates = []
    for more, side in product(_RISE_ANGLES, _SIDE_ANGLES):
        direction = _turn_and_lift(level, side, min(rise + more, _MAX_RISE))
        camera = _fit_camera(centre, direction, page.X_world_page[:3, 1], corners, _SHOULDER_MARGIN)
        hidden = [_find_hidden_share(camera, moment, letter) for moment in over]
        cost = np.mean(hidden) + hidden[-1] + 0.2 * abs(side) + 1.5 * (1 - direction @ page.normal)
        candidates.append((cost, max(hidden), camera))
    _, most_hidden, best = min(candidates, key=itemgetter(0))
    return replace(best, see_through=most_hidden > _MAX_HIDDEN_SHARE)


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


def _find_hidden_share(camera: Camera, robot: Array, letter: Array) -> float:
    """Return the share of the letter's points that the robot hides from the camera."""
    if not len(robot):
        return 0.0
    eye = np.array(camera.eye)
    R = _find_axes(eye, np.array(camera.target), np.array(camera.up))
    covered = np.zeros((2 * _CELLS + 3, 2 * _CELLS + 3), bool)
    column, row = _find_cells(robot, eye, R)
    for right, high in product((-1, 0, 1), repeat=2):
        covered[column + right, row + high] = True
    return float(covered[_find_cells(letter, eye, R)].mean())


def _find_cells(points: Array, eye: Array, R: Array) -> tuple[NDArray[np.int_], NDArray[np.int_]]:
    """Return the cell of a coarse picture in which each point is seen, at its edge if outside."""
    right, high, back = R @ (points - eye).T
    scale = _CELLS / (0.6 * np.maximum(-back, 0.05))
    column, row = (
        np.clip(np.rint(v * scale), -_CELLS, _CELLS).astype(int) + _CELLS + 1 for v in (right, high)
    )
    return column, row
