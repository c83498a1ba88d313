"""Robot, page and reach as they are seen from above: right and ahead of the robot [m]."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import scipy

from dmp_teach.classroom import Affine, Drawing
from dmp_teach.lessons.goals import CM
from dmp_teach.robot import ROBOT_PARTS, USUAL_PAGES, ReachMap, known_reach, outline_from_above
from dmp_teach.texts import gettext as _
from dmp_teach.trajectory import Array, interpolate_points

# The knobs that move the page [cm]; the map has a place at each of their steps.
FIRST_AHEAD, LAST_AHEAD, MOST_ASIDE, MAP_STEP = 30, 115, 90, 5
# What is seen of the floor: left, bottom, right, top [m].
FLOOR = [-1.0, -0.3, 1.0, 1.42]
# What carries a page reaches so far beyond it [m].
_MARGIN = 0.1
TO_PLAN = np.array([[0.0, -1.0], [1.0, 0.0]])
"""From the world's x and y to right and ahead."""


def place_on_map(right: float, ahead: float) -> tuple[int, int]:
    """Return the row and the column of a map that are nearest to a page's middle [cm]."""
    return round((MOST_ASIDE - right) / MAP_STEP), round((ahead - FIRST_AHEAD) / MAP_STEP)


def nearest_at_ease(reach: ReachMap, right: float, ahead: float) -> tuple[int, int]:
    """Return right and ahead [cm] of the place at ease that is nearest to one [m]."""
    rows, columns = np.nonzero(reach.at_ease)
    places = np.column_stack([-reach.across[rows], reach.x[columns]])
    best = places[scipy.spatial.distance.cdist([[right, ahead]], places).argmin()]
    x, y = np.round(best / CM).astype(int).tolist()
    return x, y


def border_of(where: str) -> Array:
    """Return how far ahead the middle of a page can be, from left to right, shape (N, 2) [m]."""
    reach = known_reach(where)
    rows = np.flatnonzero(reach.reached.any(axis=1))[::-1]
    farthest = [reach.x[np.flatnonzero(reach.reached[row])[-1]] for row in rows]
    return np.column_stack([-reach.across[rows], farthest])


def compare_borders(drawn: Array, border: Array) -> tuple[float, float, float]:
    """Return how far ahead two borders are, and how far the first is from the second [cm]."""
    lines = [
        interpolate_points(np.linspace(0, len(line) - 1, 200), range(len(line)), line)
        for line in (drawn, border)
    ]
    said, true = (float(line[np.abs(line[:, 0]).argmin(), 1]) for line in lines)
    return said / CM, true / CM, float(scipy.spatial.distance.cdist(*lines).min(axis=1).mean()) / CM


def draw_reached(where: str) -> list[Drawing]:
    """Draw where the middle of a page can be, a square for each place that was tried."""
    reach = known_reach(where)
    drawn = []
    for kind, places in (("hurry", reach.reached), ("reach", reach.at_ease)):
        for ahead, tried in zip(reach.x, places.T, strict=True):
            edges = np.flatnonzero(np.diff(np.concatenate([[False], tried, [False]]).astype(int)))
            for first, stop in edges.reshape(-1, 2):
                right = (
                    -reach.across[first] + MAP_STEP * CM / 2,
                    -reach.across[stop - 1] - MAP_STEP * CM / 2,
                )
                drawn.append({"points": _box(right, ahead), "kind": kind})
    return drawn


def _box(right: Sequence[float], ahead: float) -> Array:
    """Return the outline of a row of squares, shape (4, 2) [m]."""
    # So much more that no seam is seen between two rows.
    half = MAP_STEP * CM / 2 + 0.002
    low, high = ahead - half, ahead + half
    return np.array([[right[0], low], [right[1], low], [right[1], high], [right[0], high]])


def draw_robot() -> list[Drawing]:
    """Draw the robot."""
    outlines = [outline_from_above(links) @ TO_PLAN.T for links in ROBOT_PARTS]
    return [{"points": np.vstack([each, each[:1]]), "kind": "body"} for each in outlines]


def draw_page(where: str) -> list[Drawing]:
    """Draw the page, and what it lies on, where two knobs have moved them."""
    page = USUAL_PAGES[where]
    corners = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1], [-1, -1]]) / 2
    to_plan = (TO_PLAN @ page.X_world_page[:2, :2]).T
    sizes = {"under-page": page.size + 2 * _MARGIN, "page": page.size}
    return [
        {"points": follow_page(corners * size @ to_plan), "kind": kind}
        for kind, size in sizes.items()
    ]


def follow_page(points: Array) -> Affine:
    """Return points around a page's middle (N, 2) [m], moved as the page is."""
    right, ahead = (CM * np.tile(axis, (len(points), 1)) for axis in np.eye(2))
    return Affine(points, {"right": right, "ahead": ahead})


def page_ring(is_fixed: bool) -> Drawing:
    """Return the ring that moves the page, unless it is fixed."""
    ring = {"home": [0.0, 0.7], "zero": [0.0, 0.0], "at": follow_page(np.zeros((1, 2)))}
    ring |= {"label": _("the middle of the page"), "word": _("page"), "isFree": True}
    return ring | {"scale": CM, "knobs": [] if is_fixed else ["right", "ahead"]}
