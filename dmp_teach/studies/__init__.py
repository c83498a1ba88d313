"""The paper's experiments as data, and its claims with verdicts. The names below are loaded when first used."""

from importlib import import_module
from typing import Any

_HOME = {
    "curves": ("error_against_width", "error_against_number", "ErrorCurves"),
    "choose": ("choose_kernels", "choose_width", "Choice"),
    "goals": ("goal_change_1d", "goal_change_2d", "goal_traces", "goal_paths", "GoalChanges"),
    "redraw": ("redrawn", "four_widths"),
    "new_letters": ("p_from_d",),
    "style": ("attribution",),
    "among_real": ("made_among_real",),
    "hands": ("told_apart",),
    "answers": ("Answers", "Attributions"),
    "lifts": ("segmentation",),
    "shapes": ("any_shape", "random_ink"),
    "closeness": ("goals_near_start",),
    "beginnings": ("first_moments",),
    "against": ("against_original",),
    "variants": ("Variant", "WIDTH_VARIANTS", "NUMBER_VARIANTS"),
    "bench": ("Bench",),
    "work": ("ProgressBar",),
    "verdict": ("Claim", "Claims"),
    "on_kernels": (
        "narrow_kernels",
        "best_width",
        "wide_kernels",
        "truncation",
        "gaps_between_kernels",
        "number_of_kernels",
        "four_widths_on_a",
    ),
    "on_letters": (
        "goal_changes",
        "d_becomes_p",
        "strokes_from_height",
        "goal_on_start",
        "huge_accelerations",
        "decay_term",
        "redrawn_letters",
        "accuracy_and_efficiency",
        "any_ink",
        "writing_style",
    ),
}
_PLACE = {name: module for module, names in _HOME.items() for name in names}

__all__ = [*_PLACE]  # noqa: PLE0604 (the keys are strings)


def __getattr__(name: str) -> Any:
    """Load a study when it is first used."""
    if name not in _PLACE:
        raise AttributeError(f"dmp_teach.studies has no {name!r}; it has: {', '.join(sorted(_PLACE))}.")
    value = getattr(import_module(f"dmp_teach.studies.{_PLACE[name]}"), name)
    globals()[name] = value
    return value


def __dir__() -> list:
    """The studies, for the Tab key."""
    return sorted(_PLACE)
