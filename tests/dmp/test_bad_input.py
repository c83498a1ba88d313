"""Whatever is wrong is said in a sentence: what it is, what it must be, what to do next."""

import math
import re
from dataclasses import replace

import numpy as np
import pytest

from dmp_teach.dmp.integrators import INTEGRATORS, Spring, least_steps, most_alpha
from dmp_teach.dmp.kernels import KERNELS
from dmp_teach.dmp.phases import PHASES
from dmp_teach.dmp.primitive import DMP
from dmp_teach.dmp.settings import Settings
from dmp_teach.dmp.stepper import Stepper
from dmp_teach.errors import SettingError, SettingWarning, TrajectoryError
from dmp_teach.trajectory import Trajectory
from tests.dmp.ink import letter

PHASE_NAMES = ", ".join(map(repr, PHASES)) + "."
T = np.linspace(0, 1, 60)
CLOSED = np.column_stack([np.sin(2 * np.pi * T), 1 - np.cos(2 * np.pi * T)])


def closed(path):
    path = path.copy()
    path[-1] = path[0]
    return Trajectory(T, path)


@pytest.mark.parametrize(
    ("settings", "words"),
    [
        (
            {"kernel": "mollifier", "kernel_width": math.inf},
            "kernel is 'mollifier' and kernel_width is inf, but a mollifier falls to 0 at its "
            "ends and must have some: "
            "give kernel_width a number, 2 for instance.",
        ),
        (
            {"kernel": "mollifier", "kernel_sigma": 0.65},
            "kernel is 'mollifier' and kernel_sigma is 0.65, but a mollifier has no sigma, its "
            "width alone shapes it: "
            "give kernel_sigma=math.inf.",
        ),
        (
            {"kernel_sides": "one", "kernel_width": math.inf},
            "kernel_sides is 'one', but this gaussian of kernel_width inf cannot be left open on "
            "one side: "
            "give kernel='gaussian' and kernel_width a number, or kernel_sides='both'.",
        ),
        (
            {"kernel_sides": "one", "kernel": "mollifier", "kernel_width": 2.0},
            "kernel_sides is 'one', but this mollifier of kernel_width 2 cannot be left open on "
            "one side: "
            "give kernel='gaussian' and kernel_width a number, or kernel_sides='both'.",
        ),
        (
            {"alpha": 5000.0, "damping": 0.2},
            "alpha is 5000 and damping 0.2, but no step of ours can follow so stiff a spring "
            "that swings so much: "
            "use an alpha of at most 2000, or a damping nearer to 1.",
        ),
        ({"alpha": 20_000.0}, "alpha is 20000.0, but it must be between 1 and 10000."),
        ({"damping": 0.0}, "damping is 0.0, but it must be between 0.1 and 2."),
        (
            {"phase": "cosine"},
            "phase is 'cosine', but it must be one of: " + PHASE_NAMES,
        ),
        (
            {"transform": "plus"},
            "transform is 'plus', but it must be one of: 'star', 'original', 'similarity'.",
        ),
        (
            {"kernel": "box"},
            f"kernel is 'box', but it must be one of: {', '.join(map(repr, KERNELS))}.",
        ),
        (
            {"phase": ["linear"]},
            "phase is ['linear'], but it must be one of: " + PHASE_NAMES,
        ),
        ({"fit": {}}, "fit is {}, but it must be one of: 'lwr', 'bias', 'joint'."),
        ({"n_kernels": 0}, "n_kernels is 0, but it must be a whole number between 1 and 3000."),
    ],
)
def test_settings_that_do_not_go_together_are_refused_by_name_with_the_cure(settings, words):
    with pytest.raises(SettingError, match=f"^{re.escape(words)}$"):
        Settings.star(**settings)


@pytest.mark.parametrize("integrator", ["explicit", "semi-implicit", "lagged", "exact"])
@pytest.mark.parametrize("damping", [0.1, 0.35, 1.0, 2.0])
def test_the_largest_stiffness_that_is_named_works(integrator, damping):
    largest = min(10_000.0, math.floor(most_alpha(damping)))
    settings = Settings.star(alpha=largest, damping=damping, integrator=integrator, n_kernels=3)
    assert settings.alpha == largest
    alpha = min(largest, 200.0)
    drawn = DMP.imitate(
        letter(60, 1.0), Settings.star(alpha=alpha, damping=damping, integrator=integrator)
    ).rollout()
    assert np.abs(drawn.position - letter(60, 1.0).position).max() < 0.2
    spring = Spring(
        largest, math.ceil(least_steps(largest, damping)), INTEGRATORS[integrator](), damping
    )
    assert np.isfinite(spring.kick()).all()


def test_a_stiffness_that_nobody_chose_is_never_too_stiff():
    """No default is refused, however many kernels and however long the movement."""
    many = Settings.star(n_kernels=3000, alpha_per_kernel=6.0).resolved(100.0, 5000)
    assert many.alpha == 10_000
    assert Settings.as_coded().resolved(0.05, 20).alpha == 1
    assert Settings.as_coded(damping=0.1).resolved(3000.0, 20_000).alpha == pytest.approx(500)


@pytest.mark.parametrize(
    ("t", "position", "words"),
    [
        ([0.0], [[1.0, 2.0]], "A trajectory needs at least 2 samples, but has 1."),
        (
            [0, 1, 1, 2],
            np.zeros((4, 2)),
            "t[2] is 1.0 s and does not come after t[1] = 1.0 s; times must increase.",
        ),
        (
            [0, 2, 1],
            np.zeros((3, 1)),
            "t[2] is 1.0 s and does not come after t[1] = 2.0 s; times must increase.",
        ),
        (
            [0, 1],
            [[0, 0], [math.nan, 1]],
            "position[1] is [nan  1.], but must be finite; fill or cut the gap first.",
        ),
        ([0, math.inf], [[0], [1]], "t[1] is inf, but must be finite; fill or cut the gap first."),
        (
            [0, 1, 2],
            np.zeros((2, 2)),
            "t has shape (3,) and position (2, 2), but they must be (T,) and (T, D)",
        ),
        ("ab", [[0], [1]], "t must be numbers in an array, but: 'ab' is not made of numbers."),
    ],
)
def test_what_is_no_movement_is_never_a_trajectory(t, position, words):
    with pytest.raises(TrajectoryError, match=re.escape(words)):
        Trajectory(t, position)


@pytest.mark.parametrize(("axis", "name"), [(0, "x"), (1, "y"), (2, "z"), (3, "3")])
def test_the_original_names_the_one_coordinate_that_ends_where_it_began(axis, name):
    path = np.outer(T, [1.0, 2.0, 3.0, 4.0])
    path[:, axis] = np.sin(np.pi * T)
    path[-1, axis] = path[0, axis]
    words = f"start and goal are equal in coordinate {axis} ({name}). Settings.star() can."
    with pytest.raises(SettingError, match=re.escape(words)):
        DMP.imitate(Trajectory(T, path), Settings.original())
    assert np.isfinite(
        DMP.imitate(Trajectory(T, path), Settings.star(transform="similarity")).rollout().position
    ).all()


@pytest.mark.parametrize("path", [CLOSED, CLOSED[:, :1], np.column_stack([CLOSED, T * (1 - T)])])
def test_a_similarity_refuses_a_closed_stroke_and_names_dmp_star(path):
    words = (
        "transform is 'similarity', but this stroke is closed: its goal is its start, and no "
        "turn or scale carries "
        "one point elsewhere. DMP* can learn it: transform='star'."
    )
    with pytest.raises(SettingError, match=f"^{re.escape(words)}$"):
        DMP.imitate(closed(path), Settings.star(transform="similarity"))
    assert np.isfinite(DMP.imitate(closed(path)).rollout().position).all()


def test_a_closed_stroke_learned_as_dmp_star_is_not_led_by_a_similarity():
    """Its weights are the same: a stroke from a shelf changes its transformation unlearned."""
    star = DMP.imitate(closed(CLOSED))
    turned = replace(star, settings=replace(star.settings, transform="similarity"))
    np.testing.assert_allclose(turned.rollout().position, star.rollout().position, atol=1e-12)
    for draw in (turned.rollout, lambda goal: Stepper.begin(turned, goal=goal)):
        with pytest.raises(SettingError, match="this stroke is closed: its goal is its start"):
            draw(goal=star.goal + 0.01)


def test_a_similarity_refuses_to_end_at_its_start_and_names_dmp_star():
    p = DMP.imitate(letter(), Settings.star(transform="similarity"))
    words = (
        "The goal is the start, but transform 'similarity' would shrink the whole letter to that "
        "point: ask for "
        "another goal, or learn it as DMP*, transform='star'."
    )
    for asked in (
        {"goal": p.start},
        {"start": p.goal},
        {"start": (0, 0), "goal": (0, 0), "dt": 0.001},
    ):
        with pytest.raises(TrajectoryError, match=f"^{re.escape(words)}$"):
            p.rollout(**asked)


@pytest.mark.parametrize(
    ("settings", "words"),
    [
        (
            {"n_kernels": 2, "kernel_width": 0.5},
            r"Kernels leave gaps: f is 0 in 49\.8 % of the movement, at 0\.000 to 0\.251 s, "
            r"0\.753 to 1\.255 s, "
            r"1\.757 to 2\.000 s from its start\. A kernel_width of 1 or more closes them\.",
        ),
        (
            {"n_kernels": 10, "kernel_width": 0.5},
            r"Kernels leave gaps: .*, at 0\.000 to 0\.05. s, .*, .* and 8 more times from its "
            r"start\. A kernel_width",
        ),
        (
            {"kernel": "mollifier", "n_kernels": 4},
            r"Kernels leave gaps: .* A mollifier is 0 at its ends: give it a kernel_width over "
            r"1, 2 for instance\.",
        ),
        (
            {"kernel_centers": "ends", "n_kernels": 3},
            r"Kernels leave gaps: .* kernel_centers='middles' closes them\.",
        ),
    ],
)
def test_gaps_between_kernels_are_said_with_their_times_and_their_cure(settings, words):
    demo = letter(240, 2.0)
    with pytest.warns(SettingWarning, match=words):
        p = DMP.imitate(demo, Settings.star(**settings))
    assert re.search(words, p.notes[-1])
    assert np.isfinite(p.rollout().position).all()


def test_where_the_note_says_that_f_is_nought_it_is_nought():
    demo = letter(240, 2.0)
    with pytest.warns(SettingWarning):
        p = DMP.imitate(demo, Settings.star(n_kernels=2, kernel_width=0.5))
    first, second = (
        (float(a), float(b)) for a, b in re.findall(r"([\d.]+) to ([\d.]+) s", p.notes[-1])[:2]
    )
    left = 1 - np.arange(p.steps) / p.steps
    awake = p.kernels.over(left).blend(np.ones((2, 1)))[:, 0]
    t = 2.0 * np.arange(p.steps) / p.steps
    inside = ((t > first[0] + 1e-2) & (t < first[1] - 1e-2)) | (
        (t > second[0] + 1e-2) & (t < second[1] - 1e-2)
    )
    assert not awake[inside].any()
    assert awake[(t > first[1] + 1e-2) & (t < second[0] - 1e-2)].all()
