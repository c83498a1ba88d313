"""The libraries that we are measured beside stay out of all else, and the measuring is right."""

import re
import tomllib
from pathlib import Path
from time import process_time

import numpy as np
import pytest
from packaging.requirements import Requirement

from tests.benchmarks.measure import Times, exponent, in_turns, peak_memory, rms

ROOT = Path(__file__).parents[2]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
PEERS = {Requirement(line).name for line in PROJECT["optional-dependencies"]["benchmark"]}


def test_the_peers_are_in_no_environment_of_ours():
    assert {"pydmps", "movement_primitives", "pin-pink"} <= PEERS
    others = PROJECT["dependencies"] + PROJECT["optional-dependencies"]["test"]
    assert not PEERS & {Requirement(line).name for line in others}
    pinned = (ROOT / "environment.txt").read_text(encoding="utf-8").replace("-", "_")
    assert not [name for name in PEERS if name in pinned]


def test_the_peers_are_imported_nowhere_else():
    modules = {name.removeprefix("pin-") for name in PEERS}
    imported = re.compile(rf"^\s*(import|from) ({'|'.join(modules)})\b", re.MULTILINE)
    files = [
        path
        for room in ("dmp_teach", "tests", "notebooks", "assets")
        for path in (ROOT / room).rglob("*.py")
    ]
    using = {
        path.relative_to(ROOT).as_posix()
        for path in files
        if imported.search(path.read_text(encoding="utf-8"))
    }
    assert using == {"tests/benchmarks/contenders.py", "tests/benchmarks/pink_arm.py"}


def test_every_task_is_repeated_within_its_turn_and_measured_for_one():
    calls = []

    def long():
        began = process_time()
        while process_time() < began + 0.01:
            pass

    times = in_turns({"long": long, "short": lambda: calls.append(1)}, turns=2, turn=0.01)
    assert len(times["long"].seconds) == len(times["short"].seconds) == 2
    assert times["long"].median >= 0.01
    assert times["short"].median < 0.001
    assert len(calls) > 10


def test_ratios_are_of_medians_with_the_quartiles_of_the_turns():
    slow, fast = Times(np.array([10.0, 20.0, 30.0, 40.0])), Times(np.array([1.0, 2.0, 3.0, 8.0]))
    assert slow.times_longer_than(fast) == pytest.approx((10.0, 8.75, 10.0))


def test_growth_and_memory_and_error_are_what_they_say():
    assert exponent([10, 100, 1000], [2e3, 2e5, 2e7]) == pytest.approx(2.0)
    assert 8e6 <= peak_memory(lambda: np.ones(1_000_000)) < 8.1e6
    assert rms(np.zeros((3, 2)), np.full((4, 2), 0.001)) == pytest.approx(2**0.5)
    assert np.isnan(rms(np.zeros((3, 2)), np.zeros((5, 2))))
