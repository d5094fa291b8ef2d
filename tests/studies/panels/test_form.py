"""The form of a design has every field that it has, with the words, units and ranges of its model."""

from __future__ import annotations

import json

import pytest

from geometry import DesignError, load_design, prototype
from geometry.design.array_design import validated
from geometry.design.field_values import declared_at, field_values
from geometry.schema.declared_fields import field_named
from studies.panels.form import addable_tables, form_of, removable_tables, stated_values
from studies.panels.form_hints import fields_without_effect, values_in_use

ARRAY = prototype("array-2x6")


@pytest.mark.parametrize("name", ["array-2x6", "glove", "line-2"])
def test_every_field_can_be_set_to_what_it_is(name: str) -> None:
    design = prototype(name)
    form = form_of(design)
    assert json.loads(json.dumps(form)) == form
    assert len({entry["name"] for entry in form}) == len(form)
    assert {entry["name"]: entry["value"] for entry in form} == field_values(design)
    assert design.with_values({entry["name"]: entry["value"] for entry in form}) == design


def test_words_units_and_ranges_are_those_of_the_model() -> None:
    form = {entry["name"]: entry for entry in form_of(ARRAY)}
    length = form["tube.length"]
    field = field_named(type(ARRAY), "tube.length")
    assert field is not None
    assert (length["unit"], length["allowed"], length["description"]) == ("mm", field.allowed, field.description)
    assert (length["lowest"], length["highest"], length["kind"], length["group"]) == (0.5, 1000.0, "number", "tube")
    assert form["lines.0.points"]["kind"] == "count"
    assert form["membrane.shape"]["choices"] == ["flat", "rim", "boss"]
    assert "silicone-shore-a-30" in form["membrane.material"]["suggestions"]
    assert form["resonator.port_height"]["optional"]
    assert not form["tube.length"]["optional"]


@pytest.mark.parametrize(("name", "beyond"), [("tube.length", 1000.5), ("lines.0.points", 0), ("air.humidity", 1.01)])
def test_the_range_of_a_field_is_the_one_that_refuses(name: str, beyond: float) -> None:
    entry = next(each for each in form_of(ARRAY) if each["name"] == name)
    assert not (entry["lowest"] <= beyond <= entry["highest"])
    with pytest.raises(DesignError):
        ARRAY.with_values({name: beyond})


def test_kinds_patterns_and_materials_of_a_design_have_fields() -> None:
    graded = ARRAY.with_values(
        {
            "point_kinds": {"high": {"cavity_height": 3.0}},
            "lines": [{"between": ["A", "B"], "points": 2, "pattern": {"points": ["high", "high"]}}],
            "layout.columns": 2,
        }
    )
    form = {entry["name"]: entry for entry in form_of(graded)}
    assert form["point_kinds.high.cavity_height"]["value"] == 3.0
    assert form["lines.0.pattern.points"]["value"] == ["high", "high"]
    assert form["lines.0.pattern.points"]["kind"] == "list"


def test_a_design_is_made_again_of_what_it_states_and_what_follows_goes_on_to_follow() -> None:
    following = validated({k: v for k, v in stated_values(ARRAY).items() if k != "microphone_tube"}, "test")
    assert validated(json.loads(json.dumps(stated_values(ARRAY))), "test") == ARRAY
    assert "microphone_tube" not in stated_values(following)
    again = validated(stated_values(following), "test").with_values({"tube.length": 20.0})
    assert again.microphone_tube.length == 20.0


@pytest.mark.parametrize("name", ["array-2x6", "glove", "line-2"])
def test_every_table_that_can_be_added_leaves_a_valid_design_with_its_fields(name: str) -> None:
    design = prototype(name)
    for table, values in addable_tables(design).items():
        more = design.with_values({table: json.loads(json.dumps(values))})
        assert any(entry["group"] == table for entry in form_of(more)), table
        assert table not in addable_tables(more)
        if table in removable_tables(more):
            assert more.with_values({table: None}) == design


def test_a_pattern_can_be_added_when_there_is_a_kind() -> None:
    assert "lines.0.pattern" not in addable_tables(ARRAY)
    kinds = ARRAY.with_values({"point_kinds.kind_1": {"cavity_height": 3.0}})
    pattern = addable_tables(kinds)["lines.0.pattern"]
    assert pattern == {"points": ["kind_1"] * ARRAY.point_count}
    assert removable_tables(kinds.with_values({"lines.0.pattern": pattern})) == ["lines.0.pattern"]
    assert "point_kinds.kind_2" in addable_tables(kinds)


@pytest.mark.parametrize("name", ["array-2x6", "glove", "large-area-64"])
def test_hidden_fields_are_at_their_defaults_and_defaults_in_use_change_nothing_that_is_laid_out(name: str) -> None:
    design = prototype(name)
    values, hidden = field_values(design), fields_without_effect(design)
    assert hidden
    for each in hidden:
        assert values[each] == declared_at(each).default, each
    used = values_in_use(design)
    assert all(values[each] is None for each in used)
    assert used["resonator.port_height"] == design.resonator.cavity_height / 2
    assert used["microphone.board_length"] == pytest.approx(design.microphone.board_size[0], rel=1e-5)


def test_a_field_counts_once_its_shape_is_chosen() -> None:
    box = ARRAY.with_values({"resonator.shape": "box", "resonator.box_length": 3.0})
    assert "resonator.dome_depth" in fields_without_effect(box)
    assert "resonator.box_width" not in fields_without_effect(box)
    assert values_in_use(box)["resonator.box_width"] == 3.0


def test_places_on_a_body_are_no_fields_of_the_form() -> None:
    design = load_design("docs/examples/robot/fingertip.toml")
    assert design.layout.frozen is not None
    names = [entry["name"] for entry in form_of(design)]
    assert "layout.kind" in names
    assert not [name for name in names if "frozen" in name or name.startswith("surface.")]
