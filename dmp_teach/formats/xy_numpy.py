"""Arrays that NumPy saved: `.npy`, with a row for each sample, and `.npz`, with a name for each.

Nothing in them is run: arrays of objects are refused, and none may claim more than the file holds.
"""

from __future__ import annotations

import io
import zipfile

import numpy as np

from dmp_teach.errors import RecordingError
from dmp_teach.formats.columns import ARRAY_CURE, read_arrays
from dmp_teach.formats.registry import CaptureOptions, Format
from dmp_teach.ink import Recording

NPY = b"\x93NUMPY"
MOST_UNPACKED = 128_000_000  # [bytes]


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
            f"holds no array of numbers: {str(error)[:120]}. {ARRAY_CURE}"
        ) from None
    return read_arrays(arrays, name, options)


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
    """Return the arrays of a file by their names."""
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
    return found


FORMAT = Format("NumPy", (".npy", ".npz"), is_numpy, read_numpy)
