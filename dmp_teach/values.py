"""What all values have in common: locked, compared by content, printed in a line, pickled."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import fields
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from dmp_teach.arguments import as_numbers
from dmp_teach.errors import TrajectoryError, shown

LONGEST_LINE = 240
ARRAY_TYPES = ("Array", "Array | None")


# Any: arrays of every kind are locked.
def locked(values: ArrayLike, dtype: Any = float) -> NDArray[Any]:
    """Return a copy of `values` that cannot be written to."""
    array = np.array(values, dtype=dtype)
    array.setflags(write=False)
    return array


def as_array(name: str, values: ArrayLike) -> NDArray[np.float64]:
    """Return `values` as floats, or raise a TrajectoryError that names them."""
    if type(values) is np.ndarray and values.dtype == float:
        return values
    try:
        return as_numbers(values)
    except ValueError as error:
        raise TrajectoryError(f"{name} must be numbers in an array, but: {error}.") from None


class Value:
    """The base of frozen dataclasses (`eq=False, repr=False`) that may hold arrays.

    Arrays and mappings in its fields are copied and locked; lists of numbers become arrays. Two
    values are equal if all that is in their fields is. Copies and pickles hold the fields alone,
    nothing that was computed of them.
    """

    def __post_init__(self) -> None:
        """Lock what the fields hold; where an array is wanted, a list is made one.

        Raises:
            TrajectoryError: An array that is not made of numbers.
        """
        held = self.__dict__
        for each in fields(self):  # type: ignore[arg-type]
            value = held[each.name]
            if each.type in ARRAY_TYPES and isinstance(value, np.ndarray | list | tuple):
                value = as_array(each.name, value)
            if each.compare and isinstance(value, np.ndarray | tuple | dict):
                held[each.name] = _frozen(value)

    def __eq__(self, other: object) -> bool:
        if type(self) is not type(other):
            return NotImplemented
        return all(is_same(getattr(self, each), getattr(other, each)) for each in _names(self))

    def __hash__(self) -> int:
        return hash((type(self), *(_hash(getattr(self, each)) for each in _names(self))))

    # Any: whatever the fields hold.
    def __getstate__(self: Any) -> dict[str, Any]:
        held = {each.name: getattr(self, each.name) for each in fields(self)}
        return {k: dict(v) if isinstance(v, MappingProxyType) else v for k, v in held.items()}

    # Any: as above.
    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state)
        Value.__post_init__(self)

    def __repr__(self) -> str:
        """Return a line or two: the fields that are not as usual."""
        told = []
        for each in fields(self):  # type: ignore[arg-type]
            value = getattr(self, each.name)
            if each.repr and not is_same(value, each.default):
                is_array = isinstance(value, np.ndarray)
                told.append(f"{each.name}={value.shape if is_array else shown(value)}")
        return f"{type(self).__name__}({shortened(', '.join(told))})"


def shortened(line: str) -> str:
    """Return the beginning of a line that is longer than two."""
    return line if len(line) <= LONGEST_LINE else f"{line[:LONGEST_LINE]}..."


# Any: whatever is in fields, here and below.
def is_same(one: Any, other: Any) -> bool:
    """Tell whether two values have the same content; NaN is the same as NaN."""
    if isinstance(one, np.ndarray):
        is_like = isinstance(other, np.ndarray) and one.dtype == other.dtype
        return is_like and np.array_equal(one, other, equal_nan=one.dtype.kind in "fc")
    if isinstance(one, tuple | list):
        alike = type(one) is type(other) and len(one) == len(other)
        return alike and all(map(is_same, one, other))
    if isinstance(one, Mapping):
        alike = isinstance(other, Mapping) and one.keys() == other.keys()
        return alike and all(is_same(one[name], other[name]) for name in one)
    return one is other or bool(one == other) or (_is_nan(one) and _is_nan(other))


# Any: every dataclass.
def _names(value: Any) -> list[str]:
    """Return the names of the fields that count; those of a mere store do not."""
    return [each.name for each in fields(value) if each.compare]


# Any: as above.
def _frozen(value: Any) -> Any:
    """Return a value whose arrays and mappings are locked copies."""
    if isinstance(value, np.ndarray):
        return locked(value, value.dtype) if value.flags.writeable else value
    if type(value) is tuple:
        return tuple(map(_frozen, value))
    if type(value) is dict:
        return MappingProxyType({name: _frozen(each) for name, each in value.items()})
    return value


# Any: as above.
def _hash(value: Any) -> int:
    """Return a hash of what can be in a field; equal values have equal ones."""
    if isinstance(value, np.ndarray):
        # So that 0 and -0 have the same, and NaN one of its own.
        return hash((value.shape, tuple(np.nan_to_num(value.ravel()[:8]).tolist())))
    if isinstance(value, tuple | list):
        return hash(tuple(map(_hash, value)))
    if isinstance(value, Mapping):
        return hash(frozenset((name, _hash(each)) for name, each in value.items()))
    return 0 if _is_nan(value) else hash(value)


def _is_nan(value: object) -> bool:
    return isinstance(value, float) and math.isnan(value)
