"""Graphs that say they are localizers: refused by name, or run with limits of time and memory."""

from __future__ import annotations

import json

import numpy as np
import onnx
import pytest
from onnx import TensorProto, helper
from rc_line import rc_line
from refusals import refused

import localize
from geometry import Kind
from localize.graphs import KEY, foreign_graph
from localize.graphs.foreign_graph import ForeignGraph
from localize.graphs.graph_check import LARGEST_VALUES, fault_of_graph

POINTS = 5


@pytest.fixture(scope="module")
def own(tmp_path_factory):
    """A graph of the model-based decoder."""
    path = tmp_path_factory.mktemp("onnx") / "localizer.onnx"
    localize.export_onnx(localize.BayesDecoder(rc_line(POINTS), 1e-2), path)
    return path


def said_of(path):
    return json.loads(onnx.load(path).metadata_props[0].value)


def foreign(own, path, *nodes, constants=(), opset=20):
    """A graph that is none of the exporter: it names a point by the loudness of what other operators make of frames."""
    weights = np.random.default_rng(0).standard_normal((2, POINTS)).astype(np.float32)
    body = [
        helper.make_node("ReduceL2", ["heard", "last"], ["loudness"], keepdims=0),
        helper.make_node("MatMul", ["loudness", "weights"], ["logits"]),
        helper.make_node("Softmax", ["logits"], ["probability"]),
        helper.make_node("LogSoftmax", ["logits"], ["log_probability"]),
    ]
    if not any("heard" in node.output for node in nodes):
        body.insert(0, helper.make_node("Identity", ["frames"], ["heard"]))
    values = [
        helper.make_tensor("weights", TensorProto.FLOAT, weights.shape, weights.ravel()),
        helper.make_tensor("last", TensorProto.INT64, [1], [2]),
        *constants,
    ]
    graph = helper.make_graph(
        [*nodes, *body], "foreign",
        [helper.make_tensor_value_info("frames", TensorProto.FLOAT, ["n", 2, 250])],
        [
            helper.make_tensor_value_info(name, TensorProto.FLOAT, ["n", POINTS])
            for name in ("probability", "log_probability")
        ],
        values,
    )  # fmt: skip
    model = helper.make_model(graph, opset_imports=[helper.make_opsetid("", opset)], ir_version=9)
    said = said_of(own)
    del said["sha256"]
    entry = model.metadata_props.add()
    entry.key, entry.value = KEY, json.dumps(said)
    onnx.save(model, path)
    return path


def endless():
    """Adds nothing to the frames, for about ever."""
    body = helper.make_graph(
        [helper.make_node("Identity", ["go"], ["on"]), helper.make_node("Mul", ["x", "x"], ["y"])], "again",
        [
            helper.make_tensor_value_info("i", TensorProto.INT64, []),
            helper.make_tensor_value_info("go", TensorProto.BOOL, []),
            helper.make_tensor_value_info("x", TensorProto.FLOAT, ["n", 2, 250]),
        ],
        [
            helper.make_tensor_value_info("on", TensorProto.BOOL, []),
            helper.make_tensor_value_info("y", TensorProto.FLOAT, ["n", 2, 250]),
        ],
    )  # fmt: skip
    constants = [
        helper.make_tensor("often", TensorProto.INT64, [], [2**62]),
        helper.make_tensor("true", TensorProto.BOOL, [], [True]),
    ]
    return [helper.make_node("Loop", ["often", "true", "frames"], ["heard"], body=body)], constants


def enormous():
    """Eight gigabytes of zeros."""
    nodes = [
        helper.make_node("ConstantOfShape", ["shape"], ["zeros"]),
        helper.make_node("ReduceSum", ["zeros"], ["nothing"], keepdims=0),
        helper.make_node("Add", ["frames", "nothing"], ["heard"]),
    ]
    return nodes, [helper.make_tensor("shape", TensorProto.INT64, [2], [2, 10**9])]


def grown():
    """Operators that the exporter uses too, which make more and more of the frames."""
    nodes = [
        helper.make_node("Reshape", ["frames", "column"], ["x0"]),
        helper.make_node("Reshape", ["frames", "row"], ["y0"]),
    ]
    nodes += [
        helper.make_node("Mul", ["x0", "y0"], ["square"]),
        helper.make_node("MatMul", ["square", "square"], ["cube"]),
    ]
    nodes += [
        helper.make_node("ReduceMax", ["cube"], ["most"], keepdims=0),
        helper.make_node("Add", ["frames", "most"], ["heard"]),
    ]
    return nodes, [
        helper.make_tensor("column", TensorProto.INT64, [2], [-1, 1]),
        helper.make_tensor("row", TensorProto.INT64, [2], [1, -1]),
    ]


def test_a_graph_of_the_exporter_runs_in_this_process(own, monkeypatch):
    monkeypatch.setattr(ForeignGraph, "__init__", lambda *_: pytest.fail("a process was started"))
    assert fault_of_graph(onnx.load(own)) is None
    assert localize.OnnxLocalizer(own).point_count == POINTS


def test_another_graph_runs_in_a_process_of_its_own(own, tmp_path):
    path = foreign(own, tmp_path / "foreign.onnx")
    assert "it holds the operator" in fault_of_graph(onnx.load(path))
    read = localize.OnnxLocalizer(path)
    assert isinstance(read._graph, ForeignGraph)
    signals = np.random.default_rng(1).standard_normal((100, 2, 250))
    weights = np.random.default_rng(0).standard_normal((2, POINTS)).astype(np.float32)
    logits = np.linalg.norm(signals, axis=-1) @ weights
    assert (read.locate(signals).argmax(1) == logits.argmax(1)).all()
    read._graph.close()
    assert not read._graph._child.is_alive


def test_a_graph_that_does_not_end_is_stopped(own, tmp_path, monkeypatch):
    monkeypatch.setattr(foreign_graph, "LONGEST", 2.0)
    nodes, constants = endless()
    path = foreign(own, tmp_path / "endless.onnx", *nodes, constants=constants)
    assert "Loop" in fault_of_graph(onnx.load(path))
    with refused(Kind.STOPPED, file="endless.onnx", error=localize.LocalizerError):
        localize.OnnxLocalizer(path)


def test_a_graph_that_takes_more_memory_than_it_may_is_refused(own, tmp_path):
    nodes, constants = enormous()
    path = foreign(own, tmp_path / "large.onnx", *nodes, constants=constants)
    assert "ConstantOfShape" in fault_of_graph(onnx.load(path))
    with pytest.raises(localize.LocalizerError, match=r"large\.onnx: its graph (cannot be run|ended the process)"):
        localize.OnnxLocalizer(path)


def test_values_that_grow_by_plain_operators_are_seen_before_they_are_made(own, tmp_path):
    nodes, constants = grown()
    path = foreign(own, tmp_path / "grown.onnx", *nodes, constants=constants)
    model = onnx.load(path)
    for node in model.graph.node:  # all but what the exporter does not use
        if node.op_type == "ReduceL2":
            node.op_type = "ReduceSum"
        elif node.op_type == "Identity":
            node.op_type = "Abs"
    found = fault_of_graph(model)
    assert "bytes" in found
    assert float(found.split()[3]) > LARGEST_VALUES


def changed(own, path, **change):
    model = onnx.load(own)
    said = said_of(own) | change
    del said["sha256"]
    model.metadata_props[0].value = json.dumps(said)
    onnx.save(model, path)


@pytest.mark.parametrize(
    "change",
    [
        {"sample_rate": 8000.0},
        {"frame": 999},
        {"unit": "mPa"},
        {"noise_rms": -1.0},
        {"noise_rms": "design"},
        {"kind": "oracle"},
        {"design": None},
        {"microphones": ["left"]},
        {"more": 1},
        {"version": "1"},
    ],
    ids=str,
)
def test_a_description_of_something_else_is_refused_by_the_field(own, tmp_path, change):
    changed(own, tmp_path / "changed.onnx", **change)
    with pytest.raises(localize.LocalizerError) as found:
        localize.OnnxLocalizer(tmp_path / "changed.onnx")
    ((field, value),) = change.items()
    assert (found.value.file, found.value.field, found.value.value) == (str(tmp_path / "changed.onnx"), field, value)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"microphones": ["a", "b", "c"]}, r"frames is \(n, 2, 250\) of FLOAT, must be \(n, 3, 250\)"),
        ({"line": [0, 0], "place": [0, 1]}, r"is \(n, 5\) of FLOAT, must be \(n, 2\)"),
    ],
)
def test_a_graph_of_another_array_than_it_describes_is_refused(own, tmp_path, change, message):
    changed(own, tmp_path / "changed.onnx", **change)
    with pytest.raises(localize.LocalizerError, match=message):
        localize.OnnxLocalizer(tmp_path / "changed.onnx")


@pytest.mark.parametrize("missing", ["sample_rate", "unit", "line", "microphones", "provenance", "noise_rms"])
def test_a_description_without_a_field_is_refused_by_it(own, tmp_path, missing):
    model = onnx.load(own)
    said = said_of(own)
    del said[missing]
    model.metadata_props[0].value = json.dumps(said)
    onnx.save(model, tmp_path / "without.onnx")
    with refused(Kind.MISSING, missing, file=tmp_path / "without.onnx", error=localize.LocalizerError):
        localize.OnnxLocalizer(tmp_path / "without.onnx")


def test_other_inputs_outputs_and_values_elsewhere_are_refused(own, tmp_path):
    def renamed(model):
        model.graph.input[0].name = model.graph.node[0].input[0] = "signals"

    def unasked(model):
        del model.graph.output[1]

    def closed(model):
        model.graph.input[0].type.tensor_type.shape.dim[0].dim_value = 1

    def double(model):
        model.graph.input[0].type.tensor_type.elem_type = TensorProto.DOUBLE

    def elsewhere(model):
        model.graph.initializer[0].data_location = TensorProto.EXTERNAL

    def endless_values(model):
        weights = next(each for each in model.graph.initializer if each.name == "weights")
        weights.float_data[0] = np.nan

    for change in (renamed, unasked, closed, double, elsewhere, endless_values):
        model = onnx.load(foreign(own, tmp_path / "other.onnx"))
        change(model)
        (tmp_path / "other.onnx").write_bytes(model.SerializeToString())
        with refused(Kind.UNSUITABLE, file="other.onnx", error=localize.LocalizerError):
            localize.OnnxLocalizer(tmp_path / "other.onnx")


def test_metadata_that_are_no_json_are_refused(own, tmp_path):
    model = onnx.load(own)
    for text in ("", "{", "[" * 5000, "null", "[1]"):
        model.metadata_props[0].value = text
        onnx.save(model, tmp_path / "text.onnx")
        with pytest.raises(localize.LocalizerError):
            localize.OnnxLocalizer(tmp_path / "text.onnx")


def test_no_flipped_bit_changes_a_graph_in_silence(own, tmp_path):
    content = own.read_bytes()
    random = np.random.default_rng(5)
    for _ in range(60):
        damaged = bytearray(content)
        damaged[random.integers(len(content))] ^= 1 << random.integers(8)
        (tmp_path / "flipped.onnx").write_bytes(damaged)
        with pytest.raises(localize.LocalizerError, match=r"flipped\.onnx: "):
            localize.OnnxLocalizer(tmp_path / "flipped.onnx")
