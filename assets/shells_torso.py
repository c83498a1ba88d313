"""The shells of torso and head, all in the links' own frames [m]."""

import numpy as np
from look import BLACK, BLUE, DARK, GREY, LENS, WHITE, table
from meshing import Array, Mesh, extrude, lathe, loft, rounded, superellipse

TRUNK = table("""
    # height back    front  half width, power
    0.0285  -0.1780  0.044  0.1600  5.0
    0.0330  -0.1840  0.050  0.1655  5.0
    0.1500  -0.1852  0.052  0.1665  5.0
    0.2600  -0.1852  0.050  0.1690  4.8
    0.3200  -0.1852  0.044  0.1708  4.5
    0.4300  -0.1852  0.042  0.1708  4.2
    0.4700  -0.1850  0.050  0.1705  4.0
    0.5000  -0.1840  0.072  0.1690  3.8
    0.5250  -0.1810  0.094  0.1650  3.6
    0.5500  -0.1750  0.109  0.1570  3.4
    0.5750  -0.1630  0.112  0.1440  3.2
    0.5920  -0.1460  0.106  0.1260  3.0
    0.6000  -0.1280  0.096  0.1080  2.8
    0.6030  -0.1100  0.084  0.0940  2.6
""")
CHIN = table("""
    # height front   half width
    0.1200   0.0490  0.0800
    0.1700   0.0900  0.0740
    0.2050   0.1280  0.0660
    0.2350   0.1560  0.0570
    0.2600   0.1685  0.0525
    0.2800   0.1715  0.0520
    0.2955   0.1715  0.0520
    0.2985   0.1690  0.0495
""")


def trunk() -> Mesh:
    """Return the white torso: column, shoulders, an overhang below the neck, a chin for the arm."""
    rings = []
    for height, back, front, half, power in TRUNK:
        outline = superellipse((front - back) / 2, half, power, 40) + np.array(
            [(front + back) / 2, 0.0]
        )
        rings.append(np.column_stack([outline, np.full(40, height)]))
    return loft(rings) + chin()


def chin() -> Mesh:
    """Return the shelf in front of the chest on which the shoulder turns."""
    rings = []
    for height, front, half in CHIN:
        outline = rounded(
            (0.0, -half), (front, half), [half - 0.0005, 0.004, 0.004, half - 0.0005], 7
        )
        rings.append(np.column_stack([outline, np.full(len(outline), height)]))
    return loft(rings)


def column() -> Mesh:
    """Return the blue back that the trunk slides on."""
    outline = rounded((-0.1683, -0.1553), (-0.0321, 0.1553), [0.012, 0.055, 0.055, 0.012], 5)
    return extrude(outline, [(0.004, -0.0186), (0, -0.0146), (0, 0.4373), (0.006, 0.4433)])


def bellows_outline() -> Array:
    """Return the bellows from above, its folds at their widest."""
    return rounded((-0.0312, -0.1494), (0.0431, 0.1494), [0.024, 0.004, 0.004, 0.024], 3)


def pleats(low: float, high: float, count: int, inset: float) -> Mesh:
    """Return a folded sleeve around the lift: `count` folds between two heights."""
    heights = np.linspace(low, high, 2 * count + 1)
    folds = [(inset + (0.0 if fold % 2 else 0.006), height) for fold, height in enumerate(heights)]
    return extrude(bellows_outline(), folds)


def flanges() -> Mesh:
    """Return the two frames that hold the ends of the bellows."""
    low, high = (
        extrude(bellows_outline(), [(0, height), (0, height + 0.004)])
        for height in (-0.2983, 0.0242)
    )
    return low + high


def head_pan() -> dict:
    """Return a horseshoe around the back of the head, on a neck, with the pivots of the head."""
    flank, end, deep = (
        0.1262,
        0.1425,
        0.1181,
    )  # of its centre line: half width, ends, depth behind x = 0.01
    rings = []
    for angle in np.radians([84, 65, 45, 22, 0]):  # the round end on +y, seen from the side
        rings.append(upright(end + 0.055 * np.sin(angle), flank, (0.0, 1.0), 0.055 * np.cos(angle)))
    rings += [upright(x, flank, (0.0, 1.0), 0.055) for x in (0.095, 0.050)]
    for angle in np.radians(range(0, 90, 10)):
        across = np.array([-np.sin(angle) / deep, np.cos(angle) / flank])
        x, y = 0.010 - deep * np.sin(angle), flank * np.cos(angle)
        rings.append(upright(x, y, across / np.linalg.norm(across), 0.055))
    back = upright(0.010 - deep, 0.0, (-1.0, 0.0), 0.055)
    other = [ring * (1, -1, 1) for ring in rings[::-1]]
    inside = superellipse(0.0955, 0.114, 2.3, 32) + np.array([-0.0125, 0.0])
    seat = extrude(
        inside, [(0.012, 0.001), (0, 0.006), (0, 0.090), (0.003, 0.0945), (0.012, 0.097)]
    )
    neck = lathe([(0, -0.003), (0.062, -0.003), (0.066, 0.004), (0, 0.004)], 28)
    pivots = (
        lathe([(0, -0.112), (0.026, -0.112), (0.026, 0.112), (0, 0.112)], 20)
        .turned("yzx")
        .at(end, 0, 0.058)
    )
    return {"shell": (GREY, loft([*rings, back, *other]) + seat + neck), "pivots": (DARK, pivots)}


def upright(x: float, y: float, across: tuple[float, float] | Array, half: float) -> Array:
    """Return a section of the horseshoe, 34 mm thick, at a place on its centre line."""
    oval = superellipse(0.0168, half, 3.2, 16)
    return np.column_stack([np.array([x, y]) + oval[:, :1] * np.array(across), oval[:, 1] + 0.058])


def head_tilt() -> dict:
    """Return a blue box with round edges, and the dark face of its camera."""
    rings = []
    for y, shrink in ((0.105, 0.016), (0.103, 0.009), (0.097, 0.003), (0.088, 0.0)):
        outline = superellipse(0.0545 - shrink, 0.055 - shrink, 3.4, 28)
        rings.append(np.column_stack([outline[:, 0] - 0.0005, np.full(28, y), outline[:, 1]]))
    panel = rounded((-0.086, -0.004), (0.086, 0.040), [0.014], 4)
    lens = [
        (0.0, 0.0),
        (0.0095, 0.0),
        (0.0095, 0.0008),
        (0.007, 0.0012),
        (0.005, 0.0004),
        (0.0, 0.0001),
    ]
    eyes = [lathe(lens, 16).turned("zxy").at(0.0546, y, 0.018) for y in (0.020, 0.045, -0.040)]
    return {
        "shell": (BLUE, loft(rings + [ring * (1, -1, 1) for ring in rings[::-1]])),
        "face": (BLACK, extrude(panel, [(0, 0.040), (0, 0.0541), (0.001, 0.0548)]).turned("zxy")),
        "eyes": (LENS, sum(eyes[1:], eyes[0])),
    }


def torso_shells() -> dict:
    """Link to name of the piece to its colour and its mesh."""
    return {
        "torso_fixed_link": {"shell": (BLUE, column())},
        "torso_lift_link": {"shell": (WHITE, trunk())},
        "bellows_link": {"shell": (BLACK, flanges())},
        "bellows_link2": {"shell": (BLACK, pleats(-0.2970, 0.0275, 13, 0.0))},
        "bellows_skirt_link": {"shell": (BLACK, pleats(-0.030, 0.110, 6, 0.0075))},
        "head_pan_link": head_pan(),
        "head_tilt_link": head_tilt(),
    }
