"""Whose hand is it? Made letters given to the writer whose letters they look most like."""

from collections.abc import Sequence
from concurrent.futures import Executor
from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.stats import binomtest

from dmp_teach.letters.outline import bar_and_bowl
from dmp_teach.studies.material import OURS, Written, letters_of, own_recordings
from dmp_teach.studies.new_letters import MadeLetter, p_from_d, transforms
from dmp_teach.studies.tables import Rows, Tabled
from dmp_teach.studies.work import Progress
from dmp_teach.trajectory import Array, Trajectory

POINTS = 40  # along each stroke
FEATURES = ("slant", "log size", "log pace", "unevenness of pace")


@dataclass(frozen=True)
class Attribution:
    """One made letter, and whose it was taken for.

    Args:
        writer: Who wrote the D.
        by_shape: Whose P is nearest in shape, whatever its size.
        by_hand: Whose other letters are nearest in slant, size and pace; None where a writer has no others.
        source_by_hand: The same asked of the D itself: what the question can tell at all.
    """

    writer: str
    by_shape: str
    by_hand: str | None
    source_by_hand: str | None


@dataclass(frozen=True, eq=False)
class Attributions(Tabled):
    """Every made letter, and whose it was taken for.

    Args:
        items: One for each writer with a D of two strokes.
        others: How many writers have other letters to compare with.
        recorded: Whether shapes were compared with Ps that the writers wrote themselves.
    """

    items: tuple[Attribution, ...]
    others: int
    recorded: bool = False

    def right(self, question: str) -> tuple[int, int]:
        """How many were given to their writer, and of how many, for "by_shape", "by_hand" or "source_by_hand"."""
        asked = [(each.writer, getattr(each, question)) for each in self.items if getattr(each, question) is not None]
        return sum(writer == answer for writer, answer in asked), len(asked)

    def luck(self, question: str) -> float:
        """How probable as many hits or more are for somebody who guesses; 1 where nothing could be asked."""
        hits, asked = self.right(question)
        choices = len(self.items) if question == "by_shape" else self.others
        if not asked or choices < 2:
            return 1.0
        return float(binomtest(hits, asked, 1 / choices, alternative="greater").pvalue)

    def rows(self) -> Rows:
        """One for each writer."""
        return tuple(
            {
                "made from the D of": each.writer,
                "nearest P": each.by_shape,
                "nearest hand": each.by_hand or "-",
                "nearest hand of the D itself": each.source_by_hand or "-",
            }
            for each in self.items
        )


def attribution(
    recordings: Any = None, *, executor: Executor | None = None, progress: Progress | None = None
) -> Attributions:
    """Each writer's P, made from the D with DMP*, given to the nearest writer.

    By shape: strokes of 40 points at equal ways along them, the letter moved to its middle and scaled to the same
    size, root mean square distance to every writer's P: the one that was recorded, where every writer has one, or else
    the writer's D with its bowl turned and scaled, which asks only whether the primitive kept the shape. By hand:
    slant, size, pace and unevenness of pace, each divided by its spread over the writers, against the means of every
    writer's *other* letters, which the primitive never saw.

    Args:
        recordings: Recordings, files or strokes; our own letters where none is a D of two strokes.
        executor: Any `concurrent.futures.Executor`; a piece of work is one D.
        progress: Called as `progress(done, total)`.
    """
    made = p_from_d(recordings, {"DMP*": transforms()["DMP*"]}, executor=executor, progress=progress)
    letters = letters_of(own_recordings(OURS + "P") if made.borrowed or recordings is None else recordings)
    one = {item.source.writer: item for item in made.items}
    shapes, recorded = _shapes(letters, one)
    hands = _hands(letters, one)
    found = []
    for writer, item in one.items():
        form = _shape(item.strokes)
        near = min(shapes, key=lambda other: float(np.linalg.norm(shapes[other] - form)))
        asked = writer in hands and len(hands) > 1
        by_hand = _nearest_hand(item.strokes, hands) if asked else None
        found.append(Attribution(writer, near, by_hand, _nearest_hand(item.source.strokes, hands) if asked else None))
    return Attributions(tuple(found), len(hands), recorded)


def hand(strokes: Sequence[Trajectory]) -> Array:
    """Slant of the steep parts, log of size [m], log of pace [m/s], unevenness of pace, shape (4,)."""
    step = np.concatenate([np.diff(s.position, axis=0) for s in strokes])
    dt = np.concatenate([np.diff(s.t) for s in strokes])
    long = np.linalg.norm(step, axis=1)
    steep = np.abs(step[:, 1]) > np.abs(step[:, 0])
    slant = (step[steep, 0] * step[steep, 1]).sum() / max((step[steep, 1] ** 2).sum(), 1e-12)
    size = np.ptp(np.concatenate([s.position for s in strokes]), axis=0).max()
    pace, speed = long.sum() / dt.sum(), long / dt
    return np.array([slant, np.log(size), np.log(pace), speed.std() / max(speed.mean(), 1e-12)])


def _hands(letters: Sequence[Written], made: dict[str, MadeLetter]) -> dict[str, Array]:
    """The mean hand of every writer's letters other than the D."""
    found: dict[str, list[Array]] = {}
    for letter in letters:
        if letter.character != "D" and letter.writer in made:
            found.setdefault(letter.writer, []).append(hand(letter.strokes))
    return {writer: np.mean(each, axis=0) for writer, each in found.items()}


def _nearest_hand(strokes: Sequence[Trajectory], hands: dict[str, Array]) -> str:
    """The writer whose hand is nearest."""
    spread = np.std(list(hands.values()), axis=0)
    spread = np.where(spread > 0, spread, 1.0)
    asked = hand(strokes)
    return min(hands, key=lambda writer: float(np.linalg.norm((hands[writer] - asked) / spread)))


def _shapes(letters: Sequence[Written], made: dict[str, MadeLetter]) -> tuple[dict[str, Array], bool]:
    """Every writer's P, and whether they were recorded."""
    own = {each.writer: each for each in letters if each.character == "P" and len(each.strokes) >= 2}
    if made.keys() <= own.keys():
        return {writer: _shape(own[writer].strokes) for writer in made}, True
    return {writer: _shape(item.ideal) for writer, item in made.items()}, False


def _shape(strokes: Sequence[Trajectory]) -> Array:
    """Bar and bowl as points, without place and size, shape (2 * POINTS * 2,)."""
    points = np.concatenate([_evenly(strokes[k].position) for k in bar_and_bowl(tuple(strokes))])
    points = points - points.mean(axis=0)
    return (points / np.sqrt((points**2).sum(axis=1).mean())).ravel()


def _evenly(path: Array) -> Array:
    """Points at equal ways along a path."""
    way = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(path, axis=0), axis=1))])
    return np.column_stack([np.interp(np.linspace(0, way[-1], POINTS), way, axis) for axis in path.T])
