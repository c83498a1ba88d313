"""The view of a run: its ink in shades of the pen's force, and the force on the same clock."""

import re
from dataclasses import replace

import numpy as np
import pytest
import umsgpack
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp
from PIL import Image

from dmp_teach.robot.simulation.run import FORCE_BAND, Run
from dmp_teach.robot.simulation.world import SLIDE_JOINT
from dmp_teach.views.scene import pen_force
from dmp_teach.views.scene.commands import record_stage
from dmp_teach.views.scene.picture import INK_RGBA
from dmp_teach.views.scene.stage import Stage
from dmp_teach.views.scene.view import SceneView, view
from tests.views.moves import pressed, sway, unpack_commands


@pytest.fixture(scope="module")
def run():
    return pressed(sway())


@pytest.fixture(scope="module")
def stage(run):
    return Stage(run.motion, run)


def commands(stage):
    return [umsgpack.unpackb(command) for command in record_stage(stage)]


def sent(stage, path):
    return next(
        c for c in commands(stage) if c["path"].endswith(path) and c["type"] == "set_object"
    )["object"]


forces = hnp.arrays(float, st.integers(1, 3000), elements=st.floats(0, 50))


@given(forces)
def test_the_curve_keeps_the_greatest_and_the_least_force_and_both_ends(force):
    rows = pen_force.select_curve_rows(force)
    assert len(rows) <= pen_force.MAX_CURVE_ROWS + 2
    assert (np.diff(rows) > 0).all()
    assert (rows[0], rows[-1]) == (0, len(force) - 1)
    assert force[rows].max() == force.max()
    assert force[rows].min() == force.min()


@given(st.floats(0, 100), st.floats(0, 100))
def test_who_presses_harder_writes_wider_and_darker(one, other):
    low, high = sorted((one, other))
    assert pen_force.find_ink_width(np.array([low])) <= pen_force.find_ink_width(np.array([high]))
    assert pen_force.find_shade(np.array([low])) <= pen_force.find_shade(np.array([high]))


def luminance(color):
    parts = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in color]
    return float(np.dot(parts, (0.2126, 0.7152, 0.0722)))


def test_the_shades_are_told_apart_without_seeing_colours():
    light = [
        luminance(pen_force.shade_rgb(number)) + 0.05
        for number in range(len(pen_force.FORCE_SHADES))
    ]
    steps = np.array(light[:-1]) / light[1:]
    assert steps.min() > 1.2
    assert light[0] / light[-1] > 5
    assert (
        pen_force.find_shade(np.array(FORCE_BAND)) == (1, len(pen_force.FORCE_SHADES) - 1)
    ).all()
    np.testing.assert_allclose(
        pen_force.shade_rgb(int(pen_force.find_shade(np.array([0.53]))[0])),
        INK_RGBA[:3],
        atol=0.003,
    )


def test_every_corner_of_the_ink_has_the_shade_of_its_force(run, stage):
    attributes = sent(stage, "ink")["geometries"][0]["data"]["attributes"]
    colors = np.frombuffer(attributes["color"]["array"].data, np.uint8).reshape(-1, 3)
    assert len(colors) == len(stage.ink.vertices)
    t = stage.ink.t[stage.ink.owners]
    force = np.interp(t, run.t[run.contact], run.force[run.contact])
    expected = [
        [round(255 * part) for part in pen_force.shade_rgb(n)] for n in pen_force.find_shade(force)
    ]
    assert (colors == expected).all()
    assert len(np.unique(colors, axis=0)) > 3


def test_a_plan_has_its_one_colour(run):
    assert "color" not in sent(Stage(run.planned), "ink")["geometries"][0]["data"]["attributes"]
    assert Stage(run.planned).facts()["force"] is None


def test_the_pen_slides_in_a_run_and_is_put_back_for_a_plan(run, stage):
    clips = {clip["path"].split("/")[-1]: clip for clip in commands(stage)[-1]["animations"]}
    assert clips["pen_link"]["clip"]["tracks"][0]["name"] == ".position"
    plan = commands(Stage(run.planned))
    poses = [
        c["matrix"]
        for c in plan
        if c["type"] == "set_transform" and c["path"].endswith("/pen_link")
    ]
    np.testing.assert_allclose(np.reshape(list(poses[-1]), (4, 4)), np.eye(4))
    assert "pen_link" not in {clip["path"].split("/")[-1] for clip in plan[-1]["animations"]}


def test_a_rigid_pen_breaks_where_it_is_pushed_too_hard_and_writes_no_more():
    motion = sway()
    force = pressed(motion).force + 20 * (motion.t > 1.5)
    run = replace(pressed(motion), motion=motion, pen="rigid", force=force)
    stage = Stage(run.motion, run)
    assert stage.breaks_at == pytest.approx(1.5, abs=0.01)
    assert stage.ink.t.max() <= stage.breaks_at
    clips = {clip["path"].split("/")[-1]: clip for clip in commands(stage)[-1]["animations"]}
    assert clips["pen_link"]["clip"]["tracks"][0]["name"] == ".quaternion"
    whole, broken = ({each.name: each for each in stage.robot(t)} for t in (1.49, 1.52))
    tip = next(name for name in whole if name.startswith("pen_tip"))
    moved = np.linalg.norm(broken[tip].vertices - whole[tip].vertices, axis=1)
    assert moved.min() > 0.05
    assert np.isinf(Stage(run.planned).breaks_at)


def test_the_drawn_pen_touches_the_paper_where_the_ink_is(run, stage):
    for row in np.flatnonzero(run.contact)[::60]:
        tip = stage.model.frame("pen_tip", run.motion.q[row], run.motion.joint_names)[0, :3, 3]
        np.testing.assert_allclose(run.page.to_page(tip)[:2], run.nib[row, :2], atol=1e-9)


def test_the_browser_is_told_the_force_on_the_motions_own_clock(run, stage):
    force = stage.facts()["force"]
    curve = np.array(force["curve"])
    rows = pen_force.select_curve_rows(run.force)
    np.testing.assert_allclose(curve[:, 0], run.t[rows], atol=6e-4)
    np.testing.assert_allclose(curve[:, 1], run.force[rows], atol=6e-4)
    np.testing.assert_allclose(curve[:, 2:], 1000 * run.nib[rows, :2], atol=0.06)
    assert len(force["down"]) == len(run.planned.strokes)
    assert force["findings"] == list(run.findings)
    assert all(0 <= dot[4] < len(pen_force.FORCE_SHADES) for dot in stage.facts()["ink"])


def test_a_sentence_says_how_near_the_ink_is(run):
    assert pen_force.describe_ink_error(run) == "The ink is less than 0.1 mm off the plan."
    beside = replace(run, nib=run.nib + np.array([0.0, 0.0004, 0.0]))
    assert re.fullmatch(
        r"The ink is 0\.[1-4] mm off the plan\.", pen_force.describe_ink_error(beside)
    )
    assert (
        pen_force.describe_ink_error(replace(run, contact=np.zeros_like(run.contact)))
        == "There is no ink."
    )


def test_a_run_without_ink_is_shown_too(run, tmp_path):
    dry = replace(run, ink=(), contact=np.zeros_like(run.contact), force=np.zeros_like(run.force))
    assert view(dry).html(tmp_path / "a.html").stat().st_size < 800_000
    assert Stage(dry.motion, dry).facts()["force"]["inked"] == 0
    view(dry).png(tmp_path / "a.png", width=300, height=200)


def test_a_whole_word_takes_less_than_eight_tenths_of_a_megabyte(tmp_path):
    word = pressed(sway(seconds=40))
    assert view(word).html(tmp_path / "word.html").stat().st_size <= 800_000


def test_the_picture_has_the_strip_and_the_size_that_was_asked_for(run, tmp_path):
    early, late = (
        view(run).png(tmp_path / f"{t}.png", time=t, width=450, height=300) for t in (0.5, 2.0)
    )
    early, late = (np.asarray(Image.open(path)).astype(int) for path in (early, late))
    assert early.shape == late.shape == (300, 450, 3)
    blue = [np.abs(image[230:] - (0, 114, 178)).max(axis=2) < 30 for image in (early, late)]
    assert 50 < blue[0].sum() < blue[1].sum(), "the curve grows"
    head = [
        np.abs(image[240:290] - (27, 36, 48)).max(axis=2).sum(axis=0).argmin()
        for image in (early, late)
    ]
    scale = 0.885 * 450 / run.duration
    np.testing.assert_allclose(head, [0.085 * 450 + 0.5 * scale, 0.085 * 450 + 2.0 * scale], atol=2)


def test_one_view_shows_a_plan_and_then_what_became_of_it(run):
    shown = SceneView(run.planned)
    shown.show(run, play=False)
    assert shown.motion is run
    assert shown.facts["force"]["curve"]
    shown.show(run.planned, play=False)
    assert shown.facts["force"] is None


def test_the_run_of_the_tests_is_one(run):
    assert isinstance(run, Run)
    assert run.motion.joint_names[-1] == SLIDE_JOINT
    assert run.shape_error < 1e-6


def test_a_run_is_shown_as_planned_too(run, tmp_path):
    shown = view(run)
    assert shown.planned_facts == Stage(run.planned).facts()
    assert unpack_commands(shown.planned_run) == record_stage(Stage(run.planned))
    shown.seen = "as planned"
    planned, alone = (
        v.png(tmp_path / "a.png", width=300, height=200).read_bytes()
        for v in (shown, view(run.planned))
    )
    assert planned == alone
    shown.show(run.planned, play=False)
    assert (shown.planned_run, shown.planned_facts) == (b"", {})
