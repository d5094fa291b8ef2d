"""Measures of solids, against the kernel."""

import cadquery as cq
import numpy as np
import pytest
from OCP.BRepAdaptor import BRepAdaptor_Surface

from geometry.solids.measure import surface_points, tessellate

SOLIDS = {
    "cylinder": cq.Solid.makeCylinder(2, 3, cq.Vector(1, 2, 3), cq.Vector(1, 1, 0)),
    "cone": cq.Solid.makeCone(2, 1, 3, cq.Vector(0, 1, 0), cq.Vector(0, -1, 2)),
    "sphere": cq.Solid.makeSphere(2, cq.Vector(0, 1, 0), cq.Vector(0, -1, 2)),
    "torus": cq.Solid.makeTorus(3, 1, cq.Vector(0, 1, 0), cq.Vector(0, -1, 2)),
    "spline": cq.Workplane().spline([(0, 0), (2, 1), (3, 4)]).lineTo(0, 4).close().extrude(2).val(),
}


@pytest.mark.parametrize("mirrored", [False, True])
@pytest.mark.parametrize("moved", [False, True])
@pytest.mark.parametrize("kind", SOLIDS)
def test_points_of_surfaces_are_those_of_the_kernel(kind, moved, mirrored):
    solid = SOLIDS[kind].mirror("XZ") if mirrored else SOLIDS[kind]
    if moved:
        solid = solid.moved(cq.Location(cq.Vector(5, 6, 7), cq.Vector(1, 2, 3), 40))
    for face in solid.Faces():
        surface = BRepAdaptor_Surface(face.wrapped)
        first = np.array([surface.FirstUParameter(), surface.FirstVParameter()])
        last = np.array([surface.LastUParameter(), surface.LastVParameter()])
        at = first + (last - first) * np.random.default_rng(0).random((20, 2))
        kernel = [surface.Value(u, v).Coord() for u, v in at.tolist()]
        np.testing.assert_allclose(surface_points(surface, at), kernel, atol=1e-12)


@pytest.mark.parametrize("kind", SOLIDS)
def test_facets_of_a_moved_solid_lie_where_it_lies(kind):
    place = cq.Location(cq.Vector(5, 6, 7), cq.Vector(1, 2, 3), 40)
    still, moved = (tessellate(solid, 0.05, 0.2) for solid in (SOLIDS[kind], SOLIDS[kind].moved(place)))
    assert moved.volume == pytest.approx(still.volume, rel=1e-9)
    assert moved.deviation == pytest.approx(still.deviation, rel=1e-6, abs=1e-12)
    box = SOLIDS[kind].moved(place).BoundingBox(1e-4)
    np.testing.assert_allclose(moved.vertices.min(0), [box.xmin, box.ymin, box.zmin], atol=0.06)
    np.testing.assert_allclose(moved.vertices.max(0), [box.xmax, box.ymax, box.zmax], atol=0.06)
