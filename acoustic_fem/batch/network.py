"""Responses of many designs at once, with gradients: the lumped network on NumPy arrays or torch tensors.

Nodes are the cavities and the microphone chambers. A chain is folded from both ends, one point at a time, by
the star-mesh rule on series and shunt admittances, which only adds, multiplies and divides numbers of
positive real part: no cancellation, also where all pressures become equal at low frequency. The cost is
proportional to the number of points; designs, frequencies and lines of equal length are vectorised.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, fields
from functools import partial
from types import ModuleType
from typing import Any, NamedTuple

from acoustic_fem.batch.elements import Chambers, Conditions, Points, Tubes, chambers, points, tubes
from acoustic_fem.batch.numpy_or_torch import inverse, namespace
from acoustic_fem.batch.openings import check_openings, open_parts, opening_columns
from acoustic_fem.batch.parameters import ArrayParameters, MediumParameters, check_medium, check_parameters
from acoustic_fem.batch.topology import LineWiring, Topology
from acoustic_fem.quantities.checks import FrequencyLike, frequency_grid
from acoustic_fem.quantities.fidelity import CLOSED_FORMS
from acoustic_fem.quantities.local_air import AirLike, medium_of
from acoustic_fem.quantities.medium import Medium
from geometry.ground.argument_checks import out_of_range
from geometry.ground.typed import Array, NumpyOrTorch

#: Values per array worked on at once (designs x points x frequencies): larger leaves the processor's cache.
_CHUNK = 100_000
#: Values in one call from which on torch forgets what lies between and computes it again for the gradient:
#: a graph takes about 1.5 kB per value.
_LARGEST_GRAPH = 1_500_000


@dataclass(frozen=True, eq=False)
class BatchResponse:
    """Pressures per unit volume velocity injected at one membrane or microphone."""

    source_response: NumpyOrTorch
    """Pressure on the microphones, (n_design, n_point, n_microphone, n_freq) complex128, Pa s/m^3."""
    point_impedance: NumpyOrTorch
    """Pressure in the cavity of the same point, (n_design, n_point, n_freq) complex128, Pa s/m^3."""
    microphone_impedance: NumpyOrTorch
    """Pressure on one microphone per volume velocity injected at the front of another, (n_design, n_microphone,
    n_microphone, n_freq) complex128, Pa s/m^3.
    """

    @property
    def transfer_function(self) -> NumpyOrTorch:
        """Microphone pressure per pressure in the touched cavity, (n_design, n_point, n_microphone, n_freq), Pa/Pa."""
        return self.source_response * inverse(self.point_impedance)[:, :, None]


def batch_transfer_function(
    parameters: ArrayParameters,
    topology: Topology,
    frequency: FrequencyLike,
    air: AirLike | MediumParameters,
    fidelity: str = "lumped",
) -> NumpyOrTorch:
    """Transfer functions of a batch of designs.

    The frequency is (n_freq,) in Hz; arguments and errors as :func:`batch_response`.

    Returns:
        (n_design, n_point, n_microphone, n_freq) complex128, Pa/Pa; points line by line.
    """
    medium = air if isinstance(air, MediumParameters) else medium_of(air)
    return batch_response(parameters, topology, frequency, medium, fidelity).transfer_function


def batch_response(
    parameters: ArrayParameters,
    topology: Topology,
    frequency: FrequencyLike,
    air: AirLike | MediumParameters,
    fidelity: str = "lumped",
) -> BatchResponse:
    """Responses of a batch of designs of one topology in closed form, as :func:`acoustic_fem.solve` computes them.

    Torch tensors give tensors and can be differentiated by every parameter and by the air (first derivatives;
    second ones are refused by torch where they pass through a cavity that is not interpolated,
    :mod:`acoustic_fem.batch.interpolation`). Large batches are worked on in blocks; with gradients one of more
    than 1.5 million values (points x frequencies x designs) is computed a second time, block by block, on the
    way back, so that memory stays that of the results. Validity and warnings as the lumped fidelity.

    Args:
        parameters: of the designs.
        topology: their wiring, with the columns the parameters have.
        frequency: (n_freq,) float64, ascending, 1e-3 to 2e3 Hz; 0 is refused: there all pressures are equal, H = 1.
        air: the air of all, or of each design.
        fidelity: "lumped", or "atlas" with what 3-D adds to cells of cylindrical cavities.

    Raises:
        Refusal: a bad frequency grid, parameters that do not fit the topology or are out of range, or a design outside
            the atlas.
    """
    grid, medium, count = _checked(parameters, topology, frequency, air, fidelity)
    xp = parameters.namespace
    omega = xp.asarray(2 * math.pi * grid, device=parameters.tube_radius.device)
    step = max(1, _CHUNK // (topology.point_count * len(grid)))
    blocks = -(-count // step)

    def block(first: int) -> tuple[NumpyOrTorch, NumpyOrTorch, NumpyOrTorch]:
        air = Conditions.of(omega, _rows(medium, first, step), blocks)
        return _respond(_rows(parameters, first, step), topology, air, min(step, count - first), fidelity)

    work: Callable[[int], tuple[NumpyOrTorch, NumpyOrTorch, NumpyOrTorch]] = block
    if blocks * _CHUNK > _LARGEST_GRAPH and parameters.needs_gradient:
        from torch.utils.checkpoint import checkpoint

        work = partial(checkpoint, block, use_reentrant=False)
    pieces = [work(first) for first in range(0, count, step)]
    return BatchResponse(*(_joined(xp, dict(enumerate(parts)), 0) for parts in zip(*pieces, strict=True)))


def each_alone(
    parameters: ArrayParameters,
    topology: Topology,
    frequency: FrequencyLike,
    air: AirLike | MediumParameters,
    fidelity: str = "lumped",
) -> list[BatchResponse]:
    """Responses of every design of a batch as if it were alone in it, to the last bit.

    :func:`batch_response` interpolates means and sums series with as many terms as any design of the batch needs, so a
    design there differs by rounding errors from what it has in another batch. Here every design has a pass of its own.
    A pass takes three to four times as long as its part of a batch, and less if earlier designs had equal cavities,
    because the latest means are kept. Arguments and errors as :func:`batch_response`, NumPy arrays only.

    Returns:
        A batch of one for every design, in their order.
    """
    grid, medium, count = _checked(parameters, topology, frequency, air, fidelity)
    omega = 2 * math.pi * grid
    return [
        BatchResponse(
            *_respond(
                _rows(parameters, number, 1), topology, Conditions.of(omega, _gas(medium, number), 0), 1, fidelity
            )
        )
        for number in range(count)
    ]


def _checked(
    parameters: ArrayParameters,
    topology: Topology,
    frequency: FrequencyLike,
    air: AirLike | MediumParameters,
    fidelity: str,
) -> tuple[Array, Medium | MediumParameters, int]:
    """Frequencies (Hz), the gas of all or of each, and the number of designs, once all arguments fit together."""
    medium = air if isinstance(air, MediumParameters) else medium_of(air)
    grid = frequency_grid(frequency)
    if fidelity not in CLOSED_FORMS:
        raise out_of_range("fidelity", fidelity, f"one of {', '.join(CLOSED_FORMS)} in a batch")
    check_parameters(parameters, topology)
    if fidelity == "atlas":
        check_openings(parameters, topology, grid, medium)
    count = parameters.design_count
    if isinstance(medium, MediumParameters):
        count = check_medium(medium, count, parameters.namespace)
    return grid, medium, count


def _gas(medium: Medium | MediumParameters, number: int) -> Medium:
    """The gas of one design."""
    if isinstance(medium, Medium):
        return medium
    row = _rows(medium, number, 1)
    return Medium(**{field.name: float(getattr(row, field.name)[0]) for field in fields(row)})


class _Chain(NamedTuple):
    """Lines of equal length between grounded ends; arrays (n_design, n_line, ...)."""

    series: NumpyOrTorch
    """Admittance of the whole line between its ends, (n_design, n_line, n_freq)."""
    shunts: tuple[NumpyOrTorch, NumpyOrTorch]
    """Admittances of the whole line to ground at its first and last end, (n_design, n_line, n_freq)."""
    own: NumpyOrTorch
    """Impedance at each point while both ends are at zero pressure, (n_design, n_line, n_point, n_freq)."""
    first: NumpyOrTorch
    """Pressure at each point per pressure at the first end, the last at zero; shaped as ``own``."""
    last: NumpyOrTorch
    """Pressure at each point per pressure at the last end, the first at zero; shaped as ``own``."""


def _respond(
    parameters: ArrayParameters, topology: Topology, air: Conditions, count: int, fidelity: str
) -> tuple[NumpyOrTorch, NumpyOrTorch, NumpyOrTorch]:
    if fidelity == "atlas":
        tube, point, chamber = open_parts(parameters, topology, air)
        topology = opening_columns(topology).topology
    else:
        tube, point, chamber = tubes(parameters, air), points(parameters, air), chambers(parameters, air)
    found = join_parts(topology, tube, point, chamber, count)
    return found.source_response, found.point_impedance, found.microphone_impedance


def join_parts(topology: Topology, tube: Tubes, point: Points, chamber: Chambers, count: int) -> BatchResponse:
    """Responses of arrays whose parts are known.

    Args:
        topology: the wiring, with the columns the parts have.
        tube: the tubes, (n_design, n_tube_column, n_freq) or with one row for all designs.
        point: the cavities and what yields around them, in columns of points.
        chamber: the chambers, in columns of microphones.
        count: number of designs.
    """
    xp = namespace(tube.series)
    tube = Tubes(*(_all_designs(xp, values, count) for values in tube))
    point = Points(*(None if values is None else _all_designs(xp, values, count) for values in point))
    chamber = Chambers(*(_parts(values, topology.microphones) for values in chamber))
    groups: dict[int, list[int]] = {}
    for number, line in enumerate(topology.lines):
        groups.setdefault(len(line.points), []).append(number)
    chains = [
        (members, _fold(xp, [topology.lines[k] for k in members], tube, point.shunt)) for members in groups.values()
    ]

    grounds = [chamber.shunt[:, number] for number in range(len(topology.microphones))]
    series: dict[tuple[int, int], NumpyOrTorch] = {}
    for members, chain in chains:
        for place, number in enumerate(members):
            line, of_line = topology.lines[number], (slice(None), min(place, chain.series.shape[1] - 1))
            grounds[line.first] = grounds[line.first] + chain.shunts[0][of_line]
            grounds[line.last] = grounds[line.last] + chain.shunts[1][of_line]
            _add(series, (min(line.first, line.last), max(line.first, line.last)), chain.series[of_line])
    impedance = impedance_between(xp, grounds, series)
    received = impedance * chamber.ratio[:, None]  # (design, chamber, microphone, freq)

    sources, at_points = {}, {}
    for members, chain in chains:
        ends = [topology.lines[k].first for k in members], [topology.lines[k].last for k in members]
        near, far = (received[:, end][:, :, None] for end in ends)
        source = chain.first[:, :, :, None] * near + chain.last[:, :, :, None] * far
        own, across, opposite = (
            impedance[:, a, b][:, :, None] for a, b in ((ends[0], ends[0]), (ends[0], ends[1]), (ends[1], ends[1]))
        )
        at_point = chain.first * (chain.first * own + chain.last * (2 * across)) + chain.last * chain.last * opposite
        at_point = chain.own + at_point
        if point.ratio is not None:
            columns = [[topology.lines[k].points[place] for k in members] for place in range(at_point.shape[2])]
            ratio, own = (xp.stack([_parts(values, each) for each in columns], 2) for values in point[1:])
            source, at_point = ratio[:, :, :, None] * source, ratio * ratio * at_point + own
        for place, number in enumerate(members):
            sources[number], at_points[number] = source[:, place], at_point[:, place]
    diagonal = xp.eye(len(topology.microphones), dtype=xp.float64, device=tube.series.device)[..., None]
    at_microphones = received * chamber.ratio[:, :, None] + diagonal * chamber.own[:, None]
    return BatchResponse(_joined(xp, sources, 1), _joined(xp, at_points, 1), at_microphones)


def _fold(xp: ModuleType, lines: list[LineWiring], tube: Tubes, point: NumpyOrTorch) -> _Chain:
    """Lines with the same number of points, folded from both ends; once for lines that are all alike."""
    if len({(line.tubes, line.points) for line in lines}) == 1:
        lines = lines[:1]
    count = len(lines[0].points)
    tube_at = [[line.tubes[place] for line in lines] for place in range(count + 1)]
    series = [_parts(tube.series, columns) for columns in tube_at]
    first, last = ([_parts(values, columns) for columns in tube_at] for values in (tube.first, tube.last))
    load = [_parts(point, [line.points[place] for line in lines]) for place in range(count)]

    # what lies before each point, as a series admittance to the first end and a ground at the point; the
    # ground it leaves at the first end
    before, grounds_before, at_first = [series[0]], [last[0] + load[0]], first[0]
    for place in range(count):
        ground = grounds_before[place] + first[place + 1]
        through, at_next, left = _star_mesh(before[place], ground, series[place + 1])
        at_first = at_first + left
        before.append(through)
        grounds_before.append(at_next + last[place + 1] + (load[place + 1] if place + 1 < count else 0))
    after, grounds_after = [series[count]], [first[count]]
    for place in range(count - 1, 0, -1):
        through, at_next, _ = _star_mesh(after[-1], grounds_after[-1] + load[place] + last[place], series[place])
        after.append(through)
        grounds_after.append(at_next + first[place])

    near, far = xp.stack(before[:-1], 2), xp.stack(after[::-1], 2)
    own = inverse(near + far + xp.stack(grounds_before[:-1], 2) + xp.stack(grounds_after[::-1], 2))
    return _Chain(before[-1], (at_first, grounds_before[-1]), own, near * own, far * own)


def _star_mesh(
    first: NumpyOrTorch, ground: NumpyOrTorch, last: NumpyOrTorch
) -> tuple[NumpyOrTorch, NumpyOrTorch, NumpyOrTorch]:
    """A node with admittances to two others and to ground, eliminated.

    Returns:
        The admittance between the two, and the grounds left at the last and at the first.
    """
    total = inverse(first + ground + last)
    share = ground * total
    return first * (last * total), last * share, first * share


def impedance_between(
    xp: ModuleType, grounds: list[NumpyOrTorch], series: dict[tuple[int, int], NumpyOrTorch]
) -> NumpyOrTorch:
    """Impedance between nodes with admittances to ground and between them: (n_design, n, n, n_freq).

    Nodes are eliminated from the last to the first and put back, by the star-mesh rule.
    """
    grounds, series = list(grounds), dict(series)
    shares: list[tuple[NumpyOrTorch, dict[int, NumpyOrTorch]]] = []
    for node in range(len(grounds) - 1, 0, -1):
        joined = {other: series.pop((other, node)) for other in range(node) if (other, node) in series}
        held = inverse(sum(joined.values(), grounds[node]))
        share = {other: admittance * held for other, admittance in joined.items()}
        for other, admittance in joined.items():
            grounds[other] = grounds[other] + share[other] * grounds[node]
            for third in range(other + 1, node):
                if third in share:
                    _add(series, (other, third), admittance * share[third])
        shares.append((held, share))
    rows = [[inverse(grounds[0])]]
    for held, share in reversed(shares):
        new = [
            _total([part * rows[max(k, other)][min(k, other)] for other, part in share.items()])
            for k in range(len(rows))
        ]
        own = held + _total([part * new[other] for other, part in share.items()])
        rows.append([*new, own])
    size = range(len(rows))
    return xp.stack([xp.stack([rows[max(i, k)][min(i, k)] for k in size], 1) for i in size], 1)


def _total(values: list[NumpyOrTorch]) -> NumpyOrTorch:
    return sum(values[1:], values[0])


def _add(series: dict[tuple[int, int], NumpyOrTorch], pair: tuple[int, int], admittance: NumpyOrTorch) -> None:
    series[pair] = series[pair] + admittance if pair in series else admittance


def _parts(values: NumpyOrTorch, columns: Sequence[int]) -> NumpyOrTorch:
    """(n_design, n_part, n_freq): the columns of the parts, a view where it is only one part."""
    return values[:, columns[0] : columns[0] + 1] if len(columns) == 1 else values[:, list(columns)]


def _all_designs(xp: ModuleType, values: NumpyOrTorch, count: int) -> NumpyOrTorch:
    return xp.broadcast_to(values, (count, *values.shape[1:]))


def _joined(xp: ModuleType, arrays: Mapping[int, NumpyOrTorch], axis: int) -> NumpyOrTorch:
    """Arrays put after each other in the order of their numbers."""
    return arrays[0] if len(arrays) == 1 else xp.concatenate([arrays[number] for number in sorted(arrays)], axis)


def _rows(values: Any, first: int, step: int) -> Any:
    """The designs from ``first`` on; what is common to all stays."""
    if isinstance(values, Medium):
        return values
    named = {field.name: getattr(values, field.name) for field in fields(values)}
    return type(values)(**{k: v if v.shape[0] == 1 else v[first : first + step] for k, v in named.items()})
