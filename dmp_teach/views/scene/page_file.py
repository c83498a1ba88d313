"""The view as one file that opens from disk, without network or kernel."""

from __future__ import annotations

import base64
import gzip
import html
import json
from pathlib import Path
from typing import Any

_POLICY = (
    "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline' blob:; "
    "img-src data: blob:"
)
"""The file loads nothing from elsewhere, and the browser holds it to that."""

_PAGE = """<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<meta http-equiv="Content-Security-Policy" content="{policy}">
<title>{title}</title>
<style>
{css}
body {{ margin: 0; padding: 8px; background: var(--jp-layout-color0); }}
body {{ --jp-layout-color0: #ffffff; --jp-border-color2: #e0e0e0; --jp-ui-font-color0: #111111; }}
body[data-jp-theme-light="false"] {{ --jp-layout-color0: #111417; --jp-border-color2: #3a4047; }}
body[data-jp-theme-light="false"] {{ --jp-ui-font-color0: #f4f4f4; }}
.dt-scene {{ margin: 0 auto; }}
</style>
</head>
<body>
<main id="view"></main>
<noscript>{label} This page needs JavaScript to show it.</noscript>
{data}
<script type="module">
{script}
{start}
</script>
</body>
</html>
"""

_START = """
const part = (name) => Uint8Array.from(atob(document.getElementById(name).textContent), (c) => c.charCodeAt(0));
const state = JSON.parse(new TextDecoder().decode(await gunzip(part("state"))));
for (const { id } of document.querySelectorAll("script[id]:not(#state)")) state[id] = part(id);
const heard = {};
const model = {
  get: (name) => state[name],
  set(name, value) {
    if (state[name] === value) return;
    state[name] = value;
    (heard[`change:${name}`] ?? []).forEach((listener) => listener());
  },
  on: (event, listener) => (heard[event] ??= []).push(listener),
  save_changes() {},
};
const dark = window.matchMedia("(prefers-color-scheme: dark)");
const dress = () => (document.body.dataset.jpThemeLight = String(!dark.matches));
dark.addEventListener("change", dress);
dress();
render({ model, el: document.getElementById("view") });
"""


def render_page(
    title: str, css: str, script: str, state: dict[str, Any], parts: dict[str, bytes]
) -> bytes:
    """Return the whole page as the bytes of an HTML file.

    Args:
        title: Of the window.
        css: The view's style sheet.
        script: The view's script; it defines `render({model, el})`.
        state: The view's traits that are not bytes, of any type.
        parts: Those that are: "viewer", "robot", "run" and "planned_run", compressed.
    """
    data = []
    packed_state = gzip.compress(json.dumps(state).encode("utf-8"), 9, mtime=0)
    for name, part in {"state": packed_state, **parts}.items():
        text = base64.b64encode(part).decode("ascii")
        data.append(f'<script type="application/gzip;base64" id="{name}">{text}</script>')
    text = _PAGE.format(
        title=html.escape(title),
        policy=_POLICY,
        css=css,
        label=html.escape(state["facts"]["label"]),
        data="\n".join(data),
        script=script,
        start=_START,
    )
    return text.encode("utf-8")


def read_beside(name: str) -> str:
    """A file that stands beside this module."""
    return Path(__file__).with_name(name).read_text(encoding="utf-8")
