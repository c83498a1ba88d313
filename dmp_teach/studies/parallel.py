"""How a study is run: piece by piece, here or on anybody's executor, with a bar that says how far it is.

A piece of work is a function of this package and one value, so that it can be sent to another process or another
computer. Pieces are coarse (a stroke with all its widths), and results come back in the order of the pieces.
"""

from __future__ import annotations

import sys
import threading
import warnings
from collections.abc import Callable, Iterable
from concurrent.futures import Executor
from typing import Any, TextIO

from dmp_teach.errors import SettingWarning

Progress = Callable[[int, int], Any]


def run(
    work: Callable,
    pieces: Iterable,
    executor: Executor | None = None,
    progress: Progress | None = None,
) -> list:
    """`work` done on every piece.

    Args:
        work: A function that can be pickled.
        pieces: What it is called with, one at a time.
        executor: Any `concurrent.futures.Executor`; None does the pieces one after another, here.
        progress: Called as `progress(done, total)` after every piece, in this thread. It may raise to stop.

    Returns:
        The results, in the order of the pieces, whatever order they were done in.
    """
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", SettingWarning)  # gaps between kernels are what is studied
        return _run(work, list(pieces), executor, progress or _silent)


def _run(work: Callable, pieces: list, executor: Executor | None, report: Progress) -> list:
    """The results in order; what is still waiting is called off when something goes wrong."""
    report(0, len(pieces))
    results = []
    futures = (
        None if executor is None else [executor.submit(_quietly, work, piece) for piece in pieces]
    )
    try:
        for number, piece in enumerate(pieces):
            results.append(work(piece) if futures is None else futures[number].result())
            report(len(results), len(pieces))
    except BaseException:
        for future in futures or ():
            future.cancel()
        raise
    return results


def _quietly(work: Callable, piece: Any) -> Any:
    """`work` on a piece, without our warnings where this is another process: filters are not safe in threads."""
    if threading.current_thread() is not threading.main_thread():
        return work(piece)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", SettingWarning)
        return work(piece)


class ProgressBar:
    """A bar of plain text that is drawn again in place, in a terminal and in a notebook alike.

    Args:
        words: What is being done.
        stream: Where it is written; standard output unless given.
        width: How many signs wide the bar is.
    """

    def __init__(self, words: str = "", stream: TextIO | None = None, width: int = 30) -> None:
        self.words, self.width, self._stream = words, width, stream

    def __call__(self, done: int, total: int) -> None:
        """Draw the bar; the last call ends the line."""
        stream = sys.stdout if self._stream is None else self._stream
        part = done / total if total else 1.0
        full = round(part * self.width)
        bar = "█" * full + "░" * (self.width - full)
        head = f"{self.words} " if self.words else ""
        stream.write(f"\r{head}{bar} {done}/{total}" + ("\n" if done >= total else ""))
        stream.flush()


def _silent(done: int, total: int) -> None:
    """Say nothing."""
