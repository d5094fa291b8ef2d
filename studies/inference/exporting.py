"""A localizer as one ONNX graph."""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path

import localize
from geometry.ground.refusal import Kind, Refusal
from localize.model.decoding import Decoding
from localize.model.opening import ModelSource, files_of, opened_as_designed
from localize.signals.noise_model import NoiseChoice
from studies.output.folders import check_new_file


@dataclass(frozen=True)
class ExportedDecoder:
    """Graph that was written."""

    out: Path
    """File of the graph."""
    points: int
    """Number of points that it tells apart."""
    microphones: tuple[str, ...]
    """Names of the microphones, in the order of its input."""
    assumptions: str
    """Assumptions about the sensor or the touches, in words."""


def export_decoder(
    model: ModelSource,
    out: str | os.PathLike[str],
    *,
    microphone_noise: NoiseChoice = "design",
    ambient: float | None = None,
    opset: int | None = None,
    ir_version: int | None = None,
) -> ExportedDecoder:
    """Write a localizer as one ONNX graph. It maps 250 samples of each microphone to the probability of each point.

    Args:
        model: a trained localizer, or a library, whose Bayes decoder is then written; see :func:`localize.open_model`.
        out: the file to write, such as ``localizer.onnx``; an earlier one is replaced.
        microphone_noise: white noise of the microphones that the decoder of a library assumes, Pa rms over 0 to 500 Hz,
            or "design" for that of the design's microphone.
        ambient: highest level of room sound that the decoder of a library assumes, dB SPL; by default a quiet room.
        opset: version of ONNX's operators, 18 to 23; 20 by default.
        ir_version: version of the file format; by default the lowest that ``opset`` allows.

    Raises:
        Refusal: a file that cannot be written or read, or a noise or sound for a trained localizer.
    """
    path = Path(out)
    check_new_file(path, ".onnx", reads=files_of(model))
    found = opened_as_designed(model, Decoding(microphone_noise=microphone_noise, ambient=ambient))
    if path.suffix.lower() != ".onnx":
        raise Refusal(kind=Kind.OUT_OF_RANGE, field="out", value=str(path), allowed="a name that ends in .onnx")
    localize.export_onnx(found.locator, path, opset=opset, ir_version=ir_version)
    return ExportedDecoder(path, found.locator.point_count, found.locator.microphones, found.assumptions)
