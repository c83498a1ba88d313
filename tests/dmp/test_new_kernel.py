"""A kernel as a newcomer adds it, in one class, is complete: chosen, refused, tested and drawn."""

import math
import re

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dmp_teach.dmp import KERNELS, Kernels, Settings, knob_of
from dmp_teach.dmp.kernels import Kernel
from dmp_teach.dmp.primitive import DMP
from dmp_teach.errors import SettingError, SettingWarning
from dmp_teach.views import figures
from tests.dmp.ink import any_ink, kernel_settings, letter
from tests.dmp.test_every_law import CHOICES, calm, check


@pytest.fixture(scope="module", autouse=True)
def tent():
    @KERNELS.add
    class Tent(Kernel):
        """psi = 1 - |r|."""

        name = "tent"

        def height(self, r, z):
            return 1 - abs(r)

    yield Tent
    del KERNELS["tent"]


def test_it_is_a_choice_like_any_other():
    assert "tent" in knob_of("kernel").choices
    p = DMP.imitate(letter(), Settings.star(kernel="tent", kernel_width=2.0))
    heights = p.kernels.heights(np.array([0.5]))
    assert heights.sum() == pytest.approx(1)
    with pytest.raises(SettingError, match=r"one of: 'gaussian', 'mollifier'.*, 'tent'"):
        Settings(kernel="box")


@pytest.mark.parametrize(
    ("chosen", "words"),
    [
        ({"kernel_width": math.inf}, "a tent falls to 0 at its ends and must have some"),
        ({"kernel_sigma": 0.65}, "a tent has no sigma, its width alone shapes it"),
        ({"kernel_sides": "one"}, "this tent of kernel_width 1 cannot be left open"),
    ],
)
def test_settings_that_it_would_ignore_are_refused(chosen, words):
    with pytest.raises(SettingError, match=words):
        Settings.star(kernel="tent", **chosen)


def test_its_gaps_are_said_with_their_cure():
    with pytest.warns(SettingWarning, match="A tent is 0 at its ends: give it a kernel_width"):
        DMP.imitate(letter(), Settings.star(kernel="tent", kernel_centers="grid"))


@settings(max_examples=40, **calm)
@given(
    any_ink(),
    st.fixed_dictionaries({name: st.sampled_from(of) for name, of in CHOICES.items()}),
    st.integers(0, 10**6),
    st.tuples(*[st.floats(-2, 2)] * 3).map(np.array),
    st.floats(0.25, 4.0),
)
def test_it_keeps_every_law(demo, rest, pick, shift, factor):
    ours = [each for each in kernel_settings() if each["kernel"] == "tent"]
    check(demo, (ours[pick % len(ours)], rest), shift, factor)


def test_it_is_drawn_in_the_figure_of_kernels(tent):
    panels = figures.draw_kernel_types(5).axes
    assert panels[-1].get_title(loc="left").endswith(") tent: width 2/N")
    s = np.linspace(0, 1, 2001)
    drawn = panels[-1].lines[2].get_ydata()
    height = Kernels(5, 2.0, tent()).heights(s)[:, 2]
    np.testing.assert_allclose(drawn[np.isfinite(drawn)], height[np.isfinite(drawn)])
    assert re.match(r"\(a\) full Gaussian", panels[0].get_title(loc="left"))
