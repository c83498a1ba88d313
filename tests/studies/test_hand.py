"""The laws of a hand: exponents that ink was made with come back, and intervals hold them."""

import numpy as np
import pytest
from scipy.interpolate import CubicSpline

import dmp_teach as teach
from dmp_teach.errors import RecordingError, ViewError
from dmp_teach.studies import measure_hand
from dmp_teach.trajectory import arc_lengths, path_length

TURNS = np.linspace(0, 2 * np.pi, 4001)
DRAWN = teach.recording_of("e").strokes()[0].position[::4]
SHAPES = {
    "ellipse": np.column_stack([np.cos(3 * TURNS), np.sin(3 * TURNS) / 2]) / 2,
    "eights": np.column_stack([np.sin(2 * TURNS), np.sin(4 * TURNS) / 2]) / 2,
    "loops": np.column_stack([np.cos(4 * TURNS) / 4 + TURNS / 5, np.sin(4 * TURNS) / 2]),
    "e": CubicSpline(arc_lengths(DRAWN), DRAWN / np.ptp(DRAWN[:, 1]))(
        np.linspace(0, path_length(DRAWN), 4001)
    ),
}


def written(name, beta, size=0.08, duration=2.0, *, rate=100, noise=0.0, seed=0):
    """A shape at the speed curvature^-beta; near-straight parts at that of a slight bend."""
    path = SHAPES[name] * size
    s = arc_lengths(path)
    tangent = np.gradient(path, s, axis=0, edge_order=2)
    turn = np.gradient(tangent, s, axis=0, edge_order=2)
    curvature = np.abs(tangent[:, 0] * turn[:, 1] - tangent[:, 1] * turn[:, 0])
    slowness = np.maximum(curvature, 0.3 / size) ** beta
    t = np.concatenate([[0], np.cumsum(np.diff(s) * (slowness[1:] + slowness[:-1]))])
    clock = np.arange(round(duration * rate) + 1) / rate
    ink = CubicSpline(t * duration / t[-1], path)(clock)
    ink += noise * np.random.default_rng(seed).normal(size=ink.shape)
    return teach.Trajectory(clock, ink)


@pytest.mark.parametrize("beta", [0.2, 1 / 3, 0.5])
@pytest.mark.parametrize("name", SHAPES)
def test_an_exponent_comes_back_within_5_percent(name, beta):
    """Small, large and quick, by a pen that trembles by a tenth of a millimetre."""
    small = written(name, beta, 0.05, rate=60, noise=1e-4)
    large = written(name, beta, 0.12, 2.4, rate=240, noise=1e-4)
    quick = written(name, beta, duration=1.4, noise=1e-4, seed=1)
    assert measure_hand([small, large], quick).bending.value == pytest.approx(beta, rel=0.05)


def test_the_interval_holds_the_exponent_that_ink_was_made_with():
    held = []
    for seed in range(12):
        name, beta = list(SHAPES)[seed % 4], (0.2, 0.35, 0.5)[seed % 3]
        found = measure_hand(written(name, beta, noise=2e-4, seed=seed)).bending
        held.append(found.low < beta < found.high)
        assert found.high - found.low < 0.35
    assert np.mean(held) >= 0.85


@pytest.mark.parametrize("power", [0.0, 0.2, 1.0])
def test_time_grows_as_it_was_made_to(power):
    sizes = np.array([0.03, 0.05, 0.08, 0.12])
    chance = np.exp(0.02 * np.random.default_rng(5).normal(size=4))
    takes = [
        written("e", 1 / 3, size, 2 * (size / 0.05) ** power * odd)
        for size, odd in zip(sizes, chance, strict=True)
    ]
    found = measure_hand(takes, quick=written("e", 1 / 3, duration=1.0)).growth
    assert found.low < power < found.high
    assert found.value == pytest.approx(power, abs=0.05)


def test_what_is_not_known_is_not_told():
    """Two sizes have no interval, one has no growth, and a line no bends."""
    small, large = written("e", 1 / 3, 0.04), written("e", 1 / 3, 0.09)
    assert np.isnan(measure_hand([small, large]).growth.low)
    assert np.isnan(measure_hand(small).growth.value)
    line = teach.Trajectory([0.0, 0.5, 1.0], [[0, 0], [0.05, 0], [0.1, 0]])
    assert repr(measure_hand(line)).startswith("Too few bends")
    with pytest.raises(RecordingError):
        measure_hand([])


def test_a_hand_is_told_in_three_lines_and_drawn_beside_ours():
    usual = [written("e", 0.3, 0.04), written("e", 0.3, 0.09)]
    hand = measure_hand(usual, quick=written("e", 0.3, 0.06, duration=1.0))
    lines = repr(hand).splitlines()
    assert lines[0].startswith("Your speed falls as curvature^-0.30 (0.")
    assert lines[1] == "Your time grows as size^0.00; isochrony: 0"
    assert lines[2] == f"In haste you are {hand.haste:.1f} times as fast."
    figure = teach.figures.draw_hand_laws({"you": hand, "ours": measure_hand(usual[0])})
    assert [label.get_text() for label in figure.axes[1].get_yticklabels()] == ["you", "ours"]
    with pytest.raises(ViewError):
        teach.figures.draw_hand_laws({})
