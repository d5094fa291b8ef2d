"""Verbs that put a localizer to work: onnx, locate."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from studies.cli_options import named, noise_choice
from studies.tables import show, table_of

if TYPE_CHECKING:
    from localize import BayesDecoder, Localizer, OnnxLocalizer

#: White noise that waveforms are reconstructed with where a localizer knows none, Pa rms.
LEAST_NOISE = 1e-6

DecoderNoise = Annotated[
    float | None,
    typer.Option(
        help="For a library: the white noise of the microphones to assume instead, Pa rms over 0 to 500 Hz.",
        show_default="that of the design's",
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
) -> None:
    """Write a localizer as one ONNX graph, from 250 samples of each microphone to the probability of each point.

    Example: [bold]acoustic-fem onnx localizer --out localizer.onnx[/bold]
    """
    from studies.folders import check_new_file

    check_new_file(out)
    if model.suffix == ".onnx":
        raise ValueError(f"{model}: is an ONNX file already; MODEL must be a localizer's folder or a library")
    from localize import export_onnx

    localizer = _opened(model, noise)
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
            help="WAV with a channel per microphone; CSV with their names on top; NPZ with 'signals'.",
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
    waveform: Annotated[
        Path | None,
        typer.Option(
            metavar="LIBRARY",
            help="Reconstruct the pressure in the touched cavity with this library, into the lines of --out.",
            show_default=False,
        ),
    ] = None,
) -> None:
    """Where and when an array was touched, from a recording of its microphones.

    Example: [bold]acoustic-fem locate localizer recording.wav --out touches.jsonl[/bold]
    """
    from geometry.whole_file import write_text
    from studies.folders import check_new_file

    check_new_file(out)
    if waveform is not None and out is None:
        raise typer.BadParameter("--waveform goes into the lines of --out; give that too")
    from localize import Reconstructor, TouchStream, read_recording, touches_of

    localizer: Localizer | BayesDecoder | OnnxLocalizer
    if model.suffix == ".onnx":
        if noise is not None:
            raise ValueError(f"--noise = {noise} is for a library; {model} was made for the noise it names itself")
        from localize import OnnxLocalizer

        localizer = OnnxLocalizer(model)
    else:
        localizer = _opened(model, noise)
    with named(full_scale="--full-scale"):
        heard = read_recording(recording, localizer.microphones, full_scale)
    reconstructor = None
    if waveform is not None:
        import acoustic_fem

        reconstructor = Reconstructor(acoustic_fem.load(waveform), max(localizer.noise_rms, LEAST_NOISE))
    events = TouchStream(localizer, reconstructor=reconstructor).push(heard.signals)
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
    print(f"{recording}: {len(touches)} touches in {heard.seconds:.1f} s")


def _opened(model: Path, noise: float | None) -> Localizer | BayesDecoder:
    """A trained localizer from its folder, or the model-based decoder of a library."""
    from localize import BayesDecoder, load_localizer

    if model.is_dir() or not model.suffix:
        if noise is not None:
            raise ValueError(f"--noise = {noise} is for a library; {model} was trained with a noise of its own")
        return load_localizer(model)
    import acoustic_fem

    with named(microphone_noise="--noise"):
        return BayesDecoder(acoustic_fem.load(model), noise_choice(noise))
