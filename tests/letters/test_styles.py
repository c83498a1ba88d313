"""Style as numbers: blends, principal styles and chance, all linear in what is drawn."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dmp_teach.dmp.settings import Settings
from dmp_teach.errors import LetterError, SettingError, TrajectoryError
from dmp_teach.ink.alphabet import recording_of
from dmp_teach.letters.letter import Letter
from dmp_teach.letters.styles import Style
from dmp_teach.letters.styles_basis import learn_alike
from dmp_teach.trajectory import Trajectory, all_points
from tests.recordings import RECORDINGS, needs_recordings

SHEARS = (-0.3, -0.1, 0.0, 0.25, 0.5)


def drawn(letter):
    """All that a letter draws, shape (Q, 2) [m]."""
    return all_points(letter.write())


def slanted(strokes, shear, size=1.0, tempo=1.0):
    """The same letter by a writer who leans, writes larger or slower, elsewhere on the page."""
    lean = np.array([[1, shear], [0, 1]])
    return tuple(
        Trajectory(tempo * s.t, size * s.position @ lean.T + (0.1 * shear, 0.05)) for s in strokes
    )


@pytest.fixture(scope="module")
def writers():
    strokes = recording_of("D").strokes()
    sizes = np.linspace(0.8, 1.3, len(SHEARS))
    return [slanted(strokes, shear, size, size) for shear, size in zip(SHEARS, sizes, strict=True)]


@pytest.fixture(scope="module")
def hands():
    return Style.of([recording_of("a", hand) for hand in ("round", "slanted")])


@pytest.fixture(scope="module")
def style(writers):
    return Style.of(writers)


def lean(letter):
    """How much the bar of a D leans."""
    path = letter.write()[0].position
    way = path[-1] - path[0]
    return way[0] / way[1]


@pytest.mark.parametrize(
    "preset", [Settings.star(), Settings.joint(), Settings.plus(), Settings.as_fixed()]
)
def test_the_mean_of_the_weights_draws_the_mean_of_the_letters(preset):
    style = Style.of([recording_of("m", hand) for hand in ("round", "slanted")], preset)
    mean = np.mean([drawn(letter) for letter in style.letters], axis=0)
    weights = np.mean([letter.primitives[0].weights for letter in style.letters], axis=0)
    assert np.allclose(style.mean.primitives[0].weights, weights, rtol=1e-10, atol=1e-15)
    assert np.abs(drawn(style.mean) - mean).max() < 1e-10 * np.abs(mean).max()


def test_learned_alike_a_letter_is_as_near_as_learned_alone():
    for letter, hand in zip(
        learn_alike(
            [Letter.learn(recording_of("D", hand)) for hand in ("round", "slanted")],
            same_size=False,
        ),
        ("round", "slanted"),
        strict=True,
    ):
        own = Letter.learn(recording_of("D", hand))
        assert letter.error < 5e-4
        again = [p.rollout(dt=p.duration / 100).position for p in letter.primitives]
        alone = [p.rollout(dt=p.duration / 100).position for p in own.primitives]
        moved = np.concatenate(again) - np.concatenate(alone)
        assert np.sqrt(((moved - moved.mean(axis=0)) ** 2).sum(axis=1).mean()) < 5e-4


@settings(deadline=None, max_examples=25)
@given(
    shares=st.lists(st.floats(-0.5, 1.5), min_size=5, max_size=5).filter(
        lambda s: abs(sum(s)) > 0.3
    )
)
def test_a_blend_draws_the_same_blend_of_the_letters(style, shares):
    shares = np.array(shares) / sum(shares)
    blend = style.blend(dict(zip(style.writers, shares, strict=True)))
    expected = np.tensordot(shares, [drawn(letter) for letter in style.letters], axes=1)
    assert np.abs(drawn(blend) - expected).max() < 1e-9
    assert all(
        before.t[-1] < after.t[0]
        for before, after in zip(blend.strokes, blend.strokes[1:], strict=False)
    )


def test_all_of_one_writer_is_that_writer(style):
    for writer, letter in zip(style.writers, style.letters, strict=True):
        same = style.blend({writer: 1})
        assert np.abs(drawn(same) - drawn(letter)).max() < 1e-9
        assert same.primitives[0].duration == pytest.approx(letter.primitives[0].duration)
        assert same.strokes[1].t[0] - same.strokes[0].t[-1] == pytest.approx(
            letter.strokes[1].t[0] - letter.strokes[0].t[-1]
        )


def test_a_morph_leads_evenly_from_one_writer_to_another(style):
    leans = [lean(style.morph("1", "5", part)) for part in np.linspace(0, 1, 6)]
    assert leans[0] == pytest.approx(lean(style.letters[0]), abs=1e-9)
    assert leans[-1] == pytest.approx(lean(style.letters[4]), abs=1e-9)
    assert (np.diff(leans) > 0).all()


def test_writers_who_differ_only_in_slant_have_one_principal_style(style):
    # slant, and a little because the middle of the box, by which letters are put together, does
    # not grow evenly with it
    assert style.shares[0] > 0.93
    assert style.shares[:2].sum() > 0.999
    ends = [lean(style.letter([z])) for z in (-1.5, 0, 1.5)]
    assert (np.diff(ends) > 0.05).all() or (np.diff(ends) < -0.05).all()


def test_size_is_taken_away_or_kept(writers):
    def heights(same_size):
        letters = Style.of(writers, same_size=same_size).letters
        return np.array([np.ptp(letter.strokes[0].position[:, 1]) for letter in letters])

    assert np.ptp(heights(True)) < 0.12 * heights(True).mean()
    assert heights(False)[-1] / heights(False)[0] == pytest.approx(1.3 / 0.8, rel=1e-3)


def test_a_letter_that_lies_flat_is_measured_by_its_width():
    t = np.linspace(0, 1, 60)
    dashes = [(Trajectory(t, np.column_stack([0.04 * t, rise * t])),) for rise in (0.0005, 0.002)]
    widths = [np.ptp(letter.strokes[0].position[:, 0]) for letter in Style.of(dashes).letters]
    assert widths == pytest.approx([0.04, 0.04], rel=0.01)


def test_coordinates_are_standard_deviations_and_lead_back_to_the_letters(style):
    z = style.coordinates
    assert np.allclose(z.mean(axis=0), 0, atol=1e-9)
    assert np.allclose(z.T @ z / (len(z) - 1), np.eye(z.shape[1]), atol=1e-9)
    assert (np.diff(style.spread) <= 0).all()
    assert style.shares.sum() == pytest.approx(1)
    for letter, place in zip(style.letters, z, strict=True):
        assert np.abs(drawn(style.letter(place)) - drawn(letter)).max() < 1e-9


def test_chance_is_the_callers_and_spreads_as_the_writers_do(style):
    one, same, other = (drawn(style.sample(np.random.default_rng(seed))) for seed in (1, 1, 2))
    assert np.array_equal(one, same)
    assert not np.array_equal(one, other)
    rng = np.random.default_rng(0)
    made = [lean(style.sample(rng)) for _ in range(200)]
    taught = [lean(letter) for letter in style.letters]
    assert np.mean(made) == pytest.approx(np.mean(taught), abs=0.08)
    assert np.std(made) == pytest.approx(np.std(taught, ddof=1), rel=0.2)


def test_a_style_that_is_led_through_a_point_passes_it(hands):
    place = drawn(hands.morph("writer-1", "writer-2", 0.8))
    clock = np.linspace(0, 1, len(place))
    point = [np.interp(0.4, clock, axis) for axis in place.T]
    led = hands.through(0, 0.4, point)
    for letter in (led.mean, *(led.sample(np.random.default_rng(seed)) for seed in range(5))):
        there = [np.interp(0.4, clock, axis) for axis in letter.strokes[0].position.T]
        assert np.linalg.norm(np.subtract(there, point)) < 0.002
    assert np.trace(led.covariance) < np.trace(hands.covariance)
    assert np.allclose(led.through(0, 0.4, point).centre, led.centre, atol=0.02), (
        "it is led there already"
    )


def test_order_and_direction_of_strokes_are_found_by_shape(writers):
    bar, bowl = recording_of("D").strokes()
    turned = Trajectory(bowl.t - bowl.t[0], bowl.position[::-1])
    other = (turned, Trajectory(bar.t + turned.t[-1] + 0.4, bar.position))
    style = Style.of([writers[2], other])
    assert np.abs(drawn(style.letters[0]) - drawn(style.letters[1])).max() < 0.02
    assert (
        np.linalg.norm(style.mean.strokes[1].position[0] - style.letters[0].strokes[1].position[0])
        < 0.01
    )


def test_a_made_letter_is_written_and_moved_like_any_other(style):
    strokes = style.mean.write(goal_shifts={1: (0.02, 0.03)})
    assert np.allclose(
        strokes[1].position[-1], style.mean.primitives[1].goal + np.array([0.02, 0.03]), atol=1e-3
    )
    assert style.mean.error < 1e-9


@needs_recordings
def test_the_mean_of_the_recorded_letters_lies_among_them():
    from dmp_teach.formats.read import read_recording  # noqa: PLC0415

    letters = [read_recording(path) for path in RECORDINGS if path.stem.startswith("a_")]
    style = Style.of(letters)
    paths = np.array([drawn(letter) for letter in style.letters])
    apart = np.linalg.norm(paths - drawn(style.mean), axis=2).mean(axis=1)
    between = np.linalg.norm(paths[:, None] - paths[None], axis=3).mean(axis=2)
    assert (apart < between.max(axis=1)).all()


@pytest.mark.parametrize(
    ("ask", "words"),
    [
        (
            lambda s: Style.of([]),
            "A style is what several letters share, but got 0; give at least 2.",
        ),
        (
            lambda s: Style.of([recording_of("D"), recording_of("D").strokes()[:1]]),
            "Letter 1 has 1 stroke and letter 0 has 2, and they are not the same parts. Blend "
            "letters that are made of the same strokes, in any order.",
        ),
        (
            lambda s: s.blend({"1": 0.5, "2": 0.6}),
            "The shares add up to 1.1, but must add up to 1, such as 0.7 and 0.3.",
        ),
        (
            lambda s: s.blend({"me": 1}),
            "There is no letter by 'me' in this style; there are: 1, 2, 3, 4, 5.",
        ),
        (
            lambda s: s.morph("1", "me", 0.5),
            "There is no letter by 'me' in this style; there are: 1, 2, 3, 4, 5.",
        ),
        (lambda s: s.letter([3.5]), "coordinates is [3.5], but each must be between -3 and 3."),
        (
            lambda s: s.letter(np.zeros((2, 2))),
            "coordinates has shape (2, 2), but there are 4 principal styles.",
        ),
        (
            lambda s: s.through(2, 0.5, (0, 0)),
            "stroke is 2, but strokes are numbered from 0 to 1.",
        ),
        (
            lambda s: s.through(0, "half", (0, 0)),
            "part is 'half', but must be a number between 0 and 1.",
        ),
        (
            lambda s: s.through(0, 0.5, (0, 0), near=0),
            "near is 0, but must be a number between 1e-06 and 1.",
        ),
        (
            lambda s: s.morph("1", "5", np.inf),
            "part is inf, but must be a number between -10 and 10.",
        ),
        (
            lambda s: s.letter("bold"),
            "coordinates is 'bold', but must be a number between -3 and 3.",
        ),
        (
            lambda s: s.blend({"1": "all"}),
            "The share of 1 is 'all', but must be a number between -10 and 10.",
        ),
        (
            lambda s: s.blend(["1"]),
            "shares is ['1'], but must be a dictionary, writer: share, such as {'w01': 1.0}.",
        ),
        (
            lambda s: s.sample(3),
            "rng is 3, but must be a generator, such as np.random.default_rng(1).",
        ),
        (
            lambda s: Style.of(3),
            "A style is learned from letters, but got 3; give a list of recordings.",
        ),
    ],
)
def test_what_cannot_be_is_answered(style, ask, words):
    with pytest.raises(LetterError) as error:
        ask(style)
    assert str(error.value) == words


def test_a_point_that_is_none_is_refused(style):
    with pytest.raises(
        TrajectoryError, match=r"^point is \[ ?0\. nan\], but it must be finite \[m\]\.$"
    ):
        style.through(0, 0.5, (0, np.nan))


def test_the_original_transformation_cannot_be_blended():
    with pytest.raises(SettingError, match="cannot be blended with transform='original'"):
        Style.of([recording_of("a"), recording_of("a", "slanted")], Settings.original())


def test_a_style_is_of_one_letter():
    with pytest.raises(
        LetterError, match="of one letter, but these are 'D', 'P'; give one character's"
    ):
        Style.of([recording_of("D"), recording_of("P")])
