"""Arrays that NumPy saved: `.npy`, with a row for each sample, and `.npz`, with a name for each.

Nothing in them is run: arrays of objects are refused, and none may claim more than the file holds.
"""

from __future__ import annotations

import io
from collections import Counter

import numpy as np

from dmp_teach.errors import RecordingError
from dmp_teach.formats.columns import read_columns
from dmp_teach.formats.registry import CaptureOptions, Format
from dmp_teach.ink import Recording
from dmp_teach.trajectory import Array

NPY = b"\x93NUMPY"
ARRAY_CURE = "Save t, x, y as the columns of one array of numbers."
MOST_UNPACKED = 128_000_000  # [bytes]


def is_numpy(data: bytes) -> bool:
    """Tell whether a file is an array of NumPy's, or an archive of them."""
    return data.startswith(NPY) or (data.startswith(b"PK") and data[30:200].find(b".npy") > 0)


def read_numpy(data: bytes, name: str, options: CaptureOptions) -> tuple[Recording, ...]:
    """Read the letter in an array, or in arrays with names; errors as `read_columns`."""
    try:
        loaded = np.load(io.BytesIO(data), allow_pickle=False)
        if isinstance(loaded, np.ndarray):
            fields = loaded.dtype.names
            arrays = {field: loaded[field] for field in fields} if fields else {"": loaded}
        elif sum(each.file_size for each in loaded.zip.infolist()) > MOST_UNPACKED:
            raise ValueError("larger inside than ink can be")
        else:
            arrays = {key: value for key, value in loaded.items() if isinstance(value, np.ndarray)}
    # NumPy, zipfile and zlib raise many kinds of errors on a damaged file.
    except Exception as error:
        raise RecordingError(
            f"holds no array of numbers: {str(error)[:120]}. {ARRAY_CURE}"
        ) from None
    return read_arrays(arrays, name, options)


def read_arrays(
    arrays: dict[str, Array], file: str, options: CaptureOptions
) -> tuple[Recording, ...]:
    """Return the letter in arrays with names, of one column or of x, y and z; as `read_columns`.

    Raises:
        RecordingError: Also where an array is no table of numbers, or not as long as the others.
    """
    names, columns = [], []
    for label, array in arrays.items():
        if array.dtype.kind not in "iufb" or array.ndim not in (1, 2) or not array.size:
            raise RecordingError(
                f"holds an array of shape {array.shape} and kind {array.dtype.kind!r}. {ARRAY_CURE}"
            )
        table = array.astype(float).reshape(len(array), -1)
        table = table.T if len(table) < min(table.shape[1], 9) else table
        is_place = len(arrays) > 1 and 1 < table.shape[1] <= 3
        axes = [f"{label}_{axis}" for axis in "xyz"[: table.shape[1]]]
        names += axes if is_place else [label] * table.shape[1]
        columns += list(table.T)
    lengths = Counter(map(len, columns)).most_common()
    if len(lengths) > 1 and lengths[0][1] < 2:
        raise RecordingError(
            f"holds arrays of different lengths: {', '.join(map(repr, arrays))[:200]}. {ARRAY_CURE}"
        )
    kept = [k for k, column in enumerate(columns) if len(column) == lengths[0][0]]
    table = np.column_stack([columns[k] for k in kept])
    return read_columns(table, [names[k] for k in kept] if len(arrays) > 1 else None, file, options)


FORMAT = Format("NumPy", (".npy", ".npz"), is_numpy, read_numpy)
