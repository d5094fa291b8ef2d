"""All touches are assigned to points together: the marginal likelihoods are those of Gaussians."""

from __future__ import annotations

import numpy as np
import pytest

from localize.diagnosis.fault_likelihood import across
from localize.diagnosis.touch_assignment import log_integral


def test_thelog_integral_is_the_integral_of_a_gaussian() -> None:
    random = np.random.default_rng(46)
    root = random.standard_normal((3, 5, 5))
    precision, linear = root @ root.transpose(0, 2, 1) + np.eye(5), random.standard_normal((3, 5))
    exact = [
        0.5 * b @ np.linalg.solve(p, b) - 0.5 * np.linalg.slogdet(p)[1] for p, b in zip(precision, linear, strict=True)
    ]
    assert log_integral(precision, linear) == pytest.approx(exact, rel=1e-9)


@pytest.mark.parametrize("microphones", [2, 3, 4])
def test_vectors_across_are_orthonormal(microphones: int) -> None:
    random = np.random.default_rng(microphones)
    h = random.standard_normal((4, microphones, 7, 2)) @ np.array([1, 1j])
    found = across(h).conj().transpose(0, 3, 1, 2)  # (n_point, n_freq, n_microphone - 1, n_microphone)
    unit = (h / np.sqrt((np.abs(h) ** 2).sum(1, keepdims=True))).transpose(0, 2, 1)
    whole = np.concatenate([unit[:, :, None], found], axis=2)
    product = whole.conj() @ whole.transpose(0, 1, 3, 2)
    assert np.allclose(product, np.eye(microphones), atol=1e-12)
