"""Figures show what the study says, with units, and stay apart without colour."""

from importlib import import_module
from pathlib import Path
from types import FunctionType
from typing import get_type_hints

import numpy as np
import pytest
from IPython.core.formatters import PNGFormatter
from matplotlib.figure import Figure

import dmp_teach as teach
from dmp_teach.dmp import KERNELS, Kernels
from dmp_teach.errors import RecordingError, SettingError
from dmp_teach.ink.alphabet import recording_of
from dmp_teach.studies.experiments.d_to_p import make_p_from_d
from dmp_teach.studies.experiments.error_curves import sweep_kernel_number, sweep_kernel_width
from dmp_teach.studies.experiments.goal_drawings import draw_goal_change, trace_goal_change
from dmp_teach.studies.experiments.redraw import redraw_at_widths, redraw_letters
from dmp_teach.studies.experiments.validation import choose_kernels, choose_width
from dmp_teach.trajectory import Trajectory
from dmp_teach.views import figures
from dmp_teach.views.paper_figure import FIGURES
from tests.dmp.ink import letter

A = recording_of("a")
OURS = [A, recording_of("e"), recording_of("D")]
STROKE = A.strokes()[0]


@pytest.fixture(scope="module")
def every():
    """Every figure, by its name."""
    widths, numbers = sweep_kernel_width(OURS), sweep_kernel_number(OURS)
    return {
        "draw_kernel_types": figures.draw_kernel_types(),
        "draw_error_over_width": figures.draw_error_over_width(widths),
        "draw_error_over_width, all": figures.draw_error_over_width(widths, "all"),
        "draw_error_over_number": figures.draw_error_over_number(numbers, "our DMP*"),
        "draw_four_widths": figures.draw_four_widths(redraw_at_widths(OURS)),
        "draw_redrawn_letters": figures.draw_redrawn_letters(redraw_letters(OURS)),
        "draw_goal_change_over_time": figures.draw_goal_change_over_time(
            trace_goal_change(STROKE, 0, 0.01, "a")
        ),
        "draw_goal_paths": figures.draw_goal_paths(draw_goal_change(STROKE, (-0.1, 0.0))),
        "draw_d_to_p": figures.draw_d_to_p(make_p_from_d(OURS)),
        "draw_kernel_choice": figures.draw_kernel_choice(
            choose_kernels(STROKE, candidates=(5, 10, 20, 33))
        ),
        "draw_kernel_choice, width": figures.draw_kernel_choice(
            choose_width(STROKE, candidates=(1.0, 4.0, np.inf))
        ),
    }


def test_every_figure_of_every_module_is_found_in_one_place():
    drawn = set()
    for path in Path(figures.__file__).parent.glob("*.py"):
        module = import_module(f"dmp_teach.views.figures.{path.stem}")
        for name, each in vars(module).items():
            if isinstance(each, FunctionType) and each.__module__ == module.__name__:
                shown = get_type_hints(each).get("return") is Figure
                drawn |= {name} if shown and not name.startswith("_") else set()
    assert drawn == set(figures.__all__)
    assert all(name.startswith("draw_") for name in drawn)


def test_an_old_name_of_a_figure_gives_the_new_one_with_a_warning():
    with pytest.warns(DeprecationWarning, match=r"reach_drawn is now .*\.draw_reach\.") as said:
        assert figures.reach_drawn is figures.draw_reach
    assert said[0].filename == __file__


def test_every_figure_can_be_shown_in_a_notebook_and_saved(every, tmp_path):
    for name, figure in every.items():
        assert isinstance(figure, Figure)
        assert PNGFormatter()(figure).startswith(b"\x89PNG")
        figure.savefig(tmp_path / f"{name}.svg")


def test_every_axis_is_named_with_its_unit(every):
    plain = {"phase s", "height ψ(s)", "kernels per sample, N / Num", "number of kernels N"}
    for figure in every.values():
        labels = [
            text
            for panel in figure.axes
            for text in (panel.get_xlabel(), panel.get_ylabel())
            if text
        ]
        assert labels
        assert [text for text in labels if text not in plain and not text.endswith("]")] == []


def test_curves_differ_by_line_and_marker_not_by_colour_alone(every):
    for name in ("draw_error_over_width", "draw_error_over_width, all", "draw_error_over_number"):
        lines = [line for line in every[name].axes[0].lines if line.get_marker() != "None"]
        looks = {
            (line.get_marker(), str(line._dash_pattern), line.get_linestyle()) for line in lines
        }
        assert len(looks) == len(lines) >= 3


def test_the_curve_of_a_letter_is_the_median_of_its_strokes():
    curves = sweep_kernel_width(OURS, widths=(0.5, 1.0, 2.0, 4.0))
    panel, summed = figures.draw_error_over_width(curves, "box, LWR").axes
    shown, sums = (
        {line.get_label(): line.get_ydata() for line in each.lines} for each in (panel, summed)
    )
    assert (1e3 * sums["‘D’"] > 50 * shown["‘D’"]).all()
    of_d = curves.of("box, LWR")[np.array(curves.characters) == "D"]
    np.testing.assert_allclose(shown["‘D’"], 1e3 * np.median(of_d, axis=0))
    assert {"‘a’", "‘e’", "‘D’"} <= set(shown)


def test_kernels_are_drawn_as_they_are():
    panels = figures.draw_kernel_types(5).axes
    assert len(panels) >= 4
    for line, height in zip(
        panels[1].lines,
        Kernels(5, 1.0, KERNELS["gaussian"](0.5)).heights(np.linspace(0, 1, 2001)).T,
        strict=True,
    ):
        shown = line.get_ydata()
        np.testing.assert_allclose(shown[np.isfinite(shown)], height[np.isfinite(shown)])
        assert height[~np.isfinite(shown)].sum() == 0


def test_letters_are_drawn_in_mm_where_they_are_on_the_page():
    panel = figures.draw_redrawn_letters(redraw_letters([A])).axes[0]
    line = next(line for line in panel.lines if line.get_label() == "as it was drawn")
    drawn = redraw_letters([A]).items[0].drawn[0].position
    np.testing.assert_allclose(np.column_stack(line.get_data()), 1e3 * drawn)


def test_a_moved_goal_is_drawn_with_both_forms_and_mirrors_are_named():
    paths = draw_goal_change(STROKE, (-0.1, 0.0))
    star, original = figures.draw_goal_paths(paths).axes
    assert star.get_title(loc="left") == "DMP*"
    assert original.get_title(loc="left") == "original, mirrored in x"
    assert star.get_xlim() == original.get_xlim()


def test_ink_that_flies_off_is_cut_and_said():
    paths = draw_goal_change(STROKE, (0.9, 0.0))
    original = figures.draw_goal_paths(paths).axes[1]
    assert any("leaves the page" in text.get_text() for text in original.texts)
    assert np.ptp(original.get_xlim()) < 2000


def test_both_rules_stand_in_the_picture_of_a_choice():
    choice = choose_kernels(STROKE, candidates=(5, 10, 20, 33))
    panel = figures.draw_kernel_choice(choice).axes[0]
    labels = [line.get_label() for line in panel.lines]
    assert f"Num/10: {choice.tenth}" in labels
    assert any(label.startswith("chosen: ") for label in labels)


@pytest.mark.parametrize("number", [2, 3, 5, 7, 8, 9, 10])
def test_a_figure_of_the_paper_is_drawn_by_its_own_number(number):
    titles = [panel.get_title(loc="left") for panel in teach.figure(number, OURS).axes]
    word = {2: "(a)", 3: "DMP*", 5: "1/N", 7: "goal", 8: "mirrored", 9: "‘e’", 10: "a P"}[number]
    assert any(word in title for title in titles)


def test_a_figure_names_the_letter_that_was_given_and_says_which_are_ours():
    given = recording_of("e")
    assert teach.figure(7, given).axes[0].get_title(loc="left").startswith("e, x: ")
    assert "D writer-1, of ours" in teach.figure(10, given).axes[0].get_title(loc="left")
    for number in (7, 8, 9, 10):
        with pytest.raises(RecordingError, match=r"\? 1 has a 3-D stroke"):
            teach.figure(number, [letter(50, 1.0, dimensions=3)])


def test_a_closed_letter_is_drawn_without_the_form_that_refuses_it():
    t = np.linspace(0, 2, 60)
    ring = np.column_stack([0.03 * np.sin(np.pi * t), 0.04 * np.cos(np.pi * t)])
    ring[-1] = ring[0]
    for number in (7, 8):
        panel = teach.figure(number, [Trajectory(t, ring)]).axes[0]
        assert "cannot learn a coordinate" in panel.get_title(loc="left")
        assert "original" not in [line.get_label() for line in panel.lines]


def test_there_are_ten_figures():
    assert list(FIGURES) == list(range(1, 11))
    for number in (0, 11, "4", True):
        with pytest.raises(SettingError, match="but the paper's figures are 1 to 10"):
            teach.figure(number)
