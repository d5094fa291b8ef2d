"""One studio and one browser for all tests of the page."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest
from browser import Studio, chromium, opened, studio


@pytest.fixture(scope="package")
def browser() -> Iterator[Any]:
    """The Chromium of the system."""
    with chromium() as found:
        yield found


@pytest.fixture(scope="package")
def running(browser: Any, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Studio]:
    """A studio of array-2x6, with studies of its own."""
    with studio(ACOUSTIC_FEM_CACHE=str(tmp_path_factory.mktemp("cache"))) as found:
        yield found


@pytest.fixture
def page(browser: Any, running: Studio) -> Iterator[Any]:
    """A new page, which must end without errors and without having asked anybody else."""
    context = browser.new_context(viewport={"width": 1440, "height": 900})
    found = opened(context, running)
    yield found
    assert found.problems == []
    context.close()
