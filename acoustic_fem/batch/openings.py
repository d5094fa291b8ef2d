"""Tubes, points and chambers of a batch at fidelity ``atlas``: each opening counts for itself.

At fidelity lumped a tube is the same wherever it opens. Here its ends differ by the cavities, so that tubes have a
column for each pair of openings, and points one for each pair of tubes.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from acoustic_fem.atlas.cell_in_atlas import check_gas, opening_node
from acoustic_fem.atlas.cell_table import CellAtlas, Enclosure, Opening, cell_atlas
from acoustic_fem.batch.elements import Chambers, Conditions, Ducts, Points, Tubes, chambers, ducts, yielding
from acoustic_fem.batch.numpy_or_torch import inverse, namespace
from acoustic_fem.batch.parameters import ArrayParameters, opening_sizes
from acoustic_fem.batch.topology import LineWiring, Topology
from geometry.design.array_design import ArrayDesign
from geometry.ground.typed import Array, NumpyOrTorch


class Mouth(NamedTuple):
    """Openings of the tubes of one column into the cavities of another."""

    enclosure: Enclosure
    """Enclosure that the cavity belongs to."""
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
    """For each column of tubes the column of the parameters, and the mouths at the first and the last end."""
    points: tuple[tuple[int, tuple[int, ...]], ...]
    """For each column of points the column of the parameters, and the mouths of its tubes."""
    chambers: tuple[tuple[int, tuple[int, ...]], ...]
    """For each column of microphones the column of the parameters, and the mouths of its tubes."""
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
        cavities: list[tuple[Enclosure, int]] = [
            ("microphone", topology.microphones[line.first]),
            *(("resonator", column) for column in line.points),
            ("microphone", topology.microphones[line.last]),
        ]
        ends = []
        for tube, before, after in zip(line.tubes, cavities[:-1], cavities[1:], strict=True):
            ends.append(tuple(_number(mouths, Mouth(enclosure, tube, column)) for enclosure, column in (before, after)))
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


class OpeningSizes(NamedTuple):
    """Sizes of designs of one topology that decide whether the atlas covers them; NumPy, float64, m."""

    tube_radius: Array
    """Radius of the bores, (n_design, n_tube_column)."""
    cavity_radius: Array
    """Radius of the cavities, (n_design, n_point_column)."""
    cavity_height: Array
    """Height of the cavities, (n_design, n_point_column)."""
    port_height: Array
    """Height of the axes of the tubes above the floor, (n_design, n_point_column)."""
    chamber_radius: Array
    """Radius of the microphones' chambers, (n_design, n_microphone_column)."""
    chamber_height: Array
    """Height of the microphones' chambers, (n_design, n_microphone_column)."""
    hole_radius: Array
    """Radius of the sound holes, (n_design, n_microphone_column)."""

    @classmethod
    def of(cls, parameters: ArrayParameters) -> OpeningSizes:
        """Sizes of the designs of a batch."""
        found = (getattr(parameters, name) for name in cls._fields)
        return cls(*(v if isinstance(v, np.ndarray) else v.detach().cpu().numpy() for v in found))

    @classmethod
    def from_designs(cls, designs: Sequence[ArrayDesign]) -> OpeningSizes:
        """Sizes of designs of one topology, whose membranes need not be known."""
        rows = [opening_sizes(design) for design in designs]
        return cls(*(np.array([row[name] for row in rows], dtype=np.float64) for name in cls._fields))


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
    sizes = OpeningSizes.of(parameters)
    if not designs_outside(sizes, topology, frequency, medium).any():
        return
    for enclosure, mouths in _by_enclosure(opening_columns(topology).mouths):
        for mouth in mouths:
            opening, square = _stated_openings(sizes, [mouth], frequency, medium)
            cell_atlas().check(
                enclosure, opening, square, f"{topology.tube_names[mouth.tube]} at {_first_with(mouth, topology)}"
            )


def _first_with(mouth: Mouth, topology: Topology) -> str:
    """The first cavity of an array that has a mouth, in words."""
    if mouth.enclosure == "microphone":
        return "a microphone's chamber"
    points = [(column, line.tubes[k : k + 2]) for line in topology.lines for k, column in enumerate(line.points)]
    has = (column == mouth.cavity and mouth.tube in tubes for column, tubes in points)
    return f"point {list(has).index(True) + 1}"


def designs_outside(sizes: OpeningSizes, topology: Topology, frequency: Array, medium: Any) -> NDArray[np.bool_]:
    """Designs that :func:`check_openings` would refuse for their openings.

    Args:
        sizes: of the designs.
        topology: their wiring.
        frequency: (n_freq,) float64, Hz.
        medium: the gas of all, or of each.

    Returns:
        (n_design,) bool.
    """
    outside = np.zeros(len(sizes.tube_radius), dtype=bool)
    for enclosure, mouths in _by_enclosure(opening_columns(topology).mouths):
        opening, square = _stated_openings(sizes, mouths, frequency, medium)
        outside = outside | cell_atlas().is_outside(enclosure, opening, square).any((1, 2))
    return outside


def _by_enclosure(mouths: Sequence[Mouth]) -> list[tuple[Enclosure, list[Mouth]]]:
    """The mouths of points, then those of chambers."""
    enclosures: tuple[Enclosure, ...] = ("resonator", "microphone")
    return [(enclosure, [mouth for mouth in mouths if mouth.enclosure == enclosure]) for enclosure in enclosures]


def _stated_openings(
    sizes: OpeningSizes, mouths: Sequence[Mouth], frequency: Array, medium: Any
) -> tuple[Opening, Array]:
    """Shapes of mouths of one enclosure, and largest squares of their shear numbers, (n_design, n_mouth, 1)."""
    per_viscosity = medium.density / medium.viscosity
    if not isinstance(per_viscosity, float | np.ndarray):
        per_viscosity = per_viscosity.detach().cpu().numpy()
    opening = _opening(sizes, mouths)
    return opening, opening.radius**2 * (np.reshape(per_viscosity, (-1, 1, 1)) * (2 * np.pi * float(frequency[-1])))


def open_parts(parameters: ArrayParameters, topology: Topology, air: Conditions) -> tuple[Tubes, Points, Chambers]:
    """Tubes, points and chambers in the columns of :func:`opening_columns`."""
    columns, atlas = opening_columns(topology), cell_atlas()
    impedance, compliance = _at_mouths(atlas, parameters, columns.mouths, air)
    tube = _tubes(columns, ducts(parameters, air), impedance)

    cavity, load = yielding(parameters, air)
    storage = 1j * air.omega * compliance
    at = [column for column, _ in columns.points]
    one, other = ([mouths[k] for _, mouths in columns.points] for k in range(2))
    passage, through = _shared(atlas, _opening(parameters, [columns.mouths[k] for k in one]), air)
    stored = _at(cavity, at) + _at(storage, one) + _at(storage, other)
    point = Points(*opening_node(stored, _at(load, at), passage, through))

    housing, at = chambers(parameters, air), [column for column, _ in columns.chambers]
    xp = namespace(parameters.tube_radius)
    more = _beside(xp, [sum(_at(storage, [k]) for k in mouths) for _, mouths in columns.chambers])
    return tube, point, Chambers(_at(housing.shunt, at) + more, _at(housing.ratio, at), _at(housing.own, at))


def _at_mouths(
    atlas: CellAtlas, parameters: ArrayParameters, mouths: Sequence[Mouth], air: Conditions
) -> tuple[NumpyOrTorch, NumpyOrTorch]:
    """Impedance and compliance of the mouths, (n_design, n_mouth, n_freq) complex128."""
    impedances, compliances, order = [], [], []
    for enclosure, of_enclosure in _by_enclosure(mouths):
        opening = _opening(parameters, of_enclosure)
        cube = opening.radius**3
        square = opening.radius**2 * air.per_viscosity * air.omega
        impedances.append(air.medium.viscosity / cube * atlas.impedance(enclosure, opening, square))
        compliances.append(cube / air.medium.pressure * atlas.compliance(opening, square))
        order += of_enclosure
    xp, place = namespace(parameters.tube_radius), {mouth: k for k, mouth in enumerate(order)}
    back = [place[mouth] for mouth in mouths]
    return _at(_beside(xp, impedances), back), _at(_beside(xp, compliances), back)


def _shared(atlas: CellAtlas, opening: Opening, air: Conditions) -> tuple[NumpyOrTorch, NumpyOrTorch]:
    """Impedances that tubes share with each other and with the membrane beside that of the air's compliance."""
    unit = (1j * air.omega) * (air.medium.density / opening.cavity_radius)
    passage, to_membrane = atlas.inertances(opening)
    return unit * passage, unit * to_membrane


def _tubes(columns: OpeningColumns, duct: Ducts, impedance: NumpyOrTorch) -> Tubes:
    """Tubes between the impedances of their openings, as series and shunts."""
    of_tubes, *ends = ([each[k] for each in columns.tubes] for k in range(3))
    total, across, rise, ratio = (_at(values, of_tubes) for values in duct)
    before, after = (_at(impedance, mouths) for mouths in ends)
    inward = across * ratio
    # chain matrix [[1 + rise + before inward, b], [., 1 + rise + inward after]]
    through = inverse(total * ratio + (before + after) * (1 + rise) + before * after * inward)
    return Tubes(through, (rise + inward * after) * through, (rise + inward * before) * through)


def _opening(parameters: ArrayParameters | OpeningSizes, mouths: Sequence[Mouth]) -> Opening:
    """Shapes of the openings of mouths of one enclosure, (n_design, n_mouth, 1) each."""
    cavities = [mouth.cavity for mouth in mouths]

    def of_cavities(*names: str) -> list[NumpyOrTorch]:
        return [_at(getattr(parameters, name), cavities)[..., None] for name in names]

    radius = _at(parameters.tube_radius, [mouth.tube for mouth in mouths])[..., None]
    if mouths[0].enclosure == "microphone":
        cavity, height, hole = of_cavities("chamber_radius", "chamber_height", "hole_radius")
        return Opening(radius, cavity, height, height / 2, hole)
    return Opening(radius, *of_cavities("cavity_radius", "cavity_height", "port_height"))


def _at(values: NumpyOrTorch, columns: list[int]) -> NumpyOrTorch:
    """Some columns, a view where they are one."""
    first = columns[0]
    return values[:, first : first + 1] if len(columns) == 1 else values[:, columns]


def _beside(xp: Any, values: list[NumpyOrTorch]) -> NumpyOrTorch:
    """Columns put beside each other, of all designs or of each."""
    rows = max(value.shape[0] for value in values)
    return xp.concatenate([xp.broadcast_to(value, (rows, *value.shape[1:])) for value in values], 1)


def _number(known: dict[Any, int], key: Any) -> int:
    return known.setdefault(key, len(known))
