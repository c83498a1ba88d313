"""The lessons as a static site: JupyterLab and Python in the browser, from any static server.

`python3 -m dmp_teach site FOLDER` runs this in the launcher's environment. It fetches with pip and
npm, and keeps what it fetched.
"""

from __future__ import annotations

import hashlib
import json
import os
import shutil
import sys
from pathlib import Path
from typing import Any

from dmp_teach.errors import SetupError
from dmp_teach.launcher.lab import CONFIG, EXTENSIONS, FIRST_NOTEBOOK, NOTEBOOKS, PINS, ROOT, say
from dmp_teach.launcher.site_packages import PAGE, call, make_packages
from dmp_teach.texts import gettext as _

CACHE = ROOT / ".site"
TOOLS = PAGE / "tools.txt"
KERNEL = "@jupyterlite/pyodide-kernel-extension"
# Of JupyterLab's prebuilt extensions in this environment.
PANELS = ("@jupyter-widgets/jupyterlab-manager", "anywidget")
MARK = "dmp_teach.json"
# What JupyterLite brings, and no lesson reads.
UNSHOWN = ("*.eot", "*.map", "fa-*.svg", "fa-*.ttf", "fa-*.woff", "rspack.config*")
# The layout of some diagrams in Markdown, 1.5 MB that no lesson draws.
ELK = b"org.eclipse.elk"


def tell(folder: Path) -> int:
    """Make the site, say how to look at it, and return the exit code."""
    try:
        size = make_site(folder)
    except SetupError as error:
        sys.stderr.write(f"{error}\n")
        return 1
    say(f"The site is in {folder}, {size / 1e6:.0f} MB. To look at it, type")
    say(f"  python3 -m http.server -b 127.0.0.1 8000 -d {folder}")
    say("and open  http://127.0.0.1:8000")
    return 0


def make_site(folder: Path, cache: Path = CACHE) -> int:
    """Make the site in a folder that is new, empty or an older site, and return its size [bytes].

    Raises:
        SetupError: The folder holds something else, or a part could not be fetched or built.
    """
    check_folder(folder, MARK)
    say("Making the site (the first time about 2 minutes) ...")
    tools, lite = cache / "tools", cache / "lite"
    install_tools(tools, TOOLS)
    shutil.rmtree(lite, ignore_errors=True)
    shutil.copytree(NOTEBOOKS, lite / "files", ignore=lambda *_: {".ipynb_checkpoints"})
    extensions = collect_extensions(tools, lite / "labextensions")
    own = cache / "own"
    shutil.rmtree(own, ignore_errors=True)
    call([sys.executable, "-m", "hatchling", "build", "-t", "wheel", "-d", str(own)], cwd=ROOT)
    kernel = extensions / KERNEL / "static" / "pypi"
    (wheel,) = own.glob("*.whl")
    loaded = make_packages(cache, (PINS, TOOLS), kernel, wheel, lite / "static" / "pyodide")
    write_settings(lite, loaded)
    made = cache / "made"
    shutil.rmtree(made, ignore_errors=True)
    build(tools, lite, made)
    finish(made)
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(made, folder)
    return sum(path.stat().st_size for path in folder.rglob("*") if path.is_file())


def check_folder(folder: Path, mark: str) -> None:
    """Raise a SetupError unless a site, which has the file `mark`, may be made in a folder."""
    if folder.exists() and not (folder / mark).exists() and any(folder.iterdir()):
        raise SetupError(f"{folder} holds something else: name a new or an empty folder.")
    if not PINS.exists():
        raise SetupError("A site is made in a clone of dmp_teach; this copy is installed.")


def finish(made: Path) -> None:
    """Take out what no lesson reads, and let the front door lead to the first lesson."""
    for pattern in UNSHOWN:
        for path in made.rglob(pattern):
            path.unlink()
    for path in (made / "build").glob("*.js"):
        if ELK in path.read_bytes():
            path.unlink()
    # Browsers look for it here before they have read where it is.
    shutil.copy(made / "lab" / "favicon.ico", made)
    door = made / "index.html"
    first = f'<script>location.replace("lab/index.html?path={FIRST_NOTEBOOK}");</script>'
    door.write_text(door.read_text().replace("<head>", "<head>" + first, 1))
    page = made / "lab" / "index.html"
    words = {
        "ready": _("The robot is getting ready."),
        "time": _("The first time takes longest: half a minute."),
    }
    coming = (PAGE / "coming.html").read_text().format_map(words)
    page.write_text(page.read_text().replace("<noscript>", coming + "<noscript>", 1))
    (made / MARK).touch()


def install_tools(tools: Path, wanted: Path) -> None:
    """Install what a file pins beside this environment, whose packages it uses, if it changed."""
    stamp, pins = tools / "pins", wanted.read_text()
    if not stamp.exists() or stamp.read_text() != pins:
        shutil.rmtree(tools, ignore_errors=True)
        options = ["--no-deps", "--disable-pip-version-check", "--target", str(tools)]
        call([sys.executable, "-m", "pip", "install", "-q", *options, "-r", str(wanted)])
        stamp.write_text(pins)


def collect_extensions(tools: Path, folder: Path) -> Path:
    """Copy the extensions of JupyterLab that the lessons need, and return their folder."""
    shutil.copytree(EXTENSIONS, folder)
    installed = Path(sys.prefix) / "share" / "jupyter" / "labextensions"
    for name in PANELS:
        shutil.copytree(installed / name, folder / name)
    shutil.copytree(tools / "share" / "jupyter" / "labextensions" / KERNEL, folder / KERNEL)
    return folder


def write_settings(lite: Path, loaded: list[str]) -> None:
    """Write what JupyterLite reads: as the launcher's own settings, and where Python is."""
    config, overrides = (
        json.loads((CONFIG / "labconfig" / f"{name}.d" / "dmp_teach.json").read_text())
        for name in ("page_config", "default_setting_overrides")
    )
    kernel = {
        "disablePyPIFallback": True,
        "loadPyodideOptions": {
            # JSON's null is None, as in every other kernel.
            "convertNullToNone": True,
            "packages": loaded,
            "env": {
                "JUPYTER_WIDGETS_ECHO": "0",
                "PYTHONPATH": "/lib/python3.14/site-packages/pure.zip",
            },
        },
    }
    content: dict[str, Any] = {
        "appName": "dmp_teach",
        "disabledExtensions": [
            *config["disabledExtensions"],
            "@jupyterlite/application-extension:share-file",
        ],
        "litePluginSettings": {f"{KERNEL}:kernel": kernel},
        "dmpTeachSite": versions_of(NOTEBOOKS),
    }
    (lite / "lab").mkdir()
    for place, said in {"": content, "lab": {"mode": "single-document"}}.items():
        settings = {"jupyter-lite-schema-version": 0, "jupyter-config-data": said}
        (lite / place / "jupyter-lite.json").write_text(json.dumps(settings))
    (lite / "overrides.json").write_text(json.dumps(overrides))


def build(tools: Path, lite: Path, folder: Path) -> None:
    """Run JupyterLite's own build, of JupyterLab alone."""
    command = "from jupyterlite_core.app import main; main()"
    options = ["--apps", "lab", "--no-sourcemaps", "--no-unused-shared-packages"]
    options += ["--ignore-sys-prefix", "True"]
    options += [f"--FederatedExtensionAddon.extra_labextensions_path={lite / 'labextensions'}"]
    places = ["--lite-dir", str(lite), "--output-dir", str(folder), "--contents", "files"]
    call(
        [sys.executable, "-c", command, "build", *places, *options],
        cwd=lite,
        env=dict(os.environ, PYTHONPATH=str(tools)),
    )


def versions_of(folder: Path) -> dict[str, str]:
    """Return a digest of each lesson: the copy that a browser keeps belongs to one of them."""
    lessons = sorted(folder.glob("*.ipynb"))
    return {path.name: hashlib.sha256(path.read_bytes()).hexdigest()[:16] for path in lessons}


if __name__ == "__main__":
    sys.exit(tell(Path(sys.argv[1]).resolve()))
