"""The studies that the verdicts rest on, each made once for one set of recordings."""

from __future__ import annotations

from concurrent.futures import Executor
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

from dmp_teach.dmp import DMP, Settings
from dmp_teach.errors import RecordingError, SettingError
from dmp_teach.studies.authorship import answers, made, real
from dmp_teach.studies.experiments import (
    d_to_p,
    error_curves,
    goal_change,
    goal_near_start,
    initial_acceleration,
    random_ink,
    redraw,
    star_vs_original,
    stroke_segmentation,
)
from dmp_teach.studies.inputs import (
    RecordingsLike,
    Stroke,
    Written,
    list_letters,
    list_recordings,
    named_strokes,
)
from dmp_teach.trajectory import Trajectory

KEPT_SAMPLES = 4


@dataclass(frozen=True, eq=False)
class Evidence:
    """The evidence that verdicts are computed from; every claim takes recordings, or this.

    Args:
        recordings: Recordings, files or strokes; None takes our own alphabets.
        star: How DMP* is learned in the claims about DMP*; `Settings.star()` unless given.
        original: How the original form is learned; `Settings.original()` unless given.
        executor: Any `concurrent.futures.Executor`.
    """

    recordings: RecordingsLike = None
    star: Settings = field(default_factory=Settings.star)
    original: Settings = field(default_factory=Settings.original)
    executor: Executor | None = None

    @property
    def argument(self) -> str:
        """The argument of the call that computes a claim again."""
        usual = self.star == Settings.star() and self.original == Settings.original()
        return "" if usual and self.recordings is None else "recordings"

    @cached_property
    def letters(self) -> tuple[Written, ...]:
        """Every letter, cut into strokes once.

        Raises:
            RecordingError: A stroke that is not 2-D: these claims are about ink on a page.
        """
        found = list_letters(self.recordings)
        for letter in found:
            for stroke in letter.strokes:
                if stroke.dimensions != 2:
                    raise RecordingError(
                        f"{letter.name} has a stroke of {stroke.dimensions} dimensions, but the "
                        "paper's claims are about ink on a page: give strokes of x and y."
                    )
        return found

    @cached_property
    def open_letters(self) -> tuple[Written, ...]:
        """The letters, or our own where all strokes are closed, which the original form refuses."""
        open_strokes = map(self._can_learn_original, named_strokes(self.letters))
        return self.letters if any(open_strokes) else list_letters()

    @property
    def borrowed(self) -> str:
        """Words that say whether our own letters were taken."""
        if self.open_letters is self.letters:
            return ""
        return "; our own letters, since all strokes end where they began"

    def _can_learn_original(self, stroke: Stroke) -> bool:
        try:
            DMP.imitate(stroke.path, self.original)
        except SettingError:
            return False
        return True

    # Any: the keywords of several studies.
    @property
    def _forms(self) -> dict[str, Any]:
        return {"settings": self.star, "original": self.original, "executor": self.executor}

    @cached_property
    def widths(self) -> error_curves.ErrorCurves:
        """Error against kernel width."""
        return error_curves.sweep_kernel_width(self.letters, executor=self.executor)

    @cached_property
    def numbers(self) -> error_curves.ErrorCurves:
        """Error against the number of kernels."""
        return error_curves.sweep_kernel_number(self.letters, executor=self.executor)

    @cached_property
    def fewer_samples(self) -> error_curves.ErrorCurves:
        """The same with every fourth sample of every stroke that has enough of them."""
        paths = [stroke.path for stroke in named_strokes(self.letters)]
        kept = [
            Trajectory(path.t[::KEPT_SAMPLES], path.position[::KEPT_SAMPLES])
            for path in paths
            if len(path) >= 12 * KEPT_SAMPLES
        ]
        return error_curves.sweep_kernel_number(kept or paths, executor=self.executor)

    @cached_property
    def small_shifts(self) -> goal_change.GoalChanges:
        """Goals moved by 0.01 m in one coordinate."""
        return goal_change.change_goals_1d(self.open_letters, **self._forms)

    @cached_property
    def large_shifts(self) -> goal_change.GoalChanges:
        """Goals moved by 0.1 m in two."""
        return goal_change.change_goals_2d(self.open_letters, **self._forms)

    @cached_property
    def closeness(self) -> goal_near_start.GoalsNearStart:
        """Goals near the start."""
        return goal_near_start.change_goals_near_start(self.open_letters, **self._forms)

    @cached_property
    def first(self) -> initial_acceleration.InitialAcceleration:
        """Initial accelerations."""
        return initial_acceleration.measure_initial_acceleration(
            self.letters, settings=self.star, executor=self.executor
        )

    @cached_property
    def redrawn(self) -> redraw.Redrawings:
        """The letters a, b, e and m drawn again."""
        return redraw.redraw_letters(self.letters, settings=self.star, executor=self.executor)

    @cached_property
    def new_letters(self) -> d_to_p.MadeLetters:
        """Every D made into a P."""
        return d_to_p.make_p_from_d(self.letters, executor=self.executor)

    @cached_property
    def lifts(self) -> stroke_segmentation.Segmentation:
        """Strokes as the paper finds them."""
        return stroke_segmentation.compare_segmentation(
            list_recordings(self.recordings), executor=self.executor
        )

    @cached_property
    def hands(self) -> answers.Attributions:
        """Made letters attributed to their writers."""
        given = None if self.recordings is None else self.letters
        return made.attribute_made_letters(given, executor=self.executor)

    @cached_property
    def real_hands(self) -> answers.Attributions:
        """Real letters attributed to their writers."""
        return real.classify_writers(self.letters, executor=self.executor)

    @cached_property
    def against(self) -> star_vs_original.OriginalComparison:
        """DMP* against the original form."""
        return star_vs_original.compare_with_original(self.open_letters, **self._forms)

    @cached_property
    def shapes(self) -> random_ink.RandomInkErrors:
        """Random ink."""
        return random_ink.learn_random_ink(self.star, executor=self.executor)


def evidence_of(
    recordings: RecordingsLike | Evidence, executor: Executor | None = None
) -> Evidence:
    """Return the evidence from recordings; evidence is returned as it is."""
    evidence = recordings if isinstance(recordings, Evidence) else Evidence(recordings)
    return evidence if executor is None else replace(evidence, executor=executor)
