"""Rows that a student can read: as text, and as HTML in a notebook."""

from __future__ import annotations

import html
from collections.abc import Mapping, Sequence
from textwrap import wrap
from typing import Any

Rows = tuple[Mapping[str, Any], ...]


class Tabled:
    """A value that has `rows()`: mappings with the same keys, units in the keys."""

    def rows(self) -> Rows:
        """One mapping for each row."""
        raise NotImplementedError

    def table(self) -> str:
        """The rows as a table in plain text."""
        return text_table(self.rows())

    def __str__(self) -> str:
        return self.table()

    def _repr_html_(self) -> str:
        """The rows as a table in a notebook."""
        return html_table(self.rows())


def text_table(rows: Rows, widths: Mapping[str, int] | None = None, apart: bool = False) -> str:
    """Rows in aligned columns; `widths` says where the words of a column are broken, `apart` puts a line between."""
    if not rows:
        return "(no rows)"
    heads = list(rows[0])
    cells = [[_broken(head, widths, head) for head in heads]]
    cells += [[_broken(row[head], widths, head) for head in heads] for row in rows]
    wide = [max(len(line) for row in cells for line in row[k]) for k in range(len(heads))]
    right = [all(isinstance(row[head], (int, float)) for row in rows) for head in heads]
    lines = []
    for number, row in enumerate(cells):
        if apart and number > 1:
            lines.append("")
        for k in range(max(map(len, row))):
            words = [cell[k] if k < len(cell) else "" for cell in row]
            aligned = [
                w.rjust(n) if r else w.ljust(n) for w, n, r in zip(words, wide, right, strict=True)
            ]
            lines.append("  ".join(aligned).rstrip())
        if number == 0:
            lines.append("  ".join("-" * n for n in wide))
    return "\n".join(lines)


def html_table(rows: Rows, marks: Mapping[str, str] | None = None) -> str:
    """Rows as an HTML table; `marks` gives words their own style."""
    if not rows:
        return "<p>(no rows)</p>"
    left = "text-align:left;vertical-align:top"
    head = "".join(f'<th style="{left}">{html.escape(name)}</th>' for name in rows[0])
    body = ""
    for row in rows:
        cells = [(shown(value), (marks or {}).get(str(value), "")) for value in row.values()]
        body += (
            "<tr>"
            + "".join(f'<td style="{left};{mark}">{html.escape(cell)}</td>' for cell, mark in cells)
            + "</tr>"
        )
    return f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"


def shown(value: Any) -> str:
    """A cell: numbers with four digits."""
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, float):
        return f"{value:.4g}"
    if isinstance(value, Sequence) and not isinstance(value, str):
        return ", ".join(map(shown, value))
    return str(value)


def _broken(value: Any, widths: Mapping[str, int] | None, head: str) -> list[str]:
    """A cell as lines."""
    text = shown(value)
    return (wrap(text, widths[head]) or [""]) if widths and head in widths else [text]
