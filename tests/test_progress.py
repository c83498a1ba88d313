"""What takes longer than a second draws a bar by itself; what is quick, or within it, does not."""

import io
import sys
import threading

import pytest
from tqdm.auto import tqdm

from dmp_teach import progress
from dmp_teach.errors import SettingError
from dmp_teach.progress import progress_bar, reported, reporter, step_reporter


class Terminal(io.StringIO):
    """A stream that says it is one."""

    def isatty(self):
        return True


def put_terminal(monkeypatch):
    """Let standard error be a terminal; a fixture cannot, as pytest sets it anew before a test."""
    monkeypatch.setattr(sys, "stderr", Terminal())
    return sys.stderr


def test_a_bar_comes_after_a_second_and_goes_when_all_is_done(monkeypatch):
    terminal, clock = put_terminal(monkeypatch), [0.0]
    monkeypatch.setattr(progress, "monotonic", lambda: clock[0])
    report = reporter(None, "claims")
    report(0, 20)
    assert terminal.getvalue() == ""
    clock[0] = 1.5
    report(1, 20)
    assert "claims:   5%" in terminal.getvalue()
    report(20, 20)
    assert terminal.getvalue().endswith("\r")


def test_quick_work_work_within_work_and_work_without_a_terminal_are_silent(monkeypatch):
    terminal = put_terminal(monkeypatch)
    for done in range(3):
        reporter(None)(done, 2)
    monkeypatch.setattr(progress, "PATIENCE", 1e-9)
    with reported():
        reporter(None)(1, 2)
        step_reporter(None, "planning")("reach", 0.5)
    assert terminal.getvalue() == ""
    step_reporter(None, "planning")("joints", 0.5)
    assert "planning:  50%" in terminal.getvalue()
    monkeypatch.setattr(sys, "stderr", io.StringIO())
    reporter(None)(1, 2)
    assert sys.stderr.getvalue() == ""


def test_a_bar_needs_no_thread(monkeypatch, recwarn):
    monkeypatch.setattr(threading.Thread, "start", lambda self: 1 / 0)
    monkeypatch.setattr(tqdm, "monitor", None)
    progress_bar(stream=Terminal())(1, 2)
    assert not recwarn.list


def test_a_function_is_called_as_it_is_and_anything_else_refused():
    assert reporter(print) is print
    with pytest.raises(SettingError, match="progress is an int, but must be a function"):
        reporter(5)


def test_a_bar_is_drawn_in_place_and_ends_its_line():
    stream = io.StringIO()
    bar = progress_bar("widths", stream, width=60)
    for _ in range(2):
        for done in range(3):
            bar(done, 2)
    first, last = stream.getvalue().split("\n")[:2]
    for line in (first, last):
        assert line.startswith("\rwidths:   0%|")
        assert "\rwidths: 100%|" in line
        assert "| 2/2 [" in line
