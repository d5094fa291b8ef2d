"""A microphone tube that nobody stated is as the tube is, through changes and files."""

import re

import pytest
from refusals import refused

import geometry
from geometry import Kind
from geometry.design.design_file import prototype_text, read_design, write_design


@pytest.fixture
def following():
    text = re.sub(r"\[microphone_tube\]\n.*?\n\n", "", prototype_text("array-2x6"), flags=re.DOTALL)
    return read_design(text)


def test_it_follows_the_tube_that_is_stated_and_changed(following):
    assert following.microphone_tube == following.tube
    wider = following.with_values({"tube.spring_outer_diameter": 0.7, "tube.sheath_wall": 0.2})
    assert wider.microphone_tube == wider.tube
    assert wider.tube.inner_diameter == pytest.approx(0.54)
    assert wider.with_values({"name": "other"}).with_values({"tube.length": 14.0}).microphone_tube.length == 14.0


def test_one_that_is_stated_stays_as_it_is(following):
    for design in (geometry.prototype("array-2x6"), following.with_values({"microphone_tube.length": 20.0})):
        stated = design.microphone_tube
        assert design.with_values({"tube.length": 14.0}).microphone_tube == stated
    assert stated.length == 20.0


def test_it_still_follows_after_it_was_written_and_read(following):
    again = read_design(write_design(following.completed()))
    assert again == following.completed()
    assert again.with_values({"tube.length": 14.0}).microphone_tube.length == 14.0
    stated = geometry.prototype("array-2x6")
    assert "[microphone_tube]" in write_design(stated)
    assert read_design(write_design(stated)) == stated


def test_a_wrong_tube_is_said_once(following):
    with refused(Kind.OUT_OF_RANGE, "tube.length", -1.0, error=geometry.DesignError) as found:
        following.with_values({"tube.length": -1.0})
    assert len(found.value.problems) == 1
