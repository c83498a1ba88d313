"""The stamp of a letter as a QR code that a camera reads, or as text that a hand can type.

As text it is `STAMP:` and base 32: letters and digits, which a QR code holds in 5.5 bits each.
"""

from __future__ import annotations

import base64
import os
from io import BytesIO
from pathlib import Path
from typing import Any

import numpy as np

from dmp_teach.errors import LetterError, MissingPartError
from dmp_teach.files import contents, write_whole
from dmp_teach.letters import Letter, letter_from_bytes, letter_to_bytes
from dmp_teach.trajectory import Array

STAMP_PREFIX = "STAMP:"


def write_stamp(letter: Letter, path: str | os.PathLike[str]) -> Path:
    """Write a letter as a QR code, to be printed, photographed and read by `read_stamp`.

    Args:
        letter: Learned as `Settings.star()` learns. A stroke takes 30 to 100 bytes.
        path: A name that ends with .svg.

    Raises:
        LetterError: As `letter_to_bytes`; or more than a QR code holds.
        PathError: A name with another end, or a place that cannot be written.
    """
    return write_whole(path, _code(letter).to_svg(scale=4).encode(), ".svg")


def stamp_squares(letter: Letter) -> Array:
    """Return the squares of the QR code of a letter, shape (N, N): 0 is black, 255 white.

    Raises:
        LetterError: As `write_stamp`.
    """
    return np.array(_code(letter).to_image())


def stamp_text(letter: Letter) -> str:
    """Return what the QR code of a letter says: `STAMP:`, capitals and digits."""
    return STAMP_PREFIX + base64.b32encode(letter_to_bytes(letter)).decode().rstrip("=")


def read_stamp(source: str | os.PathLike[str] | Array) -> Letter:
    """Read a letter from its stamp.

    Args:
        source: A picture: the name of a file (.png, .jpg), or an array, shape (H, W) or (H, W, 3)
            of bytes. Or the text that a telephone's camera shows, which begins with `STAMP:`.

    Raises:
        LetterError: No stamp is seen, or it is damaged.
    """
    if isinstance(source, str) and source.strip().upper().startswith(STAMP_PREFIX):
        return _letter_from_text(source)
    zxing = _zxing()
    picture = source if isinstance(source, np.ndarray) else _picture(source)
    try:
        found = [each.text for each in zxing.read_barcodes(picture)]
    except (TypeError, ValueError) as error:
        raise LetterError(f"This is no picture of bytes, (H, W) or (H, W, 3): {error}.") from None
    stamps = [text for text in found if text.startswith(STAMP_PREFIX)]
    if not stamps:
        seen = "another QR code" if found else "no QR code"
        raise LetterError(
            f"There is {seen} in this picture; take it from nearer, straight, without shadows."
        )
    return _letter_from_text(stamps[0])


def _letter_from_text(text: str) -> Letter:
    """Return the letter of a text that begins with the prefix."""
    body = "".join(text.upper().split()).removeprefix(STAMP_PREFIX)
    try:
        data = base64.b32decode(body + "=" * (-len(body) % 8))
    except ValueError:
        raise LetterError(
            f"After {STAMP_PREFIX} a stamp has only the letters A to Z and the digits 2 to 7."
        ) from None
    return letter_from_bytes(data)


# Any, here and below: a library without types, and its picture.
def _zxing() -> Any:
    """Return the library that draws and reads QR codes."""
    try:
        import zxingcpp  # noqa: PLC0415 (nothing else needs it)
    except ImportError:
        words = "QR codes need zxing-cpp: pip install zxing-cpp. The text of a stamp needs nothing."
        raise MissingPartError(words) from None
    return zxingcpp


def _code(letter: Letter) -> Any:
    """Return the QR code of a letter."""
    zxing, text = _zxing(), stamp_text(letter)
    try:
        return zxing.create_barcode(text, zxing.BarcodeFormat.QRCode, ec_level="M")
    except ValueError as error:
        raise LetterError(f"This letter is too long for a QR code: {error}.") from None


def _picture(path: str | os.PathLike[str]) -> Array:
    """Return a picture file as grey bytes (H, W)."""
    from PIL import Image  # noqa: PLC0415 (nothing else of the room needs it)

    data, name = contents(path)
    try:
        return np.asarray(Image.open(BytesIO(data)).convert("L"))
    except (OSError, ValueError, Image.DecompressionBombError) as error:
        raise LetterError(f"{name}: this is no picture (.png, .jpg): {error}.") from None
