"""From recordings of a made sensor to its library."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

import acoustic_fem
import localize
from acoustic_fem import Library
from acoustic_fem.calibration import Calibration, Update
from acoustic_fem.calibration.fitted_model import UpdatedModel
from acoustic_fem.calibration.manifest import read_manifest
from acoustic_fem.calibration.measured_library import CalibrationError, calibrate
from acoustic_fem.calibration.model_updating import update
from acoustic_fem.quantities.checks import FrequencyLike, frequency_grid
from acoustic_fem.quantities.fidelity import ONE_DESIGN
from acoustic_fem.quantities.local_air import LocalAir, checked_air
from acoustic_fem.scatter.tolerances import Tolerance, tolerances_of
from geometry.ground.refusal import Field, Kind, Refusal
from geometry.ground.shown import Shown
from geometry.ground.typed import PathLike
from localize.diagnosis.bad_fits import fault_of_estimates
from localize.signals import BAND
from studies.output.call_defaults import MANIFEST
from studies.output.display import Display
from studies.output.folders import check_new_file, claimed_file
from studies.output.frequencies import CALIBRATION_FREQUENCIES
from studies.test_rig.calibration_figures import draw_calibration
from studies.test_rig.priors import fit_priors, known_parts, model_deviation


@dataclass(frozen=True, eq=False, repr=False)
class SensorCalibration(Shown):
    """Calibration of a sensor, and the library that was written."""

    out: Path
    """File of the library."""
    figure: Path
    """Picture beside it."""
    library: Library
    """Measured transfer functions with their uncertainty."""
    calibration: Calibration
    """Estimates of the measured points, and what was found of each recording."""
    fit: Update | None
    """Fit of the design's parts to the measured points, where points lack a good recording; else None. Where it has an
    objection, the missing points are those of the design."""
    expected: NDArray[np.float64] | None
    """Expected top-1 accuracies on sensors that agree with the fit, ascending; (n_draw,) float64. None without a fit
    that is used, or if the frequencies do not cover the band of the stimuli."""
    measure_next: int | None
    """Number of the point to measure next; None where no other is needed, or nothing is known of it."""

    def shown(self) -> tuple[str, Mapping[str, object]]:
        """Title and facts that a session and a notebook show."""
        expected, fit = self.expected, self.fit
        return f"Calibration of {self.library.design.name}", {
            "library": self.out,
            "picture": self.figure,
            "fitted from points": "" if fit is None else ", ".join(map(str, fit.points)),
            "objection": "" if fit is None else fit.objection,
            "expected top-1 accuracy": "" if expected is None else f"{expected.mean():.1%}, worst {expected[0]:.1%}",
            "measure next": "" if self.measure_next is None else f"point {self.measure_next}",
        }


def calibrate_sensor(
    recordings: PathLike,
    out: PathLike,
    *,
    fidelity: str = ONE_DESIGN,
    frequency: FrequencyLike = CALIBRATION_FREQUENCIES,
    tolerances: PathLike | Sequence[Tolerance] | None = None,
    air: LocalAir | None = None,
    display: Display | None = None,
) -> SensorCalibration:
    """Calibration of an as-built sensor from recordings: a library of measured transfer functions with their
    uncertainty.

    Bad recordings are left out and listed. The transfer functions of points without a good recording are computed with
    dimensions of the parts that are fitted to the measured points. If no sensor within the tolerances fits, these
    points keep the transfer functions of the design. If the manifest names a record of the build, the fit starts from
    the thicknesses and moduli that were measured there, and trusts them by their errors.

    Args:
        recordings: a manifest (TOML), or a folder with one called ``calibration.toml``.
        out: the library to write, netCDF (``.nc``), a new file; a figure goes beside it.
        fidelity: fidelity of the design's transfer functions, which are used for points without a recording.
        frequency: (n_freq,) Hz, ascending, or FIRST:LAST:COUNT.
        tolerances: tolerances of the workshop, or a TOML file of them; by default assumed ones.
        air: air during the recordings; values that you do not give are those of the design.
        display: shows progress.

    Raises:
        Refusal: a file that exists or cannot be written, a manifest or tolerances that cannot be read, a bad frequency,
            no good recording, or recordings that contradict the design because a part of the sensor is broken.
    """
    checked_air(air)
    path, show = Path(out), display or Display()
    picture = path.with_suffix(".png")
    if path.suffix.lower() != ".nc":
        remedy = "the figure of the calibration is written beside it as .png"
        raise Refusal(kind=Kind.OUT_OF_RANGE, file=path, field=Field("out"), allowed="a library, .nc", remedy=remedy)

    def check() -> None:
        check_new_file(path, kept="a measured library")
        check_new_file(picture, kept="the figure of one")

    with claimed_file(path, check):
        grid, scatter, source = frequency_grid(frequency), tolerances_of(tolerances), Path(recordings)
        manifest = read_manifest(source / MANIFEST if source.is_dir() else source)
        if air is not None:
            manifest = replace(manifest, design=manifest.design.with_values(air.design_values))
        with show.stage("Design") as report:
            model = acoustic_fem.solve(manifest.design, grid, fidelity=fidelity, progress=report)
        with show.stage("Recordings") as report:
            calibration = calibrate(manifest, model, report)
        fit, deviation = None, None
        if calibration.missing:
            with show.stage("Fit"):
                record = manifest.record
                known = known_parts(manifest.design, record, scatter) if record and record.says_something else None
                family = UpdatedModel(model, fit_priors(manifest.design, scatter), known)
                fit = update(family, calibration.estimates)
                deviation = model_deviation(manifest.design, grid, scatter)
        if calibration.misfits or (fit is not None and fit.objection):
            with show.stage("Diagnosis"):
                _refuse_a_broken_sensor(calibration, model)
        used = None if fit is None or fit.objection else fit
        library = calibration.library(model, deviation, used)
        acoustic_fem.save(library, path)
        figure = draw_calibration(calibration, model, picture)
        expected, measure_next = (None, None) if used is None else _prospect(used)
        return SensorCalibration(path, figure, library, calibration, fit, expected, measure_next)


def _refuse_a_broken_sensor(calibration: Calibration, model: Library) -> None:
    """Refuse recordings that a broken part explains, where they contradict the design or no sensor fits them."""
    found = fault_of_estimates(model, {**calibration.misfits, **calibration.estimates})
    if found is not None:
        raise CalibrationError(
            f"are of a sensor with a fault: {found.text}",
            kind=Kind.UNSUITABLE,
            field="recordings",
            remedy=found.to_do,
        )


def _prospect(fit: Update) -> tuple[NDArray[np.float64] | None, int | None]:
    """Expected quality of the fitted library, and the next measurement."""
    if fit.model.frequency[0] > BAND[0] or fit.model.frequency[-1] < BAND[1]:
        return None, None
    shares = localize.recalibration.expected_accuracy(fit)
    return shares, None if localize.recalibration.is_enough(fit, shares) else localize.recalibration.least_known(fit)
