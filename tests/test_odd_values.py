"""Whatever a public function is given, it answers with a right value or one of our sentences."""

import inspect
from collections import defaultdict
from io import IOBase

import numpy as np
import pytest

import dmp_teach as teach
from dmp_teach.errors import TeachError
from tests.public import ALIKE, INK, PLACES, STROKE, values
from tests.test_public import functions


class Stop(BaseException):
    """Raised by a report of progress: the arguments were accepted, and the work has begun."""


def stop(*_):
    raise Stop


def odd_values(folder):
    """What somebody may give by mistake."""
    numbers = [-1, 0, 5e-324, 1e308, float("nan"), float("inf"), 10**400, np.float32(0.05), True]
    arrays = [np.ma.masked_array([1.0, 2.0], [0, 1]), np.array([1 + 2j, 3]), np.zeros((2, 3))]
    arrays += [np.array(["2020-01-01"] * 2, "datetime64[D]"), np.array([object(), None])]
    others = [None, "", "ab", "a\0b", b"ab", (), (1, 2), [0.1, "x"], {}, {"x": 1}, set()]
    things = [(folder / "open").open("wb+"), folder, lambda *_: None, object(), teach.Settings]
    return numbers + arrays + others + things + [values()["Letter"], INK]


# One good argument by the name of the parameter.
def good_arguments():
    v = values()
    path, traits, piece = STROKE.position, v["PupilTraits"], v["Piece"]
    good = dict(trajectory=STROKE, strokes=(STROKE,), page=v["Page"], recording=INK, key="03")
    good |= dict(recordings=STROKE, letters=ALIKE, letter=v["Letter"], other=v["Letter"])
    good |= dict(written=INK, model=INK, primitives=[v["DMP"]] * 2, primitive=v["DMP"], text="a")
    good |= dict(motion=v["Motion"], points=np.zeros((1, 3)), stroke=STROKE, progress=stop)
    good |= dict(path="x.json", source="x.json", shelf=v["Shelf"], character="l", name="l")
    good |= dict(matrix=np.eye(2), answer={}, value=1.0, limit=1.0, low=0.0, high=1.0, wanted=1.0)
    good |= dict(pieces=[piece], score=v["Score"], content={}, traits=traits, pupil=traits)
    good |= dict(demonstration=INK, is_yes=True, memory=v["RobotPupil"].memory, duration=0.4)
    good |= dict(samples=30, times=None, goal=(0.0, 0.01), by=(0.01, 0.0), place=0.5, part=0.5)
    good |= dict(where=(0.0, 0.0), first=0, last=2, factor=1.0, degrees=1.0, before=piece)
    good |= dict(transform="star", writer="writer-1", coordinates=[0.0], one="writer-1", turns=1)
    good |= dict(rng=np.random.default_rng(0), point=(0.0, 0.0), ink=INK, x=0.5, rate=1.0)
    good |= dict(variant="box, LWR", movement=STROKE, demonstrations=[STROKE] * 2, number=2)
    good |= dict(kind="loops", drawn=path, taught=path, takes=(STROKE,) * 2, meant=path, error=0.1)
    good |= dict(way=v["StarWay"], freedom=5.0, made_with="few", answers=v["Answers"], hints=0)
    good |= dict(made=v["MadeLetters"], curves=v["ErrorCurves"], redrawings=v["Redrawings"])
    good |= dict(traces=v["GoalPaths"], paths=v["GoalPaths"], hands={"me": v["HandLaws"]}, turn=1)
    good |= dict(choice=v["Choice"], style=v["Style"], tried=v["WaysTried"], shift=(0.1, 0.0))
    return good | dict(shares={"writer-1": 1.0})


# Drawn and planned at length whatever they are given; what they refuse has tests of its own.
BUSY = {
    "draw_pipeline",
    "draw_writing",
    "draw_style_sheet",
    "claims",
    "any_ink",
    "draw_contact_sheet",
    "draw_kernel_types",
}
BUSY |= {
    "write_lines",
    "write_word",
    "compare_ways_to_learn",
    "write_rosbag",
    "explore",
    "pad",
    "lesson",
}
# Of one's own lessons, and old names that pass on what they are given.
HOOKS = {"conditions", "draw", "mistakes", "praise", "tell_bet", "tell_refusal", "tell_run", "vary"}
HOOKS |= {"values_on", "panel", "make", "joined", "showing", "choose", "done", "tell"}
# They plan for seconds before they report anything.
HOOKS |= {"reach_map", "reach_around"}


MADE_BY_USERS = [teach.Trajectory, teach.Recording, teach.Settings, teach.Page, teach.PupilTraits]


def calls():
    """Every public function, method and constructor, with arguments that it takes."""
    good = good_arguments()
    for name, function in functions():
        *place, kind, method = name.split(".")
        if method not in HOOKS and kind != "Evidence":
            parameters = inspect.signature(function).parameters.values()
            fixed = [each for each in parameters if each.kind is not each.VAR_POSITIONAL]
            needed = {each.name for each in fixed if each.default is each.empty}
            usual = {"progress", "recordings"} & {each.name for each in fixed}
            if "self" in needed:
                owner = getattr(PLACES[".".join(place)], kind)
                good["self"] = next(v for v in values().values() if isinstance(v, owner))
            yield name, function, {each: good[each] for each in needed | usual if each in good}
    for kind in MADE_BY_USERS:
        value = values()[kind.__name__]
        yield (
            kind.__name__,
            kind,
            {k: getattr(value, k) for k in inspect.signature(kind).parameters},
        )


@pytest.mark.slow
@pytest.mark.filterwarnings("ignore")
def test_every_odd_value_of_every_parameter_is_answered(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    odd, raw = odd_values(tmp_path), defaultdict(list)
    for name, function, given in calls():
        for parameter in inspect.signature(function).parameters.values():
            if parameter.kind is parameter.VAR_KEYWORD or parameter.name == "self":
                continue
            several = parameter.kind is parameter.VAR_POSITIONAL
            # Claims look at all evidence, whatever recordings they are given.
            is_busy = name.split(".")[-1] in BUSY or "verdicts" in function.__module__
            for value in odd[1::15] if is_busy else odd:
                try:
                    if several:
                        function(*given.values(), value)
                    else:
                        function(**{**given, parameter.name: value})
                except (TeachError, Stop):
                    pass
                except Exception as error:
                    raw[f"{name}({parameter.name})"].append(f"{value!r:.40}: {error!r:.90}")
    next(each for each in odd if isinstance(each, IOBase)).close()
    assert raw == {}
