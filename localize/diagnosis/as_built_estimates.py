"""As-built parameters of a sensor, estimated from touches together with its fault: values with 95 % intervals.

A fit finds the deviations of the parts and of the air that make the touches likeliest, and the curvature of the
likelihood there (:mod:`localize.diagnosis.fault_likelihood`). The inverse of the curvature is the covariance of the
deviations, if the model is exact. It is not: lengths, losses and relaxations of a real sensor deviate too. Therefore
the covariance that touches leave is widened by a factor, up to that of the tolerances.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from acoustic_fem.scatter.tolerances import QUANTITIES
from geometry.ground.typed import Array
from localize.diagnosis.fault_libraries import AROUND, FaultLibraries
from localize.diagnosis.fault_likelihood import Fitted
from localize.diagnosis.faults import tube_name

DEVIATIONS = 1.96
"""Half of a 95 % interval of a normal distribution, standard deviations."""


@dataclass(frozen=True)
class AsBuiltEstimate:
    """Estimate of one parameter of a built sensor."""

    quantity: str
    """Name of the parameter: one of :data:`acoustic_fem.scatter.tolerances.QUANTITIES`, ``pressure``, ``temperature``
    or ``rubber_slope``."""
    part: str
    """Part that it belongs to, such as "point 3"."""
    value: float
    """Likeliest value: Pa for the pressure, degrees Celsius for the temperature, else a ratio to the library's."""
    low: float
    """Lower end of the 95 % interval."""
    high: float
    """Upper end of the 95 % interval."""
    measured: bool
    """True if the touches narrow the interval to less than :attr:`DiagnosisOptions.measured` of that of the
    tolerances; otherwise the value is hardly more than the design's."""


def as_built_estimates(libraries: FaultLibraries, fitted: Fitted) -> tuple[AsBuiltEstimate, ...]:
    """Estimates of the parameters of a sensor.

    The modulus of a point is that of its own membrane, the deviation of the batch included.

    Args:
        libraries: of the design.
        fitted: hypothesis whose deviations are taken, the likeliest one.
    """
    options = libraries.options
    prior, covariance = np.ones(libraries.size), np.linalg.inv(fitted.precision)
    variance = np.minimum(options.widened**2 * np.diag(covariance), prior)
    # With its correlations kept, a covariance that is widened stays one.
    scale = np.sqrt(variance / np.diag(covariance))
    widened = covariance * np.outer(scale, scale)
    sizes, entries = libraries.deviation_sizes, libraries.entries
    batch = next((k for k, (name, _) in enumerate(entries) if name == "modulus_of_batch"), None)
    found = []
    for number, (name, part) in enumerate(entries):
        step = np.zeros(libraries.size)
        step[number] = sizes[number]
        if name == "modulus_of_part" and batch is not None:
            step[batch] = sizes[batch]
        found.append(_ratio(name, _part(libraries, name, part), step, fitted.deviations, widened, options.measured))
    base = {"pressure": libraries.medium.pressure, "temperature": libraries.design.air.temperature, "rubber_slope": 1.0}
    for number, (name, size) in enumerate(zip(AROUND, sizes[len(entries) : -1], strict=True), start=len(entries)):
        value = base[name] + size * fitted.deviations[number]
        half = DEVIATIONS * size * np.sqrt(widened[number, number])
        is_measured = bool(np.sqrt(widened[number, number]) < options.measured)
        owner = "rubber" if name == "rubber_slope" else "air"
        found.append(AsBuiltEstimate(name, owner, float(value), float(value - half), float(value + half), is_measured))
    return tuple(found)


def _ratio(name: str, part: str, step: Array, deviations: Array, covariance: Array, measured: float) -> AsBuiltEstimate:
    """Estimate of a ratio that the deviations times ``step``, each (n_deviation,), change."""
    value = float(np.prod(1 + step * deviations))
    error = float(np.sqrt(step @ covariance @ step))
    half = DEVIATIONS * error
    # A ratio is positive, so its interval is one of its logarithm.
    low, high = value * float(np.exp(-half)), value * float(np.exp(half))
    return AsBuiltEstimate(name, part, value, low, high, error < measured * float(np.linalg.norm(step)))


def _part(libraries: FaultLibraries, name: str, part: int) -> str:
    """Name of a part of a quantity, counted from 0."""
    kind = QUANTITIES[name]
    if kind == "tube":
        return tube_name(libraries.design, part + 1)
    if kind == "microphone":
        return f"microphone {libraries.design.microphones[part]}"
    return f"point {part + 1}" if kind == "point" else "all membranes"
