"""On a real array an ONNX file agrees with what it was made from in probability, whatever the touch: to 1e-5, or 1e-3
where a network of hypotheses takes differences of large numbers in single precision."""

from __future__ import annotations

import functools
from dataclasses import replace

import numpy as np
import onnxruntime
import pytest
import torch

import acoustic_fem
import geometry
import localize
from localize.decoders.surroundings import ROOM
from localize.learned.hypothesis_network import HypothesisClassifier
from localize.signals.array_response import response_of
from localize.signals.stimulus_kinds import STIMULI

AGREEMENT = 1e-5
OF_HYPOTHESES = 1e-3
PLAN = localize.TrainingPlan(
    seconds_per_point=10, epochs=2, microphone_noise=1e-3, stimuli=("multi-sines", "taps", "friction", "pulse-wave")
)
MADE = {
    "network": lambda array: localize.train(array, PLAN),
    "network of maps": lambda array: localize.train(array, replace(PLAN, network="patches")),
    "decoder": lambda array: localize.BayesDecoder(array, 1e-3),
    "decoder of low noise": lambda array: localize.BayesDecoder(array, 1e-4),
    "decoder of three levels": lambda array: localize.BayesDecoder(array, 1e-3, ambient=(None, 60.0, 80.0)),
    "decoder in a room": lambda array: localize.BayesDecoder(array, 1e-3, ambient=ROOM),
}


@functools.cache
def library():
    return acoustic_fem.solve(geometry.prototype("line-2"), np.arange(1.0, 201.0), "lumped")


@pytest.fixture(scope="module")
def array():
    return response_of(library())


SLOW = ("decoder of low noise", "decoder of three levels", "decoder in a room")


@pytest.fixture(
    scope="module",
    params=[pytest.param(name, marks=pytest.mark.slow) if name in SLOW else name for name in MADE],
)
def pair(request, array, tmp_path_factory):
    localizer = MADE[request.param](array)
    path = tmp_path_factory.mktemp("onnx") / "localizer.onnx"
    localize.export_onnx(localizer, path)
    options = onnxruntime.SessionOptions()
    options.intra_op_num_threads = 1
    return localizer, onnxruntime.InferenceSession(path, options, providers=["CPUExecutionProvider"])


def frames_of(array, stimulus, noise, ambient=None):
    """(n, 2, 250) float32: two touches of every point, from before they begin to their end."""
    levels = None if ambient is None else (ambient, ambient)
    touches = localize.TouchGenerator(array, 3, "evaluation", noise, stimuli=STIMULI[stimulus], ambient=levels)
    signals = touches.samples(0, 2 * array.point_count).signals
    before = noise * torch.randn(*signals.shape[:2], 200, generator=torch.Generator().manual_seed(0))
    frames = torch.cat([before, signals], -1).unfold(-1, 250, 190).transpose(1, 2).flatten(0, 1)
    heard = frames.amax(-1) > frames.amin(-1)  # without noise a channel may not have moved yet
    return frames[heard.all(1)].contiguous()


@pytest.mark.slow
@pytest.mark.parametrize("gain", [0.01, 1.0, 10.0])
@pytest.mark.parametrize(("stimulus", "noise", "ambient"), [
    ("multi-sines", 0.0, None), ("multi-sines", 1e-3, None), ("taps", 0.0, None), ("taps", 1e-3, None),
    ("pulse-wave", 1e-3, None), ("multi-sines", 1e-3, 75.0), ("taps", 1e-3, 60.0),
])  # fmt: skip
def test_probabilities_agree_on_line_2(array, pair, stimulus, noise, ambient, gain):
    localizer, session = pair
    is_of_hypotheses = isinstance(getattr(localizer, "classifier", None), HypothesisClassifier)
    agreement = OF_HYPOTHESES if is_of_hypotheses else AGREEMENT
    frames = frames_of(array, stimulus, noise, ambient) * gain
    expected = localizer.locate(frames)
    probability, logarithm = session.run(None, {"frames": frames.numpy()})
    assert np.abs(probability - expected).max() < agreement
    assert np.abs(np.exp(logarithm) - expected).max() < agreement
    alone = np.concatenate([session.run(None, {"frames": frame[None].numpy()})[0] for frame in frames[:40]])
    assert np.abs(alone - expected[:40]).max() < agreement
    assert np.abs(localizer.locate(frames[7]) - expected[7]).max() < agreement


@pytest.mark.slow
def test_an_offset_of_a_microphone_does_not_part_levels_of_sound(array, tmp_path):
    """Far above what the decoder assumes all scores are large, and levels differ by little of that."""
    decoder = localize.BayesDecoder(array, 1e-3, ambient=(None, 60.0, 80.0))
    localize.export_onnx(decoder, tmp_path / "localizer.onnx")
    frames = frames_of(array, "multi-sines", 1e-3)[:60] + torch.linspace(0, 5, 250)
    expected = decoder.locate(frames)
    assert np.abs(localize.OnnxLocalizer(tmp_path / "localizer.onnx").locate(frames) - expected).max() < AGREEMENT
    assert np.abs(np.stack([decoder.locate(frame) for frame in frames[:20]]) - expected[:20]).max() < AGREEMENT
