"""The network of an array solved as a whole: every node of it in one dense matrix, nothing condensed."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from acoustic_fem.cell.lumped import lumped_admittance
from acoustic_fem.duct.plane_wave import port_admittance
from acoustic_fem.membrane.design_discs import design_compliance
from acoustic_fem.network.microphone import load_admittance
from acoustic_fem.quantities.medium import Medium
from geometry.air.cells import cell_catalogue
from geometry.layout.arrangement import lay_out

AIR = Medium.at(20, 0.5)


def every_node_at_once(design, frequency, cut=None, admittances=None):
    """Impedance between all points and all microphones by one dense solve: (n_freq, n, n), points first.

    Ducts of length zero join their nodes exactly; ``cut`` divides every other in two at that fraction.
    Nothing is taken to be symmetric. Cells are lumped unless their admittances are given.
    """
    layout = lay_out(design)
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
            length = tube.acoustic_length(design.printing.port_lip) - 2 * tube.stub_length
            pair = [node((index, segment, side)) for side in (0, 1)]
            tubes_of[index, segment] = pair
            if length > 1e-12:
                nodes = pair if cut is None else [pair[0], node((index, segment, "cut")), pair[1]]
                shares = [1.0] if cut is None else [cut, 1 - cut]
                for ends, share in zip(pairwise(nodes), shares, strict=True):
                    duct = port_admittance(tube.acoustic_diameter * 5e-4, share * length * 1e-3, frequency, AIR)
                    entries.append((list(ends), duct))
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
