"""Scripts and styles, joined as anywidget and the saved page want them."""

from __future__ import annotations

import re
from pathlib import Path

_IMPORT = re.compile(r'^import (\{[^}]*\}) from "(\.[^"]+)";$', re.MULTILINE)
_EXPORT = re.compile(r"^export (?=(?:async )?(?:function|class|const) (\w+))", re.MULTILINE)
_COMMENT = re.compile(r"^ *(?://[^\n]*|/\*\*(?:(?!\*/).)*\*/)\n", re.MULTILINE | re.DOTALL)
_DEFAULT = re.compile(r"^export default .*;\n", re.MULTILINE)


def join_modules(entry: Path) -> str:
    """Return an ES module with all that it imports in front of it, each in a scope of its own.

    This reads `import { a, b as c } from "./place.js";` and `export` before a function, class or
    const. The default export is the entry's alone, and lines that are comments are left out.

    Raises:
        ValueError: A circle of imports, or an import or export of another form.
    """
    homes: dict[Path, str] = {}
    scopes: list[str] = []

    def read(path: Path, above: tuple[Path, ...]) -> str:
        """Return a module's text, whose imports take from the scopes before it."""
        if path in above:
            circle = " -> ".join(each.name for each in (*above, path))
            raise ValueError(f"Modules import each other: {circle}.")

        def taken(found: re.Match[str]) -> str:
            names, place = found.groups()
            home = scope((path.parent / place).resolve(), (*above, path))
            return f"const {names.replace(' as ', ': ')} = {home};"

        text = _COMMENT.sub("", path.read_text(encoding="utf-8"))
        return _without("import", _IMPORT.sub(taken, text), path)

    def scope(path: Path, above: tuple[Path, ...]) -> str:
        """Return the name under which a module's exports stand."""
        if path not in homes:
            text = _DEFAULT.sub("", read(path, above))
            names, text = ", ".join(_EXPORT.findall(text)), _EXPORT.sub("", text)
            text = _without("export", text, path)
            homes[path] = f"$module{len(homes) + 1}"
            scopes.append(f"const {homes[path]} = (() => {{\n{text}return {{ {names} }};\n}})();\n")
        return homes[path]

    last = read(entry.resolve(), ())
    return "".join([*scopes, last])


def join_styles(*paths: Path) -> str:
    """Return style sheets as one, in this order."""
    return "\n".join(path.read_text(encoding="utf-8") for path in paths)


def _without(word: str, text: str, path: Path) -> str:
    """Return the text, in which no line may begin with a word."""
    if left := re.search(rf"^{word}\b.*", text, re.MULTILINE):
        raise ValueError(f"{path.name} cannot be joined: {left.group()}")
    return text
