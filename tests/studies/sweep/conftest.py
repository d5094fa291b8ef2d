"""The study that tests of sweeps share."""

import pytest
from bores_study import TEXT

from studies.study.study import Study, read_study


@pytest.fixture(scope="module")
def study() -> Study:
    return read_study(TEXT)
