"""The decoder of a library as C files for a microcontroller."""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path

from geometry.ground.refusal import Field, Kind, Refusal
from geometry.ground.text_files import read_text
from geometry.ground.whole_files import write_text
from localize.embedded.boards import BoardName
from localize.embedded.budget import Budget
from localize.embedded.c_export import EmbeddedDecoder, embed
from localize.embedded.converter import AT_OVERLOAD, Converter
from localize.embedded.decoder_tables import Precision
from localize.model.opening import ModelSource, files_of, open_library
from localize.signals.array_response import response_of
from localize.signals.noise_model import NoiseChoice
from studies.output.call_defaults import BOARD, EMBEDDED_PREFIX, PRECISION
from studies.output.folders import check_folder, claimed_folder, replaced_files

#: List of the files of an earlier call, and a file by which a folder of one without it is known.
_LIST, _MARK = "decoder-files.txt", "touch_decoder.h"
#: What follows the prefix in the name of a header that every project has.
_HEADER = "_decoder.h"


@dataclass(frozen=True, eq=False)
class EmbeddedFiles:
    """Decoder that was written as C."""

    out: Path
    """Folder of the files."""
    decoder: EmbeddedDecoder
    """Texts of the files, and what the decoder costs."""
    assumptions: str
    """Assumptions of the decoder about the sensor, in words."""


def embed_decoder(
    library: ModelSource,
    out: str | os.PathLike[str],
    *,
    precision: Precision = PRECISION,
    budget: str | None = None,
    microphone_noise: NoiseChoice = "design",
    prefix: str = EMBEDDED_PREFIX,
    converter: Converter = AT_OVERLOAD,
    board: BoardName = BOARD,
) -> EmbeddedFiles:
    """Write the decoder of a library, which needs no training, as C99 for the microcontroller on the sensor.

    Args:
        library: library of the array: a path, a library or an open model. Tolerances are not modelled.
        out: a folder, created if needed. Only files of an earlier call with the same prefix are replaced.
        precision: number type of the large tables, ``float32`` or ``int16``.
        budget: limits of the microcontroller, such as ``flash=512k,ram=16k,instructions=2.5M``; by default no limits.
        microphone_noise: white noise of the microphones, Pa rms over 0 to 500 Hz, or "design" for that of the design's
            microphone.
        prefix: first part of all global names in the C files and of the files' names, for two arrays in one program,
            each in its own folder.
        converter: converter that samples the microphones; by default one whose full scale is the pressure at which the
            design's microphone overloads.
        board: board whose sources are added: ``cortex-m``, ``zephyr`` or ``arduino``.

    Raises:
        Refusal: over the budget, with the numbers; a file that cannot be read, a folder of others or of another prefix,
            or as :func:`localize.embedded.embed`.
    """
    folder = Path(out)
    check_folder(folder, "embed", _LIST, _MARK, reads=files_of(library))
    _check_own_prefix(folder, prefix)
    left = None if budget is None else Budget.stated(budget)
    response = response_of(open_library(library))
    decoder = embed(response, precision, microphone_noise, left, prefix=prefix, converter=converter, board=board)
    with claimed_folder(folder, "embed", _LIST, _MARK, reads=files_of(library)):
        _check_own_prefix(folder, prefix)
        with replaced_files(folder, _LIST) as fresh:
            for name, text in decoder.files.items():
                write_text(fresh / name, text)
    return EmbeddedFiles(folder, decoder, response.array.assumptions)


def _check_own_prefix(folder: Path, prefix: str) -> None:
    """Refuse a folder that holds the project of another prefix, whose files would be removed.

    Raises:
        Refusal: as said.
    """
    listed = folder / _LIST
    names = read_text(listed, "a list of files", Refusal).splitlines() if listed.exists() else [_MARK]
    for name in names:
        earlier = name.removesuffix(_HEADER)
        if earlier not in (name, prefix) and (folder / name).exists():
            raise Refusal(
                ("holds the project of ", Field("prefix"), f" {earlier}, which would be removed"),
                kind=Kind.EXISTS,
                file=folder,
                field=Field("out"),
                remedy="give each prefix its own folder",
            )
