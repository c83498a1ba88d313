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
from typing import Any

from dmp_teach.errors import SettingError, SettingWarning, kind_of
from dmp_teach.progress import Progress, progress_bar, reported, reporter

__all__ = ["Progress", "progress_bar", "run"]

# Without warnings about settings.
_quiet = partial(warnings.catch_warnings, action="ignore", category=SettingWarning)


def run(
    work: Callable,
    pieces: Iterable,
    executor: Executor | None = None,
    progress: Progress | None = None,
    words: str = "",
) -> list:
    """Return `work` (a function that can be pickled) of every piece, in the order of the pieces.

    What still waits is cancelled when a piece raises. Warnings about settings are silenced: gaps
    between kernels are what is studied. `progress(done, total)` is called in this thread; it may
    raise to stop. Without one, a bar with `words` comes after a second.

    Raises:
        SettingError: The executor cannot be given work, or the progress cannot be called.
    """
    if executor is not None and not hasattr(executor, "submit"):
        raise SettingError(f"executor is {kind_of(executor)}, but must be an Executor, or None.")
    report = reporter(progress, words)
    pieces = list(pieces)
    results: list = []
    with _quiet(), reported():
        futures = [] if executor is None else [executor.submit(_do, work, each) for each in pieces]
        try:
            for number in range(len(pieces) + 1):
                report(number, len(pieces))
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
