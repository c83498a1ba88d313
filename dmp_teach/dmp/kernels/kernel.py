"""What a kernel is, and the rules that every kernel keeps."""

from __future__ import annotations

import math
from abc import abstractmethod
from dataclasses import fields
from typing import ClassVar

from dmp_teach.dmp.registry import NamedChoice, Registry
from dmp_teach.errors import SettingError
from dmp_teach.trajectory import Array


class Kernel(NamedChoice):
    """The shape of one bump.

    A new kernel is one file in this folder, with one class:

        @KERNELS.add
        class Triangle(Kernel):
            name = "triangle"

            def height(self, r, z):
                return 1 - abs(r)

    It is then a choice for `Settings(kernel=...)`, tested by every law, refused with settings that
    it does not use, and drawn in the figure of kernels. `kernel_sigma` is a setting of its own only
    where it has a field `sigma`.

    Attributes:
        endless: Whether it is above 0 at its ends, so that it may be cut anywhere: at any width,
            on one side only, or nowhere. Others fall to 0 at their ends and must have both.
        examples: The kinds that the figure of kernels shows: title, width [1/N], kernel.
    """

    setting = "kernel"
    endless: ClassVar[bool] = False
    examples: ClassVar[tuple[tuple[str, float, Kernel], ...] | None] = None

    @abstractmethod
    def height(self, r: Array, z: Array) -> Array:
        """Return psi inside the ends of the kernel, between 0 and 1, in the shape of r and z.

        Args:
            r: The distance from its middle in half widths, -1 to 1; 0 where it has no ends.
            z: The distance from its centre in spacings between kernels, 1/N.
        """

    @property
    def is_box(self) -> bool:
        """Whether psi is 1 everywhere inside."""
        return False

    @classmethod
    def kinds(cls) -> tuple[tuple[str, float, Kernel], ...]:
        """Return what the figure of kernels shows of it."""
        return ((f"{cls.name}: width 2/N", 2.0, cls()),) if cls.examples is None else cls.examples

    @classmethod
    def check(cls, width: float, sigma: float, sides: str) -> None:
        """Raise a SettingError where width, sigma and sides do not go with this kernel."""
        if math.isinf(width) and not cls.endless:
            raise SettingError(
                f"kernel is {cls.name!r} and kernel_width is inf, but {cls._noun()} falls to 0 at "
                "its ends and must have some: give kernel_width a number, 2 for instance."
            )
        if not math.isinf(sigma) and "sigma" not in [each.name for each in fields(cls)]:
            raise SettingError(
                f"kernel is {cls.name!r} and kernel_sigma is {sigma:g}, but {cls._noun()} has no "
                "sigma, its width alone shapes it: give kernel_sigma=math.inf."
            )
        if sides == "one" and (math.isinf(width) or not cls.endless):
            raise SettingError(
                f"kernel_sides is 'one', but this {cls.name} of kernel_width {width:g} cannot be "
                "left open on one side: give kernel='gaussian' and kernel_width a number, or "
                "kernel_sides='both'."
            )

    @classmethod
    def cure_for_gaps(cls, width: float) -> str:
        """Return a sentence that says what closes the gaps between kernels of this width."""
        if not cls.endless:
            noun = cls._noun().capitalize()
            return f"{noun} is 0 at its ends: give it a kernel_width over 1, 2 for instance."
        if width < 1:
            return "A kernel_width of 1 or more closes them."
        return "kernel_centers='middles' closes them."

    @classmethod
    def _noun(cls) -> str:
        return f"{'an' if cls.name[0] in 'aeiou' else 'a'} {cls.name}"


KERNELS: Registry[type[Kernel]] = Registry()
