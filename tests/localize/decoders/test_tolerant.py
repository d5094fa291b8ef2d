"""The decoder of a sensor that nobody calibrated, beside that of a known one."""

from __future__ import annotations

import warnings
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import scipy.special
from refusals import refused
from rings import triangle

import acoustic_fem
import geometry
import localize
from acoustic_fem.library.transfer_functions import MEASURED
from acoustic_fem.scatter import AirAndRubber, ScatteredDesign, Tolerance, scatter_factors
from geometry import Kind
from localize.decoders import tolerant_decoder
from localize.decoders.decoder_options import HypothesisOptions, TolerantOptions
from localize.signals.array_response import response_of

GRID = np.arange(1.0, 201.0)
pytestmark = pytest.mark.filterwarnings("ignore:.*its library ends at 200 Hz")
NOISE, HEARD = 1e-3, 0.03
NO_SCATTER = (Tolerance("bore", 0.0, "relative", "a test"),)
ONE_AIR = TolerantOptions(hypotheses=HypothesisOptions(air_and_rubber=None))


@pytest.fixture(scope="module")
def library() -> acoustic_fem.Library:
    design = geometry.prototype("array-2x6").with_values({"lines.0.points": 4})
    return acoustic_fem.solve(design, GRID, "lumped")


@pytest.fixture(scope="module")
def decoder(library: acoustic_fem.Library) -> localize.TolerantDecoder:
    return localize.TolerantDecoder(library)


@pytest.fixture(scope="module")
def frames(library: acoustic_fem.Library) -> np.ndarray:
    touches = localize.TouchGenerator(response_of(library), 0, "evaluation", HEARD)
    return touches.samples(0, 40).signals[..., -250:].numpy()


def test_without_tolerances_it_is_the_decoder_of_the_library_at_its_own_temperature(
    library: acoustic_fem.Library, frames: np.ndarray
) -> None:
    exact = localize.TolerantDecoder(library, NO_SCATTER, HEARD, options=ONE_AIR)
    known = localize.BayesDecoder(library, HEARD).log_probability(frames)
    assert exact.locate(frames) == pytest.approx(
        scipy.special.softmax(known / TolerantOptions.relative_temperature, axis=1), abs=1e-3
    )  # of powers of the grid
    assert exact.locate(frames[3]) == pytest.approx(exact.locate(frames)[3], abs=1e-6)


def test_it_is_less_sure_of_frames_that_no_drawn_sensor_fits(library: acoustic_fem.Library, frames: np.ndarray) -> None:
    # of which the noise is thirty times what is told
    told = localize.TolerantDecoder(library, NO_SCATTER, NOISE, options=ONE_AIR).log_probability(frames)
    known = localize.BayesDecoder(library, NOISE).log_probability(frames) / TolerantOptions.relative_temperature
    ahead = [np.diff(np.sort(each, axis=1)[:, -2:], axis=1) for each in (told, known)]
    assert (told.argmax(1) == known.argmax(1)).all()
    assert (ahead[0] < ahead[1] / 10).all()


@pytest.mark.slow
def test_a_large_array_keeps_all_shapes_of_its_hypotheses() -> None:
    library = acoustic_fem.solve(geometry.prototype("large-area-64"), GRID, "lumped")
    few = TolerantOptions(hypotheses=HypothesisOptions(draws=40))
    assert localize.TolerantDecoder(library, options=few).shapes == few.hypotheses.shapes


def test_a_touch_is_no_surer_for_being_louder_than_its_hypotheses_are_good(
    library: acoustic_fem.Library, decoder: localize.TolerantDecoder
) -> None:
    touches = localize.TouchGenerator(response_of(library), 1, "evaluation", 0.0).samples(0, 8)
    frames = touches.signals[..., -250:].double().numpy()
    loud, louder, quiet = (decoder.log_likelihood(gain * frames) for gain in (3e3, 3e4, 0.03))
    assert loud == pytest.approx(louder, rel=1e-9)
    assert np.abs(quiet - loud).max() > 1


def test_its_hypotheses_repeat_and_their_priors_sum_to_one(
    library: acoustic_fem.Library, decoder: localize.TolerantDecoder, frames: np.ndarray
) -> None:
    assert np.exp(decoder.log_prior).sum(1) == pytest.approx(np.ones(library.design.point_count))
    assert (localize.TolerantDecoder(library).locate(frames) == decoder.locate(frames)).all()


def test_what_it_fits_to_a_frame_is_in_no_onnx_file(decoder: localize.TolerantDecoder, tmp_path: Path) -> None:
    with refused(Kind.UNSUITABLE, "localizer"):
        localize.export_onnx(decoder, tmp_path / "tolerant.onnx")
    assert not any(tmp_path.iterdir())


@pytest.mark.slow
@pytest.mark.physics
def test_it_names_touches_of_made_sensors_that_the_nominal_library_does_not_and_says_how_surely() -> None:
    library = acoustic_fem.solve(geometry.prototype("line-2").with_values({"lines.0.points": 20}), GRID, "lumped")
    response = response_of(library)
    scatter = [Tolerance(name, 0.06, "relative", "a test") for name in ("bore", "cavity_height", "modulus_of_part")]
    made = scatter_factors(ScatteredDesign(library.design, scatter), library.medium, GRID, 4, 5)
    judged = {}
    for who in (localize.BayesDecoder(library, NOISE), localize.TolerantDecoder(library, microphone_noise=NOISE)):
        sensors = [response, *(replace(response, transfer_function=response.transfer_function * k) for k in made)]
        judged[type(who).__name__] = [localize.evaluate(who, each, 20, NOISE) for each in sensors]
    nominal, tolerant = judged.values()
    assert tolerant[0].top1 > nominal[0].top1 - 0.01
    assert np.mean([each.top1 for each in tolerant[1:]]) > np.mean([each.top1 for each in nominal[1:]]) + 0.02
    errors = [[each.reliability.expected_error for each in found[1:]] for found in (nominal, tolerant)]
    assert np.mean(errors[1]) < 0.06 < np.mean(errors[0])


def test_a_measured_sensor_is_known_and_a_design_of_unknown_scatter_has_no_such_decoder(
    library: acoustic_fem.Library,
) -> None:
    dome = library.design.with_values({"resonator.shape": "dome"})
    for other in (replace(library, fidelity=MEASURED), replace(library, design=dome)):
        assert tolerant_decoder(other) is None
    assert type(tolerant_decoder(library)) is localize.TolerantDecoder


def test_a_measured_library_is_refused(library: acoustic_fem.Library) -> None:
    with refused(Kind.UNSUITABLE, "library"):
        localize.TolerantDecoder(replace(library, fidelity=MEASURED))


def test_bare_transfer_functions_are_refused(library: acoustic_fem.Library) -> None:
    with refused(Kind.UNSUITABLE, "library"):
        localize.TolerantDecoder(response_of(library))  # type: ignore[arg-type]


@pytest.mark.slow
def test_it_listens_to_some_of_the_microphones() -> None:
    library = acoustic_fem.solve(triangle(), np.arange(1.0, 201.0), "lumped")
    touches = localize.TouchGenerator(response_of(library), 3, "evaluation", NOISE).samples(0, 40)
    frames = touches.signals[:, :, 250:500].numpy()
    two = localize.TolerantDecoder(library, microphone_noise=NOISE, microphones=library.design.microphones[1:])
    assert two.microphones == library.design.microphones[1:]
    assert (two.locate(frames[:, 1:]).argmax(1) == touches.point.numpy() - 1).mean() > 0.9
    with refused(Kind.UNKNOWN, "microphones", "Z"):
        localize.TolerantDecoder(library, microphones=("A", "Z"))


@pytest.mark.physics
@pytest.mark.slow
def test_air_and_rubber_that_nobody_gave_cost_it_no_touches() -> None:
    design = geometry.prototype("array-2x6")
    library = acoustic_fem.solve(design, GRID, "lumped")
    # 2000 m above the sea, and a modulus that is the same at all frequencies
    elsewhere = AirAndRubber((79.5e3, 79.5e3), (20.0, 20.0), (0.0, 0.0), fraction=1.0)
    factor = scatter_factors(ScatteredDesign(design, NO_SCATTER), library.medium, GRID, 1, 0, air_and_rubber=elsewhere)[
        0
    ]
    response = response_of(library)
    sensor = replace(response, transfer_function=response.transfer_function * factor)
    fixed, drawn = (
        localize.evaluate(localize.TolerantDecoder(library, None, NOISE, options=each), sensor, 20, NOISE)
        for each in (ONE_AIR, TolerantOptions())
    )
    assert drawn.top1 > 0.98
    assert fixed.top1 < 0.95


@pytest.mark.slow
def test_a_line_so_long_that_nothing_arrives_has_a_decoder() -> None:
    """Transfer functions underflow to zero at 500 Hz, and were divided by."""
    narrow = {f"{tube}.{field}": value for tube in ("tube", "microphone_tube")
              for field, value in (("length", 500.0), ("inner_diameter", 0.06))}  # fmt: skip
    wide = {"resonator.cavity_diameter": 12.0, "resonator.cavity_height": 8.0, "lines.0.points": 24}
    design = geometry.prototype("line-2").with_values({**narrow, **wide})
    with warnings.catch_warnings():
        warnings.simplefilter("error", RuntimeWarning)
        long = acoustic_fem.solve(design, np.arange(1.0, 501.0), "lumped")
        assert (long.transfer_function == 0).any()
        decoder = localize.TolerantDecoder(long, options=TolerantOptions(hypotheses=HypothesisOptions(draws=30)))
        probability = decoder.locate(np.random.default_rng(0).normal(0, 0.01, (3, 2, 250)))
    assert probability.sum(1) == pytest.approx(1.0)
