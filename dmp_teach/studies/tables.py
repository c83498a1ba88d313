"""Tables of a study's rows: as text, and as HTML in a notebook."""

from __future__ import annotations

import html
from abc import abstractmethod
from collections.abc import Iterable, Mapping, Sequence
from textwrap import wrap
from typing import Any, ClassVar

import numpy as np

from dmp_teach.values import Value, shortened

# One mapping for each row, all with the same keys; units stand in the keys. Any: a cell may hold
# words, numbers or several of them, here and below.
TableRows = tuple[Mapping[str, Any], ...]
# The values of each column by its head, which says the unit.
Columns = Mapping[str, Iterable[Any]]


class Tabled(Value):
    """A dataclass of locked arrays that is shown as a table of its `columns`."""

    COLUMN_WIDTHS: ClassVar[Mapping[str, int]] = {}
    STYLES: ClassVar[Mapping[str, str]] = {}

    @property
    @abstractmethod
    def columns(self) -> Columns:
        """What the table shows."""

    def rows(self) -> TableRows:
        """Return one mapping for each row."""
        columns = self.columns
        plain = [v.tolist() if isinstance(v, np.ndarray) else v for v in columns.values()]
        return tuple(dict(zip(columns, row, strict=True)) for row in zip(*plain, strict=True))

    def table(self) -> str:
        """Return the rows as a table in plain text."""
        return text_table(self.rows(), self.COLUMN_WIDTHS)

    def __str__(self) -> str:
        return self.table()

    def __repr__(self) -> str:
        columns = shortened(", ".join(self.columns))
        n = len(self.rows())
        return f"{type(self).__name__}({n} row{'s' * (n != 1)}: {columns})"

    def _repr_html_(self) -> str:
        """Return the rows as a table in a notebook."""
        return html_table(self.rows(), self.STYLES)


def text_table(rows: TableRows, widths: Mapping[str, int]) -> str:
    """Return rows with the same keys in aligned columns.

    Where `widths` has any, columns are broken there, and an empty line parts the rows.
    """
    if not rows:
        return "(no rows)"
    heads = list(rows[0])
    cells = [[_cell(head, widths.get(head)) for head in heads]]
    cells += [[_cell(row[head], widths.get(head)) for head in heads] for row in rows]
    wide = [max(len(line) for row in cells for line in row[k]) for k in range(len(heads))]
    right = [all(isinstance(row[head], int | float) for row in rows) for head in heads]
    lines = []
    for number, row in enumerate(cells):
        if widths and number > 1:
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


def html_table(rows: TableRows, styles: Mapping[str, str]) -> str:
    """Return rows as an HTML table; `styles` gives some words a style of their own."""
    if not rows:
        return "<p>(no rows)</p>"

    def row_of(tag: str, values: Sequence[Any]) -> str:
        cells = (
            f'<{tag} style="text-align:left;vertical-align:top;{styles.get(str(value), "")}">'
            f"{html.escape(cell_text(value))}</{tag}>"
            for value in values
        )
        return f"<tr>{''.join(cells)}</tr>"

    body = "".join(row_of("td", list(row.values())) for row in rows)
    return f"<table><thead>{row_of('th', list(rows[0]))}</thead><tbody>{body}</tbody></table>"


def cell_text(value: Any) -> str:
    """Return a cell: numbers with four digits."""
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, float):
        return f"{value:.4g}"
    if isinstance(value, Sequence) and not isinstance(value, str):
        return ", ".join(map(cell_text, value))
    return str(value)


def _cell(value: Any, width: int | None) -> list[str]:
    """Return a cell as lines."""
    return (wrap(cell_text(value), width) or [""]) if width else [cell_text(value)]
