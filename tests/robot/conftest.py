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
