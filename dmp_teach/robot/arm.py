"""The arm in PlaCo's hands: joints that put the pen where it should be. Nothing else of this house knows of PlaCo."""

from __future__ import annotations

import threading
from collections.abc import Callable, Sequence
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from dmp_teach.errors import MissingPartError
from dmp_teach.files import ASSETS
from dmp_teach.robot.model.kinematics import REST, Model
from dmp_teach.robot.model.solids import bare_urdf
from dmp_teach.robot.pen_path import RATE
from dmp_teach.robot.quiet import quiet
from dmp_teach.trajectory import Array

JOINTS = (
    "torso_lift_joint",
    "shoulder_pan_joint",
    "shoulder_lift_joint",
    "upperarm_roll_joint",
    "elbow_flex_joint",
    "forearm_roll_joint",
    "wrist_flex_joint",
    "wrist_roll_joint",
)
"""The joints that write; all others stand still."""

KEEP = 0.0075
"""Where the arm is judged by its posture, all solids are thought to be so much larger on every side [m]."""

_here = threading.local()


class Solver:
    """PlaCo's robot and its solver in one hand: the solver does not keep its robot alive.

    Every method starts from what it is given, never from what was done before.
    """

    def __init__(self) -> None:
        placo = _placo()
        self.model = Model.load()
        joints = [self.model.joint(name) for name in JOINTS]
        self.lower, self.upper = np.array([(joint.lower, joint.upper) for joint in joints]).T
        self.fastest = np.array([joint.velocity for joint in joints])
        with quiet():
            self._robot = placo.RobotWrapper("", 0, bare_urdf(KEEP))
        self._solver = solver = self._robot.make_solver()
        self.state_size = len(self._robot.state.q)
        self.columns = {name: self._robot.get_joint_offset(name) for name in JOINTS}
        self._speeds = [self._robot.get_joint_v_offset(name) for name in JOINTS]
        solver.dt = 1 / RATE
        solver.mask_fbase(True)  # otherwise the robot flies to the page
        for name in self.model.joint_names:
            if name not in JOINTS:
                self.mask(name)
        solver.enable_joint_limits(True)
        self._tip = solver.add_position_task("pen_tip", np.zeros(3))
        self._axis = solver.add_axisalign_task(
            "pen_tip", np.array([0.0, 0.0, 1.0]), np.array([0.0, 0.0, -1.0])
        )
        self._posture = solver.add_joints_task()
        solver.add_regularization_task(1e-4)
        self.verdicts: dict[Any, Any] = {}

    def mask(self, name: str, masked: bool = True) -> None:
        """Hold a joint still, or let it go.

        Raises:
            JointError: No such joint; PlaCo takes any name, in silence or with a crash.
        """
        (self._solver.mask_dof if masked else self._solver.unmask_dof)(self.model.joint(name).name)

    def stand(self, q: ArrayLike, normal: Array, torso: bool, upright: float = 0.1) -> None:
        """Take a posture and like it.

        Args:
            q: Joint positions, shape (J,) [rad, m].
            normal: Out of the paper, shape (3,); the pen looks the other way, turned by 1e-9 rad
                because PlaCo knows no way from an axis to its exact opposite.
            torso: Whether the torso may move.
            upright: How much the pen's axis weighs against 1 m of its tip.
        """
        self._robot.reset()
        for name, value in zip(JOINTS, q, strict=True):
            self._robot.set_joint(self.model.joint(name).name, float(value))
        self._robot.update_kinematics()
        self.mask("torso_lift_joint", not torso)
        self._solver.dt = 1 / RATE
        self._solver.enable_velocity_limits(False)
        self._axis.targetAxis_world = -normal + 1e-9 * np.array([normal[1], normal[2], normal[0]])
        self._tip.configure("tip", "soft", 1.0)
        self._axis.configure("axis", "soft", upright)
        self._posture.set_joints(
            {name: float(value) for name, value in zip(JOINTS, q, strict=True)}
        )
        self._posture.configure("posture", "soft", 1e-6)

    def go(self, target: Array, steps: int) -> None:
        """Take some steps to a place in the world (3,) [m]."""
        self._tip.target_world = target
        for _ in range(steps):
            self._solver.solve(True)
            self._robot.update_kinematics()

    def approach(self, target: Array, finer: Sequence[float] = (0.1,)) -> None:
        """Go to a place (3,) [m], or as near as the arm gets, in steps that cannot run away.

        Far from its target a full step of the solver throws the arm about. Speed limits bound the step:
        by what a joint does in 0.1 s, then in each finer time.
        """
        self._solver.enable_velocity_limits(True)
        for self._solver.dt in finer:
            self.go(target, 50)
        self._solver.dt = 1 / RATE
        self._solver.enable_velocity_limits(False)

    def glide(self, target: Array) -> None:
        """Go straight to a place (3,) [m], 2 cm at a time."""
        start = self.pen()[:3, 3]
        steps = int(np.ceil(np.linalg.norm(target - start) / 0.02)) + 1
        for part in np.arange(1, steps + 1) / steps:
            self.go(start + part * (target - start), 3)
        self.go(target, 10)

    def settle(self, target: Array) -> None:
        """Wait at a place (3,) [m] until the posture has come to rest.

        A posture that weighs more than a tenth of the regularisation never does: it goes round in circles of 3 mm.
        """
        self._posture.configure("posture", "soft", 1e-5)
        self.go(target, 120)
        self._posture.configure("posture", "soft", 1e-6)
        self.go(target, 20)

    def joints(self) -> Array:
        """Where the joints are, shape (J,) [rad, m]."""
        return np.array([self._robot.get_joint(name) for name in JOINTS])

    def pen(self) -> Array:
        """Pose of the pen's tip in the world, shape (4, 4) [m]."""
        return self._robot.get_T_world_frame("pen_tip")

    def base(self) -> Array:
        """Pose of the robot's base in the world, shape (4, 4) [m]: always the identity."""
        return self._robot.get_T_world_fbase()

    def place_of(self, link: str) -> Array:
        """Where a link's origin is in the world, shape (3,) [m]."""
        return self._robot.get_T_world_frame(link)[:3, 3]

    def touching(self) -> set[tuple[str, str]]:
        """Pairs of links whose solids are less than twice `KEEP` apart."""
        return {
            (hit.bodyA.rpartition("_")[0], hit.bodyB.rpartition("_")[0])
            for hit in self._robot.self_collisions(False)
        }

    def jacobian(self) -> Array:
        """Velocity and turning of the pen's tip in the world for each joint's speed, shape (6, J)."""
        return self._robot.frame_jacobian("pen_tip", "local_world_aligned")[:, self._speeds]

    def speeds(self, q: Array) -> Array:
        """Of the joints from each sample of a motion (T, J) to the next, as parts of their limits, (T - 1, J)."""
        return np.abs(np.diff(q, axis=0)) * RATE / self.fastest

    def follow(
        self,
        q: ArrayLike,
        normal: Array,
        path: Array,
        report: Callable[[str, float], Any],
        solves: int = 1,
    ) -> Array:
        """The joints along a path.

        Args:
            q: Where the arm stands before, shape (J,) [rad, m]; the torso stays as it is.
            normal: Out of the paper, shape (3,).
            path: In the world, shape (T, 3) [m].
            report: Told "joints" and how much is done.
            solves: So many solutions and updates for every sample.

        Returns:
            Joint positions, unwrapped, shape (T, J) [rad, m].
        """
        self.stand(q, normal, torso=False)
        self.glide(path[0])
        self.settle(path[0])
        states = np.empty((len(path), self.state_size))
        tip, robot, solve, update = (
            self._tip,
            self._robot,
            self._solver.solve,
            self._robot.update_kinematics,
        )
        for row, target in enumerate(path):
            if row % 60 == 0:
                report("joints", row / len(path))
            tip.target_world = target
            for _ in range(solves):
                solve(True)
                update()
            states[row] = robot.state.q
        report("joints", 1.0)
        return self.unpacked(states)

    def unpacked(self, states: Array) -> Array:
        """PlaCo's states (T, n) as joint positions (T, J).

        A joint that turns for ever is held as the cosine and sine of its angle; here it does not jump at half a turn.
        """
        q = states[:, list(self.columns.values())]
        for number, (name, column) in enumerate(self.columns.items()):
            if self._robot.get_joint_size(name) == 2:
                q[:, number] = np.unwrap(np.arctan2(states[:, column + 1], states[:, column]))
        return q


def solver_here() -> Solver:
    """The solver of this thread: PlaCo's are not safe to share, and each one that is made leaks 0.35 MB."""
    if not hasattr(_here, "solver"):
        _here.solver = Solver()
    return _here.solver


def torques(q: Array, v: Array, a: Array, joint_names: Sequence[str]) -> Array:
    """What the joints' motors must give for a movement, without friction and with the pen in the air.

    M(q) a + C(q, v) v + g(q), by the recursive Newton-Euler algorithm (Featherstone 2008, table 5.1) of pinocchio, from
    the masses and inertias of all links, the pen's among them.

    Args:
        q: Positions, shape (T, J) [rad, m].
        v: Velocities, shape (T, J) [rad/s, m/s].
        a: Accelerations, shape (T, J) [rad/s^2, m/s^2].
        joint_names: J names; with `pen_slide_joint` the pen is the sprung one. All other joints stand still.

    Returns:
        Torques and forces, shape (T, J) [N m, N].

    Raises:
        JointError: A joint that the robot does not have.
        MissingPartError: PlaCo, which brings pinocchio, is not on this platform.
    """
    _placo()
    import pinocchio  # noqa: PLC0415

    model, columns = _masses(tuple(joint_names))
    states = np.zeros((len(q), model.nq))
    for angle, (at, _, size) in zip(q.T, columns, strict=True):
        states[:, at : at + size] = (
            angle[:, None] if size == 1 else np.column_stack([np.cos(angle), np.sin(angle)])
        )
    order = [at for _, at, _ in columns]
    data, needed, speeds, pushes = (
        model.createData(),
        np.empty_like(v),
        np.empty_like(v),
        np.empty_like(v),
    )
    speeds[:, order], pushes[:, order] = v, a
    for row in range(len(states)):
        needed[row] = pinocchio.rnea(model, data, states[row], speeds[row], pushes[row])
    return needed[:, order]


@lru_cache(maxsize=4)
def _masses(joint_names: tuple[str, ...]) -> tuple[Any, list[tuple[int, int, int]]]:
    """Pinocchio's model that moves only in some joints, and where each is in its positions and velocities, and size."""
    import pinocchio  # noqa: PLC0415

    path = ASSETS / ("fetch_sprung.urdf" if "pen_slide_joint" in joint_names else "fetch.urdf")
    ours = Model.load(path)
    for name in joint_names:
        ours.joint(name)
    full = pinocchio.buildModelFromUrdf(str(path))
    rest = pinocchio.neutral(full)
    for name, value in REST.items():
        rest[full.joints[full.getJointId(name)].idx_q] = value
    still = [number for number, name in enumerate(full.names) if number and name not in joint_names]
    model = pinocchio.buildReducedModel(full, still, rest)
    joints = [model.joints[model.getJointId(name)] for name in joint_names]
    return model, [(joint.idx_q, joint.idx_v, joint.nq) for joint in joints]


def _placo() -> Any:
    """PlaCo itself."""
    try:
        import placo  # noqa: PLC0415 (loaded when a robot is needed, not before)
    except (ImportError, OSError) as error:
        raise MissingPartError(
            f"The robot's joints are solved by PlaCo, which is not here ({error}). Letters, sliders and plots work "
            "without it. On Linux and macOS: python3 -m pip install placo; on Windows use WSL, or a notebook hub."
        ) from None
    return placo
