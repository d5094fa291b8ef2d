"""A sensor calibrated by touches of which nobody knows the points, or refused, and then nothing changes."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from foreign_touches import DESIGN, GRID, NOISE, Array, calibrated, heard, nominal, touches, truth
from numpy.typing import NDArray
from refusals import refused

import acoustic_fem
import geometry
import localize
from acoustic_fem.calibration.fitted_model import Posterior, UpdatedModel
from acoustic_fem.library.transfer_functions import Library
from geometry import Kind
from localize.decoders.decoder_options import DecoderOptions
from localize.recalibration.marginal_likelihood import FLAT, MarginalLikelihood, high_pass_gain
from localize.recalibration.parameter_search import value_and_slope
from localize.recalibration.recalibration_options import RecalibrationOptions
from localize.recalibration.rejections import gaps, likeliest_order, numbers
from localize.recalibration.self_calibration import SelfCalibrationError, self_calibrate
from localize.signals.array_response import response_of
from studies.test_rig.virtual_rig import HiddenScatter, Rig

SLOPES = RecalibrationOptions().slopes


def top1(library: Library, response: localize.ArrayResponse) -> float:
    return localize.evaluate(localize.BayesDecoder(library, NOISE), response, 20, NOISE, seed=7).top1


@pytest.mark.parametrize(("slopes", "high_pass"), [(FLAT, None), (SLOPES, 3.0)])
def test_the_slope_is_that_of_finite_differences(slopes: tuple[float, ...], high_pass: float | None) -> None:
    model = UpdatedModel(nominal())
    likelihood = MarginalLikelihood(GRID, touches(truth(), 24)[0], 0.01, slopes, high_pass)
    random = np.random.default_rng(3)
    u, direction = 0.5 * random.standard_normal((2, model.count))
    value, slope = value_and_slope(model, likelihood, u)
    step = 1e-3  # rounding of the likelihood is 1e-7 of it

    def at(parameters: Array) -> float:
        return float(likelihood.evidence(model.transfer_function(parameters[None])[0]).frames.sum())

    assert at(u) == pytest.approx(value, rel=1e-9)
    along = (at(u + step * direction) - at(u - step * direction)) / (2 * step)
    assert along == pytest.approx(float(slope @ direction), rel=3e-5)


def test_spectra_that_fall_and_a_high_pass_explain_what_fingers_do() -> None:
    random = np.random.default_rng(2)
    lines = np.arange(1.0, 101.0)
    drawn = random.standard_normal((2, 24, 100))
    touched = (drawn[0] + 1j * drawn[1])[:, None] * truth().at(lines)[np.arange(24) % 12]

    def likelihood(spectrum: Array, slopes: tuple[float, ...], high_pass: float | None) -> float:
        lined = np.pad(touched * spectrum, ((0, 0), (0, 0), (1, 400)))
        frames = np.fft.irfft(lined, 1000)[..., :250]
        frames *= 0.1 / frames.std(2).max(1)[:, None, None]
        frames += 1e-3 * np.random.default_rng(3).standard_normal(frames.shape)
        found = MarginalLikelihood(GRID, frames, 0.01, slopes, high_pass).evidence(truth().transfer_function)
        assert np.allclose(found.probability.sum(1), 1)
        return float(found.frames.sum())

    steep, high = lines**-2.0, high_pass_gain(lines, 20.0)
    figures = {
        (name, slopes, corner): likelihood(spectrum, slopes, corner)
        for name, spectrum in (("steep", steep), ("high", high))
        for slopes in (FLAT, SLOPES)
        for corner in (None, 20.0)
    }
    assert figures["steep", SLOPES, None] > figures["steep", FLAT, None] + 10, figures
    assert figures["high", FLAT, 20.0] > figures["high", FLAT, None] + 10, figures


def test_the_likelihood_ranks_points_as_the_decoder_does() -> None:
    frames, points = touches(truth(), 120)
    likelihood = MarginalLikelihood(GRID, frames, DecoderOptions.noise_fraction * NOISE)
    share = likelihood.evidence(truth().transfer_function).probability
    assert np.allclose(share.sum(1), 1)
    decoder = localize.BayesDecoder(truth(), NOISE)
    assert (share.argmax(1) == decoder.locate(frames).argmax(1)).mean() > 0.98
    assert (share.argmax(1) == points).mean() > 0.98


def test_information_is_symmetric_never_negative_and_grows_with_the_frames() -> None:
    model = UpdatedModel(nominal())
    h = nominal().transfer_function.values
    likelihood = MarginalLikelihood(GRID, touches(truth(), 24)[0], 0.01)
    information = likelihood.information(h, model.jacobian(np.zeros(model.count)))
    assert np.allclose(information, information.T)
    assert np.linalg.eigvalsh(information)[0] > -1e-4 * np.linalg.eigvalsh(information)[-1]
    twice = MarginalLikelihood(GRID, np.tile(touches(truth(), 24)[0], (2, 1, 1)), 0.01)
    # products are of single precision
    assert np.allclose(
        twice.information(h, model.jacobian(np.zeros(model.count))), 2 * information, 1e-6, 1e-6 * information.max()
    )


def test_information_of_touches_adds_up() -> None:
    """Whatever points they are of, and loud ones and quiet ones: each says what it says."""
    model = UpdatedModel(nominal())
    h, jacobian = truth().transfer_function, model.jacobian(np.zeros(model.count))
    frames, points = touches(truth(), 72)
    frames[::5] *= 0.1

    def told(chosen: NDArray[np.bool_]) -> Array:
        return MarginalLikelihood(GRID, frames[chosen], 0.01).information(h, jacobian)

    begin = points < 4
    both = told(points >= 0)
    assert np.allclose(told(begin) + told(~begin), both, rtol=1e-4, atol=1e-4 * both.max())


def test_touches_of_unknown_loudness_do_not_tell_the_level_that_microphones_have_in_common() -> None:
    model = UpdatedModel(nominal())
    u = np.zeros(model.count)
    likelihood = MarginalLikelihood(GRID, touches(truth(), 120)[0], 0.01)
    information = likelihood.information(nominal().transfer_function.values, model.jacobian(u))
    gain = np.array([name.startswith("gain") for name in model.names], float)
    against = gain * np.where([name.endswith("A") for name in model.names], 1, -1)
    assert abs(gain @ information @ gain) < 1e-3
    assert against @ information @ against > 10


@pytest.mark.slow
@pytest.mark.parametrize("louder", [0.1, 10.0])
def test_louder_touches_in_as_much_louder_noise_say_the_same(louder: float) -> None:
    model = UpdatedModel(nominal())
    u = calibrated().posterior.parameters
    h, jacobian = calibrated().posterior.transfer_function, model.jacobian(u)
    likelihoods = [MarginalLikelihood(GRID, k * heard(), k * calibrated().microphone_noise) for k in (1.0, louder)]
    one, other = (each.information(h, jacobian) for each in likelihoods)
    assert np.allclose(other, one, rtol=0.01, atol=0.01 * np.abs(one).max())
    one, other = (Posterior.of(model, u, each).deviation for each in (one, other))
    assert np.allclose(other, one, rtol=0.01)
    one, other = (each.evidence(h).frames for each in likelihoods)
    assert np.allclose(other, one, atol=0.01)


@pytest.mark.slow
def test_the_stated_uncertainty_of_ratios_is_about_what_they_are_off() -> None:
    """What the model is trusted to is left out."""
    found, true = calibrated().posterior, truth().transfer_function
    h, jacobian = found.transfer_function, found.model.jacobian(found.parameters)
    by_parameters = jacobian[:, :, 0] / h[:, 0] - jacobian[:, :, 1] / h[:, 1]
    spread = np.einsum("apf,ab,bpf->pf", by_parameters.conj(), found.covariance, by_parameters).real
    error = np.log(h[:, 0] / h[:, 1] * true[:, 1] / true[:, 0])
    assert 0.2 < np.sqrt(np.mean(np.abs(error) ** 2 / spread)) < 1.5


@pytest.mark.slow
def test_the_stated_uncertainty_holds_the_level() -> None:
    """A sensor 6 % louder, or quieter, at all microphones makes the same touches of quieter, or louder, fingers."""
    found = calibrated().posterior
    h = truth().transfer_function
    own = float(np.exp(np.log(np.abs(found.transfer_function / h)).mean()))
    radius = np.sqrt(-2 * np.log(0.05)) * found.deviation
    for level in (0.94, 1.0, 1.06):
        assert (np.abs(found.transfer_function - level * own * h) < radius).mean() > 0.9


@pytest.mark.slow
def test_unlabelled_touches_bring_the_library_to_the_made_sensor() -> None:
    found = calibrated()
    assert found.objection is None
    before, after, known = top1(nominal(), truth()), top1(found.library(), truth()), 1.0
    assert before < 0.7
    assert after > known - 0.01


@pytest.mark.slow
def test_the_library_says_what_it_was_made_from(tmp_path: Path) -> None:
    library = calibrated().library()
    acoustic_fem.save(library, tmp_path / "now.nc")
    read = acoustic_fem.load(tmp_path / "now.nc")
    assert np.array_equal(read.transfer_function.values, library.transfer_function.values)
    made = read.provenance["self_calibration"]
    assert (made["frames"], made["seed"], made["objection"]) == (160, 0, None)
    assert set(made["parameters"]) == set(UpdatedModel(nominal()).names)
    assert read.provenance["present"]["fidelity"] == "lumped"
    assert read.transfer_function_deviation is not None
    error = np.abs(read.transfer_function.values - truth().transfer_function)
    assert np.median(error / read.transfer_function_deviation.values) < 3


@pytest.mark.slow
def test_touches_of_another_sensor_are_refused() -> None:
    other = DESIGN.with_values({"tube.inner_diameter": 0.6 * DESIGN.tube.inner_diameter})
    h = acoustic_fem.solve(other, GRID, "lumped").transfer_function.values
    found = self_calibrate(nominal(), touches(replace(truth(), transfer_function=h), 110)[0], NOISE)
    assert found.objection is not None
    assert found.library() is nominal()


def made() -> Library:
    """The library of the made sensor, as if it had been measured."""
    return replace(nominal(), transfer_function=nominal().transfer_function.copy(data=truth().transfer_function))


def test_the_likeliest_order_of_channels_is_that_they_were_recorded_in() -> None:
    frames, _ = touches(truth(), 60)
    right, wrong = (MarginalLikelihood(GRID, each, 0.01) for each in (frames, frames[:, ::-1]))
    order = likeliest_order(right, truth().transfer_function, ("A", "B"))
    assert (order.likeliest, order.gain, order.differs) == (("A", "B"), 0.0, False)
    order = likeliest_order(wrong, truth().transfer_function, ("A", "B"))
    assert (order.likeliest, order.differs) == (("B", "A"), True)
    # a nominal array is its own mirror image
    order = likeliest_order(wrong, nominal().transfer_function.values, ("A", "B"))
    assert abs(order.gain) < 1e-6
    assert not order.differs


def test_three_channels_in_turn_are_put_back() -> None:
    design = geometry.prototype("glove")
    library = acoustic_fem.solve(design, GRID, "lumped")
    h = Rig(design, 3, fidelity="lumped").transfer_function(GRID)
    response = replace(response_of(library), transfer_function=h)
    frames, _ = touches(response, 60)
    order = likeliest_order(MarginalLikelihood(GRID, frames[:, [2, 0, 1]], 0.01), h, response.microphones)
    assert order.likeliest == tuple(response.microphones[k] for k in (2, 0, 1))
    assert order.differs


@pytest.mark.slow
def test_exchanged_channels_are_refused_by_name() -> None:
    found = self_calibrate(made(), touches(truth(), 110)[0][:, ::-1], NOISE)
    assert "the channels look exchanged: A, B are likelier B, A" in str(found.objection)
    assert found.library() is found.present


@pytest.mark.slow
def test_a_gain_that_is_6_db_higher_is_named() -> None:
    found = self_calibrate(made(), touches(truth(), 110)[0] * np.array([2.0, 1.0])[:, None], NOISE)
    assert "the sensor is not one of this tolerance (gain of microphone" in str(found.objection)
    for name, ratio in (("A", 1.4), ("B", 0.7)):
        text = str(found.objection).split(f"gain of microphone {name} x ")[1]
        assert float(text.split(",")[0]) == pytest.approx(ratio, abs=0.05)


@pytest.mark.slow
def test_touches_of_a_part_of_the_points_are_refused() -> None:
    line = np.repeat([0, 1], [36, 12])

    def refused(*untouched: int) -> str:
        count = np.full(48, 4)
        count[list(untouched)] = 0
        return numbers(gaps(count, line))

    assert refused() == refused(0, 7, 9, 35) == refused(10, 11, 12) == refused(36, 40, 47) == ""
    assert refused(0, 1) == "1-2"
    assert refused(34, 35, 36) == "35-36"
    assert refused(10, 11, 12, 13, 30) == "11-14"
    assert refused(*range(1, 36, 2)) == ", ".join(map(str, range(2, 37, 2)))
    assert refused(40, 41) == "41-42"
    count = np.where(np.arange(12) < 4, 40, 0)
    found = replace(calibrated(), touches=count)
    assert "no touch is named point 5-12:" in str(found.objection)
    assert found.library() is nominal()


@pytest.mark.slow
def test_a_refusal_names_what_touches_look_like() -> None:
    assert "touches of another kind, such as two at a time, sound from outside" in str(
        replace(calibrated(), explained=0.5).objection
    )
    with refused(Kind.UNSUITABLE, error=SelfCalibrationError):
        self_calibrate(nominal(), touches(truth(), 120)[0] * 32768, NOISE)


@pytest.mark.slow
def test_a_third_of_a_line_is_refused() -> None:
    """It looks like touches one place further on a stiffer sensor."""
    design = DESIGN.with_values(
        {"lines.0.points": 36, "layout.columns": 18, "membrane.thickness": 1.0, "resonator.cavity_diameter": 8.0,
         "resonator.cavity_height": 3.0, "tube.inner_diameter": 0.6, "tube.outer_diameter": 1.1,
         "microphone_tube.inner_diameter": 0.6, "microphone_tube.outer_diameter": 1.1}
    )  # fmt: skip
    library = acoustic_fem.solve(design, GRID, "lumped")
    h = Rig(design, 11, HiddenScatter(batch=0.0, modulus=0.85), fidelity="lumped").transfer_function(GRID)
    response = replace(response_of(library), transfer_function=h)
    frames, points = touches(response, 360)
    found = self_calibrate(library, frames[points < 12], NOISE)
    assert "no touch is named point" in str(found.objection)


@pytest.mark.slow
def test_two_touches_at_once_are_refused() -> None:
    frames = touches(truth(), 220)[0]
    found = self_calibrate(nominal(), frames[:110] + frames[110:], NOISE)
    assert "two at a time" in str(found.objection)
    assert "; farthest off: " in str(found.objection)


@pytest.mark.slow
def test_noise_that_differs_between_microphones_is_refused() -> None:
    noise = 0.1 * np.random.default_rng(5).standard_normal((110, 2, 250))
    found = self_calibrate(nominal(), noise, NOISE)
    assert "held-out frames are touches of the sensor found" in str(found.objection)
    assert found.library() is nominal()


def test_frames_that_cannot_be_used_are_refused() -> None:
    frames = touches(truth(), 120)[0]
    with refused(Kind.UNSUITABLE, error=SelfCalibrationError):
        self_calibrate(nominal(), frames[:99], NOISE)
    quiet = frames.copy()
    quiet[30:] *= 1e-6
    with refused(Kind.UNSUITABLE, error=SelfCalibrationError):
        self_calibrate(nominal(), quiet, NOISE)
    with refused(Kind.MISMATCH, "signals"):
        self_calibrate(nominal(), frames[:, :1], NOISE)
    with refused(Kind.WRONG_TYPE, "frames"):
        self_calibrate(nominal(), np.pad(frames, ((0, 0), (0, 0), (0, 50))), NOISE)
    with refused(Kind.UNSUITABLE, "signals"):
        self_calibrate(nominal(), frames * np.array([1.0, 0.0])[:, None], NOISE)
    with refused(Kind.UNSUITABLE, error=SelfCalibrationError) as found:
        self_calibrate(nominal(), np.concatenate([frames, np.zeros((1, 2, 250)), frames[[3, 5]]]), NOISE)
    assert "frame 122 of frame 4" in str(found.value)
    for gain in (1.0, -0.3):
        same = frames[:, :1] * np.array([1.0, gain])[:, None]
        with refused(Kind.UNSUITABLE, error=SelfCalibrationError) as found:
            self_calibrate(nominal(), same + 1e-5 * np.random.default_rng(2).standard_normal(same.shape), NOISE)
        assert f"B is {gain:g} times A" in str(found.value)
    with refused(Kind.OUT_OF_RANGE, "microphone_noise", 0):
        self_calibrate(nominal(), frames, 0)
    with refused(Kind.OUT_OF_RANGE, error=geometry.Refusal):
        self_calibrate(nominal(), frames, NOISE, high_pass=0.1)


def test_a_search_that_is_ended_by_its_limit_says_what_it_found_and_changes_nothing() -> None:
    frames, _ = touches(truth(), 120)
    found = self_calibrate(nominal(), frames, NOISE, options=RecalibrationOptions(seconds=0.0))
    assert not found.finished
    assert not found.accepted
    assert found.objection is not None
    assert "was ended after 0 s" in found.objection
    assert "% of the held-out frames" in found.objection
    assert found.library() is found.present
