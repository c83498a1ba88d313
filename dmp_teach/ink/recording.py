"""A recording of handwriting: where the pen was, and when, neither smoothed nor cut."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from numbers import Real
from typing import Self, TypedDict

import numpy as np
from numpy.typing import ArrayLike

from dmp_teach.arguments import as_numbers, checked
from dmp_teach.errors import RecordingError, shown
from dmp_teach.ink.svg_repr import draw_svg
from dmp_teach.segmentation import Spans, cut_at_times, get_rule
from dmp_teach.trajectory import Array, Trajectory
from dmp_teach.values import Value, locked


class About(TypedDict, total=False):
    """What is known of a recording beside its ink."""

    character: str | None
    writer: str | None
    baseline: float | None


@dataclass(frozen=True, eq=False, repr=False)
class Recording(Value):
    """One letter as it was written, in the frame of its page: x right, y up the page, z out of it.

    It carries no name, no date and no time of day: only a pseudonym, and seconds since the take
    began.

    Args:
        t: Times, strictly increasing, shape (T,), T at least 2 [s].
        position: The pen, gap-filled and cropped but never smoothed, shape (T, 3); z is about 0
            while writing [m].
        character: The letter that was meant, such as "a", or None.
        writer: A pseudonym, such as "w01", or None.
        baseline: The y of the line that the letter stands on [m], or None where unknown.
        given_strokes: Where the source knows its strokes: pairs (start, end), a stroke being the
            samples `start:end` (end not included). None: strokes are found from the height.
        pressure: How hard the pen was pressed, as a share of the hardest press that the device
            measures, shape (T,), 0 in the air and at most 1; or None where unknown.
        notes: What is doubtful in it, a sentence each; a file keeps none of them.
        marker: The name of the motion-capture marker that it shows, or None.
        doubtful: Where it is in doubt: pairs (start, end) of samples, which the picture marks.

    Raises:
        RecordingError: Shapes that do not match, values that are not finite, times that do not
            increase, strokes that are not increasing runs of at least 2 samples, or a pressure out
            of its range.
    """

    t: Array
    position: Array
    character: str | None = None
    writer: str | None = None
    baseline: float | None = None
    given_strokes: Spans | None = None
    pressure: Array | None = None
    notes: tuple[str, ...] = ()
    marker: str | None = None
    doubtful: Sequence[tuple[int, int]] = ()

    def __post_init__(self) -> None:
        """Copy, check and lock."""
        try:
            path = Trajectory(self.t, self.position)
        except ValueError as error:
            raise RecordingError(f"A recording needs a clean path. {error}") from None
        if path.dimensions != 3:
            raise RecordingError(
                f"position has shape {path.position.shape}, but must be (T, 3): right, up and "
                "height [m]. Ink from a flat pad has height 0."
            )
        object.__setattr__(self, "t", locked(path.t))
        object.__setattr__(self, "position", locked(path.position))
        if not isinstance(self.character, str | type(None)):
            raise RecordingError(f"character is {shown(self.character)}, but must be text or None.")
        if self.baseline is not None:
            if not isinstance(self.baseline, Real) or not abs(self.baseline) < 1e9:
                raise RecordingError(f"baseline is {shown(self.baseline)}, but must be a y [m].")
            object.__setattr__(self, "baseline", float(self.baseline))
        if self.given_strokes is not None:
            object.__setattr__(self, "given_strokes", _checked(self.given_strokes, len(path)))
        if self.pressure is not None:
            object.__setattr__(self, "pressure", _checked_pressure(self.pressure, len(path)))

    @property
    def duration(self) -> float:
        """Time from the first sample to the last [s]."""
        return float(self.t[-1] - self.t[0])

    @checked
    def strokes(
        self, theta: float = 0.10, sigma: float = 0.006, rule: str = "foot"
    ) -> tuple[Trajectory, ...]:
        """Find the parts that left ink, in the order in which they were written.

        Strokes that the file or the pad gave, or that were cut by hand, are kept as they are,
        whatever theta, sigma and rule say; `with_strokes(None)` gives a recording that has them
        found again.

        Args:
            theta: How fast the pen must rise to leave the paper [m/s].
            sigma: How high it must rise to have left the paper: by the rule "foot" over the foot
                of its own lift, by "authors" over the page, by the other two over the mean height
                of the recording [m].
            rule: "foot" (works), or the paper's: "printed" to the letter, as its words have it
                "meant", and as its "authors" programmed it (`dmp_teach.segmentation.paper_rules`).

        Returns:
            Trajectories in 2-D on this recording's clock: the raw samples, never smoothed.

        Raises:
            SettingError: theta or sigma is not a positive number, or there is no such rule.
            RecordingError: Nothing was written.
        """
        find_by_rule, spans = get_rule(rule), self.given_strokes
        if spans is None:
            spans = find_by_rule(self.t, self.position, theta, sigma)
        return tuple(Trajectory(self.t[a:b], self.position[a:b, :2]) for a, b in spans)

    def with_strokes(self, times: Sequence[tuple[float, float]] | None) -> Self:
        """Return the recording with its strokes cut by hand: so they are learned and kept.

        Args:
            times: The first and the last moment of each stroke on this recording's clock, in
                order, such as `[(0.66, 2.39), (3.67, 8.20)]` [s]; None lets the rule find them
                again.

        Raises:
            RecordingError: Not such pairs, a time outside the recording, or strokes that overlap.
        """
        return replace(self, given_strokes=None if times is None else cut_at_times(self.t, times))

    def __repr__(self) -> str:
        """Return one line, without the numbers."""
        letter = "" if self.character is None else f"{self.character!r}, "
        writer = "" if self.writer is None else f"by {self.writer}, "
        count = len(self.notes)
        notes = f", {count} note{'s' * (count > 1)}" if count else ""
        return f"Recording({letter}{writer}{len(self.t)} samples, {self.duration:.3f} s{notes})"

    def _repr_svg_(self) -> str | None:
        """Draw the strokes as a small picture, for a notebook."""
        try:
            marked = [self.position[max(a - 1, 0) : b + 1, :2] for a, b in self.doubtful]
            about = " ".join([repr(self), *self.notes])
            return draw_svg(self.strokes(), about, True, self.baseline, marked)
        except RecordingError:
            # Nothing was written: the one line of `repr` says more.
            return None


def _checked(spans: Spans, samples: int) -> Spans:
    """Return the strokes as plain integers; a RecordingError names the one that cannot be."""
    try:
        pairs = tuple((int(a), int(b)) for a, b in spans)
    except (OverflowError, TypeError, ValueError):
        raise RecordingError(
            f"given_strokes is {shown(spans)}, but must be pairs (start, end) of whole numbers."
        ) from None
    if not pairs:
        raise RecordingError(
            "given_strokes is empty, but a letter has at least one stroke; use None to find them."
        )
    ends = np.array([0, *(edge for pair in pairs for edge in pair), samples])
    if (np.diff(ends) < 0).any() or min(b - a for a, b in pairs) < 2:
        raise RecordingError(
            f"given_strokes is {pairs}, but strokes must be pairs (start, end) of at least 2 "
            f"samples, one after the other, within {samples} samples."
        )
    return pairs


def _checked_pressure(pressure: ArrayLike, samples: int) -> Array:
    """Return the pressure, locked; a RecordingError names the first value that cannot be."""
    try:
        values = as_numbers(pressure)
    except ValueError:
        values = np.empty(0)
    if values.shape != (samples,):
        raise RecordingError(
            f"pressure must be one number for every sample, shape ({samples},), or None."
        )
    odd = np.flatnonzero(~((values >= 0) & (values <= 1)))
    if len(odd):
        raise RecordingError(
            f"pressure[{odd[0]}] is {values[odd[0]]}, but must be between 0 and 1: a share of the "
            "hardest press."
        )
    return locked(values)
