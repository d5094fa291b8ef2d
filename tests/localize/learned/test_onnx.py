"""An ONNX file computes what the localizer it was made from does, and says what it is."""

from __future__ import annotations

import json

import numpy as np
import onnx
import onnxruntime
import pytest
import torch
from rc_line import rc_line
from refusals import refused

import localize
from geometry import Kind
from localize.graphs import KEY
from localize.graphs.graph_check import fault_of_graph
from localize.learned.onnx import OPSET

QUICK = localize.TrainingPlan(seconds_per_point=10, epochs=2, microphone_noise=1e-2)


@pytest.fixture(scope="module")
def array():
    return rc_line(20)


@pytest.fixture(scope="module")
def network(array):
    return localize.train(array, QUICK)


@pytest.fixture(scope="module")
def decoder(array):
    return localize.BayesDecoder(array, 1e-2)


@pytest.fixture(scope="module", params=["network", "decoder"])
def pair(request, tmp_path_factory):
    localizer = request.getfixturevalue(request.param)
    path = tmp_path_factory.mktemp("onnx") / "localizer.onnx"
    before = torch.get_rng_state()
    localize.export_onnx(localizer, path)
    assert torch.equal(torch.get_rng_state(), before), "exporting leaves the random numbers of torch alone"
    assert [left.name for left in path.parent.iterdir()] == ["localizer.onnx"]
    return localizer, path


def touches(array, noise, count=200):
    # In single precision, which is what the graph takes.
    return localize.TouchGenerator(array, 3, "evaluation", noise).samples(0, count).signals[..., -250:]


@pytest.mark.parametrize("noise", [0.0, 1e-2, 0.3, 10.0])
def test_probabilities_agree_with_torch_at_every_noise(array, pair, noise):
    localizer, path = pair
    frames = touches(array, noise)
    session = onnxruntime.InferenceSession(path, providers=["CPUExecutionProvider"])
    probability, logarithm = session.run(["probability", "log_probability"], {"frames": frames.numpy()})
    expected = localizer.locate(frames)
    # The network's features are large numbers in single precision, whose rounding the runtime has its own way with.
    tolerance = 1e-5 if isinstance(localizer, localize.BayesDecoder) else 2e-4
    assert np.abs(probability - expected).max() < tolerance
    assert np.abs(np.exp(logarithm) - expected).max() < tolerance
    assert probability.dtype == np.float32


@pytest.mark.slow
def test_a_low_assumed_noise_needs_the_double_precision_and_has_it(array, tmp_path):
    """At 90 dB above the noise, differences of likelihoods are 1e-9 of what they are differences of."""
    decoder = localize.BayesDecoder(array, 1e-6)
    localize.export_onnx(decoder, tmp_path / "decoder.onnx")
    frames = touches(array, 3e-2)
    found = localize.OnnxLocalizer(tmp_path / "decoder.onnx").locate(frames)
    assert np.abs(found - decoder.locate(frames)).max() < 1e-5


def test_one_frame_gives_what_it_gives_in_a_batch_and_frames_are_combined(array, pair):
    localizer, path = pair
    read = localize.OnnxLocalizer(path)
    signals = localize.TouchGenerator(array, 4, "evaluation", 1e-2).samples(0, 100).signals
    batch = read.locate(signals)
    assert batch.shape == (100, 20)
    assert read.locate(signals[7]) == pytest.approx(batch[7], abs=1e-6)
    assert np.abs(batch - localizer.locate(signals)).max() < 1e-5  # four frames, whose logarithms are added
    assert (batch.argmax(1) == localizer.locate(signals).argmax(1)).all()


def test_a_file_is_valid_and_says_what_it_is(array, pair):
    localizer, path = pair
    model = onnx.load(path)
    onnx.checker.check_model(model, full_check=True)
    assert [entry.version for entry in model.opset_import if not entry.domain] == [OPSET]
    assert {entry.domain for entry in model.opset_import} == {""}
    said = json.loads({entry.key: entry.value for entry in model.metadata_props}[KEY])
    assert said["microphones"] == ["left", "right"]
    assert (said["line"], said["place"]) == ([0] * 20, list(range(20)))
    assert (said["sample_rate"], said["frame"], said["unit"]) == (1000.0, 250, "Pa")
    assert said["noise_rms"] == pytest.approx(1e-2)
    assert said["versions"]["libraries"]["onnx"] == onnx.__version__
    assert said["provenance"]["made by"] == "tests/support/rc_line.py"
    assert fault_of_graph(model) is None  # and it runs in this process
    read = localize.OnnxLocalizer(path)
    assert (read.design, read.point_count, read.noise_rms) == ("rc-line-20", 20, localizer.noise_rms)


def test_an_onnx_file_is_evaluated_like_what_it_was_made_from(array, pair):
    localizer, path = pair
    own, read = (localize.evaluate(each, array, 5, 1e-2) for each in (localizer, localize.OnnxLocalizer(path)))
    assert np.array_equal(own.confusion, read.confusion)


def test_files_that_are_no_localizers_are_refused_by_name(pair, tmp_path):
    _, path = pair
    with refused(Kind.MISSING, file="none.onnx", error=localize.LocalizerError):
        localize.OnnxLocalizer(tmp_path / "none.onnx")
    content = path.read_bytes()
    for name, damaged in (("half", content[: len(content) // 2]), ("empty", b""), ("text", b"not a model" * 50)):
        (tmp_path / f"{name}.onnx").write_bytes(damaged)
        with refused(Kind.UNREADABLE, file=f"{name}.onnx", error=localize.LocalizerError):
            localize.OnnxLocalizer(tmp_path / f"{name}.onnx")
    model = onnx.load(path)
    said = json.loads(model.metadata_props[0].value)
    for change, kind in (({"version": 2}, Kind.MISMATCH), ({"format": "other"}, Kind.UNREADABLE)):
        model.metadata_props[0].value = json.dumps(said | change)
        onnx.save(model, tmp_path / "changed.onnx")
        with refused(kind, file="changed.onnx", error=localize.LocalizerError):
            localize.OnnxLocalizer(tmp_path / "changed.onnx")
    del model.metadata_props[:]
    onnx.save(model, tmp_path / "bare.onnx")
    with refused(Kind.UNREADABLE, file="bare.onnx", error=localize.LocalizerError):
        localize.OnnxLocalizer(tmp_path / "bare.onnx")
