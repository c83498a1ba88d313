"""How near a writing is to its model: the sentence names the fault that is there."""

import re
from itertools import product

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dmp_teach import Letter, recording_of, score
from dmp_teach.errors import LetterError
from dmp_teach.formats.read import read_recording
from dmp_teach.ink.alphabet import alphabets, characters, signs
from dmp_teach.scoring.faults import DIFFERENCE_STEPS, FAULT_STEPS
from dmp_teach.scoring.matching import match_strokes
from dmp_teach.scoring.wording import word_difference
from dmp_teach.trajectory import Trajectory
from tests.laws import for_every
from tests.recordings import RECORDINGS, needs_recordings
from tests.scoring import faulty

HANDS = pytest.mark.parametrize("alphabet", alphabets()[:2])
GROWING = {
    "shape": (faulty.bent, (0.0, 0.02, 0.04, 0.07, 0.1), lambda found: found.shape, "aBgkz28"),
    "larger": (faulty.scaled, (1.0, 1.25, 1.6, 2.0, 3.0), lambda found: found.size, "aDgil0"),
    "smaller": (faulty.scaled, (1.0, 0.8, 0.6, 0.4, 0.2), lambda found: -found.size, "aDgil0"),
    "right": (faulty.leaned, (0.0, 6.0, 12.0, 20.0, 30.0), lambda found: found.lean, "aDbktM4"),
    "left": (faulty.leaned, (0.0, -6.0, -12.0, -20.0, -30.0), lambda found: -found.lean, "aDbktM4"),
    "turned": (
        faulty.turned,
        (0.0, 8.0, 16.0, 25.0, 35.0),
        lambda found: found.turn - found.lean,
        "aDbktEM",
    ),
    "wider": (faulty.widened, (1.0, 1.3, 1.6, 2.0, 2.5), lambda found: found.width, "aDbkxM8"),
    "shaky": (
        faulty.shaken,
        (0.0, 0.005, 0.01, 0.02, 0.03),
        lambda found: -found.written.smoothness,
        "aDbkM8",
    ),
}
WORDS = {
    "shape": r"^The shape.* is (a little |quite )?different, most of all (at|in|on) ",
    "larger": r"^It is .*(large as|larger than) the model\.$",
    "smaller": r"^It is .*(large as|smaller than) the model\.$",
    "right": r"^It leans \d+ degrees to the right\.$",
    "left": r"^It leans \d+ degrees to the left\.$",
    "turned": r"^It is (a little )?turned to the left, by \d+ degrees\.$",
    "wider": r"^It is (a little|much) wider than the model, for its height\.$",
    "shaky": r"^The (pen speeds up and slows down \d+ times|line is shakier)",
}


def strokes(character, alphabet=None):
    return list(recording_of(character, alphabet).strokes())


@pytest.mark.slow
@HANDS
@pytest.mark.parametrize("fault", GROWING)
def test_a_growing_fault_grows_in_its_measure_and_is_named(fault, alphabet):
    spoil, amounts, measure, characters = GROWING[fault]
    for character in characters:
        model = strokes(character, alphabet)
        found = [score(spoil(model, amount), model) for amount in amounts]
        assert (np.diff([measure(each) for each in found]) > 0).all(), character
        for each in found[
            3 if fault == "shaky" else 2 :
        ]:  # a tremble as thin as the line of a pen is not seen
            assert re.search(WORDS[fault], each.sentence), (character, each.sentence)


FAULTS_OF_ONE_STROKE = [
    (faulty.swapped, "order", r"^The second stroke was written before the first\."),
    (lambda given: faulty.without(given, 1), "missing", r"^The second stroke is missing\."),
    (lambda given: faulty.without(given, 0), "missing", r"^The first stroke is missing\."),
    (
        lambda given: faulty.backwards(given, 1),
        "reversed",
        r"^The second stroke starts at the wrong end\.",
    ),
    (faulty.with_one_more, "extra", r"^There is one stroke too many\."),
    (
        lambda given: faulty.moved(given, 1, (0.2, 0)),
        "place",
        r" stroke is \d+ mm too far to the (left|right)\.",
    ),
    (
        lambda given: faulty.moved(given, 1, (0, 0.2)),
        "place",
        r" stroke is \d+ mm too (high|low)\.",
    ),
]


@pytest.mark.slow
@for_every(product(FAULTS_OF_ONE_STROKE, "DBPRxt457", alphabets()[:2]))
def test_a_fault_of_one_stroke_is_named(fault, character, alphabet):
    spoil, name, words = fault
    model = strokes(character, alphabet)
    found = score(spoil(model), model)
    assert found.faults[0].name == name, found.sentence
    assert re.search(words, found.sentence), found.sentence


@pytest.mark.slow
@for_every(product("abdegPRz2457"))
def test_a_mirrored_letter_and_one_on_its_head_are_named(character):
    model = strokes(character)
    assert score(faulty.mirrored(model), model).sentence == "It is the mirror image of the model."
    assert score(faulty.turned(model, 180), model).sentence in (
        "It stands on its head.",
        "It looks the same as the model.",  # z
        "It starts at the wrong end.",
    )
    assert score(faulty.turned(model, 90), model).sentence == "It lies on its side."


def test_a_letter_that_is_nearly_its_own_mirror_image_is_told_by_its_movement():
    for character in "oOvV0":
        model = strokes(character)
        assert score(faulty.mirrored(model), model).faults[0].name == "reversed"


@HANDS
@pytest.mark.parametrize("character", list("ij"))
def test_a_dot_that_was_forgotten_is_missing_and_a_line_does_not_do_its_work(character, alphabet):
    model = strokes(character, alphabet)
    assert score(faulty.without(model, 1), model).sentence == "The second stroke is missing."
    assert score(faulty.without(model, 0), model).sentence == "The first stroke is missing."
    assert score(model, faulty.without(model, 1)).sentence == "There is one stroke too many."


def test_strokes_that_are_divided_at_another_corner_are_told():
    model = strokes("M")  # a stem, then all the rest: mirrored, the stem is the other one
    found = score(faulty.mirrored(model), model)
    assert found.sentence == "Its strokes begin and end at other places than the model's."
    assert found.parts[0].word == "the same"


def test_strokes_in_one_are_told_and_the_shape_is_still_the_same():
    model = strokes("D")
    found = score(faulty.in_one(model), model)
    assert found.sentence == "It is written in one stroke; the model takes two."
    assert [part.word for part in found.parts[:3]] == ["the same"] * 3
    assert (found.parts[3].word, found.parts[3].reason) == ("not far", "joined")
    found = score(model, faulty.in_one(model))
    assert found.sentence == "It is written in two strokes; the model takes one."


@for_every(product("aDMxigk07", alphabets()[:2]))
def test_a_letter_is_the_same_as_itself_wherever_it_was_written(character, alphabet):
    model = strokes(character, alphabet)
    found = score([Trajectory(s.t + 3, s.position - [0.4, 0.1]) for s in model], model)
    assert found.sentence == "It looks the same as the model."
    assert [(part.name, part.level, part.word, part.reason) for part in found.parts] == [
        (name, 3, "the same", "") for name in ("Shape", "Size", "Lean", "Way of writing")
    ]
    assert found.distance == pytest.approx(0, abs=1e-6)
    assert found.size == pytest.approx(1)


PIECES = {
    "l": (0, "goal", 0.2, r"^A piece is missing at the bottom"),
    "e": (0, "goal", 0.15, r"^A piece is missing at the bottom right\.$"),
    "c": (0, "goal", 0.25, r"^A piece is missing at the bottom right\.$"),
    "a": (0, "start", 0.15, r"^A piece is missing at the top"),
    "t": (0, "goal", 0.35, r"^A piece of the first stroke is missing at the bottom"),
    "D": (1, "goal", 0.15, r"^A piece of the second stroke is missing at the bottom left\.$"),
    "P": (1, "goal", 0.25, r"^A piece of the second stroke is missing on the left\.$"),
    "A": (2, "goal", 0.5, r"^A piece of the third stroke is missing on the right\.$"),
    "h": (0, "start", 0.2, r"^A (small )?piece is missing at the top left\.$"),
}


@for_every(product(PIECES))
def test_a_piece_that_is_missing_is_named_and_makes_no_letter_narrow_or_turned(character):
    number, end, part, words = PIECES[character]
    model = strokes(character)
    found = score(faulty.shortened(model, number, end, part), model)
    assert re.search(words, found.sentence), found.sentence
    assert abs(found.size - 1) < 0.1
    assert abs(found.width - 1) < 0.12
    assert abs(found.lean) < 5
    assert abs(found.turn) < 4
    assert [part.word for part in found.parts[1:]] == ["the same"] * 3


@pytest.mark.parametrize(
    ("character", "number", "words"),
    [
        ("D", 0, r"^The first stroke is (a little )?too long at the bottom left\.$"),
        ("E", 2, r"^The third stroke is (a little )?too long on the right\.$"),
    ],
)
def test_a_stroke_that_goes_on_too_far_is_named(character, number, words):
    model = strokes(character)
    found = score(faulty.lengthened(model, number, 0.5 if character == "E" else 0.3), model)
    assert re.search(words, found.sentence), found.sentence


@pytest.mark.parametrize("character", list("oO0"))
def test_a_ring_with_a_gap_is_not_closed(character):
    model = strokes(character)
    found = [score(faulty.shortened(model, 0, "goal", part), model) for part in (0.01, 0.09)]
    assert found[0].sentence == "It looks the same as the model."
    assert re.search(r"^It is not (quite )?closed at the top", found[1].sentence), found[1].sentence


@HANDS
def test_a_stroke_of_another_size_lies_where_it_should(alphabet):
    """Its middle does not, but it begins where the model's begins."""
    model = strokes("D", alphabet)
    for factor in (0.75, 1.3):
        found = score(faulty.with_size(model, 1, factor), model)
        assert found.place < 0.02, found.sentence


def test_of_the_movement_nobody_speaks_while_the_ink_shows_a_fault():
    model = strokes("k")
    halting = [
        Trajectory(
            s.t,
            np.column_stack(
                [np.interp(s.t + 0.03 * np.sin(30 * s.t), s.t, x) for x in s.position.T]
            ),
        )
        for s in model
    ]
    found = score(halting, model)
    assert found.sentence.startswith("The pen speeds up and slows down ")
    assert [part.word for part in found.parts] == ["the same"] * 4
    leaning = score(faulty.leaned(halting, 12), model)
    assert leaning.sentence.startswith("It leans 1")
    assert next(fault for fault in leaning.faults if fault.name == "smooth").steps > 2


def test_rows_get_worse_by_words():
    model = strokes("a")
    sizes = [
        score(faulty.scaled(model, factor), model).parts[1] for factor in (1.05, 1.3, 2.0, 4.0)
    ]
    assert [(part.level, part.word) for part in sizes] == [
        (3, "the same"),
        (2, "close"),
        (1, "not far"),
        (0, "far"),
    ]
    assert [part.reason for part in sizes] == [
        "",
        "a little larger",
        "twice as large",
        "four times as large",
    ]


@pytest.mark.parametrize(
    ("factor", "words"),
    [
        (0.5, "half as large as"),
        (1 / 3, "a third as large as"),
        (3.0, "three times as large as"),
        (1.2, "a little larger than"),
        (0.58, "42 percent smaller than"),
        (2.4, "more than twice as large as"),
        (3.4, "more than three times as large as"),
        (0.43, "less than half as large as"),
        (0.2, "less than a quarter as large as"),
        (7.0, "7 times as large as"),
    ],
)
def test_a_size_is_told_as_people_say_it(factor, words):
    model = strokes("D")
    assert score(faulty.scaled(model, factor), model).sentence == f"It is {words} the model."


def test_a_letter_that_was_learned_is_scored_as_it_writes():
    recording = recording_of("a")
    learned = Letter.learn(recording)
    assert score(learned, recording).sentence == "It looks the same as the model."
    assert score(recording, learned).shape < DIFFERENCE_STEPS["shape"]


def test_no_sentence_shouts_and_no_fault_is_without_words():
    model = strokes("R")
    found = score(faulty.leaned(faulty.bent(faulty.without(model, 1), 0.05), 20), model)
    assert len({fault.name for fault in found.faults}) == len(found.faults)
    for fault in found.faults:
        assert fault.name in {
            *DIFFERENCE_STEPS,
            *FAULT_STEPS,
            "joined",
            "split",
            "divided",
            "begins",
        }
        assert re.fullmatch(r"[A-Z][^!]*\.", fault.sentence)
        assert fault.reason
        assert re.fullmatch(r"[A-Z][^!.]*\.", fault.advice.format(model="it", models="its"))


ADVICE = [
    (lambda model: faulty.scaled(model, 1.6), "Write it smaller."),
    (lambda model: faulty.scaled(model, 0.6), "Write it larger."),
    (lambda model: faulty.leaned(model, 18), "Let it lean less to the right."),
    (lambda model: faulty.leaned(model, -18), "Let it lean less to the left."),
    (lambda model: faulty.widened(model, 1.7), "Write it narrower."),
    (lambda model: faulty.widened(model, 0.6), "Write it wider."),
    (lambda model: faulty.turned(model, 25), "Turn it back to the right."),
    (lambda model: faulty.turned(model, -25), "Turn it back to the left."),
]


@for_every(product(range(len(ADVICE)), "aDbkM4"))
def test_what_is_advised_undoes_what_was_done(number, character):
    spoil, advice = ADVICE[number]
    model = strokes(character)
    assert score(spoil(model), model).faults[0].advice == advice


@pytest.mark.parametrize("hand", ["both", None, 1])
def test_a_hand_is_left_or_right(hand):
    with pytest.raises(LetterError, match=r"hand is .* but must be 'right' or 'left'"):
        score(strokes("t"), strokes("t"), hand=hand)


@for_every(product("tfAEFHT", alphabets()))
def test_only_a_left_hand_may_pull_bars_to_the_left_and_nothing_else_backwards(character, alphabet):
    model = strokes(character, alphabet)
    across = [np.abs(s.position[-1] - s.position[0]) @ [1, -2] > 0 for s in model]
    for number, is_bar in enumerate(across):
        written = faulty.backwards(model, number)
        names = [fault.name for fault in score(written, model, hand="left").faults]
        assert ("reversed" in names) is not is_bar, number
        assert "reversed" in [fault.name for fault in score(written, model).faults], number


def test_another_letter_is_far_but_is_scored():
    found = score(strokes("M"), strokes("o"))
    assert found.parts[0].level == 0
    assert np.isfinite([found.distance, found.size, found.lean]).all()


def coarse(numbers):
    return st.lists(st.tuples(numbers, numbers), min_size=2, max_size=9)


@settings(max_examples=25, deadline=None)
@given(
    written=st.lists(coarse(st.integers(-9, 9)), min_size=1, max_size=5),
    character=st.sampled_from("aDiE8"),
)
def test_any_scribble_gets_a_score(written, character):
    scribble = [Trajectory(np.arange(len(each)) * 0.01, np.array(each) * 0.01) for each in written]
    if not any(np.ptp(each.position, axis=0).any() for each in scribble):
        return
    found = score(scribble, strokes(character))
    assert found.sentence.endswith(".")
    measures = (found.distance, found.shape, found.place, found.size, *found.shift)
    assert np.isfinite([*measures, found.width, found.lean, found.turn, found.rise]).all()
    assert sorted(
        [k for pair in found.matching.pairs for k in pair.strokes] + list(found.matching.extra)
    ) == list(range(len(scribble)))


@pytest.mark.slow
@needs_recordings
def test_the_hands_of_other_writers_are_close_in_shape():
    for letter in "aD":
        writings = [
            read_recording(path) for path in RECORDINGS if path.stem.startswith(f"{letter}_")
        ]
        for written in writings:
            found = [score(written, model) for model in writings[::2]]
            assert all(each.parts[0].level >= 1 for each in found), written
            assert not any(each.matching.mirrored or each.matching.turn for each in found)


@pytest.mark.parametrize(
    ("written", "words"),
    [
        ([], "written must be a Recording, a Letter or its strokes .* but is nothing"),
        ("a", "but is a str"),
        (Trajectory([0, 1], np.zeros((2, 2))), "written is a dot: the pen never moves"),
        (Trajectory([0, 1], np.ones((2, 3))), "Stroke 0 of written has 3 dimensions"),
        (Trajectory([0, 1], [[0, 0], [1e300, 0]]), "Stroke 0 of written reaches to 1e\\+300"),
    ],
)
def test_what_is_no_writing_has_no_score(written, words):
    with pytest.raises(LetterError, match=words):
        score(written, strokes("a"))
    with pytest.raises(LetterError, match=words.replace("written", "model")):
        score(strokes("a"), written)


@pytest.mark.parametrize("end", [(0.06, 0.06), (0.06, 0.0), (-0.03, 0.08)])
def test_a_line_where_a_round_letter_should_be_is_another_shape_and_no_small_letter(end):
    t = np.linspace(0, 2, 120)
    found = score((Trajectory(t, np.outer(t / 2, end)),), strokes("a"))
    assert found.sentence.startswith("The shape is quite different")
    assert found.parts[0].word == "far"
    assert 0.4 < found.size < 1.5


def left_out(alphabet):
    """Every letter and sign of several strokes without each of its strokes that may go."""
    for character in [*characters(alphabet), *signs()]:
        model = strokes(character, alphabet)
        for number in range(len(model) if len(model) > 1 else 0):
            written = faulty.without(model, number)
            if any(np.ptp(stroke.position, axis=0).max() > 0 for stroke in written):
                yield match_strokes(written, model).missing


@pytest.mark.slow
def test_a_stroke_that_was_left_out_is_missing_also_an_accent():
    """But for capitals of the slanted hand, whose accents stand close and along their letter."""
    for alphabet, unseen in zip(alphabets(), (1, 6), strict=True):
        found = list(left_out(alphabet))
        assert len(found) > 200
        assert sum(not missing for missing in found) <= unseen


def test_of_a_dot_nobody_says_that_it_is_a_small_letter():
    model = strokes("!")
    dot = [stroke for stroke in model if np.ptp(stroke.position, axis=0).max() < 0.01]
    assert score(dot, model).sentence.endswith("stroke is missing.")


def test_many_strokes_are_counted():
    model = strokes("l")
    many = faulty.after_each_other(
        [
            Trajectory(np.arange(20) / 100, s.position[:20] + 0.2 * k)
            for k in range(26)
            for s in model
        ]
    )
    assert re.search(
        r"^(There are 2\d strokes too many|It is)", score([*model, *many], model).sentence
    )


def test_a_stroke_is_named_by_its_ordinal():
    said = {
        number: word_difference("begins", 1.0, {"stroke": number, "of": 200}).reason.split()[1]
        for number in (0, 10, 20, 21, 22, 110)
    }
    assert said == {0: "first", 10: "11th", 20: "21st", 21: "22nd", 22: "23rd", 110: "111th"}


def test_a_score_prints_in_one_line():
    model = strokes("D")
    found = score(faulty.in_one(model), model)
    said = "It is written in one stroke; the model takes two."
    assert repr(found).startswith(f"Score({said!r}, shape the same, size the same, lean the same, ")
    assert "\n" not in repr(found)
    assert len(repr(found.matching)) < 300


def test_a_clock_in_microseconds_takes_no_memory():
    model = strokes("a")
    slow = [Trajectory(s.t * 1e6, s.position) for s in model]
    assert np.isfinite(score(slow, model).written.smoothness)
