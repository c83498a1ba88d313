"""Lesson 03 graded by the real nbgrader and otter-grader, as `docs/grade_a_lesson.md` says.

Each grader is fetched once into an environment of its own, in pytest's cache, without what it needs
for other work: its server, its containers, its manual.
"""

import json
import os
import subprocess
import sys
import sysconfig
import venv
from pathlib import Path

import pytest
from nbformat.v4 import new_code_cell, new_notebook, new_raw_cell

import dmp_teach as teach

ROOT = Path(__file__).parents[2]
MANUAL = (ROOT / "docs" / "grade_a_lesson.md").read_text(encoding="utf-8")
pytestmark = pytest.mark.slow

NBGRADER = ("nbgrader==0.9.6", "alembic", "mako", "rapidfuzz", "sqlalchemy")
OTTER = ("otter-grader==7.0.0", "dill", "fica", "ipylab", "jupytext", "pandas")
OTTER += ("python-frontmatter", "wrapt")
IMPORT = "import dmp_teach as teach"
CHECK = 'verdict = teach.check("03", answer)\nassert verdict.done, verdict.reason'
OTTER_TEST = f"""\
def test_width(answer):
    {CHECK.replace(chr(10), chr(10) + "    ")}


test_width(answer)  # IGNORE"""
KERNEL = {"kernelspec": {"name": "python3", "display_name": "Python 3", "language": "python"}}
GRADE_BY_NBGRADER = """
import json
from nbgrader.api import Gradebook
from nbgrader.apps import NbGraderAPI
from pathlib import Path

api = NbGraderAPI()
made = api.generate_assignment("lesson03")
assert made["success"], made["log"]
given = json.loads(Path("release/lesson03/lesson03.ipynb").read_text())
points = {}
for pupil, answer in json.loads(Path("answers.json").read_text()).items():
    assert "kernel_width" not in str(given["cells"][1]), "the solution is not given away"
    handed_in = json.loads(json.dumps(given))
    handed_in["cells"][1]["source"] = f"answer = {answer!r}"
    folder = Path("submitted", pupil, "lesson03")
    folder.mkdir(parents=True)
    (folder / "lesson03.ipynb").write_text(json.dumps(handed_in))
    assert api.autograde("lesson03", pupil)["success"]
    with Gradebook("sqlite:///gradebook.db") as book:
        graded = Path("autograded", pupil, "lesson03", "lesson03.ipynb").read_text()
        points[pupil] = [book.find_submission("lesson03", pupil).score, graded]
Path("points.json").write_text(json.dumps(points))
"""
GRADE_BY_OTTER = """
import json
from otter.api import grade_submission
from otter.assign import main as assign
from pathlib import Path

assign("lesson03.ipynb", "dist", no_run_tests=True)
given = Path("dist/student/lesson03.ipynb").read_text()
(autograder,) = Path("dist/autograder").glob("*.zip")
assert "kernel_width" not in given, "the solution is not given away"
points = {}
for pupil, answer in json.loads(Path("answers.json").read_text()).items():
    Path(f"{pupil}.ipynb").write_text(given.replace("answer = ...", f"answer = {answer!r}"))
    result = grade_submission(f"{pupil}.ipynb", ag_path=str(autograder))
    points[pupil] = [result.total, result.summary()]
Path("points.json").write_text(json.dumps(points))
"""


def environment_of(packages, cache):
    """The Python of an environment that has a grader beside all that we have."""
    folder = Path(cache.mkdir(packages[0].replace("==", "_")))
    binaries = folder / ("Scripts" if sys.platform == "win32" else "bin")
    if not (folder / "ready").exists():
        venv.create(folder, with_pip=False, clear=True)
        ask = [binaries / "python", "-c", "import sysconfig; print(sysconfig.get_path('purelib'))"]
        site = Path(subprocess.check_output(ask, text=True).strip())
        places = {sysconfig.get_path("purelib"), sysconfig.get_path("platlib")}
        (site / "ours.pth").write_text("\n".join(places), encoding="utf-8")
        pip = [sys.executable, "-m", "pip", "--python", binaries / "python", "install", "-q"]
        # All of them here, even what we have, too: a grader calls its neighbours by their scripts.
        fetch = [*pip, "--no-deps", "--ignore-installed", *packages]
        fetched = subprocess.run(fetch, capture_output=True, text=True, check=False)
        if fetched.returncode != 0:
            pytest.skip(
                f"{packages[0]} cannot be fetched; is this computer online?\n{fetched.stderr}"
            )
        (folder / "ready").touch()
    return binaries / "python"


def grade(python, code, folder):
    """Run code beside a pupil's answer at the start, w01, and the solution, w02."""
    lesson = teach.lesson("03")
    answers = {
        pupil: {name: values[name] for name in lesson.settable}
        for pupil, values in (("w01", lesson.start), ("w02", lesson.solution))
    }
    (folder / "answers.json").write_text(json.dumps(answers))
    path = f"{python.parent}{os.pathsep}{os.environ['PATH']}"
    done = subprocess.run(
        [python, "-c", code],
        cwd=folder,
        env={**os.environ, "PYTHONPATH": str(ROOT), "PATH": path},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    points = json.loads((folder / "points.json").read_text())
    assert [points["w01"][0], points["w02"][0]] == [0, 2]
    reason = teach.check("03", answers["w01"]).reason
    assert f"AssertionError: {reason}" in points["w01"][1].replace("\\u001b[39m", "")
    assert reason not in points["w02"][1]


def solution():
    lesson = teach.lesson("03")
    return f"answer = { {name: lesson.solution[name] for name in lesson.settable}!r}"


def test_nbgrader_gives_the_points_and_the_reason(request, tmp_path):
    assert CHECK in MANUAL

    def graded(**how):
        return {"nbgrader": {"schema_version": 3, "cell_type": "code", "task": False, **how}}

    own = graded(grade_id="answer", grade=False, locked=False, solution=True)
    test = graded(grade_id="check", grade=True, locked=True, solution=False, points=2)
    hidden = f"### BEGIN SOLUTION\n{solution()}\n### END SOLUTION"
    cells = [new_code_cell(IMPORT), new_code_cell(hidden, metadata=own)]
    notebook = new_notebook(metadata=KERNEL, cells=[*cells, new_code_cell(CHECK, metadata=test)])
    source = tmp_path / "source" / "lesson03" / "lesson03.ipynb"
    source.parent.mkdir(parents=True)
    source.write_text(json.dumps(notebook))
    python = environment_of(NBGRADER, request.config.cache)
    grade(python, GRADE_BY_NBGRADER, tmp_path)


def test_otter_gives_the_points_and_the_reason(request, tmp_path):
    assert OTTER_TEST in MANUAL
    cells = [
        new_raw_cell("# ASSIGNMENT CONFIG\nname: lesson03\ncheck_all_cell: false"),
        new_code_cell(IMPORT),
        new_raw_cell("# BEGIN QUESTION\nname: width\npoints: 2"),
        new_raw_cell("# BEGIN SOLUTION"),
        new_code_cell(f"{solution()} # SOLUTION"),
        new_raw_cell("# END SOLUTION"),
        new_raw_cell("# BEGIN TESTS"),
        new_code_cell(OTTER_TEST),
        new_raw_cell("# END TESTS"),
        new_raw_cell("# END QUESTION"),
    ]
    (tmp_path / "lesson03.ipynb").write_text(json.dumps(new_notebook(metadata=KERNEL, cells=cells)))
    python = environment_of(OTTER, request.config.cache)
    grade(python, GRADE_BY_OTTER, tmp_path)
