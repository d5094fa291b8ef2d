"""The box around an array, against the solids of its assembly."""

from dataclasses import replace

import pytest

import geometry
from geometry.layout.arrangement import lay_out
from geometry.layout.size import array_size


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
    box = geometry.build_assembly(design).toCompound().BoundingBox(1e-3)
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
