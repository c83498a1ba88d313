"""Recipes for new letters, a line each: a D's strokes make a P, an l and an o make b, d, p and q.

A line names the letter, then its strokes in the order of writing, with commas between them. A
stroke is a letter, a role (`roles.ROLES`) and what is done with it, in words:

    lead END to SPOT     an end (upper, lower, start, goal) is led there by its primitive
    put PLACE at SPOT    it is moved so that a place of it (an end, top, bottom, left, right) lies
                         there
    slide PLACE to N     it is moved level until that place lies on stroke N
    meet SPOT            it is moved level until it passes through there
    size F               it is made F times as large, its lowest point staying
    tall F of N          it is made F times as tall as stroke N
    turn DEGREES         it is turned to the left about its middle
    back                 it is written from its other end
    alike                it is led by turning and scaling it (a similarity), unless `transform` is
                         given
    last                 it is written after all others

A SPOT is a stroke of the new letter, counted from 1, and a place on it: 1:bottom, or 1:0.5 for
half of its height. 2:right/1:bottom is as far right as the one and as high as the other. Of several
lines for a letter the first is taken whose letters are on the shelf and can be taken apart.
"""

from __future__ import annotations

import re
from collections.abc import Callable

import numpy as np

from dmp_teach.errors import LetterError, SettingError, kind_of
from dmp_teach.letters.compose.piece import Piece
from dmp_teach.letters.compose.roles import strokes_in_role
from dmp_teach.letters.compose.shelf import Shelf
from dmp_teach.letters.letter import Letter
from dmp_teach.trajectory import Array

RECIPES = """
P  D bar, D bowl lead lower to 1:0.5
P  B bar, B upper lead lower to 1:0.5
R  D bar, D bowl lead lower to 1:0.5, D bar alike lead upper to 1:0.5 lead lower to 2:right/1:bottom
R  P bar, P bowl, P bar alike lead upper to 1:0.5 lead lower to 2:right/1:bottom
B  D bar, D bowl alike lead lower to 1:0.5, D bowl alike lead upper to 1:0.5
3  B upper, B lower
b  D bar, o all slide left to 1
b  l down, o all slide left to 1
d  o all, D bar meet 1:right
d  o all, l down meet 1:right
d  a left, D bar tall 1.9 of 1 put lower at 1:right/1:bottom meet 1:right
p  o all last, D bar put upper at 1:left/1:top meet 1:left
p  o all last, l down put upper at 1:left/1:top meet 1:left
q  o all, D bar put upper at 1:right/1:top meet 1:right
q  o all, l down put upper at 1:right/1:top meet 1:right
a  o all, i stem meet 1:right
g  o all, j stem meet 1:right
h  l down, n right slide left to 1
h  D bar, n right slide left to 1
n  m left, m right put start at 1:lower
m  n left, n right, n right put start at 2:0.4/2:start
t  D bar size 0.8, f dot slide middle to 1
w  v all, v all put left at 1:right
W  V all, V all put left at 1:right
M  F bar, V all put start at 1:top, F bar put upper at 2:right/1:top
N  F bar, V left put upper at 1:top, F bar put lower at 2:lower
A  V all turn 180 back, F middle put right at 1:0.35
T  F top last, F bar put upper at 1:middle
H  F bar, F middle last, F bar put lower at 2:right/1:bottom meet 2:right
E  F bar, F top, F middle, F top put left at 1:bottom
F  E bar, E top, E middle
L  E bar, E bottom
Q  O all, D bar size 0.28 turn 50 put middle at 1:0.1
8  0 all size 0.5, 0 all size 0.48 put bottom at 1:top
9  6 all turn 180 back
6  9 all turn 180 back
C  c all size 1.9
"""
"""Every recipe: the letter, then its strokes."""

_NUMBER = r"-?\d+(?:\.\d+)?"
_SPOT = r"(\d+:[\w.]+(?:/\d+:[\w.]+)?)"
RECIPE_VERBS: dict[str, Callable[..., Piece]] = {
    rf"lead (\w+) to {_SPOT}": lambda piece, done, end, spot: piece.led(**{end: _spot(spot, done)}),
    rf"put (\w+) at {_SPOT}": lambda piece, done, place, spot: piece.put(place, _spot(spot, done)),
    r"slide (\w+) to (\d+)": lambda piece, done, place, n: piece.slid(place, _stroke(n, done)),
    rf"meet {_SPOT}": lambda piece, done, spot: piece.meeting(_spot(spot, done)),
    rf"size ({_NUMBER})": lambda piece, done, factor: piece.scaled(float(factor)),
    rf"tall ({_NUMBER}) of (\d+)": lambda piece, done, part, n: piece.scaled(
        float(part) * _tallness(_stroke(n, done)) / max(_tallness(piece), 1e-9)
    ),
    rf"turn ({_NUMBER})": lambda piece, done, degrees: piece.turned(float(degrees)),
    r"back\b": lambda piece, done: piece.backwards(),
}
"""What is done with a stroke: the words, and the method of `Piece`."""


def recipes(character: str | None = None) -> tuple[tuple[str, str], ...]:
    """Return the recipes as pairs (letter, its strokes); of one letter, or all."""
    lines = (line.split(maxsplit=1) for line in RECIPES.strip().splitlines())
    return tuple((made, how) for made, how in lines if character in (None, made))


def letters_needed(recipe: str) -> tuple[str, ...]:
    """Return the letters whose strokes a recipe takes."""
    return tuple(dict.fromkeys(item.split()[0] for item in recipe.split(",") if item.split()))


def make_letter(
    character: str, shelf: Shelf, transform: str | None = None, recipe: str | None = None
) -> Letter:
    """Make a letter from strokes of other letters, by the table of recipes.

    Args:
        character: The letter to make.
        shelf: The strokes to make it from; of one writer.
        transform: As in `Letter.compose`.
        recipe: One's own instead of the table's: "D bar, D bowl lead lower to 1:0.5".

    Raises:
        LetterError: No recipe, letters that are not on the shelf, or one that cannot be taken
            apart; says which.
        SettingError: A similarity is to lead a closed stroke.
    """
    if not isinstance(shelf, Shelf):
        raise LetterError(
            f"A letter is made from a Shelf, but got {kind_of(shelf)}; use Shelf.of(recordings)."
        )
    if not isinstance(character, str):
        raise LetterError(
            f"character is {character!r}, but must be the letter to make, such as 'P'."
        )
    if not isinstance(recipe, str | None):
        raise LetterError(
            f"recipe is {recipe!r}, but must be a line of strokes, such as 'D bar, D bowl'."
        )
    hows = [how for _, how in recipes(character)] if recipe is None else [recipe]
    if not hows:
        known = " ".join(dict.fromkeys(letter for letter, _ in recipes()))
        raise LetterError(
            f"There is no recipe for {character!r}; there are recipes for {known}. Give one: "
            "recipe='...'."
        )
    at_hand = [how for how in hows if set(letters_needed(how)) <= set(shelf.letters)]
    if not at_hand:
        wanted = ", or ".join(" and ".join(letters_needed(how)) for how in hows)
        have = ", ".join(shelf.letters)
        raise LetterError(
            f"{character!r} is made of {wanted}, but this shelf has {have}: put the missing ones "
            "on it."
        )
    refused: list[LetterError | SettingError] = []
    for how in at_hand:
        try:
            return Letter.compose(follow_recipe(how, shelf, transform))
        except (LetterError, SettingError) as error:
            refused.append(error)
    raise refused[0]


def follow_recipe(recipe: str, shelf: Shelf, transform: str | None = None) -> tuple[Piece, ...]:
    """Return the strokes of a recipe, each where it belongs.

    Raises:
        LetterError: A word that the recipe should not have, or a letter that lacks a stroke.
    """
    done: list[Piece] = []
    late: list[int] = []
    for item in recipe.split(","):
        words = item.split()
        if len(words) < 2:
            raise LetterError(
                "A stroke of a recipe is a letter and a role, such as 'D bar', but this is "
                f"{item!r}."
            )
        letter, role = words[:2]
        pieces = _transformed(strokes_in_role(role, shelf[letter]), transform, "alike" in words)
        rest = " ".join(word for word in words[2:] if word not in ("alike", "last"))
        if len(pieces) > 1 and rest:
            raise LetterError(
                f"{letter!r} has {len(pieces)} strokes, but {rest!r} is for one; name it by its "
                "role."
            )
        late += [len(done) + k for k in range(len(pieces)) if "last" in words]
        done += [_follow(piece, rest, done) for piece in pieces]
    return tuple(done[k] for k in sorted(range(len(done)), key=lambda k: k in late))


def _transformed(
    pieces: tuple[Piece, ...], transform: str | None, alike: bool
) -> tuple[Piece, ...]:
    """Return the strokes with the transformation given, or the recipe's."""
    any_goal = pieces[0].primitive.transformation.weights_fit_any_goal
    if transform is None and not (alike and any_goal):
        return pieces
    return tuple(piece.using(transform or "similarity") for piece in pieces)


def _follow(piece: Piece, words: str, done: list[Piece]) -> Piece:
    """Return one stroke after what the recipe does with it."""
    while words:
        for pattern, verb in RECIPE_VERBS.items():
            match = re.match(pattern, words)
            if match:
                piece = verb(piece, done, *match.groups())
                words = words[match.end() :].strip()
                break
        else:
            raise LetterError(
                f"A recipe cannot {words!r}; it can: lead END to SPOT, put PLACE at SPOT, slide "
                "PLACE to N, meet SPOT, size F, tall F of N, turn DEGREES, back, alike, last."
            )
    return piece


def _stroke(number: str, done: list[Piece]) -> Piece:
    """Return a stroke that is in its place already, counted from 1."""
    if not 1 <= int(number) <= len(done):
        raise LetterError(
            f"A recipe names stroke {number}, but so far it has {len(done)}; they are counted "
            "from 1."
        )
    return done[int(number) - 1]


def _tallness(piece: Piece) -> float:
    return float(np.ptp(piece.drawn.position[:, 1]))


def _spot(words: str, done: list[Piece]) -> Array:
    """Return a spot such as 1:0.5 or 2:right/1:bottom, shape (2,) [m]."""
    spots: list[Array] = []
    for each in words.split("/"):
        number, place = each.split(":")
        stroke, is_height = _stroke(number, done), re.fullmatch(_NUMBER, place)
        spots.append(stroke.height(float(place)) if is_height else stroke.at(place))
    return np.array([spots[0][0], spots[-1][1]])
