"""The launcher: `python3 -m dmp_teach lab` opens the notebooks, `python3 -m dmp_teach test` runs every test.

The first start makes an environment of its own in `.venv` from `environment.txt`; later starts install nothing.
Nothing but the standard library is used here, and only words that Python 3.6 understands: whoever starts us with
an old Python gets a newer one that is installed beside it, or one sentence that says what to type.
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
    ROOT,
    WINDOWS,
    answer_signals,
    clean_environment,
    end_family,
    lab,
    say,
)

VENV = ROOT / ".venv"
PINS = ROOT / "environment.txt"
VERSIONS = (
    "3.11",
    "3.12",
    "3.13",
)  # in order of preference: pybullet has no wheels for newer than 3.11

# How pip and uv say that they reach nobody.
NO_NETWORK = (
    "ConnectionError",
    "NewConnection",
    "Timeout",
    "timed out",
    "Temporary failure",
    "ProxyError",
    "SSLError",
)
NO_NETWORK += ("Failed to fetch", "dns error", "error sending request", "Network is unreachable")


def main(arguments=None):
    """Read the command line and do what it says; returns the exit code."""
    parser = argparse.ArgumentParser(
        prog="python3 -m dmp_teach", description="Teach a robot to write."
    )
    commands = parser.add_subparsers(dest="command", metavar="lab | test")
    commands.required = True
    lab_parser = commands.add_parser("lab", help="open the notebooks in JupyterLab")
    lab_parser.add_argument("--no-browser", action="store_true", help="only say where it is")
    lab_parser.add_argument("--port", type=int, help="the port to use, instead of any free one")
    commands.add_parser(
        "test", help="run every test; whatever follows goes to pytest", add_help=False
    )
    options, rest = parser.parse_known_args(arguments)
    if rest and options.command == "lab":
        parser.error("lab does not know " + " ".join(rest))
    answer_signals(stop)
    try:
        python = prepare()
        if options.command == "test":
            return run_tests(python, rest)
        return lab(python, options.port, not options.no_browser)
    except SetupError as error:
        print(error, file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        say("Stopped.")
        return 130


def stop(number, frame):
    """Any signal that ends us ends us in order."""
    raise KeyboardInterrupt


def prepare():
    """The environment's Python; makes the environment first, if it is not there or the pins have changed."""
    python = VENV / ("Scripts/python.exe" if WINDOWS else "bin/python")
    stamp = VENV / "dmp_teach.stamp"
    if not PINS.exists():
        raise SetupError(
            "This copy of dmp_teach is installed, and the commands work in a clone. "
            "Type them there, or open your own notebooks with  jupyter lab  here."
        )
    pins = hashlib.sha256(PINS.read_bytes()).hexdigest()
    done = stamp.read_text() if stamp.exists() and python.exists() else None
    if done == pins:
        return str(python)
    say("Setting up in .venv (once, about 2 minutes and 1.5 GB) ...")
    began = time.time()
    if (
        done is None
    ):  # nothing yet, or an unfinished one: begin it anew, what was downloaded is kept elsewhere
        make_venv()
    else:
        stamp.unlink()
    install(str(python))
    place = subprocess.check_output(
        [str(python), "-c", "import sysconfig; print(sysconfig.get_path('purelib'))"]
    )
    place = Path(place.decode().strip())
    (place / "dmp_teach.pth").write_text(os.path.relpath(str(ROOT), str(place)) + "\n")
    stamp.write_text(pins)
    say(
        "Ready after {:.0f} seconds. The next start needs none of this.".format(time.time() - began)
    )
    return str(python)


def make_venv():
    """An empty environment, by uv where there is one, by the standard library otherwise."""
    python = find_python()
    if VENV.exists():
        shutil.rmtree(str(VENV))
    if shutil.which("uv"):
        command = ["uv", "venv", "--quiet", "--seed", "--python", python or VERSIONS[0], str(VENV)]
    elif python is None:
        raise SetupError(
            "Python {} is too old or too new: dmp_teach needs {}. Install one of them, or uv, which "
            "fetches it by itself (https://docs.astral.sh/uv), and type this again.".format(
                sys.version.split()[0], ", ".join(VERSIONS)
            )
        )
    elif subprocess.call([python, "-c", "import ensurepip, venv"], stderr=subprocess.DEVNULL) != 0:
        version = subprocess.check_output(
            [python, "-c", "import sys; print('%d.%d' % sys.version_info[:2])"]
        )
        raise SetupError(
            "This Python cannot make environments. Type  sudo apt install python{}-venv  and then this again.".format(
                version.decode().strip()
            )
        )
    else:
        command = [python, "-m", "venv", str(VENV)]
    if subprocess.call(command, env=installer_environment()) != 0:
        raise SetupError(
            "The environment .venv could not be made; the lines above say why. Is this computer online?"
        )


def find_python():
    """The first Python of `VERSIONS` that runs here, or None."""
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
    """Whether a command starts a Python of this version: a name on the PATH may be a shim with nothing behind it."""
    try:
        told = subprocess.check_output([*command, "--version"], stderr=subprocess.STDOUT)
    except (OSError, subprocess.CalledProcessError):
        return False
    return told.decode("utf-8", "replace").startswith("Python " + version + ".")


def install(python):
    """Install the pins, and say how far it is."""
    if shutil.which("uv"):
        command = ["uv", "pip", "install", "--python", python, "-r", str(PINS)]
    else:
        command = [
            python,
            "-m",
            "pip",
            "install",
            "--disable-pip-version-check",
            "--no-input",
            "-r",
            str(PINS),
        ]
    process = subprocess.Popen(
        command,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        universal_newlines=True,
        env=installer_environment(),
    )
    heard, collected, total = [], 0, PINS.read_text().count("==")
    try:
        for line in process.stdout:
            heard.append(line)
            if line.startswith("Collecting "):
                collected += 1
                if collected % 20 == 0:
                    say("  {} of about {} packages".format(collected, total))
            elif line.startswith(("Installing collected", "Resolved", "Prepared", "Installed")):
                say("  " + line.split(":")[0].strip())
    finally:
        if process.poll() is None and sys.exc_info()[0]:
            process.terminate()
    if process.wait() != 0:
        noise = (" + ", "  ", "Collecting", "Ignoring", "Requirement already", "WARNING: Retrying")
        told = "".join(
            line for line in heard[-30:] if not line.startswith(noise) or line.startswith("  cause")
        )
        raise SetupError(told + "\n" + advice("".join(heard)))


def advice(heard):
    """What to do about an installation that failed, from what the installer said."""
    if "No space left" in heard or "not enough space" in heard:
        return "The disk is full: make room for 2 GB and type the same command again."
    if any(word in heard for word in NO_NETWORK):
        return "The packages could not be fetched: is this computer online? Then type the same command again."
    return "A package could not be installed; the lines above say which. Type the same command again to go on."


def installer_environment():
    """Our surroundings for pip and uv; uv trusts what this computer trusts, as schools' networks often need."""
    trusted = (
        WINDOWS or sys.platform == "darwin" or Path("/etc/ssl/certs/ca-certificates.crt").exists()
    )
    return dict({"UV_SYSTEM_CERTS": "1"} if trusted else {}, **clean_environment())


def run_tests(python, arguments):
    """Run ruff, then pytest over tests and notebooks; with arguments, pytest alone and on those."""
    commands = [] if arguments else [["ruff", "check", "."], ["ruff", "format", "--check", "."]]
    codes = []
    for command in [*commands, ["pytest", *arguments]]:
        process = subprocess.Popen([python, "-m", *command], cwd=str(ROOT), env=clean_environment())
        try:
            codes.append(process.wait())
        except KeyboardInterrupt:
            try:
                process.wait(
                    timeout=10
                )  # pytest has heard the same Ctrl-C and is putting things away
            except subprocess.TimeoutExpired:
                end_family(python, process)
            raise
    return next((code for code in codes if code), 0)


if __name__ == "__main__":
    sys.exit(main())
