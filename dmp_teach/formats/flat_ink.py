"""What the formats of flat ink share: where a letter stands, how large it is, and its label."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from dmp_teach.errors import RecordingError
from dmp_teach.files import is_pseudonym
from dmp_teach.formats.safe_xml import finite_number
from dmp_teach.ink import Recording, add_lifts
from dmp_teach.trajectory import Array, Trajectory

LARGEST_INK = 4.0  # no hand that writes moves farther [m]
SMALLEST_INK = 0.0005  # or less [m]
USUAL_HEIGHT = 0.05  # of a letter where a file says no unit [m]
LONGEST_LABEL = 40  # a longer text is no label ...
LONGEST_OWN_LABEL = 1000  # ... but in a file of ours, where it can be nothing else


def flat_recording(
    strokes: Sequence[Trajectory],
    pressures: Sequence[Array] | None = None,
    origin: ArrayLike | None = None,
    *,
    character: str | None = None,
    writer: str | None = None,
    baseline: float | None = None,
) -> Recording:
    """Return a recording of flat ink; its clock begins at 0, its origin is its lower left corner.

    Args:
        strokes: 2-D, x to the right and y up, on one clock [m].
        pressures: 0 to 1, shape (T,) for each stroke; or None.
        origin: Where the page's origin is, where the file says so, shape (2,) [m].
        character: The letter.
        writer: A pseudonym.
        baseline: Where the writing line is [m].

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
        character=character,
        writer=writer,
        baseline=baseline,
    )


def check_size(strokes: Sequence[Array]) -> None:
    """Raise a RecordingError where strokes (K, 2) are not finite, or no hand writes that size."""
    with np.errstate(all="ignore"):
        ink = np.concatenate(strokes)
        size = float(np.ptp(ink, axis=0).max()) if np.isfinite(ink).all() else np.inf
    if not SMALLEST_INK < size < LARGEST_INK:
        raise RecordingError(
            f"the ink is {size:.4g} m large, but must be {SMALLEST_INK} to {LARGEST_INK} m; is "
            "its unit right?"
        )


def check_place(corner: Array, origin: ArrayLike) -> None:
    """Raise a RecordingError where the ink's lower left corner is too far from the page's origin.

    Args:
        corner: Shape (2,) [m].
        origin: Shape (2,) [m].
    """
    away = np.asarray(origin) - corner
    if not (np.abs(away) < LARGEST_INK).all():
        raise RecordingError(
            f"the page's origin is {away} m from the ink, but no page is so large; move the ink."
        )


def check_flat(strokes: Sequence[Array], suffix: str) -> None:
    """Raise a RecordingError where strokes (K, 2) in a file could not be read again.

    Args:
        strokes: Shape (K, 2) each [m].
        suffix: What they are to be written as.
    """
    try:
        check_size(strokes)
        check_place(np.concatenate(strokes).min(axis=0), (0.0, 0.0))
    except RecordingError as error:
        raise RecordingError(
            f"This cannot be written as {suffix}: {error} A .json file keeps any ink."
        ) from None


def lengths_in_mm(text: str | None, count: int) -> Array | None:
    """Return the lengths [m] that we wrote into a file in mm with spaces between; None for others.

    Args:
        text: What the file says.
        count: How many there must be.
    """
    numbers = [finite_number(word) for word in (text or "").split()[: count + 1]]
    known = [number for number in numbers if number is not None]
    return np.array(known) / 1000 if len(known) == len(numbers) == count else None


def usual_scale(letters: Sequence[Sequence[Array]]) -> float:
    """Return what makes the median height of letters without a unit 50 mm.

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
    return USUAL_HEIGHT / high


def label_from(text: str | None) -> str | None:
    """Return a letter's label without the spaces round it; None for a text too long for one."""
    label = " ".join((text or "").split())
    return label if 0 < len(label) <= LONGEST_LABEL else None


def own_label(text: str | None) -> str | None:
    """Return a label that we wrote into a file ourselves, every sign of it."""
    return text if text is not None and len(text) <= LONGEST_OWN_LABEL else None


def pseudonym_from(text: str | None) -> str | None:
    """Return a pseudonym; None for anything that could be a name."""
    writer = (text or "").strip()
    return writer if is_pseudonym(writer) else None
