"""Distances of the arm's parts, beside those of points on their surfaces."""

import re
from functools import cache
from itertools import product
from xml.etree import ElementTree as ET

import numpy as np
import pytest

from dmp_teach.files.writing import ASSETS
from dmp_teach.robot.arm import JOINTS, SAFETY_SHELL
from dmp_teach.robot.clearance import get_plain_name
from dmp_teach.robot.model.convex import Shapes, measure_gaps
from dmp_teach.robot.model.proximity import Proximity
from dmp_teach.robot.model.urdf import read_origin
from dmp_teach.robot.page import Page
from tests.robot.sound import LIMITS, MODEL

LOW = np.array([max(joint.lower, -np.pi) for joint in LIMITS])
HIGH = np.array([min(joint.upper, np.pi) for joint in LIMITS])
SPACING = 0.03


@cache
def shapes():
    """Every collision shape of the URDF: its link, kind, size [m] and pose in the link."""
    found = []
    for link in ET.parse(ASSETS / "fetch.urdf").getroot().iter("link"):
        for element in link.findall("collision"):
            (shape,) = element.find("geometry")
            sides = [shape.get(name) for name in ("size", "radius", "length") if shape.get(name)]
            size = np.array(" ".join(sides).split(), dtype=float)
            found.append((link.attrib["name"], shape.tag, size, read_origin(element)))
    return found


def surface(kind, size, X):
    """Points all over a shape's surface, in its link's frame, shape (P, 3) [m]."""
    if kind == "sphere":
        points = size[0] * np.vstack([np.eye(3), -np.eye(3)])
    elif kind == "box":
        ticks = [np.linspace(-s / 2, s / 2, 1 + int(np.ceil(s / SPACING))) for s in size]
        points = np.array(list(product(*ticks)))
        points = points[(np.abs(points) >= size / 2 - 1e-12).any(axis=1)]
    else:
        radius, length = size
        count = max(6, int(np.ceil(2 * np.pi * radius / SPACING)))
        turns = np.linspace(0, 2 * np.pi, count, endpoint=False)
        ticks = np.linspace(-length / 2, length / 2, 1 + int(np.ceil(length / SPACING)))
        points = [(radius * np.cos(a), radius * np.sin(a), z) for a, z in product(turns, ticks)]
    return np.asarray(points) @ X[:3, :3].T + X[:3, 3]


def beside(kind, size, points):
    """How far points (P, 3) of the shape's frame are from its surface, less than 0 inside [m]."""
    x, y, z = points.T
    if kind == "sphere":
        return np.linalg.norm(points, axis=1) - size[0]
    if kind == "box":
        beyond = np.abs(points) - size / 2
    else:
        beyond = np.column_stack([np.hypot(x, y) - size[0], np.abs(z) - size[1] / 2])
    return np.linalg.norm(np.maximum(beyond, 0), axis=1) + np.minimum(beyond.max(axis=1), 0)


def by_points(link, other, poses):
    """The least distance of two links in one posture, from above [m]."""
    least = np.inf
    for carrier, kind, size, X in shapes():
        if carrier == other:
            seen = np.linalg.inv(poses[other][0] @ X) @ poses[link][0]
            for carried, *form in shapes():
                if carried == link:
                    points = surface(*form) @ seen[:3, :3].T + seen[:3, 3]
                    least = min(least, beside(kind, size, points).min())
    return least


def test_distances_are_those_of_points_on_the_surfaces():
    """Points 3 cm apart see a little less than all of a surface, and so never more nearness."""
    proximity = Proximity(JOINTS)
    q = np.random.default_rng(2).uniform(LOW, HIGH, (12, len(JOINTS)))
    near = 0
    for posture, distances in zip(q, proximity.distances(q), strict=True):
        poses = MODEL.link_poses(posture, JOINTS)
        for (link, other), distance in zip(proximity.pairs, distances, strict=True):
            if distance > 0:
                assert -1e-4 < by_points(link, other, poses) - distance < SPACING / 2
                near += distance < 0.1
            else:
                assert by_points(link, other, poses) < SPACING / 2
    assert near > 30


def random_shapes(count, seed):
    """Boxes, cylinders and balls of 1 to 20 cm, some of which overlap."""
    rng = np.random.default_rng(seed)
    R = np.linalg.qr(rng.normal(size=(count, 3, 3)))[0]
    R *= np.linalg.det(R)[:, None, None]
    kind = rng.integers(0, 3, count)
    half = rng.uniform(0.01, 0.2, (count, 3)) * (kind != 2)[:, None]
    half[kind == 1, :2] = 0
    disc, ball = rng.uniform(0.01, 0.1, (2, count)) * (kind == [[1], [2]])
    return Shapes(R, rng.uniform(-0.25, 0.25, (count, 3)), half, disc, ball)


def test_gaps_are_those_of_another_library():
    """coal's; where bodies overlap, ours may be a millimetre deeper, and coal's balls are wrong."""
    coal = pytest.importorskip("coal", reason="coal comes with PlaCo")
    one, other = random_shapes(600, 1), random_shapes(600, 2)

    def by_coal(n):
        forms = []
        for shapes in (one, other):
            if shapes.ball[n]:
                form = coal.Sphere(shapes.ball[n])
            elif shapes.disc[n]:
                form = coal.Cylinder(shapes.disc[n], 2 * shapes.half[n, 2])
            else:
                form = coal.Box(*(2 * shapes.half[n]))
            forms += [form, coal.Transform3s(shapes.R[n], shapes.p[n])]
        answer = coal.DistanceResult()
        coal.distance(*forms, coal.DistanceRequest(), answer)
        return answer.min_distance

    gaps = measure_gaps(one, other, np.full(600, np.inf))
    theirs = np.array([by_coal(n) for n in range(600)])
    apart = theirs > 0
    assert 300 < apart.sum() < 560
    np.testing.assert_array_equal(gaps > 0, apart)
    np.testing.assert_allclose(gaps[apart], theirs[apart], rtol=0, atol=3e-6)
    solid = ~apart & (one.ball + other.ball == 0)
    np.testing.assert_allclose(gaps[solid], theirs[solid], rtol=0, atol=1.5e-3)


def test_boxes_whose_sides_are_parallel_overlap_by_the_shortest_way_out():
    one, other = random_shapes(300, 3), random_shapes(300, 4)
    still, none = np.broadcast_to(np.eye(3), (300, 3, 3)), np.zeros(300)
    one, other = (Shapes(still, each.p, 0.1 + each.half, none, none) for each in (one, other))
    beyond = (np.abs(one.p - other.p) - one.half - other.half).max(axis=1)
    inside = beyond < 0
    assert inside.any()
    gaps = measure_gaps(one, other, np.full(300, np.inf))
    np.testing.assert_allclose(gaps[inside], beyond[inside], atol=1e-6)


def test_overlap_is_as_deep_as_the_way_out_is_long():
    """The tip of the pen, a small ball, in the block under the page."""
    q = np.array([0.386, -0.11, -0.45, -0.37, 1.53, -1.39, -0.88, 0.82])
    tip = MODEL.frame("pen_tip", q, JOINTS)[0, :3, 3]
    for deep in (0.01, 0.05):
        page = Page.table(tip[0], tip[1], tip[2] + deep)
        proximity = Proximity(JOINTS, page)
        (found,) = proximity.distances(q[None])[:, proximity.pairs.index(("pen_tip", "page"))]
        assert found == pytest.approx(-deep, abs=0.002)


def test_grown_shapes_are_nearer_on_both_sides():
    q = np.random.default_rng(3).uniform(LOW, HIGH, (20, len(JOINTS)))
    plain, grown = (
        Proximity(JOINTS).distances(q),
        Proximity(JOINTS, grown=SAFETY_SHELL).distances(q),
    )
    apart = grown > 0
    nearer = (plain - grown)[apart]
    assert nearer.min() >= 2 * SAFETY_SHELL - 1e-5
    assert nearer.max() <= 2 * np.sqrt(3) * SAFETY_SHELL + 1e-5


def test_what_touches_is_what_has_no_distance():
    proximity = Proximity(JOINTS)
    q = np.random.default_rng(4).uniform(LOW, HIGH, (20, len(JOINTS)))
    for touching, distances in zip(proximity.touching(q), proximity.distances(q), strict=True):
        for pair, distance in zip(proximity.pairs, distances, strict=True):
            assert (pair in touching) == (distance < 0)


def test_no_shape_is_smaller_than_the_real_link():
    """Judged by the boxes around the real links; wheels and laser are inside the base."""
    text = (ASSETS / "fetch_links.csv").read_text(encoding="utf-8")
    lines = [line.split(",") for line in text.splitlines()]
    compared = 0
    for row in [dict(zip(lines[0], line, strict=True)) for line in lines[1:]]:
        ours = [surface(*form) for link, *form in shapes() if link == row["link"]]
        inside = row["link"].startswith(("r_wheel", "l_wheel", "estop", "laser"))
        if ours and row["xmin"] and not inside:
            points, compared = np.concatenate(ours), compared + 1
            for column, axis in enumerate("xyz"):
                assert points[:, column].min() <= float(row[f"{axis}min"]) + 0.004, row["link"]
                assert points[:, column].max() >= float(row[f"{axis}max"]) - 0.004, row["link"]
    assert compared >= 14


def test_a_page_is_a_block_that_goes_on_beyond_its_edge():
    q = np.array([[0.386, -0.11, -0.45, -0.37, 1.53, -1.39, -0.88, 0.82]])
    tip = MODEL.frame("pen_tip", q, JOINTS)[0, :3, 3]
    page = Page.table(tip[0], tip[1] + 0.2, tip[2] - 0.02)
    for around, over in ((0.0, False), (0.3, True)):
        proximity = Proximity(JOINTS, page, around)
        distance = proximity.distances(q)[0, proximity.pairs.index(("pen_tip", "page"))]
        assert (distance == pytest.approx(0.02, abs=0.002)) == over


def test_every_part_has_a_plain_name():
    links = {link for pair in Proximity(JOINTS, Page.table()).pairs for link in pair}
    assert not [link for link in links if re.search("_|link", get_plain_name(link))]
