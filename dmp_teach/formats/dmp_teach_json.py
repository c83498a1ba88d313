"""Recordings as plain JSON of ours, as the pad and the alphabets have them."""

from __future__ import annotations

from dmp_teach.formats.registry import CaptureOptions, Format
from dmp_teach.ink import Recording, recording_from_json, recording_to_json


def _is_ours(data: bytes) -> bool:
    """Tell whether a file is JSON that speaks of this package."""
    begin = data[:1000].removeprefix(b"\xef\xbb\xbf").lstrip()
    return begin.startswith((b"{", b"[")) and b'"dmp_teach' in data


def _read_one(data: bytes, _name: str, _: CaptureOptions) -> tuple[Recording, ...]:
    """Read the letter of a file."""
    return (recording_from_json(data),)


FORMAT = Format("dmp_teach's JSON", (".json",), _is_ours, _read_one, recording_to_json)
