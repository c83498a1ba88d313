"""What an editor, a type checker, Tab and help() see of the package."""

import inspect
import subprocess
import sys
from pathlib import Path

import pytest

import dmp_teach as teach

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
