"""What the pad says and does when the pen is lifted."""

import re
from dataclasses import replace

import numpy as np
import pytest

from dmp_teach import Letter, LetterError, pad, recording_of, use_script, write_recording
from dmp_teach.classroom.panels import attempts
from dmp_teach.classroom.panels.kept import forget
from dmp_teach.trajectory import Trajectory


@pytest.fixture(autouse=True)
def nothing_kept():
    forget("pad")


def write(panel, stroke, backwards=False):
    """Write a stroke as the browser would send it."""
    position = stroke.position[::-1] if backwards else stroke.position
    even = np.column_stack([stroke.t - stroke.t[0], position, np.ones(len(stroke))])
    panel.add_stroke(even[::2])


def said(panel):
    return "".join(panel.message[part] for part in ("text", "strong", "after"))


def test_a_missed_stroke_is_told_at_the_lift_and_written_again_in_its_place():
    panel, (stem, bar) = pad("t"), recording_of("t").strokes()
    write(panel, stem, backwards=True)
    assert said(panel).startswith("The first stroke starts at the wrong end. Start the first")
    assert panel.lift["missed"]["expected"] == 0
    assert panel.lift["ghost"] == []
    write(panel, stem)
    assert len(panel.recording.strokes()) == 1
    assert panel.lift["missed"] is None
    write(panel, bar)
    assert "looks the same" in said(panel)
    assert panel.lift == {"ghost": [], "robots": [], "missed": None}


def test_a_letter_that_is_written_with_a_lift_keeps_both_strokes_and_is_told_so():
    panel, (whole,) = pad("b"), recording_of("b").strokes()
    foot = int(np.argmin(whole.position[: len(whole) // 2, 1]))
    parts = [slice(foot + 1), slice(foot, None)]
    for part in parts:
        write(panel, Trajectory(whole.t[part], whole.position[part]))
    assert len(panel.recording.strokes()) == 2
    assert "Lift the pen less often" in said(panel)
    panel.start_again()
    # A stem that was not right is written again, as a whole.
    write(panel, Trajectory(whole.t[parts[0]], whole.position[parts[0]]))
    write(panel, whole)
    assert len(panel.recording.strokes()) == 1
    assert "looks the same" in said(panel)


def test_after_two_misses_the_stroke_is_shown_and_after_four_the_robot_writes_it():
    panel, (stem, bar) = pad("t"), recording_of("t").strokes()
    write(panel, stem)
    for miss in (1, 2, 3):
        write(panel, bar, backwards=True)
        assert len(panel.recording.strokes()) == 2
        assert (panel.lift["ghost"] != []) == (miss >= 2)
    assert np.allclose(panel.lift["ghost"], bar.position, atol=2e-3)
    write(panel, bar, backwards=True)
    assert panel.lift["robots"] == [1]
    assert panel.caught == "Stroke 2: the robot wrote it for you."
    assert (
        said(panel)
        == "The robot wrote stroke 2 for you. Start again, and write all of it yourself."
    )
    assert np.allclose(panel.recording.strokes()[1].position[0], bar.position[0], atol=2e-3)
    panel.start_again()
    assert panel.lift["ghost"] == []
    write(panel, stem)
    write(panel, bar)
    assert panel.lift["robots"] == []


def test_misses_are_counted_over_sheets_and_another_letter_has_none():
    panel, stroke = pad("o"), recording_of("o").strokes()[0]
    for _ in range(2):
        panel.start_again()
        write(panel, stroke, backwards=True)
    assert panel.lift["ghost"] != []
    panel.start_again()
    assert panel.lift["ghost"] != []
    panel.character = "c"
    assert panel.lift["ghost"] == []


def test_a_teacher_says_what_is_judged():
    stem, bar = recording_of("t").strokes()
    shifted = Trajectory(bar.t, bar.position + np.array([0.04, 0]))
    for strict, reasons in (
        (("start", "order"), (True, False)),
        (("place",), (False, True)),
        ((), (False, False)),
    ):
        panel = pad("t", strict=strict)
        for stroke, is_back, reason in ((bar, True, reasons[0]), (shifted, False, reasons[1])):
            panel.start_again()
            write(panel, stem)
            write(panel, stroke, is_back)
            assert (panel.lift["missed"] is not None) == reason, (strict, panel.message)
            assert ("wrong end" in said(panel)) == (reason and is_back)
    panel = pad("t", strict=("size",))
    write(panel, Trajectory(stem.t, stem.position * 0.5))
    assert said(panel).startswith("It is half as large as the robot’s.")
    for strict in ("start", ("beauty",), [[]], None):
        with pytest.raises(LetterError, match="strict is"):
            pad("t", strict=strict)


def test_a_left_hand_is_not_told_of_its_bars_and_a_dot_alone_is_judged_by_nobody():
    panel, (stem, bar) = pad("t", hand="left"), recording_of("t").strokes()
    write(panel, stem)
    write(panel, bar, backwards=True)
    assert panel.lift["missed"] is None
    panel.start_again()
    panel.add_stroke([[0, 0.01, 0.05, 1]])
    assert panel.lift["missed"] is None


@pytest.mark.parametrize("character", "tAi")
@pytest.mark.parametrize(("way", "words"), [((1, 0), "the right"), ((-1, 0), "the left")])
def test_a_stroke_however_far_out_of_place_is_judged_by_its_place(character, way, words):
    *before, last = recording_of(character).strokes()
    for far in (0.04, 0.11, 0.3):
        panel = pad(character)
        panel.start_again()
        for stroke in before:
            write(panel, stroke)
        write(panel, Trajectory(last.t, last.position + far * np.array(way)))
        told = re.search(rf"is (\d+) mm too far to {words}\.", said(panel))
        assert int(told[1]) == pytest.approx(1000 * far, abs=1)
        assert panel.lift["missed"]["expected"] == len(before)
        assert not any("no letter yet" in row["reason"] for row in panel.parts)


def test_where_any_way_of_writing_is_right_a_letter_ends_when_it_can_be_read():
    panel, (whole,) = pad("b", strict=()), recording_of("b").strokes()
    foot = int(np.argmin(whole.position[: len(whole) // 2, 1]))
    write(panel, Trajectory(whole.t[: foot + 1], whole.position[: foot + 1]), backwards=True)
    assert said(panel) == "This is not a b yet. Write on, or press That is all."
    assert panel.unfinished
    assert panel.lift["missed"] is None
    write(panel, Trajectory(whole.t[foot:], whole.position[foot:]))
    assert len(panel.recording.strokes()) == 2
    assert not panel.unfinished
    assert panel.parts[-1]["word"] == "the same"
    assert "looks the same" in said(panel)


def test_the_verdict_is_out_before_the_letter_is_scored_and_learned(monkeypatch):
    panel, (stem, bar) = pad("t"), recording_of("t").strokes()
    write(panel, stem)
    done = []
    learn, scored = Letter.learn, attempts.score
    monkeypatch.setattr(Letter, "learn", lambda *given: done.append("learned") or learn(*given))
    monkeypatch.setattr(attempts, "score", lambda *given: done.append("scored") or scored(*given))
    panel.observe(lambda change: done.append(said(panel)), "message")
    write(panel, bar, backwards=True)
    assert "starts at the wrong end" in done[0]
    assert set(done[1:3]) == {"scored", "learned"}


def test_tries_of_another_hand_or_script_are_not_in_the_next_pad(tmp_path):
    panel, (stem, bar) = pad("t", hand="left"), recording_of("t", hand="left").strokes()
    write(panel, stem)
    write(panel, bar)
    assert [len(pad("t", hand=hand).recordings) for hand in ("right", "left")] == [0, 1]
    panel = pad("o")
    write(panel, *recording_of("o").strokes())
    write_recording(
        replace(panel.recording, position=0.5 * panel.recording.position), tmp_path / "o.json"
    )
    try:
        use_script(tmp_path)
        panel = pad("o")
        panel.undo()
        assert (panel.tries, panel.counts) == ([], [])
    finally:
        use_script(None)
    assert len(pad("o").tries) == 1


def test_the_robot_writes_the_bar_of_a_left_hand_from_right_to_left():
    panel, (stem, bar) = pad("t", hand="left"), recording_of("t", hand="left").strokes()
    write(panel, stem)
    write(panel, bar)
    assert panel.lift["missed"] is None
    panel.write()
    motion = panel.motion
    *_, begin = np.flatnonzero(np.diff(motion.pen_down.astype(int)) == 1) + 1
    across = motion.page.to_page(motion.tip[begin:][motion.pen_down[begin:]])[:, 0]
    assert across[-1] - across[0] == pytest.approx(-np.ptp(bar.position[:, 0]), rel=0.03)
    assert np.diff(across).max() < 1e-5
