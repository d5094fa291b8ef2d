"""Verbs that read touches from a recording: locate, recognize, track, pulse."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

import acoustic_fem
import studies
from geometry.ground.refusal import counted
from localize.live.stream_options import MOVING
from studies.cli.options import (
    AccelerationChannels,
    AccelerationFullScale,
    AccelerationPath,
    Altitude,
    ArrayLibrary,
    Channels,
    DecoderAmbient,
    DecoderNoise,
    FollowDrift,
    FullScale,
    LibraryFile,
    Lowest,
    MicrophoneOutput,
    Model,
    Motion,
    Pressure,
    Recording,
    RejectedFraction,
    Temperature,
    TwoTouches,
    acceleration_file,
    channel_map,
    noise_choice,
)
from studies.cli.terminal_tables import show, table_of, tell

if TYPE_CHECKING:
    from geometry.surface import PlanInSpace
    from localize.live.events import State
    from studies.inference.pulse_reading import RecordedPulse
    from studies.inference.recorded import LocatedTouches
    from studies.inference.tracked import TrackedRecording


def locate(
    model: Model,
    recording: Recording,
    out: Annotated[Path | None, typer.Option(help="File for a line of JSON per frame, every 16 ms.")] = None,
    picture: Annotated[
        Path | None,
        typer.Option(metavar="FILE.png", help="Picture to draw of the signals and the touches: .png, .pdf or .svg."),
    ] = None,
    full_scale: FullScale = None,
    microphone_output: MicrophoneOutput = "pressure",
    lowest: Lowest = None,
    noise: DecoderNoise = None,
    library: ArrayLibrary = None,
    waveform: Annotated[
        bool,
        typer.Option("--waveform", help="Add the reconstructed pressure in the touched cavity to the lines of --out."),
    ] = False,
    ambient: DecoderAmbient = None,
    reject: RejectedFraction = None,
    follow_drift: FollowDrift = False,
    two_touches: TwoTouches = False,
    motion: Motion = None,
    channels: Channels = None,
    correct: Annotated[
        bool,
        typer.Option(
            "--correct",
            help="Correct a reversed, exchanged or late microphone before touches are located, if the check of the "
            "sensor finds one. Default: the fault is reported, and probabilities are lowered.",
        ),
    ] = False,
    acceleration: AccelerationPath = None,
    acceleration_full_scale: AccelerationFullScale = None,
    acceleration_channels: AccelerationChannels = None,
    pressure: Pressure = None,
    altitude: Altitude = None,
    temperature: Temperature = None,
) -> None:
    """Find where and when the array was touched, from a recording.

    Prints a row for each touch. The recording has a channel for each microphone. Give --full-scale unless its values
    are in pascals.

    Example: [bold]acoustic-fem locate localizer recording.wav --picture touches.png[/bold]
    """
    if waveform and out is None:
        raise typer.BadParameter("--waveform adds to the lines of --out: give --out too")
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
    found = studies.locate_recording(
        model,
        recording,
        out,
        picture=picture,
        full_scale=full_scale,
        decoding=decoding,
        channels=channel_map(channels),
        correct=correct,
        acceleration=acceleration_file(acceleration, acceleration_full_scale, acceleration_channels),
    )
    _show_touches(found)
    names: dict[State, str] = {
        "sound": "sound alone", "motion": "motion alone", "other": "no single touch", "unreadable": "unreadable"
    }  # fmt: skip
    seconds = found.seconds_by_state
    others = "".join(f", {what} for {seconds[state]:.1f} s" for state, what in names.items() if state in seconds)
    tell(f"{recording}: {counted(len(found.touches), 'touch')} in {found.seconds:.1f} s{others}")
    for each in found.several:
        unknown = sum(touch.point is None for touch in each.touches)
        if unknown:
            what = counted(len(each.touches), "touch")
            tell(f"{what} at once at {each.touches[0].time:.3f} s, place of {unknown} unknown")
    for fault in found.first_faults:
        of = "" if fault.channel is None else f" of microphone {fault.channel}"
        tell(f"warning: {fault.kind}{of}, from {fault.time:.1f} s on")
    beside = f" and {library}" if library is not None else ""
    tell(f"points are those of the design {found.design} in {model}{beside}; they do not apply to another array")
    tell(f"the decoder assumes {found.assumptions}")
    if found.warning is not None:
        tell(f"warning: {found.warning}{_consequence(found)}")


def _consequence(found: LocatedTouches) -> str:
    """Measures against a sensor that does not fit, as clauses after the warning."""
    corrected = "; this was corrected before the touches were located" if found.corrected else ""
    lowered = "; probabilities were lowered" if found.trust < 1 else ""
    if found.fault is not None and not found.corrected:
        return f"{lowered}; correct the wiring, or add --correct"
    return corrected + lowered


def recognize(
    model: Annotated[Path, typer.Argument(metavar="MODEL", help="Recognizer, a folder from train --kind.")],
    library: LibraryFile,
    recording: Annotated[
        Path, typer.Argument(metavar="RECORDING", help="Recording of the array's microphones, as for locate.")
    ],
    out: Annotated[Path | None, typer.Option(help="File for a line of JSON per touch.")] = None,
    point: Annotated[
        int | None, typer.Option(help="Touched point. Default: the one that the library's decoder finds.")
    ] = None,
    speed: Annotated[
        float | None,
        typer.Option(
            help="Speed of the sliding contact, mm/s, for textures. Default: measured from a straight slide over three "
            "points or more."
        ),
    ] = None,
    full_scale: FullScale = None,
    microphone_output: MicrophoneOutput = "pressure",
    lowest: Lowest = None,
    noise: DecoderNoise = None,
    ambient: DecoderAmbient = None,
    pressure: Pressure = None,
    altitude: Altitude = None,
    temperature: Temperature = None,
) -> None:
    """Classify what kind each touch of a recording is, such as an event or a texture.

    Prints a row for each touch. The kinds are events, textures, or the labels that the recognizer was trained on.

    Example: [bold]acoustic-fem recognize events library.nc recording.wav[/bold]
    """
    air = acoustic_fem.LocalAir(pressure, altitude, temperature)
    decoding = studies.Decoding(
        microphone_noise=noise_choice(noise),
        ambient=ambient,
        air=air,
        microphone_output=microphone_output,
        lowest=lowest,
    )
    found = studies.recognize_recording(
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
    out: Annotated[Path, typer.Option(help="CSV file for a row per 16 ms of each path.")],
    picture: Annotated[
        Path | None,
        typer.Option(metavar="FILE.png", help="Picture to draw of the paths on the array: .png, .pdf or .svg."),
    ] = None,
    radius: Annotated[float, typer.Option(metavar="MM", help="Radius of the contact, mm; a stylus has 0.5.")] = MOVING,
    full_scale: FullScale = None,
    microphone_output: MicrophoneOutput = "pressure",
    lowest: Lowest = None,
    noise: DecoderNoise = None,
    ambient: DecoderAmbient = None,
    channels: Channels = None,
    acceleration: AccelerationPath = None,
    acceleration_full_scale: AccelerationFullScale = None,
    acceleration_channels: AccelerationChannels = None,
    pressure: Pressure = None,
    altitude: Altitude = None,
    temperature: Temperature = None,
) -> None:
    """Follow a moving contact across the surface, from a recording.

    Writes the position every 16 ms, between the points too, and prints the gesture that each path makes. For an array
    on a body (docs/robot.md), the table also has the place on the body and the direction away from it.

    Example: [bold]acoustic-fem track library.nc recording.wav --out path.csv --picture path.png[/bold]
    """
    air = acoustic_fem.LocalAir(pressure, altitude, temperature)
    decoding = studies.Decoding(
        microphone_noise=noise_choice(noise),
        ambient=ambient,
        air=air,
        microphone_output=microphone_output,
        lowest=lowest,
    )
    found = studies.track_recording(
        library,
        recording,
        out,
        picture=picture,
        contact_radius_mm=radius,
        full_scale=full_scale,
        decoding=decoding,
        channels=channel_map(channels),
        acceleration=acceleration_file(acceleration, acceleration_full_scale, acceleration_channels),
    )
    _show_paths(found)
    tell(f"{recording}: {counted(len(found.tracks), 'path')} in {found.seconds:.1f} s; {out}")
    if found.body is not None:
        _tell_plan(found.body)
    tell(f"the decoder assumes {found.assumptions}")
    if found.warning is not None:
        tell(f"warning: {found.warning}; the paths are wrong, so correct the wiring or the order of --channels")
    if not found.force_is_known:
        tell(f"forces assume the membranes of the design {found.design}, which were not measured on this sensor")


def pulse(
    library: LibraryFile,
    recording: Annotated[
        Path,
        typer.Argument(metavar="RECORDING", help="Recording of the array's microphones, as for locate; at least 3 s."),
    ],
    out: Annotated[Path | None, typer.Option(help="CSV file to write the waveform to.")] = None,
    picture: Annotated[
        Path | None,
        typer.Option(metavar="FILE.png", help="Picture to draw of the waveform and its waves: .png, .pdf or .svg."),
    ] = None,
    point: Annotated[
        int | None, typer.Option(help="Point under the finger. Default: the one that the decoder finds.")
    ] = None,
    full_scale: FullScale = None,
    microphone_output: MicrophoneOutput = "pressure",
    lowest: Lowest = None,
    noise: DecoderNoise = None,
    pressure: Pressure = None,
    altitude: Altitude = None,
    temperature: Temperature = None,
) -> None:
    """Read the pulse of a finger that rests on the array, from a recording.

    Prints the point, the rate, and the times of the waves of each beat, or why there is no pulse.

    Example: [bold]acoustic-fem pulse library.nc recording.wav --picture pulse.png[/bold]
    """
    decoding = studies.Decoding(
        microphone_noise=noise_choice(noise),
        air=acoustic_fem.LocalAir(pressure, altitude, temperature),
        microphone_output=microphone_output,
        lowest=lowest,
    )
    found = studies.read_pulse(
        library, recording, out, picture=picture, point=point, full_scale=full_scale, decoding=decoding
    )
    _show_pulse(found)
    tell(f"{recording}: {found.seconds:.1f} s; points are those of the design {found.design}")
    tell(f"the decoder assumes {found.assumptions}")
    if not found.force_is_known:
        tell(f"forces assume the membranes of the design {found.design}, which were not measured on this sensor")


def _show_pulse(found: RecordedPulse) -> None:
    reading = found.reading
    if not reading.found:
        varies = f"the force there varies by {1e6 * reading.rms:.3g} uN rms"
        tell(f"no pulse at point {reading.point}: {reading.missing}; {varies}")
        return
    table = table_of("beat", *(f"{name} (s)" for name in reading.waves), numbers=(0, 1, 2, 3))
    for number, times in enumerate(zip(*reading.waves.values(), strict=True), 1):
        table.add_row(str(number), *("" if each != each else f"{each:.3f}" for each in times))
    show(table)
    tell(
        f"point {reading.point} ({100 * reading.probability:.1f} %), {reading.rate:.1f} beats a minute, "
        f"+- {reading.rate_deviation:.1f}"
    )


def _tell_plan(body: PlanInSpace) -> None:
    off = f"the unrolled plan of the body, whose distances are off by {100 * body.stretch:.1f} % (rms)"
    if body.is_flat:
        tell(f"positions are in {off}; the table also has the places on the body")
    else:
        tell(
            f"warning: positions are in {off}, so lengths, speeds and gestures are rough, and a path over the seam "
            "jumps; use the places on the body in the table"
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
