"""Every figure of ours, each a function that returns a matplotlib `Figure`."""

from __future__ import annotations

import lazy_loader

from dmp_teach.old_names import serve_names

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

__getattr__ = serve_names("dmp_teach.figures", _load, __all__, _RENAMED)
