"""Remove ink from notebooks that are saved: the state of panels and the small pictures of ink.

JupyterLab, as our launcher starts it, keeps the state of widgets in a saved notebook, so that a
panel whose kernel has ended says how to wake it. `without_ink` runs in the server before a
notebook is written, whatever the browser sends. Figures of ink and printed numbers stay.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from dmp_teach.classroom import RESTING_SCRIPT
from dmp_teach.ink import INK_CLASS


def without_ink(model: dict[str, Any], **_: Any) -> None:
    """Remove the state of our panels and our pictures of ink from a notebook, in place.

    The name of a panel and the sentence of `resting.js` stay, and so does the text beside a
    picture.

    Args:
        model: Jupyter's contents model that is about to be saved; only notebooks are changed.
    """
    if model.get("type") != "notebook":
        return
    for each in _dicts(model.get("content")):
        state = each.get("state")
        if isinstance(state, dict) and str(state.get("_anywidget_id", "")).startswith("dmp_teach."):
            each["state"] = {name: state[name] for name in state if name.startswith("_")}
            each["state"].update(_esm=RESTING_SCRIPT, _css="")
            each["buffers"] = []
        # Notebooks of format 3 say "svg".
        for name in ("image/svg+xml", "svg"):
            if INK_CLASS in "".join(_words(each.get(name))):
                del each[name]


def _dicts(value: Any) -> Iterator[dict[str, Any]]:
    """Yield every dictionary within a value, the outer ones first."""
    if isinstance(value, dict):
        yield value
    if isinstance(value, dict | list):
        for inner in list(value.values() if isinstance(value, dict) else value):
            yield from _dicts(inner)


def _words(value: Any) -> list[str]:
    """Return the lines of a text, which Jupyter stores as one string or as several."""
    return [str(each) for each in value] if isinstance(value, list) else [str(value)]
