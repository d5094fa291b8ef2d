"""The whole array as solids: made and bought parts, each distinct shape once, and where every copy lies."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

import geometry
from geometry.assembly.facets import Facets
from geometry.assembly.part_list import PartKind, PartSet, PlacedPart, draw_parts
from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import DesignLike, resolve_design
from geometry.ground.typed import Array
from geometry.layout.arrangement import lay_out
from geometry.layout.placement import ArrayLayout, TubePlacement
from geometry.solids.membrane import build_membrane, membranes_of
from geometry.solids.tube import TubePiece, build_tube, piece_of

if TYPE_CHECKING:
    import cadquery as cq

#: Colour and opacity of each kind of part in pictures and models; solids in CAD files are opaque.
LOOKS: dict[PartKind, tuple[str, float]] = {
    "shell": ("#9fb8cc", 0.45),
    "membrane": ("#e39a7b", 0.6),
    "spring": ("#c9a227", 1.0),
    "sheath": ("#4a4a4a", 1.0),
    "housing": ("#4f7f6b", 1.0),
    "board": ("#2f2f2f", 1.0),
    "package": ("#b8b8b8", 1.0),
    "base": ("#c8c4b7", 1.0),
}


@dataclass(frozen=True)
class ArrayModel:
    """An array put together."""

    design: ArrayDesign
    """Design that it was drawn from."""
    layout: ArrayLayout
    """Positions of all parts."""
    parts: PartSet
    """Made parts, as :func:`geometry.build_parts` draws them."""
    shapes: Mapping[str, cq.Shape]
    """Each distinct part by name, in its own coordinates, mm."""
    placed: tuple[PlacedPart, ...]
    """Every copy of every part."""
    schematic: tuple[TubePlacement, ...]
    """Tubes that are not among the parts, since their way is drawn for the eye only."""

    @cached_property
    def facets(self) -> Facets:
        """Facets of the parts, which comparisons share."""
        return Facets(self.shapes)


def array_model(
    array: DesignLike | ArrayModel, parts: PartSet | None = None, layout: ArrayLayout | None = None
) -> ArrayModel:
    """Put an array together from its printed and cast parts, its tubes and its microphones.

    Membranes are shown as mounted, stretched where the design stretches them.

    Args:
        array: the design; what is put together already is returned as it is.
        parts: parts from :func:`geometry.build_parts`, if you have them already.
        layout: layout of the array, if you have it already.

    Raises:
        Refusal: a part is not one valid solid.
    """
    if isinstance(array, ArrayModel):
        return array
    design = resolve_design(array, "array")
    layout = lay_out(design) if layout is None else layout
    return put_together(design, layout, draw_parts(design, layout) if parts is None else parts)


def put_together(design: ArrayDesign, layout: ArrayLayout, parts: PartSet) -> ArrayModel:
    """Array of parts that are drawn, where the layout says, see :func:`array_model`."""
    shapes = {name: parts[name].val() for name in dict.fromkeys(part.part for part in parts.placed)}
    if design.membrane.stretch != 1:
        shapes |= {name: _mounted_membrane(alike) for name, alike in membranes_of(design).items()}
    tubes, tube_shapes = _tubes(design, layout)
    packages, package = _packages(design, parts.placed)
    return ArrayModel(
        design,
        layout,
        parts,
        {**shapes, **tube_shapes, "microphone-package": package},
        (*parts.placed, *tubes, *packages),
        tuple(tube for tube in layout.tubes if tube.schematic),
    )


def build_assembly(design: DesignLike, parts: PartSet | None = None) -> cq.Assembly:
    """Array as a CadQuery assembly with a named component for each point, microphone and tube.

    Copies of a part share its shape. Tubes that are drawn schematically are left out. To write it as STEP with the
    names of its parts, use :func:`geometry.formats.step_assembly.write_step`.

    Args:
        design: the array: a design, the path of its file, or the name of a prototype.
        parts: parts from :func:`geometry.build_parts`, if you have them already.
    """
    return assembly_of(array_model(design, parts))


def assembly_of(model: ArrayModel) -> cq.Assembly:
    """An array put together as a CadQuery assembly, see :func:`build_assembly`."""
    import cadquery as cq

    root = cq.Assembly(name=model.design.name)
    groups: dict[str, cq.Assembly] = {}
    for part in model.placed:
        groups.setdefault(part.group, cq.Assembly(name=part.group)).add(
            model.shapes[part.part],
            name=component_name(model, part),
            loc=cq.Location(plane_of(part.matrix)),
            color=cq.Color(*_rgb(LOOKS[part.kind][0])),
        )
    for group in groups.values():
        root.add(group)
    return root


def component_name(model: ArrayModel, part: PlacedPart) -> str:
    """Name of a placed part in an assembly, where its group has the name of its place."""
    return part.label if part.label != part.group else f"{part.label} {part.kind}"


def plane_of(matrix: Array) -> cq.Plane:
    """The CadQuery plane of a (4, 4) float64 matrix that turns and moves, mm."""
    import cadquery as cq

    return cq.Plane(
        origin=tuple(matrix[:3, 3].tolist()), xDir=tuple(matrix[:3, 0].tolist()), normal=tuple(matrix[:3, 2].tolist())
    )


def _mounted_membrane(design: ArrayDesign) -> cq.Shape:
    """The membrane at its mounted size: lengths in the plane times the stretch, thickness at constant volume."""
    mounted = design.membrane.model_copy(update={"stretch": 1.0, "thickness": design.membrane.mounted_thickness})
    return build_membrane(design.model_copy(update={"membrane": mounted})).val()


def _tubes(design: ArrayDesign, layout: ArrayLayout) -> tuple[list[PlacedPart], dict[str, cq.Shape]]:
    placed: list[PlacedPart] = []
    shapes: dict[str, cq.Shape] = {}
    names: dict[TubePiece, str] = {}
    for tube in layout.tubes:
        if tube.schematic:
            continue
        piece, matrix = piece_of(tube.tube, tube.course, design.printing.port_lip)
        if piece not in names:
            alike = sum(name.rsplit("_", 1)[0] == piece.name for name in names.values())
            names[piece] = piece.name + (f"_{alike + 1}" if alike else "")
            spring, sheath = build_tube(piece)
            shapes[f"spring-{names[piece]}"], shapes[f"sheath-{names[piece]}"] = spring.val(), sheath.val()
        x, y, z = ((float(a), float(b), float(c)) for a, b, c in matrix[:3, :3].T)
        kinds: tuple[PartKind, ...] = ("spring", "sheath")
        for kind in kinds:
            label = f"{kind} of {tube.label}"
            at = tuple(matrix[:3, 3].tolist())
            placed.append(PlacedPart(f"{kind}-{names[piece]}", kind, label, at, 0.0, (x, y, z), tube.label))
    return placed, shapes


def _packages(design: ArrayDesign, placed: tuple[PlacedPart, ...]) -> tuple[list[PlacedPart], cq.Shape]:
    """The bought microphones: on each board, their sound hole over that of the board."""
    import cadquery as cq

    microphone, plan = design.microphone, geometry.boards.shown_board(design)
    half, side = microphone.package_length / 2, microphone.package_width / 2
    (left, front), (right, back) = ((-half, -side), (half, side)) if plan is None else plan.package
    package = cq.Solid.makeBox(right - left, back - front, microphone.package_height, cq.Vector(left, front, 0))
    packages = []
    for board in placed:
        if board.kind == "board":
            x, y, z = (np.array(board.position) + microphone.sound_hole_length * np.array(board.axes[2])).tolist()
            label = board.group.replace("microphone", "package")
            packages.append(replace(board, part="microphone-package", kind="package", label=label, position=(x, y, z)))
    return packages, package


def _rgb(colour: str) -> tuple[float, float, float]:
    red, green, blue = (int(colour[k : k + 2], 16) / 255 for k in (1, 3, 5))
    return red, green, blue
