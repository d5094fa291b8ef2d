"""Studies made in Python: the same fields as a file's, written and read back."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from refusals import refused

import geometry
import studies
from geometry.ground.refusal import Kind
from studies.study.cases import cases_of
from studies.study.parameter import StudyError
from studies.study.study import read_study

GIVEN: dict[str, Any] = {"base": "array-2x6", "vary": {"tube.length": [12.0, 14.0]}, "metrics": ["volume"]}

STUDIES = {
    "samples": {
        "vary": {"tube.inner_diameter": (0.3, 0.6), "lines.0.points": (6, 12)}, "sampling": "sobol", "cases": 8,
        "keep": "libraries", "precision": "single", "membranes": "solved", "fidelity": "atlas", "seed": 3,
        "outside": "navier-stokes", "constraints": ("tube.length > 20 * tube.inner_diameter",), "name": "mine",
    },
    "groups": {
        "vary": {"membrane.material": ["silicone-shore-a-30", "silicone-shore-a-10"]},
        "together": [{"tube.length": np.array([12.0, 14.0]), "membrane.thickness": [0.4, 0.5]}],
        "frequency": [1.0, 5.0, 100.0], "description": 'what "it" asks',
    },
    "range of a file": {"vary": {"tube.length": {"from": 9, "to": 30, "scale": "log", "count": 4}}},
}  # fmt: skip


@pytest.mark.parametrize("own", [False, True])
@pytest.mark.parametrize("name", STUDIES)
def test_a_study_is_written_and_read_back(name: str, own: bool, tmp_path: Path) -> None:
    base = geometry.prototype("array-2x6").with_values({"name": "mine", "tube.length": 13.3}) if own else "array-2x6"
    study = studies.Study(**{**GIVEN, **STUDIES[name], "base": base})
    study.save(tmp_path / "s.toml")
    again = studies.Study.load(tmp_path / "s.toml")
    assert again == study
    assert hash(again) == hash(study)
    assert again.content() == study.content()
    assert (again.base, again.name, again.description) == (study.base, study.name, study.description)
    assert study.text == (tmp_path / "s.toml").read_text()
    for one, other in zip(cases_of(study).columns, cases_of(again).columns, strict=True):
        np.testing.assert_array_equal(one, other)


@pytest.mark.parametrize(
    ("words", "membranes"),
    [
        ({}, "interpolated"),
        ({"keep": "responses"}, "interpolated"),
        ({"keep": "libraries"}, "solved"),
        ({"keep": "libraries", "membranes": "interpolated"}, "interpolated"),
        ({"membranes": "solved"}, "solved"),
    ],
)
def test_each_membrane_is_solved_by_default_if_libraries_are_kept(words: dict[str, str], membranes: str) -> None:
    study = studies.Study(**GIVEN, **words)
    assert study.membranes == membranes
    assert read_study(study.text) == study
    assert ("membranes" in study.text) == ("membranes" in words)


def test_studies_that_differ_are_not_equal() -> None:
    study = studies.Study(**GIVEN)
    changes: list[dict[str, Any]] = [
        {"vary": {"tube.length": [12.0, 14.5]}}, {"metrics": ["mass"]}, {"seed": 1}, {"name": "other"},
        {"description": "another question"}, {"base": "line-3"}, {"keep": "libraries"}, {"frequency": "1:100:63"},
    ]  # fmt: skip
    for change in changes:
        assert studies.Study(**{**GIVEN, **change}) != study
    assert study != "study"


def test_a_pair_is_a_range_and_a_list_is_its_values() -> None:
    pair = studies.Study(**{**GIVEN, "vary": {"tube.length": (12, 14)}}, sampling="random", cases=2)
    assert (pair.parameters[0].low, pair.parameters[0].high, pair.parameters[0].values) == (12, 14, ())
    assert studies.Study(**GIVEN).parameters[0].values == (12.0, 14.0)


def test_a_base_that_is_a_file_is_read_beside_the_study_and_here(tmp_path: Path) -> None:
    design = geometry.prototype("line-3").with_values({"name": "mine"})
    geometry.save_design(design, tmp_path / "mine.toml")
    assert studies.Study(**{**GIVEN, "base": tmp_path / "mine.toml"}).base == design


WRONG: dict[str, tuple[dict[str, Any], Kind, str]] = {
    "base": ({"base": "array-2x7"}, Kind.UNKNOWN, "base"),
    "type of the base": ({"base": 3}, Kind.WRONG_TYPE, "base"),
    "nothing varies": ({"vary": {}}, Kind.MISSING, "vary"),
    "field": ({"vary": {"tube.lenght": [1, 2]}}, Kind.UNKNOWN, "vary.tube.lenght"),
    "range in a grid": ({"vary": {"tube.length": (12, 14)}}, Kind.MISSING, "vary.tube.length.count"),
    "frequency": ({"frequency": [3.0, 1.0]}, Kind.OUT_OF_RANGE, "frequency"),
    "keep": ({"keep": "all"}, Kind.OUT_OF_RANGE, "keep"),
    "precision": ({"precision": "half"}, Kind.OUT_OF_RANGE, "precision"),
    "outside": ({"fidelity": "lumped", "outside": "navier-stokes"}, Kind.CONFLICT, "outside"),
    "metric": ({"metrics": ["volum"]}, Kind.UNKNOWN, "metrics"),
}


@pytest.mark.parametrize("name", WRONG)
def test_a_wrong_argument_is_refused_by_name(name: str) -> None:
    given, kind, field = WRONG[name]
    with refused(kind, field):
        studies.Study(**{**GIVEN, **given})


@pytest.mark.parametrize(
    ("old", "field"),
    [("transfer_functions = true", "transfer_functions"), ('frequencies = "1:100:8"', "frequencies"),
     ('[parameters]\n"tube.length" = [12]', "parameters")],
)  # fmt: skip
def test_words_of_older_files_are_refused_with_what_to_write(old: str, field: str) -> None:
    with refused(Kind.UNKNOWN, field, error=StudyError) as found:
        read_study(f'base = "line-3"\nmetrics = ["volume"]\n{old}\n')
    new = {"transfer_functions": 'keep = "responses"', "frequencies": "frequency", "parameters": "[vary]"}[field]
    assert f"write {new}" in str(found.value)
