"""Laws of the two readings of the paper's rule, beside the rule of the local foot."""

import numpy as np
import pytest

from dmp_teach.errors import RecordingError, SettingError
from dmp_teach.ink.recording import Recording
from dmp_teach.segmentation.paper_rules import RULES
from tests.formats.motive_csv import Pen, bar, bowl


def written(slope=(0.0, 0.0), **given):
    pen = Pen(slope=slope).rest(0.5).draw(bar()).hop((0.0, 0.0), lift=0.04).draw(bowl()).rest(0.5)
    t, page = pen.sampled(noise=0.0)
    return Recording(t, page, **given), pen


def test_the_foot_is_the_rule_that_is_taken():
    recording, _ = written()
    assert [len(s) for s in recording.strokes()] == [len(s) for s in recording.strokes(rule="foot")]


def test_the_authors_reading_cuts_where_the_pen_rises_fast_or_is_far_from_its_mean_height():
    recording, _ = written()
    z, t = recording.position[:, 2], recording.t
    up = (np.gradient(z, t) > 0.10) | (np.abs(z - z.mean()) > 0.006)
    inked = np.isin(t, np.concatenate([stroke.t for stroke in recording.strokes(rule="meant")]))
    assert not (inked & up).any()
    assert len(recording.strokes(rule="meant")) == 2


def test_to_the_letter_a_stroke_ends_only_while_it_rises_near_the_mean_and_begins_in_the_air():
    recording, pen = written()
    first, second = recording.strokes(rule="printed")
    assert first.t[-1] > pen.touches[0][1]
    assert second.t[0] < pen.touches[1][0] - 0.1


def test_a_page_that_leans_breaks_the_mean_height_and_not_the_foot():
    recording, pen = written(slope=(0.0, 0.1))
    ends = [(s.t[0], s.t[-1]) for s in recording.strokes()]
    assert np.abs(np.array(ends) - pen.touches).max() < 0.05
    ends = [(s.t[0], s.t[-1]) for s in recording.strokes(rule="meant")]
    assert len(ends) != 2 or np.abs(np.array(ends) - pen.touches).max() > 0.05


@pytest.mark.parametrize("rule", ["feet", "", None, 3, ["foot"]])
def test_an_unknown_rule_names_those_that_there_are(rule):
    for given in (None, ((0, 50),)):
        with pytest.raises(
            SettingError, match=r"rule is .*must be one of 'foot', 'printed', 'meant', 'authors'"
        ):
            written(given_strokes=given)[0].strokes(rule=rule)


@pytest.mark.parametrize("rule", RULES)
def test_every_rule_wants_positive_thresholds_and_keeps_given_strokes(rule):
    with pytest.raises(SettingError, match="sigma is -1"):
        written()[0].strokes(sigma=-1, rule=rule)
    (kept,) = written(given_strokes=((10, 50),))[0].strokes(rule=rule)
    assert len(kept) == 40


def test_a_rule_that_finds_nothing_says_so():
    t = np.arange(100) / 100
    page = np.column_stack([t, t, np.where(np.arange(100) % 2, 0.1, -0.1)])
    with pytest.raises(RecordingError, match="never on the paper; try a larger sigma"):
        Recording(t, page).strokes(rule="meant")
