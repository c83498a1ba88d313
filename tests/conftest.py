"""Under CI=true nothing may be left out: a skipped test fails there, unless it is recordings that are absent."""

import os

import pytest

STRICT = os.environ.get("CI", "").lower() == "true"


def hold_to_it(report):
    """Turn a skip into a failure, where continuous integration promises that everything was tried."""
    reason = report.longrepr[2] if isinstance(report.longrepr, tuple) else str(report.longrepr)
    if (
        STRICT
        and report.skipped
        and not hasattr(report, "wasxfail")
        and "no recordings here" not in reason
    ):
        report.outcome, report.longrepr = (
            "failed",
            f"Nothing may be skipped under CI=true, but this was: {reason}",
        )
    return report


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport():
    return hold_to_it((yield))


@pytest.hookimpl(wrapper=True)
def pytest_make_collect_report():
    return hold_to_it((yield))
