"""Other ways to learn: each arrives where it says it does, with the demonstrations that it needs.

Writers drawn by lot, whom no constant has seen, show the letters.
"""

import numpy as np
import pytest

import dmp_teach as teach
from dmp_teach.errors import MissingPartError, SettingError, TrajectoryError, ViewError
from dmp_teach.studies import (
    WAYS,
    GaussianWay,
    compare_ways_to_learn,
    draw_takes,
    even_path,
)
from dmp_teach.trajectory import Trajectory, path_length, rms
from tests.studies.pupils import Pupil

pytest.importorskip("sklearn")
pytest.importorskip("hmmlearn", reason="it has no wheel for this computer")

STAR, MIXTURE, MARKOV, COST, PROMP = WAYS
ONE_LETTER = pytest.mark.parametrize("takes", ["a"], indirect=True)


@pytest.fixture(scope="module", params="aS")
def takes(request):
    pupil = Pupil(40)
    return tuple(pupil.writes(request.param, take).strokes[0] for take in range(6))


def gap(a, b):
    """Two writings apart, as a share of the letter's size."""
    return rms(even_path(a) - even_path(b)) / np.ptp(b.position, axis=0).max()


@pytest.mark.parametrize(("name", "share"), [(STAR, 0.005), (MARKOV, 0.015), (COST, 0.01)])
def test_one_demonstration_is_copied_and_led_to_any_goal(takes, name, share):
    way = WAYS[name].learn(takes[:1])
    assert gap(way.write(), takes[0]) < share
    goal = takes[0].position[-1] + [0.04, 0.03]
    assert np.linalg.norm(way.write(goal).position[-1] - goal) < 5e-4


def test_a_mean_and_spread_needs_one_take_more_than_both_ends_have_coordinates(takes):
    goal = takes[0].position[-1] + [0.03, 0.02]
    misses, strays = {}, {}
    for count in (1, 4, 5):
        way = WAYS[PROMP].learn(takes[:count])
        led = way.write(goal).position
        misses[count] = np.linalg.norm(led[-1] - goal)
        strays[count] = np.linalg.norm(led[0] - way.write().position[0])
    alone = WAYS[PROMP].learn(takes[:1])
    assert gap(alone.write(), takes[0]) < 0.01
    assert np.allclose(alone.write(goal).position, alone.write().position, atol=1e-9)
    assert misses[4] > 1e-3
    assert max(misses[5], strays[5]) < 1e-4


def test_a_mixture_arrives_from_elsewhere_and_has_lost_the_letter(takes):
    way = WAYS[MIXTURE].learn(takes)
    own = way.write().position
    assert path_length(own) > 2 * np.linalg.norm(own[-1] - own[0])
    for shift in ([0.25, 0.2], [-0.3, 0.1], [0.3, -0.2]):
        goal = own[-1] + shift
        written = way.write(goal)
        assert np.linalg.norm(written.position[-1] - goal) < 0.01
        assert path_length(written.position) < 1.3 * np.linalg.norm(goal - own[0])
        assert written.duration <= 1.5 * way.duration + 1e-9


def test_only_dmp_star_writes_the_whole_letter_along_with_its_goal(takes):
    """The others keep it in its place and hurry at the end."""
    moved = {}
    for name in (STAR, MARKOV, COST):
        way = WAYS[name].learn(takes[:1])
        own = way.write()
        led = way.write(own.position[-1] + [0.1, 0.0])
        moved[name] = np.linalg.norm(led.position - own.position, axis=1)
    half = {name: each[len(each) // 2] for name, each in moved.items()}
    assert half[STAR] > 0.03
    assert max(half[MARKOV], half[COST]) < 0.01


def test_averages_are_nearer_to_what_was_meant_than_any_one_take():
    """Where DMP* is not the best: it copies the slips of the one take that it saw."""
    model = teach.recording_of("e").strokes()[0]
    hands = [draw_takes(model, 5, seed) for seed in range(5)]
    names = STAR, MARKOV, COST, PROMP
    errors = {n: [gap(WAYS[n].learn(takes).write(), model) for takes in hands] for n in names}
    star, *others = (np.mean(each) for each in errors.values())
    assert max(others) < 0.7 * star
    firsts = [gap(takes[0], model) for takes in hands]
    assert errors[STAR] == pytest.approx(firsts, rel=0.05)


@ONE_LETTER
@pytest.mark.parametrize("name", [name for name in WAYS if issubclass(WAYS[name], GaussianWay)])
def test_paths_follow_their_end_in_proportion(takes, name):
    way = WAYS[name].learn(takes)
    own, shift = way.write().position, np.array([0.02, -0.01])
    once, twice = (way.write(own[-1] + k * shift).position - own for k in (1, 2))
    assert np.allclose(2 * once, twice, atol=1e-9)


@ONE_LETTER
@pytest.mark.parametrize("name", [name for name in WAYS if name != STAR])
def test_a_way_does_not_mind_where_how_large_and_how_fast_it_was_shown(name, takes):
    there = [Trajectory(2 * take.t + 5, 3 * take.position + [1.0, -2.0]) for take in takes]
    here, away = (WAYS[name].learn(each).write() for each in (takes, there))
    assert np.allclose(3 * here.position + [1.0, -2.0], away.position, atol=2e-4)
    assert away.duration == pytest.approx(2 * here.duration)


@ONE_LETTER
def test_numbers_stored_are_counted_by_their_formulas(takes):
    stored = {name: way.learn(takes[:2]).numbers_stored for name, way in WAYS.items()}
    weights = teach.DMP.imitate(takes[0]).weights.size
    # Weights, start, goal, velocity, duration; 10 components of 6; 16 states; 20 places; 20 bumps.
    assert stored == {
        STAR: weights + 7,
        MIXTURE: 10 * (1 + 6 + 21) + 5,
        MARKOV: 16 * (6 + 6 + 1) + 1,
        COST: 20 * 3 + 2,
        PROMP: 40 + 40 * 41 // 2 + 1,
    }


@ONE_LETTER
@pytest.mark.parametrize("name", WAYS)
def test_what_is_no_demonstration_is_refused(name, takes):
    flat = Trajectory(takes[0].t, takes[0].position[:, 0])
    for odd in ((), None, "abc", (1, 2), (takes[0], flat)):
        with pytest.raises(TrajectoryError):
            WAYS[name].learn(odd)
    with pytest.raises(TrajectoryError):
        WAYS[name].learn(takes[:1]).write((1.0, 2.0, 3.0))


@ONE_LETTER
def test_a_missing_library_is_named(monkeypatch, takes):
    monkeypatch.setitem(__import__("sys").modules, "hmmlearn.hmm", None)
    with pytest.raises(MissingPartError, match="pip install hmmlearn"):
        WAYS[MARKOV].learn(takes)


def test_more_takes_begin_with_the_same():
    model = teach.recording_of("c").strokes()[0]
    some, more = draw_takes(model, 2, seed=9), draw_takes(model, 4, seed=9)
    assert all(np.array_equal(a.position, b.position) for a, b in zip(some, more, strict=False))
    spread = np.std([even_path(take) for take in draw_takes(model, 40)], axis=0)
    assert 0.02 < np.sqrt((spread**2).sum(axis=1).mean()) / 0.072 < 0.09


@ONE_LETTER
def test_all_ways_stand_in_one_table_and_one_figure(takes):
    tried = compare_ways_to_learn([(take,) for take in takes], numbers=(1, 5), shift=(0.03, 0.02))
    rows = tried.rows()
    assert [(row["way"], row["shown"]) for row in rows] == [(w, n) for n in (1, 5) for w in WAYS]
    assert rows[0]["from the first take [mm]"] < 1 < rows[0]["from the letter [mm]"]
    assert len(str(tried).splitlines()) == 12
    figure = teach.figures.draw_ways_to_learn(tried)
    assert len(figure.axes) == 10
    with pytest.raises(ViewError, match="1, 5"):
        teach.figures.draw_ways_to_learn(tried, numbers=(3,))
    for odd in ((), 5):
        with pytest.raises(ViewError, match="numbers"):
            teach.figures.draw_ways_to_learn(tried, numbers=odd)


@pytest.mark.parametrize("name", ["stroke", "fetch", "executor", "progress"])
def test_what_a_comparison_cannot_use_is_refused_by_name(name):
    with pytest.raises(SettingError, match=name):
        compare_ways_to_learn(numbers=(1,), **{name: 0.5})


@pytest.mark.parametrize("draw", [teach.figures.draw_ways_to_learn, teach.figures.draw_writing])
def test_nothing_is_not_drawn(draw):
    with pytest.raises(ViewError, match="None"):
        draw(None)


@ONE_LETTER
@pytest.mark.parametrize("numbers", [(0,), (6,), (), (True, "a"), (1.0,), (True,), 6, 1.0])
def test_numbers_that_cannot_be_shown_are_refused(takes, numbers):
    with pytest.raises(SettingError, match="from 1 to 5"):
        compare_ways_to_learn(takes, numbers=numbers)
