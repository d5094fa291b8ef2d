"""Common volumes of placed parts by their facets: quick where no two pairs of parts lie to each other alike."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np

from geometry.assembly.part_list import PlacedPart
from geometry.ground.extras import check_extras

if TYPE_CHECKING:
    import cadquery as cq
    import manifold3d

#: Largest distance of facets from the solids, mm, and angle between neighbouring ones, rad.
_TOLERANCE, _FACET_ANGLE = 0.01, 0.3


class Facets:
    """Parts as facets, each tessellated when it is first asked for."""

    def __init__(self, shapes: Mapping[str, cq.Shape]) -> None:
        """Keep the solids of the parts by name."""
        check_extras("comparing parts by facets", "cad")
        self._shapes = shapes
        self._solids: dict[str, manifold3d.Manifold] = {}

    def shared(self, first: PlacedPart, second: PlacedPart) -> float:
        """Volume that two placed parts share, mm^3."""
        common = self._placed(first) ^ self._placed(second)
        return float(common.volume())

    def in_walls(self, part: PlacedPart, walls: Sequence[manifold3d.Manifold]) -> float:
        """Volume that a placed part shares with solids, mm^3."""
        return math.fsum(float((self._placed(part) ^ wall).volume()) for wall in walls)

    def _placed(self, part: PlacedPart) -> manifold3d.Manifold:
        import manifold3d

        from geometry.solids.measure import tessellate

        if part.part not in self._solids:
            found = tessellate(self._shapes[part.part], _TOLERANCE, _FACET_ANGLE, measured=False)
            corners = np.array(found.vertices, np.float64, order="C")
            triangles = np.array(found.triangles, np.uint64, order="C")
            self._solids[part.part] = manifold3d.Manifold(manifold3d.Mesh64(corners, triangles))
        return self._solids[part.part].transform(part.matrix[:3])
