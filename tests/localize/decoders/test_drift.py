"""A calibrated sensor whose stiffness drifts is followed over touches; about a nominal one nothing is followed."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from shared import solved

import localize
from acoustic_fem.library.transfer_functions import Library, measured_library
from geometry.ground.refusal import Refusal
from localize.decoders.drift import STATES
from localize.learned.onnx import export_onnx
from localize.signals.array_response import response_of
from studies.test_rig.virtual_rig import HiddenScatter, Rig

GRID = np.arange(1.0, 101.0, 3.0)
NOISE = 1e-3


@cache
def transfer_function(modulus: float = 1.0) -> np.ndarray:
    return Rig(
        solved("array-2x6", GRID).design, 6, HiddenScatter(modulus=modulus), fidelity="lumped"
    ).transfer_function(GRID)


@cache
def calibrated() -> Library:
    nominal, h = solved("array-2x6", GRID), transfer_function()
    return measured_library(nominal.design, nominal, h, 0.01 * np.abs(h), ("numpy",), {})


@cache
def follower() -> localize.DriftDecoder:
    return localize.DriftDecoder(calibrated(), NOISE)


@cache
def touches(modulus: float) -> tuple[np.ndarray, np.ndarray]:
    response = replace(response_of(calibrated()), transfer_function=transfer_function(modulus))
    made = localize.TouchGenerator(response, 1, "training", NOISE).samples(0, 72)
    order = np.random.default_rng(0).permutation(72)
    return made.signals[order, :, -250:].double().numpy(), made.point[order].numpy()


@pytest.mark.parametrize("modulus", [0.8, 1.0, 1.15])
def test_a_drift_is_followed_from_the_tenth_touch(modulus: float) -> None:
    frames, points = touches(modulus)
    decoder = follower()
    decoder.reset()
    right = decoder.locate(frames).argmax(1) == points
    assert right[10:].all()
    assert float(decoder.belief @ np.log(decoder.stiffness)) == pytest.approx(np.log(modulus), abs=0.04)
    before = localize.BayesDecoder(calibrated(), NOISE).locate(frames).argmax(1) == points
    assert right[10:].mean() >= before[10:].mean()
    assert modulus > 0.9 or before.mean() < 0.95


def test_touches_one_by_one_are_those_of_a_batch() -> None:
    frames, _ = touches(0.8)
    decoder = follower()
    decoder.reset()
    together = decoder.locate(frames[:6])
    decoder.reset()
    assert np.allclose([decoder.locate(frame) for frame in frames[:6]], together, atol=1e-6)
    assert together.shape == (6, 12)
    assert np.allclose(together.sum(1), 1)
    # what is asked otherwise moves nothing
    belief = decoder.belief
    assert np.allclose(np.exp(decoder.log_probability(frames[5:6])), together[5:], atol=1e-6)
    assert np.array_equal(decoder.belief, belief)
    decoder.reset()
    assert decoder.belief.argmax() == STATES // 2


def test_without_a_microphone_the_drift_that_was_heard_is_known_and_followed_on() -> None:
    nominal = solved("glove", GRID)
    before, after = (
        Rig(nominal.design, 6, HiddenScatter(modulus=modulus), fidelity="lumped").transfer_function(GRID)
        for modulus in (1.0, 0.8)
    )
    library = measured_library(nominal.design, nominal, before, 0.01 * np.abs(before), ("numpy",), {})
    aged = replace(response_of(library), transfer_function=after)
    made = localize.TouchGenerator(aged, 1, "training", NOISE).samples(0, 72)
    order = np.random.default_rng(0).permutation(72)
    frames, points = made.signals[order, :, -250:].double().numpy(), made.point[order].numpy()
    decoder = localize.DriftDecoder(library, NOISE)
    decoder.locate(frames[:24])
    left = decoder.microphones[1:]
    rest = decoder.heard_by(left)
    assert rest.microphones == left
    assert np.array_equal(rest.belief, decoder.belief)
    still = localize.BayesDecoder(response_of(library).heard_by(left), NOISE)
    right, unfollowed = ((each.locate(frames[24:, 1:]).argmax(1) == points[24:]).mean() for each in (rest, still))
    assert right > unfollowed
    assert np.array_equal(rest.belief, decoder.belief)
    with pytest.raises(Refusal, match="microphones names 'Z', must be of"):
        decoder.heard_by(("A", "Z"))


def test_one_touch_excludes_no_state_and_frames_of_a_stream_count_by_what_is_new() -> None:
    frames, _ = touches(0.8)
    decoder = follower()
    decoder.reset()
    before = decoder.belief
    decoder.locate(100 * frames[0])
    assert (decoder.belief / before).max() / (decoder.belief / before).min() < np.exp(4.2)
    decoder.reset()
    slow = localize.DriftDecoder(calibrated(), NOISE, new=16 / 250)
    slow.locate(frames[0])
    decoder.locate(frames[0])
    assert np.abs(np.log(slow.belief / before)).max() < 0.1 * np.abs(np.log(decoder.belief / before)).max()


def test_only_a_calibrated_library_is_followed() -> None:
    with pytest.raises(Refusal, match=r"library must be calibrated to follow a drift, was computed \(lumped\)"):
        localize.DriftDecoder(solved("array-2x6", GRID))
    half = {"calibration": {"other_points": "model", "measured_points": [1, 2, 3]}}
    with pytest.raises(Refusal, match="at all points to follow a drift: 3 of 12 were measured"):
        localize.DriftDecoder(replace(calibrated(), provenance=half))
    with pytest.raises(Refusal, match="library must be one of a design"):
        localize.DriftDecoder(response_of(calibrated()))  # type: ignore[arg-type]
    with pytest.raises(Refusal, match="new = 0 must be above 0"):
        localize.DriftDecoder(calibrated(), new=0)


def test_what_remembers_is_no_graph(tmp_path) -> None:
    with pytest.raises(Refusal, match="must not be a DriftDecoder"):
        export_onnx(follower(), tmp_path / "decoder.onnx")
