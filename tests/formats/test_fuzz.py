"""Files from strangers: broken off, shuffled or forged, each is a letter or a sentence, soon.

Every reader gets good files of each format with something done to them. What comes out must be
recordings with finite numbers, or a RecordingError that names the file; in seconds, and without
much memory.
"""

import io
import json
import pickle
import re
import subprocess
import sys
import tempfile
import zlib
from importlib import import_module
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, example, given, settings
from hypothesis import strategies as st

from dmp_teach.errors import RecordingError
from dmp_teach.formats.read import read_recordings
from dmp_teach.formats.registry import known_formats
from dmp_teach.formats.write import write_recording
from dmp_teach.ink.alphabet import recording_of

HUGE = [
    "1e308",
    "-1e308",
    "1" + "0" * 400,
    "NaN",
    "Infinity",
    "-1",
    "0",
    "null",
    "1e-320",
    "2147483648",
    "#ffffffffffff",
]
QUIET = settings(max_examples=40, deadline=None, suppress_health_check=list(HealthCheck))
THOROUGH = settings(max_examples=5000, deadline=None, suppress_health_check=list(HealthCheck))


def good_files():
    """What is written of a letter in every format, and what the formats' own tests offer."""
    files, here = {}, Path(__file__).parent
    with tempfile.TemporaryDirectory() as folder:
        for suffix in WRITTEN:
            path = write_recording(recording_of("i"), Path(folder) / f"written{suffix}")
            files[path.name] = path.read_bytes()
        for path in sorted(here.glob("test_*.py")):
            if path.name != Path(__file__).name and "def good_files" in path.read_text("utf-8"):
                files |= import_module(f"tests.formats.{path.stem}").good_files(Path(folder))
    return files


SUFFIXES = [suffix for each in known_formats() for suffix in each.suffixes]
WRITTEN = [each.suffixes[0] for each in known_formats() if each.write]
FILES = good_files()


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_every_format_gives_files_to_be_damaged(suffix):
    assert [name for name in FILES if name.endswith(suffix)], "its tests need a good_files(folder)"


def letters_or_a_sentence(path, data):
    """Read a file; whatever happens must be one of the two."""
    path.write_bytes(data)
    try:
        letters = read_recordings(path)
    except RecordingError as caught:
        sentence = str(caught)
        assert path.name in sentence
        assert sentence.rstrip()[-1] in ".?)"
        assert len(sentence) < 1500
        return None
    assert letters
    for letter in letters:
        assert np.isfinite(letter.position).all()
        assert (np.diff(letter.t) > 0).all()
        assert np.abs(letter.position).max() < 1e6
    return letters


@pytest.mark.parametrize("name", FILES)
def test_good_files_are_read(tmp_path, name):
    assert letters_or_a_sentence(tmp_path / name, FILES[name])


@pytest.mark.slow
@pytest.mark.parametrize("name", FILES)
def test_files_that_are_broken_off_anywhere(tmp_path, name):
    data = FILES[name]
    for end in np.unique(np.linspace(0, len(data) - 1, 60).astype(int)):
        letters_or_a_sentence(tmp_path / name, data[:end])


def words(text):
    """A file's words, numbers and signs, for shuffling."""
    return [word for word in re.split(rb"([\s,<>\"'{}\[\]():=]+)", text) if word]


@st.composite
def mutation(draw):
    """What is done to a file: a function of its bytes."""
    kind = draw(
        st.sampled_from(
            ["bytes", "flip", "swap", "repeat", "delete", "word", "huge", "insert", "encode"]
        )
    )
    seed, share = draw(st.integers(0, 2**32)), draw(st.floats(0, 0.999))
    piece = draw(st.binary(min_size=1, max_size=12))
    huge = draw(st.sampled_from(HUGE))
    return lambda data: _mutated(
        data, kind, np.random.default_rng(seed), share, (piece, huge.encode())
    )


def _mutated(data, kind, random, share, inserted):
    """One of the things that happen to files."""
    at, (piece, huge) = int(share * len(data)), inserted
    changed = data
    if kind == "bytes":
        changed = data[:at] + piece + data[at + len(piece) :]
    elif kind == "insert":
        changed = data[:at] + piece + data[at:]
    elif kind == "delete":
        changed = data[:at] + data[at + 1 + random.integers(200) :]
    elif kind == "repeat":
        changed = (
            data[:at]
            + data[at : at + 1 + random.integers(200)] * int(random.integers(2, 30))
            + data[at:]
        )
    elif kind == "flip":
        bits = np.frombuffer(data, np.uint8).copy()
        for k in random.integers(len(bits), size=random.integers(1, 9)):
            bits[k] ^= 1 << random.integers(8)
        changed = bits.tobytes()
    elif kind == "encode":
        text = data.decode("latin-1")
        ways = [
            text.encode("utf-16"),
            text.encode("utf-8-sig"),
            data.replace(b"\n", b"\r\n"),
            b"\0" + data,
            data + b"\0",
        ]
        changed = ways[at % 5]
    elif len(parts := words(data)) > 1:
        changed = _shuffled(parts, kind, random, share, huge)
    return changed or b" "


def _shuffled(parts, kind, random, share, huge):
    """Words that change places, or a number that becomes another."""
    a, b = (int(k) for k in random.integers(len(parts), size=2))
    numbers = [k for k, part in enumerate(parts) if part[:1] in b"-0123456789"] or [a]
    place = numbers[int(share * len(numbers))]
    if kind == "swap":
        parts[a], parts[b] = parts[b], parts[a]
    else:
        parts[place] = huge if kind == "huge" else parts[b]
    return b"".join(parts)


def run(path, data, changes):
    for change in changes:
        data = change(data)
    letters_or_a_sentence(path, data)


@pytest.mark.parametrize("name", FILES)
@QUIET
@given(changes=st.lists(mutation(), min_size=1, max_size=3))
def test_damaged_files(tmp_path, name, changes):
    run(tmp_path / name, FILES[name], changes)


@pytest.mark.thorough
@pytest.mark.parametrize("name", FILES)
@THOROUGH
@given(changes=st.lists(mutation(), min_size=1, max_size=4))
def test_many_damaged_files(tmp_path, name, changes):
    run(tmp_path / name, FILES[name], changes)


tree = st.recursive(
    st.none()
    | st.booleans()
    | st.integers(-(10**400), 10**400)
    | st.floats()
    | st.text(max_size=5),
    lambda inner: (
        st.lists(inner, max_size=4) | st.dictionaries(st.text(max_size=3), inner, max_size=3)
    ),
    max_leaves=6,
)


@QUIET
@given(
    field=st.sampled_from(
        ["character", "writer", "baseline", "units", "strokes", "pressure", "samples", "version"]
    ),
    value=tree,
)
@example(field="samples", value=[[10**400, 0, 0, 0]])
@example(field="strokes", value=[[0, 2**70]])
def test_fields_of_any_kind_in_our_json(tmp_path, field, value):
    content = json.loads(FILES["written.json"])
    content[field] = value
    letters_or_a_sentence(tmp_path / "a.json", json.dumps(content).encode())


digits = st.text("0123456789.,-+eE#TF*?!'\" \n", max_size=60)


@QUIET
@given(digits)
@example("1 2, 3 4, '*'*, \"1\"1")
def test_traces_of_any_signs(tmp_path, text):
    body = f"<ink><trace>{text.replace('<', '')}</trace><trace>0 0, 10 10</trace></ink>"
    letters_or_a_sentence(tmp_path / "a.inkml", body.encode())


@QUIET
@given(
    way=st.text("MmLlHhVvCcSsQqTtAaZz0123456789.,-eE ", max_size=60),
    turn=st.text("matrixscleo()0123456789.,- ", max_size=30),
)
def test_paths_of_any_signs(tmp_path, way, turn):
    letters_or_a_sentence(
        tmp_path / "a.svg",
        f'<svg stroke="red"><g transform="{turn}"><path d="M0 0L9 9{way}"/></g></svg>'.encode(),
    )


LAUGHS = "".join(f'<!ENTITY l{k} "{f"&l{k - 1};" * 10}">' for k in range(1, 12))
VIEW = '<traceView traceDataRef="#a"/>'
POISON = {
    "billion laughs": f'<!DOCTYPE ink [<!ENTITY l0 "1 2,">{LAUGHS}]><ink><trace>&l11;</trace>'
    f"</ink>",
    "quadratic": f'<!DOCTYPE ink [<!ENTITY a "{"1 2," * 9999}">]><ink><trace>'
    f"{'&a;' * 9999}</trace></ink>",
    "a file": '<!DOCTYPE ink [<!ENTITY a SYSTEM "file:///etc/hostname">]><ink><trace>&a;</trace>'
    "</ink>",
    "a net": '<!DOCTYPE ink [<!ENTITY % a SYSTEM "http://127.0.0.1:9/x"> %a;]><ink><trace>'
    "1 2</trace></ink>",
    "an outside DTD": '<!DOCTYPE ink SYSTEM "http://127.0.0.1:9/x"><ink><trace>&a;</trace></ink>',
    "a style from outside": '<?xml-stylesheet href="file:///etc/hostname"?><svg><style>'
    "@import url(x)</style></svg>",
    "a picture": '<svg><image href="file:///etc/hostname"/><script>alert(1)</script></svg>',
    "foreign markers": '<svg stroke="red"><path d="M0 0L9 9" '
    'marker-end="url(file:///etc/hostname#a)" '
    'style="fill:url(x#y)"/></svg>',
    "clones of clones": '<svg><use id="a" href="#b"/><use id="b" href="#a"/></svg>',
    "deep": "<svg>" + "<g>" * 100_000,
    "many": "<svg>" + "<g/>" * 200_000 + "</svg>",
    "wide": "<svg " + " ".join(f'a{k}="1"' for k in range(100_000)) + "/>",
    "contexts in a ring": '<ink><context xml:id="a" contextRef="#a"/><trace contextRef="#a">'
    "1 2</trace></ink>",
    "parts of themselves": '<ink><trace xml:id="a" continuation="end" priorRef="#a">'
    "0 0, 10 10</trace></ink>",
    "a group of itself": '<ink><traceGroup xml:id="a"><annotation type="truth">a</annotation>'
    '<traceView traceDataRef="#a"/></traceGroup></ink>',
    "an odd encoding": '<?xml version="1.0" encoding="utf-7"?><ink/>',
    "no encoding": '<?xml version="1.0" encoding="nonsense"?><ink/>',
    "spaces": f'<svg width="5{" " * 500_000}!"/>',
    "digits": f'<svg width="{"1" * 500_000}!"/>',
    "numbers in a path": f'<svg stroke="red"><path d="M0 0{"1" * 500_000}"/></svg>',
    "commas": f'<svg stroke="red"><path d="M0 0L{", " * 200_000}"/></svg>',
    "arcs": f'<svg stroke="red"><path d="M0 0{"a1 2 3 0 1 4 5" * 5_000}"/></svg>',
    "moves": f'<svg stroke="red"><path d="{"M0 0L9 9" * 50_000}"/></svg>',
    "brackets": "[" * 1_000_000,
    "braces": '{"a":' * 200_000,
    "a long number": '{"format": ' + "1" * 1_000_000 + "}",
    "quotes": f"<ink><trace>{chr(39) * 500_000}</trace></ink>",
    "stars": f"<ink><trace>1'1 1'1,{'* *,' * 200_000}</trace></ink>",
    "comments in a sheet": f"<svg><style>{'/*/' * 3_000_000}</style></svg>",
    "braces in a sheet": f"<svg><style>{'{' * 5_000_000}</style></svg>",
    "media in a sheet": f"<svg><style>{'@media screen{' * 500_000}</style></svg>",
    "selectors": f"<svg><style>{'.a,' * 2_000_000}a{{fill:red}}</style></svg>",
    "classes": f"<svg><style>.a{{fill:red}}</style>"
    f'<path d="M0 0L9 9" class="{"a " * 2_000_000}"/></svg>',
    "styles": f'<svg stroke="red"><path d="M0 0L9 9" style="{"fill:red;" * 1_000_000}"/></svg>',
    "views": f'<ink><trace xml:id="a">0 0, 9 9</trace>{VIEW * 90_000}</ink>',
    "many markers": f",,{'Marker,' * 60_000}\n,,{'a,' * 60_000}\n,,{'Position,' * 60_000}\n"
    f"Frame,Time,{'X,Y,Z,' * 20_000}\n" + "".join(f"{k},{k / 100},1\n" for k in range(200_000)),
    "names of colons": ",,Rigid Body,Marker,Marker,Marker\n,,a,"
    + f"{':' * 100_000}," * 3
    + "\n,,,Position,Position,"
    "Position\nFrame,Time,,X,Y,Z\n1,0,0,1,1,1",
    "cells": "Frame,Time\n" + "," * 2_000_000,
    "segments": ".COORD X Y\n"
    + ".PEN_DOWN\n1 1\n" * 50_000
    + ".SEGMENT CHARACTER 0-49999 OK\n" * 50_000,
    "points": ".COORD X Y\n.PEN_DOWN\n" + "1 1 " * 3_000_000,
    "rows": "\n" * 2_000_000 + "x",
}


@pytest.fixture(scope="module")
def poison(tmp_path_factory):
    """Every poisoned file read in one program of its own, in 3 GB and 90 seconds."""
    folder = tmp_path_factory.mktemp("poison")
    for k, text in enumerate(POISON.values()):
        (folder / f"{k}.txt").write_bytes(text.encode())
    (folder / f"{len(POISON)}.txt").write_bytes(zlib.compress(bytes(10_000_000)))
    return read_alone(folder, len(POISON) + 1)


READ = """
import resource, sys, time
from dmp_teach.errors import RecordingError
from dmp_teach.formats.read import read_recordings
resource.setrlimit(resource.RLIMIT_AS, (3_000_000_000,) * 2)
resource.setrlimit(resource.RLIMIT_CPU, (90, 90))
for k in range(int(sys.argv[2])):
    begun = time.process_time()
    try:
        said = f"{len(read_recordings(f'{sys.argv[1]}/{k}.txt'))} letters"
    except RecordingError as error:
        said = repr(str(error)[:300])
    # Not ru_maxrss, which begins with what the program that started this one had.
    status = dict(line.split(":", 1) for line in open("/proc/self/status"))
    room = status["VmHWM"].split()[0]
    print(k, f"{time.process_time() - begun:.2f}", room, said, sep="\\t", flush=True)
"""


def read_alone(folder, count):
    """What one program says of each file: seconds, kilobytes at most so far, and its sentence."""
    done = subprocess.run(
        [sys.executable, "-c", READ, str(folder), str(count)],
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )
    assert done.returncode == 0, done.stderr[-2000:]
    return [line.split("\t") for line in done.stdout.splitlines()]


@pytest.mark.slow
def test_no_poison_takes_long_or_much_room(poison):
    names = [*POISON, "packed bytes"]
    assert len(poison) == len(names)
    slow = {
        name: row
        for name, row in zip(names, poison, strict=True)
        if float(row[1]) > 8 or int(row[2]) > 900_000
    }
    assert slow == {}


@pytest.mark.slow
def test_no_poison_reaches_a_file_or_the_net(poison):
    said = dict(zip(POISON, (row[3] for row in poison), strict=False))
    for name in ("billion laughs", "quadratic", "a file", "a net"):
        assert "defines the entity" in said[name], said[name]
    for name in ("an outside DTD", "a style from outside", "a picture"):
        assert "letters" not in said[name].split()[1:2], said[name]
    assert said["foreign markers"] == "1 letters"
    assert "unlink clones" in said["clones of clones"]


class Trap:
    """Would say so if it were unpickled."""

    def __reduce__(self):
        return (exec, ("raise SystemExit('a pickle was run')",))


@pytest.mark.parametrize("suffix", [*SUFFIXES, ".npy", ".pkl", ""])
def test_no_pickle_is_ever_run(tmp_path, suffix):
    array = io.BytesIO()
    np.save(array, np.array([Trap()], dtype=object), allow_pickle=True)
    for data in (pickle.dumps(Trap()), array.getvalue(), pickle.dumps(Trap(), protocol=0)):
        assert letters_or_a_sentence(tmp_path / f"a{suffix}", data) is None
