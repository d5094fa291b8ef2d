"""The whole array as a network of port admittances: cells, ducts, membranes, leaks, microphones.

Every line is condensed to a two-port (:mod:`acoustic_fem.network.chain_matrices`); what remains is one small dense
system of the microphone chambers. The cost is proportional to the number of points.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from acoustic_fem.duct.plane_wave import CompliantWall, Line, port_admittance, two_port
from acoustic_fem.duct.sections import CircularSection
from acoustic_fem.membrane.design_discs import design_compliance
from acoustic_fem.membrane.disc import KnownDiscs
from acoustic_fem.network.chain_matrices import PointCell, TwoPort, chains_of, join
from acoustic_fem.network.microphone import load_admittance
from acoustic_fem.network.yielding import beside_air, sheath_compliance, soft_rubber
from acoustic_fem.quantities.checks import FrequencyLike, frequencies
from acoustic_fem.quantities.local_air import AirLike, medium_of
from acoustic_fem.quantities.medium import Medium
from acoustic_fem.quantities.units import metres
from geometry.air.cells import Cell, CellCatalogue, CellUse
from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import DesignLike, resolve_design
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array, ComplexArray
from geometry.layout.placement import Housings
from geometry.schema.part_fields import Tube

#: A tube that is nothing but its two stubs still gets a duct this much of its length, so that its ends
#: stay two nodes.
_SHORTEST_DUCT = 1e-6


@dataclass(frozen=True, eq=False)
class NetworkResponse:
    """Pressures per unit volume velocity injected at one membrane."""

    source_response: ComplexArray
    """Pressure on the microphones, (n_point, n_microphone, n_freq) complex128, Pa s/m^3."""
    point_impedance: ComplexArray
    """Pressure in the cavity of the same point, (n_point, n_freq) complex128, Pa s/m^3."""
    microphone_impedance: ComplexArray
    """Pressure on one microphone per volume velocity injected at the front of another, (n_microphone, n_microphone,
    n_freq) complex128, Pa s/m^3; symmetric. Its real part is the thermal noise.
    """


def solve_network(
    design: DesignLike,
    layout: Housings,
    catalogue: CellCatalogue,
    admittances: Mapping[Cell, ComplexArray],
    frequency: FrequencyLike,
    air: AirLike,
    known: KnownDiscs | None = None,
) -> NetworkResponse:
    """Responses of all points at all microphones and frequencies.

    Args:
        design: the array.
        layout: where its parts lie, from :func:`geometry.layout.arrangement.place_housings`.
        catalogue: its cells, from :func:`geometry.air.cells.cell_catalogue`.
        admittances: for every distinct cell its symmetric nodal admittance, (n_freq, k + 1, k + 1) complex128, m^3/(Pa
            s): the outer ends of its k stubs in the order of ``cell.ports``, then the opening.
        frequency: (n_freq,) float64, Hz.
        air: a :class:`acoustic_fem.LocalAir`, or a gas of its own.
        known: membranes that need not be solved.

    Raises:
        Refusal: a cell is missing or its admittance has the wrong shape.
    """
    design = resolve_design(design)
    medium, frequency = medium_of(air, design), frequencies(frequency)
    kinds = [design.of_kind(kind) for kind in design.kinds]
    beside = np.stack(
        [beside_air(kind, design_compliance(kind, frequency, known), frequency, medium) for kind in kinds]
    )
    loaded, cell_of_point = _loaded_cells(design, catalogue.points, admittances, beside, frequency)
    ducts, duct_at = _ducts(design, frequency, medium)
    first_point = np.cumsum([0, *(line.points for line in design.lines)])
    points_of = [slice(start, stop) for start, stop in pairwise(first_point)]
    chains = chains_of(
        loaded, ducts, [(cell_of_point[points], at) for points, at in zip(points_of, duct_at, strict=True)]
    )
    impedance, ends, openings = _microphones(
        design, layout, catalogue.microphones, admittances, [chain.whole for chain in chains], frequency, medium
    )
    source_response = np.empty((len(layout.points), len(openings), len(frequency)), dtype=np.complex128)
    point_impedance = np.empty((len(layout.points), len(frequency)), dtype=np.complex128)
    for index, (points, chain) in enumerate(zip(points_of, chains, strict=True)):
        near, far = ends[index, 0], ends[index, 1]
        first, second = chain.share
        at_near, at_far = (first * impedance[near, end] + second * impedance[far, end] for end in (near, far))
        point_impedance[points] = chain.own + first * at_near + second * at_far
        source_response[points] = first[:, None] * impedance[near, openings]
        source_response[points] += second[:, None] * impedance[far, openings]
    return NetworkResponse(source_response, point_impedance, impedance[openings][:, openings])


def _loaded_cells(
    design: ArrayDesign,
    uses: tuple[CellUse, ...],
    admittances: Mapping[Cell, ComplexArray],
    beside: ComplexArray,
    frequency: Array,
) -> tuple[PointCell, list[int]]:
    """The points' cells that differ, (n, n_freq), with what yields beside their air, and which of them each point has.

    Uses that are the same object are one; equal ones that are not cost time alone.
    """
    alike: dict[tuple[int, int], int] = {}
    which = [
        alike.setdefault((id(use), kind), len(alike)) for use, kind in zip(uses, design.kind_of_point, strict=True)
    ]
    first_use = [which.index(cell) for cell in range(len(alike))]
    nodal = np.stack([_at_place(uses[point], admittances, frequency) for point in first_use])
    nodal[..., 2, 2] += beside[[design.kind_of_point[point] for point in first_use]]
    pairs = ((0, 0), (0, 1), (1, 1), (0, 2), (1, 2), (2, 2))
    return PointCell(*(nodal[..., row, column] for row, column in pairs)), which


def _ducts(design: ArrayDesign, frequency: Array, medium: Medium) -> tuple[TwoPort, list[list[int]]]:
    """The ducts that differ, (n, n_freq), and per line which of them lie along it."""
    alike: dict[Tube, int] = {}
    at = [[alike.setdefault(tube, len(alike)) for tube in design.tubes_of(line)] for line in design.lines]
    parts = [_duct_between_stubs(design, tube, frequency, medium) for tube in alike]
    return TwoPort(*(np.stack(entry) for entry in zip(*parts, strict=True))), at


def _duct_between_stubs(design: ArrayDesign, tube: Tube, frequency: Array, medium: Medium) -> TwoPort:
    length, radius = tube.acoustic_length(design.printing.port_lip), metres(tube.acoustic_diameter) / 2
    if tube.sheath_material is None:
        between = max(length - 2 * tube.stub_length, _SHORTEST_DUCT * tube.length)
        return _as_two_port(port_admittance(radius, metres(between), frequency, medium))
    rigid = CircularSection(radius)
    compliance = sheath_compliance(design, tube) / soft_rubber(design, tube.sheath_material).ratio(frequency)
    soft = _line(CompliantWall(rigid, compliance), metres(length), frequency, medium)
    # The whole of the tube yields, the stubs in the cells do not: lines of negative length take these away.
    stub = TwoPort(*(-part for part in _line(rigid, metres(tube.stub_length), frequency, medium)))
    return join(join(stub, soft), stub)


def _line(line: Line, length: float, frequency: Array, medium: Medium) -> TwoPort:
    series, shunt = line.series_impedance(frequency, medium), line.shunt_admittance(frequency, medium)
    return _as_two_port(two_port(series, shunt, length))


def _as_two_port(nodal: ComplexArray) -> TwoPort:
    return TwoPort(nodal[:, 0, 0], nodal[:, 0, 1], nodal[:, 1, 1])


def _at_place(use: CellUse, admittances: Mapping[Cell, ComplexArray], frequency: Array) -> ComplexArray:
    """Nodal admittance of a cell with its ports in the order of the place's tubes."""
    cell = use.cell
    if cell not in admittances:
        raise Refusal(f"lack the cell {cell.label}", kind=Kind.MISSING, field="admittances")
    nodal = np.asarray(admittances[cell])
    size = len(cell.ports) + 1
    if nodal.shape != (len(frequency), size, size):
        problem = f"of {cell.label} has shape {nodal.shape}, must be {(len(frequency), size, size)}"
        raise Refusal(problem, kind=Kind.MISMATCH, field="admittances")
    nodes = [*use.order, size - 1]
    return nodal[:, nodes][:, :, nodes]


def _microphones(
    design: ArrayDesign,
    layout: Housings,
    uses: tuple[CellUse, ...],
    admittances: Mapping[Cell, ComplexArray],
    lines: list[TwoPort],
    frequency: Array,
    medium: Medium,
) -> tuple[ComplexArray, dict[tuple[int, int], int], list[int]]:
    """The chambers joined by the condensed lines.

    Returns:
        Impedance between their nodes (n, n, n_freq); node of each (line, end); node of each microphone's
        opening, in the order of ``design.microphones``.
    """
    size = sum(len(use.order) + 1 for use in uses)
    nodal = np.zeros((len(frequency), size, size), dtype=np.complex128)
    load = load_admittance(design.microphone, frequency, medium)
    ends: dict[tuple[int, int], int] = {}
    opening_of: dict[str, int] = {}
    start = 0
    for housing, use in zip(layout.microphones, uses, strict=True):
        stop = start + len(use.order) + 1
        nodal[:, start:stop, start:stop] += _at_place(use, admittances, frequency)
        nodal[:, stop - 1, stop - 1] += load
        opening_of[housing.name] = stop - 1
        for node, port in enumerate(housing.ports, start):
            ends[port.line, port.end] = node
        start = stop
    for index, whole in enumerate(lines):
        first, last = ends[index, 0], ends[index, 1]
        nodal[:, first, first] += whole.first
        nodal[:, last, last] += whole.last
        nodal[:, first, last] += whole.transfer
        nodal[:, last, first] += whole.transfer
    impedance = np.ascontiguousarray(np.moveaxis(np.linalg.inv(nodal), 0, -1))
    return impedance, ends, [opening_of[name] for name in design.microphones]
