"""How surely a robot is taught: `python -m tests.benchmarks.teaching [--minutes 20]`.

A simulated teacher shows our own letter turn by turn, and answers what is asked, over our 62 plain
letters, all faults and all pupils, in an order drawn by lot.
"""

import argparse
import random
import time
import warnings
from itertools import product

from dmp_teach.ink import characters
from tests.classroom.test_teaching import FAULTY, TURNS, teach

GOOD_AT_LEAST = 0.95
FARTHER = 1e-4  # than where it began: less is rounding [m]
Pair = tuple[str, str]


def teaching(minutes: float) -> dict[str, list[Pair]]:
    """Who was taught which letter, and of those: not good in time, farther, forgotten, lost."""
    pairs = list(product(FAULTY, characters()[:62]))
    random.Random(0).shuffle(pairs)
    found: dict[str, list[Pair]] = {
        name: [] for name in ("taught", "not good", "farther", "forgotten", "lost")
    }
    until = time.monotonic() + 60 * minutes
    for name, letter in pairs:
        if time.monotonic() > until:
            break
        (first, last), good, again = teach(letter, FAULTY[name])
        is_so = {"taught": True, "not good": good is None, "farther": last > first + FARTHER}
        is_so |= {"forgotten": bool(again), "lost": not all(again)}
        for kind, holds in is_so.items():
            found[kind] += [(name, letter)] * holds
    return found


def lines(found: dict[str, list[Pair]]) -> list[str]:
    """The shares as plain lines, and who is behind them."""
    number = {kind: len(pairs) for kind, pairs in found.items()}
    good = 1 - number["not good"] / max(number["taught"], 1)
    told = [
        f"{100 * good:.1f} % of {number['taught']} pairs of {len(FAULTY)} pupils and 62 letters "
        f"good within {TURNS} turns, of {100 * GOOD_AT_LEAST:.0f} %",
        f"{number['farther']} end farther than they began, of 0",
        f"{number['forgotten']} forget a good letter, and {number['lost']} are not good again, of "
        "0",
    ]
    return told + [f"{kind}: {found[kind]}" for kind in ("not good", "farther", "lost")]


def main() -> None:
    """Teach, and print."""
    asked = argparse.ArgumentParser(prog="python -m tests.benchmarks.teaching", description=__doc__)
    asked.add_argument("--minutes", type=float, default=20, help="when to stop (default 20)")
    warnings.simplefilter("ignore", RuntimeWarning)
    print("\n".join(lines(teaching(asked.parse_args().minutes))))


if __name__ == "__main__":
    main()
