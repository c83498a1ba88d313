"""A letter as a few dozen bytes, small enough for a QR code (`views/stamp_code.py`).

The format, version 1: a byte with the version, one with a precision [um], then the strokes as a row
of bits, and a check sum of two bytes. Of each stroke first a bit, whether it is led to another
goal, and that goal; then what `STROKE_HEAD` lists, and its weights, one coordinate after the other.
A weight is rounded so that no point of the path moves by more than the precision: to steps that are
short where the path answers much to it. Weights change smoothly from kernel to kernel, so that only
the difference from the straight continuation of the last two is stored, as a Rice code, in which
small numbers take few bits (Rice 1979, Some practical universal noiseless coding techniques).
"""

from __future__ import annotations

import binascii
from dataclasses import dataclass, replace

import numpy as np

from dmp_teach.dmp import DMP, Responses, Settings
from dmp_teach.errors import LetterError, TeachError, kind_of
from dmp_teach.letters.letter import Letter
from dmp_teach.trajectory import Array

STAMP_VERSION = 1
MICROMETRE = 1e-6
# How far rounding one weight may move the path [um]: the first with which all of them together move
# it by no more than `TOLERANCE` [m].
PRECISIONS = range(24, 1, -2)
TOLERANCE = 5e-5
# Of each stroke: how many bits a number takes, and its unit. Begin and duration [s]; samples;
# steps of the spring a sample; kernels; start and goal [m]; start velocity [m/s].
STAMP_GOAL, STAMP_START = ("goal", 18, 1e-5), ("start", 18, 1e-5)
STAMP_CLOCK = ("begin", 17, 0.001), ("duration", 20, 1e-4), ("samples", 13, 1), ("stride", 8, 1)
STAMP_VELOCITY = ("velocity", 12, 0.001)
STAMP_ENDS = STAMP_START, STAMP_START, STAMP_GOAL, STAMP_GOAL, STAMP_VELOCITY, STAMP_VELOCITY
STROKE_HEAD = *STAMP_CLOCK, ("kernels", 8, 1), *STAMP_ENDS
SIGNED = ("start", "goal", "velocity")
RICE_BITS = 5
# Weights of a letter take 12 bits or so.
LONGEST_RICE = 40
# Times are even where none is off by more than this share of a step of the spring.
CLOCK_JITTER = 0.01


def letter_to_bytes(letter: Letter) -> bytes:
    """Return a letter in a few dozen bytes; its path moves by at most 0.05 mm.

    A stroke whose samples are not evenly spaced in time gets samples that are.

    Raises:
        LetterError: It is none, was not learned as `Settings.star()` learns, takes longer than
            100 s, has a stroke of more than 255 kernels, is farther than 1.3 m from the origin of
            its page, or cannot be stored so finely.
    """
    if not isinstance(letter, Letter):
        raise LetterError(f"A stamp holds a Letter, but got {kind_of(letter)}; Letter.learn it.")
    primitives = [_with_even_times(each) for each in letter.primitives]
    even = replace(letter, primitives=tuple(primitives))
    for precision in PRECISIONS:
        data = _packed(even, precision)
        written = zip(even.write(), letter_from_bytes(data).write(), strict=True)
        if max(np.abs(a.position - b.position).max() for a, b in written) <= TOLERANCE / 2**0.5:
            return data
    mm = 1000 * TOLERANCE
    raise LetterError(f"This letter cannot be stored within {mm:g} mm; learn it with more kernels.")


def _with_even_times(primitive: DMP) -> DMP:
    """Return a stroke with even samples: its own, or one for each step of its spring."""
    t = primitive.times
    stride, rest = divmod(primitive.steps, len(t) - 1)
    even = np.linspace(t[0], t[-1], len(t))
    if rest == 0 and np.abs(t - even).max() < CLOCK_JITTER * primitive.duration / stride / len(t):
        return primitive
    return replace(primitive, times=np.linspace(t[0], t[-1], primitive.steps + 1))


def _packed(letter: Letter, precision: int) -> bytes:
    """Return the bytes of a letter whose weights are rounded with a precision [um]."""
    begin = letter.primitives[0].times[0]
    bits = ""
    for n, primitive in enumerate(letter.primitives):
        bits += _led_bits(letter.led_to.get(n)) + _bits_of(primitive, begin, precision)
    # A 1 marks where the padding begins.
    bits = bits + "1" + "0" * (-len(bits) - 1 & 7)
    data = bytes([STAMP_VERSION, precision]) + int(bits, 2).to_bytes(len(bits) // 8, "big")
    return data + binascii.crc_hqx(data, 0).to_bytes(2, "big")


def letter_from_bytes(data: bytes) -> Letter:
    """Return the letter that `letter_to_bytes` wrote.

    Raises:
        LetterError: Another version, or bytes that are damaged.
    """
    if len(data) < 4 or binascii.crc_hqx(data[:-2], 0) != int.from_bytes(data[-2:], "big"):
        raise LetterError("This stamp is damaged, or was typed with a mistake; read it again.")
    if data[0] != STAMP_VERSION:
        raise LetterError(
            f"This stamp has version {data[0]}; this dmp_teach reads version {STAMP_VERSION}."
        )
    bits = "".join(f"{byte:08b}" for byte in data[2:-2]).rstrip("0")[:-1]
    try:
        return _read_letter(_Bits(bits), data[1])
    except (ArithmeticError, TeachError, ValueError):
        raise LetterError(
            "This stamp holds no letter: its numbers are none that we wrote."
        ) from None


def _read_letter(reader: _Bits, precision: int) -> Letter:
    """Return the letter of all bits."""
    primitives, led_to = list[DMP](), dict[int, Array]()
    while reader.place < len(reader.bits):
        if reader.take(1) == "1":
            led_to[len(primitives)] = np.array([reader.fixed(*STAMP_GOAL) for _ in range(2)])
        primitives.append(_read_primitive(reader, precision))
    if not primitives:
        raise LetterError("no stroke")
    strokes = tuple(p.rollout(goal=led_to.get(n)) for n, p in enumerate(primitives))
    return Letter(strokes, tuple(primitives), led_to)


def _plain_settings(kernels: int, duration: float, samples: int) -> Settings:
    """Return what a stamp takes for granted."""
    return Settings.star(n_kernels=kernels).resolved(duration, samples)


def _led_bits(goal: Array | None) -> str:
    """Return whether a stroke is led to another goal, and that goal."""
    return "0" if goal is None else "1" + "".join(_fixed(each, *STAMP_GOAL) for each in goal)


def _bits_of(primitive: DMP, begin: float, precision: int) -> str:
    """Return one stroke as bits, on a clock that begins with the letter."""
    settings, kernels, samples = primitive.settings, len(primitive.weights), len(primitive.times)
    plain = _plain_settings(kernels, primitive.duration, samples)
    # What a demonstration was prepared by plays no part in its path.
    same = replace(plain, smoothing=settings.smoothing, sharpen=settings.sharpen)
    if settings != same or primitive.biases is not None or len(primitive.goal) != 2:
        raise LetterError(
            "A stamp holds letters in 2-D that were learned as Settings.star() learns; learn it "
            "again: Letter.learn(letter.write())."
        )
    head = [primitive.times[0] - begin, primitive.duration, samples]
    head += [primitive.steps // (samples - 1), kernels]
    head += [*primitive.start, *primitive.goal, *primitive.start_velocity]
    bits = "".join(_fixed(value, *kind) for value, kind in zip(head, STROKE_HEAD, strict=True))
    numbers = _differences(primitive.weights, _steps_of(primitive, precision))
    return bits + "".join(map(_rice, numbers))


def _read_primitive(bits: _Bits, precision: int) -> DMP:
    """Return the next stroke."""
    begin, duration, samples, stride, kernels, *ends = (bits.fixed(*kind) for kind in STROKE_HEAD)
    kernels, steps = int(kernels), int(samples - 1) * int(stride)
    start, goal, velocity = np.reshape(ends, (3, 2))
    times = begin + np.linspace(0, duration, int(samples))
    empty = np.zeros((kernels, 2))
    settings = _plain_settings(kernels, duration, int(samples))
    blank = DMP(empty, None, start, goal, duration, settings, velocity, times, steps)
    numbers = np.array([bits.rice(kernels) for _ in range(2)])
    return replace(blank, weights=_sums(numbers, _steps_of(blank, precision)))


def _steps_of(primitive: DMP, precision: int) -> Array:
    """Return to what steps each weight is rounded, shape (N,): twice the precision on the path."""
    answer = np.abs(Responses(primitive).to_weights[:, :, 0]).max(axis=1)
    return 2 * MICROMETRE * precision / answer


def _differences(weights: Array, steps: Array) -> list[list[int]]:
    """Return the numbers that `_sums` makes weights of, for each coordinate."""
    numbers = []
    for column in weights.T:
        last, row = (0.0, 0.0), []
        for weight, step in zip(column, steps, strict=True):
            row.append(round((weight - (2 * last[0] - last[1])) / step))
            last = (2 * last[0] - last[1] + row[-1] * step, last[0])
        numbers.append(row)
    return numbers


def _sums(numbers: Array, steps: Array) -> Array:
    """Return weights (N, 2): each is the straight continuation of the last two, and a number."""
    weights = np.zeros((len(steps) + 2, 2))
    for n, step in enumerate(steps):
        weights[n + 2] = 2 * weights[n + 1] - weights[n] + numbers[:, n] * step
    return weights[2:]


def _fixed(value: float, name: str, width: int, unit: float) -> str:
    """Return a number as `width` bits, in its unit."""
    number = round(value / unit) + (name in SIGNED) * 2 ** (width - 1)
    if not 0 <= number < 2**width:
        raise LetterError(
            f"The {name} of a stroke is {value:g}: too much for a stamp. Write the letter "
            "smaller and quicker, or learn it with fewer kernels."
        )
    return f"{number:0{width}b}"


def _rice(row: list[int]) -> str:
    """Return whole numbers as a Rice code: how many low bits are plain, then the numbers."""
    folded = [2 * abs(each) - (each < 0) for each in row]
    if max(folded) >= 2**LONGEST_RICE:
        raise LetterError("The weights of this letter are too large for a stamp.")
    codes = []
    for k in range(min(max(folded).bit_length() + 1, 2**RICE_BITS)):
        low = [f"{each % 2**k:0{k}b}" if k else "" for each in folded]
        parts = ["1" * (each >> k) + "0" + bits for each, bits in zip(folded, low, strict=True)]
        codes.append(f"{k:0{RICE_BITS}b}" + "".join(parts))
    return min(codes, key=len)


@dataclass
class _Bits:
    """Bits that are read one number after the other."""

    bits: str
    place: int = 0

    def take(self, width: int) -> str:
        """Return the next bits."""
        self.place += width
        return self.bits[self.place - width : self.place]

    def fixed(self, name: str, width: int, unit: float) -> float:
        """Return a number that `_fixed` wrote."""
        return (int(self.take(width), 2) - (name in SIGNED) * 2 ** (width - 1)) * unit

    def rice(self, count: int) -> list[int]:
        """Return numbers that `_rice` wrote."""
        k = int(self.take(RICE_BITS), 2)
        return [self._unfold(k) for _ in range(count)]

    def _unfold(self, k: int) -> int:
        high = self.bits.index("0", self.place) - self.place
        self.place += high + 1
        folded = (high << k) + (int(self.take(k), 2) if k else 0)
        return -((folded + 1) // 2) if folded % 2 else folded // 2
