"""Meshes, tracks and commands in as few bytes as three.js can read."""

from __future__ import annotations

import gzip
import struct
from collections.abc import Sequence
from typing import Any

import numpy as np
import umsgpack
from numpy.typing import NDArray

from dmp_teach.trajectory import Array

# Any: whole numbers of any size.
Faces = NDArray[Any]

INK_RESOLUTION = 2e-5
"""Ink need not be finer than this [m]: rounder numbers make smaller files."""

_TYPED_ARRAY_CODES = {
    "int8": 0x11,
    "uint8": 0x12,
    "uint16": 0x14,
    "int16": 0x13,
    "uint32": 0x16,
    "float32": 0x17,
}
"""The numbers by which the viewer's msgpack knows a typed array."""

_INTERPOLATE_DISCRETE = 2300
"""Three.js's number for a track that does not interpolate."""


# Any: arrays of every type of number.
def encode_array(array: NDArray[Any]) -> dict[str, object]:
    """Return an array as three.js reads it; its bytes travel as they are."""
    name = {"i": "Int", "u": "Uint", "f": "Float"}[array.dtype.kind]
    content = np.ascontiguousarray(array).tobytes()
    return {
        "type": f"{name}{8 * array.dtype.itemsize}Array",
        "array": umsgpack.Ext(_TYPED_ARRAY_CODES[array.dtype.name], content),
    }


class PackedMesh:
    """A mesh in whole numbers: 16 bits a coordinate, 8 a normal and a colour.

    Args:
        vertices: Shape (V, 3) [m].
        normals: Shape (V, 3); None where the mesh is ink.
        faces: Numbers of corners, shape (F, 3).
        colors: Red, green and blue, 0 to 1, shape (V, 3), or None.
    """

    def __init__(
        self, vertices: Array, normals: Array | None, faces: Faces, colors: Array | None = None
    ) -> None:
        coarse = INK_RESOLUTION if normals is None else 0.0
        middle = (vertices.min(axis=0) + vertices.max(axis=0)) / 2 if len(vertices) else np.zeros(3)
        scale = max(float(np.abs(vertices - middle).max(initial=0.0)) / 32767, coarse, 1e-9)
        self.X = np.diag([scale, scale, scale, 1.0])
        self.X[:3, 3] = middle
        self.vertices = np.rint((vertices - middle) / scale).astype(np.int16)
        self.normals = None if normals is None else np.rint(normals * 127).astype(np.int8)
        self.colors = None if colors is None else np.rint(np.asarray(colors) * 255).astype(np.uint8)
        self.faces = faces.astype(np.uint16 if len(vertices) < 65536 else np.uint32)

    def lower(self, name: str) -> dict[str, object]:
        """Return a BufferGeometry of that name, to be drawn at the pose and scale `X` (4, 4)."""
        attributes = {
            "position": encode_array(self.vertices) | {"itemSize": 3, "normalized": False}
        }
        if self.normals is not None:
            attributes["normal"] = encode_array(self.normals) | {"itemSize": 3, "normalized": True}
        if self.colors is not None:
            attributes["color"] = encode_array(self.colors) | {"itemSize": 3, "normalized": True}
        return {
            "uuid": name,
            "type": "BufferGeometry",
            "data": {"attributes": attributes, "index": encode_array(self.faces.ravel())},
        }


class KeyframeTrack:
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
        self.name = name
        self.kind = kind
        self.times = times
        self.values = values
        self.stepped = stepped

    def lower(self) -> dict[str, object]:
        """Return the track as three.js reads it."""
        lowered = {
            "name": f".{self.name}",
            "type": self.kind,
            "times": encode_array(np.float32(self.times).ravel())["array"],
            "values": encode_array(np.float32(self.values).ravel())["array"],
        }
        if self.stepped:
            lowered["interpolation"] = _INTERPOLATE_DISCRETE
        return lowered


def pack_commands(commands: Sequence[bytes]) -> bytes:
    """Compress commands into one piece: before each its length in 4 bytes, little-endian."""
    plain = b"".join(struct.pack("<I", len(command)) + command for command in commands)
    return gzip.compress(plain, 9, mtime=0)
