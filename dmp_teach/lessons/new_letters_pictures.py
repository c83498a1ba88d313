"""A new letter on its sheet between two hands, whose it is, and how fast the pen goes."""

from __future__ import annotations

import numpy as np

from dmp_teach.classroom import Affine, Drawing
from dmp_teach.lessons.drawing import axis, line, mark, plot
from dmp_teach.lessons.goals import CM
from dmp_teach.lessons.two_hands import BOWL, NewLetter, follow, learn_hands, speed_of
from dmp_teach.texts import gettext as _
from dmp_teach.trajectory import Array

BOX = [-0.05, -0.03, 0.14, 0.15]
# Two letters and a bowl side by side.
NEXT, BELOW = 0.105, 0.078
WIDE_BOX = [-0.015, -0.055, 0.33, 0.165]
MOST_DEGREES = 60.0


def draw_blind(shown: NewLetter, whose: int | None) -> Drawing:
    """Draw the D of both hands and the bowl that the robot made of one, unless it is hidden.

    Once it may be seen, the same bowl by the other rule stands beside it.
    """
    places = [NEXT * n * np.eye(2)[0] for n in range(3)]
    made = _("whose?") if whose is None else "DMP*"
    names = [_("hand 1"), _("hand 2"), made]
    letters = learn_hands().letters
    inks = [
        {"points": stroke.position + place, "kind": "hand"}
        for letter, place in zip(letters, places, strict=False)
        for stroke in letter.strokes
    ]
    tops = [letter.strokes[0].position[0] for letter in letters]
    tops.append(tops[0] + [0, 0.009])
    words = [_word(top + place, name) for top, place, name in zip(tops, places, names, strict=True)]
    lines = [shown.lifted[BOWL] + places[2]]
    if whose is not None:
        lines.append(shown.turned + places[2] - [0, BELOW])
        words.append(_word(lines[1][-1] - [0.01, 0.025], _("similarity")))
    return {
        "caption": _("On paper"),
        "note": _("dotted: by hand; blue: by the robot"),
        "title": _("A D by each of two hands, and the bowl that the robot made of one."),
        "box": WIDE_BOX,
        "extras": inks,
        "dots": words,
        "robot": lines,
    }


def draw_letter(made: NewLetter) -> Drawing:
    """Draw the new letter over the D of both hands, with a ring for each goal."""
    drawn = follow(made.third, str(made.values["way"]))
    count = 1 if made.third == "none" else 2
    strokes, goals = drawn[:-count], drawn[-count:]
    letters = learn_hands().letters
    inks = [{"points": s.position, "kind": "hand"} for each in letters for s in each.strokes]
    tops = [letter.strokes[0].position[0] for letter in letters]
    # The tops are nearer than the words are long.
    words = [_word(tops[0] - [0.02, 0], _("hand 1")), _word(tops[1], _("hand 2"))]
    names = [
        ("goal", _("bowl’s end"), _("bowl")),
        ("third", _("third end"), _("third")),
    ]
    rings = [_ring(goal, *name) for goal, name in zip(goals, names, strict=False)]
    return {
        "caption": _("On paper"),
        "note": _("dotted: both hands"),
        "title": _("The new letter, over the D of both hands."),
        "box": BOX,
        "extras": inks,
        "dots": words,
        "robot": strokes,
        "rings": rings,
    }


def _word(top: Array, label: str) -> Drawing:
    """Return a word above a stem whose top is at a place (2,) [m]."""
    return {"at": top[None] + [[-0.008, 0.013]], "kind": "word", "label": label}


def _ring(goal: Affine, knob: str, label: str, word: str) -> Drawing:
    """Return a ring that two knobs move [cm]; where they are 0 follows the other knobs."""
    own = [f"{knob}_x", f"{knob}_y"]
    home = Affine(goal.base, {name: term for name, term in goal.terms.items() if name not in own})
    ring: Drawing = {"home": home, "at": goal, "knobs": own, "scale": CM}
    return ring | {"label": label, "word": word}


def draw_whose(made: NewLetter | None) -> Drawing:
    """Draw how far the bowl is from that of each hand, by each rule; None hides it."""
    degrees = [[n, f"{n}°"] for n in range(0, int(MOST_DEGREES) + 1, 20)]
    drawn = plot(
        _("Whose bowl is it?"),
        axis(-6, MOST_DEGREES, _("difference"), ticks=degrees),
        axis(-0.7, 1.7, ticks=[[1, "DMP*"], [0, _("similarity")]]),
        _("after your bet") if made is None else _("at the left: most alike"),
    )
    rows = zip((1.0, 0.0), made.differences.values(), strict=True) if made else ()
    drawn["dots"] = [
        mark([min(each, MOST_DEGREES), height + lift], "robot", hand)
        for height, apart in rows
        for hand, each, lift in zip((_("hand 1"), _("hand 2")), apart, (0.16, -0.16), strict=True)
    ]
    return drawn


def draw_speed(made: NewLetter) -> Drawing:
    """Draw how fast the pen goes in one line, and with lifts."""
    lifted = NewLetter(made.values | {"way": "lifted"}).strokes
    lines = [line(speed_of(lifted), "quiet"), line(speed_of(made.strokes), "robot")]
    x, caption = axis(0, lifted[-1].t[-1], _("time [s]")), _("How fast the pen goes [cm/s]")
    return plot(caption, x, axis(0, 70), _("thin: with lifts"), lines=lines)
