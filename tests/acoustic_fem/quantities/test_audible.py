"""Ratios of responses that underflow are 1, and all others are plain ratios."""

from __future__ import annotations

import numpy as np
import pytest

from acoustic_fem.quantities.audible import audible_ratio


@pytest.mark.filterwarnings("error")
def test_ratios_are_finite_where_nothing_arrives() -> None:
    values = np.array([2j, 1e-99, 1e-200, 0.0, 1.0])
    reference = np.array([1.0, 2e-99, 3e-250, 0.0, 0.0])
    assert audible_ratio(values, reference).tolist() == [2j, 0.5, 1.0, 1.0, 1.0]
    assert audible_ratio(np.ones((2, 3), complex), np.full(3, 4.0)).shape == (2, 3)
