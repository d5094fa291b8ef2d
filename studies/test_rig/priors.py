"""Knowledge of an as-built sensor before anything is measured: tolerances as spread of responses and as priors."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from acoustic_fem.calibration.fitted_model import Priors
from acoustic_fem.quantities.local_air import design_air
from acoustic_fem.scatter.as_built_sensors import AsBuiltSensors
from acoustic_fem.scatter.tolerances import TOLERANCES, ScatteredDesign, Tolerance
from geometry.design.array_design import ArrayDesign
from geometry.ground.typed import Array

_PER_VOLUME = math.pi / (1.4 * 101325)
"""Compliance of a cylinder of air per its radius squared times its height, 1/Pa."""
_DEVIATION_SENSORS, _PRIOR_SENSORS = 64, 256
"""Sensors drawn from the tolerances."""


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
    return replace(
        Priors(),
        bore=_prior(float(np.std(resistance))),
        compliance=_prior(float(np.std(shift)) / of_membrane),
        modulus=_prior(common[0] if common else 0.0),
    )


def _prior(deviation: float) -> float:
    """At least a thousandth: what does not scatter is not known better than that."""
    return float(np.clip(deviation, 1e-3, 1.0))
