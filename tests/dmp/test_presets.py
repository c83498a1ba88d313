"""One table in the code and one in the documentation say every field of every preset."""

import math
import warnings
from pathlib import Path
from typing import get_type_hints

import numpy as np
import pytest

import dmp_teach.dmp
from dmp_teach.dmp.presets import PRESETS, SettingChanges, table_of_choices
from dmp_teach.dmp.primitive import DMP
from dmp_teach.dmp.settings import Settings
from dmp_teach.errors import SettingWarning
from tests.dmp.ink import letter, rms
from tests.dmp.test_accuracy import strokes
from tests.recordings import needs_recordings

ROOM = Path(dmp_teach.dmp.__file__).parent
# What a reading in the text changes, and what that alone costs, median [mm].
COSTS = {
    "one-sided kernels: x - c_i <= theta": ({"kernel_sides": "one"}, (10, 60)),
    "xdot = -x/T, which is exponential": (
        {"phase": "exponential", "phase_decay": 1.0, "kernel_centers": "phases"},
        (0.7, 3),
    ),
    "N centres evenly in [0, 1], both ends included": ({"kernel_centers": "ends"}, (1, 5)),
    "full Gaussians": ({"kernel_width": math.inf}, (15, 60)),
    "F not divided by K": ({"divide": False}, (1e4, 1e6)),
}


def as_markdown():
    """The table of presets as the documentation has it, a row for each setting."""
    presets = [getattr(Settings, name)() for name in PRESETS]
    lines = [["setting", *(f"`{name}`" for name in PRESETS)]]
    lines += [
        [f"`{each}`", *(as_cell(getattr(preset, each)) for preset in presets)]
        for each in SettingChanges.__annotations__
    ]
    head, *rows = (f"| {' | '.join(line)} |\n" for line in lines)
    return "".join([head, "|---" * len(lines[0]) + "|\n", *rows])


def as_cell(value):
    if isinstance(value, bool):
        return "yes" if value else "no"
    return "-" if value is None else f"{value:.4g}" if isinstance(value, float) else str(value)


def cost(demos, settings):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", SettingWarning)
        return float(
            np.median([rms(DMP.imitate(d, settings).rollout().position, d.position) for d in demos])
        )


def test_the_keywords_of_a_preset_are_the_settings():
    assert get_type_hints(SettingChanges) == get_type_hints(Settings)
    assert Settings() == Settings.star()


def test_the_documentation_shows_every_field_of_every_preset():
    assert as_markdown() in (ROOM / "README.md").read_text(encoding="utf-8")


def test_the_readings_are_those_of_the_design():
    printed, coded, fixed = Settings.as_printed(), Settings.as_coded(), Settings.as_fixed()
    assert (printed.kernel_sides, printed.kernel_centers, printed.kernel_width) == (
        "one",
        "ends",
        1.0,
    )
    assert (printed.phase, printed.phase_decay, printed.divide, printed.integrator) == (
        "exponential",
        1.0,
        True,
        "lagged",
    )
    assert (coded.kernel_centers, coded.kernel_width) == ("grid", 2.0)
    assert coded.resolved(2.5, 300).kernel_sigma == pytest.approx(30 * math.sqrt(0.5))
    resolved = coded.resolved(2.5, 300)
    D = resolved.alpha / 2.5
    assert (D, (D / (2 * resolved.damping)) ** 2) == pytest.approx(
        (4, 32)
    )  # the program's alpha and alpha beta
    assert fixed.kernel_width == 1.0 < fixed.kernel_sigma < math.inf
    for reading in (printed, coded, fixed):
        assert (reading.transform, reading.fit, reading.derivatives) == ("star", "lwr", "central")
        assert (reading.smoothing, reading.feed_goal, reading.sharpen) == (None, False, False)
        assert reading.resolved(3.0, 331).n_kernels == 33


def test_a_reading_takes_changes_like_any_preset():
    assert Settings.as_coded(n_kernels=200).n_kernels == 200
    assert Settings.as_fixed(samples_per_kernel=None).resolved(2.5, 300).n_kernels == 30


def test_dividing_by_what_multiplies_is_what_makes_the_weights_fit():
    """Algorithm 1 lacks (g - y0), LWR lacks K: the weights are too large by just that."""
    demo = letter(seed=3)
    way = demo.position[-1] - demo.position[0]
    for transform, factor in (("star", 60.0**2 / 4), ("original", way)):
        divided, not_divided = (
            DMP.imitate(demo, Settings.star(transform=transform, divide=divide)).weights
            for divide in (True, False)
        )
        assert not_divided == pytest.approx(divided * factor, rel=1e-9)


def test_as_fixed_draws_our_letters_and_as_printed_cannot():
    ours = [letter(300, 2.5, seed=seed) for seed in range(5)]
    fixed, coded, printed = (
        cost(ours, each()) for each in (Settings.as_fixed, Settings.as_coded, Settings.as_printed)
    )
    assert fixed < 1.0 < coded < 8.0
    assert 8.0 < printed < 200
    assert cost(ours, Settings.as_printed(divide=False)) > 500


@pytest.mark.parametrize(("changes", "bounds"), COSTS.values(), ids=COSTS)
def test_each_contradiction_costs_what_the_design_says(changes, bounds):
    ours = [letter(300, 2.5, seed=seed) for seed in range(5)]
    assert bounds[0] < cost(ours, Settings.star(**changes)) < bounds[1]


@needs_recordings
@pytest.mark.parametrize(("changes", "bounds"), COSTS.values(), ids=COSTS)
def test_each_contradiction_costs_what_the_design_says_on_recordings(changes, bounds):
    assert bounds[0] < cost(strokes("a"), Settings.star(**changes)) < bounds[1]


@needs_recordings
def test_the_readings_on_recordings():
    assert cost(strokes("a"), Settings.as_fixed()) < 0.5
    assert 1.0 < cost(strokes("a"), Settings.as_coded()) < 5.0
    assert cost(strokes("a"), Settings.as_printed()) > 5


def test_whose_choice_is_what_stands_in_one_table_everywhere():
    table = table_of_choices()
    for text in (ROOM / "README.md", ROOM.parents[1] / "README.md"):
        lines = text.read_text(encoding="utf-8").splitlines()
        assert set(table.splitlines()) <= {line.strip() for line in lines}
    assert table.splitlines()[-1] in Settings.star.__doc__
    star, paper = PRESETS["star"], PRESETS["as_fixed"]
    assert star == {}
    assert len(paper) <= len(table.splitlines()) - 2
