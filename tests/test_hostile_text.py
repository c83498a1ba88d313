"""A text of a file from a stranger runs nowhere, and what we write loads nothing from elsewhere."""

import json
from html.parser import HTMLParser

import pytest

import dmp_teach as teach
from dmp_teach.studies.tables import html_table

TRAP = "\"'></title></script><script>alert(1)</script><img src=//evil.example onerror=alert(2)>"


class Dangers(HTMLParser):
    """Tags and attributes of a page or picture that run something or fetch something."""

    def __init__(self, text):
        super().__init__()
        self.scripts, self.found, self.policy = 0, [], ""
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        self.scripts += tag == "script"
        for name, value in attributes:
            fetches = name in ("src", "href", "xlink:href", "srcset", "action", "data")
            if name.startswith("on") or (fetches and not value.startswith(("#", "data:", "blob:"))):
                self.found.append(f"{tag} {name}={value}")
            if value and "default-src" in value:
                self.policy = value


@pytest.fixture(scope="module")
def stranger(tmp_path_factory):
    """A recording of a file whose every free text is a trap."""
    path = tmp_path_factory.mktemp("hostile") / "a.json"
    teach.write_recording(teach.recording_of("a"), path)
    path.write_text(json.dumps(json.loads(path.read_text()) | {"character": TRAP, "writer": TRAP}))
    recording = teach.read_recording(path)
    assert recording.character == TRAP
    return recording


def worksheet(recording, folder):
    teach.figures.draw_worksheet([recording]).savefig(folder / "sheet.svg")
    return folder / "sheet.svg"


PICTURES = {
    "below a cell": lambda recording, folder: recording._repr_svg_(),
    "file of ink": lambda recording, folder: teach.write_recording(recording, folder / "a.svg"),
    "InkML": lambda recording, folder: teach.write_recording(recording, folder / "a.inkml"),
    "stamp": lambda recording, folder: teach.write_stamp(
        teach.Letter.learn(recording), folder / "stamp.svg"
    ),
    "worksheet": worksheet,
    "still panel": lambda recording, folder: teach.explore(recording).draw_still().html(),
    "table": lambda recording, folder: html_table([{recording.character: TRAP}], {}),
    "panel": lambda recording, folder: teach.explore(recording).html(folder / "a.html"),
}


@pytest.mark.parametrize("name", PICTURES)
def test_what_is_made_of_it_runs_and_fetches_nothing(stranger, tmp_path, name):
    made = PICTURES[name](stranger, tmp_path)
    text = made if isinstance(made, str) else made.read_text(encoding="utf-8")
    dangers = Dangers(text)
    assert dangers.found == []
    assert dangers.scripts == (2 if name == "panel" else 0)
    assert ("default-src 'none'" in dangers.policy) == (name == "panel")


def test_such_a_text_would_be_seen():
    assert Dangers(TRAP).scripts == 1
    assert len(Dangers(TRAP).found) == 2
