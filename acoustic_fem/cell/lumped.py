"""A cell by closed forms: duct stubs with entrance losses around a cavity of uniform pressure."""

from __future__ import annotations

import numpy as np

from acoustic_fem.cavity.closed_forms import closed_cylinder_compliance
from acoustic_fem.cavity.shaped import shaped_cavity_compliance
from acoustic_fem.duct.plane_wave import port_admittance
from acoustic_fem.duct.tube_opening import entrance_impedance
from acoustic_fem.quantities.checks import FrequencyLike, frequencies
from acoustic_fem.quantities.local_air import AirLike, medium_of
from acoustic_fem.quantities.medium import Medium
from acoustic_fem.quantities.units import metres
from geometry.air.cells import Cell
from geometry.ground.typed import Array, ComplexArray


def lumped_admittance(cell: Cell, frequency: FrequencyLike, air: AirLike) -> ComplexArray:
    """Volume velocities into a cell per pressure at its nodes, in m^3/(Pa s).

    Against 3-D Navier-Stokes: 0.04 to 0.15 % in the two-port of a 6 x 2.5 mm cavity with tubes of 0.25 mm
    radius, 1 to 100 Hz. Valid while the cavity is far below the wavelength and much wider than the bores.

    Boxes and domes (1.6 x 1.3 and 6 x 2.5 mm, 1 to 100 Hz) are as near as cylinders of their size: 0.2 % of the
    bare cell's admittances in boxes and 0.8 % in domes, 0.07 % in the compliance. Where a bore meets a slanting
    wall its length is less certain: 1.3 % in the corner of a box, 3 % in a bowl that slants by 40 degrees.

    Args:
        cell: lengths in mm.
        frequency: (n_freq,) Hz.
        air: a :class:`acoustic_fem.LocalAir`, or a gas of its own.

    Returns:
        (n_freq, k + 1, k + 1) complex128 for k tubes: the outer ends of the stubs in the order of
        ``cell.ports``, then the opening: the cavity pressure under a membrane, or the far end of a sound hole.
    """
    medium, frequency = medium_of(air), frequencies(frequency)
    radius, height = metres(cell.diameter) / 2, metres(cell.height)
    if cell.shape is None:
        cavity = closed_cylinder_compliance(radius, height, frequency, medium)
    else:
        cavity = shaped_cavity_compliance(cell.shape, radius, height, frequency, medium)
    necks = [(port.bore_diameter, cell.bore_of(port)) for port in cell.ports]
    if cell.opening_length > 0:
        necks.append((cell.opening_diameter, cell.opening_length))

    size = len(necks) + 1  # the cavity is the last node
    nodal = np.zeros((len(frequency), size, size), dtype=np.complex128)
    nodal[:, -1, -1] = 2j * np.pi * frequency * cavity
    two_ports = {neck: _neck(metres(neck[0]) / 2, metres(neck[1]), frequency, medium) for neck in dict.fromkeys(necks)}
    for node, neck in enumerate(necks):
        two_port = two_ports[neck]
        nodal[:, node, node] = two_port[:, 0, 0]
        nodal[:, node, -1] = nodal[:, -1, node] = two_port[:, 0, 1]
        nodal[:, -1, -1] += two_port[:, 1, 1]
    if cell.opening_length > 0:
        inner = nodal[:, -1, :-1]
        nodal = nodal[:, :-1, :-1] - inner[:, :, None] * inner[:, None, :] / nodal[:, -1:, -1:]
    return nodal


def _neck(radius: float, length: float, frequency: Array, medium: Medium) -> ComplexArray:
    """Two-port of a duct whose second end opens into a cavity."""
    duct = port_admittance(radius, length, frequency, medium)
    own, transfer = duct[:, 0, 0], duct[:, 0, 1]
    opening = 1 / entrance_impedance(radius, frequency, medium)
    between = own + opening
    neck = np.empty_like(duct)
    neck[:, 0, 0] = own - transfer**2 / between
    neck[:, 0, 1] = neck[:, 1, 0] = transfer * opening / between
    neck[:, 1, 1] = own * opening / between
    return neck
