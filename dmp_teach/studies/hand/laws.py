"""Two laws of a hand in its own ink: bends are slow, and large letters take hardly longer."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from dmp_teach.arguments import checked
from dmp_teach.studies.hand.power_law import UNKNOWN, Bends, Exponent, measure_power_law
from dmp_teach.studies.inputs import RecordingsLike, Written, list_letters
from dmp_teach.texts import gettext as _
from dmp_teach.trajectory import Array
from dmp_teach.values import Value, locked

# Sizes that are nearer to one another say nothing of how the time grows [ratio].
LEAST_SIZE_RATIO = 1.5


@dataclass(frozen=True, eq=False, repr=False)
class HandLaws(Value):
    """What a hand does, of W writings.

    Args:
        bending: beta of the power law, v = gain * curvature^(-beta); 1/3 in a hand.
        growth: p of the time over the size, T ~ size^p; near 0 in a hand (isochrony).
        bends: The bends that were measured, stroke by stroke.
        sizes: The larger side of each writing, shape (W,) [m].
        durations: How long the pen was down, shape (W,) [s].
        is_quick: Which were written as quickly as the writer could, shape (W,).
    """

    bending: Exponent
    growth: Exponent
    bends: tuple[Bends, ...]
    sizes: Array
    durations: Array
    is_quick: NDArray[np.bool_]

    @property
    def haste(self) -> float:
        """How many times as fast, in letter sizes a second, the quick writings are."""
        pace = self.sizes / self.durations
        return float(pace[self.is_quick].mean() / pace[~self.is_quick].mean())

    def __repr__(self) -> str:
        """Say each law in a line."""
        lines = [
            _("Your speed falls as curvature^{exponent}; two-thirds power law: -0.33").format(
                exponent=_in_words(self.bending, -1)
            )
            if np.isfinite(self.bending.value)
            else _("Too few bends were seen to tell how your speed falls; write larger or longer.")
        ]
        if np.isfinite(self.growth.value):
            said = _("Your time grows as size^{exponent}; isochrony: 0")
            lines.append(said.format(exponent=_in_words(self.growth, 1)))
        if self.is_quick.any() and not self.is_quick.all():
            lines.append(_("In haste you are {times:.1f} times as fast.").format(times=self.haste))
        return "\n".join(lines)


@checked
def measure_hand(recordings: RecordingsLike, quick: RecordingsLike = None) -> HandLaws:
    """Measure the two-thirds power law and isochrony in ink.

    Args:
        recordings: Writings of one hand at its usual pace, small and large, such as
            `pad.recordings`; of several letters, each is compared with itself. None: our alphabets.
        quick: Writings as quick as the hand can. They count for the power law alone.

    Returns:
        Both exponents, with an interval of 95 % each: of the power law over pieces of strokes, of
        the time over writings, three at least.

    Raises:
        RecordingError: Something that no letter can be read from, or nothing at all.
    """
    usual = list_letters(recordings)
    fast = () if quick is None else list_letters(quick)
    letters = usual + fast
    strokes = [stroke for letter in letters for stroke in letter.strokes]
    found = measure_power_law(strokes, [each.size for each in letters for _stroke in each.strokes])
    return HandLaws(
        UNKNOWN if found is None else found.exponent(),
        _measure_growth(usual),
        () if found is None else found.bends,
        locked([each.size for each in letters]),
        locked([_duration(each) for each in letters]),
        locked([False] * len(usual) + [True] * len(fast), dtype=bool),
    )


def _measure_growth(letters: tuple[Written, ...]) -> Exponent:
    """Return the exponent of the duration over the size, each letter compared with itself."""
    names = sorted({each.character for each in letters})
    points = np.log([(each.size, _duration(each)) for each in letters])
    for name in names:
        same = [each.character == name for each in letters]
        points[same] -= points[same].mean(axis=0)
    x, y = points.T
    if np.ptp(x) < np.log(LEAST_SIZE_RATIO):
        return UNKNOWN
    slope = (x @ y) / (x @ x)
    freedom = len(letters) - len(names) - 1
    if freedom < 1:
        return Exponent(float(slope), np.nan, np.nan)
    error = np.sqrt(((y - slope * x) ** 2).sum() / freedom / (x @ x))
    return Exponent.around(slope, float(error), freedom)


def _duration(letter: Written) -> float:
    """Return how long the pen was down [s]."""
    return sum(stroke.duration for stroke in letter.strokes)


def _in_words(exponent: Exponent, sign: int) -> str:
    """Return an exponent and its interval as one writes them."""
    said = f"{sign * exponent.value:.2f}"
    if np.isfinite(exponent.low):
        said += f" ({exponent.low:.2f} to {exponent.high:.2f})"
    return said
