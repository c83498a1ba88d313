"""Every lesson as a pupil meets it in JupyterLab: bet, try, miss twice, hint, green card."""

import json
from pathlib import Path

import pytest

import dmp_teach as teach
from dmp_teach.lessons import lessons
from tests.node import modules

NOTEBOOKS = Path(__file__).parents[2] / "notebooks"
KEYS = list(lessons())
SMALL_LAPTOP, TABLET = {"width": 1366, "height": 768}, {"width": 820, "height": 1180}
SET = """(input, place) => {
    input.value = String(place);
    for (const type of ["input", "change"]) input.dispatchEvent(new Event(type, {bubbles: true}));
}"""
VIOLATIONS = """async () => {
    const rules = {type: "tag", values: ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa"]};
    const found = await axe.run(document.querySelector(".dt-lesson"), {runOnly: rules});
    return found.violations.map(v => `${v.id}: ${v.nodes.map(n => n.html.slice(0, 120))}`);
}"""
HANDLES = """() => [...document.querySelectorAll(".dt-handle")].map(
    each => each.getAttribute("aria-valuetext"))"""
KEPT = "() => Object.entries(sessionStorage).find(([name]) => name.includes(' 03 '))[1]"
# What is left of the window when all of a lesson that is seen together is in it.
SPARE = """() => {
    const parts = [".dt-card", ".dt-stage", ".dt-says .dt-box", ".dt-knobs:not([hidden])"];
    const nodes = parts.map(part => document.querySelector(part)).filter(node => node);
    const boxes = nodes.map(node => node.getBoundingClientRect());
    const edge = (side, most) => Math[most](...boxes.map(box => box[side]));
    const { height, left, right } = document.querySelector(".jp-Notebook").getBoundingClientRect();
    const high = edge("bottom", "max") - edge("top", "min");
    return Math.min(height - high, edge("left", "min") - left, right - edge("right", "max"));
}"""


@pytest.fixture(scope="module")
def axe():
    """The script that finds what a screen reader would stumble over."""
    return modules() / "axe-core" / "axe.min.js"


def notebook_of(key):
    return next(NOTEBOOKS.glob(f"{key}_*.ipynb")).name


@pytest.fixture
def lesson(open_notebook):
    """Open a lesson's notebook; its panel wakes by itself."""

    def open_it(key):
        name, window = notebook_of(key), {"viewport": SMALL_LAPTOP}
        page = open_notebook(name, run=False, view="doc", shared=True, **window)
        page.wait_for_selector(".dt-lesson[data-dt-drawing]")
        page.locator(".dt-lesson").scroll_into_view_if_needed()
        return page

    return open_it


def press(page, name):
    page.locator(".dt-lesson").get_by_role("button", name=name, exact=True).click()


def see_together(page, shot, name):
    """The card, the pictures, the sentence and the knobs stand in one window, large or small."""
    for size in (TABLET, SMALL_LAPTOP):
        page.set_viewport_size(size)
        page.wait_for_timeout(100)
        shot(page, f"lesson_{name}_{size['width']}")
        assert page.evaluate(SPARE) >= 0, (name, size)


def bet(page, spec):
    """Bet by keyboard: the first handle is moved, or the first answer chosen."""
    if "options" in spec:
        page.locator(".dt-card .dt-choice input").first.press("Space")
    else:
        handle = page.locator(".dt-handle").first
        handle.focus()
        for key in ("ArrowDown", "ArrowDown", "ArrowUp"):
            page.keyboard.press(key)
    page.wait_for_function(
        "() => !document.querySelector('.dt-card .dt-main').getAttribute('aria-disabled')"
    )


def turn(page, lesson, values):
    """Turn every knob of the answer by hand to a value."""
    for name in lesson.settable:
        knob = lesson.knobs[name]
        row = page.locator(".dt-knobs")
        if isinstance(knob.allowed[0], str):
            label = dict(knob.options)[values[name]]
            group = row.get_by_role("radiogroup", name=knob.label).or_(
                row.get_by_role("group", name=knob.label)
            )
            group.get_by_role("radio", name=label, exact=True).check(force=True)
        else:
            slider = row.get_by_role("slider", name=knob.label)
            place = values[name]
            if knob.is_log:
                place = page.evaluate("value => Math.round(1000 * Math.log10(value)) / 1000", place)
            slider.evaluate(SET, place)
    page.wait_for_timeout(600)


@pytest.mark.parametrize("key", KEYS)
def test_a_pupil_bets_tries_misses_takes_a_hint_and_meets_the_challenge(lesson, axe, shot, key):
    page = lesson(key)
    spec = teach.lesson(key)
    see_together(page, shot, f"{key}_bet")
    bet(page, spec.bet.described())
    page.get_by_role("button", name="Lay the truth over it").press("Enter")
    page.get_by_role("button", name="Now try it").wait_for()
    assert page.evaluate("document.activeElement.textContent") == "Now try it"
    assert page.locator(".dt-card .dt-ask").inner_text() != spec.bet.question
    see_together(page, shot, f"{key}_truth")
    press(page, "Now try it")
    page.locator(".dt-tasks").wait_for()
    see_together(page, shot, f"{key}_try")
    press(page, "To the challenge")
    page.get_by_text(spec.challenge, exact=True).wait_for()
    for _ in range(2):
        press(page, "Check")
        page.locator(".dt-reason").wait_for()
    press(page, "Show a hint")
    page.get_by_text(spec.hints[0], exact=True).wait_for()
    see_together(page, shot, f"{key}_hint")
    page.add_script_tag(path=axe)
    assert page.evaluate(VIOLATIONS) == []
    turn(page, spec, spec.solution)
    press(page, "Check")
    page.locator(".dt-card.dt-passed").wait_for()
    page.get_by_role("button", name="Robot, write it").wait_for()
    see_together(page, shot, f"{key}_done")
    assert page.evaluate(VIOLATIONS) == []


def test_the_robot_writes_what_was_found_and_its_force_is_seen(lesson, shot):
    page = lesson("08")
    spec = teach.lesson("08")
    page.locator(".dt-step-bar").get_by_role("radio", name="3 Challenge").check(force=True)
    turn(page, spec, spec.solution)
    page.locator(".dt-knobs").get_by_role("radio", name="real motors").check(force=True)
    press(page, "Check")
    press(page, "Robot, write it")
    page.wait_for_selector(".dts-force:not([hidden])", timeout=60_000)
    page.wait_for_selector(".dt-scene[data-dt-ink]:not([data-dt-ink='0'])", timeout=60_000)
    see_together(page, shot, "08_robot")


def test_a_bet_and_the_knobs_outlive_a_restart_till_they_are_forgotten(lesson):
    page = lesson("03")
    places = page.evaluate(HANDLES)
    bet(page, teach.lesson("03").bet.described())
    press(page, "Lay the truth over it")
    page.get_by_role("button", name="Now try it").click()
    page.locator(".dt-knobs").get_by_role("slider", name="How wide each bump is").press("ArrowLeft")
    page.wait_for_timeout(800)
    kept = page.evaluate(
        "() => Object.entries(sessionStorage).find(([k]) => k.includes(' 03 '))[1]"
    )
    page.evaluate(
        "() => window.jupyterapp.shell.currentWidget.sessionContext.session.kernel.restart()"
    )
    page.wait_for_timeout(2000)
    page.evaluate("() => window.jupyterapp.commands.execute('notebook:run-cell')")
    page.locator(".dt-lesson .dt-tasks").wait_for()
    again = page.evaluate(
        "() => Object.entries(sessionStorage).find(([k]) => k.includes(' 03 '))[1]"
    )
    assert json.loads(again) == json.loads(kept)
    press(page, "Forget my work")
    press(page, "Yes, forget it")
    page.locator(".dt-handle").first.wait_for()
    assert page.evaluate(HANDLES) == places


def test_a_goal_that_is_dragged_asks_the_kernel_once(lesson):
    """Between press and release nothing is sent; the line follows all the same."""
    page = lesson("01")
    page.locator(".dt-step-bar").get_by_role("radio", name="2 Try").check(force=True)
    page.locator(".dt-tasks").wait_for()
    # The still picture for print follows a second after the last drawing.
    page.wait_for_timeout(2500)
    page.evaluate(
        """() => {
            window.sent = 0;
            const { send } = WebSocket.prototype;
            WebSocket.prototype.send = function (...all) {
                window.sent += 1;
                return send.apply(this, all);
            };
        }"""
    )
    box = page.locator(".dt-goal").bounding_box()
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    line = "() => document.querySelector('.dt-robot-line').getAttribute('d')"
    before = page.evaluate(line)
    page.mouse.move(x, y)
    page.mouse.down()
    for n in range(1, 20):
        page.mouse.move(x - 3 * n, y + 2 * n)
    page.wait_for_timeout(200)
    assert page.evaluate("() => window.sent") == 0
    held = page.evaluate(line)
    assert held != before
    page.mouse.up()
    page.wait_for_function("() => window.sent > 0")
    page.wait_for_timeout(800)
    assert page.evaluate(line) == held


def walk_to(page, words, key="Tab"):
    """Press a key until what has the focus is called so."""
    name = """() => {
        const here = document.activeElement;
        return here.getAttribute("aria-label") ?? here.labels?.[0]?.innerText ?? here.innerText;
    }"""
    for _ in range(60):
        if (page.evaluate(name) or "").strip().startswith(words):
            return
        page.keyboard.press(key)
    raise AssertionError(f"{words} is not reached by {key}")


def test_a_whole_lesson_by_keyboard_alone(lesson, shot):
    """From the cell to the robot that writes: no mouse, no finger."""
    page = lesson("04")
    spec = teach.lesson("04")
    walk_to(page, spec.bet.labels[0], "Shift+Tab")
    for key in ("ArrowUp", "ArrowUp", "ArrowRight", "ArrowDown"):
        page.keyboard.press(key)
    page.wait_for_function(
        "() => !document.querySelector('.dt-card .dt-main').getAttribute('aria-disabled')"
    )
    walk_to(page, "Lay the truth over it", "Shift+Tab")
    page.keyboard.press("Enter")
    page.get_by_role("button", name="Now try it").wait_for()
    for button in ("Now try it", "To the challenge"):
        walk_to(page, button)
        page.keyboard.press("Enter")
        page.wait_for_timeout(500)
    for _ in range(2):
        walk_to(page, "Check")
        page.keyboard.press("Enter")
        page.locator(".dt-reason").wait_for()
        page.wait_for_timeout(300)
    walk_to(page, "Show a hint")
    page.keyboard.press("Enter")
    page.get_by_text(spec.hints[0], exact=True).wait_for()
    walk_to(page, "How many bumps")
    page.keyboard.press("Home")
    for _ in range(spec.smallest - spec.knobs["n_kernels"].low):
        page.keyboard.press("ArrowRight")
    page.wait_for_timeout(800)
    walk_to(page, "Check", "Shift+Tab")
    page.keyboard.press("Enter")
    page.locator(".dt-card.dt-passed").wait_for()
    walk_to(page, "Robot, write it")
    page.keyboard.press("Enter")
    page.wait_for_selector(".dt-scene[data-dt-awake='true']", timeout=60_000)
    shot(page, "lesson_04_by_keyboard")
