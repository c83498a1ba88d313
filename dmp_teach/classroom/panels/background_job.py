"""The robot works in a thread of its own, so that the panel stays awake and *Stop* is heard."""

from __future__ import annotations

import asyncio
import threading
from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor

Report = Callable[[str, float], None]
"""Takes the name of a step, and the fraction of it that is done, 0 to 1."""

_ROBOT_THREAD = ThreadPoolExecutor(max_workers=1, thread_name_prefix="robot")


class StopPressed(Exception):  # noqa: N818 (not an error)
    """*Stop* was pressed."""


class Job:
    """One piece of work, whose progress and end are told to the thread that started it.

    Args:
        work: Called in the robot's thread with `report`; what it returns is the result.
        on_progress: Called with what `report` is called with.
        on_end: Called once, with the result or with the exception.
    """

    def __init__(
        self,
        work: Callable[[Report], object],
        on_progress: Report,
        on_end: Callable[[object], None],
    ):
        self._stop = threading.Event()
        self._on_progress = on_progress
        self._on_end = on_end
        self._loop = _find_running_loop()
        future = _ROBOT_THREAD.submit(work, self._report)
        if self._loop is None:
            self._pass_on(future)
        else:
            future.add_done_callback(lambda done: self._call(self._pass_on, done))

    def stop(self) -> None:
        """End the work at its next report; its result is dropped."""
        self._stop.set()

    def _pass_on(self, done: Future[object]) -> None:
        """Pass on the result of the work or what it raised, unless *Stop* was pressed since."""
        result = done.exception() or done.result()
        self._on_end(StopPressed() if self._stop.is_set() else result)

    def _report(self, step: str, fraction: float) -> None:
        """Pass progress on; raise StopPressed where *Stop* was pressed."""
        if self._stop.is_set():
            raise StopPressed
        self._call(self._on_progress, step, fraction)

    def _call(self, callback: Callable[..., None], *values: object) -> None:
        """Call back in the thread that started the job; without an event loop, here and now."""
        if self._loop is None:
            callback(*values)
        else:
            self._loop.call_soon_threadsafe(callback, *values)


def _find_running_loop() -> asyncio.AbstractEventLoop | None:
    """Return the kernel's event loop; None in a plain program."""
    try:
        return asyncio.get_running_loop()
    except RuntimeError:
        return None
