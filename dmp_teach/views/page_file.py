"""A widget as one file that opens from disk, without network or kernel."""

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
body {{ margin: 0; padding: 8px; background: #ffffff; color: #111111; }}
@media (prefers-color-scheme: dark) {{ body {{ background: #111417; color: #f4f4f4; }} }}
.dt-scene, .dt-panel {{ margin: 0 auto; }}
[data-dt-asks] {{ opacity: 0.45; filter: grayscale(1); }}
.dt-rests {{ margin: 0 0 6px; text-align: center; font: 16px system-ui, sans-serif; }}
</style>
</head>
<body>
<main id="view"></main>
<noscript>{label} This page needs JavaScript to show it.</noscript>
<script type="application/gzip;base64" id="state">{state}</script>
<script type="module">
{script}
</script>
</body>
</html>
"""


# Any: JSON with bytes at any depth.
def render_page(title: str, css: str, script: str, state: dict[str, Any], label: str) -> bytes:
    """Return a widget's page as the bytes of an HTML file.

    Args:
        title: Of the window.
        css: The widget's style sheet.
        script: The page's script, which calls `showPage` of `standalone.js`.
        state: The widget's traits; bytes may stand at any depth.
        label: What is read where scripts do not run.
    """
    packed = gzip.compress(json.dumps(state, default=_pack_bytes).encode(), 9, mtime=0)
    text = _PAGE.format(
        title=html.escape(title),
        policy=_POLICY,
        css=css,
        label=html.escape(label),
        state=base64.b64encode(packed).decode(),
        script=script,
    )
    return text.encode()


def _pack_bytes(value: bytes | memoryview) -> dict[str, str]:
    """Return bytes as the page reads them."""
    return {"base64": base64.b64encode(value).decode()}
