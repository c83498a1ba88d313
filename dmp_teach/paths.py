"""Where the files that come with the project are."""

from pathlib import Path

ASSETS = Path(__file__).resolve().parent.parent / "assets"
