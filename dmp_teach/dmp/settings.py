"""Every choice that a primitive leaves open, each written once: default, range and plain name."""

from __future__ import annotations

import math
from dataclasses import dataclass, fields
from functools import cache
from typing import Any, Self

from dmp_teach.dmp.integrators import most_alpha
from dmp_teach.dmp.knob import Knob, knob
from dmp_teach.dmp.presets import preset
from dmp_teach.errors import SettingError

KERNELS_PER_SECOND = 12  # the paper's N = Num/10, for its 120 samples a second
LEAST_ALPHA, MOST_ALPHA = 1.0, 10_000.0
YES_NO = (True, False)


@dataclass(frozen=True)
class Settings:
    """How a primitive is built. A preset gives all of it; keywords change parts: `Settings.star(kernel_width=2.0)`.

    What every preset sets stands in one table, `dmp_teach.dmp.presets.TABLE`. The settings that explain themselves
    least:

    - `n_kernels` None takes 12 for each second, or one for each `samples_per_kernel` samples where that is given.
    - `kernel_width` and `kernel_sigma` are counted in spacings between kernels, 1/N, and may be `math.inf`: a kernel
      without ends, a kernel without a hump (a box). A mollifier has no sigma and must have ends.
    - `kernel_centers`: "middles" of N equal times; as phases, "phases" (i - 1/2)/N, "ends" (i - 1)/(N - 1), "grid" i/N.
    - `alpha` is D over one movement: D = alpha / T, K = (alpha / (2 damping) / T)^2. None takes `alpha_per_second` T
      where that is given, else `alpha_per_kernel` for each kernel and at least 12.
    - `phase_decay`: an exponential phase ends at exp(-phase_decay), a sigmoid one close to it; `phase_middle`: where
      a sigmoid one is half over.
    - `divide`: whether the needed forcing is divided by what multiplies it, K or (g - y0), before it is learned.
    - `feed_goal` concerns "star" alone: the other transformations move the whole path with its goal.
    - `smoothing` None leaves the demonstration as it is. `sharpen` makes good what boxes fitted by LWR round off;
      other fits round nothing, and ignore it.

    Raises:
        SettingError: A value out of its range, or values that do not go together; names both, the rule and the cure.
    """

    n_kernels: int | None = knob(
        None,
        low=1,
        high=300,
        limit=3000,
        whole=True,
        optional=True,
        label="how many bumps",
        term="number of kernels",
    )
    kernel_width: float = knob(
        1.0, low=0.2, high=40.0, endless=True, label="how wide each bump is", term="kernel width"
    )
    kernel_sigma: float = knob(
        math.inf,
        low=0.2,
        high=40.0,
        endless=True,
        label="how round each bump is",
        term="kernel sigma",
    )
    alpha: float | None = knob(
        None,
        optional=True,
        low=LEAST_ALPHA,
        high=200.0,
        limit=MOST_ALPHA,
        label="how stiff the spring is",
        term="stiffness",
    )
    alpha_per_kernel: float = knob(
        2.0,
        low=0.5,
        high=6.0,
        label="how much stiffer each bump makes the spring",
        term="stiffness per kernel",
    )
    phase: str = knob(
        "linear",
        choices=("linear", "exponential", "sigmoid"),
        label="how the clock runs down",
        term="phase",
    )
    phase_decay: float = knob(
        4.6, low=1.0, high=10.0, label="how far the clock runs down", term="phase decay"
    )
    transform: str = knob(
        "star",
        choices=("star", "original", "similarity"),
        label="what follows the goal",
        term="transformation",
    )
    fit: str = knob(
        "lwr", choices=("lwr", "bias", "joint"), label="how the bumps are learned", term="fit"
    )
    integrator: str = knob(
        "explicit",
        choices=("explicit", "semi-implicit", "exact", "lagged"),
        label="how the pen steps through time",
        term="integrator",
    )
    feed_goal: bool = knob(
        True, choices=YES_NO, label="the pen knows that its goal moved", term="goal feed-forward"
    )
    smoothing: float | None = knob(
        10.0,
        optional=True,
        low=2.0,
        high=60.0,
        label="what counts as trembling",
        term="smoothing [Hz]",
    )
    sharpen: bool = knob(True, choices=YES_NO, label="bends are kept sharp", term="sharpening")
    samples_per_kernel: float | None = knob(
        None,
        optional=True,
        low=1.0,
        high=100.0,
        label="how many samples share a bump",
        term="samples per kernel",
    )
    kernel: str = knob(
        "gaussian", choices=("gaussian", "mollifier"), label="what shape a bump has", term="kernel"
    )
    kernel_centers: str = knob(
        "middles",
        choices=("middles", "phases", "ends", "grid"),
        label="where the bumps stand",
        term="kernel centres",
    )
    kernel_sides: str = knob(
        "both", choices=("both", "one"), label="which sides a bump ends on", term="kernel sides"
    )
    alpha_per_second: float | None = knob(
        None,
        optional=True,
        low=0.5,
        high=200.0,
        label="how stiff the spring is in a second",
        term="stiffness per second",
    )
    damping: float = knob(
        1.0, low=0.1, high=2.0, label="how little the spring swings", term="damping ratio"
    )
    phase_middle: float = knob(
        0.75,
        low=0.5,
        high=0.9,
        label="when a sigmoid clock is half over",
        term="middle of the sigmoid",
    )
    divide: bool = knob(
        True, choices=YES_NO, label="the push is learned in its own units", term="division of F"
    )
    derivatives: str = knob(
        "inverse",
        choices=("inverse", "central"),
        label="how speeds are read off the ink",
        term="derivatives",
    )
    start_velocity: str = knob(
        "fitted",
        choices=("fitted", "measured"),
        label="how fast the pen starts",
        term="start velocity",
    )

    def __post_init__(self) -> None:
        """Check every field against its own range, and those that must go together."""
        for each in knobs():
            object.__setattr__(self, each.name, each.checked(getattr(self, each.name)))
        _refuse_what_does_not_go_together(self)

    @classmethod
    def star(cls, **changes: Any) -> Self:
        """DMP*, the paper's choice: linear phase, touching boxes, locally weighted regression."""
        return cls._preset("star", changes)

    @classmethod
    def original(cls, **changes: Any) -> Self:
        """Ijspeert 2002, the paper's equations 1 to 5: exponential phase, full Gaussians, forcing times (g - y0)."""
        return cls._preset("original", changes)

    @classmethod
    def joint(cls, **changes: Any) -> Self:
        """DMP* with full Gaussians whose weights are fitted all together, to the path itself, by ridge regression."""
        return cls._preset("joint", changes)

    @classmethod
    def plus(cls, **changes: Any) -> Self:
        """DMP* with the local biases of DMP+ (Wang 2016): each kernel learns a slope and an offset."""
        return cls._preset("plus", changes)

    @classmethod
    def as_printed(cls, **changes: Any) -> Self:
        """The paper to the letter, its contradictions kept: what a reader draws who trusts every formula."""
        return cls._preset("as_printed", changes)

    @classmethod
    def as_coded(cls, **changes: Any) -> Self:
        """The paper as its authors' own program has it: theta = 1/N, centres i/N, an underdamped spring."""
        return cls._preset("as_coded", changes)

    @classmethod
    def as_fixed(cls, **changes: Any) -> Self:
        """The paper with its contradictions mended and nothing added: no smoothing, no feed-forward."""
        return cls._preset("as_fixed", changes)

    @classmethod
    def _preset(cls, name: str, changes: dict[str, Any]) -> Self:
        """A preset with `changes`, or a sentence that names the settings that exist."""
        changed = _unchanged(cls, name)._with(
            **{each: knob_of(each).checked(value) for each, value in changes.items()}
        )
        _refuse_what_does_not_go_together(changed)
        return changed

    def resolved(self, duration: float, samples: int) -> Self:
        """The same with numbers for `n_kernels` and `alpha`, for a movement of `duration` [s] and so many samples.

        Raises:
            SettingError: More kernels were asked for than there are samples.
        """
        n_kernels = self.n_kernels
        if n_kernels is None:
            wanted = KERNELS_PER_SECOND * round(duration, 6)
            if self.samples_per_kernel is not None:
                wanted = samples / self.samples_per_kernel
            n_kernels = min(max(1, round(wanted)), samples, 3000)
        if n_kernels > samples:
            raise SettingError(
                f"n_kernels is {n_kernels}, but the trajectory has only {samples} samples; use at most {samples}."
            )
        alpha = self.alpha
        if alpha is None:
            most = min(MOST_ALPHA, most_alpha(self.damping))
            given = self.alpha_per_second
            alpha = (
                max(12.0, self.alpha_per_kernel * n_kernels) if given is None else given * duration
            )
            alpha = min(max(LEAST_ALPHA, alpha), most)
        return self._with(n_kernels=n_kernels, alpha=float(alpha))

    def _with(self, **checked: Any) -> Self:
        """A copy with other values for some settings, all of them checked already: `replace` would check every one."""
        other = object.__new__(type(self))
        other.__dict__.update(self.__dict__)
        other.__dict__.update(checked)
        return other


@cache
def _unchanged(cls: type[Settings], name: str) -> Settings:
    """A preset as its table has it, checked once."""
    return cls(**preset(name))


def _refuse_what_does_not_go_together(settings: Settings) -> None:
    """Raise a SettingError that names two settings, the rule and the cure."""
    if settings.kernel == "mollifier" and math.isinf(settings.kernel_width):
        raise SettingError(
            "kernel is 'mollifier' and kernel_width is inf, but a mollifier falls to 0 at its ends and must have some: "
            "give kernel_width a number, 2 for instance."
        )
    if settings.kernel == "mollifier" and not math.isinf(settings.kernel_sigma):
        raise SettingError(
            f"kernel is 'mollifier' and kernel_sigma is {settings.kernel_sigma:g}, but a mollifier has no sigma, its "
            "width alone shapes it: give kernel_sigma=math.inf."
        )
    if settings.kernel_sides == "one" and (
        math.isinf(settings.kernel_width) or settings.kernel == "mollifier"
    ):
        raise SettingError(
            f"kernel_sides is 'one', but this {settings.kernel} of kernel_width {settings.kernel_width:g} cannot be "
            "left open on one side: give kernel='gaussian' and kernel_width a number, or kernel_sides='both'."
        )
    if settings.alpha is not None and settings.alpha > most_alpha(settings.damping):
        most = math.floor(most_alpha(settings.damping))
        raise SettingError(
            f"alpha is {settings.alpha:g} and damping {settings.damping:g}, but no step of ours can follow so stiff a "
            f"spring that swings so much: use an alpha of at most {most}, or a damping nearer to 1."
        )


@cache
def knobs() -> tuple[Knob, ...]:
    """Every knob of `Settings`, in its order."""
    return tuple(Knob(each.name, each.default, **each.metadata) for each in fields(Settings))


@cache
def _by_name() -> dict[str, Knob]:
    return {each.name: each for each in knobs()}


def knob_of(name: str) -> Knob:
    """The knob of one setting.

    Raises:
        SettingError: There is no setting of that name; names those that exist.
    """
    by_name = _by_name()
    if name not in by_name:
        raise SettingError(f"There is no setting {name!r}. The settings are: {', '.join(by_name)}.")
    return by_name[name]
