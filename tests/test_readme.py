"""What the README shows is what one gets."""

import re
from pathlib import Path

ROOT = Path(__file__).parents[1]
README = (ROOT / "README.md").read_text(encoding="utf-8")


def test_the_quick_start_prints_what_the_readme_says(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    code = re.search(r"```python\n(.*?)```", README, re.DOTALL).group(1)
    shown = re.findall(r">>> (\w+)\n(.+)", re.search(r"```text\n(.*?)```", README, re.DOTALL).group(1))
    names = {}
    exec(code, names)
    assert len(shown) == 3
    for name, text in shown:
        assert repr(names[name]) == text
    assert (tmp_path / "a.html").stat().st_size <= 800_000


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
