"""The view as a PNG, for places that run no scripts."""

from __future__ import annotations

import io

import numpy as np

from dmp_teach.errors import SettingError
from dmp_teach.robot import Mesh, picture
from dmp_teach.trajectory import Array
from dmp_teach.views.scene.cameras import Camera, known_camera
from dmp_teach.views.scene.force_strip import force_strip
from dmp_teach.views.scene.pressing import rgb
from dmp_teach.views.scene.ribbon import Ribbon
from dmp_teach.views.scene.shapes import lamp
from dmp_teach.views.scene.stage import Stage

INK_COLOR, PLAN_COLOR = (0.0, 0.447, 0.698, 1.0), (0.62, 0.64, 0.67, 1.0)
_SIZES = (64, 4000)
_STRIP = 0.26  # of a run's picture shows the force
_FAINT = 0.12  # as opaque is an arm that would hide the page, here and in scene_3d.js


def png(stage: Stage, time: float | None, camera: str, width: int, height: int) -> bytes:
    """The scene at a moment, as the bytes of a PNG file.

    Args:
        stage: What is to be seen.
        time: The moment [s]; None for the end.
        camera: "whole robot", "over the shoulder" or "page from above".
        width: Of the picture [pixels].
        height: Of the picture [pixels].

    Raises:
        SettingError: A time outside of the motion, a camera that there is not, a size that cannot be drawn.
        MissingPartError: pybullet is not installed.
    """
    time = stage.duration if time is None else time
    if not 0 <= time <= stage.duration:
        raise SettingError(
            f"time is {time} s, but must be between 0 and {stage.duration:.3f} s, when the motion ends."
        )
    low, high = _SIZES
    for name, size in (("width", width), ("height", height)):
        if not (isinstance(size, int | np.integer) and low <= size <= high):
            raise SettingError(
                f"{name} is {size!r}, but must be a whole number of pixels from {low} to {high}."
            )
    seen = stage.cameras[known_camera(camera)]
    under = (
        None if stage.run is None else force_strip(stage.run, time, width, round(_STRIP * height))
    )
    height -= 0 if under is None else len(under)
    pixels = _seen_by(seen, stage, time, width, height)
    return _encoded(pixels if under is None else np.vstack([pixels, under]))


def _seen_by(camera: Camera, stage: Stage, time: float, width: int, height: int) -> Array:
    """The pixels. The renderer knows nothing faint: a faint arm is a little of a picture with it, over one without."""
    slope = camera.slope(width / height)
    look = {"eye": camera.eye, "target": camera.target, "up": camera.up, "lamp": lamp(stage.page)}
    look |= {"field_of_view": 2 * np.degrees(np.arctan(slope)), "width": width, "height": height}
    pixels = picture(_meshes(stage, time, pen_only=False), **look)
    if not camera.see_through:
        return pixels
    behind = picture(_meshes(stage, time, pen_only=True), **look)
    return np.rint(_FAINT * pixels + (1 - _FAINT) * behind).astype(pixels.dtype)


def _meshes(stage: Stage, time: float, pen_only: bool) -> list[Mesh]:
    """Everything in the world at a time [s], the ink as far as it is written."""
    shapes = (*stage.robot(time, pen_only), *stage.around)
    meshes = [(shape.vertices, shape.normals, shape.faces, shape.color) for shape in shapes]
    meshes.append(_flat(stage, stage.plan, PLAN_COLOR, stage.plan.faces))
    written = stage.ink.faces[: stage.ink.triangles(time)]
    if stage.shades is None:
        return [*meshes, _flat(stage, stage.ink, INK_COLOR, written)]
    shades = stage.shades[stage.ink.owners[written[:, 0]]]
    colors = (((*rgb(number), 1.0), written[shades == number]) for number in np.unique(shades))
    return meshes + [_flat(stage, stage.ink, *colored) for colored in colors]


def _flat(stage: Stage, line: Ribbon, color: tuple, faces: Array) -> Mesh:
    """Some triangles of a ribbon on the page."""
    corners = line.vertices[: int(faces.max(initial=0)) + 1]
    up = np.tile(stage.page.normal, (len(corners), 1))
    return stage.page.to_world(corners), up, faces, color


def _encoded(pixels: Array) -> bytes:
    """As PNG."""
    from PIL import Image  # noqa: PLC0415 (only pictures need it)

    file = io.BytesIO()
    Image.fromarray(pixels).save(file, format="PNG", optimize=True)
    return file.getvalue()
