"""Plan of a mold: the positions and sizes that base, lid, shims, plugs and scraper have in common."""

from __future__ import annotations

import math
from dataclasses import dataclass

from geometry.design.design_file import DesignLike, resolve_design
from geometry.molds.ejector_pins import Ejector, ejector_of
from geometry.molds.mold_forces import LID_THICKNESS, PRY_DEPTH, OpeningForces, opening_forces
from geometry.molds.mold_grid import cavity_grid
from geometry.schema.manufacture import Molding
from geometry.solids.membrane import membrane_profile

Spot = tuple[float, float]

#: Material around grooves and pins and below the deepest pocket, mm: stiff enough to be clamped.
MARGIN, FLOOR = 1.5, 2.0
#: What a pin stays below the top of the lid, mm.
PIN_RECESS = 0.5
#: A blind socket leaves this much of the lid and is this much deeper than its pin, mm.
SOCKET_ROOF, SOCKET_SPARE = 1.0, 0.3
#: Width of a shim around its pin and of the scraper's rails, mm.
SHIM_WIDTH, RAIL_WIDTH = 1.2, 0.8
#: Widest slot for a flat blade in the middle of a side, what stays between it and a groove or a pin, mm.
PRY_WIDTH, PRY_WALL = 10.0, 0.8
#: How much further out one of the pins stands, mm, and the corner without a pin that is cut off base and lid, mm.
PIN_SHIFT, CORNER = 1.0, 3.0
#: Plate that carries the ejector pins, mm.
PLUG_PLATE = 2.0
#: How far an overflow groove goes below the gap between the halves, mm.
_GROOVE_DEPTH = 0.6


@dataclass(frozen=True)
class MoldPlan:
    """A mold as it lies when closed, mm: the parting plane is z = 0, the cavities lie below it."""

    mold: Molding
    """Section ``mold`` of the design."""
    profile: tuple[Spot, ...]
    """Half section of a cavity, corners (radius, height) in mm with the parting plane at 0: the membrane's, turned over
    compensated for shrinkage, and deeper by the trim.
    """
    centres: tuple[Spot, ...]
    """Axes of the cavities, mm, rows along x."""
    land: tuple[float, float]
    """Inner and outer radius of a land at the parting plane, mm."""
    groove: tuple[float, float]
    """Inner and outer radius of an overflow groove at its top, in the floor of the gap, mm."""
    groove_bottom: float
    """Height of the groove's floor, mm."""
    half: tuple[float, float]
    """Half length of the block along x and y, mm."""
    bottom: float
    """Height of the block's lower face, mm."""
    pins: tuple[Spot, ...]
    """Axes of the pins, mm, on three corners, one of them further out: the lid fits in one way only."""
    pin_top: float
    """Height of the pins' tips, mm."""
    rows: int
    """Number of rows of cavities."""
    columns: int
    """Number of cavities per row."""
    ejector: Ejector | None
    """Ejector holes of one cavity; None where cavities are blind."""
    slots: tuple[float, float]
    """Width of the slots for a blade in the sides at the ends of x and at the ends of y, mm."""

    @property
    def gap(self) -> float:
        """Height of the block beside the lands: the halves touch on the lands only, mm."""
        return -self.mold.land_height

    @property
    def socket_radius(self) -> float:
        """Radius of the sockets of the pins, mm."""
        return self.mold.pin_diameter / 2 + self.mold.pin_clearance

    @property
    def forces(self) -> OpeningForces:
        """Forces that open the mold at one of its slots, at most."""
        return opening_forces(len(self.centres), self.land[1], (2 * self.half[0], 2 * self.half[1]), min(self.slots))

    @property
    def ejector_spots(self) -> tuple[Spot, ...]:
        """Axes of all ejector holes, mm."""
        spots = self.ejector.spots if self.ejector else ()
        return tuple((x + dx, y + dy) for x, y in self.centres for dx, dy in spots)

    @property
    def cavity_volume(self) -> float:
        """Volume of one cavity below the parting plane, mm^3, of its half section turned about its axis."""
        ends = (*self.profile[1:], self.profile[0])
        cones = ((a * a + a * b + b * b) * (z - y) for (a, y), (b, z) in zip(self.profile, ends, strict=True))
        return math.pi / 3 * abs(math.fsum(cones))

    @property
    def slope(self) -> float:
        """Tangent of the draft: how far a wall leans per height."""
        return math.tan(math.radians(self.mold.draft))


def plan_mold(design: DesignLike, needed: int | None = None) -> MoldPlan:
    """Lay out the mold of a design's membranes.

    Args:
        design: the array: a design, the path of its file, or the name of a prototype.
        needed: membranes to cast; by default one for every point.
    """
    design = resolve_design(design)
    mold = design.mold
    section = [(radius * mold.scale, -height * mold.scale) for radius, height in membrane_profile(design)]
    profile = tuple((radius, z - mold.trim if z < 0 else z) for radius, z in section)
    cell = _Cell.of(mold, max(r for r, _ in profile))
    rows, columns = cavity_grid(design, needed or design.point_count, cell.block, cell.forces)
    across, along = (columns - 1) * cell.pitch / 2, (rows - 1) * cell.pitch / 2
    centres = tuple(
        (column * cell.pitch - across, along - row * cell.pitch) for row in range(rows) for column in range(columns)
    )
    # One pin stands further out than the others, so that the lid fits neither turned nor upside down.
    x, y = across + cell.aside, along + cell.aside
    pins = ((x, y), (-x, y), (-x - PIN_SHIFT, -y))
    length = LID_THICKNESS - (PIN_RECESS if mold.sockets == "through" else SOCKET_ROOF + SOCKET_SPARE)
    width, depth = cell.block(rows, columns)
    deepest = min(cell.groove_bottom, min(height for _, height in profile))
    return MoldPlan(
        mold=mold,
        profile=profile,
        centres=centres,
        land=cell.land,
        groove=cell.groove,
        groove_bottom=cell.groove_bottom,
        half=(width / 2, depth / 2),
        bottom=deepest - FLOOR,
        pins=pins if mold.kind == "two-part" else (),
        pin_top=length,
        rows=rows,
        columns=columns,
        ejector=ejector_of(design, profile) if mold.ejector == "pins" else None,
        slots=cell.slots(rows, columns),
    )


@dataclass(frozen=True)
class _Cell:
    """Sizes around one cavity, mm."""

    land: Spot
    groove: Spot
    groove_bottom: float
    pitch: float
    aside: float
    """Offset of a pin from the axis of a cavity in the corner, along x and along y."""
    beside: Spot
    """Block beside the axes of the outermost cavities, along x and along y."""
    socket: float
    """Radius of a socket of a pin."""

    @classmethod
    def of(cls, mold: Molding, radius: float) -> _Cell:
        """Sizes around a cavity of a radius (mm) at the parting plane."""
        slope = math.tan(math.radians(mold.draft))
        land = (radius, radius + mold.land_width)
        inner = land[1] + mold.land_height * slope
        groove = (inner, inner + mold.groove_width)
        shim = mold.pin_diameter / 2 + mold.pin_clearance + SHIM_WIDTH
        # Pins stand on the diagonals of the corner cavities, their shims clear of the grooves.
        aside = (groove[1] + shim + 0.2) / math.sqrt(2)
        beside = groove[1] + MARGIN, groove[1] + MARGIN
        if mold.kind == "two-part":
            least = max(groove[1] + PRY_DEPTH + PRY_WALL, aside + shim + 0.3)
            beside = max(least, aside + PIN_SHIFT + shim + 0.3), least
        return cls(
            land, groove, -mold.land_height - _GROOVE_DEPTH, 2 * groove[1] + MARGIN, aside, beside, shim - SHIM_WIDTH
        )

    def block(self, rows: int, columns: int) -> Spot:
        """Length of a block of rows and columns of cavities along x and y, mm."""
        return 2 * self.beside[0] + (columns - 1) * self.pitch, 2 * self.beside[1] + (rows - 1) * self.pitch

    def slots(self, rows: int, columns: int) -> Spot:
        """Width of the slots at the ends of x and at the ends of y: they stay clear of the pins, mm."""
        ends = ((count - 1) * self.pitch / 2 + self.aside - self.socket - PRY_WALL for count in (rows, columns))
        along_x, along_y = (min(PRY_WIDTH, 2 * end) for end in ends)
        return along_x, along_y

    def forces(self, rows: int, columns: int) -> OpeningForces:
        """Forces that open a mold of rows and columns of cavities."""
        return opening_forces(rows * columns, self.land[1], self.block(rows, columns), min(self.slots(rows, columns)))
