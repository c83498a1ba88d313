"""Sphinx's settings for the pages that `python3 -m dmp_teach docs FOLDER` makes."""

from __future__ import annotations

import re
from importlib import import_module
from typing import Any

from docutils import nodes
from docutils.utils.math.latex2mathml import tex2mathml

project = "dmp_teach"
html_title = "dmp_teach"
extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.napoleon"]
myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 3
# Shown as it stands; the paper's equations are in the lessons.
default_role = "code"
autodoc_default_options = {"members": True, "member-order": "bysource"}
autodoc_preserve_defaults = True
autodoc_type_aliases = {name: name for name in ("Array", "ArrayLike")}
autodoc_typehints_format = "short"
python_use_unqualified_type_names = True
python_maximum_signature_line_length = 88
toc_object_entries_show_parents = "hide"
html_theme = "furo"
pygments_dark_style = "one-dark"
html_static_path = ["_static"]
html_css_files = ["site.css"]
html_js_files = ["site.js"]
html_extra_path = ["live"]
html_copy_source = False
html_show_copyright = False
html_math_renderer = "mathml"
html_theme_options = {
    "light_css_variables": {"color-brand-primary": "#1b5e8c", "color-brand-content": "#1b5e8c"},
    "dark_css_variables": {"color-brand-primary": "#8cc8f0", "color-brand-content": "#8cc8f0"},
}


# Any: Sphinx is not in our environment, and its types are not known there.
def show_math(visitor: Any, node: Any) -> None:
    """Write a formula as MathML, which browsers draw by themselves."""
    block = isinstance(node, nodes.math_block)
    mathml = str(tex2mathml(node.astext(), as_block=block))
    visitor.body.append(f'<div class="math">{mathml}</div>' if block else mathml)
    raise nodes.SkipNode


def as_markup(block: str) -> str:
    """Return a paragraph of a docstring as Sphinx takes it: `code`s, |x|, an indented example."""
    if all(line.startswith("    ") for line in block.splitlines()):
        # A formula is no Python.
        language = "python" if "teach." in block else "text"
        return f".. code-block:: {language}\n\n{block}"
    words = re.split(r"`([^`]+)`", block)
    words[::2] = [re.sub(r"\*\*|[|\\]", r"\\\g<0>", word) for word in words[::2]]
    words[1::2] = [f"``{word}``\\ " for word in words[1::2]]
    return "".join(words)


# Any: as above.
def read_docstring(*given: Any) -> None:
    """Turn a docstring into markup, in place."""
    lines = given[-1]
    blocks = re.split(r"\n{2,}", "\n".join(lines).strip("\n"))
    lines[:] = "\n\n".join(map(as_markup, filter(None, blocks))).splitlines()
    lines.append("")


# Any: as above.
def read_signature(*given: Any) -> Any:
    """Return a signature that can be parsed where a dataclass makes a default; not traitlets'."""
    said, of = given[-2:]
    if not said:
        return None
    return said.replace("<factory>", "...").replace("*args: t.Any, **kwargs: t.Any", ""), of


# Any: as above.
def setup(app: Any) -> None:
    """Let Sphinx write formulas without another host's scripts, and our names within types."""
    import_module("sphinx.util.inspect").TypeAliasForwardRef.__repr__ = lambda self: self.name
    app.connect("autodoc-process-docstring", read_docstring, priority=1)
    app.connect("autodoc-process-signature", read_signature)
    app.add_html_math_renderer("mathml", (show_math, None), (show_math, None))
