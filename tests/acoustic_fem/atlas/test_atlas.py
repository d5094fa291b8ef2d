"""The atlas of cells: the same in every solver, differentiable, within its stated error of 3-D, refused outside."""

import json
from dataclasses import replace

import numpy as np
import pytest
import torch
from joined_cells import library_of_cells
from refusals import refused

import acoustic_fem
from acoustic_fem.atlas import (
    OutsideAtlas,
    atlas_admittance,
    cell_atlas,
    cell_table,
    opening_node,
    outside_atlas,
    quick_fidelity,
)
from acoustic_fem.batch.network import batch_response
from acoustic_fem.batch.parameters import ArrayParameters, MediumParameters
from acoustic_fem.batch.topology import Topology
from acoustic_fem.cell.design_cells import solve_cells
from acoustic_fem.cell.lumped import lumped_admittance
from acoustic_fem.quantities.medium import Medium
from geometry.air.cells import cell_catalogue
from geometry.design.design_file import prototype
from geometry.ground.refusal import Kind, Refusal
from geometry.layout.arrangement import lay_out

BAND = np.array([1.0, 12.0, 60.0, 200.0])
AIR = Medium.at(20, 0.5)
RESULTS = ("source_response", "point_impedance", "microphone_impedance", "transfer_function")
PROTOTYPES = ["array-2x6", "fingertip-3x4", "fingertip-4x6", "glove", "large-area-64", "line-2", "line-3", "line-4"]


@pytest.fixture(scope="module")
def design():
    return prototype("array-2x6")


def cells_of(design):
    return cell_catalogue(design, lay_out(design)).distinct


@pytest.mark.parametrize("name", PROTOTYPES)
def test_the_batch_gives_what_the_network_of_cells_gives(name):
    design = prototype(name)
    library = library_of_cells(design, BAND, "atlas", AIR)
    response = batch_response(ArrayParameters.from_design(design, AIR), Topology.of(design), BAND, AIR, "atlas")
    for result in RESULTS:
        np.testing.assert_allclose(getattr(response, result)[0], getattr(library, result), rtol=1e-8)


def test_ports_out_of_the_middle_and_air_of_their_own_count_in_the_batch_as_in_the_cells(design):
    changed = [
        design.with_values({"resonator.port_height": 0.6}),
        design.with_values({"resonator.cavity_height": 4.0, "air.temperature": 35.0, "air.pressure": 8e4}),
    ]
    media = [Medium.at(20, 0.5), Medium.at(35, 0.5, 8e4)]
    parameters = [ArrayParameters.from_design(each, air) for each, air in zip(changed, media, strict=True)]
    joined = ArrayParameters(
        **{name: np.concatenate([getattr(part, name) for part in parameters]) for name in vars(parameters[0])}
    )
    found = batch_response(joined, Topology.of(design), BAND, MediumParameters.from_media(media), "atlas")
    for number, (each, air) in enumerate(zip(changed, media, strict=True)):
        library = library_of_cells(each, BAND, "atlas", air)
        np.testing.assert_allclose(found.transfer_function[number], library.transfer_function, rtol=1e-8)
    centred = acoustic_fem.solve(design, BAND, "atlas").transfer_function
    lowered = acoustic_fem.solve(changed[0], BAND, "atlas").transfer_function
    assert np.abs(lowered / centred - 1).max() > 1e-4


def test_a_library_says_that_it_is_of_the_atlas_and_what_its_errors_are(design):
    library = acoustic_fem.solve(design, BAND, "atlas")
    assert library.fidelity == "atlas"
    for cell in library.provenance["cells"]:
        assert cell["method"] == f"atlas of cells, table {cell_atlas().digest}"
        assert 0 < cell["errors"]["transfer function by 1 + |ln H|"] < 0.01


def test_frequencies_above_those_of_touches_are_told_and_those_of_errors_are_stated(design, recwarn):
    library = acoustic_fem.solve(design, "1:500:5", "atlas")
    assert not recwarn.list  # the default grid of libraries
    assert library.provenance["cells"][0]["errors_up_to_hz"] == 200
    with pytest.warns(UserWarning, match="its errors were found up to 200 Hz; above they are not known"):
        acoustic_fem.solve(design, [1.0, 501.0], "atlas")


def test_corners_sharper_than_those_at_which_its_errors_were_found_are_told(recwarn):
    said = r"its errors were found for tubes of a point at 26\.3 degrees and more; of some at 15\.4"
    sharp = prototype("array-2x6").with_values({"layout.pitch": 11.0, "tube.length": 18.0})
    with pytest.warns(UserWarning, match=said):
        acoustic_fem.solve(sharp, BAND, "atlas")
    recwarn.clear()
    acoustic_fem.solve(prototype("fingertip-3x4"), BAND, "atlas")  # corners of 66 degrees
    assert not [each for each in recwarn if "its errors were found" in str(each.message)]


def test_the_gradient_is_that_of_finite_differences(design):
    topology, parameters = Topology.of(design), ArrayParameters.from_design(design, AIR)

    def level(numbers):
        response = batch_response(numbers, topology, BAND, AIR, "atlas").transfer_function
        power = response.real**2 + response.imag**2
        return (power[:, :, 0] / power[:, :, 1]).sum()

    tensors = parameters.tensors(requires_grad=True)
    level(tensors).backward()
    for name in ("tube_radius", "cavity_radius", "cavity_height", "port_height", "chamber_radius", "chamber_height"):
        value, step = getattr(parameters, name), 1e-5
        up, down = (replace(parameters, **{name: value * (1 + sign * step)}) for sign in (1, -1))
        difference = (level(up) - level(down)) / (2 * step)
        gradient = float((getattr(tensors, name).grad * torch.as_tensor(value)).sum())
        assert gradient == pytest.approx(difference, rel=2e-5, abs=1e-9), name
        assert gradient != 0


def test_a_cell_without_shared_inertance_is_a_cavity_of_uniform_pressure():
    storage, load = 2e-9j, 1e-10 + 3e-9j
    shunt, share, own = opening_node(storage, load, 0.0, 0.0)
    assert (shunt, share) == (pytest.approx(storage + load), pytest.approx(1.0))
    assert abs(own * (storage + load)) < 1e-12


def test_the_node_of_a_cavity_is_its_impedances_with_the_membrane_eliminated():
    storage, load, passage, through = 2e-9j, 1e-10 + 3e-9j, -4e6j, -2e6j
    shunt, share, own = opening_node(storage, load, passage, through)
    # two tubes and the membrane, the load beside it; a source drives the membrane and tube 2 is open to a conductance
    impedance = np.full((3, 3), 1 / storage)
    impedance[:2, :2] += passage
    impedance[:2, 2] += through
    impedance[2, :2] += through
    ends = 5e-10
    loads = np.diag([0.0, ends, load])
    exact = np.linalg.solve(np.eye(3) + impedance @ loads, impedance)[:, 2]  # pressures per volume velocity
    node = share / (shunt + ends)
    assert node == pytest.approx(exact[1], rel=1e-9)
    assert share * node + own == pytest.approx(exact[2], rel=1e-9)


def test_cells_outside_are_refused_by_name(design):
    for values, what, value in (
        ({"resonator.shape": "dome"}, "", Refusal.NOT_GIVEN),
        ({"resonator.cavity_height": 7.0}, "cavity height by radius", 2.333),
        ({"microphone.chamber_diameter": 8.0}, "bore by cavity diameter", 0.0558),
        ({"microphone.sound_hole_diameter": 1.3}, "sound hole by chamber diameter", 0.6842),
    ):
        outside = design.with_values(values)
        with refused(Kind.NO_RESULT, error=OutsideAtlas) as found:
            acoustic_fem.solve(outside, BAND, "atlas")
        assert found.value.field.endswith(what)
        assert found.value.value == pytest.approx(value, rel=0.03) if what else found.value.value is value
    with refused(Kind.NO_RESULT, error=OutsideAtlas) as found:
        acoustic_fem.solve(design, [1.0, 2000.0], "atlas")
    assert "shear number" in found.value.field
    with refused(Kind.NO_RESULT, "air: gamma", error=OutsideAtlas):
        acoustic_fem.solve(design, BAND, "atlas", replace(AIR, gamma=1.66))


def test_the_quick_fidelity_is_the_atlas_or_3d_and_why(design):
    assert quick_fidelity(design, BAND).words == "atlas"
    for outside, why in (
        (design.with_values({"resonator.cavity_height": 7.0}), "cavity height by radius = 2.333 must be 0.3 to 2.3"),
        (design.with_values({"resonator.shape": "dome"}), "has cylinders only"),
    ):
        found = quick_fidelity(outside, BAND)
        assert found.name == "navier-stokes"
        assert why in found.words
    assert "shear number" in quick_fidelity(design, [1.0, 2000.0]).words


def test_the_quick_fidelity_is_lumped_where_a_cell_is_too_large_for_3d_and_says_both_reasons(design):
    large = design.with_values({"resonator.cavity_diameter": 50.0, "resonator.cavity_height": 20.0})
    found = quick_fidelity(large, BAND)
    assert found.name == "lumped"
    assert found.outside == outside_atlas(large, BAND) != ""
    assert "needs a mesh of about" in found.too_large
    assert found.words == f"lumped: {found.outside}; {found.too_large}"
    assert outside_atlas(design, BAND) == ""


def test_a_batch_with_a_design_outside_is_refused_by_name(design):
    topology = Topology.of(design)
    tall = ArrayParameters.from_designs([design, design.with_values({"resonator.cavity_height": 7.0})])
    with refused(Kind.NO_RESULT, error=OutsideAtlas) as found:
        batch_response(tall, topology, BAND, AIR, "atlas")
    assert found.value.field.endswith("tube at point 1: cavity height by radius")
    wide = ArrayParameters.from_design(design.with_values({"microphone.sound_hole_diameter": 1.3}))
    with refused(Kind.NO_RESULT, error=OutsideAtlas):
        batch_response(wide, topology, BAND, AIR, "atlas")
    with refused(Kind.OUT_OF_RANGE, "fidelity", "helmholtz"):
        batch_response(tall, topology, BAND, AIR, "helmholtz")


def test_the_table_is_small_and_says_how_it_was_made():
    text = cell_table.FILE.read_bytes()
    assert len(text) < 1_000_000
    about = json.loads(text)["provenance"]
    assert about["samples"] >= 30
    assert {"made", "seeds", "gmsh", "scikit-fem", "acoustic-fem", "held-out designs"} <= about.keys()


def test_the_digest_is_of_what_decides_answers():
    plain = json.loads(cell_table.FILE.read_text())
    digest = cell_table.atlas_of(plain).digest
    assert digest == cell_atlas().digest
    plain["errors"]["transfer function by 1 + |ln H|"] = 0.5
    plain["provenance"]["made"] = "another day"
    assert cell_table.atlas_of(plain).digest == digest
    plain["bounds"]["microphone"]["cavity height by radius"][1] = 3.1
    assert cell_table.atlas_of(plain).digest != digest


def test_the_atlas_moves_lumped_cells_towards_the_3_d_of_the_reference(design):
    """Resistance of an opening of a flat wide cavity: 1.5 mu/a^3 alone, more where floor and ceiling are near."""
    cell = cells_of(design)[0]
    low = cells_of(design.with_values({"resonator.cavity_height": 1.2, "resonator.port_height": 0.4}))[0]
    ratios = []
    for each in (cell, low):
        found, lumped = (np.linalg.inv(of(each, BAND, AIR)) for of in (atlas_admittance, lumped_admittance))
        ratios.append(((found[:, 0, 0] - found[:, 0, 1]) / (lumped[:, 0, 0] - lumped[:, 0, 1])).real[0])
    assert 0 < 1.5 * (ratios[0] - 1) < ratios[1] - 1 < 0.05


@pytest.mark.slow
def test_a_cell_is_within_the_stated_error_of_3_d(design):
    cell = cells_of(design.with_values({"resonator.cavity_height": 2.9, "tube.inner_diameter": 0.5}))[0]
    exact = solve_cells([cell], BAND, AIR)[cell].admittance
    size = np.sqrt(np.abs(np.einsum("fii->fi", exact)))

    def off(of):
        return (np.abs(of(cell, BAND, AIR) - exact) / (size[:, :, None] * size[:, None, :])).max()

    assert off(atlas_admittance) < cell_atlas().errors["admittance of a resonator, held-out designs"]
    assert off(atlas_admittance) < off(lumped_admittance) / 2
