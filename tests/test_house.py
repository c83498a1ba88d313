"""The rules of the house, as far as a machine can see to them."""

import ast
import json
import re
import subprocess
import sys
from collections import defaultdict
from graphlib import TopologicalSorter
from importlib import import_module
from importlib.metadata import packages_distributions
from pathlib import Path

import pytest

import dmp_teach
from tests.test_environment import declared

ROOT = Path(__file__).parents[1]
PACKAGE = ROOT / "dmp_teach"
MODULES = sorted(PACKAGE.rglob("*.py"))
NOTEBOOKS = sorted((ROOT / "notebooks").glob("*.ipynb"))
# The launcher may use any room, and so may an old path that points up for one version.
LAUNCHER = {"__init__.py", "__main__.py", "classroom/saving.py"}

ORDER = [
    "errors",
    "old_names",
    "progress",
    "arguments",
    "values",
    "texts",
    "trajectory",
    "filtering",
    "files",
    "segmentation",
    "ink",
    "formats",
    "scoring",
    "dmp",
    "letters",
]
ORDER += ["robot", "ros", "studies", "views", "classroom", "lessons", "launcher"]
FACES = [room for room in ORDER if (PACKAGE / room / "__init__.pyi").exists()]
EVERYWHERE = {"numpy", "scipy", "dmp_teach", "lazy_loader", "tqdm"}
ROOMS = {  # where a library from elsewhere may be imported
    "csv": ["formats/"],
    "babel": ["texts/catalogue.py"],
    "pandas": ["formats/"],
    "svgelements": ["formats/"],
    "defusedxml": ["formats/"],
    "placo": ["robot/placo_arm.py"],
    "pybullet": ["robot/simulation/bullet.py"],
    "rosbags": ["ros/"],
    "meshcat": ["views/scene/commands.py"],
    "umsgpack": ["views/"],
    "PIL": ["views/"],
    "zxingcpp": ["views/"],
    "matplotlib": ["views/"],
    "IPython": ["views/", "classroom/"],
    "traitlets": ["views/", "classroom/", "launcher/"],
    "anywidget": ["views/unsaved.py", "classroom/panels/robot_panel.py"],
    "ipywidgets": ["classroom/"],
    "jupyter_server": ["launcher/"],
    "jupyterlab": ["launcher/quick_start.py"],
    "js": ["launcher/site_page/"],
    "pyodide_js": ["launcher/site_page/"],
    "docutils": ["launcher/docs_page/"],
}
# Rooms in which not every `Any` says why yet.
UNTOLD = {"scoring", "dmp", "letters", "robot", "ros", "studies", "views", "classroom", "launcher"}
TOP_LEVEL = {"dmp_teach", "notebooks", "assets", "tests", "environment.txt", "pyproject.toml"}
TOP_LEVEL |= {"README.md", "CHANGELOG.md", "LICENSE", "CONTRIBUTING.md", "CITATION.cff", "docs"}


def name_of(path):
    return path.relative_to(PACKAGE).as_posix()


def imports_of(path):
    """Every module that a file imports, inside functions too, as (full name, line)."""
    package = ["dmp_teach", *path.relative_to(PACKAGE).parts[:-1]]
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            yield from ((alias.name, node.lineno) for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            start = package[: len(package) - node.level + 1] if node.level else []
            base = ".".join([*start, *([node.module] if node.module else [])])
            yield from ((f"{base}.{alias.name}", node.lineno) for alias in node.names)


def room_of(full_name):
    """The room that a full name of ours lives in."""
    return full_name.split(".")[1]


def tracked():
    """The files that git knows."""
    answer = subprocess.run(
        ["git", "-c", "safe.directory=*", "ls-files", "-z"],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
    )
    if answer.returncode != 0:
        pytest.skip("this folder is not a git clone")
    return [name for name in answer.stdout.split("\0") if name and (ROOT / name).exists()]


@pytest.mark.parametrize(
    "path", [path for path in MODULES if name_of(path) not in LAUNCHER], ids=name_of
)
def test_imports_go_one_way(path):
    own = ORDER.index(name_of(path).split("/")[0].removesuffix(".py"))
    ours = [(name, line) for name, line in imports_of(path) if name.startswith("dmp_teach.")]
    assert [(name, line) for name, line in ours if ORDER.index(room_of(name)) > own] == []


@pytest.mark.parametrize(
    "path", [path for path in MODULES if name_of(path) not in LAUNCHER], ids=name_of
)
def test_other_rooms_come_in_by_a_face(path):
    """They import only what a room's `__init__.pyi` offers."""
    own = name_of(path).split("/")[0]
    for name, line in imports_of(path):
        parts = name.split(".")
        if parts[0] == "dmp_teach" and parts[1] in FACES and parts[1] != own:
            assert len(parts) <= 3, f"line {line} imports {name}"


def test_no_module_is_imported_in_a_circle():
    modules = {
        "dmp_teach." + name_of(path).removesuffix(".py").replace("/", "."): path for path in MODULES
    }
    arrows = {}
    for module, path in modules.items():
        told = [name for name, _ in imports_of(path)]
        arrows[module] = {
            name if name in modules else name.rpartition(".")[0] for name in told
        } & set(modules)
    TopologicalSorter(arrows).prepare()  # raises a CycleError that names the circle


@pytest.mark.parametrize("room", FACES)
def test_what_a_face_offers_is_there(room):
    face = import_module(f"dmp_teach.{room}")
    assert [name for name in face.__all__ if getattr(face, name, None) is None] == []


@pytest.mark.parametrize("path", MODULES, ids=name_of)
def test_third_parties_keep_to_their_rooms(path):
    for name, line in imports_of(path):
        first = name.split(".")[0]
        if first in ROOMS:
            assert name_of(path).startswith(tuple(ROOMS[first])), f"line {line} imports {name}"
        else:
            assert first in EVERYWHERE | set(sys.stdlib_module_names), (
                f"line {line}: {name} has no room"
            )


def test_what_is_imported_is_declared():
    homes = packages_distributions()
    imported = {name.split(".")[0] for path in MODULES for name, _ in imports_of(path)} & set(homes)
    known = {requirement.name.replace("_", "-") for requirement in declared(extras=False)}
    missing = {
        name
        for name in imported
        if not known & {home.lower().replace("_", "-") for home in homes[name]}
    } - {"dmp_teach"}
    assert missing == set()


@pytest.mark.parametrize("module", ["dmp_teach", "dmp_teach.__main__"])
def test_importing_loads_nothing_heavy(module):
    question = (
        "import sys; before = set(sys.modules); import %s; "
        "new = {name.split('.')[0] for name in set(sys.modules) - before}; "
        "print(*(new - set(sys.stdlib_module_names) - {'dmp_teach'}))"
    )
    answer = subprocess.check_output([sys.executable, "-c", question % module], cwd=ROOT, text=True)
    assert answer.split() == []


# `import scipy` and then `scipy.signal.butter(...)` loads a room of SciPy where it is first used.
SLOW = "scipy.signal scipy.stats scipy.interpolate scipy.optimize scipy.spatial matplotlib"


@pytest.mark.parametrize(
    ("work", "slow"),
    [
        ("teach.Letter.learn(teach.recording_of('a')).write()", f"{SLOW} ipywidgets"),
        ("teach.check('03', teach.lesson('03').solution)", f"{SLOW} ipywidgets"),
        ("teach.check('09', teach.lesson('09').start)", f"{SLOW} dmp_teach.lessons.bump_width"),
        ("teach.explore()", SLOW),
    ],
)
def test_what_one_waits_for_first_imports_nothing_slow(work, slow):
    question = f"import sys, dmp_teach as teach; {work}; print(*sys.modules)"
    answer = subprocess.check_output([sys.executable, "-c", question], cwd=ROOT, text=True)
    assert not set(slow.split()) & set(answer.split())


def test_every_public_name_is_at_home_and_typed():
    stub = ast.parse((PACKAGE / "__init__.pyi").read_text(encoding="utf-8"))
    typed = {
        alias.asname
        for node in stub.body
        if isinstance(node, ast.ImportFrom)
        for alias in node.names
    }
    assert typed | {"__version__"} == set(dir(dmp_teach))
    assert [name for name in typed if getattr(dmp_teach, name) is None] == []


def test_every_old_name_gives_the_new_one_with_a_warning():
    source = (PACKAGE / "__init__.py").read_text(encoding="utf-8")
    renamed = ast.literal_eval(re.search(r"^_RENAMED = (\{.*?\})", source, re.M | re.S).group(1))
    assert not set(renamed) & set(dir(dmp_teach))
    for old, new in renamed.items():
        with pytest.warns(DeprecationWarning, match=rf"dmp_teach\.{old} is .*\.{new}") as said:
            assert getattr(dmp_teach, old) is getattr(dmp_teach, new)
        assert said[0].filename == __file__


def test_no_room_has_a_public_name():
    rooms = {
        path.stem
        for path in PACKAGE.iterdir()
        if path.suffix == ".py" or (path / "__init__.py").exists()
    }
    assert rooms & set(dir(dmp_teach)) <= {"errors", "studies"}


def test_a_name_that_we_lack_is_answered_with_those_that_we_have():
    with pytest.raises(AttributeError, match=r"dmp_teach has no 'Robot'; it has: .*Fetch"):
        _ = dmp_teach.Robot


def test_the_top_level_is_tidy():
    first = {name.split("/")[0] for name in tracked()}
    assert {name for name in first if not name.startswith(".")} <= TOP_LEVEL


def test_no_file_knows_a_machine():
    places = (
        "|".join(f"/{name}/" for name in ("work", "root", "home", "Users")) + r"|/tmp/\w|[A-Z]:\\\\"
    )
    found = []
    for name in tracked():
        text = (ROOT / name).read_bytes()
        if b"\0" not in text:
            found += [f"{name}: {place}" for place in re.findall(places, text.decode("utf-8"))]
    assert [line for line in found if not line.startswith("tests/test_house.py")] == []


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.name)
def test_notebooks_are_committed_clean(path):
    notebook = json.loads(path.read_text(encoding="utf-8"))
    assert "widgets" not in notebook["metadata"]
    assert notebook["metadata"]["kernelspec"]["name"] == "python3"
    for cell in notebook["cells"]:
        assert cell.get("id"), "every cell has an id"
        tags = cell["metadata"].get("tags", [])
        assert not [tag for tag in tags if "skip" in tag], "no cell is left out of the tests"
        if cell["cell_type"] == "code":
            source = "".join(cell["source"])
            assert len(source.strip().splitlines()) <= 5, source
            assert cell["outputs"] == [] or "keep_output" in tags, source


@pytest.mark.parametrize("path", MODULES, ids=name_of)
def test_small_is_a_feature(path):
    text = path.read_text(encoding="utf-8")
    assert len(text.splitlines()) <= 300
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
            words = node.body[0] if ast.get_docstring(node, clean=False) is not None else None
            length = node.end_lineno - node.lineno + 1
            length -= words.end_lineno - words.lineno + 1 if words else 0
            assert length <= 45, f"{node.name} has {length} lines"


def names_defined(path):
    """Yield the public names that a module defines: functions, classes and constants."""
    for node in ast.parse(path.read_text(encoding="utf-8")).body:
        if isinstance(node, ast.FunctionDef | ast.ClassDef):
            yield node.name
        elif isinstance(node, ast.Assign | ast.AnnAssign):
            targets = node.targets if isinstance(node, ast.Assign) else [node.target]
            yield from (
                each.id
                for target in targets
                for each in ast.walk(target)
                if isinstance(each, ast.Name)
            )


def any_annotations(path):
    """Yield the first line of every function or name whose annotation has `Any` in it."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
            arguments = ast.walk(node.args)
            annotations = [each.annotation for each in arguments if isinstance(each, ast.arg)]
            annotations.append(node.returns)
        else:
            annotations = [node.annotation] if isinstance(node, ast.AnnAssign) else []
        words = [each for part in annotations if part for each in ast.walk(part)]
        if any(isinstance(each, ast.Name) and each.id == "Any" for each in words):
            yield min([node.lineno, *(each.lineno for each in getattr(node, "decorator_list", []))])


@pytest.mark.parametrize(
    "path", [path for path in MODULES if name_of(path).split("/")[0] not in UNTOLD], ids=name_of
)
def test_any_is_only_where_a_comment_says_why(path):
    lines = path.read_text(encoding="utf-8").splitlines()
    for first in any_annotations(path):
        assert "#" in lines[first - 1] or lines[first - 2].strip().startswith("#"), f"line {first}"


def test_a_name_has_one_meaning():
    homes = defaultdict(set)
    for path in MODULES:
        for name in names_defined(path):
            if not name.startswith("_"):
                homes[name].add(name_of(path))
    twice = {name: sorted(places) for name, places in homes.items() if len(places) > 1}
    # Every format offers itself by this name, and a hub may still name the old path.
    assert set(twice) <= {"FORMAT", "without_ink"}, twice


@pytest.mark.parametrize("path", MODULES, ids=name_of)
def test_the_library_neither_asserts_nor_prints(path):
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        assert not isinstance(node, ast.Assert), f"line {node.lineno}"
        if isinstance(node, ast.Call) and getattr(node.func, "id", "") == "print":
            assert name_of(path) in ("__main__.py", "launcher/lab.py"), f"line {node.lineno}"


@pytest.mark.parametrize(
    "path", [path for path in NOTEBOOKS if path.name[:2].isdigit()], ids=lambda path: path.name
)
def test_a_lesson_begins_with_its_question_and_its_panel(path):
    """The cell that says how to begin is one of its own: the lab hides it."""
    cells = json.loads(path.read_text(encoding="utf-8"))["cells"]
    assert [cell["id"] for cell in cells[:3]] == ["question", "begin", "panel"]
    key = path.name[:2]
    begin = f'import dmp_teach as teach\n\npanel = teach.lesson("{key}").panel()\npanel'
    assert "".join(cells[2]["source"]) == begin
    assert f'teach.check("{key}", panel.answer, pupil="w07")' in "".join(cells[-1]["source"])
    words = sum(
        len("".join(cell["source"]).split()) for cell in cells if cell["cell_type"] == "markdown"
    )
    assert 300 <= words <= 600, words
