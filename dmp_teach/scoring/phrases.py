"""Parts of the sentences on a difference: how much, which stroke, and where."""

from __future__ import annotations

import math

from dmp_teach.texts import gettext as _
from dmp_teach.texts import marked

NUMBERS_IN_WORDS = (
    marked("no"), marked("one"), marked("two"), marked("three"), marked("four"),
    marked("five"), marked("six"), marked("seven"), marked("eight"), marked("nine"),
    marked("ten"),
)  # fmt: skip
ORDINALS = (
    marked("first"), marked("second"), marked("third"), marked("fourth"), marked("fifth"),
    marked("sixth"), marked("seventh"), marked("eighth"), marked("ninth"), marked("tenth"),
)  # fmt: skip
RATIOS_IN_WORDS = {
    1 / 4: marked("a quarter as {much}"),
    1 / 3: marked("a third as {much}"),
    1 / 2: marked("half as {much}"),
    2 / 3: marked("two thirds as {much}"),
    3 / 4: marked("three quarters as {much}"),
    3 / 2: marked("one and a half times as {much}"),
    2: marked("twice as {much}"),
    3: marked("three times as {much}"),
    4: marked("four times as {much}"),
}
# Up to this number of steps a difference is "a little".
MOST_STEPS_OF_LITTLE = 2.5

Position = tuple[float, float]
"""A point in the letter's box: from 0 at the left to 1, and from 0 at the bottom to 1."""


def ratio_in_words(ratio: float, steps: float, much: str, more: str, less: str) -> tuple[str, str]:
    """Return a ratio in words, to go on with a noun, and without one."""
    near = min(RATIOS_IN_WORDS, key=lambda known: abs(math.log(known / ratio)))
    if abs(math.log(near / ratio)) < math.log(1.08):
        words = _(RATIOS_IN_WORDS[near]).format(much=much)
    elif ratio > 4:
        words = _("{n:.0f} times as {much}").format(n=ratio, much=much)
    elif ratio >= 2:
        bound = max(known for known in RATIOS_IN_WORDS if known <= ratio)
        times = _(RATIOS_IN_WORDS[bound]).format(much=much)
        words = _("more than {times}").format(times=times)
    elif ratio <= 0.5:
        bound = min(known for known in RATIOS_IN_WORDS if known >= ratio)
        times = _(RATIOS_IN_WORDS[bound]).format(much=much)
        words = _("less than {times}").format(times=times)
    else:
        words = a_little(steps, more if ratio > 1 else less)
        if steps > MOST_STEPS_OF_LITTLE:
            words = _("{n:.0f} percent {more}").format(n=100 * abs(ratio - 1), more=words)
        return _("{more} than").format(more=words), words
    return _("{times} as").format(times=words), words


def place_in_words(position: Position) -> str:
    """Return a position in words."""
    x, y = position
    rows = (
        (_("at the bottom left"), _("at the bottom"), _("at the bottom right")),
        (_("on the left"), _("in the middle"), _("on the right")),
        (_("at the top left"), _("at the top"), _("at the top right")),
    )
    row = rows[0 if y < 0.33 else 2 if y > 0.67 else 1]
    return row[0 if x < 0.33 else 2 if x > 0.67 else 1]


def a_little(steps: float, words: str) -> str:
    """Return what differs, as a little where that is so."""
    is_little = steps <= MOST_STEPS_OF_LITTLE
    return _("a little {much}").format(much=words) if is_little else words


def the_stroke(stroke: int, of: int) -> str:
    """Return a stroke by its number, from 0."""
    if of == 1:
        return _("it")
    return _("the {ordinal} stroke").format(ordinal=ordinal_in_words(stroke), number=stroke + 1)


def ordinal_in_words(number: int) -> str:
    """Return which stroke, from 0, in words."""
    if number < len(ORDINALS):
        return _(ORDINALS[number])
    is_teen = (number + 1) % 100 // 10 == 1
    ending = "th" if is_teen else {1: "st", 2: "nd", 3: "rd"}.get((number + 1) % 10, "th")
    return f"{number + 1}{ending}"


def number_in_words(count: int) -> str:
    """Return a number in words, as far as there are words."""
    return _(NUMBERS_IN_WORDS[count]) if count < len(NUMBERS_IN_WORDS) else str(count)
