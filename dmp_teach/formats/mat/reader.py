"""The field's two reference sets, as their authors gave them to MATLAB.

*UCI Character Trajectories* (B. Williams 2008): the cell array `mixout` holds a 3 x T matrix for each character: the
speed of the pen to the right and up, and its force or how fast that changes, at 200 Hz; `consts.charlabels` and
`consts.key` say which character it is. Speeds are summed up, zeros at both ends are padding, and a force row with
negative numbers is summed up, too. The set says no unit: the median of its heights is taken for 50 mm.

*LASA handwriting* (S. M. Khansari-Zadeh, A. Billard 2011): the cell array `demos` holds a struct for each
demonstration, `pos` (2 x T) [mm], `t` (1 x T) [s] or `dt` [s]. A shape such as `GShape` is the letter G.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from dmp_teach.errors import RecordingError
from dmp_teach.formats.flat_ink import flat_recording, label_from, usual_scale
from dmp_teach.formats.mat.parser import HDF5, read_mat
from dmp_teach.formats.registry import CaptureOptions, Format, name_file
from dmp_teach.ink import Recording
from dmp_teach.trajectory import Array, Trajectory

UCI_RATE = 200.0  # [1/s]
MOST = 100_000  # samples in one letter
FEWEST = 5


def _begins_like_mat(data: bytes) -> bool:
    """Tell whether a file is MATLAB's, of any version since 5."""
    return data.startswith((b"MATLAB", HDF5)) or data[512:520] == HDF5


@name_file
def read_sets(data: bytes, name: str, _: CaptureOptions) -> tuple[Recording, ...]:
    """Read the letters of a `.mat` file of either set.

    Args:
        data: The file.
        name: Its name: a LASA file says what was written only there.

    Raises:
        RecordingError: Not such a file, neither set, or a matrix that cannot be ink, by its number.
    """
    variables = read_mat(data)
    if "mixout" in variables:
        return _characters(variables)
    if "demos" in variables:
        return _demonstrations(variables, name)
    names = ", ".join(map(repr, list(variables)[:20])) or "none"
    raise RecordingError(
        f"has neither 'mixout' (Character Trajectories) nor 'demos' (LASA); its variables: {names}."
    )


def _characters(variables: dict[str, Any]) -> tuple[Recording, ...]:
    """Character Trajectories."""
    cells = _list("mixout", variables["mixout"])
    speeds = [
        _numbered("mixout", k, lambda each=each: _speeds(each)) for k, each in enumerate(cells)
    ]
    paths = [np.cumsum(speed[:2], axis=1).T / UCI_RATE for speed in speeds]
    scale = usual_scale([[path] for path in paths])
    labels = _labels(variables.get("consts"), len(cells))
    letters = []
    for k, (path, speed, label) in enumerate(zip(paths, speeds, labels, strict=True)):
        t = np.arange(len(path)) / UCI_RATE
        made = _numbered(
            "mixout",
            k,
            lambda t=t, path=path, speed=speed, label=label: flat_recording(
                [Trajectory(t, path * scale)], _pressed(speed), character=label
            ),
        )
        letters.append(made)
    return tuple(letters)


def _speeds(cell: Any) -> Array:
    """One character's rows (2 or 3, T) without the zeros before and after."""
    if not isinstance(cell, np.ndarray) or cell.ndim != 2 or cell.shape[0] not in (2, 3):
        shape = getattr(cell, "shape", None)
        raise RecordingError(
            f"is {'no matrix' if shape is None else f'of shape {shape}'}, but must be 3 x T."
        )
    _check(cell)
    moving = np.flatnonzero(cell[:2].any(axis=0))
    if len(moving) < FEWEST:
        raise RecordingError(f"moves in {len(moving)} samples, but a letter needs {FEWEST}.")
    return cell[:, moving[0] : moving[-1] + 1]


def _pressed(speed: Array) -> list[Array] | None:
    """The pressure from the third row, 0 to 1; None where there is none or it says nothing."""
    if len(speed) < 3:
        return None
    force = np.cumsum(speed[2]) if (speed[2] < 0).any() else speed[2]
    force = force - min(float(force.min()), 0.0)
    most = float(force.max())
    return [np.clip(force / most, 0.0, 1.0)] if 0 < most < np.inf else None


def _labels(consts: Any, count: int) -> list[str | None]:
    """What each character is; None where the file does not say."""
    consts = consts if isinstance(consts, dict) else {}
    numbers, key = consts.get("charlabels"), consts.get("key")
    key = list(key) if isinstance(key, str) else key
    if numbers is None or key is None:
        return [None] * count
    if not isinstance(numbers, np.ndarray) or numbers.size != count or not isinstance(key, list):
        raise RecordingError(
            f"consts.charlabels must have a number for each of the {count} characters, consts.key a list."
        )
    places = numbers.ravel()
    odd = np.flatnonzero(~((places >= 1) & (places <= len(key)) & (places == np.round(places))))
    if len(odd):
        raise RecordingError(
            f"consts.charlabels[{odd[0]}] is {places[odd[0]]:g}, but consts.key has 1 to {len(key)}."
        )
    return [
        label_from(key[int(place) - 1]) if isinstance(key[int(place) - 1], str) else None
        for place in places
    ]


def _demonstrations(variables: dict[str, Any], name: str) -> tuple[Recording, ...]:
    """LASA."""
    cells = _list("demos", variables["demos"])
    shape = variables.get("name")
    match = re.fullmatch(
        r"([A-Za-z])_?[Ss]hape.*", shape if isinstance(shape, str) else Path(name).stem
    )
    letter = match and match[1].upper()
    usual = variables.get("dt")
    return tuple(
        _numbered("demos", k, lambda each=each: _demonstration(each, usual, letter))
        for k, each in enumerate(cells)
    )


def _demonstration(cell: Any, usual: Any, letter: str | None) -> Recording:
    """One demonstration."""
    pos = cell.get("pos") if isinstance(cell, dict) else None
    if not isinstance(pos, np.ndarray) or pos.ndim != 2 or pos.shape[0] != 2:
        raise RecordingError("has no matrix 'pos' of 2 x T [mm].")
    _check(pos)
    t, dt = cell.get("t"), cell.get("dt", usual)
    if not isinstance(t, np.ndarray) or t.size != pos.shape[1]:
        step = float(dt.flat[0]) if isinstance(dt, np.ndarray) and dt.size == 1 else np.nan
        if not 1e-5 < step < 10:
            raise RecordingError(
                "has neither a time 't' for every point of 'pos' nor a step 'dt' [s]."
            )
        t = np.arange(pos.shape[1]) * step
    return flat_recording([Trajectory(t.ravel(), pos.T / 1000)], character=letter)


def _check(matrix: Array) -> None:
    """Raise where a matrix (D, T) cannot be a letter."""
    if not FEWEST <= matrix.shape[1] <= MOST:
        raise RecordingError(f"has {matrix.shape[1]} samples, but a letter has {FEWEST} to {MOST}.")
    if not (np.abs(matrix) < 1e100).all():
        raise RecordingError("has a number that is not finite, or far too large.")


def _list(name: str, value: Any) -> list:
    """A cell array, or a single struct as a list of one."""
    cells = [value] if isinstance(value, dict) else value
    if not isinstance(cells, list) or not cells:
        raise RecordingError(f"{name} must be a cell array with at least one letter.")
    return cells


def _numbered(name: str, number: int, make: Callable[[], Any]) -> Any:
    """What `make` gives, or its error with the number of the letter, from 0."""
    try:
        return make()
    except ValueError as error:
        raise RecordingError(f"{name}, letter {number}: {error}") from None


FORMAT = Format("MATLAB", (".mat",), _begins_like_mat, read_sets)
