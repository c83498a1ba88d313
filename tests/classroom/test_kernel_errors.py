"""A notebook shows one line of an error of ours; elsewhere it is a traceback like any other."""

import subprocess
import sys
from pathlib import Path

import pytest
from jupyter_client.manager import start_new_kernel

ROOT = Path(__file__).parents[2]
BEGIN = "import dmp_teach as teach"


@pytest.fixture(scope="module")
def said():
    """The lines below a cell that is run in a kernel of its own."""
    manager, client = start_new_kernel(kernel_name="python3", cwd=str(ROOT))

    def run(source):
        reply = client.execute_interactive(
            source, timeout=60, store_history=False, output_hook=lambda message: None
        )
        return reply["content"].get("ename"), "\n".join(
            reply["content"].get("traceback", [])
        ).splitlines()

    run(BEGIN)
    yield run
    client.stop_channels()
    manager.shutdown_kernel(now=True)


@pytest.mark.parametrize(
    ("source", "line"),
    [
        (
            "teach.pad().recording",
            "RecordingError: Nothing is written on the pad yet: write a letter first.",
        ),
        (
            "teach.pad('hello')",
            "RecordingError: A pad takes one letter; for words use teach.write_word('hello').",
        ),
        (
            "teach.Settings.star(kernel_width=0)",
            "SettingError: kernel_width is 0, but it must be between 0.2 and 40.",
        ),
    ],
)
def test_a_sentence_of_ours_is_one_line_below_the_cell(said, source, line):
    assert said(source) == (line.split(":")[0], [line])


def test_an_error_that_is_not_ours_keeps_its_traceback(said):
    name, lines = said("1 / 0")
    assert name == "ZeroDivisionError"
    assert len(lines) > 3


def test_outside_a_notebook_an_error_of_ours_has_its_traceback():
    code = f"{BEGIN}\nteach.recording_of('hello')"
    answer = subprocess.run(
        [sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=False
    )
    assert answer.stderr.startswith("Traceback (most recent call last)")
    assert "RecordingError: The alphabet" in answer.stderr.splitlines()[-1]
