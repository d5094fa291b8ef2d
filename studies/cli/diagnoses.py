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
    display_on_stderr,
    noise_choice,
)
from studies.cli.terminal_tables import say, show, table_of, tell

if TYPE_CHECKING:
    from localize.diagnosis import Diagnosis
    from studies.inference.diagnosed_sensors import BatchDiagnosis

#: Exit code of a batch in which a sensor does not pass.
_NOT_ALL_PASS = 3


def diagnose(
    library: LibraryFile,
    recording: Annotated[
        Path | None,
        typer.Argument(
            metavar="RECORDING",
            help="Recording of 20 to 30 touches, one at a time, spread over all points, with quiet between them.",
        ),
    ] = None,
    out: Annotated[
        Path | None, typer.Option(help="File of JSON for the diagnosis; with --batch, the folder for the results.")
    ] = None,
    batch: Annotated[
        Path | None,
        typer.Option(
            metavar="DIR",
            help="Folder with a recording of each of many sensors, named after the sensor, in place of RECORDING. A "
            "file NAME.toml beside NAME.wav may hold points of its own: points = [1, 2, 3].",
        ),
    ] = None,
    limits: Annotated[
        Path | None,
        typer.Option(
            metavar="FILE.toml",
            help="With --batch: limits within which a sensor passes: docs/diagnosis.md. Default: no fault passes.",
        ),
    ] = None,
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

    Says that the sensor has no fault, names a fault, or lists the faults that these touches cannot distinguish. A fault
    is a tube that is narrowed or blocked, a point that leaks, or a microphone that is quiet, dead, reversed or
    exchanged. Then the command says what to do at the bench and which further touch to record. You need no calibration
    microphone. If you know some of the touched points, give --points, because exchanged microphones can only be found
    with them.

    With --batch the command diagnoses many sensors of one design. It writes a page and tables to the folder
    --out, with the fault, the as-built parameters and the result of each sensor against your limits. If you stop the
    command, start it again to continue. If a recording cannot be used, its row of the table says why. The exit code is
    0 if all sensors pass and 3 if one does not.

    Example: [bold]acoustic-fem diagnose library.nc touches.wav --points 2.5=9,8.1=3[/bold]
    """
    _check_forms(recording, out, batch, limits)
    decoding = studies.Decoding(
        noise_choice(noise),
        air=acoustic_fem.LocalAir(pressure, altitude, temperature),
        microphone_output=microphone_output,
        lowest=lowest,
    )
    known, chosen = _known(points), channel_map(channels)
    if batch is not None and out is not None:
        with display_on_stderr() as display:
            several = studies.diagnose_batch(
                library, batch, out, limits=limits, points=known, full_scale=full_scale, decoding=decoding,
                channels=chosen, display=display,
            )  # fmt: skip
        _show_batch(several)
    elif recording is not None:
        found = studies.diagnose_recording(
            library, recording, out, points=known, full_scale=full_scale, decoding=decoding, channels=chosen
        )
        _show(found, recording)


def _check_forms(recording: Path | None, out: Path | None, batch: Path | None, limits: Path | None) -> None:
    """Refuse words that belong to one recording and to many, or to neither."""
    if (recording is None) == (batch is None):
        raise typer.BadParameter("give a RECORDING, or --batch with a folder of recordings")
    if batch is not None and out is None:
        raise typer.BadParameter("--batch needs --out, a folder for the results")
    if batch is None and limits is not None:
        raise typer.BadParameter("--limits belongs to --batch")


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


def _show_batch(found: BatchDiagnosis) -> None:
    """Print the table of the sensors and the paths of the files, then end with exit code 3 if one does not pass."""
    table = table_of("sensor", "result", "finding", "probability", "modulus", numbers=(3,))
    for each in found.sensors:
        modulus, probability = each.batch_modulus, each.probability
        table.add_row(
            each.sensor,
            each.result,
            each.text,
            "" if probability is None else f"{100 * probability:.1f} %",
            "" if modulus is None else f"{modulus.value:.2f} ({modulus.low:.2f} to {modulus.high:.2f})",
        )
    show(table)
    for each in found.sensors:
        if each.matching:
            tell(f"{each.sensor}: {each.matching}")
        if each.objections:
            tell(f"{each.sensor} fails: {'; '.join(each.objections)}")
    counts = found.counts
    tell(
        f"{counts['pass']} of {counted(len(found.sensors), 'sensor')} pass, {counts['fail']} fail, "
        f"{counts['no diagnosis']} could not be diagnosed"
    )
    say(found.page)
    if not found.passed:
        raise typer.Exit(_NOT_ALL_PASS)


def _show(found: Diagnosis, recording: Path) -> None:
    """Print the verdict, then the advice and what is not excluded."""
    known = int(found.known.sum())
    tell(f"{recording}: {counted(len(found.start), 'touch')}, {known} of them at known points")
    if found.matching:
        tell(found.matching)
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
