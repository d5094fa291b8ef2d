"""As-built sensors with an air and a slope of the rubber's modulus of their own."""

from dataclasses import replace

import numpy as np
import pytest
from refusals import refused

import acoustic_fem
import geometry
from acoustic_fem.batch.elements import membrane_modulus
from acoustic_fem.batch.parameters import ArrayParameters
from acoustic_fem.quantities.local_air import design_air
from acoustic_fem.scatter import (
    SEALED_AIR_AND_RUBBER,
    AirAndRubber,
    DrawnAirAndRubber,
    ScatteredDesign,
    Tolerance,
    scatter_factors,
)
from acoustic_fem.scatter.air_and_rubber import MIDDLE
from geometry import Kind

DESIGN = geometry.prototype("array-2x6").with_values({"lines.0.points": 4})
GRID = np.array([5.0, 50.0, 200.0])


@pytest.fixture(scope="module")
def scattered() -> ScatteredDesign:
    return ScatteredDesign(DESIGN)


def factors(scattered: ScatteredDesign, count: int, air_and_rubber: AirAndRubber | None, **more: float) -> np.ndarray:
    return scatter_factors(scattered, design_air(DESIGN), GRID, count, 3, air_and_rubber=air_and_rubber, **more)


def drawn(slope: float, count: int = 1) -> DrawnAirAndRubber:
    ranges = AirAndRubber(slope=(slope, slope), fraction=1.0)
    return ranges.draws(0, count, 0, DESIGN, design_air(DESIGN))


def test_a_sensor_in_other_air_is_the_design_solved_in_that_air(scattered: ScatteredDesign) -> None:
    place = AirAndRubber(pressure=(80e3, 80e3), temperature_c=(8.0, 8.0), slope=(1.0, 1.0), fraction=1.0)
    there = DESIGN.with_values({"air.pressure": 80e3, "air.temperature": 8.0})
    solved = [acoustic_fem.solve(each, GRID, "lumped").transfer_function.values for each in (there, DESIGN)]
    found = factors(scattered, 1, place, fraction=0.0)[0]
    assert np.abs(found - 1).max() > 0.05
    # the microphone's diaphragm and vent stay those of the design's air
    assert found == pytest.approx(solved[0] / solved[1], rel=1e-3)


@pytest.mark.parametrize("slope", [0.0, 2.0])
def test_a_slope_turns_the_modulus_about_its_middle(scattered: ScatteredDesign, slope: float) -> None:
    grid = MIDDLE * np.array([0.1, 1.0, 10.0])

    def stiffness(parameters: ArrayParameters) -> np.ndarray:
        return np.abs(membrane_modulus(parameters, grid))[0, 0] / parameters.membrane_compliance[0, 0]

    found = stiffness(drawn(slope).changed(scattered.nominal)) / stiffness(scattered.nominal)
    exponent = 2 / np.pi * np.arctan(DESIGN.material(DESIGN.membrane.material).loss_factor or 0.0)
    assert exponent > 0.01
    assert found == pytest.approx((grid / MIDDLE) ** (exponent * (slope - 1)), rel=1e-9)
    # the modes rise with the root of the stiffness
    modes = drawn(slope).changed(scattered.nominal).membrane_frequency / scattered.nominal.membrane_frequency
    stiffer = drawn(slope).changed(scattered.nominal).membrane_compliance / scattered.nominal.membrane_compliance
    assert modes[0, 0] == pytest.approx(1 / np.sqrt(stiffer[0, 0]), rel=1e-12)


def test_a_table_of_relaxations_without_slope_is_as_stiff_at_all_frequencies(scattered: ScatteredDesign) -> None:
    points = scattered.nominal.membrane_compliance.shape[1]
    relaxing = replace(
        scattered.nominal,
        membrane_slope=np.zeros((1, points)),
        membrane_loss=np.zeros((1, points)),
        membrane_relaxation=np.full((1, points, 1), 0.3),
        membrane_relaxation_time=np.full((1, points, 1), 1 / (2 * np.pi * MIDDLE)),
    )
    grid = np.array([0.1, MIDDLE, 1e3])
    flat = drawn(0.0).changed(relaxing)
    stiffness = np.abs(membrane_modulus(flat, grid))[0, 0] / flat.membrane_compliance[0, 0]
    at_middle = np.abs(membrane_modulus(relaxing, grid))[0, 0, 1] / relaxing.membrane_compliance[0, 0]
    assert stiffness == pytest.approx(at_middle, rel=1e-12)


def test_the_stated_fraction_of_the_sensors_is_varied_and_the_others_stay(scattered: ScatteredDesign) -> None:
    varied, kept = factors(scattered, 9, AirAndRubber(fraction=1 / 3)), factors(scattered, 9, None)
    same = np.isclose(varied, kept, rtol=1e-9).all((1, 2, 3))
    assert same.sum() == 6
    assert factors(scattered, 2, AirAndRubber(fraction=0.0)) == pytest.approx(kept[:2], rel=1e-9)


def test_a_sensor_is_the_same_whatever_is_drawn_with_it(scattered: ScatteredDesign) -> None:
    ranges = AirAndRubber()
    later = factors(scattered, 2, ranges, first=3)
    assert factors(scattered, 5, ranges)[3:] == pytest.approx(later, rel=1e-12)
    assert not np.allclose(later, factors(scattered, 2, None, first=3), rtol=1e-3)


def test_values_lie_within_their_ranges() -> None:
    ranges = AirAndRubber(fraction=1.0)
    found = ranges.draws(0, 200, 1, DESIGN, design_air(DESIGN))
    for values, (low, high) in ((found.medium.pressure, ranges.pressure), (found.slope, ranges.slope)):
        assert low < values.min() < low + 0.1 * (high - low)
        assert high - 0.1 * (high - low) < values.max() < high


def test_membranes_are_stiffened_together_and_evenly_in_the_logarithm(scattered: ScatteredDesign) -> None:
    one = AirAndRubber(slope=(1.0, 1.0), stiffening=(1.6, 1.6), fraction=1.0)
    after = one.draws(0, 1, 0, DESIGN, design_air(DESIGN)).changed(scattered.nominal)
    assert after.membrane_compliance == pytest.approx(scattered.nominal.membrane_compliance / 1.6)
    assert after.membrane_frequency == pytest.approx(scattered.nominal.membrane_frequency * np.sqrt(1.6))
    many = SEALED_AIR_AND_RUBBER.draws(0, 1000, 1, DESIGN, design_air(DESIGN)).stiffening
    own = np.log(many[many != 1]) / np.log(2)
    assert len(own) == 400
    assert 0 < own.min() < 0.02
    assert 0.98 < own.max() < 1
    assert own.mean() == pytest.approx(0.5, abs=0.05)
    with refused(Kind.OUT_OF_RANGE, "air_and_rubber.stiffening"):
        AirAndRubber(stiffening=(0.1, 1.0))


@pytest.mark.parametrize("changed", [{"membrane.thickness": 0.55}, {"membrane.thickness": 0.45}, {}])
@pytest.mark.slow
def test_bulged_membranes_that_scatter_are_those_of_a_changed_design(changed: dict[str, float]) -> None:
    bulged = DESIGN.with_values({"air.overpressure": 2000.0})
    scattered = ScatteredDesign(bulged, (Tolerance("membrane_thickness", 0.05, "absolute", "a test"),))
    steps = (changed.get("membrane.thickness", 0.5) - 0.5) / 0.05
    found = scattered.parameters({"membrane_thickness": np.full((1, 4), steps)})
    exact = ArrayParameters.from_design(bulged.with_values(changed))
    assert found.membrane_compliance == pytest.approx(np.full((1, 4), exact.membrane_compliance[0, 0]), rel=0.01)
    flat = ArrayParameters.from_design(DESIGN.with_values(changed))
    assert exact.membrane_compliance[0, 0] < 0.85 * flat.membrane_compliance[0, 0]


@pytest.mark.parametrize(
    ("tolerance", "field", "steps"),
    [
        (Tolerance("prestrain", 0.001, "absolute", "a test"), "prestrain", 0.001),
        (Tolerance("glue_thickness", 0.02, "absolute", "a test"), "glue_thickness", 0.02),
        (Tolerance("glue_thickness", 0.2, "relative", "a test"), "glue_thickness", 0.02),
    ],
)
def test_strain_and_glue_that_scatter_are_those_of_a_changed_design(
    tolerance: Tolerance, field: str, steps: float
) -> None:
    glued = DESIGN.with_values({"membrane.prestrain": 0.002, "membrane.glue_thickness": 0.1})
    scattered = ScatteredDesign(glued, (tolerance,))
    drawn = np.array([[-1.5, 0.0, 1.0, 2.5]])
    found = scattered.parameters({field: drawn})
    nominal = getattr(glued.membrane, field)
    for point, draw in enumerate(drawn[0]):
        exact = ArrayParameters.from_design(glued.with_values({f"membrane.{field}": nominal + draw * steps}))
        assert found.membrane_compliance[0, point] == pytest.approx(exact.membrane_compliance[0, 0], rel=1e-3)
        assert found.membrane_frequency[0, point] == pytest.approx(exact.membrane_frequency[0, 0], rel=1e-3)


def test_ranges_that_descend_or_leave_what_air_may_have_are_refused() -> None:
    with refused(Kind.OUT_OF_RANGE, "air_and_rubber.slope"):
        AirAndRubber(slope=(2.0, 1.0))
    with refused(Kind.OUT_OF_RANGE, "air_and_rubber.pressure"):
        AirAndRubber(pressure=(1e3, 1e5))
    with refused(Kind.OUT_OF_RANGE, "air_and_rubber.fraction"):
        AirAndRubber(fraction=1.5)
