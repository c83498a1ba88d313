"""Tiers of tests (CONTRIBUTING.md), and nothing left out under CI=true but absent recordings."""

import os

import hypothesis
import pytest

# So that a failing law says which letters fail.
pytest.register_assert_rewrite("tests.laws")

# As in a notebook that our launcher serves: pictures of ink are drawn below cells.
os.environ["DMP_TEACH_PICTURES_STAY_OUT"] = "1"
STRICT = os.environ.get("CI", "").lower() == "true"
FEW = 5
NOT_QUICK = {"benchmarks", "browser", "classroom", "launcher"}
NOT_QUICK |= {"notebooks", "pyodide", "robot", "studies", "views"}
LONGEST_FIRST = ["browser", "pyodide", "test_wheel", "studies", "robot"]
LONGEST_FIRST += ["lessons", "notebooks", "launcher", "classroom", "views"]


class FewExamples(hypothesis.settings):
    """Settings of a law that are content with few examples, whatever the law says."""

    def __init__(self, *arguments, max_examples=FEW, **more):
        super().__init__(*arguments, max_examples=min(max_examples, FEW), **more)


def is_quick(config):
    """Whether only the quick tier is run: `pytest -m quick`."""
    return config.getoption("markexpr") == "quick"


def pytest_configure(config):
    """Name the marks of the quick tier, and try laws on few examples in it."""
    config.addinivalue_line("markers", "quick: takes no time; run with -m quick")
    config.addinivalue_line("markers", "slow: not in the quick tier")
    # How long an example takes says little while all cores are busy.
    patient = {"deadline": None, "suppress_health_check": [hypothesis.HealthCheck.too_slow]}
    hypothesis.settings.register_profile("patient", **patient)
    hypothesis.settings.load_profile("patient")
    if is_quick(config):
        hypothesis.settings = FewExamples


def pytest_ignore_collect(collection_path, config):
    """Do not even import what the quick tier leaves out."""
    return True if is_quick(config) and collection_path.name in NOT_QUICK else None


def pytest_itemcollected(item):
    """Mark as quick what is not marked as slow or thorough."""
    if not item.get_closest_marker("slow") and not item.get_closest_marker("thorough"):
        item.add_marker("quick")


def pytest_collection_modifyitems(config, items):
    """Let several processes begin with what takes longest, and end together with short files."""
    if hasattr(config, "workerinput"):
        places = {name: place for place, name in enumerate(LONGEST_FIRST)}
        last = len(places)
        items.sort(
            key=lambda item: min(
                places.get(name, last) for name in (item.path.parent.name, item.path.stem)
            )
        )


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config, log):
    """Give a process whole files, and one all of the browser, so that one JupyterLab serves it."""
    from xdist.scheduler import LoadFileScheduling  # noqa: PLC0415 (only where xdist is loaded)

    class ByFile(LoadFileScheduling):
        def _split_scope(self, nodeid):
            browser = nodeid.startswith("tests/browser/")
            return "tests/browser" if browser else super()._split_scope(nodeid)

    return ByFile(config, log)


def hold_to_it(report):
    """Turn a skip into a failure, where continuous integration promises that all was tried."""
    reason = report.longrepr[2] if isinstance(report.longrepr, tuple) else str(report.longrepr)
    excused = hasattr(report, "wasxfail") or "no recordings here" in reason
    if STRICT and report.skipped and not excused:
        report.outcome = "failed"
        report.longrepr = f"Nothing may be skipped under CI=true, but this was: {reason}"
    return report


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport():
    return hold_to_it((yield))


@pytest.hookimpl(wrapper=True)
def pytest_make_collect_report():
    return hold_to_it((yield))
