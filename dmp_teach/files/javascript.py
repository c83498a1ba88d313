"""Join ES modules into the one file that anywidget wants: dependencies first, without their import and export."""

from __future__ import annotations

import re
from pathlib import Path

IMPORT = re.compile(r'^import \{[^}]*\} from "\./([\w.-]+)";\n', re.MULTILINE)


def bundle(entry: Path) -> str:
    """Return `entry` and the modules it imports as one ES module.

    Raises:
        ValueError: Modules that import each other in a circle; names them.
    """
    joined: list[str] = []
    done: set[Path] = set()

    def visit(path: Path, above: tuple[Path, ...] = ()) -> None:
        if path in above:
            raise ValueError(
                f"Modules import each other: {' -> '.join(p.name for p in (*above, path))}."
            )
        if path in done:
            return
        done.add(path)
        text = path.read_text(encoding="utf-8")
        for name in IMPORT.findall(text):
            visit(path.parent / name, (*above, path))
        text = IMPORT.sub("", text)
        joined.append(
            text if path == entry else re.sub(r"^export (?!default)", "", text, flags=re.MULTILINE)
        )

    visit(entry)
    return "\n".join(joined)
