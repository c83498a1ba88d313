"""Read our files strictly: plain JSON objects that say what they are and in which version."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Collection
from typing import Any

from dmp_teach.errors import RecordingError, shown

# Six digits would be a date, or a number that was given to a person.
PSEUDONYM = re.compile(r"(?i:[a-z]|writer|pupil)[-_]?[0-9]{1,5}")


_STRING = re.compile(r'"(?:[^"\\]|\\.)*"', re.DOTALL)
_BRACKET = re.compile(r"[][{}]")
_DEEPEST = 100


# Any: JSON, in which every field is checked before it is used.
def parse_json(data: bytes) -> Any:
    """Return what JSON holds: numbers that are numbers, names that occur once, not too deep.

    Raises:
        ValueError: It is no such JSON.
    """
    text = data.decode("utf-8-sig")
    # A browser has little stack: deep JSON would end Python there.
    depth = 0
    for bracket in _BRACKET.findall(_STRING.sub("", text)):
        depth += 1 if bracket in "[{" else -1
        if depth > _DEEPEST:
            raise ValueError(f"more than {_DEEPEST} brackets within each other")
    return json.loads(text, parse_constant=_no_constant, object_pairs_hook=_once)


# Any: as above.
def loaded(
    data: bytes, kind: str, versions: Collection[int], fields: Collection[str]
) -> dict[str, Any]:
    """Return one of our objects with exactly its fields.

    Args:
        data: The file.
        kind: What its field `format` must say, such as "dmp_teach recording".
        versions: Those that can be read, the newest last.
        fields: The names of its fields.

    Raises:
        RecordingError: Not JSON, another format, an unknown version, or fields too many or too few.
    """
    try:
        content = parse_json(data)
    except ValueError as error:
        raise RecordingError(f"this is not plain JSON: {error}.") from None
    return checked_object(content, kind, versions, fields)


# Any: as above.
def checked_object(
    content: Any, kind: str, versions: Collection[int], fields: Collection[str]
) -> dict[str, Any]:
    """Return what was read from JSON, if it is one of our objects; all else as in `loaded`."""
    if not isinstance(content, dict) or content.get("format") != kind:
        raise RecordingError(f"this is not a {kind}: 'format' must be {kind!r}.")
    version, newest = content.get("version"), max(versions)
    if type(version) is not int or version not in versions:
        cure = "update dmp_teach" if type(version) is int and version > newest else "save it again"
        known = " and ".join(map(str, versions))
        raise RecordingError(
            f"version is {shown(version)}, but this program reads version {known}; {cure}."
        )
    odd = [name for name in (*fields, *content) if (name in fields) != (name in content)]
    if odd:
        names = ", ".join(map(str, odd))
        raise RecordingError(
            f"has fields too many or too few: {names[:200]}; there must be: {', '.join(fields)}."
        )
    return content


def must(holds: bool, name: str, value: object, rule: str) -> None:
    """Raise a RecordingError that shows the beginning of the value, unless the rule holds."""
    if not holds:
        raise RecordingError(f"{name} is {shown(value)}, but must be {rule}.")


def is_number(value: object) -> bool:
    """Tell whether a value is a finite number; True and False are none."""
    if isinstance(value, bool) or not isinstance(value, int | float):
        return False
    return abs(value) < 1e300 and math.isfinite(value)


def is_pseudonym(writer: str) -> bool:
    """Tell whether a text is a letter, "writer" or "pupil" with a number: "w01", and no name."""
    return PSEUDONYM.fullmatch(writer) is not None


def _no_constant(word: str) -> None:
    """Refuse NaN and Infinity, which JSON does not have."""
    raise ValueError(f"{word} is not a number")


def _once(pairs: list[tuple[str, object]]) -> dict[str, object]:
    """Return an object whose names occur once."""
    content = dict(pairs)
    if len(content) < len(pairs):
        raise ValueError("a name occurs twice in one object")
    return content
