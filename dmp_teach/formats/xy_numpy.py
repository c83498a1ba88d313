"""Arrays that NumPy saved: `.npy`, with a row for each sample, and `.npz`, with a name for each.

Nothing in them is run: arrays of objects are refused, and none may claim more than the file holds.
"""

from __future__ import annotations

import io
import zipfile

import numpy as np

from dmp_teach.errors import RecordingError
from dmp_teach.formats.columns import read_columns
from dmp_teach.formats.registry import CaptureOptions, Format
from dmp_teach.ink import Recording
from dmp_teach.trajectory import Array

NPY = b"\x93NUMPY"
MOST_UNPACKED = 128_000_000  # [bytes]
NUMPY_CURE = "Save t, x, y as the columns of one array of numbers."


def is_numpy(data: bytes) -> bool:
    """Tell whether a file is an array of NumPy's, or an archive of them."""
    return data.startswith(NPY) or (data.startswith(b"PK") and data[30:200].find(b".npy") > 0)


def read_numpy(data: bytes, name: str, options: CaptureOptions) -> tuple[Recording, ...]:
    """Read the letter in an array, or in arrays with names; errors as `read_columns`."""
    try:
        arrays = _archive(data)
    # NumPy, zipfile and zlib raise many kinds of errors on a damaged file.
    except Exception as error:
        raise RecordingError(
            f"holds no array of numbers: {str(error)[:120]}. {NUMPY_CURE}"
        ) from None
    names, columns = [], []
    for label, array in arrays.items():
        table = _columns(array)
        for k, column in enumerate(table.T):
            wide = table.shape[1] > 1
            names.append("xyz"[k] if wide and label and table.shape[1] <= 3 else label)
            columns.append(column)
    lengths = {len(column) for column in columns}
    if len(lengths) != 1:
        raise RecordingError(
            f"holds arrays of different lengths: {', '.join(map(repr, arrays))[:200]}. {NUMPY_CURE}"
        )
    return read_columns(np.column_stack(columns), names if any(names) else None, name, options)


def _array(data: bytes) -> np.ndarray:
    """Return the array in the bytes of a `.npy` file."""
    file = io.BytesIO(data)
    major, _ = np.lib.format.read_magic(file)
    read_header = np.lib.format.read_array_header_1_0
    if major > 1:
        read_header = np.lib.format.read_array_header_2_0
    shape, _, dtype = read_header(file)
    if dtype.hasobject or int(np.prod(shape, dtype=float)) * dtype.itemsize > len(data):
        raise ValueError("objects, or fewer numbers than its head claims")
    file.seek(0)
    array: np.ndarray = np.lib.format.read_array(file, allow_pickle=False)
    return array


def _archive(data: bytes) -> dict[str, np.ndarray]:
    """Return the arrays of a file by their names; one that is alone needs none."""
    if data.startswith(NPY):
        array = _array(data)
        fields = array.dtype.names
        return {field: array[field] for field in fields} if fields else {"": array}
    with zipfile.ZipFile(io.BytesIO(data)) as file:
        parts = [each for each in file.infolist() if each.filename.endswith(".npy")]
        if sum(each.file_size for each in parts) > MOST_UNPACKED:
            raise ValueError("larger inside than ink can be")
        found = {}
        for each in parts:
            with file.open(each) as part:
                found[each.filename.removesuffix(".npy")] = _array(part.read(MOST_UNPACKED))
    return {"": next(iter(found.values()))} if len(found) == 1 else found


def _columns(array: np.ndarray) -> Array:
    """Return an array as a column for each quantity, shape (N, C)."""
    if array.dtype.kind not in "iufb" or array.ndim not in (1, 2) or not array.size:
        raise RecordingError(
            f"holds an array of shape {array.shape} and kind {array.dtype.kind!r}. {NUMPY_CURE}"
        )
    table = array.astype(float).reshape(len(array), -1)
    return table.T if len(table) < min(table.shape[1], 9) else table


FORMAT = Format("NumPy", (".npy", ".npz"), is_numpy, read_numpy)
