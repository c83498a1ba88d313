"""The view as a PNG, for places that run no scripts."""

from __future__ import annotations

import io

import numpy as np
from numpy.typing import NDArray

from dmp_teach.errors import SettingError
from dmp_teach.robot import Mesh, render_meshes
from dmp_teach.views.scene.cameras import Camera, check_camera_name
from dmp_teach.views.scene.force_strip import draw_force_strip
from dmp_teach.views.scene.packing import Faces
from dmp_teach.views.scene.pen_force import shade_rgb
from dmp_teach.views.scene.ribbon import Ribbon
from dmp_teach.views.scene.shapes import Rgba, place_lamp
from dmp_teach.views.scene.stage import Stage

INK_RGBA = (0.0, 0.447, 0.698, 1.0)
PLAN_RGBA = (0.62, 0.64, 0.67, 1.0)

_MIN_PIXELS = 64
_MAX_PIXELS = 4000
_STRIP_SHARE = 0.26


def render_png(stage: Stage, time: float | None, camera: str, width: int, height: int) -> bytes:
    """Return the scene as the bytes of a PNG file; arguments and errors as `SceneView.png`."""
    time = stage.duration if time is None else time
    if not 0 <= time <= stage.duration:
        raise SettingError(
            f"time is {time} s, but must be between 0 and {stage.duration:.3f} s, when the motion "
            "ends."
        )
    for name, size in (("width", width), ("height", height)):
        if not (isinstance(size, int | np.integer) and _MIN_PIXELS <= size <= _MAX_PIXELS):
            raise SettingError(
                f"{name} is {size!r}, but must be a whole number of pixels from {_MIN_PIXELS} to "
                f"{_MAX_PIXELS}."
            )
    chosen = stage.cameras[check_camera_name(camera)]
    if stage.run is None:
        return _encode_png(_render(chosen, stage, time, width, height))
    strip = draw_force_strip(stage.run, time, width, round(_STRIP_SHARE * height))
    pixels = _render(chosen, stage, time, width, height - len(strip))
    return _encode_png(np.vstack([pixels, strip]))


def _render(
    camera: Camera, stage: Stage, time: float, width: int, height: int
) -> NDArray[np.uint8]:
    """Return the pixels, shape (height, width, 3)."""
    slope = camera.slope(width / height)

    return render_meshes(
        _collect_meshes(stage, time, camera.pen_only),
        eye=camera.eye,
        target=camera.target,
        up=camera.up,
        lamp=place_lamp(stage.page),
        field_of_view=2 * float(np.degrees(np.arctan(slope))),
        width=width,
        height=height,
    )


def _collect_meshes(stage: Stage, time: float, pen_only: bool) -> list[Mesh]:
    """Return everything in the world at a time [s], the ink as far as it is written."""
    shapes = (*stage.robot(time, pen_only), *stage.surroundings)
    meshes: list[Mesh] = [
        (shape.vertices, shape.normals, shape.faces, shape.color) for shape in shapes
    ]
    meshes.append(_build_flat_mesh(stage, stage.plan, PLAN_RGBA, stage.plan.faces))
    written = stage.ink.faces[: stage.ink.triangles(time)]
    if stage.shades is None:
        return [*meshes, _build_flat_mesh(stage, stage.ink, INK_RGBA, written)]
    shades = stage.shades[stage.ink.owners[written[:, 0]]]
    for number in np.unique(shades):
        color = (*shade_rgb(number), 1.0)
        meshes.append(_build_flat_mesh(stage, stage.ink, color, written[shades == number]))
    return meshes


def _build_flat_mesh(stage: Stage, line: Ribbon, color: Rgba, faces: Faces) -> Mesh:
    """Return some triangles of a ribbon on the page."""
    corners = line.vertices[: int(faces.max(initial=0)) + 1]
    up = np.tile(stage.page.normal, (len(corners), 1))
    return stage.page.to_world(corners), up, faces, color


def _encode_png(pixels: NDArray[np.uint8]) -> bytes:
    """Return pixels as the bytes of a PNG file."""
    from PIL import Image  # noqa: PLC0415 (a panel in a static site waits for no more than it needs)

    file = io.BytesIO()
    Image.fromarray(pixels).save(file, format="PNG")
    return file.getvalue()
