"""An ONNX file computes what the localizer it was made from does, and says what it is."""

from __future__ import annotations

import json

import numpy as np
import onnx
import onnxruntime
import pytest
import scipy.signal
import torch
from rc_line import rc_line
from refusals import refused

import localize
from geometry import Kind
from localize.graphs import KEY
from localize.graphs.graph_check import fault_of_graph
from localize.graphs.onnx_localizer import ConvertedGraphWarning
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
    assert model.producer_version == said["versions"]["code_version"]
    for value in (*model.graph.input, *model.graph.output):
        assert "point" in value.doc_string or "high-pass" in value.doc_string
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


def test_the_file_says_what_a_stream_does_before_the_graph(array, pair):
    """A program that has only the file hears a recording as our own stream does."""
    localizer, path = pair
    (entry,) = onnx.load(path).metadata_props
    stream = json.loads(entry.value)["stream"]
    signal = localize.TouchGenerator(array, 3, "evaluation", 1e-2).samples(4, 1).signals[0].numpy()
    filtered = scipy.signal.sosfilt(np.array(stream["high_pass_sections"]), signal.astype(float), axis=-1)
    frame = filtered[None, :, -250:].astype(np.float32)
    session = onnxruntime.InferenceSession(path, providers=["CPUExecutionProvider"])
    (probability,) = session.run(["probability"], {"frames": frame})
    assert probability[0].argmax() == localizer.locate(frame)[0].argmax() == 4
    assert (stream["hop"], stream["high_pass"], stream["high_pass_order"]) == (16, 3.0, 2)
    assert np.sqrt(np.mean(frame**2)) > stream["silence"] > localizer.noise_rms


def test_silence_gives_probabilities(pair):
    _, path = pair
    session = onnxruntime.InferenceSession(path, providers=["CPUExecutionProvider"])
    frames = np.zeros((3, 2, 250), np.float32)
    frames[1], frames[2, 0] = 1.0, 1e-3
    probability, logarithm = session.run(["probability", "log_probability"], {"frames": frames})
    assert np.isfinite(logarithm).all()
    assert np.allclose(probability.sum(-1), 1, atol=1e-5)


@pytest.mark.parametrize(("opset", "ir_version"), [(18, None), (21, None), (20, 10)])
@pytest.mark.slow
def test_an_older_runtime_gets_its_own_opset(array, pair, tmp_path, opset, ir_version):
    localizer, _ = pair
    path = tmp_path / "other.onnx"
    localize.export_onnx(localizer, path, opset=opset, ir_version=ir_version)
    model = onnx.load(path)
    onnx.checker.check_model(model, full_check=True)
    assert [entry.version for entry in model.opset_import] == [opset]
    lowest = onnx.helper.find_min_ir_version_for([onnx.helper.make_opsetid("", opset)])
    assert model.ir_version == (ir_version or lowest)
    assert fault_of_graph(model) is None
    frames = touches(array, 1e-2, 20)
    assert np.abs(localize.OnnxLocalizer(path).locate(frames) - localizer.locate(frames)).max() < 2e-4


@pytest.mark.parametrize("value", [{"opset": 17}, {"opset": 24}, {"ir_version": 3}, {"opset": 20, "ir_version": 99}])
def test_versions_out_of_range_are_refused(pair, tmp_path, value):
    localizer, _ = pair
    with refused(Kind.OUT_OF_RANGE, field=list(value)[-1]):
        localize.export_onnx(localizer, tmp_path / "a.onnx", **value)


def test_a_graph_that_another_program_converted_is_accepted_with_a_warning(array, pair, tmp_path):
    localizer, path = pair
    converted = onnx.version_converter.convert_version(onnx.load(path), 21)
    (entry,) = onnx.load(path).metadata_props
    del converted.metadata_props[:]
    converted.metadata_props.add(key=entry.key, value=entry.value)
    onnx.save(converted, tmp_path / "converted.onnx")
    with pytest.warns(ConvertedGraphWarning, match="converted"):
        read = localize.OnnxLocalizer(tmp_path / "converted.onnx")
    frames = touches(array, 1e-2, 20)
    assert np.abs(read.locate(frames) - localizer.locate(frames)).max() < 2e-4
    # the same opset and producer, and other weights: damage
    damaged = onnx.load(path)
    damaged.graph.initializer[0].raw_data = bytes(len(damaged.graph.initializer[0].raw_data))
    onnx.save(damaged, tmp_path / "damaged.onnx")
    with refused(Kind.DAMAGED, file="damaged.onnx", error=localize.LocalizerError):
        localize.OnnxLocalizer(tmp_path / "damaged.onnx")
