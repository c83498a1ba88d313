"""Write our alphabets.

`python3 assets/make_alphabets.py` makes alphabets/round and alphabets/slanted beside itself. What
the letters are stands in `shapes_*.py`: for every stroke a few points placed by hand, in the order
and direction that are taught at school. How a hand moves along them stands in `letter_curves.py`
and `letter_hand.py`. Running it twice gives the same bytes.
"""

import argparse
import sys
from pathlib import Path

from letter_hand import Hand, write
from shapes_digits import DIGITS
from shapes_marks import accented
from shapes_round import ROUND
from shapes_signs import SIGNS
from shapes_slanted import SLANTED

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))  # the script also runs where dmp_teach is not installed

from dmp_teach.ink.alphabet import file_name  # noqa: E402
from dmp_teach.ink.recording import Recording  # noqa: E402
from dmp_teach.ink.recording_json import write_json  # noqa: E402

ALPHABETS = {
    "round": (
        Hand(
            "writer-1",
            0.072,
            0.98,
            slant=0.03,
            pace=0.142,
            haste=1.1,
            softness=0.035,
            wobble=0.0006,
            lift=0.022,
        ),
        ROUND | DIGITS | accented(ROUND, 0) | SIGNS,
    ),
    "slanted": (
        Hand(
            "writer-2",
            0.062,
            0.76,
            slant=0.26,
            pace=0.180,
            haste=1.4,
            softness=0.032,
            wobble=0.0005,
            lift=0.026,
        ),
        SLANTED | DIGITS | accented(SLANTED, 1) | SIGNS,
    ),
}


def recording(alphabet: str, character: str) -> Recording:
    """Return a letter as its writer writes it; its strokes are left to be found from the height."""
    hand, shapes = ALPHABETS[alphabet]
    samples, _ = write(character, shapes[character], hand)
    return Recording(samples[:, 0], samples[:, 1:], character, hand.writer, baseline=0.0)


def main(into: Path) -> None:
    """Write every letter of every alphabet."""
    for alphabet, (_, shapes) in ALPHABETS.items():
        folder = into / alphabet
        folder.mkdir(parents=True, exist_ok=True)
        for character in shapes:
            write_json(recording(alphabet, character), folder / file_name(character))


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--into", type=Path, default=HERE / "alphabets", help="the folder to write")
    main(parser.parse_args().into)
