"""What the readers of flat ink share: where a letter stands, how large it is, and its label."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from dmp_teach.errors import RecordingError
from dmp_teach.files import is_pseudonym
from dmp_teach.formats.safe_xml import number_of
from dmp_teach.ink import Recording, add_lifts
from dmp_teach.trajectory import Array, Trajectory

LARGEST = 4.0  # no hand that writes moves farther [m]
SMALLEST = 0.0005  # or less [m]
USUAL = 0.05  # how high a letter is taken to be where a file says no unit [m]
LONGEST_LABEL = 40  # a longer text is no label ...
LONGEST_OWN = 1000  # ... but in a file of ours, where it can be nothing else


def flat_recording(
    strokes: Sequence[Trajectory],
    pressures: Sequence[Array] | None = None,
    origin: ArrayLike | None = None,
    **about: Any,
) -> Recording:
    """A recording of flat ink: its clock begins at 0, and its origin is the lower left corner of the ink.

    Args:
        strokes: 2-D, x to the right and y up, on one clock [m].
        pressures: 0 to 1, shape (T,) for each stroke; or None.
        origin: Where the page's origin is, where the file says so, shape (2,) [m].
        **about: The recording's `character`, `writer` and `baseline`.

    Raises:
        RecordingError: The ink is far larger or smaller than a hand's, or as `add_lifts`.
    """
    ink = [stroke.position for stroke in strokes]
    check_size(ink)
    corner = np.concatenate(ink).min(axis=0)
    shift = corner if origin is None else np.asarray(origin)
    check_place(corner, shift)
    begin = strokes[0].t[0]
    return add_lifts(
        [Trajectory(stroke.t - begin, stroke.position - shift) for stroke in strokes],
        pressures,
        **about,
    )


def check_size(strokes: Sequence[Array]) -> None:
    """Raise a RecordingError where strokes, points (K, 2) each, are not finite, or no hand writes so large or small."""
    with np.errstate(all="ignore"):
        ink = np.concatenate(strokes)
        size = float(np.ptp(ink, axis=0).max()) if np.isfinite(ink).all() else np.inf
    if not SMALLEST < size < LARGEST:
        raise RecordingError(
            f"the ink is {size:.4g} m large, but must be {SMALLEST} to {LARGEST} m; is its unit right?"
        )


def check_place(corner: Array, origin: ArrayLike) -> None:
    """Raise a RecordingError where the ink's lower left corner is too far from its page's origin, (2,) each [m]."""
    away = np.asarray(origin) - corner
    if not (np.abs(away) < LARGEST).all():
        raise RecordingError(
            f"the page's origin is {away} m from the ink, but no page is so large; move the ink."
        )


def millimetres(text: str | None, count: int) -> Array | None:
    """So many lengths [m] that we wrote into a file ourselves, in mm with spaces between; None where there are none."""
    numbers = [number_of(word) for word in (text or "").split()[: count + 1]]
    return (
        None if len(numbers) != count or None in numbers else np.array(numbers, dtype=float) / 1000
    )


def usual_scale(letters: Sequence[Sequence[Array]]) -> float:
    """By how much letters without a unit are multiplied [m]: the median of their heights comes to 50 mm.

    Args:
        letters: For each letter its strokes, points (K, 2).

    Raises:
        RecordingError: Their heights are no numbers, or 0.
    """
    with np.errstate(all="ignore"):
        sizes = [np.ptp(np.concatenate(strokes), axis=0) for strokes in letters]
    high = float(np.median([height if height > 0.2 * width else width for width, height in sizes]))
    if not 1e-100 < high < 1e100:
        raise RecordingError(
            f"the ink is {high:.4g} high, in a unit that the file does not say; is there any ink?"
        )
    return USUAL / high


def label_of(text: str | None) -> str | None:
    """A letter's label without the spaces round it; None for a text that is too long for one."""
    label = " ".join((text or "").split())
    return label if 0 < len(label) <= LONGEST_LABEL else None


def own_label(text: str | None) -> str | None:
    """A label that we wrote into a file ourselves, every sign of it."""
    return text if text is not None and len(text) <= LONGEST_OWN else None


def writer_of(text: str | None) -> str | None:
    """A pseudonym; None for anything that could be a name."""
    writer = (text or "").strip()
    return writer if is_pseudonym(writer) else None
