"""One small value of every public class."""

from functools import cache

import numpy as np

import dmp_teach as teach
from dmp_teach import figures, studies

PLACES = {"teach": teach, "teach.studies": studies, "teach.figures": figures}
T = np.linspace(0, 0.4, 30)
STROKE = teach.Trajectory(T, np.column_stack([0.02 * np.sin(6 * T), 0.05 * T]))
INK = teach.recording_of("l")
ALIKE = [INK, teach.recording_of("l", "slanted")]
FEW = teach.Settings.star(n_kernels=5)


def public_classes():
    """Every public class but errors."""
    things = [getattr(place, name) for place in PLACES.values() for name in place.__all__]
    classes = [each for each in things if isinstance(each, type)]
    return [each for each in classes if not issubclass(each, Exception)]


@cache
def values():
    """One value of every public class but errors, by the name of its class."""
    learned, shelf = teach.DMP.imitate(STROKE, FEW), teach.Shelf.of({"l": INK}, FEW)
    motion = teach.Fetch().write((STROKE,), teach.Page.table())
    traits = teach.PupilTraits.like(teach.score(ALIKE[1], INK))
    told = studies.classify_writers([*ALIKE, teach.recording_of("a")])
    redrawn = studies.redraw_letters(STROKE, letters="?", settings=FEW)
    made = studies.make_p_from_d(teach.recording_of("D"), settings={"few": FEW})
    tried = studies.compare_ways_to_learn(studies.draw_takes(STROKE, 2), numbers=1)
    claim = studies.decay_term(studies.Evidence(STROKE))
    found = [STROKE, INK, FEW, learned, shelf, *shelf["l"], motion, traits, told, told.items[0]]
    found += [redrawn, redrawn.items[0], made, made.items[0], tried, tried.items[0], claim]
    found += [studies.Claims((claim,)), studies.Evidence(STROKE)]
    found += [studies.Written("l", "w01", (STROKE,)), *studies.Evidence(STROKE).open_strokes]
    moved, hand = studies.change_goals_1d(STROKE), studies.measure_hand(ALIKE)
    found += [moved, moved.cases[0], hand, hand.bends[0]]
    lifts = studies.compare_segmentation(teach.recording_of("D"))
    found += [
        lifts,
        lifts.items[0],
        lifts.items[0].foot,
        studies.measure_initial_acceleration(STROKE),
    ]
    found += [studies.learn_random_ink(FEW, rates=(1.0,), pieces=1)]
    found += [studies.change_goals_near_start(STROKE, ways=(0.005,))]
    found += [studies.Exponent.around(0.3, 0.01, 5.0), studies.WIDTH_VARIANTS["box, LWR"]]
    found += [studies.sweep_kernel_width(STROKE, widths=[1.0, 2.0])]
    found += [studies.draw_goal_change(STROKE)]
    found += [studies.choose_kernels(STROKE, candidates=[3, 5]), studies.READINGS[0]]
    found += [teach.score(INK, INK), teach.judge_stroke(INK, INK), teach.check("03", {})]
    found += [
        teach.Letter.learn(INK, FEW),
        teach.Style.of(ALIKE, FEW),
        teach.Stepper.begin(learned),
    ]
    found += [teach.Page.table(), teach.Fetch(), teach.lesson("03"), teach.known_reach("table")]
    found += [teach.RobotPupil.load(traits, "l"), teach.TeachingSession.begin(traits, "l")]
    found += [teach.simulate(motion), teach.at_most("error", float, 2.0, "mm")]
    ways = [way.learn(studies.draw_takes(STROKE, 3)) for way in studies.WAYS.values()]
    found += [*ways, *(way.aligned for way in ways if isinstance(way, studies.GaussianWay))]
    return {type(each).__name__: each for each in found}
