"""The robot works in a thread of its own, so that the panel stays awake and *Stop* is heard."""

from __future__ import annotations

import asyncio
import threading
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import Any

_ROBOT = ThreadPoolExecutor(max_workers=1, thread_name_prefix="robot")


class StopPressed(Exception):  # noqa: N818 (not an error)
    """Somebody pressed *Stop*."""


class Job:
    """One piece of work, its progress and its end, told to the thread that asked.

    Args:
        work: Called in the robot's thread with `report(step, fraction)`; what it returns is the result.
        on_progress: Called with the step's name and the fraction of it that is done, 0 to 1.
        on_end: Called once, with the result or with the exception.
    """

    def __init__(
        self,
        work: Callable[[Callable[[str, float], None]], Any],
        on_progress: Callable[[str, float], None],
        on_end: Callable[[Any], None],
    ):
        self._stop = threading.Event()
        self._on_progress, self._on_end = on_progress, on_end
        self._loop = _running_loop()
        future = _ROBOT.submit(self._run, work)
        if self._loop is None:
            self._on_end(future.result())
        else:
            future.add_done_callback(lambda done: self._tell(self._ended, done.result()))

    def stop(self) -> None:
        """End the work at its next report; nobody hears what came of it."""
        self._stop.set()

    def _ended(self, result: Any) -> None:
        """Pass the result on, unless somebody has pressed *Stop* since."""
        self._on_end(StopPressed() if self._stop.is_set() else result)

    def _run(self, work: Callable[[Callable[[str, float], None]], Any]) -> Any:
        """The result of the work, or what it raised: a thread has nobody else to tell."""
        try:
            return work(self._report)
        except Exception as error:
            return error

    def _report(self, step: str, fraction: float) -> None:
        """Pass progress on; raise where somebody pressed *Stop*."""
        if self._stop.is_set():
            raise StopPressed
        self._tell(self._on_progress, step, fraction)

    def _tell(self, hear: Callable[..., None], *values: Any) -> None:
        """Call `hear` in the thread that asked; without an event loop, here and now."""
        if self._loop is None:
            hear(*values)
        else:
            self._loop.call_soon_threadsafe(hear, *values)


def _running_loop() -> asyncio.AbstractEventLoop | None:
    """The kernel's event loop; None in a plain program."""
    try:
        return asyncio.get_running_loop()
    except RuntimeError:
        return None
