"""Put differences into words for a child: a sentence, and a reason to stand beside a row."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, NamedTuple

NUMBERS_IN_WORDS = (
    "no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten",
)  # fmt: skip
ORDINALS = (
    "first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth", "ninth", "tenth",
)  # fmt: skip
RATIOS_IN_WORDS = {
    1 / 4: "a quarter as",
    1 / 3: "a third as",
    1 / 2: "half as",
    2 / 3: "two thirds as",
    3 / 4: "three quarters as",
    3 / 2: "one and a half times as",
    2: "twice as",
    3: "three times as",
    4: "four times as",
}
# Up to this number of steps a difference is "a little".
MOST_STEPS_OF_LITTLE = 2.5

Position = tuple[float, float]
"""A point in the letter's box: from 0 at the left to 1, and from 0 at the bottom to 1."""


class Wording(NamedTuple):
    """A difference in words."""

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
    return _WORDINGS[name](steps, **facts)


def _mirrored(_steps: float, turn: int) -> Wording:
    if turn == 0:
        return Wording("It is the mirror image of the model.", "mirrored")
    if turn == 2:
        return Wording("It is upside down, as in a lake.", "upside down")
    return Wording("It is mirrored, and lies on its side.", "mirrored, on its side")


def _turned(_steps: float, turn: int) -> Wording:
    if turn == 2:
        return Wording("It stands on its head.", "on its head")
    return Wording("It lies on its side.", "on its side")


def _turn(steps: float, degrees: float) -> Wording:
    words = f"{_little(steps)}turned to the {'left' if degrees > 0 else 'right'}"
    return Wording(f"It is {words}, by {abs(degrees):.0f} degrees.", words)


def _rise(_steps: float, degrees: float) -> Wording:
    words = f"lines {'rise' if degrees > 0 else 'fall'} {abs(degrees):.0f} degrees"
    return Wording(f"Its {words} to the right.", words)


def _lean(_steps: float, degrees: float) -> Wording:
    side, much = "right" if degrees > 0 else "left", f"{abs(degrees):.0f} degrees"
    return Wording(f"It leans {much} to the {side}.", f"{much} to the {side}")


def _size(steps: float, ratio: float) -> Wording:
    words, reason = _times(ratio, steps, "large", "larger", "smaller")
    return Wording(f"It is {words} the model.", reason)


def _width(steps: float, ratio: float) -> Wording:
    words = f"{_little(steps) or 'much '}{'wider' if ratio > 1 else 'narrower'}"
    return Wording(f"It is {words} than the model, for its height.", words)


def _missing(_steps: float, count: int, stroke: int, of: int) -> Wording:
    if count == 1:
        return _said(f"{_the(stroke, of)} is missing")
    return _said(f"{_strokes(count)} are missing")


def _extra(_steps: float, count: int) -> Wording:
    words = f"{_strokes(count)} too many"
    return Wording(f"There {'is' if count == 1 else 'are'} {words}.", words)


def _joined(_steps: float, written: int, model: int) -> Wording:
    return Wording(_takes(written, model), "joined")


def _split(_steps: float, written: int, model: int) -> Wording:
    return Wording(_takes(written, model), "split")


def _divided(_steps: float) -> Wording:
    words = "its strokes begin and end at other places than the model's"
    return Wording(_sentence(words), "other strokes")


def _reversed(_steps: float, stroke: int, of: int, loop: bool) -> Wording:
    how = "goes round the other way" if loop else "starts at the wrong end"
    return _said(f"{_the(stroke, of)} {how}")


def _round(
    _steps: float, stroke: int, of: int, is_round: bool, left: bool, position: Position
) -> Wording:
    which = f" of {_the(stroke, of)}" if of > 1 else ""
    if is_round:
        return _said(f"the round part{which} goes round the other way")
    return _said(f"a piece{which} {_where(position)} goes the other way")


def _begins(_steps: float, stroke: int, of: int) -> Wording:
    return _said(f"{_the(stroke, of)} starts at another place of the loop")


def _order(_steps: float, early: int, late: int) -> Wording:
    words = f"the {_ordinal(early)} stroke was written before the {_ordinal(late)}"
    return Wording(_sentence(words), "another order")


def _shape(steps: float, stroke: int, of: int, alone: bool, position: Position) -> Wording:
    which = "" if alone else f" of {_the(stroke, of)}"
    much = "different" if steps <= 2 * MOST_STEPS_OF_LITTLE else "quite different"
    words, where = _little(steps) + much, _where(position)
    return Wording(f"The shape{which} is {words}, most of all {where}.", f"{words} {where}")


def _place(steps: float, stroke: int, of: int, right: float, up: float) -> Wording:
    if abs(right) > abs(up):
        far = f"far to the {'right' if right > 0 else 'left'}"
    else:
        far = "high" if up > 0 else "low"
    return _said(f"{_the(stroke, of)} is {_little(steps)}too {far}")


def _piece(steps: float, stroke: int, of: int, missing: bool, position: Position) -> Wording:
    where = _where(position)
    if not missing:
        words = f"{_little(steps)}too long {where}"
        return Wording(_sentence(f"{_the(stroke, of)} is {words}"), words)
    piece = f"a {'small ' if steps <= MOST_STEPS_OF_LITTLE else ''}piece"
    which = f" of {_the(stroke, of)}" if of > 1 else ""
    return Wording(_sentence(f"{piece}{which} is missing {where}"), f"{piece} is missing {where}")


def _open(steps: float, stroke: int, of: int, position: Position) -> Wording:
    closed = "not quite closed" if steps <= MOST_STEPS_OF_LITTLE else "not closed"
    words = f"{closed} {_where(position)}"
    return Wording(_sentence(f"{_the(stroke, of)} is {words}"), words)


def _shaky(steps: float) -> Wording:
    return Wording("The line is shakier than the model's.", f"{_little(steps)}shaky")


def _smooth(_steps: float, written: int, model: int) -> Wording:
    words = "the pen moves less smoothly than the model's"
    if written > model:
        words = f"the pen speeds up and slows down {written} times; the model's {model} times"
    return Wording(_sentence(words), "not smooth")


def _tempo(steps: float, ratio: float) -> Wording:
    words, reason = _times(ratio, steps, "fast", "faster", "slower")
    return Wording(f"It is written {words} the model.", reason)


_WORDINGS: dict[str, Callable[..., Wording]] = {
    function.__name__.removeprefix("_"): function
    for function in (
        *(_mirrored, _turned, _turn, _rise, _lean, _size, _width),
        *(_missing, _extra, _joined, _split, _divided, _reversed, _round, _begins, _order),
        *(_shape, _place, _piece, _open, _shaky, _smooth, _tempo),
    )
}


def _times(ratio: float, steps: float, much: str, more: str, less: str) -> tuple[str, str]:
    """Return a ratio in words, to go on with a noun, and without one."""
    near = min(RATIOS_IN_WORDS, key=lambda known: abs(math.log(known / ratio)))
    if abs(math.log(near / ratio)) < math.log(1.08):
        words = f"{RATIOS_IN_WORDS[near]} {much}"
        return f"{words} as", words
    if ratio > 4:
        words = f"{ratio:.0f} times as {much}"
        return f"{words} as", words
    if not 0.5 < ratio < 2:
        is_more = ratio > 2
        bound = (
            max(known for known in RATIOS_IN_WORDS if known <= ratio)
            if is_more
            else min(known for known in RATIOS_IN_WORDS if known >= ratio)
        )
        words = f"{'more' if is_more else 'less'} than {RATIOS_IN_WORDS[bound]} {much}"
        return f"{words} as", words
    word = more if ratio > 1 else less
    percent = f"{100 * abs(ratio - 1):.0f} percent "
    words = f"{_little(steps) or percent}{word}"
    return f"{words} than", words


def _where(position: Position) -> str:
    """Return a position in words."""
    x, y = position
    height = "at the top" if y > 0.67 else "at the bottom" if y < 0.33 else "in the middle"
    side = "left" if x < 0.33 else "right" if x > 0.67 else ""
    if height == "in the middle":
        return f"on the {side}" if side else height
    return f"{height} {side}".strip()


def _little(steps: float) -> str:
    """Return how much, before an adjective."""
    return "a little " if steps <= MOST_STEPS_OF_LITTLE else ""


def _the(stroke: int, of: int) -> str:
    """Return a stroke by its number, from 0."""
    return f"the {_ordinal(stroke)} stroke" if of > 1 else "it"


def _ordinal(number: int) -> str:
    """Return which stroke, from 0, in words."""
    if number < len(ORDINALS):
        return ORDINALS[number]
    is_teen = (number + 1) % 100 // 10 == 1
    ending = "th" if is_teen else {1: "st", 2: "nd", 3: "rd"}.get((number + 1) % 10, "th")
    return f"{number + 1}{ending}"


def _number(count: int) -> str:
    """Return a number in words, as far as there are words."""
    return NUMBERS_IN_WORDS[count] if count < len(NUMBERS_IN_WORDS) else str(count)


def _strokes(count: int) -> str:
    """Return how many strokes, in words."""
    return f"{_number(count)} stroke{'s' * (count > 1)}"


def _takes(written: int, model: int) -> str:
    """Return the sentence of strokes that are joined or split."""
    return f"It is written in {_strokes(written)}; the model takes {_number(model)}."


def _said(words: str) -> Wording:
    """Return words that are a sentence and a reason."""
    return Wording(_sentence(words), words)


def _sentence(words: str) -> str:
    """Return words with a capital and a full stop."""
    return f"{words[0].upper()}{words[1:]}."
