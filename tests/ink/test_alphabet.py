"""Our alphabets are written as a person writes, and JSON keeps what it was given."""

import importlib
import sys
from functools import cache
from itertools import pairwise
from pathlib import Path
from string import ascii_lowercase, ascii_uppercase, digits
from unicodedata import normalize

import numpy as np
import pytest
from scipy.spatial import cKDTree

from dmp_teach.errors import LetterError, RecordingError
from dmp_teach.files.writing import ASSETS
from dmp_teach.formats.read import read_recording
from dmp_teach.ink import alphabet
from dmp_teach.ink.alphabet import SIGNS, alphabets, characters, file_name, recording_of, signs
from dmp_teach.ink.recording_json import read_json
from dmp_teach.letters.letter import Letter
from tests.laws import for_every
from tests.recordings import RECORDINGS, needs_recordings

EVERY = [(name, letter) for name in alphabets() for letter in characters(name)]
PUNCTUATION = [(name, sign) for name in alphabets() for sign in signs(name)]
# How many strokes a letter has in the round hand, and in the slanted one; else one.
STROKES = (
    dict.fromkeys("fijtx457BDKMNPQRTXYkæœ", 2)
    | dict.fromkeys("AFHI", 3)
    | {"E": 4, "Æ": 5, "Œ": 5},
    dict.fromkeys("fijtx457ABDGKPQRTXYæœ", 2) | dict.fromkeys("EFHI", 3) | dict.fromkeys("ÆŒ", 4),
)
DIAERESIS, CEDILLA = "\u0308", "\u0327"
LANGUAGES = {  # what each wants beside a to z
    "German": "äöüß",
    "French": "àâæçéèêëîïôœùûüÿ",
    "Spanish": "áéíñóúü",
    "Portuguese": "áàâãçéêíóôõú",
    "Italian": "àèéìíîòóùú",
    "Swedish": "åäö",
}
every_letter = for_every(EVERY)
every_sign = for_every(PUNCTUATION)


@cache
def script():
    """The module that made the alphabets."""
    sys.path.insert(0, str(ASSETS))
    try:
        return importlib.import_module("make_alphabets")
    finally:
        sys.path.remove(str(ASSETS))


@cache
def written(name, letter):
    """A letter by the script, and when its strokes were on the paper [s]."""
    hand, shapes = script().ALPHABETS[name]
    return script().write(letter, shapes[letter], hand)


def strokes_taught(name, letter):
    """In how many strokes a letter is written: its base, without the dot of an i, and its mark."""
    base, *mark = normalize("NFD", letter)
    count = STROKES[alphabets().index(name)].get(base, 1)
    if not mark:
        return count
    return count - (base == "i") + (2 if mark == [DIAERESIS] else 1)


def upright(recording, name):
    """The ink of a recording (T, 2) without the slant of its hand."""
    ink = ink_of(recording)
    return ink - np.outer(ink[:, 1], (script().ALPHABETS[name][0].slant, 0.0))


def ink_of(recording):
    """All points of a recording that left ink, (T, 2)."""
    return np.concatenate([stroke.position for stroke in recording.strokes()])


def motion(recording):
    """Velocity and acceleration, (T, 3) each."""
    velocity = np.gradient(recording.position, recording.t, axis=0)
    return velocity, np.gradient(velocity, recording.t, axis=0)


def test_two_writers_have_all_62_letters_and_then_accents_for_six_languages():
    assert alphabets() == ("round", "slanted")
    for name in alphabets():
        plain, accented = characters(name)[:62], characters(name)[62:]
        assert "".join(plain) == ascii_lowercase + ascii_uppercase + digits
        assert set("".join(LANGUAGES.values())) <= set(accented)
        assert len(accented) == 57
        assert not any(map(str.isascii, accented))
        assert "".join(accented) == "".join(
            sorted(accented, key=lambda letter: (letter.isupper(), letter))
        )
    assert len({recording_of("a", name).writer for name in alphabets()}) == 2


@pytest.mark.parametrize("name", alphabets())
def test_every_small_letter_has_its_capital_and_every_capital_its_small_letter(name):
    """But ß, whose capital is SS."""
    every = set(characters(name)) - set(digits)
    assert {letter.upper() for letter in every} - {"SS"} == {
        letter for letter in every if letter.isupper()
    }
    assert {letter.lower() for letter in every} | {"ß"} == {
        letter for letter in every if letter.islower()
    }


def test_the_first_alphabet_is_taken_unless_another_is_named():
    assert characters() == characters("round")
    assert np.array_equal(recording_of("a").position, recording_of("a", "round").position)
    assert not np.array_equal(
        recording_of("a").position[:99], recording_of("a", "slanted").position[:99]
    )


@pytest.mark.slow
@every_letter
def test_every_letter_is_a_recording_at_120_hz_that_stands_on_its_line(name, letter):
    recording = recording_of(letter, name)
    assert recording.character == letter
    assert recording.baseline == 0.0
    assert recording.t[0] == 0.0
    np.testing.assert_allclose(np.diff(recording.t), 1 / 120, atol=2e-6)
    width, height = np.ptp(recording.position[:, :2], axis=0)
    assert 0.05 < height < 0.19
    assert width < 0.15
    lowest = recording.position[:, 1].min()
    below = (letter == "Q" or CEDILLA in normalize("NFD", letter)) and -0.04 < lowest < -0.005
    assert (
        -0.005 < lowest < 0.005
        or (normalize("NFD", letter)[0] in "fgjpqyz" and -0.08 < lowest < -0.03)
        or below
    )


@pytest.mark.slow
@every_letter
def test_every_letter_goes_from_rest_to_rest_no_faster_than_a_hand(name, letter):
    recording = recording_of(letter, name)
    velocity, acceleration = (np.linalg.norm(values, axis=1) for values in motion(recording))
    assert max(velocity[0], velocity[-1]) < 0.005
    assert 0.1 < velocity.max() < 0.8
    assert acceleration.max() < 8.0
    assert 1.0 < recording.duration < 6.0


@pytest.mark.slow
@every_letter
def test_the_pen_is_lifted_between_strokes_and_lies_on_the_paper_else(name, letter):
    samples, spans = written(name, letter)
    t, height = samples[:, 0], samples[:, 3]
    assert len(spans) == strokes_taught(name, letter)
    for begin, end in spans:
        assert np.abs(height[(t > begin + 0.11) & (t < end - 0.11)]).max(initial=0) < 0.0006
    for (_, up), (down, _) in pairwise(spans):
        assert 0.3 < down - up < 0.6
        assert 0.015 < height[(t > up) & (t < down)].max() < 0.040


@pytest.mark.slow
@pytest.mark.parametrize("name", alphabets())
def test_bends_are_slow_as_the_two_thirds_power_law_says(name):
    bends, speeds = [], []
    for letter in characters(name):
        recording, (_, spans) = recording_of(letter, name), written(name, letter)
        velocity, acceleration = (values[:, :2] for values in motion(recording))
        speed = np.linalg.norm(velocity, axis=1)
        turn = np.abs(velocity[:, 0] * acceleration[:, 1] - velocity[:, 1] * acceleration[:, 0])
        bend = turn / np.maximum(speed, 1e-9) ** 3
        # Where the hand neither gets up to speed nor slows down.
        ramps = [max(0.3, 0.25 * (b - a)) for a, b in spans]
        away = np.any(
            [
                (recording.t > a + ramp) & (recording.t < b - ramp)
                for (a, b), ramp in zip(spans, ramps, strict=True)
            ],
            axis=0,
        )
        bends.append(bend[away & (bend > 4)])
        speeds.append(speed[away & (bend > 4)])
    bends, speeds = np.log(np.concatenate(bends)), np.log(np.concatenate(speeds))
    for low, high, least, most, together in (
        (4, np.inf, -0.42, -0.28, -0.6),
        (4, 100, -0.35, -0.14, -0.4),
    ):
        some = (bends > np.log(low)) & (
            bends < np.log(high)
        )  # all bends, then those without the corners
        assert least < np.polyfit(bends[some], speeds[some], 1)[0] < most
        assert np.corrcoef(bends[some], speeds[some])[0, 1] < together


def largest_over_mean(recording):
    """The largest speed of the pen on paper in units of its mean."""
    speed = np.concatenate(
        [
            np.linalg.norm(np.gradient(stroke.position, stroke.t, axis=0), axis=1)
            for stroke in recording.strokes()
        ]
    )
    return speed.max() / speed.mean()


# Those of seven people who wrote a, B, D, e or M have 1.54 to 2.56.
AS_A_HAND = (1.5, 2.6)


@needs_recordings
def test_real_hands_do_not_write_at_one_speed():
    for path in RECORDINGS:
        assert AS_A_HAND[0] < largest_over_mean(read_recording(path)) < AS_A_HAND[1], path.name


@for_every((name, letter) for name in alphabets() for letter in "aceomnsuCDGOQSBU035689")
def test_round_letters_do_not_move_at_one_speed_either(name, letter):
    assert AS_A_HAND[0] < largest_over_mean(recording_of(letter, name)) < AS_A_HAND[1]


@pytest.mark.slow
@every_letter
def test_the_height_tells_the_strokes_that_the_hand_made(name, letter):
    recording, (_, spans) = recording_of(letter, name), written(name, letter)
    assert recording.given_strokes is None
    strokes = recording.strokes()
    assert len(strokes) == len(spans)
    for stroke, (begin, end) in zip(strokes, spans, strict=True):
        assert abs(stroke.t[0] - begin) < 0.05
        assert abs(stroke.t[-1] - end) < 0.05


@pytest.mark.slow
@pytest.mark.parametrize("theta", [0.08, 0.10])
@pytest.mark.parametrize("sigma", [0.003, 0.010])
def test_the_number_of_strokes_does_not_hang_on_the_thresholds(theta, sigma):
    found = {pair: len(recording_of(pair[1], pair[0]).strokes(theta, sigma)) for pair in EVERY}
    assert found == {pair: len(written(*pair)[1]) for pair in EVERY}


@pytest.mark.parametrize("name", alphabets())
def test_the_bowl_of_d_runs_from_the_top_of_its_bar_to_the_foot(name):
    samples, spans = written(name, "D")
    bar, bowl = (samples[(samples[:, 0] >= a) & (samples[:, 0] <= b), 1:3] for a, b in spans)
    assert np.linalg.norm(bowl[0] - bar[0]) < 0.006
    assert np.linalg.norm(bowl[-1] - bar[-1]) < 0.006
    chord = bowl[-1] - bowl[0]
    aside = np.abs(
        np.cross(np.append(chord, 0), np.pad(bowl - bowl[0], ((0, 0), (0, 1))))[:, 2]
    ) / np.linalg.norm(chord)
    assert aside.max() > 0.4 * np.linalg.norm(chord)


@pytest.mark.slow
def test_capitals_are_as_high_as_stems_or_a_bit_less_and_x_is_one_height():
    for name in alphabets():
        top = {
            letter: ink_of(recording_of(letter, name))[:, 1].max()
            for letter in characters(name)[:62]
        }
        stem, middle = (
            np.mean([top[letter] for letter in "bdhkl"]),
            np.mean([top[letter] for letter in "amnouxz"]),
        )
        for letter in ascii_uppercase:
            assert 0.92 * stem < top[letter] < 1.02 * stem, letter
        for letter in "acegmnopqrsuvwxyz":
            assert abs(top[letter] - middle) < 0.05 * middle, letter


def test_capitals_have_the_old_roman_proportions():
    for name in alphabets():
        wide = {
            letter: np.ptp(upright(recording_of(letter, name), name)[:, 0])
            for letter in ascii_uppercase
        }
        narrow, middle, full = (
            np.mean([wide[letter] for letter in group])
            for group in ("BEFLPRS", "AHNTUVXYZ", "CDGOQ")
        )
        assert 1.1 * narrow < min(middle, full)
        assert max(middle, full) < wide["M"] < wide["W"]
        assert wide["I"] < min(wide[letter] for letter in ascii_uppercase if letter != "I")


def test_every_stem_of_a_hand_leans_alike():
    for name in alphabets():
        hand, _ = script().ALPHABETS[name]
        for letter in "BDEFHKLPRT":
            stem = recording_of(letter, name).strokes()[0].position
            middle = stem[
                (stem[:, 1] > 0.2 * stem[:, 1].max()) & (stem[:, 1] < 0.9 * stem[:, 1].max())
            ]
            lean = np.polyfit(middle[:, 1], middle[:, 0], 1)[0]
            assert abs(lean - hand.slant - 0.01) < 0.06, letter


def test_signs_stand_beside_the_letters_and_not_among_them():
    for name in alphabets():
        assert "".join(signs(name)) == SIGNS == ".,;:!?'\"-()¿¡«»+=/"
        assert not set(SIGNS) & set(characters(name))


@every_sign
def test_every_sign_is_a_recording_that_is_found_stroke_by_stroke_and_learned(name, sign):
    recording, (_, spans) = recording_of(sign, name), written(name, sign)
    assert recording.character == sign
    assert recording.baseline == 0.0
    np.testing.assert_allclose(np.diff(recording.t), 1 / 120, atol=2e-6)
    strokes = recording.strokes()
    assert len(strokes) == len(spans) == (2 if sign in ';:!?"¿¡«»+=' else 1)
    for stroke, (begin, end) in zip(strokes, spans, strict=True):
        assert abs(stroke.t[0] - begin) < 0.05
        assert abs(stroke.t[-1] - end) < 0.05
    assert Letter.learn(recording).error < 0.9e-3
    np.testing.assert_allclose(
        recording.position, script().recording(name, sign).position, atol=2e-6
    )


@every_sign
def test_a_sign_is_at_its_height(name, sign):
    """Dots and commas at the line, a hyphen in the middle, apostrophes at the top of stems.

    Brackets go over all. Signs on their heads begin where a small letter ends, and hang as deep as
    a g.
    """
    ink = ink_of(recording_of(sign, name))[:, 1] / script().ALPHABETS[name][0].size
    low, high = {
        ".": (0, 0.1), ",": (-0.25, 0.1), ";": (-0.25, 0.7), ":": (0, 0.7), "-": (0.5, 0.5),
        **dict.fromkeys("!?", (0, 1.85)), **dict.fromkeys("'\"", (1.55, 1.9)),
        **dict.fromkeys("()/", (-0.25, 1.95)), **dict.fromkeys("¿¡", (-0.84, 1.0)),
        **dict.fromkeys("«»", (0.17, 0.84)), "+": (0.5, 1.22), "=": (0.66, 1.05),
    }[sign]  # fmt: skip
    assert ink.min() == pytest.approx(low, abs=0.06)
    assert ink.max() == pytest.approx(high, abs=0.06)


@pytest.mark.parametrize("name", alphabets())
@pytest.mark.parametrize(("sign", "usual"), ["¿?", "¡!", "»«", ")("])
def test_half_a_turn_makes_one_sign_of_another(name, sign, usual):
    """About the middle of its box, to what a hand wobbles; each stroke still begins at its top."""
    turned, other = recording_of(sign, name), recording_of(usual, name)
    size = script().ALPHABETS[name][0].size
    here, there = (
        ink - (ink.min(axis=0) + ink.max(axis=0)) / 2 for ink in (ink_of(turned), -ink_of(other))
    )
    assert cKDTree(here).query(there)[0].max() < 0.08 * size
    assert all(
        stroke.position[0, 1] > stroke.position[-1, 1] - 0.5 * size for stroke in turned.strokes()
    )


@pytest.mark.slow
@every_letter
def test_every_letter_is_learned(name, letter):
    assert Letter.learn(recording_of(letter, name)).error < 0.9e-3


@pytest.mark.parametrize("name", alphabets())
def test_an_accent_is_written_after_its_letter_and_above_or_below_it(name):
    for letter in characters(name)[62:]:
        _, *mark = normalize("NFD", letter)
        if not mark:
            continue
        accents = 2 if mark == [DIAERESIS] else 1
        strokes = recording_of(letter, name).strokes()
        body = np.concatenate([stroke.position for stroke in strokes[:-accents]])
        marks = np.concatenate([stroke.position for stroke in strokes[-accents:]])
        if mark == [CEDILLA]:
            assert marks[:, 1].max() < 0.004
        else:
            assert 0.006 < marks[:, 1].min() - body[:, 1].max() < 0.030, letter
        flat, about = (
            ink - np.outer(ink[:, 1], (script().ALPHABETS[name][0].slant, 0))
            for ink in (marks, body)
        )
        assert about[:, 0].min() - 0.015 < flat[:, 0].mean() < about[:, 0].max() + 0.002, letter


@pytest.mark.parametrize("letter", ["ä", "é", "ç", "Ñ"])
def test_an_accent_may_be_a_sign_of_its_own(letter):
    two = normalize("NFD", letter)
    assert len(two) == 2
    assert recording_of(two).character == letter
    assert file_name(two) == file_name(letter)


@pytest.mark.slow
def test_the_script_writes_the_letters_that_are_here(tmp_path):
    script().main(tmp_path)
    made, here = (
        {path.relative_to(folder): read_json(path) for path in folder.rglob("*.json")}
        for folder in (tmp_path, alphabet.ALPHABETS_FOLDER)
    )
    assert made.keys() == here.keys()
    for path, letter in here.items():
        assert letter.writer == made[path].writer
        np.testing.assert_allclose(letter.t, made[path].t, atol=1e-9)
        np.testing.assert_allclose(letter.position, made[path].position, atol=2e-6)


@pytest.mark.parametrize("letter", ["ж", "", "ab", "a\u0300\u0301", "../round/a", 3, None, ["a"]])
def test_an_unknown_letter_is_answered_with_those_that_exist(letter):
    with pytest.raises(
        RecordingError, match=r"The alphabet 'round' has no .*; it has: a b c .* B .*R"
    ):
        recording_of(letter)


@pytest.mark.parametrize("name", ["runes", "", "../alphabets/round", 3, ["round"], Path("round")])
def test_an_unknown_alphabet_is_answered_with_those_that_exist(name):
    for ask in (lambda: recording_of("a", name), lambda: characters(name)):
        with pytest.raises(
            RecordingError, match=r"There is no alphabet .*; there are: round, slanted\."
        ):
            ask()


def test_where_there_is_no_alphabet_the_script_is_named(tmp_path, monkeypatch):
    monkeypatch.setattr(alphabet, "ALPHABETS_FOLDER", tmp_path)
    with pytest.raises(RecordingError, match=r"There is no alphabet in .*make_alphabets\.py"):
        alphabets()


def test_files_of_another_kind_in_an_alphabet_are_no_letters(tmp_path, monkeypatch):
    monkeypatch.setattr(alphabet, "ALPHABETS_FOLDER", tmp_path)
    (tmp_path / "mine").mkdir()
    odd = (
        "small_u0062.json",
        "small_u00E4.json",
        "capital_a.json",
        "small_u0308.json",
        "small_.json",
        "sign_dot.json",
    )
    for file in (
        "small_a.json",
        "small_u00e4.json",
        "notes_b.json",
        "small_ab.json",
        "readme.json",
        *odd,
    ):
        (tmp_path / "mine" / file).write_text("{}")
    assert characters("mine") == ("a", "ä")


def test_file_names_differ_even_where_capitals_do_not_count():
    every = {letter for _, letter in EVERY + PUNCTUATION}
    names = [file_name(letter) for letter in every]
    assert len({name.lower() for name in names}) == len(names)
    assert all(map(str.isascii, names))
    assert (file_name("a"), file_name("Ä")) == ("small_a.json", "capital_u00c4.json")
    assert file_name(".") == "sign_full_stop.json"
    for letter in ("ab", "", "%", "..", "\u2019", "\u0308", 3, None):
        with pytest.raises(RecordingError, match="must be one letter or digit"):
            file_name(letter)


@pytest.mark.parametrize("alphabet", alphabets())
def test_a_left_hand_pulls_bars_from_right_to_left_and_leaves_the_same_ink(alphabet):
    pulled = {}
    for character in "tfAEFHTaDz45iO":
        right, left = (recording_of(character, alphabet, hand=hand) for hand in ("right", "left"))
        for number, (one, other) in enumerate(zip(right.strokes(), left.strokes(), strict=True)):
            if not np.array_equal(one.position, other.position):
                assert np.allclose(one.position, other.position[::-1])
                assert other.position[0, 0] > other.position[-1, 0]
                assert np.allclose(one.t[[0, -1]], other.t[[0, -1]])
                pulled.setdefault(character, []).append(number)
        assert (left.character, left.baseline) == (right.character, right.baseline)
    assert set(pulled) == set("tfAEFHT")
    with pytest.raises(LetterError, match="hand is 'both'"):
        recording_of("t", hand="both")
