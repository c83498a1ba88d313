"""A motion that needs no PlaCo: the resting arm, swayed; two strokes with a lift between them."""

import gzip
import struct
from dataclasses import replace

import numpy as np

from dmp_teach.robot.arm import JOINTS
from dmp_teach.robot.model.kinematics import Model
from dmp_teach.robot.motion import Motion
from dmp_teach.robot.page import Page
from dmp_teach.robot.reach.posture import START_POSTURES
from dmp_teach.robot.simulation.run import Run
from dmp_teach.robot.simulation.world import PENS, SLIDE_JOINT
from dmp_teach.trajectory import Trajectory


def sway(seconds=2.4, rate=240, size=0.06, page=None):
    """Every joint on a sine of its own; the pen is down for two thirds of the time."""
    count = round(seconds * rate) + 1
    t = np.arange(count) / rate
    rest = START_POSTURES[0] - (0.1, 0, 0, 0, 0, 0, 0, 0)
    speeds = 2 * np.pi * np.linspace(0.4, 1.1, len(rest))
    q = rest + size * np.sin(np.outer(t, speeds)) * (0.2, 1, 1, 1, 1, 1, 1, 1)
    tip = Model.load().frame("pen_tip", q, JOINTS)[:, :3, 3]
    if page is None:
        middle = (tip.min(axis=0) + tip.max(axis=0)) / 2
        page = Page.table(*middle, width=0.4, height=0.4)
    part = t / seconds
    down = ((part > 0.1) & (part < 0.45)) | ((part > 0.55) & (part < 0.9))
    on_page = page.to_page(tip)[:, :2]
    halves = (down & (part < 0.5), down & (part > 0.5))
    strokes = tuple(Trajectory(t[half], on_page[half]) for half in halves)
    return Motion(
        t,
        q,
        JOINTS,
        tip,
        tip,
        down,
        page,
        strokes,
        ("Slowed from 2.2 s to 2.4 s: elbow_flex_joint.",),
    )


def pressed(motion):
    """What a motion might become: the pen pushed in by 4 mm wherever it writes."""
    slide = np.where(motion.pen_down, -0.004, 0.0)
    q, names = np.column_stack([motion.q, slide]), (*motion.joint_names, SLIDE_JOINT)
    tip = Model.load(PENS["sprung"]).frame("pen_tip", q, names)[:, :3, 3]
    happened = replace(motion, q=q, joint_names=names, tip=tip)
    force = np.where(motion.pen_down, 0.6 + 0.9 * np.sin(3 * motion.t) ** 3, 0.0).clip(0.0)
    contact = force > 0.03
    edges = np.flatnonzero(
        np.diff(np.concatenate([[False], contact, [False]]).astype(int))
    ).reshape(-1, 2)
    nib = motion.page.to_page(tip)
    ink = [Trajectory(motion.t[a:b], nib[a:b, :2]) for a, b in edges if b - a > 1]
    effort = np.zeros_like(motion.q)
    limits = np.ones(motion.q.shape[1])
    return Run(happened, motion, ink, nib, force, contact, effort, limits)


def unpack_commands(data):
    """The commands that the browser takes out of a compressed piece."""
    plain, start, commands = gzip.decompress(data), 0, []
    while start < len(plain):
        (length,) = struct.unpack_from("<I", plain, start)
        commands.append(plain[start + 4 : start + 4 + length])
        start += 4 + length
    return tuple(commands)
