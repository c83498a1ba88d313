"""Every figure of ours, each a function that returns a matplotlib `Figure`."""

from __future__ import annotations

import warnings

import lazy_loader

_load, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)

# Old name: new name; the old one stays for one version.
_RENAMED = {
    "attribution_bars": "draw_attribution_bars",
    "confusion": "draw_confusion",
    "contact_sheet": "draw_contact_sheet",
    "d_to_p": "draw_d_to_p",
    "error_over_number": "draw_error_over_number",
    "error_over_width": "draw_error_over_width",
    "four_widths_drawn": "draw_four_widths",
    "goal_change_drawn": "draw_goal_paths",
    "goal_change_over_time": "draw_goal_change_over_time",
    "kernel_choice": "draw_kernel_choice",
    "kernel_types": "draw_kernel_types",
    "letters_made": "draw_made_letters",
    "letters_redrawn": "draw_redrawn_letters",
    "reach_drawn": "draw_reach",
    "recipes_drawn": "draw_recipes",
    "strokes_by_rule": "draw_strokes_by_rule",
    "style_sheet": "draw_style_sheet",
    "written_text": "draw_text",
}


def __getattr__(name: str) -> object:
    """Load a figure when it is first used; warn of an old name."""
    if name in __all__:
        return _load(name)
    if name not in _RENAMED:
        names = ", ".join(sorted(__all__))
        raise AttributeError(f"dmp_teach.figures has no {name!r}; it has: {names}.")
    new = _RENAMED[name]
    warnings.warn(
        f"dmp_teach.figures.{name} is now called dmp_teach.figures.{new}.",
        DeprecationWarning,
        stacklevel=2,
    )
    return _load(new)
