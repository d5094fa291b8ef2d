"""Touches of another array, and a microphone that is far off its level, are told from a sensor as it is expected."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from refusals import refused

import acoustic_fem
import geometry
import localize
from acoustic_fem.library.transfer_functions import MEASURED
from acoustic_fem.scatter import ScatteredDesign, scatter_factors
from acoustic_fem.scatter.tolerances import UNCALIBRATED
from geometry import Kind
from localize import Decision
from localize.evaluation.goodness_of_fit import FitOptions, LoudFrames, sensor_fit
from localize.signals.array_response import ArrayResponse, response_of

GRID = np.arange(1.0, 201.0)
NOISE = 1e-3
pytestmark = pytest.mark.filterwarnings("ignore:.*its library ends at 200 Hz")


@pytest.fixture(scope="module")
def library() -> acoustic_fem.Library:
    return acoustic_fem.solve(geometry.prototype("array-2x6").with_values({"lines.0.points": 4}), GRID, "lumped")


@pytest.fixture(scope="module")
def decoder(library: acoustic_fem.Library) -> localize.TolerantDecoder:
    return localize.TolerantDecoder(library, None, NOISE)


@pytest.fixture(scope="module")
def made(library: acoustic_fem.Library) -> ArrayResponse:
    """A sensor as it came out."""
    response = response_of(library)
    factor = scatter_factors(ScatteredDesign(library.design, UNCALIBRATED), library.medium, GRID, 1, 7)[0]
    return replace(response, transfer_function=response.transfer_function * factor)


def heard(response: ArrayResponse, noise: float = NOISE) -> np.ndarray:
    """Loud frames of touches."""
    touches = localize.TouchGenerator(response, 3, "evaluation", noise).samples(0, 24)
    return touches.signals[..., -250:].numpy()


def test_a_sensor_within_its_tolerances_is_not_doubted(decoder: localize.TolerantDecoder, made: ArrayResponse) -> None:
    fit = sensor_fit(decoder, heard(made))
    assert fit is not None
    assert (fit.warning, fit.off_level) == (None, None)
    assert 0.5 < fit.misfit < fit.expected


def test_touches_of_another_array_are_told(decoder: localize.TolerantDecoder) -> None:
    other = acoustic_fem.solve(geometry.prototype("line-2").with_values({"lines.0.points": 12}), GRID, "lumped")
    fit = sensor_fit(decoder, heard(response_of(other)))
    assert fit is not None
    assert fit.warning is not None
    assert "the library may be one of another array" in fit.warning


@pytest.mark.parametrize(("microphone", "level"), [(0, -12.0), (1, 9.0)])
def test_a_microphone_far_off_its_level_is_told_and_by_how_much(
    decoder: localize.TolerantDecoder, made: ArrayResponse, microphone: int, level: float
) -> None:
    frames = heard(made)
    frames[:, microphone] *= 10 ** (level / 20)
    fit = sensor_fit(decoder, frames)
    assert fit is not None
    assert fit.off_level is not None
    name, found = fit.off_level
    # of two microphones only the difference is known
    assert found if name == decoder.microphones[microphone] else -found == pytest.approx(level, abs=1.5)
    assert fit.warning is not None
    assert f"{abs(found):.0f} dB" in fit.warning


def test_noise_that_is_louder_than_told_is_no_misfit_once_it_is_measured(
    decoder: localize.TolerantDecoder, made: ArrayResponse
) -> None:
    loud = 5 * NOISE
    frames = heard(made, loud)
    told, measured = sensor_fit(decoder, frames), sensor_fit(decoder, frames, [loud, loud])
    assert told is not None
    assert measured is not None
    assert measured.warning is None
    assert told.misfit > 2 * measured.misfit
    other = acoustic_fem.solve(geometry.prototype("line-2").with_values({"lines.0.points": 12}), GRID, "lumped")
    elsewhere = sensor_fit(decoder, heard(response_of(other), loud), [loud, loud])
    assert elsewhere is not None
    assert elsewhere.misfit > 2 * measured.misfit
    with refused(Kind.WRONG_TYPE, "microphone_noise"):
        sensor_fit(decoder, frames, [loud, loud, loud])


def test_nothing_is_said_of_few_touches_or_of_a_design_without_tolerances(
    library: acoustic_fem.Library, decoder: localize.TolerantDecoder, made: ArrayResponse
) -> None:
    frames = heard(made)
    assert sensor_fit(decoder, frames[: FitOptions.fewest - 1]) is None
    assert sensor_fit(localize.BayesDecoder(library, NOISE), frames) is None


def test_a_calibrated_sensor_fits_its_library_and_a_softer_one_does_not(
    library: acoustic_fem.Library, made: ArrayResponse
) -> None:
    measured = replace(made, provenance={**made.provenance, "fidelity": MEASURED})
    known = localize.BayesDecoder(measured, NOISE)
    fit = sensor_fit(known, heard(made))
    assert fit is not None
    assert fit.warning is None
    assert 0.8 < fit.misfit < fit.expected
    changed = sensor_fit(known, heard(response_of(library)))
    assert changed is not None
    assert changed.warning is not None


def test_the_loudest_frames_are_kept_and_none_overlap() -> None:
    random, loud = np.random.default_rng(0), LoudFrames()
    events = [
        Decision(
            0.016 * k, "touch" if k % 7 else "no touch", float(random.uniform()), 1, 1.0, frame=np.full((2, 250), k)
        )
        for k in range(2000)
    ]
    for first in range(0, 2000, 100):
        loud.take([*events[first : first + 100], "anything else"])
    numbers = sorted(int(frame[0, 0]) for frame in loud.frames)
    assert len(numbers) == FitOptions.most
    assert np.diff(numbers).min() * 0.016 >= 0.25
    assert all(number % 7 for number in numbers)
    assert max(events, key=lambda event: event.level if event.state == "touch" else 0.0).time == pytest.approx(
        0.016 * max(numbers, key=lambda number: events[number].level)
    )
