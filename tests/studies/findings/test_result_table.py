"""The table behind the page: effects, maps and fronts that are known, units of the design."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable
from functools import partial
from pathlib import Path

import numpy as np
import pytest

from geometry import prototype
from studies.findings.page import _effects, design_of
from studies.findings.result_table import (
    Column,
    ResultTable,
    effect,
    fast_front,
    pair_map,
    table_of_sweep,
    unit_of,
)
from studies.optimization.search import pareto_front
from studies.study.parameter import followers
from studies.study.study import load_study
from studies.sweep.results import open_sweep
from studies.sweep.run import run_sweep


def made_up(metric: Callable[[np.ndarray, np.ndarray], np.ndarray], count: int = 4000) -> tuple[Column, Column, Column]:
    a, b = np.random.default_rng(1).random((2, count))
    return Column("a", "a", "mm", a), Column("b", "b", "mm", b), Column("m", "m", "", metric(a, b), (), "larger")


def test_shares_are_those_of_an_additive_function() -> None:
    """The variances of 3 a + b are 9 : 1."""
    a, b, metric = made_up(lambda a, b: 3 * a + b)
    assert effect(a, metric).share == pytest.approx(0.9, abs=0.02)
    assert effect(b, metric).share == pytest.approx(0.1, abs=0.02)
    own = effect(a, metric)
    np.testing.assert_allclose(own.mean, 3 * own.centres + 0.5, atol=0.06)


def test_a_parameter_without_effect_has_a_share_near_zero() -> None:
    a, b, metric = made_up(lambda a, b: np.sin(9 * a), count=60)
    assert effect(b, metric).share < 0.15
    assert effect(a, metric).share > 0.5


def test_a_map_holds_the_means_of_its_fields() -> None:
    a, b, metric = made_up(lambda a, b: a * b)
    x, y, means = pair_map(a, b, metric)
    np.testing.assert_allclose(means, np.outer(y, x), atol=0.03)


def test_the_fast_front_is_the_plain_one() -> None:
    random = np.random.default_rng(0)
    for _ in range(20):
        values = random.integers(0, 6, (40, 2)).astype(float)
        assert (fast_front(values) == pareto_front(values)).all()


def test_units_come_from_the_design() -> None:
    assert unit_of("lines.0.tube.length") == "mm"
    assert unit_of("membrane.material") == ""


def test_whole_numbers_of_a_design_stay_whole() -> None:
    points, length = (Column(name, "", "", np.array([5.0])) for name in ("lines.0.points", "tube.length"))
    about = ("a", "", "sweep", "lumped", np.array([1.0]), partial(prototype, "array-2x6"), np.array([0]))
    table = ResultTable(*about, (points, length), (), (), 0, {})
    assert table.values(0) == {"lines.0.points": 5, "tube.length": 5.0}
    assert design_of(table, 0).lines[0].points == 5


STUDY = """
name = "two"
base = "array-2x6"
fidelity = "lumped"
frequency = "1:100:16"
sampling = "grid"
metrics = ["distance_smallest", "mass"]
keep = "responses"

[vary]
"tube.inner_diameter" = [0.4, 0.5]
"""


def test_the_best_of_a_sweep_are_listed_without_what_computes_them(tmp_path: Path) -> None:
    (tmp_path / "study.toml").write_text(STUDY)
    run_sweep(load_study(tmp_path / "study.toml"), tmp_path / "results.zarr", workers=1)
    code = (
        "import sys\n"
        "from studies.findings.reporting import best_designs\n"
        f"best = best_designs({str(tmp_path / 'results.zarr')!r}, 'mass')\n"
        "print(best.rows)\n"
        "print([round(value, 3) for value in best.metric.values.tolist()])\n"
        "print(sorted({'dask', 'pandas', 'scipy', 'skfem', 'torch', 'xarray'} & set(sys.modules)))"
    )
    told = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, encoding="utf-8")
    sweep = open_sweep(tmp_path / "results.zarr")
    mass = [round(value, 3) for value in sweep.to_xarray()["mass"].values.tolist()]
    assert told.stdout.splitlines() == [str(tuple(np.argsort(mass).tolist())), str(mass), "[]"]
    assert sweep.to_xarray()["transfer_function"].shape == (2, 12, 2, 16)
    assert sweep.to_xarray().sizes["case"] == len(sweep.values["case"]) == 2
    table = table_of_sweep(sweep)
    assert [column.name for column in table.free] == ["tube.inner_diameter"]
    follow = {column.name: column.follows for column in table.parameters if column.follows}
    assert set(follow.values()) == {"tube.inner_diameter"}
    assert "tube.wire_diameter" in follow
    assert len(_effects(table)[0]) == 1
    assert [name for name in sweep.parameters if name not in sweep.followers] == ["tube.inner_diameter"]


def test_a_parameter_follows_where_those_before_it_in_its_group_decide_its_value() -> None:
    alone, bore, wire = ("length", ()), ("bore", (0.4, 0.4, 0.5)), ("wire", (0.1, 0.1, 0.2))
    assert followers([[alone], [bore, wire]]) == {"wire": "bore"}
    assert followers([[bore, ("outside", (1.0, 1.2, 1.2))]]) == {}
    assert followers([[("a", ()), ("b", ())]]) == {"b": "a"}  # two ranges that go together
