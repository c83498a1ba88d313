"""The robot's links and joints, and where each link is."""

from __future__ import annotations

import difflib
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cache, cached_property
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike

from dmp_teach.errors import JointError, TrajectoryError
from dmp_teach.files import ASSETS
from dmp_teach.robot.model.urdf import Joint, Visual, read_robot, read_visuals
from dmp_teach.trajectory import Array

# Where the fingers touch the pen's holder [m].
_GRIP = 0.0083
REST = {"r_gripper_finger_joint": _GRIP, "l_gripper_finger_joint": _GRIP}
"""Positions of joints that are not named; all others are at 0 [m]."""


@dataclass(frozen=True, eq=False)
class Model:
    """A robot read from a URDF, standing with its root at the origin of the world.

    Args:
        path: The file that it was read from; meshes are found beside it.
        name: The robot's name.
        links: Names of all links, the root first where the file has it first.
        joints: All joints, fixed ones too, each after the joint that carries its parent.
    """

    path: Path
    name: str
    links: tuple[str, ...]
    joints: tuple[Joint, ...]

    @classmethod
    @cache
    def load(cls, path: str | Path = ASSETS / "fetch.urdf") -> Model:
        """Read a URDF, once: the Fetch with a fixed pen unless another one is named."""
        return cls(Path(path), *read_robot(Path(path)))

    @property
    def joint_names(self) -> tuple[str, ...]:
        """The joints that can move, in the order of the file."""
        return tuple(joint.name for joint in self.joints if joint.type != "fixed")

    @property
    def root(self) -> str:
        """The link that no joint carries."""
        carried = {joint.child for joint in self.joints}
        return next(link for link in self.links if link not in carried)

    def joint(self, name: str) -> Joint:
        """Return a joint by its name.

        Raises:
            JointError: No joint of that name; names the nearest ones.
        """
        found = {joint.name: joint for joint in self.joints}
        if name not in found:
            raise JointError(describe_unknown("joint", name, found))
        return found[name]

    def link_poses(self, q: ArrayLike, joint_names: Sequence[str]) -> dict[str, Array]:
        """Compute where every link is: the product of the joints' poses from the root outwards.

        Args:
            q: Joint positions, shape (T, J), or (J,) for one moment [rad, m].
            joint_names: J names, one a column of q. Of joints that are not named, the fingers hold
                the pen (`REST`) and all others stay at 0.

        Returns:
            X_world_link for each link, each of shape (T, 4, 4), to be read only [m]. Of a link that
            does not move it is one pose, repeated without a copy.

        Raises:
            JointError: A joint that the robot does not have, that cannot move, or that is named
                twice.
            TrajectoryError: q has not one column for each name, or a value that is not finite.
        """
        q = np.atleast_2d(np.asarray(q, dtype=float))
        self._check(q, joint_names)
        columns = dict(zip(joint_names, q.T, strict=True))
        poses = {self.root: np.eye(4)[None]}
        for joint in self.joints:
            X = joint.X_parent_joint
            if joint.name in columns:
                X = joint.pose(columns[joint.name])
            elif joint.name in REST:
                X = joint.pose(np.full(1, REST[joint.name]))
            poses[joint.child] = poses[joint.parent] @ X
        if len(q) == 1:
            return poses
        return {link: np.broadcast_to(X, (len(q), 4, 4)) for link, X in poses.items()}

    def frame(self, name: str, q: ArrayLike, joint_names: Sequence[str]) -> Array:
        """Compute where one link is: `frame("pen_tip", q, names)` has shape (T, 4, 4) [m].

        Raises:
            JointError: No link of that name; names the nearest ones.
        """
        if name not in self.links:
            raise JointError(describe_unknown("frame", name, self.links))
        return self.link_poses(q, joint_names)[name]

    @cached_property
    def visuals(self) -> tuple[Visual, ...]:
        """All pieces of the shell; their files are read when first used."""
        return tuple(read_visuals(self.path))

    def _check(self, q: Array, joint_names: Sequence[str]) -> None:
        """Raise unless q has a finite column for each of some joints that move, named once."""
        if q.ndim != 2 or q.shape[1] != len(joint_names):
            raise TrajectoryError(
                f"q has shape {q.shape}, but needs one column for each of {len(joint_names)} "
                "joints."
            )
        for column, name in enumerate(joint_names):
            if name not in self.joint_names:
                raise JointError(describe_unknown("joint that moves", name, self.joint_names))
            if name in joint_names[:column]:
                raise JointError(
                    f"The joint {name!r} is named twice; each column of q needs a joint of its own."
                )
        if not np.isfinite(q).all():
            row, column = np.argwhere(~np.isfinite(q))[0]
            raise TrajectoryError(
                f"q[{row}] of {joint_names[column]} is {q[row, column]}, but must be finite."
            )


def describe_unknown(kind: str, name: str, known: Iterable[str]) -> str:
    """Return a sentence that says which names come nearest."""
    known = list(known)
    near = difflib.get_close_matches(name, known, n=3, cutoff=0.3) or known[:3]
    return (
        f"The robot has no {kind} called {name!r}. The nearest names: {', '.join(map(repr, near))}."
    )
