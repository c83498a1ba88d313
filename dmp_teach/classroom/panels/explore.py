"""The start panel: a person's letter, the robot's copy, sliders, and a robot that writes it."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, Unpack
from unicodedata import normalize

import numpy as np
import traitlets

from dmp_teach.arguments import checked
from dmp_teach.classroom.panels import messages
from dmp_teach.classroom.panels.panel_page import PanelPage
from dmp_teach.classroom.panels.robot_panel import RobotPanel, list_letter_choices, pack_points
from dmp_teach.classroom.panels.sheets import fit_goal_sheet
from dmp_teach.classroom.panels.still import Still
from dmp_teach.dmp import SettingChanges, Settings, knob_of
from dmp_teach.errors import RecordingError, SettingError, SettingWarning
from dmp_teach.files import join_modules, join_styles
from dmp_teach.ink import Recording, characters, recording_of
from dmp_teach.letters import Letter, rms_distance
from dmp_teach.robot import Page
from dmp_teach.texts import gettext as _
from dmp_teach.trajectory import Trajectory
from dmp_teach.views import STYLE_TOKENS

_HERE = Path(__file__).parent
# The letters of the paper's figures, and two that D becomes.
NEAR_LETTERS = "abemBDMPR"
OWN_RECORDING = "own recording"
MAX_KERNELS = 80
EXPLORE_PARTS = ("letters", "sheet", "goal", "n_kernels", "kernel_width", "robot")
_START = SettingChanges(n_kernels=12, kernel_width=2.0)


@checked
def explore(
    recording: Recording | str | Path | None = None,
    page: Page | None = None,
    show: Sequence[str] = EXPLORE_PARTS,
    **settings: Unpack[SettingChanges],
) -> Explore:
    """Show a live panel: change a letter with sliders and goals, then let the robot write it.

        panel = teach.explore("e", show=("sheet", "n_kernels"), n_kernels=5, kernel_width=1.0)

    Args:
        recording: What to begin with: a letter of our alphabet such as "e", a recording, or the
            path of one; None begins with our "a".
        page: Where the robot writes; None for a sheet of A4 on the table.
        show: Which parts are seen: "letters", "sheet", "goal", "n_kernels", "kernel_width",
            "robot".
        settings: Of the primitive, as in `Settings.star`; the sliders begin there.

    Raises:
        RecordingError: The recording cannot be read.
        SettingError: There is no such part or setting, or a value is out of its range.
    """
    return Explore(recording, page, show, settings)


class Explore(RobotPanel, PanelPage):
    """The start panel.

    Its knobs are traits: `n_kernels`, `kernel_width` [1/N], `stroke`, `goal_x` and `goal_y` [m].
    For checks there are `recording`, `learned`, `error` [m] and `answer`.
    """

    _esm = join_modules(_HERE / "explore.js")
    _css = join_styles(STYLE_TOKENS, *(_HERE / sheet for sheet in ("panel.css", "paper.css")))
    _open = (
        *("asked", "letter", "n_kernels", "kernel_width", "stroke"),
        *("goal_shifts", "goal_x", "goal_y"),
    )
    _page_script = _HERE / "explore_page.js"
    _page_traits = (
        *("shown", "near", "choices", "letter", "knobs", "n_kernels", "most_kernels"),
        *("kernel_width", "stroke", "goal_shifts", "drawn_shifts", "goal_terms", "demo", "robot"),
        *("sheet", "counts", "message", "title", "still", "files", "texts"),
    )

    shown = traitlets.List(list(EXPLORE_PARTS)).tag(sync=True)
    near = traitlets.List(list(NEAR_LETTERS)).tag(sync=True)
    letter = traitlets.Unicode().tag(sync=True)
    knobs = traitlets.Dict().tag(sync=True)
    n_kernels = traitlets.Int(12).tag(sync=True)
    most_kernels = traitlets.Int(MAX_KERNELS).tag(sync=True)
    kernel_width = traitlets.Float(2.0).tag(sync=True)
    stroke = traitlets.Int(0).tag(sync=True)
    goal_shifts: traitlets.List[list[float]] = traitlets.List().tag(sync=True)
    goal_x = traitlets.Float(0.0).tag(sync=True)
    goal_y = traitlets.Float(0.0).tag(sync=True)
    demo = traitlets.Bytes().tag(sync=True)
    # For the browser, which moves a goal alone while it is in a hand: the shifts that `robot` was
    # drawn with, and how it moves with each coordinate of its goals, packed float64 (x, y).
    drawn_shifts: traitlets.List[list[float]] = traitlets.List().tag(sync=True)
    goal_terms: traitlets.Dict[str, bytes] = traitlets.Dict().tag(sync=True)
    asked = traitlets.Int(0).tag(sync=True)

    def __init__(
        self,
        recording: Recording | str | Path | None = None,
        page: Page | None = None,
        show: Sequence[str] = EXPLORE_PARTS,
        settings: SettingChanges = _START,
    ):
        knobs = {name: _describe_knob(name) for name in ("n_kernels", "kernel_width")}
        self._settings = Settings.star(**_START | settings)
        start = {name: _check_slider(name, getattr(self._settings, name)) for name in knobs}
        self._demo: tuple[Trajectory, ...] = ()
        self._drawn: tuple[object, ...] = ()
        self._own: Recording | None = None
        self._from_browser: Recording | None = None
        super().__init__(page, knobs=knobs, shown=_check_parts(show), **start)
        self.choices = list_letter_choices()
        if recording is None:
            self.letter = "a"
        elif isinstance(recording, str) and normalize("NFC", recording) in characters():
            self.letter = normalize("NFC", recording)
        else:
            self.load(recording)
        if "n_kernels" in settings and self.n_kernels != settings["n_kernels"]:
            raise SettingError(
                f"n_kernels is {settings['n_kernels']}, but this letter has samples for at most "
                f"{self.most_kernels}."
            )

    @property
    def recording(self) -> Recording:
        """The person's letter that is seen."""
        return (
            self._own if self._own and self.letter == OWN_RECORDING else recording_of(self.letter)
        )

    @property
    def learned(self) -> Letter:
        """What the robot learned from it."""
        return self._learned

    @property
    def error(self) -> float:
        """How far the robot's letter is off the person's on average, its goals at home [m]."""
        return self._learned.error

    # Any: a word for the letter, numbers for the rest.
    @property
    def answer(self) -> dict[str, Any]:
        """What is set, by the names of the traits."""
        return {
            name: getattr(self, name)
            for name in ("letter", "n_kernels", "kernel_width", "goal_shifts")
        }

    def draw_still(self) -> Still:
        """Return the letter and the robot's; of a recording of one's own, the sentence alone."""
        plain = super().draw_still()
        if self.letter == OWN_RECORDING:
            return plain
        return plain._replace(person=self._demo, robot=self._strokes)

    def _describe_page(self) -> dict[str, object]:
        """Refuse what was opened in the browser: it may be a pupil's."""
        if self.letter == OWN_RECORDING and self._own is self._from_browser:
            raise RecordingError(
                "A recording that was opened in the panel is written nowhere. Choose a letter of "
                "the alphabet, or open it by explore(recording)."
            )
        return {}

    def _open_bytes(self, name: str, content: bytes) -> None:
        """Read a file that came from the browser; it is kept nowhere."""
        super()._open_bytes(name, content)
        self._from_browser = self._own

    def _show_own(self, own: Recording) -> None:
        """Show a recording beside the letters of the alphabet."""
        self._own = own
        label = own.character or "?"
        self.choices = [
            *(choice for choice in self.choices if choice[0] != OWN_RECORDING),
            [OWN_RECORDING, f"{label}*", _("your own {letter}").format(letter=label), ""],
        ]
        self.near = [*NEAR_LETTERS, OWN_RECORDING]
        if self.letter == OWN_RECORDING:
            self._choose()
        else:
            self.letter = OWN_RECORDING

    @traitlets.observe("letter")
    def _choose(self, change: object = None) -> None:
        """Show another letter: its strokes, its sheet, and goals as demonstrated."""
        own = self._own if self.letter == OWN_RECORDING else None
        self._demo = (own or recording_of(self.letter)).strokes()
        self._drawn = ()
        with self.hold_sync(), self.hold_trait_notifications():
            self.most_kernels = min(MAX_KERNELS, *(len(stroke) - 1 for stroke in self._demo))
            self.n_kernels = min(self.n_kernels, self.most_kernels)
            self.counts = [len(stroke) for stroke in self._demo]
            self.demo = pack_points(self._demo)
            self.sheet = fit_goal_sheet(self._demo)
            self.stroke = len(self._demo) - 1
            self.goal_shifts = [[0.0, 0.0] for _ in self._demo]
            self._size = None
        self._redraw()

    @traitlets.observe("n_kernels", "kernel_width", "goal_shifts", "stroke", "letter", "asked")
    def _redraw(self, change: object = None) -> None:
        """Learn and write again, and say how far off it is."""
        if not self._demo or len(self.goal_shifts) != len(self._demo):
            return
        now = (
            self.letter,
            self.n_kernels,
            self.kernel_width,
            self.stroke,
            str(self.goal_shifts),
            self.asked,
        )
        if now == self._drawn:
            return
        self._drawn = now
        settings = replace(self._settings, n_kernels=self.n_kernels, kernel_width=self.kernel_width)
        # The panel's sentence tells of gaps.
        with warnings.catch_warnings(action="ignore", category=SettingWarning):
            self._learned = letter = Letter.learn(self._demo, settings)
        nominal = letter.write()
        shifts = {i: shift for i, shift in enumerate(self.goal_shifts) if np.any(shift)}
        with self.hold_sync():
            self._show_strokes(letter.write(goal_shifts=shifts) if shifts else nominal)
            self.drawn_shifts = list(self.goal_shifts)
            self.goal_terms = _pack_goal_terms(letter)
            with self.hold_trait_notifications():
                self.goal_x, self.goal_y = self.goal_shifts[self.stroke]
            self._describe(nominal, shifts)
            self.answered = self.asked
            self.drawing += 1

    @traitlets.observe("goal_x", "goal_y")
    def _move_goal(self, change: object) -> None:
        """Move the goal of the chosen stroke, as sliders outside of the panel ask for."""
        shift = [self.goal_x, self.goal_y]
        if self.goal_shifts and shift != list(self.goal_shifts[self.stroke]):
            shifts = list(self.goal_shifts)
            shifts[self.stroke] = shift
            self.goal_shifts = shifts

    def _describe(self, nominal: tuple[Trajectory, ...], shifts: dict[int, list[float]]) -> None:
        """Set the number, the sentence and the text alternative."""
        error = rms_distance(self._demo, nominal)
        if shifts:
            stroke = self.stroke if self.stroke in shifts else max(shifts)
            goal = self._demo[stroke].position[-1] + shifts[stroke]
            miss = float(np.linalg.norm(self._strokes[stroke].position[-1] - goal))
            moved = float(np.linalg.norm(shifts[stroke]))
            named = None if len(self._demo) == 1 else stroke
            self.message = messages.describe_moved_goal(moved, miss, error, named)
        else:
            self.message = messages.describe_fit(error, self.n_kernels, self.kernel_width)
        name = next(name for key, _, name, _ in self.choices if key == self.letter)
        gap = messages.describe_largest_gap(self._demo, nominal)
        self.title = messages.describe_letter(name, error, gap)


def _pack_goal_terms(letter: Letter) -> dict[str, bytes]:
    """Return how the strokes move with x and y of their goals, points as `robot` has them."""
    terms = np.concatenate([each.to_goal for each in letter.responses], axis=1)
    return {axis: term.astype("<f8").tobytes() for axis, term in zip("xy", terms, strict=True)}


def _describe_knob(name: str) -> dict[str, object]:
    """Return a knob as the panel's sliders need it."""
    knob = knob_of(name)
    label = _(knob.label)
    label = label[0].upper() + label[1:]
    return {"low": knob.low, "high": knob.high, "label": label, "term": _(knob.term)}


def _check_parts(show: Sequence[str]) -> list[str]:
    """Return the names of parts, or raise a SettingError with those that there are."""
    names = [show] if isinstance(show, str) else list(show)
    for name in names:
        if name not in EXPLORE_PARTS:
            parts = ", ".join(EXPLORE_PARTS)
            raise SettingError(f"The panel has no part {name!r}; its parts are: {parts}.")
    return names


def _check_slider(name: str, value: float | None) -> float:
    """Return a value that the panel's slider has, or raise a SettingError."""
    high = MAX_KERNELS if name == "n_kernels" else knob_of(name).high
    if value is None or value > high:
        raise SettingError(f"{name} is {value}, but this panel's slider ends at {high:g}.")
    return value
