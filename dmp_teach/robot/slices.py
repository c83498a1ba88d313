"""Long work in slices, between which other things are heard: *Stop*, or another panel."""

from __future__ import annotations

from collections.abc import Generator
from typing import TypeVar

from dmp_teach.progress import StepProgress

Result = TypeVar("Result")

Slices = Generator[tuple[str, float], None, Result]
"""Yields the name of a step and the fraction of it that is done, 0 to 1; returns the result."""


def run_through(slices: Slices[Result], report: StepProgress | None = None) -> Result:
    """Do all slices and return the result; what `report` raises is raised within them."""
    try:
        told = next(slices)
        while True:
            try:
                if report is not None:
                    report(*told)
            except BaseException as error:
                told = slices.throw(error)
            else:
                told = next(slices)
    except StopIteration as end:
        return end.value


def creep(slices: Slices[Result]) -> Slices[Result]:
    """Do slices whose number nobody knows: what is told to be done creeps on towards 1."""
    done = 0.0
    while True:
        try:
            step, _ = next(slices)
        except StopIteration as end:
            return end.value
        yield step, done
        done += (1 - done) / 20
