"""Make the robot.

`python3 assets/make_fetch.py` writes fetch.urdf, fetch_sprung.urdf and meshes/ beside itself.
The facts (where joints are, what links weigh, how large their shells are) stand in
`fetch_joints.csv` and `fetch_links.csv`, measured on the Fetch in metres, radians, kilograms and
newtons. The shapes are our own and fill those boxes: `shells_base.py`, `shells_torso.py`,
`shells_arm.py`. What we add to the real robot is a pen in a holder between the fingers, and a skirt
that the bellows slide over. Running it twice gives the same bytes.
"""

import argparse
import csv
import math
from pathlib import Path
from xml.etree import ElementTree as ET

from collisions import COLLISIONS
from meshing import write_obj
from shells_arm import arm_shells
from shells_base import base_shells
from shells_torso import torso_shells

HERE = Path(__file__).resolve().parent
PEN_TILT = math.pi / 4  # between the pen and the gripper's x [rad]
PEN_LENGTH = 0.095  # from the gripper's frame to the nib [m]
SLIDE = 0.012  # how far the sprung pen can be pushed in [m]
PRESSED = 0.004  # how much further out it rests than the fixed pen [m]
NOTE = " Made by make_fetch.py from measured facts of the Fetch; do not edit. "
NOT_DRIVEN = {"bellows_joint"}  # drawn, never moved

SHELLS = base_shells() | torso_shells() | arm_shells()
PEN_LINKS = {  # name: mass [kg], middle along the pen [m], radius [m], length [m]
    "pen_holder_link": (0.015, 0.0, 0.008, 0.030),
    "pen_link": (0.012, 0.029, 0.005, 0.130),
    "pen_tip": (0.001, -0.0015, 0.0015, 0.003),
}


def read(name: str) -> list[dict[str, str]]:
    """Return the rows of a table of facts."""
    with (HERE / name).open(newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def words(*values: str | float) -> str:
    """Numbers as they stand in a URDF, every digit kept; nothing stands for 0."""
    return " ".join(repr(float(value or 0)) for value in values)


def box_inertia(mass: float, size: tuple[float, float, float]) -> dict[str, float]:
    """Return the inertia of a solid box about its middle [kg m^2]."""
    xx, yy, zz = (mass / 12 * side**2 for side in size)
    return {"ixx": yy + zz, "ixy": 0.0, "ixz": 0.0, "iyy": xx + zz, "iyz": 0.0, "izz": xx + yy}


def add_origin(parent: ET.Element, xyz: tuple = (0, 0, 0), rpy: tuple = (0, 0, 0)) -> None:
    """Where something sits."""
    ET.SubElement(parent, "origin", xyz=words(*xyz), rpy=words(*rpy))


def add_inertial(link: ET.Element, mass: float, com: tuple, inertia: dict[str, float]) -> None:
    """Return the mass, centre and inertia of a link as XML."""
    inertial = ET.SubElement(link, "inertial")
    add_origin(inertial, com)
    ET.SubElement(inertial, "mass", value=words(mass))
    ET.SubElement(inertial, "inertia", {name: words(value) for name, value in inertia.items()})


def inertia_of(row: dict[str, str]) -> tuple[float, tuple, dict[str, float]]:
    """Return the mass, centre and inertia of a link; a gram in a small box for a bare frame."""
    if not row["mass"]:
        return 0.001, (0, 0, 0), box_inertia(0.001, (0.02, 0.02, 0.02))
    mass, com = float(row["mass"]), (row["com_x"], row["com_y"], row["com_z"])
    if row["link"].endswith(
        "finger_link"
    ):  # the published one is flat: two of its three numbers are zero
        size = tuple(float(row[f"{axis}max"]) - float(row[f"{axis}min"]) for axis in "xyz")
        return mass, com, box_inertia(mass, size)
    return (
        mass,
        com,
        {name: float(row[name]) for name in ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")},
    )


def add_collisions(link: ET.Element) -> None:
    """Return the simple solids for contact: boxes, cylinders along their z, spheres."""
    for kind, size, xyz, rpy in COLLISIONS.get(link.get("name"), ()):
        collision = ET.SubElement(link, "collision")
        add_origin(collision, xyz, rpy)
        names = {"box": ("size",), "cylinder": ("radius", "length"), "sphere": ("radius",)}[kind]
        values = [words(*size)] if kind == "box" else [words(value) for value in size]
        ET.SubElement(
            ET.SubElement(collision, "geometry"), kind, dict(zip(names, values, strict=True))
        )


def add_visuals(link: ET.Element) -> None:
    """Return the pieces of a link's shell, each with its colour."""
    for piece, (color, _) in SHELLS.get(link.get("name"), {}).items():
        visual = ET.SubElement(link, "visual")
        add_origin(visual)
        ET.SubElement(
            ET.SubElement(visual, "geometry"),
            "mesh",
            filename=f"meshes/{file_of(link.get('name'), piece)}",
        )
        material = ET.SubElement(
            visual, "material", name="_".join(f"{round(255 * part):02x}" for part in color)
        )
        ET.SubElement(material, "color", rgba=words(*color, 1.0))


def file_of(link: str, piece: str) -> str:
    """Return the name of a piece's mesh."""
    return f"{link.removesuffix('_link')}_{piece}.obj"


def add_joint(robot: ET.Element, row: dict[str, str]) -> None:
    """One row of the joints' table."""
    kind = "fixed" if row["joint"] in NOT_DRIVEN else row["type"]
    joint = ET.SubElement(robot, "joint", name=row["joint"], type=kind)
    add_origin(joint, (row["x"], row["y"], row["z"]), (row["roll"], row["pitch"], row["yaw"]))
    ET.SubElement(joint, "parent", link=row["parent"])
    ET.SubElement(joint, "child", link=row["child"])
    if kind == "fixed":
        return
    ET.SubElement(joint, "axis", xyz=words(row["ax"], row["ay"], row["az"]))
    names = [name for name in ("lower", "upper", "effort", "velocity") if row[name] != ""]
    ET.SubElement(joint, "limit", {name: words(row[name]) for name in names})
    if row["damping"]:
        ET.SubElement(joint, "dynamics", damping=words(row["damping"]))


def extra_joints(sprung: bool) -> list[dict[str, str]]:
    """Return what we add: the pen in its holder, and the skirt of the bellows."""
    blank = dict.fromkeys(
        ("x", "y", "z", "roll", "pitch", "yaw", "ax", "ay", "az", "lower", "upper"), ""
    )
    blank |= {"type": "fixed", "effort": "", "velocity": "", "damping": ""}
    hold = {"joint": "pen_holder_joint", "parent": "gripper_link", "child": "pen_holder_link"}
    hold |= {"pitch": math.pi / 2 + PEN_TILT}
    pen = {"joint": "pen_joint", "parent": "pen_holder_link", "child": "pen_link"}
    if sprung:
        pen |= {"joint": "pen_slide_joint", "type": "prismatic", "z": PRESSED, "az": 1.0}
        pen |= {"lower": -SLIDE, "upper": 0.0, "effort": 10.0, "velocity": 1.0}
    tip = {"joint": "pen_tip_joint", "parent": "pen_link", "child": "pen_tip", "z": PEN_LENGTH}
    skirt = {
        "joint": "bellows_skirt_joint",
        "parent": "torso_fixed_link",
        "child": "bellows_skirt_link",
    }
    return [blank | row for row in (hold, pen, tip, skirt)]


def urdf(sprung: bool) -> str:
    """Return the whole robot as text."""
    robot = ET.Element("robot", name="fetch_sprung" if sprung else "fetch")
    robot.append(ET.Comment(NOTE))
    for row in read("fetch_links.csv"):
        link = ET.SubElement(robot, "link", name=row["link"])
        add_inertial(link, *inertia_of(row))
        add_visuals(link)
        add_collisions(link)
    for name, (mass, middle, radius, length) in PEN_LINKS.items():
        link = ET.SubElement(robot, "link", name=name)
        add_inertial(
            link, mass, (0, 0, middle), box_inertia(mass, (2 * radius, 2 * radius, length))
        )
        add_visuals(link)
        add_collisions(link)
    skirt = ET.SubElement(robot, "link", name="bellows_skirt_link")
    add_inertial(skirt, 0.1, (0.005, 0, 0.03), box_inertia(0.1, (0.06, 0.28, 0.12)))
    add_visuals(skirt)
    for row in read("fetch_joints.csv") + extra_joints(sprung):
        add_joint(robot, row)
    ET.indent(robot)
    return (
        '<?xml version="1.0" encoding="utf-8"?>\n' + ET.tostring(robot, encoding="unicode") + "\n"
    )


def main() -> None:
    """Write both robots and their shells."""
    parser = argparse.ArgumentParser(description="Make fetch.urdf, fetch_sprung.urdf and meshes/.")
    parser.add_argument(
        "--out",
        type=Path,
        default=HERE,
        help="the folder to write to (default: beside this script)",
    )
    out = parser.parse_args().out
    (out / "meshes").mkdir(parents=True, exist_ok=True)
    for link, pieces in SHELLS.items():
        for piece, (_, mesh) in pieces.items():
            write_obj(mesh, out / "meshes" / file_of(link, piece))
    for name, sprung in (("fetch", False), ("fetch_sprung", True)):
        (out / f"{name}.urdf").write_text(urdf(sprung), encoding="utf-8", newline="\n")


if __name__ == "__main__":
    main()
