"""A smooth curve through a few points.

After J. D. Hobby, "Smooth, easy to compute interpolating splines" (1986): between two points the
curve is a cubic; the headings at the points are chosen so that the bend hardly jumps there. A point
is (x, y), (x, y, heading) or, at a corner, (x, y, heading in, heading out). The writing line is y =
0, a small letter is 1 high; headings are in degrees, 0 to the right, 90 up, None where the curve
may choose.
"""

import math
from itertools import pairwise

import numpy as np

Point = tuple[float | None, ...]
Letter = list[list[Point]]  # the points of each stroke
E, N, W, S = 0, 90, 180, 270  # headings: right, up, left, down
CUBIC = np.linspace(0, 1, 101)[:, None]
CORNER = 4


def pieces(points: list[Point]) -> list[np.ndarray]:
    """Return the curve through `points`, cut at its corners, as dense polylines (N, 2)."""
    cuts = [0, *(k for k in range(1, len(points) - 1) if len(points[k]) == CORNER), len(points) - 1]
    return [_piece(points[a : b + 1]) for a, b in pairwise(cuts)]


def _piece(points: list[Point]) -> np.ndarray:
    """Return one smooth piece; a point with a heading ends one run and begins the next."""
    z = np.array([complex(point[0], point[1]) for point in points])
    arrive = [point[2] if len(point) > 2 else None for point in points]
    leave = [point[-1] if len(point) > 2 else None for point in points]
    cuts = [0, *(k for k in range(1, len(points) - 1) if arrive[k] is not None), len(points) - 1]
    dense = [z[:1]]
    for a, b in pairwise(cuts):
        dense += [cubic[1:] for cubic in _run(z[a : b + 1], leave[a], arrive[b])]
    line = np.concatenate(dense)
    return np.column_stack([line.real, line.imag])


def _run(z: np.ndarray, first: float | None, last: float | None) -> list[np.ndarray]:
    """Return the cubics through `z`; a heading [degrees] of None is as round as the neighbour."""
    chord = np.diff(z)
    theta = _angles(chord, first, last)
    phi = np.append(-np.angle(chord[1:] / chord[:-1]) - theta[1:-1], theta[-1])
    out = z[:-1] + chord * np.exp(1j * theta[:-1]) * _reach(theta[:-1], phi)
    back = z[1:] - chord * np.exp(-1j * phi) * _reach(phi, theta[:-1])
    s = CUBIC[:, 0]
    return [
        (1 - s) ** 3 * a + 3 * (1 - s) ** 2 * s * b + 3 * (1 - s) * s**2 * c + s**3 * d
        for a, b, c, d in zip(z, out, back, z[1:], strict=False)
    ]


def _angles(chord: np.ndarray, first: float | None, last: float | None) -> np.ndarray:
    """Return how far left of its chord the curve leaves each point; the last: arrives, right [rad].

    Mock curvatures on both sides of an inner point are equal: (4 theta_k - 2 phi_k+1) / d_k = (4
    phi_k - 2 theta_k-1) / d_k-1, where theta_k + phi_k + psi_k = 0 and psi_k is the turn of the
    chords.
    """
    n, d = len(chord), np.abs(chord)
    psi = np.concatenate([[0], np.angle(chord[1:] / chord[:-1]), [0]])
    A, b = np.zeros((n + 1, n + 1)), np.zeros(n + 1)
    for k in range(1, n):
        inner = (
            k + 1 < n
        )  # phi of the next point is -psi - theta there, and the unknown itself at the end
        A[k, k - 1], A[k, k] = 2 / d[k - 1], 4 / d[k] + 4 / d[k - 1]
        A[k, k + 1] = 2 / d[k] if inner else -2 / d[k]
        b[k] = -4 * psi[k] / d[k - 1] - (2 * psi[k + 1] / d[k] if inner else 0)
    sign = (
        1 if n > 1 else -1
    )  # with a single chord, the neighbour's angle is the unknown at the other end
    A[0, 0] = A[n, n] = 1
    if first is None:
        A[0, 1], b[0] = sign, -psi[1] if n > 1 else 0
    else:
        b[0] = np.angle(np.exp(1j * math.radians(first)) / chord[0])
    if last is None:
        A[n, n - 1] = -1
    else:
        b[n] = -np.angle(np.exp(1j * math.radians(last)) / chord[-1])
    if n == 1 and first is None and last is None:
        return np.zeros(2)  # a straight line
    return np.linalg.solve(A, b)


def _reach(theta: np.ndarray, phi: np.ndarray) -> np.ndarray:
    """How far a control point is from its end, in chords: Hobby's fit to the circle."""
    a, b = np.sin(theta), np.sin(phi)
    bump = math.sqrt(2) * (a - b / 16) * (b - a / 16) * (np.cos(theta) - np.cos(phi))
    root = math.sqrt(5)
    return (2 + bump) / (3 * (1 + (root - 1) / 2 * np.cos(theta) + (3 - root) / 2 * np.cos(phi)))
