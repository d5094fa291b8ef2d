"""Knowledge of an as-built sensor before anything is measured: tolerances as spread of responses and as priors."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from acoustic_fem.calibration.build_record import BuildRecord
from acoustic_fem.calibration.fitted_model import KnownParts, Priors
from acoustic_fem.quantities.local_air import design_air
from acoustic_fem.scatter.as_built_sensors import AsBuiltSensors
from acoustic_fem.scatter.tolerances import TOLERANCES, ScatteredDesign, Tolerance
from geometry.design.array_design import ArrayDesign
from geometry.ground.typed import Array

_PER_VOLUME = math.pi / (1.4 * 101325)
"""Compliance of a cylinder of air per its radius squared times its height, 1/Pa."""
_DEVIATION_SENSORS, _PRIOR_SENSORS = 64, 256
"""Sensors drawn from the tolerances."""
_LEAST_STEP = 0.02
"""Least tolerance of thickness that discs are interpolated over, mm."""
_CORNER = 0.3
"""Deviation of the high-pass corner of a microphone whose tolerance is not stated: data sheets give a typical value."""


def model_deviation(design: ArrayDesign, frequency: Array, tolerances: Sequence[Tolerance] = TOLERANCES) -> Array:
    """Deviation of the transfer functions of made sensors from those of the design.

    Args:
        design: the nominal array.
        frequency: (n_freq,) float64, Hz.
        tolerances: of manufacturing.

    Returns:
        (n_point, n_microphone, n_freq) float64, Pa/Pa: root mean square of the real part, and of the imaginary part, of
        the difference.
    """
    scattered = ScatteredDesign(design, tolerances)
    sensors = AsBuiltSensors(scattered, frequency, design_air(design))
    made = sensors.transfer_functions(scattered.draws(0, _DEVIATION_SENSORS, 0))
    return np.asarray(np.sqrt((np.abs(made - sensors.nominal) ** 2).mean(0) / 2))


def fit_priors(design: ArrayDesign, tolerances: Sequence[Tolerance] = TOLERANCES) -> Priors:
    """Priors of a fit from manufacturing tolerances; what they say nothing of keeps its default.

    The corner of each microphone is left open by 30 % unless its tolerance is stated, because recordings determine it.
    A tube's length counts as bore by what it does to the resistance, length / bore^4; all that scatters at a point
    counts as compliance of its membrane.
    """
    kept = [tolerance for tolerance in tolerances if tolerance.quantity != "modulus_of_batch"]
    common = [tolerance.deviation for tolerance in tolerances if tolerance.quantity == "modulus_of_batch"]
    scattered = ScatteredDesign(design, kept)
    made, nominal = scattered.sample(0, _PRIOR_SENSORS, 0), scattered.nominal
    resistance = np.log(made.tube_length / nominal.tube_length) / 4 - np.log(made.tube_radius / nominal.tube_radius)
    volume = made.cavity_radius**2 * made.cavity_height * _PER_VOLUME
    designed = nominal.membrane_compliance + nominal.cavity_radius**2 * nominal.cavity_height * _PER_VOLUME
    shift = np.log((made.membrane_compliance + volume) / designed)
    of_membrane = float((made.membrane_compliance / (made.membrane_compliance + volume)).mean())
    stated = {tolerance.quantity: tolerance.deviation for tolerance in tolerances}
    return replace(
        Priors(),
        gain=_prior(stated.get("microphone_gain", Priors.gain)),
        corner=_prior(stated.get("microphone_corner", _CORNER)),
        chamber=_prior(stated.get("chamber_height", Priors.chamber)),
        bore=_prior(float(np.std(resistance))),
        compliance=_prior(float(np.std(shift)) / of_membrane),
        modulus=_prior(common[0] if common else 0.0),
    )


def _prior(deviation: float) -> float:
    """At least a thousandth: what does not scatter is not known better than that."""
    return float(np.clip(deviation, 1e-3, 1.0))


def known_parts(design: ArrayDesign, record: BuildRecord, tolerances: Sequence[Tolerance] = TOLERANCES) -> KnownParts:
    """Knowledge of the membranes of a sensor from the record of its build.

    A membrane whose thickness was measured has the compliance of that thickness, and scatters by the error of the
    measurement in place of the tolerance of thickness. A batch whose modulus was measured has that modulus; others keep
    the tolerance of a batch.

    Args:
        design: the nominal array.
        record: of the build.
        tolerances: of manufacturing.
    """
    count = design.point_count
    mean = np.zeros(count)
    usual = fit_priors(design, tolerances)
    deviation = np.full(count, usual.compliance)
    if record.thickness:
        measured = np.array(sorted(record.thickness)) - 1
        mean[measured] = _compliance_of_thickness(design, record)
        error = Tolerance("membrane_thickness", record.thickness_error, "absolute", "the record of the build")
        others = [each for each in tolerances if each.quantity != "membrane_thickness"]
        deviation[measured] = fit_priors(design, [*others, error]).compliance
    stated = design.material(design.membrane.material).youngs_modulus
    batch = np.zeros(count, np.int64)
    for number, each in enumerate(record.batches):
        batch[np.array(each.points) - 1] = number
    return KnownParts(
        mean,
        deviation,
        batch,
        tuple(each.name for each in record.batches),
        np.array([0.0 if each.modulus is None else math.log(each.modulus / stated) for each in record.batches]),
        np.array([usual.modulus if each.modulus is None else each.modulus_error for each in record.batches]),
    )


def _compliance_of_thickness(design: ArrayDesign, record: BuildRecord) -> Array:
    """Logarithm of the compliance of measured membranes by that of the design, in the order of their points,
    (n_measured,) float64.
    """
    points = np.array(sorted(record.thickness)) - 1
    designed = [design.of_kind(design.kinds[design.kind_of_point[point]]).membrane.thickness for point in points]
    off = np.array([record.thickness[int(point) + 1] for point in points]) - designed
    # The interpolation of discs covers three deviations of the tolerance that it is made for.
    step = max(float(np.abs(off).max()) / 2, _LEAST_STEP)
    scattered = ScatteredDesign(design, [Tolerance("membrane_thickness", step, "absolute", "the record of the build")])
    draws = {name: np.zeros_like(value) for name, value in scattered.draws(0, 1, 0).items()}
    draws["membrane_thickness"][0, points] = off / step
    made, nominal = scattered.parameters(draws).membrane_compliance, scattered.nominal.membrane_compliance
    return np.asarray(np.log(made / nominal)[0, points])
