"""Pressures at the microphones for a touch of given force or displacement, for many designs at once."""

from __future__ import annotations

from collections.abc import Hashable
from dataclasses import fields
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

import acoustic_fem
from geometry.design.array_design import ArrayDesign
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array, ComplexArray
from localize.signals.stimulus import BAND
from studies.metrics.batch_responses import Responses, required
from studies.metrics.pairs import trapezoidal_weights

if TYPE_CHECKING:
    from acoustic_fem.membrane.disc import DiscResponse


#: What these figures need beside the transfer functions.
NEEDS = frozenset({"designs", "source_response", "point_impedance"})
NOISE_NEEDS = NEEDS | {"microphone_impedance", "medium"}


def touch_response(responses: Responses, touch: str, vacuum: DiscResponse | None = None) -> ComplexArray:
    """Pressure at the microphones per touch, as :meth:`acoustic_fem.Library.touch_response` for each design.

    Args:
        responses: of the designs.
        touch: "displacement" (m), "force" (N) or "pressure" (Pa).
        vacuum: what the membranes do in vacuo, as :func:`in_vacuo`, where it is known already.

    Returns:
        (n_design, n_point, n_microphone, n_freq) complex128, Pa per unit of the touch.
    """
    from acoustic_fem.library.touch_pressure import injected_flow

    vacuum = vacuum or in_vacuo(responses)
    injected = injected_flow(touch, responses.frequency, vacuum, required(responses.point_impedance))
    return np.asarray(required(responses.source_response) * injected[:, :, None])


def smallest_sensitivity(responses: Responses, response: ComplexArray) -> Array:
    """Rms over the band of a response at the loudest microphone, of the point where that is least.

    Args:
        responses: of the designs.
        response: (n_design, n_point, n_microphone, n_freq) complex128, in any unit.

    Returns:
        (n_design,) float64, in the unit of the response.
    """
    inside, weight = _band(responses)
    power = _squared(response[..., inside]) @ weight
    return np.asarray(np.sqrt(power.max(axis=2).min(axis=1)))


def noise_equivalent_force(responses: Responses, response: ComplexArray) -> Array:
    """Rms force of flat spectrum over the band with a ratio of signal to noise of 1, at the worst point; (n_design,)
    float64, N.

    As :func:`acoustic_fem.library.noise_floor.detection_limits`: all microphones in their best linear combination,
    thermal noise and the microphones' own.

    Args:
        responses: of the designs.
        response: (n_design, n_point, n_microphone, n_freq) complex128, Pa/N, that of :func:`touch_response`.
    """
    from acoustic_fem.library.noise_floor import combined_snr, gas_temperature, port_noise

    inside, _ = _band(responses)
    frequency = responses.frequency[inside]
    mutual = np.moveaxis(required(responses.microphone_impedance)[..., inside], -1, 1)
    temperature = np.array([gas_temperature(medium) for medium in required(responses.medium)])
    own = np.stack(
        [acoustic_fem.network.noise_density(design.microphone, frequency) for design in required(responses.designs)]
    )
    signal = np.moveaxis(response[..., inside], (3, 2), (1, 2))  # (design, freq, microphone, point)
    density = combined_snr(signal, port_noise(mutual, temperature[:, None], own))
    width = frequency[-1] - frequency[0]
    # x^2 / width times the integral of the density is 1
    return np.asarray((width / np.trapezoid(density, frequency, axis=-1)).max(axis=1) ** 0.5 * np.sqrt(width))


def bandwidth(responses: Responses, response: ComplexArray) -> Array:
    """Width of the range in which a point's response to force is within 3 dB of its maximum; (n_design,) float64, Hz.

    At the point's loudest microphone; the narrowest of all points. Between the frequencies of the grid levels are
    joined by straight lines; where the response does not fall by 3 dB, the range ends with the grid.

    Args:
        responses: of the designs.
        response: (n_design, n_point, n_microphone, n_freq) complex128, Pa/N, that of :func:`touch_response`.
    """
    level = 10 * np.log10(_squared(response))
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


def in_vacuo(responses: Responses) -> DiscResponse:
    """Motion of the membranes of each design in vacuo, arrays (n_design, n_point, n_freq) complex128."""
    from acoustic_fem.library.touch_pressure import membranes_in_vacuo
    from acoustic_fem.membrane.design_discs import design_disc, design_rubber
    from acoustic_fem.membrane.disc import DiscResponse

    def key_of(design: ArrayDesign) -> Hashable:
        return design.resonator.cavity_diameter, design.membrane, design.material(design.membrane.material)

    found: dict[Hashable, DiscResponse] = {}

    def response_of(design: ArrayDesign) -> DiscResponse:
        key = key_of(design)
        if key not in found:
            disc = design_disc(design, known=responses.discs)
            found[key] = disc.response(responses.frequency, design_rubber(design))
        return found[key]

    rows: dict[Hashable, DiscResponse] = {}
    designs = required(responses.designs)
    keys = [(tuple(key_of(each.of_kind(kind)) for kind in each.kinds), each.kind_of_point) for each in designs]
    for key, design in zip(keys, designs, strict=True):
        if key not in rows:
            rows[key] = membranes_in_vacuo(design, response_of)
    return DiscResponse(**{each.name: np.stack([getattr(rows[key], each.name) for key in keys])
                           for each in fields(DiscResponse)})  # fmt: skip


def _squared(values: ComplexArray) -> Array:
    """|z|^2, of the shape of the values; the root of it is slow."""
    return np.asarray(values.real**2 + values.imag**2)


def _band(responses: Responses) -> tuple[NDArray[np.bool_], Array]:
    """The frequencies of the band, and the weights of a mean over it."""
    grid = responses.frequency
    inside = (grid >= BAND[0] - 1e-9) & (grid <= BAND[1] + 1e-9)
    if inside.sum() < 2:
        problem = f"has {inside.sum()} values between {BAND[0]:g} and {BAND[1]:g} Hz; at least 2 are needed"
        raise Refusal(problem, kind=Kind.UNSUITABLE, field="frequency")
    return inside, trapezoidal_weights(grid[inside])
