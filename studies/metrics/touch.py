"""What a touch of given force or displacement does at the microphones, for many designs at once."""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from geometry.refusal import Refusal
from studies.metrics.pairs import BAND, trapezoidal_weights
from studies.metrics.responses import Complex, Responses

Array = NDArray[np.float64]
_T = TypeVar("_T")

#: What these figures need beside the transfer functions.
NEEDS = frozenset({"designs", "source_response", "point_impedance"})
NOISE_NEEDS = NEEDS | {"microphone_impedance", "medium"}


@lru_cache(maxsize=1)
def force_response(responses: Responses) -> Complex:
    """Pressure at the microphones per force, as :meth:`acoustic_fem.Library.touch_response` for each design.

    Returns:
        (n_design, n_point, n_microphone, n_freq) complex128, Pa/N.
    """
    volume, _ = _disc_responses(responses)
    omega = 2 * np.pi * responses.frequency
    return np.asarray(_known(responses.source_response) * (1j * omega * volume)[:, None, None])


def displacement_response(responses: Responses) -> Complex:
    """Pressure at the microphones per displacement of the touched patch; (n_design, n_point, n_microphone, n_freq)
    complex128, Pa/m.
    """
    volume, compliance = _disc_responses(responses)
    omega = 2 * np.pi * responses.frequency
    moved = compliance[:, None] - (1j * omega * volume**2)[:, None] * _known(responses.point_impedance)
    return np.asarray(_known(responses.source_response) * ((1j * omega * volume)[:, None] / moved)[:, :, None])


def smallest_sensitivity(responses: Responses, of: Callable[[Responses], Complex]) -> Array:
    """Rms over the band of a response at the loudest microphone, of the point where that is least.

    Args:
        responses: of the designs.
        of: the response, from them: (n_design, n_point, n_microphone, n_freq) complex128, in any unit.

    Returns:
        (n_design,) float64, in the unit of the response.
    """
    inside, weight = _band(responses)
    power = np.abs(of(responses)[..., inside]) ** 2 @ weight
    return np.asarray(np.sqrt(power.max(axis=2).min(axis=1)))


def noise_equivalent_force(responses: Responses) -> Array:
    """Rms force of flat spectrum over the band with a ratio of signal to noise of 1, at the worst point; (n_design,)
    float64, N.

    As :func:`acoustic_fem.library.noise.detection_limits`: all microphones in their best linear combination, thermal
    noise and the microphones' own.
    """
    from acoustic_fem.library.noise import gas_temperature, thermal_covariance
    from acoustic_fem.network.microphone import noise_density

    inside, _ = _band(responses)
    frequency = responses.frequency[inside]
    designs, media = _known(responses.designs), _known(responses.medium)
    mutual = _known(responses.microphone_impedance)
    temperature = np.array([gas_temperature(medium) for medium in media])
    noise = thermal_covariance(np.moveaxis(mutual[..., inside], -1, 1), 1.0) * temperature[:, None, None, None]
    microphones = np.arange(noise.shape[-1])
    noise[:, :, microphones, microphones] += np.stack(
        [noise_density(design.microphone, frequency) ** 2 for design in designs]
    )[:, :, None]
    signal = np.moveaxis(force_response(responses)[..., inside], (3, 2), (1, 2))  # (design, freq, microphone, point)
    scale = np.sqrt(np.einsum("dfmm->dfm", noise).real)
    signal = signal / scale[..., None]
    whitened = np.linalg.solve(noise / (scale[..., :, None] * scale[..., None, :]), signal)
    density = np.einsum("dfmp,dfmp->dpf", signal.conj(), whitened).real
    width = frequency[-1] - frequency[0]
    # x^2 / width times the integral of the density is 1
    return np.asarray((width / np.trapezoid(density, frequency, axis=-1)).max(axis=1) ** 0.5 * np.sqrt(width))


def bandwidth(responses: Responses) -> Array:
    """Width of the range in which a point's response to force is within 3 dB of its maximum; (n_design,) float64, Hz.

    At the point's loudest microphone; the narrowest of all points. Between the frequencies of the grid levels are
    joined by straight lines; where the response does not fall by 3 dB, the range ends with the grid.
    """
    level = 20 * np.log10(np.abs(force_response(responses)))
    loudest = level.max(axis=-1).argmax(axis=2)
    level = np.take_along_axis(level, loudest[:, :, None, None], axis=2)[:, :, 0]
    margin = level - level.max(axis=-1, keepdims=True) + 20 * np.log10(np.sqrt(2))
    grid, last = responses.frequency, len(responses.frequency) - 1
    peak = level.argmax(axis=-1)
    place = np.arange(last + 1)
    below = margin < 0
    left = np.where(below & (place < peak[..., None]), place, -1).max(axis=-1)
    right = np.where(below & (place > peak[..., None]), place, last + 1).min(axis=-1)

    def crossing(outside: NDArray[np.int64], inside: NDArray[np.int64]) -> Array:
        low, high = (
            np.take_along_axis(margin, np.clip(at, 0, last)[..., None], -1)[..., 0] for at in (outside, inside)
        )
        f_out, f_in = grid[np.clip(outside, 0, last)], grid[inside]
        share = np.where(high > low, high / np.where(high > low, high - low, 1.0), 0.0)
        found = (outside >= 0) & (outside <= last)
        return np.where(found, f_in + share * (f_out - f_in), f_in)

    return np.asarray((crossing(right, right - 1) - crossing(left, left + 1)).min(axis=1))


def _disc_responses(responses: Responses) -> tuple[Complex, Complex]:
    """Volume per force, m^3/N, and displacement per force, m/N, in vacuo: (n_design, n_freq) each."""
    from acoustic_fem.membrane.disc import design_disc

    known: dict[tuple[object, ...], tuple[Complex, Complex]] = {}
    rows = []
    for design in _known(responses.designs):
        material = design.material(design.membrane.material)
        key = (design.resonator.cavity_diameter, design.membrane, material)
        if key not in known:
            vacuum = design_disc(design, known=responses.known).response(responses.frequency, material.loss_factor)
            known[key] = vacuum.volume_per_force, vacuum.displacement_per_force
        rows.append(known[key])
    return np.stack([row[0] for row in rows]), np.stack([row[1] for row in rows])


def _band(responses: Responses) -> tuple[NDArray[np.bool_], Array]:
    """The frequencies of the band, and the weights of a mean over it."""
    grid = responses.frequency
    inside = (grid >= BAND[0] - 1e-9) & (grid <= BAND[1] + 1e-9)
    if inside.sum() < 2:
        raise Refusal(f"{inside.sum()} frequencies between {BAND[0]:g} and {BAND[1]:g} Hz; at least 2 are needed")
    return inside, trapezoidal_weights(grid[inside])


def _known(values: _T | None) -> _T:
    """What :attr:`studies.study.metric_registry.Metric.needs` has made sure of."""
    assert values is not None
    return values
