"""How alike PlaCo's solver and ours are: `python -m tests.benchmarks.solvers [--letters TEXT]
[--pages 200]`.

Every letter is planned on five pages by both, and random pages are judged by both. Some minutes.
"""

import argparse
import os
import string
import time

import numpy as np

import dmp_teach as teach
from dmp_teach.errors import ReachError
from dmp_teach.robot.numpy_arm import NumpySolver
from dmp_teach.robot.placo_arm import PlacoSolver
from dmp_teach.robot.reach.posture import find_posture
from dmp_teach.robot.reach.suggest import whole_area
from dmp_teach.robot.slices import run_through
from tests.robot.test_solvers import PAGES, random_pages


def plan(solver, strokes, page):
    """The motion, or why there is none, and how long that took [s]."""
    os.environ["DMP_TEACH_SOLVER"] = solver
    start = time.process_time()
    try:
        found = teach.Fetch().write(strokes, page)
    except ReachError as error:
        found = str(error)
    return found, time.process_time() - start


def off_path(motion):
    """How far the tip is from its path at most, early or late as it may be [m]."""
    least = np.full(len(motion.tip), np.inf)
    for first in range(-3, 3):
        begin, end = (
            motion.target[np.clip(np.arange(len(least)) + by, 0, len(least) - 1)]
            for by in (first, first + 1)
        )
        along = end - begin
        square = np.maximum((along**2).sum(axis=1), 1e-24)
        part = np.clip(((motion.tip - begin) * along).sum(axis=1) / square, 0, 1)
        beside = np.linalg.norm(motion.tip - begin - part[:, None] * along, axis=1)
        least = np.minimum(least, beside)
    return least.max()


def compare_letters(characters):
    joints, tips, faster = [], [], []
    for character in characters:
        strokes = teach.Letter.learn(teach.recording_of(character)).write()
        for number, page in enumerate(PAGES):
            (theirs, _), (ours, seconds) = (
                plan(each, strokes, page) for each in ("PlaCo", "NumPy")
            )
            if isinstance(theirs, str) or isinstance(ours, str) or ours.notes != theirs.notes:
                print(f"{character} on page {number}: {theirs!s} | {ours!s}")
                continue
            joints.append(np.abs(ours.q - theirs.q).max())
            tips.append((off_path(theirs), off_path(ours)))
            faster.append(ours.duration / seconds)
    theirs, ours = 1e6 * np.max(tips, axis=0)
    print(f"{len(joints)} motions: joints differ by {max(joints):.1e} rad at most")
    print(f"off the path: PlaCo {theirs:.2f} um, NumPy {ours:.2f} um at most")
    print(f"NumPy plans {np.median(faster):.0f} times as fast as one writes, or {min(faster):.0f}")


def compare_pages(count):
    solvers = PlacoSolver(), NumpySolver()
    seconds, differ, can = np.zeros(2), 0, 0
    for page in random_pages(count):
        found = []
        for number, solver in enumerate(solvers):
            start = time.process_time()
            found.append(run_through(find_posture(solver, page, *whole_area(page))))
            seconds[number] += time.process_time() - start
        one, other = found
        can += not one.trouble
        if (one.trouble, one.collides) != (other.trouble, other.collides):
            differ += 1
            print(f"{page!r}: {one.trouble or one.effort} | {other.trouble or other.effort}")
    print(f"{count} pages, {can} can be written on: {differ} judged otherwise")
    print(f"a page takes PlaCo {seconds[0] / count:.2f} s, NumPy {seconds[1] / count:.2f} s")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--letters", default=string.ascii_letters + string.digits)
    parser.add_argument("--pages", type=int, default=200)
    asked = parser.parse_args()
    if asked.letters:
        compare_letters(asked.letters)
    compare_pages(asked.pages)
