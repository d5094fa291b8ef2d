"""Tubes whose bore is that between the turns of a spring, against the ribbed line itself."""

import numpy as np
from joined_cells import library_of_cells

import acoustic_fem
from acoustic_fem.duct.coil_bore import CoilBore
from acoustic_fem.duct.plane_wave import port_admittance, two_port
from acoustic_fem.network import array_network
from acoustic_fem.network.chain_matrices import TwoPort, join
from geometry.air.cells import cell_catalogue
from geometry.design.design_file import prototype
from geometry.layout.arrangement import lay_out

BAND = np.array([1.0, 10.0, 100.0])
SMOOTH = {"tube.bore": "smooth", "microphone_tube.bore": "smooth"}


def ribbed_between_stubs(design, tube, frequency, medium):
    """Lip, spring and lip of a tube whose stubs, smooth and longer than the lips, belong to the cells."""
    lip = design.printing.port_lip
    coil = CoilBore(tube.spring_outer_diameter * 1e-3, tube.wire_diameter * 1e-3, refinement=6)
    z, y = coil.series_impedance(frequency, medium), coil.shunt_admittance(frequency, medium)
    spring = two_port(z, y, (tube.length - 2 * lip) * 1e-3)
    # a line of negative length takes away what the stub has beyond the lip
    beyond = -port_admittance(tube.inner_diameter * 5e-4, (tube.stub_length - lip) * 1e-3, frequency, medium)
    parts = [TwoPort(y[:, 0, 0], y[:, 0, 1], y[:, 1, 1]) for y in (beyond, spring, beyond)]
    return join(join(*parts[:2]), parts[2])


def test_the_smooth_tube_that_a_spring_counts_as_has_its_transfer_functions(monkeypatch):
    design = prototype("array-2x6")
    coil, smooth = (acoustic_fem.solve(design.with_values(each), BAND, "lumped") for each in ({}, SMOOTH))
    monkeypatch.setattr(array_network, "_duct_between_stubs", ribbed_between_stubs)
    ribbed = library_of_cells(design.with_values(SMOOTH), BAND).transfer_function.values
    assert np.abs(coil.transfer_function.values / ribbed - 1).max() < 0.004
    assert np.abs(smooth.transfer_function.values / ribbed - 1).max() > 0.1


def test_printed_bores_are_the_tubes_own_and_only_the_air_sees_wider_ones():
    design = prototype("array-2x6")
    smooth = design.with_values(SMOOTH)
    (air,), (plain,) = (
        {port.bore_diameter for cell in cell_catalogue(each, lay_out(each)).distinct for port in cell.ports}
        for each in (design, smooth)
    )
    assert (air, plain) == (design.tube.acoustic_diameter, 0.44)
    shells, housings = lay_out(design).points, lay_out(design).microphones
    printed = [*(each.ports for each in shells), *([end.port for end in each.ports] for each in housings)]
    assert {port.bore_diameter for ports in printed for port in ports} == {0.44}


def test_a_bore_on_the_floor_counts_as_wider_above_it():
    design = prototype("array-2x6").with_values({"resonator.port_height": 0.22})
    cells = cell_catalogue(design, lay_out(design)).distinct
    assert {cell.port_height for cell in cells if cell.kind == "resonator"} == {design.tube.acoustic_diameter / 2}
