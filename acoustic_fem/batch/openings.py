"""Tubes, points and chambers of a batch at fidelity ``atlas``: each opening counts for itself.

At fidelity lumped a tube is the same wherever it opens. Here its ends differ by the cavities, so that tubes have a
column for each pair of openings, and points one for each pair of tubes.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np

from acoustic_fem.atlas.cell_in_atlas import check_gas, opening_node
from acoustic_fem.atlas.table import CellAtlas, House, Opening, cell_atlas
from acoustic_fem.batch.elements import Chambers, Conditions, Ducts, Points, Tubes, chambers, ducts, yielding
from acoustic_fem.batch.numpy_or_torch import Array, inverse, namespace
from acoustic_fem.batch.parameters import ArrayParameters
from acoustic_fem.batch.topology import LineWiring, Topology


class Mouth(NamedTuple):
    """Where tubes of one column open into cavities of another."""

    house: House
    """What the cavity belongs to."""
    tube: int
    """Column of the tube."""
    cavity: int
    """Column of the point or of the microphone."""


@dataclass(frozen=True)
class OpeningColumns:
    """Columns of a topology in which parts with different openings are apart."""

    mouths: tuple[Mouth, ...]
    """Every kind of opening."""
    tubes: tuple[tuple[int, int, int], ...]
    """Of each column of tubes the column of the parameters, and the mouths at the first and the last end."""
    points: tuple[tuple[int, tuple[int, ...]], ...]
    """Of each column of points the column of the parameters, and the mouths of its tubes."""
    chambers: tuple[tuple[int, tuple[int, ...]], ...]
    """Of each column of microphones the column of the parameters, and the mouths of its tubes."""
    topology: Topology
    """The wiring in these columns."""


@lru_cache(maxsize=64)
def opening_columns(topology: Topology) -> OpeningColumns:
    """The columns of a topology at fidelity ``atlas``."""
    mouths: dict[Mouth, int] = {}
    tubes: dict[tuple[int, int, int], int] = {}
    points: dict[tuple[int, tuple[int, ...]], int] = {}
    at_chamber: list[list[int]] = [[] for _ in topology.microphones]
    lines = []
    for line in topology.lines:
        cavities: list[tuple[House, int]] = [
            ("microphone", topology.microphones[line.first]),
            *(("resonator", column) for column in line.points),
            ("microphone", topology.microphones[line.last]),
        ]
        ends = []
        for tube, before, after in zip(line.tubes, cavities[:-1], cavities[1:], strict=True):
            ends.append(tuple(_number(mouths, Mouth(house, tube, column)) for house, column in (before, after)))
        at_chamber[line.first].append(ends[0][0])
        at_chamber[line.last].append(ends[-1][1])
        lines.append(
            LineWiring(
                line.first,
                line.last,
                tuple(_number(tubes, (tube, *both)) for tube, both in zip(line.tubes, ends, strict=True)),
                tuple(
                    _number(points, (column, tuple(sorted((ends[place][1], ends[place + 1][0])))))
                    for place, column in enumerate(line.points)
                ),
            )
        )
    chamber_columns: dict[tuple[int, tuple[int, ...]], int] = {}
    microphones = tuple(
        _number(chamber_columns, (column, tuple(sorted(at))))
        for column, at in zip(topology.microphones, at_chamber, strict=True)
    )
    return OpeningColumns(
        tuple(mouths),
        tuple(tubes),
        tuple(points),
        tuple(chamber_columns),
        Topology(microphones, tuple(lines), tuple(f"tube {k}" for k in range(len(tubes)))),
    )


def check_openings(parameters: ArrayParameters, topology: Topology, frequency: Array, medium: Any) -> None:
    """Refuse designs outside the atlas.

    Args:
        parameters: of the designs.
        topology: their wiring.
        frequency: (n_freq,) float64, Hz, NumPy.
        medium: the gas of all, or of each.

    Raises:
        OutsideAtlas: names the kind of opening, the ratio and its range.
    """
    check_gas(medium)
    for mouth, opening, square in _stated_openings(parameters, topology, frequency, medium):
        atlas_part = "a microphone's chamber" if mouth.house == "microphone" else f"points of column {mouth.cavity}"
        cell_atlas().check(mouth.house, opening, square, f"{topology.tube_names[mouth.tube]} at {atlas_part}")


def designs_outside(parameters: ArrayParameters, topology: Topology, frequency: Array, medium: Any) -> Array:
    """Which designs :func:`check_openings` would refuse for their openings, (n_design,) bool; arguments as there."""
    outside = np.zeros(parameters.design_count, dtype=bool)
    for mouth, opening, square in _stated_openings(parameters, topology, frequency, medium):
        outside |= cell_atlas().is_outside(mouth.house, opening, square[:, None, None])[:, 0, 0]
    return outside


def _stated_openings(
    parameters: ArrayParameters, topology: Topology, frequency: Array, medium: Any
) -> Iterator[tuple[Mouth, Opening, Array]]:
    """Mouths with their shapes, (n_design, 1, 1), and largest squares of their shear numbers, (n_design,), NumPy."""
    plain = parameters if parameters.namespace is np else parameters.map(lambda values: values.detach().cpu().numpy())
    per_viscosity = medium.density / medium.viscosity
    if not isinstance(per_viscosity, float | np.ndarray):
        per_viscosity = per_viscosity.detach().cpu().numpy()
    for mouth in opening_columns(topology).mouths:
        opening = _opening(plain, mouth)
        yield mouth, opening, opening.radius[:, 0, 0] ** 2 * per_viscosity * (2 * np.pi * float(frequency[-1]))


def open_parts(parameters: ArrayParameters, topology: Topology, air: Conditions) -> tuple[Tubes, Points, Chambers]:
    """Tubes, points and chambers in the columns of :func:`opening_columns`."""
    columns, atlas = opening_columns(topology), cell_atlas()
    impedances, compliances = _at_mouths(atlas, parameters, columns.mouths, air)
    tube = _tubes(columns, ducts(parameters, air), impedances)

    cavity, load = yielding(parameters, air)
    rate = 1j * air.omega
    storage = [_at(cavity, column) + rate * sum(compliances[k] for k in at) for column, at in columns.points]
    shared = [_shared(atlas, _opening(parameters, columns.mouths[at[0]]), air) for _, at in columns.points]
    xp = namespace(parameters.tube_radius)
    point = Points(
        *opening_node(
            _beside(xp, storage),
            _beside(xp, [_at(load, column) for column, _ in columns.points]),
            *(_beside(xp, list(part)) for part in zip(*shared, strict=True)),
        )
    )
    extra = [rate * sum(compliances[k] for k in at) for _, at in columns.chambers]
    housing = chambers(parameters, air)
    chamber = [
        (_at(housing.shunt, column) + more, _at(housing.ratio, column), _at(housing.own, column))
        for (column, _), more in zip(columns.chambers, extra, strict=True)
    ]
    return tube, point, Chambers(*(_beside(xp, list(part)) for part in zip(*chamber, strict=True)))


def _at_mouths(
    atlas: CellAtlas, parameters: ArrayParameters, mouths: Sequence[Mouth], air: Conditions
) -> tuple[list[Array], list[Array]]:
    """Impedance and compliance of each mouth, (n_design, 1, n_freq) complex128."""
    impedances: list[Array] = []
    compliances: list[Array] = []
    for mouth in mouths:
        opening = _opening(parameters, mouth)
        cube = opening.radius**3
        square = opening.radius**2 * air.per_viscosity * air.omega
        impedances.append(air.medium.viscosity / cube * atlas.impedance(mouth.house, opening, square))
        compliances.append(cube / air.medium.pressure * atlas.compliance(opening, square))
    return impedances, compliances


def _shared(atlas: CellAtlas, opening: Opening, air: Conditions) -> tuple[Array, Array]:
    """Impedances that tubes share with each other and with the membrane beside that of the air's compliance."""
    unit = (1j * air.omega) * (air.medium.density / opening.cavity_radius)
    passage, to_membrane = atlas.inertances(opening)
    return unit * passage, unit * to_membrane


def _tubes(columns: OpeningColumns, duct: Ducts, impedances: Sequence[Array]) -> Tubes:
    """Tubes between the impedances of their openings, as series and shunts."""
    series, first, last = [], [], []
    for column, one, other in columns.tubes:
        total, across, rise, ratio = (_at(values, column) for values in duct)
        before, after = impedances[one], impedances[other]
        inward = across * ratio
        # chain matrix [[1 + rise + before inward, b], [., 1 + rise + inward after]]
        through = inverse(total * ratio + (before + after) * (1 + rise) + before * after * inward)
        series.append(through)
        first.append((rise + inward * after) * through)
        last.append((rise + inward * before) * through)
    xp = namespace(through)
    return Tubes(_beside(xp, series), _beside(xp, first), _beside(xp, last))


def _opening(parameters: ArrayParameters, mouth: Mouth) -> Opening:
    """Shapes of the openings of a mouth, (n_design, 1, 1) each."""
    radius = _at(parameters.tube_radius, mouth.tube)[..., None]
    if mouth.house == "microphone":
        cavity, height = (
            _at(v, mouth.cavity)[..., None] for v in (parameters.chamber_radius, parameters.chamber_height)
        )
        return Opening(radius, cavity, height, height / 2)
    sizes = (parameters.cavity_radius, parameters.cavity_height, parameters.port_height)
    return Opening(radius, *(_at(values, mouth.cavity)[..., None] for values in sizes))


def _at(values: Array, column: int) -> Array:
    """One column, kept as an axis."""
    return values[:, column : column + 1]


def _beside(xp: Any, values: list[Array]) -> Array:
    """Columns put beside each other."""
    if len(values) == 1:
        return values[0]
    shape = np.broadcast_shapes(*(tuple(value.shape) for value in values))
    return xp.concatenate([xp.broadcast_to(value, shape) for value in values], 1)


def _number(known: dict[Any, int], key: Any) -> int:
    return known.setdefault(key, len(known))
