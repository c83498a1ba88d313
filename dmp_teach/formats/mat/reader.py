"""The field's two reference sets, as their authors gave them to MATLAB.

*UCI Character Trajectories* (B. Williams 2008): the cell array `mixout` holds a 3 x T matrix for
each character: the speed of the pen to the right and up, and its force or how fast that changes, at
200 Hz; `consts.charlabels` and `consts.key` say which character it is. Speeds are summed up, zeros
at both ends are padding, and a force row with negative numbers is summed up, too. The set says no
unit: the median of its heights is taken for 50 mm.

*LASA handwriting* (S. M. Khansari-Zadeh, A. Billard 2011): the cell array `demos` holds a struct
for each demonstration, `pos` (2 x T) [mm], `t` (1 x T) [s] or `dt` [s]. A shape such as `GShape` is
the letter G.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any, TypeVar

import numpy as np

from dmp_teach.errors import RecordingError
from dmp_teach.formats.flat_ink import flat_recording, label_from, usual_scale
from dmp_teach.formats.mat.parser import HDF5, parse_mat
from dmp_teach.formats.registry import CaptureOptions, Format, name_file
from dmp_teach.ink import Recording
from dmp_teach.trajectory import Array, Trajectory

UCI_RATE = 200.0  # [1/s]
MOST_SAMPLES = 100_000  # in one letter
FEWEST_SAMPLES = 5
LASA_SHAPE = re.compile(r"([A-Za-z])_?[Ss]hape.*")
# What MATLAB's variables hold may be anything, so it is `Any` until it is checked.
Made = TypeVar("Made")


def begins_like_mat(data: bytes) -> bool:
    """Tell whether a file is MATLAB's, of any version since 5."""
    return data.startswith((b"MATLAB", HDF5)) or data[512:520] == HDF5


@name_file
def read_sets(data: bytes, name: str, _: CaptureOptions) -> tuple[Recording, ...]:
    """Read the letters of a `.mat` file of either set; a LASA file says only in its name which.

    Raises:
        RecordingError: Not such a file, neither set, or a matrix that cannot be ink, by its number.
    """
    variables = parse_mat(data)
    if "mixout" in variables:
        return _characters(variables)
    if "demos" in variables:
        return _demonstrations(variables, name)
    names = ", ".join(map(repr, list(variables)[:20])) or "none"
    raise RecordingError(
        f"has neither 'mixout' (Character Trajectories) nor 'demos' (LASA); its variables: {names}."
    )


def _characters(variables: dict[str, Any]) -> tuple[Recording, ...]:
    """Return the letters of Character Trajectories."""
    cells = _letter_cells("mixout", variables["mixout"])
    speeds = _for_each("mixout", _pen_speeds, cells)
    paths = [np.cumsum(speed[:2], axis=1).T / UCI_RATE for speed in speeds]
    scale = usual_scale([[path] for path in paths])
    labels = _character_labels(variables.get("consts"), len(cells))

    def letter(k: int) -> Recording:
        stroke = Trajectory(np.arange(len(paths[k])) / UCI_RATE, paths[k] * scale)
        return flat_recording([stroke], _pressure_row(speeds[k]), character=labels[k])

    return tuple(_for_each("mixout", letter, range(len(cells))))


def _pen_speeds(cell: Any) -> Array:
    """Return one character's rows (2 or 3, T) without the zeros before and after."""
    if not isinstance(cell, np.ndarray) or cell.ndim != 2 or cell.shape[0] not in (2, 3):
        shape = getattr(cell, "shape", None)
        raise RecordingError(
            f"is {'no matrix' if shape is None else f'of shape {shape}'}, but must be 3 x T."
        )
    _check_matrix(cell)
    moving = np.flatnonzero(cell[:2].any(axis=0))
    if len(moving) < FEWEST_SAMPLES:
        raise RecordingError(
            f"moves in {len(moving)} samples, but a letter needs {FEWEST_SAMPLES}."
        )
    return cell[:, moving[0] : moving[-1] + 1]


def _pressure_row(speed: Array) -> list[Array] | None:
    """Return the pressure, 0 to 1, from the third row; None where it says nothing."""
    if len(speed) < 3:
        return None
    force = np.cumsum(speed[2]) if (speed[2] < 0).any() else speed[2]
    force = force - min(float(force.min()), 0.0)
    most = float(force.max())
    return [np.clip(force / most, 0.0, 1.0)] if 0 < most < np.inf else None


def _character_labels(consts: Any, count: int) -> list[str | None]:
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
    places = numbers.ravel()
    odd = np.flatnonzero(~((places >= 1) & (places <= len(key)) & (places == np.round(places))))
    if len(odd):
        raise RecordingError(
            f"consts.charlabels[{odd[0]}] is {places[odd[0]]:g}, but consts.key has 1 to "
            f"{len(key)}."
        )
    names = [key[int(place) - 1] for place in places]
    return [label_from(name) if isinstance(name, str) else None for name in names]


def _demonstrations(variables: dict[str, Any], name: str) -> tuple[Recording, ...]:
    """Return the letters of LASA."""
    shape = variables.get("name")
    match = LASA_SHAPE.fullmatch(shape if isinstance(shape, str) else Path(name).stem)
    character = match[1].upper() if match else None

    def letter(cell: Any) -> Recording:
        return _demonstration(cell, variables.get("dt"), character)

    return tuple(_for_each("demos", letter, _letter_cells("demos", variables["demos"])))


def _demonstration(cell: Any, usual_step: Any, character: str | None) -> Recording:
    """Return one demonstration."""
    pos = cell.get("pos") if isinstance(cell, dict) else None
    if not isinstance(pos, np.ndarray) or pos.ndim != 2 or pos.shape[0] != 2:
        raise RecordingError("has no matrix 'pos' of 2 x T [mm].")
    _check_matrix(pos)
    t, dt = cell.get("t"), cell.get("dt", usual_step)
    if not isinstance(t, np.ndarray) or t.size != pos.shape[1]:
        step = float(dt.flat[0]) if isinstance(dt, np.ndarray) and dt.size == 1 else np.nan
        if not 1e-5 < step < 10:
            raise RecordingError(
                "has neither a time 't' for every point of 'pos' nor a step 'dt' [s]."
            )
        t = np.arange(pos.shape[1]) * step
    return flat_recording([Trajectory(t.ravel(), pos.T / 1000)], character=character)


def _check_matrix(matrix: Array) -> None:
    """Raise where a matrix (D, T) cannot be a letter."""
    if not FEWEST_SAMPLES <= matrix.shape[1] <= MOST_SAMPLES:
        raise RecordingError(
            f"has {matrix.shape[1]} samples, but a letter has {FEWEST_SAMPLES} to {MOST_SAMPLES}."
        )
    if not (np.abs(matrix) < 1e100).all():
        raise RecordingError("has a number that is not finite, or far too large.")


def _letter_cells(name: str, value: Any) -> list[Any]:
    """Return a cell array, or a single struct as a list of one."""
    cells = [value] if isinstance(value, dict) else value
    if not isinstance(cells, list) or not cells:
        raise RecordingError(f"{name} must be a cell array with at least one letter.")
    return cells


def _for_each(name: str, make: Callable[[Any], Made], cells: Iterable[Any]) -> list[Made]:
    """Return what `make` makes of every letter; its error gets the letter's number, from 0."""
    made = []
    for number, cell in enumerate(cells):
        try:
            made.append(make(cell))
        except ValueError as error:
            raise RecordingError(f"{name}, letter {number}: {error}") from None
    return made


FORMAT = Format("MATLAB", (".mat",), begins_like_mat, read_sets)
