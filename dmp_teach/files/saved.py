"""Values as files of plain JSON: whole or not at all, and refused where they were touched since."""

from __future__ import annotations

import hashlib
import json
import re
from collections.abc import Iterable
from dataclasses import fields
from itertools import count
from os import PathLike
from pathlib import Path
from typing import Any, ClassVar, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from dmp_teach.arguments import as_numbers
from dmp_teach.errors import LetterError, RecordingError, TeachError
from dmp_teach.files.reading import contents
from dmp_teach.files.strict_json import PSEUDONYM, loaded
from dmp_teach.files.writing import write_whole

SAVED_VERSION = 1
# What a study calls a writer who has no pseudonym, "2", or the second letter of one, "w01.2".
_NO_NAME = re.compile(rf"(?:{PSEUDONYM.pattern})(?:\.[0-9]{{1,3}})?|[0-9]{{1,3}}")


class Saved:
    """The base of dataclasses that are saved in a file: no code in it, and no names of people.

    The file is one JSON object: `format`, `version`, what `extra_fields` lists, the fields of the
    dataclass, and `check`, a sum of all that.
    """

    # What a file holds, "letter", and what in it is no field of the dataclass.
    file_kind: ClassVar[str]
    extra_fields: ClassVar[tuple[str, ...]] = ()

    def save(self, path: str | PathLike[str]) -> Path:
        """Save it in a file of plain JSON, whole or not at all.

        Raises:
            PathError: A name that does not end with .json, or a place that cannot be written.
        """
        content = {"format": f"dmp_teach {self.file_kind}", "version": SAVED_VERSION}
        content |= self._to_json()
        content["check"] = check_sum(content)
        lines = [f"{json.dumps(name)}: {json.dumps(value)}" for name, value in content.items()]
        return write_whole(path, ("{\n" + ",\n".join(lines) + "\n}\n").encode(), ".json")

    @classmethod
    def load(cls, path: str | PathLike[str]) -> Self:
        """Load what was saved: it writes as it did, to the last bit.

        Raises:
            LetterError: No such file, another version, a file that was changed, or a wrong field.
        """
        kind, name, own = cls.file_kind, "", [each.name for each in fields(cls)]  # type: ignore[arg-type]
        try:
            data, name = contents(path)
            wanted = ("format", "version", *cls.extra_fields, *own, "check")
            content = loaded(data, f"dmp_teach {kind}", (SAVED_VERSION,), wanted)
            if content.pop("check") != check_sum(content):
                raise LetterError("it was changed after it was saved, or damaged; save again.")
            return cls._from_json(content)
        except TeachError as error:
            raise LetterError(f"{name}: {error}" if name else str(error)) from None
        except (ArithmeticError, AttributeError, LookupError, TypeError, ValueError) as error:
            raise LetterError(
                f"{name}: this is no {kind} as {cls.__name__}.save writes it: {error}."
            ) from None

    # Any: what JSON holds.
    def _to_json(self) -> dict[str, Any]:
        """Return the file's fields."""
        raise NotImplementedError

    # Any: as above.
    @classmethod
    def _from_json(cls, content: dict[str, Any]) -> Self:
        """Return the value of a file's fields, each of them checked; any error says that none is.

        Format, version and check are right already.
        """
        raise NotImplementedError


# Any: as above.
def check_sum(content: dict[str, Any]) -> str:
    """Return a number that changes with every character of the content."""
    return hashlib.sha256(json.dumps(content, sort_keys=True).encode()).hexdigest()


def array_from_json(name: str, value: ArrayLike, shape: tuple[int, ...]) -> NDArray[np.float64]:
    """Return finite numbers of this shape, or raise a RecordingError."""
    array = as_numbers(value)
    # JSON keeps no shape of nothing.
    array = array.reshape(shape) if array.size == 0 == np.prod(shape) else array
    if array.shape != shape or not np.isfinite(array).all():
        raise RecordingError(
            f"{name} has shape {array.shape}, but must be finite numbers of shape {shape}."
        )
    return array


def pseudonyms(writers: Iterable[str | None]) -> dict[str | None, str | None]:
    """Return for every writer a pseudonym: the own one, or "writer-1" and so on for a name."""
    known = dict.fromkeys(writers)
    free = (name for n in count(1) if (name := f"writer-{n}") not in known)
    return {
        each: each if each is None or _NO_NAME.fullmatch(each) else next(free) for each in known
    }
