"""Values of a design by dotted name: all of them, declared, and in the order of its file."""

from __future__ import annotations

import random

import pytest

import geometry
from geometry.design.field_values import declared_at, field_values, place_in_file
from geometry.schema.declared_fields import field_named

ARRAY = geometry.prototype("array-2x6")
PLACES = {
    "layout": {"kind": "places", "places": [{"x": 18.0 * number, "y": 0.0} for number in range(12)]},
    "materials.mine": ARRAY.material("silicone-shore-a-30").model_dump(),
}


@pytest.mark.parametrize("name", ["array-2x6", "glove", "line-2", "places"])
def test_every_value_is_that_of_its_name_and_has_a_declaration(name: str) -> None:
    design = ARRAY.with_values(PLACES) if name == "places" else geometry.prototype(name)
    values = field_values(design)
    assert design.with_values(values) == design
    for field in values:
        assert declared_at(field) == field_named(type(design), field)


def test_names_are_sorted_as_a_file_lists_them() -> None:
    names = list(field_values(ARRAY.with_values(PLACES)))
    assert "layout.places.11.x" in names
    shuffled = random.Random(0).sample(names, len(names))
    assert sorted(shuffled, key=place_in_file) == names
