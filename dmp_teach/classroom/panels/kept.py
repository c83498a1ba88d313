"""What panels keep while the kernel lives, so that running a cell again loses nothing.

It is in memory alone: a restart, or `forget`, leaves nothing of it.
"""

from __future__ import annotations

from typing import Any

# Any: whatever a panel keeps, under names of its own.
_KEPT: dict[str, dict[str, Any]] = {}


def kept(key: str) -> dict[str, Any]:
    """Return the one dictionary of a key such as "pad w01", empty at first, to be filled."""
    return _KEPT.setdefault(key, {})


def forget(key: str) -> None:
    """Empty the dictionary of a key, for all who hold it."""
    kept(key).clear()


def forget_all(beginning: str) -> None:
    """Empty every dictionary whose key begins so."""
    for key in [key for key in _KEPT if key.startswith(beginning)]:
        forget(key)
