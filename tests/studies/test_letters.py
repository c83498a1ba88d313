"""Letters drawn again, a P made of a D, and whose hand it is."""

import numpy as np
import pytest

from dmp_teach.dmp.settings import Settings
from dmp_teach.ink.alphabet import alphabets, recording_of
from dmp_teach.ink.recording import Recording
from dmp_teach.studies.experiments.d_to_p import make_p_from_d
from dmp_teach.studies.experiments.random_ink import INK_KINDS, draw_random_ink, learn_random_ink
from dmp_teach.studies.experiments.redraw import redraw_at_widths, redraw_letters, width_name
from dmp_teach.studies.experiments.stroke_segmentation import compare_segmentation
from dmp_teach.studies.inputs import list_letters, own_recordings
from dmp_teach.trajectory import Trajectory
from tests.dmp.ink import letter

DS = [recording_of("D", alphabet) for alphabet in alphabets()]


def turned_about(recording):
    """The bowl first, then the bar, on one clock."""
    bar, bowl = recording.strokes()
    return (Trajectory(bowl.t - bowl.t[0], bowl.position), Trajectory(bar.t + 20, bar.position))


def test_asked_for_letters_are_drawn_and_all_where_there_are_none():
    ours = own_recordings("abx")
    assert {item.letter.character for item in redraw_letters(ours).items} == {"a", "b"}
    assert {item.letter.character for item in redraw_letters(ours, letters="q").items} == {
        "a",
        "b",
        "x",
    }
    assert all(item.error < 0.001 < item.letter.size for item in redraw_letters(ours).items)


def test_a_drawing_that_is_refused_is_infinitely_far():
    t = np.linspace(0, 1, 100)
    closed = Trajectory(t, np.column_stack([np.sin(2 * np.pi * t), np.cos(2 * np.pi * t)]))
    (item,) = redraw_letters([closed], settings={"original": Settings.original()}).items
    assert item.drawn is None
    assert item.error == item.largest == np.inf


def test_four_widths_are_drawn_in_the_papers_order():
    found = redraw_at_widths([recording_of("a")])
    assert [item.settings for item in found.items] == ["1/N", "10/N", "full Gaussian", "2/3N"]
    assert found.items[0].error == min(item.error for item in found.items)
    assert width_name(2.5) == "2.5/N"


@pytest.mark.parametrize("recording", DS, ids=alphabets())
def test_a_p_is_made_whatever_stroke_came_first(recording):
    from dmp_teach.studies.inputs import Written  # noqa: PLC0415

    usual = make_p_from_d([recording]).by("DMP*")[0]
    other = make_p_from_d([Written("D", "x", turned_about(recording))]).by("DMP*")[0]
    assert (usual.bar, usual.bowl) == (0, 1)
    assert (other.bar, other.bowl) == (1, 0)
    assert usual.recognisable
    assert other.recognisable
    np.testing.assert_allclose(usual.target, other.target)
    np.testing.assert_allclose(usual.strokes[1].position, other.strokes[0].position, atol=1e-9)


def test_a_d_is_no_p():
    """Drawn to its own goal, the bowl reaches the bar's foot and leaves no leg."""
    item = make_p_from_d(DS).by("DMP*")[0]
    plain = type(item)(
        item.source, "as shown", item.bar, item.bowl, item.target, item.source.strokes
    )
    assert not plain.recognisable


def test_the_similarity_makes_the_bowl_that_is_only_turned_and_scaled():
    for item in make_p_from_d(DS).by("similarity"):
        assert item.shear <= 0.005 * item.height
        np.testing.assert_allclose(item.ideal[item.bowl].position[-1], item.target)


def test_without_a_d_of_two_strokes_our_own_is_borrowed():
    assert make_p_from_d([recording_of("a")]).borrowed
    assert not make_p_from_d(DS).borrowed


def lifted(lift, rate=120):
    """Two bars with a lift of so many metres between them, its strokes known."""
    t = np.arange(3 * rate) / rate
    z = np.where((t > 1) & (t < 2), lift * np.sin(np.pi * (t - 1)) ** 2, 0.0)
    x = np.where(t < 1, t, np.where(t < 2, 1 + 0.1 * (t - 1), 1.1 + (t - 2))) * 0.1
    return Recording(
        t, np.column_stack([x, 0 * t, z]), "D", "w", given_strokes=((0, rate), (2 * rate, 3 * rate))
    )


def test_every_rule_is_judged_by_the_strokes_that_are_known():
    table = compare_segmentation([lifted(0.05)])
    (item,) = table.items
    assert item.known
    assert item.strokes == 2
    assert (item.foot.strokes, item.foot.right) == (2, True)
    assert item.authors.strokes >= 2
    assert not item.printed.right
    (row,) = table.rows()
    assert (row["foot"], row["authors"], row["printed"]) == (
        2,
        item.authors.strokes,
        item.printed.strokes,
    )
    assert compare_segmentation([lifted(0.0)]).items == ()  # flat: nothing to find


def test_what_has_no_height_is_left_out():
    assert compare_segmentation([letter()]).items == ()


@pytest.mark.parametrize("kind", INK_KINDS)
def test_random_ink_is_what_its_name_says(kind):
    for seed in range(5):
        ink = draw_random_ink(kind, 2.0, np.random.default_rng(seed))
        size = np.ptp(ink.position, axis=0).max()
        assert 0.003 <= size <= 0.5
        assert ink.duration == 2.0
        chord = np.linalg.norm(ink.position[-1] - ink.position[0])
        if kind == "closed":
            assert chord <= 1e-9
        if kind == "straight":
            way = ink.position - ink.position[0]
            assert np.abs(way[:, 0] * way[-1, 1] - way[:, 1] * way[-1, 0]).max() <= 1e-12


def test_the_same_seed_gives_the_same_ink():
    once, again = (learn_random_ink(rates=(1.0, 3.0), pieces=3, seed=4) for _ in range(2))
    np.testing.assert_array_equal(once.error, again.error)
    assert (learn_random_ink(rates=(1.0, 3.0), pieces=3, seed=5).error != once.error).any()
    assert len(list_letters(draw_random_ink("waves", 1.0, np.random.default_rng(0)))) == 1
