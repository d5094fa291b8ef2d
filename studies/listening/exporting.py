"""A localizer as one ONNX graph."""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path

from geometry.ground.refusal import Refusal
from studies.listening.opening import Decoding, assumed_by, open_trained
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
    assumes: str
    """What it takes for granted of the sensor or of touches, in words."""


def export_decoder(
    model: str | os.PathLike[str],
    out: str | os.PathLike[str],
    *,
    noise: float | None = None,
    ambient: float | None = None,
) -> ExportedDecoder:
    """Write a localizer as one ONNX graph, from 250 samples of each microphone to the probability of each point.

    Args:
        model: the folder of a trained localizer, or a library for the model-based decoder.
        out: the file to write, such as ``localizer.onnx``; an earlier one is replaced.
        noise: for a library: the white noise of the microphones, Pa rms over 0 to 500 Hz; by default that of the
            design's.
        ambient: for a library: sound in the room up to this level, dB SPL; by default a quiet room.

    Raises:
        Refusal: a file that cannot be written or read, or a noise or sound for a trained localizer.
    """
    source, path = Path(model), Path(out)
    check_new_file(path, ".onnx", reads=(source,))
    if source.suffix == ".onnx":
        raise Refusal(f"{source}: is an ONNX file already; MODEL must be a localizer's folder or a library")
    from localize import BayesDecoder, export_onnx

    localizer = open_trained(source, noise, ambient)
    if ambient is not None and not isinstance(localizer, BayesDecoder):
        raise Refusal(f"`ambient` = {ambient:g} is for a library; {source} was trained with a sound of its own")
    if path.suffix.lower() != ".onnx":
        raise Refusal(f"out = {path} must end in .onnx, by which locate, live and evaluate know such a file")
    export_onnx(localizer, path)
    assumes = assumed_by(source, localizer, Decoding(noise, ambient=ambient))
    return ExportedDecoder(path, len(localizer.line), tuple(localizer.microphones), assumes)
