import pytest

from tests.views.moves import sway


@pytest.fixture(scope="session")
def motion():
    return sway()
