"""Progress: what takes longer than a second says so, in a terminal and in a notebook alike."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from time import monotonic
from typing import Any, TextIO

from dmp_teach.errors import SettingError, kind_of

Progress = Callable[[int, int], object]
StepProgress = Callable[[str, float], object]
# Work that takes no longer shows no bar [s].
PATIENCE = 1.0
_is_reported: ContextVar[bool] = ContextVar("_is_reported", default=False)


def progress_bar(
    words: str = "", stream: TextIO | None = None, width: int | None = None, patience: float = 0.0
) -> Progress:
    """Return a function for `progress=` that draws a bar, in a terminal and in a notebook alike.

    Args:
        words: What is being done.
        stream: Where the bar is written; standard error unless given.
        width: Of the whole line [characters].
        patience: How long nothing is drawn [s]. Such a bar is gone when all is done, and is not
            written into files.
    """
    # Any: tqdm has no types.
    bar: Any = None
    began = monotonic()

    def report(done: int, total: int) -> None:
        nonlocal bar
        if bar is None or done == 0:
            if patience and (done >= total or monotonic() - began < patience):
                return
            from tqdm.auto import tqdm  # noqa: PLC0415 (it takes longer than most of what is done)

            stays = {"disable": None, "leave": False} if patience else {}
            kinds = {"desc": words or None, "file": stream, "ncols": width, **stays}
            # Without the thread that tqdm would watch it from: a browser has none.
            unwatched = type("Bar", (tqdm,), {"monitor_interval": 0})
            bar = unwatched(total=total, initial=done, miniters=1, **kinds)
        bar.update(done - bar.n)
        if done >= total:
            bar.close()

    return report


def reporter(progress: Progress | None, words: str = "") -> Progress:
    """Return `progress`, or a bar that comes after a second; within other work, nothing.

    Raises:
        SettingError: It cannot be called.
    """
    if progress is None:
        within = _is_reported.get()
        return (lambda done, total: None) if within else progress_bar(words, patience=PATIENCE)
    if not callable(progress):
        raise SettingError(f"progress is {kind_of(progress)}, but must be a function, or None.")
    return progress


def step_reporter(progress: StepProgress | None, words: str) -> StepProgress:
    """Return `progress`, or a bar as `reporter` does, which begins anew with every step."""
    if progress is not None:
        return progress
    report = reporter(None, words)
    return lambda step, fraction: report(round(100 * fraction), 100)


@contextmanager
def reported() -> Iterator[None]:
    """Keep work within other work from drawing bars of its own."""
    token = _is_reported.set(True)
    try:
        yield
    finally:
        _is_reported.reset(token)
