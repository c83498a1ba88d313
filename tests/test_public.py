"""What an editor, a type checker, Tab and help() see of the package."""

import ast
import builtins
import collections.abc
import inspect
import os
import subprocess
import sys
import typing
from pathlib import Path

import numpy as np
import pytest

import dmp_teach as teach
from tests.public import public_classes
from tests.test_house import ORDER

ROOT = Path(__file__).parents[1]
PLACES = {"teach": teach, "teach.studies": teach.studies, "teach.figures": teach.figures}
USED = {
    "teach": {"Letter", "Score", "Piece", "SettingError", "TeachError", "figures", "studies"},
    "teach.studies": {"claims", "choose_kernels", "classify_writers"},
    "teach.figures": {"draw_contact_sheet"},
}


def functions():
    """Every public function and method of ours, by its name."""
    for place, module in PLACES.items():
        for name in dir(module):
            thing = getattr(module, name)
            if inspect.isfunction(thing):
                yield f"{place}.{name}", thing
            elif inspect.isclass(thing):
                for method, value in inspect.getmembers(thing, inspect.isroutine):
                    ours = str(getattr(value, "__module__", "")).startswith("dmp_teach")
                    if ours and not method.startswith("_"):
                        yield f"{place}.{name}.{method}", value


@pytest.mark.parametrize("place", PLACES)
def test_tab_finds_what_is_used(place):
    assert USED[place] <= set(dir(PLACES[place]))


def test_help_opens_with_a_signature_of_four_lines_at_most():
    found = dict(functions())
    assert len(found) > 100
    signatures = {name: str(inspect.signature(each)) for name, each in found.items()}
    assert {name: said for name, said in signatures.items() if len(said) > 4 * 80} == {}


def annotations():
    """Every annotation that help() shows: of what, the names in it, and what they mean there."""
    shown = [(name, inspect.unwrap(each)) for name, each in functions()]
    for kind in public_classes():
        shown.append((kind.__name__, kind))
        for name, value in inspect.getmembers(kind):
            getter = getattr(value, "fget", None) or getattr(value, "func", None)
            if not name.startswith("_") and inspect.isfunction(getter):
                shown.append((f"{kind.__name__}.{name}", getter))
    for name, thing in shown:
        if str(thing.__module__).startswith("dmp_teach"):
            around = vars(sys.modules[thing.__module__])
            for part, said in inspect.get_annotations(thing).items():
                tree = ast.parse(said, mode="eval")
                words = {node.id for node in ast.walk(tree) if isinstance(node, ast.Name)}
                words |= {node.attr for node in ast.walk(tree) if isinstance(node, ast.Attribute)}
                yield from ((f"{name}: {part}", word, around.get(word)) for word in words)


def is_foreign(word, meaning):
    """Whether a name is Python's or another library's."""
    places = [builtins, typing, collections.abc, np, np.random, np.typing, os]
    module = str(getattr(meaning, "__module__", ""))
    foreign = inspect.isclass(meaning) and not module.startswith("dmp_teach")
    return foreign or inspect.ismodule(meaning) or any(hasattr(each, word) for each in places)


def test_every_name_of_ours_in_help_has_a_public_home():
    """As `teach.X` or `teach.room.X`."""
    rooms = [getattr(teach, room) for room in ORDER if room != "launcher"]
    homes = {name for place in [teach, teach.figures, *rooms] for name in dir(place)}
    assert {f"{word} in {of}" for of, word, meaning in annotations()
            if word not in homes and not is_foreign(word, meaning)} == set()  # fmt: skip


def check_types(*words, folder=ROOT):
    """What mypy says, run in a folder."""
    answer = subprocess.run(
        [sys.executable, "-m", "mypy", *words],
        cwd=folder,
        env={"MYPYPATH": str(ROOT), "MYPY_CACHE_DIR": str(ROOT / ".mypy_cache")},
        capture_output=True,
        text=True,
        check=False,
    )
    return answer.stdout


@pytest.mark.slow
def test_a_type_checker_finds_nothing():
    said = check_types()
    assert said.startswith("Success"), said


@pytest.mark.slow
def test_a_type_checker_accepts_our_names_and_refuses_others(tmp_path):
    code = """
import dmp_teach as teach

letter = teach.Letter.learn(teach.recording_of("a"))
reveal_type(letter)
teach.Leter
teach.Letter.lern
teach.Settings.star(kernel_width="wide", widht=2.0)
teach.Letter.learn(3)
teach.Letter.learn(letter.strokes)
"""
    (tmp_path / "used.py").write_text(code, encoding="utf-8")
    said = check_types("used.py", "--ignore-missing-imports", folder=tmp_path)
    assert 'Revealed type is "dmp_teach.letters.letter.Letter"' in said
    assert 'used.py:6: error: Module has no attribute "Leter"' in said
    assert 'used.py:7: error: "type[Letter]" has no attribute "lern"' in said
    assert 'used.py:8: error: Argument "kernel_width" to "star" of "Settings"' in said
    assert 'used.py:8: error: Unexpected keyword argument "widht"' in said
    assert 'used.py:9: error: Argument 1 to "learn" of "Letter"' in said
    assert "used.py:10" not in said


@pytest.mark.parametrize("place", PLACES)
def test_a_name_that_is_not_there_is_answered_with_those_that_are(place):
    with pytest.raises(AttributeError, match=rf"dmp_{place} has no 'nope'; it has: .*\w+, \w+"):
        _ = PLACES[place].nope
