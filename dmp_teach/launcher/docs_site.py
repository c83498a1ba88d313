"""The docs as a site: what is written in `docs`, lessons that live, the API, a gallery.

`python3 -m dmp_teach docs FOLDER` runs this in the launcher's environment. It fetches Sphinx with
pip, once, beside the environment.
"""

from __future__ import annotations

import os
import re
import shutil
import sys
from collections.abc import Iterable, Sequence
from pathlib import Path

from dmp_teach.errors import SetupError
from dmp_teach.launcher.docs_pages import PageWriter
from dmp_teach.launcher.lab import NOTEBOOKS, ROOT, say
from dmp_teach.launcher.site_packages import call
from dmp_teach.launcher.static_site import CACHE, check_folder, install_tools

_PAGE = Path(__file__).resolve().parent / "docs_page"
_LINK = re.compile(r"\[([^\]]*)\]\(([^)#:\s]+)\)")
_MARK = ".buildinfo"


def tell_docs(folder: Path) -> int:
    """Make the site, say where it is, and return the exit code."""
    try:
        make_docs(folder)
    except SetupError as error:
        sys.stderr.write(f"{error}\n")
        return 1
    say(f"The docs are in {folder}: open {folder / 'index.html'}")
    return 0


def make_docs(
    folder: Path,
    lessons: Sequence[Path] | None = None,
    figures: Iterable[int] = range(1, 11),
    cache: Path = CACHE,
) -> None:
    """Make the site in a folder that is new, empty or an older site.

    Args:
        folder: Where to.
        lessons: The notebooks that become pages; None takes all.
        figures: The paper's figures that are in the gallery, by their numbers.
        cache: Where what is fetched and made is kept.

    Raises:
        SetupError: The folder holds something else, or a part could not be fetched or built.
    """
    check_folder(folder, _MARK)
    tools, source, made = (cache / name for name in ("docs_tools", "docs_source", "docs_made"))
    install_tools(tools, _PAGE / "tools.txt")
    for old in (source, made):
        shutil.rmtree(old, ignore_errors=True)
    shutil.copytree(_PAGE, source, ignore=shutil.ignore_patterns("tools.txt"))
    say("Running the lessons and drawing the figures ...")
    writer = PageWriter(source)
    found = sorted(NOTEBOOKS.glob("*.ipynb")) if lessons is None else lessons
    pages = {"Lessons": [writer.write_lesson(each) for each in found]}
    pages["What it draws"] = [writer.write_gallery(figures), "docs/benchmarks"]
    pages |= copy_texts(source)
    pages["API"] = writer.write_api()
    index = [f"```{{toctree}}\n:hidden:\n:caption: {name}\n\n" + "\n".join(each) + "\n```"
             for name, each in pages.items()]  # fmt: skip
    with (source / "index.md").open("a", encoding="utf-8") as home:
        home.write("\n" + "\n\n".join(index) + "\n")
    say("Building the site ...")
    build = [sys.executable, "-m", "sphinx", "-q", "-W", "--keep-going", "-j", "auto"]
    environment = dict(os.environ, PYTHONPATH=os.pathsep.join([str(ROOT), str(tools)]))
    call([*build, str(source), str(made)], env=environment)
    shutil.rmtree(made / ".doctrees", ignore_errors=True)
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(made, folder)


def copy_texts(source: Path) -> dict[str, list[str]]:
    """Copy what is written by hand, with the files it links, and return its pages by caption."""
    engineers = sorted((ROOT / "docs").glob("add_*.md"))
    engineers += [ROOT / "CONTRIBUTING.md", ROOT / "CHANGELOG.md"]
    engineers += [ROOT / "dmp_teach" / "dmp" / "README.md", ROOT / "assets" / "LICENSE.md"]
    teachers = [path for path in sorted((ROOT / "docs").glob("*.md")) if path not in engineers]
    for path in (ROOT / "README.md", *teachers, *engineers):
        _copy(path, source / path.relative_to(ROOT), source)
    (source / "README.md").rename(source / "index.md")
    names = {path: str(path.relative_to(ROOT).with_suffix("")) for path in teachers + engineers}
    return {
        "For a teacher": [names[path] for path in teachers if path.stem != "benchmarks"],
        "For an engineer": [names[path] for path in engineers],
    }


def _copy(text: Path, to: Path, source: Path) -> None:
    """Copy a text and the files that it links; a link to a folder becomes its words."""

    def link(found: re.Match[str]) -> str:
        target = (text.parent / found[2]).resolve()
        if target.is_file() and target.suffix != ".md":
            copied = source / target.relative_to(ROOT)
            copied.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(target, copied)
        return found[1] if target.is_dir() else found[0]

    to.parent.mkdir(parents=True, exist_ok=True)
    words = _LINK.sub(link, text.read_text(encoding="utf-8"))
    to.write_text(words, encoding="utf-8")


if __name__ == "__main__":
    sys.exit(tell_docs(Path(sys.argv[1]).resolve()))
