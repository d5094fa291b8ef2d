"""Distances of points: exact for ratios that are known, a metric, blind to the touch."""

from __future__ import annotations

import json
from dataclasses import replace
from functools import partial
from itertools import combinations
from pathlib import Path

import numpy as np
import pytest
import xarray as xr
from hypothesis import given, strategies as st
from refusals import check_messages, refused

import acoustic_fem
import geometry
from acoustic_fem.library.noise_floor import detection_limits
from geometry import Kind
from geometry.assembly.bill import Waste, bill_of_materials
from geometry.layout.size import array_size
from geometry.stock import catalogue
from studies.metrics import build, shared
from studies.metrics.batch_responses import Responses
from studies.metrics.build import volumes_of
from studies.metrics.confusion import check_grid, predict_confusion
from studies.metrics.pairs import (
    DECIBEL,
    attenuation,
    disagreement,
    microphone_ratios,
    sensitivity,
    trapezoidal_weights,
    worst_heard,
)
from studies.metrics.separation import pair_distances, separability
from studies.metrics.shared import SharedFigures
from studies.metrics.touch_metrics import touch_response
from studies.study.metric_registry import METRICS, metrics_named


def array(values: np.ndarray, frequency: np.ndarray | None = None) -> xr.DataArray:
    """Transfer functions from (point, microphone, frequency) values."""
    points, microphones, count = values.shape
    grid = np.linspace(1.0, 100.0, count) if frequency is None else frequency
    return xr.DataArray(
        values.astype(complex),
        dims=("point", "microphone", "frequency"),
        coords={"point": np.arange(1, points + 1), "microphone": list("ABCDEF"[:microphones]), "frequency": grid},
    )


def two_points(ratio: np.ndarray, frequency: np.ndarray | None = None) -> xr.DataArray:
    """Two points, two microphones; the ratio of the first point is 1, that of the second as given."""
    one = np.ones_like(ratio)
    return array(np.array([[one, one], [ratio, one]]), frequency)


random_arrays = st.integers(0, 10**6).map(
    lambda seed: array(
        np.exp(np.random.default_rng(seed).normal(size=(4, 3, 9)) * (1 + 2j * np.random.default_rng(seed).random()))
    )
)


def test_a_constant_ratio_gives_its_level_and_phase() -> None:
    found = separability(two_points(np.full(50, 0.5 * np.exp(-0.3j))))
    assert found.level[0, 1] == pytest.approx(20 * np.log10(2), rel=1e-12)
    assert found.phase[0, 1] == pytest.approx(np.degrees(0.3), rel=1e-12)
    assert found.combined[0, 1] == pytest.approx(abs(np.log(0.5 * np.exp(-0.3j))), rel=1e-12)
    assert found.between(1, 2) == found.between(2, 1)


def test_phase_is_the_short_way_round() -> None:
    found = separability(two_points(np.full(50, np.exp(1j * np.radians(350.0)))))
    assert found.phase[0, 1] == pytest.approx(10.0, rel=1e-9)
    assert found.level[0, 1] == pytest.approx(0.0, abs=1e-12)


def test_the_mean_is_over_frequency_not_over_the_places_of_the_grid() -> None:
    # level in nepers rises as f: rms of f over 1 to 100 is sqrt((100^3 - 1) / (3 * 99))
    grid = np.concatenate([np.linspace(1, 20, 2000), np.linspace(20, 100, 900)[1:]])
    found = separability(two_points(np.exp(1e-3 * grid), grid))
    assert found.level[0, 1] == pytest.approx(DECIBEL * 1e-3 * np.sqrt((1e6 - 1) / (3 * 99)), rel=1e-5)


def test_frequencies_outside_the_band_do_not_count() -> None:
    grid = np.arange(1.0, 501.0)
    ratio = np.where(grid <= 100, 0.9, 1e-4)
    assert separability(two_points(ratio, grid)).level[0, 1] == pytest.approx(-20 * np.log10(0.9), rel=1e-9)


def test_distances_of_several_microphone_pairs_are_joined_by_rms() -> None:
    one = np.ones(20)
    h = array(np.array([[one, one, one], [2 * one, one, one]]))
    # ratios AB, AC, BC of the second point: 2, 2, 1
    assert separability(h).level[0, 1] == pytest.approx(20 * np.log10(2) * np.sqrt(2 / 3), rel=1e-12)


@given(random_arrays)
def test_distances_are_a_metric(h: xr.DataArray) -> None:
    found = separability(h)
    for d in (found.level, found.phase, found.combined):
        assert np.array_equal(d, d.T)
        assert np.all(np.diag(d) == 0)
        assert np.all(d[:, None, :] <= d[:, :, None] + d[None, :, :] + 1e-9)


@given(random_arrays, st.integers(0, 10**6))
def test_distances_do_not_depend_on_the_touch(h: xr.DataArray, seed: int) -> None:
    touch = np.exp(np.random.default_rng(seed).normal(size=(4, 1, 9)) * (1 + 1j))
    assert np.allclose(separability(h * touch).combined, separability(h).combined, rtol=1e-9, atol=1e-9)


def test_the_hardest_pair_comes_first_and_its_equals_are_named() -> None:
    place = np.array([0.0, 1.0, 2.5, 3.5])[:, None] * np.ones(10)
    found = separability(array(np.stack([np.exp(place), np.ones_like(place)], axis=1)))
    assert found.hardest_pairs[0] == (1, 2)
    assert found.equally_hard == ((1, 2), (3, 4))
    assert found.nearest(3) == 4
    assert found.between(2, 3)[2] == pytest.approx(1.5)


@pytest.mark.parametrize(
    ("shape", "lacking"), [((1, 2, 5), "1 point"), ((3, 1, 5), "1 microphone"), ((3, 2, 1), "1 frequency")]
)
def test_too_little_to_compare_is_refused(shape: tuple[int, int, int], lacking: str) -> None:
    with refused(Kind.UNSUITABLE, "transfer_function") as found:
        separability(array(np.ones(shape)))
    assert lacking in str(found.value)


def test_disagreement_names_where_it_is_largest() -> None:
    reference = array(np.ones((3, 2, 5)))
    changed = reference.copy(deep=True)
    changed[2, 1, 3] *= 1.02
    changed[0, 0, 1] *= np.exp(-1j * np.radians(3))
    found = disagreement(changed, reference)
    assert (found.magnitude, found.phase) == (pytest.approx(0.02), pytest.approx(3.0))
    assert found.magnitude_at == (3, "B", 75.25)
    assert found.phase_at == (1, "A", 25.75)
    with refused(Kind.MISMATCH, "reference"):
        disagreement(changed, reference[..., 1:])


def test_levels_are_those_of_the_transfer_function_and_joined_by_straight_lines() -> None:
    h = array(np.array([[[1.0, 0.1], [0.5, 0.5]], [[1.0, 0.2], [0.1, 0.01]]]), np.array([1.0, 100.0]))
    assert attenuation(h, 100.0) == pytest.approx(np.array([[-20.0, -6.0206], [-13.9794, -40.0]]), abs=1e-4)
    assert attenuation(h, 50.5)[0, 0] == pytest.approx(20 * np.log10(0.55))
    assert worst_heard(h, 100.0) == (pytest.approx(-40.0), 2)
    with refused(Kind.OUT_OF_RANGE, "frequency", 101.0):
        attenuation(h, 101.0)


def test_a_symmetric_line_has_mirror_images_as_equally_hard_pairs() -> None:
    library = acoustic_fem.solve(geometry.prototype("array-2x6"), np.linspace(1, 100, 64), fidelity="lumped")
    found = separability(library.transfer_function)
    (first, second), mirror = found.equally_hard
    assert mirror == (13 - second, 13 - first)
    assert np.allclose(found.combined, found.combined[::-1, ::-1], rtol=1e-9)
    assert microphone_ratios(library.transfer_function).shape == (12, 1, 64)


def test_sensitivity_at_low_frequency_is_that_of_the_sealed_volume() -> None:
    """The volume a touch sweeps compresses all air and lifts all other membranes: p = q / sum of compliances."""
    from acoustic_fem.membrane.design_discs import design_compliance

    design = geometry.prototype("array-2x6").with_values({"materials.soft": SOFT, "membrane.material": "soft"})
    library = acoustic_fem.solve(design, [0.01, 0.02], fidelity="lumped")
    tube, microphone = design.tube, design.microphone
    bore = np.pi / 4 * tube.inner_diameter**2
    hole = np.pi / 4 * microphone.sound_hole_diameter**2 * microphone.sound_hole_length
    air = 12 * design.resonator.cavity_volume + 13 * tube.length * bore
    air += 2 * (microphone.chamber_volume + hole + microphone.back_volume)
    total = air * 1e-9 / library.medium.pressure + 12 * design_compliance(design, 0.01).real
    assert sensitivity(library, 0.01) == pytest.approx(np.full(12, 1e-9 / total), rel=2e-3)


#: Without loss, so that compliances are real and add up.
SOFT = {"youngs_modulus": 1.0, "poisson_ratio": 0.49, "density": 1070.0, "loss_factor": 0.0, "source": "a test"}


# -- metrics by name ----------------------------------------------------------------------------------
GRID = np.linspace(1.0, 100.0, 32)


@pytest.fixture(scope="module")
def glove() -> acoustic_fem.Library:
    return acoustic_fem.solve(geometry.prototype("glove"), GRID, "lumped")


def test_every_metric_has_a_unit_a_definition_and_a_value(glove: acoustic_fem.Library) -> None:
    for name, metric in METRICS.items():
        assert metric.name == name
        assert metric.unit
        assert metric.definition.endswith(".")
        assert metric.better in ("larger", "smaller")
        assert np.isfinite(metric.of_library(glove)), name


@pytest.mark.slow
def test_a_design_has_the_same_metrics_in_any_batch() -> None:
    """Each metric at once for three designs and alone for each; to rounding, for sums are taken in other orders."""
    base = geometry.prototype("array-2x6").with_values({"lines.0.points": 4})
    changes = [{}, {"resonator.cavity_height": 4.0}, {"tube.length": 20.0, "membrane.thickness": 0.6}]
    libraries = [acoustic_fem.solve(base.with_values(change), GRID, "lumped") for change in changes]
    alone = [Responses.of_library(library) for library in libraries]
    fields = ("transfer_function", "source_response", "point_impedance", "microphone_impedance")
    batch = Responses(
        frequency=GRID,
        designs=[library.design for library in libraries],
        medium=[library.medium for library in libraries],
        **{name: np.concatenate([getattr(one, name) for one in alone]) for name in fields},
    )
    for name, metric in METRICS.items():
        expected = [float(metric.of_batch(one)[0]) for one in alone]
        assert metric.of_batch(batch) == pytest.approx(expected, rel=1e-10, abs=0), name


@given(random_arrays)
def test_distances_are_those_of_their_definition(h: xr.DataArray) -> None:
    ratio, weight = microphone_ratios(h), trapezoidal_weights(h["frequency"].values)
    found = separability(h)
    for i, j in combinations(range(4), 2):
        change = ratio[i] / ratio[j]
        level = np.sqrt(((20 * np.log10(np.abs(change))) ** 2 @ weight).mean())
        phase = np.sqrt((np.degrees(np.angle(change)) ** 2 @ weight).mean())
        assert np.allclose(found.between(i + 1, j + 1)[:2], (level, phase), rtol=1e-9, atol=1e-9)
    assert np.array_equal(found.level, found.level.T)
    batch = pair_distances(Responses(h["frequency"].values, np.stack([h.values, h.values])))
    assert np.allclose(batch.level[1], found.level[np.triu_indices(4, 1)], rtol=1e-12, atol=0)


def test_what_several_metrics_share_is_computed_once(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[str] = []
    for name in ("array_size", "pair_distances", "predict_confusions", "touch_response", "volumes_of"):
        own = getattr(shared, name)
        monkeypatch.setattr(shared, name, partial(lambda *given, _own, _name: (asked.append(_name), _own(*given))[1],
                                                  _own=own, _name=name))  # fmt: skip
    responses = Responses.of_library(acoustic_fem.solve(geometry.prototype("array-2x6"), GRID, "lumped"))
    figures = SharedFigures(responses, (level for metric in METRICS.values() for level in metric.noise_levels))
    for metric in METRICS.values():
        if metric.name != "scattered_top1":
            metric.of_batch(responses, figures)
    assert sorted(asked) == [
        "array_size",
        *["pair_distances"] * 2,
        "predict_confusions",
        *["touch_response"] * 2,
        "volumes_of",
    ]


def test_sensitivities_are_those_of_the_touch_response(glove: acoustic_fem.Library) -> None:
    weight = trapezoidal_weights(GRID)
    for name, touch, unit in (("force", "force", 1.0), ("displacement", "displacement", 1e-6)):
        power = np.abs(glove.touch_response(touch).values) ** 2 @ weight
        expected = unit * np.sqrt(power.max(axis=1).min())
        assert METRICS[f"sensitivity_{name}"].of_library(glove) == pytest.approx(expected, rel=1e-9, abs=0)
    assert glove.force_response.values[None] == pytest.approx(
        touch_response(Responses.of_library(glove), "force"), rel=1e-9
    )


def test_noise_equivalent_force_is_the_detection_limit_of_the_deafest_point(glove: acoustic_fem.Library) -> None:
    expected = float(detection_limits(glove, (1.0, 100.0))["force"].max())
    assert METRICS["noise_equivalent_force"].of_library(glove) == pytest.approx(expected, rel=1e-9, abs=0)


def test_bandwidth_of_a_low_pass_and_of_a_resonance() -> None:
    library = acoustic_fem.solve(geometry.prototype("array-2x6"), np.linspace(1, 100, 397), "lumped")
    own = Responses.of_library(library)
    grid = own.frequency

    def shaped(response: np.ndarray) -> Responses:
        """With this pressure per force at every point."""
        source = own.source_response * (response / touch_response(own, "force"))
        return replace(own, source_response=source)

    low_pass = METRICS["bandwidth"].of_batch(shaped(1 / (1 + 1j * grid / 20)))[0]
    assert low_pass == pytest.approx(np.sqrt(20**2 + 2) - 1, rel=1e-3)
    resonance = METRICS["bandwidth"].of_batch(shaped(1 / (1 + 1j * 4 * (grid / 40 - 40 / grid))))[0]
    assert resonance == pytest.approx(40 / 4, rel=1e-3)  # f0 / Q
    assert METRICS["bandwidth"].of_batch(shaped(np.ones_like(grid)))[0] == pytest.approx(99)


def test_parts_have_the_volume_of_their_solids() -> None:
    design = geometry.prototype("array-2x6").with_values({"lines.0.points": 3})
    parts = geometry.build_parts(design)
    solids = {name: parts[name].val().Volume() * count for name, count in parts.counts.items()}
    drawn = sum(volume for name, volume in solids.items() if not name.startswith("mold"))
    tubes = sum(volumes_of(design)[name][0] for name in ("wire", "sheath"))
    # sockets are counted as straight cylinders in a flat wall
    assert build.volume(design) - tubes == pytest.approx(drawn, rel=0.025)


def test_length_width_and_height_are_the_size_of_the_array_whichever_way_it_lies() -> None:
    design = geometry.prototype("glove")
    x, y, z = array_size(design)
    responses = Responses(np.array([1.0]), np.ones((1, 15, 3, 1), complex), designs=(design,))
    values = [metric.of_batch(responses)[0] for metric in metrics_named(("length", "width", "height"))]
    assert values == [max(x, y), min(x, y), z]


def test_mass_and_cost_add_up_and_the_wall_is_the_thinnest() -> None:
    design = geometry.prototype("array-2x6")
    heavier = design.with_values({"resonator.wall_thickness": 3.0})
    resin = build.volume(heavier) - build.volume(design)
    assert build.mass(heavier) - build.mass(design) == pytest.approx(resin * 1180e-6, rel=1e-9)
    price = Waste().resin_factor * catalogue().resin(design).part.price
    assert build.cost(heavier) - build.cost(design) == pytest.approx(resin * 1e-3 * price, rel=1e-9)
    assert build.smallest_wall(design.with_values({"resonator.floor_thickness": 0.35})) == pytest.approx(0.35)
    # the seat of the board begins close below the socket, outside the wall of the chamber
    seat = {"microphone.chamber_height": 2.18, "microphone.wall_thickness": 2.0, "microphone_tube.outer_diameter": 1.62}
    assert build.smallest_wall(design.with_values(seat)) == pytest.approx(0.1)


@pytest.mark.parametrize("name", ["array-2x6", "glove"])
def test_the_cost_is_that_of_the_bill_of_materials(name: str) -> None:
    design = geometry.prototype(name)
    assert build.cost(design) == pytest.approx(bill_of_materials(design).cost, rel=5e-3)


def test_distances_below_20_hz_are_those_of_that_part_of_the_grid() -> None:
    design = geometry.prototype("array-2x6")
    grid = np.linspace(1, 20, 20)
    low = acoustic_fem.solve(design, grid, "lumped")
    whole = acoustic_fem.solve(design, np.append(grid, np.arange(25.0, 101.0, 5.0)), "lumped")
    for extent in ("smallest", "mean"):
        below = METRICS[f"distance_{extent}_low"].of_library(whole)
        assert below == pytest.approx(METRICS[f"distance_{extent}_low"].of_library(low), rel=1e-6)
        assert below != pytest.approx(METRICS[f"distance_{extent}"].of_library(whole), rel=1e-2)


@pytest.mark.parametrize(
    ("frequency", "not_covered", "allowed"),
    [
        (np.linspace(5, 50, 10), "distance_smallest", "bandwidth"),
        (np.linspace(1, 50, 50), "sensitivity_force", "distance_mean_low"),
        (np.linspace(2, 100, 50), "distance_mean_low", "volume"),
        (np.linspace(90, 100, 2), "ipd_mean", "mass"),
        (np.array([1.0, 100.0]), "noise_equivalent_force", "cost"),
        (np.array([1.0, 2.0, 3.0, 150.0]), "ild_mean", "height"),
        (np.linspace(1, 100, 11), "distance_smallest_low", "distance_smallest"),
        (np.linspace(0.5, 400, 500), "", "predicted_top1_white_noise"),
    ],
)
def test_a_grid_that_does_not_cover_the_band_of_a_metric_is_refused(
    frequency: np.ndarray, not_covered: str, allowed: str
) -> None:
    library = acoustic_fem.solve(
        geometry.prototype("array-2x6").with_values({"lines.0.points": 3}), frequency, "lumped"
    )
    assert np.isfinite(METRICS[allowed].of_library(library))
    if not_covered:
        with refused(Kind.UNSUITABLE, "frequency") as found:
            METRICS[not_covered].of_library(library)
        assert not_covered in str(found.value)


def test_every_metric_that_names_a_band_in_its_definition_has_it() -> None:
    for metric in METRICS.values():
        if "1 to 100 Hz" in metric.definition:
            assert metric.band == (1.0, 100.0), metric.name
        if "1 to 20 Hz" in metric.definition:
            assert metric.band == (1.0, 20.0), metric.name


def test_unknown_metrics_and_missing_responses_are_refused_by_name() -> None:
    with refused(Kind.UNKNOWN, "metrics", "predicted_top"):
        metrics_named(["ild_mean", "predicted_top"])
    assert [metric.name for metric in metrics_named(["mass", "bandwidth"])] == ["mass", "bandwidth"]
    bare = Responses(GRID, np.ones((1, 3, 2, 32), complex))
    with refused(Kind.MISSING, "responses"):
        METRICS["noise_equivalent_force"].of_batch(bare)
    with refused(Kind.WRONG_TYPE, "source_response"):
        replace(bare, source_response=np.ones((1, 2, 2, 32), complex))


def test_predicted_accuracy_of_the_page_is_that_of_the_code_and_follows_trained_networks() -> None:
    """The stored accuracies of trained networks, and predictions made again for three of the designs."""
    rows = json.loads((Path(__file__).parents[3] / "docs" / "predicted_accuracy.json").read_text())
    assert len({(row["prototype"], str(row["values"])) for row in rows}) >= 8
    trained, predicted = (np.array([row[name] for row in rows]) for name in ("trained", "predicted_network"))
    assert np.ptp(trained) > 0.5
    assert np.corrcoef(trained, predicted)[0, 1] > 0.95
    assert np.sqrt(((trained - predicted) ** 2).mean()) < 0.07
    for row in rows[:3]:
        design = geometry.prototype(row["prototype"]).with_values(row["values"]).completed()
        # the networks were trained on membranes of constant loss and on smooth bores
        before = {"tube.bore": "smooth", "microphone_tube.bore": "smooth"}
        design = design.with_values({f"materials.{design.membrane.material}.law": "constant", **before})
        h = acoustic_fem.solve(design, np.linspace(1, 100, 64), "lumped").transfer_function.values[None]
        again = predict_confusion(h, np.linspace(1, 100, 64), row["noise"], touches=200).top1[0]
        assert again == pytest.approx(row["predicted_network"], abs=0.005)


def test_the_messages_of_metrics() -> None:
    bare = Responses(GRID, np.ones((1, 3, 2, 32), complex))
    flat = array(np.ones((3, 2, 5)))
    calls = {
        "metric unknown": lambda: metrics_named(["predicted_top"]),
        "response missing": lambda: METRICS["noise_equivalent_force"].of_batch(bare),
        "response of another shape": lambda: replace(bare, point_impedance=np.ones((1, 2, 32), complex)),
        "designs too few": lambda: replace(bare, designs=()),
        "grid too short": lambda: METRICS["ild_mean"].check_grid(np.linspace(1, 50, 50)),
        "grid too short for confusions": lambda: check_grid(np.linspace(2, 100, 50)),
        "one point": lambda: separability(array(np.ones((1, 2, 5)))),
        "other grids": lambda: disagreement(flat, flat[..., 1:]),
        "frequency outside": lambda: attenuation(flat, 101.0),
        "listener unknown": lambda: predict_confusion(np.ones((1, 2, 2, 32)), GRID, 0.01, listener="ear"),  # type: ignore[arg-type]
        "noise of another shape": lambda: predict_confusion(np.ones((1, 2, 2, 32)), GRID, np.ones((2, 500))),
    }
    check_messages(Path(__file__).parent / "messages.txt", calls)
