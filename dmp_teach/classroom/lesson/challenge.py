"""A challenge of a teacher's own: a text, conditions, hints and usual mistakes on one card."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from html import escape
from pathlib import Path
from typing import Any

import traitlets
from IPython.display import display

from dmp_teach.arguments import checked
from dmp_teach.classroom.lesson.check import Condition, Verdict, evaluate, judge
from dmp_teach.classroom.lesson.progress import HINTS_AFTER_MISSES
from dmp_teach.classroom.panels.kept import kept
from dmp_teach.errors import SettingError
from dmp_teach.files import join_modules, join_styles
from dmp_teach.texts import gettext as _
from dmp_teach.views import STYLE_TOKENS, UnsavedWidget

_HERE = Path(__file__).parent


@checked
def challenge(
    text: str,
    *conditions: Condition,
    hints: Sequence[str] = (),
    mistakes: Mapping[str, Callable[[], object]] | None = None,
    praise: str = "",
) -> Challenge:
    """Show a card with a challenge, which *Check* judges by what is set at that moment.

        teach.challenge(
            "Bring the **e** under 1 mm.",
            teach.at_most("the e", lambda: 1000 * panel.error, 1.0, "mm"),
            hints=["Look where the line leaves the dots."],
            mistakes={"There are gaps between the bumps.": lambda: panel.kernel_width < 1},
        )

    Running the cell again finds the card as it was left.

    Args:
        text: What to do; words between ** are bold.
        conditions: Made by `at_most`, `at_least`, `between` and `exactly`, their values functions.
        hints: Offered one by one, from the second miss on.
        mistakes: What is said, and a function that returns whether it is so. The first mistake
            that was made is told before what is missing, and the challenge is then not done.
        praise: What is said when all is met; empty: the numbers.

    Raises:
        SettingError: There is no condition, or an argument of another kind.
    """
    return Challenge(text, conditions, hints, mistakes or {}, praise)


class Challenge(UnsavedWidget):
    """The card of a challenge. `check` is what its button does."""

    _esm = join_modules(_HERE / "challenge.js")
    _css = join_styles(STYLE_TOKENS, _HERE.parent / "panels" / "panel.css", _HERE / "lesson.css")

    words = traitlets.Unicode().tag(sync=True)
    # Any, here and below: JSON for the browser.
    progress: traitlets.Dict[str, Any] = traitlets.Dict().tag(sync=True)
    card: traitlets.Dict[str, Any] = traitlets.Dict().tag(sync=True)
    answered = traitlets.Int(0).tag(sync=True)

    def __init__(
        self,
        text: str,
        conditions: Sequence[Condition],
        hints: Sequence[str],
        mistakes: Mapping[str, Callable[[], object]],
        praise: str,
    ):
        _refuse_other_kinds(conditions, mistakes)
        self.conditions, self.mistakes, self.praise = tuple(conditions), dict(mistakes), praise
        self.hints = (hints,) if isinstance(hints, str) else tuple(hints)
        rules = [[each.name, "", each.rule, False] for each in conditions]
        self._kept = kept(f"challenge {text} {rules}")
        super().__init__(words=text)
        self.on_msg(self._hear)
        fresh = {"verdict": None, "passed": False, "misses": 0, "hints": 0, "rows": rules}
        self._change(**fresh | self._kept)

    def __repr__(self) -> str:
        """Return the challenge, and what was said last."""
        said = (self._kept["verdict"] or {}).get("reason", "")
        return f"Challenge({self.words!r}{said and f', {said!r}'})"

    def check(self) -> Verdict:
        """Judge what is set now, and count a miss."""
        hint = self.hints[min(self._kept["hints"], len(self.hints) - 1)] if self.hints else ""
        try:
            conditions = [replace(each, value=each.number) for each in self.conditions]
            mistakes = [words for words, ask in self.mistakes.items() if evaluate(words, ask)]
        except SettingError as error:
            # The fault is the challenge's: no miss of who tries it.
            self._change(verdict={"done": False, "reason": str(error)})
            return Verdict(False, str(error))
        verdict = judge(conditions, mistakes, lambda: self.praise or _praise(conditions), hint)
        self._change(
            verdict={"done": verdict.done, "reason": verdict.reason},
            passed=self._kept["passed"] or verdict.done,
            misses=self._kept["misses"] + (not verdict.done),
            rows=[[each.name, each.shown, each.rule, each.is_met] for each in conditions],
        )
        return verdict

    def show_hint(self) -> None:
        """Show one hint more."""
        self._change(hints=min(self._kept["hints"] + 1, len(self.hints)))

    def _hear(self, _widget: object, message: dict[str, Any], _buffers: list[memoryview]) -> None:
        """Do what a button asks for."""
        if message.get("kind") == "check":
            self.check()
        elif message.get("kind") == "hint":
            self.show_hint()
        self.answered += 1

    def _change(self, **changes: Any) -> None:
        """Keep changes, and show them."""
        self._kept.update(changes)
        now = self._kept
        is_stuck = now["misses"] >= HINTS_AFTER_MISSES and not now["passed"]
        with self.hold_sync():
            self.progress = {"step": "challenge", **{n: now[n] for n in ("verdict", "passed")}}
            self.card = {
                "rows": now["rows"],
                "hints": list(self.hints[: now["hints"]]),
                "offersHint": is_stuck and now["hints"] < len(self.hints),
            }

    def _ipython_display_(self) -> None:
        """Show the card, and its text where it cannot live."""
        bundle, metadata = self._repr_mimebundle_() or ({}, {})
        display({**bundle, "text/plain": repr(self)}, metadata=metadata, raw=True)
        display({"text/html": f'<p class="dt-stand-in">{escape(self.words)}</p>'}, raw=True)


def _praise(conditions: Sequence[Condition]) -> str:
    """Return that all is met, with the numbers."""
    numbers = ", ".join(f"{each.name} {each.shown}" for each in conditions)
    return _("You did it: {numbers}.").format(numbers=numbers)


def _refuse_other_kinds(conditions: Sequence[object], mistakes: Mapping[str, object]) -> None:
    """Raise a SettingError where a teacher's challenge cannot be judged."""
    makers = "at_most, at_least, between or exactly"
    odd = [each for each in conditions if not isinstance(each, Condition)]
    if odd or not conditions:
        got = repr(odd[0]) if odd else "none"
        raise SettingError(f"A challenge has conditions, made by {makers}, but got {got:.60}.")
    for words, ask in mistakes.items():
        if not isinstance(words, str) or not callable(ask):
            raise SettingError(
                f"mistakes has {words!r:.40}: {ask!r:.40}, but must have sentences, and to each a "
                "function, such as lambda: panel.kernel_width < 1."
            )
