"""A letter: its strokes learned, and written with other starts and goals on one clock."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dmp_teach.dmp.settings import Settings
from dmp_teach.errors import LetterError, TrajectoryError
from dmp_teach.ink import svg_repr as drawing
from dmp_teach.ink.alphabet import recording_of
from dmp_teach.letters.letter import Letter, rms_distance
from dmp_teach.trajectory import Trajectory
from tests.dmp.ink import letter as scrawl
from tests.dmp.ink import rms

SHIFT = (0.03, -0.01)


@pytest.fixture(scope="module")
def letter_d():
    return Letter.learn(recording_of("D"))


def test_a_letter_is_written_as_it_was_shown(letter_d):
    assert len(letter_d.strokes) == len(letter_d.primitives) == len(letter_d.write()) == 2
    for shown, written in zip(letter_d.strokes, letter_d.write(), strict=True):
        assert np.array_equal(shown.t, written.t)
        assert rms(shown.position, written.position) < 0.3


@pytest.mark.parametrize("character", list("aem8"))
@pytest.mark.parametrize("seconds", [0.25, 0.4, 0.7])
def test_a_letter_that_was_written_in_a_moment_is_learned_as_finely_as_a_slow_one(
    character, seconds
):
    """As a pad sees it: 120 points a second at most."""
    (slow,) = recording_of(character).strokes()
    t = np.linspace(0, seconds, round(120 * seconds) + 1)
    quick = Trajectory(
        t,
        np.column_stack(
            [np.interp(t / seconds * slow.duration, slow.t - slow.t[0], x) for x in slow.position.T]
        ),
    )
    size = np.ptp(quick.position, axis=0).max()
    assert Letter.learn((quick,)).error < 0.02 * size
    if seconds < 0.5:
        assert Letter.learn((quick,), Settings.star()).error > 0.02 * size


def test_a_letter_of_ordinary_pace_is_learned_with_the_kernels_of_the_preset():
    for character in "aDm":
        recording = recording_of(character)
        for mine, preset in zip(
            Letter.learn(recording).primitives,
            Letter.learn(recording, Settings.star()).primitives,
            strict=True,
        ):
            assert mine.settings == preset.settings


def test_a_scribble_that_no_kernels_follow_is_learned_as_well_as_may_be():
    t = np.linspace(0, 0.05, 8)
    zigzag = Trajectory(t, np.column_stack([t, 0.05 * (-1.0) ** np.arange(8)]))
    assert np.isfinite(Letter.learn((zigzag,)).error)


def test_only_the_stroke_whose_goal_moves_is_changed(letter_d):
    before, after = letter_d.write(), letter_d.write(goal_shifts={1: SHIFT})
    assert np.array_equal(before[0].position, after[0].position)
    moved = after[1].position[-1] - before[1].position[-1]
    assert moved == pytest.approx(SHIFT, abs=4e-4)
    assert np.array_equal(after[1].position[0], before[1].position[0])


def test_a_goal_is_absolute_and_a_shift_is_from_the_taught_goal(letter_d):
    goal = letter_d.primitives[1].goal + SHIFT
    absolute, relative = letter_d.write(goals={1: goal}), letter_d.write(goal_shifts={1: SHIFT})
    assert np.array_equal(absolute[1].position, relative[1].position)


def test_starts_are_absolute(letter_d):
    start = letter_d.primitives[0].start + SHIFT
    assert np.allclose(letter_d.write(starts={0: start})[0].position[0], start)
    assert letter_d.write(starts={0: start})[0].position[-1] == pytest.approx(
        letter_d.write()[0].position[-1], abs=4e-4
    )


@settings(deadline=None, max_examples=30)
@given(st.floats(0.25, 4.0))
def test_a_new_duration_stretches_the_whole_clock_evenly_lifts_too(factor):
    letter = Letter.learn(recording_of("D"))
    as_shown, slow = letter.write(), letter.write(duration=factor * letter.duration)
    begin = as_shown[0].t[0]
    for before, after in zip(as_shown, slow, strict=True):
        assert np.allclose(after.t - begin, factor * (before.t - begin), rtol=1e-9, atol=1e-9)
        assert np.array_equal(after.position, before.position)


def test_a_letter_is_learned_from_strokes_or_one_stroke_too():
    one = scrawl(100, 1.0)
    two = scrawl(100, 1.0, begin=1.5)
    assert len(Letter.learn([one, two]).primitives) == 2
    assert len(Letter.learn(one).strokes) == 1
    assert Letter.learn(s for s in (one, two)).duration == 2.5
    assert Letter.learn(one, Settings.plus()).primitives[0].biases is not None


@pytest.mark.parametrize(
    ("asked", "answer"),
    [
        ({"goals": {2: (0, 0)}}, "goals names stroke 2, but this letter has stroke 0, 1."),
        ({"starts": {-1: (0, 0)}}, "starts names stroke -1, but this letter has stroke 0, 1."),
        (
            {"goal_shifts": {"last": (0, 0)}},
            "goal_shifts names stroke 'last', but this letter has stroke 0, 1.",
        ),
        (
            {"goals": {1: (0, 0)}, "goal_shifts": {1: (0, 0)}},
            "Stroke 1 has a goal and a goal shift; give one of them.",
        ),
        (
            {"goal_shifts": {1: (0, 0, 0)}},
            r"The goal shift of stroke 1 is \(0, 0, 0\), but it must be 2 numbers \[m\].",
        ),
        (
            {"goal_shifts": {1: "far"}},
            r"The goal shift of stroke 1 is 'far', but it must be 2 numbers \[m\].",
        ),
        (
            {"goal_shifts": {1: 0.1}},
            r"The goal shift of stroke 1 is 0.1, but it must be 2 numbers \[m\].",
        ),
        (
            {"goal_shifts": {1: (math.nan, 0)}},
            r"The goal shift of stroke 1 is \(nan, 0\), but it must be finite \[m\].",
        ),
        (
            {"goals": [(0, 0)]},
            r"goals must be a dictionary, stroke number: point \[m\], but is a list.",
        ),
        ({"duration": 0}, "duration is 0, but it must be a time longer than 0 s."),
        ({"duration": math.inf}, "duration is inf, but it must be a time longer than 0 s."),
        ({"duration": "slow"}, "duration is 'slow', but it must be a time longer than 0 s."),
    ],
)
def test_what_cannot_be_written_is_said_in_a_sentence(letter_d, asked, answer):
    with pytest.raises(LetterError, match=f"^{answer}$"):
        letter_d.write(**asked)


def test_a_goal_that_is_no_point_is_said_by_the_stroke(letter_d):
    with pytest.raises(TrajectoryError, match=r"goal is \[nan +0.\], but it must be finite"):
        letter_d.write(goals={0: (math.nan, 0)})


def test_what_cannot_be_learned_is_said_in_a_sentence():
    one, two = scrawl(100, 1.0), scrawl(100, 1.0, begin=0.5)
    for nothing, what in (
        ([], "nothing"),
        ([one, 3], "an int"),
        (None, "None"),
        ("a.csv", "a str"),
    ):
        with pytest.raises(
            LetterError,
            match=f"learned from a recording or from strokes .Trajectory., but got {what}",
        ):
            Letter.learn(nothing)
    with pytest.raises(
        LetterError, match=r"Stroke 1 begins at 0.5 s, before stroke 0 ends at 1.0 s"
    ):
        Letter.learn([one, two])


def test_strokes_are_the_demonstration_itself():
    one = Trajectory([0, 0.5, 1.0], [[0, 0], [0.01, 0.02], [0.03, 0.01]])
    letter = Letter.learn([one])
    assert letter.strokes[0] is one
    assert np.isfinite(letter.write()[0].position).all()


def test_the_distance_of_a_letter_to_itself_moved_by_a_centimetre_is_a_centimetre():
    stroke = Trajectory(np.linspace(0, 1, 9), np.random.default_rng(1).normal(size=(9, 2)))
    moved = Trajectory(stroke.t, stroke.position + np.array([0.006, 0.008]))
    assert rms_distance((stroke,), (moved,)) == pytest.approx(0.01)
    assert rms_distance((stroke, stroke), (stroke, moved)) == pytest.approx(0.01 / math.sqrt(2))


def test_a_letter_may_be_written_in_one_stroke_that_never_stops(letter_d):
    one = letter_d.chain(overlap=-0.3, goal_shifts={1: SHIFT})
    durations = [p.duration for p in letter_d.primitives]
    assert one.duration == pytest.approx(sum(durations) + 0.3)
    assert one.t[0] == letter_d.strokes[0].t[0]
    assert one.position[0] == pytest.approx(letter_d.primitives[0].start)
    assert one.position[-1] == pytest.approx(letter_d.primitives[1].goal + SHIFT, abs=2e-3)
    shorter = letter_d.chain()
    assert shorter.duration == pytest.approx(sum(durations) - 0.1)
    moving = np.linalg.norm(np.diff(shorter.position, axis=0), axis=1) / np.diff(shorter.t)
    joint = np.abs(shorter.t[1:] - shorter.t[0] - durations[0]) < 0.2
    assert moving[joint].min() > 0.02


def test_what_cannot_be_joined_is_said_in_a_sentence(letter_d):
    with pytest.raises(
        LetterError, match=r"goals names stroke 2, but this letter has stroke 0, 1\."
    ):
        letter_d.chain(goals={2: (0, 0)})
    with pytest.raises(
        LetterError, match=r"Stroke 1 has a goal and a goal shift; give one of them\."
    ):
        letter_d.chain(goals={1: (0, 0)}, goal_shifts={1: (0, 0)})
    with pytest.raises(TrajectoryError, match=r"overlap is 9\.0, but it must be between -5 s and"):
        letter_d.chain(overlap=9.0)


def test_a_letter_says_in_one_line_how_well_it_was_learned():
    learned = Letter.learn(recording_of("D"))
    assert f"{1000 * learned.error:.2f} mm rms" in repr(learned)
    assert repr(learned).startswith("Letter(2 strokes, ")


def test_a_letter_below_a_cell_is_the_robots_line():
    letter = Letter.learn(recording_of("D"))
    picture = letter._repr_svg_()
    assert drawing.ROBOT_INK in picture
    assert picture.count("<circle") == 2
    assert repr(letter) in picture.replace("&gt;", ">")


def test_strokes_of_a_letter_have_as_many_dimensions():
    t = np.linspace(0, 1, 50)
    flat, high = (
        Trajectory(t, np.column_stack([t, t**2])),
        Trajectory(t + 2, np.column_stack([t, t**2, t])),
    )
    with pytest.raises(
        LetterError, match="Stroke 1 has 3 dimensions, but stroke 0 has 2; all strokes of a letter"
    ):
        Letter.learn((flat, high))
    assert Letter.learn((Trajectory(t, t[:, None]),))._repr_svg_() is None
