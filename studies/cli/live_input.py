"""The verbs live and record."""

from __future__ import annotations

import os
import sys
from contextlib import ExitStack
from pathlib import Path
from types import TracebackType
from typing import TYPE_CHECKING, Annotated, Self

import typer
from rich.console import Console

import acoustic_fem
import localize
import studies
from geometry.ground.argument_checks import whole_number
from geometry.ground.refusal import Kind, Refusal, counted, in_one_line
from localize.live.stream_options import BAUD
from studies.cli.options import (
    AccelerationChannels,
    AccelerationFullScale,
    AccelerationPath,
    Altitude,
    ArrayLibrary,
    DecoderAmbient,
    DecoderNoise,
    FollowDrift,
    Lowest,
    MicrophoneOutput,
    Model,
    Motion,
    Pressure,
    RejectedFraction,
    Temperature,
    TwoTouches,
    acceleration_file,
    channel_map,
    noise_choice,
)
from studies.cli.terminal_tables import show, table_of, tell
from studies.output.call_defaults import FULL_SCALE

if TYPE_CHECKING:
    from localize.live.listener import Heard
    from localize.live.serial_frames import LineCounts
    from studies.cli.live_display import LivePicture
    from studies.inference.live import LiveSession, LiveSummary

Baud = Annotated[
    int | None,
    typer.Option(help=f"Speed of the serial line, bit/s. USB serial ports ignore it. Default: {BAUD}."),
]


def _list_devices(wanted: bool) -> None:
    if not wanted:
        return
    devices = localize.live.input_devices()
    if not devices:
        raise localize.live.no_device()
    table = table_of("device", "name", "audio system", "channels", "rate (Hz)", "", numbers=(0, 3, 4))
    for each in devices:
        default = "default" if each.default else ""
        table.add_row(str(each.number), each.name, each.host, str(each.channels), f"{each.rate:g}", default)
    show(table)
    raise typer.Exit


def live(
    model: Model,
    device: Annotated[
        str | None,
        typer.Option(
            help="Sound card: its number, part of its name, or 'NAME, AUDIO SYSTEM' of a card that appears under "
            "several. Default: the system's."
        ),
    ] = None,
    rate: Annotated[int | None, typer.Option(help="Sample rate of the sound card, Hz. Default: its own.")] = None,
    list_devices: Annotated[
        bool, typer.Option("--list-devices", callback=_list_devices, is_eager=True, help="List sound cards, then stop.")
    ] = False,
    channels: Annotated[
        str | None,
        typer.Option(
            metavar="A=1,B=2",
            help="Channel of each microphone, counted from 1. Default: the first ones, in the order of the design; a "
            "file of --replay must then have as many channels as there are microphones.",
        ),
    ] = None,
    full_scale: Annotated[
        float | None,
        typer.Option(help=f"Pressure at full scale of the sound card or file, Pa. Default: {FULL_SCALE:g}."),
    ] = None,
    microphone_output: MicrophoneOutput = "pressure",
    lowest: Lowest = None,
    replay: Annotated[
        Path | None, typer.Option(metavar="FILE.wav", help="Recording to play in real time in place of a sound card.")
    ] = None,
    serial: Annotated[
        str | None,
        typer.Option(
            metavar="PORT",
            help="Serial port of a board with the firmware of embed, such as /dev/ttyACM0 or COM3, to read in place of "
            "a sound card.",
        ),
    ] = None,
    baud: Baud = None,
    record: Annotated[
        Path | None,
        typer.Option(
            metavar="FILE.wav",
            help="New file to record the input to, at its own sample rate; readable even if the program is killed.",
        ),
    ] = None,
    out: Annotated[Path | None, typer.Option(help="File for a line of JSON per frame, every 16 ms.")] = None,
    noise: DecoderNoise = None,
    library: ArrayLibrary = None,
    waveform: Annotated[
        bool, typer.Option("--waveform", help="Add the reconstructed pressure in the touched cavity.")
    ] = False,
    ambient: DecoderAmbient = None,
    reject: RejectedFraction = None,
    follow_drift: FollowDrift = False,
    two_touches: TwoTouches = False,
    motion: Motion = None,
    acceleration: AccelerationPath = None,
    acceleration_full_scale: AccelerationFullScale = None,
    acceleration_channels: AccelerationChannels = None,
    radius: Annotated[
        float | None,
        typer.Option(
            metavar="MM",
            help="Report also the position on the surface of a contact of this radius, and its gestures; needs a "
            "library. Default: points alone.",
        ),
    ] = None,
    pressure: Pressure = None,
    altitude: Altitude = None,
    temperature: Temperature = None,
) -> None:
    r"""Locate touches as they happen, from a sound card, a board, or a recording played in real time.

    A terminal shows the array. If the output is not a terminal, it is a line of JSON per frame. If a sound card or a
    board is unplugged, the program waits for it. Press Ctrl-C to end with a summary. Sound cards need pip install
    'acoustic-fem\[live]', and boards need pip install 'acoustic-fem\[serial]'.

    Example: [bold]acoustic-fem live library.nc --device USB --record touches.wav --out touches.jsonl[/bold]
    """
    from studies.inference.live import listen

    number = -1 if device is None else whole_number(device)
    wanted = device if number < 0 else number
    moved = acceleration_file(acceleration, acceleration_full_scale, acceleration_channels)
    source = studies.LiveInput(
        wanted, replay, channel_map(channels), full_scale, rate, serial=serial, baud=baud, acceleration=moved
    )
    air = acoustic_fem.LocalAir(pressure, altitude, temperature)
    decoding = studies.Decoding(
        noise_choice(noise),
        library,
        waveform,
        ambient,
        reject,
        air,
        follow_drift,
        microphone_output=microphone_output,
        lowest=lowest,
        two_touches=two_touches,
        motion=motion,
    )
    with _Output(waveform) as output:
        summary = listen(
            model, source, out, record=record, decoding=decoding, contact_radius_mm=radius, hear=output.hear
        )
    _print_summary(summary)
    if summary.unrecorded:
        raise Refusal(f"{summary.unrecorded}; all input before that is in the file", kind=Kind.STOPPED)


def record(
    serial: Annotated[
        str,
        typer.Option(
            metavar="PORT", help="Serial port of a board with the firmware of embed, such as /dev/ttyACM0 or COM3."
        ),
    ],
    out: Annotated[Path, typer.Option(metavar="FILE.wav", help="New file to record to.")],
    seconds: Annotated[float | None, typer.Option(help="Length of the recording, s. Default: until Ctrl-C.")] = None,
    baud: Baud = None,
) -> None:
    r"""Record the samples of a board on a serial port.

    Writes a WAV file in pascals, which locate, calibrate and train read without --full-scale. Lost samples are zeros in
    it. If the board is unplugged, the program waits for it and goes on in a second file. Needs pip install
    'acoustic-fem\[serial]'.

    Example: [bold]acoustic-fem record --serial /dev/ttyACM0 --out touches.wav --seconds 60[/bold]
    """
    made = studies.record_board(serial, out, baud=baud, seconds=seconds, hear=_told)
    tell(
        f"{', '.join(map(str, made.recordings))}: {counted(made.microphones, 'microphone')}, {made.seconds:.1f} s, "
        f"{made.rate:g} Hz, in Pa"
    )
    tell(_line_words(made.line, made.samples_lost))


def _line_words(line: LineCounts, samples_lost: int) -> str:
    return (
        f"serial line: {counted(line.frames, 'frame')}, {line.lost} lost, {line.damaged} damaged; "
        f"{counted(samples_lost, 'sample')} lost"
    )


class _Output:
    """Output of every event: the picture on a terminal, elsewhere a line of JSON."""

    def __init__(self, waveform: bool) -> None:
        self._console = Console()
        self._waveform = waveform
        self._picture: LivePicture | None = None
        self._stack = ExitStack()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._stack.close()

    def hear(self, session: LiveSession, heard: Heard, line: str) -> bool:
        """Put out an event; whether there is anyone left who reads it."""
        if self._console.is_terminal:
            self._shown(session).hear(heard)
            return True
        try:
            print(line, flush=True)
        except BrokenPipeError:
            # Whoever read the lines has gone; Python would fail once more when it flushes them at the end.
            os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
            return False
        return True

    def _shown(self, session: LiveSession) -> LivePicture:
        if self._picture is None:
            from studies.cli.live_display import LivePicture

            self._picture = LivePicture(
                session.source, session.array, lambda: session.recent, session.latencies, self._waveform
            )
            self._stack.enter_context(self._picture.live(self._console))
        return self._picture


def _print_summary(summary: LiveSummary) -> None:
    """On stderr, beside the lines of the events."""
    states = ", ".join(f"{count} {state}" for state, count in summary.states.items()) or "none"
    faults = ", ".join(f"{count} {kind}" for kind, count in summary.faults.items()) or "none"
    lost = f" ({counted(summary.samples_lost, 'sample')})" if summary.samples_lost else ""
    p50, p99 = (1e3 * summary.latencies.percentile(share) for share in (50, 99))
    for line in (
        f"listened for {summary.seconds:.1f} s: {counted(summary.touches, 'touch')}; decisions: {states}",
        f"faults: {faults}{lost}",
        f"latency: p50 {p50:.1f} ms, p99 {p99:.1f} ms, at most {1e3 * summary.latencies.largest:.1f} ms",
        f"the decoder assumes {summary.assumptions}",
        *([] if summary.line is None else [_line_words(summary.line, summary.samples_lost)]),
        *([] if summary.warning is None else [f"warning: {summary.warning}"]),
        *summary.recordings,
    ):
        print(in_one_line(str(line)), file=sys.stderr)


def _told(text: str) -> None:
    """Notice of a board, on stderr."""
    print(in_one_line(text), file=sys.stderr)
