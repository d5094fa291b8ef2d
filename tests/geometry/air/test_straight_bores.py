"""Lengths that are cut off the straight bores of a solid, and bores that stay."""

import cadquery as cq
import numpy as np
import pytest

from geometry.air.cells import Cell
from geometry.air.mesh import face_at
from geometry.air.mirror_symmetry import mirror_half
from geometry.air.straight_bores import KEPT_RADII, shortened
from geometry.air.volume import air_volume
from geometry.schema.ports import CellPort

RADIUS = 0.25


def cell(*angles, height=None):
    return Cell("resonator", 6.0, 2.5, 1.25, tuple(CellPort(angle, 2 * RADIUS, height) for angle in angles), 6.0, 0.0)


def with_bore(bore):
    """A box with a bore that ends at x = 4, and that port."""
    return cq.Workplane().box(3, 3, 3).union(bore).val(), {"a": (4.0, 0.0, 0.0)}


@pytest.mark.parametrize("height", [None, 1.0])
@pytest.mark.parametrize("angles", [(0.0, 90.0), (0.0, 180.0), (0.0, 100.0, 240.0)], ids=str)
def test_of_each_bore_of_a_cell_two_radii_are_left_before_its_mouth(angles, height):
    """Symmetric cells are drawn as a half or a quarter, and so are their bores."""
    air = air_volume(cell(*angles, height=height))
    points = air.faces
    short = shortened(air.solid, points, list(air.ports))
    share = 0.5 ** len(air.mirrors)
    gone = sum(share * np.pi * bore.radius**2 * bore.length for bore in short.bores)
    assert [bore.radius for bore in short.bores] == pytest.approx([RADIUS] * len(angles))
    # the wall of a cylinder is nearest above and below the axis, where it was drawn from
    assert [bore.length for bore in short.bores] == pytest.approx([(4 - KEPT_RADII) * RADIUS] * len(angles), abs=2e-3)
    assert air.solid.Volume() - short.solid.Volume() == pytest.approx(gone, rel=1e-4)
    for name, bore in zip(air.ports, short.bores, strict=True):
        before, after = (np.array(each[name]) for each in (points, short.points))
        assert np.linalg.norm(before - after) == pytest.approx(bore.length)
        assert face_at(short.solid, name, short.points[name]).Area() == pytest.approx(share * np.pi * RADIUS**2)
    assert short.points["opening"] == points["opening"]


def test_bores_of_a_mirrored_cad_solid_are_cut_too():
    solid = cq.Workplane().cylinder(2.5, 3).union(cq.Workplane("YZ").circle(RADIUS).extrude(9.25, both=True)).val()
    ports = {"a": (9.25, 0, 0), "b": (-9.25, 0, 0)}
    half = mirror_half(solid, ports)
    bores = shortened(half.solid, {**half.ports, "mirror": half.mirror}, ["a", "b"]).bores
    assert [bore.length for bore in bores] == pytest.approx([6.25 - KEPT_RADII * RADIUS] * 2, abs=2e-3)


@pytest.mark.parametrize(
    "bore",
    [
        cq.Workplane("YZ").rect(0.4, 0.4).extrude(4.0),
        cq.Workplane(cq.Solid.makeCone(0.6, RADIUS, 4.0, cq.Vector(0, 0, 0), cq.Vector(1, 0, 0))),
        cq.Workplane("YZ").circle(1.2).extrude(4.0),
    ],
    ids=["square", "cone", "short for its width"],
)
def test_what_is_no_long_round_bore_stays(bore):
    solid, ports = with_bore(bore)
    short = shortened(solid, ports, ["a"])
    assert (short.bores[0].length, short.points) == (0.0, ports)


def test_a_tube_between_two_ports_has_no_mouth_and_stays():
    tube = cq.Solid.makeCylinder(RADIUS, 5.0)
    short = shortened(tube, {"a": (0, 0, 0), "b": (0, 0, 5.0)}, ["a", "b"])
    assert [bore.length for bore in short.bores] == [0.0, 0.0]
    assert short.solid.Volume() == tube.Volume()


def test_a_bore_beside_which_another_wall_lies_close_stays():
    """The piece that would be cut away with it belongs to another part of the air."""
    bores = cq.Workplane("YZ").pushPoints([(0, 0), (0, 0.51)]).circle(RADIUS).extrude(4.0)
    solid, ports = with_bore(bores)
    assert shortened(solid, ports, ["a"]).bores[0].length == 0.0


@pytest.mark.parametrize("half", [True, False])
def test_a_tube_that_ends_at_a_wall_keeps_two_radii_before_it_and_its_mirror(half):
    tube, port = cq.Workplane("XY").circle(0.5).extrude(20).val(), {"a": (0.0, 0.0, 0.0)}
    found = mirror_half(tube, port)
    points = {**found.ports, "mirror": found.mirror} if half else port
    short = shortened(found.solid if half else tube, points, ["a"])
    assert short.bores[0].length == pytest.approx(20 - KEPT_RADII * 0.5)
    assert short.solid.Volume() == pytest.approx(np.pi * 0.25 * KEPT_RADII * 0.5 * (0.5 if half else 1), rel=1e-6)
    for name, point in short.points.items():
        assert face_at(short.solid.Solids()[0], name, point).geomType() == "PLANE"
