"""What is said of a stroke when the pen is lifted, while the rest is still to come."""

from itertools import cycle

import numpy as np
import pytest

from dmp_teach import LetterError, judge_stroke, read_recording, recording_of, score
from dmp_teach.ink import alphabet
from dmp_teach.trajectory import Trajectory
from tests.recordings import RECORDINGS, needs_recordings
from tests.scoring import faulty
from tests.studies.pupils import Pupil

PLAIN = [each for each in alphabet.characters() if each.isascii()]


def seeded(far, characters):
    """Yield letters up to a stroke with one fault: strokes, model, that stroke and its fault."""
    rng = np.random.default_rng(0)
    for character in characters:
        model = list(recording_of(character).strokes())
        loose = faulty.loose(model, 0.015, rng)
        for number, stroke in enumerate(loose):
            so_far = loose[: number + 1]
            if np.ptp(stroke.position, axis=0).max() > 0.015:
                yield faulty.backwards(so_far, number), model, number, ("start", "direction")
            for begin, end in faulty.loops(model[number]):
                if end - begin < 0.95:
                    turned = faulty.turned_back(so_far, number, begin, end)
                    yield turned, model, number, ("direction", "start")
            for other in range(number + 1, len(model)):
                yield [*loose[:number], loose[other]], model, other, ("order",)
            for way in np.vstack([np.eye(2), -np.eye(2)]) if number else ():
                yield faulty.moved(so_far, number, far * way), model, number, ("place",)


def test_of_seeded_faults_the_stroke_and_the_reason_are_told():
    found = []
    for written, model, number, reasons in seeded(0.3, PLAIN[::2]):
        verdict = judge_stroke(written, model)
        found.append(verdict.stroke == number and verdict.reason in reasons)
        assert verdict.good == (verdict.reason == "")
        assert "\n" not in str(verdict)
    assert len(found) > 100
    assert np.mean(found) >= 0.95


def test_who_writes_as_taught_is_seldom_stopped():
    alarms, count = [], 0
    for seed, character in zip(cycle((11, 12, 13)), PLAIN, strict=False):
        model, written = recording_of(character).strokes(), Pupil(seed).writes(character).strokes
        for n in range(len(written) if len(written) == len(model) else 0):
            verdict = judge_stroke(written[: n + 1], model)
            alarms += [] if (verdict.stroke, verdict.reason) == (n, "") else [(character, verdict)]
            count += 1
    assert len(alarms) <= 0.02 * count, alarms


@needs_recordings
def test_real_letters_with_the_models_strokes_are_good_at_each_lift():
    judged = 0
    for path in RECORDINGS:
        recording = read_recording(path)
        model, written = recording_of(recording.character).strokes(), recording.strokes()
        for n in range(len(written) if len(written) == len(model) else 0):
            assert judge_stroke(written[: n + 1], model).good, (path.name, n)
            judged += 1
    assert judged > 10


@pytest.mark.parametrize(("character", "number"), [("t", 1), ("E", 3), ("o", 0), ("4", 1)])
def test_the_last_lift_says_what_the_score_of_the_whole_says(character, number):
    written = faulty.backwards(list(recording_of(character).strokes()), number)
    verdict, whole = (
        judge_stroke(written, recording_of(character)),
        score(written, recording_of(character)),
    )
    assert (verdict.sentence, verdict.reason != "") == (whole.sentence, True)


def test_a_left_hand_pulls_the_bar_and_a_scribble_is_no_stroke():
    model = list(recording_of("t").strokes())
    written = faulty.backwards(model, 1)
    assert judge_stroke(written, model).reason == "start"
    assert judge_stroke(written, model, hand="left").good
    t = np.linspace(0, 4, 200)
    scribble = np.column_stack([0.05 * np.sin(9 * t), 0.05 + 0.05 * np.sin(23 * t)])
    verdict = judge_stroke([Trajectory(t, scribble)], model)
    assert (verdict.stroke, verdict.due, verdict.reason) == (None, 0, "unlike")
    with pytest.raises(LetterError, match="written must be"):
        judge_stroke("t", model)
