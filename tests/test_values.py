"""Public values are values: short to read, locked, compared by content, copied and pickled."""

import copy
import pickle
from collections.abc import Mapping
from concurrent.futures import ProcessPoolExecutor
from dataclasses import fields, is_dataclass
from multiprocessing import get_context

import numpy as np
import pytest

import dmp_teach as teach
from tests.public import ALIKE, FEW, T, public_classes, values


def arrays(value, place=""):
    """Every array in the fields of a value, and in theirs."""
    if isinstance(value, np.ndarray):
        yield place, value
    elif isinstance(value, tuple | list):
        for number, each in enumerate(value):
            yield from arrays(each, f"{place}[{number}]")
    elif isinstance(value, Mapping):
        for name, each in value.items():
            yield from arrays(each, f"{place}[{name!r}]")
    elif is_dataclass(value):
        for each in fields(value):
            yield from arrays(getattr(value, each.name), f"{place}.{each.name}")


def test_every_public_class_has_a_value_here():
    found = tuple(values().values())
    assert [each for each in public_classes() if not any(isinstance(v, each) for v in found)] == []


@pytest.mark.parametrize("name", values())
def test_it_is_read_in_three_lines_locked_and_the_same_after_every_copy(name):
    value = values()[name]
    assert len(repr(value)) <= 300
    assert repr(value).count("\n") < 3
    assert " object at 0x" not in repr(value)
    copies = [copy.copy(value), copy.deepcopy(value), pickle.loads(pickle.dumps(value))]
    for each in (value, *copies):
        assert each == value
        assert hash(each) == hash(value)
        assert repr(each) == repr(value)
        assert [place for place, array in arrays(each) if array.flags.writeable] == []
    assert value != object()


def test_values_of_other_content_differ():
    """Of each kind with an array or a number of its own."""
    other = teach.Trajectory(T, 0.1 + values()["Trajectory"].position)
    assert other != values()["Trajectory"]
    assert teach.DMP.imitate(other, FEW) != values()["DMP"]
    assert teach.Page.board() != values()["Page"]
    assert ALIKE[0] != ALIKE[1]
    assert teach.lesson("03", "w01") != values()["BumpWidth"]


def test_a_pool_of_processes_learns_a_class():
    with ProcessPoolExecutor(1, get_context("fork")) as pool:
        learned = list(pool.map(teach.Letter.learn, ALIKE))
    assert learned == list(map(teach.Letter.learn, ALIKE))
