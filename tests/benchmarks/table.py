"""All that was measured as one table in Markdown, for the docs: `python -m tests.benchmarks --table
docs/benchmarks.md`. The slow ones are short here: teaching for a minute, planning five letters.
"""

import os
import platform
from contextlib import redirect_stdout
from io import StringIO
from pathlib import Path
from typing import Any

import numpy as np

from tests.benchmarks import browser, solvers, teaching
from tests.browser.conftest import chromium_path

TEXT = """# What was measured

Made again by `python -m tests.benchmarks --table docs/benchmarks.md`. A ratio is the median over
turns that both took one after the other, in brackets the quartiles; what else ran on the computer
decides too. What is to be reached stands beside it, where something is. How each is measured
stands at the top of the module of `tests/benchmarks` that is named.

{machine}

| what | result | to be reached | measured by |
|---|---|---|---|
"""
Row = tuple[str, str, str, str]


def rows(found: dict[str, Any]) -> list[Row]:
    """The rows of `python -m tests.benchmarks`."""
    return [
        *_beside_others(found["race"]),
        *(
            ("", f"a D from motion capture, {row['name']}",
             f"{row['times_real_time']:.0f} times faster than it was written", "")
            for row in found["real_time"]
        ),
        ("", "time of a fit and a rollout grows with the samples' power",
         f"{found['growth']['exponent_by_samples']:.2f}", ""),
        ("classroom", f"a class of {found['classroom']['pupils'][-1]}, a letter read, cut, learned "
         "and scored", f"{1e3 * found['classroom']['seconds_a_letter'][-1]:.0f} ms", ""),
        ("lifts", f"{found['lifts']['faults']} faults told at the pen's lift",
         f"{100 * found['lifts']['right']:.1f} %", "95 %"),
        ("lifts", f"{found['lifts']['letters']} letters stopped for nothing",
         f"{100 * found['lifts']['alarms']:.1f} %", "at most 2 %"),
        *(
            ("writing", row["name"].replace(" [s]", ""),
             "{median:.1f} [{lower_quartile:.1f}, {upper_quartile:.1f}]".format_map(row)
             + (" s" if "[s]" in row["name"] else " times real time"), str(row["bound"] or ""))
            for row in found["writing"]
        ),
    ]  # fmt: skip


def _beside_others(race: list[dict[str, Any]]) -> list[Row]:
    """How far off each path is, and how many times longer each takes than the first."""
    told: list[Row] = []
    for row in race:
        result, bounds = f"{row['error_mm']:.2f} mm off", []
        for part in ("fit_and_rollout", "goal_changed") if row is not race[0] else ():
            spread = "{ratio:.1f} [{lower_quartile:.1f}, {upper_quartile:.1f}]"
            result += f"; {part.replace('_', ' ')} {spread.format_map(row[part])} times as long"
            bounds += [f"{row[part]['bound']:.0f}"] if row[part]["bound"] else []
        told.append(("", row["name"], result, " and ".join(bounds)))
    return told


def other_rows() -> list[Row]:
    """The rows of what has commands of its own, kept short."""
    said = StringIO()
    with redirect_stdout(said):
        solvers.compare_letters("aRk8g")
    told = [
        ("solvers", "our solver beside PlaCo", line, "") for line in said.getvalue().splitlines()
    ]
    told += [
        ("teaching", "robots that are taught", result, bound)
        for line in teaching.lines(teaching.teaching(1.0))[:3]
        for result, bound in [line.rsplit(", of ", 1)]
    ]
    if chromium_path():
        (run,) = browser.runs(1, 3.0)
        seen = {row["name"]: row["updates_a_second"] for row in run}
        for what, ours in (("goal", "in the browser"), ("bumps", "by the kernel")):
            ratio = seen[f"{what}, {ours}"] / seen[f"{what}, by interact"]
            told.append(("browser", f"{what}, {ours}: updates a second",
                         f"{ratio:.1f} times those by interact", ""))  # fmt: skip
    return told


def write_table(found: dict[str, Any], file: Path) -> None:
    """Write the table."""
    lines = [
        f"| {what} | {result} | {bound} | `{name or '__main__'}.py` |"
        for name, what, result, bound in [*rows(found), *other_rows()]
    ]
    load = f", load {os.getloadavg()[0]:.0f}" if hasattr(os, "getloadavg") else ""
    machine = (
        f"With Python {platform.python_version()} and NumPy {np.__version__} on "
        f"{platform.machine()}, {os.cpu_count()} cores{load}."
    )
    file.write_text(TEXT.format(machine=machine) + "\n".join(lines) + "\n", encoding="utf-8")
