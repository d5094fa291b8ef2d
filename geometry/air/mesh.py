"""CAD solid -> curved second-order tetrahedra with named faces. The only module that knows gmsh."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from io import BytesIO
from typing import TYPE_CHECKING, TypeAlias

import numpy as np
from numpy.typing import NDArray

from geometry.air.curved_tetrahedra import SOLVER_RULE, VOLUME_RULE, curved_volume, jacobians, split_wall_corners
from geometry.air.solid_checks import estimated_elements
from geometry.ground.forked import in_a_copy
from geometry.ground.process_messages import ChildError, Limits
from geometry.ground.refusal import Kind, Refusal, counted, said_by
from geometry.ground.typed import Array
from geometry.ground.whole_files import temporary_folder

if TYPE_CHECKING:
    import cadquery

#: Place in space, mm.
Point: TypeAlias = tuple[float, float, float]
#: Nodes, tetrahedra, and triangles of every face by its name.
_Elements: TypeAlias = tuple[Array, NDArray[np.int64], dict[str, NDArray[np.int64]]]

#: Most elements of a mesh, as estimated: of more gmsh makes none in minutes.
MOST_ELEMENTS = 1e6
#: Processor time and memory beyond those of the program that gmsh may take for one solid.
GMSH_LIMITS = Limits(processor_seconds=60, memory=3 * 2**30)
#: Name under which a mesh lists every face that nobody named.
WALL = "wall"

# gmsh numbers the last two edges of a second-order tetrahedron the other way round than scikit-fem:
# gmsh (0,1)(1,2)(2,0)(3,0)(2,3)(1,3), scikit-fem (0,1)(1,2)(0,2)(0,3)(1,3)(2,3).
_GMSH_TO_SKFEM_NODES = np.array([0, 1, 2, 3, 4, 5, 6, 7, 9, 8])


class MeshError(Refusal):
    """A solid that cannot be meshed as asked; the message says why."""


class InvertedElementsError(MeshError):
    """Curved elements that are turned inside out: the mesh is too coarse for the shape."""


@dataclass(frozen=True)
class MeshSizes:
    """Element sizes of a mesh: fine at the mouths of tubes, growing into the cavity."""

    mouth_edge: float
    """Size at the re-entrant edge where a tube meets the cavity, in radii of the nearest port."""
    tube: float
    """Size along the stub of a tube in radii of its port, and on every curved face in its radii of curvature."""
    growth: float
    """Increase of size per distance from the mouth, mm/mm."""
    largest: float
    """Largest size, mm."""
    wall: float | None = None
    """Size near every face, mm, where a layer along the walls must be resolved; None where it need not be."""
    tube_layer: float = math.inf
    """Upper limit of the sizes at mouths and along stubs, mm, where a layer along their walls is thin."""


@dataclass(frozen=True)
class SolidMesh:
    """Second-order tetrahedra of one solid; lengths in mm."""

    nodes: Array
    """Places of the nodes, (n_node, 3) float64, mm."""
    tetrahedra: NDArray[np.int64]
    """Nodes of every element, (n_tetrahedron, 10) int64, in the order of scikit-fem."""
    faces: dict[str, NDArray[np.int64]]
    """Corner nodes of the triangles of every face by name, (n_triangle, 3) int64 each; unnamed faces are listed under
    ``wall``.
    """
    normals: dict[str, Array]
    """Unit normal, of length one, out of the solid of every named flat face, (3,) float64 each."""
    volume: float
    """Volume of the CAD solid, mm^3."""
    mesh_volume: float
    """Volume of the curved elements, mm^3."""

    def __post_init__(self) -> None:
        """Refuse elements that are turned inside out: at whatever place a mesh was made.

        Raises:
            InvertedElementsError: with the first of them, its place and its Jacobian.
        """
        points = np.concatenate([VOLUME_RULE, SOLVER_RULE])
        smallest = jacobians(self.nodes, self.tetrahedra, points).min(axis=0)
        bad = np.flatnonzero(~(smallest > 0))
        if bad.size:
            x, y, z = self.nodes[self.tetrahedra[bad[0], :4]].mean(axis=0)
            raise InvertedElementsError(
                f"the mesh has {bad.size} inverted elements, the first is tetrahedron {bad[0]} at ({x:.4g}, {y:.4g}, "
                f"{z:.4g}) mm with Jacobian {smallest[bad[0]]:.2g}; it must be above 0",
                kind=Kind.NO_RESULT,
            )


def mesh_solid(
    solid: cadquery.Shape,
    faces: Mapping[str, Point],
    tubes: tuple[str, ...],
    sizes: MeshSizes,
    beat: Callable[[], None] = lambda: None,
) -> SolidMesh:
    """Mesh a CAD solid with curved second-order tetrahedra.

    Args:
        solid: one closed solid, mm.
        faces: name -> a point on that flat face, mm.
        tubes: which of them end a tube, and so ask for a fine mesh.
        sizes: element sizes.
        beat: called again and again while gmsh is at work, in a process of its own.

    Raises:
        MeshError: not one solid; a point on no flat face or on several; more elements than :data:`MOST_ELEMENTS`;
            inverted elements; a mesh whose volume differs from the solid's by more than 1 %.
    """
    solids = solid.Solids()
    if len(solids) != 1:
        problem = f"has {counted(len(solids), 'solid')}; it must have one"
        raise MeshError(problem, kind=Kind.UNSUITABLE, field="solid")
    refuse_large_mesh(solids[0], sizes)
    named = {name: face_at(solids[0], name, point) for name, point in faces.items()}
    counts = Counter(face.hashCode() for face in named.values())
    shared = sorted(name for name, face in named.items() if counts[face.hashCode()] > 1)
    if shared:
        raise MeshError("lie on the same face", kind=Kind.CONFLICT, field="faces", value=shared)
    work = partial(_run_gmsh, solids[0], named, tubes, sizes)
    nodes, tetrahedra, triangles = _in_a_copy(work, beat)
    normals = {}
    for name, face in named.items():
        normal = face.normalAt()
        normals[name] = np.array([normal.x, normal.y, normal.z])
    return checked_mesh(nodes, tetrahedra, triangles, normals, float(solids[0].Volume()))


def _in_a_copy(work: Callable[[], _Elements], beat: Callable[[], None]) -> _Elements:
    """The elements that gmsh makes, always in a copy: one of a process where gmsh has worked waits for its threads."""
    try:
        return in_a_copy(work, "gmsh", GMSH_LIMITS, beat)
    except ChildError as error:
        if error.status is None:
            raise
        raise Refusal(
            "gmsh gave up on this solid: it may take 60 s of processor time and 3 GiB",
            kind=Kind.STOPPED,
            remedy="leave out small holes and roundings, or ask for less accuracy",
        ) from None


def refuse_large_mesh(solid: cadquery.Solid, sizes: MeshSizes, most: float = MOST_ELEMENTS) -> None:
    """Refuse a mesh that would be too large, before gmsh begins.

    Raises:
        MeshError: it would have more elements than ``most``.
    """
    count = estimated_elements(solid, sizes.largest, sizes.tube, sizes.growth, sizes.wall)
    if not count <= most:
        raise MeshError(
            f"needs a mesh of about {count:.2g} elements; it must need at most {most:.2g}",
            kind=Kind.UNSUITABLE,
            field="solid",
            remedy="leave out small holes and roundings, shorten long thin pieces, or ask for less accuracy",
        )


def checked_mesh(
    nodes: Array,
    tetrahedra: NDArray[np.int64],
    triangles: dict[str, NDArray[np.int64]],
    normals: dict[str, Array],
    volume: float,
) -> SolidMesh:
    """A mesh fit for the solvers: elements that would lock a pressure split, Jacobians and volume checked.

    Args:
        nodes: (n_node, 3) float64, mm.
        tetrahedra: (n_tetrahedron, 10) int64: corners, then the middles of
            :data:`geometry.air.curved_tetrahedra.EDGES`.
        triangles: corner nodes of the faces, (n_triangle, 3) int64 each; every face that is not a port, moving wall or
            mirror under :data:`WALL`.
        normals: of the other faces, (3,) float64 each.
        volume: of the solid, mm^3.

    Raises:
        InvertedElementsError: an element is turned inside out.
        MeshError: the volume differs from the solid's by more than 1 %.
    """
    nodes, tetrahedra = split_wall_corners(nodes, tetrahedra, triangles)
    mesh = SolidMesh(nodes, tetrahedra, triangles, normals, volume, curved_volume(nodes, tetrahedra))
    if abs(mesh.mesh_volume - volume) > 1e-2 * volume:
        problem = f"the mesh has {mesh.mesh_volume:g} mm^3, the solid {volume:g} mm^3"
        raise MeshError(problem, kind=Kind.NO_RESULT)
    return mesh


def face_at(solid: cadquery.Solid, name: str, point: Point) -> cadquery.Face:
    """The one flat face of the solid that holds the point (mm).

    Raises:
        MeshError: the point lies on no face, on several, or on one that is not flat.
    """
    import cadquery as cq

    vertex = cq.Vertex.makeVertex(*point)
    hits = [face for face in solid.Faces() if face.distance(vertex) < 1e-6]
    if len(hits) != 1:
        problem = f"lies on {counted(len(hits), 'face')} of the solid; it must lie on one"
        raise MeshError(problem, kind=Kind.UNSUITABLE, field=f"faces.{name}", value=tuple(point), unit="mm")
    if hits[0].geomType() != "PLANE":
        problem = f"lies on a {hits[0].geomType().lower()}; it must lie on a flat face"
        raise MeshError(problem, kind=Kind.UNSUITABLE, field=f"faces.{name}", value=tuple(point), unit="mm")
    return hits[0]


def inner_point(face: cadquery.Face) -> Point:
    """A point inside a flat face: the middle of the largest facet."""
    vertices, triangles = face.tessellate(0.1)
    corners = np.array([vertex.toTuple() for vertex in vertices])[np.array(triangles)]
    areas = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    x, y, z = corners[int(np.argmax(areas))].mean(axis=0).tolist()
    return (x, y, z)


def _run_gmsh(
    solid: cadquery.Solid, named: Mapping[str, cadquery.Face], tubes: tuple[str, ...], sizes: MeshSizes
) -> _Elements:
    import gmsh

    started_here = not gmsh.isInitialized()
    if started_here:
        # gmsh would otherwise replace the signal handlers of the whole program.
        gmsh.initialize(interruptible=False)
    try:
        gmsh.option.setNumber("General.Terminal", 0)
        gmsh.option.setNumber("General.NumThreads", 1)  # the same mesh on every machine
        gmsh.model.add("cell")
        with temporary_folder() as folder:
            brep, content = folder / "solid.brep", BytesIO()
            solid.exportBrep(content)  # into memory: to a full disk it writes half of a file in silence
            brep.write_bytes(content.getvalue())
            gmsh.model.occ.importShapes(str(brep))
        gmsh.model.occ.synchronize()
        surfaces = {name: _matching_surface(name, face) for name, face in named.items()}
        _set_sizes(surfaces, tubes, named, sizes, solid)
        gmsh.option.setNumber("Mesh.MeshSizeExtendFromBoundary", 0)
        gmsh.option.setNumber("Mesh.MeshSizeFromPoints", 0)
        # Fillets and domes: as many elements a turn as a tube has.
        gmsh.option.setNumber("Mesh.MeshSizeFromCurvature", 2 * math.pi / sizes.tube)
        gmsh.option.setNumber("Mesh.MeshSizeMax", sizes.largest)
        # How exactly sizes are summed along edges: 1e-9, which gmsh takes, is most of the time of a mesh.
        gmsh.option.setNumber("Mesh.LcIntegrationPrecision", 1e-5)
        gmsh.option.setNumber("Mesh.Algorithm3D", 1)
        # Left off: where gmsh's optimiser of curved elements fails it ends the whole program, and its elastic
        # one takes minutes. The Jacobians are checked instead.
        gmsh.option.setNumber("Mesh.HighOrderOptimize", 0)
        gmsh.option.setNumber("Mesh.ElementOrder", 2)
        gmsh.model.mesh.generate(3)
        return _read_mesh(surfaces)
    except Exception as error:
        if type(error) is not Exception:  # gmsh raises nothing else
            raise
        raise MeshError(f"gmsh could not mesh the solid: {said_by(error)}", kind=Kind.NO_RESULT) from error
    finally:
        if started_here:
            gmsh.finalize()
        else:
            gmsh.model.remove()


def _matching_surface(name: str, face: cadquery.Face) -> int:
    """The gmsh surface with the face's centre and area: entity numbers mean nothing across kernels."""
    import gmsh

    centre, area = np.array(face.Center().toTuple()), face.Area()
    hits = [
        tag
        for _, tag in gmsh.model.getEntities(2)
        if abs(gmsh.model.occ.getMass(2, tag) - area) < 1e-6 * area
        and np.linalg.norm(np.array(gmsh.model.occ.getCenterOfMass(2, tag)) - centre) < 1e-5 * math.sqrt(area)
    ]
    if len(hits) != 1:
        problem = f"matches {counted(len(hits), 'surface')} of the imported solid; it must match one"
        raise MeshError(problem, kind=Kind.NO_RESULT, field=f"faces.{name}")
    return hits[0]


def _set_sizes(
    surfaces: Mapping[str, int],
    tubes: tuple[str, ...],
    named: Mapping[str, cadquery.Face],
    sizes: MeshSizes,
    solid: cadquery.Solid,
) -> None:
    """Background field: fine at the mouth edges, even along the stubs, growing into the cavity."""
    import gmsh

    field = gmsh.model.mesh.field
    fields = []
    # A mirror plane cuts through tubes without being their wall.
    others = {tag for name, tag in surfaces.items() if name not in tubes}
    ends = {surfaces[name] for name in tubes}
    tube_walls: list[tuple[set[int], float, cadquery.Face | None]] = []
    for name in tubes:
        surface, radius = surfaces[name], _port_radius(surfaces[name], others, named[name])
        edges = [tag for _, tag in gmsh.model.getBoundary([(2, surface)], oriented=False)]
        walls = {int(wall) for edge in edges for wall in gmsh.model.getAdjacencies(1, edge)[0]} - {surface} - others
        tube_walls.append((walls, radius, named[name]))
    known: set[int] = {wall for walls, _, _ in tube_walls for wall in walls}
    # Tubes that end at no port: between cavities, or a microphone's sound hole. The kernel does not call every
    # round tube a cylinder.
    tube_walls += [
        ({tag}, radius, None)
        for _, tag in gmsh.model.getEntities(2)
        if tag not in known and gmsh.model.getType(2, tag) != "Plane"
        if sizes.tube * (radius := _curvature_radius(tag)) < sizes.largest / 2
    ]
    for walls, radius, port in tube_walls:
        rims = {tag for wall in walls for _, tag in gmsh.model.getBoundary([(2, wall)], oriented=False)}
        # A seam joins a face to itself; a mouth edge joins the tube's wall to another face, but to no port.
        mouth = [
            tag
            for tag in rims
            if len(beside := set(gmsh.model.getAdjacencies(1, tag)[0])) > 1 and not beside & (others | ends)
        ]
        # In front of a wall the flow turns within the gap, however wide the tube.
        free = radius if port is None else min(radius, _clearance(solid, port, mouth))
        at_mouth = min(sizes.mouth_edge * free, sizes.tube_layer)
        fields.append(_size_around("CurvesList", mouth, at_mouth, 0.0, sizes))
        along = min(sizes.tube * radius, sizes.tube_layer)
        fields.append(_size_around("SurfacesList", sorted(walls), along, 0.5 * radius, sizes))
    if sizes.wall is not None:
        everywhere = [tag for _, tag in gmsh.model.getEntities(2)]
        fields.append(_size_around("SurfacesList", everywhere, sizes.wall, sizes.wall, sizes))
    if fields:
        smallest = field.add("Min")
        field.setNumbers(smallest, "FieldsList", fields)
        field.setAsBackgroundMesh(smallest)


def _clearance(solid: cadquery.Solid, port: cadquery.Face, mouth: list[int]) -> float:
    """Distance from the mouth of a tube along its axis to the wall beyond, mm; infinite for a tube without a mouth."""
    import gmsh
    from OCP.gp import gp_Dir, gp_Lin, gp_Pnt
    from OCP.IntCurvesFace import IntCurvesFace_ShapeIntersector

    if not mouth:
        return math.inf
    start, axis = np.array(port.Center().toTuple()), -np.array(port.normalAt().toTuple())
    crossing = IntCurvesFace_ShapeIntersector()
    crossing.Load(solid.wrapped, 1e-7)
    crossing.Perform(gp_Lin(gp_Pnt(*start), gp_Dir(*axis)), 1e-6, 1e9)
    depths = [crossing.WParameter(k) for k in range(1, crossing.NbPnt() + 1)]
    rims = [(np.array(box[:3]) + np.array(box[3:])) / 2 for box in (gmsh.model.getBoundingBox(1, tag) for tag in mouth)]
    at_mouth = float((np.mean(rims, axis=0) - start) @ axis)
    # Where the mouth is cut from a curved wall or a mirror plane its middle is not exactly on the axis.
    beyond = [depth - at_mouth for depth in depths if depth - at_mouth > 1e-6]
    return min(beyond, default=math.inf)


def _port_radius(surface: int, others: set[int], face: cadquery.Face) -> float:
    """Radius of the circle with the port's area; each mirror plane leaves half of it."""
    import gmsh

    edges = [tag for _, tag in gmsh.model.getBoundary([(2, surface)], oriented=False)]
    planes = {int(beside) for edge in edges for beside in gmsh.model.getAdjacencies(1, edge)[0]} & others
    return math.sqrt(2 ** len(planes) * face.Area() / math.pi)


def _curvature_radius(surface: int) -> float:
    """Smaller radius of curvature at the middle of a surface's parameters, infinite where it is flat."""
    import gmsh

    low, high = gmsh.model.getParametrizationBounds(2, surface)
    middle = [(a + b) / 2 for a, b in zip(low, high, strict=True)]
    largest, smallest, _, _ = gmsh.model.getPrincipalCurvatures(surface, middle)
    curvature = max(abs(largest[0]), abs(smallest[0]))
    return 1 / curvature if curvature > 0 else math.inf


def _size_around(kind: str, tags: list[int], near: float, reach: float, sizes: MeshSizes) -> int:
    """Size field: ``near`` up to the distance ``reach`` from the entities, then growing to the largest."""
    import gmsh

    field = gmsh.model.mesh.field
    distance = field.add("Distance")
    field.setNumbers(distance, kind, tags)
    field.setNumber(distance, "Sampling", 60)
    threshold = field.add("Threshold")
    field.setNumber(threshold, "InField", distance)
    field.setNumber(threshold, "SizeMin", min(near, sizes.largest))
    field.setNumber(threshold, "SizeMax", sizes.largest)
    field.setNumber(threshold, "DistMin", reach)
    field.setNumber(threshold, "DistMax", reach + max(sizes.largest - near, 1e-9) / sizes.growth)
    return int(threshold)


def _read_mesh(surfaces: Mapping[str, int]) -> _Elements:
    import gmsh

    tags, coordinates, _ = gmsh.model.mesh.getNodes()
    position = np.full(int(tags.max()) + 1, -1, dtype=np.int64)
    position[tags.astype(np.int64)] = np.arange(len(tags))
    _, connectivity = gmsh.model.mesh.getElementsByType(11)
    tetrahedra = position[connectivity.astype(np.int64).reshape(-1, 10)][:, _GMSH_TO_SKFEM_NODES]
    if len(tetrahedra) == 0:
        raise MeshError("gmsh made no tetrahedra", kind=Kind.NO_RESULT)
    triangles: dict[str, list[NDArray[np.int64]]] = {name: [] for name in (*surfaces, WALL)}
    names = {tag: name for name, tag in surfaces.items()}
    for _, surface in gmsh.model.getEntities(2):
        _, nodes = gmsh.model.mesh.getElementsByType(9, surface)
        corners = position[nodes.astype(np.int64).reshape(-1, 6)][:, :3]
        triangles[names.get(surface, WALL)].append(corners)
    used, renumbered = np.unique(tetrahedra, return_inverse=True)
    position = np.full(len(tags), -1, dtype=np.int64)
    position[used] = np.arange(len(used))
    return (
        coordinates.reshape(-1, 3)[used],
        renumbered.reshape(tetrahedra.shape),
        {name: position[np.concatenate(parts)] for name, parts in triangles.items()},
    )
