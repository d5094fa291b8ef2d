"""A calibrated sensor whose stiffness drifts is followed over touches; about a nominal one nothing is followed."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from refusals import refused
from shared import solved

import localize
from acoustic_fem.library.transfer_functions import Library, measured_library
from geometry import Kind
from localize.decoders.decoder_options import DriftOptions
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
    return made.signals[order, :, -250:].double().numpy(), made.point[order].numpy() - 1


@pytest.mark.parametrize("modulus", [0.8, 1.0, 1.15])
def test_a_drift_is_followed_from_the_tenth_touch(modulus: float) -> None:
    frames, points = touches(modulus)
    decoder = follower()
    probability, belief = decoder.follow(frames, decoder.start)
    right = probability.argmax(1) == points
    assert right[10:].all()
    assert float(np.exp(belief) @ np.log(decoder.stiffness)) == pytest.approx(np.log(modulus), abs=0.04)
    before = localize.BayesDecoder(calibrated(), NOISE).locate(frames).argmax(1) == points
    assert right[10:].mean() >= before[10:].mean()
    assert modulus > 0.9 or before.mean() < 0.95


@pytest.mark.parametrize(
    "there",
    [
        pytest.param({"temperature_c": 32.0, "humidity": 0.85, "hours": 0.25}, id="worn and sweating"),
        pytest.param({"altitude": 1000.0, "hours": 0.0}, id="climbed"),
    ],
)
@pytest.mark.slow
def test_a_sealed_sensor_that_is_worn_or_climbs_is_followed_from_the_tenth_touch(there: dict[str, float]) -> None:
    moved = response_of(calibrated().in_air(**there))
    made = localize.TouchGenerator(moved, 1, "training", NOISE).samples(0, 120)
    order = np.random.default_rng(0).permutation(120)
    frames, points = made.signals[order, :, -250:].double().numpy(), made.point[order].numpy() - 1
    decoder = follower()
    right = decoder.follow(frames, decoder.start)[0].argmax(1) == points
    assert right[10:].mean() >= 0.98
    assert (localize.BayesDecoder(calibrated(), NOISE).locate(frames).argmax(1) == points).mean() < 0.8


def test_touches_one_by_one_are_those_of_a_batch_and_the_decoder_keeps_nothing() -> None:
    frames, _ = touches(0.8)
    decoder = follower()
    together, after = decoder.follow(frames[:6], decoder.start)
    state, alone = decoder.start, []
    for frame in frames[:6]:
        probability, state = decoder.follow(frame, state)
        alone.append(probability)
    assert np.allclose(alone, together, atol=1e-6)
    assert np.allclose(state, after, atol=1e-6)
    assert together.shape == (6, 12)
    assert np.allclose(together.sum(1), 1)
    assert np.array_equal(decoder.follow(frames[:6], decoder.start)[0], together)
    assert decoder.start.argmax() == DriftOptions.softer
    assert decoder.stiffness[DriftOptions.softer] == 1


def test_what_is_located_is_taken_as_the_first_touch_in_any_order() -> None:
    frames, _ = touches(0.8)
    decoder = follower()
    located = decoder.locate(frames[:6])
    assert np.array_equal(located[0], decoder.follow(frames[0], decoder.start)[0])
    assert np.allclose(decoder.locate(frames[5::-1])[::-1], located, atol=1e-12)
    assert np.allclose(np.exp(decoder.log_probability(frames[:6])), located, atol=1e-12)


def test_without_a_microphone_the_drift_so_far_is_followed_on() -> None:
    nominal = solved("glove", GRID)
    before, after = (
        Rig(nominal.design, 6, HiddenScatter(modulus=modulus), fidelity="lumped").transfer_function(GRID)
        for modulus in (1.0, 0.8)
    )
    library = measured_library(nominal.design, nominal, before, 0.01 * np.abs(before), ("numpy",), {})
    aged = replace(response_of(library), transfer_function=after)
    made = localize.TouchGenerator(aged, 1, "training", NOISE).samples(0, 72)
    order = np.random.default_rng(0).permutation(72)
    frames, points = made.signals[order, :, -250:].double().numpy(), made.point[order].numpy() - 1
    decoder = localize.DriftDecoder(library, NOISE)
    _, belief = decoder.follow(frames[:24], decoder.start)
    left = decoder.microphones[1:]
    rest = decoder.heard_by(left)
    assert rest.microphones == left
    still = localize.BayesDecoder(response_of(library).heard_by(left), NOISE)
    followed = rest.follow(frames[24:, 1:], belief)[0]
    right, unfollowed = ((each.argmax(1) == points[24:]).mean() for each in (followed, still.locate(frames[24:, 1:])))
    assert right > unfollowed
    with refused(Kind.UNKNOWN, "microphones"):
        decoder.heard_by(("A", "Z"))


def test_one_touch_excludes_no_state_and_frames_of_a_stream_count_by_what_is_new() -> None:
    frames, _ = touches(0.8)
    decoder = follower()
    change = decoder.follow(100 * frames[0], decoder.start)[1] - decoder.start
    assert change.max() - change.min() < 4.2
    slow = localize.DriftDecoder(calibrated(), NOISE, new=16 / 250)
    once, slowly = (each.follow(frames[0], each.start)[1] - each.start for each in (decoder, slow))
    assert np.abs(slowly).max() < 0.1 * np.abs(once).max()


def test_only_a_calibrated_library_is_followed() -> None:
    half = {"calibration": {"other_points": "model", "measured_points": [1, 2, 3]}}
    for library in (
        solved("array-2x6", GRID),
        replace(calibrated(), provenance=half),
        response_of(calibrated()),
    ):
        with refused(Kind.UNSUITABLE, "library"):
            localize.DriftDecoder(library, NOISE)  # type: ignore[arg-type]
    with refused(Kind.OUT_OF_RANGE, "new", 0):
        localize.DriftDecoder(calibrated(), new=0)


def test_what_follows_its_sensor_is_no_graph(tmp_path) -> None:
    with refused(Kind.UNSUITABLE, "localizer"):
        export_onnx(follower(), tmp_path / "decoder.onnx")
