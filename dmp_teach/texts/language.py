"""The language that panels, views and scores speak, by gettext's rules: English is the msgid."""

from __future__ import annotations

from gettext import NullTranslations
from pathlib import Path

from dmp_teach.arguments import checked
from dmp_teach.errors import SettingError
from dmp_teach.texts.pseudo import PseudoTranslations

FOLDER = Path(__file__).parent
TEMPLATE = FOLDER / "messages.pot"
# Whatever the language, the form of a larger number is that of its last two digits and 100.
COUNTS = range(200)

_ENGLISH = NullTranslations()
_spoken = _ENGLISH


@checked
def set_language(name: str) -> None:
    """Let what is made from now on speak another language.

    Args:
        name: "en"; a language with a file beside this module, such as "de"; or "pseudo", which has
            none: English with accents, a third longer and in brackets, as a test of translation.

    Raises:
        SettingError: There is no such language.
    """
    global _spoken  # noqa: PLW0603 (a process speaks one language)
    known = ["en", *sorted(path.stem for path in FOLDER.glob("*.po")), "pseudo"]
    if name not in known:
        names = ", ".join(map(repr, known))
        raise SettingError(f"language is {name!r}, but it must be one of: {names}.")
    if name in ("en", "pseudo"):
        _spoken = _ENGLISH if name == "en" else PseudoTranslations()
    else:
        # Babel loads when another language is wanted.
        from dmp_teach.texts.catalogue import load_translations  # noqa: PLC0415

        _spoken = load_translations(FOLDER / f"{name}.po")


def gettext(text: str) -> str:
    """Return a text in the language that is spoken; English where it has no translation."""
    return _spoken.gettext(text)


def ngettext(one: str, many: str, n: int) -> str:
    """Return the text for n things, of which English has two: for one of them and for many."""
    return _spoken.ngettext(one, many, n)


def marked(text: str) -> str:
    """Mark a text for the catalogue and return it as it is; `gettext` takes it where it is used."""
    return text


def javascript_texts() -> dict[str, object]:
    """Return the texts of the scripts, text -> translation; none for English.

    A text that counts things has its forms, and for each number from 0 to 199 which of them it is.
    """
    if _spoken is _ENGLISH:
        return {}
    from dmp_teach.texts.catalogue import list_texts  # noqa: PLC0415

    table: dict[str, object] = {}
    for text in list_texts(TEMPLATE, ".js"):
        if isinstance(text, str):
            table[text] = gettext(text)
        else:
            told = [ngettext(text[0], text[1], n) for n in COUNTS]
            forms = list(dict.fromkeys(told))
            table[text[0]] = [forms, [forms.index(each) for each in told]]
    return table
