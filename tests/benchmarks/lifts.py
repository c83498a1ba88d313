"""How sure, and how quick, the pad's verdict is when the pen is lifted.

Seeded faults over our whole alphabet, and letters as they are taught by writers drawn by lot: the
share of strokes and reasons that are right, of alarms that are false, and processor time.
"""

import time
from typing import Any

import numpy as np

from dmp_teach import StrokeVerdict, judge_stroke, recording_of
from tests.scoring.test_strokes import PLAIN, seeded
from tests.studies.pupils import Pupil

WRITERS = range(100, 108)
AT_LEAST, AT_MOST, SOON = 0.95, 0.02, 0.05


def lifts() -> dict[str, Any]:
    """The shares, and the median and the slowest of all verdicts [s]."""
    seconds: list[float] = []

    def judge(*given: Any) -> StrokeVerdict:
        begin = time.process_time()
        verdict = judge_stroke(*given)
        seconds.append(time.process_time() - begin)
        return verdict

    judge_stroke(recording_of("a"), recording_of("a"))  # what is loaded once
    right = []
    for written, model, number, reasons in seeded(0.3, PLAIN):
        verdict = judge(written, model)
        right.append(verdict.stroke == number and verdict.reason in reasons)
    alarms = []
    for seed in WRITERS:
        for character in PLAIN:
            model, written = (
                recording_of(character).strokes(),
                Pupil(seed).writes(character).strokes,
            )
            if len(written) == len(model):
                so_far = [judge(written[: n + 1], model) for n in range(len(written))]
                alarms.append(not all(verdict.good for verdict in so_far))
    return {
        "faults": len(right),
        "right": float(np.mean(right)),
        "letters": len(alarms),
        "alarms": float(np.mean(alarms)),
        "median_s": float(np.median(seconds)),
        "slowest_s": max(seconds),
    }


def lines(found: dict[str, Any]) -> list[str]:
    """The figures as plain lines."""
    return [
        "",
        "At the pen's lift",
        f"{100 * found['right']:.1f} % of {found['faults']} seeded faults told, of "
        f"{100 * AT_LEAST:.0f} %; {100 * found['alarms']:.1f} % of {found['letters']} letters "
        f"stopped for nothing, of {100 * AT_MOST:.0f} %",
        f"{1e3 * found['median_s']:.0f} ms of processor time in the median, "
        f"{1e3 * found['slowest_s']:.0f} ms at most, of {1e3 * SOON:.0f} ms",
    ]
