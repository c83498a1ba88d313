"""The pages of the docs that are made: lessons with what they show, the API, the gallery."""

from __future__ import annotations

import ast
import html
import inspect
import io
import json
from collections.abc import Iterable
from contextlib import redirect_stdout
from importlib import import_module
from pathlib import Path

from dmp_teach.ink import recording_of
from dmp_teach.letters import Letter
from dmp_teach.robot import Fetch, Page
from dmp_teach.views import figure, view

# Tells the page around it how tall it is.
_MEASURED = """<script type="module">
const view = document.getElementById("view");
const tell = () => parent.postMessage({ height: view.getBoundingClientRect().bottom + 12 }, "*");
new ResizeObserver(tell).observe(view);
</script>
</body>"""
_FRAME = """```{{raw}} html
<iframe class="live" src="../{name}" title="{title}" loading="lazy"></iframe>
<p class="alone"><a href="../{name}">In a window of its own</a></p>
```"""
_FOLDED = """```{{raw}} html
<details class="why"><summary>{title}</summary>
```
{told}
```{{raw}} html
</details>
```"""
_WRITTEN = ("a", "P", "8")
_PACKAGE = Path(__file__).resolve().parent.parent


class PageWriter:
    """Write pages below a folder, and in its folder `live` what lives in them."""

    def __init__(self, source: Path) -> None:
        self._source = source

    def write_lesson(self, notebook: Path) -> str:
        """Run a notebook, write it with what its cells show, and return the page's name."""
        names: dict[str, object] = {}
        parts = []
        for cell in json.loads(notebook.read_text(encoding="utf-8"))["cells"]:
            text = "".join(cell["source"])
            if cell["cell_type"] == "code":
                printed, value = _run(text, names)
                parts.append(f"```python\n{text}\n```")
                parts += [f"```text\n{printed.rstrip()}\n```"] if printed else []
                name = f"{notebook.stem}_{cell['id']}"
                parts += [] if value is None else self._show(value, name)
            elif cell["id"] == "why":  # it would give away the bet
                title, told = text.removeprefix("## ").split("\n", 1)
                parts.append(_FOLDED.format(title=title, told=told))
            elif cell["id"] != "begin":
                parts.append(text)
        return self._write(f"lessons/{notebook.stem}.md", parts)

    def write_gallery(self, figures: Iterable[int] = range(1, 11)) -> str:
        """Write how the robot writes, and the paper's figures, all by letters of our own."""
        parts = ["# Gallery", "One line draws each of them, from letters of our own."]
        parts.append("## The robot writes")
        for letter in _WRITTEN:
            strokes = Letter.learn(recording_of(letter)).write()
            motion = Fetch().write(strokes, Page.table())
            parts += [f"### {letter}", "`teach.view(motion)`"]
            parts += self._show(view(motion), f"robot_{ord(letter)}")
        parts.append("## The paper's figures")
        told = " ".join((inspect.getdoc(figure) or "").split("\n\n")[1].split())
        shown = dict(each.split(" ", 1) for each in told.split(". Figures")[0].split("; "))
        for number in figures:
            parts += [f"### Figure {number}: {shown[str(number)]}", f"`teach.figure({number})`"]
            parts += self._show(figure(number), f"figure_{number}")
        return self._write("gallery/index.md", parts)

    def write_api(self) -> list[str]:
        """Write a page a room, `teach`'s own names first, and return the names of the pages."""
        told: set[int] = set()
        front = import_module("dmp_teach")
        homes = {name: getattr(getattr(front, name), "__module__", "") for name in dir(front)}
        rooms = {home.split(".")[1] for home in homes.values() if home}
        rooms |= {path.parent.name for path in _PACKAGE.glob("*/__init__.pyi")}
        pages = []
        for room in sorted(rooms):
            place = f"dmp_teach.{room}"
            parts = [_title(place, "="), f".. automodule:: {place}\n   :no-members:"]
            own = [name for name, home in homes.items() if f"{home}.".startswith(f"{place}.")]
            parts += _describe("dmp_teach", front, own, told)
            faces = {place: import_module(place)}
            faces |= {"dmp_teach.figures": front.figures} if room == "views" else {}
            for name, face in faces.items():
                rest = _describe(name, face, getattr(face, "__all__", ()), told)
                parts += [_title(f"In {name}", "-"), *rest] if rest else []
            pages.append(self._write(f"api/{room}.rst", parts))
        return pages

    def _show(self, value: object, name: str) -> list[str]:
        """Return the Markdown that shows a value: alive, as a picture, a table or a text."""
        if hasattr(value, "savefig"):
            path = self._source / "pictures" / f"{name}.svg"
            path.parent.mkdir(exist_ok=True)
            value.savefig(path)
            return [f"![What the line above draws](../pictures/{path.name})"]
        if hasattr(value, "html"):
            path = self._source / "live" / f"{name}.html"
            path.parent.mkdir(exist_ok=True)
            page = value.html(path).read_text(encoding="utf-8")
            path.write_text(page.replace("</body>", _MEASURED), encoding="utf-8")
            title = html.escape(getattr(value, "title", "") or "A robot writes")
            return [_FRAME.format(name=path.name, title=title)]
        if hasattr(value, "_repr_html_"):
            return [f'```{{raw}} html\n<div class="shown">{value._repr_html_()}</div>\n```']
        if hasattr(value, "comm"):
            return ["*This part lives in a notebook.*"]
        return [f"```text\n{value!r}\n```"]

    def _write(self, name: str, parts: list[str]) -> str:
        path = self._source / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text("\n\n".join(parts) + "\n", encoding="utf-8")
        return name.rpartition(".")[0]


def _run(code: str, names: dict[str, object]) -> tuple[str, object]:
    """Run a cell, and return what it prints and the value of its last line."""
    tree = ast.parse(code)
    last, value = tree.body[-1], None
    printed = io.StringIO()
    with redirect_stdout(printed):
        if isinstance(last, ast.Expr):
            tree.body.pop()
        exec(compile(tree, "cell", "exec"), names)
        if isinstance(last, ast.Expr):
            value = eval(compile(ast.Expression(last.value), "cell", "eval"), names)
    return printed.getvalue(), value


def _title(text: str, line: str) -> str:
    return f"{text}\n{line * len(text)}"


def _describe(place: str, face: object, names: Iterable[str], told: set[int]) -> list[str]:
    """Return the directives that describe names of a face, each thing once."""
    parts = []
    for name in sorted(names):
        thing = getattr(face, name)
        if id(thing) not in told:
            told.add(id(thing))
            kind = "autofunction" if inspect.isroutine(thing) else "py:data"
            kind = "autoclass" if inspect.isclass(thing) else kind
            parts.append(f".. {kind}:: {place}.{name}")
    return parts
