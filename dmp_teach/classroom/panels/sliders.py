"""Sliders of ipywidgets for any settings, for who builds a panel of one's own."""

from __future__ import annotations

import math
from dataclasses import replace

import ipywidgets
import traitlets

from dmp_teach.arguments import checked
from dmp_teach.dmp import Knob, Settings, as_settings, knob_of
from dmp_teach.errors import SettingError
from dmp_teach.texts import gettext as _


@checked
def sliders(settings: Settings | None = None, *names: str, duration: float = 3.0) -> Sliders:
    """Show sliders for settings, with their names and ranges.

        knobs = teach.sliders(teach.Settings.star(), "n_kernels", "kernel_width")
        ipywidgets.jslink((knobs.controls["n_kernels"], "value"), (panel, "n_kernels"))

    Args:
        settings: Where they begin; None: DMP*. What is None there begins as for a movement of
            this duration, what is endless at the slider's end.
        names: Fields of `Settings`; none: `n_kernels` and `kernel_width`.
        duration: Of a movement [s].

    Raises:
        SettingError: No settings, or there is no such field.
    """
    return Sliders(as_settings(settings), names or ("n_kernels", "kernel_width"), duration)


class Sliders(ipywidgets.VBox):
    """Controls for settings: `controls` has a widget for each name, `settings` what they say."""

    settings = traitlets.Instance(Settings)

    def __init__(self, settings: Settings, names: tuple[str, ...], duration: float):
        start = settings.resolved(duration, samples=1_000_000)
        self.controls = {name: _make_control(knob_of(name), start) for name in names}
        self._said = ipywidgets.Label()
        self._base = settings
        super().__init__([*self.controls.values(), self._said])
        for control in self.controls.values():
            control.observe(self._read, "value")
        self._read()

    def _read(self, _change: object = None) -> None:
        """Take up what the controls say; values that do not go together change nothing."""
        try:
            values = {name: control.value for name, control in self.controls.items()}
            self.settings = replace(self._base, **values)
            self._said.value = ""
        except SettingError as error:
            self._said.value = str(error)


def _make_control(knob: Knob, start: Settings) -> ipywidgets.DOMWidget:
    """Return the widget for one setting."""
    value = getattr(start, knob.name)
    look = {
        "description": _(knob.label).capitalize(),
        "tooltip": _(knob.term),
        "style": {"description_width": "16em"},
        "layout": ipywidgets.Layout(width="auto"),
    }
    if knob.options:
        is_yes_or_no = set(knob.choices) == {True, False}
        kind = ipywidgets.Checkbox if is_yes_or_no else ipywidgets.Dropdown
        return kind(value=value, **look, **({} if is_yes_or_no else {"options": knob.choices}))
    value = min(max(knob.high if value is None else value, knob.low), knob.high)
    ends = {"min": knob.low, "max": knob.high}
    if knob.whole:
        return ipywidgets.IntSlider(value, **look, **ends)
    if knob.high > 50 * knob.low > 0:
        ends = {end: math.log10(at) for end, at in ends.items()}
        return ipywidgets.FloatLogSlider(value, **look, **ends, step=0.02)
    return ipywidgets.FloatSlider(value, **look, **ends, step=(knob.high - knob.low) / 100)
