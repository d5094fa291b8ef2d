"""Layers of a part as a slicer cuts them: islands, reach of overhangs, walls under two pixels. Lengths in mm."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array
from geometry.printing.overhangs import Overhang, Place, Skin

if TYPE_CHECKING:
    from manifold3d import CrossSection

    from geometry.solids.measure import Tessellation

#: Facets whose normals are flatter than this are upright: they do not change the section from layer to layer.
_UPRIGHT = 1e-9
#: Layers in a row in which a thin wall must be there: a rounded top is thin in one or two.
_LASTING = 3
#: Outlines are simplified within this part of a pixel.
_ROUGH = 0.05
#: Corners of a circle when outlines are moved, and the play that this roughness needs, as a fraction.
_CIRCLE, _PLAY = 24, 0.03
#: The bracket of a wall's width is halved so often, that of an overhang's reach three times more.
_HALVINGS = 9


@dataclass(frozen=True)
class Island:
    """Material that starts in the air: nothing of the layer below touches it."""

    layer: int
    """Layer in which it starts; layers count from 0 at the plate."""
    area: float
    """Area in that layer, mm^2."""
    place: Place
    """Middle of it, in the part's own coordinates, mm."""


@dataclass(frozen=True)
class ThinWall:
    """Material narrower than two pixels in at least three layers in a row."""

    width: float
    """Widest circle that fits into it has this diameter, mm."""
    area: float
    """Area in one layer, mm^2."""
    place: Place
    """Middle of it, in the part's own coordinates, mm."""


class Slices:
    """Sections of a part at the middle of every layer, as it lies on the plate.

    Args:
        facets: of the part, one closed body.
        rotation: from the part's own directions to those of the plate, (3, 3) float64.
        layer: height of a layer, mm.
        pixel: width of a pixel, mm; what is smaller than a pixel is not printed.

    Raises:
        Refusal: the facets do not enclose one body.
    """

    def __init__(self, facets: Tessellation, rotation: Array, layer: float, pixel: float) -> None:
        import manifold3d

        turned = facets.vertices @ rotation.T
        self.layer, self.pixel = layer, pixel
        self._rotation, self._bottom = rotation, float(turned[:, 2].min())
        self._extent = float(np.ptp(turned, axis=0).max())
        height = float(np.ptp(turned[:, 2]))
        #: Heights of the sections above the plate, (n_layer,) float64, mm.
        self.heights = (np.arange(max(int(np.ceil(height / layer - 0.5)), 1)) + 0.5) * layer
        triangles = facets.triangles.astype(np.uint64)
        self._body = manifold3d.Manifold(manifold3d.Mesh64(np.ascontiguousarray(turned), triangles))
        if self._body.is_empty():
            raise Refusal("cannot be cut into layers: its facets do not enclose one body", kind=Kind.NO_RESULT)
        self._changes = self._changing(turned, Skin(facets), rotation)

    def _changing(self, turned: Array, skin: Skin, rotation: Array) -> Array:
        """True for each layer whose section may differ from that of the layer below, (n_layer,) bool."""
        steep = np.abs(skin.normals @ rotation[2]) > _UPRIGHT
        heights = turned[skin.triangles[steep]][:, :, 2] - self._bottom
        first = np.searchsorted(self.heights, heights.min(axis=1) - 1e-9)
        last = np.searchsorted(self.heights, heights.max(axis=1) + 1e-9)
        count = np.zeros(len(self.heights) + 2, dtype=np.int64)
        np.add.at(count, first, 1)
        np.add.at(count, np.minimum(last + 1, len(self.heights) + 1), -1)
        changes = np.cumsum(count)[: len(self.heights)] > 0
        changes[0] = True
        return np.asarray(changes)

    @cached_property
    def sections(self) -> list[CrossSection]:
        """Sections of all layers from the plate on; equal neighbours are one object."""
        found: list[CrossSection] = []
        for height, changes in zip(self.heights.tolist(), self._changes.tolist(), strict=True):
            if changes:
                found.append(self._body.slice(height + self._bottom).simplify(_ROUGH * self.pixel))
            else:
                found.append(found[-1])
        return found

    def part_place(self, x: float, y: float, layer: int) -> Place:
        """Position in the part's own coordinates of a position on the plate in a layer, mm."""
        px, py, pz = (np.array([x, y, self.heights[layer] + self._bottom]) @ self._rotation).tolist()
        return px, py, pz

    def plate_place(self, place: Place) -> Place:
        """Position on the plate of a position in the part's own coordinates; z counts from the plate, mm."""
        x, y, z = (self._rotation @ np.array(place)).tolist()
        return x, y, z - self._bottom

    def _pairs(self) -> Iterator[tuple[int, CrossSection, CrossSection]]:
        """Layers that differ from the layer below: number, section, what of the layer below is printed."""
        printed = self.sections[0]
        for layer in range(1, len(self.sections)):
            section = self.sections[layer]
            if section is self.sections[layer - 1]:
                continue
            yield layer, section, printed
            specks = [one for one in section.decompose() if one.area() < self.pixel**2 and (one ^ printed).is_empty()]
            printed = section
            for speck in specks:  # less than a pixel that hangs in the air is no support of what comes next
                printed -= speck

    def islands(self) -> list[Island]:
        """Every place at which material starts in the air, from the plate on."""
        found = []
        for layer, section, below in self._pairs():
            if (section - below).area() < self.pixel**2:
                continue
            for one in section.decompose():
                if one.area() >= self.pixel**2 and (one ^ below).is_empty():
                    found.append(Island(layer, one.area(), self.part_place(*middle_of(one), layer)))
        return found

    def overhang(self, angle: float) -> Overhang:
        """Farthest that a layer reaches beyond the layer below: `span` is that distance, mm.

        Faces steeper than ``angle`` and islands, which rest on nothing, are not counted.

        Args:
            angle: from the horizontal, degrees.
        """
        free = self.layer / math.tan(math.radians(angle))
        farthest, place, area = 0.0, None, 0.0
        for layer, section, below in self._pairs():
            if below.is_empty() or (section - below).area() < self.pixel**2:
                continue
            beyond = section - _moved(below, free)
            for one in section.decompose():
                if (one ^ below).is_empty():
                    beyond -= one
            if beyond.area() < self.pixel**2:
                continue
            area += beyond.area()
            if (beyond - _moved(below, max(farthest, free))).is_empty():
                continue
            low, high = max(farthest, free), self._extent
            for _ in range(_HALVINGS + 3):
                try_at = (low + high) / 2
                left = beyond - _moved(below, try_at)
                if left.is_empty():
                    high = try_at
                else:
                    low, beyond = try_at, left
            farthest, place = float(low + high) / 2, self.part_place(*middle_of(beyond), layer)
        return Overhang(farthest, place, area)

    def thin_walls(self) -> list[ThinWall]:
        """Walls narrower than two pixels that last for three layers or more, the largest area first."""
        found: list[ThinWall] = []
        chain: list[CrossSection] = []  # thin in this layer, in this and the one below, and so on
        thin, last = self._thin(self.sections[0]), None
        for layer, section in enumerate(self.sections):
            if layer and section is not self.sections[layer - 1]:
                thin = self._thin(section)
            chain = [thin, *(one ^ thin for one in chain)][:_LASTING]
            lasting = chain[-1] if len(chain) == _LASTING else None
            if lasting is not None and not lasting.is_empty() and section is not last:
                last = section
                for one in lasting.decompose():
                    if one.area() > 4 * self.pixel**2:
                        place = self.part_place(*middle_of(one), layer)
                        found.append(ThinWall(_width(one, self.pixel), one.area(), place))
        return sorted(found, key=lambda wall: -wall.area)

    def _thin(self, section: CrossSection) -> CrossSection:
        """Stretches of a section that are narrower than two pixels; corners, smaller than four pixels, are left out."""
        import manifold3d

        opened = _moved(_moved(section, -self.pixel), self.pixel * (1 + _PLAY))
        pieces = [one for one in (section - opened).decompose() if one.area() > 4 * self.pixel**2]
        return manifold3d.CrossSection.compose(pieces) if pieces else manifold3d.CrossSection()


def middle_of(section: CrossSection) -> tuple[float, float]:
    """Corner of the outline of a section that is nearest its middle, mm."""
    outline = max(section.to_polygons(), key=len)
    centre = outline.mean(axis=0)
    nearest = outline[int(np.argmin(np.linalg.norm(outline - centre, axis=1)))]
    x, y = nearest.tolist()
    return x, y


def _moved(section: CrossSection, distance: float) -> CrossSection:
    """Outline moved outwards, or inwards where the distance is negative, mm."""
    import manifold3d

    return section.offset(distance, manifold3d.JoinType.Round, 2.0, _CIRCLE)


def _width(section: CrossSection, most: float) -> float:
    """Diameter of the widest circle in a section that is narrower than ``2 * most``, mm."""
    low, high = 0.0, 1.2 * most
    for _ in range(_HALVINGS):
        half = (low + high) / 2
        low, high = (low, half) if _moved(section, -half).is_empty() else (half, high)
    return low + high
