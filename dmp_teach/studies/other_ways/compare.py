"""Ways to learn a movement, beside one another: the same takes, the same goals, the same robot."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass, replace
from time import perf_counter

import numpy as np
from numpy.typing import ArrayLike

from dmp_teach.arguments import checked, is_whole
from dmp_teach.dmp import check_point
from dmp_teach.errors import SettingError, TeachError, kind_of, shown
from dmp_teach.ink import recording_of
from dmp_teach.robot import Fetch, Page
from dmp_teach.studies.inputs import RecordingsLike, list_letters
from dmp_teach.studies.other_ways.cost import LearnedCost
from dmp_teach.studies.other_ways.mixture import Mixture
from dmp_teach.studies.other_ways.probabilistic import Probabilistic
from dmp_teach.studies.other_ways.star import StarWay
from dmp_teach.studies.other_ways.states import HiddenMarkov
from dmp_teach.studies.other_ways.takes import draw_takes
from dmp_teach.studies.other_ways.way import CUTS, Way, even_path
from dmp_teach.studies.parallel import Progress, run
from dmp_teach.studies.tables import Columns, Tabled
from dmp_teach.trajectory import Array, Trajectory, interpolate_points, rms
from dmp_teach.values import Value

WAYS: Mapping[str, type[Way]] = {
    each.name: each for each in (StarWay, Mixture, HiddenMarkov, LearnedCost, Probabilistic)
}
"""The ways to learn, by their names."""
NUMBERS_SHOWN = (1, 2, 5, 10)
# Takes that are drawn to be shown, where no recordings are given.
TAKES_DRAWN = 10


@dataclass(frozen=True, eq=False, repr=False)
class WayTried(Value):
    """One way to learn, with so many demonstrations.

    Args:
        way: As it was learned.
        takes: The demonstrations.
        meant: The letter that they are takes of, shape (CUTS + 1, D) [m].
        shift: How far the goal moved, shape (D,) [m].
        letter: As it is written to its own goal.
        moved: As it is written to the goal that moved.
        seconds: To learn it and to write it once [s].
        robot_seconds: The robot takes so long for `moved` [s]; NaN where it was not asked to write,
            and infinite where it cannot, or the page is too small.
    """

    way: Way
    takes: tuple[Trajectory, ...]
    meant: Array
    shift: Array
    letter: Trajectory
    moved: Trajectory
    seconds: float
    robot_seconds: float

    @property
    def goal(self) -> Array:
        """Where the moved letter is to end, shape (D,) [m]."""
        return self.meant[-1] + self.shift

    @property
    def error(self) -> float:
        """How far it is from the letter that was meant, root mean square [m]."""
        return rms(self._timed(self.letter) - self.meant)

    @property
    def error_from_first(self) -> float:
        """How far it is from the first demonstration, root mean square [m]."""
        return rms(self._timed(self.letter) - even_path(self.takes[0]))

    @property
    def miss(self) -> float:
        """How far from the goal that moved it ends [m]."""
        return float(np.linalg.norm(self.moved.position[-1] - self.goal))

    @property
    def same_way(self) -> float:
        """How much of the moved letter goes the way of the letter to its own goal [share]."""
        return share_of_same_way(self._timed(self.moved), self._timed(self.letter))

    def _timed(self, movement: Trajectory) -> Array:
        """Return where the pen is at equal parts of the letter's duration (CUTS + 1, D) [m]."""
        t = movement.t - movement.t[0]
        even = np.linspace(0, self.way.duration, CUTS + 1)
        return interpolate_points(even, t, movement.position)


@dataclass(frozen=True, eq=False, repr=False)
class WaysTried(Tabled):
    """Ways to learn beside one another."""

    items: tuple[WayTried, ...]

    @property
    def columns(self) -> Columns:
        """A row for each way and number of demonstrations."""
        items = self.items
        columns: dict[str, list] = {
            "way": [each.way.name for each in items],
            "shown": [len(each.takes) for each in items],
            "from the letter [mm]": [round(1e3 * each.error, 2) for each in items],
            "from the first take [mm]": [round(1e3 * each.error_from_first, 2) for each in items],
            "goal missed [mm]": [round(1e3 * each.miss, 2) for each in items],
            "same way [%]": [round(100 * each.same_way) for each in items],
            "numbers": [each.way.numbers_stored for each in items],
            "time [ms]": [round(1e3 * each.seconds, 1) for each in items],
        }
        if not all(np.isnan(each.robot_seconds) for each in items):
            seconds = [each.robot_seconds for each in items]
            columns["robot [s]"] = [round(s, 2) if s < np.inf else "cannot" for s in seconds]
        return columns


@checked
def compare_ways_to_learn(
    takes: RecordingsLike = None,
    numbers: Sequence[int] | int | None = None,
    shift: ArrayLike = (0.1, 0.0),
    stroke: int = 0,
    fetch: Fetch | None = None,
    *,
    executor: Executor | None = None,
    progress: Progress | None = None,
) -> WaysTried:
    """Learn one stroke in every way, from more and more takes of it, and lead it to another goal.

    Ways whose library is not installed (scikit-learn, hmmlearn) are left out.

    Args:
        takes: Recordings of one letter, files or strokes. They are laid on one another by their
            middles, and what was meant is the mean of those that are not shown. None: ten takes of
            our letter a, drawn by `draw_takes`, and what was meant is known.
        numbers: Of demonstrations; 1, 2, 5 and 10 unless given, as far as there are takes.
        shift: How far the goal moves [m]; the paper's figure 8 moves it by 0.1 m.
        stroke: Which stroke of the letter, from 0.
        fetch: The robot, to write every moved letter on its table, too.
        executor: As in `claims`; a piece of work is one way with one number.
        progress: As in `claims`.

    Raises:
        SettingError: A number of demonstrations that there are not, or that leaves none to judge
            by; no such stroke; a robot that is no `Fetch`.
    """
    if fetch is not None and not isinstance(fetch, Fetch):
        raise SettingError(f"fetch is {kind_of(fetch)}, but must be a robot, as Fetch() gives it.")
    if takes is None:
        _check_stroke(stroke, 1)
        model = recording_of("a").strokes()[0]
        paths, meant = draw_takes(model, TAKES_DRAWN), even_path(model)
        most = TAKES_DRAWN
    else:
        paths, meant = _lay_together(takes, stroke), None
        most = len(paths) - 1
    if numbers is None:
        numbers = [n for n in NUMBERS_SHOWN if n <= most]
    # One number alone is a list of it.
    wanted = list(numbers) if isinstance(numbers, Iterable) else [numbers]
    odd = [n for n in wanted if not is_whole(n) or not 1 <= n <= most]
    if odd or not wanted:
        asked = f"{shown(odd[0])} demonstrations" if odd else "no number of demonstrations"
        raise SettingError(
            f"numbers asks for {asked}, but there are {len(paths)} takes: from 1 to {most} can be "
            "shown."
        )
    moved = check_point("shift", shift, paths[0].dimensions)
    pieces = []
    for number in wanted:
        left = [even_path(each) for each in paths[number:]]
        aim = np.mean(left, axis=0) if meant is None else meant
        ways = [way for way in WAYS.values() if way.can_learn()]
        pieces += [(each, paths[:number], aim, moved) for each in ways]
    found = run(try_way, pieces, executor, progress)
    return WaysTried(tuple(_written(each, fetch) for each in found) if fetch else tuple(found))


def try_way(piece: tuple[type[Way], tuple[Trajectory, ...], Array, Array]) -> WayTried:
    """Learn a movement in one way, and write it to both goals."""
    kind, takes, meant, shift = piece
    begin = perf_counter()
    way = kind.learn(takes)
    way.write()
    return lead_way(way, takes, meant, shift, perf_counter() - begin)


@checked
def lead_way(
    way: Way,
    takes: tuple[Trajectory, ...],
    meant: Array,
    shift: Array,
    seconds: float = np.nan,
) -> WayTried:
    """Write what was learned to its own goal, and to the one that was meant moved by a shift.

    Args:
        way: As it was learned.
        takes: The demonstrations.
        meant: The letter that they are takes of, shape (CUTS + 1, D) [m].
        shift: How far its goal moves, shape (D,) [m].
        seconds: How long it took to learn [s].
    """
    shift = check_point("shift", shift, meant.shape[-1])
    letter, moved = way.write(), way.write(meant[-1] + shift)
    return WayTried(way, takes, meant, shift, letter, moved, seconds, np.nan)


@checked
def share_of_same_way(drawn: Array, taught: Array) -> float:
    """Return how much of a line goes the way of another, to within 45 degrees [share of it].

    Args:
        drawn: The line, shape (T, D) [m].
        taught: The other one at the same moments, shape (T, D) [m].
    """
    if drawn.shape != taught.shape:
        raise SettingError(
            f"drawn has shape {drawn.shape} and taught {taught.shape}, but must have the same."
        )
    steps, others = np.diff(drawn, axis=0), np.diff(taught, axis=0)
    length = np.linalg.norm(steps, axis=1)
    along = np.sum(steps * others, axis=1)
    is_same = along > np.sqrt(0.5) * length * np.linalg.norm(others, axis=1)
    return float(length[is_same].sum() / max(length.sum(), 1e-9))


def _lay_together(takes: RecordingsLike, stroke: int) -> tuple[Trajectory, ...]:
    """Return one stroke of every take, moved so that all have the middle of the first."""
    letters = list_letters(takes)
    least = min(len(each.strokes) for each in letters)
    _check_stroke(stroke, least)
    paths = [each.strokes[stroke] for each in letters]
    middle = even_path(paths[0]).mean(axis=0)
    return tuple(
        Trajectory(each.t, each.position - even_path(each).mean(axis=0) + middle) for each in paths
    )


def _check_stroke(stroke: int, count: int) -> None:
    """Raise a SettingError unless there is such a stroke among so many."""
    if not is_whole(stroke) or not 0 <= stroke < count:
        last = count - 1
        raise SettingError(f"stroke is {shown(stroke)}, but every take has strokes 0 to {last}.")


def _written(tried: WayTried, fetch: Fetch) -> WayTried:
    """Return the same with the time that the robot takes for the moved letter."""
    try:
        seconds = fetch.write((tried.moved,), Page.table()).duration
    except TeachError:
        seconds = np.inf
    return replace(tried, robot_seconds=seconds)
