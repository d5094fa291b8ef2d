"""The predicted error under scatter: its definition, its slopes, and its ranking against touches on made sensors."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import scipy.special
import scipy.stats
from refusals import refused
from small_run import small_design

import acoustic_fem
import geometry
import localize
from acoustic_fem.batch.network import batch_transfer_function
from acoustic_fem.batch.parameters import ArrayParameters
from acoustic_fem.scatter.tolerances import UNCALIBRATED, ScatteredDesign
from geometry import Kind
from geometry.design.design_file import value_of
from localize.signals.array_response import response_of
from studies.metrics.scatter_detection import FREQUENCIES, UNKNOWN, scatter_detection, scatter_slopes
from studies.study.metric_registry import METRICS
from studies.test_rig.virtual_rig import HiddenScatter, Rig

EXAMPLES = Path(__file__).parents[3] / "docs" / "examples"
NAMES = ("tube.inner_diameter", "tube.length", "resonator.cavity_height", "membrane.thickness")


def test_numbers_of_a_batch_that_are_known_are_not_worked_out_again() -> None:
    dry, damp = small_design(), small_design().with_values({"air.humidity": 0.9, "tube.length": 20.0})
    designs = [dry, damp, dry.with_values({"tube.inner_diameter": 0.5})]
    expected = scatter_detection(designs)
    assert np.array_equal(scatter_detection(designs, parameters=ArrayParameters.from_designs(designs)), expected)
    other = ArrayParameters.from_designs([dry, dry, dry])  # taken for those of the designs
    assert scatter_detection(designs, parameters=other)[2] == pytest.approx(expected[0], rel=1e-12)


def test_it_is_the_error_of_the_nominal_decoder_to_first_order() -> None:
    """By hand for three points: a draw of one deviation at a time from the scatter that decoders assume."""
    design = small_design()
    known = {each.quantity: each for each in UNCALIBRATED}
    moved = ("bore", "cavity_height", "modulus_of_part", "modulus_of_batch", "chamber_height")
    scattered = ScatteredDesign(design, [known[name] for name in moved])
    sizes = {name: draw.shape[1] for name, draw in scattered.draws(0, 1, 0).items()}
    air = acoustic_fem.Medium.at(design.air.temperature, design.air.humidity, design.air.pressure)

    def response(quantity: str | None = None, part: int = 0) -> np.ndarray:
        draws = {name: np.zeros((1, size)) for name, size in sizes.items()}
        if quantity:
            draws[quantity][0, part] = 1.0
        parameters = scattered.parameters(draws)
        return batch_transfer_function(parameters, scattered.topology, FREQUENCIES, air)[0]

    h = response()
    ratio = h[:, 0] / h[:, 1]
    columns = [response(name, k) for name in moved for k in range(sizes[name])]
    jacobian = [np.log(each[:, 0] / each[:, 1] / ratio) for each in columns]
    jacobian += [sign * np.full(ratio.shape, known["microphone_gain"].deviation) for sign in (1, -1)]
    power = np.abs(h) ** 2
    weight = power[:, 0] * power[:, 1] / power.sum(1)
    error = np.zeros((3, 3))
    for i in range(3):
        for j in {0, 1, 2} - {i}:
            apart = np.log(ratio[j] / ratio[i])
            spread = sum((weight[i] * (apart.conj() * column[i]).real).sum() ** 2 for column in jacobian)
            spread += (weight[i] ** 2 * np.abs(apart) ** 2).sum() * UNKNOWN**2  # the microphone's noise is far below
            distance = (weight[i] * np.abs(apart) ** 2).sum() / math.sqrt(spread)
            error[i, j] = scipy.special.erfc(distance / math.sqrt(8)) / 2
    mean, worst = error.sum(1).mean(), (error**4).sum(1).mean() ** 0.25
    assert scatter_detection([design])[0] == pytest.approx((mean * worst**0.2) ** (1 / 1.2), rel=0.02)


def test_its_slopes_are_those_of_its_values() -> None:
    design = small_design()
    value, slopes = scatter_slopes(design, NAMES)
    assert value == pytest.approx(math.log(scatter_detection([design])[0]), rel=1e-9)
    for name, slope in zip(NAMES, slopes, strict=True):
        ends = [design.with_values({name: value_of(design, name) * factor}) for factor in (1.002, 0.998)]
        high, low = np.log(scatter_detection(ends))
        assert slope == pytest.approx((high - low) / 0.004, rel=0.02, abs=2e-3), name


def test_many_designs_have_what_each_has_alone() -> None:
    base = small_design()
    changes = {"tube.length": 14.0}, {"air.temperature": 35.0}, {"lines.0.points": 4, "layout.columns": 4}
    designs = [base, *(base.with_values(change) for change in changes), base.with_values({"membrane.thickness": 0.3})]
    together = scatter_detection(designs)
    assert len(set(together)) == len(designs)
    assert together == pytest.approx([scatter_detection([design])[0] for design in designs], rel=1e-10)


def test_a_further_point_costs_and_what_cannot_be_computed_is_refused() -> None:
    base = small_design()
    four = base.with_values({"lines.0.points": 4, "layout.columns": 4})
    plain, longer = scatter_detection([base, four])
    assert 0 < plain < longer < 1
    metric = METRICS["scatter_detection"]
    assert metric.better == "smaller"
    assert metric.of_library(acoustic_fem.solve(base, np.linspace(1, 100, 12), "lumped")) == plain
    with refused(Kind.UNSUITABLE, "lines.0.points", 1):
        scatter_detection([base.with_values({"lines.0.points": 1, "layout.columns": 1})])
    with refused(Kind.OUT_OF_RANGE, "resonator.shape", "box"):
        scatter_detection([base.with_values({"resonator.shape": "box"})])


@pytest.mark.slow
def test_it_ranks_designs_as_touches_on_made_sensors_do() -> None:
    both = (0.6, 12.5, 3.0, 1.0), (0.94, 9.35, 4.7, 1.66)
    chosen = [("line-36", cell) for cell in (*both, (0.45, 12.5, 3.0, 2.0), (0.995, 8.4, 5.88, 1.96))]
    chosen += [("ring-3x12", cell) for cell in (*both, (0.727, 26.75, 5.6, 1.124))]
    bases = {name: geometry.load_design(EXAMPLES / f"{name}.toml") for name, _ in chosen}
    designs = [bases[name].with_values(dict(zip(NAMES, cell, strict=True))) for name, cell in chosen]
    parts = HiddenScatter(
        gain=0.0, corner=0.0, chamber=0.0, length=0.0, loss=0.0, temperature=0.0, pressure=0.0, slope=0.0
    )
    right, grid = [], np.arange(1.0, 161.0)
    for design in designs:
        response = response_of(acoustic_fem.solve(design, grid, "lumped"))
        decoder = localize.BayesDecoder(response, 1e-3)
        shares = []
        for seed in range(8):
            made = replace(
                response, transfer_function=Rig(design, seed, parts, fidelity="lumped").transfer_function(grid)
            )
            shares.append(localize.evaluate(decoder, made, 4, 1e-3).top1)
        right.append(np.mean(shares))
    assert np.ptp(right) > 0.1
    assert scipy.stats.spearmanr(scatter_detection(designs), right).statistic < -0.75
