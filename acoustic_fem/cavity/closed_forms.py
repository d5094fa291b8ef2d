"""Complex compliance of closed cavities with isothermal walls, from isothermal to adiabatic.

The pressure is uniform (cavity far below the wavelength); the temperature diffuses to the walls:
C = V (gamma - (gamma - 1) <Psi>) / (gamma p), with <Psi> the mean over the cavity of the solution of
Psi - (alpha / (j w)) Laplace(Psi) = 1, Psi = 0 on the wall. Limits: V / p at low frequency,
V / (gamma p) at high. Carslaw and Jaeger, Conduction of Heat in Solids (1959), chapters 3, 8, 9.
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from scipy.special import jn_zeros, jve, zeta

from acoustic_fem.quantities.checks import FrequencyLike, frequencies
from acoustic_fem.quantities.local_air import AirLike, medium_of
from acoustic_fem.quantities.medium import Medium
from geometry.ground.argument_checks import positive_numbers
from geometry.ground.typed import Array, ComplexArray

#: Results on longer grids are not kept.
_LONGEST_GRID = 1024


def closed_cylinder_compliance(radius: float, height: float, frequency: FrequencyLike, air: AirLike) -> ComplexArray:
    """Compliance of a closed cylinder, m^3/Pa.

    Args:
        radius: of the cylinder, m.
        height: of the cylinder, m.
        frequency: Hz, any shape.
        air: a :class:`acoustic_fem.LocalAir`, or a gas of its own.

    Returns:
        Shape of frequency, complex128; series with summed tail, relative error below 1e-8.

    Raises:
        Refusal: a radius, height or frequency that is not finite and positive.
    """
    medium = medium_of(air)
    positive_numbers("radius", radius, "m")
    positive_numbers("height", height, "m")
    rate = _rate(frequency, medium)
    if rate.size > _LONGEST_GRID:
        mean = _cylinder_mean(radius, height, rate)
    else:
        mean = _known_cylinder_mean(float(radius), float(height), rate.tobytes()).reshape(rate.shape)
    return _compliance(np.pi * radius**2 * height, mean, medium)


def closed_sphere_compliance(radius: float, frequency: FrequencyLike, air: AirLike) -> ComplexArray:
    """Compliance of a closed sphere, m^3/Pa.

    Args:
        radius: of the sphere, m.
        frequency: Hz, any shape.
        air: a :class:`acoustic_fem.LocalAir`, or a gas of its own.

    Returns:
        Shape of frequency, complex128.

    Raises:
        Refusal: a radius or frequency that is not finite and positive.
    """
    medium = medium_of(air)
    positive_numbers("radius", radius, "m")
    mean = _sphere_mean(radius, _rate(frequency, medium))
    return _compliance(4 / 3 * np.pi * radius**3, mean, medium)


def _rate(frequency: FrequencyLike, medium: Medium) -> ComplexArray:
    """Rate of heat diffusion j w / alpha, 1/m^2."""
    omega = 2 * np.pi * frequencies(frequency)
    return np.asarray(1j * omega / medium.thermal_diffusivity)


def _compliance(volume: float, mean: ComplexArray, medium: Medium) -> ComplexArray:
    return volume * (medium.gamma - (medium.gamma - 1) * mean) / (medium.gamma * medium.pressure)


def _sphere_mean(radius: float, rate: ComplexArray) -> ComplexArray:
    """<Psi> = 1 + 3 (z cot z - 1)/z^2 with z = R sqrt(-j w / alpha).

    Below |z| = 1 taken as -J_{5/2}(z) / J_{1/2}(z), which does not cancel and is slow.
    """
    argument = np.asarray(radius * np.sqrt(-rate), dtype=np.complex128)
    small = np.abs(argument) < 1
    z = np.where(small, 1 - 1j, argument)  # below the real axis, where exp(-2 j z) is small
    phasor = np.exp(-2j * z)
    mean = 1 + 3 * (1j * z * (1 + phasor) / (1 - phasor) - 1) / z**2
    if small.any():
        below = np.where(small, argument, 1)
        mean = np.where(small, -jve(2.5, below) / jve(0.5, below), mean)
    return np.asarray(mean, dtype=np.complex128)


def _cylinder_mean(radius: float, height: float, rate: ComplexArray) -> ComplexArray:
    """<Psi> = sum 4/l^2 s/q^2 (1 - tanh(q H/2)/(q H/2)), q^2 = (l/R)^2 + s, over the zeros l of J0.

    Explicit terms reach past both scales of the problem, l = 4 R |s|^(1/2) and q H/2 = 20; the rest is
    summed by Hurwitz zeta functions of l = b + 1/(8 b), b = pi (n - 1/4).
    """
    largest = float(np.sqrt(np.abs(rate).max(initial=0.0)))
    count = int(np.ceil(max(64.0, 4 * radius * largest / np.pi, 40 * radius / (np.pi * height))))
    scaled = np.asarray(rate[..., None] * radius**2, dtype=np.complex128)
    zeros = bessel_zeros(count)
    square = zeros**2 + scaled
    wave = np.asarray(np.sqrt(square) * (height / (2 * radius)), dtype=np.complex128)
    # Real parts of the wave are at least those of its zeros; above 20 the tangent is 1 in double precision.
    curved = int(np.searchsorted(zeros * (height / (2 * radius)), 20.0))
    field = 1 - 1 / wave
    field[..., :curved] = _one_minus_tanh_over(wave[..., :curved])
    sr2, aspect = scaled[..., 0], 2 * radius / height
    four, five, six, seven, eight, nine = _tails(count)
    rest = four - sr2 * six + sr2**2 * eight - aspect * (five - 1.5 * sr2 * seven + 1.875 * sr2**2 * nine)
    return np.asarray(4 * sr2 * ((field / square) @ zeros**-2.0 + rest), dtype=np.complex128)


@lru_cache(maxsize=64)
def _tails(count: int) -> tuple[float, ...]:
    """Sums of l^-4 to l^-9 over the zeros l of J0 beyond the first so many."""

    def tail(power: int) -> float:
        inner = float(zeta(power, count + 0.75)) / np.pi**power
        return inner - power / 8 * float(zeta(power + 2, count + 0.75)) / np.pi ** (power + 2)

    return tuple(tail(power) for power in range(4, 10))


@lru_cache(maxsize=32)  # an array has cells of one height and diameter that differ in their ports
def _known_cylinder_mean(radius: float, height: float, rate: bytes) -> ComplexArray:
    return _cylinder_mean(radius, height, np.frombuffer(rate, dtype=np.complex128))


def bessel_zeros(count: int) -> Array:
    """First zeros of J0, (count,) float64; beyond the 30th by McMahon's expansion, accurate to rounding there."""
    exact = _first_zeros()[:count]
    beta = np.pi * (np.arange(len(exact) + 1, count + 1) - 0.25)
    return np.concatenate([exact, beta + 1 / (8 * beta) - 31 / (384 * beta**3) + 3779 / (15360 * beta**5)])


@lru_cache(maxsize=1)
def _first_zeros() -> Array:
    """The first 30 zeros of J0, found once: the search takes longer than what is summed over them."""
    return np.asarray(jn_zeros(0, 30))


def _one_minus_tanh_over(x: ComplexArray) -> ComplexArray:
    """1 - tanh(x)/x without cancellation at small x."""
    square = x**2
    series = square * (1 / 3 - square * (2 / 15 - square * (17 / 315 - square * 62 / 2835)))
    return np.where(np.abs(x) < 0.1, series, 1 - np.tanh(x) / x)
