"""Layers of a part: islands, overhangs, thin walls and overcured bores are those of a slicer and of closed forms."""

import math

import cadquery as cq
import numpy as np
import pytest
from prusa_slicer import slice_file

import geometry
from geometry.printing.bleed import open_bores
from geometry.printing.layer_rules import judge_layers
from geometry.printing.overhangs import Cups
from geometry.printing.pose import find_pose
from geometry.printing.printability import print_report
from geometry.printing.round_faces import round_distance, round_face
from geometry.printing.slices import Slices
from geometry.printing.walls import _distance
from geometry.schema.print_processes import PROCESSES, with_rules
from geometry.solids.measure import rounds, tessellate

SLA = PROCESSES["sla-resin"]
OVER = np.diag([1.0, -1.0, -1.0])


def slices_of(solid, rotation=None, layer=0.05, pixel=0.05):
    return Slices(tessellate(solid, 0.002), np.eye(3) if rotation is None else rotation, layer, pixel)


def bridge(pegs):
    """A bridge on two piers, with pegs that hang from it: the corner and the height of each, mm."""
    whole = cq.Solid.makeBox(20, 6, 8).cut(cq.Solid.makeBox(16, 6, 6, cq.Vector(2, 0, 0)))
    for x, height in pegs:
        whole = whole.fuse(cq.Solid.makeBox(1, 1, height + 0.5, cq.Vector(x, 2, 6 - height)))
    return whole.clean()


def test_what_hangs_from_a_bridge_is_an_island_in_its_layer_and_place():
    solid = bridge([(4, 2.0), (8, 3.0), (12, 2.0)])
    found = slices_of(solid).islands()
    assert sorted(island.layer for island in found) == [60, 80, 80]  # 3 and 4 mm above the plate
    assert [island.area for island in found] == pytest.approx([1, 1, 1], rel=1e-3)
    assert found[0].place == pytest.approx((8.5, 2.5, 3.025), abs=0.8)
    assert slices_of(solid, OVER).islands() == []  # built from its top nothing begins in the air


def test_islands_smaller_than_a_pixel_are_counted_where_they_grow_to_one():
    cone = cq.Solid.makeCone(0, 1, 3, cq.Vector(10, 3, 3))
    solid = bridge([]).fuse(cone)
    (island,) = slices_of(solid).islands()
    # The section of the cone is a pixel of 0.05 mm at a radius of 0.028 mm: in the second layer above its tip.
    assert island.layer in (61, 62)


@pytest.mark.parametrize("width", [1.0, 4.0, 16.0])
def test_a_bridge_reaches_half_its_width_and_a_ledge_all_of_it(width):
    table = cq.Solid.makeBox(20, 6, 3).cut(cq.Solid.makeBox(width, 6, 2, cq.Vector(1, 0, 0)))
    assert slices_of(table).overhang(19).span == pytest.approx(width / 2, rel=0.05)
    ledge = cq.Solid.makeBox(20, 6, 1).fuse(cq.Solid.makeBox(20 + width, 6, 1, cq.Vector(0, 0, 1))).clean()
    found = slices_of(ledge).overhang(19)
    assert found.span == pytest.approx(width, rel=0.05)
    assert found.place[0] == pytest.approx(20 + width, abs=0.2)


def test_a_slope_steeper_than_the_angle_reaches_nowhere():
    def wedge(angle):
        side = 4 / math.tan(math.radians(angle))
        return cq.Workplane("XZ").polyline([(0, 0), (5, 0), (5 + side, 4), (0, 4)]).close().extrude(5).val()

    assert slices_of(wedge(25)).overhang(19).span == 0
    assert slices_of(wedge(10)).overhang(19).span == pytest.approx(0.05 / math.tan(math.radians(10)), rel=0.05)


def test_walls_under_two_pixels_are_found_and_corners_are_not():
    def fin(width):
        return cq.Solid.makeBox(10, 6, 1).fuse(cq.Solid.makeBox(width, 6, 3, cq.Vector(5, 0, 1))).clean()

    (wall, *_) = slices_of(fin(0.08)).thin_walls()
    assert wall.width == pytest.approx(0.08, rel=0.03)
    assert wall.area == pytest.approx(0.08 * 6, rel=0.1)
    assert wall.place[0] == pytest.approx(5.04, abs=0.05)
    assert slices_of(fin(0.12)).thin_walls() == []
    wedge = cq.Workplane().polyline([(0, 0), (10, 0), (0, 4)]).close().extrude(3).val()
    assert slices_of(wedge).thin_walls() == []


def bored(diameter, offset=0.0, turn=0.0):
    drill = cq.Solid.makeCylinder(diameter / 2, 14, cq.Vector(-2, 5, 2.5 + offset), cq.Vector(1, 0, 0))
    return cq.Solid.makeBox(10, 10, 5).cut(drill).rotate(cq.Vector(), cq.Vector(0, 0, 1), turn)


@pytest.mark.parametrize("turn", [0.0, 33.0])
def test_two_layers_of_bleed_halve_a_bore_of_044_and_close_one_of_018(turn):
    """Areas that a slicer's own pictures gave, with light spread by 0.05 mm and two layers of bleed."""

    def left(diameter, layer, offset=0.0):
        solid = bored(diameter, offset, turn)
        (one,) = open_bores(slices_of(solid, layer=layer), rounds(solid), 2 * layer, 0.05)
        return one.left * math.pi * diameter**2 / 4

    assert left(0.44, 0.05) == pytest.approx(0.076, rel=0.03)
    assert left(0.54, 0.05) == pytest.approx(0.123, rel=0.08)
    assert left(0.18, 0.05) == 0
    assert left(0.18, 0.01) == pytest.approx(0.0068, rel=0.02)


def test_overcure_of_a_wide_bore_is_that_of_the_closed_form():
    """In thin layers: the chord of each place across the bore, less the depth; without bleed all of it."""
    solid, depth, spread = bored(2.0), 0.3, 0.1
    slices = slices_of(solid, layer=0.01)
    across = np.linspace(-1 + spread, 1 - spread, 20001)
    chord = 2 * np.sqrt(1 - (np.abs(across) + spread) ** 2)
    exact = np.maximum(chord - depth, 0).sum() * (across[1] - across[0]) / math.pi
    assert open_bores(slices, rounds(solid), depth, spread)[0].left == pytest.approx(exact, rel=0.01)
    assert open_bores(slices, rounds(solid), 0.0, 0.0)[0].left == pytest.approx(1, rel=0.01)
    standing = cq.Solid.makeBox(5, 5, 5).cut(cq.Solid.makeCylinder(1, 5, cq.Vector(2.5, 2.5, 0)))
    assert open_bores(slices_of(standing), rounds(standing), depth, spread) == []


def test_layers_that_only_upright_faces_cross_are_cut_once():
    slices = slices_of(bridge([]))
    assert len({id(section) for section in slices.sections}) < 6
    areas = [section.area() for section in slices.sections]
    assert areas[:120] == pytest.approx([24.0] * 120)
    assert areas[120:] == pytest.approx([120.0] * 40)


def test_a_part_on_its_head_is_also_judged_as_its_own_file_stands():
    dish = cq.Workplane().circle(7).extrude(3).faces("<Z").workplane().circle(5.5).cutBlind(-1.5)
    dish = dish.union(cq.Workplane().workplane(offset=3).rect(16, 16).extrude(1))
    facets = tessellate(dish.val(), 0.005)
    pose = find_pose(facets, SLA)
    found = {one.rule: one for one in judge_layers("dish", facets, SLA, [], pose, Cups(facets, 0.5))}
    assert pose.upside_down == ("sealed cup of its own file" in found)
    assert pose.upside_down
    assert found["free border of the plate"].value == pytest.approx((145 - 16) / 2)


def test_thin_plates_are_mostly_first_layers():
    report = print_report({"shim": cq.Workplane().box(10, 10, 0.55), "block": cq.Workplane().box(10, 10, 4)})
    found = {one.part: one for one in report.findings if one.rule == "height in first layers"}
    assert found["shim"].value == pytest.approx(8 * 0.05 / 0.55)
    assert (found["shim"].verdict, found["block"].verdict) == ("warn", "ok")
    powder = {one.rule for one in print_report({"block": cq.Workplane().box(10, 10, 4)}, "mjf").findings}
    assert powder.isdisjoint({"islands", "height in first layers", "bore after overcure", "free border of the plate"})


@pytest.mark.parametrize("apart", [0.0, 6.5])
@pytest.mark.parametrize("tilt", [0.0, 20.0])
def test_the_distance_of_round_faces_of_parallel_axes_is_that_of_the_cad_kernel(tilt, apart):
    random = np.random.default_rng(7)
    for _ in range(12):
        solids = []
        for at in (0.0, apart):
            low, high, base, height = random.uniform([0.5, 0.5, -3, 0.5], [3, 3, 3, 4])
            solids.append(cq.Solid.makeCone(low, high, height, cq.Vector(0, at, base)))
        faces = [
            next(
                face
                for face in solid.rotate(cq.Vector(), cq.Vector(1, 0, 0), tilt).Faces()
                if face.geomType() != "PLANE"
            )
            for solid in solids
        ]
        value, ends = round_distance(*map(round_face, faces))
        assert value == pytest.approx(_distance(*faces)[0], abs=1e-6)
        assert all((end - start).Length == pytest.approx(value, abs=1e-9) for start, end in ends)


def test_round_faces_have_no_closed_form_where_one_may_be_in_the_other_or_their_axes_cross():
    upright = round_face(cq.Solid.makeCylinder(1, 2).Faces()[0])
    for place, direction in (((1.5, 0, 0), (0, 0, 1)), ((3, 0, 0), (0, 1, 0))):
        other = cq.Solid.makeCylinder(1, 2, cq.Vector(*place), cq.Vector(*direction)).Faces()[0]
        assert round_distance(upright, round_face(other)) is None
    assert round_face(cq.Solid.makeBox(1, 1, 1).Faces()[0]) is None


@pytest.mark.slow
def test_prusaslicer_finds_as_many_islands(tmp_path):
    """Its pictures, not its own count: of a bridge with pegs and without, and of a housing."""
    housing = geometry.build_parts(geometry.prototype("array-2x6"))["microphone-housing"].val()
    small = with_rules(SLA, {"build_volume": (34.0, 34.0, 60.0)})
    solids = {"bridge": bridge([(4, 2.0), (8, 3.0), (12, 2.0)]), "flat": bridge([]), "housing": housing}
    for name, solid in solids.items():
        cq.exporters.export(cq.Workplane(solid), str(tmp_path / f"{name}.stl"), tolerance=0.002, angularTolerance=0.1)
        sliced = slice_file(tmp_path / f"{name}.stl", small, tmp_path)
        ours = slices_of(solid, layer=small.layer, pixel=small.pixel)
        assert abs(len(sliced.lit) - len(ours.sections)) <= 1  # a height of half a layer is rounded either way
        assert sliced.islands == len(ours.islands())
        both = range(min(len(sliced.lit), len(ours.sections)))
        lit = sliced.lit[: len(both)] * small.pixel**2
        areas = np.array([ours.sections[layer].area() for layer in both])
        off = np.abs(lit - areas) > 0.06 * areas + 0.3  # half a pixel at walls of 1 mm
        assert off.sum() <= 3, (name, np.flatnonzero(off), lit[off], areas[off])
