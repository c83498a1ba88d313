"""Recordings as plain JSON of ours, as the pad and the alphabets have them."""

from __future__ import annotations

from dmp_teach.formats.registry import CaptureOptions, Format
from dmp_teach.ink import Recording, recording_from_json, recording_to_json


def begins_like_json(data: bytes) -> bool:
    """Tell whether a file begins with a brace or a bracket."""
    return data[:1000].removeprefix(b"\xef\xbb\xbf").lstrip().startswith((b"{", b"["))


def _is_ours(data: bytes) -> bool:
    """Tell whether a file is JSON that speaks of this package."""
    return begins_like_json(data) and b'"dmp_teach' in data


def _read_one(data: bytes, _name: str, _: CaptureOptions) -> tuple[Recording, ...]:
    """Read the letter of a file."""
    return (recording_from_json(data),)


FORMAT = Format("JSON", (".json",), _is_ours, _read_one, recording_to_json)
