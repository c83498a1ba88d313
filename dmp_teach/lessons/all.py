"""Every lesson by its number: a module of this room that defines one is found."""

from __future__ import annotations

from functools import cache
from importlib import import_module
from pkgutil import iter_modules

from dmp_teach.classroom import Lesson, Verdict
from dmp_teach.errors import SettingError, shown

_PACKAGE = __name__.rpartition(".")[0]


@cache
def lessons() -> dict[str, type[Lesson]]:
    """Return every lesson by its number, such as "03", in order."""
    package = import_module(_PACKAGE)
    for module in iter_modules(package.__path__):
        import_module(f"{_PACKAGE}.{module.name}")
    return {each.key: each for each in sorted(_all(Lesson), key=lambda each: each.key)}


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
    for each in lessons().values():
        if key in (each.key, each.slug):
            return each(pupil)
    known = ", ".join(f"{each.key!r} ({each.slug})" for each in lessons().values())
    raise SettingError(f"There is no lesson {shown(key)}; there are: {known}.")


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


def _all(kind: type[Lesson]) -> list[type[Lesson]]:
    """Return every subclass that has a number, and theirs."""
    below = [kind, *(each for sub in kind.__subclasses__() for each in _all(sub))]
    return [each for each in below if hasattr(each, "key")]
