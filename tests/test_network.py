"""The network: a plain solve of every node at once, and the properties every passive network has."""

import time

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from acoustic_fem.cell import solve_cells
from acoustic_fem.duct import port_admittance
from acoustic_fem.frequency import ReducedModel
from acoustic_fem.lumped_cell import lumped_admittance
from acoustic_fem.medium import Medium
from acoustic_fem.membrane import design_compliance
from acoustic_fem.microphone import load_admittance
from acoustic_fem.network import solve_network
from geometry.cells import cell_catalogue
from geometry.design_file import prototype
from geometry.layout import place

AIR = Medium.at(20, 0.5)
BAND = np.geomspace(0.1, 100, 7)
WIDE_BAND = np.array([0.01, *np.linspace(1, 100, 34)])


def solve(design, frequency=BAND):
    layout = place(design)
    cells = {cell: lumped_admittance(cell, frequency, AIR) for cell in cell_catalogue(design, layout).distinct}
    return solve_network(design, layout, cells, frequency, AIR)


def transfer_functions(response):
    return response.source_response / response.point_impedance[:, None, :]


def every_node_at_once(design, frequency=BAND, admittances=None):
    """Impedance between all points and all microphones by one dense solve: (n_freq, n, n), points first.

    Ducts of length zero join their nodes exactly. Nothing is taken to be symmetric. Cells are lumped unless
    their admittances are given.
    """
    layout = place(design)
    catalogue = cell_catalogue(design, layout)
    names: dict[object, int] = {}

    def node(name):
        return names.setdefault(name, len(names))

    entries = []  # (nodes, matrix)
    load = load_admittance(design.microphone, frequency, AIR)
    membrane = 2j * np.pi * frequency * design_compliance(design, frequency)
    starts, tubes_of = np.cumsum([0, *(line.points for line in design.lines)]), {}
    for index, line in enumerate(design.lines):
        for segment in range(line.points + 1):
            outer = segment in (0, line.points)
            tube = design.microphone_tube_of(line) if outer else design.tube_of(line)
            length = tube.length - 2 * tube.stub_length
            pair = [node((index, segment, side)) for side in (0, 1)]
            tubes_of[index, segment] = pair
            if length > 1e-12:
                duct = port_admittance(tube.inner_diameter * 5e-4, length * 1e-3, frequency, AIR)
                entries.append((pair, duct))
            else:
                names[index, segment, 1] = pair[1] = pair[0]

    def add_cell(use, ports, opening, shunt):
        nodal = admittances[use.cell] if admittances else lumped_admittance(use.cell, frequency, AIR)
        nodes = [0] * len(ports)
        for tube, position in enumerate(use.order):
            nodes[position] = ports[tube]
        entries.append(([*nodes, opening], nodal))
        entries.append(([opening], shunt[:, None, None]))

    for where, use in zip(layout.points, catalogue.points, strict=True):
        ports = [tubes_of[where.line, where.place][1], tubes_of[where.line, where.place + 1][0]]
        add_cell(use, ports, node(("point", starts[where.line] + where.place)), membrane)
    for housing, use in zip(layout.microphones, catalogue.microphones, strict=True):
        ports = [tubes_of[p.line, 0 if p.end == 0 else design.lines[p.line].points][p.end] for p in housing.ports]
        add_cell(use, ports, node(("microphone", housing.name)), load)

    used = sorted({node for nodes, _ in entries for node in nodes})
    position = {node: place for place, node in enumerate(used)}
    total = np.zeros((len(frequency), len(used), len(used)), dtype=complex)
    for nodes, matrix in entries:
        local = [position[n] for n in nodes]
        for row, i in enumerate(local):
            for col, k in enumerate(local):
                total[:, i, k] += matrix[:, row, col]
    outputs = [position[names["point", i]] for i in range(design.point_count)]
    outputs += [position[names["microphone", name]] for name in design.microphones]
    return np.linalg.inv(total)[:, outputs][:, :, outputs]


@pytest.fixture(scope="module")
def navier_stokes():
    """Cells of array-2x6 on a grid whose lowest frequency is for the limit: as solved, and not symmetrised.

    The reduced model averages its response with the transposed one. Here the responses before that are kept:
    what flows at one port for a pressure at another, each from a solution of its own.
    """
    design = prototype("array-2x6")
    symmetrised = ReducedModel.response
    solved, plain = {}, {}
    with pytest.MonkeyPatch.context() as patch:
        for cell in cell_catalogue(design, place(design)).distinct:
            last = {}

            def response(model, theta, phi, last=last):
                solution, excitation = model.coordinates(theta, phi)
                last["raw"] = np.einsum("frm,frn->fmn", excitation, solution)
                return symmetrised(model, theta, phi)

            patch.setattr(ReducedModel, "response", response)
            solved[cell] = solve_cells([cell], WIDE_BAND, AIR)[cell].admittance
            plain[cell] = nodal_of_hybrid(last["raw"], solved[cell])
    return design, solved, plain


def nodal_of_hybrid(raw, solved):
    """Nodal admittance from Q = Y p + B U and Z U = F + C p, where B is not taken for the transposed C."""
    scale = 1e-9 / AIR.viscosity  # cells are solved in mm and in units of viscosity
    wall = solved[:, -1:, -1:]  # 1 / Z
    nodal = np.empty_like(solved)
    nodal[:, :-1, :-1] = raw[:, :-1, :-1] * scale + raw[:, :-1, -1:] * raw[:, -1:, :-1] * wall
    nodal[:, :-1, -1:] = raw[:, :-1, -1:] * wall
    nodal[:, -1:, :-1] = raw[:, -1:, :-1] * wall
    nodal[:, -1:, -1:] = wall
    return nodal


def shortened(name, points):
    design = prototype(name)
    return design.with_values({f"lines.{k}.points": points for k in range(len(design.lines))})


@pytest.mark.parametrize(
    "design",
    [prototype("array-2x6"), shortened("line-3", 3), shortened("line-4", 2), prototype("glove")],
    ids=lambda design: f"{design.name}-{design.point_count}",
)
def test_condensation_equals_one_solve_of_all_nodes(design):
    response, direct = solve(design), every_node_at_once(design)
    points = design.point_count
    own = np.einsum("fpp->pf", direct[:, :points, :points])
    np.testing.assert_allclose(response.point_impedance, own, rtol=1e-10)
    reference = np.transpose(direct[:, points:, :points], (2, 1, 0))
    np.testing.assert_allclose(response.source_response, reference, rtol=1e-10)


def test_source_and_receiver_exchanged_give_the_same_pressure():
    design = shortened("line-3", 4)
    response, direct = solve(design), every_node_at_once(design)
    points = design.point_count
    # the network injects at the points; the plain solve injects at the microphones
    received = np.transpose(direct[:, :points, points:], (1, 2, 0))
    np.testing.assert_allclose(response.source_response, received, rtol=1e-9)


def test_source_and_receiver_exchanged_give_the_same_pressure_with_navier_stokes_cells(navier_stokes):
    design, solved, plain = navier_stokes
    for cell, nodal in plain.items():
        scale = np.sqrt(np.abs(np.einsum("fii->fi", nodal)))
        difference = np.abs(nodal - solved[cell]) / (scale[:, :, None] * scale[:, None, :])
        assert difference.max() < 1e-9  # the same cells, but
        assert not np.array_equal(nodal, np.swapaxes(nodal, 1, 2))  # nothing made them symmetric
    response = solve_network(design, place(design), solved, WIDE_BAND, AIR)
    direct = every_node_at_once(design, WIDE_BAND, plain)
    from_points = np.transpose(direct[:, 12:, :12], (2, 1, 0))
    from_microphones = np.transpose(direct[:, :12, 12:], (1, 2, 0))
    np.testing.assert_allclose(from_microphones, from_points, rtol=1e-9)
    np.testing.assert_allclose(response.source_response, from_microphones, rtol=1e-9)
    between_points = direct[:, :12, :12]
    np.testing.assert_allclose(between_points, np.swapaxes(between_points, 1, 2), rtol=1e-9)


def test_closed_forms_and_navier_stokes_give_the_same_transfer_functions(navier_stokes):
    design, solved, _ = navier_stokes
    response, lumped = solve_network(design, place(design), solved, WIDE_BAND, AIR), solve(design, WIDE_BAND)
    finite_elements, closed_forms = transfer_functions(response), transfer_functions(lumped)
    assert finite_elements.shape == (12, 2, len(WIDE_BAND))
    ratio = closed_forms / finite_elements
    # Measured: 0.30 % and 0.15 degrees.
    assert np.abs(np.abs(ratio) - 1).max() < 0.015
    assert np.abs(np.degrees(np.angle(ratio))).max() < 1.0


def test_a_sealed_array_of_navier_stokes_cells_has_one_pressure_at_low_frequency(navier_stokes):
    design, solved, _ = navier_stokes
    transfer = transfer_functions(solve_network(design, place(design), solved, WIDE_BAND, AIR))
    assert WIDE_BAND[0] == 0.01
    assert np.abs(transfer[..., 0] - 1).max() < 0.01
    assert np.abs(transfer[..., -1] - 1).max() > 0.3  # not so at 100 Hz


@settings(max_examples=15)
@given(
    bore=st.floats(0.2, 0.8),
    length=st.floats(7.0, 40.0),
    height=st.floats(2.0, 5.0),
    thickness=st.sampled_from([0.4, 0.6]),
)
def test_any_array_is_reciprocal_and_passive(bore, length, height, thickness):
    design = shortened("line-3", 2).with_values(
        {
            "tube": {"length": length, "inner_diameter": bore, "outer_diameter": bore + 0.3, "wire_diameter": 0.08},
            "resonator.cavity_height": height,
            "resonator.port_height": None,
            "membrane.thickness": thickness,
        }
    )
    response, direct = solve(design), every_node_at_once(design)
    points = design.point_count
    np.testing.assert_allclose(direct, np.swapaxes(direct, 1, 2), rtol=1e-9)
    np.testing.assert_allclose(response.source_response.transpose(2, 1, 0), direct[:, points:, :points], rtol=1e-9)
    assert np.all(response.point_impedance.real > 0)
    # whatever is injected at points and microphones together, it takes power
    assert np.linalg.eigvalsh(direct.real).min() >= -1e-9 * np.abs(direct).max()


def test_a_sealed_array_has_one_pressure_at_low_frequency():
    design = prototype("array-2x6")
    response = solve(design, np.array([0.001, 0.01]))
    transfer = transfer_functions(response)
    assert transfer.shape == (12, 2, 2)
    assert np.abs(transfer - 1).max() < 0.01
    assert np.abs(transfer[..., 0] - 1).max() < 0.11 * np.abs(transfer[..., 1] - 1).max()


def test_at_low_frequency_the_array_is_the_sum_of_its_compliances():
    design = prototype("array-2x6")
    frequency = np.array([0.001])
    volume = 12 * design.resonator.cavity_volume
    volume += 2 * (design.microphone.chamber_volume + design.microphone.back_volume)
    volume += 2 * np.pi / 4 * design.microphone.sound_hole_diameter**2 * design.microphone.sound_hole_length
    tubes = 11 * [design.tube] + 2 * [design.microphone_tube]
    volume += sum(np.pi / 4 * tube.inner_diameter**2 * tube.length for tube in tubes)
    compliance = volume * 1e-9 / AIR.pressure + 12 * design_compliance(design, frequency)
    response = solve(design, frequency)
    np.testing.assert_allclose(
        1 / response.point_impedance, np.tile(2j * np.pi * frequency * compliance, (12, 1)), rtol=2e-3
    )


def test_a_symmetric_line_has_mirrored_responses():
    response = solve(prototype("array-2x6"))
    np.testing.assert_allclose(response.source_response, response.source_response[::-1, ::-1], rtol=1e-10)
    np.testing.assert_allclose(response.point_impedance, response.point_impedance[::-1], rtol=1e-10)


def test_the_place_where_tubes_are_cut_does_not_matter(monkeypatch):
    design = prototype("array-2x6")
    four_radii = solve(design)
    monkeypatch.setattr("geometry.design.STUB_LENGTH_IN_RADII", 2.5)
    monkeypatch.setattr("geometry.cells.STUB_LENGTH_IN_RADII", 2.5)
    assert design.tube.stub_length == pytest.approx(2.5 * design.tube.inner_diameter / 2)
    two_and_a_half = solve(design)
    np.testing.assert_allclose(two_and_a_half.source_response, four_radii.source_response, rtol=1e-9)
    np.testing.assert_allclose(two_and_a_half.point_impedance, four_radii.point_impedance, rtol=1e-9)


def test_tubes_that_are_nothing_but_their_stubs_join_the_cells_directly():
    design = prototype("array-2x6")
    shortest = {f"{name}.length": 4 * getattr(design, name).inner_diameter for name in ("tube", "microphone_tube")}
    walls = {"resonator.wall_thickness": 0.6, "membrane.rim_width": 0.5, "microphone.wall_thickness": 0.6}
    design = design.with_values(shortest | walls)
    response, direct = solve(design), every_node_at_once(design)
    reference = np.transpose(direct[:, 12:, :12], (2, 1, 0))
    np.testing.assert_allclose(response.source_response, reference, rtol=3e-5)


def test_216_points_at_64_frequencies_take_under_two_seconds():
    design = prototype("line-4")
    frequency = np.linspace(1, 100, 64)
    solve(design, frequency)  # the membrane is solved once
    start = time.perf_counter()
    response = solve(design, frequency)
    assert time.perf_counter() - start < 2
    assert response.source_response.shape == (216, 4, 64)


def test_a_missing_cell_or_a_wrong_shape_is_refused():
    design = prototype("array-2x6")
    layout = place(design)
    cells = {cell: lumped_admittance(cell, BAND, AIR) for cell in cell_catalogue(design, layout).distinct}
    first = next(iter(cells))
    with pytest.raises(ValueError, match=r"admittances lack the cell (resonator|microphone)"):
        solve_network(design, layout, {k: v for k, v in cells.items() if k != first}, BAND, AIR)
    with pytest.raises(ValueError, match=r"has shape \(6, 3, 3\), must be \(7, 3, 3\)"):
        solve_network(design, layout, {**cells, first: cells[first][1:]}, BAND, AIR)


def test_every_frequency_is_solved_on_its_own():
    design = prototype("fingertip-3x4")
    whole, part = solve(design), solve(design, BAND[[1, 4]])
    np.testing.assert_allclose(part.source_response, whole.source_response[..., [1, 4]], rtol=1e-12)
