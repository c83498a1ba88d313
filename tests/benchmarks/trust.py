"""How much the tests see: `python -m tests.benchmarks.trust [--mutants 60] [--seed 1] [--all]`.

A row a room: its statements and branches, the share of branches that its tests take (coverage.py),
and that of mutants that they notice (mutmut, for which `pip install -e ".[trust]"`). Mutants are
drawn by the seed and tried on the quick tests alone, which take few examples of each law: the share
is a lower bound. A mutant that only words a text otherwise says nothing and is not drawn; mutmut
makes none outside of functions, nor in most that have a decorator. Those that live are named below
the table: `python -m mutmut show NAME`, in the folder that is named there, shows one.
"""

import argparse
import ast
import json
import random
import shutil
import subprocess
import sys
import tempfile
from collections import Counter
from pathlib import Path

ROOT = Path(__file__).parents[2]
ROOMS = ("dmp", "segmentation", "letters", "scoring")
TESTS = [f"tests/{folder}" for folder in (*ROOMS, "formats")]
# It asks who called, which is mutmut.
ASKS_WHO_CALLS = "tests/dmp/test_variants.py::"
ASKS_WHO_CALLS += "test_touching_kernels_say_nothing_and_gaps_are_said_once"
NEEDED = ["CHANGELOG.md", "LICENSE", "README.md", "environment.txt"]
NEEDED += ["assets", "docs", "notebooks"]

# What mutmut keeps of a mutant that all tests pass, that none touches, and that was not tried.
ALIVE = (0, 33, None)


def run(folder, *command, must_work=True):
    """Run a module in the folder, its output beside ours."""
    done = subprocess.run(
        [sys.executable, "-m", *command], cwd=folder, stdout=sys.stderr, check=False
    )
    if must_work and done.returncode:
        raise SystemExit(f"{' '.join(command[:2])} failed in {folder}.")


def measure_coverage(folder):
    """Statements, branches and branches taken, by room."""
    sources = ",".join(f"dmp_teach.{room}" for room in ROOMS)
    run(ROOT, "coverage", "run", "--branch", f"--source={sources}", f"--data-file={folder}/data",
        "-m", "pytest", "-q", *TESTS)  # fmt: skip
    run(ROOT, "coverage", "json", "-q", f"--data-file={folder}/data", "-o", f"{folder}/c.json")
    found = {room: Counter() for room in ROOMS}
    for name, file in json.loads((folder / "c.json").read_text())["files"].items():
        found[Path(name).parts[1]].update(file["summary"])
    return found


def prepare(folder):
    """A copy of the project in which mutmut has made the mutants of the rooms and timed tests."""
    ignored = shutil.ignore_patterns("node_modules", "__pycache__")
    for name in ("dmp_teach", "tests", *(each for each in NEEDED if (ROOT / each).is_dir())):
        shutil.copytree(ROOT / name, folder / name, ignore=ignored)
    for name in ("pyproject.toml", *(each for each in NEEDED if (ROOT / each).is_file())):
        shutil.copy(ROOT / name, folder)
    settings = {
        "source_paths": ["dmp_teach"],
        "only_mutate": [f"dmp_teach/{room}/*" for room in ROOMS],
        "also_copy": NEEDED,
        "pytest_add_cli_args_test_selection": [*TESTS, "-m", "quick", "--deselect", ASKS_WHO_CALLS],
        "use_git_change_detection": ["false"],
    }
    with (folder / "setup.cfg").open("w") as file:
        file.write("[mutmut]\n")
        for name, values in settings.items():
            file.write(f"{name} = {values[0]}\n" + "".join(f"  {each}\n" for each in values[1:]))
    # No mutant has this name, so that none is tried yet.
    run(folder, "mutmut", "run", "none", must_work=False)


class Unworded(ast.NodeTransformer):
    """Code without what its texts say."""

    def visit_Constant(self, node):
        return ast.Constant("") if isinstance(node.value, str) else node


def list_mutants(folder, room):
    """Names of the mutants of a room that do more than word a text otherwise."""
    for meta in sorted((folder / "mutants" / "dmp_teach" / room).rglob("*.meta")):
        bodies = {}
        for node in ast.walk(ast.parse(meta.with_suffix("").read_text())):
            if isinstance(node, ast.FunctionDef) and "__mutmut_" in node.name:
                name, node.name = node.name, ""
                bodies[name] = ast.dump(Unworded().visit(node))
        for mutant in json.loads(meta.read_text())["exit_code_by_key"]:
            name = mutant.rsplit(".", 1)[1]
            if bodies[name] != bodies[name.rsplit("_", 1)[0] + "_orig"]:
                yield mutant


def try_mutants(folder, names):
    """What mutmut keeps of each mutant, mostly the exit code of pytest."""
    run(folder, "mutmut", "run", *names)
    codes = {}
    for meta in (folder / "mutants").rglob("*.meta"):
        codes |= json.loads(meta.read_text())["exit_code_by_key"]
    return {name: codes[name] for name in names}


def main():
    """Print the table and the mutants that live."""
    asked = argparse.ArgumentParser(
        prog="python -m tests.benchmarks.trust", description=__doc__.splitlines()[0]
    )
    asked.add_argument("--mutants", type=int, default=60, help="of each room (default 60)")
    asked.add_argument("--seed", type=int, default=1)
    asked.add_argument("--all", action="store_true", help="try every mutant, for some hours")
    options = asked.parse_args()
    folder = Path(tempfile.mkdtemp(prefix="trust_"))
    covered = measure_coverage(folder)
    prepare(folder)
    drawn = {room: list(list_mutants(folder, room)) for room in ROOMS}
    if not options.all:
        draw = random.Random(options.seed).sample
        drawn = {
            room: draw(names, min(options.mutants, len(names))) for room, names in drawn.items()
        }
    codes = try_mutants(folder, [name for names in drawn.values() for name in names])
    print(f"{'room':14}{'statements':>11}{'branches':>10}{'taken':>8}{'mutants':>9}{'noticed':>9}")
    for room, names in drawn.items():
        part, alive = covered[room], [name for name in names if codes[name] in ALIVE]
        taken = part["covered_branches"] / part["num_branches"]
        print(
            f"{room:14}{part['num_statements']:11}{part['num_branches']:10}{taken:8.1%}"
            f"{len(names):9}{1 - len(alive) / len(names):9.1%}"
        )
    alive = [name for name, code in codes.items() if code in ALIVE]
    print("", f"These live, in {folder}:", *alive, sep="\n")


if __name__ == "__main__":
    main()
