"""Meshes, tracks and commands in as few bytes as three.js can read."""

from __future__ import annotations

import gzip
import struct
from collections.abc import Sequence

import numpy as np
import umsgpack

from dmp_teach.trajectory import Array

_CODES = {
    "int8": 0x11,
    "uint8": 0x12,
    "uint16": 0x14,
    "int16": 0x13,
    "uint32": 0x16,
    "float32": 0x17,
}
"""The numbers by which the viewer's msgpack knows a typed array."""

_UNTIL_THE_NEXT_KEY = 2300
"""Three.js's number for a track that does not interpolate."""


def typed(array: Array) -> dict:
    """An array as three.js reads it; its bytes travel as they are."""
    name = {"i": "Int", "u": "Uint", "f": "Float"}[array.dtype.kind]
    code = umsgpack.Ext(_CODES[array.dtype.name], np.ascontiguousarray(array).tobytes())
    return {"type": f"{name}{8 * array.dtype.itemsize}Array", "array": code}


FINE = 2e-5
"""Ink need not be finer than this [m]: rounder numbers, smaller files."""


class PackedMesh:
    """A mesh in whole numbers: 16 bits a coordinate (a part of 65 000 of the mesh's size), 8 a normal and a colour."""

    def __init__(
        self, vertices: Array, normals: Array | None, faces: Array, colors: Array | None = None
    ) -> None:
        coarse = FINE if normals is None else 0.0
        middle = (vertices.min(axis=0) + vertices.max(axis=0)) / 2 if len(vertices) else np.zeros(3)
        scale = max(float(np.abs(vertices - middle).max(initial=0.0)) / 32767, coarse, 1e-9)
        self.X = np.diag([scale, scale, scale, 1.0])
        self.X[:3, 3] = middle
        self.vertices = np.rint((vertices - middle) / scale).astype(np.int16)
        self.normals = None if normals is None else np.rint(normals * 127).astype(np.int8)
        self.colors = None if colors is None else np.rint(np.asarray(colors) * 255).astype(np.uint8)
        self.faces = faces.astype(np.uint16 if len(vertices) < 65536 else np.uint32)

    def lower(self, name: str) -> dict:
        """A BufferGeometry of that name, to be drawn at the pose and scale `X` (4, 4)."""
        attributes = {"position": typed(self.vertices) | {"itemSize": 3, "normalized": False}}
        if self.normals is not None:
            attributes["normal"] = typed(self.normals) | {"itemSize": 3, "normalized": True}
        if self.colors is not None:
            attributes["color"] = typed(self.colors) | {"itemSize": 3, "normalized": True}
        return {
            "uuid": name,
            "type": "BufferGeometry",
            "data": {"attributes": attributes, "index": typed(self.faces.ravel())},
        }


class Track:
    """One property over time, as two arrays where meshcat writes a table of keys.

    Args:
        name: What changes, in three.js's words.
        kind: "vector3", "quaternion" or "number".
        times: Increasing, shape (K,) [s].
        values: Shape (K, D).
        stepped: True where a value stays until the next key.
    """

    def __init__(
        self, name: str, kind: str, times: Array, values: Array, stepped: bool = False
    ) -> None:
        self.name, self.kind, self.times, self.values, self.stepped = (
            name,
            kind,
            times,
            values,
            stepped,
        )

    def lower(self) -> dict:
        """As three.js reads it."""
        times, values = (
            typed(np.float32(array).ravel())["array"] for array in (self.times, self.values)
        )
        step = {"interpolation": _UNTIL_THE_NEXT_KEY} if self.stepped else {}
        return {"name": f".{self.name}", "type": self.kind, "times": times, "values": values} | step


def bundle(commands: Sequence[bytes]) -> bytes:
    """Commands in one compressed piece: before each its length in 4 bytes, the least significant first."""
    return gzip.compress(
        b"".join(struct.pack("<I", len(command)) + command for command in commands), 9, mtime=0
    )


def unbundle(data: bytes) -> tuple[bytes, ...]:
    """The commands of a bundle."""
    plain, start, commands = gzip.decompress(data), 0, []
    while start < len(plain):
        (length,) = struct.unpack_from("<I", plain, start)
        commands.append(plain[start + 4 : start + 4 + length])
        start += 4 + length
    return tuple(commands)
