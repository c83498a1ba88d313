"""How accents look; Unicode knows which letter carries which ("ä" is "a" and a diaeresis).

Units and headings as in `letter_curves.py`. A mark is drawn around x = 0 and over a small letter;
it is written after the letter, and takes the place of the dot of an i.
"""

from unicodedata import normalize

from letter_curves import E, Letter, N, S, W

SMALL = "áàâãäåçéèêëíìîïñóòôõöúùûüÿ"
ACCENTED = SMALL + SMALL.upper()
"""Small letters of German, French, Spanish, Portuguese, Italian and Swedish, and their capitals."""

# fmt: off
MARKS: dict[str, Letter] = {
    "\N{COMBINING DIAERESIS}": [[(-0.21, 1.43), (-0.18, 1.33)], [(0.17, 1.43), (0.20, 1.33)]],
    "\N{COMBINING ACUTE ACCENT}": [[(0.17, 1.54), (0.02, 1.40), (-0.12, 1.25)]],
    "\N{COMBINING GRAVE ACCENT}": [[(-0.17, 1.54), (-0.02, 1.40), (0.12, 1.25)]],
    "\N{COMBINING CIRCUMFLEX ACCENT}": [[(-0.25, 1.24), (-0.12, 1.38), (0.00, 1.52, None, None),
                                         (0.12, 1.38), (0.25, 1.24)]],
    "\N{COMBINING TILDE}": [[(-0.30, 1.30), (-0.14, 1.42), (0.12, 1.32), (0.29, 1.45)]],
    "\N{COMBINING RING ABOVE}": [[(0.00, 1.56), (-0.16, 1.40, S), (0.00, 1.24, E), (0.16, 1.40, N),
                                  (0.01, 1.56)]],
    "\N{COMBINING CEDILLA}": [[(0.02, -0.01), (-0.03, -0.17, None, None), (0.18, -0.32, S),
                               (0.00, -0.46, W), (-0.18, -0.38)]],
}
OVER = {  # where the middle of the mark is, in the round hand and in the slanted one
    "a": (0.47, 0.55),
    "c": (0.48, 0.36),
    "e": (0.48, 0.50),
    "i": (0.05, 0.20),
    "n": (0.43, 0.46),
    "o": (0.47, 0.50),
    "u": (0.43, 0.50),
    "y": (0.43, 0.50),
    "A": (0.72, 0.88),
    "C": (0.74, 0.60),
    "E": (0.47, 0.54),
    "I": (0.36, 0.40),
    "N": (0.66, 0.80),
    "O": (0.76, 0.80),
    "U": (0.60, 0.64),
    "Y": (0.62, 0.60),
}
# fmt: on
BELOW = "\N{COMBINING CEDILLA}"
RISE = 0.88  # how much higher a capital carries its mark
WIDE = (1.0, 1.25)  # how wide each hand draws a mark: the letters of the slanted one are narrow


def accented(shapes: dict[str, Letter], hand: int) -> dict[str, Letter]:
    """Return the letters of one hand with their marks: 0 is the round hand, 1 the slanted one."""
    return {
        character: _marked(shapes, *normalize("NFD", character), hand) for character in ACCENTED
    }


def _marked(shapes: dict[str, Letter], base: str, mark: str, hand: int) -> Letter:
    """Return the strokes of a letter, and then those of its mark."""
    letter = shapes[base][:1] if base == "i" else shapes[base]
    x, y = OVER[base][hand], RISE if base.isupper() and mark != BELOW else 0.0
    drawn = [
        [(WIDE[hand] * px + x, py + y, *headings) for px, py, *headings in stroke]
        for stroke in MARKS[mark]
    ]
    return letter + drawn
