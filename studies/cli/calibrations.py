"""The verb calibrate."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from geometry.refusal import Refusal
from studies.cli.options import Fidelity, Frequencies, Tolerances, display_on_stderr, frequency_option, named
from studies.cli.tables import show, table_of

if TYPE_CHECKING:
    from acoustic_fem.calibration.model_updating import Update

#: The manifest of a folder of recordings.
MANIFEST = "calibration.toml"
#: s, from which on a delay that the fit found is told.
_NOTED_DELAY = 3e-4


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
    ] = Fidelity.lumped,
    frequencies: Frequencies = "1:100:64",
    tolerances: Tolerances = None,
) -> None:
    """From recordings of the made sensor to its library: measured transfer functions with their uncertainty.

    Swept sines or noise at each point, a calibration microphone at the touched cavity. Bad recordings are left out and
    named. Where points lack a good one, all follow from a fit of the sensor's parts to the measured points; where no
    sensor within the tolerances is like the measured one, that is said, and they keep those of the design.

    Example: [bold]acoustic-fem calibrate recordings --out made.nc[/bold]
    """
    grid = frequency_option(frequencies)
    from studies.output.folders import check_new_file

    picture = out.with_suffix(".png")
    if out.suffix.lower() != ".nc":
        raise Refusal(f"{out}: --out must be a library, .nc; its figure goes beside it as .png")
    check_new_file(out, kept="a measured library")
    check_new_file(picture, kept="the figure of one")
    import acoustic_fem
    from acoustic_fem.calibration.fitted_model import UpdatedModel
    from acoustic_fem.calibration.manifest import read_manifest
    from acoustic_fem.calibration.measured_library import calibrate as estimate
    from acoustic_fem.calibration.model_updating import update
    from studies.made_sensor.figures import draw_calibration
    from studies.made_sensor.priors import fit_priors, model_deviation
    from studies.scatter.tolerances import TOLERANCES, read_tolerances

    scatter = TOLERANCES if tolerances is None else read_tolerances(tolerances)
    manifest = read_manifest(recordings / MANIFEST if recordings.is_dir() else recordings)
    with display_on_stderr() as display, named(frequency="--frequencies"):
        with display.stage("Design") as report:
            model = acoustic_fem.solve(manifest.design, grid, fidelity=fidelity.value, progress=report)
        with display.stage("Recordings") as report:
            calibration = estimate(manifest, model, report)
        fit, deviation = None, None
        if calibration.missing:
            with display.stage("Fit"):
                fit = update(UpdatedModel(model, fit_priors(manifest.design, scatter)), calibration.estimates)
                deviation = model_deviation(manifest.design, grid, scatter)
        library = calibration.library(model, deviation, None if fit is None or fit.objection else fit)
        acoustic_fem.save(library, out)
        figure = draw_calibration(calibration, model, picture)
    if calibration.findings:
        table = table_of("point", "", "finding", numbers=(0,))
        for finding in calibration.findings:
            table.add_row(str(finding.point), "left out" if finding.excluded else "note", finding.text)
        show(table)
    if fit is not None:
        determined = int((fit.eigenvalues >= 1).sum())
        print(
            f"fit: chi-squared {fit.chi_squared:.0f} for {fit.residuals} residuals; {determined} of "
            f"{len(fit.parameters)} combinations of parameters determined"
        )
        if fit.objection:
            print(
                f"fit not used: {fit.objection}\nwarning: measured and designed points beside each other may decode "
                "worse than the design's own library; measure point "
                f"{', '.join(map(str, calibration.missing))} too, or find what is wrong with point {fit.worst_point}"
            )
        else:
            print(_prospect(fit))
            if abs(fit.delay) > _NOTED_DELAY:
                when = f"{1e3 * abs(fit.delay):.1f} ms {'later' if fit.delay > 0 else 'earlier'}"
                print(f"the array's microphones came {when} than stated, against the reference; the fit allows for it")
    source = "of the design" if fit is not None and fit.objection else "fitted"
    rest = f", {len(calibration.missing)} {source}" if calibration.missing else ""
    print(f"{out}: {len(calibration.estimates)} of {manifest.design.point_count} points measured{rest}")
    print(figure)


def _prospect(fit: Update) -> str:
    """What is to be expected of the fitted library, and what to measure next."""
    from localize.recalibration.accuracy_to_expect import DRAWS, expected_accuracy, is_enough, least_known
    from localize.signals.stimulus import BAND

    if fit.model.frequency[0] > BAND[0] or fit.model.frequency[-1] < BAND[1]:
        return f"--frequencies do not cover {BAND[0]:g} to {BAND[1]:g} Hz: what to expect of the fit is not known"
    shares = expected_accuracy(fit)
    text = (
        f"to expect: {100 * shares.mean():.1f} % of touches named right, {100 * shares[0]:.1f} % in the worst of "
        f"{DRAWS} cases"
    )
    return text if is_enough(fit, shares) else f"{text}; warning: measure another point, best point {least_known(fit)}"
