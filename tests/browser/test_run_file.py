"""A run as a file: the force under the time slider, one picture and one time."""

import re

import pytest

from dmp_teach.views.scene.view import view
from tests.views.moves import pressed, sway

ROOT = ".dt-scene"
VIEWPORT = {"width": 1000, "height": 1150}
PLACES = """() => {
    const middle = (node) => {
        const box = node.getBoundingClientRect();
        return box.left + box.width / 2;
    };
    const slider = document.querySelector('.dts-bar input');
    const box = slider.getBoundingClientRect();
    const part = slider.value / slider.max;
    return { thumb: box.left + 14 + part * (box.width - 28),
             head: middle(document.querySelector('.dts-f-head')),
             dot: middle(document.querySelector('.dts-f-dot')) };
}"""


@pytest.fixture(scope="module")
def run():
    return pressed(sway())


@pytest.fixture(scope="module")
def file(run, tmp_path_factory):
    return view(run).html(tmp_path_factory.mktemp("file") / "run.html")


def go(page, time):
    slider = page.get_by_role("slider", name="Time")
    slider.evaluate(
        "(node, t) => { node.value = t; node.dispatchEvent(new Event('input')); }", time
    )


@pytest.mark.parametrize(("width", "scheme"), [(1000, "light"), (1000, "dark"), (400, "light")])
def test_the_playhead_stands_under_the_thumb(opened, shot, width, scheme):
    page = opened(
        viewport={"width": width, "height": 1150}, color_scheme=scheme, reduced_motion="reduce"
    )
    for time in (0.0, 0.7, 1.9, 2.4):
        go(page, time)
        places = page.evaluate(PLACES)
        assert abs(places["head"] - places["thumb"]) < 1.5
        assert abs(places["dot"] - places["thumb"]) < 1.5
    assert page.evaluate("document.documentElement.scrollWidth") <= width
    go(page, 0.7)
    shot(page, f"run_{width}_{scheme}")


def test_it_follows_a_window_that_changes(opened):
    page = opened(reduced_motion="reduce")
    go(page, 1.0)
    page.set_viewport_size({"width": 700, "height": 1000})
    page.wait_for_timeout(500)
    places = page.evaluate(PLACES)
    assert abs(places["head"] - places["thumb"]) < 1.5


def test_the_number_and_the_sentence_are_those_of_the_moment(opened, run):
    page = opened(reduced_motion="reduce")
    for time, words in ((0.0, "The pen is in the air."), (1.0, "good pressing"), (0.5, "too hard")):
        go(page, time)
        force = run.force[round(time * 240)]
        assert float(page.locator(".dts-newtons").inner_text().split()[0]) == pytest.approx(
            force, abs=0.06
        )
        assert words in page.locator(".dts-feels").inner_text()
    assert page.get_by_text("Pressed too hard").count() == 1
    assert page.get_by_role("img", name=re.compile("How hard the pen presses")).count() == 1


def test_the_small_page_has_a_path_for_each_shade_and_grows(opened):
    page = opened(reduced_motion="reduce")
    shades = page.locator(".dts-shade")
    lengths = []
    for time in (0.0, 1.2, 2.4):
        go(page, time)
        lengths.append(
            sum(
                len(path)
                for path in shades.evaluate_all("all => all.map(n => n.getAttribute('d'))")
            )
        )
    assert lengths[0] == 0 < lengths[1] < lengths[2]
    assert page.locator(".dts-ink").get_attribute("d") == ""


def test_the_plan_and_what_happened_are_seen_at_the_same_moment(opened, shot):
    page = opened(reduced_motion="reduce")
    go(page, 1.2)
    ink = page.locator(".dts-ink")
    assert page.locator(".dts-force").is_visible()
    page.get_by_role("radio", name="as planned").check()
    page.wait_for_function("document.querySelector('.dts-force').hidden")
    assert ink.get_attribute("d").startswith("M"), "the plan has one shade"
    assert page.locator(ROOT).get_attribute("data-dt-time") == "1.200"
    shot(page, "run_as_planned")
    page.get_by_role("radio", name="as it happened").check()
    page.wait_for_function("!document.querySelector('.dts-force').hidden")
    assert ink.get_attribute("d") == ""
    assert page.evaluate(PLACES)["head"] == pytest.approx(page.evaluate(PLACES)["thumb"], abs=1.5)
