"""Punctuation and the signs of sums, the same for both hands; dots are drawn as that of an i is.

Units and headings as in `letter_curves.py`; headings E, N, W, S are right, up, left, down.
"""

from letter_curves import E, Letter, S

# The top of a sign on its head: its dot is where a small letter ends, its foot hangs below.
TURNED_TOP = 1.00


def on_its_head(sign: Letter, wide: float) -> Letter:
    """Return a sign after half a turn, written from its top; `wide` is the sum of its sides."""
    high = TURNED_TOP + min(point[1] for stroke in sign for point in stroke)
    return [
        [(wide - x, high - y, *headings[::-1]) for x, y, *headings in reversed(stroke)]
        for stroke in sign
    ]


# fmt: off
SIGNS: dict[str, Letter] = {
    ".": [
        [(0.04, 0.11), (0.07, 0.01)],
    ],
    ",": [
        [(0.12, 0.12), (0.13, -0.04), (0.02, -0.24)],
    ],
    ";": [
        [(0.09, 0.72), (0.12, 0.62)],
        [(0.12, 0.12), (0.13, -0.04), (0.02, -0.24)],
    ],
    ":": [
        [(0.04, 0.72), (0.07, 0.62)],
        [(0.04, 0.11), (0.07, 0.01)],
    ],
    "!": [
        [(0.06, 1.84), (0.05, 1.15), (0.05, 0.46)],
        [(0.04, 0.11), (0.07, 0.01)],
    ],
    "?": [
        [(0.03, 1.48), (0.38, 1.85, E), (0.74, 1.46, S), (0.52, 1.02), (0.38, 0.46, 268)],
        [(0.37, 0.11), (0.40, 0.01)],
    ],
    "'": [
        [(0.08, 1.88), (0.07, 1.72), (0.03, 1.54)],
    ],
    '"': [
        [(0.08, 1.88), (0.07, 1.72), (0.03, 1.54)],
        [(0.36, 1.88), (0.35, 1.72), (0.31, 1.54)],
    ],
    "-": [
        [(0.02, 0.50), (0.26, 0.51), (0.50, 0.51)],
    ],
    "(": [
        [(0.40, 1.96), (0.03, 0.86, S), (0.40, -0.24)],
    ],
    ")": [
        [(0.03, 1.96), (0.40, 0.86, S), (0.03, -0.24)],
    ],
    "«": [
        [(0.36, 0.84), (0.19, 0.67), (0.02, 0.50, None, None), (0.19, 0.33), (0.36, 0.16)],
        [(0.72, 0.84), (0.55, 0.67), (0.38, 0.50, None, None), (0.55, 0.33), (0.72, 0.16)],
    ],
    "»": [
        [(0.02, 0.84), (0.19, 0.67), (0.36, 0.50, None, None), (0.19, 0.33), (0.02, 0.16)],
        [(0.38, 0.84), (0.55, 0.67), (0.72, 0.50, None, None), (0.55, 0.33), (0.38, 0.16)],
    ],
    "+": [
        [(0.02, 0.85), (0.38, 0.86), (0.74, 0.86)],
        [(0.38, 1.22), (0.38, 0.86), (0.37, 0.50)],
    ],
    "=": [
        [(0.02, 1.04), (0.36, 1.05), (0.70, 1.05)],
        [(0.02, 0.66), (0.36, 0.67), (0.70, 0.67)],
    ],
    "/": [
        [(0.66, 1.96), (0.34, 0.86), (0.02, -0.24)],
    ],
}
SIGNS |= {"¿": on_its_head(SIGNS["?"], 0.77), "¡": on_its_head(SIGNS["!"], 0.11)}
# fmt: on
