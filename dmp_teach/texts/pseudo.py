"""A language made by a function: a text that has not been translated is seen at once."""

from __future__ import annotations

import re
from gettext import NullTranslations

_ACCENTS = str.maketrans("aceinosuyzACEINOSUYZ", "áčéíñöšüýžÁČÉÍÑÖŠÜÝŽ")
_PLACEHOLDER = re.compile(r"(\{[^}]*\})")
# By so much translations from English are longer.
_LONGER = 0.3


class PseudoTranslations(NullTranslations):
    """English with accents, a third longer and in brackets; placeholders stay."""

    def gettext(self, message: str) -> str:
        """Return a text as it is in the pseudo-language."""
        parts = _PLACEHOLDER.split(message)
        letters = sum(map(len, parts[::2]))
        parts[::2] = [part.translate(_ACCENTS) for part in parts[::2]]
        return f"[{''.join(parts)}{'~' * round(_LONGER * letters)}]"

    def ngettext(self, msgid1: str, msgid2: str, n: int) -> str:
        """Return one of two texts as it is in the pseudo-language."""
        return self.gettext(msgid1 if n == 1 else msgid2)
