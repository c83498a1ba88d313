"""Sliders of one's own, as ipywidgets: named, bounded, and heard."""

import math

import ipywidgets
import pytest

import dmp_teach as teach
from dmp_teach.dmp import knobs


def test_a_slider_moves_the_settings_and_who_watches_hears():
    star = teach.Settings.star(n_kernels=20)
    made = teach.sliders(star, "n_kernels", "kernel_width")
    assert made.settings == star
    heard = []
    made.observe(lambda change: heard.append(change["new"].n_kernels), "settings")
    made.controls["n_kernels"].value = 30
    made.controls["kernel_width"].value = 2.5
    assert made.settings == teach.Settings.star(n_kernels=30, kernel_width=2.5)
    assert heard == [30, 30]
    assert made.controls["n_kernels"].description == "How many bumps"


@pytest.mark.parametrize("preset", ["star", "original", "joint", "plus", "as_printed", "as_coded"])
def test_every_knob_of_every_preset_has_a_control_that_begins_within_its_range(preset):
    settings = getattr(teach.Settings, preset)()
    for knob in knobs():
        made = teach.sliders(settings, knob.name)
        value, given = getattr(made.settings, knob.name), getattr(settings, knob.name)
        assert made.controls[knob.name].value == value
        is_shown = given is not None and (knob.options or knob.low <= given <= knob.high)
        assert not is_shown or value == pytest.approx(given) or math.isinf(given)


def test_a_count_that_a_preset_leaves_open_begins_as_for_a_movement_of_the_duration():
    resolved = teach.Settings.star().resolved(2.0, 1000)
    assert teach.sliders(duration=2.0).settings.n_kernels == resolved.n_kernels


def test_a_slider_can_drive_a_panel_and_interact_takes_the_controls():
    panel = teach.explore("e")
    made = teach.sliders(teach.Settings.star(n_kernels=20, kernel_width=1.0))
    for name, control in made.controls.items():
        ipywidgets.jslink((control, "value"), (panel, name))
        ipywidgets.link((control, "value"), (panel, name))
    made.controls["n_kernels"].value = 14
    assert panel.n_kernels == 14
    seen = []
    ipywidgets.interactive_output(lambda **values: seen.append(values), made.controls)
    made.controls["kernel_width"].value = 1.5
    assert seen[-1] == {"n_kernels": 14, "kernel_width": 1.5}


def test_values_that_do_not_go_together_change_nothing_and_say_why():
    made = teach.sliders(teach.Settings.star(alpha=25.0), "alpha", "damping")
    made.controls["damping"].value = 0.1
    made.controls["alpha"].value = 200
    said = made.children[-1].value
    assert (made.settings.alpha == 200) == (said == "")
    assert made.settings.damping == 0.1


@pytest.mark.parametrize("wrong", [("star",), (None, "n_kernel")])
def test_settings_or_names_that_are_not_there_are_refused(wrong):
    with pytest.raises(teach.SettingError, match=r"Settings\.star|The settings are: n_kernels"):
        teach.sliders(*wrong)
