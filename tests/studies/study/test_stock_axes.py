"""A study varies sizes that can be bought, with the parts that go with them, unless its stock is off."""

from __future__ import annotations

from itertools import product
from pathlib import Path
from typing import Any

import pytest
from refusals import refused

from geometry.ground.refusal import Kind
from geometry.stock import Spring, catalogue
from geometry.stock.stock_files import VARIABLE
from studies.study.cases import cases_of
from studies.study.parameter import StudyError
from studies.study.study import Study, read_study

HEAD = 'base = "array-2x6"\nmetrics = ["distance_smallest"]\nfidelity = "lumped"\n'


def study(vary: dict[str, Any], **more: Any) -> Study:
    more = {"sampling": "sobol", "cases": 32, "fidelity": "lumped", **more}
    return Study("array-2x6", vary, metrics=["distance_smallest"], **more)


def assert_bought(found: Study) -> None:
    stock, cases = catalogue(), cases_of(found)
    for number in range(len(cases)):
        fit = stock.fit(cases.design(number))
        assert fit.bought, (cases.case(number), fit.changes, fit.missing)


RANGES: dict[str, Any] = {
    "tube.inner_diameter": (0.3, 1.0),
    "tube.spring_outer_diameter": (0.5, 1.0),
    "tube.wire_diameter": (0.05, 0.2),
    "tube.outer_diameter": (0.8, 1.3),
    "tube.sheath_wall": (0.1, 0.3),
    "membrane.thickness": (0.2, 1.0),
}


@pytest.mark.parametrize("name", RANGES)
@pytest.mark.parametrize("sampling", ["sobol", "latin-hypercube", "random", "grid"])
def test_every_case_of_a_range_can_be_bought(name: str, sampling: str) -> None:
    found = study({name: RANGES[name]}, sampling=sampling, cases=None if sampling == "grid" else 32)
    assert_bought(found)
    sizes = set(cases_of(found).columns[0].tolist())
    assert len(sizes) > 2
    assert RANGES[name][0] - 1e-3 <= min(sizes) < max(sizes) <= RANGES[name][1] + 1e-3


@pytest.mark.parametrize(
    "names",
    [
        ("tube.inner_diameter", "tube.wire_diameter"),
        ("tube.spring_outer_diameter", "tube.wire_diameter", "tube.outer_diameter"),
        ("tube.inner_diameter", "tube.sheath_wall", "membrane.thickness"),
        ("microphone_tube.inner_diameter", "tube.inner_diameter"),
    ],
)
def test_fields_of_one_tube_together_are_those_of_parts(names: tuple[str, ...]) -> None:
    wanted = {name: RANGES.get(name, (0.3, 0.8)) for name in names}
    assert_bought(study(wanted))
    assert_bought(study(wanted, sampling="grid", cases=None))


def test_a_bore_and_a_wire_are_those_of_one_spring() -> None:
    found = cases_of(study({"tube.inner_diameter": (0.3, 0.8), "tube.wire_diameter": (0.08, 0.1)}, cases=64))
    pairs = {(part.bore, part.wire_diameter) for part in catalogue().of(Spring)}
    drawn = {(case["tube.inner_diameter"], case["tube.wire_diameter"]) for case in map(found.case, range(64))}
    assert drawn <= pairs
    assert len(drawn) > 6


def test_wire_and_sheath_go_with_a_bore_and_a_follower_that_stays_is_left_out() -> None:
    names = [each.name for each in study({"tube.inner_diameter": (0.3, 0.6)}).parameters]
    assert names == ["tube.inner_diameter", "tube.wire_diameter", "tube.outer_diameter"]
    assert [each.name for each in study({"tube.spring_outer_diameter": [0.6]}).parameters] == [
        "tube.spring_outer_diameter"
    ]
    assert [each.name for each in study({"tube.outer_diameter": (0.8, 1.3)}).parameters] == ["tube.outer_diameter"]


def test_a_grid_has_all_sizes_of_a_range_or_as_many_as_it_counts() -> None:
    text = f'{HEAD}[vary]\n"membrane.thickness" = {{from = 0.2, to = 0.8%s}}\n'
    all_sizes = cases_of(read_study(text % "")).columns[0].tolist()
    assert all_sizes == [size for size in catalogue().sizes("membrane.thickness") if 0.2 <= size <= 0.8]
    assert cases_of(read_study(text % ", count = 3")).columns[0].tolist() == [0.2, 0.5, 0.8]


def test_a_group_of_ranges_goes_from_size_to_size_and_its_other_fields_stay_free() -> None:
    group = {
        "tube.inner_diameter": (0.35, 0.7),
        "microphone_tube.inner_diameter": (0.4, 0.8),
        "tube.length": (9.0, 12.0),
    }
    found = study({}, together=[group])
    assert_bought(found)
    cases = [cases_of(found).case(number) for number in range(32)]
    assert len({case["tube.length"] for case in cases}) == 32
    ordered = sorted(cases, key=lambda case: case["tube.length"])
    for name in ("tube.inner_diameter", "microphone_tube.inner_diameter"):
        values = [case[name] for case in ordered]
        assert values == sorted(values)
        assert len(set(values)) > 4


def test_a_smooth_bore_is_that_of_a_tubing() -> None:
    base = read_study(f'{HEAD}[vary]\n"tube.length" = [12.5]\n').base.with_values({"tube.bore": "smooth"})
    found = Study(base, {"tube.inner_diameter": (0.3, 0.8)}, metrics=["distance_smallest"], sampling="random", cases=32)
    assert_bought(found)


def test_rows_of_listed_springs_get_their_sheaths() -> None:
    group = {"tube.spring_outer_diameter": [0.6, 0.7, 0.8], "tube.wire_diameter": [0.08, 0.1, 0.1]}
    found = study({}, together=[group], sampling="grid", cases=None)
    assert_bought(found)
    assert [each.name for each in found.parameters][:2] == list(group)


def test_a_step_states_the_sizes_of_its_own() -> None:
    text = f'{HEAD}[vary]\n"membrane.thickness" = {{from = 0.31, to = 0.75, step = 0.11}}\n'
    assert cases_of(read_study(text)).columns[0].tolist() == [0.31, 0.42, 0.53, 0.64, 0.75]


def test_stock_off_frees_every_field() -> None:
    freed = study({"tube.inner_diameter": (0.1, 0.3), "membrane.thickness": [0.123, 0.456]}, stock="off")
    assert [each.name for each in freed.parameters] == ["tube.inner_diameter", "membrane.thickness"]
    assert set(cases_of(freed).columns[1].tolist()) == {0.123, 0.456}


@pytest.mark.parametrize(
    ("vary", "field", "value"),
    [
        ({"tube.inner_diameter": (0.1, 0.3)}, "vary.tube.inner_diameter", [0.1, 0.3]),
        ({"tube.inner_diameter": [0.44, 0.3]}, "vary.tube.inner_diameter", 0.3),
        ({"membrane.thickness": [0.55]}, "vary.membrane.thickness", 0.55),
        ({"tube.outer_diameter": (2.0, 2.4)}, "vary.tube.outer_diameter", [2.0, 2.4]),
        ({"tube.inner_diameter": (0.3, 0.5), "tube.wire_diameter": [0.3]}, "vary", None),
    ],
)
def test_sizes_that_nobody_sells_are_refused_with_the_way_out(vary: dict[str, Any], field: str, value: Any) -> None:
    with refused(Kind.CONFLICT, field, error=StudyError) as found:
        study(vary)
    assert 'stock = "off"' in str(found.value)
    assert value is None or found.value.value == value


def test_a_listed_row_that_nobody_sells_is_refused() -> None:
    group = {"tube.spring_outer_diameter": [0.6, 0.5], "tube.wire_diameter": [0.08, 0.12]}
    with refused(Kind.CONFLICT, "together.0.tube", [0.5, 0.12], error=StudyError):
        study({}, together=[group], sampling="grid", cases=None)


def test_own_parts_count(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    row = 'maker = "me"\nprice = 1.0\nprice_date = "2026"\nsource = "measured"\n'
    (tmp_path / "mine.toml").write_text(f"[[sheet]]\n{row}thickness = 0.55\nshore_a = 30.0\ntolerance = 0.05\n")
    monkeypatch.setenv(VARIABLE, str(tmp_path))
    assert 0.55 in cases_of(study({"membrane.thickness": (0.5, 0.6)})).columns[0].tolist()


def test_other_studies_stay_what_they_were() -> None:
    vary = {"tube.length": (9.0, 12.0), "resonator.cavity_height": [2.0, 2.5]}
    on, off = (study(vary, stock=stock) for stock in ("on", "off"))
    assert on.digest() == off.digest()


def test_a_study_that_is_written_and_read_is_the_same(tmp_path: Path) -> None:
    for stock, bore in product(("on", "off"), ((0.3, 0.6), [0.44, 0.6])):
        given = study({"tube.inner_diameter": bore}, stock=stock)
        given.save(tmp_path / "study.toml")
        assert Study.load(tmp_path / "study.toml") == given
