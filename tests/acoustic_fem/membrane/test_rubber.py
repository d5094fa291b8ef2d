"""The law of silicone over frequency: causal, passive, and one for NumPy and torch."""

from __future__ import annotations

import numpy as np
import pytest
import torch
from hypothesis import given, strategies as st
from scipy.special import gamma

from acoustic_fem.membrane.design_discs import design_compliance
from acoustic_fem.membrane.disc import DiscOptions, solve_disc
from acoustic_fem.membrane.rubber import ELASTIC, Rubber, causal_slope, modulus_ratio
from geometry import prototype
from geometry.schema.materials import STATIC_FREQUENCY, Material

GRID = np.geomspace(0.01, 1000.0, 31)
PRONY = Rubber(strengths=(0.05, 0.1, 0.08), times=(0.3, 0.02, 1e-3))
SPRING_POT = Rubber.spring_pot(0.1, 10.0)


def causal_imaginary_part(law: Rubber, frequency: np.ndarray) -> np.ndarray:
    """Loss modulus that Kramers and Kronig ask of the storage modulus: 2 w / pi of the integral of E' / (w^2 - s^2).

    With s = w e^x it is (1 / pi) of the integral of (E'(w) - E'(w e^x)) / sinh x, where E'(w) adds nothing; here over
    e^-30 to e^30, in steps of x that never meet 0, and with the mean of both sides, which converges faster.
    """
    step = 30 / 4000
    x = (np.arange(4000) + 0.5) * step
    above, below = (law.ratio(frequency[:, None] * np.exp(sign * x)).real for sign in (1, -1))
    return ((above - below) / np.sinh(x)).sum(1) * step / np.pi


@pytest.mark.parametrize("law", [SPRING_POT, Rubber.spring_pot(0.3, 0.1), PRONY])
def test_storage_and_loss_modulus_are_those_of_one_causal_material(law: Rubber) -> None:
    np.testing.assert_allclose(causal_imaginary_part(law, GRID), law.ratio(GRID).imag, rtol=2e-4)


def test_a_constant_loss_factor_belongs_to_no_causal_material() -> None:
    """Its storage modulus asks for no loss at all."""
    constant = Rubber(0.1)
    assert np.abs(causal_imaginary_part(constant, GRID)).max() < 1e-12
    np.testing.assert_allclose(constant.ratio(GRID), 1 + 0.1j, rtol=1e-15)


@pytest.mark.parametrize("time", [0.01, 1.0, 10.0])
def test_a_spring_pot_that_is_held_relaxes_as_a_power_of_time(time: float) -> None:
    """Stress per sudden strain, from the storage modulus alone: (2 / pi) of the integral of E'(w) sin(w t) / w."""
    slope = float(causal_slope(0.1))
    expected = np.sqrt(1 + 0.1**2) * (2 * np.pi * 10.0 * time) ** -slope / gamma(1 - slope)
    # w t = y: the integral of y^(slope - 1) sin y is Gamma(slope) sin(pi slope / 2)
    found = 2 / np.pi * SPRING_POT.ratio(1 / (2 * np.pi * time)).real * gamma(slope) * np.sin(np.pi * slope / 2)
    assert found == pytest.approx(expected, rel=1e-12)


def test_a_hardness_read_after_one_to_three_seconds_is_the_modulus_at_a_tenth_of_a_hertz() -> None:
    law = Rubber.spring_pot(0.1, STATIC_FREQUENCY)
    slope = law.slope
    read = np.sqrt(1 + 0.1**2) * (2 * np.pi * STATIC_FREQUENCY * np.array([1.0, 3.0])) ** -slope / gamma(1 - slope)
    assert read[0] == pytest.approx(1, abs=0.01)
    assert read[1] == pytest.approx(1, abs=0.08)


def test_a_loss_of_a_tenth_stiffens_by_a_third_from_1_to_100_hz() -> None:
    one, hundred = SPRING_POT.ratio([1.0, 100.0])
    assert hundred.real / one.real == pytest.approx(1.34, abs=0.005)
    assert SPRING_POT.ratio(10.0) == pytest.approx(1 + 0.1j, rel=1e-14)


@given(st.floats(0, 1), st.floats(1e-3, 1e3), st.floats(1e-3, 2e3))
def test_the_loss_factor_is_the_stated_one_at_all_frequencies(loss: float, reference: float, frequency: float) -> None:
    ratio = Rubber.spring_pot(loss, reference).ratio(frequency)
    assert ratio.real > 0
    assert ratio.imag == pytest.approx(loss * ratio.real, rel=1e-12, abs=1e-300)


def test_materials_state_their_law() -> None:
    common = {"poisson_ratio": 0.49, "density": 1070.0, "source": "a test"}
    stated = Material(youngs_modulus=2.0, loss_factor=0.1, modulus_frequency=10.0, **common)
    assert Rubber.of(stated) == SPRING_POT
    assert Rubber.of(Material(youngs_modulus=2.0, loss_factor=0.1, law="constant", **common)) == Rubber(0.1)
    table = Material(
        youngs_modulus=2.0,
        law="prony",
        relaxation_times=(0.3, 0.02, 1e-3),
        relaxation_moduli=(0.1, 0.2, 0.16),
        **common,
    )
    np.testing.assert_allclose(Rubber.of(table).ratio(GRID), PRONY.ratio(GRID), rtol=1e-15)
    assert ELASTIC.elastic
    assert Rubber.of(Material(youngs_modulus=2.0, loss_factor=0.0, **common)).elastic
    assert not PRONY.elastic
    assert not SPRING_POT.elastic


def test_torch_computes_the_same_modulus_and_its_derivatives() -> None:
    def ratio(*values: torch.Tensor) -> torch.Tensor:
        frequency, loss, reference, strength, time = values
        return modulus_ratio(frequency, loss, causal_slope(loss), reference, strength, time)

    numbers = [torch.tensor(v, dtype=torch.float64, requires_grad=True)
               for v in ([1.0, 30.0], 0.1, 0.1, [0.05, 0.2], [0.3, 0.01])]  # fmt: skip
    plain = modulus_ratio(
        np.array([1.0, 30.0]), 0.1, causal_slope(0.1), 0.1, np.array([0.05, 0.2]), np.array([0.3, 0.01])
    )
    np.testing.assert_allclose(ratio(*numbers).detach().numpy(), plain, rtol=1e-14)
    assert torch.autograd.gradcheck(ratio, numbers)


def test_the_tension_of_a_stretched_disc_does_not_follow_the_law() -> None:
    """Far above its relaxation a rubber is that of the whole modulus, under the same tension."""
    tense = DiscOptions(tension=100.0)
    relaxing = solve_disc(3e-3, 0.5e-3, 1e6, options=tense).compliance(0.1, Rubber(strengths=(0.5,), times=(1e5,)))
    assert relaxing.real == pytest.approx(solve_disc(3e-3, 0.5e-3, 1.5e6, options=tense).static_compliance, rel=1e-3)
    assert abs(relaxing.imag) < 1e-4 * relaxing.real


def test_a_design_that_asks_for_constant_loss_has_the_same_modulus_at_all_frequencies() -> None:
    design = prototype("array-2x6").completed()
    constant = design.with_values({"materials.silicone-shore-a-30.law": "constant"})
    grid = np.array([0.01, 0.1, 1.0])
    compliance = design_compliance(constant, grid)
    np.testing.assert_allclose(compliance, compliance[0], rtol=1e-5)
    assert design_compliance(design, 0.1) == pytest.approx(compliance[1], rel=1e-9)
    ratio = design_compliance(design, 10.0) / design_compliance(constant, 10.0)
    assert ratio == pytest.approx(1 / 1.340, rel=1e-3)
