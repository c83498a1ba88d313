"""What many rooms refuse is refused in the same words."""

import importlib
import inspect
import pkgutil

import numpy as np
import pytest

import dmp_teach
from dmp_teach.dmp.primitive import DMP
from dmp_teach.dmp.settings import Settings
from dmp_teach.errors import SettingError, kind_of, shown
from dmp_teach.ink.alphabet import recording_of
from dmp_teach.letters.compose.shelf import Shelf
from dmp_teach.letters.kernel_choice import imitate_strokes
from dmp_teach.letters.letter import Letter
from dmp_teach.letters.styles import Style
from dmp_teach.letters.styles_basis import learn_alike
from dmp_teach.letters.text.lines import write_lines
from dmp_teach.letters.text.words import write_word
from dmp_teach.studies.experiments.d_to_p import make_p_from_d
from dmp_teach.studies.experiments.goal_change import change_goals_1d, change_goals_2d
from dmp_teach.studies.experiments.goal_near_start import change_goals_near_start
from dmp_teach.studies.experiments.initial_acceleration import measure_initial_acceleration
from dmp_teach.studies.experiments.random_ink import learn_random_ink
from dmp_teach.studies.experiments.redraw import redraw_at_widths, redraw_letters
from dmp_teach.studies.experiments.validation import choose_kernels, choose_width
from dmp_teach.studies.experiments.variants import rms_error

D, STROKE = recording_of("D"), recording_of("D").strokes()[1]
LEARNED = Letter.learn(D)
TAKE_SETTINGS = {
    dmp_teach.sliders: [],
    DMP.imitate: (STROKE,),
    Letter.learn: (D,),
    imitate_strokes: ([STROKE],),
    Shelf.of: ({"D": LEARNED},),
    Style.of: ([D, recording_of("D", "slanted")],),
    learn_alike: ([LEARNED, LEARNED],),
    write_word: ("hi",),
    write_lines: ("hi",),
    measure_initial_acceleration: (D,),
    choose_kernels: (STROKE,),
    choose_width: (STROKE,),
    change_goals_near_start: (D,),
    change_goals_1d: (D,),
    change_goals_2d: (D,),
    make_p_from_d: (D,),
    redraw_letters: (D,),
    redraw_at_widths: (D,),
    learn_random_ink: (),
    rms_error: (STROKE,),
}
# What other rooms call with settings that are checked already.
INSIDE = {"Hand.of", "NamedChoice.of", "both_forms", "has_ends", "kernels_of", "note_gaps"}
INSIDE |= {"both_errors", "imitate_within", "time_ratio", "Evidence.errors", "Evidence.strays"}
# Its settings are keywords, each checked by its own knob.
INSIDE |= {"explore"}


def takes_settings(thing):
    return (inspect.isfunction(thing) or inspect.ismethod(thing)) and {
        "settings",
        "original",
    } & set(inspect.signature(thing).parameters)


def names():
    """Every function and method of ours that takes settings."""
    for module in pkgutil.walk_packages(dmp_teach.__path__, "dmp_teach."):
        if module.name.endswith(".__main__"):
            continue
        for name, thing in vars(importlib.import_module(module.name)).items():
            if getattr(thing, "__module__", "") != module.name or name.startswith("_"):
                continue
            if inspect.isclass(thing):
                methods = [getattr(thing, each) for each in vars(thing) if not each.startswith("_")]
                yield from (each.__qualname__ for each in methods if takes_settings(each))
            elif takes_settings(thing):
                yield thing.__qualname__


def test_whatever_takes_settings_is_asked_here():
    assert set(names()) == {ask.__qualname__ for ask in TAKE_SETTINGS} | INSIDE


@pytest.mark.parametrize("wrong", ["star", 3, "", 0, {}, Settings.star])
@pytest.mark.parametrize("ask", TAKE_SETTINGS, ids=lambda ask: ask.__qualname__)
def test_what_is_no_settings_is_refused_with_those_that_are(ask, wrong):
    for name in {"settings", "original"} & set(inspect.signature(ask).parameters):
        with pytest.raises(
            SettingError,
            match=rf"{name} is .*, but must be Settings.* such as .*Settings\.star\(\)",
        ):
            ask(*TAKE_SETTINGS[ask], **{name: wrong})


def test_the_refusal_is_a_sentence():
    with pytest.raises(
        SettingError,
        match=r"^settings is 'star', but must be Settings, such as Settings\.star\(\)\.$",
    ):
        write_word("hi", settings="star")
    with pytest.raises(
        SettingError, match=r"^settings\['mine'\] is 'star', but must be Settings, such as"
    ):
        redraw_letters(D, settings={"mine": "star"})
    with pytest.raises(
        SettingError,
        match=r"^settings is 'star', but must be Settings by their names, such as \{'DMP",
    ):
        make_p_from_d(D, settings="star")


@pytest.mark.parametrize(
    ("value", "words"),
    [
        (3, "an int"),
        ("a", "a str"),
        (None, "None"),
        (np.zeros(2), "an ndarray"),
        (np.uint8(1), "a uint8"),
        (D, "a Rec"),
    ],
)
def test_a_kind_has_its_article(value, words):
    assert kind_of(value).startswith(words)
    assert kind_of(value, first=True)[1:] == kind_of(value)[1:]
    assert kind_of(value, first=True)[0].isupper()


def test_whatever_is_wrong_is_shown_in_a_few_words():
    deep = []
    for _ in range(10_000):
        deep = [deep]
    assert shown(10**5000) == "an int"
    assert all(len(shown(each)) < 200 for each in (deep, "a" * 10_000, list(range(10_000))))
