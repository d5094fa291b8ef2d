"""The membrane: reference numbers, thin-plate limit, convergence, scaling, bad input."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from reference_data import rows

from acoustic_fem.axisymmetric_elasticity import solve_dimensionless
from acoustic_fem.membrane import design_disc, disc_compliance, solve_disc
from geometry.design_file import prototype


def kirchhoff(radius, thickness, modulus, poisson_ratio=0.49, density=1070.0):
    """Volume compliance and first frequency of a thin clamped plate."""
    stiffness = modulus * thickness**3 / (12 * (1 - poisson_ratio**2))
    frequency = 10.2158 / (2 * np.pi * radius**2) * np.sqrt(stiffness / (density * thickness))
    return np.pi * radius**6 / (192 * stiffness), frequency


@pytest.mark.parametrize("row", rows("clamped_disc"), ids=lambda row: f"h={row['h']:g} nu={row['nu']:g}")
def test_clamped_disc_agrees_with_the_reference(row):
    disc = solve_disc(row["a"], row["h"], row["E"], row["nu"], density=row["rho"])
    # the reference mesh does not resolve the edge of the clamp: 4e-4, see reference/README.md
    assert disc.static_compliance == pytest.approx(row["Cvol"], rel=5e-4)
    assert disc.first_frequency == pytest.approx(row["f1"], rel=2e-4)


@pytest.mark.parametrize(("thickness", "ratio"), [(0.3e-3, 1.32), (0.5e-3, 1.64), (0.8e-3, 2.32)])
def test_disc_glued_on_a_rim_is_softer_than_a_thin_plate_by_the_known_ratio(thickness, ratio):
    glued = disc_compliance(3e-3, thickness, 5e5, rim_width=1.5e-3)
    assert glued / kirchhoff(3e-3, thickness, 5e5)[0] == pytest.approx(ratio, abs=0.005)
    assert glued > disc_compliance(3e-3, thickness, 5e5)


@pytest.mark.parametrize("rim", [0.0, 0.5], ids=["clamped", "glued"])
@pytest.mark.parametrize("thickness", [0.1, 0.27])
def test_each_refinement_at_least_halves_the_error(thickness, rim):
    values = np.array([solve_dimensionless(thickness, 0.49, rim, n).compliance for n in (2, 3, 4, 5)])
    steps = np.diff(values) / values[-1]
    assert np.all(steps > 0)  # conforming elements are too stiff
    assert np.all(steps[1:] < 0.5 * steps[:-1])
    assert steps[-1] < 1.2e-4  # what refinement 4, the default, lacks


def test_thin_discs_tend_to_the_thin_plate():
    disc = solve_disc(3e-3, 0.06e-3, 5e5)
    compliance, frequency = kirchhoff(3e-3, 0.06e-3, 5e5)
    assert disc.static_compliance == pytest.approx(compliance, rel=3e-3)
    assert disc.first_frequency == pytest.approx(frequency, rel=3e-3)


def test_nearly_incompressible_rubber_does_not_lock():
    soft, hard = (disc_compliance(3e-3, 0.3e-3, 5e5, poisson_ratio) for poisson_ratio in (0.49, 0.49999))
    assert hard / soft == pytest.approx((1 - 0.49999**2) / (1 - 0.49**2), rel=2e-3)


@settings(max_examples=8)
@given(st.floats(1e-3, 5e-3), st.floats(1e5, 1e7))
def test_compliance_scales_with_volume_over_modulus_and_frequency_with_its_root(radius, modulus):
    disc = solve_disc(radius, radius / 8, modulus, rim_width=radius / 2)
    unit = solve_dimensionless(0.125, 0.49, 0.5)
    assert disc.static_compliance == pytest.approx(unit.compliance * radius**3 / modulus, rel=1e-12)
    expected = np.sqrt(unit.eigenvalue * modulus / 1070) / radius / (2 * np.pi)
    assert disc.first_frequency == pytest.approx(expected, rel=1e-9)


def test_the_deflection_sweeps_the_compliance_and_is_held_at_the_edge():
    disc = solve_disc(3e-3, 0.5e-3, 1e6, rim_width=1e-3)
    assert np.all(np.diff(disc.radius) > 0)
    assert disc.radius[0] == 0
    assert disc.radius[-1] == pytest.approx(3e-3, rel=1e-12)
    assert disc.deflection[-1] == 0
    assert disc.deflection[0] == disc.deflection.max()
    swept = np.trapezoid(2 * np.pi * disc.radius * disc.deflection, disc.radius)
    assert swept == pytest.approx(disc.static_compliance, rel=2e-3)


def test_the_first_mode_carries_nearly_the_whole_static_compliance():
    disc = solve_disc(3e-3, 0.3e-3, 5e5)
    share = 1 / (disc.modal_mass * (2 * np.pi * disc.first_frequency) ** 2) / disc.static_compliance
    assert 0.95 < share < 1


def test_dynamic_compliance_is_static_at_low_frequency_and_lossy():
    disc = solve_disc(3e-3, 0.3e-3, 5e5)
    low = disc.compliance(1e-3, loss_factor=0.1)
    assert low == pytest.approx(disc.static_compliance / (1 + 0.1j), rel=1e-9)
    assert disc.compliance(disc.first_frequency / 4) == pytest.approx(disc.static_compliance * 16 / 15, rel=1e-12)


def test_a_warning_with_numbers_comes_near_the_resonance():
    disc = solve_disc(3e-3, 0.3e-3, 5e5)
    with pytest.warns(UserWarning, match=r"200 Hz is above a third of its first resonance in vacuo \(378\.\d Hz\)"):
        disc.compliance([1.0, 200.0])


def test_a_design_gives_its_membrane_in_si():
    design = prototype("array-2x6")
    material = design.material(design.membrane.material)
    expected = disc_compliance(
        design.resonator.cavity_diameter * 0.5e-3,
        design.membrane.thickness * 1e-3,
        material.youngs_modulus * 1e6,
        material.poisson_ratio,
        design.membrane.rim_width * 1e-3,
    )
    assert design_disc(design).static_compliance == pytest.approx(expected, rel=1e-12)


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"radius": 0.0}, "radius = 0 m"),
        ({"thickness": 2.9e-5}, "thickness = 2.9e-05 m must be between 3e-05 and 0.006 m"),
        ({"youngs_modulus": -1.0}, "youngs_modulus = -1 Pa"),
        ({"poisson_ratio": 0.5}, "poisson_ratio = 0.5 must be between 0.01 and 0.49999"),
        ({"rim_width": 1e-6}, "rim_width = 1e-06 m must be between 1.5e-05 and 0.15 m"),
    ],
)
def test_an_impossible_disc_is_refused_by_name(changes, message):
    arguments = {"radius": 3e-3, "thickness": 0.3e-3, "youngs_modulus": 5e5, **changes}
    with pytest.raises(ValueError) as error:
        disc_compliance(**arguments)
    assert message in str(error.value)
