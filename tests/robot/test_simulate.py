"""What must hold for every letter under gravity, on paper; and that what goes wrong is said."""

import os
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from hypothesis import strategies as st

import dmp_teach as teach
from dmp_teach.errors import MissingPartError, SettingError
from dmp_teach.robot.model.kinematics import Model
from dmp_teach.robot.simulation import bullet as physics
from dmp_teach.robot.simulation.run import FORCE_BAND, describe_part, measure_distances
from dmp_teach.robot.simulation.simulate import simulate
from dmp_teach.robot.simulation.world import NIB_RADIUS, PENS, SLIDE_JOINT
from tests.recordings import RECORDINGS, needs_recordings
from tests.robot import ink
from tests.robot.ink import law

pybullet = pytest.importorskip("pybullet", reason="pybullet is not on this platform")

PAGES = {"table": teach.Page.table(), "board": teach.Page.board()}
LETTERS = [
    ("a", "round", "table", None),
    ("i", "slanted", "board", 0.10),
    ("g", "slanted", "table", 0.18),
    ("8", "round", "board", 0.15),
    ("R", "round", "table", 0.12),
    ("k", "slanted", "table", 0.03),
]


@cache
def written(character="a", alphabet="round", page="table", size=None):
    letter = teach.Letter.learn(teach.recording_of(character, alphabet))
    return teach.Fetch().write(letter.write(), PAGES[page], size=size)


def short():
    """The first bit of a motion: a quarter of a second, down to the paper."""
    motion = written()
    rows = slice(0, 84)
    cut = {name: getattr(motion, name)[rows] for name in ("t", "q", "tip", "target", "pen_down")}
    return replace(motion, **cut)


def time_error(run):
    """Root mean square distance of the ink from where the pen was meant to be just then [m]."""
    meant = run.planned.page.to_page(run.motion.target[run.writing])[:, :2]
    return np.sqrt(np.mean(np.sum((run.nib[run.writing, :2] - meant) ** 2, axis=1)))


def assert_written(run, error):
    """The letter stands on the paper as planned, pressed as it should be."""
    assert run.shape_error <= error
    assert run.contact[run.motion.pen_down].mean() >= 0.99
    assert FORCE_BAND[0] <= run.force_band[0] <= run.force_band[1] <= FORCE_BAND[1]
    assert run.ink_in_the_air == 0
    assert run.missing.mean() < 0.01
    assert [sentence for sentence in run.findings if "of the time; it has" not in sentence] == []


@pytest.mark.parametrize("letter", LETTERS, ids=str)
def test_with_ideal_motors_the_ink_is_the_planned_letter(letter):
    run = simulate(written(*letter))
    assert_written(run, 0.00005)
    assert time_error(run) <= 0.00005
    assert (np.abs(run.effort) <= run.limits).all()
    assert run.findings == ()
    assert len(run.ink) == len(run.planned.strokes)


@pytest.mark.parametrize(("letter", "seed"), list(zip(LETTERS, range(6), strict=True)), ids=str)
def test_with_real_motors_the_ink_is_within_a_millimetre(letter, seed):
    run = simulate(written(*letter), motors="real", seed=seed)
    assert_written(run, 0.001)
    assert (np.abs(run.effort) <= run.limits).all()
    assert run.shape_error > 0.00005, "real motors are not ideal"
    assert run.shape_error <= time_error(run)


@law(
    examples=6,
    letter=ink.letters(),
    page=st.sampled_from(sorted(PAGES)),
    seed=st.integers(0, 10**6),
)
def test_any_ink_is_written(letter, page, seed):
    motion = teach.Fetch().write(letter, PAGES[page])
    assert_written(simulate(motion), 0.00005)
    assert_written(simulate(motion, motors="real", seed=seed), 0.0015)


@needs_recordings
@pytest.mark.parametrize("path", RECORDINGS[::9], ids=lambda path: path.stem)
def test_recorded_letters_are_written(path):
    strokes = teach.read_recording(path).strokes()
    extent = np.ptp(np.concatenate([stroke.position for stroke in strokes]), axis=0)
    fits = min(1.0, *((PAGES["table"].size - 0.0102) / extent))
    motion = teach.Fetch().write(strokes, PAGES["table"], size=fits * extent[1])
    assert_written(simulate(motion), 0.00005)
    assert_written(simulate(motion, motors="real"), 0.001)


@pytest.mark.parametrize("motors", ["ideal", "real"])
def test_the_same_seed_gives_the_same_run_bit_for_bit(motors):
    first, again = (simulate(written(), motors=motors, seed=3) for _ in range(2))
    for name in ("force", "nib", "effort", "contact"):
        np.testing.assert_array_equal(getattr(first, name), getattr(again, name))
    np.testing.assert_array_equal(first.motion.q, again.motion.q)


def test_another_seed_is_another_robot():
    one, other = (simulate(short(), motors="real", seed=seed) for seed in (0, 1))
    assert np.abs(one.motion.q - other.motion.q).max() > 1e-5


def test_the_clock_and_the_joints_are_the_plans_and_the_pen_slides():
    plan = written()
    run = simulate(plan)
    np.testing.assert_array_equal(run.t, plan.t)
    assert run.motion.joint_names == (*plan.joint_names, SLIDE_JOINT)
    assert np.abs(run.motion.q[:, :-1] - plan.q).max() < 1e-4
    slide = run.motion.q[:, -1]
    assert np.abs(slide[0]) < 1e-9
    np.testing.assert_allclose(slide[plan.pen_down], -0.004, atol=5e-5)
    for stroke in run.ink:
        assert stroke.t[0] >= run.t[0]
        assert stroke.t[-1] <= run.t[-1]


def test_the_force_is_the_springs_and_the_pens_weight():
    """0.4 N from the spring everywhere; on a table the pen of 13 g adds its weight, 0.127 N."""
    for page, force in (("table", 0.4 + 0.013 * 9.81), ("board", 0.4)):
        run = simulate(written("i", "slanted", page, 0.10))
        np.testing.assert_allclose(np.median(run.force[run.writing]), force, atol=0.005)


def test_the_model_has_the_nib_and_the_slide_that_the_physics_counts_on():
    fixed, sprung = (Model.load(PENS[pen]) for pen in ("rigid", "sprung"))
    slide = sprung.joint(SLIDE_JOINT)
    assert (slide.type, slide.lower, slide.upper) == ("prismatic", -0.012, 0.0)
    near, far = (model.frame("pen_tip", np.zeros((1, 0)), ())[0] for model in (fixed, sprung))
    np.testing.assert_allclose(far[:3, 3] - near[:3, 3], 0.004 * near[:3, 2], atol=1e-12)
    with physics.open_world() as (bullet, number):
        robot = bullet.loadURDF(str(PENS["sprung"]), physicsClientId=number)
        count = bullet.getNumJoints(robot, physicsClientId=number)
        names = [
            bullet.getJointInfo(robot, n, physicsClientId=number)[12].decode() for n in range(count)
        ]
        _, _, kind, size, *_ = bullet.getCollisionShapeData(
            robot, names.index("pen_tip"), physicsClientId=number
        )[0]
    assert kind == pybullet.GEOM_SPHERE
    assert size[0] == NIB_RADIUS


def test_a_page_6_mm_too_low_gets_no_ink():
    run = simulate(written(), page_height_error=-0.006)
    assert run.ink == ()
    assert not run.contact.any()
    assert run.missing.all()
    assert np.isnan(run.shape_error)
    (sentence,) = run.findings
    assert sentence.startswith("No ink: the pen's tip stayed 1.")
    assert sentence.endswith("2.0 mm over the paper. Plan again for the page as it lies.")
    assert "no ink" in repr(run)


@pytest.mark.parametrize(("tilt", "bare", "hard"), [(5, "bottom", "top"), (-5, "top", "bottom")])
def test_a_tilted_page_lacks_a_part_of_the_letter_and_the_sentence_says_which(tilt, bare, hard):
    run = simulate(written("l", "round", "table", 0.2), page_tilt=np.radians(tilt))
    assert 0.2 < run.missing.mean() < 0.7
    missing, pressed = run.findings
    assert f"of the letter has no ink, at its {bare}" in missing
    assert "mm over the paper. Plan again" in missing
    assert f"Pressed too hard, at its {hard}" in pressed
    assert "1.2 N are enough" in pressed


def test_the_advice_works():
    motion = written("l", "round", "table", 0.2)
    wrong = simulate(motion, page_tilt=np.radians(4), page_height_error=-0.004)
    assert wrong.findings
    again = teach.Fetch().write(motion.strokes, wrong.page)
    assert_written(simulate(again), 0.00005)


def test_a_page_that_is_higher_presses_by_the_springs_law():
    low, high = (simulate(written(), page_height_error=error) for error in (0.0, 0.003))
    difference = np.median(high.force[high.writing]) - np.median(low.force[low.writing])
    np.testing.assert_allclose(difference, 100.0 * 0.003, atol=0.005)


def test_a_rigid_pen_would_break():
    run = simulate(written(), pen="rigid")
    assert run.greatest_force > 100
    assert run.motion.joint_names == run.planned.joint_names
    sentence = run.findings[0]
    assert sentence.startswith(
        f"The pen would break: it is pushed with {run.greatest_force:.0f} N, and 10 N are enough"
    )
    assert sentence.endswith("use the pen with a spring.")


def test_real_motors_give_no_more_than_they_have_and_ideal_ones_what_is_needed():
    motion = written()
    q = np.array(motion.q)
    q[300:, 1] += 0.05  # in one step
    jerked = replace(motion, q=q)
    real, ideal = (simulate(jerked, motors=motors) for motors in ("real", "ideal"))
    np.testing.assert_allclose((np.abs(real.effort) / real.limits).max(), 1.0)
    assert (np.abs(ideal.effort) > ideal.limits).any()


def test_a_motor_that_gives_all_it_has_is_named():
    run = simulate(written(), motors="real")
    effort = np.array(run.effort)
    effort[:80, 4] = run.limits[4]
    share = f"{8000 / len(effort):.0f} %"
    assert replace(run, effort=effort).findings == (
        f"elbow_flex_joint gives all of 66 N m for {share} of the time; it has 66. "
        "Write more slowly, or move the page nearer to the robot.",
    )
    effort[:80, 4] *= 2
    assert f"needs up to 132 N m for {share} of the time" in replace(run, effort=effort).findings[0]


def test_ink_beside_the_letter_and_between_strokes_is_said():
    run = simulate(written("i", "slanted", "board", 0.10))
    beside = replace(run, nib=run.nib + np.array([0.004, 0, 0]))
    assert any("mm from the letter on average" in sentence for sentence in beside.findings)
    pressed_all_along = replace(run, contact=np.ones_like(run.contact))
    assert run.ink_in_the_air == 0 < pressed_all_along.ink_in_the_air
    assert any(
        "of ink lie between the strokes" in sentence for sentence in pressed_all_along.findings
    )


@pytest.mark.parametrize(
    ("spot", "words"),
    [
        ((0, 1), "at its top"),
        ((-1, 0), "on its left"),
        ((1, -1), "at its bottom and on its right"),
        ((0, 0), "in its middle"),
    ],
)
def test_a_part_of_a_letter_has_a_name(spot, words):
    letter = np.stack(np.meshgrid(np.linspace(-1, 1, 21), np.linspace(-1, 1, 21)), axis=-1).reshape(
        -1, 2
    )
    near = np.abs(letter - spot).max(axis=1) < 0.3
    assert describe_part(letter, near) == words
    assert describe_part(letter, np.ones(len(letter), bool)) == "all over it"


def test_distances_are_those_to_the_nearest_piece_of_the_letter():
    """A second route: the letter in pieces a hundred times as short."""
    motion = written()
    points = np.random.default_rng(0).uniform(-0.05, 0.05, (50, 2))
    letter = motion.page.to_page(motion.target[motion.pen_down])[:, :2]
    rows = np.linspace(0, len(letter) - 1, 100 * len(letter))
    fine = np.column_stack([np.interp(rows, np.arange(len(letter)), column) for column in letter.T])
    expected = np.linalg.norm(points[:, None] - fine, axis=2).min(axis=1)
    np.testing.assert_allclose(measure_distances(points, motion), expected, atol=2e-6)


def test_a_run_cannot_be_changed():
    run = simulate(short())
    for name in ("force", "contact", "nib", "effort", "limits"):
        with pytest.raises(ValueError, match="read-only"):
            getattr(run, name)[0] = 1
    assert isinstance(run.ink, tuple)


@pytest.mark.parametrize(
    ("settings", "words"),
    [
        ({"motors": "perfect"}, "motors is 'perfect', but must be one of: 'ideal', 'real'"),
        ({"pen": "fountain"}, "pen is 'fountain', but must be one of: 'sprung', 'rigid'"),
        ({"seed": -1}, "seed is -1, but must be a whole number, 0 or more"),
        ({"seed": 0.5}, "seed is 0.5"),
        (
            {"page_height_error": -6},
            r"page_height_error is -6 m, but must be between -0.1 and 0.1 m; .*millimetres",
        ),
        ({"page_tilt": 5}, r"page_tilt is 5 rad, but must be between -0.5 and 0.5 rad; .*degrees"),
        ({"page_tilt": float("nan")}, "page_tilt is nan"),
        ({"page_height_error": "low"}, "page_height_error is 'low'"),
    ],
)
def test_settings_that_cannot_be_are_refused(settings, words):
    with pytest.raises(SettingError, match=words):
        simulate(short(), **settings)


def test_only_a_motion_can_be_simulated():
    with pytest.raises(
        SettingError, match=r"motion is a tuple, but must be a Motion; Fetch\(\).write"
    ):
        simulate(written().strokes)
    motion = written()
    coarse = {name: getattr(motion, name)[::4] for name in ("t", "q", "tip", "target", "pen_down")}
    with pytest.raises(SettingError, match="at least 200 samples a second, evenly spaced"):
        simulate(replace(motion, **coarse))


@pytest.fixture
def clients(monkeypatch):
    """The numbers of all clients that were opened."""
    numbers, connect = [], pybullet.connect
    monkeypatch.setattr(
        pybullet, "connect", lambda *mode: numbers.append(connect(*mode)) or numbers[-1]
    )
    return numbers


def stop_at(fraction, error):
    def progress(step, part):
        assert step == "physics"
        if part >= fraction:
            raise error

    return progress


def test_an_interrupted_kernel_keeps_what_was_written(clients):
    whole = simulate(written())
    run = simulate(written(), progress=stop_at(0.5, KeyboardInterrupt()))
    assert run.stopped
    assert 0.45 * whole.duration < run.duration < 0.6 * whole.duration
    np.testing.assert_array_equal(run.force, whole.force[: len(run.force)])
    assert len(run.ink) == 1
    assert run.findings == (
        f"Stopped after {run.duration:.2f} s of {whole.duration:.2f} s; what was written "
        "until then is kept.",
    )
    assert "stopped" in repr(run)
    assert not any(pybullet.isConnected(number) for number in clients)


def test_progress_may_stop_the_simulation_and_the_error_keeps_what_was_written(clients):
    with pytest.raises(ZeroDivisionError) as caught:
        simulate(written(), progress=stop_at(0.5, ZeroDivisionError()))
    assert caught.value.run.stopped
    assert caught.value.run.contact.any()
    assert not any(pybullet.isConnected(number) for number in clients)


def test_stopped_before_anything_was_written_there_is_no_run(clients):
    for error in (KeyboardInterrupt, ZeroDivisionError):
        with pytest.raises(error) as caught:
            simulate(written(), progress=stop_at(0.0, error()))
        assert not hasattr(caught.value, "run")
    assert not any(pybullet.isConnected(number) for number in clients)


def test_progress_is_told_often_and_to_the_end():
    told = []
    run = simulate(written(), progress=lambda step, part: told.append(part))
    assert told == sorted(told)
    assert (told[0], told[-1]) == (0.0, 1.0)
    assert len(told) > 5 * run.duration


def memory():
    """What this process holds [bytes]."""
    return int(Path("/proc/self/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE")


@pytest.mark.skipif(
    not Path("/proc/self/statm").exists(), reason="only Linux says how much memory a process holds"
)
def test_many_runs_in_one_process_leak_nothing(clients):
    motion = short()
    simulate(motion)
    simulate(motion, motors="real")
    before = memory()
    for seed in range(40):
        simulate(motion)
        simulate(motion, motors="real", seed=seed)
    assert memory() - before < 10e6, "one client that stays open keeps 30 MB"
    assert len(clients) == 82
    assert not any(pybullet.isConnected(number) for number in clients)


def test_nothing_is_printed(capfd):
    simulate(short())
    simulate(short(), motors="real", pen="rigid")
    assert capfd.readouterr() == ("", "")


def test_without_pybullet_it_says_what_still_works(without_pybullet):
    motion = short()
    with pytest.raises(
        MissingPartError,
        match=r"need pybullet.*\.html\(path\) work without it.*pip install pybullet",
    ):
        simulate(motion)
    assert teach.Fetch().write(ink.LETTER, PAGES["table"]).duration > 0
