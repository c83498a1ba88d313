"""Arguments that cannot be used are named, in a sentence, by the annotations of a function."""

from __future__ import annotations

import inspect
import warnings
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from functools import wraps
from numbers import Integral, Real
from os import PathLike
from types import UnionType
from typing import Any, TypeGuard, TypeVar, Union, cast, get_args, get_origin, get_type_hints

import numpy as np
from numpy.typing import ArrayLike, NDArray

from dmp_teach.errors import SettingError, TeachError, shown

_RAW = (ArithmeticError, AttributeError, LookupError, TypeError, ValueError)
_ARRAY_LIKE = set(get_args(ArrayLike))
LARGEST, LARGEST_SEED = 1e300, 2**32 - 1
_HOLDERS = {Mapping, dict, Sequence, tuple, list, Iterable, Collection}
# Any: kinds, some of which are no classes.
_WORDS: dict[Any, str] = {
    **{float: "a number", int: "a whole number", str: "text", bool: "True or False"},
    **{type(None): "None", np.ndarray: "an array of numbers", Callable: "a function"},
    **{Mapping: "a dictionary", dict: "a dictionary", Sequence: "a list", tuple: "a list"},
    **{list: "a list", Iterable: "a list", Collection: "a list", PathLike: "a path"},
}
# Any: every function, whatever it takes.
_Function = TypeVar("_Function", bound=Callable[..., Any])


def checked(function: _Function) -> _Function:
    """Let a function say in a SettingError which of its arguments cannot be used.

    Only where it fails with an error that is none of ours are its arguments compared with its
    annotations: good ones cost nothing, and an error that no argument explains stays what it is.
    """

    # Any: as above.
    @wraps(function)
    def call(*args: Any, **kwargs: Any) -> Any:
        try:
            return function(*args, **kwargs)
        except TeachError:
            raise
        except _RAW:
            if not (wrong := _find_wrong(function, args, kwargs)):
                raise
            name, value, words = wrong
        raise SettingError(f"{name} is {shown(value)}, but must be {words}.")

    return cast(_Function, call)


def warn_caller(words: str, category: type[Warning] = UserWarning, calls: int = 1) -> None:
    """Warn at the line that called a function, whatever of the way there is `checked`.

    Args:
        words: The warning.
        category: Its kind.
        calls: How many calls up from the function that warns; 1 is the line that called it.
    """
    frame, level = inspect.currentframe(), 1
    while calls >= 0 and frame and frame.f_back:
        frame, level = frame.f_back, level + 1
        calls -= frame.f_globals is not globals()
    warnings.warn(words, category, stacklevel=level)


def is_whole(value: object) -> TypeGuard[int]:
    """Tell whether a value is a whole number, of NumPy or not; True and False are none."""
    return isinstance(value, Integral) and not isinstance(value, bool)


def check_whole(name: str, value: object, least: int, most: int) -> None:
    """Raise a SettingError unless a value is a whole number from `least` to `most`."""
    if not (is_whole(value) and least <= int(value) <= most):
        raise SettingError(
            f"{name} is {shown(value)}, but must be a whole number from {least} to {most}."
        )


# Any: numbers in whatever form.
def as_numbers(values: Any) -> NDArray[np.float64]:
    """Return numbers as an array of floats.

    Raises:
        ValueError: Something else: a mask, complex numbers, times, text, or too large for floats.
    """
    with np.errstate(over="ignore"):
        try:
            array = np.asanyarray(values)
            is_real = array.dtype.kind in "fiub" or all(isinstance(v, Real) for v in array.flat)
            if is_real and not np.ma.is_masked(array):
                return np.asarray(array, dtype=float)
        except (OverflowError, TypeError, ValueError):
            pass
    raise ValueError(f"{shown(values)} is not made of numbers")


# Any: arguments and annotations are of any kind, here and below.
def _find_wrong(
    function: Callable[..., Any], args: tuple[Any, ...], kwargs: dict[str, Any]
) -> tuple[str, Any, str] | None:
    """Return the first argument that its annotation does not allow, and what would be allowed."""
    signature, hints = inspect.signature(function), get_type_hints(function)
    try:
        given = signature.bind(*args, **kwargs).arguments
    except TypeError:
        return None
    for name, value in given.items():
        hint = hints.get(name, Any)
        several = signature.parameters[name].kind is inspect.Parameter.VAR_POSITIONAL
        for each in value if several else (value,):
            if not _fits(each, hint):
                return name, each, _tell(hint)
    return None


# Any: as above.
def _fits(value: Any, hint: Any) -> bool:
    """Return whether a value is what an annotation says; where that is not known, it is."""
    kind, inner = get_origin(hint) or hint, get_args(hint)
    if kind in (Union, UnionType):
        kinds, is_array = _kinds(inner)
        return any(_fits(value, each) for each in kinds) or (is_array and _is_numbers(value))
    if kind is np.ndarray:
        return isinstance(value, np.ndarray) and _is_numbers(value)
    if kind is Callable:
        return callable(value)
    if kind is Any or not isinstance(kind, type):
        return True
    if kind in (float, int):
        is_kind = isinstance(value, Real if kind is float else Integral)
        return is_kind and not abs(value) > LARGEST
    return isinstance(value, kind) and _fit_all(value, inner)


# Any: as above.
def _fit_all(value: Any, inner: tuple[Any, ...]) -> bool:
    """Return whether what a value holds is what an annotation says of it."""
    if inner and isinstance(value, Mapping):
        return all(_fits(k, inner[0]) and _fits(v, inner[1]) for k, v in value.items())
    is_list = isinstance(value, bytes | list | str | tuple)
    if inner and is_list and (len(inner) == 1 or inner[1] is Ellipsis):
        return all(_fits(each, inner[0]) for each in value)
    return True


# Any: as above.
def _kinds(inner: tuple[Any, ...]) -> tuple[list[Any], bool]:
    """Return the kinds of a union, and whether what makes an array is one of them."""
    is_array = set(inner) >= _ARRAY_LIKE
    return [each for each in inner if not (is_array and each in _ARRAY_LIKE)], is_array


# Any: as above.
def _is_numbers(value: Any) -> bool:
    try:
        return value is not None and as_numbers(value) is not None
    except ValueError:
        return False


# Any: as above.
def _tell(hint: Any) -> str:
    """Return what an annotation allows, in words."""
    kind, inner = get_origin(hint) or hint, get_args(hint)
    if kind in (Union, UnionType):
        kinds, is_array = _kinds(inner)
        several = ["numbers in an array"] * is_array + list(map(_tell, kinds))
        return " or ".join(dict.fromkeys(several))
    name = getattr(kind, "__name__", str(kind))
    words = _WORDS.get(kind) or f"a{'n' * (name[0] in 'AEIOU')} {name}"
    held = [each for each in inner[1 if kind in (Mapping, dict) else 0 :] if each is not Ellipsis]
    return f"{words} ({_tell(held[-1])} each)" if held and kind in _HOLDERS else words
