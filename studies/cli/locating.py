"""Verbs that put a localizer to work: onnx, locate."""

from __future__ import annotations

from collections import Counter
from pathlib import Path
from typing import Annotated

import typer

from geometry.refusal import Refusal
from studies.cli.listening import Extras, open_localizer, open_stream, open_trained
from studies.cli.options import named
from studies.cli.tables import show, table_of

DecoderNoise = Annotated[
    float | None,
    typer.Option(
        help="For a library: the white noise of the microphones to assume instead, Pa rms over 0 to 500 Hz.",
        show_default="that of the design's",
    ),
]
DecoderAmbient = Annotated[
    float | None,
    typer.Option(
        metavar="DB",
        help="Expect sound in the room, up to this level in dB SPL.",
        show_default="a quiet room",
        min=0,
        max=140,
    ),
]
ArrayLibrary = Annotated[
    Path | None,
    typer.Option(
        help="The library of the array, for the options below.", show_default="MODEL, where that is a library"
    ),
]
RefusedShare = Annotated[
    float | None,
    typer.Option(
        metavar="SHARE",
        help="Call frames 'other' that no single point explains; so many true ones may be refused, such as 1e-6. "
        "For a calibrated sensor.",
        show_default="the likeliest point is named",
    ),
]


def onnx(
    model: Annotated[
        Path,
        typer.Argument(
            metavar="MODEL",
            help="A trained localizer (a folder), or a library (library.nc) for the model-based decoder.",
            show_default=False,
        ),
    ],
    out: Annotated[Path, typer.Option(help="The file to write, such as localizer.onnx.", show_default=False)],
    noise: DecoderNoise = None,
    ambient: DecoderAmbient = None,
) -> None:
    """Write a localizer as one ONNX graph, from 250 samples of each microphone to the probability of each point.

    Example: [bold]acoustic-fem onnx localizer --out localizer.onnx[/bold]
    """
    from studies.output.folders import check_new_file

    check_new_file(out)
    if model.suffix == ".onnx":
        raise Refusal(f"{model}: is an ONNX file already; MODEL must be a localizer's folder or a library")
    from localize import BayesDecoder, export_onnx

    localizer = open_trained(model, noise, ambient)
    if ambient is not None and not isinstance(localizer, BayesDecoder):
        raise Refusal(f"--ambient = {ambient:g} is for a library; {model} was trained with a sound of its own")
    export_onnx(localizer, out)
    print(
        f"{out}: {len(localizer.line)} points, {len(localizer.microphones)} microphones, "
        f"{out.stat().st_size / 1e6:.1f} MB"
    )


def locate(
    model: Annotated[
        Path,
        typer.Argument(
            metavar="MODEL",
            help="A trained localizer (a folder), an .onnx file, or a library for the model-based decoder.",
            show_default=False,
        ),
    ],
    recording: Annotated[
        Path,
        typer.Argument(
            metavar="RECORDING",
            help="WAV with a channel per microphone; CSV with their names on top; NPZ or MAT with 'signals'.",
            show_default=False,
        ),
    ],
    out: Annotated[
        Path | None,
        typer.Option(help="Write a line of JSON for every frame here, 16 ms apart.", show_default=False),
    ] = None,
    full_scale: Annotated[
        float | None,
        typer.Option(
            help="Pa: of WAV files the pressure at full scale, of others that at which they clip.",
            show_default="1 Pa; flat tops",
        ),
    ] = None,
    noise: DecoderNoise = None,
    library: ArrayLibrary = None,
    waveform: Annotated[
        bool,
        typer.Option("--waveform", help="Reconstruct the pressure in the touched cavity, into the lines of --out."),
    ] = False,
    ambient: DecoderAmbient = None,
    refuse: RefusedShare = None,
) -> None:
    """Where and when an array was touched, from a recording of its microphones.

    Example: [bold]acoustic-fem locate localizer recording.wav --out touches.jsonl[/bold]
    """
    from geometry.files.writing import write_text
    from studies.output.folders import check_new_file

    check_new_file(out)
    if waveform and out is None:
        raise typer.BadParameter("--waveform goes into the lines of --out; give that too")
    from localize import Decision, read_recording, touches_of
    from localize.live.stream import HOP, State
    from localize.signals.stimulus import SAMPLE_RATE

    localizer = open_localizer(model, noise, ambient)
    stream = open_stream(model, localizer, library, Extras(waveform, ambient, refuse))
    with named(full_scale="--full-scale"):
        heard = read_recording(recording, localizer.microphones, full_scale)
    events = stream.push(heard.signals)
    if out is not None:
        write_text(out, "".join(event.json_line() + "\n" for event in events))
    touches = touches_of(events, localizer)
    table = table_of("from (s)", "to (s)", "point", "line", "place", "probability (%)", "level (Pa)",
                     numbers=tuple(range(7)))  # fmt: skip
    for touch in touches:
        index = touch.point - 1
        table.add_row(
            f"{touch.start:.3f}",
            f"{touch.end:.3f}",
            str(touch.point),
            str(localizer.line[index] + 1),
            str(localizer.place[index] + 1),
            f"{100 * touch.probability:.1f}",
            f"{touch.level:.3g}",
        )
    show(table)
    told: dict[State, str] = {"sound": "sound alone", "other": "no single touch"}
    states = Counter(event.state for event in events if isinstance(event, Decision))
    others = "".join(
        f", {what} for {states[state] * HOP / SAMPLE_RATE:.1f} s" for state, what in told.items() if states[state]
    )
    print(f"{recording}: {len(touches)} touches in {heard.seconds:.1f} s{others}")
