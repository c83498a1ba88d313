"""Whatever we write is there whole or not at all, whatever the disk does, and leaves no rest."""

import os
import re
import subprocess
import sys
from contextlib import contextmanager
from errno import EACCES, EIO, ENOSPC, EROFS
from functools import cache, partial
from unittest import mock

import pytest

import dmp_teach as teach
from dmp_teach.classroom.lesson.work_file import save_work
from dmp_teach.errors import PathError
from dmp_teach.files import write_whole
from dmp_teach.formats.registry import known_formats
from tests.public import INK
from tests.views.moves import sway

resource = pytest.importorskip("resource", reason="Windows has no limits of this kind")


@contextmanager
def room_for(size):
    """A disk that takes so many bytes of a file, and then no more."""
    old = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, old[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, old)


def refused(step, code):
    """A disk that refuses a step."""
    return mock.patch.object(os, step, side_effect=OSError(code, os.strerror(code)))


FAULTS = {
    "full": partial(room_for, 0),
    "full half-way": partial(room_for, 100),
    "read-only": partial(refused, "open", EROFS),
    "of somebody else": partial(refused, "open", EACCES),
    "pulled out": partial(refused, "fsync", EIO),
    "full at the last step": partial(refused, "replace", ENOSPC),
}


@cache
def writers():
    """Everything that writes a file, by the name of the file."""
    letter, shown, panel = teach.Letter.learn(INK), teach.view(sway()), teach.explore("l")
    ink = [each.suffixes[0] for each in known_formats() if each.write]
    return {f"ink{suffix}": partial(teach.write_recording, INK) for suffix in ink} | {
        "letter.json": letter.save,
        "shelf.json": teach.Shelf.of({"l": INK}).save,
        "pupil.json": teach.PupilTraits.like(teach.score(INK, INK)).save,
        "stamp.svg": partial(teach.write_stamp, letter),
        "motion.bag": partial(teach.write_rosbag, sway(), start=None),
        "motion.html": shown.html,
        "motion.png": partial(shown.png, width=64, height=64),
        "panel.html": panel.html,
        "work_w01.json": lambda path: save_work(path.parent, "w01", "03", {"bet": 1}),
    }


def left_in(folder):
    return {path.name: path.read_bytes() for path in folder.iterdir()}


@pytest.mark.parametrize("fault", FAULTS)
def test_a_disk_that_fails_leaves_what_was_there(tmp_path, fault):
    for name, write in writers().items():
        # All faults are one writer's; the others must only use it.
        if name != "ink.json" and fault not in ("full half-way", "full at the last step"):
            continue
        path = tmp_path / name
        room = "make room on the disk, or " if fault.startswith("full") else ""
        sentence = f"{re.escape(repr(str(path)))} cannot be written: .+ unchanged; {room}save in"
        for _new_then_old in range(2):
            before = left_in(tmp_path)
            with FAULTS[fault](), pytest.raises(PathError, match=sentence):
                write(path)
            assert left_in(tmp_path) == before
            write(path)


@pytest.mark.parametrize("error", [KeyboardInterrupt, MemoryError])
def test_an_interruption_leaves_what_was_there(tmp_path, error):
    with mock.patch.object(os, "fsync", side_effect=error), pytest.raises(error):
        write_whole(tmp_path / "a.json", b"new", ".json")
    assert left_in(tmp_path) == {}


# Each step, and the middle of the longest, ends the program that does it.
KILLED = """
import os, resource, signal, sys
from pathlib import Path
from dmp_teach.files import write_whole

path, old, new = Path(sys.argv[1]), b"old", b"new" * 100_000
resource.setrlimit(resource.RLIMIT_CORE, (0, 0))

def killed_at(step, is_done):
    def kill(*arguments, real=getattr(os, step), **more):
        if is_done:
            real(*arguments, **more)
        os.kill(os.getpid(), signal.SIGKILL)
    return lambda: setattr(os, step, kill)

def killed_half_way():
    signal.signal(signal.SIGXFSZ, signal.SIG_DFL)
    resource.setrlimit(resource.RLIMIT_FSIZE, (len(new) // 2,) * 2)

steps = ("open", "fsync", "chmod", "replace")
for fall in [killed_half_way, *(killed_at(step, done) for step in steps for done in (False, True))]:
    write_whole(path, old, ".json")
    if os.fork() == 0:
        fall()
        write_whole(path, new, ".json")
        os._exit(0)
    assert os.WIFSIGNALED(os.wait()[1])
    assert path.read_bytes() in (old, new)
"""


def test_who_is_killed_leaves_a_whole_file_and_the_next_to_write_finds_the_rest(tmp_path):
    path = tmp_path / "a.json"
    subprocess.run([sys.executable, "-c", KILLED, str(path)], check=True)
    rests = set(tmp_path.iterdir()) - {path}
    assert rests
    write_whole(path, b"new", ".json")
    assert set(tmp_path.iterdir()) == {path, *rests}, "somebody may still write them"
    for n, rest in enumerate(sorted(rests)):
        # A clock may have been set back since.
        os.utime(rest, (0, (0, 2**32)[n % 2]))
    write_whole(path, b"newer", ".json")
    assert left_in(tmp_path) == {"a.json": b"newer"}
