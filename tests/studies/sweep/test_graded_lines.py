"""Studies over lines of several kinds of points and tubes: the fields of kinds are parameters like others."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from refusals import refused

import acoustic_fem
from acoustic_fem.batch.network import batch_transfer_function
from acoustic_fem.membrane.design_discs import design_disc
from acoustic_fem.quantities.local_air import design_air
from acoustic_fem.scatter.tolerances import ScatteredDesign
from geometry import ArrayDesign, prototype
from geometry.design.design_file import save_design
from geometry.ground.refusal import Kind
from studies.metrics import build
from studies.optimization.printable import measures
from studies.optimization.problem import read_optimization
from studies.optimization.search import search_designs
from studies.run.check import kind_uses
from studies.run.validity import model_validity
from studies.study.metric_registry import METRICS
from studies.study.parameter import StudyError
from studies.study.study import load_study, read_study
from studies.sweep.results import open_sweep
from studies.sweep.run import run_sweep
from studies.sweep.survey import surveyed

NAMES = ("distance_smallest", "sensitivity_force", "volume", "cost", "length")
STUDY = """
name = "wells"
base = "graded.toml"
fidelity = "lumped"
frequency = "1:100:7"
stock = "off"
metrics = ["distance_smallest", "sensitivity_force", "volume", "cost", "length"]
"""
PARAMETERS = """
[vary]
"point_kinds.well.cavity_height" = [3.0, 5.0]
"point_kinds.well.membrane_thickness" = [0.7, 0.9]
"tube_kinds.short.length" = [8.0, 11.0]
"""


def graded() -> ArrayDesign:
    base = prototype("array-2x6")
    tube = base.tube.model_dump()
    pattern = {"points": ["stiff", "well"], "tubes": ["long", "short"], "mirrored": True}
    return base.with_values({
        "point_kinds": {"stiff": {}, "well": {"cavity_height": 4.0, "membrane_thickness": 0.8}},
        "tube_kinds": {"long": {**tube, "length": 14.0}, "short": {**tube, "length": 8.0, "inner_diameter": 0.5}},
        "lines": [{"between": ["A", "B"], "points": 4, "pattern": pattern}],
    })  # fmt: skip


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    save_design(graded(), tmp_path / "graded.toml")
    return tmp_path


def test_a_sweep_over_the_fields_of_kinds_has_the_values_of_each_design_solved_alone(folder: Path) -> None:
    (folder / "study.toml").write_text(STUDY + PARAMETERS, encoding="utf-8")
    study = load_study(folder / "study.toml")
    # Membranes of all cases, those of the stiff kind too: two thicknesses of wells and one.
    assert len(surveyed(study).discs) == 3
    run_sweep(study, folder / "results.zarr", workers=1)
    result = open_sweep(folder / "results.zarr")
    assert result.done.all()
    assert len(result.done) == 8
    for number in (0, 3, 6):
        library = acoustic_fem.solve(result.design(number), study.frequency, "lumped")
        for name in NAMES:
            assert float(result.to_xarray()[name][number]) == pytest.approx(METRICS[name].of_library(library), rel=1e-6)
    assert len(np.unique(result.to_xarray()["sensitivity_force"].values)) == 8


def test_a_kind_that_is_not_there_is_refused_by_name(folder: Path) -> None:
    (folder / "study.toml").write_text(STUDY + '[vary]\n"point_kinds.wel.cavity_height" = [3.0]\n', encoding="utf-8")
    with refused(Kind.UNKNOWN, "vary.point_kinds.wel.cavity_height", file="study.toml", error=StudyError):
        load_study(folder / "study.toml")
    with refused(Kind.OUT_OF_RANGE, "vary.point_kinds.well.cavity_height.from", 0.1, error=StudyError):
        read_study(
            STUDY.replace("graded.toml", str(folder / "graded.toml"))
            + '[vary]\n"point_kinds.well.cavity_height" = { from = 0.1, to = 5.0 }\n'
        )


def test_a_search_over_the_fields_of_kinds_finds_designs_that_can_be_printed(folder: Path) -> None:
    problem = read_optimization(
        STUDY.replace("graded.toml", str(folder / "graded.toml"))
        + """
[vary]
"point_kinds.well.membrane_thickness" = { from = 0.05, to = 0.9 }
"tube_kinds.short.length" = { from = 6.0, to = 14.0 }
[optimize]
trials = 8
batch = 8
[[optimize.objectives]]
metric = "distance_smallest"
"""
    )
    found = search_designs(problem, folder)
    assert found.front
    for candidate in found.front:
        # Thinner discs are below what the process casts.
        assert candidate.values["point_kinds.well.membrane_thickness"] >= 0.2
        assert 6.0 <= candidate.values["tube_kinds.short.length"] <= 14.0


def test_print_rules_measure_every_kind() -> None:
    found = {measure.name: measure.value for measure in measures(graded())}
    assert found["point_kinds.well.membrane_thickness"] == 0.8
    assert found["tube_kinds.short.inner_diameter"] == 0.5
    assert found["wall above the socket of tube_kinds.short"] == pytest.approx(2.5 - 1.25 - 0.45 - 0.05)


def test_volumes_and_walls_are_those_of_the_kinds() -> None:
    design = graded()
    halves = [build.volume(design.with_values({"lines.0.pattern.points": [kind] * 2})) for kind in ("stiff", "well")]
    assert build.volume(design) == pytest.approx(np.mean(halves))
    lower = design.with_values({"point_kinds.well.cavity_height": 2.0})
    assert build.smallest_wall(lower) == pytest.approx(2.0 - 1.25 - 0.45 - 0.05)


def test_made_sensors_scatter_about_their_own_kinds() -> None:
    design, frequency = graded(), np.array([3.0, 60.0])
    scattered, air = ScatteredDesign(design), design_air(design)
    still = {name: np.zeros_like(values) for name, values in scattered.draws(0, 1, 0).items()}
    made = batch_transfer_function(scattered.parameters(still), scattered.topology, frequency, air)
    nominal = acoustic_fem.solve(design, frequency, "lumped").transfer_function.values
    np.testing.assert_allclose(made[0], nominal, rtol=2e-4)
    soft = scattered.sample(0, 200, 0).membrane_compliance.mean(axis=0)
    own = [design_disc(design.of_kind(kind)).static_compliance for kind in ("stiff", "well", "well", "stiff")]
    np.testing.assert_allclose(soft, own, rtol=0.1)


def test_check_counts_the_kinds_and_takes_the_worst_of_them() -> None:
    design = graded()
    thickness = design.membrane.thickness
    assert [(use.name, use.what, use.sizes, use.count) for use in kind_uses(design)] == [
        ("stiff", "point", f"cavity 2.5 mm high, membrane {thickness:g} mm", 2),
        ("well", "point", "cavity 4 mm high, membrane 0.8 mm", 2),
        ("long", "tube", "14 mm long, bore 0.44 mm", 2),
        ("short", "tube", "8 mm long, bore 0.5 mm", 1),
    ]
    assert kind_uses(prototype("array-2x6")) == ()
    first = {item.assumption: item.value for item in model_validity(design, design_air(design), -20.0)}
    slowest = min(design_disc(design.of_kind(kind)).first_frequency for kind in design.kinds)
    assert first["first resonance of the membrane, without air"] == slowest
    assert first["shear number of the widest bore at 100 Hz"] == pytest.approx(
        0.25e-3 * np.sqrt(2 * np.pi * 100 / design_air(design).kinematic_viscosity)
    )
