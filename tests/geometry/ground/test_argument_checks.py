import math

import numpy as np
import pytest

from geometry.ground.argument_checks import check_choice, check_given, check_range, check_shape
from geometry.ground.refusal import Kind, Refusal


@pytest.mark.parametrize(
    ("value", "options", "allowed"),
    [
        (3.5, {"low": 0, "high": 3, "unit": "mm"}, "between 0 and 3 mm"),
        (math.nan, {"low": 0}, "at least 0"),
        (0, {"low": 0, "excluded": "low"}, "above 0"),
        (1, {"low": 0, "high": 1, "excluded": "both"}, "above 0 and below 1"),
        (1, {"low": 0, "high": 1, "excluded": "high"}, "at least 0 and below 1"),
        (2.0, {"low": 1, "high": 4, "whole": True}, "a whole number between 1 and 4"),
        (True, {"low": 1, "whole": True}, "a whole number at least 1"),
        (9, {"high": 8, "why": "the number of points"}, "at most 8, the number of points"),
        (9, {"high": 8, "allowed": "few"}, "few"),
        (0, {"low": 1, "high": 2**31}, "between 1 and 2147483648"),
    ],
)
def test_a_number_outside_its_range_is_rejected_with_the_range(value, options, allowed):
    with pytest.raises(Refusal) as caught:
        check_range("count", value, **options)
    assert caught.value.kind is Kind.OUT_OF_RANGE
    assert (caught.value.field, caught.value.allowed) == ("count", allowed)
    assert caught.value.value is value


def test_numbers_choices_shapes_and_lists_that_fit_pass():
    check_range("count", 3, 3, 3, whole=True)
    check_range("loss", 0.5, 0, 1, excluded="both")
    check_choice("law", "prony", ("prony", "elastic"))
    check_shape("h", np.zeros((2, 5)), (2, "n"))
    check_given("names", ["one"])


def test_choices_shapes_and_empty_lists_are_rejected_with_their_own_kinds():
    class Other(Refusal):
        pass

    with pytest.raises(Other) as caught:
        check_choice("law", "none", ["prony", "elastic"], error=Other, kind=Kind.UNKNOWN)
    assert (caught.value.kind, caught.value.allowed) == (Kind.UNKNOWN, ("prony", "elastic"))
    for wrong in (np.zeros(2), np.zeros((3, 5))):
        with pytest.raises(Refusal, match=r"it must be \(2, n\), one row for each point") as caught:
            check_shape("h", wrong, (2, "n"), "one row for each point")
        assert caught.value.kind is Kind.WRONG_TYPE
    with pytest.raises(Refusal) as caught:
        check_given("names", [], "a batch needs one")
    assert caught.value.kind is Kind.MISSING
