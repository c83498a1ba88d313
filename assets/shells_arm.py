"""The arm's shells: drums that bend, tubes that turn, gripper and pen, in the links' frames [m]."""

import numpy as np
from look import BLACK, BLUE, DARK, GREY, WHITE, smooth
from meshing import Mesh, extrude, lathe, rounded, sections

RADIUS = 0.052  # of every tube of the arm
SEAM = 0.0008  # half of the gap in the middle of a bending joint
AROUND = 32


def drum(radius: float, out: float, inner: float) -> Mesh:
    """Return half of a bending joint: from the seam to a ringed cap at y = out, a spindle on -y."""
    r, b = radius, 0.009
    profile = [
        (0.0, -inner),
        (0.84 * r, -inner),
        (0.84 * r, SEAM),
        (r - 0.0015, SEAM),
        (r, SEAM + 0.0015),
    ]
    profile += [
        (r - b + b * np.cos(a), out - b + b * np.sin(a)) for a in np.radians([0, 30, 60, 90])
    ]
    profile += [
        (0.74 * r, out),
        (0.71 * r, out - 0.002),
        (0.66 * r, out - 0.002),
        (0.63 * r, out),
        (0.0, out),
    ]
    return lathe(profile, AROUND).turned("yzx")


def neck(out: float, radius: float, start: float, end: float) -> list[tuple[float, ...]]:
    """Sections from the heart of a drum (beside the seam, on +y) to a round tube on the axis."""
    rows = []
    inside, half = (SEAM + out - 0.010) / 2, (out - 0.010 - SEAM) / 2
    for x in (0.0, *np.linspace(start, end, 6)):
        s = smooth((x - start) / (end - start))
        height = radius - 0.006 + s * (RADIUS - radius + 0.006)
        rows.append((x, (1 - s) * inside, 0.0, half + s * (RADIUS - half), height, 4.5 - 2.5 * s))
    return rows


def tube_end(x: float) -> list[tuple[float, ...]]:
    """Return the sections that end a tube at x: a bevel, and the stub of the next link."""
    rings = ((x - 0.0040, RADIUS), (x - 0.0020, RADIUS - 0.0015), (x - 0.0020, 0.046), (x, 0.046))
    return [(at, 0.0, 0.0, r, r, 2.0) for at, r in rings]


def tube_start(x: float) -> list[tuple[float, ...]]:
    """Return the sections that begin a tube at x with a small bevel."""
    return [
        (x, 0.0, 0.0, RADIUS - 0.0015, RADIUS - 0.0015, 2.0),
        (x + 0.0020, 0.0, 0.0, RADIUS, RADIUS, 2.0),
    ]


def bends(radius: float, out: float, length: float) -> Mesh:
    """Return a link that bends about its own y: its half of the drum on +y, then a tube along x."""
    end = min(0.105, length - 0.012)
    return drum(radius, out, -SEAM) + sections(
        neck(out, radius, 0.030, end) + tube_end(length), AROUND
    )


def turns(start: float, elbow: float, out: float) -> Mesh:
    """Return a link that turns about its x: a tube from `start`, then half a drum on -y."""
    half = drum(RADIUS, out, 0.004).mirrored("y").at(elbow, 0, 0)
    length = min(0.105, elbow - start - 0.006)
    rows = [(elbow - x, -y, z, a, b, n) for x, y, z, a, b, n in neck(out, RADIUS, 0.030, length)]
    return half + sections(rows + tube_start(start)[::-1], AROUND)


def shoulder_pan() -> Mesh:
    """Return an upright tube that carries half of the shoulder's drum in front of it."""
    post = [(RADIUS - 0.0015, -0.048), (RADIUS, -0.046), (RADIUS, 0.030)]
    post += [(RADIUS * np.cos(a), 0.030 + 0.034 * np.sin(a)) for a in np.radians([22, 45, 67, 90])]
    half = drum(0.0605, 0.0745, 0.004).mirrored("y").at(0.117, 0, 0.06)
    rows = []
    for x in np.linspace(0.0, 0.117, 8):
        s = smooth(x / 0.100)
        rows.append(
            (x, -0.032 * s, 0.010 + 0.050 * s, 0.046 - 0.016 * s, 0.048 + 0.006 * s, 2.6 + 1.6 * s)
        )
    return lathe(post, AROUND) + half + sections(rows, 24)


def wrist_roll() -> Mesh:
    """Return a short ring between the wrist and the gripper."""
    rows = tube_start(-0.023)
    rings = ((0.006, RADIUS), (0.012, RADIUS - 0.002), (0.017, 0.046), (0.0195, 0.041))
    return sections(rows + [(x, 0.0, 0.0, r, r, 2.0) for x, r in rings], AROUND)


def palm() -> Mesh:
    """Return the gripper's body: round at the wrist, wide and flat at the fingers."""
    rows = [(-0.154, 0.0, 0.0, 0.039, 0.039, 2.0), (-0.138, 0.0, 0.0, 0.0395, 0.0395, 2.0)]
    for x in np.linspace(-0.130, -0.100, 5):
        s = smooth((x + 0.134) / 0.036)
        rows.append((x, 0.0, 0.0, 0.0395 + 0.0236 * s, 0.0398 - 0.001 * s, 2.0 + 3.0 * s))
    rows += [(-0.046, 0.0, 0.0, 0.0631, 0.034, 5.0), (-0.039, 0.0, 0.0, 0.0605, 0.031, 5.0)]
    return sections([*rows, (-0.036, 0.0, 0.0, 0.056, 0.0265, 5.0)], AROUND)


def rail() -> Mesh:
    """Return the rail that the fingers slide on."""
    outline = rounded((-0.054, -0.0145), (0.054, 0.0145), [0.004], 2)
    return extrude(outline, [(0, -0.040), (0, -0.0325), (0.001, -0.0315)]).turned("zxy")


def finger() -> Mesh:
    """Return the right finger, on +y of the gripper; its flat face looks towards -y."""
    outline = rounded((-0.029, -0.0132), (0.031, 0.0132), [0.006, 0.002, 0.002, 0.006], 3)
    profile = [(0.0012, -0.0157), (0.0, -0.0145), (0.0, -0.0044), (0.0030, -0.0014)]
    return extrude(outline, profile).turned("xzy")


def pen() -> dict:
    """Return a pen along z; its nib ends at `pen_tip`, 95 mm out, which carries the last 2 mm."""
    barrel = [
        (0.0, -0.031),
        (0.0030, -0.031),
        (0.0050, -0.028),
        (0.0050, 0.066),
        (0.0044, 0.068),
        (0.0, 0.068),
    ]
    nib = [
        (0.0, 0.064),
        (0.0040, 0.066),
        (0.0040, 0.071),
        (0.0017, 0.086),
        (0.0009, 0.0935),
        (0.0, 0.0935),
    ]
    cap = [(0.0, -0.036), (0.0034, -0.036), (0.0040, -0.034), (0.0040, -0.030), (0.0, -0.030)]
    ball = [(0.0, -0.002), (0.0008, -0.002), (0.0007, -0.0006), (0.0004, -0.0001), (0.0, 0.0)]
    return {
        "pen_link": {
            "barrel": (BLUE, lathe(barrel, 16)),
            "nib": (DARK, lathe(nib, 16) + lathe(cap, 16)),
        },
        "pen_tip": {"ball": (BLACK, lathe(ball, 8))},
    }


def arm_shells() -> dict:
    """Link to name of the piece to its colour and its mesh."""
    sleeve = [
        (0.0, -0.015),
        (0.0068, -0.015),
        (0.008, -0.0138),
        (0.008, 0.0138),
        (0.0068, 0.015),
        (0.0, 0.015),
    ]
    right = finger()
    return {
        "shoulder_pan_link": {"shell": (WHITE, shoulder_pan())},
        "shoulder_lift_link": {"shell": (BLUE, bends(0.0597, 0.0705, 0.172))},
        "upperarm_roll_link": {"shell": (WHITE, turns(-0.048, 0.133, 0.0705))},
        "elbow_flex_link": {"shell": (BLUE, bends(RADIUS, 0.0705, 0.166))},
        "forearm_roll_link": {"shell": (WHITE, turns(-0.032, 0.1245, 0.087))},
        "wrist_flex_link": {"shell": (BLUE, bends(RADIUS, 0.067, 0.1165))},
        "wrist_roll_link": {"shell": (WHITE, wrist_roll())},
        "gripper_link": {"palm": (DARK, palm()), "rail": (GREY, rail())},
        "r_gripper_finger_link": {"shell": (GREY, right)},
        "l_gripper_finger_link": {"shell": (GREY, right.mirrored("y"))},
        "pen_holder_link": {"shell": (BLACK, lathe(sleeve, 16))},
    } | pen()
