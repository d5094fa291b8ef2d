"""Measures of a CAD solid: its tessellation, genus, round holes, pins and inner voids. Lengths in mm."""

from __future__ import annotations

import contextlib
import math
from dataclasses import dataclass

import cadquery as cq
import numpy as np
from numpy.typing import NDArray
from OCP.Bnd import Bnd_Box
from OCP.BRep import BRep_Tool
from OCP.BRepAdaptor import BRepAdaptor_Surface
from OCP.BRepBndLib import BRepBndLib
from OCP.BRepMesh import BRepMesh_IncrementalMesh
from OCP.GeomAbs import GeomAbs_Cone, GeomAbs_Cylinder, GeomAbs_Plane, GeomAbs_SurfaceType
from OCP.gp import gp_Dir, gp_Pnt
from OCP.IMeshTools import IMeshTools_MeshAlgoType, IMeshTools_Parameters
from OCP.Message import Message_ProgressRange
from OCP.Poly import Poly_Triangulation
from OCP.TopAbs import TopAbs_EDGE, TopAbs_FACE, TopAbs_REVERSED
from OCP.TopExp import TopExp
from OCP.TopLoc import TopLoc_Location
from OCP.TopTools import TopTools_IndexedDataMapOfShapeListOfShape

from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array

#: Largest angle between neighbouring facets, rad: a round body of such facets lacks angle^2 / 6 = 0.05 % of volume.
FACET_ANGLE = 0.055
#: A round face that goes this far round (rad) is a hole or a pin; less is a fillet or a trough.
_ROUND = 1.5 * math.pi
#: Triangulations of the kernel. The first takes a tenth of the time for a mold, because the other one is quadratic in
#: the corners of a face. It gives up on some faces along splines, for which the other one is taken.
_SWEEPING = IMeshTools_MeshAlgoType.IMeshTools_MeshAlgoType_Delabella
_INSERTING = IMeshTools_MeshAlgoType.IMeshTools_MeshAlgoType_Watson


@dataclass(frozen=True)
class Tessellation:
    """Facets of a solid, outwards."""

    vertices: Array
    """Corners of the facets, (n, 3) float64, mm; facets share them."""
    triangles: NDArray[np.int64]
    """Corners of each facet, (m, 3) int64, anticlockwise from outside."""
    faces: NDArray[np.int64]
    """Number of the solid's face that each facet belongs to, (m,) int64."""
    deviation: float
    """Largest distance from the solid's surface of the middles of facets and of their edges, mm; NaN if unmeasured."""

    @property
    def volume(self) -> float:
        """Volume inside the facets, mm^3."""
        a, b, c = (self.vertices[self.triangles[:, k]] - self.vertices[0] for k in range(3))
        return float(np.einsum("ij,ij->", a, np.cross(b, c)) / 6)


def quick_box(shape: cq.Shape) -> Array:
    """Lowest and highest corner of a box around a shape, (2, 3) float64, mm.

    It is exact around planes and cylinders and may be larger around other faces, whose exact box can take seconds.
    """
    box = Bnd_Box()
    BRepBndLib.Add_s(shape.wrapped, box, False)
    return np.array(box.Get()).reshape(2, 3)


def tessellate(
    solid: cq.Shape, tolerance: float, facet_angle: float = FACET_ANGLE, *, measured: bool = True
) -> Tessellation:
    """Facets of a solid within an absolute tolerance.

    A copy is meshed: the kernel keeps facets with the shape and would hand out earlier, coarser or finer ones.

    Args:
        solid: of any kind.
        tolerance: largest distance between facets and surface, mm.
        facet_angle: largest angle between neighbouring facets, rad.
        measured: measure the deviation; of tubes along curves that takes longer than making the facets.

    Raises:
        Refusal: a face cannot be tessellated.
    """
    with contextlib.suppress(Refusal):
        found = _facets(solid, tolerance, facet_angle, measured, _SWEEPING)
        if _is_closed(found.triangles):
            return found
    return _facets(solid, tolerance, facet_angle, measured, _INSERTING)


def _facets(
    solid: cq.Shape, tolerance: float, facet_angle: float, measured: bool, algorithm: IMeshTools_MeshAlgoType
) -> Tessellation:
    """Facets of a copy of a solid, made by one of the kernel's algorithms."""
    copy, options = solid.copy(), IMeshTools_Parameters()
    options.Deflection, options.Angle, options.Relative = tolerance, facet_angle, False
    options.MeshAlgo = algorithm
    BRepMesh_IncrementalMesh(copy.wrapped, options, Message_ProgressRange())
    vertices, triangles, faces = [], [], []
    count, deviation = 0, 0.0 if measured else math.nan
    for index, face in enumerate(copy.Faces()):
        location = TopLoc_Location()
        mesh = BRep_Tool.Triangulation_s(face.wrapped, location)
        if mesh is None:
            raise Refusal(f"face {index} of the solid cannot be tessellated", kind=Kind.NO_RESULT)
        corners = np.array([mesh.Triangle(k).Get() for k in range(1, mesh.NbTriangles() + 1)]) - 1
        points = np.array([mesh.Node(k).Coord() for k in range(1, mesh.NbNodes() + 1)])
        if not location.IsIdentity():
            move = location.Transformation()
            matrix = np.array([[move.Value(row, column) for column in range(1, 5)] for row in range(1, 4)])
            points = points @ matrix[:, :3].T + matrix[:, 3]
        if measured:
            deviation = max(deviation, _deviation(face, mesh, points, corners))
        if face.wrapped.Orientation() == TopAbs_REVERSED:
            corners = corners[:, ::-1]
        vertices.append(points)
        triangles.append(corners + count)
        faces.append(np.full(len(corners), index))
        count += len(points)
    # Faces share the nodes of their common edges bit by bit, up to rounding of the last places.
    joined, place = np.unique(np.round(np.vstack(vertices), 9) + 0.0, axis=0, return_inverse=True)
    joined_triangles = place.reshape(-1)[np.vstack(triangles)]
    # At the pole of a sphere or the tip of a cone the kernel writes facets with one edge of no length.
    a, b, c = joined_triangles.T
    real = (a != b) & (b != c) & (c != a)
    return Tessellation(joined, joined_triangles[real], np.concatenate(faces)[real], deviation)


def _is_closed(triangles: NDArray[np.int64]) -> bool:
    """True where every edge of (n, 3) triangles has a triangle at both sides."""
    edges = np.sort(triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    _, count = np.unique(edges @ [int(triangles.max()) + 1, 1], return_counts=True)
    return bool((count % 2 == 0).all())


def _deviation(face: cq.Face, mesh: Poly_Triangulation, points: Array, corners: NDArray[np.int64]) -> float:
    """Distance of the middles of facets and of their edges from the surface, along the facets' normals.

    The surface is taken at the middle parameters, which on a spline lie elsewhere along the surface.
    """
    surface = BRepAdaptor_Surface(face.wrapped)
    if surface.GetType() == GeomAbs_Plane:
        return 0.0
    parameters = np.array([mesh.UVNode(k).Coord() for k in range(1, mesh.NbNodes() + 1)])
    edges, first = np.unique(
        np.sort(corners[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1), axis=0, return_index=True
    )
    a, b, c = (points[corners[:, k]] for k in range(3))
    normals = np.cross(b - a, c - a)
    normals /= np.maximum(np.linalg.norm(normals, axis=1), 1e-300)[:, None]
    at = np.vstack([parameters[edges].mean(axis=1), parameters[corners].mean(axis=1)])
    middles = np.vstack([points[edges].mean(axis=1), points[corners].mean(axis=1)])
    across = np.vstack([normals[first // 3], normals])
    return float(np.abs(np.einsum("ij,ij->i", middles - surface_points(surface, at), across)).max())


def surface_points(surface: BRepAdaptor_Surface, at: Array) -> Array:
    """Points of a surface at its parameters, (n, 3) float64, mm; those of round ones all at once.

    Args:
        surface: of a face.
        at: its parameters, (n, 2) float64.
    """
    along, up = at.T
    match surface.GetType():
        case GeomAbs_SurfaceType.GeomAbs_Cylinder:
            body = surface.Cylinder()
            radius, height = body.Radius(), up
        case GeomAbs_SurfaceType.GeomAbs_Cone:
            body = surface.Cone()
            radius = body.RefRadius() + up * math.sin(body.SemiAngle())
            height = up * math.cos(body.SemiAngle())
        case GeomAbs_SurfaceType.GeomAbs_Sphere:
            body = surface.Sphere()
            radius, height = body.Radius() * np.cos(up), body.Radius() * np.sin(up)
        case GeomAbs_SurfaceType.GeomAbs_Torus:
            body = surface.Torus()
            radius = body.MajorRadius() + body.MinorRadius() * np.cos(up)
            height = body.MinorRadius() * np.sin(up)
        case _:
            return np.array([surface.Value(u, v).Coord() for u, v in at.tolist()])
    place = body.Position()
    x, y, z = (each.Coord() for each in (place.XDirection(), place.YDirection(), place.Direction()))
    parts = np.stack([radius * np.cos(along), radius * np.sin(along), height], axis=1)
    return np.asarray(parts @ np.array([x, y, z]) + place.Location().Coord())


@dataclass(frozen=True)
class Round:
    """A round hole or pin of a solid."""

    diameter: float
    """Mean diameter, mm."""
    length: float
    """Length along the axis, mm."""
    place: tuple[float, float, float]
    """Middle of the axis, mm."""
    direction: tuple[float, float, float]
    """Unit vector, of length one, along the axis."""
    hollow: bool
    """True where the material is outside of it."""


def rounds(solid: cq.Shape) -> list[Round]:
    """Round holes and pins: cylinders and cones that go three quarters round, faces of one surface as one."""
    found: dict[tuple[object, ...], list[tuple[float, float, float, BRepAdaptor_Surface]]] = {}
    for face in solid.Faces():
        surface = BRepAdaptor_Surface(face.wrapped)
        kind = surface.GetType()
        if kind not in (GeomAbs_Cylinder, GeomAbs_Cone):
            continue
        body = surface.Cylinder() if kind == GeomAbs_Cylinder else surface.Cone()
        axis = body.Axis()
        # The parametric normal of a right-handed surface points away from its axis; reversed, the axis is in air.
        hollow = (face.wrapped.Orientation() == TopAbs_REVERSED) == body.Position().Direct()
        at, along = axis.Location(), axis.Direction()
        offset = np.array([at.X(), at.Y(), at.Z()])
        unit = np.array([along.X(), along.Y(), along.Z()])
        foot = offset - (offset @ unit) * unit  # the same for every point of the axis
        first, last = surface.FirstVParameter(), surface.LastVParameter()
        radii = [_distance(surface.Value(surface.FirstUParameter(), v), offset, unit) for v in (first, last)]
        # Two halves of one bore are one; two coaxial bores of one width, apart along the axis, are two.
        key = (kind, hollow, *np.round([*foot, *np.abs(unit), sum(radii), *sorted((first, last))], 4).tolist())
        turn = surface.LastUParameter() - surface.FirstUParameter()
        found.setdefault(key, []).append((turn, *radii, surface))
    result = []
    for key, faces in found.items():
        if sum(turn for turn, *_ in faces) < _ROUND:
            continue
        _, start, end, surface = faces[0]
        axis = (surface.Cylinder() if surface.GetType() == GeomAbs_Cylinder else surface.Cone()).Axis()
        ends = [
            _on_axis(surface.Value(surface.FirstUParameter(), v), axis.Location(), axis.Direction())
            for v in (surface.FirstVParameter(), surface.LastVParameter())
        ]
        along = axis.Direction()
        x, y, z = np.mean(ends, axis=0).tolist()
        length = float(np.linalg.norm(np.subtract(*ends)))
        result.append(Round(start + end, length, (x, y, z), (along.X(), along.Y(), along.Z()), bool(key[1])))
    return sorted(result, key=lambda one: one.diameter)


def _distance(point: gp_Pnt, offset: Array, unit: Array) -> float:
    to = np.array([point.X(), point.Y(), point.Z()]) - offset
    return float(np.linalg.norm(to - (to @ unit) * unit))


def _on_axis(point: gp_Pnt, at: gp_Pnt, along: gp_Dir) -> Array:
    offset, unit = np.array([at.X(), at.Y(), at.Z()]), np.array([along.X(), along.Y(), along.Z()])
    return np.asarray(offset + ((np.array([point.X(), point.Y(), point.Z()]) - offset) @ unit) * unit)


def hole_diameters(solid: cq.Shape) -> list[float]:
    """Diameters of all round holes of a solid (bores, cavities, sockets), ascending, mm."""
    return [one.diameter for one in rounds(solid) if one.hollow]


def inner_voids(solid: cq.Shape) -> int:
    """Number of voids without a way out: liquid resin stays trapped in them."""
    return len(solid.Shells()) - len(solid.Solids())


def genus(solid: cq.Shape) -> int:
    """Number of ways that lead through a solid, such as bores: the genus of its skin, by Euler and Poincare.

    A closed mesh of it has the Euler number ``2 * (shells - genus)``.
    """
    faces = solid.Faces()
    edges = [edge for edge in solid.Edges() if not BRep_Tool.Degenerated_s(edge.wrapped)]
    inner_loops = sum(len(face.innerWires()) for face in faces)
    euler = len(solid.Vertices()) - len(edges) + len(faces) - inner_loops
    return len(solid.Shells()) - euler // 2


def pinched_edges(solid: cq.Shape) -> int:
    """Number of edges on which more than two faces meet: there the solid touches itself and has no closed mesh."""
    faces_of = TopTools_IndexedDataMapOfShapeListOfShape()
    TopExp.MapShapesAndAncestors_s(solid.wrapped, TopAbs_EDGE, TopAbs_FACE, faces_of)
    return sum(faces_of.FindFromIndex(k).Extent() > 2 for k in range(1, faces_of.Extent() + 1))
