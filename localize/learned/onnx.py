"""A localizer as one ONNX graph, from a frame of samples to probabilities: for any runtime that reads ONNX.

Both kinds have the same input, ``frames`` (n, n_microphone, 250) float32 in Pa at 1 kHz, and the same outputs,
``probability`` and ``log_probability``, (n, n_point) float32. The file also holds the other facts that a runtime needs,
as JSON under the key ``acoustic-fem``: points, microphones, sample rate, frame, what a stream does with its samples
before it cuts frames, noise, and the versions that it was made with.

A network's graph holds its features. The model-based decoder's graph computes the likelihood of
:mod:`localize.decoders.bayes`. Likelihoods are differences of large numbers, a million times larger than what decides
between two points when the signal stands 60 dB above the noise: single precision is not enough to rank the best
points, and double precision takes twice the time, which goes into reading the tables. So all points are scored in
single precision, then those that may be the best in double, as many as they are: one in a clear frame, all in one
that says nothing.
"""

from __future__ import annotations

import json
import logging
import os
import warnings
from pathlib import Path
from typing import TYPE_CHECKING, Any

import torch
from torch import Tensor, nn

from acoustic_fem.library.provenance import versions
from geometry.ground.argument_checks import check_range
from geometry.ground.record import sealed
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.whole_files import whole_file
from localize.decoders.library_decoder import LibraryDecoder
from localize.decoders.likelihood import DecoderTables
from localize.graphs.graph_check import INPUT, OUTPUTS
from localize.graphs.onnx_localizer import FORMAT, KEY, PRODUCER, VERSION, bare_graph
from localize.learned.localizer import Localizer
from localize.live.events import HOP
from localize.live.front_end import ORDER, high_pass_sections
from localize.live.stream_options import HIGH_PASS, StreamOptions
from localize.signals.frames import FRAME
from localize.signals.locator import Locator
from localize.signals.stimulus import SAMPLE_RATE

if TYPE_CHECKING:
    from onnx import ModelProto

OPSET = 20
"""Version of ONNX's operators where none is given."""
OPSETS = (18, 23)
"""Lowest and highest version that is written."""


def export_onnx(
    localizer: Locator, path: str | os.PathLike[str], *, opset: int | None = None, ir_version: int | None = None
) -> None:
    """Write a trained network or a model-based decoder as one ONNX file.

    Args:
        localizer: a network of :func:`localize.train`, or a :class:`localize.BayesDecoder`.
        path: of the file, such as ``localizer.onnx``; it is there whole or not at all.
        opset: version of ONNX's operators, 18 to 23, for a runtime that knows no later ones; 20 by default.
        ir_version: version of the file format, from the lowest that ``opset`` allows, which is the default, to the
            newest of the installed onnx.

    Raises:
        Refusal: an opset or a version of the format that cannot be written; a localizer that no graph can hold, such as
            :class:`localize.TolerantDecoder`, which fits deviations to each frame, or :class:`localize.DriftDecoder`,
            which follows its sensor from touch to touch.
    """
    if localizer.no_graph:
        problem = f"cannot be written as a graph: {localizer.no_graph}"
        raise Refusal(problem, kind=Kind.UNSUITABLE, field="localizer")
    if isinstance(localizer, Localizer):
        graph: nn.Module = _NetworkGraph(localizer)
    else:
        assert isinstance(localizer, LibraryDecoder)
        graph = DecoderGraph(localizer)
    opset = OPSET if opset is None else int(check_range("opset", opset, *OPSETS, whole=True))
    versions_of_format = _ir_versions(opset)
    if ir_version is not None:
        check_range("ir_version", ir_version, *versions_of_format, whole=True, why=f"for opset {opset}")
    model = _translated(graph.eval(), len(localizer.microphones), opset)
    model.ir_version = versions_of_format[0] if ir_version is None else ir_version
    description = {**_description(localizer, opset), "ir_version": model.ir_version}
    model.producer_name, model.producer_version = PRODUCER, description["versions"]["code_version"]
    _explain(model, description)
    del model.metadata_props[:]
    entry = model.metadata_props.add()
    entry.key, entry.value = KEY, json.dumps(sealed(description, bare_graph(model)))
    with whole_file(Path(path)) as beside:
        beside.write_bytes(model.SerializeToString())


class _NetworkGraph(nn.Module):
    """Frames to probabilities and their logarithms."""

    def __init__(self, localizer: Localizer) -> None:
        super().__init__()
        self.classifier = localizer.classifier

    def forward(self, frames: Tensor) -> tuple[Tensor, Tensor]:
        """(n, n_microphone, 250) to two of (n, n_point)."""
        logits = self.classifier(frames)
        return logits.softmax(-1), logits.log_softmax(-1)


class DecoderGraph(nn.Module):
    """Graph of the likelihood of :class:`localize.BayesDecoder`, all points in single precision, the best in double."""

    def __init__(self, decoder: LibraryDecoder) -> None:
        super().__init__()
        several = len(decoder.tables) > 1
        self._sure_lead = decoder.options.sure_lead
        self._levels = tuple(_LevelGraph(tables, several) for tables in decoder.tables)
        self.levels = nn.ModuleList(self._levels)

    def forward(self, frames: Tensor) -> tuple[Tensor, Tensor]:
        """Probabilities and their logarithms.

        Args:
            frames: (n, n_microphone, 250) float32, Pa, at 1 kHz.

        Returns:
            Two of (n, n_point) float32: probability per point, and its logarithm, nats.
        """
        flat = frames.double().flatten(1)
        levels = [(level, *level.screened(flat)) for level in self._levels]
        # Points are left to single precision only where none of any level may come near the best of all.
        least = torch.stack([score.amax(0) - error for _, _, score, error in levels]).amax(0) - self._sure_lead
        score = torch.stack([level.again(x, score, least - error) for level, x, score, error in levels]).amax(0).T
        return score.softmax(-1).float(), score.log_softmax(-1).float()


class _LevelGraph(nn.Module):
    """The same for one level of the sound around."""

    reduce: Tensor
    screen: Tensor
    screen_weight: Tensor
    screen_determinant: Tensor
    vectors: Tensor
    weight: Tensor
    determinant: Tensor

    def __init__(self, tables: DecoderTables, is_one_of_several: bool) -> None:
        super().__init__()
        self.is_one_of_several = is_one_of_several
        reduce, vectors, weight, determinant = (
            torch.from_numpy(table) for table in (tables.reduce, tables.vectors, tables.weight, tables.log_determinant)
        )
        self.points, size, self.rank = vectors.shape
        self.offset = tables.offset
        self.screen_error, self.temperature = tables.options.screen_error, tables.options.temperature
        for name, table in (
            ("reduce", reduce),
            # One matrix for all points: (n_microphone SAMPLES, n_point rank).
            ("screen", vectors.float().movedim(0, 1).reshape(size, -1).contiguous()),
            ("screen_weight", weight.float()),
            ("screen_determinant", determinant.float()),
            ("vectors", vectors),
            ("weight", weight),
            ("determinant", determinant),
        ):
            self.register_buffer(name, table)

    def screened(self, frames: Tensor) -> tuple[Tensor, Tensor, Tensor]:
        """(n, n_microphone 250) to white frames, scores (n_point, n) in single precision, and their error (n,)."""
        x = frames @ self.reduce
        energy = (x.float() @ self.screen).square().unflatten(1, (self.points, self.rank))
        # (point, n, power): one matrix product per point.
        values = -0.5 * (energy.transpose(0, 1) @ self.screen_weight + self.screen_determinant[:, None, :])
        # Of large numbers single precision knows no parabola; a true one rises by less than a nat above its samples.
        score = torch.minimum(_vertex(values), values.amax(-1) + 1).double()
        return x, score + self._alone(x), self.screen_error * x.square().sum(1)

    def again(self, x: Tensor, score: Tensor, least: Tensor) -> Tensor:
        """Scores (n_point, n), in double precision of the points that may reach ``least`` (n,)."""
        # The points that any frame of the batch needs: tables are then gathered once for all of them.
        # Never none of a level: ONNX Runtime multiplies no empty tables.
        best = ((score > least) | (score == score.amax(0))).any(1).nonzero().squeeze(1)
        gain = (x @ self.vectors[best]).square() @ self.weight[best]
        exact = _vertex(-0.5 * (gain + self.determinant[best][:, None, :]))
        return score.index_put((best,), exact + self._alone(x))

    def _alone(self, x: Tensor) -> Tensor:
        """(n,) nats, of noise and sound without a touch, as in :mod:`localize.decoders.bayes` of one level."""
        if not self.is_one_of_several:
            return torch.zeros_like(x[:, 0])
        return self.offset - x.square().sum(1) / (2 * self.temperature)


def _vertex(values: Tensor) -> Tensor:
    """Maximum of the parabola around the largest value along the last axis, as in :mod:`localize.decoders.bayes`."""
    best = values.argmax(-1, keepdim=True)
    inner = best.clamp(1, values.shape[-1] - 2)
    left, middle, right = (values.gather(-1, inner + k) for k in (-1, 0, 1))
    bend = left - 2 * middle + right
    is_top = (best == inner) & (bend < 0)
    rise = -((right - left) ** 2) / (8 * torch.where(is_top, bend, -1.0))
    return torch.where(is_top, middle + rise, values.amax(-1, keepdim=True)).squeeze(-1)


def _ir_versions(opset: int) -> tuple[int, int]:
    """Lowest version of the file format that an opset allows, and the newest of the installed onnx."""
    import onnx

    return onnx.helper.find_min_ir_version_for([onnx.helper.make_opsetid("", opset)]), onnx.IR_VERSION


def _explain(model: ModelProto, description: dict[str, Any]) -> None:
    """Say in the graph itself what its values are, for a reader who has only the file."""
    microphones = ", ".join(description["microphones"])
    stream = description["stream"]
    for value in model.graph.input:
        value.doc_string = (
            f"(n, {len(description['microphones'])}, {FRAME}) pressure in Pa at {SAMPLE_RATE:g} Hz of the microphones "
            f"{microphones}, behind a Butterworth high-pass of order {stream['high_pass_order']} at "
            f"{stream['high_pass']:g} Hz; frames below {stream['silence']:g} Pa rms hold no touch"
        )
    for value, what in zip(model.graph.output, ("probability", "natural logarithm of the probability"), strict=True):
        value.doc_string = f"(n, {len(description['line'])}) {what} of each point, from point 1"


def _translated(graph: nn.Module, microphones: int, opset: int) -> ModelProto:
    """By torch's exporter, the batch left open."""
    # It warns of operators of a package that is not installed and not used here, and of its own old habits.
    logging.getLogger("torch.onnx._internal.exporter._registration").setLevel(logging.ERROR)
    frames = torch.randn(2, microphones, FRAME, generator=torch.Generator().manual_seed(0))
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", r"`isinstance\(treespec, LeafSpec\)` is deprecated", FutureWarning)
        program = torch.onnx.export(
            graph,
            (frames,),
            input_names=[INPUT],
            output_names=[*OUTPUTS],
            opset_version=opset,
            dynamo=True,
            dynamic_shapes={"frames": {0: torch.export.Dim("n")}},
            verbose=False,
        )
    if program is None:
        raise RuntimeError("torch.onnx.export returned no program")
    return program.model_proto


def _description(localizer: Locator, opset: int) -> dict[str, Any]:
    """Description that a file carries."""
    return {
        "format": FORMAT,
        "version": VERSION,
        "kind": localizer.kind,
        "design": localizer.design,
        "microphones": list(localizer.microphones),
        "line": localizer.line.tolist(),
        "place": localizer.place.tolist(),
        "sample_rate": SAMPLE_RATE,
        "frame": FRAME,
        "unit": "Pa",
        "noise_rms": localizer.noise_rms,
        "stream": {
            "high_pass": HIGH_PASS,
            "high_pass_order": ORDER,
            "high_pass_sections": high_pass_sections(HIGH_PASS).tolist(),
            "hop": HOP,
            "silence": StreamOptions().silence_of(localizer.noise_rms),
        },
        "opset": opset,
        "versions": versions(0, ("numpy", "onnx", "onnxscript", "scipy", "torch")),
        "provenance": dict(localizer.provenance),
    }
