"""Parts to files: STL, STEP and 3MF, each read back and compared with the CAD solid before it counts."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from geometry.assembly import PartSet

if TYPE_CHECKING:
    import cadquery as cq
    import trimesh

    from geometry.measure import Tessellation

FORMATS = ("stl", "step", "3mf")
#: A file whose volume differs more than this from the CAD solid is refused.
LARGEST_VOLUME_ERROR = 0.005
#: Facets stay this part of the narrowest hole's diameter from the surface.
_TOLERANCE_IN_HOLES = 1 / 50
#: Namespace of our metadata in 3MF files.
_NAMESPACE = "urn:acoustic-fem:part"


@dataclass(frozen=True)
class ExportedFile:
    """A file that was written and read back. Lengths mm, volumes mm^3; STEP is exact and has no facets."""

    path: Path
    part: str
    format: str
    triangles: int | None
    linear_deviation: float | None
    """Largest distance of the facets' edges from the CAD surface."""
    cad_volume: float
    mesh_volume: float
    """Volume of what the file holds."""

    @property
    def volume_error(self) -> float:
        """Relative difference of the file's volume from the CAD volume."""
        return self.mesh_volume / self.cad_volume - 1


def tessellation_tolerance(parts: Mapping[str, cq.Workplane]) -> float:
    """Absolute tolerance for a set of parts, mm: a fiftieth of the narrowest hole, or of the thinnest part."""
    from geometry.measure import hole_diameters

    holes = [diameter for part in parts.values() for diameter in hole_diameters(_shape(part))]
    if holes:
        return min(holes) * _TOLERANCE_IN_HOLES
    boxes = [_shape(part).BoundingBox() for part in parts.values()]
    return min(min(box.xlen, box.ylen, box.zlen) for box in boxes) * _TOLERANCE_IN_HOLES


def export(
    parts: Mapping[str, cq.Workplane], folder: str | os.PathLike[str], formats: Iterable[str] = FORMATS
) -> tuple[ExportedFile, ...]:
    """Write each part to ``folder/NAME.FORMAT``, in mm; existing files are replaced only by complete ones.

    Facets keep an absolute tolerance, see :func:`tessellation_tolerance`. STL is binary; 3MF carries the
    unit, the part's name and, for parts from :func:`geometry.build_parts`, what it was generated from.

    Args:
        parts: name to workplane with one solid, mm.
        folder: made if it does not exist.
        formats: of ``stl``, ``step``, ``3mf``.

    Returns:
        One record per file, parts in their order, formats in the order given.

    Raises:
        ValueError: an unknown format, no parts, a name that cannot be a file name, or a file that is not
            one closed body with the part's volume.
        OSError: the folder cannot be written.
    """
    formats = tuple(dict.fromkeys(formats))
    for format_ in formats:
        if format_ not in FORMATS:
            raise ValueError(f"formats = {format_!r} must be of: {', '.join(FORMATS)}")
    if not parts or not formats:
        raise ValueError(f"parts = {sorted(parts)}, formats = {list(formats)} must not be empty")
    for name in parts:
        if not re.fullmatch(r"[A-Za-z0-9][A-Za-z0-9._-]*", name):
            raise ValueError(f"parts: name {name!r} must be of letters, digits, '.', '_' and '-' to name a file")
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    from geometry.measure import tessellate

    tolerance = tessellation_tolerance(parts)
    parameters = parts.parameters if isinstance(parts, PartSet) else {}
    files = []
    for name, part in parts.items():
        shape = _shape(part)
        if len(shape.Solids()) != 1 or not shape.isValid():
            raise ValueError(f"parts: {name} must be one valid solid; it has {len(shape.Solids())}")
        facets = None if formats == ("step",) else tessellate(shape, tolerance)
        for format_ in formats:
            path = folder / f"{name}.{format_}"
            beside = folder / f".{name}.{os.getpid()}.{format_}"
            try:
                if format_ == "step" or facets is None:
                    _write_step(shape, name, beside)
                    record = _checked_step(shape, name, beside, path)
                elif format_ == "stl":
                    _mesh(facets).export(beside, file_type="stl")
                    record = _checked_mesh(_read_stl(beside), facets, shape, name, path)
                else:
                    _write_3mf(facets, name, parameters.get(name, {}), beside)
                    record = _checked_mesh(_read_3mf(beside), facets, shape, name, path)
                os.replace(beside, path)
            finally:
                beside.unlink(missing_ok=True)
            files.append(record)
    return tuple(files)


def _shape(part: cq.Workplane) -> cq.Shape:
    shape: Any = part.val()
    return shape


# -- checks -----------------------------------------------------------------------------------------------
def _checked_mesh(mesh: trimesh.Trimesh, facets: Tessellation, shape: cq.Shape, name: str, path: Path) -> ExportedFile:
    if not mesh.is_volume or mesh.body_count != 1:
        raise ValueError(
            f"{path.name}: is not one closed body (closed: {mesh.is_watertight}, bodies: {mesh.body_count}); "
            "the part has features finer than the tessellation"
        )
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
        raise ValueError(f"{path.name}: holds {len(solids)} solids instead of one")
    volume = sum(_shape(read.newObject([solid])).Volume() for solid in solids)
    return _checked_volume(ExportedFile(path, name, "step", None, None, shape.Volume(), volume))


def _checked_volume(file: ExportedFile) -> ExportedFile:
    if not abs(file.volume_error) <= LARGEST_VOLUME_ERROR:
        raise ValueError(
            f"{file.path.name}: volume {file.mesh_volume:.6g} mm^3 must be within {LARGEST_VOLUME_ERROR:.1%} of the "
            f"CAD volume {file.cad_volume:.6g} mm^3"
        )
    return file


# -- formats ------------------------------------------------------------------------------------------------
def _mesh(facets: Tessellation) -> trimesh.Trimesh:
    import trimesh

    return trimesh.Trimesh(facets.vertices, facets.triangles, process=False)


def _read_stl(path: Path) -> trimesh.Trimesh:
    import trimesh

    # Facets of an STL share no vertices: equal positions are joined on reading, as a slicer does.
    return trimesh.load_mesh(path, file_type="stl")


def _write_step(shape: cq.Shape, name: str, path: Path) -> None:
    import cadquery as cq

    cq.Assembly(shape, name=name).export(str(path), "STEP")


def _write_3mf(facets: Tessellation, name: str, parameters: Mapping[str, Any], path: Path) -> None:
    import lib3mf

    wrapper = lib3mf.get_wrapper()
    model = wrapper.CreateModel()
    model.SetUnit(lib3mf.ModelUnit.MilliMeter)
    model.GetMetaDataGroup().AddMetaData("", "Title", name, "xs:string", True)
    model.GetMetaDataGroup().AddMetaData("", "Application", "acoustic-fem", "xs:string", True)
    body = model.AddMeshObject()
    body.SetName(name)
    body.SetPartNumber(name)
    for key, value in parameters.items():
        body.GetMetaDataGroup().AddMetaData(_NAMESPACE, key, str(value), "xs:string", True)
    body.SetGeometry(
        [_filled(lib3mf.Position(), vertex) for vertex in facets.vertices.tolist()],
        [_filled(lib3mf.Triangle(), corners) for corners in facets.triangles.tolist()],
    )
    model.AddBuildItem(body, wrapper.GetIdentityTransform())
    writer = model.QueryWriter("3mf")
    writer.SetDecimalPrecision(7)
    writer.WriteToFile(str(path))


def _filled(record: Any, numbers: list[Any]) -> Any:
    (field,) = (getattr(record, name) for name, _ in record._fields_)
    for index, number in enumerate(numbers):
        field[index] = number
    return record


def _read_3mf(path: Path) -> trimesh.Trimesh:
    import lib3mf
    import numpy as np
    import trimesh

    model = lib3mf.get_wrapper().CreateModel()
    model.QueryReader("3mf").ReadFromFile(str(path))
    bodies = model.GetMeshObjects()
    if model.GetUnit() != lib3mf.ModelUnit.MilliMeter or bodies.Count() != 1:
        raise ValueError(f"{path.name}: holds {bodies.Count()} bodies instead of one, or another unit than mm")
    bodies.MoveNext()
    body = bodies.GetCurrentMeshObject()
    return trimesh.Trimesh(
        np.array([list(vertex.Coordinates) for vertex in body.GetVertices()]),
        np.array([list(triangle.Indices) for triangle in body.GetTriangleIndices()]),
        process=False,
    )
