"""The kernel never dies: robots dropped, made again and interrupted in any order."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]

WALK = """
import gc, hashlib, random, signal, sys, threading
import numpy as np
from dmp_teach.robot.fetch import Fetch
from dmp_teach.robot.page import Page
from dmp_teach.robot.solvers import build_solver
from tests.robot.ink import LETTER

def digest(motion):
    numbers = motion.q.tobytes() + motion.tip.tobytes()
    return hashlib.sha256(numbers + repr(motion.notes).encode()).hexdigest()

def write():
    assert digest(Fetch().write(LETTER, Page.table())) == fresh

def drop():
    robots.clear()
    gc.collect()

def make_again():
    thread = threading.Thread(target=lambda: robots.append(Fetch()))
    thread.start()
    thread.join()
    gc.collect()

def hold_a_part():
    solver = build_solver()
    robots.append((solver.pen(), solver.jacobian(), solver.proximity))
    del solver
    gc.collect()

def interrupt():
    count = random.randrange(1, 14)
    def stop(step, part):
        nonlocal count
        count -= 1
        if not count:
            signal.raise_signal(signal.SIGINT)
    try:
        Fetch().write(LETTER, Page.board(), progress=stop)
    except KeyboardInterrupt:
        pass
    write()

def elsewhere():
    failed = []
    def work():
        try:
            write()
        except BaseException as error:
            failed.append(error)
    threads = [threading.Thread(target=work) for _ in range(2)]
    [thread.start() for thread in threads]
    robots.clear()
    gc.collect()
    [thread.join() for thread in threads]
    assert not failed, failed

random.seed(int(sys.argv[1]))
robots = [Fetch()]
fresh = digest(robots[0].write(LETTER, Page.table()))
deeds = [write, drop, make_again, hold_a_part, interrupt, elsewhere]
left = {make_again: 3, hold_a_part: 2, elsewhere: 2}  # these build solvers, and each leaks a little
for _ in range(10):
    deed = random.choice([deed for deed in deeds if left.get(deed, 1)])
    if deed in left:
        left[deed] -= 1
    deed()
    print(deed.__name__, flush=True)
robots.append(Fetch())  # alive when the interpreter ends
print("alive", fresh)
"""


@pytest.mark.parametrize("seed", [1, 2])
def test_robots_dropped_made_again_and_interrupted_in_any_order_do_no_harm(seed):
    walk = subprocess.run(
        [sys.executable, "-X", "faulthandler", "-c", WALK, str(seed)],
        cwd=ROOT,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )
    assert walk.returncode == 0, walk.stdout + walk.stderr
    assert walk.stdout.splitlines()[-1].startswith("alive")
