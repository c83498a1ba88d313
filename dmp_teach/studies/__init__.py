"""The paper's experiments as data, and its claims with verdicts.

The names in `__init__.pyi` are loaded when they are first used.
"""

import lazy_loader

from dmp_teach.old_names import serve_names

_load, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)

# Old name: new name. The old one stays for one version.
_RENAMED = {
    "Bench": "Evidence",
    "ProgressBar": "progress_bar",
    "Traces": "GoalPaths",
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
    "p_from_d": "make_p_from_d",
    "random_ink": "draw_random_ink",
    "redrawn": "redraw_letters",
    "segmentation": "compare_segmentation",
    "told_apart": "classify_writers",
}

__getattr__ = serve_names("dmp_teach.studies", _load, __all__, _RENAMED)
