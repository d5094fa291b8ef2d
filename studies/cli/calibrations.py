"""Verbs on a made sensor and its library: rig, calibrate, recalibrate, convert."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from acoustic_fem.quantities.fidelity import Fidelity
from acoustic_fem.quantities.local_air import LocalAir
from geometry.ground.refusal import counted
from localize.recalibration.rejections import numbers
from localize.signals.stimulus import BAND
from studies.cli.options import (
    Altitude,
    Design,
    Frequencies,
    FullScale,
    LibraryFile,
    Noise,
    Pressure,
    Temperature,
    Tolerances,
    defaults_of,
    display_on_stderr,
    noise_choice,
)
from studies.cli.terminal_tables import show, show_library, table_of, tell
from studies.output.frequencies import CALIBRATION_FREQUENCIES
from studies.run.library_files import convert_library
from studies.test_rig.calibrating import MANIFEST, SensorCalibration, calibrate_sensor
from studies.test_rig.recalibrating import recalibrate as recalibrate_sensor
from studies.test_rig.rig_session import record_rig
from studies.test_rig.virtual_rig import HiddenScatter

#: s, from which on a delay that the fit found is told.
_NOTED_DELAY = 3e-4
_FIDELITY: Fidelity = defaults_of(calibrate_sensor)["fidelity"]
_SEED = defaults_of(recalibrate_sensor)["seed"]
_RIG_SEED = defaults_of(record_rig)["seed"]


def rig(
    design: Design,
    out: Annotated[Path, typer.Option(help="The folder to write to.", show_default=False)],
    seed: Annotated[int, typer.Option(help="Of the sensor: another one, another sensor.", min=0)] = _RIG_SEED,
    altitude: Annotated[
        float, typer.Option(metavar="M", help="Height of its place above that of the design's pressure.")
    ] = 0.0,
    modulus: Annotated[
        float, typer.Option(metavar="FACTOR", help="Modulus of its membranes against the design's; 0.85 is softer.")
    ] = 1.0,
    fidelity: Annotated[Fidelity, typer.Option(help="Of the sensor's transfer functions.")] = _FIDELITY,
) -> None:
    """Recordings of a virtual made sensor, to try everything before there is a real one.

    Its parts deviate from the design, its rubber, its microphones and the air of its place too; recordings have noise,
    hum and wander, touches the spectra and the hysteresis of fingers. None of it is what decodes them.

    calibration: a recording of each point with a calibration microphone, as calibrate reads them. touches: recordings
    of each point whose names say which, as locate, recalibrate and train --recordings read them. truth.json: what was
    hidden, seed and versions; truth.nc: the library of the sensor as it is, as evaluate reads it. Not to be looked at
    before.

    Example: [bold]acoustic-fem rig array-2x6 --out bench; acoustic-fem calibrate bench/calibration --out made.nc[/bold]
    """
    scatter = HiddenScatter(altitude=altitude, modulus=modulus)
    with display_on_stderr() as display:
        made = record_rig(design, out, seed=seed, fidelity=fidelity, scatter=scatter, display=display)
    for path in (made.calibration, made.touches, made.truth, made.library):
        print(path)
    tell(f"full scale of the touches: {made.full_scale:g} Pa, which locate and recalibrate take as --full-scale")


def calibrate(
    recordings: Annotated[
        Path,
        typer.Argument(
            metavar="RECORDINGS",
            help=f"A manifest, TOML, or a folder with one called {MANIFEST}: docs/calibration.md.",
            show_default=False,
        ),
    ],
    out: Annotated[
        Path,
        typer.Option(help="The library to write, netCDF, a new file; a figure goes beside.", show_default=False),
    ],
    fidelity: Annotated[
        Fidelity, typer.Option(help="Of the design's own transfer functions, which stand in for missing points.")
    ] = _FIDELITY,
    frequencies: Frequencies = CALIBRATION_FREQUENCIES,
    tolerances: Tolerances = None,
    pressure: Pressure = None,
    altitude: Altitude = None,
    temperature: Temperature = None,
) -> None:
    """From recordings of the made sensor to its library: measured transfer functions with their uncertainty.

    Swept sines or noise at each point, a calibration microphone at the touched cavity. Bad recordings are left out and
    named. Where points lack a good one, all follow from a fit of the sensor's parts to the measured points; where no
    sensor within the tolerances is like the measured one, that is said, and they keep those of the design.

    The library ends with --frequencies: what is made of it takes touches to be silent above.

    Example: [bold]acoustic-fem calibrate recordings --out made.nc[/bold]
    """
    air = LocalAir(pressure, altitude, temperature)
    with display_on_stderr() as display:
        found = calibrate_sensor(
            recordings, out, fidelity=fidelity, frequency=frequencies, tolerances=tolerances, air=air, display=display
        )
    calibration = found.calibration
    if calibration.findings:
        table = table_of("point", "", "finding", numbers=(0,))
        for finding in calibration.findings:
            table.add_row(str(finding.point), "left out" if finding.excluded else "note", finding.text)
        show(table)
    _print_fit(found)
    source = "of the design" if found.fit is not None and found.fit.objection else "fitted"
    rest = f", {len(calibration.missing)} {source}" if calibration.missing else ""
    tell(
        f"{out}: {len(calibration.estimates)} of {counted(calibration.manifest.design.point_count, 'point')} "
        f"measured{rest}"
    )
    print(found.figure)


def _print_fit(found: SensorCalibration) -> None:
    """What the fit says of the missing points, where there was one."""
    fit = found.fit
    if fit is None:
        return
    determined = int((fit.eigenvalues >= 1).sum())
    print(
        f"fit: {'does not agree' if fit.objection else 'agrees'} with the measurement, chi-squared "
        f"{fit.chi_squared:.0f} for {fit.residuals} residuals; {determined} of {len(fit.parameters)} combinations of "
        "parameters determined"
    )
    if fit.objection:
        print(
            f"fit not used: {fit.objection}\nwarning: measured and designed points beside each other may decode "
            "worse than the design's own library; measure point "
            f"{', '.join(map(str, found.calibration.missing))} too, or find what is wrong with point {fit.worst_point}"
        )
        return
    print(_prospect(found))
    if abs(fit.delay) > _NOTED_DELAY:
        when = f"{1e3 * abs(fit.delay):.1f} ms {'later' if fit.delay > 0 else 'earlier'}"
        print(f"the array's microphones came {when} than stated, against the reference; the fit allows for it")


def _prospect(found: SensorCalibration) -> str:
    """What is to be expected of the fitted library, and what to measure next."""
    shares = found.expected
    if shares is None:
        return f"--frequencies do not cover {BAND[0]:g} to {BAND[1]:g} Hz: what to expect of the fit is not known"
    text = (
        f"to expect: {100 * shares.mean():.1f} % of touches classified correctly, {100 * shares[0]:.1f} % in the worst "
        f"of {len(shares)} cases"
    )
    if found.measure_next is None:
        return text
    return f"{text}; warning: measure another point, best point {found.measure_next}"


def recalibrate(
    library: LibraryFile,
    recordings: Annotated[
        list[Path],
        typer.Argument(
            metavar="RECORDINGS",
            help="Touches, one at a time, spread over all points: WAV with a channel per "
            "microphone; CSV with their names on top; NPZ with 'signals'.",
            show_default=False,
        ),
    ],
    out: Annotated[Path, typer.Option(help="The library to write, netCDF, a new file.", show_default=False)],
    full_scale: FullScale = None,
    noise: Noise = None,
    seed: Annotated[int, typer.Option(help="Of the choice of the touches that judge.", min=0)] = _SEED,
    pressure: Pressure = None,
    altitude: Altitude = None,
    temperature: Temperature = None,
) -> None:
    """From touches of which nobody knows the points to the library of the sensor as it is now.

    LIBRARY is that of the design or the last calibration. Needed are touches of fingers (taps, presses, slides),
    multi-sines or noise, one at a time, in a quiet room, spread over all points: at least 100 frames of 250 ms, better
    300, and several per point. A quarter of them is held out and judges; where they do not speak for the
    sensor found, that is said with the reason, nothing is written, and LIBRARY stays what is best known.

    Example: [bold]acoustic-fem recalibrate made.nc monday.wav tuesday.wav --out now.nc[/bold]
    """
    air, level = LocalAir(pressure, altitude, temperature), noise_choice(noise)
    with display_on_stderr() as display:
        found = recalibrate_sensor(
            library, recordings, out, full_scale=full_scale, microphone_noise=level, seed=seed, air=air, display=display
        ).found
    print(
        f"{out}: from {counted(found.frames, 'frame')} with touches; {found.gain:.2f} +- {found.gain_error:.2f} nats "
        f"per held-out frame likelier than with {library}, {100 * found.explained:.0f} % of them explained"
    )
    if len(found.untouched):
        print(f"no touch was named point {numbers(found.untouched)}: least known; touch it next time")


def convert(
    library: Annotated[
        Path, typer.Argument(metavar="LIBRARY", help="A library: .nc, .sofa, .npz or .csv.", show_default=False)
    ],
    out: Annotated[
        Path,
        typer.Option(help="The file to write, of another such suffix; a measured library is kept.", show_default=False),
    ],
) -> None:
    """A library in another format: netCDF, SOFA (AES69-2022, GeneralTF-E), NPZ or CSV, and back to the last digit.

    Example: [bold]acoustic-fem convert library.nc --out library.sofa[/bold]
    """
    show_library(out, convert_library(library, out))
