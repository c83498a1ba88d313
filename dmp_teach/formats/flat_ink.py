"""What the formats of flat ink share: letters on their clock, at their size, in their place.

Where a file does not say when the pen was where, a hand's pace does; where it says no unit, the
median height of its letters is taken for 50 mm.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from dmp_teach.errors import RecordingError, TrajectoryError
from dmp_teach.files import is_pseudonym
from dmp_teach.formats.hand_pace import LIFT_DURATION, at_hand_pace
from dmp_teach.formats.safe_xml import finite_number
from dmp_teach.ink import Recording, add_lifts
from dmp_teach.trajectory import Array, Trajectory

LARGEST_INK = 4.0  # no hand that writes moves farther [m]
SMALLEST_INK = 0.0005  # or less [m]
USUAL_HEIGHT = 0.05  # of a letter where a file says no unit [m]
LONGEST_LABEL = 40  # a longer text is no label ...
LONGEST_OWN_LABEL = 1000  # ... but in a file of ours, where it can be nothing else
TAP = 0.02  # how long a single point lasts [s]
LONGEST_STROKE = 3600.0  # [s]
MOST_FAULTS_TOLD = 3  # in a note
NO_UNIT = "The file says no unit of length: its letters are taken to be 50 mm high."
NO_INK = "has no stroke of a pen that was down, so there is no ink in it."
PIXELS = "Its pixels are read as 96 to the inch; some programs mean 72 or 90."
NO_TIMES = "The file says no times: the ink is written at a hand's pace."


@dataclass(frozen=True)
class FlatStroke:
    """A stroke as a file has it.

    Args:
        xy: Its points, right and up, shape (K, 2).
        t: When the pen was there, shape (K,) [s]; None where the file does not say.
        force: How hard it pressed, from 0, shape (K,); None where the file does not say.
    """

    xy: Array
    t: Array | None = None
    force: Array | None = None


@dataclass(frozen=True)
class FlatLetter:
    """A letter as a file has it.

    Args:
        strokes: In the order of writing.
        character: What it is.
        writer: A pseudonym.
        origin: Where the page's origin is, shape (2,) [m]; None is the ink's lower left corner.
        baseline: Where the writing line is [m].
        notes: What is doubtful in it, a sentence each.
    """

    strokes: Sequence[FlatStroke]
    character: str | None = None
    writer: str | None = None
    origin: Array | None = None
    baseline: float | None = None
    notes: tuple[str, ...] = ()


def flat_recordings(
    letters: Sequence[FlatLetter], scale: float | None = 1.0, faults: Sequence[str] = ()
) -> tuple[Recording, ...]:
    """Return the letters of a file as recordings; the clock of each begins at 0.

    A letter that cannot be is left out, and the notes of the others tell it.

    Args:
        letters: Those without strokes are left out.
        scale: The metres in a unit of the points; None where the file does not say.
        faults: Why other letters of the file are left out already, a sentence each.

    Raises:
        RecordingError: No letter can be read, or all ink is far smaller than a hand's.
    """
    left_out, read = list(faults), []
    letters = [letter for letter in letters if letter.strokes]
    notes = (NO_UNIT,) if scale is None else ()
    with np.errstate(all="ignore"):
        if scale is None and letters:
            scale = _usual_scale([[stroke.xy for stroke in each.strokes] for each in letters])
        for number, letter in enumerate(letters):
            try:
                read.append(_recording(letter, scale or 1.0, notes))
            except (RecordingError, TrajectoryError) as error:
                name = f"letter {number}" if letter.character is None else repr(letter.character)
                left_out.append(str(error) if len(letters) == 1 else f"{name}: {error}")
    if not read:
        raise RecordingError([*left_out, NO_INK][0])
    check_size([stroke.position for each in read for stroke in each.strokes()])
    if left_out:
        more = len(left_out) - MOST_FAULTS_TOLD
        told = [*left_out[:MOST_FAULTS_TOLD], *([f"And {more} more."] if more > 0 else [])]
        note = f"Of this file is left out what cannot be read: {' '.join(told)}"
        read = [replace(each, notes=(*each.notes, note)) for each in read]
    return tuple(read)


def _recording(letter: FlatLetter, scale: float, notes: tuple[str, ...]) -> Recording:
    """Return one letter."""
    strokes = letter.strokes
    rows = [stroke.xy * scale for stroke in strokes]
    check_size(rows, smallest=-1.0)
    forces = [stroke.force for stroke in strokes if stroke.force is not None]
    is_forced = len(forces) == len(strokes)
    if is_forced:
        # In a unit that the file does not say, force is a share of the hardest press.
        hardest = max([1.0, *(float(force.max()) for force in forces)])
        rows = [np.column_stack([xy, f / hardest]) for xy, f in zip(rows, forces, strict=True)]
    # Times that stand still say no more than none.
    times = [t for t in (stroke.t for stroke in strokes) if t is not None]
    times = [t for t in times if len(t) == 1 or np.ptp(t) > 0]
    is_timed = len(times) == len(strokes)
    laid = _on_one_clock(times, rows) if is_timed else at_hand_pace(rows)
    corner = np.concatenate([row[:, :2] for _, row in laid]).min(axis=0)
    origin = corner if letter.origin is None else letter.origin
    begin = laid[0][0][0]
    recording = add_lifts(
        [Trajectory(t - begin, row[:, :2] - origin) for t, row in laid],
        [row[:, 2] for _, row in laid] if is_forced else None,
        character=letter.character,
        writer=letter.writer,
        baseline=letter.baseline,
    )
    notes = (*letter.notes, *notes, *(() if is_timed else (NO_TIMES,)))
    return replace(recording, notes=notes)


def _on_one_clock(times: Sequence[Array], rows: Sequence[Array]) -> list[tuple[Array, Array]]:
    """Return strokes one after the other, as times (K,) and rows (K, D), each time once.

    A single point is a dot, and lasts 20 ms. A stroke that begins before the one before it has
    ended, for its clock was its own, begins a pause after that one.

    Raises:
        RecordingError: Time runs back inside a stroke, or a stroke takes more than an hour.
    """
    laid: list[tuple[Array, Array]] = []
    for number, (t, row) in enumerate(zip(times, rows, strict=True)):
        step, long = np.diff(t), t[-1] - t[0]
        if (step < 0).any() or not long < LONGEST_STROKE:
            what = "has times that run back" if long < LONGEST_STROKE else f"takes {long:.4g} s"
            raise RecordingError(f"stroke {number} {what}; is the unit of its times right?")
        fresh = np.concatenate([[True], step > 0])
        clock, way = t[fresh], row[fresh]
        if len(clock) == 1:
            clock, way = np.array([t[0], t[0] + TAP]), np.repeat(way, 2, axis=0)
        if laid and clock[0] <= laid[-1][0][-1]:
            clock = clock - clock[0] + laid[-1][0][-1] + LIFT_DURATION
        laid.append((clock, way))
    return laid


def check_size(strokes: Sequence[Array], smallest: float = SMALLEST_INK) -> None:
    """Raise a RecordingError where strokes (K, 2) are not finite, or no hand writes that size.

    Of a page with other letters a dot may be the `smallest` there is [m].
    """
    ink = np.concatenate(strokes)
    size = float(np.ptp(ink, axis=0).max()) if np.isfinite(ink).all() else np.inf
    if not smallest < size < LARGEST_INK:
        raise RecordingError(
            f"the ink is {size:.4g} m large, but must be {SMALLEST_INK} to {LARGEST_INK} m; is "
            "its unit right?"
        )


def _usual_scale(letters: Sequence[Sequence[Array]]) -> float:
    """Return what makes the median height of letters, points (K, 2) a stroke, 50 mm; dots aside."""
    sizes = [np.ptp(np.concatenate(strokes), axis=0) for strokes in letters]
    heights = [high if high > 0.2 * wide else wide for wide, high in sizes]
    high = float(np.median([each for each in heights if each != 0] or [0.0]))
    if not 1e-100 < high < 1e100:
        raise RecordingError(
            f"the ink is {high:.4g} high, in a unit that the file does not say; is there any ink?"
        )
    return USUAL_HEIGHT / high


def labelled(
    letter: FlatLetter,
    character: str | None,
    writer: str | None,
    origin: str | None,
    baseline: str | None,
) -> FlatLetter:
    """Return a letter with what its file says of it, as text; only ours say an origin [mm]."""
    place, line = _metres(origin), _metres(baseline)
    is_ours = len(place) == 2
    return replace(
        letter,
        character=own_label(character) if is_ours else label_from(character),
        writer=pseudonym_from(writer),
        origin=place if is_ours else None,
        baseline=float(line[0]) if is_ours and len(line) == 1 else None,
    )


def _metres(text: str | None) -> Array:
    """Return the lengths [m] in a text that has them in mm."""
    numbers = [finite_number(word) for word in (text or "").split()]
    return np.array([number / 1000 for number in numbers if number is not None])


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
