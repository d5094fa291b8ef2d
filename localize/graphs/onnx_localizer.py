"""A localizer read from an ONNX file, run by ONNX Runtime: signals in, probability per point out, without torch."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from geometry.ground.caller_warnings import warn_caller
from geometry.ground.file_checks import library_reads, read_bytes
from geometry.ground.record import is_sealed
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.text_files import parse_json
from geometry.ground.typed import Array
from localize.graphs.description import (
    LARGEST_MODEL,
    GraphDescription,
    LocalizerError,
    check_format,
    described,
)
from localize.graphs.foreign_graph import ForeignGraph
from localize.graphs.graph_check import BATCH, INPUT, OUTPUTS, check_interface, fault_of_graph
from localize.signals.array_facts import ArrayFacts
from localize.signals.frames import FRAME, combined_probability, cut_frames
from localize.signals.locator import Locator

if TYPE_CHECKING:
    from onnx import ModelProto

FORMAT = "acoustic-fem onnx"
VERSION = 1
KEY = "acoustic-fem"
"""Key of the JSON text among the metadata of a file."""
PRODUCER = "acoustic-fem"
"""Name of the program that every file states; a program that converts graphs puts its own, or another opset."""


class ConvertedGraphWarning(UserWarning):
    """Another program converted a graph, so its checksum cannot say whether it is whole."""


class OnnxLocalizer(Locator):
    """Localizer read from an ONNX file, run by ONNX Runtime on one thread.

    Args:
        path: a file that :func:`export_onnx` wrote. Another graph that says the same of itself runs in a process of its
            own, with limits of time and memory.

    Raises:
        LocalizerError: the file cannot be read, is cut short, changed or not of a localizer, or its graph cannot be
            run.
    """

    def __init__(self, path: str | os.PathLike[str]) -> None:
        import onnx

        content = read_bytes(path, "the graph of a localizer", LocalizerError, LARGEST_MODEL)
        with library_reads(path, "an ONNX file", LocalizerError):
            model = onnx.load_model_from_string(content)
        if not model.HasField("graph"):
            raise LocalizerError("is cut short or not an ONNX file: it holds no graph", kind=Kind.UNREADABLE, file=path)
        stated = _read_description(model, path)
        self.description: dict[str, Any] = stated.model_dump()
        self._kind = str(stated.kind)
        self.array = ArrayFacts(
            stated.design,
            tuple(stated.microphones),
            np.asarray(stated.line, np.int64),
            np.asarray(stated.place, np.int64),
            stated.provenance,
            stated.noise_rms,
        )
        try:
            check_interface(model, len(self.microphones), self.point_count)
        except Refusal as error:
            raise LocalizerError.of(error, file=path) from None
        self._path = path
        self._graph = (
            ForeignGraph(content, str(path), LocalizerError) if fault_of_graph(model) else _OwnGraph(content, path)
        )
        self._try()

    def _try(self) -> None:
        """Refuse a graph that gives no probabilities of a frame."""
        shape = (2, len(self.microphones), FRAME)
        score = self._graph.run(np.random.default_rng(0).standard_normal(shape).astype(np.float32))
        total = np.exp(score.astype(np.float64)).sum(-1)
        if score.shape != (2, self.point_count) or not np.allclose(total, 1.0, atol=1e-3):
            raise LocalizerError(
                f"its graph gives values {score.shape} of two frames, must give logarithms of probabilities of "
                f"{self.point_count} points",
                kind=Kind.UNSUITABLE,
                file=self._path,
            )

    @property
    def kind(self) -> str:
        """Kind of localizer that the graph holds."""
        return self._kind

    @property
    def assumptions(self) -> str:
        """Assumptions about the sensor or touches, in words."""
        return super().assumptions if self.kind == "network" else self.array.assumptions

    @property
    def no_graph(self) -> str:
        """Reason why no ONNX graph can hold this localizer, as a clause."""
        return "it is an ONNX file already"

    def _probability(self, batch: Array) -> Array:
        frames = cut_frames(batch)
        flat = frames.reshape(-1, *frames.shape[2:]).astype(np.float32)
        score = np.concatenate([self._graph.run(flat[k : k + BATCH]) for k in range(0, len(flat), BATCH)])
        return combined_probability(score.astype(np.float64).reshape(*frames.shape[:2], -1))


class _OwnGraph:
    """Graph that is known to end in little time and memory, run in this process."""

    def __init__(self, content: bytes, path: str | os.PathLike[str]) -> None:
        import onnxruntime

        options = onnxruntime.SessionOptions()
        options.intra_op_num_threads = options.inter_op_num_threads = 1
        options.log_severity_level = 4
        self._path = path
        with library_reads(path, "the graph of a localizer", LocalizerError):
            self._session = onnxruntime.InferenceSession(content, options, providers=["CPUExecutionProvider"])

    def run(self, frames: NDArray[np.float32]) -> NDArray[np.float32]:
        """(n, n_microphone, 250) Pa to log probabilities (n, n_point)."""
        with library_reads(self._path, "the graph of a localizer", LocalizerError):
            (score,) = self._session.run([OUTPUTS[1]], {INPUT: np.ascontiguousarray(frames)})
        return np.asarray(score)


def _read_description(model: ModelProto, path: str | os.PathLike[str]) -> GraphDescription:
    """Description in a graph's metadata; if it states a checksum, the graph must have it."""
    texts = [entry.value for entry in model.metadata_props if entry.key == KEY]
    if len(texts) != 1:
        raise LocalizerError(
            f"is not a localizer: its metadata have no {KEY!r}, or more than one", kind=Kind.UNREADABLE, file=path
        )
    values = parse_json(texts[0], str(path), LocalizerError)
    check_format(values, FORMAT, VERSION, path, LocalizerError)
    stated = described(GraphDescription, texts[0], path, LocalizerError)
    if stated.sha256 is None or is_sealed(values, bare_graph(model)):
        return stated
    converted = _conversion(model, stated)
    if not converted:
        raise LocalizerError(
            "is changed or damaged: its checksum differs from the one in it", kind=Kind.DAMAGED, file=path
        )
    warn_caller(
        f"{path}: another program converted the graph ({converted}), so its checksum does not hold; compare a few "
        "probabilities with those of the original",
        ConvertedGraphWarning,
    )
    return stated


def _conversion(model: ModelProto, stated: GraphDescription) -> str:
    """Sign that another program converted a graph, in words; empty where there is none."""
    opset = max((each.version for each in model.opset_import if not each.domain), default=0)
    for what, found, written in (
        ("opset", opset, stated.opset),
        ("version of the format", model.ir_version, stated.ir_version),
        ("producer", model.producer_name, PRODUCER),
    ):
        if written is not None and found != written:
            return f"its {what} is {found}, not {written}"
    return ""


def bare_graph(model: ModelProto) -> bytes:
    """All of a graph but its metadata, with which its checksum is taken."""
    bare = type(model)()
    bare.CopyFrom(model)
    del bare.metadata_props[:]
    return bare.SerializeToString(deterministic=True)
