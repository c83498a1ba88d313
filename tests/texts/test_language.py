"""A language is one file, and what it has not translated is English."""

import pytest

import dmp_teach as teach
from dmp_teach.texts import gettext, javascript_texts, ngettext


@pytest.fixture(autouse=True)
def english_again():
    yield
    teach.set_language("en")


def test_english_is_what_stands_in_the_code():
    assert gettext("Try {n}.") == "Try {n}."
    assert [ngettext("{n} dot", "{n} dots", n) for n in (1, 2)] == ["{n} dot", "{n} dots"]
    assert javascript_texts() == {}


def test_the_pseudo_language_is_longer_and_keeps_its_placeholders():
    teach.set_language("pseudo")
    text = "The pen stops {mm:.1f} mm from the ring."
    said = gettext(text)
    assert said[0] + said[-1] == "[]"
    assert "éñ" in said
    assert "{mm:.1f}" in said
    assert 1.2 * len(text) < len(said) < 1.4 * len(text)


def test_a_language_that_is_not_there_is_answered_with_those_that_are():
    with pytest.raises(teach.errors.SettingError, match="'xx', but it must be one of: 'en', "):
        teach.set_language("xx")
