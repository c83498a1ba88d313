"""pybullet's worlds and its renderer, which draws pictures without a browser."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from types import ModuleType

import numpy as np
from numpy.typing import ArrayLike, NDArray

from dmp_teach.errors import MissingPartError
from dmp_teach.robot.quiet import quiet
from dmp_teach.trajectory import Array

Mesh = tuple[Array, Array, NDArray[np.int64], Sequence[float]]
"""Vertices (V, 3) in the world [m], normals (V, 3), triangles (F, 3), and a colour (4,)."""

# The renderer has no smooth edges: draw so many times larger, then average.
_FINER = 2


@contextmanager
def open_world() -> Iterator[tuple[ModuleType, int]]:
    """Open a pybullet world without a window; one that stays open keeps 30 MB."""
    try:
        with quiet():  # it prints when it was built
            import pybullet  # noqa: PLC0415 (heavy, and absent on some platforms)
    except ImportError:
        raise MissingPartError(
            "Pictures and physics need pybullet, which is not installed here. The live view and "
            "view(motion).html(path) work without it. Where pip has a pybullet for this platform, "
            "`pip install pybullet` brings it."
        ) from None
    number = pybullet.connect(pybullet.DIRECT)
    try:
        yield pybullet, number
    finally:
        pybullet.disconnect(number)


def render_meshes(
    meshes: Sequence[Mesh],
    *,
    eye: ArrayLike,
    target: ArrayLike,
    up: ArrayLike,
    field_of_view: float,
    width: int,
    height: int,
    lamp: ArrayLike = (0.3, 1.8, 4.4),
) -> NDArray[np.uint8]:
    """Draw meshes with pybullet's software renderer.

    Args:
        meshes: What is to be seen.
        eye: Where the camera is (3,) [m].
        target: The middle of the picture (3,) [m].
        up: What points up in the picture (3,).
        field_of_view: From the bottom to the top of the picture [degrees].
        width: Of the picture [pixels].
        height: Of the picture [pixels].
        lamp: Where the light comes from (3,) [m].

    Returns:
        Red, green and blue, shape (height, width, 3).

    Raises:
        MissingPartError: pybullet is not installed.
    """
    with open_world() as (bullet, number):
        for mesh in meshes:
            _add(bullet, number, mesh)
        _, _, pixels, depth, _ = bullet.getCameraImage(
            width * _FINER,
            height * _FINER,
            bullet.computeViewMatrix(*(np.asarray(at).tolist() for at in (eye, target, up))),
            bullet.computeProjectionMatrixFOV(field_of_view, width / height, 0.05, 12.0),
            lightDirection=np.asarray(lamp).tolist(),
            shadow=0,
            flags=bullet.ER_NO_SEGMENTATION_MASK,
            lightAmbientCoeff=0.62,
            lightDiffuseCoeff=0.42,
            lightSpecularCoeff=0.06,
            renderer=bullet.ER_TINY_RENDERER,
            physicsClientId=number,
        )
    drawn = np.reshape(pixels, (height * _FINER, width * _FINER, 4))[..., :3]
    empty = np.reshape(depth, drawn.shape[:2]) >= 1.0
    sky = np.rint(np.linspace((246, 249, 253), (222, 229, 239), len(drawn))).astype(np.uint8)
    drawn = np.where(empty[..., None], sky[:, None], drawn)
    parts = [drawn[i::_FINER, j::_FINER] for i in range(_FINER) for j in range(_FINER)]
    total = np.sum(parts, axis=0, dtype=np.uint16)
    return np.asarray((total + len(parts) // 2) // len(parts), dtype=np.uint8)


def _add(bullet: ModuleType, number: int, mesh: Mesh) -> None:
    """Put a mesh into the world; a mesh with nothing in it is left out."""
    vertices, normals, faces, color = mesh
    if not len(faces):
        return
    shape = bullet.createVisualShape(
        bullet.GEOM_MESH,
        vertices=vertices.tolist(),
        normals=normals.tolist(),
        uvs=np.zeros((len(vertices), 2)).tolist(),
        indices=faces.ravel().tolist(),
        rgbaColor=list(color),
        physicsClientId=number,
    )
    bullet.createMultiBody(baseVisualShapeIndex=shape, physicsClientId=number)
