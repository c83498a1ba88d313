"""Laws of strokes: how many, in which order, and where they begin and end."""

from contextlib import suppress

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dmp_teach.errors import RecordingError, SettingError
from dmp_teach.ink.recording import Recording
from dmp_teach.segmentation.strokes import find_strokes
from tests.formats.motive_csv import Pen, bar, bowl, letter_a

GRID = [(0.10, s) for s in (0.003, 0.006, 0.009, 0.012)] + [
    (0.08, s) for s in (0.003, 0.006, 0.008, 0.010)
]


def found_in(pen, rate=120.0, theta=0.10, sigma=0.006):
    t, page = pen.sampled(rate)
    page[:, 2] -= pen.height
    return t, find_strokes(t, page, theta, sigma)


def check_ends(pen, t, found, within=0.05):
    assert len(found) == len(pen.touches)
    for (a, b), (down, up) in zip(found, pen.touches, strict=True):
        assert abs(t[a] - down) < within, f"stroke begins at {t[a]:.3f} s, the pen at {down:.3f} s"
        assert abs(t[b - 1] - up) < within, (
            f"stroke ends at {t[b - 1]:.3f} s, the pen at {up:.3f} s"
        )


def two_stroke_d(speed=0.15):
    return Pen(speed=speed).rest(0.5).draw(bar()).hop((0.0, 0.0)).draw(bowl()).rest(0.5)


def bowl_first():
    return Pen().rest(0.5).draw(bowl()).hop((0.0, 0.0)).draw(bar()).rest(0.5)


def one_stroke_d():
    return Pen().rest(1.0).draw(np.vstack([bar(), bowl()[::-1]])).rest(1.0)


def idle_then_hop():
    """Rests on the paper, hops off it, lands, writes, lands again beside its letter and rests."""
    pen = Pen().rest(4.0).hop((0.03, 0.0), lift=0.02).rest(0.5).draw(letter_a())
    return pen.hop((0.15, -0.05), lift=0.03).rest(3.0)


def dotted_i():
    """The dot is a small stroke."""
    pen = Pen().rest(0.3).draw(bar(0.5)).hop((0.0, 0.03), lift=0.02)
    pen.speed = 0.05
    return pen.draw(np.array([(0.004, 0.034), (0.0, 0.038)])).hop((0.1, 0.0), lift=0.04).rest(1.0)


def pauses_while_landing():
    """Hovers 4 mm over the paper before it sinks for good."""
    pen = (
        Pen()
        .rest(0.4)
        .draw(bar())
        .fly((0.0, -0.05), 0.03, 0.3)
        .fly((0.003, 0.002), 0.004, 0.35)
        .rest(0.35)
    )
    return pen.fly((0.0, 0.0), 0.0, 0.15).rest(0.15).draw(bowl()).rest(0.5)


def sinks_in_steps():
    """Hovers along over the paper, low and slowly, and only then sinks to it."""
    pen = Pen().rest(0.4).draw(bar()).fly((0.0, -0.05), 0.03, 0.3).fly((-0.01, 0.0), 0.004, 0.3)
    return (
        pen.fly((-0.002, 0.0), 0.003, 0.25)
        .fly((0.0, 0.0), 0.0, 0.2)
        .rest(0.3)
        .draw(bowl())
        .rest(0.5)
    )


def lifts_slowly():
    """Only the landing is faster than theta."""
    pen = Pen().rest(0.4).draw(bar()).fly((0.0, -0.05), 0.025, 0.8)
    return pen.fly((0.0, 0.0), 0.0, 0.25).draw(bowl()).rest(0.5)


def flies_in_and_away():
    pen = Pen()
    pen.path = [(0.0, np.array([0.1, -0.1, 0.06]))]
    return (
        pen.rest(1.0)
        .fly((0.0, 0.0), 0.0, 0.6)
        .rest(0.1)
        .draw(letter_a())
        .fly((0.3, -0.1), 0.1, 0.4)
    )


HANDS = {
    hand.__name__: hand
    for hand in (
        two_stroke_d,
        bowl_first,
        one_stroke_d,
        idle_then_hop,
        dotted_i,
        pauses_while_landing,
        sinks_in_steps,
        lifts_slowly,
        flies_in_and_away,
    )
}


@pytest.mark.parametrize("hand", HANDS)
@pytest.mark.parametrize(("theta", "sigma"), GRID)
def test_every_stroke_is_found_where_the_pen_wrote_it(hand, theta, sigma):
    pen = HANDS[hand]()
    t, found = found_in(pen, theta=theta, sigma=sigma)
    check_ends(pen, t, found)


@pytest.mark.parametrize("rate", [30.0, 60.0, 100.0, 240.0])
@pytest.mark.parametrize("hand", HANDS)
def test_no_rate_is_special(hand, rate):
    pen = HANDS[hand]()
    t, found = found_in(pen, rate)
    check_ends(pen, t, found, within=0.12)


def test_a_tap_between_two_lifts_is_a_dot():
    pen = (
        Pen()
        .rest(0.3)
        .draw(bar(0.5))
        .hop((0.0, 0.03), lift=0.02)
        .rest(0.2)
        .hop((0.1, 0.0), lift=0.03)
        .rest(0.5)
    )
    t, found = found_in(pen)
    assert len(found) == 2
    a, b = found[1]
    assert 0.1 < t[b - 1] - t[a] < 0.35


@pytest.mark.parametrize("wander", [0.005, 0.0125])
@pytest.mark.parametrize("turns", [0.3, 0.6, 1.1])
@pytest.mark.parametrize("phase", [0.0, 1.6, 3.1, 4.7])
def test_a_marker_that_wanders_while_it_writes_keeps_the_whole_stroke(wander, turns, phase):
    pen = Pen().rest(1.0).draw(letter_a(1.5)).rest(1.0)
    t, page = pen.sampled()
    way = np.cumsum(np.linalg.norm(np.diff(page[:, :2], axis=0, prepend=page[:1, :2]), axis=1))
    page[:, 2] += wander * np.sin(2 * np.pi * turns * way / way[-1] + phase)
    check_ends(pen, t, find_strokes(t, page), within=0.12)


def faltering(pen, slow):
    """The first 2 mm down the bar: a small push, `slow` for 0.06 s, and on."""
    for way, seconds in ((0.0009, 0.05), (0.06 * slow, 0.06), (0.0007, 0.05)):
        x, y = pen.here()[:2]
        pen._go([(s, (x, y - s * way, 0.0)) for s in np.linspace(0.05, 1, 20)], seconds)
    return pen


@pytest.mark.parametrize("rest", [0.0, 0.4])
@pytest.mark.parametrize("lifted", [False, True])
@pytest.mark.parametrize("slow", [0.008, 0.010, 0.012])
def test_a_hand_that_falters_as_it_begins_has_begun(slow, lifted, rest):
    """Its first millimetre is too short for a stroke, but it never came to rest again."""
    pen = Pen().rest(0.8)
    if lifted:
        pen = pen.draw(bowl()[::-1]).hop((0.0, 0.0)).rest(0.1 + rest)
    begun = pen.t
    t, page = faltering(pen, slow).draw(bar()).rest(0.6).sampled()
    assert abs(t[find_strokes(t, page)[-1][0]] - begun) < 0.05


@pytest.mark.parametrize("bend", [1.0, 1.5])
@pytest.mark.parametrize("seconds", [0.15, 0.25])
@pytest.mark.parametrize("lift", [0.02, 0.04])
def test_a_resting_hand_that_swings_into_its_hop_wrote_nothing(lift, seconds, bend):
    """It moves along the page before it is off it, and only then goes to its letter."""
    pen = Pen().rest(1.0)
    over = np.array([-0.05, 0.03])
    eased = [(s, 10 * s**3 - 15 * s**4 + 6 * s**5) for s in np.linspace(0.02, 1, 50)]
    pen._go([(s, (*over * s**bend, lift * e)) for s, e in eased], seconds)
    pen.fly((0.0, 0.0), 0.0, 0.4).rest(0.2).draw(letter_a()).rest(0.5)
    t, page = pen.sampled()
    for theta, sigma in GRID:
        check_ends(pen, t, find_strokes(t, page, theta, sigma))


@pytest.mark.parametrize("height", [0.003, 0.0042, 0.0055])
@pytest.mark.parametrize("sink", [0.04, 0.06, 0.1])
def test_a_pen_that_stood_over_the_place_where_it_then_touches_made_no_dot(height, sink):
    pen = (
        Pen()
        .rest(0.4)
        .draw(bar())
        .fly((0.0, -0.05), 0.03, 0.3)
        .fly((0.002, 0.001), height, 0.2)
        .rest(0.3)
    )
    t, page = pen.fly((0.0, 0.0), 0.0, sink).rest(0.1).draw(bowl()).rest(0.5).sampled()
    assert {len(find_strokes(t, page, theta, sigma)) for theta, sigma in GRID} == {2}


@pytest.mark.parametrize("part", [3, -2])
def test_a_pen_that_pauses_near_an_end_of_its_stroke_keeps_all_of_it(part):
    """It wrote 4 % of it before or after."""
    ink = letter_a() if part > 0 else letter_a()[::-1]
    pen = Pen(path=[(0.0, np.append(ink[0], 0.0))]).rest(0.5)
    t, page = pen.draw(ink[1:part]).rest(2.0).draw(ink[part:]).rest(0.5).sampled()
    ((a, b),) = find_strokes(t, page)
    assert abs(t[a] - pen.touches[0][0]) < 0.05
    assert abs(t[b - 1] - pen.touches[-1][1]) < 0.05


@pytest.mark.parametrize("seed", range(6))
def test_a_hand_that_trembles_along_while_it_sinks_is_still_landing(seed):
    """Moves in fits and starts, each a little lower: together they sink too steeply for writing."""
    pen = (
        Pen()
        .rest(0.4)
        .draw(bar())
        .fly((0.0, -0.05), 0.03, 0.3)
        .fly((-0.009, 0.0), 0.0031, 0.3)
        .rest(0.05)
    )
    pen.fly((-0.005, 0.0), 0.0022, 0.1).rest(0.04)
    for k in range(1, 6):
        pen.fly((-0.005 + 0.001 * k, 0.0), 0.0022 * (1 - k / 5), 0.07).rest(0.04)
    pen.rest(0.2).draw(bowl()).rest(0.5)
    t, page = pen.sampled(noise=0.0001, seed=seed)
    check_ends(pen, t, find_strokes(t, page), within=0.1)


def test_a_marker_that_sinks_along_with_the_writing_is_not_landing():
    """By 8 mm on the first 45 mm of ink; a hand that lands sinks by over a quarter of its way."""
    pen = Pen(speed=0.12).rest(0.5).draw(letter_a(1.2)).rest(0.5)
    t, page = pen.sampled()
    way = np.cumsum(np.linalg.norm(np.diff(page[:, :2], axis=0, prepend=page[:1, :2]), axis=1))
    page[:, 2] += np.interp(way, [0.0, 0.045], [0.008, 0.0])
    check_ends(pen, t, find_strokes(t, page))


@pytest.mark.parametrize("drop", [0.0, 0.006, 0.012, 0.016])
@pytest.mark.parametrize("lift", [0.004, 0.02])
def test_a_hand_that_comes_to_rest_beside_a_thick_pad_takes_no_stroke_with_it(drop, lift):
    pen = two_stroke_d().fly((0.12, -0.1), lift, 0.12).fly((0.14, -0.11), -drop, 0.15).rest(0.6)
    t, page = pen.sampled()
    for theta, sigma in GRID:
        found = find_strokes(t, page, theta, sigma)
        assert len(found) == 2
        assert abs(t[found[1][0]] - pen.touches[1][0]) < 0.05


@pytest.mark.parametrize("drop", [0.008, 0.012, 0.016])
@pytest.mark.parametrize("hand", [one_stroke_d, flies_in_and_away])
def test_a_hand_that_slips_off_a_thick_pad_leaves_the_only_stroke(hand, drop):
    """It falls faster than theta, and rises less than sigma before."""
    pen = hand()
    if hand is flies_in_and_away:
        pen = (
            Pen(path=[(0.0, np.array([0.1, -0.1, 0.06]))])
            .rest(0.1)
            .fly((0.0, 0.0), 0.0, 0.6)
            .draw(letter_a())
        )
    t, page = pen.fly((0.12, -0.1), 0.002, 0.12).fly((0.13, -0.1), -drop, 0.13).rest(0.5).sampled()
    assert len(find_strokes(t, page)) == 1
    assert abs(t[find_strokes(t, page)[0][0]] - pen.touches[0][0]) < 0.05


@pytest.mark.parametrize("aside", [0.0, 0.005, 0.02])
def test_a_take_that_ends_while_the_pen_lands_has_no_stroke_there(aside):
    """Of the span after the lift the landing leaves nothing."""
    pen = Pen().rest(0.4).draw(bar()).fly((0.0, -0.05), 0.03, 0.3).fly((aside, 0.0), 0.0055, 0.3)
    t, page = pen.fly((0.0, 0.0), 0.0, 0.15).sampled()
    assert len(find_strokes(t, page)) == 1


@pytest.mark.parametrize("seed", range(5))
def test_a_hand_that_trembles_beside_a_slow_letter_writes_nothing(seed):
    pen = (
        Pen(speed=0.04)
        .rest(0.5)
        .draw(bar(0.5))
        .hop((0.0, 0.0))
        .draw(bowl(0.5))
        .hop((0.06, -0.03))
        .rest(0.6)
    )
    t, page = pen.sampled(noise=0.0003, seed=seed)
    assert len(find_strokes(t, page)) == 2


@pytest.mark.parametrize("hand", HANDS)
def test_a_clock_that_begins_at_0_gives_the_same_strokes_to_the_sample(hand):
    t, page = HANDS[hand]().sampled()
    for later in (0.31, 1.31, 2.31, 100 / 3):
        kept = np.round(t + later, 6)
        assert find_strokes(kept - kept[0], page) == find_strokes(kept, page)


def test_a_low_lift_counts_only_over_sigma():
    pen = (
        Pen().rest(0.3).draw(bar()).hop((0.0, 0.0), lift=0.014, seconds=0.35).draw(bowl()).rest(0.3)
    )
    assert len(found_in(pen, sigma=0.006)[1]) == 2
    assert len(found_in(pen, sigma=0.020)[1]) == 1


def test_height_that_wanders_is_no_lift():
    pen = Pen().rest(0.3).draw(letter_a(), wander=0.005).rest(0.3)
    t, found = found_in(pen)
    check_ends(pen, t, found)


@settings(max_examples=25, deadline=None)
@given(
    size=st.floats(0.4, 2.0),
    speed=st.floats(0.05, 0.5),
    hand=st.sampled_from(["two", "bowl first", "one"]),
)
def test_no_size_or_speed_is_special(size, speed, hand):
    pen = Pen(speed=speed * size**0.5).rest(0.5)
    if hand == "one":
        pen.draw(letter_a(size)).rest(0.5)
    else:
        first, second = (bar(size), bowl(size)) if hand == "two" else (bowl(size), bar(size))
        pen.draw(first).hop((0.0, 0.0)).draw(second).rest(0.5)
    assert len(found_in(pen)[1]) == len(pen.touches)


@settings(max_examples=15, deadline=None)
@given(
    later=st.floats(-5.0, 1000.0),
    east=st.floats(-0.5, 0.5),
    north=st.floats(-0.5, 0.5),
    turn=st.floats(-3.1, 3.1),
    hand=st.sampled_from(sorted(HANDS)),
)
def test_when_and_where_it_was_written_does_not_matter(later, east, north, turn, hand):
    t, page = HANDS[hand]().sampled()
    t, page = np.round(t, 9), page - [0, 0, 0.03]
    c, s = np.cos(turn), np.sin(turn)
    moved = page @ np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]]) + [east, north, 0]
    for (a, b), (c, d) in zip(find_strokes(t, page), find_strokes(t + later, moved), strict=True):
        assert abs(a - c) <= 1
        assert abs(b - d) <= 1


def test_strokes_are_the_raw_samples_on_the_recordings_clock():
    t, page = two_stroke_d().sampled()
    page[:, 2] -= 0.03
    before = t.copy(), page.copy()
    for stroke in Recording(t, page).strokes():
        start = int(np.flatnonzero(t == stroke.t[0])[0])
        assert np.array_equal(stroke.t, t[start : start + len(stroke)])
        assert np.array_equal(stroke.position, page[start : start + len(stroke), :2])
    assert np.array_equal(before[0], t)
    assert np.array_equal(before[1], page)


def test_uneven_clocks_do_not_matter():
    pen = two_stroke_d()
    t, page = pen.sampled()
    page[:, 2] -= pen.height
    uneven = t + np.random.default_rng(1).uniform(-0.003, 0.003, len(t))
    resampled = np.column_stack([np.interp(uneven, t, axis) for axis in page.T])
    check_ends(pen, uneven, find_strokes(uneven, resampled))


def test_given_strokes_are_kept():
    t = np.arange(20) / 100
    page = np.column_stack([t, t**2, 0 * t])
    strokes = Recording(t, page, given_strokes=((0, 5), (8, 20))).strokes(theta=1.0, sigma=1.0)
    assert [len(s) for s in strokes] == [5, 12]
    assert strokes[1].t[0] == t[8]


@pytest.mark.parametrize("spans", [(), ((0, 1),), ((3, 6), (5, 9)), ((0, 21),), ((-1, 4),)])
def test_given_strokes_must_be_runs_of_samples(spans):
    with pytest.raises(RecordingError, match="given_strokes is"):
        Recording(np.arange(20.0), np.zeros((20, 3)), given_strokes=spans)


def test_a_recording_is_locked_and_three_dimensional():
    recording = Recording(np.arange(3.0), np.zeros((3, 3)), "a", "w01", 0.0)
    with pytest.raises(ValueError, match="read-only"):
        recording.position[0] = 1
    with pytest.raises(RecordingError, match=r"must be \(T, 3\)"):
        Recording(np.arange(3.0), np.zeros((3, 2)))
    with pytest.raises(RecordingError, match="needs a clean path"):
        Recording(np.zeros(3), np.zeros((3, 3)))
    assert repr(recording) == "Recording('a', by w01, 3 samples, 2.000 s)"


@pytest.mark.parametrize("value", [0.0, -1.0, np.nan, np.inf, None, "fast", True])
@pytest.mark.parametrize("name", ["theta", "sigma"])
def test_theta_and_sigma_are_positive(name, value):
    t, page = two_stroke_d().sampled()
    with pytest.raises(SettingError, match=f"{name} is .*positive"):
        Recording(t, page).strokes(**{name: value})


def test_a_pen_that_never_moves_wrote_nothing():
    with pytest.raises(RecordingError, match="no writing"):
        find_strokes(np.arange(100) / 120, np.zeros((100, 3)))


def test_a_broken_clock_is_refused():
    t = np.concatenate([np.arange(99) / 120, [1e9]])
    with pytest.raises(RecordingError, match="too uneven to find strokes"):
        find_strokes(t, np.zeros((100, 3)))


def test_pressure_is_kept_locked_and_within_0_and_1():
    t, page = np.arange(4.0), np.zeros((4, 3))
    recording = Recording(t, page, pressure=[0, 0.5, 1, 0])
    assert recording.pressure.tolist() == [0, 0.5, 1, 0]
    assert not recording.pressure.flags.writeable
    assert Recording(t, page).pressure is None
    for odd in ([0, 1], "hard", [[0]] * 4, 0.5, [10**400] * 4):
        with pytest.raises(
            RecordingError, match=r"pressure must be one number for every sample, shape \(4,\)"
        ):
            Recording(t, page, pressure=odd)
    for odd in (-0.1, 1.1, np.nan, np.inf):
        with pytest.raises(
            RecordingError, match=r"pressure\[2\] is .*, but must be between 0 and 1"
        ):
            Recording(t, page, pressure=[0, 1, odd, 0])


@pytest.mark.parametrize("rate", [1.0, 3.0, 10.0])
def test_a_slow_clock_gives_strokes_or_a_sentence(rate):
    for seed in range(40):
        random = np.random.default_rng(seed)
        path = np.cumsum(random.normal(0, 0.02, (100, 3)), axis=0)
        with suppress(RecordingError):
            assert find_strokes(np.arange(100) / rate, path)
