"""A panel where it cannot live: a still picture with its sentence, for print, export and reopening.

It is an output of its own below the panel, which hides it (`panel.css`) for as long as it lives.
"""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Sequence
from html import escape
from typing import NamedTuple

import numpy as np

from dmp_teach.classroom.panels.messages import Message
from dmp_teach.ink import PERSON_INK, ROBOT_INK, SHEET_COLOR, SHEET_EDGE_COLOR
from dmp_teach.trajectory import Trajectory

_HEIGHT = 300
_MOST_POINTS = 120
_FIGURE = """\
<figure class="dt-stand-in" style="margin: 0">
<img alt="{title}" src="data:image/svg+xml;base64,{picture}">
<figcaption style="font-size: 16px"><b style="font-size: 24px">{number}</b> {sentence}</figcaption>
</figure>"""


class Still(NamedTuple):
    """What is seen of a panel in an exported notebook: never what a pupil has written.

    `sheet` is left, bottom, right and top [m].
    """

    title: str
    message: Message
    sheet: Sequence[float]
    person: Sequence[Trajectory] = ()
    robot: Sequence[Trajectory] = ()

    def text(self) -> str:
        """Return the title, the number and the sentence."""
        return " ".join(filter(None, (self.title, *_read(self.message))))

    def html(self) -> str:
        """Return the picture over the number and the sentence.

        The picture is an image, for Jupyter takes an SVG out of a notebook from elsewhere.
        """
        number, sentence = map(escape, _read(self.message))
        picture = b64encode(self.svg().encode()).decode()
        return _FIGURE.format(
            title=escape(self.title), picture=picture, number=number, sentence=sentence
        )

    def svg(self) -> str:
        """Return the sheet with the person's dots and the robot's line."""
        left, bottom, right, top = self.sheet
        scale = _HEIGHT / (top - bottom)
        width = round(scale * (right - left))
        look = 'fill="none" stroke-linecap="round" stroke-linejoin="round"'
        lines = [
            f'<polyline points="{_points(stroke, left, top, scale)}" {look} {ink}/>'
            for strokes, ink in (
                (self.robot, f'stroke="{ROBOT_INK}" stroke-width="3"'),
                (
                    self.person,
                    f'stroke="{PERSON_INK}" stroke-width="3.6" stroke-dasharray="0.01 8"',
                ),
            )
            for stroke in strokes
        ]
        return (
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{_HEIGHT}">'
            f'<rect x="0.5" y="0.5" width="{width - 1}" height="{_HEIGHT - 1}" rx="6" '
            f'fill="{SHEET_COLOR}" stroke="{SHEET_EDGE_COLOR}"/>{"".join(lines)}</svg>'
        )


def _read(message: Message) -> tuple[str, str]:
    """Return a message's number with its unit, and its sentence."""
    number = f"{message['number']} {message['unit']}".strip()
    return number, message["text"] + message["strong"] + message["after"]


def _points(stroke: Trajectory, left: float, top: float, scale: float) -> str:
    """Return the points of a stroke on the sheet, as SVG has them."""
    count = min(len(stroke), _MOST_POINTS)
    kept = stroke.position[np.linspace(0, len(stroke) - 1, count).round().astype(int), :2]
    return " ".join(f"{x:.1f},{y:.1f}" for x, y in (kept - (left, top)) * (scale, -scale))
