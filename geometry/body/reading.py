"""Bodies from files: STEP, STL, 3MF, OBJ and PLY as closed facets. Faults are reported and never repaired."""

from __future__ import annotations

import hashlib
import io
import os
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from geometry.body.closed_surface import check_closed, check_crossings, check_size, skins
from geometry.formats.step_file import read_step
from geometry.ground.extras import check_extras
from geometry.ground.file_checks import read_bytes
from geometry.ground.foreign_files import read_apart
from geometry.ground.refusal import Kind, Refusal, counted
from geometry.ground.typed import Array

#: Largest distance of facets from the surface of a STEP file, mm, and angle between neighbouring ones, rad.
_TOLERANCE, _FACET_ANGLE = 0.02, 0.15
#: Most bytes of the file of a body, and memory that a mesh may take to be read, bytes.
_LARGEST, _MEMORY = 200_000_000, 1_500_000_000
#: Units of lengths in files, mm.
UNITS = {"mm": 1.0, "cm": 10.0, "m": 1000.0, "inch": 25.4}
#: Endings of files that are read.
_STEP, _MESHES = (".step", ".stp"), (".stl", ".3mf", ".obj", ".ply")
#: Facets lower than this are of no area, mm.
_NO_AREA = 1e-9

Corners = NDArray[np.int64]


@dataclass(frozen=True)
class Body:
    """The closed surface of a body, mm."""

    vertices: Array
    """Corners of the facets, (n, 3) float64, mm; facets share them."""
    triangles: Corners
    """Corners of each facet, (m, 3) int64, anticlockwise from outside."""
    faces: Corners
    """Number of the face that each facet belongs to, from 1 as CAD programs count, (m,) int64.

    Painted groups of a mesh file are its faces, the largest first: materials of OBJ, solids of STL, objects of 3MF,
    or colours of facets. A mesh that is not painted is one face.
    """
    sha256: str
    """SHA-256 of the file."""
    findings: tuple[str, ...] = ()
    """Sentences on the file, such as facets that were left out."""

    @property
    def extent(self) -> Array:
        """Size along x, y and z, (3,) float64, mm."""
        return np.asarray(np.ptp(self.vertices, axis=0))


def read_body(
    path: str | os.PathLike[str], unit: str = "mm", skin: int | None = None, least: float = 0.0, most: float = 2000.0
) -> Body:
    """The body in a file.

    Args:
        path: STEP, STL, 3MF, OBJ or PLY.
        unit: of the lengths in a mesh file: mm, cm, m or inch; STEP files state their own.
        skin: which of several closed surfaces, from 1, the largest first; None: there must be one.
        least: smallest size that makes sense, mm.
        most: largest size that makes sense, mm.

    Raises:
        Refusal: the file cannot be read, or its surface is open, forked, inside out, crosses itself, has several
            skins, or has a size that makes no sense.
    """
    path = Path(path)
    suffix = path.suffix.lower()
    if suffix not in (*_STEP, *_MESHES):
        allowed = f"a file of {', '.join((*_STEP, *_MESHES))}"
        raise Refusal(kind=Kind.UNSUITABLE, file=path, field="body", value=suffix or path.name, allowed=allowed)
    content = read_bytes(path, "a body", Refusal, _LARGEST)
    digest = hashlib.sha256(content).hexdigest()
    findings: list[str] = []
    if suffix in _STEP:
        vertices, triangles, faces = _of_step(path)
    else:
        vertices, triangles, faces = _of_mesh(path, UNITS[unit])
        vertices, triangles, faces, lost = _welded(vertices, triangles, faces)
        if lost:
            findings.append(f"{counted(lost, 'facet')} of no area left out")
    if not len(triangles):
        raise Refusal("has no facets", kind=Kind.UNSUITABLE, file=path)
    check_size(path, vertices, least, most)
    check_closed(path, vertices, triangles)
    which = skins(triangles, len(vertices))
    count = int(which.max()) + 1
    if count > 1:
        sizes = np.array([np.ptp(vertices[np.unique(triangles[which == k])], axis=0).max() for k in range(count)])
        ranked = np.argsort(-sizes, kind="stable")
        if skin is None or not 1 <= skin <= count:
            listed = ", ".join(f"{number} is {sizes[k]:.3g} mm long" for number, k in enumerate(ranked[:4], 1))
            raise Refusal(
                f"has {count} separate skins: {listed}",
                kind=Kind.UNSUITABLE,
                file=path,
                remedy="export one solid, or choose one with surface.skin",
            )
        own = which == ranked[skin - 1]
        vertices, triangles, faces, _ = _welded(vertices, triangles[own], faces[own])
        findings.append(f"skin {skin} of {count} is used")
    if suffix not in _STEP:
        check_crossings(path, vertices, triangles)
    return Body(vertices, triangles, faces, digest, tuple(findings))


def _of_step(path: Path) -> tuple[Array, Corners, Corners]:
    check_extras("reading a body", "cad")
    from geometry.solids.measure import tessellate

    solids = [solid for shape in read_step(path) for solid in shape.Solids()]
    if not solids:
        problem = "has no solid, only surfaces or curves"
        raise Refusal(problem, kind=Kind.UNSUITABLE, file=path, remedy="join them to a solid in your CAD program")
    if len(solids) > 1:
        problem = f"has {len(solids)} solids"
        raise Refusal(problem, kind=Kind.UNSUITABLE, file=path, remedy="export the one that carries the array")
    if not solids[0].isValid():
        problem = "has a solid that is not valid"
        raise Refusal(problem, kind=Kind.UNSUITABLE, file=path, remedy="check and heal it in your CAD program")
    found = tessellate(solids[0], _TOLERANCE, _FACET_ANGLE)
    return found.vertices, found.triangles, found.faces + 1


def _of_mesh(path: Path, scale: float) -> tuple[Array, Corners, Corners]:
    check_extras("reading a body", "cad")
    answer = read_apart(_mesh_in, path, f"a mesh in {path.suffix[1:].upper()}", Refusal, _MEMORY)
    end = 8 + 24 * int.from_bytes(answer[:8], "little")
    vertices = np.frombuffer(answer[8:end]).reshape(-1, 3)
    facets = np.frombuffer(answer[end:], np.int64).reshape(-1, 4)
    if not len(facets):
        raise Refusal("has no facets", kind=Kind.UNSUITABLE, file=path)
    if not np.isfinite(vertices).all():
        raise Refusal("has corners that are not finite numbers", kind=Kind.UNSUITABLE, file=path)
    return vertices * scale, facets[:, :3], facets[:, 3]


def _mesh_in(path: str) -> bytes:
    """In the process: number of corners of a mesh, their places, and corners and group of each facet.

    No other file is opened.
    """
    import trimesh

    content = io.BytesIO(Path(path).read_bytes())
    loaded = trimesh.load(content, file_type=Path(path).suffix[1:].lower(), process=False)
    pieces = loaded.dump() if isinstance(loaded, trimesh.Scene) else [loaded]
    vertices, facets, groups = [np.empty((0, 3))], [np.empty((0, 4), np.int64)], 0
    for piece in pieces:
        if not isinstance(piece, trimesh.Trimesh) or not len(piece.faces):  # it holds nothing
            continue
        group = np.zeros(len(piece.faces), np.int64)
        if piece.visual.kind == "face":
            group = np.unique(piece.visual.face_colors, axis=0, return_inverse=True)[1].reshape(-1)
        corners = np.asarray(piece.faces, np.int64) + sum(map(len, vertices))
        facets.append(np.column_stack([corners, group + groups]))
        vertices.append(np.asarray(piece.vertices, np.float64))
        groups += int(group.max()) + 1
    places, rows = np.vstack(vertices), np.vstack(facets)
    a, b, c = (places[rows[:, k]] for k in range(3))
    area = np.bincount(rows[:, 3], np.linalg.norm(np.cross(b - a, c - a), axis=1), groups)
    rows[:, 3] = 1 + np.argsort(np.argsort(-area, kind="stable"))[rows[:, 3]]
    return len(places).to_bytes(8, "little") + places.tobytes() + rows.tobytes()


def _welded(vertices: Array, triangles: Corners, faces: Corners) -> tuple[Array, Corners, Corners, int]:
    """Facets that share equal corners, without those of no area, and how many these are."""
    span = float(np.ptp(vertices, axis=0).max())
    grid = max(span, 1e-9) * 1e-9
    _, first, place = np.unique(np.round(vertices / grid), axis=0, return_index=True, return_inverse=True)
    triangles = place.reshape(-1)[triangles]
    vertices = vertices[first]
    a, b, c = (vertices[triangles[:, k]] for k in range(3))
    longest = np.max([np.linalg.norm(b - a, axis=1), np.linalg.norm(c - b, axis=1), np.linalg.norm(a - c, axis=1)], 0)
    height = np.linalg.norm(np.cross(b - a, c - a), axis=1) / np.maximum(longest, 1e-300)
    real = height > _NO_AREA
    used, place = np.unique(triangles[real], return_inverse=True)
    return vertices[used], place.reshape(-1, 3), faces[real], int((~real).sum())
