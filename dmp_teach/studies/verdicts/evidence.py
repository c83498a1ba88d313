"""The studies that the verdicts rest on, each made once for one set of recordings."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import Executor
from dataclasses import dataclass, field, replace
from functools import cached_property, wraps
from typing import Any, Concatenate, ParamSpec, TypeVar, cast

import numpy as np

from dmp_teach.dmp import Settings
from dmp_teach.errors import SettingError, shown
from dmp_teach.studies.authorship import answers, made, real
from dmp_teach.studies.experiments import (
    d_to_p,
    error_curves,
    goal_change,
    goal_near_start,
    initial_acceleration,
    random_ink,
    redraw,
    stroke_segmentation,
)
from dmp_teach.studies.experiments.variants import PAPER_SHARE, Variant
from dmp_teach.studies.inputs import (
    RecordingsLike,
    Stroke,
    Written,
    list_letters,
    list_letters_on_page,
    list_recordings,
    named_strokes,
)
from dmp_teach.studies.parallel import run
from dmp_teach.studies.readings import READINGS, Reading
from dmp_teach.studies.verdicts import single
from dmp_teach.trajectory import Array, Trajectory
from dmp_teach.values import Value

KEPT_SAMPLES = 4
# Fewer than the studies take when they are called alone: what a verdict needs.
JUDGED_WIDTHS = (0.2, 2 / 3, 0.8, 1.0, 1.5, 2.0, 3.0, 4.0, 10.0, 20.0, 40.0, np.inf)
JUDGED_SHARES = (0.02, 0.04, 0.07, 0.1, 0.5)
JUDGED_OFFSETS = (0.005, 0.0005)
JUDGED_RATES = (0.5, 1.0, 2.0, 3.0, 4.0, 6.0)
JUDGED_PIECES = 5
JUDGED_VARIATIONS = 5

P = ParamSpec("P")
R = TypeVar("R")


def _once(
    study: Callable[Concatenate[Evidence, P], R],
) -> Callable[Concatenate[Evidence, P], R]:
    """Make a study of evidence once for the same arguments."""

    @wraps(study)
    def kept(evidence: Evidence, *args: P.args, **kwargs: P.kwargs) -> R:
        key = (study.__name__, *args, *kwargs.values())
        if key not in evidence.kept:
            evidence.kept[key] = study(evidence, *args, **kwargs)
        return cast(R, evidence.kept[key])

    return kept


@dataclass(frozen=True, eq=False, repr=False)
class Evidence(Value):
    """The evidence that verdicts are computed from; every claim takes recordings, or this.

    Args:
        recordings: Recordings, files, folders or strokes; None takes our own alphabets.
        readings: The readings of the paper that claims about DMP* are judged by.
        labels: How letters and writers are read off the names of files, as in `claims`.
        executor: Any `concurrent.futures.Executor`.
    """

    recordings: RecordingsLike = None
    readings: tuple[Reading, ...] = READINGS
    labels: str | None = None
    executor: Executor | None = None
    # Any: what each of the studies finds.
    kept: dict[tuple, Any] = field(default_factory=dict, repr=False, compare=False)

    def __post_init__(self) -> None:
        given = self.readings
        is_list = isinstance(given, tuple | list) and given
        if not is_list or not all(isinstance(each, Reading) for each in given):
            raise SettingError(
                f"readings is {shown(given)}, but must be readings, such as studies.READINGS[:1]."
            )
        super().__post_init__()

    @property
    def argument(self) -> str:
        """The arguments of the call that computes a claim again."""
        usual = self.readings == READINGS and self.recordings is None
        return ("" if usual else "recordings") + ", labels=labels" * (self.labels is not None)

    @cached_property
    def read(self) -> tuple[Any, ...]:
        """What was given, files read.  Any: recordings or strokes."""
        return list_recordings(self.recordings, self.labels)

    @cached_property
    def letters(self) -> tuple[Written, ...]:
        """Every letter, cut into strokes once; the same ink given twice is one letter."""
        found: dict[tuple[bytes, ...], Written] = {}
        for each in list_letters_on_page(self.read):
            found.setdefault(tuple(s.position.tobytes() for s in each.strokes), each)
        return tuple(found.values())

    @cached_property
    def open_letters(self) -> tuple[Written, ...]:
        """The letters, or our own where all strokes are closed, which the original form refuses."""
        return self.letters if any(map(single.has_open_stroke, self.letters)) else list_letters()

    @cached_property
    def open_strokes(self) -> tuple[Stroke, ...]:
        """Their strokes that the original form can learn."""
        return tuple(filter(single.can_learn_original, named_strokes(self.open_letters)))

    @property
    def strokes(self) -> str:
        """What verdicts about all strokes count."""
        return single.tell_strokes(self.letters)

    @cached_property
    def strokes_open(self) -> str:
        """What verdicts about strokes count that the original form can learn."""
        return single.tell_strokes(filter(single.has_open_stroke, self.open_letters))

    @property
    def borrowed(self) -> str:
        """Words that say whether our own letters were taken."""
        if self.open_letters is self.letters:
            return ""
        return "our own letters were taken, since all strokes end where they began"

    def missing(self, letters: str, instead: str) -> str:
        """Return words that name those of the letters that were not recorded, or nothing."""
        there = {each.character for each in self.letters}
        absent = [letter for letter in letters if letter not in there]
        if not absent:
            return ""
        words = f"not recorded: {', '.join(absent)}"
        return words + f", so that {instead}" * (len(absent) == len(letters))

    @cached_property
    def size(self) -> float:
        """The median size of the letters [m]."""
        return float(np.median([letter.size for letter in self.letters]))

    # Any: the keywords of several studies.
    def _forms(self, reading: Reading) -> dict[str, Any]:
        return {
            **{"settings": reading.star, "original": reading.original},
            "executor": self.executor,
        }

    @_once
    def errors(
        self,
        settings: Settings,
        stretch: float = 1.0,
        pace: float = 1.0,
        *,
        share: float = PAPER_SHARE,
    ) -> Array:
        """Return the error of every open stroke as a share of its size, (S,).

        The strokes are drawn `stretch` times as large and `pace` times as fast beforehand, seen by
        the same clock; kernels are a `share` of their samples.
        """
        variant = Variant(settings, share)
        pieces = [(each.path, variant, stretch, pace) for each in self.open_strokes]
        return np.array(run(single.find_error, pieces, self.executor))

    @_once
    def widths(self) -> error_curves.ErrorCurves:
        """Return error against kernel width."""
        return error_curves.sweep_kernel_width(self.letters, JUDGED_WIDTHS, executor=self.executor)

    @_once
    def numbers(self) -> error_curves.ErrorCurves:
        """Return error against the number of kernels."""
        return error_curves.sweep_kernel_number(self.letters, JUDGED_SHARES, executor=self.executor)

    @_once
    def fewer_samples(self) -> error_curves.ErrorCurves:
        """Return the same with every fourth sample of every stroke that has enough of them."""
        paths = [stroke.path for stroke in named_strokes(self.letters)]
        kept = [
            Trajectory(path.t[::KEPT_SAMPLES], path.position[::KEPT_SAMPLES])
            for path in paths
            if len(path) >= 12 * KEPT_SAMPLES
        ]
        return error_curves.sweep_kernel_number(
            kept or paths, JUDGED_SHARES[-2:], executor=self.executor
        )

    @_once
    def shifts(self, reading: Reading, shift: float) -> goal_change.GoalChanges:
        """Return goals moved in one coordinate (0.01 m), or in two (0.1 m)."""
        study = goal_change.change_goals_1d if shift < 0.05 else goal_change.change_goals_2d
        return study(self.open_letters, shift, **self._forms(reading))

    @_once
    def strays(self, original: Settings) -> Array:
        """Return how far each open stroke strays whose goal is its start, shape (S,) [m]."""
        return np.array(
            run(single.find_stray, [(s.path, original) for s in self.open_strokes], self.executor)
        )

    @_once
    def closeness(self, reading: Reading) -> goal_near_start.GoalsNearStart:
        """Return goals near the start."""
        return goal_near_start.change_goals_near_start(
            self.open_letters, ways=JUDGED_OFFSETS, **self._forms(reading)
        )

    @_once
    def first(self, reading: Reading) -> initial_acceleration.InitialAcceleration:
        """Return initial accelerations."""
        return initial_acceleration.measure_initial_acceleration(
            self.letters, settings=reading.star, executor=self.executor
        )

    @_once
    def redrawn(self, reading: Reading) -> redraw.Redrawings:
        """Return the letters a, b, e and m drawn again."""
        return redraw.redraw_letters(self.letters, settings=reading.star, executor=self.executor)

    @_once
    def new_letters(self) -> d_to_p.MadeLetters:
        """Return every D made into a P, by each reading, the original form and similarity."""
        ways = {each.name: each.star for each in self.readings}
        others = {name: form for name, form in d_to_p.goal_transforms().items() if name != "DMP*"}
        return d_to_p.make_p_from_d(self.letters, ways | others, executor=self.executor)

    @_once
    def lifts(self) -> stroke_segmentation.Segmentation:
        """Return strokes as the paper finds them."""
        return stroke_segmentation.compare_segmentation(self.read, executor=self.executor)

    @_once
    def hands(self) -> answers.Attributions:
        """Return made letters attributed to their writers, as each reading led them."""
        given = None if self.recordings is None else self.letters
        led: dict[str, tuple[Settings, str | None]]
        led = {each.name: (each.star, "star") for each in self.readings}
        led["original"] = made.LED_WITH["original"]
        return made.attribute_made_letters(given, JUDGED_VARIATIONS, led, executor=self.executor)

    @_once
    def real_hands(self) -> answers.Attributions:
        """Return real letters attributed to their writers."""
        return real.classify_writers(self.letters, executor=self.executor)

    @_once
    def time_ratio(self, reading: Reading) -> float:
        """Return the time that DMP* takes, as a share of the same with full Gaussians."""
        paths = [each.path for each in self.open_strokes]
        full = replace(
            reading.star,
            kernel_width=np.inf,
            kernel_sigma=0.65,
            kernel_spread=None,
            kernel_sides="both",
        )
        return single.time_ratio(paths, reading.star, full)

    @_once
    def shapes(self, reading: Reading) -> random_ink.RandomInkErrors:
        """Return random ink."""
        return random_ink.learn_random_ink(
            reading.star, JUDGED_RATES, JUDGED_PIECES, executor=self.executor
        )


def evidence_of(
    recordings: RecordingsLike | Evidence,
    executor: Executor | None = None,
    labels: str | None = None,
    readings: tuple[Reading, ...] = READINGS,
) -> Evidence:
    """Return the evidence from recordings; evidence is returned as it is."""
    if isinstance(recordings, Evidence):
        return recordings if executor is None else replace(recordings, executor=executor)
    return Evidence(recordings, readings, labels, executor)
