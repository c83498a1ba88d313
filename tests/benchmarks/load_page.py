"""What dragging in a real page asks of a pupil's server: messages and processor time."""

import time

from playwright.sync_api import Page, sync_playwright

from tests.benchmarks.load_hub import Hub, processor_time
from tests.browser.conftest import FLAGS, PATIENCE, chromium_path
from tests.browser.test_lab import notebook_of

PUPIL, NOTEBOOK = "w00", "drag.ipynb"
GRIPS = {
    "goal, drawn in the page": ".dt-goal .dt-ring",
    "bumps, drawn by the kernel": ".dt-slider:has-text('How many bumps') input",
}
STEPS = 120


def drag_in_page(hub: Hub) -> dict[str, dict[str, float]]:
    """Drag a goal and a slider for two seconds: messages to the kernel, and processor time [s]."""
    path = chromium_path()
    if path is None:
        return {}
    notebook = notebook_of("import dmp_teach as teach\nteach.explore()")
    (hub.folder / PUPIL / "lessons" / NOTEBOOK).write_text(notebook, encoding="utf-8")
    sent: list[str] = []
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=path, args=[*FLAGS, "--no-sandbox"])
        page = browser.new_page(viewport={"width": 1366, "height": 900})
        page.set_default_timeout(PATIENCE)
        # Playwright cannot mark a method of a list as its own.
        note = lambda told: sent.append(told)  # noqa: E731, PLW0108
        page.on("websocket", lambda socket: socket.on("framesent", note))
        page.goto(f"{hub.url}/hub/login?next=/user/{PUPIL}/doc/tree/{NOTEBOOK}")
        page.get_by_label("Username").fill(PUPIL)
        page.get_by_label("Password").fill("any")
        page.get_by_role("button", name="Sign in").click()
        page.wait_for_selector(".dt-explore[data-dt-drawing]")
        found = {name: _drag(page, hub, grip, sent) for name, grip in GRIPS.items()}
        browser.close()
    return found


def _drag(page: Page, hub: Hub, grip: str, sent: list[str]) -> dict[str, float]:
    """Drag to and fro by the mouse, 60 events a second."""
    handle = page.locator(grip).first
    handle.scroll_into_view_if_needed()
    box = handle.bounding_box()
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    page.mouse.move(x, y)
    page.mouse.down()
    server = hub.server(PUPIL)
    busy = [server, *server.children(), hub.proxy()]
    before, heard, began = processor_time(*busy), len(sent), time.monotonic()
    for step in range(STEPS):
        page.mouse.move(x + 40 - abs(step % 80 - 40), y)
        page.wait_for_timeout(1000 / 60)
    found = {
        "seconds": time.monotonic() - began,
        "messages": len([each for each in sent[heard:] if "comm_msg" in str(each)]),
        "processor": processor_time(*busy) - before,
    }
    page.mouse.up()
    return found
