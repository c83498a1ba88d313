"""A movement step by step: undisturbed it is the rollout; pushed, it comes back."""

import dataclasses
import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dmp_teach.dmp.primitive import DMP
from dmp_teach.dmp.settings import Settings
from dmp_teach.dmp.stepper import Stepper
from dmp_teach.errors import TrajectoryError
from tests.dmp.ink import in_all_its_steps, letter, letters, to_the_end

few = settings(max_examples=25, deadline=None)
KINDS = [
    Settings.star(),
    Settings.joint(),
    Settings.plus(),
    Settings.original(),
    Settings.as_fixed(),
    Settings.as_coded(),
    Settings.star(integrator="exact"),
    Settings.star(transform="similarity", phase="sigmoid"),
]


@few
@given(letters(), st.sampled_from(KINDS), st.floats(-0.1, 0.1), st.floats(0.25, 4.0))
def test_undisturbed_steps_are_the_rollout(demo, kind, shift, factor):
    p = DMP.imitate(demo, kind)
    goal, T = p.goal + shift, factor * p.duration
    stepped = to_the_end(Stepper.begin(p, goal=goal, duration=T))
    drawn = in_all_its_steps(p, goal)
    assert np.abs(stepped.position - drawn).max() <= 1e-12 * max(1, np.abs(drawn).max())
    assert stepped.duration == pytest.approx(T)
    waiting = to_the_end(Stepper.begin(p, goal=goal, patience=0.01))
    assert np.abs(waiting.position[:-1] - drawn[: len(waiting) - 1]).max() <= 1e-9 * max(
        1, np.abs(drawn).max()
    )


@few
@given(letters(), st.sampled_from(KINDS[:3]), st.floats(0.1, 0.5), st.integers(0, 99))
def test_a_pushed_pen_comes_back_to_its_path(demo, kind, when, seed):
    p = DMP.imitate(demo, kind)
    hand = np.random.default_rng(seed).normal(size=len(p.start))
    begin, end = when * p.duration, (when + 0.05) * p.duration
    pushed = to_the_end(
        Stepper.begin(p), lambda t: 100 * hand / p.duration**2 if begin < t < end else None
    )
    off = np.linalg.norm(pushed.position - p.start - p.nominal_path, axis=1)
    before = pushed.t < begin - 1e-9
    assert off[before].max(initial=0) < 1e-12
    assert off.max() > 1e-3 * np.linalg.norm(hand)
    spring, during = Stepper.begin(p).plan.spring, (pushed.t[:-1] > begin) & (pushed.t[:-1] < end)
    alone = spring.follow(
        np.outer(during, 100 * hand)
    )  # the spring's own answer, whatever the letter
    assert np.abs(np.linalg.norm(alone, axis=1) - off).max() <= 1e-9 * off.max()
    if p.settings.alpha >= 30:
        assert off[-1] < 0.05 * off.max()


def test_a_pen_that_a_hand_has_moved_comes_back_too():
    p = DMP.imitate(letter())
    pen = Stepper.begin(p)
    for _ in range(60):
        pen = pen.step()
    taken = pen.moved((0.02, -0.01))
    assert taken.position == pytest.approx(pen.position + np.array([0.02, -0.01]))
    assert taken.off_path == pytest.approx(math.hypot(0.02, 0.01), abs=1e-9)
    assert np.abs(to_the_end(taken).position[-1] - p.rollout().position[-1]).max() < 1e-6


@few
@given(letters(), st.sampled_from([Settings.star(), Settings.original()]), st.floats(0.0, 0.8))
def test_a_goal_that_moves_on_the_way_changes_the_rest_alone_and_in_proportion(demo, kind, when):
    p = DMP.imitate(demo, kind)

    def led(shift):
        pen, path = Stepper.begin(p), []
        while not pen.over:
            if len(path) == round(when * p.steps):
                pen = pen.led(p.goal + shift)
            path.append(pen.position)
            pen = pen.step()
        return np.array([*path, pen.position])

    at_rest, near, far = (led(shift) for shift in (0.0, 0.01, 0.03))
    gone = round(when * p.steps) + 1
    assert np.array_equal(near[:gone], at_rest[:gone])
    assert np.abs(near[-1] - at_rest[-1]).max() > 1e-3
    assert np.abs((far - at_rest) - 3 * (near - at_rest)).max() <= 1e-9 * np.abs(far).max()


@few
@given(letters(), st.sampled_from(KINDS), st.floats(0.0, 1.2), st.none() | st.floats(0.003, 0.1))
def test_a_goal_may_move_at_any_step_and_is_reached_with_no_more_than_the_laws_own_jump(
    demo, kind, when, patience
):
    p = DMP.imitate(demo, kind)
    goal, pen = p.goal + np.resize((0.03, -0.1), len(p.goal)), Stepper.begin(p, patience=patience)
    while pen.clock < when * p.steps:
        pen = pen.step()
    led = pen.led(goal)
    assert np.array_equal([led.position, led.velocity], [pen.position, pen.velocity])
    if patience is None:
        law = (led.plan.input_at(pen.clock) - pen.plan.input_at(pen.clock)) / p.duration**2
        h = p.duration / p.steps
        jump = (led.step().velocity - pen.step().velocity) / h
        assert np.linalg.norm(jump) <= (1 + 1e-6) * np.linalg.norm(law)
    for _ in range(20_000):
        led = led.step()
        if led.over and np.abs(led.position - goal).max() < 1e-5:
            break
    assert np.abs(led.position - goal).max() < 1e-5


def test_every_step_is_a_new_value():
    pen = Stepper.begin(DMP.imitate(letter()))
    later = pen.step(push=(1.0, 0.0))
    assert (pen.t, pen.clock) == (0.0, 0.0)
    assert (later.clock, later.t) == (1.0, pytest.approx(2.5 / later.plan.spring.steps))
    assert np.array_equal(pen.step(push=(1.0, 0.0)).states[1], later.states[1])
    with pytest.raises(dataclasses.FrozenInstanceError):
        pen.t = 1.0


def test_after_the_end_the_pen_goes_on_to_its_goal_and_rests():
    p = DMP.imitate(letter(), Settings.star(feed_goal=False))
    goal, pen = p.goal + 0.05, Stepper.begin(p, goal=p.goal + 0.05)
    while not pen.over:
        pen = pen.step()
    missed = np.abs(pen.position - goal).max()
    for _ in range(200):
        pen = pen.step()
    assert missed > 2e-3
    assert np.abs(pen.position - goal).max() < 1e-6
    assert np.abs(pen.velocity).max() < 1e-5
    assert pen.over


def test_with_patience_the_clock_waits_for_a_pen_that_is_held():
    """Phase stopping: what is written while the pen is held off its path is written afterwards."""
    p = DMP.imitate(letter(seed=2))

    def hold(t):
        return (6.0, 6.0) if 0.8 < t < 1.4 else None

    hasty, patient = (
        to_the_end(Stepper.begin(p), hold),
        to_the_end(Stepper.begin(p, patience=0.005), hold),
    )
    assert hasty.duration == pytest.approx(2.5)
    assert 3.0 < patient.duration < 4.0
    shown = p.start + p.nominal_path

    def skipped(drawn):
        """How much of the letter was never come near to, in samples."""
        apart = np.linalg.norm(shown[:, None] - drawn.position[None], axis=2).min(axis=1)
        return (apart > 0.003).sum()

    assert skipped(patient) < 0.7 * skipped(hasty)
    assert np.linalg.norm(patient.position[-1] - p.goal) < 2e-3


@pytest.mark.slow
@pytest.mark.parametrize(
    ("ask", "answer"),
    [
        (
            lambda p: Stepper.begin(p, goal=(1, 2, 3)),
            r"goal has shape \(3,\), but this movement has 2 dimensions",
        ),
        (
            lambda p: Stepper.begin(p, duration=0),
            "duration is 0, but it must be a time longer than 0 s",
        ),
        (
            lambda p: Stepper.begin(p, patience=0),
            "patience is 0, but it must be a distance over 0 m, or None",
        ),
        (
            lambda p: Stepper.begin(p).step(push=3.0),
            r"push has shape \(\), but this movement has 2 dimensions",
        ),
        (
            lambda p: Stepper.begin(p).step(push=(math.nan, 0)),
            "push is .*nan.*, but it must be finite",
        ),
        (lambda p: Stepper.begin(p).moved("left"), "by is 'left', but it must be 2 numbers"),
    ],
)
def test_what_cannot_be_stepped_is_said_in_a_sentence(ask, answer):
    with pytest.raises(TrajectoryError, match=answer):
        ask(DMP.imitate(letter(60, 2.5)))


def test_a_pen_under_way_is_said_in_a_line():
    pen = Stepper.begin(DMP.imitate(letter())).step()
    assert repr(pen).startswith("Stepper(0.0")
    assert len(repr(pen)) < 120
