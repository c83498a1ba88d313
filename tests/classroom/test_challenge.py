"""A teacher's own challenge: judged when asked, told in sentences, and kept."""

import itertools
import re

import pytest

import dmp_teach as teach
from tests.classroom.browser import send

HINTS = ["Look where the line leaves the dots.", "Tight bends need more bumps.", "Try 14."]
GAPS = "There are gaps: the robot sleeps between the bumps."
numbers = itertools.count()


@pytest.fixture
def panel():
    return teach.explore("e", show=("sheet", "n_kernels"), n_kernels=5, kernel_width=1.0)


@pytest.fixture
def make(panel):
    """Make the example's card; each test has a text of its own, for cards are kept by it."""
    text = f"Bring the **e** under 1 mm with at most 16 bumps. ({next(numbers)})"

    def make_it(limit=16, **changes):
        given = {"hints": HINTS, "mistakes": {GAPS: lambda: panel.kernel_width < 1}, **changes}
        return teach.challenge(
            text,
            teach.at_most("the e", lambda: 1000 * panel.error, 1.0, "mm"),
            teach.at_most("bumps", lambda: panel.n_kernels, limit),
            **given,
        )

    return make_it


def test_the_example_goes_from_misses_and_a_hint_to_the_green_card(panel, make):
    card = make()
    assert card.card["rows"] == [
        ["the e", "", "at most 1 mm", False],
        ["bumps", "", "at most 16", False],
    ]
    first = card.check()
    assert (first.done, first.hint) == (False, HINTS[0])
    assert re.fullmatch(r"The e: \d\.\d mm\. It must be at most 1 mm\.", first.reason)
    assert not card.card["offersHint"]
    send(card, {"kind": "check"})
    assert card.card["offersHint"]
    send(card, {"kind": "hint"})
    assert card.card["hints"] == HINTS[:1]
    panel.n_kernels = 14
    assert not card.progress["passed"]
    send(card, {"kind": "check"})
    assert card.progress["verdict"]["done"]
    praise = r"You did it: the e 0\.\d\d mm, bumps 14\."
    assert re.fullmatch(praise, card.progress["verdict"]["reason"])
    assert [row[-1] for row in card.card["rows"]] == [True, True]
    assert not card.card["offersHint"]


def test_a_mistake_is_told_before_what_is_missing_and_keeps_the_card_from_turning_green(
    panel, make
):
    panel.n_kernels = 16
    assert make(praise="Well drawn.").check().reason == "Well drawn."
    panel.kernel_width = 0.99
    verdict = make(praise="Well drawn.").check()
    assert (verdict.done, verdict.reason) == (False, GAPS)


def test_running_the_cell_again_finds_the_card_as_it_was_and_other_rules_begin_afresh(panel, make):
    card = make()
    card.check()
    card.check()
    card.show_hint()
    panel.n_kernels = 14
    card.check()
    again = make()
    assert (again.progress, again.card) == (card.progress, card.card)
    assert not make(limit=13).progress["passed"]


def test_hints_come_one_by_one_and_the_last_stays(make):
    card = make()
    told = []
    for _ in range(5):
        told.append(card.check().hint)
        card.show_hint()
    assert told == [*HINTS, HINTS[2], HINTS[2]]
    assert make(hints=(), limit=1).check().hint == ""
    assert make(hints="Try 14.", limit=2).check().hint == "Try 14."


@pytest.mark.parametrize(
    ("ask", "told"),
    [
        (lambda: 1 / 0, "ZeroDivisionError"),
        (lambda: undefined_name, "undefined_name"),  # noqa: F821
        (lambda: None, "NoneType"),
        (lambda: "wide", "wide"),
    ],
)
def test_a_fault_in_a_teachers_function_is_a_sentence_that_names_it_and_no_miss(ask, told):
    card = teach.challenge(f"Fault {told}", teach.at_most("the width", ask, 1.0))
    for _ in range(3):
        send(card, {"kind": "check"})
    reason = card.progress["verdict"]["reason"]
    assert reason.startswith("“the width” cannot be worked out.")
    assert told in reason
    assert "Traceback" not in reason
    assert not card.card["offersHint"]
    slips = {"It is too wide.": lambda: 1 / 0}
    card = teach.challenge(f"Slip {told}", teach.at_most("bumps", 3, 5), mistakes=slips)
    assert card.check().reason.startswith("“It is too wide.” cannot be worked out.")


@pytest.mark.parametrize(
    ("conditions", "mistakes", "told"),
    [
        ((), {}, "got none"),
        ((lambda: True,), {}, "made by at_most"),
        ((teach.exactly("bumps", 3, 3),), {"gaps": True}, "a function"),
        ((teach.exactly("bumps", 3, 3),), {len: "gaps"}, "must have sentences"),
    ],
)
def test_a_challenge_that_cannot_be_judged_is_refused(conditions, mistakes, told):
    with pytest.raises(teach.SettingError) as said:
        teach.challenge("Draw.", *conditions, mistakes=mistakes)
    assert told in str(said.value)


@pytest.mark.parametrize(
    ("condition", "met", "missed"),
    [
        (lambda ask: teach.at_most("it", ask, 2), 2, 2.1),
        (lambda ask: teach.at_least("it", ask, 2), 2, 1.9),
        (lambda ask: teach.between("it", ask, 2, 3), 2.5, 3.1),
        (lambda ask: teach.exactly("it", ask, 2), 2, 3),
    ],
)
def test_every_kind_of_condition_asks_its_function_anew(condition, met, missed):
    now = [missed]
    condition = condition(lambda: now[0])
    assert not condition.is_met
    now[0] = met
    assert condition.is_met
    assert condition.shown == f"{met:g}"
