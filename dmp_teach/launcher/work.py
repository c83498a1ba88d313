"""The work folder: copies of the lessons, which a pupil may change and a new version may not.

Standard library only, in the syntax of Python 3.6, as the launcher.
"""

import hashlib
import json
import re
import time

# What was given to a pupil, notebook -> digest: it tells a change from an older version.
RECORD = ".lessons.json"
EARLIER = "earlier"
LESSON = re.compile(r"\d\d_\w+\.ipynb")
# The cell that we put above a lesson.
STRIP = "lessons"


def copy_lessons(source, work, fresh=()):
    """Bring the copies of the lessons up to date, and return the names of those that stay behind.

    A copy without a change follows ours; one that was changed stays, even where ours is newer.

    Args:
        source: The folder of our own notebooks.
        work: The folder of the copies; made where it is missing.
        fresh: Beginnings of names, such as "03", of lessons that begin anew: what was changed in
            them is moved to the folder `EARLIER`.
    """
    work.mkdir(parents=True, exist_ok=True)
    record = work / RECORD
    given = json.loads(record.read_text(encoding="utf-8")) if record.exists() else {}
    names = sorted(path.name for path in source.glob("*.ipynb"))
    behind = []
    for name in names:
        copy, ours = work / name, _digest(source / name)
        own = _digest(copy) if copy.exists() else None
        if own not in (None, ours, given.get(name)):
            if not name.startswith(tuple(fresh)):
                behind += [name] if given.get(name) != ours else []
                continue
            _set_aside(copy)
        if own != ours or name.startswith(tuple(fresh)):
            _write_copy(source / name, copy, names)
        given[name] = ours
    record.write_text(json.dumps(given, indent=1), encoding="utf-8")
    return behind


def title_of(name):
    """Return the title of a lesson from its notebook's name: "03 Bump width"."""
    number, _, words = name[: -len(".ipynb")].partition("_")
    return "{} {}".format(number, words.replace("_", " ").capitalize())


def _write_copy(ours, copy, names):
    """Write a notebook, with a strip of all lessons above it, which works in every Jupyter."""
    notebook = json.loads(ours.read_text(encoding="utf-8"))
    lessons = [name for name in names if LESSON.match(name)]
    if copy.name in lessons:
        links = [
            "**{}**".format(title_of(name))
            if name == copy.name
            else "[{}]({})".format(title_of(name), name)
            for name in lessons
        ]
        strip = {
            "cell_type": "markdown",
            "id": STRIP,
            "metadata": {"dmp_teach": STRIP, "editable": False},
            "source": [" · ".join(links)],
        }
        notebook["cells"].insert(0, strip)
    copy.write_text(json.dumps(notebook, indent=1) + "\n", encoding="utf-8")


def _digest(path):
    """Return a digest of what is written in a notebook: outputs do not count, nor does the strip.

    What cannot be read as a notebook counts byte for byte.
    """
    content = path.read_bytes()
    try:
        cells = json.loads(content.decode("utf-8"))["cells"]
        written = [
            (cell["cell_type"], "".join(cell["source"]))
            for cell in cells
            if cell["metadata"].get("dmp_teach") != STRIP
        ]
        content = json.dumps(written).encode()
    except (ValueError, LookupError, TypeError, AttributeError):
        pass
    return hashlib.sha256(content).hexdigest()


def _set_aside(copy):
    """Move a copy to the folder of earlier ones, under a name with the time that is free."""
    folder = copy.parent / EARLIER
    folder.mkdir(exist_ok=True)
    stem = copy.stem + time.strftime("_%Y-%m-%d_%H-%M-%S")
    place, n = folder / (stem + copy.suffix), 1
    while place.exists():
        place, n = folder / "{}_{}{}".format(stem, n, copy.suffix), n + 1
    copy.rename(place)
