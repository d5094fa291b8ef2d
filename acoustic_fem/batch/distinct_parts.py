"""Transfer functions of designs that share most of their parts: each distinct part is worked out once.

Where one part after the other deviates, as for derivatives by finite differences, nearly all parts of a batch are
equal. Closed forms of a part take far longer than the network that joins the parts.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import fields, replace
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from acoustic_fem.batch.elements import Chambers, Conditions, Points, Tubes, chambers, points, tubes
from acoustic_fem.batch.network import join_parts
from acoustic_fem.batch.parameters import PART, ArrayParameters, MediumParameters, check_medium, check_parameters
from acoustic_fem.batch.topology import Topology
from acoustic_fem.quantities.checks import FrequencyLike, frequency_grid
from geometry.ground.typed import Array, ComplexArray

#: Values per array joined at once (designs x points x frequencies): larger leaves the processor's cache.
_CHUNK = 100_000

Parts = TypeVar("Parts", Tubes, Points, Chambers)


def transfer_function_of_distinct_parts(
    parameters: ArrayParameters, topology: Topology, frequency: FrequencyLike, air: MediumParameters
) -> ComplexArray:
    """Transfer functions as :func:`acoustic_fem.batch.batch_transfer_function` at the fidelity ``lumped``.

    Args:
        parameters: of the designs, NumPy arrays.
        topology: their wiring, with a column for every part.
        frequency: (n_freq,) Hz, ascending.
        air: of each design.

    Returns:
        (n_design, n_point, n_microphone, n_freq) complex128, Pa/Pa.

    Raises:
        Refusal: a bad frequency grid, or parameters that do not fit the topology or are out of range.
    """
    omega = 2 * np.pi * frequency_grid(frequency)
    check_parameters(parameters, topology)
    count = check_medium(air, parameters.design_count, np)
    tube = _distinct(tubes, "tube", parameters, omega, air, count)
    point = _distinct(points, "point", parameters, omega, air, count)
    chamber = _distinct(chambers, "microphone", parameters, omega, air, count)
    found = np.empty((count, topology.point_count, len(topology.microphones), len(omega)), np.complex128)
    step = max(1, _CHUNK // (topology.point_count * len(omega)))
    for first in range(0, count, step):
        rows = slice(first, first + step)
        size = len(found[rows])
        joined = join_parts(topology, Tubes(*tube(rows)), Points(*point(rows)), Chambers(*chamber(rows)), size)
        found[rows] = joined.transfer_function
    return found


def _distinct(
    function: Callable[[ArrayParameters, Conditions], Parts],
    kind: str,
    parameters: ArrayParameters,
    omega: Array,
    air: MediumParameters,
    count: int,
) -> Callable[[slice], list[ComplexArray | None]]:
    """Function that gives the parts of one kind of some designs, whose distinct ones are worked out here."""
    own: dict[str, Array] = {}
    for name in (name for name, part in PART.items() if part == kind):
        given: Array = getattr(parameters, name)
        own[name] = np.broadcast_to(given, (count, *given.shape[1:]))
    columns = max(values.shape[1] for values in own.values())
    gas = {field.name: np.broadcast_to(getattr(air, field.name), (count,)) for field in fields(air)}
    flat = [values.reshape(count * columns, -1) for values in own.values()]
    flat += [np.repeat(values, columns)[:, None] for values in gas.values()]
    first, of_part = _different_rows(np.concatenate(flat, axis=1))
    design, column = np.divmod(first, columns)
    alone = replace(parameters, **{name: values[design, column][:, None] for name, values in own.items()})
    medium = MediumParameters(**{name: values[design] for name, values in gas.items()})
    found = function(alone, Conditions.of(omega, medium))
    place = of_part.reshape(count, columns)
    return lambda rows: [None if each is None else each[place[rows], 0] for each in found]


def _different_rows(table: Array) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Index of the first of all rows that are equal, and for every row the place of its own among these."""
    varying = np.ascontiguousarray(table[:, (table != table[0]).any(0)])
    seen: dict[bytes, int] = {}
    if not varying.shape[1]:
        return np.zeros(1, np.int64), np.zeros(len(table), np.int64)
    keys = varying.view(f"V{varying.itemsize * varying.shape[1]}").ravel().tolist()
    place = np.array([seen.setdefault(key, len(seen)) for key in keys], np.int64)
    return np.unique(place, return_index=True)[1], place
