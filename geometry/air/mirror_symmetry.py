"""Half of a solid that is its own mirror image, where every port is its own mirror image too."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import cadquery as cq
import numpy as np

from geometry.air.mesh import Point, face_at, inner_point
from geometry.ground.typed import Array

#: Places that agree within this part of the solid's size are the same; the CAD kernel is a few times better.
_SAME = 1e-5
#: Volumes and areas that do; the CAD kernel integrates them to about 1e-5.
_SAME_CONTENT = 1e-4
#: Points of each face whose mirror images are looked for.
_PROBES = 40


@dataclass(frozen=True)
class Half:
    """One side of a mirror plane, with points on the faces that the plane cut."""

    solid: cq.Solid
    """The half, mm."""
    ports: dict[str, Point]
    """A point on the remaining part of each port, mm."""
    mirror: Point
    """A point on the mirror plane's face, mm."""


def mirror_half(solid: cq.Solid, ports: Mapping[str, Point]) -> Half | None:
    """Half of a solid, if a plane mirrors the solid onto itself and every port onto itself.

    Faces are compared by kind, area, centre and points all over them. Planes are sought through the centre of
    volume, across the axes of the coordinates and of inertia and along the axis of each port.

    Args:
        solid: one closed solid, mm.
        ports: name -> a point on its flat face, mm.

    Returns:
        None where no such plane is found, or where it would cut the solid or a face into more than two.

    Raises:
        MeshError: a port lies on no flat face, or on several.
    """
    faces = {name: face_at(solid, name, point) for name, point in ports.items()}
    centre, size = _vector(solid.Center()), solid.BoundingBox().DiagonalLength
    axes = [(_vector(face.Center()), _vector(face.normalAt())) for face in faces.values()]
    # The ports' axes and the vectors from the first port to the others must lie in the plane.
    within = np.array([*(direction for _, direction in axes), *(place - axes[0][0] for place, _ in axes[1:])])
    for candidate in _candidates(solid, centre, axes):
        if np.abs(within @ candidate).max() > 1e-4 * size or abs((axes[0][0] - centre) @ candidate) > _SAME * size:
            continue
        # Axes of inertia are good to about 1e-6 only; the ports' are exact.
        normal = candidate - np.linalg.pinv(within, rcond=1e-6) @ (within @ candidate)
        normal /= np.linalg.norm(normal)
        if np.abs(within @ normal).max() < _SAME and _mirrors(solid, centre, normal, size):
            half = _cut(solid, faces, axes[0][0], normal, size)
            if half is not None:
                return half
    return None


def _candidates(solid: cq.Solid, centre: Array, axes: list[tuple[Array, Array]]) -> Iterator[Array]:
    _, principal = np.linalg.eigh(np.array(cq.Shape.matrixOfInertia(solid)))
    basis = [*np.eye(3), *principal.T]
    crossed = [np.cross(direction, other) for _, direction in axes for other in basis]
    crossed += [np.cross(direction, place - centre) for place, direction in axes]
    tried: list[Array] = []
    for normal in [*basis, *crossed]:
        length = np.linalg.norm(normal)
        if length < _SAME or any(abs(normal @ other) > (1 - 1e-9) * length for other in tried):
            continue
        tried.append(normal / length)
        yield normal / length


def _mirrors(solid: cq.Solid, centre: Array, normal: Array, size: float) -> bool:
    """True where each face of the solid is the mirror image of one of its faces.

    A twisted face has the area and the centre of its image without being it: points all over each face must
    have their images on the other.
    """
    faces = solid.Faces()
    places = np.array([_vector(face.Center()) for face in faces])
    areas = np.array([face.Area() for face in faces])
    kinds = [face.geomType() for face in faces]
    partners: list[list[int]] = []
    for k, image in enumerate(_mirrored(places, centre, normal)):
        near = (np.linalg.norm(places - image, axis=1) < _SAME * size) & (
            np.abs(areas - areas[k]) < _SAME_CONTENT * areas[k]
        )
        partners.append([other for other in np.flatnonzero(near).tolist() if kinds[other] == kinds[k]])
    if not all(partners):
        return False
    random = np.random.default_rng(0)
    for face, others in zip(faces, partners, strict=True):
        nodes, _ = face.tessellate(0.02 * size, 0.3)
        corners = np.array([_vector(node) for node in nodes])
        # Nodes lie on the face; the middles of its facets would not.
        chosen = random.permutation(len(corners))[:_PROBES]
        images = [cq.Vertex.makeVertex(*image) for image in _mirrored(corners[chosen], centre, normal)]
        if not any(all(faces[other].distance(image) < _SAME * size for image in images) for other in others):
            return False
    return True


def _mirrored(points: Array, centre: Array, normal: Array) -> Array:
    return points - 2 * np.outer((points - centre) @ normal, normal)


def _cut(solid: cq.Solid, faces: Mapping[str, cq.Face], centre: Array, normal: Array, size: float) -> Half | None:
    plane = cq.Plane(origin=tuple(centre), normal=tuple(normal))
    space = cq.Workplane(plane).box(4 * size, 4 * size, 2 * size, centered=(True, True, False)).val()
    halves = solid.intersect(space).Solids()
    if len(halves) != 1 or not halves[0].isValid() or abs(2 * halves[0].Volume() / solid.Volume() - 1) > _SAME_CONTENT:
        return None

    def left_of(place: Array, direction: Array) -> list[cq.Face]:
        """Flat faces of the half in a plane."""
        return [
            face
            for face in halves[0].Faces()
            if face.geomType() == "PLANE"
            and abs((_vector(face.Center()) - place) @ direction) < _SAME * size
            and abs(abs(_vector(face.normalAt()) @ direction) - 1) < _SAME
        ]

    mirror = left_of(centre, normal)
    ports = {}
    for name, face in faces.items():
        whole, place = face.Area(), _vector(face.Center())
        own = [
            part
            for part in left_of(place, _vector(face.normalAt()))
            if abs(2 * part.Area() - whole) < _SAME_CONTENT * whole and part.distance(face) < _SAME * size
        ]
        if len(own) != 1:
            return None
        ports[name] = inner_point(own[0])
    return Half(halves[0], ports, inner_point(mirror[0])) if len(mirror) == 1 else None


def _vector(value: cq.Array) -> Array:
    return np.array(value.toTuple())
