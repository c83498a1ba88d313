from xml.etree import ElementTree as ET

import numpy as np
import pytest

from dmp_teach.files.writing import ASSETS
from dmp_teach.robot.arm import JOINTS, KEEP, solver_here
from dmp_teach.robot.model.solids import Clearances, Solid, bare_urdf, solids_of
from dmp_teach.robot.page import Page
from tests.robot.sound import LIMITS, MODEL

SOLIDS = {
    "box": Solid("a", "box", [0.1, 0.2, 0.3], np.eye(4)),
    "cylinder": Solid("a", "cylinder", [0.1, 0.3], np.eye(4)),
    "sphere": Solid("a", "sphere", [0.1], np.eye(4)),
}
LOW = np.array([max(joint.lower, -np.pi) for joint in LIMITS])
HIGH = np.array([min(joint.upper, np.pi) for joint in LIMITS])


@pytest.mark.parametrize("solid", SOLIDS.values(), ids=SOLIDS)
def test_the_surface_is_where_the_distance_is_nothing(solid):
    np.testing.assert_allclose(solid.distance(solid.surface()), 0, atol=1e-12)


@pytest.mark.parametrize("solid", SOLIDS.values(), ids=SOLIDS)
def test_the_distance_grows_as_fast_as_one_walks_away_and_never_faster(solid):
    rng = np.random.default_rng(0)
    one, other = rng.uniform(-0.5, 0.5, (2, 2000, 3))
    change = np.abs(solid.distance(one) - solid.distance(other))
    assert (change <= np.linalg.norm(one - other, axis=1) + 1e-12).all()
    np.testing.assert_allclose(
        solid.distance(np.array([0, 0, 2.0])) - solid.distance(np.array([0, 0, 1.0])), 1
    )
    assert solid.distance(np.zeros(3)) == pytest.approx(
        -min(solid.size / 2) if solid.kind == "box" else -0.1
    )


@pytest.mark.parametrize("solid", solids_of(), ids=lambda solid: f"{solid.link}-{solid.kind}")
def test_the_points_on_a_surface_leave_no_wide_gap(solid):
    points = solid.surface()
    back = (points - solid.X_link_solid[:3, 3]) @ solid.X_link_solid[:3, :3]
    np.testing.assert_allclose(solid.distance(back), 0, atol=1e-9)


def test_it_agrees_with_placo_on_what_touches():
    """Another method for the same solids: PlaCo asks coal whether they overlap when each is larger by `KEEP`."""
    pytest.importorskip("placo", reason="PlaCo is not on this platform")
    solver, clearances = solver_here(), Clearances()
    q = np.random.default_rng(2).uniform(LOW, HIGH, (150, len(JOINTS)))
    away = clearances(MODEL.link_poses(q, JOINTS))
    touched = 0
    for posture, distances in zip(q, away, strict=True):
        solver.stand(posture, np.array([0.0, 0, 1]), torso=True)
        touching = {frozenset(pair) for pair in solver.touching()}
        for (link, other), distance in zip(clearances.pairs, distances, strict=True):
            known = not link.startswith(("pen", "r_grip", "l_grip")) and not other.startswith(
                ("pen", "r_grip", "l_grip")
            )
            if known and distance < 2 * KEEP - 0.001:
                assert frozenset((link, other)) in touching
                touched += 1
            if distance > 0.015 + 2 * np.sqrt(3) * KEEP:
                assert frozenset((link, other)) not in touching
    assert touched > 30


@pytest.mark.parametrize("grown", [0.0, KEEP])
def test_solids_grow_on_every_side(grown):
    sizes = [
        [
            float(side)
            for name in ("size", "radius", "length")
            for side in shape.get(name, "").split()
        ]
        for shape in ET.fromstring(bare_urdf(grown)).iterfind(".//collision/geometry/*")
    ]
    plain = [
        solid.size + (2 * grown if solid.kind == "box" else np.array([1, 2]) * grown)
        for solid in solids_of()
        if solid.link.startswith(
            ("base", "torso", "head", "shoulder", "upper", "elbow", "fore", "wrist", "gripper_l")
        )
    ]
    assert len(sizes) == len(plain)
    for size, expected in zip(sizes, plain, strict=True):
        np.testing.assert_allclose(size, expected, atol=1e-6)


def test_no_solid_is_smaller_than_the_real_link():
    """Judged by the boxes around the real links; wheels and laser are inside the base's cylinder."""
    lines = [
        line.split(",")
        for line in (ASSETS / "fetch_links.csv").read_text(encoding="utf-8").splitlines()
    ]
    rows = [dict(zip(lines[0], line, strict=True)) for line in lines[1:]]
    compared = 0
    for row in rows:
        ours = [solid.surface() for solid in solids_of() if solid.link == row["link"]]
        if (
            ours
            and row["xmin"]
            and not row["link"].startswith(("r_wheel", "l_wheel", "estop", "laser"))
        ):
            points, compared = np.concatenate(ours), compared + 1
            for column, axis in enumerate("xyz"):
                assert points[:, column].min() <= float(row[f"{axis}min"]) + 0.004, row["link"]
                assert points[:, column].max() >= float(row[f"{axis}max"]) - 0.004, row["link"]
    assert compared >= 14


def test_a_page_is_a_block_that_goes_on_beyond_its_edge():
    page = Page.table()
    q = [0.386, -0.11, -0.45, -0.37, 1.53, -1.39, -0.88, 0.82]
    X = MODEL.frame("pen_tip", q, JOINTS)[0]
    for around, over in ((0.0, False), (0.3, True)):
        beside = page.moved([X[0, 3] - 0.7, X[1, 3] + 0.2, X[2, 3] - 0.02 - 0.72])
        clearances = Clearances(beside, around)
        column = clearances.pairs.index(("pen_tip", "page"))
        distance = clearances(MODEL.link_poses(q, JOINTS))[0, column]
        assert (distance == pytest.approx(0.02, abs=0.002)) == over
