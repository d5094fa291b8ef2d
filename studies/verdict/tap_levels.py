"""Levels of a tap at every microphone, against the noise there: of many designs at once, in closed forms."""

from __future__ import annotations

import math
import warnings
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from typing import TypeVar

import numpy as np

import acoustic_fem
from acoustic_fem.batch.network import batch_response
from acoustic_fem.batch.parameters import ArrayParameters, fits_batch
from acoustic_fem.batch.topology import Topology
from acoustic_fem.library.noise_floor import gas_temperature, thermal_covariance
from acoustic_fem.membrane.disc import KnownDiscs
from acoustic_fem.network.microphone import noise_density
from acoustic_fem.network.microphone_output import output_response
from acoustic_fem.quantities.local_air import design_air
from acoustic_fem.quantities.model_limit_warning import ModelLimitWarning
from geometry.design.array_design import ArrayDesign
from geometry.ground.typed import Array
from geometry.schema.array_fields import Air
from localize.contacts.contact import hertz_fraction
from localize.contacts.finger_gestures import TAP_SECONDS
from localize.signals.stimulus import BAND
from studies.metrics.batch_responses import Responses, required
from studies.metrics.separation import pair_distances
from studies.metrics.touch_metrics import touch_response

SLOW = (3.0, 10.0)
"""Band of slow touches, Hz: from the high-pass of a stream to the first frequencies that differ between points."""
FREQUENCIES = np.unique(np.concatenate([np.geomspace(*BAND, 40), SLOW]))
"""Frequencies at which the levels are computed, Hz."""
TAP = math.sqrt(math.prod(TAP_SECONDS))
"""Length of the tap, s: the geometric mean of the shortest and the longest tap of a finger."""
LOSS_AT = 10.0
"""Frequency of the loss, Hz."""
#: Frequencies from which a tap is put together, Hz, up to five by its length, and the times from its middle, s, in
#: which it is loudest; they repeat after a quarter of a second.
_TAP_GRID = np.arange(2.0, 162.0, 4.0)
_AROUND_TAP = np.arange(-0.05, 0.15, 0.001)

_T = TypeVar("_T")


@dataclass(frozen=True, eq=False)
class TapLevels:
    """Levels of one tap on each point of a design."""

    snr: Array
    """Signal-to-noise ratio behind a matched filter; (n_point, n_microphone) float64, dB."""
    loss: Array
    """Loss from the touched cavity to each microphone at :data:`LOSS_AT`; (n_point, n_microphone) float64, dB."""
    slow: float
    """Smallest distance of two points over :data:`SLOW`, nepers and radians; infinite for one point."""
    alike: tuple[int, int]
    """Numbers of these two points, from 1; zeros for one point."""

    @property
    def second(self) -> Array:
        """Ratio at the second-loudest microphone; (n_point,) float64, dB."""
        return np.asarray(np.sort(self.snr, axis=1)[:, -2])

    @property
    def loss_to_second(self) -> Array:
        """Loss to the second-loudest microphone; (n_point,) float64, dB."""
        order = np.argsort(self.snr, axis=1)[:, -2]
        return np.asarray(self.loss[np.arange(len(order)), order])


def tap_levels(designs: Sequence[ArrayDesign], known: KnownDiscs | None = None) -> list[TapLevels]:
    """Levels of a tap of the force and the contact of each design's target, in the middle of each point.

    The tap lasts :data:`TAP` and rises and falls as sin^2, as :func:`localize.contacts.tap` does. A membrane takes the
    part of the force that lies over it, by Hertz's pressure. The matched filter knows the signal of one microphone over
    1 to 100 Hz, as :func:`acoustic_fem.library.noise_floor.detection_limits`; the noise is that of the air and of the
    microphone. Sound and vibration from outside are not in it. Fidelity: lumped.

    Args:
        designs: the arrays.
        known: membranes that need not be solved.
    """
    return _of_each(designs, FREQUENCIES, _levels, known)


def loudest_taps(designs: Sequence[ArrayDesign], known: KnownDiscs | None = None, seconds: float = TAP) -> list[Array]:
    """Largest output of each microphone while the tap of :func:`tap_levels` is on each point, in closed forms.

    :func:`localize.contacts.loudest_outputs` does so in time, with membranes that stiffen under large presses.

    Args:
        designs: the arrays.
        known: membranes that need not be solved.
        seconds: length of the tap, s; a longer one is a press, which the high-pass of the microphone weakens.

    Returns:
        (n_point, n_microphone) float64 for each design, Pa at 1 kHz, to be compared with ``microphone.overload``.
    """
    return _of_each(designs, _TAP_GRID * TAP / seconds, partial(_loudest, seconds=seconds), known)


def _of_each(
    designs: Sequence[ArrayDesign], grid: Array, figures: Callable[[Responses], list[_T]], known: KnownDiscs | None
) -> list[_T]:
    """Figures of each design from the responses at some frequencies; those of like designs are computed at once."""
    alike: dict[tuple[Topology, Air] | int, list[int]] = {}
    for number, design in enumerate(designs):
        alike.setdefault((Topology.of(design), design.air) if fits_batch(design) else number, []).append(number)
    found: dict[int, _T] = {}
    with warnings.catch_warnings(), np.errstate(over="ignore", under="ignore", invalid="ignore", divide="ignore"):
        # check lists the same limits under validity
        warnings.simplefilter("ignore", ModelLimitWarning)
        warnings.filterwarnings("ignore", "membrane: |noise: ", UserWarning)
        for key, numbers in alike.items():
            own = [designs[number] for number in numbers]
            responses = _alone(own[0], grid) if isinstance(key, int) else _batch(own, grid, key[0], known)
            found |= zip(numbers, figures(responses), strict=True)
    return [found[number] for number in range(len(designs))]


def covered_forces(design: ArrayDesign) -> Array:
    """Force on the membrane of each point if the target's contact presses its middle, (n_point,) float64, N."""
    target = design.target
    radii = np.array([design.of_kind(kind).resonator.cavity_diameter / 2 for kind in design.kinds])
    covered = np.array([hertz_fraction(np.zeros(1), target.contact_radius, float(radius))[0] for radius in radii])
    return np.asarray(target.force * covered[list(design.kind_of_point)])


def _batch(designs: Sequence[ArrayDesign], grid: Array, topology: Topology, known: KnownDiscs | None) -> Responses:
    air = design_air(designs[0])
    found = batch_response(ArrayParameters.from_designs(designs, air, known), topology, grid, air)
    return Responses(
        grid,
        np.asarray(found.transfer_function),
        tuple(designs),
        (air,) * len(designs),
        np.asarray(found.source_response),
        np.asarray(found.point_impedance),
        np.asarray(found.microphone_impedance),
        known,
    )


def _alone(design: ArrayDesign, grid: Array) -> Responses:
    return Responses.of_library(acoustic_fem.solve(design, grid, fidelity="lumped"))


def _levels(responses: Responses) -> list[TapLevels]:
    designs, grid = required(responses.designs), responses.frequency
    force = np.stack([covered_forces(design) for design in designs])
    temperature = np.array([gas_temperature(medium) for medium in required(responses.medium)])
    mutual = np.moveaxis(required(responses.microphone_impedance), -1, 1)
    thermal = np.einsum("dfmm->dmf", thermal_covariance(mutual, temperature[:, None])).real
    own = np.stack([noise_density(design.microphone, grid) for design in designs]) ** 2
    received = touch_response(responses, "force") * force[:, :, None, None]
    power = np.abs(received * _tap_spectrum(grid)) ** 2 / (thermal + own[:, None])[:, None]
    with np.errstate(divide="ignore"):
        snr = 10 * np.log10(4 * np.trapezoid(power, grid, axis=-1))
        loss = -20 * np.log10(np.abs(responses.transfer_function))
    at = int(np.abs(grid - LOSS_AT).argmin())
    count = responses.transfer_function.shape[1]
    if count < 2:
        return [TapLevels(*each, np.inf, (0, 0)) for each in zip(snr, loss[..., at], strict=True)]
    apart = pair_distances(responses, SLOW).combined
    first, second = np.triu_indices(count, 1)
    closest = apart.argmin(axis=1)
    pairs = [(int(first[pair]) + 1, int(second[pair]) + 1) for pair in closest]
    return [TapLevels(*each) for each in zip(snr, loss[..., at], apart.min(axis=1), pairs, strict=True)]


def _loudest(responses: Responses, seconds: float) -> list[Array]:
    designs, grid = required(responses.designs), responses.frequency
    force = np.stack([covered_forces(design) for design in designs])
    outputs = np.stack([output_response(design.microphone, grid, design_air(design)) for design in designs])
    received = touch_response(responses, "force") * force[:, :, None, None] * outputs[:, None, None]
    phases = np.exp(2j * np.pi * grid[:, None] * _AROUND_TAP * seconds / TAP)
    spectrum = np.ascontiguousarray(received * _tap_spectrum(grid, seconds)).view(np.float64)
    # the real part of a product, as a product of real numbers
    course = (
        2 * (grid[1] - grid[0]) * (spectrum @ np.stack([phases.real, -phases.imag], 1).reshape(-1, len(_AROUND_TAP)))
    )
    return list(np.abs(course).max(axis=-1))


def _tap_spectrum(grid: Array, seconds: float = TAP) -> Array:
    """Spectrum of sin^2(pi t / T) about its middle, (n_freq,) float64, s: T / 2 sinc(f T) / (1 - (f T)^2)."""
    cycles = grid * seconds
    return np.asarray(seconds / 2 * np.sinc(cycles) / np.where(np.abs(cycles - 1) < 1e-9, np.inf, 1 - cycles**2))
