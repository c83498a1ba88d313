"""The paper's claims: computed, reproduced by their calls, and turned by other data."""

import re
from dataclasses import replace
from itertools import product
from types import SimpleNamespace

import numpy as np
import pytest

import dmp_teach as teach
from dmp_teach.dmp.settings import Settings
from dmp_teach.errors import RecordingError, SettingError
from dmp_teach.ink.alphabet import alphabets, recording_of
from dmp_teach.studies.authorship.answers import Answers, Attributions
from dmp_teach.studies.authorship.made import question
from dmp_teach.studies.experiments.d_to_p import make_p_from_d
from dmp_teach.studies.experiments.error_curves import ErrorCurves
from dmp_teach.studies.experiments.stroke_segmentation import (
    RuleResult,
    Segmentation,
    SegmentationCase,
)
from dmp_teach.studies.readings import READINGS, Reading
from dmp_teach.studies.verdicts import accuracy as on_accuracy
from dmp_teach.studies.verdicts import goals as on_goals
from dmp_teach.studies.verdicts import kernels as on_kernels
from dmp_teach.studies.verdicts import letters as on_letters
from dmp_teach.studies.verdicts.all import ALL_CLAIMS, claims
from dmp_teach.studies.verdicts.claim import (
    DEPENDS,
    FAILS,
    HOLDS,
    as_times,
    mm,
    per_cent,
    verdict_over,
)
from dmp_teach.studies.verdicts.evidence import Evidence
from dmp_teach.trajectory import Trajectory
from tests.dmp.ink import letter
from tests.recordings import RECORDINGS, needs_recordings

FEW = [recording_of(character, alphabet) for character in "aD" for alphabet in alphabets()]
EVIDENCE = Evidence(FEW)
QUESTIONS = [
    question(*each) for each in product(("ours", "original"), (True, False), (True, False))
]
OTHERS = {"original": Settings.original(), "similarity": Settings.star(transform="similarity")}
NAMES = ("Gaussian, LWR", "Gaussian, joint")


@pytest.fixture(scope="module")
def few():
    return claims(FEW)


def again(row, recordings):
    return eval(row.call, {"teach": teach, "recordings": recordings})


def test_every_claim_of_the_paper_has_a_row(few):
    assert len(few) == len(ALL_CLAIMS) == len({row.name for row in few})
    for row in few:
        assert row.verdict in (HOLDS, FAILS, DEPENDS)
        assert all((row.claim, row.figure.endswith("."), row.depends_on, row.call, row.n))
        if row.by_reading:
            assert list(row.by_reading) == [each.name for each in READINGS]


@pytest.mark.parametrize("number", range(len(ALL_CLAIMS)))
def test_the_call_of_a_row_reproduces_its_figure(few, number):
    assert few[number].call.endswith("(recordings).figure")
    # Five claims share the study of widths, which evidence makes once.
    shared = number in range(1, 6)
    assert again(few[number], EVIDENCE if shared else FEW) == few[number].figure


def test_a_row_is_found_by_its_name_and_others_are_named(few):
    assert few["decay term"].name == "decay term"
    with pytest.raises(SettingError, match="There is no claim 'x'; there are: narrow kernels, "):
        _ = few["x"]


def test_the_table_is_read_as_text_and_in_a_notebook(few):
    text = str(few)
    assert text == few.table()
    assert repr(few).startswith(f"Claims({len(few)} rows: claim, ")
    assert max(map(len, text.splitlines())) <= 170
    assert all(row.name.split()[0] in text for row in few)
    assert few._repr_html_().count("<tr>") == 1 + len(ALL_CLAIMS)
    assert few[0].call in str(few[0])
    assert Evidence().argument == ""


def test_progress_counts_the_claims_and_an_executor_changes_nothing(few):
    from concurrent.futures import ThreadPoolExecutor  # noqa: PLC0415

    told = []
    with ThreadPoolExecutor(2) as threads:
        found = teach.claims(
            FEW,
            readings=READINGS[:1],
            executor=threads,
            progress=lambda done, total: told.append((done, total)),
        )
    assert told == [(k, len(ALL_CLAIMS)) for k in range(len(ALL_CLAIMS) + 1)]
    for row, usual in zip(found, few, strict=True):
        if row.by_reading:
            assert row.verdict == usual.by_reading["ours"]
        else:
            assert row.verdict == usual.verdict


def test_any_ink_can_be_asked_strokes_without_a_name_too():
    bare = Evidence([letter(150, 1.2, seed=seed) for seed in range(2)], READINGS[:1])
    assert "our own were taken" in on_letters.d_becomes_p(bare).warning
    assert "our own letters" in on_letters.strokes_from_height(bare).warning


def test_where_the_original_can_learn_nothing_our_own_letters_are_taken():
    t = np.linspace(0, 1, 150)
    ring = Trajectory(t, 0.05 * np.column_stack([np.sin(2 * np.pi * t), np.cos(2 * np.pi * t)]))
    closed = Trajectory(t, ring.position - t[:, None] * (ring.position[-1] - ring.position[0]))
    evidence = Evidence([closed], READINGS[:1])
    for row in (
        on_goals.goal_changes,
        on_goals.goal_on_start,
        on_goals.huge_accelerations,
        on_accuracy.accuracy_and_efficiency,
    ):
        assert "our own letters were taken, since all strokes end" in row(evidence).warning


def test_claims_are_about_ink_on_a_page():
    with pytest.raises(
        RecordingError,
        match="has a 3-D stroke, but the paper is about ink on a page",
    ):
        claims([letter(50, 1.0, dimensions=3)])


def test_ink_that_is_given_twice_proves_nothing_twice():
    again = replace(FEW[0], writer="writer-9")
    assert len(Evidence([*FEW, again]).letters) == len(FEW)


def test_readings_that_are_none_are_refused():
    for readings in ((), "ours", [Settings.star()]):
        with pytest.raises(SettingError, match=r"readings is .*, but must be readings"):
            claims(FEW, readings=readings)


def test_a_verdict_is_over_all_cases():
    assert verdict_over({"a": True, "b": True}) == (HOLDS, "holds for: a; b")
    assert verdict_over({"a": False}) == (FAILS, "fails for: a")
    assert verdict_over({"a": True, "b": False}) == (DEPENDS, "holds for: a. Not for: b")


def test_numbers_in_sentences_have_two_digits():
    assert [mm(x) for x in (0.000123, 0.0123, 2.5, 250.0)] == ["0.12 mm", "12 mm", "2.5 m", "250 m"]
    assert [per_cent(x) for x in (0.0123, 0.5, 0.0)] == ["1.2 %", "50 %", "0 %"]
    assert [as_times(x) for x in (1.23, 123.4)] == ["1.2 times", "123 times"]


# Made-up data: the same function, another verdict.


def made(star=None, original=None, **studies):
    """Evidence whose studies are made up, read in one way."""
    reading = Reading("ours", star or Settings.star(), original or Settings.original())
    evidence = Evidence(FEW, (reading,))
    for name, found in studies.items():
        evidence.__dict__[name] = lambda *_, found=found, **__: found
    return evidence


def curves(errors, names=NAMES):
    """The same made-up errors {x: error [mm]} for two strokes and every variant."""
    x = np.array(list(errors))
    error = np.tile(1e-3 * np.array(list(errors.values())), (len(names), 2, 1))
    return ErrorCurves(
        x, "x", names, ("a 1", "a 2"), ("a", "a"), [100, 100], error, np.ones_like(error), error
    )


X = (
    0.2,
    0.3,
    0.4,
    0.5,
    2 / 3,
    0.8,
    0.9,
    1.0,
    1.5,
    2.0,
    3.0,
    4.0,
    5.0,
    7.0,
    10.0,
    14.0,
    20.0,
    40.0,
    np.inf,
)
AS_THE_PAPER = (60, 55, 50, 45, 40, 20, 5, 1, 1.1, 1.1, 1.1, 1.2, 2, 3, 4, 6, 10, 10.3, 10.4)
AS_THE_PAPER = curves(dict(zip(X, AS_THE_PAPER, strict=True)))
FALLING = curves({x: 0.5 + 1 / x for x in X})
RISING = curves({x: min(x, 60.0) for x in X})


@pytest.mark.parametrize(
    ("claim", "against"),
    [
        (on_kernels.narrow_kernels, FALLING),
        (on_kernels.best_width, FALLING),
        (on_kernels.wide_kernels, FALLING),
        (on_kernels.truncation, FALLING),
        (on_kernels.gaps_between_kernels, RISING),
        (on_kernels.four_widths_on_a, RISING),
    ],
    ids=lambda value: getattr(value, "__name__", ""),
)
def test_a_claim_about_widths_goes_with_its_curves(claim, against):
    assert claim(made(widths=AS_THE_PAPER)).verdict == HOLDS
    assert claim(made(widths=against)).verdict == FAILS


def test_a_claim_that_one_variant_keeps_depends_on_it():
    mixed = np.stack([AS_THE_PAPER.error[0], RISING.error[0]])
    both = replace(AS_THE_PAPER, error=mixed)
    found = on_kernels.narrow_kernels(made(widths=both))
    assert found.verdict == DEPENDS
    assert found.depends_on == "holds for: Gaussian, LWR. Not for: Gaussian, joint"


def test_the_number_of_kernels_is_enough_where_more_do_not_help():
    level, falling = curves({0.01: 9, 0.1: 1, 0.5: 0.9}), curves({0.01: 9, 0.1: 1, 0.5: 0.1})
    assert on_kernels.number_of_kernels(made(numbers=level, fewer_samples=level)).verdict == HOLDS
    high = curves({0.01: 99, 0.1: 90, 0.5: 90})
    assert on_kernels.number_of_kernels(made(numbers=high, fewer_samples=high)).verdict == FAILS
    assert (
        on_kernels.number_of_kernels(made(numbers=falling, fewer_samples=falling)).verdict == FAILS
    )
    assert (
        on_kernels.number_of_kernels(made(numbers=level, fewer_samples=falling)).verdict == DEPENDS
    )


def test_redrawn_letters_are_identical_only_if_the_kernels_leave_no_gap():
    assert on_letters.redrawn_letters(made()).verdict == HOLDS
    assert on_letters.redrawn_letters(made(star=Settings.star(kernel_width=0.5))).verdict == FAILS


def test_a_start_velocity_that_is_kept_leaves_the_start_and_one_that_grows_does_not():
    found = on_goals.goal_on_start(made())
    assert found.verdict == DEPENDS
    assert "Not for: one kept" in found.depends_on
    assert on_goals.goal_on_start(made(original=Settings.star())).verdict == FAILS


def test_goals_change_well_only_with_dmp_star():
    assert on_goals.goal_changes(made()).verdict == HOLDS
    assert on_goals.goal_changes(made(star=Settings.original())).verdict == FAILS
    assert on_goals.goal_changes(made(original=Settings.star())).verdict != HOLDS


def test_accelerations_are_huge_only_with_the_original():
    assert on_goals.huge_accelerations(made()).verdict in (HOLDS, DEPENDS)
    assert on_goals.huge_accelerations(made(original=Settings.star())).verdict == FAILS


def test_the_decay_term_is_judged_by_what_it_leaves():
    ones = np.ones(3)
    first = SimpleNamespace(shift=0.01, without=ones, with_term=0.05 * ones, fed=0.5 * ones)
    assert on_goals.decay_term(made(first=first)).verdict == FAILS
    plain = made(Settings.star(feed_goal=False), first=first)
    assert on_goals.decay_term(plain).verdict == HOLDS


def test_accuracy_and_efficiency_are_two_things():
    for star, time, verdict in (
        (Settings.star(), 0.5, HOLDS),
        (Settings.star(), 1.5, DEPENDS),
        (Settings.as_printed(), 0.5, DEPENDS),
        (Settings.as_printed(), 1.5, FAILS),
    ):
        assert on_accuracy.accuracy_and_efficiency(made(star, time_ratio=time)).verdict == verdict


def test_dmp_plus_is_more_accurate_and_with_all_else_the_same_the_form_changes_nothing():
    found = on_accuracy.state_of_the_art(made())
    assert found.verdict == DEPENDS
    assert "Not for: DMP+" in found.depends_on
    assert " %, 100 %, " in on_accuracy.accuracy_and_efficiency(made()).figure


def test_a_linear_decay_saves_kernels_where_they_stand_at_equal_phases():
    found = on_accuracy.linear_decay(made())
    ratios = re.findall(r"(\d+) %", found.figure)
    assert int(ratios[1]) > max(100, int(ratios[0]))


def test_any_size_is_the_same_and_any_pace_is_not():
    found = on_letters.any_scale(made(Settings.star(n_kernels=3)))
    same = found.figure.rsplit(": ", 1)[1].split(", ")
    assert same[1] in same[0]
    assert same[0] == f"ours {same[2]}"
    assert same[3] != f"{same[2]}."


def test_few_are_no_proof_and_letters_that_are_missing_are_named():
    evidence = Evidence([recording_of("b"), recording_of("e")], READINGS[:1])
    found = on_letters.redrawn_letters(evidence)
    assert found.warning == "not recorded: a, m; 2 letters are no proof"
    assert found.n == "2 letters"
    four = on_kernels.four_widths_on_a(evidence)
    assert four.warning.startswith("not recorded: a, so that all letters")


def test_a_p_is_neat_sheared_or_none():
    ways = {
        HOLDS: Settings.star(transform="similarity"),
        DEPENDS: Settings.star(),
        FAILS: Settings.star(kernel_width=0.3),
    }
    for verdict, settings in ways.items():
        found = make_p_from_d(FEW, {"ours": settings, **OTHERS})
        assert on_letters.d_becomes_p(made(new_letters=found)).verdict == verdict


def test_strokes_are_found_as_often_as_they_are_found():
    for right, verdict in ((10, DEPENDS), (7, FAILS), (2, FAILS)):
        found = [RuleResult(2, k < right, 0.001) for k in range(10)]
        items = tuple(
            SegmentationCase(
                "D w", 2, True, RuleResult(2, True), each, each, RuleResult(1, False), True
            )
            for each in found
        )
        assert on_letters.strokes_from_height(made(lifts=Segmentation(items))).verdict == verdict


def test_a_style_is_kept_where_guessing_would_fail():
    for hits, luck, verdict in ((8, 0.001, HOLDS), (0, 1.0, FAILS), (2, 0.3, DEPENDS)):
        items = tuple((f"w{k}", f"w{k if k < hits else (k + 1) % 8}") for k in range(8))
        found = Attributions(tuple(Answers(words, items, 1 / 8, luck) for words in QUESTIONS))
        assert on_letters.writing_style(made(hands=found)).verdict == verdict


def test_a_style_that_is_kept_only_beside_everybodys_mean_depends_on_that():
    items = tuple((f"w{k}", f"w{k}") for k in range(8))
    found = [
        Answers(words, items, 1 / 8, 0.001 if "mean" in words else 0.06) for words in QUESTIONS
    ]
    assert on_letters.writing_style(made(hands=Attributions(tuple(found)))).verdict == DEPENDS


def test_any_shape_needs_enough_kernels():
    assert on_letters.any_ink(made()).verdict == DEPENDS
    assert on_letters.any_ink(made(star=Settings.star(n_kernels=2))).verdict in (DEPENDS, FAILS)
    found = SimpleNamespace(
        rates=(1.0, 2.0), error=np.full((1, 2, 3), 0.001), miss=np.full((1, 2, 3), 0.001)
    )
    assert on_letters.any_ink(made(shapes=found)).verdict == HOLDS
    bad = SimpleNamespace(
        rates=(1.0, 2.0), error=np.full((1, 2, 3), 0.1), miss=np.full((1, 2, 3), 0.001)
    )
    assert on_letters.any_ink(made(shapes=bad)).verdict == FAILS


@needs_recordings
def test_the_recordings_say_what_the_design_measured():
    """What must hold for any writers: not the numbers, but the sense of them."""
    found = claims(RECORDINGS, readings=(READINGS[0], READINGS[-1]))
    assert found["narrow kernels"].verdict == HOLDS
    for name in ("goal changes", "redrawn letters"):
        assert found[name].by_reading["ours"] == HOLDS
        assert found[name].by_reading["as printed"] == FAILS
    assert found["best width"].verdict == found["truncation"].verdict == DEPENDS
    assert found["strokes from height"].verdict != HOLDS
    assert found["D becomes P"].verdict == DEPENDS
