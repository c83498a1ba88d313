"""Kernels chosen by drawing samples that were not shown."""

import numpy as np
import pytest

from dmp_teach.dmp.primitive import DMP
from dmp_teach.dmp.settings import Settings
from dmp_teach.errors import SettingError, TrajectoryError
from dmp_teach.ink.alphabet import recording_of
from dmp_teach.studies.experiments.validation import choose_kernels, choose_width
from dmp_teach.trajectory import Trajectory
from tests.dmp.ink import letter


def wave(turns, noise=0.0, samples=301, seconds=2.5):
    t = np.linspace(0, 1, samples)
    path = 0.05 * np.column_stack([np.cos(2 * np.pi * turns * t), np.sin(2 * np.pi * turns * t)])
    return Trajectory(seconds * t, path + noise * np.random.default_rng(0).normal(size=path.shape))


def test_more_turns_need_more_kernels():
    chosen = [choose_kernels(wave(turns)).chosen for turns in (1, 2, 4)]
    assert chosen[0] < chosen[1] < chosen[2]


def test_noise_is_not_learned():
    """With one kernel for every sample shown, the noise is drawn: others are missed by more."""
    settings = Settings.plus(smoothing=None)
    choice = choose_kernels(wave(1, noise=0.001), settings, tolerance=0.0)
    assert choice.best < choice.candidates[-1]
    assert choice.chosen <= choice.best
    assert choice.taught[-1] < choice.error[-1]


def test_the_choice_is_the_smallest_that_is_near_enough():
    choice = choose_kernels(wave(2), candidates=[40, 5, 20, 10], tolerance=0.0)
    assert list(choice.candidates) == [5, 10, 20, 40]
    enough = choice.error <= 1.1 * choice.error.min()
    assert choice.chosen == choice.candidates[enough][0]
    assert choose_kernels(wave(2), candidates=[5, 10, 20, 40], tolerance=1.0).chosen == 5


def test_both_rules_of_thumb_stand_beside_the_choice():
    choice = choose_kernels(wave(2))
    assert (choice.tenth, choice.twelve_a_second, choice.samples) == (30, 30, 301)
    assert {30} <= set(choice.candidates)
    assert choice.sentence in str(choice)
    assert "Num/10 is 30 for 301 samples; 12 kernels a second are 30." in choice.sentence
    assert [row[""] for row in choice.rows()].count("chosen") == 1


def test_the_settings_of_a_choice_are_ready_to_learn_with():
    choice = choose_kernels(wave(1), Settings.joint(), candidates=(6, 12))
    assert len(DMP.imitate(wave(1), choice.settings).weights) == choice.chosen
    assert choice.settings.fit == "joint"


def test_touching_kernels_are_chosen_by_dmp_star():
    choice = choose_width(letter(300, 2.5, seed=4))
    assert choice.best == choice.chosen == choice.settings.kernel_width == 1.0


def test_a_recording_of_one_stroke_is_taken_and_of_two_is_sent_back():
    assert choose_kernels(recording_of("a"), candidates=(10, 20)).samples == len(
        recording_of("a").strokes()[0]
    )
    with pytest.raises(
        TrajectoryError, match=r"2 strokes.* choose for each of recording.strokes\(\)"
    ):
        choose_kernels(recording_of("D"))


def test_what_cannot_be_chosen_from_is_said():
    with pytest.raises(TrajectoryError, match="has 4 samples, but validation needs 6"):
        choose_kernels(letter(4, 1.0))
    with pytest.raises(SettingError, match="candidates is empty"):
        choose_kernels(wave(1), candidates=())
    with pytest.raises(
        SettingError, match="n_kernels is 200, but the trajectory has only 151 samples"
    ):
        choose_kernels(wave(1), candidates=(200,))
