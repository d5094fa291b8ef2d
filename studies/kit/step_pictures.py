"""Pictures of the steps of a build, rendered from the solids of the design itself; each PNG as bytes."""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

import numpy as np
import pyvista as pv

import geometry
from geometry.assembly.model import LOOKS, ArrayModel, PartKind
from geometry.design.shell_rules import membrane_top
from geometry.formats.part_files import SharedShape
from geometry.ground.typed import Array
from geometry.pictures.canvas import aim, draw_labels, open_plotter, polydata, save_picture
from geometry.printing.plates import Plate
from geometry.schema.print_processes import PrintProcess
from geometry.solids.measure import Tessellation
from studies.output.figure_style import crop_picture

#: Width and height of a picture before the white around it is cut away, pixels.
_SIZE = (1100, 620)
#: Colour of parts without a colour of their own, and of the plate of a printer.
_TOOL, _PLATE = "#d9c27a", "#e8ebee"
#: View from the front and above.
_FROM_ABOVE = (0.0, -1.0, 0.8)
#: View in which the angles between ports are seen.
_STEEPLY = (0.0, -1.0, 2.0)
#: Words of a picture, pixels.
_WORDS = 18
#: Colours of a body, and of what has the pockets.
_BODY, _WALL = "#8f9aa3", "#e2ddcf"
#: Length of a mean normal below which an array goes round its body; cosines of directions that are seen from straight
#: above, and of parts that face the viewer; height of their numbers above the membranes, mm.
_ROUND, _STEEP, _FACING, _RAISED = 0.2, 0.95, 0.25, 0.3
#: Parts of the sheet of parts that stand in one row, and distance of its rows by that of its columns.
_A_ROW, _ROW_APART = 5, 1.45
#: Letter on a part of a plate, pixels.
_LETTER = 13


def _png(draw: Callable[[Path], object]) -> bytes:
    """Bytes of a picture, without the white around it."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "picture.png"
        draw(path)
        crop_picture(path)
        return path.read_bytes()


def plate_picture(
    plate: Plate, shapes: Sequence[SharedShape], process: PrintProcess, marks: Mapping[str, str]
) -> bytes:
    """A plate of the printer with what lies on it, each part under its mark if it has one.

    Args:
        plate: the plate.
        shapes: facets of its parts.
        process: its build volume is the size of the plate.
        marks: letters of :func:`part_marks`, by the name of the part.
    """
    width, depth, _ = process.build_volume
    facets = {shape.names[0]: shape.facets for shape in shapes}

    def draw(path: Path) -> None:
        plotter = open_plotter(_SIZE)
        ground = pv.Plane(center=(width / 2, depth / 2, -0.2), i_size=width, j_size=depth)
        plotter.add_mesh(ground, color=_PLATE, lighting=False)
        for name, places in plate.places.items():
            mesh = pv.PolyData.from_regular_faces(facets[name].vertices, facets[name].triangles)
            copies = pv.merge([mesh.transform(place, inplace=False) for place in places])
            plotter.add_mesh(copies, color=LOOKS["shell"][0], split_sharp_edges=True, smooth_shading=True)
            if name in marks:
                tops = [_over(mesh.transform(place, inplace=False)) for place in places]
                draw_labels(plotter, tops, [marks[name]] * len(tops), _LETTER)
        aim(plotter, (0.0, -0.5, 1.0))
        save_picture(plotter, path)

    return _png(draw)


def part_marks(model: ArrayModel) -> dict[str, str]:
    """Letters by which the picture of the parts and the table beside it call the printed parts of the array."""
    parts = model.parts
    names = [name for name in parts if parts.kinds[name] in ("shell", "carrier", "housing") and parts.counts[name]]
    return {name: chr(ord("A") + number % 26) * (number // 26 + 1) for number, name in enumerate(names)}


def parts_picture(model: ArrayModel) -> bytes:
    """Every distinct printed part of the array with its letter and number, as it stands in its file."""
    parts, marks = model.parts, part_marks(model)
    names = list(marks)

    def draw(path: Path) -> None:
        plotter = open_plotter(_SIZE)
        boxes = [parts[name].val().BoundingBox() for name in names]
        step = 1.6 * max(max(box.xlen, box.ylen) for box in boxes)
        for number, (name, box) in enumerate(zip(names, boxes, strict=True)):
            row, column = divmod(number, _A_ROW)
            middle = np.array([column * step, -_ROW_APART * row * step, 0.0])
            centre = np.array([box.xmin + box.xmax, box.ymin + box.ymax, 2 * box.zmin]) / 2
            mesh = polydata(parts[name].val()).translate(middle - centre)
            # Shells are drawn as glass, because they differ only in the ports within their walls.
            colour, opacity = LOOKS.get(parts.kinds[name], LOOKS["shell"])
            plotter.add_mesh(mesh, color=colour, opacity=opacity, split_sharp_edges=True, smooth_shading=True)
            anchor = (float(middle[0]), float(middle[1]) - 0.62 * step, 0.0)
            draw_labels(plotter, [anchor], [f"{marks[name]}: {parts.counts[name]} x"], 22, ("center", "top"))
        aim(plotter, _STEEPLY, left=0.12, right=0.12)
        save_picture(plotter, path)

    return _png(draw)


def mold_picture(model: ArrayModel) -> bytes:
    """The parts of the mold above each other."""
    return _png(lambda path: geometry.pictures.open_mold(model, path, _SIZE))


def order_picture(model: ArrayModel) -> bytes:
    """The array from above with the numbers of its points and the names of its microphones."""
    return _png(lambda path: geometry.pictures.top_view(model, path, (1300, 800)))


def array_picture(model: ArrayModel) -> bytes:
    """The finished array."""
    return _png(lambda path: geometry.pictures.draw_array(model, path, (1300, 760)))


def body_picture(model: ArrayModel, shown: Mapping[str, Tessellation]) -> bytes:
    """The body of an array with the array lying in its skin or in its pockets, seen from the middle of the array.

    Args:
        model: the array.
        shown: facets of the body and of its skin by name, as :class:`studies.kit.body_files.BodyFiles` holds them.
    """
    frames = [model.layout.frame(point) for point in model.layout.points]
    middle = np.mean([frame.axes[2] for frame in frames], axis=0)
    # An array all round a body has no middle: it is seen from its side.
    towards = middle / np.linalg.norm(middle) if np.linalg.norm(middle) > _ROUND else np.array(frames[0].axes[2])
    upwards = (0.0, 0.0, 1.0) if abs(towards[2]) < _STEEP else (0.0, 1.0, 0.0)

    def draw(path: Path) -> None:
        plotter = open_plotter(_SIZE)
        for name, facets in shown.items():
            mesh = pv.PolyData.from_regular_faces(facets.vertices, facets.triangles)
            colour = _BODY if name == "body" else _WALL
            plotter.add_mesh(mesh, color=colour, split_sharp_edges=True, smooth_shading=True)
        for part in model.placed:
            mesh = _placed(model, part.part, part.matrix)
            plotter.add_mesh(mesh, color=LOOKS[part.kind][0], split_sharp_edges=True, smooth_shading=True)
        layout = model.layout
        names = [*(str(point.number) for point in layout.points), *(each.name for each in layout.microphones)]
        frames = [*map(layout.frame, layout.points), *map(layout.frame, layout.microphones)]
        front = [k for k, frame in enumerate(frames) if np.dot(frame.axes[2], towards) > _FACING]
        height = membrane_top(model.design) + _RAISED
        anchors = [tuple(frames[k].at(0.0, 0.0, height).tolist()) for k in front]
        draw_labels(plotter, anchors, [names[k] for k in front], _WORDS, ("center", "center"))
        aim(plotter, tuple(towards.tolist()), upwards)
        save_picture(plotter, path)

    return _png(draw)


def membrane_picture(model: ArrayModel) -> bytes:
    """A shell with its membrane above the seat."""
    point = model.layout.points[0].number
    return _stack_picture(model, f"point {point}", ("shell", "membrane"), {"shell": "shell", "membrane": "membrane"})


def microphone_picture(model: ArrayModel) -> bytes:
    """A housing with its board and its microphone above it."""
    name = model.layout.microphones[0].name
    words = {"housing": "housing, seat upwards", "board": "board", "package": "microphone, sound hole downwards"}
    return _stack_picture(model, f"microphone {name}", ("housing", "board", "package"), words)


def joint_picture(model: ArrayModel) -> bytes:
    """The first tube of a line before it is pushed into its sockets: shell, spring, sheath."""
    line = model.layout.points[0]
    group = f"point {line.number}"
    tubes = [part for part in model.placed if part.kind == "sheath"]
    if not tubes:
        return order_picture(model)
    own = next(part for part in model.placed if part.group == group and part.kind == "shell")
    near = min(tubes, key=lambda part: float(np.linalg.norm(np.array(part.position) - np.array(own.position))))

    def draw(path: Path) -> None:
        plotter = open_plotter(_SIZE)
        inwards = np.linalg.inv(own.matrix)
        away = np.zeros(3)
        for part in model.placed:
            if part.group not in (group, near.group) or part.kind == "membrane":
                continue
            mesh = _placed(model, part.part, inwards @ part.matrix)
            if part.group == near.group:
                if not away.any():
                    middle = np.array(mesh.center) * (1, 1, 0)
                    away = middle / np.linalg.norm(middle)
                mesh = mesh.translate(away * (3.0 if part.kind == "sheath" else 8.0))
            colour, opacity = LOOKS[part.kind]
            plotter.add_mesh(mesh, color=colour, opacity=opacity, split_sharp_edges=True, smooth_shading=True)
            draw_labels(plotter, [_above(mesh)], [part.kind], _WORDS, ("center", "bottom"))
        aim(plotter, (-away[1] or 0.2, away[0] - 0.4, 0.9), left=0.05, right=0.05)
        save_picture(plotter, path)

    return _png(draw)


def _stack_picture(model: ArrayModel, group: str, kinds: Sequence[PartKind], words: dict[str, str]) -> bytes:
    """Parts of one group, one lifted above the other, with their names."""
    placed = {part.kind: part for part in model.placed if part.group == group}
    own = placed[kinds[0]]

    def draw(path: Path) -> None:
        plotter = open_plotter(_SIZE)
        inwards, top = np.linalg.inv(own.matrix), -np.inf
        for kind in kinds:
            part = placed[kind]
            mesh = _placed(model, part.part, inwards @ part.matrix)
            low, high = mesh.bounds[4], mesh.bounds[5]
            if np.isfinite(top):
                mesh = mesh.translate((0.0, 0.0, top - low + 0.5 * (high - low) + 1.5))
            top = mesh.bounds[5]
            colour, opacity = LOOKS[kind]
            plotter.add_mesh(mesh, color=colour, opacity=opacity, split_sharp_edges=True, smooth_shading=True)
            anchor = (float(mesh.bounds[1]) + 0.5, 0.0, float(mesh.center[2]))
            draw_labels(plotter, [anchor], [words[kind]], 26, ("left", "center"))
        aim(plotter, (0.2, -1.0, 0.5), left=0.1, right=0.45)
        save_picture(plotter, path)

    return _png(draw)


def _placed(model: ArrayModel, name: str, matrix: Array) -> pv.PolyData:
    return polydata(model.shapes[name]).transform(matrix, inplace=False)


def _above(mesh: pv.PolyData) -> tuple[float, float, float]:
    """Place above the middle of a mesh."""
    x, y, top = _over(mesh)
    return x, y, top + 0.4


def _over(mesh: pv.PolyData) -> tuple[float, float, float]:
    """Middle of the top of a mesh."""
    x, y, _ = mesh.center
    return float(x), float(y), float(mesh.bounds[5])
