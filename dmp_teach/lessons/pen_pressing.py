"""How hard a pen presses, and how much a page asks of the joints: what needs no simulation."""

from __future__ import annotations

from dmp_teach.robot import FORCE_BAND, SWIFT_WRITING, USUAL_PAGES

LEAST_FORCE, MOST_FORCE = FORCE_BAND
SPRING = 0.1
"""A sprung pen pushes with so much more for each millimetre that it is pressed in [N/mm]."""

SPRING_TRAVEL = 12.0
"""Pressed in further, the spring is at its end [mm]."""

RIGID = 12.0
"""What a rigid pen does with real motors, within a half; perfect ones push far harder [N/mm]."""

# What pushes then is the arm, as with a rigid pen [N/mm].
_AT_ITS_END = 6.0

# Of what slides in the pen.
_PEN_WEIGHT = 0.127
# So far `simulate` presses each pen in, on a page that lies as planned [mm].
PRESSED_AS_PLANNED = {"sprung": 4.0, "rigid": 0.5}


def weight_on(where: str) -> float:
    """Return what the pen's own weight adds on a usual page: none on a board [N]."""
    return _PEN_WEIGHT * max(float(USUAL_PAGES[where].normal[2]), 0.0)


def force_of(pen: str, press: float, where: str) -> float:
    """Return with how much a pen presses that is pressed in by so many mm on a usual page [N].

    As `simulate` gives it, within 0.05 N as long as a spring has a way to go.
    """
    if pen == "rigid":
        return RIGID * press
    further = max(press - SPRING_TRAVEL, 0.0)
    return SPRING * min(press, SPRING_TRAVEL) + _AT_ITS_END * further + weight_on(where)


def busiest_joint(effort: float, speed: float) -> float:
    """Return how much of its fastest turn the busiest joint needs on a page of such an effort.

    Args:
        effort: Of the page, from a `ReachMap`.
        speed: Of the pen [cm/s].

    Returns:
        In the worst place of the page, in the worst direction [%].
    """
    return effort * speed / SWIFT_WRITING
