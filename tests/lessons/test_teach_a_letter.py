"""What lesson 02 says of bumps is true of every letter that it may show."""

import numpy as np
import pytest

from dmp_teach.dmp import DMP, Settings
from dmp_teach.ink import recording_of
from dmp_teach.lessons.bumps import BUMP_NUMBER, learn_bumps
from dmp_teach.lessons.teach_a_letter import BET_BUMP, BET_CHANGE, BUMP_LETTERS, TeachALetter

PUPILS = [None, *(f"w{n:02d}" for n in range(30))]


@pytest.fixture(params=BUMP_LETTERS)
def bumps(request):
    return learn_bumps(request.param)


def test_the_bumps_add_up_to_the_push_that_the_letter_needs(bumps):
    push = bumps.weights @ bumps.shares
    assert np.sqrt(np.mean((push - bumps.needed) ** 2)) < 0.3 * np.std(bumps.needed)


def test_a_pushed_bump_is_heard_from_its_begin_on_and_the_end_stays(bumps):
    moved = np.abs(bumps.write((BET_BUMP, BET_CHANGE / 100)) - bumps.path)[:, 1]
    begin = bumps.awake(BET_BUMP).start
    assert moved[: begin + 1].max() < 1e-6
    assert moved.max() > 0.015
    assert moved[-1] < 1e-4


def test_the_bump_to_look_for_is_not_the_one_that_is_lit_at_first(bumps):
    assert bumps.hardest != BET_BUMP


def test_the_last_bump_whispers(bumps):
    loudest = np.abs(bumps.responses).max(axis=1)
    assert (np.diff(loudest) < 0).all()
    assert loudest[-1] < loudest[0] / 20


def test_what_the_browser_adds_is_what_the_robot_draws():
    settings = Settings.star(n_kernels=BUMP_NUMBER, kernel="mollifier", kernel_width=1.6)
    [stroke] = recording_of("a").strokes()
    learned = DMP.imitate(stroke, settings)
    weights = np.array(learned.weights)
    weights[BUMP_NUMBER - 3, 1] += 0.07
    values = {name: getattr(learned, name) for name in learned.__dataclass_fields__}
    drawn = DMP(**values | {"weights": weights}).rollout().position
    np.testing.assert_allclose(learn_bumps("a").write((3, 0.07)), drawn, atol=1e-9)


@pytest.mark.parametrize("pupil", PUPILS)
def test_no_other_bump_can_mend_the_letter(pupil):
    lesson = TeachALetter(pupil)
    changes = np.linspace(*lesson.settable["change"], 41)
    for bump in range(1, BUMP_NUMBER + 1):
        solved = [lesson.check({"bump": bump, "change": float(by)}).done for by in changes]
        assert any(solved) == (bump == lesson.solution["bump"])


@pytest.mark.parametrize("pupil", PUPILS)
def test_the_fault_is_seen_on_paper_where_its_bump_is_awake_or_the_next(pupil):
    lesson = TeachALetter(pupil)
    bumps, bump = lesson.bumps, lesson.spoilt[0]
    apart = bumps.write(lesson.spoilt)[:, None] - bumps.demonstration
    off = np.linalg.norm(apart, axis=2).min(axis=1)
    begin, end = bumps.awake(bump).start, bumps.awake(bump + 1).stop
    assert off[:begin].max() < 0.0035 < off[begin:end].max()


@pytest.mark.parametrize(
    ("bump", "share", "words"),
    [
        (0, 0.5, "too little"),
        (0, -1, "wrong way"),
        (-2, 1, "later"),
        (3, 1, "earlier"),
        (0, 0, "0"),
    ],
)
def test_a_mistake_is_called_what_it_is(bump, share, words):
    lesson = TeachALetter()
    right = lesson.solution
    answer = {"bump": right["bump"] + bump, "change": share * right["change"]}
    assert words in lesson.check(answer).reason
