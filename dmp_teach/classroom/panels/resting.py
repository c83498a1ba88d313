"""What a saved notebook shows in place of a panel: a sentence that says how to wake it."""

from pathlib import Path

from dmp_teach.files import join_modules

RESTING_SCRIPT = join_modules(Path(__file__).with_name("resting.js"))
