"""Verbs that export a decoder to another program or chip: onnx, embed."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, cast

import typer

import localize
import studies
from geometry.ground.refusal import counted
from studies.cli.options import DecoderAmbient, DecoderNoise, LibraryFile, noise_choice
from studies.cli.terminal_tables import show, table_of, tell
from studies.output.call_defaults import BOARD, CONVERTER_BITS, EMBEDDED_PREFIX, PRECISION

if TYPE_CHECKING:
    from localize.embedded.boards import BoardName
    from localize.embedded.decoder_tables import Precision


def onnx(
    model: Annotated[
        Path,
        typer.Argument(
            metavar="MODEL",
            help="The folder of a trained localizer, or a library, whose Bayes decoder is then exported.",
        ),
    ],
    out: Annotated[Path, typer.Option(help="File to write, such as localizer.onnx.")],
    noise: DecoderNoise = None,
    ambient: DecoderAmbient = None,
    opset: Annotated[
        int | None,
        typer.Option(help="Version of ONNX's operators, 18 to 23: lower it for an old runtime. Default: 20."),
    ] = None,
    ir: Annotated[
        int | None,
        typer.Option(help="Version of the file format. Default: the lowest that the operators allow."),
    ] = None,
) -> None:
    """Export a localizer as one ONNX graph.

    Writes a graph that maps 250 samples of each microphone to the probability of each point.

    Example: [bold]acoustic-fem onnx localizer --out localizer.onnx[/bold]
    """
    written = studies.export_decoder(
        model, out, microphone_noise=noise_choice(noise), ambient=ambient, opset=opset, ir_version=ir
    )
    tell(
        f"{out}: {counted(written.points, 'point')}, {counted(len(written.microphones), 'microphone')}, "
        f"{out.stat().st_size / 1e6:.1f} MB"
    )
    tell(f"the decoder assumes {written.assumptions}")


def embed(
    library: LibraryFile,
    out: Annotated[Path, typer.Option(help="Folder to write the C files to.")],
    precision: Annotated[
        str,
        typer.Option(
            metavar="float32|int16", help="Number type of the large tables. int16 needs three fifths of the flash."
        ),
    ] = PRECISION,
    budget: Annotated[
        str | None,
        typer.Option(
            metavar="BUDGET",
            help="Limits of the chip, such as flash=512k,ram=16k,stack=4k,instructions=2.5M: bytes (k is 1024), and "
            "instructions of a decision, every 16 ms. If the decoder alone needs more, nothing is written; the rest of "
            "the firmware is smaller: docs/embed.md#cost. Default: no limits.",
        ),
    ] = None,
    noise: DecoderNoise = None,
    prefix: Annotated[
        str,
        typer.Option(
            help="First part of all global names and of the files' names, for two arrays in one program. Each needs "
            "its own folder."
        ),
    ] = EMBEDDED_PREFIX,
    board: Annotated[
        str, typer.Option(metavar="cortex-m|zephyr|arduino", help="Board or system whose sources are added.")
    ] = BOARD,
    converter_volts: Annotated[
        float | None,
        typer.Option(
            metavar="V",
            help="Voltage of the microphone, before any amplifier, that gives the converter's largest sample. With the "
            "design's sensitivity it gives the pressure of a sample. Default: that at the microphone's overload.",
        ),
    ] = None,
    full_scale: Annotated[
        float | None,
        typer.Option(
            metavar="PA", help="Pressure of the largest sample, for digital microphones, in place of --converter-volts."
        ),
    ] = None,
    converter_bits: Annotated[int, typer.Option(help="Bits of a sample, 8 to 16.")] = CONVERTER_BITS,
) -> None:
    """Export the decoder of a library as C99 source for a microcontroller.

    Writes C files, a test and README.md. The code reads samples and returns the touched point. It needs no training, no
    heap and no library but math.h. It decodes the sensor that the library describes, so calibrate first. The firmware
    reads the converter and sends touches or samples over a serial line, which live --serial reads. docs/embed.md lists
    the decoders that fit on common chips.

    Example: [bold]acoustic-fem embed library.nc --out firmware --budget flash=512k[/bold]
    """
    chosen = cast("Precision", precision)
    written = studies.embed_decoder(
        library,
        out,
        precision=chosen,
        budget=budget,
        microphone_noise=noise_choice(noise),
        prefix=prefix,
        converter=localize.embedded.Converter(converter_volts, full_scale, converter_bits),
        board=cast("BoardName", board),
    )
    cost, table = written.decoder.cost, table_of("", "at most", numbers=(1,))
    for name, value in (("flash", cost.flash), ("ram", cost.ram), ("stack", cost.stack)):
        table.add_row(name, f"{value} bytes")
    table.add_row("instructions, a decision every 16 ms", str(cost.instructions))
    table.add_row("additional instructions of the first decision", str(cost.first))
    show(table)
    tables = written.decoder.tables
    tell(
        f"{out}: {counted(tables.point_count, 'point')}, {counted(len(tables.microphones), 'microphone')}, "
        f"{tables.precision}; how to build, call and wire it: {out / 'README.md'}"
    )
    scale = written.decoder.scale
    tell(
        f"largest sample of the firmware: {scale.largest}, {scale.full_scale:.4g} Pa, "
        f"{scale.pascals_per_step:.3g} Pa a step; {scale.source}"
    )
    tell(f"the decoder assumes {written.assumptions}")
