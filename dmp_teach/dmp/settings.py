"""Every choice that a primitive leaves open, each written once: default, range and plain name."""

import math
from dataclasses import dataclass, field, fields, replace
from functools import cache
from typing import Any, Self

from dmp_teach.errors import SettingError

KERNELS_PER_SECOND = 12  # the paper's N = Num/10, for its 120 samples a second


@dataclass(frozen=True)
class Knob:
    """What a child or teacher can turn: its default, its range and its names.

    `low` and `high` are where a slider ends, `limit` (or else `high`) is where a number is refused;
    `whole` numbers only, `endless` takes infinity too, `optional` takes None too; `choices` are the words of
    a setting that is not a number. `term` is the real word, `label` the plain one.
    """

    name: str
    default: Any
    label: str
    term: str
    low: float | None = None
    high: float | None = None
    limit: float | None = None
    whole: bool = False
    endless: bool = False
    optional: bool = False
    choices: tuple[str, ...] = ()

    def checked(self, value: Any) -> Any:
        """`value` as the type that it should have.

        Raises:
            SettingError: It is out of range, or no such choice.
        """
        if self.choices:
            return self._one_of_the_choices(value)
        if (value is None and self.optional) or (self.endless and value == math.inf):
            return value
        limit = self.high if self.limit is None else self.limit
        what = (
            f"a whole number between {self.low:g} and {limit:g}"
            if self.whole
            else f"between {self.low:g} and {limit:g}"
        )
        if isinstance(value, (str, bool)) or not _is_number(value) or not self.low <= value <= limit:
            raise SettingError(f"{self.name} is {value!r}, but it must be {what}.")
        if self.whole and value != int(value):
            raise SettingError(f"{self.name} is {value!r}, but it must be {what}.")
        return int(value) if self.whole else float(value)

    def _one_of_the_choices(self, value: Any) -> str:
        if value not in self.choices:
            names = ", ".join(map(repr, self.choices))
            raise SettingError(f"{self.name} is {value!r}, but it must be one of: {names}.")
        return value


def _is_number(value: Any) -> bool:
    try:
        return not math.isnan(float(value))
    except (TypeError, ValueError):
        return False


def knob(default: Any, *, label: str, term: str, **about: Any) -> Any:
    """A field of `Settings` that carries its own range and names."""
    return field(default=default, metadata={"label": label, "term": term, **about})


@dataclass(frozen=True)
class Settings:
    """How a primitive is built. A preset gives all of it; keywords change parts: `Settings.star(kernel_width=2.0)`.

    `kernel_width` and `kernel_sigma` are counted in spacings between kernels, 1/N, and may be `math.inf`:
    a kernel without ends, a kernel without a hump (a box). `alpha` is the stiffness of the spring over one
    movement, K = alpha^2 / 4 / T^2 and D = alpha / T; None takes `alpha_per_kernel` for each kernel, and at
    least 12. `n_kernels` None takes 12 for each second. `smoothing` None leaves the demonstration as it is. `sharpen`
    makes good what boxes fitted by LWR round off; other fits round nothing, and ignore it.

    Raises:
        SettingError: A value out of its range; names the setting, the value and the range.
    """

    n_kernels: int | None = knob(
        None, low=1, high=300, limit=3000, whole=True, optional=True, label="how many bumps", term="number of kernels"
    )
    kernel_width: float = knob(
        1.0, low=0.2, high=40.0, endless=True, label="how wide each bump is", term="kernel width"
    )
    kernel_sigma: float = knob(
        math.inf, low=0.2, high=40.0, endless=True, label="how round each bump is", term="kernel sigma"
    )
    alpha: float | None = knob(
        None, optional=True, low=1.0, high=200.0, limit=10_000.0, label="how stiff the spring is", term="stiffness"
    )
    alpha_per_kernel: float = knob(
        2.0, low=0.5, high=6.0, label="how much stiffer each bump makes the spring", term="stiffness per kernel"
    )
    phase: str = knob("linear", choices=("linear", "exponential"), label="how the clock runs down", term="phase")
    phase_decay: float = knob(
        4.6, low=1.0, high=10.0, label="how fast an exponential clock runs down", term="phase decay"
    )
    transform: str = knob("star", choices=("star", "original"), label="what follows the goal", term="transformation")
    fit: str = knob("lwr", choices=("lwr", "bias", "joint"), label="how the bumps are learned", term="fit")
    integrator: str = knob(
        "explicit", choices=("explicit", "semi-implicit"), label="how the pen steps through time", term="integrator"
    )
    feed_goal: bool = knob(
        True, choices=(True, False), label="the pen knows that its goal moved", term="goal feed-forward"
    )
    smoothing: float | None = knob(
        10.0, optional=True, low=2.0, high=60.0, label="what counts as trembling", term="smoothing [Hz]"
    )
    sharpen: bool = knob(True, choices=(True, False), label="bends are kept sharp", term="sharpening")

    def __post_init__(self) -> None:
        """Check every field against its own range."""
        for each in knobs():
            object.__setattr__(self, each.name, each.checked(getattr(self, each.name)))

    @classmethod
    def star(cls, **changes: Any) -> Self:
        """DMP*, the paper's choice: linear phase, touching boxes, locally weighted regression."""
        return _changed(cls(), changes)

    @classmethod
    def original(cls, **changes: Any) -> Self:
        """Ijspeert 2002, the paper's equations 1 to 5: exponential phase, full Gaussians, forcing times (g - y0)."""
        about = {"kernel_width": math.inf, "kernel_sigma": 0.65, "alpha": 25.0, "phase": "exponential"}
        return _changed(cls(**about, transform="original", feed_goal=False, sharpen=False), changes)

    @classmethod
    def joint(cls, **changes: Any) -> Self:
        """DMP* with full Gaussians whose weights are fitted all together, to the path itself, by ridge regression."""
        about = {"kernel_width": math.inf, "kernel_sigma": 0.65, "fit": "joint", "alpha_per_kernel": 4.0}
        return _changed(cls(**about, integrator="semi-implicit", smoothing=None), changes)

    @classmethod
    def plus(cls, **changes: Any) -> Self:
        """DMP* with the local biases of DMP+ (Wang 2016): each kernel learns a slope and an offset."""
        about = {"alpha_per_kernel": 3.0, "integrator": "semi-implicit", "smoothing": 20.0}
        return _changed(cls(**about, fit="bias"), changes)

    def resolved(self, duration: float, samples: int) -> Self:
        """The same with numbers for `n_kernels` and `alpha`, for a movement of `duration` [s] and so many samples.

        Raises:
            SettingError: More kernels were asked for than there are samples.
        """
        n_kernels = self.n_kernels
        if n_kernels is None:
            n_kernels = min(max(1, round(KERNELS_PER_SECOND * round(duration, 6))), samples, 3000)
        if n_kernels > samples:
            raise SettingError(
                f"n_kernels is {n_kernels}, but the trajectory has only {samples} samples; use at most {samples}."
            )
        alpha = max(12.0, self.alpha_per_kernel * n_kernels) if self.alpha is None else self.alpha
        return replace(self, n_kernels=n_kernels, alpha=alpha)


def _changed(settings: Settings, changes: dict[str, Any]) -> Settings:
    """`settings` with `changes`, or a sentence that names the settings that exist."""
    names = [each.name for each in fields(Settings)]
    for name in changes:
        if name not in names:
            raise SettingError(f"There is no setting {name!r}. The settings are: {', '.join(names)}.")
    return replace(settings, **changes)


@cache
def knobs() -> tuple[Knob, ...]:
    """Every knob of `Settings`, in its order."""
    return tuple(Knob(each.name, each.default, **each.metadata) for each in fields(Settings))


def knob_of(name: str) -> Knob:
    """The knob of one setting.

    Raises:
        SettingError: There is no setting of that name; names those that exist.
    """
    by_name = {each.name: each for each in knobs()}
    if name not in by_name:
        raise SettingError(f"There is no setting {name!r}. The settings are: {', '.join(by_name)}.")
    return by_name[name]
