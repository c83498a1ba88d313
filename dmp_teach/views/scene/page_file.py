"""The view as one file that opens from disk, without network or kernel."""

from __future__ import annotations

import base64
import gzip
import html
import json
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
</script>
</body>
</html>
"""


def render_page(
    title: str, css: str, script: str, state: dict[str, Any], parts: dict[str, bytes]
) -> bytes:
    """Return the whole page as the bytes of an HTML file.

    Args:
        title: Of the window.
        css: The view's style sheet.
        script: The page's script; it shows the view with the traits that stand in the page.
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
    )
    return text.encode("utf-8")
