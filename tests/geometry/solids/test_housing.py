"""Microphone housings: the chamber is the simulated one, the board has its seat, one to six lines fit in."""

import math

import cadquery as cq
import numpy as np
import pytest
from refusals import refused

from geometry import Kind
from geometry.air.cells import Cell
from geometry.air.volume import air_volume
from geometry.schema.manufacture import Printing
from geometry.schema.part_fields import Microphone
from geometry.schema.ports import CellPort, Port
from geometry.solids.housing import build_board, build_housing
from geometry.solids.round_solids import cylinder

PRINTING = Printing(port_lip=0.3)


def microphone(**values):
    return Microphone(**{"chamber_diameter": 3.0, "chamber_height": 2.0, "sound_hole_length": 0.4, **values})


def ports(count, bore=0.44, outside=0.9):
    return [Port(360.0 * k / count, bore, outside) for k in range(count)]


def closed(mic, sides):
    """Housing with its board on the seat, and a rod in every port from the wall of the chamber outwards."""
    housing = build_housing(mic, PRINTING, sides).val()
    board = build_board(mic).val().moved(cq.Location(cq.Vector(0, 0, mic.chamber_height)))
    chamber = cylinder(mic.chamber_diameter / 2, 0, mic.chamber_height)
    rods = []
    for port in sides:
        turn = math.radians(port.angle)
        rod = cq.Solid.makeCylinder(
            0.3, 12.0, cq.Vector(0, 0, mic.chamber_height / 2), cq.Vector(math.cos(turn), math.sin(turn), 0)
        )
        rods.append(rod.cut(chamber))
    return housing, board, rods


@pytest.mark.parametrize(("count", "gasket"), [(1, None), (2, 0.8), (3, None), (4, None), (5, None), (6, 0.8)])
def test_chamber_and_sound_hole_hold_the_given_volume(count, gasket):
    mic = microphone(gasket_width=gasket, gasket_depth=0.3)
    housing, board, rods = closed(mic, ports(count))
    box = cq.Compound.makeCompound([housing, board]).BoundingBox()
    block = cq.Solid.makeBox(box.xlen, box.ylen, box.zlen, cq.Vector(box.xmin, box.ymin, box.zmin))
    cap = cylinder(1.0, mic.chamber_height + mic.sound_hole_length, box.zmax)  # where the package sits
    voids = block.cut(housing, board, cap, *rods).Solids()
    inside = [void for void in voids if void.isInside(cq.Vector(0, 0, 0.1 * mic.chamber_height))]
    hole = math.pi / 4 * mic.sound_hole_diameter**2 * mic.sound_hole_length
    assert [void.Volume() for void in inside] == pytest.approx([mic.chamber_volume + hole], rel=2e-5)
    if gasket is not None:
        # The groove is a ring of its own between board and seat, closed on all sides.
        inner = mic.chamber_diameter / 2 + 0.6
        ring = math.pi * ((inner + gasket) ** 2 - inner**2) * 0.3
        assert any(void.Volume() == pytest.approx(ring, rel=1e-9) for void in voids)


@pytest.mark.slow
@pytest.mark.parametrize("count", [1, 2, 6])
def test_the_parts_leave_the_simulated_air(count):
    mic, sides = microphone(), ports(count)
    housing, board, _ = closed(mic, sides)
    cell = Cell(
        kind="microphone",
        diameter=mic.chamber_diameter,
        height=mic.chamber_height,
        port_height=mic.chamber_height / 2,
        ports=tuple(CellPort(port.angle, port.bore_diameter) for port in sides),
        opening_diameter=mic.sound_hole_diameter,
        opening_length=mic.sound_hole_length,
    )
    air = air_volume(cell).solid
    assert air.intersect(housing).Volume() + air.intersect(board).Volume() < 1e-9
    # Grown by a hair the air meets the parts on every wall it has in them: chamber, bores and sound hole.
    shifts = [(1e-3, 0, 0), (-1e-3, 0, 0), (0, 1e-3, 0), (0, 0, 1e-3), (0, 0, -1e-3)]
    for shift in shifts:
        near = air.moved(cq.Location(cq.Vector(*shift)))
        assert near.intersect(housing).Volume() + near.intersect(board).Volume() > 1e-4


def test_the_board_lies_in_its_seat_with_the_package_below_the_rim():
    mic = microphone(package_height=1.1, gasket_width=0.6, gasket_depth=0.3)
    housing, board, _ = closed(mic, ports(2))
    assert housing.intersect(board).Volume() < 1e-9
    assert housing.distance(board) < 1e-9
    pressed = board.moved(cq.Location(cq.Vector(0, 0, -1e-3)))
    inner, outer = mic.chamber_diameter / 2 + 0.6, mic.chamber_diameter / 2 + 1.2
    seat = np.prod(mic.board_size) - math.pi * (outer**2 - inner**2) - math.pi / 4 * mic.chamber_diameter**2
    assert housing.intersect(pressed).Volume() == pytest.approx(1e-3 * seat, rel=1e-6)
    assert housing.BoundingBox().zmax == pytest.approx(mic.chamber_height + 0.4 + 1.1, abs=1e-6)
    # It has its clearance on both sides and is held beyond it.
    for shift, held in ((mic.board_gap - 0.01, False), (mic.board_gap + 0.01, True)):
        for axis in ((1, 0), (0, 1), (-1, 0)):
            aside = board.moved(cq.Location(cq.Vector(shift * axis[0], shift * axis[1], 0)))
            assert (housing.intersect(aside).Volume() > 1e-4) == held


@pytest.mark.parametrize("wall", [0.8, 2.6])
def test_wires_leave_the_seat_through_its_slot(wall):
    mic = microphone(wall_thickness=wall)
    housing = build_housing(mic, PRINTING, ports(2)).val()
    wires = cq.Solid.makeBox(10, 1.5, 0.3, cq.Vector(-10, -0.75, mic.chamber_height + 0.4))
    assert housing.intersect(wires).Volume() < 1e-9
    assert housing.intersect(wires.mirror("YZ")).Volume() > 0.3


def test_the_board_has_the_sound_hole_and_covers_package_chamber_and_gasket():
    mic = microphone()
    assert mic.board_size == pytest.approx((4.5, 4.2))  # 0.5 around the package, 0.6 around the chamber
    board = build_board(mic).val()
    assert board.Volume() == pytest.approx((4.5 * 4.2 - math.pi * 0.25**2) * 0.4, rel=1e-9)
    assert microphone(gasket_width=0.8).board_size == pytest.approx((7.0, 7.0))
    assert microphone(board_length=8.0).board_size == pytest.approx((8.0, 4.2))


@pytest.mark.parametrize("angle", [0.0, 60.0, 90.0])
def test_tubes_have_a_free_way_below_the_seat(angle):
    mic = microphone(chamber_height=1.3)
    housing = build_housing(mic, PRINTING, [Port(0.0, 0.44, 0.8), Port(angle + 90.0, 0.44, 0.8)]).val()
    for turn in (0.0, math.radians(angle + 90.0)):
        direction = cq.Vector(math.cos(turn), math.sin(turn), 0)
        start = cq.Vector(0, 0, 0.65) + direction * (mic.chamber_diameter / 2 + 0.3)
        assert housing.intersect(cq.Solid.makeCylinder(0.4, 20.0, start, direction)).Volume() < 1e-9
        assert housing.intersect(cq.Solid.makeCylinder(0.46, 20.0, start, direction)).Volume() > 1e-3


def test_a_deep_groove_leaves_a_seat_as_thick_as_the_wall():
    mic = microphone(chamber_height=6.0, gasket_width=0.8, gasket_depth=1.5, wall_thickness=0.5, board_length=9.0)
    housing = build_housing(mic, PRINTING, ports(1)).val()
    below = cylinder(3.0, 4.4, 4.6).cut(cylinder(2.1, 4.4, 4.6))
    assert housing.intersect(below).Volume() == pytest.approx(
        below.Volume() - 0.1 * math.pi * (2.9**2 - 2.1**2), rel=1e-6
    )


def test_a_housing_without_a_port_is_refused():
    with refused(Kind.MISSING, "ports"):
        build_housing(microphone(), PRINTING, [])
