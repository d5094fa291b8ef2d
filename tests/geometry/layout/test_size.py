"""The box around an array, against the solids of its assembly."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import assume, given, settings, strategies as st

import geometry
from geometry.assembly.model import array_model, assembly_of
from geometry.layout.arrangement import lay_out, point_axes
from geometry.layout.size import array_size
from geometry.layout.straight_rows import is_wide_apart, straight_size


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "values"),
    [
        ("fingertip-3x4", {}),
        ("glove", {}),
        ("array-2x6", {"shell.feet": 3, "lines.0.points": 4}),
        ("array-2x6", {"resonator.wall_thickness": 2.5, "membrane.stretch": 1.8, "lines.0.points": 4}),
        ("array-2x6", {"membrane.shape": "boss", "membrane.boss_diameter": 2.0, "membrane.boss_height": 2.0}),
        ("array-2x6", {"layout": {"kind": "cylinder", "columns": 6, "diameter": 50.0}}),
    ],
)
def test_the_size_is_that_of_the_assembled_solids(name, values):
    design = geometry.prototype(name).with_values(values)
    model = array_model(design)
    # The heads of boards are not part of the size; the rest of a board lies in its housing.
    housed = replace(model, placed=tuple(part for part in model.placed if part.kind != "board"))
    box = assembly_of(housed).toCompound().BoundingBox(1e-3)
    # Solids that lie askew are measured through their facets.
    assert array_size(design) == pytest.approx((box.xlen, box.ylen, box.zlen), abs=4e-3)


def test_tubes_that_are_drawn_schematically_do_not_count():
    design = geometry.prototype("line-4")
    layout = lay_out(design)
    assert any(tube.schematic for tube in layout.tubes)
    sizes = []
    for schematic in (True, False):
        moved = [replace(tube, course=tube.course + 100.0) if tube.schematic is schematic else tube
                 for tube in layout.tubes]  # fmt: skip
        sizes.append(array_size(design, replace(layout, tubes=tuple(moved))))
    assert sizes[0] == array_size(design, layout) == array_size(design)
    assert sizes[1][2] > 100


def test_wider_housings_at_both_ends_make_it_longer_by_that_much():
    design = geometry.prototype("fingertip-3x4")
    small, wide = array_size(design), array_size(design.with_values({"microphone.board_gap": 0.3}))
    assert wide[0] - small[0] == pytest.approx(2 * 0.2)


@settings(max_examples=60, derandomize=True, deadline=None)
@given(
    points=st.integers(1, 9),
    columns=st.integers(1, 5),
    lengths=st.tuples(st.floats(6, 14), st.floats(6, 12)),
    walls=st.tuples(st.floats(0.7, 2.6), st.floats(0.6, 3)),
    board=st.tuples(st.floats(3.5, 9), st.floats(2.7, 5)),
    membrane=st.sampled_from(
        [{}, {"stretch": 1.5}, {"shape": "boss", "boss_diameter": 2.0, "boss_height": 2.0}],
    ),
)
def test_rows_of_straight_tubes_have_their_size_from_lengths_alone(points, columns, lengths, walls, board, membrane):
    values = {"lines.0.points": points, "layout.columns": columns, "resonator.wall_thickness": walls[0]}
    values |= {"tube.length": lengths[0], "microphone_tube.length": lengths[1]}
    values |= {"microphone.wall_thickness": walls[1], "membrane.rim_width": 0.6 * walls[0]}
    values |= {"microphone.board_length": board[0], "microphone.board_width": board[1]}
    values |= {f"membrane.{name}": value for name, value in membrane.items()}
    try:
        design = geometry.prototype("array-2x6").with_values(values)
    except geometry.DesignError:
        assume(False)
    assume(is_wide_apart(design))
    assert straight_size(design) == pytest.approx(array_size(design, lay_out(design)), abs=2e-9)


def test_kinds_of_points_reach_as_far_as_the_tallest():
    kinds = {"flat": {}, "deep": {"cavity_height": 4.0}}
    design = geometry.prototype("array-2x6").with_values(
        {"point_kinds": kinds, "lines.0.pattern": {"points": ["flat", "deep"] * 6}}
    )
    assert is_wide_apart(design)
    assert straight_size(design) == pytest.approx(array_size(design, lay_out(design)), abs=2e-9)


@pytest.mark.parametrize("name", ["array-2x6", "fingertip-3x4", "glove", "large-area-64", "line-4"])
def test_the_axes_of_points_are_those_of_the_layout(name):
    design = geometry.prototype(name)
    placed = np.array([point.position for point in lay_out(design).points])
    assert point_axes(design) == pytest.approx(placed, abs=1e-9)
