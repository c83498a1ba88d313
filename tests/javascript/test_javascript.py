"""The scripts of panels and views: linted, type-checked, tested without a browser, and joined.

`npm run format` in this folder lays scripts and styles out as the linter wants them.
"""

import re
import subprocess
from pathlib import Path

import pytest

from dmp_teach.files import join_modules
from tests.node import command, modules

HERE = Path(__file__).parent
PACKAGE = HERE.parents[1] / "dmp_teach"
SCRIPTS = sorted(PACKAGE.rglob("*.js"))
ENTRIES = [
    path
    for path in SCRIPTS
    if "export default" in path.read_text(encoding="utf-8") or path.name.endswith("page.js")
]
MODULES = {
    "entry.js": 'import { number as seen } from "./in/first.js";\n'
    'import {\n  second,\n} from "./in/second.js";\n\n'
    "const hidden = 10;\nexport default { answer: hidden + seen + second() };\n",
    "in/first.js": "const hidden = 1;\nexport const number = hidden;\nexport default { number };\n",
    "in/second.js": 'import { shared } from "../shared.js";\n'
    "const hidden = 2;\nexport function second() {\n  return hidden * shared.value;\n}\n",
    "shared.js": "// A comment.\n/** Another, of\n * two lines. */\n"
    "export class shared {\n  static /** here */ value = 100;\n}\n",
}


def run(*line, **options):
    return subprocess.run(
        [str(word) for word in line],
        cwd=HERE,
        capture_output=True,
        text=True,
        encoding="utf-8",
        check=False,
        **options,
    )


def write(folder, modules):
    for name, text in modules.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text, encoding="utf-8")
    return folder / "entry.js"


@pytest.mark.slow
def test_linter_types_and_unit_tests_find_nothing():
    modules()
    checked = run(command("npm"), "test", "--silent", timeout=300)
    assert checked.returncode == 0, checked.stdout + checked.stderr


@pytest.mark.parametrize("path", SCRIPTS, ids=lambda path: path.name)
def test_no_script_is_long_or_wide(path):
    lines = path.read_text(encoding="utf-8").splitlines()
    assert len(lines) <= 300
    assert [number for number, line in enumerate(lines, 1) if len(line) > 100] == []


@pytest.mark.parametrize("path", SCRIPTS, ids=lambda path: path.name)
def test_scripts_import_along_the_rooms(path):
    """A panel may use what the views offer to all, and nothing the other way round."""
    own = path.relative_to(PACKAGE).parts[0]
    for place in re.findall(r'from "([^"]+)"', path.read_text(encoding="utf-8")):
        other = (path.parent / place).resolve().relative_to(PACKAGE)
        assert other.parts[0] == own or other.parent.as_posix() == "views"


def test_joined_modules_keep_their_names_to_themselves(tmp_path):
    joined = tmp_path / "joined.mjs"
    joined.write_text(join_modules(write(tmp_path, MODULES)), encoding="utf-8")
    question = f"import it from {joined.as_uri()!r}; console.log(it.answer);"
    answered = run(command("node"), "--input-type=module", "--eval", question)
    assert answered.stdout.strip() == "211", answered.stderr
    assert "omment" not in joined.read_text(encoding="utf-8")


@pytest.mark.parametrize("path", ENTRIES, ids=lambda path: path.name)
def test_what_a_browser_gets_is_a_module(tmp_path, path):
    joined = tmp_path / "joined.mjs"
    joined.write_text(join_modules(path), encoding="utf-8")
    checked = run(command("node"), "--check", joined)
    assert checked.returncode == 0, checked.stderr


def test_modules_that_import_each_other_are_refused(tmp_path):
    modules = {"entry.js": 'import { a } from "./a.js";\n'}
    modules["a.js"] = 'import { b } from "./entry.js";\nexport const a = b;\n'
    with pytest.raises(ValueError, match=r"each other: entry\.js -> a\.js -> entry\.js"):
        join_modules(write(tmp_path, modules))


@pytest.mark.parametrize(
    "line",
    ['import a from "./a.js";', 'import * as a from "./a.js";', 'import { a } from "package";'],
)
def test_an_import_of_another_form_is_refused(tmp_path, line):
    with pytest.raises(ValueError, match=r"entry\.js cannot be joined: import"):
        join_modules(write(tmp_path, {"entry.js": f"{line}\n", "a.js": "\n"}))


@pytest.mark.parametrize("line", ["export let a = 1;", "export { a };", 'export * from "./b.js";'])
def test_an_export_of_another_form_is_refused(tmp_path, line):
    modules = {"entry.js": 'import { a } from "./a.js";\n', "a.js": f"{line}\n"}
    with pytest.raises(ValueError, match=r"a\.js cannot be joined: export"):
        join_modules(write(tmp_path, modules))
