"""Run the pieces of a study, here or on any executor, and report progress.

A piece of work is a function of this package and one value, so that it can be sent to another
process or another computer. Pieces are coarse (a stroke with all its widths).
"""

from __future__ import annotations

import threading
import warnings
from collections.abc import Callable, Iterable
from concurrent.futures import Executor
from functools import partial
from typing import Any, TextIO

from tqdm.auto import tqdm

from dmp_teach.errors import SettingError, SettingWarning, kind_of

Progress = Callable[[int, int], object]
# Without warnings about settings.
_quiet = partial(warnings.catch_warnings, action="ignore", category=SettingWarning)


def run(
    work: Callable,
    pieces: Iterable,
    executor: Executor | None = None,
    progress: Progress | None = None,
) -> list:
    """Return `work` (a function that can be pickled) of every piece, in the order of the pieces.

    What still waits is cancelled when a piece raises. Warnings about settings are silenced: gaps
    between kernels are what is studied. `progress(done, total)` is called in this thread; it may
    raise to stop.

    Raises:
        SettingError: The executor cannot be given work, or the progress cannot be called.
    """
    if executor is not None and not hasattr(executor, "submit"):
        raise SettingError(f"executor is {kind_of(executor)}, but must be an Executor, or None.")
    if progress is not None and not callable(progress):
        raise SettingError(f"progress is {kind_of(progress)}, but must be a function, or None.")
    pieces = list(pieces)
    results: list = []
    with _quiet():
        futures = [] if executor is None else [executor.submit(_do, work, each) for each in pieces]
        try:
            for number in range(len(pieces) + 1):
                if progress is not None:
                    progress(number, len(pieces))
                if number < len(pieces):
                    done = futures[number].result() if futures else work(pieces[number])
                    results.append(done)
        except BaseException:
            for future in futures:
                future.cancel()
            raise
    return results


# Any: whatever a study works on, and what it finds.
def _do(work: Callable, piece: Any) -> Any:
    """Return `work(piece)` on an executor."""
    # Filters are not safe in threads, which share those of the main thread.
    if threading.current_thread() is not threading.main_thread():
        return work(piece)
    with _quiet():
        return work(piece)


def progress_bar(
    words: str = "", stream: TextIO | None = None, width: int | None = None
) -> Progress:
    """Return a function for `progress=` that draws a bar, in a terminal and in a notebook alike.

    Args:
        words: What is being done.
        stream: Where the bar is written; standard error unless given.
        width: Of the whole line [characters].
    """
    # Any: tqdm has no types.
    bar: Any = None

    def report(done: int, total: int) -> None:
        nonlocal bar
        if bar is None or done == 0:
            bar = tqdm(desc=words or None, total=total, file=stream, ncols=width)
        bar.update(done - bar.n)
        if done >= total:
            bar.close()

    return report
