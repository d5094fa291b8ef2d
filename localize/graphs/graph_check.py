"""Checks of a graph: that it is one of a localizer, and that it ends in little time and memory, before it is run.

A graph of the exporter holds a few operators, none of which repeats or calls others, and the shape of every value
follows from the shape of the frames: what all values take together is then known. A graph of which this cannot be shown
runs in a process of its own (:mod:`localize.graphs.foreign_graph`).
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from geometry.ground.refusal import Kind, Refusal, said_by
from localize.signals.frames import FRAME

if TYPE_CHECKING:
    from onnx import ModelProto, NodeProto, ValueInfoProto

INPUT, OUTPUTS = "frames", ("probability", "log_probability")
BATCH = 64
"""Number of frames that are decoded at once."""
OPERATORS = frozenset((
    "Abs", "Add", "And", "ArgMax", "Atan", "AveragePool", "Cast", "Clip", "Concat", "Conv", "Div", "Equal", "Erf",
    "Exp", "Expand", "Gather", "GatherElements", "GatherND", "Gelu", "Gemm", "Greater", "IsNaN", "Less", "Log",
    "LogSoftmax", "MatMul", "Max", "Min", "Mul", "Neg", "NonZero", "Or", "Pow", "Reciprocal", "ReduceLogSumExp",
    "ReduceMax", "ReduceMean", "ReduceSum", "Relu", "Reshape", "ScatterND", "Shape", "Slice", "Softmax", "Sqrt",
    "Squeeze", "Sub", "Transpose", "Unsqueeze", "Where"
))  # fmt: skip
"""Operators that graphs of the exporter consist of; every one ends, and its work follows from the shapes of its
values."""
MOST_NODES = 5000
LARGEST_VALUES = 1.5e9
"""Most bytes that all values of a batch of frames may take together."""
MOST_WORK = 1e11
"""Most products that a batch of frames may take: some ten seconds of one core."""


def check_interface(model: ModelProto, microphones: int, points: int) -> None:
    """Refuse a graph that does not take frames of an array and give probabilities of its points.

    Args:
        model: the graph.
        microphones: number of channels of a frame.
        points: number of sensing points.

    Raises:
        Refusal: other inputs or outputs, values in other files, or values that are not finite.
    """
    from onnx import TensorProto, numpy_helper

    graph = model.graph
    own = {each.name for each in graph.initializer}
    inputs = {each.name: each for each in graph.input if each.name not in own}
    outputs = {each.name: each for each in graph.output}
    if list(inputs) != [INPUT]:
        raise Refusal(f"its inputs are {', '.join(inputs) or 'none'}; the one must be {INPUT}", kind=Kind.UNSUITABLE)
    if sorted(outputs) != sorted(OUTPUTS):
        raise Refusal(
            f"its outputs are {', '.join(outputs) or 'none'}; they must be {', '.join(OUTPUTS)}", kind=Kind.UNSUITABLE
        )
    for value, shape in (
        (inputs[INPUT], ("n", microphones, FRAME)),
        *((outputs[name], ("n", points)) for name in OUTPUTS),
    ):
        _check_shape(value, shape, stated=value.name == INPUT)
    for tensor in graph.initializer:
        if tensor.data_location == TensorProto.EXTERNAL:
            raise Refusal(
                f"the values of {tensor.name} lie in another file; they must be in this one", kind=Kind.UNSUITABLE
            )
        if tensor.data_type in (TensorProto.FLOAT, TensorProto.DOUBLE):
            try:
                values = numpy_helper.to_array(tensor)
            except Exception as error:  # whatever a library says of a tensor that it cannot read
                raise Refusal(f"the values of {tensor.name} are damaged: {said_by(error)}", kind=Kind.DAMAGED) from None
            if not np.isfinite(values).all():
                raise Refusal(f"the values of {tensor.name} are not all finite", kind=Kind.UNSUITABLE)


def _check_shape(value: ValueInfoProto, shape: tuple[str | int, ...], stated: bool) -> None:
    """The first axis is open, for any number of frames; the others are as they must be, where they are stated."""
    from onnx import TensorProto

    kind = value.type.tensor_type
    axes = [axis.dim_value if axis.HasField("dim_value") else None for axis in kind.shape.dim]
    is_open = not axes or axes[0] is None
    fits = len(axes) == len(shape) and all(
        found == wanted or (found is None and not stated) for found, wanted in zip(axes[1:], shape[1:], strict=True)
    )
    if kind.elem_type != TensorProto.FLOAT or not is_open or not (fits or (not axes and not stated)):
        found = ", ".join("n" if axis is None else str(axis) for axis in axes)
        wanted = ", ".join(map(str, shape))
        name = TensorProto.DataType.Name(kind.elem_type) if kind.elem_type else "no type"
        raise Refusal(
            f"{value.name} is ({found}) of {name}, must be ({wanted}) of FLOAT, for any number n of frames",
            kind=Kind.UNSUITABLE,
        )


def fault_of_graph(model: ModelProto) -> str | None:
    """Why it is not known that a graph ends in little time and memory, in words; None where it is.

    Args:
        model: the graph, whose interface was checked.
    """
    from onnx import AttributeProto

    graph = model.graph
    if model.functions or graph.sparse_initializer or {each.domain for each in model.opset_import} != {""}:
        return "it holds functions, sparse values or operators of others"
    if len(graph.node) > MOST_NODES:
        return f"it has {len(graph.node)} operators, more than {MOST_NODES}"
    plain = {
        AttributeProto.FLOAT,
        AttributeProto.INT,
        AttributeProto.STRING,
        AttributeProto.FLOATS,
        AttributeProto.INTS,
    }
    for node in graph.node:
        if node.domain or node.op_type not in OPERATORS or any(each.type not in plain for each in node.attribute):
            return f"it holds the operator {node.op_type}"
    shapes = _shapes(model)
    return shapes if isinstance(shapes, str) else _too_large(model, shapes)


@dataclass(frozen=True)
class _Value:
    """Shape and type of a value: the lengths of its axes, open ones by name, and the bytes of an entry."""

    axes: tuple[int | str, ...]
    bytes: int


def _shapes(model: ModelProto) -> dict[str, _Value] | str:
    """Shape and type of every value for a batch of frames; or the reason why they are not known."""
    import onnx

    batch = onnx.ModelProto()
    batch.CopyFrom(model)
    own = {each.name for each in batch.graph.initializer}
    for value in batch.graph.input:
        if value.name not in own:
            value.type.tensor_type.shape.dim[0].dim_value = BATCH
    for value in batch.graph.output:
        value.type.tensor_type.ClearField("shape")
    del batch.graph.value_info[:]
    try:
        found = onnx.shape_inference.infer_shapes(batch, check_type=True, strict_mode=True, data_prop=True).graph
        shapes = {}
        for value in (*found.input, *found.value_info, *found.output):
            kind = value.type.tensor_type
            axes = tuple(axis.dim_value if axis.HasField("dim_value") else axis.dim_param for axis in kind.shape.dim)
            shapes[value.name] = _Value(axes, onnx.helper.tensor_dtype_to_np_dtype(kind.elem_type).itemsize)
        for tensor in batch.graph.initializer:
            bytes_each = onnx.helper.tensor_dtype_to_np_dtype(tensor.data_type).itemsize
            shapes[tensor.name] = _Value(tuple(tensor.dims), bytes_each)
    except Exception as error:  # whatever a library says of a graph that it cannot follow
        return f"its shapes are not known: {type(error).__name__}"
    return shapes


def _too_large(model: ModelProto, shapes: Mapping[str, _Value]) -> str | None:
    """Reason why the values of a batch of frames are too many, or not known to be few."""
    longest: dict[str, int] = {}
    total = work = 0.0
    for node in model.graph.node:
        lengths: dict[str, list[int]] = {}
        for name in filter(None, (*node.input, *node.output)):
            axes = shapes[name].axes if name in shapes else ("",)
            for axis in axes:
                if isinstance(axis, str) and axis not in longest:
                    # As many as are not zero: an axis whose length only the values say.
                    if node.op_type != "NonZero" or not axis:
                        return f"the shape of a value of {node.op_type} is not known"
                    longest[axis] = math.prod(lengths[node.input[0]])
            lengths[name] = [longest[axis] if isinstance(axis, str) else axis for axis in axes]
        made = [name for name in node.output if name]
        total += sum(math.prod(lengths[name]) * shapes[name].bytes for name in made)
        of_each = _products(node, lengths)
        work += sum(math.prod(lengths[name]) * of_each for name in made) + sum(map(math.prod, lengths.values()))
    if total > LARGEST_VALUES or work > MOST_WORK:
        return f"its values take {total:.2g} bytes and {work:.2g} products for {BATCH} frames"
    return None


def _products(node: NodeProto, lengths: Mapping[str, list[int]]) -> int:
    """How many products an entry of the result takes."""
    if node.op_type == "MatMul":
        return lengths[node.input[0]][-1]
    if node.op_type == "Gemm":
        return max(lengths[node.input[0]])
    if node.op_type == "Conv":
        return math.prod(lengths[node.input[1]][1:])
    if node.op_type == "AveragePool":
        return math.prod(size for each in node.attribute if each.name == "kernel_shape" for size in each.ints)
    return 1
