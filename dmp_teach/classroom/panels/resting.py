"""What a saved notebook shows in place of a panel: a sentence that says how to wake it."""

from pathlib import Path

RESTING_SCRIPT = Path(__file__).with_name("resting.js").read_text(encoding="utf-8")
