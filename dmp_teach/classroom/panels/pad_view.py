"""What a pad shows of the attempt on its sheet: ink, message, rows, and the attempts before."""

from __future__ import annotations

from typing import Any

import numpy as np

from dmp_teach.classroom.panels import messages
from dmp_teach.classroom.panels.attempts import Attempt, Attempts, list_rows
from dmp_teach.classroom.panels.pen_lift import PenLift
from dmp_teach.classroom.panels.robot_panel import pack_points
from dmp_teach.classroom.panels.sheets import fit_pad_sheet
from dmp_teach.classroom.panels.still import Still
from dmp_teach.errors import RecordingError
from dmp_teach.ink import Recording
from dmp_teach.texts import gettext as _
from dmp_teach.trajectory import Array

# All attempts are kept.
MAX_SHOWN_ATTEMPTS = 6


def describe_pad(
    attempts: Attempts, character: str, is_done: bool, lift: PenLift
) -> dict[str, object]:
    """Return the traits of a pad that follow from what is on its sheet.

    `is_done` says that a letter with fewer strokes than the robot's is complete.
    """
    now = attempts.now
    ink = now.ink if now else ()
    unfinished = now is not None and now.missing_strokes > 0 and not is_done
    scored = attempts.scored(character, with_sheet=not unfinished)
    before = [attempt for attempt in scored if attempt is not now]
    message, parts = _describe_attempt_now(now, before, character, unfinished)
    robots = lift.find_robots(now.strokes if now else ())
    if unfinished and lift.verdict is not None and lift.verdict.fault is not None:
        message = messages.describe_missed_stroke(lift.verdict.fault)
    elif robots and not unfinished:
        message = messages.describe_help(robots[0])
    said = message["text"] + message["strong"] if now else ""
    shown = scored[-MAX_SHOWN_ATTEMPTS:]
    shift = [0.0, 0.0]
    if now is not None and now in scored and now.score is not None:
        shift = now.score.shift.tolist()
    return {
        "ink": pack_points(ink),
        "counts": [len(stroke) for stroke in ink],
        "unfinished": unfinished,
        "message": message,
        "parts": parts,
        "title": messages.describe_sheet(character, len(ink), said),
        "tries": list_rows(shown, len(scored) - len(shown) + 1),
        "tried": pack_points([stroke for attempt in shown for stroke in attempt.aligned]),
        "shift": shift,
        "lift": lift.describe(now.strokes if now else ()),
    }


def describe_empty_pad(model: Recording | None, character: str) -> Still:
    """Return a pad's still picture: the robot's own letter, and none of a pupil's."""
    strokes = model.strokes() if model else ()
    title = _("The robot’s own {letter}.").format(letter=character) if model else ""
    message = messages.invite_to_write(character)
    return Still(title, message, fit_pad_sheet(strokes), robot=strokes)


def _describe_attempt_now(
    now: Attempt | None, before: list[Attempt], character: str, unfinished: bool
) -> tuple[messages.Message, list[dict[str, object]]]:
    """Return the message on what is on the sheet, and a row for each part of its score."""
    if now is None:
        return messages.invite_to_write(character), []
    if unfinished:
        done = len(now.ink)
        return messages.ask_for_next_stroke(done, done + now.missing_strokes, character), []
    if now.score is None:
        if character:
            return messages.describe_dot(character), []
        return messages.describe_learned_ink(now.letter.error), []
    other = now.looks_like
    if other is not None:
        words = _("looks like {letter}").format(letter=messages.add_article(other))
        reason = words if other else _("no letter yet")
        row: dict[str, object] = {"name": _("Shape"), "level": 0, "word": _("far")}
        message = messages.describe_other_letter(other, character, now.score.distance)
        return message, [row | {"reason": reason}]
    previous = before[-1].score if before else None
    rows: list[dict[str, object]] = [
        {"name": _(part.name), "level": part.level, "word": _(part.word), "reason": part.reason}
        for part in now.score.parts
    ]
    return messages.describe_attempt(now.score, previous, now.is_coarse), rows


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
