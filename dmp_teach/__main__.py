"""The launcher: `python3 -m dmp_teach lab` opens the notebooks, `... test` runs every test.

In a clone the first start makes an environment in `.venv` from `environment.txt`; later starts
install nothing; an installed copy runs where it is installed. Standard library only, in the syntax
of Python 3.6: started with an old Python, it finds a newer one beside it, or prints one sentence
that says what to type.
"""

import argparse
import hashlib
import os
import shutil
import subprocess
import sys
import time
from pathlib import Path

from dmp_teach.errors import SetupError
from dmp_teach.launcher.lab import (
    PINS,
    ROOT,
    WINDOWS,
    WORK,
    answer_signals,
    clean_environment,
    end_family,
    lab,
    run_site,
    say,
)

VENV = ROOT / ".venv"
# In order of preference: pybullet has no wheels for newer than 3.11.
VERSIONS = ("3.11", "3.12", "3.13")

# What pip and uv print when they are offline.
NO_NETWORK = (
    "ConnectionError",
    "NewConnection",
    "Timeout",
    "timed out",
    "Temporary failure",
    "ProxyError",
    "SSLError",
    "Failed to fetch",
    "dns error",
    "error sending request",
    "Network is unreachable",
)
LINTERS = [["ruff", "check", "."], ["ruff", "format", "--check", "."]]
# Processes on all cores, at most eight, for each may need 1 GB; the slowest files first.
PARALLEL = ["-n", "logical", "--maxprocesses", "8", "--dist", "loadfile", "--no-loadscope-reorder"]


def main(arguments=None):
    """Run the command line and return the exit code."""
    parser = argparse.ArgumentParser("python3 -m dmp_teach", description="Teach a robot to write.")
    commands = parser.add_subparsers(dest="command", metavar="lab | site | docs | test")
    commands.required = True
    lab_parser = commands.add_parser("lab", help="open the notebooks in JupyterLab")
    lab_parser.add_argument("--no-browser", action="store_true", help="only say where it is")
    lab_parser.add_argument("--port", type=int, help="the port to use, instead of any free one")
    lab_parser.add_argument("--work", type=Path, default=WORK, help="the folder of your copies")
    lab_parser.add_argument(
        "--fresh",
        nargs="*",
        metavar="LESSON",
        help="begin lessons anew, such as 03, or all; what you changed is moved to work/earlier",
    )
    lab_parser.add_argument("--full", action="store_true", help="show all of JupyterLab")
    site_parser = commands.add_parser("site", help="make the lessons a site for any web server")
    site_parser.add_argument("folder", type=Path, help="a new or an empty one, or an older site")
    docs_parser = commands.add_parser("docs", help="make the docs a site: lessons, API, gallery")
    docs_parser.add_argument("folder", type=Path, help="a new or an empty one, or older docs")
    commands.add_parser(
        "test",
        help="run every test; --quick: in a minute; whatever else follows goes to pytest",
        add_help=False,
    )
    options, rest = parser.parse_known_args(arguments)
    if rest and options.command != "test":
        parser.error("{} does not know {}".format(options.command, " ".join(rest)))
    answer_signals(stop)
    try:
        python = prepare()
        if options.command == "test":
            return run_tests(python, rest)
        if options.command == "site":
            return run_site(python, options.folder)
        if options.command == "docs":
            return run_site(python, options.folder, of="docs_site")
        fresh = () if options.fresh is None else options.fresh or ("",)
        kept = {"work": options.work.resolve(), "fresh": fresh, "full": options.full}
        return lab(python, options.port, not options.no_browser, **kept)
    except SetupError as error:
        print(error, file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        say("Stopped.")
        return 130


def stop(number, frame):
    """Turn any signal that ends us into the exception of Ctrl-C."""
    raise KeyboardInterrupt


def prepare():
    """Return the environment's Python; make or update the environment where the pins ask for it.

    An installed copy runs where pip has put it, with what it depends on.
    """
    if not PINS.exists():
        return sys.executable
    python = VENV / ("Scripts/python.exe" if WINDOWS else "bin/python")
    stamp = VENV / "dmp_teach.stamp"
    pins = hashlib.sha256(PINS.read_bytes()).hexdigest()
    done = stamp.read_text() if stamp.exists() and python.exists() else None
    if done == pins:
        return str(python)
    say("Setting up in .venv (once, about 2 minutes and 1.5 GB) ...")
    began = time.monotonic()
    if done is None:
        # There is none, or an unfinished one. What was downloaded is kept in the installer's cache.
        make_venv()
    else:
        stamp.unlink()
    install(str(python))
    ask = "import sysconfig; print(sysconfig.get_path('purelib'))"
    place = Path(subprocess.check_output([str(python), "-c", ask]).decode().strip())
    (place / "dmp_teach.pth").write_text(os.path.relpath(str(ROOT), str(place)) + "\n")
    stamp.write_text(pins)
    say("Ready after {:.0f} s.".format(time.monotonic() - began))
    return str(python)


def make_venv():
    """Make an empty environment, by uv where it is installed, else by the standard library."""
    python = find_python()
    if VENV.exists():
        shutil.rmtree(str(VENV))
    if shutil.which("uv"):
        command = ["uv", "venv", "--quiet", "--seed", "--python", python or VERSIONS[0], str(VENV)]
    elif python is None:
        raise SetupError(
            "Python {} is too old or too new: dmp_teach needs {}. Install one of them, or uv, "
            "which fetches it by itself (https://docs.astral.sh/uv), and type this again.".format(
                sys.version.split()[0], ", ".join(VERSIONS)
            )
        )
    elif subprocess.call([python, "-c", "import ensurepip, venv"], stderr=subprocess.DEVNULL) != 0:
        version = subprocess.check_output(
            [python, "-c", "import sys; print('%d.%d' % sys.version_info[:2])"]
        )
        raise SetupError(
            "This Python cannot make environments. Type  sudo apt install python{}-venv  "
            "and then this again.".format(version.decode().strip())
        )
    else:
        command = [python, "-m", "venv", str(VENV)]
    if subprocess.call(command, env=installer_environment()) != 0:
        raise SetupError(
            "The environment .venv could not be made; the lines above say why. "
            "Is this computer online?"
        )


def find_python():
    """Return the first Python of `VERSIONS` that runs here, or None."""
    own = getattr(sys, "_base_executable", None) or sys.executable
    for version in VERSIONS:
        if version == "%d.%d" % sys.version_info[:2]:
            return own
        found = shutil.which("python" + version)
        if found and answers([found], version):
            return found
        if WINDOWS and answers(["py", "-" + version], version):
            path = subprocess.check_output(
                ["py", "-" + version, "-c", "import sys; print(sys.executable)"]
            )
            return path.decode().strip()
    return None


def answers(command, version):
    """Return whether a command starts a Python of this version; it may be an empty shim."""
    try:
        output = subprocess.check_output([*command, "--version"], stderr=subprocess.STDOUT)
    except (OSError, subprocess.CalledProcessError):
        return False
    return output.decode("utf-8", "replace").startswith("Python " + version + ".")


def install(python):
    """Install the pins and show the progress."""
    if shutil.which("uv"):
        command = ["uv", "pip", "install", "--python", python]
    else:
        command = [python, "-m", "pip", "install", "--disable-pip-version-check", "--no-input"]
    process = subprocess.Popen(
        [*command, "-r", str(PINS)],
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        universal_newlines=True,
        env=installer_environment(),
    )
    try:
        output = show_progress(process.stdout or [])
    finally:
        if process.poll() is None and sys.exc_info()[0]:
            process.terminate()
        if process.stdout:
            process.stdout.close()
    if process.wait() != 0:
        noise = (" + ", "  ", "Collecting", "Ignoring", "Requirement already", "WARNING: Retrying")
        shown = [
            line
            for line in output[-30:]
            if not line.startswith(noise) or line.startswith("  cause")
        ]
        raise SetupError("".join(shown) + "\n" + advice("".join(output)))


def show_progress(lines):
    """Print how far the installer is, and return its lines."""
    output = []
    collected = 0
    total = PINS.read_text().count("==")
    for line in lines:
        output.append(line)
        if line.startswith("Collecting "):
            collected += 1
            if collected % 20 == 0:
                say("  {} of about {} packages".format(collected, total))
        elif line.startswith(("Installing collected", "Resolved", "Prepared", "Installed")):
            say("  " + line.split(":")[0].strip())
    return output


def advice(output):
    """Return what to do about an installation that failed, from the installer's output."""
    if "No space left" in output or "not enough space" in output:
        return "The disk is full: make room for 2 GB and type the same command again."
    if any(word in output for word in NO_NETWORK):
        return (
            "The packages could not be fetched: is this computer online? "
            "Then type the same command again."
        )
    return (
        "A package could not be installed; the lines above say which. "
        "Type the same command again to go on."
    )


def installer_environment():
    """Return the environment variables for pip and uv.

    uv trusts the certificates of this computer, as schools' networks often need.
    """
    trusted = (
        WINDOWS or sys.platform == "darwin" or Path("/etc/ssl/certs/ca-certificates.crt").exists()
    )
    return dict({"UV_SYSTEM_CERTS": "1"} if trusted else {}, **clean_environment())


def check_commands(arguments):
    """Return what `test` runs: linters, and every test; what follows `test`, by pytest."""
    rest = [word for word in arguments if word != "--quick"]
    quick = ["-m", "quick"] if len(rest) < len(arguments) else []
    if rest:
        return [["pytest", *quick, *rest]]
    if quick:
        return [*LINTERS, ["pytest", *quick, "tests"]]
    return [*LINTERS, ["pytest", *PARALLEL]]


def run_tests(python, arguments):
    """Run each command of the tests and return the first exit code that is not 0, or 0."""
    if not PINS.exists():
        raise SetupError("The tests are in a clone of dmp_teach, not in an installed copy.")
    codes = []
    for command in check_commands(arguments):
        process = subprocess.Popen([python, "-m", *command], cwd=str(ROOT), env=clean_environment())
        try:
            codes.append(process.wait())
        except KeyboardInterrupt:
            try:
                # pytest was interrupted by the same Ctrl-C and is tidying up.
                process.wait(timeout=10)
            except subprocess.TimeoutExpired:
                end_family(python, process)
            raise
    return next((code for code in codes if code), 0)


if __name__ == "__main__":
    sys.exit(main())
