"""MATLAB's files, level 5, as far as ink needs: numbers, text, cells and structs; none is run.

Written for files from strangers, where `scipy.io.loadmat` may end the whole process: no element may
claim more than the file holds, compressed parts stop growing at a limit, cells and structs may not
nest for ever, and objects and functions are passed over. The layout is that of "MAT-File Format" by
The MathWorks. Version 7.3 is another format (HDF5) and is refused.
"""

from __future__ import annotations

import math
import struct
import zlib
from typing import Literal

import numpy as np

from dmp_teach.errors import RecordingError
from dmp_teach.trajectory import Array

MOST_BYTES = 128_000_000  # an unpacked file and the numbers in it have fewer [bytes]
DEEPEST_CELL = 12  # cells and structs inside one another
MOST_CELLS = 200_000  # in a file
NUMBERS = {1: "i1", 2: "u1", 3: "i2", 4: "u2", 5: "i4", 6: "u4", 7: "f4", 9: "f8", 12: "i8"}
NUMBERS |= {13: "u8", 16: "u1", 17: "u2", 18: "u4"}
MATRIX, COMPRESSED, UTF8 = 14, 15, 16
CELL, STRUCT, TEXT = 1, 2, 4
NUMERIC = range(6, 16)
HDF5 = b"\x89HDF\r\n\x1a\n"
MAT_CURE = "Save it in MATLAB with save(..., '-v7')."

MatValue = Array | str | list["MatValue"] | dict[str, "MatValue"] | None
"""Numbers; text; a cell array, flat, or a struct array; a struct; or what is not read."""
Element = tuple[int, memoryview]
"""The kind of an element, and what is in it."""


def parse_mat(data: bytes) -> dict[str, MatValue]:
    """Return the variables of a file, by name.

    Raises:
        RecordingError: Not such a file, another version, broken off, or larger inside than ink can
            be.
    """
    if data[:8] == HDF5 or data[512:520] == HDF5 or data[:10] == b"MATLAB 7.3":
        raise RecordingError(f"is a MATLAB file of version 7.3, which is not read. {MAT_CURE}")
    orders: dict[bytes, Literal["<", ">"]] = {b"IM": "<", b"MI": ">"}
    order = orders.get(data[126:128])
    if order is None or data[:6] != b"MATLAB":
        raise RecordingError(f"is not a MATLAB file of version 5 to 7. {MAT_CURE}")
    file = _MatFile(order)
    parts: list[Element] = []
    for kind, content in file.elements(memoryview(data)[128:]):
        packed = kind == COMPRESSED
        parts += file.elements(file.unpacked(content)) if packed else [(kind, content)]
    return dict(file.matrix(content, 0) for kind, content in parts if kind == MATRIX)


class _MatFile:
    """A file while it is read: the order of its bytes, and how much it may still hold."""

    def __init__(self, order: Literal["<", ">"]) -> None:
        self.order: Literal["<", ">"] = order
        self.room, self.cells = MOST_BYTES, MOST_CELLS

    def elements(self, data: memoryview) -> list[Element]:
        """Return the elements that lie side by side."""
        found: list[Element] = []
        at = 0
        while len(data) - at >= 8:
            kind, size = struct.unpack(self.order + "II", data[at : at + 8])
            begin = at + 8
            # In a small element size and type share one word, and the content is the other.
            if kind >> 16:
                kind, size, begin = kind & 0xFFFF, kind >> 16, at + 4
                _require(size <= 4, "a small element of more than 4 bytes")
            at = begin + size + (0 if kind == COMPRESSED else -(begin + size) % 8)
            _require(begin + size <= len(data), f"it is broken off: {size} bytes should follow")
            found.append((kind, data[begin : begin + size]))
            _require(len(found) <= MOST_CELLS, f"it has more than {MOST_CELLS} elements in a row")
        return found

    def unpacked(self, data: memoryview) -> memoryview:
        """Unpack a compressed element as far as there is room."""
        stream = zlib.decompressobj()
        try:
            content = stream.decompress(data, self.room + 1)
        except zlib.error:
            content = b""
        self._take(len(content))
        _require(stream.eof, "a packed part is damaged, or broken off")
        return memoryview(content)

    def matrix(self, data: memoryview, depth: int) -> tuple[str, MatValue]:
        """Return the name and the value of one array."""
        if not len(data):
            return "", np.empty((0, 0))
        parts = self.elements(data)
        has_head = len(parts) > 2 and len(parts[0][1]) >= 4 and parts[1][0] == 5
        _require(has_head, "an array has no head")
        _require(depth <= DEEPEST_CELL, f"cells and structs lie more than {DEEPEST_CELL} deep")
        kind = struct.unpack(self.order + "I", parts[0][1][:4])[0] & 0xFF
        shape = tuple(self.numbers(parts[1:]).tolist())
        _require(0 < len(shape) <= 16 and min(shape) >= 0, "an array has no shape")
        name, rest, count = bytes(parts[2][1]).decode("latin-1"), parts[3:], math.prod(shape)
        if kind in NUMERIC:
            values = self.numbers(rest)  # without their imaginary part
            _require(len(values) == count, f"an array of shape {shape} has {len(values)} numbers")
            self._take(8 * count)
            return name, values.astype(float).reshape(shape, order="F")
        if kind == TEXT and rest and rest[0][0] == UTF8:
            return name, bytes(rest[0][1]).decode("utf-8", errors="replace")
        if kind == TEXT:
            codes = self.numbers(rest)
            self._take(4 * len(codes))
            return name, codes.astype("<u4").tobytes().decode("utf-32-le", errors="replace")
        if kind == CELL:
            return name, self._values(count, rest, depth)
        return name, self._struct(count, rest, depth) if kind == STRUCT else None

    def numbers(self, parts: list[Element]) -> np.ndarray:
        """Return the numbers of the first of some elements, shape (K,)."""
        kind, content = parts[0] if parts else (2, b"")
        _require(kind in NUMBERS, f"its numbers are of the unknown kind {kind}")
        dtype = np.dtype(NUMBERS[kind]).newbyteorder(self.order)
        _require(len(content) % dtype.itemsize == 0, "its numbers are broken off")
        return np.frombuffer(content, dtype)

    def _values(self, count: int, parts: list[Element], depth: int) -> list[MatValue]:
        """Return the values of so many arrays."""
        self.cells -= count
        _require(self.cells >= 0, f"it has more than {MOST_CELLS} cells")
        whole = len(parts) == count and all(kind == MATRIX for kind, _ in parts)
        _require(whole, "a cell array or a struct is broken off")
        return [self.matrix(content, depth + 1)[1] for _, content in parts]

    def _struct(self, count: int, parts: list[Element], depth: int) -> MatValue:
        """Return a struct as a dictionary, a struct array as a list of them."""
        width, text = int(self.numbers(parts).sum()), bytes(parts[1][1]) if len(parts) > 1 else b""
        _require(0 < width <= 256 and len(text) >= width, "a struct has no names")
        starts = range(0, len(text), width)
        names = [text[k : k + width].split(b"\0")[0].decode("latin-1") for k in starts]
        values = iter(self._values(count * len(names), parts[2:], depth))
        rows: list[MatValue] = [{name: next(values) for name in names} for _ in range(count)]
        return rows[0] if count == 1 else rows

    def _take(self, size: int) -> None:
        """Raise if there is no room for so many more bytes."""
        self.room -= size
        _require(self.room >= 0, f"it is larger than {MOST_BYTES / 1e6:.0f} MB inside")


def _require(holds: bool, fault: str) -> None:
    """Raise a RecordingError unless the file is sound."""
    if not holds:
        raise RecordingError(
            f"cannot be read as a MATLAB file: {fault}. Copy or download it again. {MAT_CURE}"
        )
