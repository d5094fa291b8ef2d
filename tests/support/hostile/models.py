"""Models that are damaged, or made by others to do harm."""

from __future__ import annotations

import json
import random
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import onnx
from onnx import TensorProto, helper

from hostile.damage import Change


def _localizer(*path: str | int, value: Any) -> Change:
    """Puts a value at a place of localizer.json."""

    def change(folder: Path, draw: random.Random) -> None:
        file = folder / "localizer" / "localizer.json"
        held = json.loads(file.read_text(encoding="utf-8"))
        place = held
        for step in path[:-1]:
            place = place[step]
        if value is _GONE:
            del place[path[-1]]
        else:
            place[path[-1]] = value
        file.write_text(json.dumps(held), encoding="utf-8")

    return change


_GONE = object()


def _wrong_places() -> Iterator[tuple[str, Change]]:
    for name in (
        "format",
        "version",
        "weights",
        "weights_sha256",
        "design",
        "microphones",
        "line",
        "place",
        "network",
        "plan",
        "training",
        "provenance",
    ):
        for value in (None, -1, "nonsense", [], {}):
            yield f"{name} = {value!r}", _localizer(name, value=value)
        yield f"{name} gone", _localizer(name, value=_GONE)
    for name in ("maps", "points", "width", "depths", "patch", "features"):
        for value in (None, "a", -1, 0, 10**9, [10**6] * 4, []):
            yield f"network.{name} = {value!r}"[:60], _localizer("network", name, value=value)
    for name in ("batch", "microphone_noise", "seed", "stimuli", "features", "ambient"):
        for value in ("nonsense", -1.5, [None]):
            yield f"plan.{name} = {value!r}", _localizer("plan", name, value=value)
    yield "a million microphones", _localizer("microphones", value=[f"M{k}" for k in range(10**6)])
    yield "a million layers", _localizer("network", "depths", value=[1] * 10**6)
    yield "a million points", _localizer("line", value=[0] * 10**6)
    yield "weights elsewhere", _localizer("weights", value="../library.nc")
    yield "a later version", _localizer("version", value=99)
    yield "two microphones of one name", _localizer("microphones", value=["A", "A"])
    yield "points renumbered", _localizer("place", value=[0, 0, 0])


LOCALIZER_CHANGES: tuple[tuple[str, Change], ...] = tuple(_wrong_places())


# -- ONNX -----------------------------------------------------------------------------------------------------
def _onnx(edit: Callable[[onnx.ModelProto], onnx.ModelProto | None]) -> Change:
    def change(folder: Path, draw: random.Random) -> None:
        path = str(folder / "decoder.onnx")
        model = onnx.load(path)
        onnx.save(edit(model) or model, path)

    return change


def _metadata(**fields: Any) -> Callable[[onnx.ModelProto], None]:
    """Sets fields of what our graphs say of themselves; None takes one away."""

    def edit(model: onnx.ModelProto) -> None:
        (entry,) = model.metadata_props
        held = json.loads(entry.value)
        for name, value in fields.items():
            assert name in held, sorted(held)
            held[name] = value
        entry.value = json.dumps({name: value for name, value in held.items() if value is not None})

    return edit


def _no_metadata(model: onnx.ModelProto) -> None:
    del model.metadata_props[:]


def _broken_metadata(model: onnx.ModelProto) -> None:
    model.metadata_props[0].value = "{"


def _renamed_input(model: onnx.ModelProto) -> None:
    old = model.graph.input[0].name
    model.graph.input[0].name = "sound"
    for node in model.graph.node:
        for k, name in enumerate(node.input):
            if name == old:
                node.input[k] = "sound"


def _foreign(model: onnx.ModelProto, nodes: list[onnx.NodeProto], extra: list[onnx.TensorProto] | None = None) -> None:
    """Another graph in the place of ours, with our input, outputs and metadata."""
    del model.graph.node[:]
    del model.graph.initializer[:]
    model.graph.node.extend(nodes)
    model.graph.initializer.extend(extra or [])


def _endless(model: onnx.ModelProto) -> None:
    """A loop of 2^62 rounds."""
    given, told = model.graph.input[0].name, model.graph.output[0].name
    body = helper.make_graph(
        [helper.make_node("Identity", ["go"], ["go_on"]), helper.make_node("Sin", ["x"], ["y"])],
        "round",
        [
            helper.make_tensor_value_info("round", TensorProto.INT64, []),
            helper.make_tensor_value_info("go", TensorProto.BOOL, []),
            helper.make_tensor_value_info("x", TensorProto.FLOAT, None),
        ],
        [
            helper.make_tensor_value_info("go_on", TensorProto.BOOL, []),
            helper.make_tensor_value_info("y", TensorProto.FLOAT, None),
        ],
    )
    rounds = helper.make_tensor("rounds", TensorProto.INT64, [], [2**62])
    go = helper.make_tensor("go_first", TensorProto.BOOL, [], [True])
    _foreign(model, [helper.make_node("Loop", ["rounds", "go_first", given], [told], body=body)], [rounds, go])


def _greedy(model: onnx.ModelProto) -> None:
    """Eight gigabytes, made of a number."""
    told = model.graph.output[0].name
    shape = helper.make_tensor("shape", TensorProto.INT64, [2], [2**16, 2**15])
    nodes = [
        helper.make_node("ConstantOfShape", ["shape"], ["much"]),
        helper.make_node("ReduceSum", ["much"], [told], keepdims=1),
    ]
    _foreign(model, nodes, [shape])


#: What else could stand in what a graph says of itself; None: it is missing.
KEYS: dict[str, tuple[Any, ...]] = {
    "format": ("other", None, 5),
    "version": (99, None, "1"),
    "kind": ("oracle", None),
    "microphones": ([], ["A", "A"], ["C", "D"], None, "AB", ["A"], 7),
    "place": ([0], [], None, "012"),
    "line": ([0], None),
    "sample_rate": (8000.0, 0, None, "fast", -1),
    "frame": (999, 0, None, 1e9),
    "unit": ("mPa", None, 5),
}


def _onnx_changes() -> Iterator[tuple[str, Change]]:
    yield "no metadata", _onnx(_no_metadata)
    for name, values in KEYS.items():
        for value in values:
            yield f"{name} = {value!r}", _onnx(_metadata(**{name: value}))
    yield "metadata that is no JSON", _onnx(_broken_metadata)
    yield "another input name", _onnx(_renamed_input)
    yield "an endless loop", _onnx(_endless)
    yield "eight gigabytes", _onnx(_greedy)


ONNX_CHANGES: tuple[tuple[str, Change], ...] = tuple(_onnx_changes())
