"""What differs between two writings, each in steps of what an eye begins to see, and in plain words."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from dmp_teach.scoring.fit import Fit
from dmp_teach.scoring.kinematics import Movement
from dmp_teach.scoring.matching import Matching
from dmp_teach.scoring.resampling import size_of
from dmp_teach.trajectory import Array, Trajectory

STEPS = {
    "shape": 0.0125,  # of the letter's size: the line of a pen, in a letter as large as a hand
    "place": 0.05,  # of the letter's size: a finger's breadth there; a smaller gap reads as touching
    "piece": 0.05,  # the same
    "open": 0.05,  # the same
    "shaky": 0.0025,  # of the letter's size, see `movement.shake`: waves as high as the line of a pen is wide
    "size": math.log(1.15),  # a seventh: letters in one word differ by as much, and nobody minds
    "width": math.log(1.15),  # the same
    "lean": 5.0,  # degrees: less than one minute on the face of a clock
    "turn": 6.0,  # degrees: one minute on the face of a clock
    "rise": 10.0,  # degrees: lines are seen to be level less sharply, for they are short and round
    "smooth": 1.5,  # in the logarithm: 4.5 times the jerk; the same hand, slower by half, loses as much
    "tempo": math.log(
        3.0
    ),  # people write one letter three times as fast as another day's, and it looks the same
}
"""How much of each is one step. Below one step two letters are taken for the same."""

UNSEEN = ("smooth", "tempo")
"""Faults of the movement that leave no trace in the ink."""

PLAIN = {
    "mirrored": 14.0,
    "turned": 14.0,
    "missing": 12.0,
    "extra": 12.0,
    "reversed": 5.0,
    "order": 4.0,
    "pieces": 4.0,
}
"""How many steps are what is or is not: what another reader would stumble over counts most."""

NUMBERS = ("no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten")
ORDINALS = (
    "first",
    "second",
    "third",
    "fourth",
    "fifth",
    "sixth",
    "seventh",
    "eighth",
    "ninth",
    "tenth",
)
TIMES = {
    1 / 4: "a quarter as",
    1 / 3: "a third as",
    1 / 2: "half as",
    2 / 3: "two thirds as",
    3 / 4: "three quarters as",
}
TIMES |= {3 / 2: "one and a half times as", 2: "twice as", 3: "three times as", 4: "four times as"}
DOT = 0.1  # of the letter's size: what is smaller, and lacks a stroke, is a dot of it
LITTLE = 2.5  # up to so many steps a fault is "a little"


@dataclass(frozen=True)
class Fault:
    """One way in which a writing differs from its model.

    Args:
        name: What it is, such as "lean".
        steps: How many steps of what an eye begins to see; see `STEPS`.
        sentence: In plain words.
        reason: The same in a few words, to stand beside a row.
    """

    name: str
    steps: float
    sentence: str
    reason: str


def faults(
    matching: Matching, fit: Fit, written: Movement, model: Movement, strokes: Sequence[Trajectory]
):
    """All faults, the largest first; `strokes` are the model's."""
    sizes = [max(each.width, each.height) for each in (written, model)]
    nothing = (
        bool(matching.missing) and sizes[0] < DOT * sizes[1]
    )  # a dot has no size, width or lean
    found = [
        *(replace(each, steps=0.0) if nothing else each for each in _of_the_whole(matching, fit)),
        *_of_strokes(matching, model),
        *_of_order(matching, written, model),
        *_of_shape(matching, fit, strokes),
        *_of_loops(matching, fit, strokes),
        *_of_movement(written, model),
    ]
    return tuple(sorted(found, key=lambda fault: -fault.steps))


def _of_the_whole(matching: Matching, fit: Fit) -> Iterator[Fault]:
    """Mirrored, turned, size, width, lean."""
    if matching.mirrored and matching.turn == 0:
        yield Fault(
            "mirrored", PLAIN["mirrored"], "It is the mirror image of the model.", "mirrored"
        )
    elif matching.mirrored and matching.turn == 2:
        yield Fault(
            "mirrored", PLAIN["mirrored"], "It is upside down, as in a lake.", "upside down"
        )
    elif matching.mirrored:
        yield Fault(
            "mirrored",
            PLAIN["mirrored"],
            "It is mirrored, and lies on its side.",
            "mirrored, on its side",
        )
    elif matching.turn == 2:
        yield Fault("turned", PLAIN["turned"], "It stands on its head.", "on its head")
    elif matching.turn:
        yield Fault("turned", PLAIN["turned"], "It lies on its side.", "on its side")
    steps = abs(fit.turn) / STEPS["turn"]
    words = f"{_little(steps)}turned to the {'left' if fit.turn > 0 else 'right'}"
    yield Fault("turn", steps, f"It is {words}, by {abs(fit.turn):.0f} degrees.", words)
    steps = abs(fit.rise) / STEPS["rise"]
    words = f"lines {'rise' if fit.rise > 0 else 'fall'} {abs(fit.rise):.0f} degrees"
    yield Fault("rise", steps, f"Its {words} to the right.", words)
    steps = abs(fit.lean) / STEPS["lean"]
    side, degrees = "right" if fit.lean > 0 else "left", f"{abs(fit.lean):.0f} degrees"
    yield Fault("lean", steps, f"It leans {degrees} to the {side}.", f"{degrees} to the {side}")
    steps = abs(math.log(fit.size)) / STEPS["size"]
    words = _times(fit.size, steps, "large", "larger", "smaller")
    yield Fault("size", steps, f"It is {words[0]} the model.", words[1])
    steps = abs(math.log(fit.width)) / STEPS["width"]
    words = f"{_little(steps) or 'much '}{'wider' if fit.width > 1 else 'narrower'}"
    yield Fault("width", steps, f"It is {words} than the model, for its height.", words)


def _of_strokes(matching: Matching, model: Movement) -> Iterator[Fault]:
    """Strokes that are not there, or too many."""
    if len(matching.missing) == 1:
        words = f"{_the(matching.missing[0], model.strokes)} is missing"
        yield Fault("missing", PLAIN["missing"], f"{_sentence(words)}", words)
    elif matching.missing:
        words = f"{_count(len(matching.missing), True)} are missing"
        yield Fault("missing", PLAIN["missing"] + 1, _sentence(words), words)
    if matching.extra:
        count = len(matching.extra)
        words = f"there {'is' if count == 1 else 'are'} {_count(count, True)} too many"
        yield Fault("extra", PLAIN["extra"], _sentence(words), words.split(" ", 2)[2])


def _of_order(matching: Matching, written: Movement, model: Movement) -> Iterator[Fault]:
    """Strokes that are joined, split, divided or begun elsewhere, or in another order."""
    for pairs, name in ((matching.joined, "joined"), (matching.split, "split")):
        if pairs:
            takes = f"the model takes {_count(model.strokes)}"
            yield Fault(
                name,
                PLAIN["pieces"],
                f"It is written in {_count(written.strokes, True)}; {takes}.",
                name,
            )
    if matching.divided:
        words = "its strokes begin and end at other places than the model's"
        yield Fault("divided", PLAIN["pieces"], _sentence(words), "other strokes")
    for number in matching.reversed[:1]:
        loop = next(pair.laid.loop for pair in matching.pairs if pair.others[0] == number)
        words = f"{_the(number, model.strokes)} {'goes round the other way' if loop else 'starts at the wrong end'}"
        extra = 0.1 * len(matching.reversed)
        yield Fault("reversed", PLAIN["reversed"] + extra, _sentence(words), words)
    for pair in matching.pairs:
        away = min(pair.laid.begins, 1 - pair.laid.begins)
        if not pair.laid.backwards and away > 0.125:
            words = f"{_the(pair.others[0], model.strokes)} starts at another place of the loop"
            yield Fault("begins", 2 * PLAIN["reversed"] * away, _sentence(words), words)
    order = matching.order
    if order != tuple(sorted(order)):
        late = next(k for k, number in enumerate(order) if number != sorted(order)[k])
        words = f"the {_nth(order[late])} stroke was written before the {_nth(sorted(order)[late])}"
        yield Fault("order", PLAIN["order"], _sentence(words), "another order")


def _of_shape(matching: Matching, fit: Fit, strokes: Sequence[Trajectory]) -> Iterator[Fault]:
    """Shapes of strokes, and their places."""
    point, worst = fit.worst
    steps = fit.shape / STEPS["shape"]
    where = _where(point, strokes)
    which = (
        ""
        if len(matching.pairs) == 1
        else f" of {_the(matching.pairs[worst].others[0], len(strokes))}"
    )
    much = (
        "a little different"
        if steps <= LITTLE
        else "different"
        if steps <= 2 * LITTLE
        else "quite different"
    )
    yield Fault(
        "shape", steps, f"The shape{which} is {much}, most of all {where}.", f"{much} {where}"
    )
    if fit.trim is not None:
        yield _piece(matching, fit, strokes)
    far = np.linalg.norm(fit.places, axis=1)
    k = int(np.argmax(far))
    steps, (right, up) = float(far[k]) / STEPS["place"], fit.places[k]
    side = (
        ("right" if right > 0 else "left")
        if abs(right) > abs(up)
        else ("high" if up > 0 else "low")
    )
    much = "a little too" if steps <= LITTLE else "too"
    words = f"{much} far to the {side}" if side in ("left", "right") else f"{much} {side}"
    stroke = _the(matching.pairs[k].others[0], len(strokes))
    yield Fault("place", steps, _sentence(f"{stroke} is {words}"), f"{stroke} is {words}")


def _piece(matching: Matching, fit: Fit, strokes: Sequence[Trajectory]) -> Fault:
    """A piece at the end of a stroke, missing or too much."""
    steps, number = fit.gap / STEPS["piece"], matching.pairs[fit.trim.pair].others[0]
    where = _where(strokes[number].position[0 if fit.trim.first else -1], strokes)
    if fit.trim.missing:
        of = f" of {_the(number, len(strokes))}" if len(strokes) > 1 else ""
        piece = f"a {'small ' if steps <= LITTLE else ''}piece"
        return Fault(
            "piece",
            steps,
            _sentence(f"{piece}{of} is missing {where}"),
            f"{piece} is missing {where}",
        )
    words = f"{_little(steps)}too long {where}"
    return Fault("piece", steps, _sentence(f"{_the(number, len(strokes))} is {words}"), words)


def _of_loops(matching: Matching, fit: Fit, strokes: Sequence[Trajectory]) -> Iterator[Fault]:
    """Rings that are not closed: two points one after the other are farther apart where their ends are."""
    size = size_of(strokes)
    for pair in matching.pairs:
        if pair.laid.loop:
            mine, yours = (
                np.linalg.norm(line - np.roll(line, 1, axis=0), axis=1) for line in pair.laid.lines
            )
            steps = max(0.0, float(mine.max() / fit.size - yours.max()) / size / STEPS["open"])
            closed = "not quite closed" if steps <= LITTLE else "not closed"
            where = _where(pair.laid.others[int(np.argmax(mine))], strokes)
            words = f"{closed} {where}"
            yield Fault(
                "open", steps, _sentence(f"{_the(pair.others[0], len(strokes))} is {words}"), words
            )


def _of_movement(written: Movement, model: Movement) -> Iterator[Fault]:
    """Smoothness, of the line and of the movement, and tempo."""
    steps = max(0.0, written.shake - model.shake) / STEPS["shaky"]
    yield Fault("shaky", steps, "The line is shakier than the model's.", f"{_little(steps)}shaky")
    steps = max(0.0, model.smoothness - written.smoothness) / STEPS["smooth"]
    words = (
        f"the pen speeds up and slows down {written.peaks} times; the model's {model.peaks} times"
    )
    if written.peaks <= model.peaks:
        words = "the pen moves less smoothly than the model's"
    yield Fault("smooth", steps, _sentence(words), "not smooth")
    ratio = (
        written.pace
        / model.pace
        * max(model.width, model.height)
        / max(written.width, written.height)
    )
    steps = abs(math.log(ratio)) / STEPS["tempo"]
    words = _times(ratio, steps, "fast", "faster", "slower")
    yield Fault("tempo", steps, f"It is written {words[0]} the model.", words[1])


def _times(ratio: float, steps: float, much: str, more: str, less: str) -> tuple[str, str]:
    """A ratio in words, to go on with a noun, and without one."""
    near = min(TIMES, key=lambda known: abs(math.log(known / ratio)))
    if abs(math.log(near / ratio)) < math.log(1.08):
        return f"{TIMES[near]} {much} as", f"{TIMES[near]} {much}"
    percent = abs(ratio - 1)
    if ratio > 4:
        return f"{ratio:.0f} times as {much} as", f"{ratio:.0f} times as {much}"
    if not 0.5 < ratio < 2:
        known = (
            max(n for n in TIMES if n <= ratio)
            if ratio > 2
            else min(n for n in TIMES if n >= ratio)
        )
        words = f"{'more' if ratio > 2 else 'less'} than {TIMES[known]} {much}"
        return f"{words} as", words
    word = more if ratio > 1 else less
    if steps <= LITTLE:
        return f"a little {word} than", f"a little {word}"
    return f"{100 * percent:.0f} percent {word} than", f"{100 * percent:.0f} percent {word}"


def _where(point: Array, strokes: Sequence[Trajectory]) -> str:
    """A point of the letter in words."""
    ink = np.concatenate([stroke.position for stroke in strokes])
    low, size = ink.min(axis=0), np.ptp(ink, axis=0)
    x, y = np.divide(point - low, size, out=np.full(2, 0.5), where=size > 0.25 * size.max())
    height = "at the top" if y > 0.67 else "at the bottom" if y < 0.33 else "in the middle"
    side = "left" if x < 0.33 else "right" if x > 0.67 else ""
    if height == "in the middle":
        return f"on the {side}" if side else height
    return f"{height} {side}".strip()


def _little(steps: float) -> str:
    """How much, before an adjective."""
    return "a little " if steps <= LITTLE else ""


def _the(number: int, of: int) -> str:
    """A stroke by its number, from 0."""
    return f"the {_nth(number)} stroke" if of > 1 else "it"


def _nth(number: int) -> str:
    """Which stroke, from 0, in words."""
    if number < len(ORDINALS):
        return ORDINALS[number]
    teen = (number + 1) % 100 // 10 == 1
    return (
        f"{number + 1}{'th' if teen else {1: 'st', 2: 'nd', 3: 'rd'}.get((number + 1) % 10, 'th')}"
    )


def _count(strokes: int, noun: bool = False) -> str:
    """How many strokes, in words."""
    words = NUMBERS[strokes] if strokes < len(NUMBERS) else str(strokes)
    return f"{words} stroke{'s' * (strokes > 1)}" if noun else words


def _sentence(words: str) -> str:
    """Words with a capital and a full stop."""
    return f"{words[0].upper()}{words[1:]}."
