"""Floors and sheaths that yield: against closed forms, in the whole network, and alike in solve and in batches."""

import numpy as np
import pytest
from joined_cells import library_of_cells

import acoustic_fem
import geometry
from acoustic_fem.batch.network import batch_response
from acoustic_fem.batch.parameters import ArrayParameters
from acoustic_fem.batch.topology import Topology
from acoustic_fem.duct.plane_wave import tube_compliance
from acoustic_fem.membrane.rubber import Rubber
from acoustic_fem.network.yielding import floor_compliance, sheath_compliance

BAND = np.geomspace(1, 100, 7)
RUBBER = {
    "youngs_modulus": 1.0,
    "poisson_ratio": 0.49,
    "density": 1070.0,
    "loss_factor": 0.1,
    "modulus_frequency": 10.0,
    "source": "test",
}
TABLE = {
    "youngs_modulus": 0.8,
    "poisson_ratio": 0.49,
    "density": 1070.0,
    "law": "prony",
    "relaxation_times": [1.0, 0.01],
    "relaxation_moduli": [0.2, 0.3],
    "source": "test",
}
SHEATHS = {"tube.sheath_material": "own", "microphone_tube.sheath_material": "own"}
FLOOR = {"resonator.floor_material": "own"}


def changed(values, **material):
    return geometry.prototype("array-2x6").with_values({"materials": {"own": {**RUBBER, **material}}, **values})


def response(design):
    return acoustic_fem.solve(design, BAND, "lumped").transfer_function.values


def test_a_thin_floor_is_the_clamped_plate():
    design = changed({**FLOOR, "resonator.cavity_diameter": 40.0, "resonator.floor_thickness": 0.4})
    plate = np.pi * 0.02**6 * 12 * (1 - 0.49**2) / (192 * 1e6 * 0.0004**3)  # pi a^6 / (192 D)
    assert floor_compliance(design) == pytest.approx(plate, rel=4e-3)


def test_a_soft_floor_is_one_shunt_more_at_each_membrane():
    """It and a membrane that is softer by as much are the same to the network."""
    design = changed(FLOOR)
    rigid = acoustic_fem.solve(design.with_values({"resonator.floor_material": None}), BAND, "lumped")
    topology, parameters = Topology.of(design), ArrayParameters.from_design(rigid.design)
    alone = parameters.individual(topology)
    alone.floor_compliance[0, 3] = floor_compliance(design)
    alone.floor_loss[:], alone.floor_slope[:], alone.floor_reference[:] = 0.1, 1.0, 10.0
    found = batch_response(alone, topology.individual(), BAND, rigid.medium)
    softness = floor_compliance(design) / Rubber.spring_pot(0.1, 10.0).ratio(BAND)
    z, source = rigid.point_impedance.values[3], rigid.source_response.values[3]
    np.testing.assert_allclose(found.source_response[0, 3], source / (1 + 2j * np.pi * BAND * softness * z), rtol=1e-10)


def test_a_sheath_lies_on_the_spring():
    design = changed(SHEATHS)
    lame = tube_compliance(0.3e-3, 0.45e-3, 1e6, 0.49).real
    assert sheath_compliance(design, design.tube) == pytest.approx(lame, rel=1e-12)


def test_what_is_stiff_is_as_rigid():
    stiff = response(changed({**SHEATHS, **FLOOR}, youngs_modulus=1e5))
    np.testing.assert_allclose(stiff, response(geometry.prototype("array-2x6")), rtol=1e-5)


def test_soft_walls_change_what_the_page_of_theory_says():
    rigid = response(geometry.prototype("array-2x6"))
    floors, sheaths = (
        np.sort(np.abs(response(changed(values)) / rigid - 1).max(2), axis=1).max(0) for values in (FLOOR, SHEATHS)
    )
    np.testing.assert_allclose(floors, [0.157, 0.303], atol=0.003)  # near and far microphone
    np.testing.assert_allclose(sheaths, [0.019, 0.035], atol=0.001)


@pytest.mark.parametrize("material", [RUBBER, TABLE], ids=["spring-pot", "prony"])
def test_the_batch_yields_as_the_network_of_cells_does(material):
    values = {"materials": {"own": material}, **FLOOR, "tube.sheath_material": "own", "resonator.leak_diameter": 0.05}
    design = geometry.prototype("array-2x6").with_values(values)
    library = library_of_cells(design, BAND)
    for parameters in (ArrayParameters.from_design(design), ArrayParameters.from_design(design).tensors()):
        found = batch_response(parameters, Topology.of(design), BAND, library.medium)
        for name in ("source_response", "point_impedance", "microphone_impedance"):
            np.testing.assert_allclose(np.asarray(getattr(found, name))[0], getattr(library, name).values, rtol=1e-9)


def test_a_library_of_soft_parts_states_their_material(tmp_path):
    design = changed({**SHEATHS, **FLOOR, "resonator.floor_material": "silicone-shore-a-30"})
    library = acoustic_fem.solve(design, BAND, "lumped")
    acoustic_fem.save(library, tmp_path / "soft.nc")
    again = acoustic_fem.load(tmp_path / "soft.nc").design
    assert again.material("silicone-shore-a-30") == design.material("silicone-shore-a-30")
    assert (again.tube, again.resonator) == (design.tube, design.resonator)


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"tube.sheath_material": "wax"}, "tube.sheath_material = 'wax' must be one of: "),
        ({"resonator.floor_material": "wax"}, "resonator.floor_material = 'wax' must be one of: "),
        (
            {**FLOOR, "resonator.floor_thickness": 7.0},
            "resonator.floor_thickness = 7 mm must be between 0.03 and 6 mm for resonator.floor_material",
        ),
        (
            {"tube.sheath_material": "own", "tube.outer_diameter": 0.6},
            "tube.outer_diameter = 0.6 mm must be above 0.6 mm, the outside of the spring, for tube.sheath_material",
        ),
    ],
)
def test_soft_parts_without_material_or_size_are_refused(values, message):
    with pytest.raises(geometry.DesignError) as refused:
        changed(values)
    assert message in str(refused.value)
