"""Every lesson by its number. Only the module of the one that is asked for is imported."""

from __future__ import annotations

from importlib import import_module
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING

from dmp_teach.arguments import checked
from dmp_teach.classroom import Lesson, Verdict
from dmp_teach.errors import PathError, SettingError, shown

if TYPE_CHECKING:
    from dmp_teach.classroom import ClassOverview

_PACKAGE = __name__.rpartition(".")[0]
# The modules of the lessons, from number "00".
_ORDER = [
    "start_here",
    "spring_to_goal",
    "teach_a_letter",
    "bump_width",
    "how_many_bumps",
    "move_goal",
    "pen_up",
    "new_letters",
    "robot_writes",
    "teach_the_robot",
    "be_a_scientist",
    "reading_a_paper",
    "other_ways",
]


def lessons() -> dict[str, str]:
    """Return the name of every lesson by its number, such as "03", in order."""
    return {f"{number:02d}": name for number, name in enumerate(_ORDER)}


@checked
def lesson(key: str, pupil: str | None = None) -> Lesson:
    """Return a lesson.

        teach.lesson("03").panel()

    Args:
        key: Its number, "03", or its name, "bump_width".
        pupil: A pseudonym: letters, target and start of the challenge follow from it, so that
            neighbours cannot copy numbers. None: the same for all.

    Raises:
        SettingError: There is no such lesson.
        RecordingError: The pupil is no pseudonym.
    """
    for number, name in lessons().items():
        if key in (number, name):
            return _import_lesson(name)(pupil)
    known = ", ".join(f"{number!r} ({name})" for number, name in lessons().items())
    raise SettingError(f"There is no lesson {shown(key)}; there are: {known}.")


@checked
def check(key: str, answer: object, pupil: str | None = None, hints: int = 0) -> Verdict:
    """Judge the answer to the challenge of a lesson, without a browser.

        teach.check("03", panel.answer)

    Args:
        key: The lesson, "03".
        answer: What a panel's `.answer` holds: a value for each name of the lesson's `.settable`.
        pupil: The pseudonym that the lesson was opened with.
        hints: How many hints were seen; the next is given.

    Raises:
        SettingError: There is no such lesson, or hints is no whole number. A bad answer raises
            nothing: the verdict says why.
    """
    return lesson(key, pupil).check(answer, hints)


def class_overview(folder: str | PathLike[str]) -> ClassOverview:
    """Read what a class has saved: who is where, what is hard, and the spread of bets.

        teach.class_overview("class_7b").html("class_7b.html")

    Args:
        folder: With the files that *Save* writes, `work_w01.json` and `a_w01.json`, or with such
            a folder for each pupil, as a hub's homes. A check counts as passed where the file
            says so: `check` judges an answer.

    Raises:
        PathError: There is no such folder.
    """
    # Whoever opens a lesson does not wait for it.
    from dmp_teach.classroom import ClassOverview, read_class  # noqa: PLC0415

    try:
        place = Path(folder).expanduser()
        is_there = place.is_dir()
    except (OSError, RuntimeError, TypeError, ValueError):
        is_there = False
    if not is_there:
        raise PathError(f"There is no folder {shown(folder)}; give the one with the pupils' files.")
    pupils, notes = read_class(place)
    found = {}
    for number, name in lessons().items():
        if any(number in pupil.lessons for pupil in pupils):
            content = _import_lesson(name)()
            found[number] = (content.question, content.bet)
    return ClassOverview(tuple(pupils), found, tuple(notes))


def _import_lesson(name: str) -> type[Lesson]:
    """Return the lesson of a module: its class with a key."""
    module = vars(import_module(f"{_PACKAGE}.{name}")).values()
    return next(each for each in module if isinstance(each, type) and hasattr(each, "key"))
