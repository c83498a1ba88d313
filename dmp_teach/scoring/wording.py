"""Put differences into words for a child: a sentence, and a reason to stand beside a row."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from inspect import signature
from typing import Any, NamedTuple

from dmp_teach.scoring.phrases import (
    MOST_STEPS_OF_LITTLE,
    Position,
    a_little,
    number_in_words,
    ordinal_in_words,
    place_in_words,
    ratio_in_words,
    the_stroke,
)
from dmp_teach.texts import gettext as _
from dmp_teach.texts import ngettext

# The names of the model stay open, see `Wording`.
_KEPT = {"model": "{model}", "models": "{models}"}

_signature = cache(signature)


class Wording(NamedTuple):
    """A difference in words; the model is `{model}` or, of something of its own, `{models}`."""

    sentence: str
    reason: str


# Any: numbers, truths and positions, each as the function of that name in `_WORDINGS` takes it.
def word_difference(name: str, steps: float, facts: dict[str, Any]) -> Wording:
    """Return a difference in words.

    Args:
        name: What differs, such as "lean".
        steps: By how many of the steps that an eye begins to see.
        facts: What is known of it, such as degrees or the number of the stroke.
    """
    wanted = _signature(_WORDINGS[name]).parameters
    return _WORDINGS[name](steps, **{key: facts[key] for key in facts if key in wanted})


def _mirrored(_steps: float, turn: int) -> Wording:
    if turn == 0:
        return Wording(_("It is the mirror image of {model}."), _("mirrored"))
    if turn == 2:
        return Wording(_("It is upside down, as in a lake."), _("upside down"))
    return Wording(_("It is mirrored, and lies on its side."), _("mirrored, on its side"))


def _turned(_steps: float, turn: int) -> Wording:
    if turn == 2:
        return Wording(_("It stands on its head."), _("on its head"))
    return Wording(_("It lies on its side."), _("on its side"))


def _turn(steps: float, degrees: float) -> Wording:
    words = a_little(steps, _("turned to the left") if degrees > 0 else _("turned to the right"))
    sentence = _("It is {turned}, by {degrees:.0f} degrees.")
    return Wording(sentence.format(turned=words, degrees=abs(degrees)), words)


def _rise(_steps: float, degrees: float) -> Wording:
    words = _("lines rise {n:.0f} degrees") if degrees > 0 else _("lines fall {n:.0f} degrees")
    words = words.format(n=abs(degrees))
    return Wording(_("Its {lines} to the right.").format(lines=words), words)


def _lean(_steps: float, degrees: float) -> Wording:
    words = _("{n:.0f} degrees to the right") if degrees > 0 else _("{n:.0f} degrees to the left")
    words = words.format(n=abs(degrees))
    return Wording(_("It leans {degrees}.").format(degrees=words), words)


def _size(steps: float, ratio: float) -> Wording:
    words, reason = ratio_in_words(ratio, steps, _("large"), _("larger"), _("smaller"))
    return Wording(_("It is {times} {model}.").format(times=words, **_KEPT), reason)


def _width(steps: float, ratio: float) -> Wording:
    wider = _("wider") if ratio > 1 else _("narrower")
    is_little = steps <= MOST_STEPS_OF_LITTLE
    words = a_little(steps, wider) if is_little else _("much {more}").format(more=wider)
    sentence = _("It is {wider} than {model}, for its height.")
    return Wording(sentence.format(wider=words, **_KEPT), words)


def _missing(_steps: float, count: int, stroke: int, of: int) -> Wording:
    if count == 1:
        return _said(_("{it} is missing").format(it=the_stroke(stroke, of)))
    words = ngettext("{number} stroke is missing", "{number} strokes are missing", count)
    return _said(words.format(number=number_in_words(count)))


def _extra(_steps: float, count: int) -> Wording:
    sentence = ngettext(
        "There is {number} stroke too many.", "There are {number} strokes too many.", count
    )
    reason = ngettext("{number} stroke too many", "{number} strokes too many", count)
    number = number_in_words(count)
    return Wording(sentence.format(number=number), reason.format(number=number))


def _unlike(_steps: float) -> Wording:
    return Wording(_("No stroke of {model} looks like that.").format(**_KEPT), _("another stroke"))


def _joined(_steps: float, written: int, model: int) -> Wording:
    return Wording(_takes(written, model), _("joined"))


def _split(_steps: float, written: int, model: int) -> Wording:
    return Wording(_takes(written, model), _("split"))


def _divided(_steps: float) -> Wording:
    words = _("its strokes begin and end at other places than {models}")
    return Wording(_sentence(words), _("other strokes"))


def _reversed(_steps: float, stroke: int, of: int, is_round: bool) -> Wording:
    how = _("{it} goes round the other way") if is_round else _("{it} starts at the wrong end")
    return _said(how.format(it=the_stroke(stroke, of)))


def _round(_steps: float, stroke: int, of: int, is_round: bool, position: Position) -> Wording:
    if is_round:
        words, of_it = (
            _("the round part goes round the other way"),
            _("the round part of {it} goes round the other way"),
        )
    else:
        words, of_it = (
            _("a piece {where} goes the other way"),
            _("a piece of {it} {where} goes the other way"),
        )
    where = place_in_words(position)
    return _said((of_it if of > 1 else words).format(it=the_stroke(stroke, of), where=where))


def _begins(_steps: float, stroke: int, of: int) -> Wording:
    return _said(_("{it} starts at another place of the loop").format(it=the_stroke(stroke, of)))


def _order(_steps: float, early: int, late: int) -> Wording:
    words = _("the {early} stroke was written before the {late}")
    said = words.format(early=ordinal_in_words(early), late=ordinal_in_words(late))
    return Wording(_sentence(said), _("another order"))


def _shape(steps: float, stroke: int, of: int, alone: bool, position: Position) -> Wording:
    words = _("different") if steps <= 2 * MOST_STEPS_OF_LITTLE else _("quite different")
    words, where = a_little(steps, words), place_in_words(position)
    sentence = _("The shape of {it} is {different}, most of all {where}.")
    if alone:
        sentence = _("The shape is {different}, most of all {where}.")
    said = sentence.format(it=the_stroke(stroke, of), different=words, where=where)
    return Wording(said, f"{words} {where}")


def _place(_steps: float, stroke: int, of: int, right: float, up: float) -> Wording:
    if abs(right) > abs(up):
        far = (
            _("{mm:.0f} mm too far to the right")
            if right > 0
            else _("{mm:.0f} mm too far to the left")
        )
    else:
        far = _("{mm:.0f} mm too high") if up > 0 else _("{mm:.0f} mm too low")
    far = far.format(mm=1000 * max(abs(right), abs(up)))
    return _said(_("{it} is {so}").format(it=the_stroke(stroke, of), so=far))


def _piece(steps: float, stroke: int, of: int, missing: bool, position: Position) -> Wording:
    it, where = the_stroke(stroke, of), place_in_words(position)
    if not missing:
        words = a_little(steps, _("too long {where}").format(where=where))
        return Wording(_sentence(_("{it} is {so}").format(it=it, so=words)), words)
    words, of_it = _("a piece is missing {where}"), _("a piece of {it} is missing {where}")
    if steps <= MOST_STEPS_OF_LITTLE:
        words = _("a small piece is missing {where}")
        of_it = _("a small piece of {it} is missing {where}")
    said = (of_it if of > 1 else words).format(it=it, where=where)
    return Wording(_sentence(said), words.format(where=where))


def _open(steps: float, stroke: int, of: int, position: Position) -> Wording:
    is_little = steps <= MOST_STEPS_OF_LITTLE
    closed = _("not quite closed {where}") if is_little else _("not closed {where}")
    words = closed.format(where=place_in_words(position))
    return Wording(_sentence(_("{it} is {so}").format(it=the_stroke(stroke, of), so=words)), words)


def _shaky(steps: float) -> Wording:
    return Wording(_("The line is shakier than {models}."), a_little(steps, _("shaky")))


def _smooth(_steps: float, written: int, model: int) -> Wording:
    words = _("the pen moves less smoothly than {models}")
    if written > model:
        said = _("the pen speeds up and slows down {n} times; {models} {wanted} times")
        words = said.format(n=written, wanted=model, **_KEPT)
    return Wording(_sentence(words), _("not smooth"))


def _tempo(steps: float, ratio: float) -> Wording:
    words, reason = ratio_in_words(ratio, steps, _("fast"), _("faster"), _("slower"))
    return Wording(_("It is written {times} {model}.").format(times=words, **_KEPT), reason)


_WORDINGS: dict[str, Callable[..., Wording]] = {
    function.__name__.removeprefix("_"): function
    for function in (
        *(_mirrored, _turned, _turn, _rise, _lean, _size, _width),
        *(_missing, _extra, _unlike, _joined, _split, _divided, _reversed, _round, _begins, _order),
        *(_shape, _place, _piece, _open, _shaky, _smooth, _tempo),
    )
}


def _takes(written: int, model: int) -> str:
    """Return the sentence of strokes that are joined or split."""
    sentence = ngettext(
        "It is written in {number} stroke; {model} takes {wanted}.",
        "It is written in {number} strokes; {model} takes {wanted}.",
        written,
    )
    return sentence.format(number=number_in_words(written), wanted=number_in_words(model), **_KEPT)


def _said(words: str) -> Wording:
    """Return words that are a sentence and a reason."""
    return Wording(_sentence(words), words)


def _sentence(words: str) -> str:
    """Return words with a capital and a full stop."""
    return f"{words[0].upper()}{words[1:]}."
