"""Overcure: what light that goes too deep and too wide leaves open of a bore that lies in the layers. Lengths in mm.

Light that hardens a layer goes on into the resin below it. Where that resin is air in the part, a layer of stated
depth under every ceiling hardens too (print-through, Jacobs, Rapid Prototyping and Manufacturing, 1992, chapter 4).
Light also spreads sideways, so every opening loses the stated tolerance at each side.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from geometry.ground.typed import Array
from geometry.printing.slices import Slices

if TYPE_CHECKING:
    from collections.abc import Sequence

    from geometry.solids.measure import Round

#: Bores whose axis rises less than this lie in the layers: sine of the angle.
_LYING = 0.1
#: Places across a bore at which its layers are counted.
_PLACES = 400


@dataclass(frozen=True)
class OpenBore:
    """A bore that lies in the layers."""

    bore: Round
    """The bore as designed."""
    left: float
    """Fraction of its designed section that stays open."""


def open_bores(slices: Slices, bores: Sequence[Round], depth: float, spread: float) -> list[OpenBore]:
    """Open sections of lying bores, on the layers that are printed; the most closed bore comes first.

    Args:
        slices: of the part.
        bores: of :func:`geometry.solids.measure.rounds`; pins and bores that stand are left out.
        depth: to which light hardens resin below a layer, mm, as a whole number of layers.
        spread: by which light hardens resin beside an edge, mm.
    """
    found = []
    for bore in bores:
        axis = np.array(slices.plate_place(bore.direction)) - np.array(slices.plate_place((0.0, 0.0, 0.0)))
        if bore.hollow and abs(axis[2]) < _LYING:
            area = open_area(slices, bore, axis[:2] / np.hypot(*axis[:2]), round(depth / slices.layer), spread)
            found.append(OpenBore(bore, area / (math.pi * bore.diameter**2 / 4)))
    return sorted(found, key=lambda each: each.left)


def open_area(slices: Slices, bore: Round, along: Array, layers: int, spread: float) -> float:
    """Section of one lying bore that stays open, mm^2.

    Args:
        slices: of the part.
        bore: of it.
        along: direction of its axis on the plate, (2,) float64, of length one.
        layers: that light hardens below a layer.
        spread: see :func:`open_bores`.
    """
    x, y, z = slices.plate_place(bore.place)
    radius = bore.diameter / 2
    across = np.linspace(-radius, radius, _PLACES)
    chosen = np.flatnonzero(np.abs(slices.heights - z) < radius + (layers + 1) * slices.layer)
    solid = np.zeros((len(chosen), _PLACES), dtype=bool)
    for row, layer in enumerate(chosen.tolist()):
        low, high = _opening(slices, layer, np.array([x, y]), along)
        wide = math.sqrt(max(radius**2 - (slices.heights[layer] - z) ** 2, 0.0))
        solid[row] = (across < max(low, -wide) + spread) | (across > min(high, wide) - spread)
    cured = solid.copy()
    for step in range(1, layers + 1):
        cured[: len(cured) - step] |= solid[step:]
    return float((~cured[np.abs(slices.heights[chosen] - z) < radius]).sum() * (across[1] - across[0]) * slices.layer)


def _opening(slices: Slices, layer: int, centre: Array, along: Array) -> tuple[float, float]:
    """Ends of the air on the line across a bore through its middle; an empty stretch where material is there."""
    beside = np.array([-along[1], along[0]])
    cuts = []
    for outline in slices.sections[layer].to_polygons():
        to = outline - centre
        u, v = to @ along, to @ beside
        nu, nv = np.roll(u, -1), np.roll(v, -1)
        crossed = (u < 0) != (nu < 0)
        cuts += (v + (nv - v) * u / np.where(crossed, u - nu, 1.0))[crossed].tolist()
    before, after = [cut for cut in cuts if cut <= 0], [cut for cut in cuts if cut > 0]
    if len(after) % 2:
        return 0.0, 0.0
    return max(before, default=-math.inf), min(after, default=math.inf)
