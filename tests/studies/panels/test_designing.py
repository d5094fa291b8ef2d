"""A design that is changed: steps are taken back and again, and a refused value has its mend beside it."""

from __future__ import annotations

from typing import Any

import pytest

from geometry import DesignError, prototype
from studies.panels.designing import MOST_STEPS, DesignState, design_key, refusal_of

ARRAY = prototype("array-2x6")


def lengths(state: DesignState) -> float:
    return state.design.tube.length


def test_steps_are_taken_back_and_again() -> None:
    state = DesignState(ARRAY)
    for length in (13.0, 14.0):
        state.set_values({"tube.length": length})
    state.undo()
    assert (lengths(state), state.can_undo, state.can_redo) == (13.0, True, True)
    state.undo()
    assert state.design == ARRAY
    state.undo()
    state.redo()
    state.redo()
    assert lengths(state) == 14.0
    state.redo()
    state.undo()
    state.set_values({"tube.length": 15.0})
    assert not state.can_redo


def test_all_values_of_one_drag_are_one_step() -> None:
    state = DesignState(ARRAY)
    for length in (13.0, 13.5, 14.0):
        state.set_values({"tube.length": length}, gesture="a")
    state.set_values({"tube.length": 15.0}, gesture="b")
    state.undo()
    assert lengths(state) == 14.0
    state.undo()
    assert state.design == ARRAY


def test_a_refused_value_changes_nothing() -> None:
    state = DesignState(ARRAY)
    with pytest.raises(DesignError):
        state.set_values({"tube.length": 0.1})
    assert (state.design, state.revision, state.can_undo) == (ARRAY, 0, False)


def test_unsaved_is_what_differs_from_the_file() -> None:
    state = DesignState(ARRAY)
    state.set_values({"tube.length": 14.0})
    assert state.unsaved
    state.set_values({"tube.length": 12.5})
    assert not state.unsaved
    state.set_values({"tube.length": 14.0})
    state.mark_saved()
    assert not state.unsaved
    state.undo()
    assert state.unsaved


def test_the_number_of_steps_is_bounded() -> None:
    state = DesignState(ARRAY)
    for step in range(MOST_STEPS + 10):
        state.replace(ARRAY if step % 2 else ARRAY.with_values({"tube.length": 14.0}))
    for _ in range(MOST_STEPS):
        assert state.can_undo
        state.undo()
    assert not state.can_undo


@pytest.mark.parametrize(
    ("name", "value", "mend"),
    [
        ("air.humidity", -0.5, 0),
        ("tube.length", 5000.0, 1000.0),
        ("lines.0.points", 0, 1),
        ("tube.length", "long", None),
        ("nowhere.at_all", 1.0, None),
        ("tube", 1.0, None),
    ],
)
def test_the_nearest_value_that_is_allowed_is_offered(name: str, value: Any, mend: float | None) -> None:
    with pytest.raises(DesignError) as error:
        ARRAY.with_values({name: value})
    refused = refusal_of(ARRAY, name, value, error.value)
    assert refused.message == str(error.value)
    assert refused.mend == mend


def test_the_mend_of_a_rule_between_fields_is_valid_and_near_the_bound() -> None:
    with pytest.raises(DesignError, match=r"rim_width|wall_thickness") as error:
        ARRAY.with_values({"resonator.wall_thickness": 0.5})
    mend = refusal_of(ARRAY, "resonator.wall_thickness", 0.5, error.value).mend
    assert mend is not None
    assert ARRAY.with_values({"resonator.wall_thickness": mend})
    with pytest.raises(DesignError):
        ARRAY.with_values({"resonator.wall_thickness": 0.99 * mend})


def test_designs_have_one_key_where_they_are_equal() -> None:
    assert design_key(ARRAY) == design_key(prototype("array-2x6"))
    assert design_key(ARRAY) != design_key(ARRAY.with_values({"tube.length": 12.6}))


def test_a_value_that_is_there_already_is_no_step() -> None:
    state = DesignState(ARRAY)
    state.set_values({"tube.length": ARRAY.tube.length})
    assert (state.can_undo, state.revision) == (False, 0)
