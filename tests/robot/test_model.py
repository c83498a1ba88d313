"""The robot's model against the facts that it is made from, and against other people's readers."""

import csv
import subprocess
import sys
from functools import cache
from xml.etree import ElementTree as ET

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from dmp_teach.errors import JointError, TrajectoryError
from dmp_teach.files.writing import ASSETS
from dmp_teach.robot.model.kinematics import REST, Model

ROBOTS = ("fetch.urdf", "fetch_sprung.urdf")


@cache
def facts(name):
    with (ASSETS / name).open(newline="", encoding="utf-8") as file:
        return tuple(csv.DictReader(file))


@cache
def fetch(name="fetch.urdf"):
    return Model.load(ASSETS / name)


def numbers(row, *names):
    return np.array([float(row[name] or 0) for name in names])


def moves(row):
    return row["type"] != "fixed" and row["joint"] != "bellows_joint"


DRIVEN = tuple(row["joint"] for row in facts("fetch_joints.csv") if moves(row))
positions = st.lists(st.floats(-3.2, 3.2), min_size=len(DRIVEN), max_size=len(DRIVEN))


def composed(q):
    """A second route: SciPy's rotations and places, no poses, from the table of facts."""
    found = {"base_link": (Rotation.identity(), np.zeros(3))}
    for row in facts("fetch_joints.csv"):
        R, p = found[row["parent"]]
        p = p + R.apply(numbers(row, "x", "y", "z"))
        R = R * Rotation.from_euler("xyz", numbers(row, "roll", "pitch", "yaw"))
        if moves(row):
            move = q[DRIVEN.index(row["joint"])] * numbers(row, "ax", "ay", "az")
            if row["type"] == "prismatic":
                p = p + R.apply(move)
            else:
                R = R * Rotation.from_rotvec(move)
        found[row["child"]] = (R, p)
    return found


@given(positions)
def test_every_link_is_where_the_facts_say(q):
    poses = fetch().link_poses(q, DRIVEN)
    for link, (R, p) in composed(q).items():
        np.testing.assert_allclose(poses[link][0, :3, 3], p, rtol=0, atol=1e-12)
        np.testing.assert_allclose(poses[link][0, :3, :3], R.as_matrix(), rtol=0, atol=1e-12)


@given(st.lists(positions, min_size=1, max_size=5))
def test_many_moments_at_once_are_as_one_at_a_time(q):
    together = fetch().frame("pen_tip", q, DRIVEN)
    alone = [fetch().frame("pen_tip", row, DRIVEN)[0] for row in q]
    np.testing.assert_allclose(together, alone, rtol=0, atol=1e-14)


@settings(max_examples=10, deadline=None)
@given(positions)
def test_placo_reads_the_same_robot(q):
    placo = pytest.importorskip("placo", reason="PlaCo has no build for this platform")
    for name in ROBOTS:
        poses = fetch(name).link_poses(q, DRIVEN)
        for link in (
            "gripper_link",
            "pen_tip",
            "head_camera_rgb_optical_frame",
            "l_gripper_finger_link",
        ):
            robot = read_by_placo(placo, name)
            for joint, value in zip(DRIVEN, q, strict=True):
                robot.set_joint(joint, value)
            robot.update_kinematics()
            np.testing.assert_allclose(
                robot.get_T_world_frame(link), poses[link][0], rtol=0, atol=1e-9
            )


@cache
def read_by_placo(placo, name):
    return placo.RobotWrapper(str(ASSETS / name), placo.Flags.ignore_collisions)


def test_joints_are_the_fetchs_in_name_order_and_limits():
    ours = {joint.name: joint for joint in fetch().joints}
    rows = facts("fetch_joints.csv")
    assert tuple(ours)[: len(rows)] == tuple(row["joint"] for row in rows)
    assert fetch().joint_names == DRIVEN
    for row in rows:
        joint = ours[row["joint"]]
        assert (joint.parent, joint.child) == (row["parent"], row["child"])
        if moves(row):
            assert joint.type == row["type"]
            np.testing.assert_array_equal(joint.axis, numbers(row, "ax", "ay", "az"))
            for name in ("lower", "upper", "velocity", "effort"):
                if row[name]:
                    assert getattr(joint, name) == float(row[name]), (joint.name, name)


def test_a_joint_without_a_limit_turns_for_ever():
    assert fetch().joint("wrist_roll_joint").upper == np.inf
    assert fetch().joint("wrist_roll_joint").lower == -np.inf


@given(positions)
def test_the_pen_is_tilted_45_degrees_and_its_nib_is_95_mm_out(q):
    poses = fetch().link_poses(q, DRIVEN)
    gripper, tip = poses["gripper_link"][0], poses["pen_tip"][0]
    along = np.linalg.inv(gripper) @ tip
    np.testing.assert_allclose(
        along[:3, 2], (np.sqrt(0.5), 0, -np.sqrt(0.5)), atol=1e-12
    )  # z: out of the nib
    np.testing.assert_allclose(along[:3, 3], 0.095 * along[:3, 2], atol=1e-12)


@given(st.floats(-0.012, 0.0))
def test_the_sprung_pen_rests_4_mm_further_out_and_slides_along_itself(slide):
    fixed, sprung = (fetch(name).frame("pen_tip", [q], joints) for name, q, joints in _pens(slide))
    np.testing.assert_allclose(sprung[0, :3, :3], fixed[0, :3, :3], atol=1e-12)
    np.testing.assert_allclose(
        sprung[0, :3, 3], fixed[0, :3, 3] + (0.004 + slide) * fixed[0, :3, 2], atol=1e-12
    )
    joint = fetch("fetch_sprung.urdf").joint("pen_slide_joint")
    assert (joint.type, joint.lower, joint.upper) == ("prismatic", -0.012, 0.0)


def _pens(slide):
    return ("fetch.urdf", 0.3, ["elbow_flex_joint"]), (
        "fetch_sprung.urdf",
        (0.3, slide),
        ["elbow_flex_joint", "pen_slide_joint"],
    )


def test_nothing_but_the_nib_is_at_the_nib():
    pieces = [(v.link, v) for v in fetch().visuals if v.link in ("pen_link", "pen_tip")]
    ends = {
        link: max(v.vertices[:, 2].max() for name, v in pieces if name == link)
        for link, _ in pieces
    }
    assert ends["pen_tip"] == 0.0
    assert 0.090 < ends["pen_link"] < 0.095


def test_the_fingers_touch_the_holder_where_they_rest():
    poses = fetch().link_poses([], [])
    to_gripper = np.linalg.inv(poses["gripper_link"][0])
    inner = []
    for side in "rl":
        finger = next(v for v in fetch().visuals if v.link == f"{side}_gripper_finger_link")
        inner.append((to_gripper @ poses[finger.link][0])[1, 3] + finger.vertices[:, 1])
    holder = next(v for v in fetch().visuals if v.link == "pen_holder_link").vertices[:, 1].max()
    assert inner[0].min() == pytest.approx(holder, abs=5e-4)
    assert inner[1].max() == pytest.approx(-holder, abs=5e-4)
    lower, upper = (
        getattr(fetch().joint("r_gripper_finger_joint"), name) for name in ("lower", "upper")
    )
    assert lower < REST["r_gripper_finger_joint"] < upper


@pytest.mark.parametrize("name", ROBOTS)
def test_every_link_weighs_something_and_can_be_turned(name):
    for link in ET.parse(ASSETS / name).getroot().findall("link"):
        assert float(link.find("inertial/mass").attrib["value"]) > 0
        i = {key: float(value) for key, value in link.find("inertial/inertia").attrib.items()}
        tensor = np.array(
            [
                [i["ixx"], i["ixy"], i["ixz"]],
                [i["ixy"], i["iyy"], i["iyz"]],
                [i["ixz"], i["iyz"], i["izz"]],
            ]
        )
        principal = np.linalg.eigvalsh(tensor)
        assert principal[0] > 0, link.attrib["name"]
        assert principal[2] <= principal[0] + principal[1] + 1e-12, link.attrib["name"]


def test_masses_and_centres_are_the_facts():
    links = {
        link.attrib["name"]: link
        for link in ET.parse(ASSETS / "fetch.urdf").getroot().findall("link")
    }
    for row in facts("fetch_links.csv"):
        if row["mass"]:
            inertial = links[row["link"]].find("inertial")
            assert float(inertial.find("mass").attrib["value"]) == float(row["mass"])
            centre = [float(value) for value in inertial.find("origin").attrib["xyz"].split()]
            np.testing.assert_array_equal(centre, numbers(row, "com_x", "com_y", "com_z"))


def test_pybullet_reads_every_link_and_piece(capfd):
    pybullet = pytest.importorskip("pybullet", reason="pybullet has no build for this platform")
    client = pybullet.connect(pybullet.DIRECT)
    try:
        for name in ROBOTS:
            body = pybullet.loadURDF(str(ASSETS / name), useFixedBase=True, physicsClientId=client)
            assert pybullet.getNumJoints(body, client) == len(fetch(name).joints)
            shapes = pybullet.getVisualShapeData(body, physicsClientId=client)
            assert sum(shape[2] == pybullet.GEOM_MESH for shape in shapes) == len(
                fetch(name).visuals
            )
    finally:
        pybullet.disconnect(client)
    said = capfd.readouterr()
    assert "inertia" not in said.out + said.err
    assert "annot" not in said.out + said.err


def test_the_committed_files_are_what_the_script_makes(tmp_path):
    subprocess.run(
        [sys.executable, str(ASSETS / "make_fetch.py"), "--out", str(tmp_path)], check=True
    )
    made = {
        path.relative_to(tmp_path): path.read_bytes()
        for path in tmp_path.rglob("*")
        if path.is_file()
    }
    assert {path.name for path in (ASSETS / "meshes").iterdir()} == {
        p.name for p in made if p.suffix == ".obj"
    }
    for path, content in made.items():
        assert (ASSETS / path).read_bytes() == content, f"{path} is old: run assets/make_fetch.py"


def test_shells_fill_the_boxes_of_the_real_ones():
    for row in facts("fetch_links.csv"):
        if row["xmin"]:
            points = np.concatenate([v.vertices for v in fetch().visuals if v.link == row["link"]])
            low, high = numbers(row, "xmin", "ymin", "zmin"), numbers(row, "xmax", "ymax", "zmax")
            np.testing.assert_allclose(
                points.min(axis=0), low, rtol=0, atol=2.5e-3, err_msg=row["link"]
            )
            np.testing.assert_allclose(
                points.max(axis=0), high, rtol=0, atol=2.5e-3, err_msg=row["link"]
            )


def test_the_shells_are_light_enough_for_a_page():
    assert sum(len(v.faces) for v in fetch().visuals) <= 20_000
    sizes = [path.stat().st_size for path in (ASSETS / "meshes").iterdir()]
    assert max(sizes) < 1.5e6
    assert sum(sizes) < 3e6


@pytest.mark.parametrize("piece", fetch().visuals, ids=lambda v: v.link)
def test_every_piece_is_closed_smooth_and_faces_outwards(piece):
    corners = piece.vertices[piece.faces]
    area = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    assert (np.linalg.norm(area, axis=1) > 0).all()
    np.testing.assert_allclose(
        area.sum(axis=0), 0, atol=1e-6
    )  # closed: what faces one way is matched by the other
    assert np.einsum("ij,ij->", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])) > 0
    np.testing.assert_allclose(np.linalg.norm(piece.normals, axis=1), 1, atol=2e-3)
    flat = area / np.linalg.norm(area, axis=1, keepdims=True)
    assert (np.einsum("fci,fi->fc", piece.normals[piece.faces], flat) > 0).all()
    _, places = np.unique(np.round(piece.vertices, 5), axis=0, return_inverse=True)
    solid = places.reshape(-1)[piece.faces]
    edges = np.sort(np.stack([solid, np.roll(solid, -1, axis=1)], -1).reshape(-1, 2), axis=1)
    assert (np.unique(edges, axis=0, return_counts=True)[1] % 2 == 0).all()
    np.testing.assert_array_equal(piece.color >= 0, True)


def test_values_are_locked():
    joint, piece = fetch().joints[0], fetch().visuals[0]
    for array in (
        joint.X_parent_joint,
        joint.axis,
        piece.vertices,
        piece.normals,
        piece.faces,
        piece.color,
    ):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 0


def test_an_unknown_joint_is_told_the_nearest_names():
    with pytest.raises(
        JointError, match=r"no joint that moves called 'elbow_joint'.*'elbow_flex_joint'"
    ):
        fetch().link_poses([[0.0]], ["elbow_joint"])
    with pytest.raises(JointError, match=r"no joint called 'torso'.*'torso_"):
        fetch().joint("torso")


def test_a_joint_that_cannot_move_is_not_moved():
    with pytest.raises(JointError, match="no joint that moves called 'bellows_joint'"):
        fetch().link_poses([[0.1]], ["bellows_joint"])


def test_an_unknown_frame_is_told_the_nearest_names():
    with pytest.raises(JointError, match=r"no frame called 'pentip'.*'pen_tip'"):
        fetch().frame("pentip", [], [])


def test_a_joint_named_twice_is_refused():
    with pytest.raises(JointError, match="'elbow_flex_joint' is named twice"):
        fetch().link_poses([[0.0, 0.1]], ["elbow_flex_joint", "elbow_flex_joint"])


@pytest.mark.parametrize(
    ("q", "says"),
    [([[0.0, 1.0]], r"shape \(1, 2\)"), ([[np.nan]], r"q\[0\] of elbow_flex_joint is nan")],
)
def test_positions_that_do_not_fit_are_refused(q, says):
    with pytest.raises(TrajectoryError, match=says):
        fetch().link_poses(q, ["elbow_flex_joint"])


@pytest.mark.parametrize("name", ["fetch.urdf", "fetch_sprung.urdf"])
def test_every_joint_comes_after_the_one_that_carries_it(name):
    model = fetch(name)
    reached = {model.root}
    for joint in model.joints:
        assert joint.parent in reached
        reached.add(joint.child)
    assert reached == set(model.links)
