"""What several tests of the robot need."""

import builtins

import pytest


@pytest.fixture
def without_pybullet(monkeypatch):
    """A platform for which there is no pybullet."""
    real = builtins.__import__

    def without(name, *rest):
        if name == "pybullet":
            raise ImportError(name)
        return real(name, *rest)

    monkeypatch.setattr(builtins, "__import__", without)


@pytest.fixture(params=["PlaCo", "NumPy"])
def each_solver(request, monkeypatch):
    """Let each solver plan what a test asks for."""
    monkeypatch.setenv("DMP_TEACH_SOLVER", request.param)
