"""A letter that was saved writes as it did, and a file that was touched is refused."""

import json
import os
import pickle
from contextlib import suppress
from dataclasses import fields, replace

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from dmp_teach.dmp.primitive import DMP
from dmp_teach.dmp.settings import Settings
from dmp_teach.errors import LetterError, PathError
from dmp_teach.files.saved import check_sum
from dmp_teach.ink.alphabet import recording_of
from dmp_teach.letters.compose.shelf import Shelf
from dmp_teach.letters.letter import Letter
from dmp_teach.letters.styles import Style
from dmp_teach.trajectory import Trajectory

FIELDS = ["format", "version", "units", "strokes", "primitives", "led_to", "made_of", "check"]
PRESETS = ["star", "original", "joint", "plus", "as_printed", "as_coded", "as_fixed"]
ASKED = [
    {},
    {"goals": {0: (0.01, 0.02)}},
    {"goal_shifts": {1: (0.03, -0.01)}, "starts": {0: (0.0, 0.1)}},
    {"duration": 7.0},
]


def same(one, other, **asked):
    """Whether two letters write the same, bit for bit."""
    return all(
        np.array_equal(a.t, b.t) and np.array_equal(a.position, b.position)
        for a, b in zip(one.write(**asked), other.write(**asked), strict=True)
    )


@pytest.mark.parametrize("preset", PRESETS)
def test_a_letter_that_was_saved_writes_the_same_to_the_last_bit(tmp_path, preset):
    letter = Letter.learn(recording_of("D"), getattr(Settings, preset)())
    again = Letter.load(letter.save(tmp_path / "d.json"))
    for asked in ASKED:
        assert same(letter, again, **asked)
    for one, other in zip(letter.primitives, again.primitives, strict=True):
        assert one.settings == other.settings
        assert one.notes == other.notes
        assert np.array_equal(one.weights, other.weights)
    assert again.error == letter.error
    assert repr(again) == repr(letter)
    assert again.save(tmp_path / "e.json").read_bytes() == (tmp_path / "d.json").read_bytes()


@pytest.mark.parametrize("transform", ["star", "similarity"])
def test_other_transforms_and_endless_kernels_are_kept(tmp_path, transform):
    letter = Letter.learn(
        recording_of("M"), Settings.joint(transform=transform, kernel_width=np.inf)
    )
    again = Letter.load(letter.save(tmp_path / "m.json"))
    for asked in ASKED:
        assert same(letter, again, **asked)


def test_a_letter_that_was_composed_is_kept(tmp_path):
    bar, bowl = Shelf.of([recording_of("D")])["D"]
    letter = Letter.compose([bar, bowl.led(lower=bar.at(0.5))])
    again = Letter.load(letter.save(tmp_path / "p.json"))
    assert same(letter, again)
    assert again.made_of == letter.made_of
    assert {k: tuple(v) for k, v in again.led_to.items()} == {
        k: tuple(v) for k, v in letter.led_to.items()
    }


@pytest.mark.parametrize("began", [41_000.0, 1.7e9])  # seconds since midnight, and since 1970
def test_a_letter_keeps_its_clock_unless_it_may_be_one_of_the_world(tmp_path, began):
    t = np.linspace(0, 1, 60)
    way = np.column_stack([0.1 * t, 0.05 * np.sin(3 * t)])
    soon, late = (Letter.learn([Trajectory(t + begin, way)]) for begin in (3.25, began))
    assert Letter.load(soon.save(tmp_path / "a.json")).write()[0].t[0] == 3.25
    path = late.save(tmp_path / "b.json")
    assert Letter.load(path).write()[0].t[0] == 0.0
    assert str(int(began)) not in path.read_text()


@pytest.fixture(scope="module")
def content(tmp_path_factory):
    """A saved letter of two short strokes, as an object."""
    t = np.linspace(0, 0.5, 25)
    strokes = [
        Trajectory(t, np.column_stack([0.1 * t, t**2])),
        Trajectory(t + 1, np.column_stack([t**2, 0.1 * t])),
    ]
    path = Letter.learn(strokes).save(tmp_path_factory.mktemp("saved") / "l.json")
    return json.loads(path.read_text())


def forged(content, path, *keys, value):
    """The file with one value changed and its check sum made again."""
    content = json.loads(json.dumps(content))
    inner = content
    for key in keys[:-1]:
        inner = inner[key]
    inner[keys[-1]] = value
    del content["check"]
    content["check"] = check_sum(content)
    path.write_text(json.dumps(content))
    return path


def test_a_file_that_was_changed_is_refused(tmp_path, content):
    text = json.dumps(content)
    (tmp_path / "l.json").write_text(text)
    assert len(Letter.load(tmp_path / "l.json").strokes) == 2
    (tmp_path / "l.json").write_text(text.replace('"duration": 0.5', '"duration": 0.6', 1))
    with pytest.raises(
        LetterError, match=r"l\.json: it was changed after it was saved, or damaged; save again"
    ):
        Letter.load(tmp_path / "l.json")


FORGED = {
    "version": (("version",), 2, "version is 2, but this program reads version 1; update"),
    "format": (("format",), "font", "this is not a dmp_teach letter"),
    "units": (("units",), {"t": "ms"}, "its units are {'t': 'ms'}, but must be"),
    "time stands still": (("strokes", 0), [[0.0, 1.0, 1.0]] * 3, "does not come after"),
    "text": (("primitives", 0, "goal"), [0.0, "x"], "no letter as Letter.save writes it"),
    "ragged": (("primitives", 1, "weights"), [[1.0], [1.0, 2.0]], "no letter as Letter.save"),
    "a step too few": (("primitives", 0, "steps"), 3, "path has shape ("),
    "a field": (("primitives", 0, "code"), "import os", "unexpected keyword argument 'code'"),
    "no weights": (("primitives", 0, "weights"), None, "no letter as Letter.save writes it"),
    "no time": (("primitives", 0, "duration"), "long", "duration is 'long', but it must be"),
    "notes": (("primitives", 0, "notes"), [{}], "but must be texts"),
    "other times": (("primitives", 0, "times"), [0.0, 1.0], "must have the times of its stroke"),
    "names": (("made_of",), [1], "made_of is (1,), but must be names of strokes"),
    "a setting": (("primitives", 0, "settings", "phase"), "moon", "phase is 'moon', but it must"),
    "a setting more": (("primitives", 0, "settings", "name"), "Kim", "keyword argument 'name'"),
}


@pytest.mark.parametrize("fault", FORGED)
def test_a_forged_field_is_refused_even_with_its_sum_made_again(tmp_path, content, fault):
    keys, value, sentence = FORGED[fault]
    with pytest.raises(LetterError) as caught:
        Letter.load(forged(content, tmp_path / "l.json", *keys, value=value))
    assert str(caught.value).startswith("l.json: ")
    assert sentence in str(caught.value)


@pytest.mark.parametrize("field", FIELDS)
def test_a_missing_field_is_refused(tmp_path, content, field):
    (tmp_path / "l.json").write_text(
        json.dumps({name: value for name, value in content.items() if name != field})
    )
    with pytest.raises(LetterError, match=r"l\.json: "):
        Letter.load(tmp_path / "l.json")


@settings(max_examples=60, deadline=None, suppress_health_check=list(HealthCheck))
@given(
    keys=st.sampled_from(
        [("primitives", 0, name) for name in (*(each.name for each in fields(DMP)), "path")]
        + [(f,) for f in FIELDS[2:7]]
    ),
    value=st.recursive(
        st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=3),
        lambda inner: (
            st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=3), inner, max_size=3)
        ),
    ),
)
def test_anything_in_any_field_is_a_letter_or_a_sentence(tmp_path, content, keys, value):
    forged(content, tmp_path / "l.json", *keys, value=value)
    with suppress(LetterError):
        assert Letter.load(tmp_path / "l.json").strokes


def test_what_is_no_saved_letter_is_refused(tmp_path):
    recording_path = tmp_path / "a.json"
    recording_path.write_text("{}")
    with pytest.raises(LetterError, match=r"a\.json: this is not a dmp_teach letter"):
        Letter.load(recording_path)
    recording_path.write_bytes(pickle.dumps([1]))
    with pytest.raises(LetterError, match=r"a\.json: this is not plain JSON"):
        Letter.load(recording_path)
    with pytest.raises(LetterError, match=r"b\.json cannot be read: No such file"):
        Letter.load(tmp_path / "b.json")
    for named in (3, ""):
        with pytest.raises(LetterError, match="must be the name of a file"):
            Letter.load(named)


@pytest.mark.skipif(os.name == "nt", reason="Windows has no rights of this kind")
def test_a_file_keeps_its_rights_and_a_link_is_followed(tmp_path):
    letter, path, link = Letter.learn(recording_of("l")), tmp_path / "l.json", tmp_path / "k.json"
    letter.save(path).chmod(0o600)
    link.symlink_to(path)
    Letter.learn(recording_of("D")).save(link)
    assert link.is_symlink()
    assert len(Letter.load(path).strokes) == 2
    assert path.stat().st_mode & 0o777 == 0o600
    path.chmod(0o400)
    with pytest.raises(PathError, match="cannot be written: it is read-only"):
        letter.save(link)


@pytest.mark.parametrize("dimensions", [1, 3, 5])
def test_letters_and_primitives_of_any_dimension_are_saved(tmp_path, dimensions):
    t = np.linspace(0, 1, 60)
    stroke = Trajectory(t, np.column_stack([t**n for n in range(1, dimensions + 1)]))
    letter = Letter.learn([stroke])
    assert Letter.load(letter.save(tmp_path / "l.json")) == letter
    (primitive,) = letter.primitives
    again = DMP.load(primitive.save(tmp_path / "p.json"))
    assert again == primitive
    for ends in ({}, {"goal": 1.1 * primitive.goal}, {"start": primitive.start + 0.1}):
        assert again.rollout(**ends) == primitive.rollout(**ends)


@pytest.fixture(scope="module")
def alike():
    return [recording_of("l"), replace(recording_of("l", "slanted"), writer="Kim")]


def test_a_shelf_that_was_saved_gives_the_same_pieces_without_names(tmp_path, alike):
    shelf = Shelf.of([*alike, recording_of("D"), replace(alike[0], writer=None)])
    path = shelf.save(tmp_path / "s.json")
    again = Shelf.load(path)
    assert "Kim" not in path.read_text()
    assert again.writers == ("writer-1", "writer-2", None)
    renamed = [replace(each, writer="Kim") for each in again.by("writer-2")]
    assert Shelf((*again.by("writer-1"), *renamed, *again.by(None))) == Shelf(
        (*shelf.by("writer-1"), *shelf.by("Kim"), *shelf.by(None))
    )


def test_a_style_that_was_saved_draws_the_same_without_names(tmp_path, alike):
    style = Style.of(alike).through(0, 0.5, (0.02, 0.1))
    path = style.save(tmp_path / "s.json")
    again = Style.load(path)
    assert "Kim" not in path.read_text()
    assert again == replace(style, writers=("writer-1", "writer-2"))
    assert again.mean == style.mean
    assert again.blend({"writer-2": 1.0}) == style.blend({"Kim": 1.0})
    twice = Style.of([alike[0], alike[0]])
    assert Style.load(twice.save(path)) == twice


TOUCHED = {
    "weights": (DMP, ("weights", 0), [0.0]),
    "not finite": (DMP, ("weights", 0, 0), float("1e999")),
    "a name": (Shelf, ("pieces", 0, "writer"), "Kim"),
    "no number": (Shelf, ("pieces", 0, "number"), "b"),
    "a piece less": (Shelf, ("pieces", 0, "shown"), []),
    "another name": (Style, ("writers", 0), "Kim"),
    "a way too many": (Style, ("ways",), []),
    "a letter less": (Style, ("letters",), []),
}


@pytest.mark.parametrize("fault", TOUCHED)
def test_what_no_save_writes_is_refused(tmp_path, alike, fault):
    kind, keys, value = TOUCHED[fault]
    few = Settings.star(n_kernels=5)
    made = {Shelf: lambda: Shelf.of(alike, few), Style: lambda: Style.of(alike, few)}
    made[DMP] = lambda: Letter.learn(alike[0], few).primitives[0]
    content = json.loads(made[kind]().save(tmp_path / "a.json").read_text())
    with pytest.raises(LetterError, match=r"^b\.json: "):
        kind.load(forged(content, tmp_path / "b.json", *keys, value=value))
