"""The scene as commands for meshcat's viewer: recorded here, sent to nobody.

Stock meshcat starts a web server that everybody in the room can reach. Here its Python API only records the
commands; the viewer script gets them in the browser over the kernel's own channel, or from the file itself.
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
from dmp_teach.views.scene.packing import PackedMesh, Track, bundle
from dmp_teach.views.scene.pressing import SHADES, rgb
from dmp_teach.views.scene.ribbon import Ribbon
from dmp_teach.views.scene.shapes import LIGHTS, Shape, floor, lamp
from dmp_teach.views.scene.stage import Stage, robot_model
from dmp_teach.views.scene.tracks import ink_track, joint_track, link_paths

INK, PLAN = 0x0072B2, 0x9AA1A9


class Recorder:
    """A window for meshcat that opens nothing: it keeps the packed commands."""

    def __init__(self) -> None:
        self.commands: list[bytes] = []

    def send(self, command: Any) -> None:
        """Keep one command, as the viewer in the browser wants it."""
        self.commands.append(umsgpack.packb(command.lower(), force_float_precision="single"))


class _Mesh(meshcat.geometry.Geometry):
    """A mesh in few bytes, with the normals that make it smooth."""

    def __init__(
        self,
        name: str,
        vertices: Array,
        normals: Array | None,
        faces: Array,
        colors: Array | None = None,
    ) -> None:
        self.uuid = name  # meshcat would take the machine's address and the time
        self.mesh = PackedMesh(vertices, normals, faces, colors)

    def intrinsic_transform(self) -> Array:
        """Transposed: three.js reads columns where meshcat writes rows."""
        return self.mesh.X.T

    def lower(self, object_data: dict) -> dict:
        """As three.js reads it."""
        return self.mesh.lower(self.uuid)


class _Property(meshcat.commands.SetProperty):
    """Meshcat writes the names of properties in small letters, so that it cannot name `castShadow`."""

    __slots__ = ()

    def lower(self) -> dict:
        """The name as it is."""
        return super().lower() | {"property": self.key}


class _Shadow(meshcat.geometry.GenericMaterial):
    """Shows nothing but the shadows that fall on it."""

    _type = "ShadowMaterial"


def robot_commands() -> tuple[bytes, ...]:
    """The robot's shell, the floor and the lights: the same for every motion."""
    recorder = Recorder()
    viewer = meshcat.Visualizer(window=recorder)
    for path, key, value in LIGHTS:
        _tell(viewer[path], key, value)
    model, paths = robot_model(), link_paths()
    poses = model.link_poses(np.zeros((1, 0)), ())
    for joint in model.joints:
        viewer[paths[joint.child]].set_transform(
            np.linalg.solve(poses[joint.parent][0], poses[joint.child][0])
        )
    for number, piece in enumerate(model.visuals):
        X = piece.X_link_visual
        vertices, normals = piece.vertices @ X[:3, :3].T + X[:3, 3], piece.normals @ X[:3, :3].T
        shape = Shape(f"piece{number}", vertices, normals, piece.faces, tuple(piece.color))
        _put(viewer[paths[piece.link]], shape)
    ground = floor()
    _put(viewer, ground, _Shadow(color=0x000000, opacity=ground.color[3], transparent=True))
    return tuple(recorder.commands)


def run_commands(stage: Stage) -> tuple[bytes, ...]:
    """The page and what carries it, the letter, where the robot stands, and last one animation of all."""
    recorder = Recorder()
    viewer = meshcat.Visualizer(window=recorder)
    viewer["around"].delete()
    _tell(viewer["/Lights/SpotLight/<object>"], "position", lamp(stage.page).tolist())
    for shape in stage.around:
        _put(viewer["around"], shape, gloss=0)
    _put_ribbon(viewer["plan"], "plan", stage.plan, stage, PLAN)
    _put_ribbon(viewer["ink"], "ink", stage.ink, stage, INK)
    model, paths = stage.model, link_paths()
    pen = next(joint for joint in model.joints if joint.child == "pen_link")
    viewer[paths["pen_link"]].set_transform(
        pen.pose(np.zeros(1))[0]
    )  # where another motion may have left it
    times, q = stage.keys
    clips = {}
    for name, column in zip(stage.joint_names, q.T, strict=True):
        joint = model.joint(name)
        node = viewer[paths[joint.child]]
        node.set_transform(joint.pose(column[:1])[0])
        if np.ptp(column) > 0:
            clips[node.path] = _clip(joint_track(joint, times, column))
    if len(stage.ink.t):
        clips[viewer["ink/<object>"].path] = _clip(ink_track(stage.ink))
    viewer.set_animation(Animation(clips), play=False)
    return tuple(recorder.commands)


def _tell(node: meshcat.Visualizer, key: str, value: Any) -> None:
    """Set a property, its name as it is."""
    node.window.send(_Property(key, value, node.path))


def _put(
    parent: meshcat.Visualizer, shape: Shape, material: Any = None, gloss: int = 0x1C1C1C
) -> None:
    """A mesh of one colour under a node."""
    red, green, blue = (round(255 * part) for part in shape.color[:3])
    if material is None:
        color = (red << 16) + (green << 8) + blue
        material = meshcat.geometry.MeshPhongMaterial(
            color=color, shininess=30, specular=gloss, side=0
        )
    _set(
        parent[shape.name], _Mesh(shape.name, shape.vertices, shape.normals, shape.faces), material
    )


def _put_ribbon(
    node: meshcat.Visualizer, name: str, ribbon: Ribbon, stage: Stage, color: int
) -> None:
    """A ribbon on the page, in a colour that no lamp changes; the ink of a run in the shades of its force."""
    colors = None
    if name == "ink" and stage.shades is not None:
        colors, color = (
            np.array([rgb(n) for n in range(len(SHADES))])[stage.shades][ribbon.owners],
            0xFFFFFF,
        )
    material = meshcat.geometry.MeshBasicMaterial(color=color, vertexColors=colors is not None)
    _set(node, _Mesh(name, ribbon.vertices, None, ribbon.faces, colors), material)
    node.set_transform(stage.page.X_world_page)


def _set(node: meshcat.Visualizer, mesh: _Mesh, material: Any) -> None:
    """Put a mesh at a node, named by what it is and not by the machine's address."""
    material.uuid = f"{mesh.uuid} material"
    piece = meshcat.geometry.Mesh(mesh, material)
    piece.uuid = f"{mesh.uuid} object"
    node.set_object(piece)


def _clip(track: Track) -> AnimationClip:
    """A clip of one track, its times in seconds."""
    return AnimationClip(tracks={track.name: track}, fps=1)


@lru_cache(maxsize=1)
def robot_bundle() -> bytes:
    """The robot for the browser."""
    return bundle(robot_commands())


@lru_cache(maxsize=1)
def viewer_script() -> bytes:
    """Meshcat's own viewer, as it is installed, compressed."""
    script = resources.files("meshcat").joinpath("viewer/dist/main.min.js").read_bytes()
    return gzip.compress(script, 9, mtime=0)
