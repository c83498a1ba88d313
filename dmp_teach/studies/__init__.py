"""The paper's experiments as data, and its claims with verdicts.

The names in `__init__.pyi` are loaded when they are first used.
"""

import warnings
from typing import Any

import lazy_loader

_load, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)

# Old name: new name. The old one stays for one version.
_RENAMED = {
    "Bench": "Evidence",
    "ProgressBar": "progress_bar",
    "against_original": "compare_with_original",
    "any_shape": "learn_random_ink",
    "attribution": "attribute_made_letters",
    "error_against_number": "sweep_kernel_number",
    "error_against_width": "sweep_kernel_width",
    "first_moments": "measure_initial_acceleration",
    "four_widths": "redraw_at_widths",
    "goal_change_1d": "change_goals_1d",
    "goal_change_2d": "change_goals_2d",
    "goal_paths": "draw_goal_change",
    "goal_traces": "trace_goal_change",
    "goals_near_start": "change_goals_near_start",
    "made_among_real": "attribute_among_real",
    "p_from_d": "make_p_from_d",
    "random_ink": "draw_random_ink",
    "redrawn": "redraw_letters",
    "segmentation": "compare_segmentation",
    "told_apart": "classify_writers",
}


def __getattr__(name: str) -> Any:
    """Load a name from its module, and warn where it has a new one."""
    if name in __all__:
        return _load(name)
    if name not in _RENAMED:
        names = ", ".join(sorted(__all__))
        raise AttributeError(f"dmp_teach.studies has no {name!r}; it has: {names}.")
    new = _RENAMED[name]
    warnings.warn(
        f"dmp_teach.studies.{name} is now called dmp_teach.studies.{new}.",
        DeprecationWarning,
        stacklevel=2,
    )
    return _load(new)
