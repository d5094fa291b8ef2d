"""A whole array of three points in one mesh against cells joined by plane-wave ducts: the substructuring itself."""

import cadquery as cq
import numpy as np
import pytest
from reference_data import AIR

from acoustic_fem import duct
from acoustic_fem.cell import mesh_sizes
from acoustic_fem.condensed import condense
from acoustic_fem.design_cells import solve_cells
from acoustic_fem.navier_stokes import WallMotion
from geometry.cells import Cell, CellPort
from geometry.mesh import mesh_solid

BORE, RADIUS, HEIGHT, LENGTH = 0.5, 3.0, 2.5, 12.5  # mm
PITCH = 2 * RADIUS + LENGTH
FREQUENCY = np.array([1.0, 10.0, 100.0])
MEMBRANE, MICROPHONE = 1.2e-11, 5e-14  # m^3/Pa


def in_one_mesh():
    """Nodal admittance of both tube ends and the three membranes; one half of the array is meshed."""
    end = PITCH + RADIUS + LENGTH
    air = cq.Workplane("YZ").circle(BORE / 2).extrude(end, both=True).translate((0, 0, HEIGHT / 2))
    faces = {"A": (-end, 0.05, HEIGHT / 2), "B": (end, 0.05, HEIGHT / 2), "mirror": (0, 0, HEIGHT / 2)}
    radius = np.linspace(0, RADIUS, 200)
    profile = np.column_stack([radius, (1 - (radius / RADIUS) ** 2) ** 2])
    motions = []
    for k in (-1, 0, 1):
        air = air.union(cq.Workplane().circle(RADIUS).extrude(HEIGHT).translate((k * PITCH, 0, 0)))
        faces[f"membrane {k}"] = (k * PITCH, 0.1, HEIGHT)
        motions.append(WallMotion(f"membrane {k}", profile, (k * PITCH, 0, HEIGHT)))
    half = air.intersect(cq.Workplane().box(200, 50, 200).translate((0, 25, 0))).val()
    meshes = [mesh_solid(half, faces, ("A", "B"), sizes) for sizes in mesh_sizes(1.2, HEIGHT, AIR, FREQUENCY[-1])]
    band = (FREQUENCY[0], FREQUENCY[-1])
    return condense(*meshes, ("A", "B"), motions, "mirror", AIR, band).nodal_admittance(FREQUENCY)


def in_pieces():
    """The same nodes from one cell, used three times, and ducts."""
    cell = Cell(
        "resonator", 2 * RADIUS, HEIGHT, HEIGHT / 2, (CellPort(0.0, BORE), CellPort(180.0, BORE)), 2 * RADIUS, 0.0
    )
    nodal = solve_cells([cell], FREQUENCY, AIR)[cell].admittance
    stub = cell.ports[0].stub_length
    inner = duct.port_admittance(BORE / 2e3, (LENGTH - 2 * stub) * 1e-3, FREQUENCY, AIR)
    outer = duct.port_admittance(BORE / 2e3, (LENGTH - stub) * 1e-3, FREQUENCY, AIR)
    total = np.zeros((len(FREQUENCY), 11, 11), dtype=complex)  # A, B, membranes, then left and right ports
    entries = [([6 + 2 * c, 5 + 2 * c, 2 + c], nodal) for c in range(3)]
    entries += [([0, 5], outer), ([10, 1], outer), ([6, 7], inner), ([8, 9], inner)]
    for nodes, matrix in entries:
        total[np.ix_(range(len(FREQUENCY)), nodes, nodes)] += matrix
    kept, gone = slice(0, 5), slice(5, 11)
    return total[:, kept, kept] - total[:, kept, gone] @ np.linalg.solve(total[:, gone, gone], total[:, gone, kept])


def transfer_functions(nodal):
    """From each of the three membranes to a small volume at either end."""
    loaded = nodal.copy()
    for node, compliance in ((0, MICROPHONE), (1, MICROPHONE), (2, MEMBRANE), (3, MEMBRANE), (4, MEMBRANE)):
        loaded[:, node, node] += 2j * np.pi * FREQUENCY * compliance
    impedance = np.linalg.inv(loaded)
    return np.stack([impedance[:, m, p] / impedance[:, p, p] for p in (2, 3, 4) for m in (0, 1)], axis=1)


@pytest.mark.slow
def test_three_points_in_one_mesh_agree_with_cells_and_plane_waves_between_them():
    whole, pieces = transfer_functions(in_one_mesh()), transfer_functions(in_pieces())
    assert np.abs(pieces[-1]).min() < 0.6  # enough loss at 100 Hz for the comparison to say something
    ratio = whole / pieces
    assert np.abs(20 * np.log10(np.abs(ratio))).max() < 0.05
    assert np.abs(np.degrees(np.angle(ratio))).max() < 0.3
