"""What a notebook keeps of our panels and of our small pictures of ink when it is saved: nothing that was written.

Figures that somebody draws of ink, and numbers that are printed, are outputs like any other, and stay.

JupyterLab, as our launcher starts it, keeps the state of widgets in a saved notebook, so that a panel whose kernel has
ended says how to wake it. `without_ink` runs in the server before a notebook is written, whatever the browser sends.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from dmp_teach.classroom import RESTING
from dmp_teach.ink import MARK

_SVG = "image/svg+xml"


def without_ink(model: dict[str, Any], **_: Any) -> None:
    """Take the state of our panels, and our pictures of ink, out of a notebook that is about to be saved.

    Of a panel its name and the sentence of `resting.js` stay; below a cell the text beside a picture stays.

    Args:
        model: What Jupyter is about to save; a file that is no notebook stays as it is.
    """
    if model.get("type") != "notebook":
        return
    for each in _dicts(model.get("content")):
        state = each.get("state")
        if isinstance(state, dict) and str(state.get("_anywidget_id", "")).startswith("dmp_teach."):
            each["state"] = {name: state[name] for name in state if name.startswith("_")}
            each["state"].update(_esm=RESTING, _css="")
            each["buffers"] = []
        for name in (_SVG, "svg"):  # as notebooks of format 3 have it
            if MARK in "".join(_words(each.get(name))):
                del each[name]


def _dicts(value: Any) -> Iterator[dict[str, Any]]:
    """Every dictionary within a value, the outer ones first."""
    if isinstance(value, dict):
        yield value
    if isinstance(value, dict | list):
        for inner in list(value.values() if isinstance(value, dict) else value):
            yield from _dicts(inner)


def _words(value: Any) -> list[str]:
    """A text as Jupyter has it: in one piece, or a line each."""
    return [str(each) for each in value] if isinstance(value, list) else [str(value)]
