"""Settings: ranges written once, presets, and what is said when something is out of range."""

import dataclasses
import math
import re

import numpy as np
import pytest

from dmp_teach.dmp.phases import PHASES
from dmp_teach.dmp.settings import Settings, knob_of, knobs
from dmp_teach.errors import SettingError, TeachError


def test_every_setting_has_a_default_a_plain_name_and_a_range_or_choices():
    assert [each.name for each in knobs()] == [each.name for each in dataclasses.fields(Settings)]
    for each in knobs():
        assert each.label
        assert each.term
        assert each.choices or each.low < each.high <= (each.limit or each.high)
        assert each.checked(each.default) == each.default
    width = knob_of("kernel_width")
    assert (width.default, width.low, width.high) == (1.0, 0.2, 40.0)
    assert (width.label, width.term) == ("how wide each bump is", "kernel width")


@pytest.mark.parametrize(
    "each", [each for each in knobs() if not each.choices], ids=lambda each: each.name
)
def test_a_number_is_taken_at_the_ends_of_its_range_and_refused_beyond(each):
    limit = each.limit or each.high
    for fine in (each.low, each.high, limit):
        assert getattr(Settings(**{each.name: fine}), each.name) == fine
    for bad in (each.low - 1, limit + 1, math.nan, "wide", [1], True):
        with pytest.raises(
            SettingError, match=f"{each.name} is {re.escape(repr(bad))}, but it must be .*between"
        ):
            Settings(**{each.name: bad})


def test_an_error_says_what_it_is_and_what_it_must_be():
    with pytest.raises(SettingError) as caught:
        Settings.star(kernel_width=0.0)
    assert str(caught.value) == "kernel_width is 0.0, but it must be between 0.2 and 40."
    assert isinstance(caught.value, (TeachError, ValueError))
    with pytest.raises(SettingError) as caught:
        Settings(n_kernels=2.5)
    assert (
        str(caught.value) == "n_kernels is 2.5, but it must be a whole number between 1 and 3000."
    )
    with pytest.raises(SettingError) as caught:
        Settings(phase="linnear")
    assert (
        str(caught.value)
        == f"phase is 'linnear', but it must be one of: {', '.join(map(repr, PHASES))}."
    )
    with pytest.raises(SettingError, match=r"^kernel_width is None, but it must be between"):
        Settings(kernel_width=None)


@pytest.mark.parametrize(
    ("name", "value"),
    [("alpha", 10**5000), ("kernel_width", np.array([1, 2])), ("damping", np.True_)],
    ids=["alpha", "kernel_width", "damping"],
)
def test_what_is_no_number_is_refused_by_name(name, value):
    with pytest.raises(SettingError, match=f"^{name} is"):
        Settings.star(**{name: value})


def test_a_choice_is_kept_as_the_option_that_it_is():
    assert Settings.star(sharpen=np.True_).sharpen is True


def test_an_unknown_setting_is_answered_with_those_that_exist():
    for ask in (lambda: Settings.joint(kernel_widht=2.0), lambda: knob_of("kernel_widht")):
        with pytest.raises(
            SettingError,
            match=r"There is no setting 'kernel_widht'. The settings are: n_kernels, kernel_wid",
        ):
            ask()


def test_presets_are_those_of_the_design_and_take_changes():
    star, original, joint, plus = (
        Settings.star(),
        Settings.original(),
        Settings.joint(),
        Settings.plus(),
    )
    assert star == Settings()
    assert (star.phase, star.transform, star.fit, star.integrator) == (
        "linear",
        "star",
        "lwr",
        "explicit",
    )
    assert (star.kernel_width, star.kernel_sigma, star.smoothing, star.feed_goal) == (
        1.0,
        math.inf,
        10.0,
        True,
    )
    assert (original.phase, original.phase_decay, original.transform) == (
        "exponential",
        4.6,
        "original",
    )
    assert (original.kernel_width, original.kernel_sigma, original.alpha) == (math.inf, 0.65, 25.0)
    assert (original.fit, original.feed_goal) == ("lwr", False)
    assert (joint.fit, joint.kernel_sigma, joint.integrator) == ("joint", 0.65, "semi-implicit")
    assert (plus.fit, plus.kernel_width, plus.alpha_per_kernel) == ("bias", 1.0, 3.0)
    assert Settings.star(kernel_width=2.0) == dataclasses.replace(star, kernel_width=2.0)
    assert Settings.original(alpha=None).alpha is None
    with pytest.raises(dataclasses.FrozenInstanceError):
        star.alpha = 3.0


def test_numbers_are_found_from_the_movement_where_none_are_given():
    assert Settings.star().resolved(2.5, 300).n_kernels == 30
    assert Settings.star().resolved(2.5, 300).alpha == 60
    assert Settings.plus().resolved(2.5, 300).alpha == 90
    assert Settings.star().resolved(0.01, 300).n_kernels == 1
    assert Settings.star().resolved(0.01, 300).alpha == 12
    assert Settings.star().resolved(2.5, 5).n_kernels == 5
    assert Settings.star(n_kernels=7, alpha=33).resolved(2.5, 300).alpha == 33
