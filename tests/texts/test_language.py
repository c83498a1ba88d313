"""A language is one file, and what it has not translated is English."""

import json
import shutil
import subprocess

import pytest

import dmp_teach as teach
from dmp_teach.classroom.panels import pad_messages
from dmp_teach.texts import catalogue, gettext, javascript_texts, language, ngettext
from tests.test_house import PACKAGE

POLISH = """
msgid ""
msgstr ""
"Content-Type: text/plain; charset=utf-8\\n"
"Plural-Forms: nplurals=3; plural=(n==1 ? 0 : n%10>=2 && n%10<=4 && (n%100<10 || n%100>=20) "
"? 1 : 2);\\n"

msgid "{n} stroke"
msgid_plural "{n} strokes"
msgstr[0] "{n} kreska"
msgstr[1] "{n} kreski"
msgstr[2] "{n} kresek"

msgid "Undo"
msgstr "Cofnij"

#, fuzzy
msgid "Save"
msgstr "Może"

msgid "The pen stops here."
msgstr "Pióro staje tutaj."
"""
COUNTED = {0: "0 kresek", 1: "1 kreska", 2: "2 kreski", 5: "5 kresek", 12: "12 kresek"}
COUNTED |= {22: "22 kreski", 112: "112 kresek", 1002: "1002 kreski"}


@pytest.fixture(autouse=True)
def english_again():
    yield
    teach.set_language("en")


@pytest.fixture
def polish(tmp_path, monkeypatch):
    """A language that has translated little, beside the others."""
    monkeypatch.setattr(language, "FOLDER", tmp_path)
    (tmp_path / "pl.po").write_text(POLISH, encoding="utf-8")
    teach.set_language("pl")
    return tmp_path / "pl.po"


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


def test_a_language_is_a_file_and_says_the_rest_in_english(polish):
    assert gettext("The pen stops here.") == "Pióro staje tutaj."
    assert gettext("Save") == "Save", "a fuzzy translation is a guess"
    assert gettext("Start again") == "Start again"
    for n, said in COUNTED.items():
        assert ngettext("{n} stroke", "{n} strokes", n).format(n=n) == said


def test_a_script_counts_as_python_does(polish):
    node = shutil.which("node")
    if node is None:
        pytest.skip("node is not installed")
    script = f"""
import {{ t, tn, useTexts }} from {(PACKAGE / "views" / "texts.js").as_uri()!r};
const count = (n) => tn("{{n}} stroke", "{{n}} strokes", n);
const said = [count(1), count(2), t("Try {{number}}", {{ number: 3 }})];
useTexts({json.dumps(javascript_texts())});
console.log(JSON.stringify([said, t("Undo"), t("Save"), {list(COUNTED)}.map(count)]));
"""
    line = [node, "--input-type=module", "--eval", script]
    told = subprocess.run(line, capture_output=True, encoding="utf-8", check=True)
    english = ["1 stroke", "2 strokes", "Try 3"]
    assert json.loads(told.stdout) == [english, "Cofnij", "Save", list(COUNTED.values())]


def test_a_language_that_is_not_there_is_answered_with_those_that_are():
    with pytest.raises(teach.errors.SettingError, match="'xx', but it must be one of: 'en', "):
        teach.set_language("xx")


def test_the_template_has_every_text_of_the_code():
    made = catalogue.extract_texts()
    assert language.TEMPLATE.read_bytes() == made, "run `python -m dmp_teach.texts`"


def test_a_file_is_begun_and_brought_up_to_date_without_a_loss(polish):
    catalogue.update_language(polish, language.TEMPLATE)
    begun = polish.with_name("fr.po")
    catalogue.update_language(begun, language.TEMPLATE)
    text = polish.read_text(encoding="utf-8")
    assert 'msgid "Undo"\nmsgstr "Cofnij"' in text
    assert text.count("msgid ") >= begun.read_text(encoding="utf-8").count("msgid ") > 300
    teach.set_language("fr")
    assert pad_messages.describe_sheet("a", 2, "") == "Your a, 2 strokes."


def test_scores_and_messages_are_translated_whole():
    teach.set_language("pseudo")
    model = teach.recording_of("a")
    found = teach.score([stroke for stroke in teach.recording_of("e").strokes()], model)
    for said in (found.sentence, pad_messages.describe_attempt(found, found)["text"]):
        assert said.strip().startswith("[")
        assert not {"shape", "letter", "average"} & set(said.split())
