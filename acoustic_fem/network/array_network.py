"""The whole array as a network of port admittances: cells, ducts, membranes, leaks, microphones.

Every line is a chain of two-ports. From both of its ends the chain is condensed point by point, all
frequencies at once; what remains is one small dense system of the microphone chambers. The cost is
proportional to the number of points.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from acoustic_fem.duct.plane_wave import CompliantWall, Line, port_admittance, two_port
from acoustic_fem.duct.sections import CircularSection
from acoustic_fem.membrane.disc import KnownDiscs, design_compliance
from acoustic_fem.network.microphone import load_admittance
from acoustic_fem.network.yielding import beside_air, sheath_compliance, soft_rubber
from acoustic_fem.quantities.medium import Medium
from acoustic_fem.quantities.units import metres
from geometry.air.cells import Cell, CellCatalogue, CellUse
from geometry.design.array_design import ArrayDesign
from geometry.layout.placement import ArrayLayout
from geometry.refusal import Refusal
from geometry.stated.parts import Tube

Array = NDArray[np.complex128]

#: A tube that is nothing but its two stubs still gets a duct this much of its length, so that its ends
#: stay two nodes.
_SHORTEST_DUCT = 1e-6


@dataclass(frozen=True, eq=False)
class NetworkResponse:
    """Pressures per unit volume velocity injected at one membrane."""

    source_response: Array
    """Pressure on the microphones, (n_point, n_microphone, n_freq) complex128, Pa s/m^3."""
    point_impedance: Array
    """Pressure in the cavity of the same point, (n_point, n_freq) complex128, Pa s/m^3."""
    microphone_impedance: Array
    """Pressure on one microphone per volume velocity injected at the front of another, (n_microphone, n_microphone,
    n_freq) complex128, Pa s/m^3; symmetric. Its real part is the thermal noise.
    """


class TwoPort(NamedTuple):
    """A reciprocal two-port: volume velocities into its ends per pressure there."""

    first: Array
    """Y11, (n_freq,) complex128, m^3/(Pa s)."""
    transfer: Array
    """Y12 = Y21, (n_freq,) complex128, m^3/(Pa s)."""
    last: Array
    """Y22, (n_freq,) complex128, m^3/(Pa s)."""


def join(left: TwoPort, right: TwoPort) -> TwoPort:
    """Two two-ports in series, their common node eliminated."""
    between = left.last + right.first
    return TwoPort(
        left.first - left.transfer**2 / between,
        -left.transfer * right.transfer / between,
        right.last - right.transfer**2 / between,
    )


def solve_network(
    design: ArrayDesign,
    layout: ArrayLayout,
    catalogue: CellCatalogue,
    admittances: Mapping[Cell, Array],
    frequency: NDArray[np.float64],
    medium: Medium,
    known: KnownDiscs | None = None,
) -> NetworkResponse:
    """Responses of all points at all microphones and frequencies.

    Args:
        design: the array.
        layout: its layout, from :func:`geometry.layout.arrangement.lay_out`.
        catalogue: its cells, from :func:`geometry.air.cells.cell_catalogue`.
        admittances: for every distinct cell its symmetric nodal admittance, (n_freq, k + 1, k + 1) complex128, m^3/(Pa
            s): the outer ends of its k stubs in the order of ``cell.ports``, then the opening.
        frequency: (n_freq,) float64, Hz.
        medium: the air.
        known: membranes that need not be solved.

    Raises:
        Refusal: a cell is missing or its admittance has the wrong shape.
    """
    kinds = [design.of_kind(kind) for kind in design.kinds]
    beside = np.stack(
        [beside_air(kind, design_compliance(kind, frequency, known), frequency, medium) for kind in kinds]
    )[list(design.kind_of_point)]
    ducts: dict[Tube, TwoPort] = {}
    lines = []
    for index, line in enumerate(design.lines):
        tubes = design.tubes_of(line)
        for tube in tubes:
            if tube not in ducts:
                ducts[tube] = _duct_between_stubs(design, tube, frequency, medium)
        points = [point for point, where in enumerate(layout.points) if where.line == index]
        points.sort(key=lambda point: layout.points[point].place)
        cells = np.stack([_at_place(catalogue.points[point], admittances, frequency) for point in points])
        cells[:, :, 2, 2] += beside[[layout.points[point].number - 1 for point in points]]
        lines.append((points, _Chain(cells, [ducts[tube] for tube in tubes])))

    impedance, ends, openings = _microphones(
        design, layout, catalogue.microphones, admittances, [chain.whole for _, chain in lines], frequency, medium
    )
    source_response = np.empty((len(layout.points), len(openings), len(frequency)), dtype=np.complex128)
    point_impedance = np.empty((len(layout.points), len(frequency)), dtype=np.complex128)
    for index, (points, chain) in enumerate(lines):
        at_ends = [ends[index, 0], ends[index, 1]]
        own, share = chain.own, chain.share
        outer = impedance[:, at_ends]
        point_impedance[points] = own + np.einsum("pfa,fab,pfb->pf", share, outer[:, :, at_ends], share)
        source_response[points] = np.einsum("pfa,fam->pmf", share, outer[:, :, openings])
    at_microphones = np.moveaxis(impedance[:, openings][:, :, openings], 0, -1)
    return NetworkResponse(source_response, point_impedance, at_microphones)


class _Chain:
    """A line between its two microphone chambers, membranes included.

    ``whole`` is the line as a two-port; ``own`` (n_point, n_freq) the impedance at each membrane while both ends are
    held at zero pressure; ``share`` (n_point, n_freq, 2) the cavity pressure per pressure at either end, by reciprocity
    also the volume velocity out of either end, held at zero pressure, per volume velocity injected.
    """

    def __init__(self, cells: Array, ducts: list[TwoPort]) -> None:
        count = len(cells)
        inner = cells[..., :2, 2]
        condensed = cells[..., :2, :2] - inner[..., :, None] * inner[..., None, :] / cells[..., 2:, 2:]
        passes = [TwoPort(cell[:, 0, 0], cell[:, 0, 1], cell[:, 1, 1]) for cell in condensed]
        before = [ducts[0]]
        for place in range(count - 1):
            before.append(join(join(before[place], passes[place]), ducts[place + 1]))
        after = [ducts[count]]
        for place in range(count - 1, 0, -1):
            after.append(join(join(ducts[place], passes[place]), after[-1]))
        after.reverse()
        self.whole = join(join(before[-1], passes[-1]), after[-1])

        local = cells.copy()
        local[..., 0, 0] += np.stack([part.last for part in before])
        local[..., 1, 1] += np.stack([part.first for part in after])
        at_opening = np.linalg.inv(local)[..., 2]
        self.own = at_opening[..., 2]
        self.share = -at_opening[..., :2] * np.stack(
            [np.stack([part.transfer for part in before]), np.stack([part.transfer for part in after])], -1
        )


def _duct_between_stubs(design: ArrayDesign, tube: Tube, frequency: NDArray[np.float64], medium: Medium) -> TwoPort:
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


def _line(line: Line, length: float, frequency: NDArray[np.float64], medium: Medium) -> TwoPort:
    series, shunt = line.series_impedance(frequency, medium), line.shunt_admittance(frequency, medium)
    return _as_two_port(two_port(series, shunt, length))


def _as_two_port(nodal: Array) -> TwoPort:
    return TwoPort(nodal[:, 0, 0], nodal[:, 0, 1], nodal[:, 1, 1])


def _at_place(use: CellUse, admittances: Mapping[Cell, Array], frequency: NDArray[np.float64]) -> Array:
    """Nodal admittance of a cell with its ports in the order of the place's tubes."""
    cell = use.cell
    if cell not in admittances:
        raise Refusal(f"admittances lack the cell {cell.label}")
    nodal = np.asarray(admittances[cell])
    size = len(cell.ports) + 1
    if nodal.shape != (len(frequency), size, size):
        raise Refusal(f"admittance of {cell.label} has shape {nodal.shape}, must be {(len(frequency), size, size)}")
    nodes = [*use.order, size - 1]
    return nodal[:, nodes][:, :, nodes]


def _microphones(
    design: ArrayDesign,
    layout: ArrayLayout,
    uses: tuple[CellUse, ...],
    admittances: Mapping[Cell, Array],
    lines: list[TwoPort],
    frequency: NDArray[np.float64],
    medium: Medium,
) -> tuple[Array, dict[tuple[int, int], int], list[int]]:
    """The chambers joined by the condensed lines.

    Returns:
        Impedance between their nodes (n_freq, n, n); node of each (line, end); node of each microphone's
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
    impedance = np.asarray(np.linalg.inv(nodal), dtype=np.complex128)
    return impedance, ends, [opening_of[name] for name in design.microphones]
