"""The scene as commands for meshcat's viewer, which is JavaScript; its Python is never imported.

That would start a web server that everybody in the room can reach. The viewer gets the commands in
the browser over the kernel's own channel, or from the file itself.
"""

from __future__ import annotations

import gzip
from collections.abc import Iterable, Iterator
from functools import lru_cache
from importlib.metadata import PackageNotFoundError, distribution
from pathlib import Path
from typing import Any, cast

import numpy as np
import umsgpack

from dmp_teach.errors import MissingPartError
from dmp_teach.trajectory import Array
from dmp_teach.views.scene.packing import KeyframeTrack, PackedMesh, pack_commands
from dmp_teach.views.scene.pen_force import FORCE_SHADES, shade_rgb
from dmp_teach.views.scene.ribbon import Ribbon
from dmp_teach.views.scene.shapes import ColoredMesh, build_floor, place_lamp
from dmp_teach.views.scene.stage import Stage, build_visual, load_robot_model
from dmp_teach.views.scene.tracks import (
    build_break_track,
    build_ink_track,
    build_joint_track,
    find_link_paths,
)

INK_HEX = 0x0072B2
PLAN_HEX = 0x9AA1A9
WHITE_HEX = 0xFFFFFF

VIEWER_LIGHTS = (
    ("/Grid", "visible", False),
    ("/Axes", "visible", False),
    ("/Lights/SpotLight", "visible", True),
    ("/Lights/SpotLight/<object>", "intensity", 0.40),
    ("/Lights/SpotLight/<object>", "penumbra", 0.6),
    ("/Lights/SpotLight/<object>", "castShadow", True),
    ("/Lights/PointLightNegativeX", "visible", False),
    ("/Lights/PointLightPositiveX", "visible", False),
    ("/Lights/AmbientLight/<object>", "intensity", 0.58),
    ("/Lights/FillLight/<object>", "intensity", 0.22),
)
"""Meshcat's own things: a lamp with soft shadows, light from all sides, no grid, no axes."""


# Any: what a command tells the viewer, as msgpack carries it.
Command = dict[str, Any]
Material = dict[str, Any]


def record_robot() -> tuple[bytes, ...]:
    """Return the robot's shell, the floor and the lights: the same for every motion."""
    return _pack(_list_robot())


def record_stage(stage: Stage) -> tuple[bytes, ...]:
    """Return page, letter and the robot's first pose, and last one animation of all."""
    return _pack(_list_stage(stage))


def _pack(commands: Iterable[Command]) -> tuple[bytes, ...]:
    """Return commands as the viewer in the browser reads them."""
    return tuple(umsgpack.packb(each, force_float_precision="single") for each in commands)


def _list_robot() -> Iterator[Command]:
    """Yield what shows the robot, the floor and the lights."""
    for path, name, value in VIEWER_LIGHTS:
        yield _command("set_property", path, property=name, value=value)
    model = load_robot_model()
    paths = find_link_paths()
    poses = model.link_poses(np.zeros((1, 0)), ())
    for joint in model.joints:
        X_parent_child = np.linalg.solve(poses[joint.parent][0], poses[joint.child][0])
        yield _set_transform(paths[joint.child], X_parent_child)
    for number, piece in enumerate(model.visuals):
        shape = build_visual(piece, f"piece{number}").moved(piece.X_link_visual)
        yield _put_shape(paths[piece.link], shape)
    floor = build_floor()
    # Nothing of it is seen but the shadows that fall on it.
    shadow = _material("ShadowMaterial", 0x000000, opacity=floor.color[3], transparent=True)
    yield _put_shape("", floor, shadow)


def _list_stage(stage: Stage) -> Iterator[Command]:
    """Yield what shows page, letter and the robot in its first pose, and what moves it."""
    yield _command("delete", "around")
    lamp = place_lamp(stage.page).tolist()
    yield _command("set_property", "/Lights/SpotLight/<object>", property="position", value=lamp)
    for shape in stage.surroundings:
        yield _put_shape("around", shape, gloss=0)
    yield from _put_ribbon("plan", stage.plan, stage, PLAN_HEX)
    yield from _put_ribbon("ink", stage.ink, stage, INK_HEX)
    paths = find_link_paths()
    # Another motion may have moved the pen in its holder.
    pen = next(joint for joint in stage.model.joints if joint.child == "pen_link")
    yield _set_transform(paths["pen_link"], pen.pose(np.zeros(1))[0])
    times, q = stage.keys
    tracks = {}
    for name, column in zip(stage.joint_names, q.T, strict=True):
        joint = stage.model.joint(name)
        yield _set_transform(paths[joint.child], joint.pose(column[:1])[0])
        if np.ptp(column) > 0:
            tracks[paths[joint.child]] = build_joint_track(joint, times, column)
    if np.isfinite(stage.breaks_at):
        tracks[paths["pen_link"]] = build_break_track(stage.breaks_at)
    if len(stage.ink.t):
        tracks["ink/<object>"] = build_ink_track(stage.ink)
    yield {
        "type": "set_animation",
        "animations": [_animate(path, track) for path, track in tracks.items()],
        "options": {"play": False, "repetitions": 1},
        "path": "",
    }


# Any: as in `Command`.
def _command(kind: str, path: str, **values: Any) -> Command:
    """Return a command to a place in the viewer's tree: its own begin with /."""
    return {"type": kind, "path": _find_place(path), **values}


def _find_place(path: str) -> str:
    """Return a path in the viewer's tree; what is shown stands under /meshcat."""
    return path if path.startswith("/") else f"/meshcat/{path}".rstrip("/")


def _set_transform(path: str, X_parent_node: Array) -> Command:
    """Return the command that places a node in its parent: a pose (4, 4), column by column."""
    return _command("set_transform", path, matrix=X_parent_node.T.ravel().tolist())


def _animate(path: str, track: KeyframeTrack) -> Command:
    """Return a clip of one track, its times in seconds."""
    clip = {"fps": 1, "name": "default", "tracks": [track.lower()]}
    return {"path": _find_place(path), "clip": clip}


# Any: three.js's own names and values.
def _material(kind: str, color: int, **properties: Any) -> Material:
    """Return a material of three.js, seen from both sides unless that is said."""
    return {"type": kind, "color": color, "side": 2, **properties}


def _put_shape(
    parent: str, shape: ColoredMesh, material: Material | None = None, gloss: int = 0x1C1C1C
) -> Command:
    """Return the command that puts a mesh of one colour under a node."""
    red, green, blue = (round(255 * part) for part in shape.color[:3])
    if material is None:
        color = (red << 16) + (green << 8) + blue
        material = _material("MeshPhongMaterial", color, shininess=30, specular=gloss, side=0)
    mesh = PackedMesh(shape.vertices, shape.normals, shape.faces)
    return _set_object(f"{parent}/{shape.name}".lstrip("/"), shape.name, mesh, material)


def _put_ribbon(name: str, ribbon: Ribbon, stage: Stage, color: int) -> Iterator[Command]:
    """Yield a ribbon on the page in a colour that no lamp changes, a run's ink in its shades."""
    colors = None
    if name == "ink" and stage.shades is not None:
        shades = np.array([shade_rgb(number) for number in range(len(FORCE_SHADES))])
        colors = shades[stage.shades][ribbon.owners]
        color = WHITE_HEX
    material = _material("MeshBasicMaterial", color, vertexColors=colors is not None)
    mesh = PackedMesh(ribbon.vertices, None, ribbon.faces, colors)
    yield _set_object(name, name, mesh, material)
    yield _set_transform(name, stage.page.X_world_page)


def _set_object(path: str, name: str, mesh: PackedMesh, material: Material) -> Command:
    """Return the command that puts a mesh at a node, all named by what it is."""
    piece = {
        "uuid": f"{name} object",
        "type": "Mesh",
        "geometry": name,
        "material": f"{name} material",
        "matrix": mesh.X.T.ravel().tolist(),
    }
    content = {
        "metadata": {"version": 4.5, "type": "Object"},
        "geometries": [mesh.lower(name)],
        "materials": [{"uuid": piece["material"], **material}],
        "object": piece,
    }
    return _command("set_object", path, object=content)


@lru_cache(maxsize=1)
def pack_robot() -> bytes:
    """Return the robot for the browser."""
    return pack_commands(record_robot())


@lru_cache(maxsize=1)
def pack_viewer() -> bytes:
    """Return meshcat's own viewer, as it is installed, compressed.

    Raises:
        MissingPartError: meshcat is not installed.
    """
    try:
        viewer = distribution("meshcat").locate_file("meshcat/viewer/dist/main.min.js")
    except PackageNotFoundError:
        raise MissingPartError("The 3-D view needs meshcat: pip install meshcat.") from None
    # It may stand in an archive.
    return gzip.compress(cast("Path", viewer).read_bytes(), 9, mtime=0)
