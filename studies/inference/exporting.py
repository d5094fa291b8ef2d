"""A localizer as one ONNX graph."""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path

import localize
from geometry.ground.refusal import Kind, Refusal
from localize.model.opened_model import Decoding, ModelSource, files_of, opened_as_designed
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
) -> ExportedDecoder:
    """Write a localizer as one ONNX graph, from 250 samples of each microphone to the probability of each point.

    Args:
        model: as of :func:`localize.open_model`: a trained localizer, or a library for the decoder of its sensor as it
            is.
        out: the file to write, such as ``localizer.onnx``; an earlier one is replaced.
        microphone_noise: for a library: noise of the microphones, white, Pa rms over 0 to 500 Hz, or "design".
        ambient: for a library: sound in the room up to this level, dB SPL; by default a quiet room.

    Raises:
        Refusal: a file that cannot be written or read, or a noise or sound for a trained localizer.
    """
    path = Path(out)
    check_new_file(path, ".onnx", reads=files_of(model))
    found = opened_as_designed(model, Decoding(microphone_noise=microphone_noise, ambient=ambient))
    if path.suffix.lower() != ".onnx":
        raise Refusal(kind=Kind.OUT_OF_RANGE, field="out", value=str(path), allowed="a name that ends in .onnx")
    localize.export_onnx(found.locator, path)
    return ExportedDecoder(path, found.locator.point_count, found.locator.microphones, found.assumptions)
