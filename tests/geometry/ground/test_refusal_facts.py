"""A refusal is data: its sentence is made of its facts, and a front end can write the fields in its own way."""

from __future__ import annotations

import pickle
from pathlib import Path

import numpy as np
import pytest
from refusals import refused

from geometry.ground.missing_packages import MissingLibrary
from geometry.ground.refusal import Field, Kind, Refusal, quoted
from geometry.schema.field_errors import DesignError


def test_the_sentence_has_the_file_the_field_the_value_and_what_is_allowed() -> None:
    found = Refusal(
        kind=Kind.OUT_OF_RANGE,
        file=Path("mine.toml"),
        field="tube.length",
        value=np.float64(0.1),
        unit="mm",
        allowed="above 1 mm",
        remedy="choose a longer one",
    )
    assert str(found) == "mine.toml: tube.length = 0.1 mm must be above 1 mm; choose a longer one"
    assert (found.file, found.field, found.value) == ("mine.toml", "tube.length", 0.1)


@pytest.mark.parametrize(
    ("found", "sentence"),
    [
        (Refusal(kind=Kind.MISSING, file="a.nc"), "a.nc: no such file"),
        (Refusal(kind=Kind.MISSING, field="rate", allowed="a number"), "rate is missing; it must be a number"),
        (
            Refusal(kind=Kind.OUT_OF_RANGE, field="place", value="moon", allowed=("wrist", "palm")),
            "place = 'moon' must be one of: wrist, palm",
        ),
        (Refusal(kind=Kind.UNKNOWN, field="metric", value="x"), "metric = 'x' is not known"),
        (Refusal("has no samples", kind=Kind.UNSUITABLE, file="a.wav"), "a.wav: has no samples"),
    ],
)
def test_what_is_usual_needs_no_words(found: Refusal, sentence: str) -> None:
    assert str(found) == sentence


def test_a_front_end_writes_arguments_in_its_own_way_and_leaves_files_alone() -> None:
    options = {"full_scale": "--full-scale", "altitude": "--altitude"}
    found = Refusal("is missing", kind=Kind.MISSING, field="full_scale", remedy=("see ", Field("altitude")))
    assert found.sentence(options) == "--full-scale is missing; see --altitude"
    assert str(found) == "full_scale is missing; see altitude"
    # A file called as an option is, and a field of a file that is called as one: neither is rewritten.
    assert Refusal(kind=Kind.MISSING, file="altitude.csv").sentence(options) == "altitude.csv: no such file"
    of_file = Refusal("is missing", kind=Kind.MISSING, file="a.toml", field="altitude")
    assert of_file.sentence(options) == "a.toml: altitude is missing"
    # An argument that names the file is one of the command line, whatever the file is called.
    argument = Refusal("exists", kind=Kind.EXISTS, file="altitude", field=Field("altitude"))
    assert argument.sentence(options) == "altitude: --altitude exists"
    assert pickle.loads(pickle.dumps(argument)).sentence(options) == argument.sentence(options)


def test_a_refusal_becomes_one_of_another_class_with_the_file_that_it_is_of() -> None:
    class OfAFile(Refusal): ...

    found = OfAFile.of(Refusal(kind=Kind.OUT_OF_RANGE, field="a", value=1, allowed="2"), file="b.toml")
    assert type(found) is OfAFile
    assert str(found) == "b.toml: a = 1 must be 2"


def test_it_travels_between_processes_with_its_facts() -> None:
    found = pickle.loads(pickle.dumps(MissingLibrary("a library is missing", kind=Kind.NOT_INSTALLED, field="cad")))
    assert (type(found), found.kind, found.field) == (MissingLibrary, Kind.NOT_INSTALLED, "cad")
    assert found.value is Refusal.NOT_GIVEN
    several = pickle.loads(
        pickle.dumps(DesignError("a", kind=Kind.CONFLICT, others=[Refusal("b", kind=Kind.OUT_OF_RANGE, field="c")]))
    )
    assert [(str(each), each.field) for each in several.problems] == [("a", ""), ("c b", "c")]


@pytest.mark.parametrize(
    ("value", "text"), [(True, "true"), (None, "nothing"), (1.0, "1"), ("a", "'a'"), (Path("a"), "'a'"), ((), "()")]
)
def test_values_are_quoted_as_files_show_them(value: object, text: str) -> None:
    assert quoted(value) == text
    assert len(quoted([value] * 100)) <= 80


def test_a_refusal_of_another_kind_fails_the_test() -> None:
    with pytest.raises(AssertionError), refused(Kind.MISSING, "a"):
        raise Refusal(kind=Kind.UNKNOWN, field="a")
