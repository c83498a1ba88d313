"""How soon a page shows what a hand does: `python -m tests.benchmarks.browser [--runs 3]`.

In a real JupyterLab in a headless Chromium a goal is dragged, which needs no kernel, and the slider
of bumps moved, which needs a fit; beside them, in the same run, the same picture by `interact` and
inline matplotlib. 60 events a second. An update is a frame that shows a new picture; it takes from
the moment when its event was due to the beginning of the frame. The floor is the same of a handler
that notes a number and draws nothing: what is above it is ours.

No test: what else a computer does decides too, so nothing here fails.
"""

import argparse
import json
import tempfile
from pathlib import Path
from typing import Any

import numpy as np
from playwright.sync_api import Page, sync_playwright

from tests.browser.conftest import FLAGS, PATIENCE, STATE, TOKEN, chromium_path, run_all, serve
from tests.browser.test_lab import notebook_of

CELLS = [
    "import dmp_teach as teach\nteach.explore()",
    """%matplotlib inline
import matplotlib.pyplot as plt
from ipywidgets import interact
shown = teach.recording_of("a").strokes()

@interact(n=(8, 37), x=(0, 29))
def draw(n=12, x=0):
    letter = teach.Letter.learn(shown, teach.Settings.star(n_kernels=n, kernel_width=2.0))
    (line,) = letter.write(goal_shifts={0: (0.001 * x, 0.0)})
    plt.plot(*shown[0].position.T, ".")
    plt.plot(*line.position.T)
    plt.axis("equal")
    plt.show()""",
]
# Pages are painted as without a graphics card; through its emulation there are 5 frames a second.
LAUNCH = [*FLAGS, "--no-sandbox", "--disable-gpu-compositing"]
DRIVE = (Path(__file__).parent / "drive.js").read_text(encoding="utf-8")
LINE = "() => document.querySelector('.dt-explore .dt-paper .dt-robot-line').getAttribute('d')"
PICTURE = "() => document.querySelector('img[src*=png]')?.src ?? ''"
RING = """(place) => {
    const ring = document.querySelector('.dt-goal');
    window.grip ??= (({x, y, width, height}) => [x + width / 2, y + height / 2])(
        ring.querySelector('.dt-ring').getBoundingClientRect());
    const at = {clientX: window.grip[0] + 2 * place, clientY: window.grip[1] - place};
    ring.dispatchEvent(new PointerEvent('pointermove', {pointerId: 1, bubbles: true, ...at}));
}"""
BUMPS = """(place) => {
    const input = document.querySelector('.dt-knobs input');
    input.value = 8 + place;
    input.dispatchEvent(new Event('input', {bubbles: true}));
}"""
INTERACT = """(place) => {
    const handle = document.querySelectorAll('.jp-OutputArea .noUi-handle')[%d];
    const low = Number(handle.getAttribute('aria-valuemin'));
    const way = () => low + place - Number(handle.getAttribute('aria-valuenow'));
    for (let to = Math.round(way()), i = 0; i < Math.abs(to); i += 1) {
        const key = to < 0 ? 'ArrowLeft' : 'ArrowRight';
        handle.dispatchEvent(new KeyboardEvent('keydown', {key, bubbles: true}));
    }
}"""
NOTE, NOTED = "(place) => { window.noted = String(place); }", "() => window.noted ?? ''"
# What is moved: how, what is looked at, and whether the kernel makes the picture.
MOVED = {
    "nothing: the floor": (NOTE, NOTED, False),
    "goal, in the browser": (RING, LINE, False),
    "goal, by interact": (INTERACT % 1, PICTURE, True),
    "bumps, by the kernel": (BUMPS, LINE, True),
    "bumps, by interact": (INTERACT % 0, PICTURE, True),
}


def measure(page: Page, name: str, seconds: float) -> dict[str, Any]:
    """Updates a second, and median and p95 of what they take [ms], of one control."""
    fire, look, by_kernel = MOVED[name]
    held = name == "goal, in the browser"
    ours = look != PICTURE
    page.locator(".dt-paper" if ours else ".noUi-handle >> nth=0").scroll_into_view_if_needed()
    if held:
        ring = page.locator(".dt-goal .dt-ring").bounding_box()
        page.mouse.move(ring["x"] + ring["width"] / 2, ring["y"] + ring["height"] / 2)
        page.mouse.down()
    how = f"{{fire: {fire}, look: {look}, places: 30, calibrate: {json.dumps(by_kernel)}"
    found = page.evaluate(f"() => ({DRIVE.strip().rstrip(';')})({how}, seconds: {seconds}}})")
    if held:
        page.mouse.up()
    took = np.array(found["latencies"])
    return {
        "name": name,
        "updates_a_second": len(took) / seconds,
        "median_ms": float(np.median(took)),
        "p95_ms": float(np.percentile(took, 95)),
        "frames_a_second": found["frames"],
        "events_a_second": found["events"],
        "ends_right": found["isRight"],
    }


def opened(page: Page, url: str) -> None:
    """Open the notebook, run it, and wait for panel and picture."""
    page.set_default_timeout(PATIENCE)
    page.goto(f"{url}/lab/tree/notebooks/speed.ipynb?reset&token={TOKEN}")
    page.wait_for_function(f"() => ({STATE})()?.status === 'idle'", timeout=PATIENCE)
    run_all(page)
    page.wait_for_selector(".dt-explore[data-dt-drawing]")
    page.wait_for_selector("img[src*=png]")


def runs(count: int, seconds: float) -> list[list[dict[str, Any]]]:
    """Everything in turns, `count` times, in one JupyterLab."""
    notebooks = {"speed.ipynb": notebook_of(*CELLS)}
    with (
        tempfile.TemporaryDirectory() as home,
        sync_playwright() as playwright,
        serve(Path(home), notebooks) as lab,
    ):
        browser = playwright.chromium.launch(executable_path=chromium_path(), args=LAUNCH)
        page = browser.new_page(viewport={"width": 1366, "height": 1600})
        opened(page, lab.url)
        found = [[measure(page, name, seconds) for name in MOVED] for _ in range(count)]
        browser.close()
    return found


def lines(found: list[list[dict[str, Any]]]) -> list[str]:
    """A row for each control and run."""
    rows = [f"{'':24}{'updates/s':>10}{'median':>10}{'p95':>10}{'frames/s':>10}"]
    for each in (row for run in found for row in run):
        rows.append(
            f"{each['name']:24}{each['updates_a_second']:10.1f}{each['median_ms']:7.1f} ms"
            f"{each['p95_ms']:7.1f} ms{each['frames_a_second']:10.1f}"
            + ("" if each["ends_right"] else "  the last value is not shown")
        )
    return rows


def main() -> None:
    """Measure, print, and write the figures where asked."""
    asked = argparse.ArgumentParser(prog="python -m tests.benchmarks.browser", description=__doc__)
    asked.add_argument("--runs", type=int, default=3)
    asked.add_argument("--seconds", type=float, default=4.0, help="for each control (default 4)")
    asked.add_argument("--json", type=Path, help="where to write the figures, too")
    options = asked.parse_args()
    found = runs(options.runs, options.seconds)
    print("\n".join(lines(found)))
    if options.json:
        options.json.write_text(json.dumps(found, indent=2), encoding="utf-8")


if __name__ == "__main__":
    main()
