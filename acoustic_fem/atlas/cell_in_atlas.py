"""A cell by closed forms and the atlas: what it answers in 3-D, within the error that the atlas states."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np

from acoustic_fem.atlas.cell_table import CellAtlas, Opening, OutsideAtlas, cell_atlas
from acoustic_fem.cavity.closed_forms import closed_cylinder_compliance
from acoustic_fem.duct.plane_wave import port_admittance
from acoustic_fem.duct.tube_opening import entrance_impedance
from acoustic_fem.quantities.checks import FrequencyLike, frequencies
from acoustic_fem.quantities.local_air import AirLike, medium_of
from acoustic_fem.quantities.medium import Medium
from acoustic_fem.quantities.units import metres
from geometry.air.cells import Cell
from geometry.ground.refusal import Kind
from geometry.ground.typed import Array, ComplexArray, NumpyOrTorch

#: Prandtl number and ratio of heat capacities of the air that the atlas was made in, and how far others may be off.
_PRANDTL, _GAMMA, _PART = 0.71, 1.4, 0.05


def atlas_admittance(cell: Cell, frequency: FrequencyLike, air: AirLike) -> ComplexArray:
    """Volume velocities into a cell per pressure at its nodes, in m^3/(Pa s), as 3-D Navier-Stokes gives them.

    Closed forms, with the impedances of the openings, their part in the compliance and the inertance of the air in
    the cavity from the atlas.

    Args:
        cell: lengths in mm.
        frequency: (n_freq,) Hz.
        air: a :class:`acoustic_fem.LocalAir`, or a gas of its own.

    Returns:
        (n_freq, k + 1, k + 1) complex128 for k tubes, nodes as :func:`acoustic_fem.cell.lumped_admittance`.

    Raises:
        OutsideAtlas: a cell that is not a cylinder, or sizes, air or frequencies out of the bounds.
    """
    medium, frequency = medium_of(air), frequencies(frequency)
    atlas = cell_atlas()
    check_cell(atlas, cell, frequency, medium)
    omega, radius = 2 * np.pi * frequency, metres(cell.diameter) / 2
    compliance = closed_cylinder_compliance(radius, metres(cell.height), frequency, medium)
    known: dict[tuple[float, float], tuple[ComplexArray, ComplexArray]] = {}
    necks = []
    for opening, port in zip(_openings(cell), cell.ports, strict=True):
        a, alike = opening.radius, (port.bore_diameter, cell.height_of(port))
        if alike not in known:
            square = omega * a**2 / medium.kinematic_viscosity
            impedance = medium.viscosity / a**3 * atlas.impedance(cell.kind, opening, square)
            neck = _neck(a, metres(cell.bore_of(port)), impedance, frequency, medium)
            known[alike] = neck, atlas.compliance(opening, square) * (a**3 / medium.pressure)
        necks.append(known[alike][0])
        compliance = compliance + known[alike][1]
    storage = 1j * omega * compliance
    if cell.kind == "microphone":
        return _behind_sound_hole(cell, _around_node(necks, storage, 0.0, 0.0), frequency, medium)
    passage, through = (1j * omega * medium.density / radius * part for part in atlas.inertances(_openings(cell)[0]))
    return _around_node(necks, storage, passage, through)


def opening_node(
    storage: NumpyOrTorch, load: NumpyOrTorch, passage: NumpyOrTorch, through: NumpyOrTorch
) -> tuple[NumpyOrTorch, NumpyOrTorch, NumpyOrTorch]:
    """The cavity and what loads its membrane as one node between the tubes.

    Tubes 1, 2, ... open at pressures p_k = (1/s + m12) sum(Q) + (1/s + m) U, the membrane is at (1/s + m) sum(Q) + U/s,
    with s the admittance of the air, Q the volume velocities out of the tubes and U that of the membrane, which also
    drives the load. All arrays broadcast, complex128, SI.

    Args:
        storage: s, m^3/(Pa s); broadcasts with the others, as they do.
        load: admittance of all that yields around the air, m^3/(Pa s); broadcasts.
        passage: m12, impedance that the tubes share beside 1/s, Pa s/m^3; broadcasts.
        through: m, impedance that tubes and membrane share beside 1/s, Pa s/m^3; broadcasts.

    Returns:
        Admittance of the node to ground; pressure on the membrane by that of the node, also the part of a volume
        velocity injected at the membrane that arrives at the node; impedance at the membrane while the node is held at
        zero. Broadcast shape, complex128.
    """
    total = storage + load
    shared = (1 + through * storage) / total
    node = passage + (1 - load * through * (2 + through * storage)) / total
    fraction = shared / node
    return 1 / node, fraction, 1 / total - shared * fraction


def check_cell(atlas: CellAtlas, cell: Cell, frequency: Array, medium: Medium) -> None:
    """Refuse a cell outside the atlas; arguments and errors as :func:`atlas_admittance`."""
    if cell.shape is not None:
        raise OutsideAtlas(
            "is not in the atlas of cells, which has cylinders only",
            kind=Kind.NO_RESULT,
            field=cell.label,
            remedy='fidelity "navier-stokes" solves it in 3-D',
        )
    check_gas(medium)
    for opening in {(opening.radius, opening.port_height): opening for opening in _openings(cell)}.values():
        square = np.array(2 * np.pi * float(np.max(frequency)) * opening.radius**2 / medium.kinematic_viscosity)
        atlas.check(cell.kind, opening, square, cell.label)


def least_angle(cells: Iterable[Cell]) -> float:
    """Smallest angle between the two tubes of a point of any of these cells, degrees; 180 where there is none."""
    turns = [abs(c.ports[0].angle - c.ports[1].angle) for c in cells if c.kind == "resonator" and len(c.ports) == 2]
    return min([180.0, *(min(turn, 360 - turn) for turn in turns)])


def check_gas(medium: Any) -> None:
    """Refuse a gas that is not like air, in numbers or in arrays of the fields of a :class:`Medium`.

    Raises:
        OutsideAtlas: its Prandtl number or its ratio of heat capacities is more than 5 % off.
    """
    prandtl = medium.viscosity * medium.heat_capacity / medium.conductivity
    for name, value, usual in (("Prandtl number", prandtl, _PRANDTL), ("gamma", medium.gamma, _GAMMA)):
        if bool(
            (abs(value - usual) > _PART * usual).any() if hasattr(value, "any") else abs(value / usual - 1) > _PART
        ):
            low, high = usual * (1 - _PART), usual * (1 + _PART)
            raise OutsideAtlas(
                kind=Kind.NO_RESULT,
                field=f"air: {name}",
                allowed=f"{low:.4g} to {high:.4g}, that of air, in the atlas of cells",
                remedy='fidelity "navier-stokes" accepts any gas',
            )


def _openings(cell: Cell) -> list[Opening]:
    return [
        Opening(
            np.float64(metres(port.bore_diameter) / 2),
            metres(cell.diameter) / 2,
            metres(cell.height),
            metres(cell.height_of(port)),
            metres(cell.opening_diameter) / 2 if cell.kind == "microphone" else None,
        )
        for port in cell.ports
    ]


def _neck(radius: float, length: float, opening: ComplexArray, frequency: Array, medium: Medium) -> ComplexArray:
    """Two-port of a duct whose second end opens into a cavity."""
    duct = port_admittance(radius, length, frequency, medium)
    own, transfer = duct[:, 0, 0], duct[:, 0, 1]
    held = 1 / (1 + opening * own)
    neck = np.empty_like(duct)
    neck[:, 0, 0] = own - transfer**2 * opening * held
    neck[:, 0, 1] = neck[:, 1, 0] = transfer * held
    neck[:, 1, 1] = own * held
    return neck


def _around_node(
    necks: list[ComplexArray], storage: ComplexArray, passage: NumpyOrTorch, through: NumpyOrTorch
) -> ComplexArray:
    """Nodal admittance of necks around a cavity: their outer ends, then the membrane; see :func:`opening_node`."""
    transfer = np.stack([neck[:, 0, 1] for neck in necks], -1)
    inner = sum(neck[:, 1, 1] for neck in necks)
    between = passage - 2 * through - through**2 * storage
    lift = 1 + through * storage
    held = 1 / (1 + between * inner)
    size = len(necks) + 1
    nodal = np.zeros((len(storage), size, size), dtype=np.complex128)
    nodal[:, :-1, :-1] = -transfer[:, :, None] * transfer[:, None, :] * (between * held)[:, None, None]
    for node, neck in enumerate(necks):
        nodal[:, node, node] += neck[:, 0, 0]
        nodal[:, node, -1] = nodal[:, -1, node] = transfer[:, node] * lift * held
    nodal[:, -1, -1] = storage + lift**2 * inner * held
    return nodal


def _behind_sound_hole(cell: Cell, nodal: ComplexArray, frequency: Array, medium: Medium) -> ComplexArray:
    """The chamber's node replaced by the far end of the sound hole, which is as at fidelity lumped."""
    radius = metres(cell.opening_diameter) / 2
    opening = entrance_impedance(radius, frequency, medium)
    hole = _neck(radius, metres(cell.opening_length), opening, frequency, medium)
    cavity = nodal[:, -1, -1] + hole[:, 1, 1]
    to_cavity = np.concatenate([nodal[:, -1, :-1], hole[:, 0, 1, None]], -1)
    joined = -to_cavity[:, :, None] * to_cavity[:, None, :] / cavity[:, None, None]
    joined[:, :-1, :-1] += nodal[:, :-1, :-1]
    joined[:, -1, -1] += hole[:, 0, 0]
    return joined
