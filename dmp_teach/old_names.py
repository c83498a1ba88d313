"""Names that changed stay for one version, with a warning that gives the new one."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Collection, Mapping


def serve_names(
    place: str, load: Callable[[str], object], names: Collection[str], renamed: Mapping[str, str]
) -> Callable[[str], object]:
    """Return a module's `__getattr__` that loads its names, and warns where one has a new name.

    Args:
        place: What people call the module, "dmp_teach.studies".
        load: Loads a name from where it stands.
        names: The names that the module offers.
        renamed: Old name: new name.
    """

    def find(name: str) -> object:
        if name in names:
            return load(name)
        if name not in renamed:
            known = ", ".join(sorted(names))
            raise AttributeError(f"{place} has no {name!r}; it has: {known}.")
        new = renamed[name]
        message = f"{place}.{name} is now called {place}.{new}."
        warnings.warn(message, DeprecationWarning, stacklevel=2)
        return load(new)

    return find
