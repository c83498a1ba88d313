"""Ours and PlaCo's solver take the same steps, and ours needs nothing but NumPy."""

import subprocess
import sys

import numpy as np
import pytest

import dmp_teach as teach
from dmp_teach.errors import SettingError
from dmp_teach.robot.numpy_arm import NumpySolver
from dmp_teach.robot.page import Page
from dmp_teach.robot.reach.posture import find_posture
from dmp_teach.robot.reach.suggest import whole_area
from dmp_teach.robot.slices import run_through

PAGES = (
    Page.table(),
    Page.board(),
    Page.table(x=0.6, width=0.297, height=0.21),
    Page.board(x=0.7, y=0.2),
    Page.table(x=0.65, y=-0.15, tilt=0.4),
)
BARE = """
import sys
for name in ("placo", "pinocchio", "coal", "pybullet"):
    sys.modules[name] = None
import dmp_teach as teach
from dmp_teach.errors import MissingPartError

letter = teach.Letter.learn(teach.recording_of("a"))
motion = teach.Fetch().write(letter.write(), teach.Page.table())
teach.view(motion).html(sys.argv[1])
try:
    teach.simulate(motion)
except MissingPartError as error:
    print(motion.solver, error)
"""


@pytest.fixture(scope="module")
def placo():
    pytest.importorskip("placo", reason="PlaCo is not on this platform")
    from dmp_teach.robot.placo_arm import PlacoSolver  # noqa: PLC0415

    return PlacoSolver()


def random_pages(count, seed=0):
    """Pages around the robot, of which the arm reaches about two of three."""
    rng = np.random.default_rng(seed)
    for number in range(count):
        width, height = rng.uniform(0.1, 0.3, 2)
        x, y, tilt, z = rng.uniform((0.3, -0.6, -0.5, 0.4), (1.1, 0.6, 0.8, 1.1))
        place = {"x": x, "y": y, "tilt": tilt, "width": width, "height": height}
        yield Page.table(z=z, **place) if number % 2 else Page.board(**place)


@pytest.mark.parametrize(("character", "page"), list(zip("aQm8f", PAGES, strict=True)))
def test_a_letter_is_planned_alike(placo, monkeypatch, character, page):
    strokes = teach.Letter.learn(teach.recording_of(character)).write()
    theirs = teach.Fetch().write(strokes, page)
    monkeypatch.setenv("DMP_TEACH_SOLVER", "NumPy")
    ours = teach.Fetch().write(strokes, page)
    assert (theirs.solver, ours.solver) == ("PlaCo", "NumPy")
    np.testing.assert_allclose(ours.q, theirs.q, rtol=0, atol=1e-6)
    assert ours.notes == theirs.notes


def test_pages_are_judged_alike(placo):
    ours = NumpySolver()
    can = 0
    for page in random_pages(6, seed=6):
        one, other = (
            run_through(find_posture(each, page, *whole_area(page))) for each in (placo, ours)
        )
        assert (one.trouble, one.collides) == (other.trouble, other.collides)
        assert one.effort == pytest.approx(other.effort, rel=1e-4)
        can += not one.trouble
    assert can == 3


def test_without_any_native_library_a_letter_is_learned_planned_and_shown(tmp_path):
    view = tmp_path / "view.html"
    told = subprocess.check_output([sys.executable, "-c", BARE, str(view)], text=True)
    assert told.startswith("NumPy Pictures and physics need pybullet")
    assert view.stat().st_size > 10_000


def test_two_plans_in_slices_do_not_move_the_arm_of_each_other():
    strokes = teach.Letter.learn(teach.recording_of("l")).write()
    pages = Page.table(), Page.board()
    alone = [run_through(teach.Fetch().write_in_slices(strokes, page)) for page in pages]
    turns = [teach.Fetch().write_in_slices(strokes, page) for page in pages]
    found = {}
    for _ in range(10_000):
        for k, turn in enumerate(turns):
            if k not in found:
                try:
                    next(turn)
                except StopIteration as end:
                    found[k] = end.value
    assert [found[0], found[1]] == alone


def test_a_refusal_is_found_in_slices_between_which_stop_is_heard():
    strokes = teach.Letter.learn(teach.recording_of("l")).write()
    stopped = teach.Fetch().write_in_slices(strokes, Page.table(x=1.317, y=0.013))
    reached = [next(stopped) for _ in range(40)]
    stopped.close()
    assert {step for step, _ in reached} == {"reach"}
    assert len(set(reached)) > 20


def test_a_solver_that_there_is_not_is_refused(monkeypatch):
    monkeypatch.setenv("DMP_TEACH_SOLVER", "banana")
    with pytest.raises(SettingError, match="'banana', but must be NumPy"):
        teach.Fetch().write(teach.Letter.learn(teach.recording_of("l")).write(), Page.table())
