"""Signals that a sensor without a leak must give: level of every point at its two loudest microphones.

They are lumped transfer functions at one low frequency, so that the first recording can be compared point by point.
The spread is that of sensors with the tolerances of a workshop.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

import acoustic_fem
from acoustic_fem.batch import ArrayParameters, Topology, batch_response
from acoustic_fem.duct.leak import leak_conductance
from acoustic_fem.network.microphone_output import output_response
from acoustic_fem.quantities.local_air import design_air
from acoustic_fem.scatter import AsBuiltSensors, ScatteredDesign, UnknownScatterError
from geometry.design.array_design import ArrayDesign
from geometry.ground.refusal import Refusal
from geometry.ground.typed import Array

#: Frequency of the comparison, Hz: taps and presses of fingers have most of their energy about here.
FREQUENCY = 10.0
#: Frequency at which a leak is looked for, Hz: the high-pass of a stream, below which nothing is decoded.
LEAK_FREQUENCY = 3.0
#: Diameter and length of the hole whose signal is stated, m: a joint that the glue has missed.
HOLE, HOLE_LENGTH = 1e-4, 1e-3
#: Sensors that are drawn for the spread.
_SENSORS = 64


@dataclass(frozen=True)
class ExpectedSignal:
    """Expected signal of one point for a pressure of 1 Pa in its cavity."""

    point: int
    """Number of the point, from 1."""
    louder: str
    """Microphone that hears it best."""
    softer: str
    """Microphone that hears it second best; empty where there is only one."""
    level: float
    """Sound pressure at the louder microphone, Pa."""
    difference: float
    """Level of the louder relative to the softer microphone, dB."""
    spread: float | None
    """Two standard deviations of that difference over as-built sensors, dB; None where the scatter is not known."""
    leak: float | None
    """Change of the level at the louder microphone at 3 Hz by a hole of 0.1 mm beside the point, dB, negative; None
    where the network of closed forms does not take the cavity."""


def expected_signals(design: ArrayDesign, built: Array | None) -> tuple[ExpectedSignal, ...]:
    """Expected signal of every point of a design.

    Args:
        design: the array.
        built: levels of as-built sensors, see :func:`as_built_levels`.
    """
    nominal = acoustic_fem.solve(design, np.array([FREQUENCY]), fidelity="lumped").transfer_function
    h = np.abs(nominal.transpose("point", "microphone", "frequency").values[..., 0])
    order = np.asarray(np.argsort(-h, axis=1, kind="stable"), np.int64)
    spread, leak = _spread(built, order), _leak(design, order[:, 0])
    names, signals = design.microphones, []
    for point, (first, *others) in enumerate(order.tolist()):
        second = others[0] if others else None
        level = h[point, first]
        signals.append(
            ExpectedSignal(
                point + 1,
                names[first],
                "" if second is None else names[second],
                float(level),
                0.0 if second is None else float(20 * np.log10(level / h[point, second])),
                None if spread is None else float(spread[point]),
                None if leak is None else float(leak[point]),
            )
        )
    return tuple(signals)


def microphone_loss(design: ArrayDesign) -> float:
    """Output of a microphone at :data:`FREQUENCY` relative to that at 1 kHz, dB, negative below its corner."""
    return float(20 * np.log10(np.abs(output_response(design.microphone, FREQUENCY, design_air(design)))))


def _leak(design: ArrayDesign, louder: NDArray[np.int64]) -> Array | None:
    """Change of the level of each point at its louder microphone by a hole beside it, (n_point,) float64, dB.

    It is that of the pressure per displaced volume: the pressure in the touched cavity falls as well.
    """
    air, shared = design_air(design), Topology.of(design)
    try:
        tight = ArrayParameters.from_design(design, air).individual(shared)
    except Refusal:
        return None
    points, topology = design.point_count, shared.individual()
    hole = np.eye(points) * leak_conductance(HOLE / 2, HOLE_LENGTH, air)
    leaky = replace(tight, leak_conductance=np.asarray(tight.leak_conductance) + hole)
    levels = []
    for parameters in (tight, leaky):
        h = np.abs(batch_response(parameters, topology, np.array([LEAK_FREQUENCY]), air).source_response[..., 0])
        levels.append(np.broadcast_to(h, (points, *h.shape[1:])))
    own = np.arange(points), np.arange(points), louder
    return np.asarray(20 * np.log10(levels[1][own] / levels[0][own]))


def as_built_levels(design: ArrayDesign) -> Array | None:
    """Levels of touches on as-built sensors at :data:`FREQUENCY`, relative to the touched cavity, dB.

    Returns:
        (n_sensor, n_point, n_microphone) float64; None for a single microphone, or where the scatter is not known.
    """
    if len(design.microphones) < 2:
        return None
    try:
        scattered = ScatteredDesign(design)
    except UnknownScatterError:
        return None
    sensors = AsBuiltSensors(scattered, np.array([FREQUENCY]))
    h = sensors.transfer_functions(scattered.draws(0, _SENSORS, 0))[..., 0]
    return np.asarray(20 * np.log10(np.abs(h)))


def _spread(built: Array | None, order: NDArray[np.int64]) -> Array | None:
    """Two standard deviations of the difference of the two loudest microphones, (n_point,) float64, dB."""
    if built is None:
        return None
    first, second = (np.take_along_axis(built, order[None, :, number, None], axis=2)[..., 0] for number in (0, 1))
    return np.asarray(2 * np.std(first - second, axis=0))
