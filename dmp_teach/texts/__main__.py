"""Bring the catalogue up to date with the code: `python -m dmp_teach.texts [language ...]`.

The template gets every text of the code, and the files of all languages get what is new in it; a
language that is named has its file begun.
"""

from __future__ import annotations

import sys

from dmp_teach.texts.catalogue import extract_texts, update_language
from dmp_teach.texts.language import FOLDER, TEMPLATE

TEMPLATE.write_bytes(extract_texts())
for path in {*FOLDER.glob("*.po"), *(FOLDER / f"{name}.po" for name in sys.argv[1:])}:
    update_language(path, TEMPLATE)
