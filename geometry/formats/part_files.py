"""Parts to files: STL, STEP and 3MF, each read back and compared with the CAD solid before it counts."""

from __future__ import annotations

import hashlib
import math
import os
import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

import geometry
from geometry.assembly.part_list import part_set
from geometry.formats.three_mf import Body, read_3mf, write_3mf
from geometry.ground.argument_checks import check_choice, check_range
from geometry.ground.refusal import Kind, Refusal, counted
from geometry.ground.whole_files import made_folder, whole_file

if TYPE_CHECKING:
    import cadquery as cq
    import trimesh

    from geometry.solids.measure import Tessellation

#: Formats of part files, by the ending of their names.
FORMATS = ("stl", "step", "3mf")
#: A file whose volume differs more than this from the CAD solid is refused.
LARGEST_VOLUME_ERROR = 0.001
#: Facets are made finer until the volume of their body keeps this.
_VOLUME_ERROR_AIM = 0.0008
#: How often they are made finer, each time by half.
_REFINEMENTS = 3
#: Facets stay this part of the narrowest hole's diameter from the surface.
_TOLERANCE_IN_HOLES = 1 / 50


@dataclass(frozen=True)
class ExportedFile:
    """A file that was written and read back; STEP is exact and has no facets."""

    path: Path
    """Path of the file."""
    part: str
    """Name of the part."""
    format: str
    """Format of the file, one of :data:`FORMATS`."""
    triangles: int | None
    """Number of facets; None of a STEP file."""
    linear_deviation: float | None
    """Largest distance of the facets' edges from the CAD surface, mm; None of a STEP file."""
    cad_volume: float
    """Volume of the CAD solid, mm^3."""
    mesh_volume: float
    """Volume of what the file holds, mm^3."""
    count: int = 1
    """How many to make, of all parts of this shape."""
    also: tuple[str, ...] = ()
    """Names of other parts of the same shape: they have no file of their own."""

    @property
    def volume_error(self) -> float:
        """Relative difference of the file's volume from the CAD volume."""
        return self.mesh_volume / self.cad_volume - 1


def tessellation_tolerance(parts: Mapping[str, cq.Workplane]) -> float:
    """Absolute tolerance for a set of parts, mm: a fiftieth of the narrowest hole, or of the thinnest part."""
    holes = [diameter for part in parts.values() for diameter in geometry.solids.hole_diameters(_shape(part))]
    if holes:
        return min(holes) * _TOLERANCE_IN_HOLES
    boxes = [_shape(part).BoundingBox() for part in parts.values()]
    return min(min(box.xlen, box.ylen, box.zlen) for box in boxes) * _TOLERANCE_IN_HOLES


def export(
    parts: Mapping[str, cq.Workplane],
    folder: str | os.PathLike[str],
    formats: Iterable[str] = FORMATS,
    tolerance: float | None = None,
    progress: Callable[[str, float], None] | None = None,
    shapes: Sequence[SharedShape] | None = None,
) -> tuple[ExportedFile, ...]:
    """Write each shape to ``folder/NAME.FORMAT``, in mm; existing files are replaced only by complete ones.

    Facets keep an absolute tolerance and are made anew at every call. STL is binary; 3MF carries the unit, the
    part's name and, for parts from :func:`geometry.build_parts`, what it was generated from. Parts of one shape
    are written once, under the name of the first, with the count of all.

    Args:
        parts: name to workplane with one solid, mm.
        folder: a folder, created if needed.
        formats: of ``stl``, ``step``, ``3mf``.
        tolerance: largest distance of facets from the surface, mm; default: see :func:`tessellation_tolerance`.
        progress: called with what of which part is being made, and the fraction done.
        shapes: shapes from :func:`tessellate_distinct`, if you have them already; they have their own tolerance.

    Returns:
        One record per file, parts in their order, formats in the order given.

    Raises:
        Refusal: an unknown format, no parts, a tolerance that is not above 0, a name that cannot be a file
            name, or a file that is not one closed body with the part's bores and volume.
        OSError: the folder cannot be written.
    """
    formats = tuple(dict.fromkeys(formats))
    for format_ in formats:
        check_choice("formats", format_, FORMATS, kind=Kind.UNKNOWN)
    if not parts or not formats:
        raise Refusal("is empty", kind=Kind.MISSING, field="formats" if parts else "parts")
    for name in parts:
        if not re.fullmatch(r"[A-Za-z0-9][A-Za-z0-9._-]*", name):
            allowed = "a name of letters, digits, '.', '_' and '-', since files are called by it"
            raise Refusal(kind=Kind.OUT_OF_RANGE, field="parts", value=name, allowed=allowed)
    if tolerance is not None:
        check_range("tolerance", tolerance, 0, math.inf, "mm", excluded="both")
    folder = made_folder(folder)
    shapes = tessellate_distinct(parts, tolerance, progress) if shapes is None else shapes
    known = part_set(parts)
    files = []
    for index, shared in enumerate(shapes):
        name, shape, facets = shared.names[0], _shape(parts[shared.names[0]]), shared.facets
        if progress is not None:
            progress(f"files of {name}", 0.4 + 0.6 * index / len(shapes))
        for format_ in formats:
            path = folder / f"{name}.{format_}"
            with whole_file(path) as beside:
                if format_ == "step":
                    _write_step(shape, name, beside, path)
                    record = _checked_step(shape, name, beside, path)
                elif format_ == "stl":
                    _mesh(facets).export(beside, file_type="stl")
                    record = _checked_mesh(_read_stl(beside), facets, shape, name, path)
                else:
                    body = Body(name, facets, known.parameters.get(name, {}))
                    write_3mf([body], name, beside, design_toml=known.design_toml)
                    record = _checked_mesh(_read_only_body(beside, name), facets, shape, name, path)
            files.append(replace(record, count=shared.count, also=shared.names[1:]))
    return tuple(files)


@dataclass(frozen=True)
class SharedShape:
    """A shape, the parts that have it, and how many of them there are."""

    names: tuple[str, ...]
    """Names of the parts, in order."""
    count: int
    """How many to make, of all of them."""
    facets: Tessellation
    """Facets of the shape."""


def tessellate_distinct(
    parts: Mapping[str, cq.Workplane],
    tolerance: float | None = None,
    progress: Callable[[str, float], None] | None = None,
) -> tuple[SharedShape, ...]:
    """Facets of every distinct shape of a set of parts, in order of first use.

    Facets start at the tolerance and are made finer where the volume asks for it. Two parts share a shape where
    their facets are the same.

    Args:
        parts: name to workplane with one solid, mm.
        tolerance: largest distance of facets from the surface, mm; default: see :func:`tessellation_tolerance`.
        progress: called with the part and a fraction that ends at 0.4, when its file is yet to be written.

    Raises:
        Refusal: a part that is not one valid solid.
    """
    counts = part_set(parts).counts
    tolerance = tessellation_tolerance(parts) if tolerance is None else tolerance
    shared: dict[bytes, SharedShape] = {}
    for index, (name, part) in enumerate(parts.items()):
        if progress is not None:
            progress(f"facets of {name}", 0.4 * index / len(parts))
        shape = _shape(part)
        if len(shape.Solids()) != 1 or not shape.isValid():
            problem = f"must be one valid solid; it has {counted(len(shape.Solids()), 'solid')}"
            raise Refusal(problem, kind=Kind.UNSUITABLE, field=f"parts.{name}")
        facets = _fine_enough(shape, tolerance)
        # Vertices are sorted by their coordinates, so equal shapes get equal numbers.
        corners = np.unique(np.sort(facets.triangles, axis=1), axis=0)
        key = hashlib.sha256(facets.vertices.round(6).tobytes() + corners.tobytes()).digest()
        known = shared.get(key)
        count = counts.get(name, 1)
        shared[key] = (
            SharedShape((name,), count, facets)
            if known is None
            else replace(known, names=(*known.names, name), count=known.count + count)
        )
    return tuple(shared.values())


def _fine_enough(shape: cq.Shape, tolerance: float) -> Tessellation:
    volume = shape.Volume()
    for halving in range(_REFINEMENTS + 1):
        facets = geometry.solids.tessellate(shape, tolerance / 2**halving, geometry.solids.FACET_ANGLE / 2**halving)
        if abs(facets.volume / volume - 1) <= _VOLUME_ERROR_AIM:
            break
    return facets


def _shape(part: cq.Workplane) -> cq.Shape:
    shape: Any = part.val()
    return shape


# -- checks -----------------------------------------------------------------------------------------------
def _checked_mesh(mesh: trimesh.Trimesh, facets: Tessellation, shape: cq.Shape, name: str, path: Path) -> ExportedFile:
    if not mesh.is_volume or mesh.body_count != 1:
        raise Refusal(
            f"is not one closed body (closed: {mesh.is_watertight}, bodies: {mesh.body_count})",
            kind=Kind.NO_RESULT,
            file=path,
            remedy="the part has features finer than the tessellation",
        )
    through = geometry.solids.genus(shape)
    if mesh.euler_number != 2 - 2 * through:
        problem = f"has Euler number {mesh.euler_number} for {counted(through, 'hole')} through the part"
        raise Refusal(f"{problem}; it must be {2 - 2 * through}", kind=Kind.NO_RESULT, file=path)
    return _checked_volume(
        ExportedFile(
            path,
            name,
            path.suffix[1:],
            len(mesh.faces),
            facets.deviation,
            shape.Volume(),
            float(mesh.volume),
        )
    )


def _checked_step(shape: cq.Shape, name: str, written: Path, path: Path) -> ExportedFile:
    import cadquery as cq

    read = cq.importers.importStep(str(written))
    solids = read.solids().vals()
    if len(solids) != 1:
        raise Refusal(f"has {len(solids)} solids instead of one", kind=Kind.NO_RESULT, file=path)
    volume = sum(_shape(read.newObject([solid])).Volume() for solid in solids)
    return _checked_volume(ExportedFile(path, name, "step", None, None, shape.Volume(), volume))


def _checked_volume(file: ExportedFile) -> ExportedFile:
    if not abs(file.volume_error) <= LARGEST_VOLUME_ERROR:
        problem = (
            f"has a volume of {file.mesh_volume:.6g} mm^3; it must be within {LARGEST_VOLUME_ERROR:.1%} of the CAD "
            f"volume {file.cad_volume:.6g} mm^3"
        )
        raise Refusal(problem, kind=Kind.NO_RESULT, file=file.path)
    return file


# -- formats ------------------------------------------------------------------------------------------------
def _mesh(facets: Tessellation) -> trimesh.Trimesh:
    import trimesh

    return trimesh.Trimesh(facets.vertices, facets.triangles, process=False)


def _read_stl(path: Path) -> trimesh.Trimesh:
    import trimesh

    # Facets of an STL share no vertices: equal positions are joined on reading, as a slicer does.
    return trimesh.load_mesh(path, file_type="stl")


def _read_only_body(path: Path, name: str) -> trimesh.Trimesh:
    bodies = read_3mf(path)
    if list(bodies) != [name]:
        raise Refusal(f"has {counted(len(bodies), 'body')} instead of {name} alone", kind=Kind.NO_RESULT, file=path)
    return bodies[name]


def _write_step(shape: cq.Shape, name: str, beside: Path, path: Path) -> None:
    from geometry.formats.step_document import part_document, write_document

    write_document(part_document(shape, name), beside, title=name, named=path)
