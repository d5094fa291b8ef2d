"""Verb that finds what is broken in a built sensor: diagnose."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

import acoustic_fem
import studies
from geometry.ground.refusal import counted
from studies.cli.options import (
    Altitude,
    Channels,
    FullScale,
    LibraryFile,
    Lowest,
    MicrophoneOutput,
    Noise,
    Pressure,
    Temperature,
    channel_map,
    noise_choice,
)
from studies.cli.terminal_tables import show, table_of, tell

if TYPE_CHECKING:
    from localize.diagnosis import Diagnosis


def diagnose(
    library: LibraryFile,
    recording: Annotated[
        Path,
        typer.Argument(
            metavar="RECORDING",
            help="Recording of 20 to 30 touches, one at a time, spread over all points, with quiet between them.",
        ),
    ],
    out: Annotated[Path | None, typer.Option(help="File of JSON for the diagnosis.")] = None,
    points: Annotated[
        str | None,
        typer.Option(
            metavar="POINTS",
            help="Touched points that you know: TIME=POINT of some touches, such as 2.5=9,8.1=3 with times in seconds, "
            "or one point for each touch, such as 1,2,3. Default: none is known.",
        ),
    ] = None,
    full_scale: FullScale = None,
    microphone_output: MicrophoneOutput = "pressure",
    lowest: Lowest = None,
    noise: Noise = None,
    channels: Channels = None,
    pressure: Pressure = None,
    altitude: Altitude = None,
    temperature: Temperature = None,
) -> None:
    """Find what is broken in a built sensor, from a recording of ordinary touches.

    Says that the sensor is sound, names a fault, or lists the faults that these touches cannot tell apart: a tube that
    is narrowed or blocked, a point that leaks, a microphone that is quiet, dead, reversed or exchanged. Then it says
    what to do at the bench and which touch would tell more. You need no calibration microphone. If you know some of the
    touched points, give --points. Exchanged microphones show only then.

    Example: [bold]acoustic-fem diagnose library.nc touches.wav --points 2.5=9,8.1=3[/bold]
    """
    decoding = studies.Decoding(
        noise_choice(noise),
        air=acoustic_fem.LocalAir(pressure, altitude, temperature),
        microphone_output=microphone_output,
        lowest=lowest,
    )
    found = studies.diagnose_recording(
        library,
        recording,
        out,
        points=_known(points),
        full_scale=full_scale,
        decoding=decoding,
        channels=channel_map(channels),
    )
    _show(found, recording)


def _known(text: str | None) -> list[int] | dict[float, int] | None:
    """Points of --points, as :func:`studies.diagnose_recording` takes them."""
    if text is None:
        return None
    pieces = [piece.strip() for piece in text.split(",")]
    try:
        if "=" in text:
            pairs = [piece.split("=") for piece in pieces]
            return {float(time): int(point) for time, point in pairs}
        return [int(piece) for piece in pieces]
    except ValueError:
        problem = f"--points = {text!r} must be TIME=POINT,... or POINT,..., such as 2.5=9,8.1=3"
        raise typer.BadParameter(problem) from None


def _show(found: Diagnosis, recording: Path) -> None:
    """Print the verdict, then the advice and what is not excluded."""
    known = int(found.known.sum())
    tell(f"{recording}: {counted(len(found.start), 'touch')}, {known} of them at known points")
    tell(f"{found.verdict}: {found.text}" if found.verdict != "sound" else found.text)
    if found.faults and found.verdict != "unexplained":
        table = table_of("fault", "to do")
        for fault, advice in zip(found.faults, found.advice, strict=True):
            table.add_row(fault.described(found.design), advice)
        show(table)
    if found.verdict == "unexplained":
        tell("Several parts may be broken, or the library may be one of another array or air: check it first.")
    if found.not_excluded:
        names = "; ".join(fault.described(found.design) for fault in found.not_excluded)
        tell(f"These touches cannot exclude the following faults: {names}.")
    if found.next_point is not None:
        tell(f"To be more certain, record a touch of point {found.next_point} too, and give its time with --points.")
    if found.verdict in ("fault", "one of several"):
        tell("After the repair, record the touches again and repeat the diagnosis.")
