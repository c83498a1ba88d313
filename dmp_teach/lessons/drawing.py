"""What several lessons draw: a letter on its sheet, bumps over time, errors and their words."""

from __future__ import annotations

import math
import warnings
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from dmp_teach import classroom as kit
from dmp_teach.classroom import Affine, Drawing, tell_number
from dmp_teach.dmp import DMP, Settings
from dmp_teach.errors import SettingWarning
from dmp_teach.ink import DEFAULT_ALPHABET, Recording, recording_of
from dmp_teach.letters import Letter, rms_distance
from dmp_teach.texts import gettext as _
from dmp_teach.trajectory import Array, Trajectory, resample_in_time

# So many points draw one bump.
BUMP_POINTS = 24
GOAL_KNOBS = "goal_x", "goal_y"


def millimetres(metres: float, limit: float = math.inf) -> str:
    """Return a length as it is shown, beside a limit [mm]: "0.37", "3.6", "24"."""
    mm = 1000 * metres
    return tell_number(mm, limit, 2 if mm < 0.995 else 1 if mm < 9.95 else 0)


def lesson_letter(character: str, alphabet: str | None = None) -> Recording:
    """Return a letter of an alphabet as lessons can take it: with our strokes.

    Lessons name strokes, such as the bar of a D. A school's own letter is taken where it is one
    stroke, as ours is; else ours.
    """
    own, ours = (recording_of(character, each) for each in (alphabet, DEFAULT_ALPHABET))
    return own if len(own.strokes()) == len(ours.strokes()) == 1 else ours


@lru_cache(maxsize=2048)
def learn_letter(character: str, settings: Settings, rate: int | None = None) -> Letter:
    """Learn a letter of our alphabet; what its settings warn of, the lesson says itself.

    With a rate it is first sampled so often a second.
    """
    strokes = lesson_letter(character).strokes()
    if rate is not None:
        strokes = tuple(
            resample_in_time(stroke, round(stroke.duration * rate) + 1) for stroke in strokes
        )
    with warnings.catch_warnings(action="ignore", category=SettingWarning):
        return Letter.learn(strokes, settings)


# A slider asks for all of a curve at every move.
@lru_cache(maxsize=2048)
def error_of(letter: Letter) -> float:
    """Return how far the robot's letter is off the person's, on average [m]."""
    return rms_distance(letter.write(), letter.strokes)


def paths_of(strokes: Iterable[Trajectory]) -> list[Array]:
    """Return the points of strokes, each shape (N, 2) [m]."""
    return [stroke.position for stroke in strokes]


def draw_sheet(
    demonstration: Sequence[Trajectory], robot: Sequence[object], **more: object
) -> Drawing:
    """Return a sheet with a person's letter and the robot's lines over it."""
    paths = paths_of(demonstration)
    title = _("The person’s letter, and the robot’s over it.")
    sheet = {"box": sheet_box(paths), "title": title, "caption": _("On paper"), "demo": paths}
    return sheet | {"robot": list(robot)} | more


def sheet_box(paths: Sequence[Array]) -> list[float]:
    """Return what a sheet shows around paths, each shape (N, 2): left, bottom, right, top [m]."""
    points = np.concatenate(paths)
    margin = 0.12 * np.ptp(points, axis=0).max()
    return [*(points.min(axis=0) - margin), *(points.max(axis=0) + margin)]


def line(points: object, kind: str, label: str = "") -> Drawing:
    """Return a line of a plot: points are an array (N, 2), an `Affine` or a `Pick`."""
    return {"points": points, "kind": kind, "label": label}


def mark(at: object, kind: str, label: str = "") -> Drawing:
    """Return a dot at a place."""
    return {"at": at, "kind": kind, "label": label}


def axis(low: float, high: float, label: str = "", **more: object) -> Drawing:
    """Return an axis; more: `ticks`, [value, word] each, and `log`."""
    return {"low": float(low), "high": float(high), "label": label, **more}


def plot(caption: str, x: Drawing, y: Drawing, note: str = "", **marks: object) -> Drawing:
    """Return a plot; marks: its lines, dots, fills, bands and thresholds."""
    return {"caption": caption, "note": note, "x": x, "y": y, **marks}


def goal_slider(
    label: str, low: float, high: float, *, term: str = "g", **more: bool
) -> kit.Slider:
    """Return a slider of a goal [cm], whose letter the browser draws."""
    here = {"unit": "cm", "digits": 1, "is_drawn_here": True}
    return kit.Slider(label, term, low, high, 0.1, **here, **more)  # type: ignore[arg-type]


def goal_ring(goal: Array, is_fixed: bool) -> Drawing:
    """Return the ring of a goal (2,) [m] that two knobs move [cm], unless it is fixed."""
    axes = dict(zip(GOAL_KNOBS, 0.01 * np.eye(2)[:, None], strict=True))
    ring = {"home": goal.tolist(), "at": Affine(goal[None], axes), "label": _("goal")}
    return ring | {"scale": 0.01, "knobs": [] if is_fixed else list(GOAL_KNOBS)}


def bumps_over_time(primitive: DMP) -> list[Array]:
    """Return the outline of each bump over time, in order of time, each shape (P, 2) [s, 1].

    A bump is drawn only where it is awake.
    """
    kernels, duration = primitive.kernels, primitive.duration
    t = np.linspace(0, 1, max(1000, BUMP_POINTS * kernels.number))
    heights = kernels.heights(kernels.phase.at(1 - t))
    outlines = []
    for height in heights.T[::-1]:
        awake = np.flatnonzero(height > 0.004)
        if len(awake):
            span = np.unique(np.linspace(awake[0], awake[-1], BUMP_POINTS).astype(int))
            path = np.column_stack([t[span] * duration, height[span]])
            ends = np.array([[path[0, 0], 0.0], [path[-1, 0], 0.0]])
            outlines.append(np.vstack([ends[:1], path, ends[1:]]))
    return outlines


def draw_bumps(letter: Letter) -> Drawing:
    """Draw the bumps of the longest stroke of a letter over time."""
    primitive = max(letter.primitives, key=lambda each: each.duration)
    bumps = bumps_over_time(primitive)
    return plot(
        _("The bumps in time [s]"),
        axis(0, primitive.duration),
        axis(0, 1.15, ticks=[]),
        _("{n} bumps").format(n=len(bumps)),
        fills=[{"points": each} for each in bumps],
    )


@dataclass(frozen=True)
class ErrorCurve:
    """How far off a letter is over one knob: it is bet on, and then drawn.

    Args:
        knob: The name of the knob.
        error_at: Returns the error [mm] with these values.
        x: The axis of the knob.
        places: Where the truth is drawn.
    """

    knob: str
    error_at: Callable[[kit.Answer], float]
    x: Drawing
    places: Sequence[float]

    def draw(self, state: kit.LessonState) -> Drawing:
        """Draw the errors that were tried, or all; a dot at what is set."""
        values, is_all = state.values, state.is_revealed
        alike = (each for each in state.tried if each | {self.knob: 0} == values | {self.knob: 0})
        places = self.places if is_all else sorted({each[self.knob] for each in alike})
        points = np.array([[x, self.error_at(values | {self.knob: x})] for x in places])
        shown = line(points, *(("truth", _("the robot")) if is_all else ("quiet",)))
        note = _("your bet, and the truth") if is_all else _("what you tried")
        lines = [shown] if len(points) > 1 else []
        now = mark([float(values[self.knob]), self.error_at(values)], "robot")
        return plot(_("How far off"), self.x, error_axis(), note, lines=lines, dots=[now])

    def rank(self, bet: kit.KeptBet, values: kit.Answer) -> list[tuple[float, str, str]]:
        """Return each place of a bet, what was said and what is so [mm], the nearest first."""
        told = [(x, said, self.error_at(values | {self.knob: x})) for x, said in bet]
        told.sort(key=lambda each: abs(math.log(each[1] / each[2])))
        return [(x, *map(millimetres, (said / 1000, true / 1000))) for x, said, true in told]


def bet_on_errors(
    question: str, places: Iterable[float], height: float, label: str
) -> kit.DrawnBet:
    """Return a bet on errors [mm] over a setting, which a label names."""
    handles = np.array([[each, height] for each in places])
    return kit.DrawnBet(question, "curve", handles, label, "y", 0.1, "mm", 0.1, 100.0)


def error_axis() -> Drawing:
    """Return the axis of errors, with a thing of each size [mm]."""
    words = {0.1: _("a hair"), 1.0: _("a pen line"), 10.0: _("a finger"), 100.0: _("a hand")}
    ticks = [[value, f"{value:g} mm {word}"] for value, word in words.items()]
    return axis(0.1, 100, log=True, ticks=ticks)
