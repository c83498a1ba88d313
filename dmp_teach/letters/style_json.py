"""A style as JSON: its letters as `letter_json` has them, and its arrays; no names of people."""

from __future__ import annotations

from typing import Any

from dmp_teach.files import array_from_json, must, pseudonyms
from dmp_teach.letters.letter import Letter
from dmp_teach.letters.letter_json import letter_parts, letter_to_json
from dmp_teach.letters.styles_basis import letter_to_row


# Any: a Style, whose module imports this one; and what JSON holds, here and below.
def style_to_json(style: Any) -> dict[str, Any]:
    """Return a `Style`."""
    names = pseudonyms(style.writers)
    content = {name: getattr(style, name).tolist() for name in _shapes(style.letters, 0)}
    content["letters"] = list(map(letter_to_json, style.letters))
    return content | {"writers": [names[each] for each in style.writers]}


def style_parts(content: dict[str, Any]) -> dict[str, Any]:
    """Return the arguments of `Style`; any error says that this is none."""
    letters = tuple(Letter(**letter_parts(each)) for each in content["letters"])
    writers, known = tuple(content["writers"]), pseudonyms(content["writers"])
    is_each = len(known) == len(letters) == len(writers) and set(known.values()) == set(writers)
    must(is_each, "writers", writers, "a pseudonym for each letter")
    shapes = _shapes(letters, len(content["spread"]))
    arrays = {name: array_from_json(name, content[name], shapes[name]) for name in shapes}
    return {"letters": letters, "writers": writers, **arrays}


def _shapes(letters: tuple[Letter, ...], K: int) -> dict[str, tuple[int, ...]]:
    """Return the shapes of the arrays of a style with K principal styles."""
    W, P = len(letters), len(letter_to_row(letters[0]))
    shapes: dict[str, tuple[int, ...]] = {"mean_row": (P,), "ways": (K, P), "coordinates": (W, K)}
    return shapes | {"spread": (K,), "centre": (K,), "covariance": (K, K)}
