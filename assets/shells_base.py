"""The shells of the mobile base: body, wheels, stop button, laser, in the links' frames [m]."""

import numpy as np
from look import BLACK, BLUE, DARK, GREY, RED, smooth, table
from meshing import Array, Mesh, extrude, lathe, loft, rounded

# Directions around the base [degrees], close together where the wells of the wheels begin.
BEARINGS = np.radians(sorted({*range(0, 360, 10), 74, 76, 104, 106, 254, 256, 284, 286}))

SKIRT = table("""
    # height scale wells
    0.012    0.930 0.035
    0.020    0.965 0.044
    0.115    0.975 0.046
    0.122    0.975 0
    0.130    0.975 0
""")
LINE = table("""
    # height scale
    0.1265   0.960
    0.1280   0.996
    0.1300   1.000
    0.1360   1.000
    0.1380   0.996
    0.1395   0.960
""")
BODY = table("""
    # height scale window
    0.1340   0.975 0
    0.1420   0.990 0
    0.2000   0.993 0
    0.2100   0.990 0
    0.2150   0.980 0.002
    0.2170   0.970 0.075
    0.2630   0.970 0.075
    0.2650   0.980 0.002
    0.2700   0.985 0
    0.3050   0.980 0
    0.3300   0.962 0
    0.3470   0.925 0
    0.3555   0.870 0
    0.3589   0.800 0
""")


def level(height: float, scale: float, window: float = 0.0, wells: float = 0.0) -> Array:
    """Return a level oval of the base; `window` moves its front inwards, `wells` its sides [m]."""
    c, s = np.cos(BEARINGS), np.sin(BEARINGS)
    radius = scale * ((c / 0.2866) ** 2 + (s / 0.2641) ** 2) ** -0.5
    radius = radius - window * np.array([smooth((x + 0.05) / 0.20) for x in c])
    beside = np.abs(np.abs(np.degrees(np.arctan2(s, c))) - 90) < 15
    radius = np.where(beside, radius - wells, radius)
    return np.stack([radius * c, radius * s, np.full(len(c), height)], -1)


def base() -> dict:
    """Return a dark skirt with wells for wheels, a blue line, a grey body with a window."""
    caster = lathe([(0, 0), (0.022, 0), (0.022, 0.03), (0, 0.03)], 8)
    casters = [caster.at(x, y, 0) for x in (-0.17, 0.17) for y in (-0.10, 0.10)]
    skirt = loft([level(height, scale, wells=wells) for height, scale, wells in SKIRT])
    return {
        "skirt": (DARK, sum(casters, skirt)),
        "line": (BLUE, loft([level(*row) for row in LINE])),
        "body": (GREY, loft([level(*row) for row in BODY])),
    }


def wheel() -> Mesh:
    """Return the left wheel: a bevelled tread, a hollow hub on its outer side."""
    tread = [
        (0.0, -0.0447),
        (0.052, -0.0447),
        (0.0602, -0.038),
        (0.0602, 0.036),
        (0.055, 0.0447),
        (0.046, 0.0447),
    ]
    hub = [(0.043, 0.040), (0.020, 0.040), (0.017, 0.0447), (0.0, 0.0447)]
    return lathe(tread + hub, 24).turned("yzx")


def estop() -> dict:
    """Return the red button on its block; it is pushed along +z."""
    rim = [(0.0, -0.0145), (0.011, -0.0142), (0.0160, -0.0125), (0.0174, -0.0095)]
    stem = [(0.0174, -0.0055), (0.0150, -0.0035), (0.011, -0.0035), (0.011, 0.001), (0.0, 0.001)]
    block = rounded((-0.0174, -0.0239), (0.0214, 0.0174), [0.006], 3)
    return {
        "cap": (RED, lathe(rim + stem, 20)),
        "block": (DARK, extrude(block, [(0.001, 0.0), (0, 0.001), (0, 0.0288)])),
    }


def laser() -> Mesh:
    """Return the scanner in the base's window, with a groove that it looks through."""
    outline = rounded((-0.0473, -0.0189), (0.0281, 0.0189), [0.018, 0.004, 0.004, 0.018], 5)
    low = [(0.002, 0.0349), (0, 0.0369), (0, 0.046), (0.003, 0.048)]
    return extrude(outline, [*low, (0.003, 0.054), (0, 0.056), (0, 0.0597), (0.002, 0.0617)])


def base_shells() -> dict:
    """Link to name of the piece to its colour and its mesh."""
    left = wheel()
    return {
        "base_link": base(),
        "r_wheel_link": {"shell": (BLUE, left.mirrored("y"))},
        "l_wheel_link": {"shell": (BLUE, left)},
        "estop_link": estop(),
        "laser_link": {"shell": (BLACK, laser())},
    }
