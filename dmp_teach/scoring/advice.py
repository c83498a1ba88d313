"""Say what to do next about a difference: one short sentence, in terms of what a hand can do."""

from __future__ import annotations

from typing import Any

from dmp_teach.scoring.phrases import ordinal_in_words, place_in_words, the_stroke
from dmp_teach.texts import gettext as _
from dmp_teach.texts import marked

_ADVICE: dict[str, str | tuple[str, str]] = {
    "size": (marked("Write it smaller."), marked("Write it larger.")),
    "width": (marked("Write it narrower."), marked("Write it wider.")),
    "tempo": (marked("Write a little slower."), marked("Write a little faster.")),
    "turn": (marked("Turn it back to the right."), marked("Turn it back to the left.")),
    "rise": (marked("Keep it lower on the right."), marked("Keep it higher on the right.")),
    "lean": (marked("Let it lean less to the right."), marked("Let it lean less to the left.")),
    "joined": marked("Lift the pen between the strokes."),
    "split": marked("Lift the pen less often."),
    "divided": marked("Watch where the pen is lifted."),
    "extra": marked("Write only as many strokes as {model}."),
    "missing": marked("Write {it} too: it starts {where}."),
    "shape": marked("Keep nearer to {models} line {where}."),
    "unlike": marked("Write {it}: it starts {where}."),
    "begins": marked("Start {it} {where}."),
    "order": marked("Write the {late} stroke before the {early}."),
    "open": marked("Close {it} {where}."),
    "shaky": marked("Write it in one quick sweep."),
    "smooth": marked("Write it in one sweep, without a stop."),
}
_AROUND = (marked("Go round against the clock."), marked("Go round with the clock."))


# Any: as in `wording`.
def advise(name: str, facts: dict[str, Any]) -> str:
    """Return what to do next about a difference; the model stays open, as in `Wording`."""
    words = _ADVICE.get(name) or _of_facts(name, facts)
    if isinstance(words, tuple):
        amount = facts["ratio"] - 1 if "ratio" in facts else facts["degrees"]
        words = words[0 if amount > 0 else 1]
    return _(words).format(
        it=the_stroke(facts.get("stroke", 0), facts.get("of", 1)),
        where=place_in_words(facts.get("position", (0.5, 0.5))),
        early=ordinal_in_words(facts.get("early", 0)),
        late=ordinal_in_words(facts.get("late", 0)),
        model="{model}",
        models="{models}",
    )


def _of_facts(name: str, facts: dict[str, Any]) -> str:
    """Return the advice of a difference that has several."""
    if name in ("mirrored", "turned"):
        return _upright(name == "mirrored", facts["turn"])
    if name == "piece":
        much = marked("Write more of {it} {where}."), marked("Write less of {it} {where}.")
        return much[0 if facts["missing"] else 1]
    if name == "place":
        return _nearer(facts["right"], facts["up"])
    if facts["is_round"]:
        return _AROUND[0 if facts["left"] else 1]
    if name == "reversed":
        return marked("Start {it} at its other end, {where}.")
    return marked("Go the other way {where}.")


def _upright(mirrored: bool, turn: int) -> str:
    """Return how a letter is put right that is mirrored, or turned by quarters to the left."""
    if mirrored and turn == 0:
        return marked("What is on the left belongs on the right.")
    if turn == 2:
        return marked("What is at the top belongs at the bottom.")
    return marked("Turn it upright.")


def _nearer(right: float, up: float) -> str:
    """Return where a stroke belongs that is too far right or up."""
    if abs(right) > abs(up):
        ways = marked("Put {it} further to the left."), marked("Put {it} further to the right.")
        return ways[0 if right > 0 else 1]
    return (marked("Put {it} lower."), marked("Put {it} higher."))[0 if up > 0 else 1]
