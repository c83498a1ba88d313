"""The robot works beside the panel, which stays awake, and *Stop* is heard.

In a thread of its own; in a browser, which has none, in turns with all else.
"""

from __future__ import annotations

import asyncio
import sys
import threading
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor

from dmp_teach.robot import Slices, StepProgress, run_through

_ROBOT_THREAD = ThreadPoolExecutor(max_workers=1, thread_name_prefix="robot")
_ONE_AT_A_TIME = asyncio.Lock()
_HAS_THREADS = sys.platform != "emscripten"


class StopPressed(Exception):  # noqa: N818 (not an error)
    """*Stop* was pressed."""


class Job:
    """One piece of work, whose progress and end are told to the thread that started it.

    Args:
        work: Done here and now where no event loop runs.
        on_progress: Called with what the work yields.
        on_end: Called with the result or with the exception; again with what it raises itself.
        threads: Whether the work gets a thread.
    """

    def __init__(
        self,
        work: Slices[object],
        on_progress: StepProgress,
        on_end: Callable[[object], None],
        threads: bool = _HAS_THREADS,
    ):
        self._stop = threading.Event()
        self._on_progress = on_progress
        self._on_end = on_end
        loop = _find_running_loop()
        self._call = loop.call_soon_threadsafe if loop and threads else _call_now
        if loop is None:
            self._end(self._do_all(work))
        elif threads:
            future = _ROBOT_THREAD.submit(self._do_all, work)
            future.add_done_callback(lambda done: self._call(self._end, done.result()))
        else:
            # The loop itself keeps no task alive.
            self._task = loop.create_task(self._take_turns(work))

    def stop(self) -> None:
        """End the work at its next report; its result is dropped."""
        self._stop.set()

    def _do_all(self, work: Slices[object]) -> object:
        """Return the result of the work, or what it raised."""
        try:
            return run_through(work, self._report)
        except Exception as error:
            return error

    async def _take_turns(self, work: Slices[object]) -> None:
        """Do the work, and hear all else between two slices."""
        result: object
        async with _ONE_AT_A_TIME:
            try:
                while True:
                    self._report(*next(work))
                    await asyncio.sleep(0)
            except StopIteration as end:
                result = end.value
            except Exception as error:
                result = error
        self._end(result)

    def _report(self, step: str, fraction: float) -> None:
        """Pass progress on; raise StopPressed where *Stop* was pressed."""
        if self._stop.is_set():
            raise StopPressed
        self._call(self._on_progress, step, fraction)

    def _end(self, result: object) -> None:
        """Pass the result on, unless *Stop* was pressed since."""
        try:
            self._on_end(StopPressed() if self._stop.is_set() else result)
        except Exception as error:
            self._on_end(error)
            raise


def _call_now(callback: Callable[..., object], *values: object) -> None:
    """Call back here and now."""
    callback(*values)


def _find_running_loop() -> asyncio.AbstractEventLoop | None:
    """Return the kernel's event loop; None in a plain program."""
    try:
        return asyncio.get_running_loop()
    except RuntimeError:
        return None
