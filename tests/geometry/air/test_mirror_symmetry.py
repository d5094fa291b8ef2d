"""Planes that mirror a body of air and its ports: found where they are, and nowhere else."""

import cadquery as cq
import numpy as np
import pytest

from geometry.air.mirror_symmetry import mirror_half

BORE, REACH = 0.25, 4.0


def with_tubes(body, *angles, height=1.5):
    """A body around the origin with round tubes, and the middles of their ends."""
    ports = {}
    for number, angle in enumerate(angles):
        direction = cq.Vector(np.cos(np.radians(angle)), np.sin(np.radians(angle)), 0)
        start, end = (cq.Vector(0, 0, height) + direction * reach for reach in (1.0, REACH))
        body = body.fuse(cq.Solid.makeCylinder(BORE, (end - start).Length, start, direction))
        ports[f"port {number}"] = end.toTuple()
    return body.clean().Solids()[0], ports


CYLINDER = cq.Solid.makeCylinder(3, 3)
BOX = cq.Solid.makeBox(5, 4, 3, cq.Vector(-2.5, -2, 0))
DOME = cq.Workplane().sphere(3).val().intersect(cq.Solid.makeBox(8, 8, 4, cq.Vector(-4, -4, 0)))


@pytest.mark.parametrize(
    ("body", "angles", "height"),
    [(CYLINDER, (0, 180), 1.0), (CYLINDER, (20, 110, 250), 1.5), (BOX, (0,), 1.0), (DOME, (70, 250), 1.0)],
    ids=["line", "three ports at mid height", "box", "dome with a turned line"],
)
def test_a_mirror_plane_leaves_half_of_the_body_and_of_each_port(body, angles, height):
    solid, ports = with_tubes(body, *angles, height=height)
    half = mirror_half(solid, ports)
    assert half is not None
    assert half.solid.isValid()
    assert 2 * half.solid.Volume() == pytest.approx(solid.Volume(), rel=1e-4)
    assert set(half.ports) == set(ports)
    for name, point in half.ports.items():
        assert 0 < np.linalg.norm(np.subtract(point, ports[name])) < BORE


def test_a_body_without_a_plane_through_its_ports_stays_whole():
    # Two tubes at a right angle below mid height: the plane between them would exchange them.
    assert mirror_half(*with_tubes(CYLINDER, 0, 90, height=1.0)) is None
    dented = CYLINDER.cut(cq.Solid.makeSphere(0.4, cq.Vector(1.5, 2.0, 3.0), angleDegrees1=-90))
    assert mirror_half(*with_tubes(dented, 0, 180, height=1.0)) is None


@pytest.mark.parametrize("angle", [45, 90, 180])
def test_a_twisted_body_has_the_faces_of_its_mirror_image_and_stays_whole(angle):
    twisted = cq.Workplane().rect(2, 0.6).twistExtrude(2.5, angle)
    ends = {"below": (0, 0, 0), "above": (0, 0, 2.5)}
    assert mirror_half(twisted.val(), ends) is None
    # Straight, it has its planes.
    assert mirror_half(cq.Workplane().rect(2, 0.6).extrude(2.5).val(), ends) is not None
