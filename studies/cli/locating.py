"""Verbs that put a localizer or a recognizer to work: onnx, embed, locate, recognize, track, pulse."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, cast

import typer

from acoustic_fem.quantities.local_air import LocalAir
from geometry.ground.refusal import counted
from localize.contacts.contact import MOVING
from localize.embedded.decoder_tables import Precision
from localize.live.events import State
from studies.cli.options import (
    Altitude,
    FullScale,
    LibraryFile,
    Model,
    Pressure,
    Recording,
    Temperature,
    noise_choice,
)
from studies.cli.terminal_tables import show, table_of, tell
from studies.inference.embedding import PRECISION, embed_decoder
from studies.inference.exporting import export_decoder
from studies.inference.pulse_reading import RecordedPulse, read_pulse
from studies.inference.recognized import recognize_recording
from studies.inference.recorded import Decoding, LocatedTouches, locate_recording
from studies.inference.tracked import TrackedRecording, track_recording

DecoderNoise = Annotated[
    float | None,
    typer.Option(
        help="For a library: the white noise of the microphones to assume instead, Pa rms over 0 to 500 Hz.",
        show_default="the design's",
    ),
]
DecoderAmbient = Annotated[
    float | None,
    typer.Option(
        metavar="DB",
        help="Name touches in sound up to this level, dB SPL; slower. Sound alone is told from touches in any case.",
        show_default="a quiet room",
        min=0,
        max=140,
    ),
]
ArrayLibrary = Annotated[
    Path | None,
    typer.Option(
        help="The library of the array, which tells sound from touches, and for the options below.",
        show_default="MODEL, where that is a library",
    ),
]
RejectedFraction = Annotated[
    float | None,
    typer.Option(
        metavar="FRACTION",
        help="Call frames 'other' that no single point explains; so many true ones may be rejected, such as 1e-6. "
        "For a calibrated sensor.",
        show_default="the likeliest point is named",
    ),
]
FollowDrift = Annotated[
    bool,
    typer.Option(
        "--follow-drift",
        help="Follow the stiffness of the sensor over the touches, for a calibrated library: rubber that ages, air of "
        "another place.",
    ),
]


def onnx(
    model: Annotated[
        Path,
        typer.Argument(
            metavar="MODEL",
            help="A trained localizer (a folder), or a library (.nc, .sofa, .npz or .csv) for the model-based decoder.",
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
    written = export_decoder(model, out, noise=noise_choice(noise), ambient=ambient)
    tell(
        f"{out}: {counted(written.points, 'point')}, {counted(len(written.microphones), 'microphone')}, "
        f"{out.stat().st_size / 1e6:.1f} MB"
    )
    tell(f"assumed is {written.assumptions}")


def embed(
    library: LibraryFile,
    out: Annotated[Path, typer.Option(help="The folder to write the C files into.", show_default=False)],
    precision: Annotated[
        str, typer.Option(metavar="float32|int16", help="Of the large tables: int16 takes three fifths of the flash.")
    ] = PRECISION,
    budget: Annotated[
        str | None,
        typer.Option(
            metavar="flash=512k,ram=16k,instructions=2.5M",
            help="What the chip has left, one or more of flash, ram, stack (bytes; k is 1024) and instructions (a "
            "decision's, every 16 ms); what takes more is refused, with the numbers.",
            show_default="whatever it takes",
        ),
    ] = None,
    noise: DecoderNoise = None,
) -> None:
    """Write the decoder of a library as C99 for the microcontroller on the sensor: samples in, the touched point out.

    No training, no heap, nothing but math.h. It decodes the sensor as its library has it: calibrate first. What fits
    on which chip: docs/embed.md.

    Example: [bold]acoustic-fem embed library.nc --out firmware/touch --budget flash=512k,ram=16k[/bold]
    """
    chosen = cast("Precision", precision)
    written = embed_decoder(library, out, precision=chosen, budget=budget, noise=noise_choice(noise))
    cost, table = written.decoder.cost, table_of("", "at most", numbers=(1,))
    for name, value in (("flash", cost.flash), ("ram", cost.ram), ("stack", cost.stack)):
        table.add_row(name, f"{value} bytes")
    table.add_row("instructions, a decision every 16 ms", str(cost.instructions))
    table.add_row("the first one, more", str(cost.first))
    show(table)
    tables = written.decoder.tables
    tell(
        f"{out}: {counted(tables.point_count, 'point')}, {counted(len(tables.microphones), 'microphone')}, "
        f"{tables.precision}; how to build, call and wire it: {out / 'README.md'}"
    )
    tell(f"assumed is {written.assumptions}")


def locate(
    model: Model,
    recording: Recording,
    out: Annotated[
        Path | None,
        typer.Option(help="Write a line of JSON for every frame here, 16 ms apart.", show_default=False),
    ] = None,
    picture: Annotated[
        Path | None, typer.Option(metavar="FILE.png", help="Draw the signals and the touches.", show_default=False)
    ] = None,
    full_scale: FullScale = None,
    noise: DecoderNoise = None,
    library: ArrayLibrary = None,
    waveform: Annotated[
        bool,
        typer.Option("--waveform", help="Reconstruct the pressure in the touched cavity, into the lines of --out."),
    ] = False,
    ambient: DecoderAmbient = None,
    reject: RejectedFraction = None,
    follow_drift: FollowDrift = False,
    pressure: Pressure = None,
    altitude: Altitude = None,
    temperature: Temperature = None,
) -> None:
    """Where and when an array was touched, from a recording of its microphones.

    Example: [bold]acoustic-fem locate localizer recording.wav --picture touches.png[/bold]
    """
    if waveform and out is None:
        raise typer.BadParameter("--waveform goes into the lines of --out; give that too")
    air = LocalAir(pressure, altitude, temperature)
    decoding = Decoding(noise_choice(noise), library, waveform, ambient, reject, air, follow_drift)
    found = locate_recording(model, recording, out, picture=picture, full_scale=full_scale, decoding=decoding)
    _show_touches(found)
    told: dict[State, str] = {"sound": "sound alone", "other": "no single touch", "unreadable": "unreadable"}
    seconds = found.seconds_by_state
    others = "".join(f", {what} for {seconds[state]:.1f} s" for state, what in told.items() if state in seconds)
    tell(f"{recording}: {counted(len(found.touches), 'touch')} in {found.seconds:.1f} s{others}")
    for fault in found.first_faults:
        of = "" if fault.channel is None else f" of microphone {fault.channel}"
        tell(f"warning: {fault.kind}{of}, from {fault.time:.1f} s on")
    told_of = f" and {library}" if library is not None else ""
    tell(
        f"points are those of the design {found.design}, as {model}{told_of} has it: of another array they say nothing"
    )
    tell(f"assumed is {found.assumptions}")
    if found.warning is not None:
        level = (
            ""
            if found.rescaled_microphone is None
            else f"; the level of {found.rescaled_microphone} was corrected first"
        )
        tell(f"warning: {found.warning}{level}")


def recognize(
    model: Annotated[
        Path, typer.Argument(metavar="MODEL", help="A recognizer, from train --kind (a folder).", show_default=False)
    ],
    library: LibraryFile,
    recording: Annotated[
        Path,
        typer.Argument(metavar="RECORDING", help="Of the array's microphones, as for locate.", show_default=False),
    ],
    out: Annotated[
        Path | None, typer.Option(help="Write a line of JSON for every touch here.", show_default=False)
    ] = None,
    point: Annotated[
        int | None,
        typer.Option(help="The point that is touched.", show_default="the one that the library's decoder names"),
    ] = None,
    speed: Annotated[
        float | None,
        typer.Option(
            help="Of what slides, mm/s: for textures.",
            show_default="that of a straight slide over three points or more",
        ),
    ] = None,
    full_scale: FullScale = None,
    noise: DecoderNoise = None,
    ambient: DecoderAmbient = None,
    pressure: Pressure = None,
    altitude: Altitude = None,
    temperature: Temperature = None,
) -> None:
    """What kind each touch of a recording is: events, textures, or the labels that a recognizer was trained on.

    Example: [bold]acoustic-fem recognize events library.nc recording.wav[/bold]
    """
    air = LocalAir(pressure, altitude, temperature)
    decoding = Decoding(noise=noise_choice(noise), ambient=ambient, air=air)
    found = recognize_recording(
        model, library, recording, out, point=point, speed=speed, full_scale=full_scale, decoding=decoding
    )
    table = table_of("from (s)", "to (s)", "point", "kind", "probability (%)", numbers=(0, 1, 2, 4))
    for each in found:
        share = f"{100 * each.probability:.1f}"
        table.add_row(f"{each.start:.3f}", f"{each.end:.3f}", str(each.point), each.kind, share)
    show(table)
    tell(f"{recording}: {counted(len(found), 'touch')}")


def _show_touches(found: LocatedTouches) -> None:
    table = table_of("from (s)", "to (s)", "point", "line", "place", "probability (%)", "level (Pa)",
                     numbers=tuple(range(7)))  # fmt: skip
    for touch in found.touches:
        index = touch.point - 1
        table.add_row(
            f"{touch.start:.3f}",
            f"{touch.end:.3f}",
            str(touch.point),
            str(found.array.line[index] + 1),
            str(found.array.place[index] + 1),
            f"{100 * touch.probability:.1f}",
            f"{touch.level:.3g}",
        )
    show(table)


def track(
    library: LibraryFile,
    recording: Recording,
    out: Annotated[Path, typer.Option(help="Write a row for every 16 ms of each path here.", show_default=False)],
    picture: Annotated[
        Path | None, typer.Option(metavar="FILE.png", help="Draw the paths on the array.", show_default=False)
    ] = None,
    radius: Annotated[float, typer.Option(metavar="MM", help="Radius of the contact, mm: a stylus has 0.5.")] = MOVING,
    full_scale: FullScale = None,
    noise: DecoderNoise = None,
    ambient: DecoderAmbient = None,
    pressure: Pressure = None,
    altitude: Altitude = None,
    temperature: Temperature = None,
) -> None:
    """Where a contact went on the surface, between the points too, from a recording; and gestures by rule.

    Example: [bold]acoustic-fem track library.nc recording.wav --out path.csv --picture path.png[/bold]
    """
    air = LocalAir(pressure, altitude, temperature)
    decoding = Decoding(noise=noise_choice(noise), ambient=ambient, air=air)
    found = track_recording(
        library, recording, out, picture=picture, radius=radius, full_scale=full_scale, decoding=decoding
    )
    _show_paths(found)
    tell(f"{recording}: {counted(len(found.tracks), 'path')} in {found.seconds:.1f} s; {out}")
    tell(f"assumed is {found.assumptions}")
    if not found.force_is_known:
        tell(f"forces are by the membranes of the design {found.design}, which nobody measured on this sensor")


def pulse(
    library: LibraryFile,
    recording: Annotated[
        Path,
        typer.Argument(
            metavar="RECORDING", help="Of the array's microphones, as for locate; at least 3 s.", show_default=False
        ),
    ],
    out: Annotated[Path | None, typer.Option(help="Write the waveform here, .csv.", show_default=False)] = None,
    picture: Annotated[
        Path | None, typer.Option(metavar="FILE.png", help="Draw the waveform and its waves.", show_default=False)
    ] = None,
    point: Annotated[
        int | None,
        typer.Option(help="The point under which it is felt.", show_default="the one that the decoder names"),
    ] = None,
    full_scale: FullScale = None,
    noise: DecoderNoise = None,
    pressure: Pressure = None,
    altitude: Altitude = None,
    temperature: Temperature = None,
) -> None:
    """The pulse under a finger that rests on the array: where it is felt, its rate, the waves of each beat.

    Example: [bold]acoustic-fem pulse library.nc recording.wav --picture pulse.png[/bold]
    """
    decoding = Decoding(noise=noise_choice(noise), air=LocalAir(pressure, altitude, temperature))
    found = read_pulse(library, recording, out, picture=picture, point=point, full_scale=full_scale, decoding=decoding)
    _show_pulse(found)
    tell(f"{recording}: {found.seconds:.1f} s; points are those of the design {found.design}")
    tell(f"assumed is {found.assumptions}")
    if not found.force_is_known:
        tell(f"forces are by the membranes of the design {found.design}, which nobody measured on this sensor")


def _show_pulse(found: RecordedPulse) -> None:
    reading = found.reading
    table = table_of("beat", *(f"{name} (s)" for name in reading.waves), numbers=(0, 1, 2, 3))
    for number, times in enumerate(zip(*reading.waves.values(), strict=True), 1):
        table.add_row(str(number), *("" if each != each else f"{each:.3f}" for each in times))
    show(table)
    tell(
        f"point {reading.point} ({100 * reading.probability:.1f} %), {reading.rate:.1f} beats a minute, "
        f"+- {reading.rate_deviation:.1f}"
    )


def _show_paths(found: TrackedRecording) -> None:
    table = table_of(
        "from (s)", "to (s)", "gesture", "length (mm)", "speed (mm/s)", "deviation (mm)", numbers=(0, 1, 3, 4, 5)
    )
    for track, gesture in zip(found.tracks, found.gestures, strict=True):
        table.add_row(
            f"{gesture.start:.3f}",
            f"{gesture.end:.3f}",
            f"{gesture.kind} {gesture.direction}".strip(),
            f"{gesture.length:.0f}",
            f"{track.speed.mean():.0f}",
            f"{track.deviation.mean():.1f}",
        )
    show(table)
