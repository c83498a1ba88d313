"""Where to look from: three cameras, found from the pose of the page and of the robot."""

from __future__ import annotations

from dataclasses import asdict, dataclass, replace

import numpy as np

from dmp_teach.errors import SettingError
from dmp_teach.robot import Page
from dmp_teach.trajectory import Array

CAMERAS = ("whole robot", "over the shoulder", "page from above")
"""Their names say what is seen; a view opens over the shoulder, because the letter can be read from there."""

ASPECT = 1.5
"""Width over height of the picture that the cameras are fitted to."""

_FIELD_OF_VIEW = 34.0
_SIDEWAYS = np.radians([0, 15, -15, 30, -30, 45, -45, 60, -60, 75, -75])
_UPWARDS = np.radians([0, -10, 10, 20])
_STEEPEST = np.radians(75)
_HEAD = np.array([0.1, 0.0, 1.45])
_ROOM = 1.6
_SHEET = 0.25
"""How much of the way from the letter's box to the sheet's corners is seen over the shoulder."""

_VEIL = 0.3
"""An arm that hides more of the letter than this at some moment of the writing is drawn faintly."""

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
        see_through: True where the arm is drawn faintly, because it would hide the page, or much of the letter.
    """

    eye: tuple[float, float, float]
    target: tuple[float, float, float]
    up: tuple[float, float, float]
    wide: float
    high: float
    see_through: bool = False

    def slope(self, aspect: float) -> float:
        """Tangent of half of the field of view, from bottom to top, in a picture of that width over height."""
        return max(self.high, self.wide / aspect)

    def as_dict(self) -> dict[str, object]:
        """For JSON."""
        return asdict(self)


def known_camera(name: str) -> str:
    """The name itself, in small letters.

    Raises:
        SettingError: No camera of that name; lists those that there are.
    """
    if str(name).lower() not in CAMERAS:
        raise SettingError(
            f"camera is {name!r}, but must be one of: {', '.join(map(repr, CAMERAS))}."
        )
    return str(name).lower()


def cameras(page: Page, robot: Array, letter: Array, table: Array) -> dict[str, Camera]:
    """The three cameras for a page.

    Args:
        page: The sheet.
        robot: Points all over the robot at a few moments, shape (M, P, 3) [m].
        letter: Points of the letter in the world, shape (L, 3), L at least 1 [m].
        table: Points of the sheet and of what carries it, shape (N, 3) [m].

    Returns:
        A `Camera` for each name in `CAMERAS`.
    """
    corners = page.to_world(
        [(x * page.width / 2, y * page.height / 2) for x in (-1, 1) for y in (-1, 1)]
    )
    return {
        "whole robot": _whole(np.vstack([robot.reshape(-1, 3), table]), page.normal),
        "over the shoulder": _shoulder(
            page, robot, letter, _SHEET * corners + (1 - _SHEET) * _box(page, letter)
        ),
        "page from above": _above(page, corners),
    }


def _whole(points: Array, normal: Array) -> Camera:
    """From the front and the right; from further behind where the page would show its back."""
    turns = np.radians([-52, -70, -90, -110, -130])
    directions = [_direction((1, 0, 0), (0, 0, 1), turn, np.radians(15)) for turn in turns]
    seen = next((direction for direction in directions if direction @ normal > 0.15), directions[0])
    return _fit((points.min(axis=0) + points.max(axis=0)) / 2, seen, (0, 0, 1), points, 1.06)


def _above(page: Page, corners: Array) -> Camera:
    """Straight at the page, its up pointing up."""
    straight = _fit(page.X_world_page[:3, 3], page.normal, page.X_world_page[:3, 1], corners, 1.15)
    return replace(straight, see_through=True)


def _box(page: Page, letter: Array) -> Array:
    """The four corners of the letter's own box on the page, in the world, in the order of the page's corners."""
    low, high = (pick(page.to_page(letter), axis=0) for pick in (np.min, np.max))
    return page.to_world([(x, y) for x in (low[0], high[0]) for y in (low[1], high[1])])


def _shoulder(page: Page, robot: Array, letter: Array, corners: Array) -> Camera:
    """From where the robot's eyes are, the page's up pointing up.

    Of many directions the one from which the arm hides least of the letter, above all in the end, when it is read.
    While it is written the hand is above it whatever the direction: then the arm is drawn faintly.
    """
    centre = corners.mean(axis=0)
    ahead = _HEAD - centre
    rise = np.arctan2(ahead[2], np.hypot(*ahead[:2]))
    level = np.array([*ahead[:2], 0.0]) / (np.hypot(*ahead[:2]) or 1.0)
    over = [moment[(moment - centre) @ page.normal > 0.005] for moment in robot]
    best, least, most_hidden = None, np.inf, 0.0
    for side, more in ((side, more) for more in _UPWARDS for side in _SIDEWAYS):
        direction = _direction(level, (0, 0, 1), side, min(rise + more, _STEEPEST))
        camera = _fit(centre, direction, page.X_world_page[:3, 1], corners, _ROOM)
        hidden = [_hidden(camera, moment, letter) for moment in over]
        cost = np.mean(hidden) + hidden[-1] + 0.2 * abs(side) + 1.5 * (1 - direction @ page.normal)
        if cost < least:
            best, least, most_hidden = camera, cost, max(hidden)
    return replace(best, see_through=most_hidden > _VEIL)


def _direction(ahead: Array, up: Array, side: float, rise: float) -> Array:
    """A unit vector: `ahead` turned by `side` about `up`, then lifted by `rise` [rad]."""
    ahead, up = np.asarray(ahead, float), np.asarray(up, float)
    level = np.cos(side) * ahead + np.sin(side) * np.cross(up, ahead)
    return np.cos(rise) * level + np.sin(rise) * up


def _frame(eye: Array, target: Array, up: Array) -> Array:
    """Rows: right, up and backwards of a camera, shape (3, 3)."""
    back = (eye - target) / np.linalg.norm(eye - target)
    right = np.cross(up, back)
    right /= np.linalg.norm(right)
    return np.array([right, np.cross(back, right), back])


def _fit(target: Array, direction: Array, up: Array, points: Array, room: float) -> Camera:
    """The nearest camera in a direction that has all points in its picture, in the middle, with room around them."""
    target, direction, up = (np.asarray(v, float) for v in (target, direction, up))
    R = _frame(target + direction, target, up)
    slope = np.tan(np.radians(_FIELD_OF_VIEW / 2))
    for _ in range(4):
        right, high, near = R @ (points - target).T
        distance = np.max(near + room * np.maximum(np.abs(high), np.abs(right) / ASPECT) / slope)
        in_picture = np.array([right, high]) / (distance - near)
        target = target + distance * (in_picture.max(axis=1) + in_picture.min(axis=1)) / 2 @ R[:2]
    wide, high = room * np.abs(R[:2] @ (points - target).T / (distance - near)).max(axis=1)
    places = (tuple(map(float, v)) for v in (target + distance * direction, target, up))
    return Camera(*places, wide=float(wide), high=float(high))


def _hidden(camera: Camera, robot: Array, letter: Array) -> float:
    """Which part of the letter's points has a point of the robot in front of it, seen from the camera."""
    if not len(robot):
        return 0.0
    eye = np.array(camera.eye)
    R = _frame(eye, np.array(camera.target), np.array(camera.up))
    covered = np.zeros((2 * _CELLS + 3, 2 * _CELLS + 3), bool)
    column, row = _cells(robot, eye, R)
    for right in (-1, 0, 1):
        for high in (-1, 0, 1):
            covered[column + right, row + high] = True
    return float(covered[_cells(letter, eye, R)].mean())


def _cells(points: Array, eye: Array, R: Array) -> tuple[Array, Array]:
    """The cell of a coarse picture in which each point is seen; those outside are in the cells of its edge."""
    right, high, back = R @ (points - eye).T
    scale = _CELLS / (0.6 * np.maximum(-back, 0.05))
    cells = (
        np.clip(np.rint(v * scale), -_CELLS, _CELLS).astype(int) + _CELLS + 1 for v in (right, high)
    )
    return tuple(cells)
