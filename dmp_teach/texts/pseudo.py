"""A language made by a function: a text that has not been translated is seen at once."""

from __future__ import annotations

import re
from gettext import NullTranslations

_ACCENTS = str.maketrans("aceinosuyzACEINOSUYZ", "áčéíñöšüýžÁČÉÍÑÖŠÜÝŽ")
_PLACEHOLDER = re.compile(r"(\{[^}]*\})")
_WORD = re.compile(r"[^\W\d_]+")
# By so much translations from English are longer.
_LONGER = 0.35


def _lengthen(word: re.Match[str]) -> str:
    """Return a word with its accents, and longer."""
    return word.group().translate(_ACCENTS) + "~" * round(_LONGER * len(word.group()))


class PseudoTranslations(NullTranslations):
    """English with accents, a third longer and in brackets; placeholders stay."""

    def gettext(self, message: str) -> str:
        """Return a text as it is in the pseudo-language."""
        parts = _PLACEHOLDER.split(message)
        parts[::2] = [_WORD.sub(_lengthen, part) for part in parts[::2]]
        return f"[{''.join(parts)}]"

    def ngettext(self, msgid1: str, msgid2: str, n: int) -> str:
        """Return one of two texts as it is in the pseudo-language."""
        return self.gettext(msgid1 if n == 1 else msgid2)
