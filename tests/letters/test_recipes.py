"""The table of recipes: every line makes its letter, of our letters and of everybody's."""

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dmp_teach.errors import LetterError
from dmp_teach.formats.read import read_recording
from dmp_teach.ink.alphabet import alphabets, characters, recording_of
from dmp_teach.letters.compose.recipes import letters_needed, make_letter, recipes
from dmp_teach.letters.compose.roles import strokes_in_role
from dmp_teach.letters.compose.shelf import Shelf
from dmp_teach.letters.letter import Letter
from dmp_teach.scoring.letter_score import score
from dmp_teach.studies.experiments.d_to_p import make_p_from_d
from dmp_teach.trajectory import Trajectory, rms
from tests.recordings import RECORDINGS, needs_recordings

FORMS = ("star", "similarity")


def distance(path, point):
    """How far a point (2,) is from the polyline through a path (T, 2) [m]."""
    a, along = path[:-1], np.diff(path, axis=0)
    part = ((point - a) * along).sum(axis=1) / np.maximum((along**2).sum(axis=1), 1e-18)
    return np.linalg.norm(a + np.clip(part, 0, 1)[:, None] * along - point, axis=1).min()


@pytest.fixture(scope="module")
def shelves():
    wanted = {letter for _, how in recipes() for letter in letters_needed(how)}
    return {
        name: Shelf.of(
            recording_of(letter, name) for letter in characters(name) if letter in wanted
        )
        for name in alphabets()
    }


@pytest.fixture(scope="module")
def everybody():
    shelf = Shelf.of(map(read_recording, RECORDINGS))
    return [shelf.by(writer) for writer in shelf.writers]


def makeable(shelf):
    """The letters for which there is a recipe whose letters are all on the shelf."""
    have = set(shelf.letters)
    return dict.fromkeys(made for made, how in recipes() if set(letters_needed(how)) <= have)


def box(strokes):
    points = np.concatenate([stroke.position for stroke in strokes])
    return points.min(axis=0), points.max(axis=0)


@pytest.mark.parametrize("transform", FORMS)
@pytest.mark.parametrize("alphabet", alphabets())
def test_every_line_of_the_table_makes_its_letter(shelves, alphabet, transform):
    """Of a letter's size and shape, and one stroke after the other."""
    shelf = shelves[alphabet]
    assert len({made for made, _ in recipes()}) >= 25
    for character, how in recipes():
        strokes = make_letter(character, shelf, transform, how).write()
        (left, low), (right, high) = box(strokes)
        below, above = box(
            [piece.drawn for letter in letters_needed(how) for piece in shelf[letter]]
        )
        tall = above[1] - below[1]
        assert 0.3 * tall < high - low < 2 * tall, (character, how)
        assert 0.1 < (right - left) / (high - low) < 2, (character, how)
        assert all(after.t[0] >= before.t[-1] for before, after in pairwise(strokes))


@pytest.mark.parametrize("alphabet", alphabets())
def test_made_letters_hang_together(shelves, alphabet):
    """Where the strokes of a letter touch by its recipe they touch in the ink."""
    shelf = shelves[alphabet]
    for character, how in recipes():
        if len(how.split(",")) < 2:
            continue
        strokes = make_letter(character, shelf, "similarity", how).write()
        size = np.ptp(np.concatenate([stroke.position for stroke in strokes]), axis=0).max()
        for number, stroke in enumerate(strokes):
            others = [other.position for k, other in enumerate(strokes) if k != number]
            gaps = [distance(other, p) for other in others for p in stroke.position[::3]]
            assert min(gaps) < 0.06 * size, (character, how, number)


@pytest.mark.parametrize("transform", FORMS)
@pytest.mark.parametrize("alphabet", alphabets())
def test_a_p_is_joined_in_the_middle_and_a_b_at_its_foot_too(shelves, alphabet, transform):
    (bar,) = strokes_in_role("bar", shelves[alphabet]["D"])
    middle, foot = bar.height(0.5), bar.at("bottom")
    p, b = (make_letter(character, shelves[alphabet], transform).write() for character in "PB")
    assert np.linalg.norm(p[1].position[-1] - middle) < 1e-4
    assert np.linalg.norm(b[2].position[0] - middle) < 1e-4
    assert np.linalg.norm(b[2].position[-1] - foot) < 0.01


def test_the_first_line_is_taken_that_can_be():
    lo = Shelf.of(recording_of(letter) for letter in "lo")
    assert {"b", "d", "p", "q"} <= set(makeable(lo))
    assert make_letter("b", lo).made_of == ("l.1b", "o.1")
    assert make_letter("b", Shelf.of(recording_of(letter) for letter in "loD")).made_of == (
        "D.1",
        "o.1",
    )


@pytest.mark.slow
@pytest.mark.parametrize("alphabet", alphabets())
def test_made_letters_are_written_in_the_order_and_direction_of_school(shelves, alphabet):
    for character, how in recipes():
        found = score(
            make_letter(character, shelves[alphabet], recipe=how), recording_of(character, alphabet)
        )
        assert not {"order", "reversed"} & {fault.name for fault in found.faults}, (
            character,
            how,
            found.sentence,
        )


def test_a_leg_that_is_led_at_both_ends_is_straight_unless_another_way_is_asked_for(shelves):
    """Turned and scaled; DMP* keeps the way of the bar, and adds to it."""
    shelf = shelves["round"]
    legs = [
        make_letter("R", shelf, transform).write()[2].position
        for transform in (None, "similarity", "star")
    ]
    ends = [
        np.linalg.norm(leg[-1] - leg[0]) / np.linalg.norm(np.diff(leg, axis=0), axis=1).sum()
        for leg in legs
    ]
    assert ends[0] == pytest.approx(ends[1], abs=1e-3)
    assert ends[0] > max(0.98, ends[2])


def test_what_leads_down_has_no_loop_and_no_hook(shelves):
    for alphabet in alphabets():
        (down,) = strokes_in_role("down", shelves[alphabet]["l"])
        path = down.drawn.position
        assert np.ptp(path[:, 1]) == pytest.approx(
            np.ptp(shelves[alphabet]["l"][0].shown.position[:, 1]), rel=0.02
        )
        assert (np.diff(path[:, 1]) <= 1e-4).all()


def test_a_stroke_that_is_written_back_has_the_same_ink(shelves):
    (piece,) = shelves["round"]["6"]
    back = piece.backwards()
    np.testing.assert_allclose(back.drawn.position[::-1], piece.drawn.position, atol=1e-3)


def test_parts_of_a_quick_letter_are_learned_as_finely_as_the_letter():
    for character in "nmh":
        (slow,) = recording_of(character).strokes()
        quick = Trajectory((slow.t - slow.t[0]) / 5, slow.position)
        (piece,) = Shelf.of({character: (quick,)})[character]
        size = np.ptp(quick.position, axis=0).max()
        for part in (*piece.cut(), piece.backwards()):
            assert rms(part.drawn.position - part.shown.position) < 0.02 * size, character


@pytest.mark.slow
def test_every_letter_has_a_top_and_a_bottom():
    for alphabet in alphabets():
        for character in characters(alphabet):
            for piece in Shelf.of([recording_of(character, alphabet)]):
                assert piece.height(1.0)[1] == pytest.approx(piece.at("top")[1])
                assert piece.height(0.0)[1] == pytest.approx(piece.at("bottom")[1])


def test_no_letter_is_made_of_no_name():
    with pytest.raises(
        LetterError, match="character is None, but must be the letter to make, such as 'P'"
    ):
        make_letter(None, Shelf.of([recording_of("D")]))


def test_last_is_the_order_of_writing_and_not_of_the_recipe(shelves):
    letter = make_letter(
        "p", shelves["round"], recipe="o all last, D bar put upper at 1:left/1:top meet 1:left"
    )
    assert letter.made_of == ("D.1", "o.1")


def test_a_line_of_ones_own_makes_a_letter():
    shelf = Shelf.of(recording_of(letter) for letter in "Do")
    letter = make_letter("p", shelf, recipe="D bar, o all size 0.5 slide left to 1")
    assert letter.made_of == ("D.1", "o.1")


@pytest.mark.parametrize(
    ("ask", "answer"),
    [
        (
            ("%", None),
            r"There is no recipe for '%'; there are recipes for P R B .*Give one: recipe='\.\.\.'",
        ),
        (("w", None), r"'w' is made of v, but this shelf has D, o: put the missing ones on it"),
        (("P", "D bar, D bowl bend"), r"A recipe cannot 'bend'; it can: lead END to SPOT"),
        (
            ("P", "D"),
            r"A stroke of a recipe is a letter and a role, such as 'D bar', but this is 'D'",
        ),
        (
            ("P", "D bar, D bowl lead lower to 3:0.5"),
            r"names stroke 3, but so far it has 1; they are counted from 1",
        ),
        (("P", "D all size 2"), r"'D' has 2 strokes, but 'size 2' is for one; name it by its role"),
        (("P", "D bar, D bowl put side at 1:top"), r"There is no place 'side'"),
        (("P", "D bar, D bowl put top at 1:side"), r"There is no place 'side'"),
        (("P", 3), r"recipe is 3, but must be a line of strokes, such as 'D bar, D bowl'"),
        (("P", "D nose"), r"There is no role 'nose'"),
    ],
)
def test_a_recipe_that_cannot_be_is_said_in_a_sentence(ask, answer):
    shelf = Shelf.of(recording_of(letter) for letter in "Do")
    with pytest.raises(LetterError, match=answer):
        make_letter(ask[0], shelf, recipe=ask[1])


def test_where_a_letter_cannot_be_taken_apart_the_next_recipe_is_tried():
    ring = Letter.learn(recording_of("o"))
    shelf = Shelf.of({"D": ring, "B": recording_of("B")})
    assert {name[0] for name in make_letter("P", shelf).made_of} == {"B"}
    with pytest.raises(LetterError, match=r"This D, .* has no 'bar'"):
        make_letter("P", Shelf.of({"D": ring}))


def test_a_letter_is_made_from_a_shelf():
    with pytest.raises(
        LetterError,
        match=r"A letter is made from a Shelf, but got a dict; use Shelf\.of\(recordings\)",
    ):
        make_letter("P", {})


@pytest.mark.slow
@needs_recordings
@pytest.mark.parametrize("transform", FORMS)
def test_everybodys_strokes_make_every_letter_that_they_can(everybody, transform):
    count = 0
    for shelf in everybody:
        for character in makeable(shelf):
            (left, low), (right, high) = box(make_letter(character, shelf, transform).write())
            assert 0.2 < (right - left) / (high - low) < 1.8, (shelf, character)
            count += 1
    assert count >= 21


@needs_recordings
def test_every_writers_d_makes_a_p_of_that_writer_however_it_was_drawn():
    of_d = [read_recording(path) for path in RECORDINGS if path.name.startswith("D")]
    found = make_p_from_d(of_d)
    assert len(found.by("DMP*")) == len(of_d)
    assert all(item.recognisable for way in ("DMP*", "similarity") for item in found.by(way))
    for recording in of_d:
        bar, bowl = make_letter("P", Shelf.of([recording])).write()
        assert min(distance(bar.position, end) for end in bowl.position[[0, -1]]) < 1e-4


@settings(max_examples=25, deadline=None)
@given(
    st.sampled_from(alphabets()),
    st.tuples(st.floats(-0.5, 0.5), st.floats(0.6, 1.6), st.floats(0.2, 5)),
    st.tuples(st.booleans(), st.booleans(), st.booleans()),
    st.sampled_from(FORMS),
)
def test_any_d_makes_a_p(name, form, ways, transform):
    """Slanted, narrow, large, in any order and direction: the bowl meets the bar half way up."""
    strokes = [
        _drawn(stroke, form, up)
        for stroke, up in zip(recording_of("D", name).strokes(), ways[:2], strict=True)
    ]
    strokes = strokes[::-1] if ways[2] else strokes
    late = Trajectory(strokes[1].t + strokes[0].t[-1] + 0.4, strokes[1].position)
    p = make_letter("P", Shelf.of({"D": Letter.learn([strokes[0], late])}), transform)
    stem, bow = p.write()
    low, high = np.sort(stem.position[[0, -1], 1])
    lower = min(bow.position[[0, -1]], key=lambda end: end[1])
    assert distance(stem.position, lower) < 1e-4
    assert abs(lower[1] - (low + high) / 2) < 0.05 * (high - low)


def _drawn(stroke, form, up):
    """A stroke from 0 s on, slanted, widened, scaled, and drawn upwards or downwards."""
    slant, wide, size = form
    path = size * stroke.position @ np.array([[wide, 0], [slant, 1]])
    rises = path[-1, 1] > path[0, 1]
    return Trajectory(stroke.t - stroke.t[0], path if rises == up else path[::-1])


def test_the_old_name_warns_and_makes_the_same_letter():
    shelf = Shelf.of([recording_of("D")])
    with pytest.warns(DeprecationWarning, match=r"Letter\.make is now called dmp_teach\.make_lett"):
        old = Letter.make("P", shelf)
    for one, other in zip(old.write(), make_letter("P", shelf).write(), strict=True):
        np.testing.assert_array_equal(one.position, other.position)
