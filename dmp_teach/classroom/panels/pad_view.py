"""What a pad shows of the attempt on its sheet: ink, message, rows, and the attempts before."""

from __future__ import annotations

from typing import Any, cast

import numpy as np
import traitlets

from dmp_teach.classroom.panels import pad_messages
from dmp_teach.classroom.panels.attempts import Attempt, Attempts, list_rows
from dmp_teach.classroom.panels.messages import Message
from dmp_teach.classroom.panels.pen_lift import PenLift
from dmp_teach.classroom.panels.robot_panel import pack_points
from dmp_teach.classroom.panels.sheets import fit_pad_sheet
from dmp_teach.classroom.panels.still import Still
from dmp_teach.errors import RecordingError
from dmp_teach.ink import Recording
from dmp_teach.scoring import Fault
from dmp_teach.texts import gettext as _
from dmp_teach.trajectory import Array

NEAR_CHARACTERS = ["", "a", "e", "i", "m", "D", "P"]
# All attempts are kept.
MAX_SHOWN_ATTEMPTS = 6


class PadTraits(traitlets.HasTraits):
    """What a pad shows, beside what every panel does; `character` is "" for any letter."""

    near = traitlets.List(NEAR_CHARACTERS).tag(sync=True)
    character = traitlets.Unicode().tag(sync=True)
    # "an a", or "a letter".
    wanted = traitlets.Unicode().tag(sync=True)
    lines: traitlets.List[float] = traitlets.List().tag(sync=True)
    model = traitlets.Bytes().tag(sync=True)
    model_times: traitlets.List[list[float]] = traitlets.List().tag(sync=True)
    robot_counts: traitlets.List[int] = traitlets.List().tag(sync=True)
    ink = traitlets.Bytes().tag(sync=True)
    caught = traitlets.Unicode().tag(sync=True)
    parts: traitlets.List[dict[str, object]] = traitlets.List().tag(sync=True)
    tries: traitlets.List[dict[str, object]] = traitlets.List().tag(sync=True)
    tried = traitlets.Bytes().tag(sync=True)
    shift: traitlets.List[float] = traitlets.List().tag(sync=True)
    unfinished = traitlets.Bool(False).tag(sync=True)
    kept = traitlets.Unicode().tag(sync=True)
    lift = traitlets.Dict().tag(sync=True)
    hand = traitlets.Unicode().tag(sync=True)


def describe_lift(
    now: Attempt | None, character: str, is_done: bool, lift: PenLift
) -> dict[str, object]:
    """Return the traits of a pad that are known as soon as the last stroke is judged.

    `is_done` says that somebody takes the letter as complete, whatever is missing.
    """
    ink = now.ink if now else ()
    unfinished = now is not None and not is_done and not now.is_whole
    shown: dict[str, object] = {
        "ink": pack_points(ink),
        "counts": [len(stroke) for stroke in ink],
        "unfinished": unfinished,
        "lift": lift.describe(now.strokes if now else ()),
        # How all of it lies on the model is known with the score.
        "shift": [],
    }
    if lift.missed is not None:
        shown["message"] = pad_messages.describe_missed_stroke(lift.missed)
    elif now is not None and unfinished:
        missing, done = now.missing_strokes, len(ink)
        shown["message"] = (
            pad_messages.ask_for_next_stroke(done, done + missing, character)
            if missing
            else pad_messages.ask_to_write_on(character)
        )
    return shown


def describe_pad(
    attempts: Attempts, model: Recording | None, is_done: bool, lift: PenLift
) -> dict[str, object]:
    """Return the traits of a pad that follow from what is on its sheet; `is_done` as above."""
    now, character = attempts.now, str(model.character) if model else ""
    at_the_lift = describe_lift(now, character, is_done, lift)
    unfinished = bool(at_the_lift["unfinished"])
    scored = attempts.scored(model, with_sheet=not unfinished)
    shown = scored[-MAX_SHOWN_ATTEMPTS:]
    message, parts = cast(Message, at_the_lift.get("message")), list[dict[str, object]]()
    if not unfinished:
        before = [attempt for attempt in scored if attempt is not now]
        message, parts = _describe_attempt_now(now, before, character, lift.missed)
        robots = lift.find_robots(now.strokes if now else ())
        message = pad_messages.describe_help(robots[0]) if robots else message
    said = message["text"] + message["strong"] if now else ""
    shift: list[float] = []
    if now is not None and not unfinished:
        shift = [0.0, 0.0] if now.score is None else now.score.shift.tolist()
    return at_the_lift | {
        "message": message,
        "parts": parts,
        "title": pad_messages.describe_sheet(character, len(now.ink) if now else 0, said),
        "tries": list_rows(shown, len(scored) - len(shown) + 1),
        "tried": pack_points([stroke for attempt in shown for stroke in attempt.aligned]),
        "shift": shift,
    }


def describe_empty_pad(model: Recording | None, character: str) -> Still:
    """Return a pad's still picture: the robot's own letter, and none of a pupil's."""
    strokes = model.strokes() if model else ()
    title = _("The robot’s own {letter}.").format(letter=character) if model else ""
    message = pad_messages.invite_to_write(character)
    return Still(title, message, fit_pad_sheet(strokes), robot=strokes)


def _describe_attempt_now(
    now: Attempt | None, before: list[Attempt], character: str, missed: Fault | None
) -> tuple[Message, list[dict[str, object]]]:
    """Return the message on what is on the sheet, and a row for each part of its score.

    `missed` is what is wrong with the last stroke.
    """
    if now is None:
        return pad_messages.invite_to_write(character), []
    if now.score is None:
        if character:
            return pad_messages.describe_dot(character), []
        return pad_messages.describe_learned_ink(now.letter.error), []
    other = now.looks_like
    row: dict[str, object] = {"name": _("Shape"), "level": 0, "word": _("far")}
    is_doubted = other is not None or bool(now.score.matching.missing)
    if is_doubted and missed is not None and missed.name == "place":
        return pad_messages.describe_missed_stroke(missed), [row | {"reason": missed.reason}]
    if other is not None:
        words = _("looks like {letter}").format(letter=pad_messages.add_article(other))
        reason = words if other else _("no letter yet")
        message = pad_messages.describe_other_letter(other, character, now.score.distance)
        return message, [row | {"reason": reason}]
    previous = before[-1].score if before else None
    rows: list[dict[str, object]] = [
        {"name": _(part.name), "level": part.level, "word": _(part.word), "reason": part.reason}
        for part in now.score.parts
    ]
    return pad_messages.describe_attempt(now.score, previous, now.is_coarse), rows


# Any: JSON from the browser.
def unpack_stroke(
    message: dict[str, Any], buffers: list[memoryview], answered: int
) -> tuple[Array, bool, int]:
    """Return a stroke of the browser as `Pad.add_stroke` takes it.

    Its points are float64 rows t [s], x, y [m], pressure.

    Raises:
        RecordingError: It came before, or not whole.
    """
    if type(message.get("n")) is int and message["n"] <= answered:
        raise RecordingError(_("A stroke came twice, or too late, and was left out."))
    content = b"".join(map(bytes, buffers))
    if not content or len(content) % 32:
        raise RecordingError(_("A stroke came in pieces and was left out: write it again."))
    outside = message.get("outside")
    rows = np.frombuffer(content, "<f8").reshape(-1, 4)
    return rows, message.get("pointer") == "pen", outside if type(outside) is int else 0
