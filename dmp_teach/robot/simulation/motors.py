"""Motors of the simulated joints: as one wishes them, and as they are."""

from __future__ import annotations

import numpy as np

from dmp_teach.robot.model.reduced import load_reduced_robot
from dmp_teach.robot.motion import Motion
from dmp_teach.robot.simulation.world import World
from dmp_teach.trajectory import Array

# The part of an error in position that an ideal motor makes good in one step.
_GAIN = 0.5
# More than any letter needs [N m, N].
_STRONG = 1e5

_BANDWIDTH = 80.0
"""How quickly a real motor answers to an error [rad/s]."""

_DRY_FRICTION = (0.003, 0.010)
"""Dry friction of a joint: between these parts of its greatest effort."""

_MASS_ERROR = 0.05
"""Every link is heavier or lighter than the controller thinks, by a normal deviate of so much."""

_ENCODER_ERROR = 0.0004
"""Every joint is up to so much away from where its encoder says [rad, m]."""

# Samples for which one mass matrix is good enough.
_EVERY = 24


class IdealMotors:
    """Position motors that know the speed to come and are as strong as they must be."""

    def __init__(self, world: World, motion: Motion) -> None:
        dt = motion.duration / (len(motion.t) - 1)
        self._world = world
        self._targets = motion.q.tolist()
        self._speeds = (np.diff(motion.q, axis=0) / dt).tolist()
        count = len(world.arm)
        self._fixed = {
            "forces": [_STRONG] * count,
            "positionGains": [_GAIN] * count,
            "velocityGains": [1.0] * count,
        }

    def push(self, row: int, q: list[float], v: list[float]) -> None:
        """Set out from sample `row` - 1 to sample `row`."""
        world = self._world
        world.send(
            world.arm,
            world.bullet.POSITION_CONTROL,
            targetPositions=self._targets[row - 1],
            targetVelocities=self._speeds[row - 1],
            **self._fixed,
        )


class RealMotors:
    """Motors with dry friction and limits, and encoders and a model that are a little off.

    The controller is a computed torque, tau = h(q, q', q'') + M (w^2 e + 2 w e') with w =
    `_BANDWIDTH`: h is what the model needs for the plan, M its mass matrix, e what the encoders say
    is missing. All that differs from one robot to the next comes from `rng`.
    """

    def __init__(self, world: World, motion: Motion, rng: np.random.Generator) -> None:
        dt = motion.duration / (len(motion.t) - 1)
        self._world = world
        self._q = motion.q
        self._v = np.gradient(motion.q, dt, axis=0)
        robot = load_reduced_robot(motion.joint_names)
        self._needed = robot.torques(motion.q, self._v, np.gradient(self._v, dt, axis=0))
        self._inertia = robot.inertia(motion.q[::_EVERY])
        self._off = rng.uniform(-_ENCODER_ERROR, _ENCODER_ERROR, len(world.arm))
        self._rub(rng.uniform(*_DRY_FRICTION, len(world.arm)) * world.limits)
        self._weigh(1 + _MASS_ERROR * rng.standard_normal(len(world.links)).clip(-3, 3))

    def push(self, row: int, q: list[float], v: list[float]) -> Array:
        """Set out from sample `row` - 1 to sample `row`; return the efforts (J,) [N m, N]."""
        world = self._world
        now = row - 1
        wrong = self._q[now] - q[: len(world.arm)] - self._off
        pull = _BANDWIDTH**2 * wrong + 2 * _BANDWIDTH * (self._v[now] - v)
        effort = self._needed[now] + self._inertia[now // _EVERY] @ pull
        effort = np.clip(effort, -world.limits, world.limits)
        world.send(world.arm, world.bullet.TORQUE_CONTROL, forces=effort.tolist())
        return effort

    def _rub(self, friction: Array) -> None:
        """Set dry friction (J,) [N m, N]: a weak motor that wants to stand still."""
        for number, force in zip(self._world.arm, friction, strict=True):
            self._world.call(
                "setJointMotorControl2",
                self._world.robot,
                number,
                self._world.bullet.VELOCITY_CONTROL,
                targetVelocity=0.0,
                force=force,
            )

    def _weigh(self, factors: Array) -> None:
        """Set other masses than the model's; the shape of each link stays."""
        for number, factor in zip(self._world.links, factors, strict=True):
            mass, _, inertia, *_ = self._world.call("getDynamicsInfo", self._world.robot, number)
            self._world.call(
                "changeDynamics",
                self._world.robot,
                number,
                mass=mass * factor,
                localInertiaDiagonal=[axis * factor for axis in inertia],
            )
