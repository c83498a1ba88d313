"""Motion capture as a recording: fill its gaps, lay it on its page, cut it to its writing."""

from __future__ import annotations

import re
import unicodedata
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np

from dmp_teach.errors import RecordingError
from dmp_teach.formats.flat_ink import LARGEST_INK
from dmp_teach.formats.motive.page_plane import find_page, level_axes
from dmp_teach.formats.motive.take import Take, read_take
from dmp_teach.formats.registry import CaptureOptions, Format
from dmp_teach.ink import Recording
from dmp_teach.segmentation import find_strokes
from dmp_teach.trajectory import Array

HEADER = re.compile(
    rb"(?:^|[\r\n])[^,;\r\n]{0,8}frame[\"\t ]{0,8}[,;\t][\"\t ]{0,8}time", re.IGNORECASE
)
SHORT = 0.1  # a gap up to this long is filled with a straight line anywhere; a longer one only off the ink [s]
FEWEST = 20  # fewer samples are no letter
DOT = 0.15  # of the lift after a dot so much is kept, and so much again until it is one [s]
JUMP = 0.004  # a step that is this much longer than its neighbours was no pen ...
PEN = 8.0  # ... unless the samples are so far apart that a pen could do it [m/s2] ...
AIR = 50.0  # ... or a hand in the air, or one that knocks on the paper [m/s2]
BESIDE = 0.5  # a leap this soon before or after the writing has cut it short [s]
EDGE = 0.05  # how long a marker is watched before it is lost, or after it is found [s]
WRITING = 0.03  # a marker that is lost slower than this had written all there was [m/s]
FLAT = 3.0  # ink lies this much wider on its paper than off it
SMALLEST = 0.004  # no marker at a hand that writes moves less [m]


def has_motive_header(data: bytes) -> bool:
    """Tell whether a file has the row `Frame,Time`."""
    return HEADER.search(data[:100_000].replace(b"\0", b"")) is not None


def read_motive(data: bytes, name: str, options: CaptureOptions) -> tuple[Recording, ...]:
    """Read the letter in a Motive CSV file; errors as `read_recording`."""
    up, right = options.up, options.right
    level_axes(up, right)
    take = _seen(read_take(data, name, options.marker))
    filled = replace(take, position=_filled(take))
    _check_size(take, filled.position)
    try:
        position = find_page(filled.t, filled.position, up, right).of(filled.position)
        strokes, (start, end) = _settled(filled.t, position)
    except RecordingError as error:
        raise RecordingError(f"{take.name}, marker {take.marker!r}: {error}") from None
    _check_gaps(take, strokes)
    _check_jumps(take, filled.position, strokes)
    _check_ink(take, strokes, up)
    ink = np.concatenate([position[a:b] for a, b in strokes])
    position = position - [*ink[:, :2].min(axis=0), np.median(ink[:, 2])]
    character, writer = _labels(take.name)
    return (Recording(take.t[start:end], position[start:end], character, writer),)


def _settled(t: Array, position: Array) -> tuple[list[tuple[int, int]], tuple[int, int]]:
    """The strokes, and where to cut the take so that a recording which begins and ends there has the same ones.

    It ends with its last stroke; of a dot, which only its two lifts tell from a rest, some of the lift is kept.
    """
    end, tail = len(t), 0
    strokes = list(find_strokes(t, position))
    while True:
        a, b = strokes[0][0], min(end, strokes[-1][1] + tail)
        again = [(first + a, last + a) for first, last in find_strokes(t[a:b], position[a:b])]
        if len(again) < len(strokes) and strokes[-1][1] + tail < end:
            tail += max(1, round(DOT / float(np.median(np.diff(t)))))
        elif again == strokes:
            return strokes, (a, b)
        else:
            strokes, end = again, b


def _seen(take: Take) -> Take:
    """The take from the first sample that the cameras saw to the last."""
    seen = np.flatnonzero(np.isfinite(take.position[:, 0]))
    if len(seen) < FEWEST:
        raise RecordingError(
            f"{take.name}: marker {take.marker!r} was seen in {len(seen)} frames, but a letter needs {FEWEST}; "
            f"record again. {take.choice}"
        )
    first, last = int(seen[0]), int(seen[-1])
    unseen = (float(take.t[first] - take.t[0]), float(take.t[-1] - take.t[last]))
    return replace(take.part(first, last + 1), unseen=unseen)


def _filled(take: Take) -> Array:
    """Positions (T, 3) with straight lines across the gaps."""
    seen = np.isfinite(take.position[:, 0])
    return np.column_stack(
        [np.interp(take.t, take.t[seen], axis[seen]) for axis in take.position.T]
    )


def _check_gaps(take: Take, strokes: list[tuple[int, int]]) -> None:
    """Raise where a long gap, of empty cells or of missing rows, leaves a hole in a stroke."""
    seen = np.flatnonzero(np.isfinite(take.position[:, 0]))
    longest = SHORT + float(np.median(np.diff(take.t)))
    for before, after in pairwise(seen):
        if take.t[after] - take.t[before] > longest:
            for number, (a, b) in enumerate(strokes):
                if before < b - 1 and after > a:
                    raise RecordingError(
                        f"{take.name}: marker {take.marker!r} is lost for {take.t[after] - take.t[before]:.2f} s after "
                        f"{take.at(before)}, inside stroke {number}; gaps up to {SHORT} s can be filled. Fill it in "
                        f"Motive, or record again. {take.choice}"
                    )
    _check_edges(take, strokes, longest)


def _check_edges(take: Take, strokes: list[tuple[int, int]], longest: float) -> None:
    """Raise where the take goes on without the marker while it was writing: the rest of the stroke is missing."""
    seen = np.flatnonzero(np.isfinite(take.position[:, 0]))
    ends = [(seen, take.unseen[0], 0, "before", "is first seen at")]
    ends += [(seen[::-1], take.unseen[1], len(strokes) - 1, "after", "is lost for good after")]
    for edge, unseen, number, side, verb in ends:
        near = edge[np.abs(take.t[edge] - take.t[edge[0]]) <= EDGE]
        near = near[(near >= strokes[number][0]) & (near < strokes[number][1])]
        if (
            unseen > longest
            and len(near) > 1
            and _speed(take, near[0], near[-1], strokes) > WRITING
        ):
            raise RecordingError(
                f"{take.name}: marker {take.marker!r} {verb} {take.at(int(edge[0]))}, inside stroke {number}: the take "
                f"has {unseen:.2f} s {side} that, but not the marker. Mend it in Motive, or record again. {take.choice}"
            )


def _speed(take: Take, one: int, other: int, strokes: list[tuple[int, int]]) -> float:
    """How fast the marker goes from one sample to another along the paper, a lift not counted [m/s]."""
    ink = np.concatenate([take.position[a:b] for a, b in strokes])
    ink = ink[np.isfinite(ink[:, 0])]
    _, spread, ways = np.linalg.svd(np.cov(ink.T))
    paper = (
        ways[:2] if spread[1] > FLAT**2 * spread[2] else ways[:1]
    )  # a bar does not tell how its paper lies
    along = paper @ (take.position[other] - take.position[one])
    return float(np.linalg.norm(along) / abs(take.t[other] - take.t[one]))


def _check_size(take: Take, position: Array) -> None:
    """Raise where the whole way of the marker is far larger or smaller than a hand's."""
    size = float(np.ptp(position, axis=0).max())
    if not SMALLEST < size < LARGEST_INK:
        away = np.abs(take.position - np.nanmedian(take.position, axis=0)).max(axis=1)
        astray = np.nanmax(away) > LARGEST_INK / 2 > np.nanmedian(away)
        far = (
            f" It is {np.nanmax(away):.4g} m off at {take.at(int(np.nanargmax(away)))}."
            if astray
            else ""
        )
        raise RecordingError(
            f"{take.name}: marker {take.marker!r} moves within {size:.4g} m, but a writing hand within {SMALLEST} to "
            f"{LARGEST_INK} m.{far} Is 'Length Units' in row 1 right, and is this marker the pen? {take.choice}"
        )


def _check_ink(take: Take, strokes: list[tuple[int, int]], up: str) -> None:
    """Raise where hardly anything was written: a page seen from the wrong side, or no letter."""
    samples = sum(b - a for a, b in strokes)
    if samples < FEWEST:
        raise RecordingError(
            f"{take.name}: marker {take.marker!r} writes in {samples} frames only, but a letter needs {FEWEST}. Does "
            f"up={up!r} point out of the paper? Otherwise record again. {take.choice}"
        )


def _check_jumps(take: Take, position: Array, strokes: list[tuple[int, int]]) -> None:
    """Raise where the marker leaps, as it does when the cameras take another one for it.

    A leap is a step far from the mean of its neighbours; where the marker flickers all the time it is noise. A leap off
    the paper looks like a lift, so lifts are searched, too, and a moment before and after the writing.
    """
    dt = float(np.median(np.diff(take.t)))
    step = np.diff(position, axis=0)
    off = np.zeros(len(take.t))
    off[2:-1] = np.linalg.norm(step[1:-1] - (step[:-2] + step[2:]) / 2, axis=1)
    inked = np.zeros(len(off), dtype=bool)
    for a, b in strokes:
        inked[a:b] = True
    seen = np.convolve(np.isfinite(take.position[:, 0]), np.ones(5), "same") == 5
    limit = np.where(inked, JUMP + PEN * dt**2, np.where(seen, JUMP + AIR * dt**2, np.inf))
    start, end = np.searchsorted(
        take.t, take.t[[strokes[0][0], strokes[-1][1] - 1]] + [-BESIDE, BESIDE]
    )
    for k in np.flatnonzero(off[start:end] > limit[start:end]) + start:
        near = np.concatenate([off[max(start, k - 15) : max(start, k - 2)], off[k + 3 : k + 16]])
        if not len(near) or off[k] > 4 * np.quantile(near, 0.9):
            where = "inside a stroke" if inked[k] else "beside a stroke"
            raise RecordingError(
                f"{take.name}, {take.at(k)}: {take.marker!r} jumps by {off[k] * 1e3:.1f} mm {where}, "
                f"which no pen does. Mend the take in Motive. {take.choice}"
            )


def _labels(name: str) -> tuple[str | None, str | None]:
    """Letter and pseudonym from a file name such as `a_w01.csv`; other names stay private."""
    stem = unicodedata.normalize("NFC", Path(name).stem)  # macOS takes the dots off an ä
    match = re.fullmatch(r"(\S)_(w\d+)(?:[_ .-].*)?", stem)
    return match.groups() if match else (None, None)


FORMAT = Format("Motive CSV", (".csv",), has_motive_header, read_motive)
