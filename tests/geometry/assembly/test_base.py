"""The base plate: parts fit into it and stay where the layout has them, pieces lock, clashes are refused by name."""

import math
from itertools import pairwise

import numpy as np
import pytest
from refusals import refused

import geometry
from geometry import Kind
from geometry.assembly.base_plan import plan_base
from geometry.assembly.fit import interferences
from geometry.assembly.model import array_model
from geometry.layout.arrangement import lay_out
from geometry.printing.plates import export_plates
from geometry.printing.printability import print_report
from geometry.schema.print_processes import process_of
from geometry.solids.base_plate import draw_base

PLATE = {"base.kind": "plate"}
SMALL = {**PLATE, "lines.0.points": 4, "layout.columns": 2}


def design(**values):
    return geometry.prototype("array-2x6").with_values({**SMALL, **values})


def pieces_of(drawn):
    return [piece.val() for piece in draw_base(plan_base(drawn, lay_out(drawn)))]


@pytest.mark.slow
def test_every_part_lies_in_the_plate_and_none_in_its_material():
    model = array_model(design())
    assert [part.part for part in model.placed if part.kind == "base"] == ["base"]
    assert [both for both in interferences(model) if "base" in (both.first, both.second)] == []


def test_shells_and_housings_cannot_slide_and_stand_on_the_floor_of_their_seats():
    drawn = design()
    plan, layout = plan_base(drawn, lay_out(drawn)), lay_out(drawn)
    (plate,) = pieces_of(drawn)
    placed = [*layout.points, *layout.microphones]
    assert len(plan.seats) == len(placed) == 6
    for seat, part in zip(plan.seats, placed, strict=True):
        x, y = part.position
        for angle in np.arange(7.0, 360.0, 45.0):
            turn = math.radians(angle)
            for reach, inside in ((seat.radius - 0.05, False), (seat.radius + 0.5, True)):
                at = (x + reach * math.cos(turn), y + reach * math.sin(turn), seat.bottom + 0.2)
                assert plate.isInside(at) == inside, (part, angle)
        assert plate.isInside((x, y, seat.bottom - 0.05))
        assert not plate.isInside((x, y, seat.bottom + 0.05))
    assert {seat.bottom for seat in plan.seats[:4]} == {-drawn.resonator.floor_thickness}


def test_each_tube_lies_in_a_saddle_along_its_course():
    drawn = design(**{"layout.pitch": 17.0})  # tubes are bowed
    plan, layout = plan_base(drawn, lay_out(drawn)), lay_out(drawn)
    (plate,) = pieces_of(drawn)
    assert [saddle.name for saddle in plan.saddles] == [tube.label for tube in layout.tubes]
    for saddle, tube in zip(plan.saddles, layout.tubes, strict=True):
        steps = np.linspace(0, len(tube.course) - 1, 2000)
        course = np.array([np.interp(steps, np.arange(len(tube.course)), tube.course[:, k]) for k in range(2)]).T
        apart = np.linalg.norm(course - np.array(saddle.place), axis=1)
        assert apart.min() < 0.5
        assert saddle.radius >= tube.tube.outer_diameter / 2 + drawn.printing.glue_gap
        below = (*saddle.place, saddle.height - saddle.radius - 0.2)
        assert plate.isInside(below)
        assert not plate.isInside((*saddle.place, saddle.height))


def test_points_are_numbered_beside_their_seats():
    drawn = design()
    plan = plan_base(drawn, lay_out(drawn))
    assert [mark.text for mark in plan.marks] == ["1", "2", "3", "4", "A", "B"]
    for mark, seat in zip(plan.marks, plan.seats, strict=True):
        apart = [math.dist(mark.place, other.place) - other.radius for other in plan.seats]
        assert min(apart) == apart[plan.seats.index(seat)] > 0
    smooth = draw_base(plan.__class__(**{**plan.__dict__, "marks": ()}))
    engraved = smooth[0].val().Volume() - pieces_of(drawn)[0].Volume()
    assert 0 < engraved < 6 * 0.4 * 2.5**2


@pytest.mark.slow
def test_shells_with_feet_are_screwed_down_beside_their_numbers():
    drawn = design(**{"shell.feet": 2, "tube.length": 20.0, "microphone_tube.length": 20.0})
    model = array_model(drawn)
    assert [both for both in interferences(model) if "base" in (both.first, both.second)] == []
    plan = plan_base(drawn, lay_out(drawn))
    (plate,) = pieces_of(drawn)
    assert len(plan.marks) == 6
    for seat in plan.seats[:4]:
        assert len(seat.feet) == 2
        for angle in seat.feet:
            turn = math.radians(angle)
            tip = (seat.place[0] + seat.foot_reach * math.cos(turn), seat.place[1] + seat.foot_reach * math.sin(turn))
            assert not plate.isInside((*tip, seat.bottom - 0.5))  # the screw goes through
            assert plate.isInside((tip[0] + seat.foot_hole / 2 + 0.2, tip[1], seat.bottom - 0.5))


@pytest.mark.slow
def test_a_plate_larger_than_the_printer_comes_in_pieces_that_lock():
    drawn = geometry.prototype("array-2x6").with_values({**PLATE, "printing.rules.build_volume": (80.0, 60.0, 50.0)})
    plan = plan_base(drawn, lay_out(drawn))
    pieces = draw_base(plan)
    assert len(pieces) == len(plan.cuts) + 1 > 1
    for piece in pieces:
        box = piece.val().BoundingBox()
        assert box.xlen <= 80 - 6 + 1e-6
        assert box.ylen <= 60 - 6 + 1e-6
    whole = draw_base(plan.__class__(**{**plan.__dict__, "cuts": ()}))[0].val().Volume()
    lost = whole - sum(piece.val().Volume() for piece in pieces)
    assert 0 < lost < 0.01 * whole  # the gap of the cuts
    for first, second in pairwise(piece.val() for piece in pieces):
        assert first.intersect(second).Volume() == pytest.approx(0, abs=1e-6)
        pulled = second.translate((3.0, 0.0, 0.0))  # dovetails hold against a pull across the cut
        assert first.intersect(pulled).Volume() > 0.1
    for cut in plan.cuts:
        assert all(abs(cut.at - seat.place[0]) > seat.radius for seat in plan.seats)


@pytest.mark.parametrize(
    ("values", "field"),
    [
        ({"base.seat_depth": 3.0}, "base.seat_depth"),
        ({"base.saddle_length": 15.0}, "base.saddle_length"),
        ({"base.label_height": 10.0, "base.border": 3.0, "base.mount": "none"}, "base.label_height"),
        ({"base.screw_diameter": 8.0}, "base.screw_diameter"),
        ({"base.mount": "strap", "base.strap_width": 90.0}, "base.strap_width"),
        ({"printing.rules.build_volume": (30.0, 30.0, 50.0)}, "base.kind"),
        ({"layout.kind": "cylinder", "layout.diameter": 60.0}, "base.kind"),
        ({"microphone.wall_thickness": 4.0, "base.thickness": 0.8}, "base.thickness"),
    ],
)
def test_what_a_plate_has_no_room_for_is_refused_by_name(values, field):
    with refused(Kind.CONFLICT, field):
        drawn = design(**values)
        plan_base(drawn, lay_out(drawn))


def test_strap_and_no_mount_have_no_screw_holes():
    strap = plan_base(design(**{"base.mount": "strap"}), lay_out(design()))
    assert (len(strap.holes), len(strap.slots)) == (0, 2)
    assert plan_base(design(**{"base.mount": "none"}), lay_out(design())).slots == ()


@pytest.mark.slow
def test_the_plate_is_a_part_on_the_plates_of_the_printer_and_can_be_printed(tmp_path):
    drawn = design()
    parts = geometry.build_parts(drawn).only("base")
    assert parts.origin("base") == "printed"
    (plate,) = export_plates(parts, tmp_path, process_of(drawn.printing)).plates
    assert plate.copies == {"base": 1}
    report = print_report(parts, design=drawn)
    assert [found.rule for found in report.findings if found.verdict == "fail"] == []
    assert next(found.value for found in report.findings if found.rule == "islands") == 0


@pytest.mark.slow
def test_a_design_without_a_base_has_no_plate():
    assert not any(name.startswith("base") for name in geometry.build_parts(geometry.prototype("line-4")))
