"""The scene as commands for meshcat's viewer: recorded here, never sent.

Stock meshcat starts a web server that everybody in the room can reach. Here its Python API only
records the commands; the viewer script gets them in the browser over the kernel's own channel, or
from the file itself.
"""

from __future__ import annotations

import gzip
from functools import lru_cache
from importlib import resources
from typing import Any

import meshcat
import numpy as np
import umsgpack
from meshcat.animation import Animation, AnimationClip

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


class CommandRecorder:
    """A window for meshcat that opens nothing: it keeps the packed commands."""

    def __init__(self) -> None:
        self.commands: list[bytes] = []

    # Any: meshcat's commands share no type.
    def send(self, command: Any) -> None:
        """Keep one command, as the viewer in the browser wants it."""
        self.commands.append(umsgpack.packb(command.lower(), force_float_precision="single"))


class _Mesh(meshcat.geometry.Geometry):
    """A mesh in few bytes, with the normals that make it smooth."""

    def __init__(self, name: str, mesh: PackedMesh) -> None:
        # Meshcat's own identifiers hold the machine's address and the time.
        self.uuid = name
        self.mesh = mesh

    def intrinsic_transform(self) -> Array:
        """Return the pose transposed: three.js reads columns where meshcat writes rows."""
        return self.mesh.X.T

    def lower(self, object_data: dict[str, object]) -> dict[str, object]:
        """Return the mesh as three.js reads it."""
        return self.mesh.lower(self.uuid)


class _Property(meshcat.commands.SetProperty):
    """A property whose name keeps its capitals, as `castShadow`."""

    __slots__ = ()

    def lower(self) -> dict[str, object]:
        """Return the command with the name as it is."""
        return super().lower() | {"property": self.key}


class _Shadow(meshcat.geometry.GenericMaterial):
    """A material that shows nothing but the shadows that fall on it."""

    _type = "ShadowMaterial"


def record_robot() -> tuple[bytes, ...]:
    """Return the robot's shell, the floor and the lights: the same for every motion."""
    recorder = CommandRecorder()
    viewer = meshcat.Visualizer(window=recorder)
    for path, key, value in VIEWER_LIGHTS:
        _set_property(viewer[path], key, value)
    model = load_robot_model()
    paths = find_link_paths()
    poses = model.link_poses(np.zeros((1, 0)), ())
    for joint in model.joints:
        viewer[paths[joint.child]].set_transform(
            np.linalg.solve(poses[joint.parent][0], poses[joint.child][0])
        )
    for number, piece in enumerate(model.visuals):
        X = piece.X_link_visual
        _put_shape(viewer[paths[piece.link]], build_visual(piece, f"piece{number}").moved(X))
    floor = build_floor()
    _put_shape(viewer, floor, _Shadow(color=0x000000, opacity=floor.color[3], transparent=True))
    return tuple(recorder.commands)


def record_stage(stage: Stage) -> tuple[bytes, ...]:
    """Return page, letter and the robot's first pose, and last one animation of all."""
    recorder = CommandRecorder()
    viewer = meshcat.Visualizer(window=recorder)
    viewer["around"].delete()
    lamp = viewer["/Lights/SpotLight/<object>"]
    _set_property(lamp, "position", place_lamp(stage.page).tolist())
    for shape in stage.surroundings:
        _put_shape(viewer["around"], shape, gloss=0)
    _put_ribbon(viewer["plan"], "plan", stage.plan, stage, PLAN_HEX)
    _put_ribbon(viewer["ink"], "ink", stage.ink, stage, INK_HEX)
    model = stage.model
    paths = find_link_paths()
    # Another motion may have moved the pen in its holder.
    pen = next(joint for joint in model.joints if joint.child == "pen_link")
    viewer[paths["pen_link"]].set_transform(pen.pose(np.zeros(1))[0])
    times, q = stage.keys
    clips = {}
    for name, column in zip(stage.joint_names, q.T, strict=True):
        joint = model.joint(name)
        node = viewer[paths[joint.child]]
        node.set_transform(joint.pose(column[:1])[0])
        if np.ptp(column) > 0:
            clips[node.path] = _build_clip(build_joint_track(joint, times, column))
    if np.isfinite(stage.breaks_at):
        clips[viewer[paths["pen_link"]].path] = _build_clip(build_break_track(stage.breaks_at))
    if len(stage.ink.t):
        clips[viewer["ink/<object>"].path] = _build_clip(build_ink_track(stage.ink))
    viewer.set_animation(Animation(clips), play=False)
    return tuple(recorder.commands)


def _set_property(node: meshcat.Visualizer, key: str, value: object) -> None:
    """Set a property, its name as it is."""
    node.window.send(_Property(key, value, node.path))


def _put_shape(
    parent: meshcat.Visualizer,
    shape: ColoredMesh,
    material: meshcat.geometry.Material | None = None,
    gloss: int = 0x1C1C1C,
) -> None:
    """Put a mesh of one colour under a node."""
    red, green, blue = (round(255 * part) for part in shape.color[:3])
    if material is None:
        color = (red << 16) + (green << 8) + blue
        material = meshcat.geometry.MeshPhongMaterial(
            color=color, shininess=30, specular=gloss, side=0
        )
    mesh = PackedMesh(shape.vertices, shape.normals, shape.faces)
    _put_mesh(parent[shape.name], _Mesh(shape.name, mesh), material)


def _put_ribbon(
    node: meshcat.Visualizer, name: str, ribbon: Ribbon, stage: Stage, color: int
) -> None:
    """Put a ribbon on the page in a colour that no lamp changes, a run's ink in its shades."""
    colors = None
    if name == "ink" and stage.shades is not None:
        shades = np.array([shade_rgb(number) for number in range(len(FORCE_SHADES))])
        colors = shades[stage.shades][ribbon.owners]
        color = WHITE_HEX
    material = meshcat.geometry.MeshBasicMaterial(color=color, vertexColors=colors is not None)
    mesh = PackedMesh(ribbon.vertices, None, ribbon.faces, colors)
    _put_mesh(node, _Mesh(name, mesh), material)
    node.set_transform(stage.page.X_world_page)


def _put_mesh(node: meshcat.Visualizer, mesh: _Mesh, material: meshcat.geometry.Material) -> None:
    """Put a mesh at a node, named by what it is and not by the machine's address."""
    material.uuid = f"{mesh.uuid} material"
    piece = meshcat.geometry.Mesh(mesh, material)
    piece.uuid = f"{mesh.uuid} object"
    node.set_object(piece)


def _build_clip(track: KeyframeTrack) -> AnimationClip:
    """Return a clip of one track, its times in seconds."""
    return AnimationClip(tracks={track.name: track}, fps=1)


@lru_cache(maxsize=1)
def pack_robot() -> bytes:
    """Return the robot for the browser."""
    return pack_commands(record_robot())


@lru_cache(maxsize=1)
def pack_viewer() -> bytes:
    """Return meshcat's own viewer, as it is installed, compressed."""
    script = resources.files("meshcat").joinpath("viewer/dist/main.min.js").read_bytes()
    return gzip.compress(script, 9, mtime=0)
