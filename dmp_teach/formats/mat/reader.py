"""The field's two reference sets, as their authors gave them to MATLAB, and arrays t, x, y.

*UCI Character Trajectories* (B. Williams 2008): the cell array `mixout` holds a 3 x T matrix for
each character: the speed of the pen to the right and up, and its force or how fast that changes, at
200 Hz; `consts.charlabels` and `consts.key` say which character it is. Speeds are summed up, zeros
at both ends are padding, and a force row with negative numbers is summed up, too. The set says no
unit.

*LASA handwriting* (S. M. Khansari-Zadeh, A. Billard 2011): the cell array `demos` holds a struct
for each demonstration, `pos` (2 x T) [mm], `t` (1 x T) [s] or `dt` [s], or neither. A shape such as
`GShape`, or a part of its name such as `2_G`, is the letter G.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path

import numpy as np

from dmp_teach.errors import RecordingError
from dmp_teach.formats.flat_ink import FlatLetter, FlatStroke, flat_recordings, label_from
from dmp_teach.formats.mat.parser import HDF5, MatValue, parse_mat
from dmp_teach.formats.registry import CaptureOptions, Format
from dmp_teach.formats.xy_numpy import read_arrays
from dmp_teach.ink import Recording
from dmp_teach.trajectory import Array

UCI_RATE = 200.0  # [1/s]
MOST_SAMPLES = 100_000  # in one letter
FEWEST_SAMPLES = 5
LASA_SHAPE = re.compile(r"(?:.*_)?([A-Za-z])(?:_.*|[Ss]hape.*)?")


def begins_like_mat(data: bytes) -> bool:
    """Tell whether a file is MATLAB's, of any version since 5."""
    return data.startswith(b"MATLAB") or data[512:520] == HDF5


def read_sets(data: bytes, name: str, options: CaptureOptions) -> tuple[Recording, ...]:
    """Read the letters of a `.mat` file of either set; a LASA file says only in its name which.

    Raises:
        RecordingError: Not such a file, neither set, or a matrix that cannot be ink, by its number.
    """
    variables = parse_mat(data)
    if "mixout" in variables:
        strokes, faults = _strokes("mixout", variables["mixout"], _pen_speeds)
        labels = _character_labels(variables.get("consts"), len(strokes))
        letters = [FlatLetter(stroke, label) for stroke, label in zip(strokes, labels, strict=True)]
        return flat_recordings(letters, None, faults)
    if "demos" in variables:
        shape, dt = variables.get("name"), variables.get("dt")
        match = LASA_SHAPE.fullmatch(shape if isinstance(shape, str) else Path(name).stem)
        make = partial(_demonstration, usual_step=dt)
        strokes, faults = _strokes("demos", variables["demos"], make)
        letters = [FlatLetter(stroke, match[1] if match else None) for stroke in strokes]
        return flat_recordings(letters, 0.001, faults)
    structs = [each for each in variables.values() if isinstance(each, dict)]
    arrays = {
        label: value
        for each in [variables, *structs]
        for label, value in each.items()
        if isinstance(value, np.ndarray) and value.size > 1
    }
    if arrays:
        return read_arrays(arrays, name, options)
    names = ", ".join(map(repr, list(variables)[:20])) or "none"
    raise RecordingError(
        f"has neither 'mixout' (Character Trajectories) nor 'demos' (LASA), nor the numbers t, x, "
        f"y; its variables: {names}."
    )


def _strokes(
    name: str, value: MatValue, make: Callable[[MatValue], FlatStroke]
) -> tuple[list[list[FlatStroke]], list[str]]:
    """Return what `make` makes of each of a cell array, or nothing, and why."""
    cells = [value] if isinstance(value, dict) else value
    if not isinstance(cells, list) or not cells:
        raise RecordingError(f"{name} must be a cell array with at least one letter.")
    strokes, faults = [], []
    for number, cell in enumerate(cells):
        try:
            strokes.append([make(cell)])
        except RecordingError as error:
            strokes.append([])
            faults.append(f"{name}, letter {number}: {error}")
    return strokes, faults


def _matrix(value: MatValue, what: str, *rows: int) -> Array:
    """Return a matrix that can be a letter, with one of so many rows, shape (D, T)."""
    shape = value.shape if isinstance(value, np.ndarray) else ()
    if not isinstance(value, np.ndarray) or len(shape) != 2 or shape[0] not in rows:
        is_what = f"of shape {shape}" if shape else "no matrix"
        raise RecordingError(f"{what} is {is_what}, but must be {rows[-1]} x T.")
    if not FEWEST_SAMPLES <= shape[1] <= MOST_SAMPLES or not (np.abs(value) < 1e100).all():
        raise RecordingError(
            f"{what} must have {FEWEST_SAMPLES} to {MOST_SAMPLES} samples, each of them finite and "
            "below 1e100."
        )
    return value


def _pen_speeds(cell: MatValue) -> FlatStroke:
    """Return one character: its rows are speeds and force, with zeros before and after."""
    speed = _matrix(cell, "its value", 2, 3)
    moving = np.flatnonzero(speed[:2].any(axis=0))
    if len(moving) < FEWEST_SAMPLES:
        raise RecordingError(
            f"moves in {len(moving)} samples, but a letter needs {FEWEST_SAMPLES}."
        )
    speed = speed[:, moving[0] : moving[-1] + 1]
    xy = np.cumsum(speed[:2], axis=1).T / UCI_RATE
    return FlatStroke(xy, np.arange(len(xy)) / UCI_RATE, _pressure(speed[2:].ravel()))


def _pressure(row: Array) -> Array | None:
    """Return the pressure, 0 to 1, from force or its rate (T,); None where it says nothing."""
    force = np.cumsum(row) if (row < 0).any() else row
    force = force - min(float(force.min(initial=0.0)), 0.0)
    most = float(force.max(initial=0.0))
    return np.clip(force / most, 0.0, 1.0) if 0 < most < np.inf else None


def _character_labels(consts: MatValue, count: int) -> Sequence[str | None]:
    """Return what each character is; None where the file does not say."""
    consts = consts if isinstance(consts, dict) else {}
    numbers, key = consts.get("charlabels"), consts.get("key")
    key = list(key) if isinstance(key, str) else key
    if numbers is None or key is None:
        return [None] * count
    if not isinstance(numbers, np.ndarray) or numbers.size != count or not isinstance(key, list):
        raise RecordingError(
            f"consts.charlabels must have a number for each of the {count} characters, consts.key "
            "a list."
        )
    places = numbers.ravel().tolist()
    odd = [place for place in places if place not in range(1, len(key) + 1)]
    if odd:
        raise RecordingError(
            f"consts.charlabels has {odd[0]:g}, but consts.key has 1 to {len(key)}."
        )
    names = [key[int(place) - 1] for place in places]
    return [label_from(name) if isinstance(name, str) else None for name in names]


def _demonstration(cell: MatValue, usual_step: MatValue) -> FlatStroke:
    """Return one demonstration, of places [mm]."""
    cell = cell if isinstance(cell, dict) else {"pos": cell}
    pos = cell.get("pos")
    if isinstance(pos, np.ndarray) and pos.shape[1:] == (2,):
        pos = pos.T
    pos = _matrix(pos, "'pos'", 2)
    t, dt = cell.get("t"), cell.get("dt", usual_step)
    if isinstance(t, np.ndarray) and t.size == pos.shape[1] and np.isfinite(t).all():
        return FlatStroke(pos.T, t.ravel())
    step = float(dt.flat[0]) if isinstance(dt, np.ndarray) and dt.size == 1 else 0.0
    times: Array = np.arange(pos.shape[1], dtype=float) * step
    return FlatStroke(pos.T, times if 1e-5 < step < 10 else None)


FORMAT = Format("MATLAB", (".mat",), begins_like_mat, read_sets)
