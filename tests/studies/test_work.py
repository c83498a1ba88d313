"""A study gives the same on every executor, in the same order, and says how far it is."""

import io
import warnings
from concurrent.futures import Executor, Future, ProcessPoolExecutor, ThreadPoolExecutor

import numpy as np
import pytest

from dmp_teach.errors import SettingWarning
from dmp_teach.studies.authorship.real import classify_writers
from dmp_teach.studies.experiments.error_curves import sweep_kernel_number, sweep_kernel_width
from dmp_teach.studies.experiments.goal_change import change_goals_1d, change_goals_2d
from dmp_teach.studies.experiments.goal_drawings import draw_goal_change
from dmp_teach.studies.experiments.goal_near_start import change_goals_near_start
from dmp_teach.studies.experiments.random_ink import learn_random_ink
from dmp_teach.studies.experiments.redraw import redraw_at_widths, redraw_letters
from dmp_teach.studies.experiments.validation import choose_kernels
from dmp_teach.studies.parallel import progress_bar, run
from tests.dmp.ink import letter

INK = [letter(120, 1.0, seed=seed) for seed in range(3)]


class Backwards(Executor):
    """A cluster that begins with the last piece."""

    def __init__(self):
        self.waiting = []

    def submit(self, work, /, *args, **kwargs):
        future = Late(self)
        self.waiting.append((future, work, args, kwargs))
        return future

    def finish(self):
        while self.waiting:
            future, work, args, kwargs = self.waiting.pop()
            future.set_result(work(*args, **kwargs))


class Late(Future):
    def __init__(self, engine):
        super().__init__()
        self.engine = engine

    def result(self, timeout=None):
        self.engine.finish()
        return super().result(timeout)


@pytest.fixture(scope="module")
def processes():
    with ProcessPoolExecutor(2) as pool:
        yield pool


def figures(executor):
    """Every kind of study, as plain numbers."""
    widths = sweep_kernel_width(INK, widths=(0.5, 1.0, 4.0, np.inf), executor=executor)
    numbers = sweep_kernel_number(INK, shares=(0.1, 0.3), executor=executor)
    return [
        widths.error,
        numbers.error,
        change_goals_1d(INK, executor=executor).values("original"),
        change_goals_2d(INK, executor=executor).values("star"),
        [item.error for item in redraw_letters(INK, executor=executor).items],
        [item.error for item in redraw_at_widths(INK, executor=executor).items],
        learn_random_ink(rates=(1.0,), pieces=2, executor=executor).error,
        choose_kernels(INK[0], candidates=(4, 8), executor=executor).error,
    ]


def test_threads_processes_and_other_engines_give_the_serial_result(processes):
    serial = figures(None)
    with ThreadPoolExecutor(2) as threads:
        for engine in (threads, processes, Backwards()):
            for one, other in zip(serial, figures(engine), strict=True):
                np.testing.assert_allclose(one, other, rtol=1e-9)


def test_progress_is_told_after_every_piece_from_none_to_all():
    told = []
    sweep_kernel_number(INK, shares=(0.1,), progress=lambda done, total: told.append((done, total)))
    assert told == [(0, 3), (1, 3), (2, 3), (3, 3)]


def test_nothing_to_do_is_done():
    stream = io.StringIO()
    assert run(abs, [], progress=progress_bar(stream=stream)) == []
    assert stream.getvalue().endswith("\n")


def test_an_error_in_one_piece_calls_off_the_rest():
    called_off = []

    class Slow(Executor):
        def submit(self, work, /, *args):
            future = Future()
            future.cancel = lambda: called_off.append(1)
            future.set_exception(ZeroDivisionError("no"))
            return future

    with pytest.raises(ZeroDivisionError):
        run(abs, [1, 2, 3], Slow())
    assert len(called_off) == 3


def test_progress_may_stop_a_study():
    def stop(done, total):
        if done == 1:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        run(abs, [1, 2, 3], progress=stop)


def test_gaps_that_are_studied_are_not_warned_of(processes):
    with warnings.catch_warnings():
        warnings.simplefilter("error", SettingWarning)
        for engine in (None, processes):
            sweep_kernel_width(INK[:1], widths=(0.3, 1.0), executor=engine)


def test_a_wrong_keyword_names_the_study_that_it_was_given_to():
    for study in (sweep_kernel_width, change_goals_1d, redraw_letters, choose_kernels):
        with pytest.raises(TypeError, match=rf"{study.__name__}\(\) .* 'exectuor'"):
            study(INK, exectuor=None)


def test_what_a_study_gives_is_said_in_a_line():
    near, hands = change_goals_near_start(INK[:1], ways=(0.02, 0.001)), classify_writers()
    for value in (near, hands, hands.items[0], change_goals_1d(INK), draw_goal_change(INK[0])):
        assert repr(value).startswith(f"{type(value).__name__}(")
        assert len(repr(value)) < 300
