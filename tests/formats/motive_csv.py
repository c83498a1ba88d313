"""Synthetic writers, and Motive files with every quirk that real ones were seen to have.

`write` builds the pen's way from a script of steps; `motive` puts it into a file.
"""

from dataclasses import dataclass, field

import numpy as np
from scipy.spatial.transform import Rotation

RATE = 120.0


@dataclass
class Pen:
    """A hand with a marker: a chain of steps; `touches` keeps when each stroke began and ended."""

    height: float = 0.03
    speed: float = 0.15
    slope: tuple = (0.0, 0.0)
    t: float = 0.0
    path: list = field(default_factory=lambda: [(0.0, np.zeros(3))])
    touches: list = field(default_factory=list)

    def _go(self, points, seconds):
        for share, point in points:
            self.path.append((self.t + share * seconds, np.asarray(point, float)))
        self.t += seconds
        return self

    def here(self):
        return self.path[-1][1]

    def rest(self, seconds):
        return self._go([(s, self.here()) for s in np.linspace(0.05, 1, 20)], seconds)

    def fly(self, to, z, seconds):
        """To a point at another height, starting and ending at rest."""
        start, end = self.here(), np.array([*to, z])
        ease = [
            (s, start + (end - start) * (10 * s**3 - 15 * s**4 + 6 * s**5))
            for s in np.linspace(0.02, 1, 50)
        ]
        return self._go(ease, seconds)

    def hop(self, to, lift=0.02, seconds=0.45):
        """Off the paper, over, and down again."""
        start, end = self.here(), np.array([*to, 0.0])
        points = []
        for s in np.linspace(0.02, 1, 50):
            e = 10 * s**3 - 15 * s**4 + 6 * s**5
            points.append((s, start + (end - start) * e + [0, 0, lift * np.sin(np.pi * s) ** 2]))
        return self._go(points, seconds)

    def draw(self, points, wander=0.0):
        """A stroke through points: moves off at once, stops at the end."""
        points = np.vstack([self.here()[:2], np.asarray(points, float)])
        way = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])
        seconds = way[-1] / self.speed
        began = self.t
        for s in np.linspace(0.005, 1, 200):
            e = s - np.sin(2 * np.pi * s) / (2 * np.pi) * 0.8
            xy = [np.interp(e * way[-1], way, axis) for axis in points.T]
            self.path.append((began + s * seconds, np.array([*xy, wander * np.sin(2 * np.pi * s)])))
        self.t += seconds
        self.touches.append((began, self.t))
        return self

    def sampled(self, rate=RATE, noise=0.00005, seed=0):
        """Times (T,) and the marker on the page (T, 3): height, slope and noise added."""
        times, points = np.array([t for t, _ in self.path]), np.array([p for _, p in self.path])
        t = np.arange(round(times[-1] * rate) + 1) / rate
        page = np.column_stack([np.interp(t, times, axis) for axis in points.T])
        page[:, 2] += self.height + page[:, :2] @ self.slope
        return t, page + np.random.default_rng(seed).normal(0, noise, page.shape)


def arc(centre, radius, start, end, n=40):
    """Points on an ellipse, angles in degrees."""
    angle = np.radians(np.linspace(start, end, n))
    return np.asarray(centre) + np.column_stack([np.cos(angle), np.sin(angle)]) * radius


def letter_a(size=1.0):
    """One stroke: the bowl, then the bar."""
    return (
        np.vstack(
            [arc((0, 0), (0.05, 0.05), 30, 390), [(0.05, 0.05)], [(0.05, -0.04)], [(0.06, -0.05)]]
        )
        * size
    )


def bar(size=1.0):
    return np.array([(0.0, -0.12)]) * size


def bowl(size=1.0):
    return arc((0, -0.06), (0.07, 0.06), 90, -90) * size


def lab(page, up="+y", right="-x", at=(-0.4, 0.0, 0.3), tilt=0.0):
    """Page coordinates (T, 3) as the cameras see them: up is +y, the page's right is -x."""
    axes = {s + a: np.eye(3)["xyz".index(a)] * (1 if s == "+" else -1) for s in "+-" for a in "xyz"}
    turned = page @ Rotation.from_euler("x", tilt, degrees=True).as_matrix().T
    frame = np.column_stack([axes[right], np.cross(axes[up], axes[right]), axes[up]])
    return turned @ frame.T + at


def motive(
    path,
    t,
    world,
    *,
    pen="Unlabeled:5000",
    crlf=True,
    quoted=True,
    commas=False,
    whole=False,
    units="Meters",
    ghosts=(),
    body=("RigidBody 1", (0.1, 0.05, 0.2)),
    times="{:.6f}",
    scale=1.0,
    head=None,
    empty_last=True,
):
    """Write a Motive 1.21 file; NaN becomes an empty cell, `body` is a rigid body and its place."""
    body_id = '"8392B20CF49E3573"' if quoted else "8392B20CF49E3573"
    markers = [(f"{body[0]}:Marker1", np.broadcast_to(body[1], (len(t), 3))), *ghosts, (pen, world)]
    rate = "120" if whole else "120.000000"
    width = 2 + 3 * len(markers) + 4
    top = [
        "Format Version",
        "1.21",
        "Take Name",
        "Take",
        "Capture Frame Rate",
        rate,
        "Length Units",
        units,
    ]
    columns = [("Rigid Body", body[0], body_id, "Rotation", axis) for axis in "XYZW"]
    columns += [
        ("Marker", n, f'"{n}id"' if quoted else "id", "Position", a)
        for n, _ in markers
        for a in "XYZ"
    ]
    rows = [
        ",".join(top) + ("," * (width - len(top)) if commas else ""),
        "," * (width - 1) if commas else "",
    ]
    rows += [",".join(["", "", *(c[k] for c in columns)]) for k in range(4)]
    rows.append(head or ",".join(["Frame", "Time", *(c[4] for c in columns)]))
    for k in range(len(t)):
        cells = [str(k), times.format(t[k]), "0", "0", "0", "1"]
        for _, xyz in markers:
            cells += ["" if np.isnan(v) else f"{v * scale:.6f}" for v in xyz[k]]
        rows.append(",".join(cells))
    if empty_last:
        rows.append(f"{len(t)},{t[-1] + 1 / 120:.6f}" + "," * (width - 2))
    path.write_bytes(("\r\n" if crlf else "\n").join([*rows, ""]).encode())
    return path
