"""Maps of reach that come with the package, so that nothing needs to be solved to see them."""

from __future__ import annotations

import json
from functools import cache

import numpy as np

from dmp_teach.errors import PageError
from dmp_teach.files import ASSETS
from dmp_teach.robot.page import Page
from dmp_teach.robot.reach.map import ReachMap

USUAL_PAGES = {
    "table": Page.table(),
    "desk": Page.table(z=0.91, tilt=np.radians(45)),
    "board": Page.board(),
}
"""Pages whose maps are known, by name; the height of the slanted desk is as in `reach_map`."""

KNOWN_REACH = ASSETS / "reach.json"
"""Written by `assets/make_reach.py`: the axes, and of each map effort (0: not reached) and
residual [mm]."""


def known_reach(name: str) -> ReachMap:
    """Return the map, seen from above, of where a usual page can lie.

    As `reach_around` gives it, 5 cm by 5 cm, to a hundredth of a millimetre and of an effort.

    Args:
        name: "table", "desk" (slanted by 45 degrees) or "board".

    Raises:
        PageError: Another name.
    """
    if not isinstance(name, str) or name not in USUAL_PAGES:
        names = ", ".join(map(repr, USUAL_PAGES))
        raise PageError(f"There is no known map of {name!r:.40}; there are: {names}.")
    return _read_known(name)


@cache
def _read_known(name: str) -> ReachMap:
    """Return a map of the file."""
    known = json.loads(KNOWN_REACH.read_text(encoding="utf-8"))
    x, y = (np.array(known[axis]) for axis in "xy")
    effort, residual = (np.array(known[name][what]) for what in ("effort", "residual"))
    page = USUAL_PAGES[name]
    ahead, left = page.X_world_page[:2, 3]
    rows = tuple(tuple(page.moved((a - ahead, b - left, 0.0)) for a in x) for b in y)
    return ReachMap(x, y, "y", rows, np.where(effort > 0, effort, np.inf), residual / 1000)
