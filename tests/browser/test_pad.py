"""The writing pad in a real JupyterLab: by mouse, finger, pen and keys."""

import ast
import json

import numpy as np
import pytest

import dmp_teach
from tests.browser.conftest import TOKEN
from tests.browser.pads import (
    PAD,
    Sheet,
    by_mouse,
    caught,
    farthest,
    into_sight,
    letter,
    open_pad,
    press,
    strokes,
)
from tests.browser.test_lab import notebook_of

WET = """() => {
    const ink = document.querySelector('.dt-ink');
    const { data } = ink.getContext('2d').getImageData(0, 0, ink.width, ink.height);
    return data.filter((value, i) => i % 4 === 3 && value > 0).length;
}"""
GROWING = """() => {
    window.seen = [];
    const panel = document.querySelector('.dt-pad');
    const look = () => {
        const line = panel.querySelector('.dt-stage > div:last-child .dt-robot-line');
        const now = [line.getTotalLength(), performance.now()];
        if ('dtShowing' in panel.dataset) window.seen.push(now);
        requestAnimationFrame(look);
    };
    look();
}"""
SAVE = "() => jupyterapp.commands.execute('docmanager:save')"
SHUT_DOWN = "() => jupyterapp.shell.currentWidget.sessionContext.shutdown()"
RESTART = "() => jupyterapp.shell.currentWidget.sessionContext.session.kernel.restart()"
DOTS = ".dt-stage > div:first-child .dt-child-dots"
LINE = ".dt-stage > div:last-child .dt-robot-line"


@pytest.fixture
def panel(open_notebook, lab):
    return lambda **context: open_pad(open_notebook, lab, **context)


def files(lab):
    return sorted(file.name for file in lab.folder.rglob("*.json"))


def test_a_child_writes_by_mouse_and_the_robot_learns_shows_and_writes_it(panel, lab, ask, shot):
    page = panel(again=True)
    shot(page, "pad_empty")
    sheet = Sheet(page, ask)
    drawn = sheet.on_screen(letter(size=0.9))
    assert page.evaluate(WET) == 0
    by_mouse(page, drawn, pause=10)
    assert page.evaluate(WET) > 1000
    assert ask(page, "pad.recordings") == "()"
    shot(page, "pad_wet")
    page.mouse.up()
    strokes(page, 1)
    page.wait_for_function(f"() => ({WET})() === 0")
    assert page.locator(DOTS).count() == 1
    assert farthest(caught(page, ask), sheet.in_metres(drawn)) < 0.001
    assert page.locator(".dt-caught").inner_text().startswith("Stroke 1:")
    assert "points" in page.locator(".dt-caught").inner_text()

    line = page.locator(LINE).get_attribute("d")
    assert len(line) > 500
    assert float(ask(page, "pad.letter.error")) < 0.002
    assert page.locator(".dt-rows li b").all_inner_texts() == json.loads(
        ast.literal_eval(
            ask(page, "__import__('json').dumps([part.word for part in pad.score.parts])")
        )
    )
    assert page.locator(".dt-rows li >> nth=0 >> circle").count() == 4
    press(page, "Start again")
    strokes(page, 0)
    by_mouse(page, sheet.on_screen(letter(step=20, size=0.5)))
    page.mouse.up()
    strokes(page, 1)
    page.locator(".dt-sentence", has_text="Further away this time").wait_for()
    assert page.locator(".dt-tries b").all_inner_texts() == ["Try 1", "Try 2"]
    press(page, "Undo")
    strokes(page, 0)
    press(page, "Undo")
    strokes(page, 1)
    shot(page, "pad_tries")


def test_the_robot_shows_its_letter_and_writes_it_and_only_save_writes_a_file(
    panel, lab, ask, shot
):
    page = panel(again=True)
    page.evaluate(GROWING)
    press(page, "Show it")
    page.wait_for_selector(".dt-pad[data-dt-showing]")
    shot(page, "pad_shows")
    page.wait_for_selector(".dt-pad:not([data-dt-showing])")
    lengths, seconds = page.evaluate(
        "[window.seen.map((each) => each[0]), (window.seen.at(-1)[1] - window.seen[0][1]) / 1000]"
    )
    assert lengths == sorted(lengths)
    assert len(set(lengths)) > 8
    assert seconds == pytest.approx(dmp_teach.recording_of("a").duration, abs=0.8)
    by_mouse(page, Sheet(page, ask).on_screen(letter(step=12)))
    page.mouse.up()
    strokes(page, 1)
    press(page, "Robot, write it")
    page.wait_for_selector(".dt-scene[data-dt-state='playing']", timeout=60_000)
    page.wait_for_function("Number(document.querySelector('.dt-scene').dataset.dtInk) > 0")
    assert ask(page, "pad.motion is pad.scene.motion") == "True"
    shot(page, "pad_written")

    assert files(lab) == []
    press(page, "Save")
    page.get_by_text("Saved as a_w01.json").wait_for()
    assert files(lab) == ["a_w01.json"]
    assert "w01" in ask(page, "teach.read_recording('a_w01.json')")
    press(page, "Forget")
    press(page, "Yes, forget all")
    page.get_by_text("Everything is forgotten, and a_w01.json removed.").wait_for()
    assert files(lab) == []
    assert ask(page, "(pad.recordings, pad.ink, pad.tried, pad.motion)") == "((), b'', b'', None)"
    assert page.locator(DOTS).count() == 0
    assert page.locator(".dt-tries li").count() == 0


def test_a_saved_notebook_holds_no_ink_and_its_panel_says_how_to_wake_it(
    open_notebook, lab, ask, shot
):
    cells = PAD, "other = teach.pad()  # is never seen", "1", "2"
    (lab.folder / "kept.ipynb").write_text(notebook_of(*cells))
    page = open_notebook("kept.ipynb")
    page.wait_for_selector(".dt-pad[data-dt-drawing]")
    into_sight(page)
    by_mouse(page, Sheet(page, ask).on_screen(letter()), pause=15)
    page.mouse.up()
    strokes(page, 1)
    assert ask(page, "other.load(pad.recording)") == "None"
    page.evaluate("""async () => {
        const notebook = jupyterapp.shell.currentWidget.content;
        const motion = "teach.Fetch().write(pad.recording.strokes(), teach.Page.table())";
        for (const [i, source] of [[2, "pad.recording"], [3, `teach.view(${motion})`]]) {
            notebook.model.cells.get(i).sharedModel.setSource(source);
            notebook.activeCellIndex = i;
            notebook.deselectAll();
            await jupyterapp.commands.execute("notebook:run-cell");
        }
    }""")
    page.locator(
        ".jp-OutputArea-output img, .jp-OutputArea-output svg.dmp-teach-ink"
    ).first.wait_for(state="attached")
    answered = "jupyterapp.shell.currentWidget.content.model.cells.get(3).outputs.length > 0"
    page.wait_for_function(answered, timeout=60_000)
    shot(page, "pad_recording")
    page.evaluate(SAVE)
    saved = json.loads((lab.folder / "kept.ipynb").read_text())
    widgets = [
        each for kind in saved["metadata"]["widgets"].values() for each in kind["state"].values()
    ]
    ours = [each for each in widgets if each["model_name"] == "AnyModel"]
    assert len(ours) >= 3, "the pad, the one that is never seen, the robot"
    assert all(name.startswith("_") for each in ours for name in each["state"])
    assert not any(each.get("buffers") for each in widgets)
    assert [list(output["data"]) for output in saved["cells"][2]["outputs"]] == [["text/plain"]]
    assert len(json.dumps(saved)) < 12_000

    page.evaluate(SHUT_DOWN)
    page.goto(f"{lab.url}/lab/tree/notebooks/kept.ipynb?token={TOKEN}")
    page.get_by_text("This panel is resting. Run the cell above to wake it").first.wait_for(
        timeout=60_000
    )
    assert page.get_by_text("model not found").count() == 0
    shot(page, "pad_resting")


def test_after_a_restart_a_press_leads_to_the_sentence_that_the_pad_does_not_answer(panel, shot):
    page = panel(again=True, viewport={"width": 1280, "height": 700})
    page.evaluate(RESTART)
    page.wait_for_timeout(1000)
    press(page, "Robot, write it")
    sentence = page.get_by_text("The pad does not answer")
    sentence.wait_for(timeout=10_000)
    page.wait_for_timeout(300)
    room, words = (
        place.bounding_box() for place in (page.locator(".jp-NotebookPanel-notebook"), sentence)
    )
    assert room["y"] <= words["y"]
    assert words["y"] + words["height"] <= room["y"] + room["height"]
    shot(page, "pad_asleep")


def test_finger_and_pen_write_and_a_palm_does_not_also_scrolled_zoomed_and_resized(
    panel, ask, shot
):
    page = panel(viewport={"width": 820, "height": 900}, has_touch=True, device_scale_factor=1.5)
    page.evaluate("document.querySelector('.jp-WindowedPanel-outer').scrollBy(0, 40)")
    page.set_viewport_size({"width": 900, "height": 1000})
    page.wait_for_timeout(1000)
    hand = page.context.new_cdp_session(page)
    sheet = Sheet(page, ask)
    path = sheet.on_screen(letter())
    scrolled = "document.querySelector('.jp-WindowedPanel-outer').scrollTop"

    def touch(kind, *places):
        hand.send(
            "Input.dispatchTouchEvent",
            {"type": kind, "touchPoints": [{"x": x, "y": y} for x, y in places]},
        )

    def pen(kind, place, force):
        x, y = place
        buttons = (
            {"button": "left", "buttons": 1, "clickCount": 1}
            if force or kind != "mouseMoved"
            else {}
        )
        event = {"type": kind, "x": x, "y": y, "pointerType": "pen", "force": force, **buttons}
        hand.send("Input.dispatchMouseEvent", event)

    before = page.evaluate(scrolled)
    touch("touchStart", path[0])
    for place in path[1:]:
        touch("touchMove", place)
    touch("touchEnd")
    strokes(page, 1)
    assert page.evaluate(scrolled) == before > 0
    assert farthest(caught(page, ask), sheet.in_metres(path)) < 0.001
    assert ask(page, "pad.recording.pressure") == "None"
    press(page, "Start again")
    strokes(page, 0)

    touch("touchStart", sheet.on_screen([0.12, -0.02]))  # the palm lands first
    touch("touchMove", sheet.on_screen([0.121, -0.021]))
    force = np.linspace(0.2, 0.9, len(path))
    pen("mousePressed", path[0], force[0])
    for place, hard in zip(path[1:], force[1:], strict=True):
        pen("mouseMoved", place, float(hard))
    pen("mouseReleased", path[-1], 0.0)
    touch("touchEnd")
    strokes(page, 1)
    touch("touchStart", sheet.on_screen([0.1, -0.02]))  # and is still there after the lift
    touch("touchEnd")
    page.wait_for_timeout(300)
    strokes(page, 1)
    assert farthest(caught(page, ask), sheet.in_metres(path)) < 0.001
    low, high = ast.literal_eval(
        ask(page, "(float(pad.recording.pressure[0]), float(pad.recording.pressure.max()))")
    )
    assert low == pytest.approx(0.2, abs=0.02)
    assert high == pytest.approx(0.9, abs=0.02)
    shot(page, "pad_tablet")


def test_keys_alone_suffice_and_people_who_ask_for_less_movement_get_stills(panel, ask, shot):
    page = panel(reduced_motion="reduce")
    sent = page.evaluate("jupyterapp.shell.currentWidget.content.model.cells.length")
    page.get_by_role("radio", name="the letter a, small").focus()
    reached = []
    for _ in range(13):
        reached.append(
            page.evaluate(
                "() => { const e = document.activeElement; "
                "return e.getAttribute('aria-label') ?? e.innerText; }"
            )
        )
        page.keyboard.press("Tab")
    wanted = (
        "the letter a",
        "More letters",
        "Your sheet is empty",
        "Undo",
        "Start again",
        "The robot’s own letter",
    )
    wanted += ("Show it", "Robot, write it", "Open your own recording", "Forget", "Save")
    places = [
        next((k for k, name in enumerate(reached) if name.startswith(word)), None)
        for word in wanted
    ]
    assert places == sorted(places), list(zip(wanted, places, strict=True))

    page.get_by_role("radio", name="the letter i, small").check(force=True)
    page.wait_for_function("document.querySelector('.dt-hint').textContent.includes('an i')")
    page.locator(".dt-ink").focus()
    for key in ("Home", "Space", *["ArrowDown"] * 30, "Shift+ArrowRight", "Space"):
        page.keyboard.press(key)
    strokes(page, 1)
    bar = caught(page, ask)
    assert np.ptp(bar, axis=0) == pytest.approx([0.01, 0.06], abs=1e-6)
    assert bar[0] == pytest.approx(dmp_teach.recording_of("i").strokes()[0].position[0], abs=1e-6)
    assert 1.2 < float(ask(page, "pad.recording.duration")) < 1.6
    page.keyboard.press("Home")
    page.keyboard.press("Space")
    page.keyboard.press("Space")
    strokes(page, 2)
    assert page.locator(".dt-caught").inner_text() == "Stroke 2: a dot."
    assert page.locator(".dt-rows li").count() == 4
    shot(page, "pad_keys")

    page.get_by_role("button", name="Show it").press("Enter")
    lengths = []
    for number in (1, 2):
        page.get_by_text(f"picture {number} of 2").wait_for()
        lengths.append(page.locator(LINE).count())
        page.get_by_role("button", name="Next picture").press("Enter")
    assert lengths == [1, 2]
    page.get_by_role("button", name="Undo").press("Space")
    strokes(page, 1)
    assert page.evaluate("jupyterapp.shell.currentWidget.content.model.cells.length") == sent
