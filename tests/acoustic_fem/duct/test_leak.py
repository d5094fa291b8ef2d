"""Leaks of cavities: against the capillary as a duct with both its openings, and what they do to an array."""

import numpy as np
import pytest
from joined_cells import library_of_cells

import acoustic_fem
import geometry
from acoustic_fem.batch.network import batch_response
from acoustic_fem.batch.parameters import ArrayParameters
from acoustic_fem.batch.topology import Topology
from acoustic_fem.duct.leak import leak_conductance
from acoustic_fem.duct.plane_wave import port_admittance
from acoustic_fem.duct.tube_opening import entrance_impedance
from acoustic_fem.quantities.medium import Medium

AIR = Medium.at(20, 0.5)
BAND = np.geomspace(1, 100, 7)
RESULTS = ("source_response", "point_impedance", "microphone_impedance")


def as_a_duct(radius, length):
    """Admittance of a capillary between its openings, its far end at no pressure."""
    duct = port_admittance(radius, length, BAND, AIR)
    opening = entrance_impedance(radius, BAND, AIR)
    inside = duct[:, 0, 0] - duct[:, 0, 1] ** 2 / (duct[:, 1, 1] + 1 / opening)
    return 1 / (opening + 1 / inside)


@pytest.mark.parametrize(
    ("radius", "length", "within"), [(25e-6, 1e-3, 0.004), (50e-6, 1e-3, 0.02), (5e-5, 1e-4, 0.022)]
)
def test_a_leak_is_the_resistance_of_a_capillary_with_openings(radius, length, within):
    exact = as_a_duct(radius, length)
    conductance = leak_conductance(radius, length, AIR)
    np.testing.assert_allclose(conductance, exact, rtol=within)
    assert conductance == pytest.approx(exact[0].real, rel=2e-5)


def test_no_bore_is_no_leak():
    assert leak_conductance(0.0, 1e-3, AIR) == 0


@pytest.fixture(scope="module")
def libraries():
    tight = geometry.prototype("array-2x6")
    leaking = tight.with_values({"resonator.leak_diameter": 0.05})
    return tuple(acoustic_fem.solve(design, BAND, "lumped") for design in (tight, leaking))


def test_a_leak_of_a_hair_changes_the_far_microphone_by_a_tenth(libraries):
    tight, leaking = (library.transfer_function.values for library in libraries)
    change = np.sort(np.abs(leaking / tight - 1).max(2), axis=1).max(0)
    np.testing.assert_allclose(change, [0.029, 0.115], atol=0.002)  # near and far microphone


def test_a_leak_is_one_shunt_at_the_membrane_of_each_point(libraries):
    """One leak alone, by the Sherman-Morrison formula of a rank-one change."""
    tight = libraries[0]
    topology, parameters = Topology.of(tight.design), ArrayParameters.from_design(tight.design)
    alone = parameters.individual(topology)
    conductance = leak_conductance(25e-6, 1e-3, tight.medium)
    alone.leak_conductance[0, 3] = conductance
    found = batch_response(alone, topology.individual(), BAND, tight.medium)
    z, source = tight.point_impedance.values[3], tight.source_response.values[3]
    np.testing.assert_allclose(found.point_impedance[0, 3], z / (1 + conductance * z), rtol=1e-10)
    np.testing.assert_allclose(found.source_response[0, 3], source / (1 + conductance * z), rtol=1e-10)
    before = tight.microphone_impedance.values
    lost = source[:, None] * source * conductance / (1 + conductance * z)
    np.testing.assert_allclose(found.microphone_impedance[0], before - lost, rtol=1e-10)


def test_the_batch_leaks_as_the_network_of_cells_does(libraries):
    design = libraries[1].design
    leaking = library_of_cells(design, BAND)
    found = batch_response(ArrayParameters.from_design(design), Topology.of(design), BAND, leaking.medium)
    for name in RESULTS:
        np.testing.assert_allclose(getattr(found, name)[0], getattr(leaking, name).values, rtol=1e-9)
