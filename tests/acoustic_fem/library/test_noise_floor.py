"""Noise: thermal noise against equipartition, detection limits against closed forms, bad input."""

import dataclasses

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st
from reference_data import AIR
from refusals import refused

import acoustic_fem
from acoustic_fem.library.noise_floor import (
    BOLTZMANN,
    detectable_density,
    detection_limits,
    gas_temperature,
    matched_filter_snr,
    noise_covariance,
    noise_density,
    thermal_covariance,
)
from acoustic_fem.membrane.design_discs import design_disc, design_rubber
from acoustic_fem.network.microphone import noise_density as own_density
from geometry.design.design_file import prototype
from geometry.ground.refusal import Kind

GRID = np.linspace(1, 100, 100)
DESIGN = prototype("fingertip-3x4")


@pytest.fixture(scope="module")
def library():
    return acoustic_fem.solve(DESIGN, GRID, fidelity="lumped")


def flat(library, response, own):
    """The library with frequency-independent responses, no thermal noise and white microphones."""
    microphone = library.design.microphone.model_copy(update={"noise_density": own, "noise_corner": 0.0})
    return dataclasses.replace(
        library,
        source_response=xr_full(library.source_response, response),
        microphone_impedance=xr_full(library.microphone_impedance, 0.0),
        design=library.design.model_copy(update={"microphone": microphone}),
    )


def xr_full(array, value):
    return array.copy(data=np.broadcast_to(value, array.shape).astype(complex))


def ladder(conductances, compliances, omega):
    """Impedance (n_freq, n, n) of a chain of compliances with resistances between neighbours."""
    size = len(compliances)
    nodal = np.zeros((size, size))
    for k, g in enumerate(conductances):
        nodal[k : k + 2, k : k + 2] += g * np.array([[1, -1], [-1, 1]])
    return np.linalg.inv(nodal + 1j * omega[:, None, None] * np.diag(compliances))


# -- thermal noise -------------------------------------------------------------------------------------
def test_the_temperature_of_the_air_is_that_it_was_made_with():
    for celsius in (0, 20, 40):
        air = acoustic_fem.Medium.at(celsius, 0.5)
        assert gas_temperature(air) == pytest.approx(273.15 + celsius, rel=1e-9, abs=0)
    assert gas_temperature(AIR) == pytest.approx(292.8, abs=0.1)


def test_thermal_pressure_of_a_leaky_cavity_is_k_t_over_c():
    compliance, resistance, temperature = 7e-13, 2.5e8, 293.0
    frequency = np.geomspace(1e-6, 1e6, 20001) / (2 * np.pi * resistance * compliance)
    impedance = 1 / (1 / resistance + 2j * np.pi * frequency * compliance)
    density = thermal_covariance(impedance[:, None, None], temperature)[:, 0, 0].real
    assert density[0] == pytest.approx(4 * BOLTZMANN * temperature * resistance, rel=1e-9, abs=0)
    variance = np.trapezoid(density, frequency)
    assert variance == pytest.approx(BOLTZMANN * temperature / compliance, rel=1e-5, abs=0)


@settings(max_examples=20)
@given(st.lists(st.tuples(st.floats(0.1, 10), st.floats(0.1, 10)), min_size=2, max_size=5))
def test_thermal_pressures_in_a_sealed_chain_have_the_variance_of_equipartition(parts):
    """Gas flows between the nodes and its sum stays: <p p^T> = k T (diag(1/C) - 1 1^T / sum C)."""
    scale_g, scale_c, temperature = 4e-9, 1e-12, 293.0
    conductances = scale_g * np.array([g for g, _ in parts[1:]])
    compliances = scale_c * np.array([c for _, c in parts])
    frequency = np.geomspace(1e-7, 1e6, 3001) * scale_g / scale_c
    covariance = thermal_covariance(ladder(conductances, compliances, 2 * np.pi * frequency), temperature)
    found = np.trapezoid(covariance, frequency, axis=0)
    expected = BOLTZMANN * temperature * (np.diag(1 / compliances) - 1 / compliances.sum())
    np.testing.assert_allclose(found, expected, atol=1e-4 * expected.max())


def test_noise_of_a_network_that_is_not_reciprocal_is_hermitian():
    impedance = np.array([[[2.0 + 1j, 1.0 + 2j], [3.0, 5.0]]])
    covariance = thermal_covariance(impedance, 300.0) / (2 * BOLTZMANN * 300)
    np.testing.assert_allclose(covariance, [[[4, 4 + 2j], [4 - 2j, 10]]], rtol=1e-12)


def test_thermal_noise_of_the_microphones_is_4_k_t_re_z(library):
    noise = noise_density(library)
    own = noise["own"].sel(microphone="A").values
    np.testing.assert_allclose(own, own_density(library.design.microphone, GRID), rtol=1e-12)
    for k, name in enumerate(library.design.microphones):
        resistance = library.microphone_impedance.values[k, k].real
        thermal = np.sqrt(4 * BOLTZMANN * 293.15 * resistance)
        np.testing.assert_allclose(noise["thermal"].sel(microphone=name), thermal, rtol=1e-6)
    np.testing.assert_allclose(noise["total"] ** 2, noise["thermal"] ** 2 + noise["own"] ** 2, rtol=1e-12)
    assert noise["total"].attrs["units"] == "Pa/sqrt(Hz)"
    assert noise["total"].dims == ("microphone", "frequency")


def test_the_noise_covariance_is_positive_definite_and_its_diagonal_the_total(library):
    covariance = noise_covariance(library)
    assert np.linalg.eigvalsh(covariance).min() > 0
    total = noise_density(library)["total"].transpose("frequency", ...).values
    np.testing.assert_allclose(np.einsum("fmm->fm", covariance).real, total**2, rtol=1e-12)


def test_noise_at_the_output_weighs_more_below_the_corner_of_the_vent(library):
    ratio = noise_density(library, "output")["own"] / noise_density(library)["own"]
    assert ratio.sel(frequency=1.0, microphone="A") == pytest.approx(20, rel=0.1, abs=0)
    assert 1 < ratio.sel(frequency=100.0, microphone="A") < 1.1


# -- touches -------------------------------------------------------------------------------------------
def test_a_force_and_a_pressure_inject_what_the_disc_sweeps(library):
    disc = design_disc(DESIGN)
    force = library.touch_response("force")
    assert force.dims == ("point", "microphone", "frequency")
    assert force.attrs["units"] == "Pa/N"
    vacuum = disc.response(GRID, design_rubber(DESIGN))
    injected = 2j * np.pi * GRID * vacuum.volume_per_force
    np.testing.assert_allclose(force.values, library.source_response.values * injected, rtol=1e-12)
    ratio = library.touch_response("pressure") / force
    np.testing.assert_allclose(
        ratio, np.broadcast_to(vacuum.volume_per_pressure / vacuum.volume_per_force, ratio.shape), rtol=1e-12
    )


def test_a_displacement_is_a_force_against_membrane_and_air(library):
    """Patch force and cavity pressure load the disc together: solved as two equations per point."""
    disc = design_disc(DESIGN)
    vacuum = disc.response(GRID, design_rubber(DESIGN))
    omega = 2j * np.pi * GRID
    membrane_and_air = 1 / library.point_impedance.values
    air = membrane_and_air - omega * vacuum.compliance
    for point in (0, 5):
        # unknowns F, p: displacement D F - V p = 1; volume into the cavity jw (V F - C p) = air p
        system = np.empty((len(GRID), 2, 2), dtype=complex)
        system[:, 0, 0], system[:, 0, 1] = vacuum.displacement_per_force, -vacuum.volume_per_force
        system[:, 1, 0] = omega * vacuum.volume_per_force
        system[:, 1, 1] = -omega * vacuum.compliance - air[point]
        solution = np.linalg.solve(system, np.tile([1.0, 0.0], (len(GRID), 1))[..., None])[..., 0]
        expected = library.transfer_function.values[point] * solution[:, 1]
        found = library.touch_response("displacement").values[point]
        np.testing.assert_allclose(found, expected, rtol=1e-9)


def test_a_wider_patch_of_the_same_force_sweeps_less(library):
    narrow, wide = (library.touch_response("force", contact_radius=radius) for radius in (0.05e-3, 0.5e-3))
    assert np.all(np.abs(narrow) > np.abs(wide))


# -- detection -----------------------------------------------------------------------------------------
@settings(max_examples=10)
@given(st.floats(1, 30), st.floats(40, 100), st.floats(-40, 60), st.floats(1e-7, 1e-4))
def test_with_white_noise_and_flat_response_the_limit_is_the_noise_of_the_band_over_the_response(low, high, snr, own):
    library = flat(acoustic_fem.solve(DESIGN, GRID, "lumped"), 1e9, own)
    # the response to pressure is flat but for j w: undone in the source response
    response = np.abs(library.touch_response("pressure").values[0, 0])
    library = dataclasses.replace(library, source_response=library.source_response / response * response[0])
    limits = detection_limits(library, (low, high), snr)
    count = len(DESIGN.microphones)
    noise = own * np.sqrt(high - low)
    expected = 10 ** (snr / 20) * noise / response[0] / np.sqrt(count)
    np.testing.assert_allclose(limits["pressure"], expected, rtol=1e-9)
    density = detectable_density(library, "pressure", snr)
    np.testing.assert_allclose(density, 10 ** (snr / 20) * own / response[0] / np.sqrt(count), rtol=1e-9)
    pulse = matched_filter_snr(library, "pressure", 2e-3, (low, high))
    np.testing.assert_allclose(pulse, count * 4 * (2e-3 * response[0] / own) ** 2 * (high - low), rtol=1e-9)


def test_a_matched_filter_finds_a_known_pulse_with_the_computed_ratio():
    """Sampled: a pulse in white noise, filtered by itself; 4 int |X|^2 / N df is its squared peak over variance."""
    rate, count, own = 1000.0, 1000, 0.3
    time = np.arange(count) / rate
    pulse = np.exp(-((time - 0.5) ** 2) / (2 * 0.02**2))
    spectrum = np.fft.rfft(pulse) / rate
    computed = 4 * np.trapezoid(np.abs(spectrum) ** 2 / own**2, np.fft.rfftfreq(count, 1 / rate))
    noise = np.random.default_rng(1).normal(scale=own * np.sqrt(rate / 2), size=(5000, count))
    assert (pulse @ pulse) ** 2 / np.var(noise @ pulse) == pytest.approx(computed, rel=0.08, abs=0)


def test_limits_per_point_are_labelled_and_scale_with_the_required_ratio(library):
    limits, strict = detection_limits(library, (1, 100)), detection_limits(library, (1, 100), snr_db=20)
    assert set(limits) == {"displacement", "force", "pressure"}
    assert [limits[name].attrs["units"] for name in ("displacement", "force", "pressure")] == ["m", "N", "Pa"]
    for name in limits:
        assert limits[name].dims == ("point",)
        np.testing.assert_allclose(strict[name] / limits[name], 10, rtol=1e-12)


def test_listening_to_more_microphones_never_hurts(library):
    both = detectable_density(library, "force")
    for name in DESIGN.microphones:
        assert np.all(detectable_density(library, "force", microphones=[name]) >= both * (1 - 1e-12))


def test_one_microphone_hears_down_to_its_noise_over_the_response(library):
    found = detectable_density(library, "force", microphones=["A"])
    noise = noise_density(library)["total"].sel(microphone="A")
    expected = noise / np.abs(library.touch_response("force").sel(microphone="A"))
    np.testing.assert_allclose(found, expected.transpose(*found.dims), rtol=1e-9)


def test_the_limit_does_not_hang_on_the_grid():
    coarse, fine = (acoustic_fem.solve(DESIGN, np.linspace(1, 100, n), "lumped") for n in (64, 400))
    for name, values in detection_limits(coarse, (1, 100)).items():
        np.testing.assert_allclose(values, detection_limits(fine, (1, 100))[name], rtol=2e-3)


def test_a_symmetric_line_has_mirrored_limits():
    library = acoustic_fem.solve(prototype("array-2x6"), GRID, "lumped")
    limits = detection_limits(library, (1, 100))
    np.testing.assert_allclose(limits["force"], limits["force"][::-1], rtol=1e-9)


# -- bad input -----------------------------------------------------------------------------------------
def test_a_library_without_microphone_impedance_is_refused(library):
    old = dataclasses.replace(library, microphone_impedance=None)
    with refused(Kind.MISSING, "microphone_impedance"):
        noise_density(old)


@pytest.mark.parametrize(
    ("call", "field", "kind"),
    [
        (lambda x: x.touch_response("tickle"), "touch", Kind.OUT_OF_RANGE),
        (lambda x: x.touch_response("force", contact_radius=1.0), "contact_radius", Kind.OUT_OF_RANGE),
        (lambda x: noise_density(x, "inside"), "noise_at", Kind.OUT_OF_RANGE),
        (lambda x: detection_limits(x, (0.5, 50)), "band", Kind.OUT_OF_RANGE),
        (lambda x: detection_limits(x, (50, 20)), "band", Kind.OUT_OF_RANGE),
        (lambda x: detection_limits(x, (np.nan, 20)), "band", Kind.OUT_OF_RANGE),
        (lambda x: detection_limits(x, (1, 100), 999), "snr_db", Kind.OUT_OF_RANGE),
        (lambda x: detectable_density(x, "force", microphones=["Z"]), "microphones", Kind.UNKNOWN),
        (lambda x: detectable_density(x, "force", microphones=[]), "microphones", Kind.OUT_OF_RANGE),
        (lambda x: matched_filter_snr(x, "force", [1.0, 2.0], (1, 9)), "spectrum", Kind.WRONG_TYPE),
        (lambda x: matched_filter_snr(x, "force", np.inf, (1, 9)), "spectrum", Kind.WRONG_TYPE),
    ],
)
def test_bad_input_is_refused_by_name(library, call, field, kind):
    with refused(kind, field):
        call(library)


def test_impedances_that_are_not_square_and_cold_networks_are_refused():
    with refused(Kind.WRONG_TYPE, "impedance"):
        thermal_covariance(np.ones((2, 3)), 300)
    with refused(Kind.OUT_OF_RANGE, "temperature", 0.0):
        thermal_covariance(np.ones((2, 2)), 0)


def test_a_band_with_few_frequencies_brings_a_warning(library):
    with pytest.warns(UserWarning, match="within 10 to 15 Hz the library has only 4 frequencies;"):
        detection_limits(library, (10, 15))
