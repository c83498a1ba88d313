"""How it is measured: turns taken one after the other, medians, and quartiles of what was seen."""

import tracemalloc
from collections.abc import Callable
from dataclasses import dataclass
from time import process_time
from typing import Any

import numpy as np

from dmp_teach.trajectory import Array


@dataclass(frozen=True)
class Times:
    """The seconds of processor time that one thing took, turn by turn, shape (turns,)."""

    seconds: Array

    @property
    def median(self) -> float:
        """Of all turns [s]."""
        return float(np.median(self.seconds))

    def times_longer_than(self, other: "Times") -> tuple[float, float, float]:
        """The ratio of the two medians, and the quartiles of the ratios turn by turn."""
        low, high = np.percentile(self.seconds / other.seconds, [25, 75])
        return self.median / other.median, float(low), float(high)


def in_turns(
    tasks: dict[str, Callable[[], Any]], turns: int, turn: float = 0.02
) -> dict[str, Times]:
    """Measure several things fairly: each turn every task runs for about `turn` [s], one task after
    the other.

    A short task is repeated within its turn, so that neither the clock nor the caches, which the
    task before it filled, decide. Processor time is measured, not the clock on the wall: what else
    the computer does is no part of it, and slows all of them alike where it fills the caches.
    """
    repeats = {}
    for name, task in tasks.items():
        task()
        began = process_time()
        task()
        repeats[name] = max(1, int(turn / (process_time() - began)))
    seconds: dict[str, list[float]] = {name: [] for name in tasks}
    for _ in range(turns):
        for name, task in tasks.items():
            began = process_time()
            for _ in range(repeats[name]):
                task()
            seconds[name].append((process_time() - began) / repeats[name])
    return {name: Times(np.array(each)) for name, each in seconds.items()}


def exponent(sizes: list[int], figures: list[float]) -> float:
    """The p of the power law size^p that runs through the figures: 1 is linear growth."""
    return float(np.polyfit(np.log(sizes), np.log(figures), 1)[0])


def peak_memory(task: Callable[[], Any]) -> int:
    """The most memory that `task` holds at once, what it returns included [bytes]."""
    task()
    tracemalloc.start()
    kept = task()
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    del kept
    return peak


def rms(path: Array, shown: Array) -> float:
    """Root mean square distance of two paths [mm]; one may have a sample more than the other."""
    if abs(len(path) - len(shown)) > 1:
        return float("nan")
    both = min(len(path), len(shown))
    return 1e3 * float(np.sqrt(((path[:both] - shown[:both]) ** 2).sum(axis=1).mean()))
