"""The view as a file: opened from disk, with the network cut."""

from io import BytesIO
from time import monotonic

import numpy as np
import pytest
from PIL import Image

from dmp_teach.views.scene.view import view
from tests.views.moves import sway

ROOT = ".dt-scene"
VIEWPORT = {"width": 1000, "height": 900}


@pytest.fixture(scope="module")
def file(tmp_path_factory):
    return view(sway()).html(tmp_path_factory.mktemp("file") / "robot.html")


def data(page, name):
    return page.locator(ROOT).get_attribute(f"data-dt-{name}")


def test_the_robot_writes_and_the_ink_follows_the_slider_both_ways(opened, shot):
    page = opened()
    page.wait_for_selector(f"{ROOT}[data-dt-state='ready']")
    whole = int(data(page, "ink"))
    assert whole > 100
    amounts = []
    slider = page.get_by_role("slider", name="Time")
    for time in (0.0, 0.6, 1.2, 1.8, 2.4, 1.2, 0.0):
        slider.evaluate(
            "(node, t) => { node.value = t; node.dispatchEvent(new Event('input')); }", time
        )
        amounts.append(int(data(page, "ink")))
    assert amounts[0] == amounts[-1] == 0
    assert amounts[2] == amounts[5]
    assert amounts[:5] == sorted(amounts[:5])
    assert amounts[4] == whole
    shot(page, "scene_file")


def test_the_picture_changes_when_the_pen_moves(opened):
    page = opened(reduced_motion="reduce")
    box = page.locator(".dts-box")
    slider = page.get_by_role("slider", name="Time")

    def at(key):
        slider.press(key)
        page.wait_for_timeout(1000)
        return np.asarray(Image.open(BytesIO(box.screenshot())).convert("RGB"), dtype=int)

    end, start = at("End"), at("Home")
    assert np.abs(end - start).max() > 50
    assert np.abs(end - at("End")).max() < 5


def test_the_play_button_plays_and_pauses_by_the_space_key(opened):
    page = opened()
    page.wait_for_selector(f"{ROOT}[data-dt-state='ready']")
    page.get_by_role("slider", name="Time").press("Home")
    page.get_by_role("button", name="Play").press("Space")
    page.wait_for_selector(f"{ROOT}[data-dt-state='playing']")
    page.get_by_role("button", name="Pause").press("Space")
    page.wait_for_selector(f"{ROOT}[data-dt-state='ready']")
    assert 0 <= float(data(page, "time")) < 2.4


def test_a_quarter_of_the_speed_takes_four_times_as_long(opened):
    page = opened()
    page.wait_for_selector(f"{ROOT}[data-dt-state='ready']")
    page.get_by_role("radio", name="¼×").check(force=True)
    page.get_by_role("button", name="Play").click()
    page.wait_for_selector(
        f"{ROOT}[data-dt-state='playing']:not([data-dt-time='2.400'], [data-dt-time='0.000'])"
    )
    first = page.evaluate(
        "[performance.now(), Number(document.querySelector('.dt-scene').dataset.dtTime)]"
    )
    page.wait_for_timeout(1500)
    last = page.evaluate(
        "[performance.now(), Number(document.querySelector('.dt-scene').dataset.dtTime)]"
    )
    assert (last[1] - first[1]) / ((last[0] - first[0]) / 1000) <= 0.3


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_it_follows_the_systems_light_or_dark(opened, scheme, shot):
    page = opened(color_scheme=scheme)
    card = page.locator(ROOT).evaluate("node => getComputedStyle(node).backgroundColor")
    assert (card == "rgb(255, 255, 255)") == (scheme == "light")
    shot(page, f"scene_file_{scheme}")


@pytest.mark.parametrize("width", [320, 768])
def test_nothing_is_cut_on_a_narrow_screen_and_targets_are_large(opened, width, shot):
    page = opened(viewport={"width": width, "height": 900}, reduced_motion="reduce")
    assert page.evaluate("document.documentElement.scrollWidth") <= width
    for box in page.evaluate(
        "[...document.querySelectorAll('.dts-play, .dts-choice label, .dts-bar input')]"
        ".map(n => n.getBoundingClientRect()).filter(r => r.width).map(r => [r.width, r.height])"
    ):
        assert min(box) >= 44
    shot(page, f"scene_file_{width}")


def test_every_control_has_a_name_and_the_picture_an_alternative(opened):
    page = opened()
    assert page.get_by_role("img", name="It writes 2 strokes in 2.4 s").count() == 1
    assert page.get_by_role("slider", name="Time").count() == 1
    assert page.get_by_role("group", name="Camera").count() == 1
    assert page.get_by_role("group", name="Speed").count() == 1
    assert page.title() == "A robot writes a letter"


def test_without_webgl_the_letter_is_still_written_on_the_small_page(chromium, file, shot):
    context = chromium.new_context(reduced_motion="reduce")
    context.add_init_script("HTMLCanvasElement.prototype.getContext = () => null")
    page = context.new_page()
    page.goto(file.as_uri())
    page.get_by_text("This browser cannot draw in three dimensions here").wait_for()
    ink = page.locator(".dts-ink")
    lengths = []
    for key in ("End", "Home"):
        page.get_by_role("slider", name="Time").press(key)
        lengths.append(len(ink.get_attribute("d")))
    assert lengths[0] > 500
    assert lengths[1] == 0
    shot(page, "scene_flat")
    context.close()


def test_on_a_slow_machine_a_motion_takes_no_longer_than_it_lasts(opened):
    page = opened()
    page.wait_for_selector(f"{ROOT}[data-dt-state='ready']")
    page.evaluate(
        """() => {
            const draw = window.requestAnimationFrame.bind(window);
            window.requestAnimationFrame = (next) => setTimeout(() => draw(next), 300);
        }"""
    )
    page.get_by_role("slider", name="Time").press("Home")
    page.get_by_role("button", name="Play").press("Space")
    page.wait_for_selector(f"{ROOT}[data-dt-state='playing']")
    began = monotonic()
    page.wait_for_selector(f"{ROOT}[data-dt-state='ready']")
    assert monotonic() - began < 5, "of 2.4 s, in pictures of 0.1 s at most: 7 s and more"


def test_in_a_wide_low_picture_the_letter_is_large_and_the_arm_is_not_under_it(opened, shot):
    page = opened(viewport={"width": 1200, "height": 560}, reduced_motion="reduce")
    picture = page.locator(".dts-picture").bounding_box()
    assert picture["width"] > 3 * picture["height"]
    small = page.locator(".dts-inset").bounding_box()
    drawn = page.locator(".dts-box").bounding_box()
    assert page.locator(".dts-ink").bounding_box()["height"] > picture["height"] / 3
    assert drawn["x"] + drawn["width"] <= small["x"] + 1
    shot(page, "wide")
