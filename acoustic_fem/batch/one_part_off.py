"""Arrays of which one part is off, each part in turn: chains are multiplied out once, not once for every part.

A tube is a transfer matrix [[1 + Z last, Z], [C, 1 + Z first]] with Z the inverse of its series admittance and C =
first + last (1 + Z first), a point that of its shunt. Of the product of all matrices between a point and an end of its
line, the entry B is the inverse of the series admittance of what lies there. If one part is off, B changes by a row of
what lies before it times the change of its matrix times a column of what lies behind it: rows and columns are the same
for all parts. Of A and D what is beside 1 is carried along, so that nothing cancels at low frequency.
"""

from __future__ import annotations

from collections.abc import Sequence
from types import ModuleType
from typing import NamedTuple

from acoustic_fem.batch.elements import Chambers, Tubes
from acoustic_fem.batch.network import impedance_between
from acoustic_fem.batch.numpy_or_torch import Array, inverse, namespace
from acoustic_fem.batch.topology import LineWiring, Topology


class PartsOff(NamedTuple):
    """Parts in the columns of a topology, as designed and with their deviations."""

    tubes: tuple[Tubes, Tubes]
    """As designed, and off."""
    shunts: tuple[Array, ...]
    """Shunts of the points, (n_design, n_column, n_freq) each: as designed, with each deviation that a point has alone,
    and with that which all have together."""
    chambers: tuple[Chambers, Chambers]
    """As designed, and off."""


def one_part_off(topology: Topology, parts: PartsOff) -> Array:
    """Pressures at the microphones from a source at each point, up to a factor that all microphones have in common.

    Args:
        topology: the wiring, with the columns that the parts have.
        parts: what is off, each in turn.

    Returns:
        (n_design, n_sensor, n_point, n_microphone, n_freq) complex128. The first sensor is as designed; then, line by
        line, one tube after the other is off, one point after the other by each of its deviations; then each chamber;
        in the last, all points together.
    """
    xp = namespace(parts.shunts[0])
    chains = [_chain(xp, line, parts) for line in topology.lines]
    own = [chain.series.shape[1] - 2 for chain in chains]
    microphones = len(topology.microphones)

    def in_all(number: int, values: Array) -> Array:
        """Values of a line, (n_design, n_own + 2, ...), in all sensors: as designed where another part is off."""

        def as_designed(count: int) -> Array:
            return xp.broadcast_to(values[:, :1], (len(values), count, *values.shape[2:]))

        before, behind = as_designed(1 + sum(own[:number])), as_designed(sum(own[number + 1 :]) + microphones)
        return xp.concatenate([before, values[:, 1:-1], behind, values[:, -1:]], 1)

    shunts: list[Array] = []
    ratios: list[Array] = []
    for number, column in enumerate(topology.microphones):
        off = [0] * (2 + sum(own) + microphones)
        off[1 + sum(own) + number] = 1
        for name, found in (("shunt", shunts), ("ratio", ratios)):
            found.append(xp.stack([getattr(each, name)[:, column] for each in parts.chambers], 1)[:, off])
    series: dict[tuple[int, int], Array] = {}
    for number, (line, chain) in enumerate(zip(topology.lines, chains, strict=True)):
        between = min(line.first, line.last), max(line.first, line.last)
        admittance, *grounds = (in_all(number, values) for values in chain[:3])
        series[between] = series[between] + admittance if between in series else admittance
        for end, ground in zip((line.first, line.last), grounds, strict=True):
            shunts[end] = shunts[end] + ground
    impedance = impedance_between(xp, shunts, series)
    pressures = []
    for number, (line, chain) in enumerate(zip(topology.lines, chains, strict=True)):
        to_last, to_first = in_all(number, chain.to_last), in_all(number, chain.to_first)
        near, far = (
            [(impedance[:, end, k] * ratio)[:, :, None] for k, ratio in enumerate(ratios)]
            for end in (line.first, line.last)
        )
        heard = [to_last * one + to_first * other for one, other in zip(near, far, strict=True)]
        pressures.append(xp.stack(heard, 3))
    return pressures[0] if len(pressures) == 1 else xp.concatenate(pressures, 2)


class _Chain(NamedTuple):
    """A line in the sensors of its own, (n_design, n_own + 2, ...): as designed, one part off each, all points off."""

    series: Array
    """Admittance between its ends, (n_design, n_own + 2, n_freq)."""
    first: Array
    """Admittance to ground at its first end, shaped as ``series``."""
    last: Array
    """Admittance to ground at its last end, shaped as ``series``."""
    to_first: Array
    """Inverse of the series admittance from each point to the first end, (n_design, n_own + 2, n_point, n_freq)."""
    to_last: Array
    """That to the last end, shaped as ``to_first``."""


class _Links(NamedTuple):
    """Transfer matrices of tubes one after the other, (2, n_design, n_tube, n_freq) each.

    Along the first axis the way is that of the line, and backwards.
    """

    a: Array
    """A - 1."""
    b: Array
    """B."""
    c: Array
    """C."""
    d: Array
    """D - 1."""


def _chain(xp: ModuleType, line: LineWiring, parts: PartsOff) -> _Chain:
    columns, count = list(line.tubes), len(line.points)
    designed, off = (_links(xp, Tubes(*(values[:, columns] for values in tube))) for tube in parts.tubes)
    change = _Links(*(one - other for one, other in zip(off, designed, strict=True)))
    loads, *others, together = (_both_ways(xp, values[:, list(line.points)]) for values in parts.shunts)
    nominal, behind = _from_the_end(xp, designed, loads)
    rows = [nominal]
    rows.append(nominal + _changes(xp, designed, change, loads, [each - loads for each in others], nominal, behind))
    rows.append(_from_the_end(xp, designed, together)[0])
    forth, back = xp.concatenate(rows, 2)
    # backwards the parts and the points come in the opposite order
    tubes, points = list(range(count, -1, -1)), list(range(count - 1, -1, -1))
    sizes = [count + 1 + count * number for number in range(len(others) + 1)]
    order = [0, *(1 + place for place in tubes), *(1 + start + place for start in sizes[:-1] for place in points)]
    back = back[:, [*order, sizes[-1] + 1]]
    series = inverse(forth[:, :, 1])
    return _Chain(
        series, forth[:, :, 0] * series, back[:, :, 0] * series, back[:, :, [2 + k for k in points]], forth[:, :, 2:]
    )


def _links(xp: ModuleType, tubes: Tubes) -> _Links:
    """Of tubes (n_design, n_tube, n_freq) in the order of their line."""
    b = inverse(tubes.series)
    a, d = b * tubes.last, b * tubes.first
    c = tubes.first + tubes.last * (1 + d)
    return _Links(_both_ways(xp, a, d), _both_ways(xp, b), _both_ways(xp, c), _both_ways(xp, d, a))


def _both_ways(xp: ModuleType, forth: Array, back: Array | None = None) -> Array:
    """Parts (n_design, n, n_freq) along a line, and ``back`` (or they) backwards: (2, n_design, n, n_freq)."""
    turned = list(range(forth.shape[1] - 1, -1, -1))
    return xp.stack([forth, (forth if back is None else back)[:, turned]])


def _from_the_end(xp: ModuleType, tubes: _Links, loads: Array) -> tuple[Array, list[tuple[Array, Array]]]:
    """Products of all matrices from the end of a chain to each of its parts.

    Returns:
        D - 1 and B of the whole chain and B from each point to the end, (2, n_design, 1, 2 + n_point, n_freq); and the
        entries B and D of what lies between each tube and the end, (2, n_design, n_freq) each.
    """
    count = loads.shape[2]
    b, rest = xp.zeros_like(loads[:, :, 0]), xp.zeros_like(loads[:, :, 0])  # rest: D - 1
    behind, found = [], []
    for place in range(count, -1, -1):
        behind.append((b, 1 + rest))
        own = [each[:, :, place] for each in tubes]
        b, rest = b + own[0] * b + own[1] * (1 + rest), own[2] * b + own[3] + rest + own[3] * rest
        found.append(b)
        if place:
            rest = rest + loads[:, :, place - 1] * b
    return xp.stack([rest, found[-1], *found[-2::-1]], 2)[:, :, None], behind[::-1]


def _changes(
    xp: ModuleType,
    tubes: _Links,
    change: _Links,
    loads: Array,
    changes: Sequence[Array],
    nominal: Array,
    behind: Sequence[tuple[Array, Array]],
) -> Array:
    """What each tube, then each load by each of its changes, adds to what :func:`_from_the_end` returns.

    (2, n_design, n_changed, 2 + n_point, n_freq).
    """
    count = loads.shape[2]
    nothing = xp.zeros_like(loads)
    one = 1 + nothing[:, :, :1]
    # rows of the products of all matrices up to a place: from the other end (0, 1) and (1, 0), from each point (1, 0)
    first, second = xp.concatenate([nothing[:, :, :1], one], 2), xp.concatenate([one, nothing[:, :, :1]], 2)
    of_tubes: list[Array] = []
    of_loads: list[list[Array]] = [[] for _ in changes]
    for place in range(count + 1):
        a, b, c, d = (each[:, :, place, None] for each in tubes)
        more_a, more_b, more_c, more_d = (each[:, :, place, None] for each in change)
        b_behind, d_behind = (each[:, :, None] for each in behind[place])
        none_yet = nothing[:, :, place:]
        added = (first * more_b + second * more_d) * d_behind
        if place < count:
            added = added + (first * more_a + second * more_c) * b_behind
        of_tubes.append(xp.concatenate([added, none_yet], 2))
        first, second = first + first * a + second * c, first * b + second + second * d
        if place < count:
            seen = second * nominal[:, :, :, 2 + place]
            for found, each in zip(of_loads, changes, strict=True):
                found.append(xp.concatenate([seen * each[:, :, place, None], none_yet], 2))
            first = xp.concatenate([first + second * loads[:, :, place, None], one], 2)
            second = xp.concatenate([second, nothing[:, :, :1]], 2)
    return xp.stack([*of_tubes, *(each for found in of_loads for each in found)], 2)
