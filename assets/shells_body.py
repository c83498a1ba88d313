"""The shells of base, torso and head, all in the links' own frames [m]."""

import numpy as np
from meshing import Array, Mesh, extrude, lathe, loft, rounded, sections, superellipse
from shells_arm import BLACK, BLUE, DARK, GREY, WHITE, smooth

RED = (0.8, 0.02, 0.02)
LENS = (0.22, 0.25, 0.30)

# Directions around the base: close together where the wheel wells and the laser's window begin [degrees].
BEARINGS = sorted({*range(0, 360, 10), 74, 76, 104, 106, 254, 256, 284, 286, 98, 82, 262, 278, 45, 135, 225, 315})


def base_ring(scale: float, height: float, window: float = 0.0, wells: float = 0.0) -> Array:
    """A level line of the base: an oval; `window` moves its front inwards, `wells` its sides [m]."""
    angles = np.radians(BEARINGS)
    c, s = np.cos(angles), np.sin(angles)
    radius = scale * ((c / 0.2866) ** 2 + (s / 0.2641) ** 2) ** -0.5
    front = np.array([smooth((x + 0.05) / 0.20) for x in c])
    radius = radius - window * front
    beside = np.abs(np.abs(np.degrees(np.arctan2(s, c))) - 90) < 15
    radius = np.where(beside, radius - wells, radius)
    return np.stack([radius * c, radius * s, np.full(len(c), height)], -1)


def base() -> dict:
    """A dark skirt with wells for the wheels, a blue line, a grey body with a window for the laser all round its front."""
    skirt = [
        base_ring(0.93, 0.012, wells=0.035),
        base_ring(0.965, 0.020, wells=0.044),
        base_ring(0.975, 0.115, wells=0.046),
    ]
    skirt += [base_ring(0.975, 0.122), base_ring(0.975, 0.130)]
    line = [
        base_ring(s, z)
        for s, z in ((0.96, 0.1265), (0.996, 0.128), (1.0, 0.130), (1.0, 0.136), (0.996, 0.138), (0.96, 0.1395))
    ]
    body = [
        base_ring(s, z, w)
        for s, z, w in (
            (0.975, 0.134, 0),
            (0.990, 0.142, 0),
            (0.993, 0.200, 0),
            (0.990, 0.210, 0),
            (0.980, 0.215, 0.002),
            (0.970, 0.217, 0.075),
            (0.970, 0.263, 0.075),
            (0.980, 0.265, 0.002),
            (0.985, 0.270, 0),
            (0.980, 0.305, 0),
            (0.962, 0.330, 0),
            (0.925, 0.347, 0),
            (0.87, 0.3555, 0),
            (0.80, 0.3589, 0),
        )
    ]
    casters = [
        lathe([(0, 0), (0.022, 0), (0.022, 0.03), (0, 0.03)], 10).at(x, y, 0)
        for x in (-0.17, 0.17)
        for y in (-0.10, 0.10)
    ]
    return {
        "skirt": (DARK, sum(casters, loft(skirt))),
        "line": (BLUE, loft(line)),
        "body": (GREY, loft(body)),
    }


def wheel(side: int) -> Mesh:
    """A wheel with a bevelled tread and a hollow hub on its outer side."""
    profile = [(0.0, -0.0447), (0.052, -0.0447), (0.0602, -0.038), (0.0602, 0.036), (0.055, 0.0447), (0.046, 0.0447)]
    return (
        lathe([*profile, (0.043, 0.040), (0.020, 0.040), (0.017, 0.0447), (0.0, 0.0447)], 24)
        .turned("yzx")
        .mirrored("y" if side < 0 else "x")
    )


def torso_lift() -> Mesh:
    """The white trunk: a shell around the column, shoulders, a chin that carries the arm, an overhang below the neck."""
    rows = (  # height, back, front, half width, power
        (0.0285, -0.178, 0.044, 0.160, 5.0),
        (0.0330, -0.184, 0.050, 0.1655, 5.0),
        (0.150, -0.1852, 0.052, 0.1665, 5.0),
        (0.260, -0.1852, 0.050, 0.1690, 4.8),
        (0.320, -0.1852, 0.044, 0.1708, 4.5),
        (0.430, -0.1852, 0.042, 0.1708, 4.2),
        (0.470, -0.1850, 0.050, 0.1705, 4.0),
        (0.500, -0.184, 0.072, 0.1690, 3.8),
        (0.525, -0.181, 0.094, 0.1650, 3.6),
        (0.550, -0.175, 0.109, 0.1570, 3.4),
        (0.575, -0.163, 0.112, 0.1440, 3.2),
        (0.592, -0.146, 0.106, 0.1260, 3.0),
        (0.600, -0.128, 0.096, 0.1080, 2.8),
        (0.603, -0.110, 0.084, 0.0940, 2.6),
    )
    rings = []
    for height, back, front, half, power in rows:
        outline = superellipse((front - back) / 2, half, power, 40) + ((front + back) / 2, 0)
        rings.append(np.column_stack([outline, np.full(40, height)]))
    return loft(rings) + chin()


def chin() -> Mesh:
    """The shelf in front of the chest on which the shoulder turns."""
    rings = []
    for height, front, half in (
        (0.120, 0.049, 0.080),
        (0.170, 0.090, 0.074),
        (0.205, 0.128, 0.066),
        (0.235, 0.156, 0.057),
        (0.260, 0.1685, 0.0525),
        (0.280, 0.1715, 0.052),
        (0.2955, 0.1715, 0.052),
        (0.2985, 0.1690, 0.0495),
    ):
        outline = rounded((0.0, -half), (front, half), [half - 0.0005, 0.004, 0.004, half - 0.0005], 7)
        rings.append(np.column_stack([outline, np.full(len(outline), height)]))
    return loft(rings)


def column() -> Mesh:
    """The blue back that the trunk slides on."""
    outline = rounded((-0.1683, -0.1553), (-0.0321, 0.1553), [0.012, 0.055, 0.055, 0.012], 5)
    return extrude(outline, [(0.004, -0.0186), (0, -0.0146), (0, 0.4373), (0.006, 0.4433)])


def pleats(low: float, high: float, count: int, inset: float) -> Mesh:
    """A folded sleeve around the lift: `count` folds between two heights."""
    outline = rounded((-0.0290, -0.1494), (0.0431, 0.1494), [0.024, 0.004, 0.004, 0.024], 3)
    heights = np.linspace(low, high, 2 * count + 1)
    return extrude(outline, [(inset + (0.0 if fold % 2 else 0.006), z) for fold, z in enumerate(heights)])


def head_pan() -> Mesh:
    """A horseshoe around the back of the head, on a plate and a neck."""
    flank, end = 0.1262, 0.1425
    places = [(end + 0.055 * np.sin(a), flank, 0.055 * np.cos(a)) for a in np.radians([84, 65, 45, 22, 0])]
    places += [(x, flank, 0.055) for x in (0.10, 0.05)]
    places += [(0.01 - 0.1185 * np.sin(a), flank * np.cos(a), 0.055) for a in np.radians(range(0, 91, 15))]
    rings = []
    for x, y, half in places:
        back = smooth((0.09 - x) / 0.16)
        ahead = (
            np.radians(180)
            if x >= 0.01
            else np.radians(180) + np.arctan2(-(0.01 - x) / 0.1185 * flank, -y / flank * 0.1185) + np.pi
        )
        across = np.array([np.sin(ahead), -np.cos(ahead)]) if x < 0.01 else np.array([0.0, 1.0])
        oval = superellipse(0.0168, half - 0.004 * back, 3.2, 16)
        middle = 0.058 - 0.006 * back
        rings.append(np.column_stack([np.array([x, y]) + oval[:, :1] * across, oval[:, 1] + middle]))
    other = [ring * (1, -1, 1) for ring in rings[-2::-1]]
    other = [np.roll(ring, 0, axis=0) for ring in other]
    plate = extrude(
        superellipse(0.095, 0.118, 2.6, 28) + (-0.010, 0), [(0.012, 0.0), (0, 0.008), (0, 0.058), (0.012, 0.066)]
    )
    return loft(rings + other) + plate + lathe([(0, -0.003), (0.062, -0.003), (0.066, 0.004), (0, 0.004)], 28)


def head_tilt() -> dict:
    """A blue box with round edges and the dark face of its camera."""
    rings = []
    for y, shrink in ((0.105, 0.016), (0.103, 0.009), (0.097, 0.003), (0.088, 0.0)):
        outline = superellipse(0.0545 - shrink, 0.055 - shrink, 3.4, 28)
        rings.append(np.column_stack([outline[:, 0] - 0.0005, np.full(28, y), outline[:, 1]]))
    shell = loft(rings + [ring * (1, -1, 1) for ring in rings[::-1]])
    pivot = lathe([(0.0, -0.111), (0.026, -0.111), (0.026, 0.111), (0.0, 0.111)], 20).turned("yzx")
    panel = rounded((-0.086, -0.004), (0.086, 0.040), [0.014] * 4, 4)
    face = extrude(panel, [(0, 0.040), (0, 0.0545), (0.0015, 0.0555)]).turned("zxy")
    eye = lathe(
        [(0.0, 0.0), (0.0095, 0.0), (0.0095, 0.0008), (0.007, 0.0012), (0.005, 0.0004), (0.0, 0.0001)], 16
    ).turned("zxy")
    eyes = [eye.at(0.0552, y, 0.018) for y in (0.020, 0.045, -0.040)]
    return {
        "shell": (BLUE, shell),
        "pivot": (DARK, pivot),
        "face": (BLACK, face),
        "eyes": (LENS, sum(eyes[1:], eyes[0])),
    }


def estop() -> dict:
    """The red button; it is pushed along +z."""
    cap = [
        (0.0, -0.0145),
        (0.011, -0.0142),
        (0.0160, -0.0125),
        (0.0174, -0.0095),
        (0.0174, -0.0055),
        (0.0150, -0.0035),
        (0, -0.0035),
    ]
    post = [(0.0, -0.004), (0.011, -0.004), (0.011, 0.0), (0.0174, 0.0), (0.0174, 0.0288), (0.0, 0.0288)]
    return {"cap": (RED, lathe(cap, 20)), "post": (DARK, lathe(post, 20))}


def laser() -> Mesh:
    """The scanner in the base's window."""
    outline = rounded((-0.0473, -0.0189), (0.0281, 0.0189), [0.0180, 0.004, 0.004, 0.0180], 5)
    return extrude(
        outline,
        [
            (0.002, 0.0349),
            (0, 0.0369),
            (0, 0.046),
            (0.003, 0.048),
            (0.003, 0.054),
            (0, 0.056),
            (0, 0.0597),
            (0.002, 0.0617),
        ],
    )


def body_shells() -> dict:
    """Link to name of the piece to its colour and its mesh."""
    return {
        "base_link": base(),
        "r_wheel_link": {"shell": (BLUE, wheel(-1))},
        "l_wheel_link": {"shell": (BLUE, wheel(1))},
        "torso_fixed_link": {"shell": (BLUE, column())},
        "torso_lift_link": {"shell": (WHITE, torso_lift())},
        "bellows_link2": {"shell": (BLACK, pleats(-0.2983, 0.0285, 13, 0.0))},
        "bellows_link": {
            "shell": (
                BLACK,
                extrude(
                    rounded((-0.022, -0.141), (0.035, 0.141), [0.016, 0.003, 0.003, 0.016], 3),
                    [(0, -0.297), (0, 0.0285)],
                ),
            )
        },
        "bellows_skirt_link": {"shell": (BLACK, pleats(-0.030, 0.110, 6, 0.0075))},
        "head_pan_link": {"shell": (GREY, head_pan())},
        "head_tilt_link": head_tilt(),
        "estop_link": estop(),
        "laser_link": {"shell": (BLACK, laser())},
    }
