"""Plane waves in a round duct with viscous, isothermal walls: exact for a uniform section.

J(z) = 2 J1(z) / (z J0(z)) is the mean of the field J0(z r/a)/J0(z) over the section; with
1 - J = -J2/J0 nothing cancels at small z, and scaled Bessel functions do not overflow at large z.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.special import jve

from acoustic_fem.checks import positive
from acoustic_fem.medium import Medium


def series_impedance(radius: ArrayLike, frequency: ArrayLike, medium: Medium) -> NDArray[np.complex128]:
    """Z' = j w rho / (S (1 - J(kv a))), kv = sqrt(-j w rho / mu), in Pa s/m^4.

    Zwikker and Kosten (1949); Tijdeman, J. Sound Vib. 39 (1975) 1; Stinson, J. Acoust. Soc. Am. 89
    (1991) 550. Exact for wavelengths far above the radius; below, Z' -> 8 mu / (pi a^4).

    Args:
        radius: of the bore, m; broadcasts with frequency.
        frequency: Hz.
        medium: the gas.

    Returns:
        Broadcast shape, complex128.

    Raises:
        ValueError: a radius or frequency that is not finite and positive.
    """
    radius, omega = positive("radius", radius, "m"), 2 * np.pi * positive("frequency", frequency, "Hz")
    section = np.pi * radius**2
    return 1j * omega * medium.density / (section * _one_minus_mean(radius, omega, medium.kinematic_viscosity))


def shunt_admittance(radius: ArrayLike, frequency: ArrayLike, medium: Medium) -> NDArray[np.complex128]:
    """Y' = j w S / (rho c^2) (1 + (gamma - 1) J(kt a)), kt = sqrt(-j w rho cp / kappa), in m^2/(Pa s).

    Sources, arguments and errors as :func:`series_impedance`. Low frequency: j w S / p (isothermal).
    """
    radius, omega = positive("radius", radius, "m"), 2 * np.pi * positive("frequency", frequency, "Hz")
    psi = _one_minus_mean(radius, omega, medium.thermal_diffusivity)
    gamma = medium.gamma
    return 1j * omega * np.pi * radius**2 / (gamma * medium.pressure) * (gamma - (gamma - 1) * psi)


def port_admittance(
    radius: ArrayLike, length: ArrayLike, frequency: ArrayLike, medium: Medium
) -> NDArray[np.complex128]:
    """Volume velocities into a duct per pressure at its two ends, in m^3/(Pa s).

    Y11 = Y22 = coth(G L) / Zc, Y12 = Y21 = -1 / (Zc sinh(G L)), G = sqrt(Z' Y'), Zc = sqrt(Z' / Y').
    Safe for very short and very long ducts. Sources as :func:`series_impedance`.

    Args:
        radius: of the bore, m.
        length: m.
        frequency: Hz; radius, length and frequency broadcast.
        medium: the gas.

    Returns:
        Broadcast shape + (2, 2), complex128: (n_freq, 2, 2) for one duct at n_freq frequencies.

    Raises:
        ValueError: a radius, length or frequency that is not finite and positive.
    """
    length = positive("length", length, "m")
    impedance = series_impedance(radius, frequency, medium)
    admittance = shunt_admittance(radius, frequency, medium)
    # principal roots: both arguments are in (0, 90] degrees, so G and Yc lie in the right half plane
    exponent = np.sqrt(impedance * admittance) * length
    characteristic = np.sqrt(admittance / impedance)
    # 1/sinh and coth by decaying exponentials; expm1 keeps short ducts exact
    shrink = -np.expm1(-2 * exponent)
    own = characteristic * (2 - shrink) / shrink
    transfer = -2 * characteristic * np.exp(-exponent) / shrink
    return np.stack([np.stack([own, transfer], -1), np.stack([transfer, own], -1)], -2)


def _one_minus_mean(
    radius: NDArray[np.float64], omega: NDArray[np.float64], diffusivity: float
) -> NDArray[np.complex128]:
    """1 - J(k a) for k = sqrt(-j w / diffusivity)."""
    argument = radius * np.sqrt(-1j * omega / diffusivity)
    result: NDArray[np.complex128] = -jve(2, argument) / jve(0, argument)
    return result
