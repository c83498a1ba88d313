"""Real recordings, cut where a person would cut them, and writers drawn by lot."""

import csv
from itertools import groupby
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dmp_teach.formats.read import read_recording
from dmp_teach.segmentation.strokes import find_strokes
from tests.recordings import RECORDINGS, needs_recordings
from tests.segmentation.writers import HABITS, take

GRID = [(0.10, s) for s in (0.003, 0.006, 0.009, 0.012)] + [
    (0.08, s) for s in (0.003, 0.005, 0.008, 0.010)
]
NEAR = 0.05  # how near to the label an end must be [s]


def labels():
    """The strokes of each labelled take: rows of times [s], by the name of the file."""
    lines = (Path(__file__).parent / "labels.csv").read_text(encoding="utf-8").splitlines()
    rows = csv.DictReader(line for line in lines if not line.startswith("#"))
    return {name: list(strokes) for name, strokes in groupby(rows, lambda row: row["take"])}


LABELS = labels()
LABELLED = [path for path in RECORDINGS if path.stem in LABELS]


def number(row, name):
    return float(row[name]) if row[name] else None


def test_labels_are_in_order():
    for name, strokes in LABELS.items():
        times = [number(row, key) for row in strokes for key in ("touch", "moves", "stops", "lift")]
        assert [int(row["stroke"]) for row in strokes] == list(range(len(strokes)))
        assert (np.diff([t for t in times if t is not None]) >= 0).all(), name


@pytest.mark.slow
@needs_recordings
@pytest.mark.parametrize("path", LABELLED, ids=[path.stem for path in LABELLED])
def test_a_recording_is_cut_where_a_person_would_cut_it(path):
    recording, strokes = read_recording(path), LABELS[path.stem]
    for theta, sigma in GRID:
        found = recording.strokes(theta, sigma)
        assert len(found) == len(strokes), (theta, sigma)
        for stroke, row in zip(found, strokes, strict=True):
            assert abs(stroke.t[0] - number(row, "moves")) <= NEAR, (theta, sigma)
            assert abs(stroke.t[-1] - number(row, "stops")) <= NEAR, (theta, sigma)


def ends(drawn):
    """How far ends lie from the time between touch and first move, or last move and lift [s]."""
    found = find_strokes(drawn.t, drawn.page)
    if len(found) != len(drawn.ink):
        return np.array([np.inf])
    off = []
    for (a, b), (touch, moves, stops, lift) in zip(found, drawn.ink, strict=True):
        first, last = drawn.t[a], drawn.t[b - 1]
        off += [first - np.clip(first, moves if touch is None else touch, moves)]
        off += [last - np.clip(last, stops, stops if lift is None else lift)]
    return np.abs(off)


@pytest.mark.slow
@pytest.mark.parametrize("habit", HABITS)
def test_writers_drawn_by_lot_are_cut_where_their_pens_wrote(habit):
    """No dots (i): who rests beside a dot smaller than the marker's noise made no stroke."""
    off = [ends(take(seed, habit=habit, letters="aDBePM")) for seed in range(25)]
    assert np.mean([each.max() < np.inf for each in off]) >= 0.95
    off = np.concatenate([each for each in off if each.max() < np.inf])
    assert np.mean(off <= NEAR) >= 0.95
    assert np.median(off) <= 0.01


@settings(max_examples=25, deadline=None, derandomize=True)
@given(st.integers(0, 10**6), st.floats(0.02, 0.06), st.floats(-10.0, 1000.0))
def test_neither_the_thresholds_nor_the_clock_change_the_count(seed, lift, later):
    drawn = take(seed, letters="aDBePM", lift=lift, wander=0.005, noise=0.0001)
    counts = {len(find_strokes(drawn.t, drawn.page, theta, sigma)) for theta, sigma in GRID}
    assert counts == {len(drawn.ink)}
    moved = find_strokes(drawn.t + later, drawn.page)
    assert np.abs(np.subtract(moved, find_strokes(drawn.t, drawn.page))).max() <= 1
