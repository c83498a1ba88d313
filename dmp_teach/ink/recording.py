"""What a person wrote: where the pen was, and when, before anybody smooths or cuts it."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from dmp_teach.errors import RecordingError
from dmp_teach.ink.strokes import find_strokes
from dmp_teach.trajectory import Array, Trajectory, locked


@dataclass(frozen=True, eq=False)
class Recording:
    """One letter as it was written, in the frame of its page: x to the right, y up the page, z out of it.

    It carries no name, no date and no time of day: only a pseudonym, and seconds since the take began.

    Args:
        t: Times, strictly increasing, shape (T,), T at least 2 [s].
        position: The pen, gap-filled and cropped but never smoothed, shape (T, 3); z is about 0 while writing [m].
        character: The letter that was meant, such as "a", or None.
        writer: A pseudonym, such as "w01", or None.
        baseline: The y of the line that the letter stands on [m], or None where nobody knows.
        given_strokes: Where the source knows its strokes: pairs (start, end), a stroke being the
            samples `start:end` (end not included). None: strokes are found from the height.
        pressure: How hard the pen was pressed, as a share of the hardest press that the device can tell, shape (T,),
            0 in the air and at most 1; or None where nobody knows.

    Raises:
        RecordingError: Shapes that do not match, values that are not finite, times that do not
            increase, strokes that are not increasing runs of at least 2 samples, or a pressure out of its range.
    """

    t: Array
    position: Array
    character: str | None = None
    writer: str | None = None
    baseline: float | None = None
    given_strokes: tuple[tuple[int, int], ...] | None = None
    pressure: Array | None = None

    def __post_init__(self) -> None:
        """Copy, check and lock."""
        try:
            path = Trajectory(self.t, self.position)
        except ValueError as error:
            raise RecordingError(f"A recording needs a clean path. {error}") from None
        if path.dimensions != 3:
            raise RecordingError(
                f"position has shape {path.position.shape}, but must be (T, 3): right, up and height [m]. "
                "Ink from a flat pad has height 0."
            )
        object.__setattr__(self, "t", locked(path.t))
        object.__setattr__(self, "position", locked(path.position))
        if self.baseline is not None:
            object.__setattr__(self, "baseline", float(self.baseline))
        if self.given_strokes is not None:
            object.__setattr__(self, "given_strokes", _checked(self.given_strokes, len(path)))
        if self.pressure is not None:
            object.__setattr__(self, "pressure", _checked_pressure(self.pressure, len(path)))

    @property
    def duration(self) -> float:
        """From the first sample to the last [s]."""
        return float(self.t[-1] - self.t[0])

    def strokes(self, theta: float = 0.10, sigma: float = 0.006) -> tuple[Trajectory, ...]:
        """The parts that left ink, in the order in which they were written.

        Strokes that the file or the pad gave are kept as they are, whatever theta and sigma say.

        Args:
            theta: How fast the pen must rise to leave the paper [m/s].
            sigma: How high it must rise over the foot of its own lift to have left the paper [m].

        Returns:
            2-D trajectories on this recording's clock: the raw samples, never smoothed.

        Raises:
            SettingError: theta or sigma is not a positive number.
            RecordingError: Nothing was written.
        """
        spans = self.given_strokes
        if spans is None:
            spans = find_strokes(self.t, self.position, theta, sigma)
        return tuple(Trajectory(self.t[a:b], self.position[a:b, :2]) for a, b in spans)

    def __repr__(self) -> str:
        """In one line, without the numbers."""
        letter = "" if self.character is None else f"{self.character!r}, "
        writer = "" if self.writer is None else f"by {self.writer}, "
        return f"Recording({letter}{writer}{len(self.t)} samples, {self.duration:.3f} s)"


def _checked(spans: tuple[tuple[int, int], ...], samples: int) -> tuple[tuple[int, int], ...]:
    """The strokes as plain integers, or an error that names the one that cannot be."""
    pairs = tuple((int(a), int(b)) for a, b in spans)
    if not pairs:
        raise RecordingError("given_strokes is empty, but a letter has at least one stroke; use None to find them.")
    ends = np.array([0, *(edge for pair in pairs for edge in pair), samples])
    if (np.diff(ends) < 0).any() or min(b - a for a, b in pairs) < 2:
        raise RecordingError(
            f"given_strokes is {pairs}, but strokes must be pairs (start, end) of at least 2 samples, "
            f"one after the other, within {samples} samples."
        )
    return pairs


def _checked_pressure(pressure: ArrayLike, samples: int) -> Array:
    """The pressure as a locked array, or an error that names the first value that cannot be."""
    try:
        values = np.asarray(pressure, dtype=float)
    except (TypeError, ValueError, OverflowError):
        values = np.empty(0)
    if values.shape != (samples,):
        raise RecordingError(f"pressure must be one number for every sample, shape ({samples},), or None.")
    odd = np.flatnonzero(~((values >= 0) & (values <= 1)))
    if len(odd):
        raise RecordingError(
            f"pressure[{odd[0]}] is {values[odd[0]]}, but must be between 0 and 1: a share of the hardest press."
        )
    return locked(values)
