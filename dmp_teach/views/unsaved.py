"""A widget of which no program saves in a notebook what a pupil has written, nor a pseudonym.

JupyterLab, nbclient, papermill and others may keep in a notebook what Jupyter knows of a widget.
Of these it knows the script, the look, and the traits named in `_open`; all traits reach the
browser by messages, which nobody keeps (`told.js`).
"""

from __future__ import annotations

import json
from collections.abc import Iterable
from typing import Any, ClassVar

import anywidget
import traitlets

from dmp_teach.texts import javascript_texts

_OF_EVERY_WIDGET = frozenset(anywidget.AnyWidget.class_trait_names(sync=True))


class UnsavedWidget(anywidget.AnyWidget):
    """The base of every widget of ours; its script exports `told(render)`.

    In `_open` are traits that the browser sets, or that other widgets may be linked with; no ink
    and no name may be in them.
    """

    _open: ClassVar[tuple[str, ...]] = ()

    texts = traitlets.Dict(read_only=True).tag(sync=True)

    # Any: values of traits.
    def __init__(self, **traits: Any) -> None:
        super().__init__(**traits)
        self.on_msg(self._tell_all)

    @traitlets.default("texts")
    def _find_texts(self) -> dict[str, object]:
        """Return the script's texts in the language that is spoken now."""
        return javascript_texts()

    def open(self) -> None:
        """Open the way to the browser, and send it the traits."""
        super().open()
        self.send_state()

    # Any, here and below: as in the base class.
    def get_state(
        self, key: str | Iterable[str] | None = None, drop_defaults: bool = False
    ) -> dict[str, Any]:
        """Return of the traits those that a program may save."""
        return super().get_state(filter(self._is_open, self._names(key)), drop_defaults)

    def send_state(self, key: str | Iterable[str] | None = None) -> None:
        """Send traits, or all of them, to all who see the widget."""
        names = self._names(key)
        # ipywidgets looks through all traits even where there is nothing to send.
        if opened := [name for name in names if self._is_open(name)]:
            super().send_state(opened)
        self._tell(names, is_whole=key is None)

    def _names(self, key: str | Iterable[str] | None) -> list[str]:
        """Return the names of traits that ipywidgets means."""
        if key is None:
            return list(self.keys)
        return [key] if isinstance(key, str) else list(key)

    def _is_open(self, name: str) -> bool:
        """Return whether a program may save a trait."""
        return name.startswith("_") or name in _OF_EVERY_WIDGET or name in self._open

    def _tell(self, names: list[str], is_whole: bool, asker: float | None = None) -> None:
        """Send traits by a message, to all or to who has asked."""
        ours = [name for name in names if name in self._open or not self._is_open(name)]
        if not ours:
            return
        told = super().get_state(ours)
        # What was sent last; else a value that the browser has set would not be sent back.
        self._property_lock.update((n, v) for n, v in told.items() if n in self._property_lock)
        buffers: list[bytes] = []

        def take(value: bytes) -> dict[str, int]:
            buffers.append(value)
            return {"buffer": len(buffers) - 1}

        text = json.dumps(told, default=take)
        message = {"kind": "traits", "json": text, "isWhole": is_whole, "asker": asker}
        if "answered" in told and "asked" in self._open:
            # For another window of the same notebook, which has not turned them.
            message["knobs"] = super().get_state(self._open)
        self.send(message, buffers)

    def _tell_all(self, _widget: object, message: dict[str, Any], _buffers: object) -> None:
        """Send all traits to who asks."""
        if message.get("kind") == "traits":
            self._tell(self.keys, True, message.get("asker"))
