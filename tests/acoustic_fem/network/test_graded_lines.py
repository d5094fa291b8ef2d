"""Lines whose points and tubes are of several kinds: every solver takes at each place what stands there."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from joined_cells import library_of_cells

import acoustic_fem
from acoustic_fem.batch.network import batch_response
from acoustic_fem.batch.parameters import ArrayParameters
from acoustic_fem.batch.topology import Topology
from acoustic_fem.cell.lumped import lumped_admittance
from acoustic_fem.duct.plane_wave import port_admittance
from acoustic_fem.membrane.design_discs import design_compliance
from acoustic_fem.network.microphone import load_admittance
from geometry.air.cells import cell_catalogue, resonator_cell
from geometry.design.design_file import load_design, prototype
from geometry.layout.arrangement import lay_out
from geometry.schema.ports import Port

BAND = np.array([1.0, 7.0, 40.0, 100.0])
RESULTS = ("source_response", "point_impedance", "microphone_impedance", "transfer_function")
#: Height of the cavity and thickness of the membrane at each point, length and bore of each tube between them, mm.
POINTS = [(2.5, 1.0), (2.5, 1.0), (4.0, 1.0), (4.0, 0.7), (2.5, 1.0)]
TUBES = [(14.0, 0.44), (8.0, 0.6), (8.0, 0.6), (14.0, 0.44)]


@pytest.fixture(scope="module")
def stated():
    """The common parts of the line, without kinds."""
    line = [{"between": ["A", "B"], "points": 5}]
    smooth = {"tube.bore": "smooth", "microphone_tube.bore": "smooth"}
    return prototype("array-2x6").with_values({"lines": line, "membrane.thickness": 1.0, **smooth})


@pytest.fixture(scope="module")
def design(stated):
    tube = stated.tube.model_dump()
    kinds = {
        "point_kinds": {
            "stiff": {},
            "large": {"cavity_height": 4.0},
            "well": {"cavity_height": 4.0, "membrane_thickness": 0.7},
        },
        "tube_kinds": {
            "long": {**tube, "length": 14.0, "inner_diameter": 0.44},
            "short": {**tube, "length": 8.0, "inner_diameter": 0.6},
        },
    }
    pattern = {"points": ["stiff", "stiff", "large", "well", "stiff"], "tubes": ["long", "short", "short", "long"]}
    return stated.with_values({**kinds, "lines.0.pattern": pattern})


@pytest.fixture(scope="module")
def library(design):
    return acoustic_fem.solve(design, BAND, "lumped")


def test_a_graded_line_is_the_network_built_by_hand(stated, library):
    """Every node at once, from the numbers above: cells, ducts, membranes and microphones, nothing of a pattern."""
    air, count = library.medium, len(POINTS)
    outer = (stated.microphone_tube.length, stated.microphone_tube.inner_diameter)
    tubes = [outer, *TUBES, outer]
    catalogue = cell_catalogue(stated, lay_out(stated))
    size = 3 * count + 4  # in, out and membrane of each point; port and sound hole of both microphones
    nodal = np.zeros((len(BAND), size, size), complex)

    def add(nodes, matrix):
        nodal[np.ix_(range(len(BAND)), nodes, nodes)] += matrix

    for place, (height, thickness) in enumerate(POINTS):
        alike = stated.with_values({
            "resonator.cavity_height": height, "resonator.port_height": 1.25, "membrane.thickness": thickness,
        })  # fmt: skip
        outside = stated.tube.outer_diameter
        ports = [
            Port(angle, bore, outside) for angle, (_, bore) in zip((180.0, 0.0), tubes[place : place + 2], strict=True)
        ]
        use = resonator_cell(alike.resonator, ports)
        inside = [3 * place, 3 * place + 1]
        nodes = [inside[use.order.index(port)] for port in range(2)]
        add([*nodes, 3 * place + 2], lumped_admittance(use.cell, BAND, air))
        membrane = 2j * np.pi * BAND * design_compliance(alike, BAND)
        add([3 * place + 2], membrane[:, None, None])
    ends = [(3 * count, 0), *((3 * k + 1, 3 * k + 3) for k in range(count - 1)), (3 * count - 2, 3 * count + 2)]
    for (first, second), (length, bore) in zip(ends, tubes, strict=True):
        free = (length - 2 * 4 * bore / 2) * 1e-3  # less the stubs of four radii that the cells have
        add([first, second], port_admittance(bore / 2 * 1e-3, free, BAND, air))
    load = load_admittance(stated.microphone, BAND, air)
    for end, use in zip((3 * count, 3 * count + 2), catalogue.microphones, strict=True):
        add([end, end + 1], lumped_admittance(use.cell, BAND, air))
        add([end + 1], load[:, None, None])
    impedance = np.linalg.inv(nodal)
    points, microphones = np.arange(2, 3 * count, 3), [3 * count + 1, 3 * count + 3]
    source = np.moveaxis(impedance[:, points][:, :, microphones], 0, -1)
    own = np.moveaxis(impedance[:, points, points], 0, -1)
    np.testing.assert_allclose(library.source_response.values, source, rtol=1e-10)
    np.testing.assert_allclose(library.point_impedance.values, own, rtol=1e-10)
    np.testing.assert_allclose(library.transfer_function.values, source / own[:, None], rtol=1e-10)


def test_the_batch_solves_a_graded_line_as_its_cells_in_columns_of_kinds_and_of_its_own(design):
    library = library_of_cells(design, BAND)
    topology, parameters = Topology.of(design), ArrayParameters.from_design(design)
    (line,) = topology.lines
    assert topology.tube_names == ("microphone_tube", "tube_kinds.long", "tube_kinds.short")
    assert (line.tubes, line.points) == ((0, 1, 2, 2, 1, 0), (0, 0, 1, 2, 0))
    for numbers, wiring in (
        (parameters, topology),
        (parameters.individual(topology), topology.individual()),
        (parameters.tensors(), topology),
    ):
        response = batch_response(numbers, wiring, BAND, library.medium)
        for result in RESULTS:
            np.testing.assert_allclose(
                np.asarray(getattr(response, result))[0], getattr(library, result).values, rtol=1e-10
            )


def test_a_derivative_by_a_column_is_that_of_its_kind(design, library):
    topology, parameters = Topology.of(design), ArrayParameters.from_design(design).tensors(requires_grad=True)
    level = batch_response(parameters, topology, BAND, library.medium).transfer_function.abs().log().sum()
    level.backward()
    step = 1e-4
    lengths = []
    for sign in (1, -1):
        longer = design.with_values({"tube_kinds.short.length": 8.0 * (1 + sign * step)})
        found = acoustic_fem.solve(longer, BAND, "lumped").transfer_function.values
        lengths.append(np.log(np.abs(found)).sum())
    expected = (lengths[0] - lengths[1]) / (2 * step * 8.0e-3)
    assert float(parameters.tube_length.grad[0, 2]) == pytest.approx(expected, rel=1e-5)


def test_a_graded_line_read_backwards_is_its_mirror_image(design, library):
    pattern = design.lines[0].pattern
    backwards = pattern.model_copy(update={"points": pattern.points[::-1], "tubes": pattern.tubes[::-1]})
    turned = acoustic_fem.solve(design.with_values({"lines.0.pattern": backwards}), BAND, "lumped")
    np.testing.assert_allclose(turned.source_response.values[::-1, ::-1], library.source_response.values, rtol=1e-11)
    mutual = library.microphone_impedance.values
    np.testing.assert_allclose(mutual[0, 1], mutual[1, 0], rtol=1e-12)


def test_kinds_that_are_all_as_stated_give_the_same_to_the_last_digit(stated):
    alike = stated.with_values({
        "point_kinds": {"one": {}, "two": {"cavity_height": stated.resonator.cavity_height, "membrane_thickness": 1.0}},
        "tube_kinds": {"one": stated.tube, "two": stated.tube},
        "lines.0.pattern": {"points": ["one", "two", "one"], "tubes": ["two", "one"], "mirrored": True},
    })  # fmt: skip
    plain, kinds = (acoustic_fem.solve(each, BAND, "lumped") for each in (stated, alike))
    for result in RESULTS:
        assert (getattr(plain, result).values == getattr(kinds, result).values).all()
    for touch in ("force", "displacement", "pressure"):
        assert (plain.touch_response(touch).values == kinds.touch_response(touch).values).all()
    assert cell_catalogue(alike, lay_out(alike)) == cell_catalogue(stated, lay_out(stated))


def test_each_distinct_cell_of_a_graded_line_is_solved_once(design):
    cells = cell_catalogue(design, lay_out(design)).distinct
    resonators = [cell for cell in cells if cell.kind == "resonator"]
    # Ends (long and microphone tube, both 0.44), long and short at 2.5 mm; two short at 4 mm; long and short at 4 mm.
    assert sorted((cell.height, *(port.bore_diameter for port in cell.ports)) for cell in resonators) == [
        (2.5, 0.44, 0.44), (2.5, 0.44, 0.6), (4.0, 0.44, 0.6), (4.0, 0.6, 0.6),
    ]  # fmt: skip
    assert len(cells) == 5
    assert {cell.port_height for cell in resonators} == {1.25}


def test_a_force_moves_the_membrane_that_it_touches(design, library):
    """The response to a force is that of a line of the kind's membranes by the network of this one."""
    response = library.touch_response("force").values
    for place, (_, thickness) in enumerate(POINTS):
        alike = replace(
            library, design=design.with_values({"lines.0.pattern.points": None, "membrane.thickness": thickness})
        )
        np.testing.assert_allclose(response[place], alike.touch_response("force").values[place], rtol=1e-12)


@pytest.mark.filterwarnings("ignore:entrance loss")
def test_the_graded_example_pays_in_loudness_what_its_page_says():
    graded = load_design(Path(__file__).parents[3] / "docs" / "examples" / "graded-line-36.toml")
    tube = {"length": 9.35, "inner_diameter": 0.94, "outer_diameter": 1.3, "wire_diameter": 0.1}
    uniform = graded.with_values({
        "lines.0.pattern": None, "tube": tube, "microphone_tube": tube,
        "resonator.cavity_height": 4.7, "membrane.thickness": 1.66,
    })  # fmt: skip
    spread, quieter = [], []
    for design in (graded, uniform):
        response = acoustic_fem.solve(design, np.linspace(1, 100, 12), "lumped").touch_response("force").values
        level = 10 * np.log10((np.abs(response) ** 2).mean(axis=-1))
        spread.append(np.ptp(level.max(axis=1)))
        quieter.append(level.min())
    assert spread == pytest.approx([26, 7], abs=1)
    assert quieter[1] - quieter[0] == pytest.approx(10, abs=1)
