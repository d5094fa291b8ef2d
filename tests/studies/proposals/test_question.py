"""A designer's question: what it may say, and the layouts and designs that may answer it."""

from functools import partial
from pathlib import Path

import pytest
from refusals import check_messages, refused

import studies
from geometry import Kind
from geometry.layout import array_size
from geometry.stock import catalogue
from studies.proposals.candidates import Candidates
from studies.proposals.designer_question import PLACES, question
from studies.proposals.grids import grids

#: What is asked -> kind, field and value of the refusal.
REFUSED = (
    ({"place": "moon"}, Kind.UNKNOWN, "place", "moon"),
    ({"name": "../up"}, Kind.OUT_OF_RANGE, "name", "../up"),
    ({"choose": 4}, Kind.OUT_OF_RANGE, "choose", 4),
    ({"points": 1}, Kind.OUT_OF_RANGE, "points", 1),
    ({"points": "many"}, Kind.WRONG_TYPE, "points", "many"),
    ({"points": "most"}, Kind.MISSING, "points", "most"),
    ({"points": 15, "rows": 4, "columns": 4}, Kind.CONFLICT, "points", 15),
    ({"size": "30"}, Kind.WRONG_TYPE, "size", "30"),
    ({"size": "1x30"}, Kind.OUT_OF_RANGE, "size", 1.0),
    ({"pitch": 2.5}, Kind.OUT_OF_RANGE, "pitch", 2.5),
    ({"around": 20}, Kind.OUT_OF_RANGE, "around", 20),
    ({"place": "flat", "around": 160}, Kind.CONFLICT, "around", 160),
    ({"around": 160, "microphones": 3}, Kind.CONFLICT, "microphones", 3),
    ({"points": 3, "microphones": 16}, Kind.CONFLICT, "microphones", 16),
    ({"place": "hand", "points": 2}, Kind.CONFLICT, "microphones", 3),
    ({"tubes_below": "deep"}, Kind.WRONG_TYPE, "tubes_below", "deep"),
    ({"printer": "laser"}, Kind.UNKNOWN, "printer", "laser"),
    ({"target": "elbow 1 N"}, Kind.WRONG_TYPE, "target", "elbow 1 N"),
    ({"budget": 0}, Kind.OUT_OF_RANGE, "budget", 0),
)


@pytest.mark.parametrize(("asked", "kind", "field", "value"), REFUSED, ids=str)
def test_a_question_that_cannot_be_is_refused_at_once_and_nothing_is_written(asked, kind, field, value, tmp_path):
    with refused(kind, field, value):
        studies.new_design(**{"name": "mine", "out": tmp_path / "mine.toml"} | asked)
    assert list(tmp_path.iterdir()) == []


def test_messages(tmp_path):
    out = {"name": "mine", "out": tmp_path / "mine.toml"}
    calls = {str(asked): partial(studies.new_design, **out | asked) for asked, *_ in REFUSED}
    check_messages(Path(__file__).parent / "messages.txt", calls)


def test_a_question_has_the_usual_values_of_its_place():
    for name, place in PLACES.items():
        asked = question(place=name)
        assert (asked.points, asked.microphones, asked.size) == (place.points, place.microphones, place.size)
        assert asked.printer == "sla-resin"
    assert question(around=160).place == "wrist"
    assert question(rows=3, columns=5).points == 15
    assert question(size="20 mm x 30mm").size == (30.0, 20.0)
    assert question(points="most", size=(30, 30)).points is None
    asked = question(target="hand 2 N", tubes_below="5mm", budget=20)
    assert (asked.target.force, asked.target.contact_radius, asked.target.budget) == (2.0, 25.0, 20.0)
    assert asked.tubes_below == 5.0


def test_a_ring_is_the_first_layout_around_a_wrist():
    ring = grids(question(around=160, points=10), 10)[0]
    assert (ring.kind, ring.columns, ring.rows, ring.side) == ("cylinder", 10, 1, "front")
    assert all(grid.rows > 1 for grid in grids(question(around=160, points=12, pitch=15), 12))


def test_a_grid_within_a_size_has_its_shape():
    square = grids(question(size="30x30", points=16), 16)
    assert (square[0].columns, square[0].rows, square[0].side) == (4, 4, "below")
    long = grids(question(size="60x20", points=12), 12)
    assert (long[0].columns, long[0].rows) == (6, 2)
    assert all(grid.columns == 5 for grid in grids(question(points=15, columns=5), 15))
    assert {grid.rows for grid in grids(question(points=15, rows=3), 15)} == {3}


def test_lines_between_several_microphones_take_whole_rows():
    grid = grids(question(size="400x400", points=36, microphones=4), 36)[0]
    assert [line["points"] for line in grid.lines(["A", "B", "C", "D"])] == [12, 12, 12]


@pytest.mark.parametrize(
    "asked",
    [{"size": "30x30", "points": 16}, {"around": 160, "points": 10}, {"points": 12, "pitch": 20.0}, {"place": "hand"},
     {"size": "300x200", "points": 24, "microphones": 3}],
    ids=str,
)  # fmt: skip
def test_drawn_designs_fit_the_question_and_can_be_bought(asked):
    given = question(**asked)
    drawn = Candidates(given, "mine", grids(given, given.points)[0]).drawn(40)
    assert len(drawn) > 3
    for design, _ in drawn:
        assert design.point_count == given.points
        assert len(design.microphones) == given.microphones
        assert design.printing.process == "sla-resin"
        assert design.target.size == given.size
    design = drawn[0][0]
    assert catalogue().fit(design).bought
    if given.size is not None:
        length, width, _ = array_size(design)
        assert max(length, width) <= given.size[0] + 1e-2
        assert min(length, width) <= given.size[1] + 1e-2


def test_designs_are_drawn_from_a_fixed_seed():
    given = question(size="30x30", points=16)
    grid = grids(given, 16)[0]
    one, other = (Candidates(given, "mine", grid).drawn(10) for _ in range(2))
    assert [design for design, _ in one] == [design for design, _ in other]


def test_room_below_the_shells_limits_the_height():
    deep, flat = (question(size="30x30", points=16, tubes_below=room) for room in (20, 4.5))
    heights = [
        [array_size(design)[2] for design, _ in Candidates(each, "mine", grids(each, 16)[0]).drawn(80)]
        for each in (deep, flat)
    ]
    assert max(heights[0]) > max(heights[1], default=0.0)


def test_another_printer_is_used_only_if_it_is_asked_for():
    given = question(size="80x80", points=16, printer="fdm")
    drawn = Candidates(given, "mine", grids(given, 16)[0]).drawn(60)
    assert drawn
    for design, _ in drawn:
        assert design.printing.process == "fdm"
        assert min(tube.inner_diameter for tube in design.tubes) >= 0.8
