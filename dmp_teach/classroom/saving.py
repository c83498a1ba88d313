"""The old home of `without_ink`, which a hub's settings may name, for one version."""

from __future__ import annotations

import warnings
from typing import Any

from dmp_teach.launcher import notebook_privacy


def without_ink(model: dict[str, Any], **rest: Any) -> None:
    """Remove ink as `notebook_privacy.without_ink` does, with a warning."""
    words = "dmp_teach.classroom.saving is now called dmp_teach.launcher.notebook_privacy."
    warnings.warn(words, DeprecationWarning, stacklevel=2)
    notebook_privacy.without_ink(model, **rest)
