"""Arrays of which one part is off, each part in turn: chains are multiplied out once, not once for every part.

A tube is a transfer matrix [[1 + Z last, Z], [C, 1 + Z first]] with Z the inverse of its series admittance and C =
first + last (1 + Z first), a point that of its shunt. The entry B of the product of all matrices
between a point and an end of its line is the inverse of the series admittance between them. If one part is off, B
changes by a row of the matrices before it times the change of its matrix times a column of the matrices behind it: rows
and columns are the same for all parts. A - 1 and D - 1 are carried along, so that nothing cancels at low frequency.
"""

from __future__ import annotations

from collections.abc import Sequence
from types import ModuleType
from typing import NamedTuple

from acoustic_fem.batch.elements import Chambers, Tubes
from acoustic_fem.batch.network import impedance_between
from acoustic_fem.batch.numpy_or_torch import inverse, namespace
from acoustic_fem.batch.topology import LineWiring, Topology
from geometry.ground.typed import NumpyOrTorch


class PartsOff(NamedTuple):
    """Parts in the columns of a topology, as designed and with their deviations."""

    tubes: tuple[Tubes, Tubes]
    """As designed, and off."""
    shunts: tuple[NumpyOrTorch, ...]
    """Shunts of the points, (n_design, n_column, n_freq) each: as designed, with each deviation that a point has alone,
    and with that which all have together."""
    chambers: tuple[Chambers, Chambers]
    """As designed, and off."""


def one_part_off(topology: Topology, parts: PartsOff) -> tuple[NumpyOrTorch, ...]:
    """Pressures at each microphone from a source at each point, up to a factor that all microphones have in common.

    Args:
        topology: the wiring, with the columns that the parts have.
        parts: what is off, each in turn.

    Returns:
        For each microphone (n_design, n_sensor, n_point, n_freq) complex128. The first sensor is as designed; then line
        by line, one tube after the other is off, one point after the other by each of its deviations; then each
        chamber; in the last, all points together.
    """
    xp = namespace(parts.shunts[0])
    microphones, deviations = len(topology.microphones), len(parts.shunts) - 2
    own = [len(line.tubes) + deviations * len(line.points) for line in topology.lines]
    chains = [
        _chain(xp, line, parts, 1 + sum(own[:number]), sum(own[number + 1 :]) + microphones)
        for number, line in enumerate(topology.lines)
    ]
    grounds: list[NumpyOrTorch] = []
    ratios: list[NumpyOrTorch] = []
    for number, column in enumerate(topology.microphones):
        off = [0] * (2 + sum(own) + microphones)
        off[1 + sum(own) + number] = 1
        for name, found in (("shunt", grounds), ("ratio", ratios)):
            found.append(xp.stack([getattr(each, name)[:, column] for each in parts.chambers], 1)[:, off])
    series: dict[tuple[int, int], NumpyOrTorch] = {}
    for line, chain in zip(topology.lines, chains, strict=True):
        between = min(line.first, line.last), max(line.first, line.last)
        series[between] = series[between] + chain.series if between in series else chain.series
        grounds[line.first] = grounds[line.first] + chain.first
        grounds[line.last] = grounds[line.last] + chain.last
    impedance = impedance_between(xp, grounds, series)

    def pressure(microphone: int) -> NumpyOrTorch:
        received = impedance[:, :, microphone] * ratios[microphone][:, None]  # from each end
        lines = [
            chain.to_last * received[:, line.first][:, :, None] + chain.to_first * received[:, line.last][:, :, None]
            for line, chain in zip(topology.lines, chains, strict=True)
        ]
        return lines[0] if len(lines) == 1 else xp.concatenate(lines, 2)

    return tuple(map(pressure, range(microphones)))


class _Chain(NamedTuple):
    """A line in all sensors."""

    series: NumpyOrTorch
    """Admittance between its ends, (n_design, n_sensor, n_freq)."""
    first: NumpyOrTorch
    """Admittance to ground at its first end, shaped as ``series``."""
    last: NumpyOrTorch
    """Admittance to ground at its last end, shaped as ``series``."""
    to_first: NumpyOrTorch
    """Inverse of the series admittance from each point to the first end, (n_design, n_sensor, n_point, n_freq)."""
    to_last: NumpyOrTorch
    """The same to the last end, shaped as ``to_first``."""


class _Links(NamedTuple):
    """Transfer matrices of tubes one after the other, (2, n_design, n_tube, n_freq) each.

    Along the first axis the way is that of the line, and backwards.
    """

    a: NumpyOrTorch
    """A - 1."""
    b: NumpyOrTorch
    """B."""
    c: NumpyOrTorch
    """C."""
    d: NumpyOrTorch
    """D - 1."""


def _chain(xp: ModuleType, line: LineWiring, parts: PartsOff, before: int, behind: int) -> _Chain:
    """A line which is as designed in so many sensors before and behind those in which a part of it is off."""
    columns, count = list(line.tubes), len(line.points)
    designed, off = (_links(xp, Tubes(*(values[:, columns] for values in tube))) for tube in parts.tubes)
    change = _Links(*(one - other for one, other in zip(off, designed, strict=True)))
    loads, *others, together = (_both_ways(xp, values[:, list(line.points)]) for values in parts.shunts)
    nominal, followed = _from_the_end(xp, designed, loads)
    off_alone = _each_off(xp, designed, change, loads, [each - loads for each in others], nominal, followed)
    all_off = _from_the_end(xp, designed, together)[0]
    ways = []
    for way in (0, 1):  # backwards the parts come in the opposite order
        each = [group[::-1] if way else group for group in off_alone]
        own = [values[way] for group in each for values in group]
        ways.append(xp.stack([*[nominal[way]] * before, *own, *[nominal[way]] * behind, all_off[way]], 1))
    forth, back = ways
    series = inverse(forth[:, :, 1])
    first, last = (each[:, :, 0] * series for each in ways)
    return _Chain(series, first, last, back[:, :, list(range(count + 1, 1, -1))], forth[:, :, 2:])


def _links(xp: ModuleType, tubes: Tubes) -> _Links:
    """Tubes (n_design, n_tube, n_freq) in the order of their line."""
    b = inverse(tubes.series)
    a, d = b * tubes.last, b * tubes.first
    c = tubes.first + tubes.last * (1 + d)
    return _Links(_both_ways(xp, a, d), _both_ways(xp, b), _both_ways(xp, c), _both_ways(xp, d, a))


def _both_ways(xp: ModuleType, forth: NumpyOrTorch, back: NumpyOrTorch | None = None) -> NumpyOrTorch:
    """Parts (n_design, n, n_freq) along a line, and ``back`` (or they) backwards: (2, n_design, n, n_freq)."""
    turned = list(range(forth.shape[1] - 1, -1, -1))
    return xp.stack([forth, (forth if back is None else back)[:, turned]])


def _from_the_end(
    xp: ModuleType, tubes: _Links, loads: NumpyOrTorch
) -> tuple[NumpyOrTorch, list[tuple[NumpyOrTorch, NumpyOrTorch]]]:
    """Products of all matrices from the end of a chain to each of its parts.

    Returns:
        D - 1 and B of the whole chain and B from each point to the end, (2, n_design, 2 + n_point, n_freq); and the
        entries B and D of what lies between each tube and the end, (2, n_design, n_freq) each.
    """
    b, rest = xp.zeros_like(loads[:, :, 0]), xp.zeros_like(loads[:, :, 0])  # rest: D - 1
    behind, found = [], []
    for place in range(loads.shape[2], -1, -1):
        behind.append((b, 1 + rest))
        own = [each[:, :, place] for each in tubes]
        b, rest = b + own[0] * b + own[1] * (1 + rest), own[2] * b + own[3] + rest + own[3] * rest
        found.append(b)
        if place:
            rest = rest + loads[:, :, place - 1] * b
    return xp.stack([rest, found[-1], *found[-2::-1]], 2), behind[::-1]


def _each_off(
    xp: ModuleType,
    tubes: _Links,
    change: _Links,
    loads: NumpyOrTorch,
    changes: Sequence[NumpyOrTorch],
    nominal: NumpyOrTorch,
    behind: Sequence[tuple[NumpyOrTorch, NumpyOrTorch]],
) -> list[list[NumpyOrTorch]]:
    """The first result of :func:`_from_the_end`, with each tube off; then with each load by each of its changes."""
    count = loads.shape[2]
    nothing = xp.zeros_like(loads[:, :, :1])
    one = 1 + nothing
    # rows of the products of all matrices up to a place: from the other end (0, 1) and (1, 0), from each point (1, 0)
    first, second = xp.concatenate([nothing, one], 2), xp.concatenate([one, nothing], 2)
    found: list[list[NumpyOrTorch]] = [[] for _ in range(1 + len(changes))]
    for place in range(count + 1):
        begun, still = nominal[:, :, : place + 2], nominal[:, :, place + 2 :]
        a, b, c, d = (each[:, :, place, None] for each in tubes)
        more_a, more_b, more_c, more_d = (each[:, :, place, None] for each in change)
        b_behind, d_behind = (each[:, :, None] for each in behind[place])
        added = first * (more_a * b_behind + more_b * d_behind) + second * (more_c * b_behind + more_d * d_behind)
        found[0].append(xp.concatenate([begun + added, still], 2))
        first, second = first + first * a + second * c, first * b + second + second * d
        if place < count:
            seen = second * nominal[:, :, 2 + place, None]
            for group, each in zip(found[1:], changes, strict=True):
                group.append(xp.concatenate([begun + seen * each[:, :, place, None], still], 2))
            first = xp.concatenate([first + second * loads[:, :, place, None], one], 2)
            second = xp.concatenate([second, nothing], 2)
    return found
