"""Designs that cannot be built are refused with a remedy; parts that are surely wide apart are not measured."""

import re
import sys
from functools import partial
from pathlib import Path

import pytest
from hypothesis import assume, given, settings, strategies as st
from refusals import check_messages, refused

import geometry
from geometry import Kind
from geometry.layout.arrangement import lay_out
from geometry.layout.overlaps import OverlapError, overlaps, refuse_overlaps, schematic_notes
from geometry.layout.remedies import fix_for, refuse_unbuildable
from geometry.layout.straight_rows import is_wide_apart

MESSAGES = Path(__file__).with_name("messages_of_overlaps.txt")
CLOSE = {"lines.0.points": 9, "resonator.cavity_diameter": 5.0, "layout.columns": 3, "layout.pitch": 9.0}


def test_tubes_that_pass_through_shells_are_refused_with_the_length_that_mends_it():
    design = geometry.prototype("array-2x6").with_values(CLOSE)
    with refused(Kind.CONFLICT, file="array-2x6", error=OverlapError) as found:
        refuse_unbuildable(design, unless="nothing else")
    assert len(found.value.problems) == 8
    assert found.value.remedy[-2:] == ("; ", "nothing else")
    check_messages(MESSAGES, {"overlap": partial(refuse_unbuildable, design, unless="nothing else")})
    walls = {"resonator.wall_thickness": 1.9, "membrane.rim_width": 1.5}
    refuse_overlaps(design.with_values({"tube.length": 4.0, **walls}))


@pytest.mark.parametrize(
    ("values", "field"),
    [
        ({"layout": {"kind": "cylinder", "columns": 6, "diameter": 9.0}, "lines.0.points": 4}, "layout.diameter"),
        ({"microphone_tube.length": 3.1}, "microphone_tube.length"),
        ({"layout.pitch": 10.5, "tube.length": 60.0}, "tube.length"),
    ],
)
def test_the_fix_of_an_overlap_can_be_built(values, field):
    design = geometry.prototype("array-2x6").with_values(values)
    found = re.fullmatch(r"set (\S+) = ([\d.]+).*", fix_for(design))
    assert found is not None
    assert found[1] == field
    refuse_overlaps(design.with_values({field: float(found[2])}))


@pytest.mark.parametrize("pitch", [8.9, 17.6])
def test_the_pitch_that_a_design_is_offered_can_be_built(pitch):
    design = geometry.prototype("array-2x6")
    with refused(Kind.CONFLICT, "layout.pitch", pitch, error=geometry.DesignError) as found:
        design.with_values({**CLOSE, "layout.pitch": pitch})
    offered = re.findall(r"([\d.]+) mm: the tubes then lie straight", found.value.remedy)
    assert len(offered) == 1
    for each in (float(offered[0]), None):
        refuse_overlaps(design.with_values({**CLOSE, "layout.pitch": each}))


def test_what_is_drawn_schematically_is_a_note_and_no_overlap():
    design = geometry.prototype("line-4")
    layout = lay_out(design)
    assert len(schematic_notes(design, layout)) == 5
    assert overlaps(design, layout) == ()


def test_seats_of_boards_and_feet_get_in_the_way_too():
    long = geometry.prototype("array-2x6").with_values({"microphone.board_length": 30.0})
    assert "shell 1 overlaps microphone A" in overlaps(long, lay_out(long))[0]
    fingers = {"layout": {"kind": "hand", "columns": 2, "palm": 40.0, "spread": 18.0}, "lines.0.points": 4}
    feet = {"shell.feet": 2, "shell.foot_length": 4.0}
    plain, footed = (geometry.prototype("array-2x6").with_values({**fingers, **each}) for each in ({}, feet))
    assert overlaps(plain, lay_out(plain)) == ()
    assert "shell 1 overlaps shell 4" in overlaps(footed, lay_out(footed))[0]


def test_ports_that_leave_no_wall_between_them_are_found_without_drawing_the_shell():
    design = geometry.prototype("fingertip-3x4").with_values({"tube.length": 5.2})
    assert "ports of shell 2 at 0 and 33.9 deg overlap" in overlaps(design, lay_out(design))


@settings(max_examples=25, derandomize=True, deadline=None)
@given(
    points=st.integers(1, 9),
    columns=st.integers(1, 4),
    lengths=st.tuples(st.floats(4.1, 12), st.floats(4.1, 9)),
    wall=st.floats(0.7, 2),
    feet=st.sampled_from([0, 0, 3]),
)
def test_what_is_surely_wide_apart_has_no_overlap(points, columns, lengths, wall, feet):
    values = {"lines.0.points": points, "layout.columns": columns, "resonator.wall_thickness": wall}
    values |= {"tube.length": lengths[0], "microphone_tube.length": lengths[1], "membrane.rim_width": 0.5 * wall}
    try:
        design = geometry.prototype("array-2x6").with_values({**values, "shell.feet": feet, "shell.foot_length": 3.5})
    except geometry.DesignError:
        assume(False)
    assume(is_wide_apart(design))
    assert overlaps(design, lay_out(design)) == ()


def test_the_usual_arrays_are_not_measured_at_all(monkeypatch):
    monkeypatch.setattr(sys.modules[refuse_overlaps.__module__], "overlaps", None)
    for name in ("array-2x6", "line-2"):
        refuse_overlaps(geometry.prototype(name))
