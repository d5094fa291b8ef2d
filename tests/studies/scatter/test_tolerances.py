"""Manufacturing scatter: draws that repeat, parts that are those of a changed design, indices that are known."""

from __future__ import annotations

import json
from dataclasses import replace
from functools import partial
from pathlib import Path

import numpy as np
import pytest
import scipy.stats
from refusals import check_messages, refused
from typer.testing import CliRunner

import acoustic_fem
import geometry
from acoustic_fem.batch.network import batch_transfer_function
from acoustic_fem.batch.openings import OpeningSizes, designs_outside
from acoustic_fem.batch.parameters import ArrayParameters
from acoustic_fem.duct.meshed_section import MeshedSection
from acoustic_fem.duct.sections import CircularSection
from acoustic_fem.quantities.local_air import design_air
from acoustic_fem.scatter.as_built_sensors import AsBuiltSensors, as_built_fidelity, scatter_factors
from acoustic_fem.scatter.tolerances import CUT, TOLERANCES, ScatteredDesign, Tolerance, read_tolerances
from geometry import Kind
from studies.cli.app import app
from studies.scatter.effects import deviation, scatter_effects, scattered_accuracy, sobol_indices

GRID = np.linspace(1.0, 100.0, 24)
DESIGN = geometry.prototype("array-2x6").with_values({"lines.0.points": 4})


@pytest.fixture(scope="module")
def scattered() -> ScatteredDesign:
    return ScatteredDesign(DESIGN)


def only(quantity: str, size: float) -> tuple[Tolerance, ...]:
    kind = "relative" if quantity.startswith("modulus") else "absolute"
    return (Tolerance(quantity, size, kind, "a test"),)


def test_a_sample_is_the_same_whatever_is_drawn_with_it(scattered: ScatteredDesign) -> None:
    many = scattered.draws(0, 20, 3)
    alone = scattered.draws(13, 1, 3)
    for name, values in many.items():
        assert np.array_equal(values[13:14], alone[name])
    assert not np.array_equal(scattered.draws(13, 1, 4)["bore"], alone["bore"])


def test_deviations_have_the_stated_size_and_are_independent(scattered: ScatteredDesign) -> None:
    parameters = scattered.sample(0, 4000, 0)
    bore = 2e3 * parameters.tube_radius
    # 0.9733 of the normal's deviation is left by the cut at three
    assert bore.std(axis=0) == pytest.approx(np.full(5, 0.015 * 0.987), rel=0.05, abs=0)
    assert np.abs(bore - DESIGN.tube.acoustic_diameter).max() <= CUT * 0.015 + 1e-9
    assert np.abs(np.corrcoef(bore.T) - np.eye(5)).max() < 0.07
    # one batch of silicone: all membranes of a sensor are softer or stiffer together
    compliance = np.log(ScatteredDesign(DESIGN, only("modulus_of_batch", 0.15)).sample(0, 50, 0).membrane_compliance)
    assert np.ptp(compliance, axis=1).max() < 1e-12
    assert np.ptp(compliance, axis=0).min() > 0.2


def test_an_oval_tube_is_the_round_one_of_its_resistance() -> None:
    tolerance = Tolerance("ovality", 0.1, "relative", "a test")
    oval = ScatteredDesign(DESIGN, [tolerance])
    draws = {name: np.ones_like(values) for name, values in oval.draws(0, 1, 0).items()}
    narrowed = oval.parameters(draws).tube_radius / oval.nominal.tube_radius
    assert narrowed == pytest.approx(np.full((1, 5), 0.99**0.75 * 1.01**-0.25), rel=1e-12, abs=0)
    # against quadratic elements on the ellipse, whose gas is 0.5 % more than that of this round one
    round_mesh, frequency, air = MeshedSection.circle(2.2e-4), np.array([1.0, 100.0]), design_air(DESIGN)
    ellipse = MeshedSection(round_mesh.points * [1.1, 0.9], round_mesh.triangles)
    z, y = (
        [getattr(section, name)(frequency, air) for section in (ellipse, CircularSection(2.2e-4 * narrowed[0, 0]))]
        for name in ("series_impedance", "shunt_admittance")
    )
    assert np.all(np.abs(z[1] / z[0] - 1) < [3e-4, 4e-3])  # resistance, and with inertance
    assert np.abs(y[1] / y[0] - 1).max() < 0.011


def test_without_deviations_it_is_the_design(scattered: ScatteredDesign) -> None:
    zero = {name: np.zeros_like(values) for name, values in scattered.draws(0, 1, 0).items()}
    h = batch_transfer_function(scattered.parameters(zero), scattered.topology, GRID, design_air(DESIGN))[0]
    expected = acoustic_fem.solve(DESIGN, GRID, "lumped").transfer_function.values
    assert np.abs(h / expected - 1).max() < 3e-5


@pytest.mark.parametrize(("thickness", "diameter"), [(0.38, 6.1), (0.5, 5.9), (0.64, 6.0)])
def test_membranes_between_the_nodes_are_those_of_the_elastic_solution(
    scattered: ScatteredDesign, thickness: float, diameter: float
) -> None:
    changed = DESIGN.with_values({"membrane.thickness": thickness, "resonator.cavity_diameter": diameter})
    exact = ArrayParameters.from_design(changed)
    one = np.ones((1, 1))
    compliance, share, frequency = scattered._discs[0].at(one * diameter / 2e3, one * thickness / 1e3, one)
    # the rim keeps its ratio to the opening: a tenth of a percent
    assert compliance == pytest.approx(exact.membrane_compliance, rel=1e-3, abs=0)
    assert np.abs(share - exact.membrane_fraction).max() < 1e-4
    assert frequency == pytest.approx(exact.membrane_frequency, rel=2e-3, abs=0)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("quantity", "size", "values"),
    [
        ("length", 0.2, {"tube.length": 12.7, "microphone_tube.length": 12.7}),
        ("bore", 0.02, {"tube.inner_diameter": 0.46, "microphone_tube.inner_diameter": 0.46}),
        ("cavity_height", 0.1, {"resonator.cavity_height": 2.6}),
        ("cavity_diameter", 0.1, {"resonator.cavity_diameter": 6.1}),
        ("membrane_thickness", 0.05, {"membrane.thickness": 0.55}),
    ],
)
def test_all_parts_one_deviation_up_are_the_changed_design(quantity: str, size: float, values: dict) -> None:
    scattered = ScatteredDesign(DESIGN, only(quantity, size))
    ones = {name: np.ones_like(drawn) for name, drawn in scattered.draws(0, 1, 0).items()}
    h = batch_transfer_function(scattered.parameters(ones), scattered.topology, GRID, design_air(DESIGN))
    changed = acoustic_fem.solve(DESIGN.with_values(values), GRID, "lumped").transfer_function.values[None]
    moved = deviation(changed, acoustic_fem.solve(DESIGN, GRID, "lumped").transfer_function.values[None])[0]
    assert deviation(h, changed)[0] < 0.03 * moved


def test_indices_of_a_known_function() -> None:
    """Ishigami's function: first 0.3139, 0.4424, 0; total 0.5576, 0.4424, 0.2437 (Saltelli 2000, p. 179)."""

    def ishigami(x: np.ndarray) -> np.ndarray:
        return np.sin(x[0]) + 7 * np.sin(x[1]) ** 2 + 0.1 * x[2] ** 4 * np.sin(x[0])

    draws = np.pi * (2 * scipy.stats.qmc.Sobol(6, seed=1).random(4096).T - 1)
    a, b = draws[:3], draws[3:]
    mixed = np.stack([ishigami(np.where(np.arange(3)[:, None] == k, b, a)) for k in range(3)])
    found = {index.quantity: index for index in sobol_indices("xyz", ishigami(a), ishigami(b), mixed)}
    for name, first, total in (("x", 0.3139, 0.5576), ("y", 0.4424, 0.4424), ("z", 0.0, 0.2437)):
        assert found[name].first == pytest.approx(first, abs=0.03)
        assert found[name].total == pytest.approx(total, abs=0.03)
        assert abs(found[name].total - total) < 4 * found[name].error + 0.01
    uniform = scipy.stats.uniform(-np.pi, 2 * np.pi)
    scipys = scipy.stats.sobol_indices(func=ishigami, n=4096, dists=[uniform] * 3, rng=1)
    assert [found[name].total for name in "xyz"] == pytest.approx(scipys.total_order, abs=0.04)


def test_an_output_that_never_changes_has_no_causes() -> None:
    assert all(index.total == 0 for index in sobol_indices("ab", np.ones(8), np.ones(8), np.ones((2, 8))))


def test_scatter_costs_accuracy_and_a_calibrated_sensor_gets_it_back() -> None:
    found = scatter_effects(DESIGN, GRID, samples=24, base_samples=8, microphone_noise=3e-3)
    mean = {name: values.mean() for name, values in found.accuracy.items()}
    assert mean["nominal"] < mean["calibrated"]
    assert mean["calibrated"] == pytest.approx(found.nominal_accuracy, abs=0.02)
    assert {index.quantity for index in found.sobol["deviation"]} == {t.quantity for t in TOLERANCES}
    largest = [index.quantity for index in found.sobol["deviation"]][:2]
    assert {"membrane_thickness", "modulus_of_batch"} & set(largest)
    again = scatter_effects(DESIGN, GRID, samples=24, base_samples=0, microphone_noise=3e-3)
    assert np.array_equal(again.transfer_function, found.transfer_function)
    assert again.sobol == {}
    assert found.summary()["fidelity"] == "atlas"
    json.dumps(found.summary(), allow_nan=False)


@pytest.mark.slow
def test_drawn_sensors_are_of_the_atlas_if_it_covers_all_of_them_otherwise_of_3d_and_it_says_why() -> None:
    scattered, air = ScatteredDesign(DESIGN), design_air(DESIGN)
    found = scatter_effects(DESIGN, GRID, samples=4, base_samples=0, microphone_noise=3e-3)
    draws = scattered.draws(0, 4, 0)
    expected = AsBuiltSensors(scattered, GRID, air, "atlas").transfer_functions(draws)
    assert np.array_equal(found.transfer_function, expected)
    lumped = AsBuiltSensors(scattered, GRID, air).transfer_functions(draws)
    assert np.abs(expected / lumped - 1).max() > 1e-3
    # tall: heights by radius end at 2.3, bore radii by the distance to the floor at 0.06
    edge = DESIGN.with_values({"resonator.cavity_height": round(2.29 * DESIGN.resonator.cavity_diameter / 2, 3)})
    found = scatter_effects(edge, GRID, samples=2, base_samples=0, microphone_noise=3e-3)
    assert found.summary()["fidelity"] == "navier-stokes"
    assert "height of its axis above the floor = 0.05" in found.summary()["outside_atlas"]
    solid = acoustic_fem.solve(edge, GRID).transfer_function.values
    np.testing.assert_allclose(found.nominal, solid, rtol=1e-12)
    ratio = scatter_factors(ScatteredDesign(edge), design_air(edge), GRID, 2, 0)
    np.testing.assert_allclose(found.transfer_function, solid * ratio, rtol=1e-9)
    within = scatter_effects(
        edge, GRID, samples=2, base_samples=0, microphone_noise=3e-3, tolerances=only("length", 0.1)
    )
    assert within.summary()["fidelity"] == "atlas"


def test_every_drawn_sensor_is_within_what_the_decision_looked_at() -> None:
    """Sizes drawn far: of whatever is decided to be of the atlas, no draw is refused by it."""
    tolerances = tuple(replace(each, deviation=6 * each.deviation) for each in TOLERANCES if each.kind == "absolute")
    for height in (1.7, 2.5, 4.0, 5.5):
        design = DESIGN.with_values({"resonator.cavity_height": height})
        scattered, air = ScatteredDesign(design, tolerances), design_air(design)
        drawn = scattered.parameters(scattered.draws(0, 400, 1))
        outside = designs_outside(OpeningSizes.of(drawn), scattered.topology, GRID, air).any()
        assert not (outside and as_built_fidelity(scattered, GRID, air).name == "atlas")


def test_without_scatter_every_sensor_is_the_design() -> None:
    found = scatter_effects(
        DESIGN, GRID, samples=2, base_samples=2, tolerances=only("length", 0.0), microphone_noise=3e-3
    )
    assert found.deviation == pytest.approx(np.zeros(2), abs=1e-4)
    assert found.accuracy["nominal"] == pytest.approx(np.full(2, found.nominal_accuracy))
    assert found.sobol["deviation"][0].total == 0


def test_stiff_membranes_forgive() -> None:
    """The air's compliance, which does not scatter, takes the place of the silicone's."""
    stiff = DESIGN.with_values({"lines.0.points": 12, "membrane.thickness": 2.0})
    soft = DESIGN.with_values({"lines.0.points": 12})
    assert (scattered_accuracy(stiff, GRID, sensors=8) - scattered_accuracy(soft, GRID, sensors=8)).mean() > 0.02
    precise = tuple(replace(tolerance, deviation=0.0) for tolerance in TOLERANCES)
    assert scattered_accuracy(soft, GRID, sensors=2, tolerances=precise).min() > 0.95


def test_a_stretched_membrane_with_loss_is_refused_in_the_words_of_the_design_file() -> None:
    with refused(Kind.NO_RESULT, "membrane.stretch", 1.1):
        scattered_accuracy(DESIGN.with_values({"membrane.stretch": 1.1}), GRID, sensors=2)


def test_a_file_replaces_what_it_names(tmp_path: Path) -> None:
    file = tmp_path / "mine.toml"
    file.write_text('[bore]\ndeviation = 0.03\nkind = "relative"\n[length]\ndeviation = 0.05\nsource = "a ruler"\n')
    found = {tolerance.quantity: tolerance for tolerance in read_tolerances(file)}
    assert (found["bore"].deviation, found["bore"].kind) == (0.03, "relative")
    assert (found["length"].deviation, found["length"].source) == (0.05, "a ruler")
    assert found["cavity_height"] in TOLERANCES
    assert len(found) == len(TOLERANCES)


#: Text of a file of tolerances, and kind, field and value of its refusal.
BAD_FILES: dict[str, tuple[str, Kind, str]] = {
    "a quantity that is none": ("[boar]\ndeviation = 1", Kind.UNKNOWN, "boar"),
    "a key that is none": ("[bore]\nsize = 1", Kind.UNKNOWN, "bore"),
    "too large": ("[bore]\ndeviation = 9.0", Kind.OUT_OF_RANGE, "bore.deviation"),
    "not a number": ("[bore]\ndeviation = nan", Kind.OUT_OF_RANGE, "bore.deviation"),
    "true": ("[bore]\ndeviation = true", Kind.WRONG_TYPE, "bore.deviation"),
    "a kind that is none": ('[bore]\nkind = "some"', Kind.OUT_OF_RANGE, "bore.kind"),
    "a list": ("[bore]\nkind = []", Kind.WRONG_TYPE, "bore.kind"),
    "a source of three": ("[bore]\nsource = 3", Kind.WRONG_TYPE, "bore.source"),
    "no length": ('[modulus_of_part]\nkind = "absolute"', Kind.OUT_OF_RANGE, "modulus_of_part.kind"),
    "no scatter by default": ("[ovality]\nsource = 'a guess'", Kind.MISSING, "ovality"),
    "no table": ("bore = 3", Kind.WRONG_TYPE, "bore"),
    "empty": ("", Kind.MISSING, ""),
}


def test_a_bad_file_is_refused_by_name(tmp_path: Path) -> None:
    cases = {}
    for fault, (text, kind, field) in BAD_FILES.items():
        path = tmp_path / f"{fault}.toml"
        path.write_text(text)
        with refused(kind, field, file=path):
            read_tolerances(path)
        cases[fault] = partial(read_tolerances, path)
    check_messages(Path(__file__).with_name("messages.txt"), cases, {f"{tmp_path}/": ""})


@pytest.mark.parametrize(
    ("name", "value", "kind"),
    [
        ("samples", 1, Kind.OUT_OF_RANGE),
        ("base_samples", -1, Kind.OUT_OF_RANGE),
        ("microphone_noise", 0.0, Kind.OUT_OF_RANGE),
        ("tolerances", TOLERANCES[:1] * 2, Kind.CONFLICT),
    ],
)
def test_bad_arguments_are_refused(name: str, value: object, kind: Kind) -> None:
    with refused(kind, "tolerances.bore" if name == "tolerances" else name):
        scatter_effects(DESIGN, GRID, **{name: value})


def test_the_verb_writes_its_files(tmp_path: Path) -> None:
    design = tmp_path / "four.toml"
    design.write_text(geometry.design.write_design(DESIGN))
    out = tmp_path / "scatter"
    arguments = ["tolerance", str(design), "--out", str(out), "--samples", "8", "--base", "4", "--library", "5"]
    result = CliRunner().invoke(app, arguments)
    assert result.exit_code == 0, result.output
    assert json.loads((out / "tolerance.json").read_text())["samples"] == 8
    assert (out / "tolerance.png").stat().st_size > 10_000
    with refused(Kind.EXISTS, "out", file="library.zarr"):
        CliRunner().invoke(app, arguments, standalone_mode=False, catch_exceptions=False)
