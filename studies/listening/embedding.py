"""The decoder of a library as C files for a microcontroller."""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, cast

from geometry.ground.refusal import Refusal
from geometry.ground.whole_files import write_text
from studies.output.folders import check_folder, replaced_files

if TYPE_CHECKING:
    from localize.embedded import EmbeddedDecoder, Precision
    from localize.signals.noise_model import NoiseChoice

PRECISION = "float32"
"""Precision of the large tables where a caller names none."""
#: By this file a folder is known as one of an earlier call.
_MARK = "touch_decoder.h"


@dataclass(frozen=True, eq=False)
class EmbeddedFiles:
    """Decoder that was written as C."""

    out: Path
    """Folder of the files."""
    decoder: EmbeddedDecoder
    """Texts of the files, and what the decoder costs."""
    assumes: str
    """What the decoder takes for granted of the sensor, in words."""


def embed_decoder(
    library: str | os.PathLike[str],
    out: str | os.PathLike[str],
    *,
    precision: str = PRECISION,
    budget: str | None = None,
    noise: float | None = None,
) -> EmbeddedFiles:
    """Write the decoder of a library, which needs no training, as C99 for the microcontroller on the sensor.

    Args:
        library: of the array; its sensor is decoded as it is.
        out: a folder, made if it does not exist. What it holds of an earlier call is replaced, and nothing else.
        precision: of the large tables, ``float32`` or ``int16``.
        budget: what the microcontroller has for it, such as ``flash=512k,ram=16k,instructions=2.5M``; by default all
            that it takes.
        noise: white noise of the microphones, Pa rms over 0 to 500 Hz; by default that of the design's.

    Raises:
        Refusal: over the budget, with the numbers; a file that cannot be read, a folder of others, or as
            :func:`localize.embedded.embed`.
    """
    source, folder = Path(library), Path(out)
    check_folder(folder, "embed", _MARK, reads=(source,))
    if source.is_dir() or source.suffix.lower() == ".onnx":
        raise Refusal(
            f"{source}: is no library; a network is too large for a microcontroller, a library's decoder is not"
        )
    import acoustic_fem
    from localize.decoders.bayes import assumed_of
    from localize.embedded import Budget, embed
    from localize.signals.array_response import response_of

    left = None if budget is None else Budget.stated(budget)
    level: NoiseChoice = "design" if noise is None else noise
    response = response_of(acoustic_fem.load(source))
    decoder = embed(response, cast("Precision", precision), level, left)
    with replaced_files(folder) as fresh:
        for name, text in decoder.files.items():
            write_text(fresh / name, text)
    return EmbeddedFiles(folder, decoder, assumed_of(response.provenance))
