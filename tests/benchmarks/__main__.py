"""How fast primitive and robot are, beside others: `python -m tests.benchmarks [--turns 40] [--json
figures.json] [--table table.md]`.

No test: what a computer does beside it decides too, so nothing here fails. It prints medians,
ratios of medians with the quartiles of the ratios turn by turn, and the error of each path against
the letter that was shown.
"""

import argparse
import json
import platform
import sys
import tempfile
import warnings
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import scipy

from dmp_teach.dmp.primitive import DMP
from dmp_teach.dmp.settings import Settings
from dmp_teach.errors import TeachError
from dmp_teach.formats.read import read_recording
from dmp_teach.ink.alphabet import recording_of
from dmp_teach.letters.letter import Letter
from dmp_teach.trajectory import Trajectory
from tests.benchmarks.classroom import classroom
from tests.benchmarks.classroom import lines as classroom_lines
from tests.benchmarks.contenders import HOW_TO_INSTALL, Contender, others, ours
from tests.benchmarks.lifts import lifts
from tests.benchmarks.lifts import lines as lift_lines
from tests.benchmarks.measure import Times, exponent, in_turns, peak_memory, rms
from tests.benchmarks.writing import lines as writing_lines
from tests.benchmarks.writing import writing
from tests.dmp.ink import letter
from tests.formats.motive_csv import Pen, bar, bowl, lab, motive

SAMPLES, KERNELS = 300, 30
SHIFT = np.array([0.03, -0.02])  # of the goal [m]
MOST = 30_000  # samples, for the growth


def the_letter() -> Trajectory:
    """Our own `a`, sampled evenly: 300 times from 0 on, in 2-D."""
    (stroke,) = recording_of("a").strokes()
    t = np.linspace(0, stroke.duration, SAMPLES)
    path = [np.interp(t, stroke.t - stroke.t[0], axis) for axis in stroke.position.T[:2]]
    return Trajectory(t, np.column_stack(path))


def race(contenders: list[Contender], turns: int) -> list[dict[str, Any]]:
    """A row a contender: fit and rollout, and a rollout with only the goal changed."""
    shown = the_letter()
    learned = {each.name: each.learn(shown) for each in contenders}
    errors = {
        each.name: rms(each.draw(learned[each.name], None), shown.position) for each in contenders
    }
    goal = shown.position[-1] + SHIFT
    scratch = in_turns(
        {each.name: lambda each=each: each.draw(each.learn(shown), None) for each in contenders},
        turns,
    )
    moved = in_turns(
        {each.name: lambda each=each: each.draw(learned[each.name], goal) for each in contenders},
        turns,
    )
    first = contenders[0].name
    return [
        {
            "name": each.name,
            "error_mm": errors[each.name],
            "fit_and_rollout": _figures(scratch[each.name], scratch[first], each.bound),
            "goal_changed": _figures(moved[each.name], moved[first], each.bound_for_goal),
        }
        for each in contenders
    ]


def _figures(times: Times, of_ours: Times, bound: float) -> dict[str, float]:
    ratio, low, high = times.times_longer_than(of_ours)
    return {
        "seconds": times.median,
        "ratio": ratio,
        "lower_quartile": low,
        "upper_quartile": high,
        "bound": bound,
    }


def growth(turns: int) -> dict[str, Any]:
    """Time and memory of a fit and a rollout as the letter and its kernels grow."""
    sizes = [n for n in (300, 1000, 3000, 10_000, MOST) if n <= MOST]
    numbers = [30, 100, 300, 1000, 3000]
    long = {n: letter(n, n / 120) for n in sizes}

    def learned_and_drawn(n: int, kernels: int) -> Callable[[], Any]:
        return lambda: DMP.imitate(long[n], Settings.star(n_kernels=kernels)).rollout()

    by_samples = in_turns({n: learned_and_drawn(n, n // 10) for n in sizes}, turns)
    by_kernels = in_turns({kernels: learned_and_drawn(MOST, kernels) for kernels in numbers}, turns)
    memory = [peak_memory(learned_and_drawn(n, n // 10)) for n in sizes]
    seconds, more = (
        [by_samples[n].median for n in sizes],
        [by_kernels[kernels].median for kernels in numbers],
    )
    return {
        "samples": sizes,
        "seconds_by_samples": seconds,
        "exponent_by_samples": exponent(sizes[1:], seconds[1:]),
        "peak_bytes": memory,
        "exponent_of_memory": exponent(sizes, memory),
        "kernels": numbers,
        "seconds_by_kernels": more,
        "exponent_by_kernels": exponent(numbers, more),
    }


def real_time(turns: int) -> list[dict[str, Any]]:
    """How much longer a `D` took to write than we take to read it and to learn it."""
    t, page = Pen().rest(1.0).draw(bar()).hop((0.0, 0.0)).draw(bowl()).rest(1.0).sampled()
    with tempfile.TemporaryDirectory() as folder:
        path = motive(Path(folder) / "D_w01.csv", t, lab(page))
        recording = read_recording(path)
        tasks = {
            "reading and segmenting": lambda: read_recording(path).strokes(),
            "learning and writing, star": lambda: Letter.learn(recording).write(),
        }
        took = {name: each.median for name, each in in_turns(tasks, turns).items()}
    return [
        {"name": name, "seconds": s, "times_real_time": recording.duration / s}
        for name, s in took.items()
    ]


def _writing(turns: int) -> tuple[list[dict[str, Any]], list[str]]:
    """The robot's writing, where there is a robot."""
    try:
        return writing(turns)
    except TeachError as error:
        print(f"The robot is not measured: {error}\n", file=sys.stderr)
        return [], []


def printed(results: dict[str, Any]) -> str:
    """The results as plain tables."""
    lines = [
        f"Python {platform.python_version()}, NumPy {np.__version__}, "
        f"SciPy {scipy.__version__}, {platform.machine()}",
        f"One letter, {SAMPLES} samples in 2-D, {KERNELS} kernels. Processor time. "
        "Ratios: how many times longer than",
        "dmp_teach star, of the medians, and in brackets the quartiles of the ratios turn by "
        "turn; 'of' names what is",
        "to be reached.",
        "",
        f"{'':38}{'error':>9}  {'fit and rollout':<43}only the goal changed",
    ]
    for row in results["race"]:
        cells = "".join(f"{_cell(row[part]):<43}" for part in ("fit_and_rollout", "goal_changed"))
        lines.append(f"{row['name']:38}{row['error_mm']:6.2f} mm  {cells}".rstrip())
    grown = results["growth"]
    lines += [
        "",
        "Fit and rollout, star, N = n/10",
        f"{'n':>8}{'time':>12}{'memory':>12}{'a sample':>12}",
    ]
    for n, seconds, peak in zip(
        grown["samples"], grown["seconds_by_samples"], grown["peak_bytes"], strict=True
    ):
        lines.append(f"{n:8}{1e3 * seconds:9.3f} ms{peak / 1e6:9.3f} MB{peak / n:10.0f} B")
    lines += ["", f"The same, n = {MOST}", f"{'N':>8}{'time':>12}"]
    for kernels, seconds in zip(grown["kernels"], grown["seconds_by_kernels"], strict=True):
        lines.append(f"{kernels:8}{1e3 * seconds:9.3f} ms")
    lines += [
        "",
        f"Growth: time with n^{grown['exponent_by_samples']:.2f} from n = {grown['samples'][1]} "
        "on, with "
        f"N^{grown['exponent_by_kernels']:.2f}; memory with n^{grown['exponent_of_memory']:.2f}.",
    ]
    lines += ["", "A D from motion capture, beside the time that its writer took"]
    for row in results["real_time"]:
        lines.append(
            f"{row['name']:35}{1e3 * row['seconds']:10.3f} ms"
            f"{row['times_real_time']:10.1f} times faster"
        )
    return "\n".join(
        lines
        + classroom_lines(results["classroom"])
        + lift_lines(results["lifts"])
        + writing_lines(results["writing"])
    )


def _cell(figures: dict[str, float]) -> str:
    """Median, ratio with its quartiles, and the bound where there is one."""
    time = f"{1e6 * figures['seconds']:10.1f} us"
    if figures["ratio"] == 1:
        return time
    spread = "{ratio:7.1f} [{lower_quartile:.1f}, {upper_quartile:.1f}]".format_map(figures)
    return f"{time} {spread}" + (f" of {figures['bound']:.0f}" if figures["bound"] else "")


def main(arguments: list[str] | None = None) -> None:
    """Measure, print, and write the figures where asked."""
    asked = argparse.ArgumentParser(
        prog="python -m tests.benchmarks", description=__doc__.splitlines()[0]
    )
    asked.add_argument(
        "--turns", type=int, default=40, help="how often everything is measured (default 40)"
    )
    asked.add_argument("--json", type=Path, help="where to write the figures, too")
    asked.add_argument("--table", type=Path, help="where to write all benchmarks as one table")
    options = asked.parse_args(arguments)
    warnings.simplefilter("ignore", RuntimeWarning)
    found, missing = others(KERNELS)
    few = max(3, options.turns // 4)
    robot, more_missing = _writing(few)
    results = {
        "race": race(ours(KERNELS) + found, options.turns),
        "growth": growth(few),
        "real_time": real_time(few),
        "classroom": classroom(),
        "lifts": lifts(),
        "writing": robot,
    }
    print(printed(results))
    if missing + more_missing:
        print("\n" + HOW_TO_INSTALL.format(names=" and ".join(missing + more_missing)))
    if options.json:
        options.json.write_text(json.dumps(results, indent=2), encoding="utf-8")
    if options.table:
        # It wants a browser and the tests' packages, too.
        from tests.benchmarks.table import write_table  # noqa: PLC0415

        write_table(results, options.table)


if __name__ == "__main__":
    main()
