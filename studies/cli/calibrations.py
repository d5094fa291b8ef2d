"""Verbs on a made sensor and its library: rig, calibrate, recalibrate, convert."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

import acoustic_fem
import localize
import studies
from acoustic_fem.quantities.fidelity import ONE_DESIGN, Fidelity
from geometry.ground.refusal import counted
from localize.signals.stimulus import BAND
from studies.cli.options import (
    Altitude,
    Channels,
    Design,
    Frequencies,
    FullScale,
    LibraryFile,
    Lowest,
    MicrophoneOutput,
    Noise,
    Pressure,
    Temperature,
    Tolerances,
    channel_map,
    display_on_stderr,
    noise_choice,
)
from studies.cli.terminal_tables import say, show, show_library, table_of, tell
from studies.output.call_defaults import MANIFEST, RECALIBRATION_SECONDS, SEED, STATE_SPACE_ERROR, TAKE_SECONDS, TAKES
from studies.output.frequencies import CALIBRATION_FREQUENCIES

if TYPE_CHECKING:
    from acoustic_fem.calibration import Update
    from studies.test_rig.calibrating import SensorCalibration

#: Delay (s) above which the table of the fit shows it.
_NOTED_DELAY = 3e-4


def rig(
    design: Design,
    out: Annotated[Path, typer.Option(help="Folder to write to.")],
    seed: Annotated[int, typer.Option(help="Seed of the simulated sensor.", min=0)] = SEED,
    altitude: Annotated[
        float, typer.Option(metavar="M", help="Altitude of the simulated sensor above that of the design.")
    ] = 0.0,
    modulus: Annotated[
        float, typer.Option(metavar="FACTOR", help="Modulus of the membranes relative to the design; 0.85 is softer.")
    ] = 1.0,
    warming: Annotated[
        float,
        typer.Option(
            metavar="K",
            help="Warming of the sealed air since it was in balance with the outside, K. A worn sensor warms by 12 K.",
        ),
    ] = 0.0,
    climb: Annotated[
        float, typer.Option(metavar="M", help="Height climbed since the sealed air was in balance with the outside, m.")
    ] = 0.0,
    motion: Annotated[
        float,
        typer.Option(
            metavar="M/S2",
            help="Largest acceleration of a sensor that is worn on a waved hand while it is touched, such as 5.",
        ),
    ] = 0.0,
    fidelity: Annotated[Fidelity, typer.Option(help="Fidelity of the sensor's transfer functions.")] = ONE_DESIGN,
) -> None:
    """Simulate recordings of an as-built sensor, to practise before you have a real one.

    The sensor's parts, rubber, microphones and air deviate from the design. Its recordings contain noise, hum and
    drift, and its touches have the spectra and the hysteresis of fingers. The decoders are given none of this.

    Writes a folder calibration with a recording of each point for calibrate, and a folder touches with recordings for
    locate, recalibrate and train --recordings, whose file names give the point. truth.json and truth.nc hold the hidden
    deviations and the sensor's true library: look at them last. With --motion, the acceleration is written beside each
    touch, for locate --acceleration, and a folder motion holds a recording of the waved sensor that nobody touches.

    Example: [bold]acoustic-fem rig array-2x6 --out bench; acoustic-fem calibrate bench/calibration --out made.nc[/bold]
    """
    scatter = studies.HiddenScatter(altitude=altitude, modulus=modulus, warming=warming, climb=climb)
    with display_on_stderr() as display:
        session = None if motion == 0 else studies.TouchSession(TAKES, TAKE_SECONDS, motion=motion)
        made = studies.record_rig(
            design, out, seed=seed, fidelity=fidelity, scatter=scatter, session=session, display=display
        )
    waved = () if made.waved is None else (made.waved,)
    for path in (made.calibration, made.touches, *waved, made.truth, made.library):
        say(path)
    tell(
        f"The recordings are voltages of the microphones with a full scale of {made.full_scale:g} Pa. Give locate and "
        f"recalibrate --full-scale {made.full_scale:g} --microphone-output voltage."
    )


def calibrate(
    recordings: Annotated[
        Path,
        typer.Argument(
            metavar="RECORDINGS", help=f"Manifest, TOML, or a folder that contains {MANIFEST}: docs/calibration.md."
        ),
    ],
    out: Annotated[Path, typer.Option(help="Library to write, netCDF, a new file; a figure is written beside it.")],
    fidelity: Annotated[
        Fidelity, typer.Option(help="Fidelity of the design's transfer functions, used for points without a recording.")
    ] = ONE_DESIGN,
    frequencies: Frequencies = CALIBRATION_FREQUENCIES,
    tolerances: Tolerances = None,
    pressure: Pressure = None,
    altitude: Altitude = None,
    temperature: Temperature = None,
) -> None:
    """Measure the library of your sensor from recordings with a calibration microphone.

    Writes a library of measured transfer functions with their uncertainty. Record swept sines or noise at each point,
    with a calibration microphone at the touched cavity. Bad recordings are left out and listed. If a point has no good
    recording, its transfer functions are computed with dimensions of the parts that are fitted to the measured points.
    If no sensor within the tolerances fits, you get a warning and these points keep the design's transfer functions.
    If a broken part explains the recordings, the command names it and writes nothing: docs/diagnosis.md.

    A decoder of this library assumes that touches contain no sound above the last of --frequencies.

    Example: [bold]acoustic-fem calibrate recordings --out made.nc[/bold]
    """
    air = acoustic_fem.LocalAir(pressure, altitude, temperature)
    with display_on_stderr() as display:
        found = studies.calibrate_sensor(
            recordings, out, fidelity=fidelity, frequency=frequencies, tolerances=tolerances, air=air, display=display
        )
    _show_calibration(found)
    say(found.figure)


def _show_calibration(found: SensorCalibration) -> None:
    """Print how many points are measured and how accurate the library is, then the fit and the recordings as tables."""
    calibration, fit = found.calibration, found.fit
    text = f"{found.out}: {len(calibration.estimates)} of {counted(calibration.manifest.design.point_count, 'point')} "
    text += "measured"
    if calibration.missing:
        kept = fit is not None and fit.objection
        text += f", {len(calibration.missing)} {'of the design' if kept else 'fitted'}"
    tell(text)
    if fit is not None:
        _show_fit(found, fit)
    if calibration.findings:
        table = table_of("point", "recording", "finding", numbers=(0,))
        for finding in calibration.findings:
            table.add_row(str(finding.point), "left out" if finding.excluded else "used", finding.text)
        show(table)
    if fit is not None:
        _print_warnings(found, fit)


def _show_fit(found: SensorCalibration, fit: Update) -> None:
    """Print the figures of the fit to the measured points, each with its meaning."""
    determined = int((fit.eigenvalues >= 1).sum())
    table = table_of("fit to the measured points", "value", "meaning", numbers=(1,))
    agrees = "no sensor within the tolerances fits" if fit.objection else "a sensor within the tolerances fits"
    table.add_row("chi-squared", f"{fit.chi_squared:.0f}", f"for {fit.residuals} residuals: {agrees}")
    meaning = f"of {len(fit.parameters)} combinations of parameters; the others keep their assumed values"
    table.add_row("determined", str(determined), meaning)
    if found.expected is not None:
        many = counted(len(found.expected), "sensor")
        rows = (
            (f"{100 * found.expected.mean():.1f} %", f"top-1, mean over {many} that agree with the recordings"),
            (f"{100 * found.expected[0]:.1f} %", "top-1, the worst of these sensors"),
        )
        for value, meaning in rows:
            table.add_row("expected accuracy", value, meaning)
    if not fit.objection and abs(fit.delay) > _NOTED_DELAY:
        when = "later" if fit.delay > 0 else "earlier"
        meaning = f"the array's microphones are {when} than stated, relative to the reference; the fit corrects this"
        table.add_row("delay", f"{1e3 * abs(fit.delay):.1f} ms", meaning)
    show(table)


def _print_warnings(found: SensorCalibration, fit: Update) -> None:
    """Print why the fit is not used, or why its accuracy is not known or too low, and what to do."""
    if fit.objection:
        tell(f"The fit is not used: {fit.objection}")
        tell(
            "warning: a mixture of measured and designed points may decode worse than the design's own library. "
            f"Measure point {', '.join(map(str, found.calibration.missing))} too, or find what is wrong with point "
            f"{fit.worst_point}."
        )
    elif found.expected is None:
        tell(f"The accuracy is not predicted, because --frequencies do not cover {BAND[0]:g} to {BAND[1]:g} Hz.")
    elif found.measure_next is not None:
        tell(f"warning: the expected accuracy is low, so measure another point, best point {found.measure_next}")


def recalibrate(
    library: LibraryFile,
    recordings: Annotated[
        list[Path],
        typer.Argument(
            metavar="RECORDINGS",
            help="Touches, one at a time, spread over all points: WAV with a channel per microphone, CSV with their "
            "names in the first line, or NPZ with 'signals'.",
        ),
    ],
    out: Annotated[Path, typer.Option(help="Library to write, netCDF, a new file.")],
    full_scale: FullScale = None,
    microphone_output: MicrophoneOutput = "pressure",
    lowest: Lowest = None,
    noise: Noise = None,
    seconds: Annotated[
        float, typer.Option(metavar="S", help="Processor time after which the search ends without a library.", min=1)
    ] = RECALIBRATION_SECONDS,
    seed: Annotated[int, typer.Option(help="Seed that chooses the held-out touches.", min=0)] = SEED,
    channels: Channels = None,
    pressure: Pressure = None,
    altitude: Altitude = None,
    temperature: Temperature = None,
) -> None:
    """Update the library of your sensor from ordinary touches, whose points need not be known.

    Writes a new library. LIBRARY is that of the design or of the last calibration. Record taps, presses or slides of
    fingers, one at a time, in a quiet room, several at every point: at least 100 frames of 250 ms, better 300. A
    quarter of the touches is held out. If they do not support the new library, the command says why and writes nothing.
    If a broken part explains the touches, the command names it: docs/diagnosis.md.

    Example: [bold]acoustic-fem recalibrate made.nc monday.wav tuesday.wav --out now.nc[/bold]
    """
    air, level = acoustic_fem.LocalAir(pressure, altitude, temperature), noise_choice(noise)
    with display_on_stderr() as display:
        found = studies.recalibrate(
            library,
            recordings,
            out,
            full_scale=full_scale,
            microphone_noise=level,
            seed=seed,
            air=air,
            channels=channel_map(channels),
            microphone_output=microphone_output,
            lowest=lowest,
            seconds=seconds,
            display=display,
        ).found
    tell(f"{out}: updated from {counted(found.frames, 'frame')} with touches")
    table = table_of("check with held-out touches", "value", "meaning", numbers=(1,))
    gain = f"{found.gain:.2f} +- {found.gain_error:.2f}"
    table.add_row("gain", gain, f"log-likelihood of a frame (nats) compared with {library}, and its standard error")
    table.add_row("explained", f"{100 * found.explained:.0f} %", "fraction of the frames that pass the residual test")
    show(table)
    if len(found.untouched):
        points = localize.recalibration.numbers(found.untouched)
        tell(f"No touch was assigned to point {points}, so it is the least certain. Touch it next time.")


def convert(
    library: Annotated[Path, typer.Argument(metavar="LIBRARY", help="Library: .nc, .sofa, .npz, .mat or .csv.")],
    out: Annotated[
        Path, typer.Option(help="File to write; its suffix is the format. A measured library is never overwritten.")
    ],
    content: Annotated[
        str | None,
        typer.Option(
            "--as", metavar="CONTENT", help="library, state-space or circuit. Default: circuit for .cir and .sNp."
        ),
    ] = None,
    touch: Annotated[
        str | None,
        typer.Option(
            metavar="INPUT", help="Input of a state space at each membrane: force or volume-velocity. Default: force."
        ),
    ] = None,
    output: Annotated[
        str | None,
        typer.Option(
            metavar="OUTPUT", help="Output of a state space at each microphone: pressure or voltage. Default: pressure."
        ),
    ] = None,
    tolerance: Annotated[
        float | None,
        typer.Option(
            help="Largest error of a state space, relative to each response at each frequency. Default: "
            f"{STATE_SPACE_ERROR:g}."
        ),
    ] = None,
    design: Annotated[
        str | None,
        typer.Option(metavar="DESIGN", help="Array of a SOFA file of another program: a file or a prototype's name."),
    ] = None,
) -> None:
    """Convert a library without loss to another format, or to a state space or a circuit.

    SOFA files follow AES69-2022, convention GeneralTF-E. Every digit is kept. A state space (.mat for Octave, MATLAB
    and Simulink, or .npz, with --as state-space) is a fit within --tolerance, with as few poles as possible. It is
    stable and passive, even outside the band. A circuit (.cir) is a SPICE netlist of the design, by its closed forms. A
    Touchstone file (.s14p for 12 points and 2 microphones) has the impedances between its cavities and microphones. For
    a SOFA file of another program, give --design. Its receivers are then the microphones, and its emitters or
    measurements are the points. Guide: docs/formats.md.

    Example: [bold]acoustic-fem convert library.nc --out library.sofa[/bold]
    """
    from acoustic_fem.circuit import SensorCircuit, is_touchstone  # loads SciPy

    converted = studies.convert_library(
        library, out, content=content, touch=touch, output=output, tolerance=tolerance, design=design
    )
    if isinstance(converted, acoustic_fem.Library):
        show_library(out, converted)
        return
    if isinstance(converted, SensorCircuit):
        low, high = converted.band
        many = counted(len(converted.circuit.elements), "passive element")
        if is_touchstone(out):
            many = f"impedances between {counted(len(converted.cavities) + len(converted.fronts), 'port')}"
        tell(f"{out}: {many}, largest difference to the library {converted.error:.1e} from {low:g} to {high:g} Hz")
        return
    low, high = converted.band
    tell(f"{out}: {converted.order} poles, error {converted.error:.1e} from {low:g} to {high:g} Hz")
    if converted.margin is None:
        tell("passivity is not checked, because the library has no impedance between microphones")
    else:
        tell(f"passive from 1e-3 to 1e5 Hz: the least eigenvalue of the impedances is {converted.margin:.1e}")
