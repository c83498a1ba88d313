"""The pins agree with pyproject.toml on every computer that we name, and may be given away."""

import re
import tomllib
from importlib.metadata import PackageNotFoundError, metadata
from pathlib import Path

import pytest
from packaging.requirements import Requirement

ROOT = Path(__file__).parents[1]
PINS = [
    Requirement(line)
    for line in (ROOT / "environment.txt").read_text().splitlines()
    if not line.startswith("#")
]
LINUX = {
    "sys_platform": "linux",
    "platform_system": "Linux",
    "os_name": "posix",
    "platform_machine": "x86_64",
}
WINDOWS = {
    "sys_platform": "win32",
    "platform_system": "Windows",
    "os_name": "nt",
    "platform_machine": "AMD64",
}
MAC = {
    "sys_platform": "darwin",
    "platform_system": "Darwin",
    "os_name": "posix",
    "platform_machine": "arm64",
}
COMPUTERS = {
    f"{name}-{version}": {
        **computer,
        "python_version": version,
        "python_full_version": version + ".9",
    }
    for name, computer in {
        "linux": LINUX,
        "arm": {**LINUX, "platform_machine": "aarch64"},
        "windows": WINDOWS,
        "mac": MAC,
    }.items()
    for version in ("3.11", "3.12", "3.13")
}
FREE = r"MIT|BSD|Apache|ISC|PSF|Python Software Foundation|Zlib|BSL-1.0|MPL|Mozilla Public"
SAID_ELSEWHERE = {
    "cmeel-qhull": "Qhull's own licence, which asks only to be named",
    "apsw": "any licence that the Open Source Initiative has approved, as one likes",
}


def declared(extras=True):
    """What pyproject.toml asks for."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    optional = project["optional-dependencies"]
    more = optional["test"] + optional["ways"] if extras else []
    return [Requirement(line) for line in project["dependencies"] + more]


def wanted(requirement, computer):
    return requirement.marker is None or requirement.marker.evaluate(computer)


@pytest.mark.parametrize("computer", COMPUTERS.values(), ids=COMPUTERS)
def test_the_pins_are_what_pyproject_asks_for(computer):
    pins = {pin.name: pin for pin in PINS if wanted(pin, computer)}
    for requirement in declared():
        name = requirement.name.lower().replace("_", "-")
        if wanted(requirement, computer):
            (pin,) = pins[name].specifier
            assert requirement.specifier.contains(pin.version), f"{name} {pin.version}"
        else:
            assert name not in pins, f"{name} has nothing to install there"


def test_a_computer_without_wheels_is_not_asked_to_build():
    names = {
        computer: {pin.name for pin in PINS if wanted(pin, COMPUTERS[computer])}
        for computer in COMPUTERS
    }
    assert {"placo", "pybullet"} <= names["linux-3.11"]
    assert "pybullet" not in names["linux-3.12"] | names["arm-3.11"] | names["mac-3.11"]
    assert not {
        name
        for name in names["windows-3.11"]
        if name.startswith(("placo", "pin", "cmeel", "pybullet"))
    }


def test_every_pin_names_one_version_of_an_index_that_it_does_not_name():
    for pin in PINS:
        (version,) = pin.specifier
        assert version.operator == "=="
        assert pin.url is None
    assert "://" not in (ROOT / "environment.txt").read_text()


def test_the_head_says_how_it_is_made():
    head = (ROOT / "environment.txt").read_text().splitlines()[:2]
    assert "uv pip compile --universal" in head[1]


@pytest.mark.parametrize("name", sorted({pin.name for pin in PINS}))
def test_every_licence_agrees_with_ours(name):
    try:
        about = metadata(name)
    except PackageNotFoundError:
        return  # for another kind of computer
    classifiers = [
        line for line in about.get_all("Classifier") or [] if line.startswith("License ::")
    ]
    said = " ".join([about.get("License-Expression") or "", *classifiers]).strip()
    said = said or (about.get("License") or "").strip()[:200] or SAID_ELSEWHERE.get(name, "")
    assert name in SAID_ELSEWHERE or re.search(FREE, said, re.IGNORECASE), said
    assert not re.search(r"\bA?GPL|GNU (Affero )?General", said), said
