"""Error against width and number: what must hold for any ink."""

import numpy as np
import pytest

from dmp_teach.dmp.primitive import DMP
from dmp_teach.dmp.settings import Settings
from dmp_teach.errors import SettingError
from dmp_teach.studies.experiments.error_curves import (
    SWEPT_WIDTHS,
    sweep_kernel_number,
    sweep_kernel_width,
)
from dmp_teach.studies.experiments.variants import WIDTH_VARIANTS, Variant
from dmp_teach.trajectory import Trajectory
from tests.dmp.ink import letter, rms

INK = [letter(200, 1.7, seed=seed) for seed in range(3)]


def test_a_curve_holds_what_one_gets_by_hand():
    settings = Settings.star(n_kernels=20, sharpen=False, feed_goal=False, kernel_width=2.0)
    curves = sweep_kernel_width(INK, widths=(1.0, 2.0))
    by_hand = rms(DMP.imitate(INK[1], settings).rollout().position, INK[1].position)
    assert 1e3 * curves.of("box, LWR")[1, 1] == pytest.approx(by_hand)
    assert curves.numbers[curves.variants.index("box, LWR"), 1, 1] == 20


def test_every_kernel_and_fit_has_its_error_at_every_width():
    curves = sweep_kernel_width(INK[:1])
    assert curves.error.shape == (len(WIDTH_VARIANTS), 1, len(SWEPT_WIDTHS))
    missing = np.isnan(curves.error)
    assert missing.sum() == 1  # a mollifier without ends
    assert missing[curves.variants.index("mollifier, LWR"), 0, -1]


def test_gaps_cost_more_than_touching_kernels_whatever_the_fit():
    curves = sweep_kernel_width(INK, widths=(0.5, 1.0))
    # With as many kernels as samples the program's leave no sample bare.
    few = [curves.variants.index("the authors' program")]
    narrow, touching = (np.delete(curves.at(x), few, axis=0) for x in (0.5, 1.0))
    assert (narrow > 2 * touching).all()


def test_error_does_not_depend_on_place_and_grows_with_size():
    one = sweep_kernel_width(INK[:1], widths=(1.0, 4.0))
    moved = Trajectory(INK[0].t + 7, 3 * INK[0].position + [0.2, -0.4])
    np.testing.assert_allclose(
        sweep_kernel_width([moved], widths=(1.0, 4.0)).error, 3 * one.error, rtol=1e-6, atol=1e-12
    )


def test_numbers_go_from_five_to_half_of_the_samples():
    curves = sweep_kernel_number(INK)
    assert curves.numbers.min() == 5
    assert curves.numbers.max() == 100
    assert 0.1 in curves.x
    assert (np.diff(curves.numbers, axis=2) >= 0).all()
    ours = curves.of("our DMP*")
    assert (ours[:, -1] < ours[:, 0] / 10).all()


def test_a_stroke_of_few_samples_has_no_more_kernels_than_samples():
    curves = sweep_kernel_number([letter(8, 0.3)])
    assert curves.numbers.max() <= 8
    assert np.isfinite(curves.error).all()
    narrow = sweep_kernel_width([letter(8, 0.3)], widths=(1.0,))
    assert narrow.numbers.max() <= 8


def test_values_are_locked_and_rows_say_their_units():
    curves = sweep_kernel_width(
        INK[:1], widths=(1.0, np.inf), variants={"mine": Variant(Settings.star())}
    )
    with pytest.raises(ValueError, match="read-only"):
        curves.error[0] = 0
    assert list(curves.rows()[0]) == ["width [1/N]", "mine [mm]", "mine, sum [m]"]
    head, _, first, _ = curves.table().splitlines()
    assert head.split()[:4] == ["width", "[1/N]", "mine", "[mm]"]
    assert float(first.split()[1]) == pytest.approx(1e3 * curves.error[0, 0, 0], rel=1e-3)
    assert str(curves) == curves.table()
    assert curves._repr_html_().count("<tr>") == 3


def test_a_variant_that_is_not_there_is_answered_with_those_that_are():
    with pytest.raises(
        SettingError, match="There is no variant 'x'; there are: the authors' 200 kernels, "
    ):
        sweep_kernel_width(INK[:1], widths=(1.0,)).of("x")
