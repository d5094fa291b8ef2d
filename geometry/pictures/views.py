"""Pictures of an array and of one point, rendered off screen to PNG."""

from __future__ import annotations

import itertools
import math
import os
from collections import Counter
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

import cadquery as cq
import numpy as np
import pyvista as pv

from geometry.assembly.model import LOOKS, ArrayModel, PartKind, array_model
from geometry.boards import BoardPlan, shown_board
from geometry.design.array_design import ArrayDesign
from geometry.ground.typed import Array
from geometry.layout.placement import MicrophonePlacement
from geometry.pictures.canvas import (
    aim,
    draw_dimension,
    draw_labels,
    open_plotter,
    picture_axes,
    pixel_size,
    polydata,
    save_picture,
)
from geometry.plan.cylinder import Plane
from geometry.plan.routing import unit
from geometry.solids.measure import quick_box
from geometry.solids.membrane import membranes_of

_MOLD, _SCHEMATIC = "#d9c27a", "#b08fc7"
#: Layers of the exploded view, from below.
_LEVELS: dict[PartKind, int] = {
    "base": -1,
    "shell": 0,
    "housing": 0,
    "spring": 1,
    "sheath": 2,
    "membrane": 3,
    "board": 3,
    "package": 4,
}
_PLURALS: dict[PartKind, str] = {
    "base": "base plate",
    "shell": "shells",
    "housing": "housings",
    "spring": "springs",
    "sheath": "sheaths",
    "membrane": "membranes",
    "board": "boards",
    "package": "microphones",
}
#: Arrays of more points are shown exploded in an excerpt of so many.
_MOST_EXPLODED, _EXCERPT = 24, 5
#: Parts of a picture's width that are kept for names at its left and for words at its right.
_NAMES_LEFT, _WORDS_RIGHT = 0.2, 0.12
#: Size of the names of layers, pixels, and the mean width of their letters, by this size.
_NAME_SIZE, _LETTER = 20, 0.75
#: Room between the array and what stands beside it in the top view, for the names of microphones, pixels.
_LABEL_ROOM = 90
#: Distance of a name from the head of a board, mm.
_BESIDE_HEAD = 0.5
#: Angles from which the exploded view is seen, degrees.
_STEEPEST, _FLATTEST = 27, 10
#: Tubes of a microphone lead away from the viewer where their directions add up to more than this.
_LEADS_AWAY = 0.1


def draw_array(
    array: ArrayDesign | ArrayModel, path: str | os.PathLike[str], size: tuple[int, int] = (1600, 1000)
) -> Path:
    """Render the whole array with translucent shells, numbered points and named microphones.

    Tubes drawn schematically (see :func:`geometry.layout.arrangement.lay_out`) have a colour of their own.

    Args:
        array: the design, or what :func:`geometry.assembly.model.array_model` put together of it already.
        path: of the PNG.
        size: width and height in pixels.
    """
    model = array_model(array)
    plotter = open_plotter(size)
    _add_parts(plotter, model)
    _add_schematic(plotter, model)
    x0, x1, y0, y1, _, _ = plotter.bounds
    # Tall arrays are seen from their right side, so that they lie along the picture's longer edge.
    seen_from = (0.0, -0.7, 1.0) if x1 - x0 >= y1 - y0 else (0.7, 0.0, 1.0)
    _add_labels(plotter, model, seen_from)
    aim(plotter, seen_from)
    return save_picture(plotter, path)


def top_view(
    array: ArrayDesign | ArrayModel, path: str | os.PathLike[str], size: tuple[int, int] = (1600, 1000)
) -> Path:
    """Render the whole array from straight above, with its width, depth and pitch in mm and the names of its parts.

    The pitch is that of two neighbours of the first line, with a straight tube between them if one has it, where the
    array is flat. Arguments as for :func:`draw_array`.
    """
    model = array_model(array)
    plotter = open_plotter(size)
    above, north = (0.0, 0.0, 1.0), (0.0, 1.0, 0.0)
    _add_parts(plotter, model)
    x0, x1, y0, y1, _, z1 = plotter.bounds
    _add_schematic(plotter, model)
    _add_labels(plotter, model, above)
    pixel = pixel_size(plotter, above, north, _NAMES_LEFT, _WORDS_RIGHT)
    lower_left, lower_right, upper_right = (np.array([x, y, z1]) for x, y in ((x0, y0), (x1, y0), (x1, y1)))
    draw_dimension(plotter, (lower_left, lower_right), (0.0, -_LABEL_ROOM * pixel, 0.0), f"{x1 - x0:.1f} mm", pixel)
    draw_dimension(plotter, (lower_right, upper_right), (_LABEL_ROOM * pixel, 0.0, 0.0), f"{y1 - y0:.1f} mm", pixel)
    _add_pitch(plotter, model, z1, pixel)
    _add_legend(plotter, model, (x0 - _LABEL_ROOM * pixel, (y0 + y1) / 2, z1), pixel)
    aim(plotter, above, north, left=_NAMES_LEFT - _LABEL_ROOM / size[0], right=_WORDS_RIGHT)
    return save_picture(plotter, path)


def _add_pitch(plotter: pv.Plotter, model: ArrayModel, height: float, pixel: float) -> None:
    """Dimension between two neighbours of the first line, below them or beside them."""
    points = model.design.lines[0].points
    if points < 2 or not isinstance(model.layout.surface, Plane):
        return
    begin = min(2, points - 2)  # away from the name of the first microphone
    # A bent tube brings the axes of its shells nearer than the length of a tube says.
    straight = [tube.segment - 1 for tube in model.layout.tubes if tube.line == 0 and tube.is_straight]
    between = [number for number in straight if 0 <= number <= points - 2]
    begin = min(between, key=lambda number: abs(number - begin), default=begin)
    first, second = (np.array([*point.position, height]) for point in model.layout.points[begin : begin + 2])
    step = second - first
    reach = model.design.resonator.outer_diameter / 2 + 15 * pixel
    aside = (0.0, -reach, 0.0) if abs(step[0]) >= abs(step[1]) else (reach, 0.0, 0.0)
    draw_dimension(plotter, (first, second), aside, f"pitch {np.linalg.norm(step):.4g} mm", pixel)


def _add_legend(plotter: pv.Plotter, model: ArrayModel, at: tuple[float, float, float], pixel: float) -> None:
    """Numbers and names of the parts with their colours, one below the other, left of a place."""
    counts = Counter(part.kind for part in model.placed)
    seen = [kind for kind in _PLURALS if counts[kind] and kind != "spring"]  # which lie within sheaths
    named = [(f"{counts[kind]} {_PLURALS[kind]}", LOOKS[kind][0]) for kind in seen]
    if model.schematic:
        named.append((f"{len(model.schematic)} tubes, drawn schematically", _SCHEMATIC))
    x, middle, z = at
    for row, (words, colour) in enumerate(named):
        y = middle + 30 * pixel * ((len(named) - 1) / 2 - row)
        square = pv.Plane(center=(x, y, z), direction=(0.0, 0.0, 1.0), i_size=16 * pixel, j_size=16 * pixel)
        plotter.add_mesh(square, color=colour, lighting=False)
        draw_labels(plotter, [(x - 14 * pixel, y, z)], [words], 18, ("right", "center"))


def exploded_view(
    array: ArrayDesign | ArrayModel, path: str | os.PathLike[str], size: tuple[int, int] = (1600, 1000)
) -> Path:
    """Render the array pulled apart, away from what it stands on, one layer per kind, each named with its count.

    From below: shells and housings, springs, sheaths, membranes, boards, microphones. An array of many points is shown
    by its first microphone and the points next to it. Tubes that are drawn schematically are left out.
    Arguments as for :func:`draw_array`.
    """
    model = array_model(array)
    counts = Counter(part.kind for part in model.placed)
    if model.design.point_count > _MOST_EXPLODED:
        model = _first_of(model, _EXCERPT)
    boxes = {kind: _bounds(model, kind) for kind in _LEVELS if any(p.kind == kind for p in model.placed)}
    low, high = np.min([low for low, _ in boxes.values()], axis=0), np.max([high for _, high in boxes.values()], axis=0)
    # Long sides lie across the picture.
    tall = bool(high[1] - low[1] > high[0] - low[0])
    width, depth = sorted((high - low)[:2].tolist(), reverse=True)
    thick = max(float(high[2] - low[2]) for low, high in boxes.values())
    levels = sorted({_LEVELS[kind] for kind in boxes})
    names = []
    for level in levels:
        kinds = [kind for kind, own in _LEVELS.items() if own == level and counts[kind]]
        names.append(", ".join(f"{counts[kind]} {_PLURALS[kind]}" for kind in kinds))
    # A name that begins outside the picture is left out.
    left = max(_NAMES_LEFT, _LETTER * _NAME_SIZE * (max(map(len, names)) + 1) / size[0])
    slope, step = _exploded(width, depth, thick, len(levels), size, left)
    plotter = open_plotter(size)
    _add_parts(plotter, model, {kind: step * level for kind, level in _LEVELS.items()})
    aside = 0.03 * width
    if not isinstance(model.layout.surface, Plane):
        aside += step * max(_LEVELS.values())  # its layers spread sideways too
    start = (float(high[0]), float(low[1]) - aside) if tall else (float(low[0]) - aside, float(low[1]))
    anchors = [(*start, step * level) for level in levels]
    if model.design.point_count > _MOST_EXPLODED:
        shown = f"shown: {_EXCERPT} of {model.design.point_count} points"
        plotter.add_text(shown, position=(0.02, 0.03), viewport=True, color="black", font_size=10)
    draw_labels(plotter, anchors, names, _NAME_SIZE, ("right", "center"))
    aim(plotter, (1.0, 0.25, slope) if tall else (0.25, -1.0, slope), left=left)
    return save_picture(plotter, path)


def _bounds(model: ArrayModel, kind: PartKind) -> tuple[Array, Array]:
    """Lowest and highest x, y and z of all parts of a kind, mm."""
    corners = []
    for part in model.placed:
        if part.kind == kind:
            sides = itertools.product(*quick_box(model.shapes[part.part]).T)
            corners.append(np.array(list(sides)) @ part.matrix[:3, :3].T + part.matrix[:3, 3])
    points = np.vstack(corners)
    return points.min(axis=0), points.max(axis=0)


def _exploded(
    width: float, depth: float, thick: float, layers: int, size: tuple[int, int], left: float
) -> tuple[float, float]:
    """Slope at which layers are looked at from above, and what lifts each clear of the one below, mm.

    A layer of that depth and thickness takes ``depth sin a + thick cos a`` of the picture's height at an angle ``a``,
    so that a deep array is seen flatly: as steeply as fills the picture, within what shows membranes and rows.

    Args:
        width: of the array across the picture, mm.
        depth: of the array away from the viewer, mm.
        thick: of a layer, mm.
        layers: how many lie above each other.
        size: width and height of the picture in pixels.
        left: part of its width that is kept for names.
    """
    room = width * size[1] / (size[0] * (1 - left))
    for degrees in range(_STEEPEST, _FLATTEST, -1):
        rise, lean = math.sin(math.radians(degrees)), math.cos(math.radians(degrees))
        if layers * (depth * rise + thick * lean) <= room:
            break
    # Seen a little from the side, the direction has more than 1 in the plan.
    return math.hypot(1.0, 0.25) * rise / lean, (depth * rise + thick * lean) / lean


def draw_point(
    array: ArrayDesign | ArrayModel, path: str | os.PathLike[str], size: tuple[int, int] = (1600, 1000)
) -> Path:
    """Render the parts of one point pulled apart: the shell and the membrane above it.

    A quarter of the shell is cut away to show the cavity and a port. Arguments as for :func:`draw_array`; the shell is
    the first one of the design.
    """
    model = array_model(array)
    design, parts = model.design, model.parts
    shell = next(name for name in parts if parts.kinds[name] == "shell")
    resonator = design.of_kind(design.kinds[0]).resonator
    membrane = next(name for name in membranes_of(design))
    plotter = open_plotter(size)
    seen_from = (0.25, -1.0, 0.6)
    across = picture_axes(seen_from)[0]
    solid = parts[shell].val()
    # The quarter towards the viewer; ports lie at 0 degrees and beyond, so one of them is cut in half.
    reach = 2 * (solid.BoundingBox().DiagonalLength + 1)
    quarter = cq.Solid.makeBox(reach, reach, reach, cq.Vector(0, -reach, -reach / 2))
    lifted = parts[membrane].val().moved(cq.Location(cq.Vector(0, 0, 2 * resonator.cavity_height)))
    meshes = {shell: polydata(solid.cut(quarter)), membrane: polydata(lifted)}
    width = resonator.outer_diameter
    # Names stand beside everything, to the left.
    left = min(float((mesh.points @ across).min()) for mesh in meshes.values())
    for name, mesh in meshes.items():
        plotter.add_mesh(mesh, color=_look(parts.kinds[name])[0], split_sharp_edges=True, smooth_shading=True)
        outermost = mesh.points[int(np.argmin(mesh.points @ across))]
        end = outermost + (left - 0.06 * width - outermost @ across) * across
        plotter.add_mesh(pv.Line(outermost, end), color="black", line_width=1)
        draw_labels(plotter, [tuple((end - 0.01 * width * across).tolist())], [name], 22, ("right", "center"))
    aim(plotter, seen_from, left=_WORDS_RIGHT)
    return save_picture(plotter, path)


def _look(kind: PartKind) -> tuple[str, float]:
    """Colour and opacity of a part."""
    return LOOKS.get(kind, (_MOLD, 1.0))


def _first_of(model: ArrayModel, count: int) -> ArrayModel:
    """The first points of the first line with their tubes and the line's first microphone."""
    line = model.design.lines[0]
    count = min(count, line.points)
    tubes = [tube.label for tube in model.layout.tubes if tube.line == 0 and tube.segment < count]
    groups = {*tubes, *(f"point {k + 1}" for k in range(count))}
    if not any(tube.line == 0 and tube.segment == 0 for tube in model.schematic):
        groups.add(f"microphone {line.between[0]}")
    return replace(model, placed=tuple(part for part in model.placed if part.group in groups))


def _add_parts(plotter: pv.Plotter, model: ArrayModel, lifted: Mapping[PartKind, float] | None = None) -> None:
    """All placed parts, each kind raised away from what the array stands on (mm)."""
    copies: dict[str, list[Array]] = {}
    kinds = {placed.part: placed.kind for placed in model.placed}
    for placed in model.placed:
        matrix = placed.matrix
        if lifted:
            matrix[:3, 3] += lifted[placed.kind] * model.layout.surface.outwards(matrix[:3, 3])
        copies.setdefault(placed.part, []).append(matrix)
    for name, matrices in copies.items():
        colour, opacity = LOOKS[kinds[name]]
        mesh = _copies(polydata(model.shapes[name]), matrices)
        plotter.add_mesh(mesh, color=colour, opacity=opacity, split_sharp_edges=True, smooth_shading=True)


def _copies(mesh: pv.PolyData, matrices: list[Array]) -> pv.PolyData:
    """One mesh of all copies, each moved by a (4, 4) matrix."""
    points = [mesh.points @ matrix[:3, :3].T + matrix[:3, 3] for matrix in matrices]
    triangles = [mesh.regular_faces + count * mesh.n_points for count in range(len(matrices))]
    return pv.PolyData.from_regular_faces(np.vstack(points), np.vstack(triangles))


def _add_schematic(plotter: pv.Plotter, model: ArrayModel) -> None:
    meshes = [
        pv.MultipleLines(tube.course).tube(radius=tube.tube.outer_diameter / 2, n_sides=16) for tube in model.schematic
    ]
    if meshes:
        plotter.add_mesh(pv.merge(meshes), color=_SCHEMATIC, smooth_shading=True)


def _name_at_head(
    plotter: pv.Plotter, model: ArrayModel, placed: MicrophonePlacement, board: BoardPlan, towards: Array
) -> None:
    """Name of a microphone beyond the head of its board, or below a head that lies across the picture.

    ``towards`` is the direction of the viewer in the plane of the array, (2,) float64.
    """
    microphone = model.design.microphone
    along, reach = -unit(placed.turned[1]), -board.head[0][0]
    down = float(along @ towards)
    if abs(down) > math.sqrt(0.5):
        place, vertical = (reach + _BESIDE_HEAD) * along, "top" if down > 0 else "bottom"
        height = model.design.resonator.port_axis_height + microphone.chamber_height / 2
    else:
        seat = microphone.board_size[1] / 2 + microphone.board_gap + microphone.wall_thickness
        place = reach / 2 * along + (max(seat, board.head[1][1]) + _BESIDE_HEAD) * towards
        vertical, height = "top", -model.design.resonator.floor_thickness
    anchor = tuple(model.layout.frame(placed).at(float(place[0]), float(place[1]), height).tolist())
    draw_labels(plotter, [anchor], [f"mic {placed.name}"], 20, ("center", vertical))


def _add_labels(plotter: pv.Plotter, model: ArrayModel, seen_from: tuple[float, float, float]) -> None:
    design, layout = model.design, model.layout
    alike = [design.of_kind(kind) for kind in design.kinds]
    tops = [each.resonator.cavity_height + each.membrane.total_height for each in alike]
    top = max(tops)
    numbers = [
        tuple(layout.frame(point).at(0.0, 0.0, tops[kind]).tolist())
        for point, kind in zip(layout.points, design.kind_of_point, strict=True)
    ]
    draw_labels(plotter, numbers, [str(point.number) for point in layout.points], 16)
    # Names stand behind their housing as seen in the picture, before it where its tubes lead away from the viewer.
    towards = np.array(seen_from[:2])
    towards = towards / np.linalg.norm(towards) if towards.any() else np.array([0.0, -1.0])
    housing = design.microphone.chamber_diameter + 2 * design.microphone.wall_thickness
    reach = max(0.8 * housing, design.resonator.outer_diameter / 2)
    board = shown_board(design)
    if board is not None:
        for microphone in layout.microphones:
            _name_at_head(plotter, model, microphone, board, towards)
        return
    for microphone in layout.microphones:
        before = sum(float(unit(port.angle) @ towards) for port in microphone.ports) < -_LEADS_AWAY
        x, y = (reach if before else -reach) * towards
        height = -design.resonator.floor_thickness if before else top
        anchor = tuple(layout.frame(microphone).at(float(x), float(y), height).tolist())
        draw_labels(plotter, [anchor], [f"mic {microphone.name}"], 20, ("center", "top" if before else "bottom"))
