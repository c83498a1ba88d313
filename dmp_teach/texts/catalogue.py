"""The catalogue's files: a template with every text of the code, and a `.po` for each language."""

from __future__ import annotations

from functools import cache
from gettext import GNUTranslations
from io import BytesIO
from pathlib import Path

from babel.messages import Catalog
from babel.messages.extract import extract_from_dir
from babel.messages.mofile import write_mo
from babel.messages.pofile import read_po, write_po

PACKAGE = Path(__file__).parents[1]
METHODS = [("**.py", "python"), ("**.js", "javascript")]
# Which of a function's arguments are texts; the first one where nothing is said.
KEYWORDS = dict.fromkeys(("_", "gettext", "marked", "t"))
KEYWORDS |= dict.fromkeys(("ngettext", "tn"), (1, 2))
# Plain and real name of a setting: two texts of one call, which Babel takes for one that counts.
KNOB_KEYWORDS = ({"knob": (2,)}, {"knob": (3,)})


def extract_texts() -> bytes:
    """Return the template: every text of the package's Python and JavaScript, file by file."""
    template = Catalog(project="dmp_teach", charset="utf-8")
    for keywords in (KEYWORDS, *KNOB_KEYWORDS):
        for file, _, text, *_ in extract_from_dir(PACKAGE, METHODS, keywords=keywords):
            template.add(text, None, [(f"dmp_teach/{file}", 0)])
    return _render(template, omit_header=True)


def update_language(path: Path, template: Path) -> None:
    """Write a language's file anew with the template's texts; those that it has translated stay.

    A file that is not there yet is begun.
    """
    with template.open("rb") as file:
        texts = read_po(file)
    catalogue = _read(path) if path.exists() else Catalog(path.stem, project="dmp_teach")
    catalogue.update(texts)
    path.write_bytes(_render(catalogue))


def load_translations(path: Path) -> GNUTranslations:
    """Return a language's translations; texts without one, and fuzzy ones, are left out."""
    machine = BytesIO()
    write_mo(machine, _read(path))
    machine.seek(0)
    return GNUTranslations(machine)


@cache
def list_texts(template: Path, suffix: str) -> tuple[str | tuple[str, ...], ...]:
    """Return the texts that stand in files of a kind; one that counts is a tuple of two."""
    return tuple(
        message.id if isinstance(message.id, str) else tuple(message.id)
        for message in _read(template)
        if message.id and any(file.endswith(suffix) for file, _ in message.locations)
    )


def _read(path: Path) -> Catalog:
    """Return a catalogue in the language that its name says."""
    with path.open("rb") as file:
        return read_po(file, locale=None if path.suffix == ".pot" else path.stem)


def _render(catalogue: Catalog, omit_header: bool = False) -> bytes:
    """Return a catalogue as a file holds it."""
    content = BytesIO()
    write_po(
        content,
        catalogue,
        width=100,
        omit_header=omit_header,
        sort_by_file=True,
        include_lineno=False,
    )
    return content.getvalue()
