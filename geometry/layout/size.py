"""How large an array is: the box around everything that is built, as :func:`geometry.build_assembly` draws it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import DesignLike, resolve_design
from geometry.design.shell_rules import FOOT_EDGE, ledge_height, membrane_top
from geometry.ground.typed import Array
from geometry.layout.arrangement import lay_out
from geometry.layout.placement import ArrayLayout, MicrophonePlacement, TubePlacement
from geometry.layout.straight_rows import is_wide_apart, straight_size
from geometry.plan.cylinder import Frame
from geometry.plan.routing import unit
from geometry.schema.ports import foot_directions


def array_size(design: DesignLike, layout: ArrayLayout | None = None) -> tuple[float, float, float]:
    """Extent of an array in space along x, y and z, mm: shells with their feet, membranes, housings and tubes.

    Tubes that are drawn schematically do not count, for their way is not real; nor do raised digits and carriers, nor
    the heads of boards, which lie outside the housings and may be bent or cut from another board.

    Args:
        design: the array.
        layout: layout of the array, if you have it already.
    """
    design = resolve_design(design)
    if layout is None and not design.shell.feet and is_wide_apart(design):
        return straight_size(design)
    return laid_out_size(design, lay_out(design) if layout is None else layout)


def laid_out_size(design: ArrayDesign, layout: ArrayLayout) -> tuple[float, float, float]:
    """Extent of an array whose parts lie as the layout says, see :func:`array_size`."""
    low, high = array_box(design, layout)
    x, y, z = (round(float(side), 9) for side in high - low)
    return x, y, z


def array_box(design: ArrayDesign, layout: ArrayLayout) -> tuple[Array, Array]:
    """Lowest and highest x, y and z of an array whose parts lie as the layout says, each (3,) float64, mm."""
    low, high = np.full(3, np.inf), np.full(3, -np.inf)
    for ends in _ends(design, layout):
        low, high = np.minimum(low, ends.min(axis=0)), np.maximum(high, ends.max(axis=0))
    return low, high


def _ends(design: ArrayDesign, layout: ArrayLayout) -> Iterator[Array]:
    """Per kind of part, points (n, 3) in space of which none of that kind reaches further along an axis."""
    microphone, kinds = design.microphone, design.kind_of_point
    for number, kind in enumerate(design.kinds):
        points = [layout.frame(point) for point, own in zip(layout.points, kinds, strict=True) if own == number]
        yield from _shells(design.of_kind(kind), points)
    if design.shell.feet:
        yield _feet(design, layout)
    floor = design.resonator.port_axis_height - microphone.chamber_height / 2
    housings = [layout.frame(each) for each in layout.microphones]
    chamber = microphone.chamber_diameter / 2 + microphone.wall_thickness
    seat = floor + microphone.chamber_height
    yield _upright(housings, chamber, floor - microphone.wall_thickness, seat)
    for frame, each in zip(housings, layout.microphones, strict=True):
        yield _seat(design, frame, each, seat)
    real = [tube for tube in layout.tubes if not tube.schematic]
    if real:
        yield _tubes(real)


def _shells(design: ArrayDesign, points: Sequence[Frame]) -> Iterator[Array]:
    """Ends of the shells and membranes at some places of a design whose points are alike."""
    resonator, membrane = design.resonator, design.membrane
    outer, top = resonator.outer_diameter / 2, resonator.cavity_height
    disc = resonator.cavity_diameter / 2 + membrane.rim_width
    yield _upright(points, outer, -resonator.floor_thickness, top + ledge_height(resonator, membrane, design.printing))
    yield _upright(points, disc, top, membrane_top(design))


def _upright(frames: Sequence[Frame], radius: float, bottom: float, top: float) -> Array:
    """Ends of cylinders along the z of their frames."""
    origins = np.array([frame.origin for frame in frames])
    normals = np.array([frame.axes[2] for frame in frames])
    across = radius * np.sqrt(np.maximum(1 - normals**2, 0.0))
    return np.vstack([origins + z * normals + side * across for z in (bottom, top) for side in (-1, 1)])


def _feet(design: ArrayDesign, layout: ArrayLayout) -> Array:
    """Ends of the round tips of the feet."""
    features, thickness = design.shell, design.resonator.floor_thickness
    half = features.foot_hole / 2 + FOOT_EDGE
    out = design.resonator.outer_diameter / 2 + features.foot_length - half
    tips = []
    for point in layout.points:
        ports, turn = point.turned
        frame = layout.frame(point)
        for angle in foot_directions([port.angle for port in ports], features.feet):
            along, across = out * unit(angle + turn)
            x, y, z = frame.at(along, across, 0.0).tolist()
            tips.append(Frame((x, y, z), frame.axes))
    return _upright(tips, half, -thickness, 0.0)


def _seat(design: ArrayDesign, frame: Frame, placed: MicrophonePlacement, bottom: float) -> Array:
    """Corners of the walls around the board of a microphone, which are as high as the package on it."""
    microphone = design.microphone
    x, y = unit(placed.turned[1])
    along, across = (side / 2 + microphone.board_gap + microphone.wall_thickness for side in microphone.board_size)
    top = bottom + microphone.sound_hole_length + microphone.package_height
    corners = [(i * along * x - j * across * y, i * along * y + j * across * x) for i in (-1, 1) for j in (-1, 1)]
    return np.asarray(frame.origin) + np.array([(u, v, z) for u, v in corners for z in (bottom, top)]) @ np.array(
        frame.axes
    )


def _tubes(tubes: Sequence[TubePlacement]) -> Array:
    """Ends of the discs across tubes along their ways; what of them is in a wall reaches less far than the wall."""
    path = np.vstack([tube.course for tube in tubes])
    sizes = [len(tube.course) for tube in tubes]
    radius = np.repeat([tube.tube.outer_diameter / 2 for tube in tubes], sizes)[:-1, None]
    owner = np.repeat(np.arange(len(tubes)), sizes)
    within = owner[1:] == owner[:-1]
    steps = np.diff(path, axis=0)[within]
    along = steps / np.linalg.norm(steps, axis=1, keepdims=True)
    across = radius[within] * np.sqrt(np.maximum(1 - along**2, 0.0))
    return np.vstack([path[part][within] + side * across for part in (slice(-1), slice(1, None)) for side in (-1, 1)])
