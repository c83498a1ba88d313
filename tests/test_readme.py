"""What the README shows is what one gets."""

import math
import re
from pathlib import Path

import dmp_teach as teach

ROOT = Path(__file__).parents[1]
README = (ROOT / "README.md").read_text(encoding="utf-8")


def test_the_quick_start_prints_what_the_readme_says(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    code = re.search(r"```python\n(.*?)```", README, re.DOTALL).group(1)
    shown = re.findall(
        r">>> (\w+)\n(.+)", re.search(r"```text\n(.*?)```", README, re.DOTALL).group(1)
    )
    names = {}
    exec(code, names)
    assert len(shown) == 3
    for name, text in shown:
        assert repr(names[name]) == text
    assert (tmp_path / "a.html").stat().st_size <= 800_000


SLOW = {"reach_map", "claims", "explore"}  # they have tests of their own


def test_what_is_one_line_works_as_it_stands(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    a1, a2, D = (teach.recording_of(*which) for which in (("a",), ("a", "slanted"), ("D",)))
    letter = teach.Letter.learn(a1)
    teach.write_recording(a1, "a.svg")
    names = {
        "teach": teach,
        "recording": a1,
        "a1": a1,
        "a2": a2,
        "D": D,
        "letter": letter,
        "strokes": letter.write(),
    }
    table = README.split("What else is one line")[1].split("## ")[0]
    lines = re.findall(r"`((?:pad = )?(?:teach|letter)\.[^`]*\)[.\w]*(?:; pad)?)`", table)
    tried = [line for line in lines if re.search(r"\w+(?=\()", line).group() not in SLOW]
    assert len(tried) >= 10
    for line in tried:
        exec(line, names)
    assert type(names["pad"].recordings) is tuple


def test_what_star_is_stands_in_the_table():
    star = teach.Settings.star()
    for seconds, samples in ((3.0, 360), (0.5, 60)):
        told = star.resolved(seconds, samples)
        assert told.n_kernels == round(12 * seconds)
        assert told.alpha == max(12, 2 * told.n_kernels)
    # The spring's beta is alpha / (4 damping^2), and a Gaussian without a hump is a box.
    assert (star.damping, star.smoothing, star.kernel_width) == (1.0, 10.0, 1.0)
    assert star.kernel_sigma == math.inf
    assert star.feed_goal
    assert star.sharpen
    ours = [line.split("|")[-2].strip() for line in README.splitlines() if line.startswith("  | ")]
    assert {"12 for each second", "2 N (at least 12), alpha/4", "smoothed at 10 Hz"} <= set(ours)


def test_every_name_in_the_readme_is_there():
    for name in re.findall(r"\bteach\.(\w+)", README):
        assert getattr(teach, name) is not None


def test_the_two_commands_are_the_first_lines():
    lines = [line for line in README.splitlines() if line.startswith("python3 ")]
    assert [line.split("#")[0].split() for line in lines] == [
        ["python3", "-m", "dmp_teach", word] for word in ("lab", "test")
    ]
    assert README.index("python3 -m dmp_teach lab") < 60


def test_every_file_that_the_readme_shows_or_links_is_there():
    for target in re.findall(r"\]\(([^)#:]+)\)", README):
        assert (ROOT / target).is_file(), target


def test_every_room_of_the_map_is_there():
    for name in re.findall(r"^\| `([\w/]+)`", README, re.MULTILINE):
        assert (ROOT / name).exists(), name


def test_the_page_on_a_schools_letters_runs_as_it_stands(tmp_path, monkeypatch):
    page = (ROOT / "docs" / "your_schools_letters.md").read_text(encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    (tmp_path / "my_school").mkdir()
    teach.write_recording(teach.recording_of("a", "slanted"), tmp_path / "my_school" / "a_w01.json")
    names: dict = {}
    try:
        for block in re.findall(r"```python\n(.*?)```", page, re.DOTALL):
            exec(block, names)
    finally:
        teach.use_script(None)
