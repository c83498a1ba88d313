"""Every choice that a primitive leaves open, each written once: default, range and plain name."""

from __future__ import annotations

import math
from dataclasses import dataclass, fields
from functools import cache
from textwrap import indent
from typing import Self, Unpack

from dmp_teach.arguments import checked
from dmp_teach.dmp.fit import FITS
from dmp_teach.dmp.integrators import DERIVATIVES, INTEGRATORS, most_alpha
from dmp_teach.dmp.kernels import KERNELS, PLACEMENTS
from dmp_teach.dmp.knob import Knob, knob
from dmp_teach.dmp.phases import PHASES
from dmp_teach.dmp.presets import PRESETS, SettingChanges, table_of_choices
from dmp_teach.dmp.transformations import TRANSFORMATIONS
from dmp_teach.errors import SettingError
from dmp_teach.values import Value

# The paper's N = Num/10, for its 120 samples a second.
KERNELS_PER_SECOND = 12
MOST_KERNELS = 3000
SMALLEST_ALPHA, LARGEST_ALPHA = 1.0, 10_000.0
YES_NO = (True, False)


@dataclass(frozen=True, eq=False, repr=False)
class Settings(Value):
    """How a primitive is built: a preset, and changes of it, `Settings.star(kernel_width=2.0)`.

    How each preset differs from `star` stands in `dmp_teach.dmp.presets.PRESETS`. The settings
    that explain themselves least:

    - `n_kernels` None takes 12 for each second, or one for each `samples_per_kernel` samples where
      that is given.
    - `kernel_width` and `kernel_sigma` are counted in spacings between kernels, 1/N, and may be
      `math.inf`: a kernel without ends, a kernel without a hump (a box). A mollifier has no sigma
      and must have ends. `kernel_spread` gives sigma as a phase instead, whatever N is.
    - `kernel_floor`: the height of a kernel beyond its ends; where no other is active, f is then s
      times the mean of all weights.
    - `kernel_centers`: "middles" of N equal times; as phases, "phases" (i - 1/2)/N, "ends"
      (i - 1)/(N - 1), "grid" i/N.
    - `kernel_sides`: "both" as cells that touch, "one" as printed, x - c <= theta, "closed"
      |x - c| <= theta, so that two kernels share a sample where they touch.
    - `alpha` is D over one movement: D = alpha / T, K = (alpha / (2 damping) / T)^2. None takes
      `alpha_per_second` T where that is given, else `alpha_per_kernel` for each kernel and at
      least 12.
    - `phase_decay`: an exponential phase ends at exp(-phase_decay), a sigmoid one close to it;
      `phase_middle`: where a sigmoid one is half over.
    - `divide`: whether the needed forcing is divided by what multiplies it, K or (g - y0), before
      it is learned.
    - `feed_goal` concerns "star" alone: the other transformations move the whole path with its
      goal.
    - `start_velocity`: "fitted" to the whole path, "measured" at the first sample, or measured and
      "kept" where the original form leads its path to another goal: else it grows with the path.
    - `smoothing` None leaves the demonstration as it is. `sharpen` makes good what boxes fitted by
      LWR round off; other fits round nothing, and ignore it.

    Raises:
        SettingError: A value out of its range, or values that do not go together; names both, the
            rule and the cure.
    """

    n_kernels: int | None = knob(
        None,
        "how many bumps",
        "number of kernels",
        low=1,
        high=300,
        limit=MOST_KERNELS,
        whole=True,
        optional=True,
    )
    kernel_width: float = knob(
        1.0, "how wide each bump is", "kernel width", low=0.2, high=40.0, endless=True
    )
    kernel_sigma: float = knob(
        math.inf,
        "how round each bump is",
        "kernel sigma",
        low=0.2,
        high=40.0,
        limit=MOST_KERNELS,
        endless=True,
    )
    alpha: float | None = knob(
        None,
        "how stiff the spring is",
        "stiffness",
        optional=True,
        low=SMALLEST_ALPHA,
        high=200.0,
        limit=LARGEST_ALPHA,
    )
    alpha_per_kernel: float = knob(
        2.0,
        "how much stiffer each bump makes the spring",
        "stiffness per kernel",
        low=0.5,
        high=6.0,
    )
    phase: str = knob("linear", "how the clock runs down", "phase", options=PHASES)
    phase_decay: float = knob(4.6, "how far the clock runs down", "phase decay", low=1.0, high=10.0)
    transform: str = knob(
        "star", "what follows the goal", "transformation", options=TRANSFORMATIONS
    )
    fit: str = knob("lwr", "how the bumps are learned", "fit", options=FITS)
    integrator: str = knob(
        "explicit", "how the pen steps through time", "integrator", options=INTEGRATORS
    )
    feed_goal: bool = knob(
        True, "the pen knows that its goal moved", "goal feed-forward", options=YES_NO
    )
    smoothing: float | None = knob(
        10.0, "what counts as trembling", "smoothing [Hz]", optional=True, low=2.0, high=60.0
    )
    sharpen: bool = knob(True, "bends are kept sharp", "sharpening", options=YES_NO)
    samples_per_kernel: float | None = knob(
        None,
        "how many samples share a bump",
        "samples per kernel",
        optional=True,
        low=1.0,
        high=100.0,
    )
    kernel: str = knob("gaussian", "what shape a bump has", "kernel", options=KERNELS)
    kernel_centers: str = knob(
        "middles", "where the bumps stand", "kernel centres", options=PLACEMENTS
    )
    kernel_sides: str = knob(
        "both", "which sides a bump ends on", "kernel sides", options=("both", "one", "closed")
    )
    kernel_spread: float | None = knob(
        None, "how round each bump is", "sigma as a phase", optional=True, low=0.001, high=1.0
    )
    kernel_floor: float = knob(
        0.0, "how high a bump is beyond its ends", "kernel floor", low=0.0, high=0.01
    )
    alpha_per_second: float | None = knob(
        None,
        "how stiff the spring is in a second",
        "stiffness per second",
        optional=True,
        low=0.5,
        high=200.0,
    )
    damping: float = knob(1.0, "how little the spring swings", "damping ratio", low=0.1, high=2.0)
    phase_middle: float = knob(
        0.75, "when a sigmoid clock is half over", "middle of the sigmoid", low=0.5, high=0.9
    )
    divide: bool = knob(
        True, "the push is learned in its own units", "division of F", options=YES_NO
    )
    derivatives: str = knob(
        "inverse", "how speeds are read off the ink", "derivatives", options=DERIVATIVES
    )
    start_velocity: str = knob(
        "fitted",
        "how fast the pen starts",
        "start velocity",
        options=("fitted", "measured", "kept"),
    )

    def __post_init__(self) -> None:
        for each in knobs():
            object.__setattr__(self, each.name, each.checked(getattr(self, each.name)))
        sigma = self.kernel_sigma if self.kernel_spread is None else self.kernel_spread
        KERNELS[self.kernel].check(self.kernel_width, sigma, self.kernel_sides)
        if self.alpha is not None and self.alpha > most_alpha(self.damping):
            most = math.floor(most_alpha(self.damping))
            raise SettingError(
                f"alpha is {self.alpha:g} and damping {self.damping:g}, but no step of ours can "
                f"follow so stiff a spring that swings so much: use an alpha of at most {most}, or "
                "a damping nearer to 1."
            )

    @classmethod
    def star(cls, **changes: Unpack[SettingChanges]) -> Self:
        """Return our DMP*: the paper's form and phase with improvements that are not in it.

        `as_fixed` is the paper without them.
        """
        return cls._preset("star", changes)

    @classmethod
    def original(cls, **changes: Unpack[SettingChanges]) -> Self:
        """Return Ijspeert 2002, the paper's equations 1 to 5, smoothed and started as `star`."""
        return cls._preset("original", changes)

    @classmethod
    def joint(cls, **changes: Unpack[SettingChanges]) -> Self:
        """Return DMP* with full Gaussians, their weights fitted together by ridge regression."""
        return cls._preset("joint", changes)

    @classmethod
    def plus(cls, **changes: Unpack[SettingChanges]) -> Self:
        """Return DMP* with the local biases of DMP+ (Wang 2016): each kernel learns a line."""
        return cls._preset("plus", changes)

    @classmethod
    def as_printed(cls, **changes: Unpack[SettingChanges]) -> Self:
        """Return the paper to the letter, its contradictions kept: every formula as it stands."""
        return cls._preset("as_printed", changes)

    @classmethod
    def as_coded(cls, **changes: Unpack[SettingChanges]) -> Self:
        """Return the authors' own program: theta = 1/N, centres i/N, an underdamped spring."""
        return cls._preset("as_coded", changes)

    @classmethod
    def as_fixed(cls, **changes: Unpack[SettingChanges]) -> Self:
        """Return the paper with its contradictions mended and nothing added."""
        return cls._preset("as_fixed", changes)

    @classmethod
    @cache
    def _usual(cls, name: str) -> Self:
        """Return a preset as it is: settings never change, so that one serves everybody."""
        return cls(**PRESETS[name])

    @classmethod
    def _preset(cls, name: str, changes: SettingChanges) -> Self:
        """Return a preset with `changes`, or name the settings that exist."""
        for each in changes:
            knob_of(each)
        return cls(**PRESETS[name] | changes) if changes else cls._usual(name)

    @checked
    def resolved(self, duration: float, samples: int) -> Self:
        """Return the same with numbers for `n_kernels` and `alpha`.

        Args:
            duration: Of the movement [s].
            samples: How many it has.

        Raises:
            SettingError: More kernels than samples, or a duration that is none.
        """
        if not 0 < duration < math.inf:
            raise SettingError(f"duration is {duration}, but must be a time longer than 0 s.")
        n_kernels, alpha = self.n_kernels, self.alpha
        if n_kernels is None:
            wanted = KERNELS_PER_SECOND * round(duration, 6)
            if self.samples_per_kernel is not None:
                wanted = samples / self.samples_per_kernel
            n_kernels = min(max(1, round(wanted)), samples, MOST_KERNELS)
        if n_kernels > samples:
            raise SettingError(
                f"n_kernels is {n_kernels}, but the trajectory has only {samples} samples; use at "
                f"most {samples}."
            )
        if alpha is None:
            if self.alpha_per_second is None:
                alpha = max(12.0, self.alpha_per_kernel * n_kernels)
            else:
                alpha = self.alpha_per_second * duration
            most = min(LARGEST_ALPHA, most_alpha(self.damping))
            alpha = min(max(SMALLEST_ALPHA, alpha), most)
        # Both are in range: `replace` would check every setting again, which costs more than a fit.
        same = object.__new__(type(self))
        same.__dict__.update(self.__dict__, n_kernels=n_kernels, alpha=float(alpha))
        if self.kernel_spread is not None:
            same.__dict__["kernel_sigma"] = self.kernel_spread * n_kernels
        return same


# One source for the words here and in the documentation.
vars(Settings)["star"].__func__.__doc__ += "\n" + indent(table_of_choices(), 8 * " ")


@cache
def knobs() -> tuple[Knob, ...]:
    """Return every knob of `Settings`, in its order."""
    return tuple(Knob(each.name, each.default, **each.metadata) for each in fields(Settings))


def knob_of(name: str) -> Knob:
    """Return the knob of one setting.

    Raises:
        SettingError: There is no setting of that name; names those that exist.
    """
    for each in knobs():
        if each.name == name:
            return each
    names = ", ".join(each.name for each in knobs())
    raise SettingError(f"There is no setting {name!r}. The settings are: {names}.")
