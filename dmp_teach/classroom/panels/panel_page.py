"""A panel as a page of its own: what the browser draws lives on, and the rest is seen and rests."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from dmp_teach.files import join_modules, write_whole
from dmp_teach.views import render_page

# Any: JSON for the browser.
_NOBODY_ANSWERS: dict[str, Any] = {"asked": 0, "answered": 0, "drawing": 0}
_NO_ROBOT: dict[str, Any] = {"work": {"state": "idle"}, "older": False, "scene": None}


class PanelPage:
    """What a panel has that can be a page: `html`.

    A subclass has the script `_page_script`, the names of the traits that the page may hold,
    `_page_traits`, and in `_describe_page` what else, or otherwise, it shows.
    """

    _css: str
    title: str
    _page_script: Path
    _page_traits: tuple[str, ...]

    def html(self, path: str | Path) -> Path:
        """Write the panel as one file that opens from disk, without network or kernel.

        Goals, bets and all else that the browser draws follow the hand; what needs a kernel is
        seen and disabled. Nothing that was written or opened in the browser is in it, nor a
        pseudonym; the recording of `explore(recording)`, which was chosen by name, is.

        Args:
            path: Where to, ending with .html; its folder must exist.

        Returns:
            The path.

        Raises:
            PathError: A path that cannot be written; what was there before stays.
            RecordingError: The letter that is seen was opened in the browser.
        """
        state = {name: getattr(self, name) for name in self._page_traits}
        state |= _NOBODY_ANSWERS | _NO_ROBOT | self._describe_page()
        script = join_modules(self._page_script)
        return write_whole(
            path, render_page(self.title, self._css, script, state, self.title), ".html"
        )

    def _describe_page(self) -> dict[str, object]:
        """Return what the page shows beside the traits, or instead of them."""
        return {}
