"""Touches of another array, and a microphone that is far off its level, are told from a sensor as it is expected."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from refusals import refused

import acoustic_fem
import geometry
import localize
from acoustic_fem.library.transfer_functions import MEASURED, measured_library
from acoustic_fem.scatter import ScatteredDesign, scatter_factors
from acoustic_fem.scatter.tolerances import UNCALIBRATED
from geometry import Kind
from localize import Decision
from localize.decoders.decoder_options import DecoderOptions
from localize.evaluation.connection_faults import ConnectionFault, earlier
from localize.evaluation.goodness_of_fit import FAULTY_TRUST, MARGIN, FitOptions, LoudFrames, SensorFit, sensor_fit
from localize.signals.array_response import ArrayResponse, response_of
from localize.signals.frames import FRAME

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
    assert (fit.warning, fit.fault, fit.trust) == (None, None, 1.0)
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
    assert fit.fault is not None
    assert fit.fault.kind == "level"
    # of two microphones only the difference is known
    own = fit.fault.microphones == (decoder.microphones[microphone],)
    assert (fit.fault.amount if own else -fit.fault.amount) == pytest.approx(level, abs=1.5)
    assert fit.warning is not None
    assert f"{abs(fit.fault.amount):.0f} dB" in fit.warning
    assert (fit.trust <= FAULTY_TRUST, fit.trust_of(fit.fault)) == (True, 1.0)
    again = sensor_fit(decoder, fit.fault.corrected(frames, decoder.microphones))
    assert again is not None
    assert again.fault is None


def with_margins(response: ArrayResponse) -> np.ndarray:
    """Loud frames of touches with the samples before and after."""
    touches = localize.TouchGenerator(response, 3, "evaluation", NOISE).samples(0, 24)
    return touches.signals[..., -FRAME - 2 * MARGIN :].numpy()


@pytest.mark.parametrize(
    "fault",
    [
        ConnectionFault("reversed", ("A",)),
        ConnectionFault("late", ("A",), 0.02),
        ConnectionFault("late", ("A",), -0.0075),
    ],
    ids=str,
)
@pytest.mark.slow
def test_a_fault_of_the_connection_is_found_without_a_calibration(
    decoder: localize.TolerantDecoder, made: ArrayResponse, fault: ConnectionFault
) -> None:
    names = decoder.microphones
    frames = replace(fault, amount=-fault.amount).corrected(with_margins(made), names)
    fit = sensor_fit(decoder, frames)
    assert fit is not None
    assert fit.fault is not None
    assert (fit.fault.kind, fit.fault.microphones) == (fault.kind, fault.microphones)
    assert fit.fault.amount == pytest.approx(fault.amount, abs=1e-3)
    assert fit.warning is not None
    assert fit.fault.described(names) in fit.warning
    right = sensor_fit(decoder, fit.fault.corrected(frames, names))
    assert right is not None
    assert (right.fault, right.warning) == (None, None)


def test_a_library_that_was_fitted_or_brought_to_another_air_may_fit_worse(library: acoustic_fem.Library) -> None:
    h = library.transfer_function.values

    def expected(**provenance: object) -> float | None:
        made = measured_library(library.design, library, h, 0.01 * np.abs(h), ("numpy",), dict(provenance))
        return localize.BayesDecoder(made, NOISE).largest_misfit

    whole = {"measured_points": [1, 2, 3, 4]}
    direct = expected(calibration=whole, fit=None)
    assert direct == DecoderOptions.calibrated_misfit
    for changed in (
        {"calibration": {"measured_points": [1, 2, 4]}, "fit": None}, {"calibration": whole, "fit": {"chi": 1.0}},
        {"self_calibration": {}}, {"brought_from_air": {}},
    ):  # fmt: skip
        assert expected(**changed) == DecoderOptions.fitted_misfit


def test_exchanged_microphones_are_found_once_the_sensor_is_calibrated(made: ArrayResponse) -> None:
    measured = replace(made, provenance={**made.provenance, "fidelity": MEASURED})
    known, fault = localize.BayesDecoder(measured, NOISE), ConnectionFault("exchanged", ("A", "B"))
    fit = sensor_fit(known, fault.corrected(heard(made), ("A", "B")))
    assert fit is not None
    assert fit.fault == fault


def test_probabilities_are_trusted_the_less_the_worse_the_sensor_fits() -> None:
    trusts = [SensorFit(misfit, 4.0, ("A", "B")).trust for misfit in (1.0, 4.0, 8.0, 100.0)]
    assert trusts == pytest.approx([1.0, 1.0, 0.5, 0.04])
    texts = [SensorFit(misfit, 4.0, ("A", "B")).warning for misfit in (5.0, 20.0, 100.0)]
    assert len({str(text).split("; ")[0].split(", so ")[1] for text in texts}) == 3


@pytest.mark.parametrize("samples", [-3.0, 0.0, 7.0, 12.4, -30.6, 5000.0])
def test_a_signal_is_moved_by_any_number_of_samples(samples: float) -> None:
    time = np.arange(1000.0)
    smooth = np.sin(0.3 * time) * np.exp(-(((time - 500) / 100) ** 2))
    moved = np.sin(0.3 * (time + samples)) * np.exp(-(((time + samples - 500) / 100) ** 2))
    assert earlier(smooth, samples) == pytest.approx(moved, abs=1e-6)


@pytest.mark.slow
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
            0.016 * k,
            "touch" if k % 7 else "no touch",
            float(random.uniform()),
            1,
            1.0,
            frame=np.tile(16.0 * k + np.arange(-249, 1), (2, 1)),  # numbers of the samples
        )
        for k in range(2000)
    ]
    for first in range(0, 2000, 100):
        loud.take([*events[first : first + 100], "anything else"])
    found = loud.frames()
    numbers = sorted(round(frame[0, MARGIN + FRAME - 1]) // 16 for frame in found)
    assert {frame.shape for frame in found} == {(2, FRAME + 2 * MARGIN)}
    assert len(numbers) == FitOptions.most
    assert np.diff(numbers).min() * 0.016 >= 0.25
    assert all(number % 7 for number in numbers)
    assert max(events, key=lambda event: event.level if event.state == "touch" else 0.0).time == pytest.approx(
        0.016 * max(numbers, key=lambda number: events[number].level)
    )


def test_loud_frames_come_with_the_samples_around_them() -> None:
    samples = np.random.default_rng(1).standard_normal((2, 3000)) * np.exp(-(((np.arange(3000) - 1500) / 300) ** 2))
    loud = LoudFrames()
    ends = range(FRAME, 3001, 16)
    levels = {end: float(samples[:, end - FRAME : end].std()) for end in ends}
    for end in ends:
        frame = samples[:, end - FRAME : end]
        loud.take([Decision(end / 1000, "touch", levels[end], 1, 1.0, frame=frame)])
    best = max(levels, key=lambda end: levels[end])
    around = samples[:, best - FRAME - MARGIN : best + MARGIN]
    assert any(np.array_equal(each, around) for each in loud.frames())
