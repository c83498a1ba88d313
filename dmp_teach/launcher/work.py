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
UNREADABLE = (ValueError, LookupError, TypeError, AttributeError)


def copy_lessons(source, work, fresh=()):
    """Bring the copies of the lessons up to date, and return the names of those that stay behind.

    A copy without a change follows ours; one that was changed stays, even where ours is newer, but
    for its strip of the lessons.

    Args:
        source: The folder of our own notebooks.
        work: The folder of the copies; made where it is missing.
        fresh: Beginnings of names, such as "03", of lessons that begin anew: what was changed in
            them is moved to the folder `EARLIER`.
    """
    work.mkdir(parents=True, exist_ok=True)
    given = _read_record(work / RECORD)
    names = sorted(path.name for path in source.glob("*.ipynb"))
    behind = []
    for name in names:
        copy, ours = work / name, _digest(source / name)
        own = _digest(copy) if copy.exists() else None
        if own not in (None, ours, given.get(name)):
            if not name.startswith(tuple(fresh)):
                behind += [name] if given.get(name) != ours else []
                _renew_strip(copy, names)
                continue
            _set_aside(copy)
        if own != ours or name.startswith(tuple(fresh)):
            _write_copy(source / name, copy, names)
        _renew_strip(copy, names)
        given[name] = ours
    _write_json(work / RECORD, given)
    return behind


def title_of(name):
    """Return the title of a lesson from its notebook's name: "03 Bump width"."""
    number, _, words = name[: -len(".ipynb")].partition("_")
    return "{} {}".format(number, words.replace("_", " ").capitalize())


def _read_record(path):
    """Return what was given, notebook -> digest; of a damaged record nothing is known."""
    try:
        given = json.loads(path.read_bytes().decode("utf-8"))
    except (OSError, ValueError):
        return {}
    return given if isinstance(given, dict) else {}


def _write_json(path, content):
    """Write a file beside its place, then move it there, so that no half of it ever lies there."""
    beside = path.with_name(path.name + ".part")
    try:
        beside.write_text(json.dumps(content, indent=1) + "\n", encoding="utf-8")
        beside.replace(path)
    finally:
        if beside.exists():
            beside.unlink()


def _write_copy(ours, copy, names):
    """Write a notebook, with a strip of all lessons above it, which works in every Jupyter."""
    notebook = json.loads(ours.read_text(encoding="utf-8"))
    if LESSON.match(copy.name):
        strip = {
            "cell_type": "markdown",
            "id": STRIP,
            "metadata": {"dmp_teach": STRIP, "editable": False},
            "source": [_links(copy.name, names)],
        }
        notebook["cells"].insert(0, strip)
    _write_json(copy, notebook)


def _renew_strip(copy, names):
    """Let the strip of a copy show the lessons of today; the cells of a pupil stay as they are."""
    links = _links(copy.name, names)
    try:
        notebook = json.loads(copy.read_bytes().decode("utf-8"))
        strips = [cell for cell in notebook["cells"] if _is_strip(cell)]
        old = [cell for cell in strips if "".join(cell["source"]) != links]
    except UNREADABLE:
        return
    for cell in old:
        cell["source"] = [links]
    if old:
        _write_json(copy, notebook)


def _links(own, names):
    """Return links to all lessons in Markdown; its own is bold."""
    return " · ".join(
        ("**{}**" if name == own else "[{}]({})").format(title_of(name), name)
        for name in names
        if LESSON.match(name)
    )


def _is_strip(cell):
    """Tell whether a cell is ours."""
    return cell["metadata"].get("dmp_teach") == STRIP


def _digest(path):
    """Return a digest of what is written in a notebook: outputs do not count, nor does the strip.

    What cannot be read as a notebook counts byte for byte.
    """
    content = path.read_bytes()
    try:
        cells = json.loads(content.decode("utf-8"))["cells"]
        written = [
            (cell["cell_type"], "".join(cell["source"])) for cell in cells if not _is_strip(cell)
        ]
        content = json.dumps(written).encode()
    except UNREADABLE:
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
