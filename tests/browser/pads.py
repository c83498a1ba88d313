"""A pad in a notebook, and hands that write on it."""

import ast
import json

import numpy as np

import dmp_teach
from tests.browser.test_lab import notebook_of

PAD = "import dmp_teach as teach\npad = teach.pad()\npad"


def open_pad(open_notebook, lab, **context):
    """The page with the pad, scrolled into sight."""
    notebook = lab.folder / "pad.ipynb"
    if not (context.get("again") and notebook.exists()):
        notebook.write_text(notebook_of(PAD))
    page = open_notebook("pad.ipynb", **context)
    page.wait_for_selector(".dt-pad[data-dt-drawing]")
    into_sight(page)
    return page


def into_sight(page):
    page.locator(".dt-stage").evaluate("node => node.scrollIntoView({ block: 'start' })")
    page.wait_for_timeout(200)


def press(page, name):
    page.locator(".dt-pad").get_by_role("button", name=name, exact=True).click()


def strokes(page, number):
    page.wait_for_selector(f".dt-pad[data-dt-strokes='{number}']")


LINES = """() => ['base', 'mid'].map((name) => {
    const line = document.querySelector(`.dt-sheet:has(canvas) .dt-${name}line`);
    const at = (far) => line.getPointAtLength(far).matrixTransform(line.getScreenCTM());
    return [0, line.getTotalLength()].map(at).map(({ x, y }) => [x, y]);
})"""


class Sheet:
    """Where metres of the sheet are on the screen, from its two writing lines and its middle."""

    def __init__(self, page, ask):
        lines = None
        while lines != (lines := page.evaluate(LINES)):
            # A window that was resized takes its time.
            box = json.loads(ast.literal_eval(ask(page, "__import__('json').dumps(pad.sheet)")))
            height = float(ask(page, "pad.lines[1]"))
        (left, _, right, _), (base, middle) = box, np.array(lines)
        along = (base[1] - base[0]) / np.linalg.norm(base[1] - base[0])
        up = np.array([along[1], -along[0]])
        self.axes = (middle[0] - base[0]) @ up / height * np.array([along, up])
        self.origin = base.mean(axis=0) - (left + right) / 2 * self.axes[0]

    def on_screen(self, places):
        return (self.origin + np.asarray(places) @ self.axes).round().tolist()

    def in_metres(self, pixels):
        return (np.asarray(pixels) - self.origin) @ np.linalg.inv(self.axes)


def caught(page, ask, number=-1):
    """The points of a stroke as Python has them [m]."""
    asked = f"__import__('json').dumps(pad.recording.strokes()[{number}].position.tolist())"
    return np.array(json.loads(ast.literal_eval(ask(page, asked))))


def farthest(ink, drawn):
    """How far two lines are from each other, at most, either way [m]."""
    a, b = (np.linspace(line[:-1], line[1:], 9).reshape(-1, 2) for line in (ink, drawn))
    apart = np.linalg.norm(a[:, None] - b[None], axis=2)
    return max(apart.min(axis=0).max(), apart.min(axis=1).max())


def letter(character="a", stroke=0, step=6, size=1.0):
    return dmp_teach.recording_of(character).strokes()[stroke].position[::step] * size


def by_mouse(page, pixels, pause=0):
    """Draw, with a pause [ms] after each point as slowly as a hand: the pace is learned, too."""
    page.mouse.move(*pixels[0])
    page.mouse.down()
    for place in pixels[1:]:
        page.mouse.move(*place)
        page.wait_for_timeout(pause)
