"""Constraints of a study: what is computed with must be numbers, which is found before anything is computed."""

import pytest
from refusals import refused

import geometry
from geometry import Kind
from studies.study.constraints import parse_constraint

BASE = geometry.prototype("array-2x6")


@pytest.mark.parametrize(
    "text",
    [
        "'a' * 1000000000 == 'b'",
        "1000000000 * 'a' == 'b'",
        "'a' * 9999 * 9999 * 9999 > 'b'",
        "name * 1000000000 == name",
        "('a' * 99999) + ('a' * 99999) == name",
        "name + name == 'x'",
        "max(name, 'a') * 2 == 'x'",
        "abs(name) > 1",
        "-name == 'x'",
        "sqrt('4') == 2",
        "tube.length < 'a'",
    ],
)
def test_a_text_that_is_computed_with_is_refused_when_the_study_is_read(text: str) -> None:
    with refused(Kind.WRONG_TYPE, "constraints", text):
        parse_constraint(text, BASE)


@pytest.mark.parametrize("text", ["(" * 240 + "1" + ")" * 240 + " < 2", "((" * 100, "1 < " + "[" * 200])
def test_deep_parentheses_are_refused(text: str) -> None:
    with refused(Kind.WRONG_TYPE, "constraints", text):
        parse_constraint(text, BASE)


def test_a_text_that_becomes_one_only_in_a_case_is_refused_there() -> None:
    constraint = parse_constraint("tube.length * 1000000000 > 1", BASE)
    with refused(Kind.NO_RESULT, "constraints", constraint.text):
        constraint.holds({"tube.length": "a"})


@pytest.mark.parametrize("text", ["name == 'array-2x6'", "'a' < name", "min(tube.length, 3) <= 3", "not 1 > 2"])
def test_conditions_on_numbers_and_texts_hold(text: str) -> None:
    constraint = parse_constraint(text, BASE)
    values = {"name": "array-2x6", "tube.length": 20.0}
    assert constraint.holds({name: values[name] for name in constraint.names})
