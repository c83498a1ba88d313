"""What a teacher reads about a run: what is wrong, where, by how much, and what to do."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from dmp_teach.trajectory import Array

if TYPE_CHECKING:
    from dmp_teach.robot.simulation.run import Run

BAND = (0.2, 1.2)
"""Good pressing: between these two forces [N]."""

BREAKS = 10.0
"""A pen does not survive more than this [N]."""

SPARE = 0.01
"""So much of the letter may lack ink, or be pressed too hard, before anything is said."""

_ASTRAY = 0.002  # ink that is this far from the letter on average is worth a word [m]
_PLAN_AGAIN = "Plan again for the page as it lies: Fetch().write(strokes, run.page)."


def findings(run: Run) -> tuple[str, ...]:
    """Sentences about a run, the worst first; none where all is well."""
    told = [_stopped(run), _ink(run), _pressed(run), _astray(run), _stray_ink(run), _tired(run)]
    return tuple(sentence for sentence in told if sentence)


def _stopped(run: Run) -> str:
    """Interrupted."""
    if not run.stopped:
        return ""
    return f"Stopped after {run.duration:.2f} s of {run.planned.duration:.2f} s; what was written until then is kept."


def _ink(run: Run) -> str:
    """No ink, or not everywhere: how far from the paper, and which part."""
    down = run.motion.pen_down
    if not down.any():
        return ""
    gap = 1000 * np.maximum(run.nib[down, 2], 0.0)
    if not run.writing.any():
        return f"No ink: the pen's tip stayed {gap.min():.1f} to {gap.max():.1f} mm over the paper. {_PLAN_AGAIN}"
    share = run.missing.mean()
    if share < SPARE:
        return ""
    where = part(run.letter[: len(run.missing)], run.missing)
    over = gap[run.missing].max(initial=0.0)
    return (
        f"{_percent(share)} of the letter has no ink, {where}: there the tip is up to {over:.1f} mm over the paper. "
        f"{_PLAN_AGAIN}"
    )


def _pressed(run: Run) -> str:
    """Too hard: how many newtons, and whether the pen survives."""
    down = run.motion.pen_down
    hard = run.force[down] > BAND[1]
    most = run.greatest_force
    if run.pen == "rigid" and most > BREAKS:
        return (
            f"The pen would break: it is pushed with {most:.0f} N, and {BREAKS:.0f} N are enough to break one. "
            'A rigid pen cannot give way: use pen="sprung".'
        )
    if not hard.any() or hard.mean() < SPARE:
        return ""
    where = part(run.letter[: len(hard)], hard)
    cure = 'Use pen="sprung".' if run.pen == "rigid" else _PLAN_AGAIN
    fate = f", and {BREAKS:.0f} N would break the pen" if most > BREAKS else ""
    return (
        f"Pressed too hard, {where}: up to {most:.1f} N, where {BAND[1]} N are enough{fate}. {cure}"
    )


def _astray(run: Run) -> str:
    """Ink beside the letter."""
    if not run.writing.any() or run.shape_error <= _ASTRAY:
        return ""
    return (
        f"The ink is {1000 * run.shape_error:.1f} mm from the letter on average: the arm could not follow. "
        "Write more slowly: letter.write(duration=...)."
    )


def _stray_ink(run: Run) -> str:
    """Ink between the strokes."""
    if run.ink_in_the_air <= 0.0005:
        return ""
    length = 1000 * run.ink_in_the_air
    return f"{length:.0f} mm of ink lie between the strokes, where the pen was meant to be up. {_PLAN_AGAIN}"


def _tired(run: Run) -> str:
    """Joints that gave all they had, or would have had to give more, and not just for a moment."""
    share = (np.abs(run.effort) >= 0.999 * run.limits).mean(axis=0)
    if share.max(initial=0.0) < SPARE or run.greatest_force > BREAKS:
        return ""
    worst = int(np.argmax(share))
    name, most, limit = (
        run.planned.joint_names[worst],
        np.abs(run.effort[:, worst]).max(),
        run.limits[worst],
    )
    unit = "N" if name.startswith("torso") else "N m"
    does = "needs up to" if most > 1.001 * limit else "gives all of"
    return (
        f"{name} {does} {most:.0f} {unit} for {_percent(share[worst])} of the time; it has {limit:.0f}. "
        "Write more slowly, or move the page nearer to the robot."
    )


def part(letter: Array, chosen: Array) -> str:
    """Where on a letter (N, 2) the chosen points (N,) are: "at its top", "on its left", "all over it"."""
    low, high = letter.min(axis=0), letter.max(axis=0)
    side = np.maximum(high - low, 1e-9)
    middle = (letter[chosen].mean(axis=0) - (low + high) / 2) / side
    x, y = middle
    words = []
    if abs(y) > 0.15:
        words.append("at its top" if y > 0 else "at its bottom")
    if abs(x) > 0.15:
        words.append("on its right" if x > 0 else "on its left")
    return (
        " and ".join(words) if words else "all over it" if chosen.mean() > 0.5 else "in its middle"
    )


def _percent(share: float) -> str:
    """A share, never rounded to nothing."""
    return f"{max(1, round(100 * share))} %"
