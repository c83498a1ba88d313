"""What the static site has for piplite, which would install packages from a network.

The kernel imports this module first. It lets the large wheels wait on the server until something
of them is used: a panel needs no SciPy. They are fetched at that moment, which a worker may do.
"""

from __future__ import annotations

import importlib
import io
import json
import site
import sys
import zipfile
from collections.abc import Sequence
from importlib.abc import Loader
from importlib.machinery import ModuleSpec, PathFinder
from pathlib import Path
from types import ModuleType

import js
import pyodide_js

# The kernel sets them.
_PIPLITE_DISABLE_PYPI = True
_PIPLITE_URLS: list[str] = []

PACKAGES = Path(site.getsitepackages()[0])
# Module -> the wheel that is still on the server.
LATE: dict[str, str] = json.loads((PACKAGES / "late_wheels.json").read_text())


async def install(*requirements: object, **options: object) -> None:
    """Say that this page installs nothing."""
    raise OSError("This page holds the packages of the lessons, and installs no others.")


class LateModule(ModuleType):
    """A package that is fetched when one of its attributes is asked for."""

    def __getattr__(self, name: str) -> object:
        """Become the package itself; what Python asks of every module wakes none."""
        if name.startswith("__") and name != "__version__":
            raise AttributeError(name)
        wake(self)
        return getattr(self, name)


class LateWheels(Loader):
    """Finds the modules of wheels that are still on the server."""

    def find_spec(
        self, name: str, path: Sequence[str] | None = None, target: ModuleType | None = None
    ) -> ModuleSpec | None:
        """Return where a module is; for one within a package the package is fetched first."""
        package = name.partition(".")[0]
        if package not in LATE:
            return None
        if name != package:
            wake(sys.modules[package])
            return PathFinder.find_spec(name, path)
        spec = ModuleSpec(name, self, is_package=True)
        spec.submodule_search_locations = [str(PACKAGES / name)]
        return spec

    def create_module(self, spec: ModuleSpec) -> ModuleType:
        """Return a package that waits."""
        return LateModule(spec.name)

    def exec_module(self, module: ModuleType) -> None:
        """Do nothing yet."""


def wake(module: ModuleType) -> None:
    """Fetch and unpack a package's wheel, unless another has brought it, and run the package."""
    name = module.__name__
    wheel = LATE.pop(name)
    module.__class__ = ModuleType
    if not (PACKAGES / name).exists():
        with zipfile.ZipFile(io.BytesIO(fetch(wheel))) as packed:
            packed.extractall(PACKAGES)
        importlib.invalidate_caches()
    spec = PathFinder.find_spec(name)
    if spec is None or spec.loader is None:
        raise ImportError(f"{wheel} holds no {name}.", name=name)
    module.__spec__, module.__loader__, module.__file__ = spec, spec.loader, spec.origin
    spec.loader.exec_module(module)


def fetch(file: str) -> bytes:
    """Return the bytes of a file beside Pyodide's own."""
    request = js.XMLHttpRequest.new()
    request.open("GET", pyodide_js._api.config.indexURL + file, False)
    request.responseType = "arraybuffer"
    request.send()
    if request.status != 200:
        raise OSError(f"The server answered {request.status} for {file}.")
    return request.response.to_bytes()


# Last on the path: before, every import would ask the page's storage for a file.
sys.path.append("")
sys.meta_path.append(LateWheels())
