r"""Plane waves in ducts: the exact round bore, and lines with any series impedance and shunt admittance.

A duct is a line, dp/dx = -Z' q and dq/dx = -Y' p. For a uniform section both follow from the mean of a
diffusion field, :math:`\nabla^2 \Psi = s(\Psi - 1)`, zero on the wall, with s = j w / nu for the velocity
and j w / alpha for the heat:

    Z' = j w rho / (S <Psi_v>),   Y' = j w S / (gamma p) (gamma - (gamma - 1) <Psi_h>).

For a round bore <Psi> = 1 - J(k a), J(z) = 2 J1(z) / (z J0(z)), k^2 = -s. Zwikker and Kosten, Sound Absorbing
Materials (1949); Tijdeman, J. Sound Vib. 39 (1975) 1; Stinson, J. Acoust. Soc. Am. 89 (1991) 550. Valid for
wavelengths far above the bore. Sections of other shapes: :mod:`acoustic_fem.duct.sections`.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from typing import Literal

import numpy as np
from numpy.polynomial.polynomial import polyval
from numpy.typing import ArrayLike
from scipy.special import jve, zeta

from acoustic_fem.quantities.checks import FrequencyLike, frequencies
from acoustic_fem.quantities.local_air import AirLike, medium_of
from acoustic_fem.quantities.medium import Medium
from geometry.ground.argument_checks import check_range, mismatch, out_of_range, positive_numbers
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array, ComplexArray

#: A complex quantity over frequency: values that broadcast with the frequencies, or a function of Hz.
Spectrum = ArrayLike | Callable[[Array], ArrayLike]
#: Ducts on longer grids are computed anew each time, so that what is kept stays below 10 MB.
_LONGEST_GRID = 1024


def series_impedance(radius: ArrayLike, frequency: FrequencyLike, air: AirLike) -> ComplexArray:
    """Series impedance per length of a round bore, Pa s/m^4.

    Z' = j w rho / (S (1 - J(kv a))), kv = sqrt(-j w rho / mu).

    Exact for wavelengths far above the radius; at low frequency Z' -> 8 mu / (pi a^4). Relative error below
    1e-14, in real and imaginary part each below 1e-13 (0.01 Hz to 20 kHz, 0.05 to 5 mm).

    Args:
        radius: of the bore, m; broadcasts with frequency.
        frequency: Hz, any shape.
        air: a :class:`acoustic_fem.LocalAir`, or a gas of its own.

    Returns:
        Broadcast shape, complex128.

    Raises:
        Refusal: a radius or frequency that is not finite and positive.
    """
    medium = medium_of(air)
    radius = positive_numbers("radius", radius, "m")
    mean = round_mean(2, radius, diffusion_rate(frequency, medium.kinematic_viscosity))
    return series_from_mean(np.pi * radius**2, mean, frequency, medium)


def shunt_admittance(radius: ArrayLike, frequency: FrequencyLike, air: AirLike) -> ComplexArray:
    """Shunt admittance per length of a round bore, m^2/(Pa s).

    Y' = j w S / (rho c^2) (1 + (gamma - 1) J(kt a)), kt = sqrt(-j w rho cp / kappa). Low frequency: j w S / p
    (isothermal). Sources, arguments and errors as :func:`series_impedance`.

    Returns:
        Broadcast shape of radius and frequency, complex128.
    """
    medium = medium_of(air)
    radius = positive_numbers("radius", radius, "m")
    mean = round_mean(2, radius, diffusion_rate(frequency, medium.thermal_diffusivity))
    return shunt_from_mean(np.pi * radius**2, mean, frequency, medium)


def port_admittance(radius: ArrayLike, length: ArrayLike, frequency: FrequencyLike, air: AirLike) -> ComplexArray:
    """Volume velocities into a round duct per pressure at its two ends, in m^3/(Pa s).

    Args:
        radius: of the bore, m, scalar or (n_freq,).
        length: of the duct, m, scalar or (n_freq,).
        frequency: (n_freq,) Hz; all three broadcast.
        air: a :class:`acoustic_fem.LocalAir`, or a gas of its own.

    Returns:
        As :func:`two_port`: (n_freq, 2, 2) complex128 for one duct at n_freq frequencies.

    Raises:
        Refusal: a radius, length or frequency that is not finite and positive.
    """
    medium = medium_of(air)
    length, radius = positive_numbers("length", length, "m"), positive_numbers("radius", radius, "m")
    frequency = frequencies(frequency)
    if radius.ndim == length.ndim == 0 and frequency.ndim == 1 and frequency.size <= _LONGEST_GRID:
        return _duct(float(radius), float(length), frequency.tobytes(), medium).copy()
    return two_port(series_impedance(radius, frequency, medium), shunt_admittance(radius, frequency, medium), length)


@lru_cache(maxsize=64)
def _duct(radius: float, length: float, grid: bytes, medium: Medium) -> ComplexArray:
    """As :func:`port_admittance`, kept: an array has many tubes and cells, and few bores that differ."""
    return two_port(*_line(radius, grid, medium), length)


@lru_cache(maxsize=32)
def _line(radius: float, grid: bytes, medium: Medium) -> tuple[ComplexArray, ComplexArray]:
    """Series impedance and shunt admittance per length of a round bore, kept."""
    frequency = np.frombuffer(grid)
    return series_impedance(radius, frequency, medium), shunt_admittance(radius, frequency, medium)


def two_port(series: ArrayLike, shunt: ArrayLike, length: ArrayLike) -> ComplexArray:
    """Volume velocities into a uniform line per pressure at its two ends, in m^3/(Pa s).

    Y11 = Y22 = x coth(x) / (Z' L), Y12 = Y21 = -x / sinh(x) / (Z' L), x^2 = Z' Y' L^2: even in x, so that
    no branch has to be chosen. Short lines by power series, others by decaying exponentials: the relative
    error of every entry is below 1e-15 (2 + |x|), the share of |x| being what rounding Z', Y' or L to double
    precision costs: 1e-12 up to |x| = 1000. A transfer below 1e-308 is returned as 0.

    Args:
        series: Z', Pa s/m^4, not zero; scalar or (n_freq,).
        shunt: Y', m^2/(Pa s), scalar or (n_freq,).
        length: of the line, m, scalar or (n_freq,); all three broadcast.

    Returns:
        Broadcast shape + (2, 2), complex128.

    Raises:
        Refusal: a length that is not finite and positive, a value that is not finite, Z' = 0.
    """
    length = positive_numbers("length", length, "m")
    total, square = _line_values(series, shunt, length)
    own, transfer = _x_coth_x(square) / total, -_x_over_sinh_x(square) / total
    return np.stack([np.stack([own, transfer], -1), np.stack([transfer, own], -1)], -2)


class Line(ABC):
    """Anything that carries plane waves with a series impedance and a shunt admittance per length.

    A subclass gives these two; the rest follows. Frequencies are in Hz, any shape; results broadcast.
    """

    @abstractmethod
    def series_impedance(self, frequency: FrequencyLike, air: AirLike) -> ComplexArray:
        """Series impedance Z' per length, Pa s/m^4: shape of frequency (Hz), complex128."""

    @abstractmethod
    def shunt_admittance(self, frequency: FrequencyLike, air: AirLike) -> ComplexArray:
        """Shunt admittance Y' per length, m^2/(Pa s): shape of frequency (Hz), complex128."""

    def propagation(self, frequency: FrequencyLike, air: AirLike) -> ComplexArray:
        """Propagation constant Gamma = sqrt(Z' Y'), 1/m: shape of frequency (Hz), complex128, real part >= 0."""
        medium = medium_of(air)
        return np.sqrt(self.series_impedance(frequency, medium) * self.shunt_admittance(frequency, medium))

    def characteristic_impedance(self, frequency: FrequencyLike, air: AirLike) -> ComplexArray:
        """Characteristic impedance sqrt(Z' / Y'), Pa s/m^3: shape of frequency (Hz), complex128, real part >= 0."""
        medium = medium_of(air)
        return np.sqrt(self.series_impedance(frequency, medium) / self.shunt_admittance(frequency, medium))

    def port_admittance(self, length: ArrayLike, frequency: FrequencyLike, air: AirLike) -> ComplexArray:
        """Two-port of a piece of a length (m) by :func:`two_port`: broadcast shape + (2, 2), m^3/(Pa s)."""
        medium = medium_of(air)
        return two_port(self.series_impedance(frequency, medium), self.shunt_admittance(frequency, medium), length)


@dataclass(frozen=True, eq=False)
class UserLine(Line):
    """A line known by its propagation constant and characteristic impedance, whatever the gas."""

    gamma: Spectrum
    """Propagation constant, 1/m, real part not negative; values that broadcast with the frequencies asked for, or a
    function of the frequency in Hz.
    """
    zc: Spectrum
    """Characteristic impedance, Pa s/m^3, real part not negative; values or a function as of ``gamma``."""

    def series_impedance(self, frequency: FrequencyLike, air: AirLike) -> ComplexArray:
        """Series impedance per length Z' = Gamma Zc, Pa s/m^4: shape of frequency (Hz), complex128.

        Raises:
            Refusal: gamma or zc is not finite, has a negative real part or does not fit the frequencies.
        """
        return self._at("gamma", frequency) * self._at("zc", frequency)

    def shunt_admittance(self, frequency: FrequencyLike, air: AirLike) -> ComplexArray:
        """Shunt admittance per length Y' = Gamma / Zc, m^2/(Pa s): shape of frequency (Hz), complex128.

        Errors as :meth:`series_impedance`.
        """
        return self._at("gamma", frequency) / self._at("zc", frequency)

    def _at(self, name: str, frequency: FrequencyLike) -> ComplexArray:
        frequency = frequencies(frequency)
        given = getattr(self, name)
        values = np.asarray(given(frequency) if callable(given) else given, dtype=np.complex128)
        try:
            values = np.broadcast_to(values, frequency.shape)
        except ValueError:
            raise mismatch(name, f"has shape {values.shape}, the frequencies have {frequency.shape}") from None
        bad = ~np.isfinite(values) | (values.real < 0) | (values == 0)
        if bad.any():
            raise out_of_range(name, complex(values[bad][0]), "finite, not 0, and its real part not negative")
        return values


@dataclass(frozen=True)
class CompliantWall(Line):
    """A line whose wall gives way to the pressure: Y' + j w C'.

    The inertia of the wall is left out, so it holds far below the first ring resonance of the wall.
    """

    line: Line
    """The same line with a rigid wall."""
    compliance: complex | ComplexArray
    """Compliance C' = dS/dp, m^2/Pa, imaginary part (losses) not positive, one or (n_freq,) complex128; see
    :func:`tube_compliance`."""

    def __post_init__(self) -> None:
        values = np.asarray(self.compliance, dtype=np.complex128)
        bad = ~(np.isfinite(values) & (values.real >= 0) & (values.imag <= 0))
        if bad.any():
            raise out_of_range(
                "compliance", complex(values[bad][0]), "finite, with real part >= 0 and imaginary <= 0, m^2/Pa"
            )

    def series_impedance(self, frequency: FrequencyLike, air: AirLike) -> ComplexArray:
        """Series impedance Z' of the line per length, Pa s/m^4: shape of frequency (Hz), complex128."""
        medium = medium_of(air)
        return self.line.series_impedance(frequency, medium)

    def shunt_admittance(self, frequency: FrequencyLike, air: AirLike) -> ComplexArray:
        """Shunt admittance per length Y' + j w C', m^2/(Pa s): shape of frequency (Hz), complex128."""
        medium = medium_of(air)
        omega = 2 * np.pi * frequencies(frequency)
        return self.line.shunt_admittance(frequency, medium) + 1j * omega * self.compliance


def tube_compliance(
    inner_radius: float,
    outer_radius: float,
    youngs_modulus: float,
    poisson_ratio: float = 0.49,
    loss_factor: float = 0.0,
    axial: Literal["held", "free"] = "held",
) -> complex:
    """Change of the inner section of an elastic tube per inner pressure, dS/dp, in m^2/Pa.

    2 pi a u(a)/p with the displacement of Lame's thick tube (Timoshenko and Goodier, Theory of Elasticity,
    3rd ed. (1970), art. 28): ``held`` in the axial direction (plane strain, a long or bonded sheath)
    u/p = (1 + nu) a ((1 - 2 nu) a^2 + b^2) / (E (b^2 - a^2)); ``free`` to shorten (plane stress)
    u/p = a/E ((b^2 + a^2) / (b^2 - a^2) + nu). A thin free wall of thickness h tends to 2 pi a^3 / (E h).
    Small strains; no inertia.

    Args:
        inner_radius: a, m.
        outer_radius: b > a, m.
        youngs_modulus: E, Pa.
        poisson_ratio: a ratio, 0 to 0.5.
        loss_factor: eta of E (1 + j eta), a ratio, 0 to 2.
        axial: ``"held"`` or ``"free"``.

    Raises:
        Refusal: a value outside its range, by name.
    """
    a = float(positive_numbers("inner_radius", inner_radius, "m"))
    b = float(positive_numbers("outer_radius", outer_radius, "m"))
    modulus = float(positive_numbers("youngs_modulus", youngs_modulus, "Pa"))
    nu, eta = check_range("poisson_ratio", poisson_ratio, 0.0, 0.5), check_range("loss_factor", loss_factor, 0.0, 2.0)
    if b <= a:
        raise out_of_range("outer_radius", b, f"above inner_radius = {a:g} m", "m")
    wall = (b - a) * (b + a)
    if axial == "held":
        displacement = (1 + nu) * a * ((1 - 2 * nu) * a**2 + b**2) / wall
    elif axial == "free":
        displacement = a * ((b**2 + a**2) / wall + nu)
    else:
        raise Refusal(kind=Kind.OUT_OF_RANGE, field="axial", value=axial, allowed=("held", "free"))
    return 2 * np.pi * a * displacement / (modulus * (1 + 1j * eta))


def diffusion_rate(frequency: FrequencyLike, diffusivity: float) -> ComplexArray:
    """Rate of diffusion s = j w / diffusivity, 1/m^2: shape of frequency (Hz), complex128."""
    return np.asarray(2j * np.pi * frequencies(frequency) / diffusivity, dtype=np.complex128)


def series_from_mean(area: ArrayLike, mean: ComplexArray, frequency: FrequencyLike, air: AirLike) -> ComplexArray:
    """Series impedance per length of a section, Z' = j w rho / (S <Psi_v>).

    Args:
        area: S, m^2.
        mean: <Psi_v>, shape of frequency, complex128.
        frequency: Hz; area, mean and frequency broadcast.
        air: a :class:`acoustic_fem.LocalAir`, or a gas of its own.

    Returns:
        Broadcast shape, complex128, Pa s/m^4.
    """
    medium = medium_of(air)
    return np.asarray(2j * np.pi * frequencies(frequency) * medium.density / (np.asarray(area) * mean))


def shunt_from_mean(area: ArrayLike, mean: ComplexArray, frequency: FrequencyLike, air: AirLike) -> ComplexArray:
    """Shunt admittance per length of a section, Y' = j w S / (gamma p) (gamma - (gamma - 1) <Psi_h>).

    Args:
        area: S, m^2.
        mean: <Psi_h>, shape of frequency, complex128.
        frequency: Hz; area, mean and frequency broadcast.
        air: a :class:`acoustic_fem.LocalAir`, or a gas of its own.

    Returns:
        Broadcast shape, complex128, m^2/(Pa s).
    """
    medium = medium_of(air)
    gamma = medium.gamma
    adiabatic = 2j * np.pi * frequencies(frequency) * np.asarray(area) / (gamma * medium.pressure)
    return np.asarray(adiabatic * (gamma - (gamma - 1) * mean))


def round_mean(dimension: int, radius: ArrayLike, rate: ComplexArray) -> ComplexArray:
    """Mean <Psi> of a slab, circle or sphere (dimension 1, 2, 3) of that half thickness or radius (m).

    With x^2 = R^2 s the means 1 - tanh(x)/x, 1 - 2 I1/(x I0), 1 - 3 (x coth x - 1)/x^2 are all
    I_{d/2+1}(x) / I_{d/2-1}(x): scaled Bessel functions for |x| > 1, below it the power series in x^2,
    which keep real and imaginary part each to rounding.

    Args:
        dimension: 1, 2 or 3.
        radius: R, m.
        rate: s, 1/m^2, complex128; broadcasts with the radius.

    Returns:
        Broadcast shape, complex128.
    """
    scaled = np.asarray(np.asarray(radius) ** 2 * rate, dtype=np.complex128)
    order = dimension / 2 - 1

    def series(square: ComplexArray) -> ComplexArray:
        quarter = square / 4
        first = quarter / ((order + 1) * (order + 2)) * _hypergeometric(order + 3, quarter)
        return first / _hypergeometric(order + 1, quarter)

    def bessel(square: ComplexArray) -> ComplexArray:
        argument = np.sqrt(-square)
        return np.asarray(-jve(order + 2, argument) / jve(order, argument))

    return _by_size(scaled, 1.0, series, bessel)


def _by_size(
    square: ComplexArray,
    limit: float,
    below: Callable[[ComplexArray], ComplexArray],
    above: Callable[[ComplexArray], ComplexArray],
) -> ComplexArray:
    """One function where the modulus is below a limit, another elsewhere, each only where it is wanted."""
    small = np.abs(square) < limit
    if small.all():
        return below(square)
    if not small.any():
        return above(square)
    values = np.empty_like(square)
    values[small], values[~small] = below(square[small]), above(square[~small])
    return values


def _hypergeometric(parameter: float, y: ComplexArray) -> ComplexArray:
    """0F1(; parameter; y) for |y| <= 1/4."""
    total = np.ones_like(y)
    for k in range(12, 0, -1):
        total = 1 + y / (k * (parameter + k - 1)) * total
    return total


def _line_values(series: ArrayLike, shunt: ArrayLike, length: Array) -> tuple[ComplexArray, ComplexArray]:
    """Z' L and (Gamma L)^2."""
    z, y = np.asarray(series, dtype=np.complex128), np.asarray(shunt, dtype=np.complex128)
    for name, values, bad in (("series", z, ~np.isfinite(z) | (z == 0)), ("shunt", y, ~np.isfinite(y))):
        if bad.any():
            raise out_of_range(name, complex(values[bad].flat[0]), "finite and not 0" if name == "series" else "finite")
    total, square = np.broadcast_arrays(z * length, (z * length) * (y * length))
    return total, square


#: Below this |x|^2 the power series is used; its terms fall by 1/40 each.
_SHORT = 0.25
_ORDERS = np.arange(1, 13)
_COTH = np.concatenate([[1.0], -2 * zeta(2.0 * _ORDERS) * (-1 / np.pi**2) ** _ORDERS])
_CSCH = np.concatenate([[1.0], 2 * zeta(2.0 * _ORDERS) * (1 - 2.0 ** (1 - 2 * _ORDERS)) * (-1 / np.pi**2) ** _ORDERS])


def _polynomial(coefficients: Array) -> Callable[[ComplexArray], ComplexArray]:
    return lambda square: np.asarray(polyval(square, coefficients), dtype=np.complex128)


def _x_coth_x(square: ComplexArray) -> ComplexArray:
    """The function x coth(x) of x^2: 1 + x^2/3 - ..."""

    def long(square: ComplexArray) -> ComplexArray:
        x = np.sqrt(square)
        shrink = -np.expm1(-2 * x)
        return np.asarray(x * (2 - shrink) / shrink)

    return _by_size(square, _SHORT, _polynomial(_COTH), long)


def _x_over_sinh_x(square: ComplexArray) -> ComplexArray:
    """The function x / sinh(x) of x^2: 1 - x^2/6 + ..."""

    def long(square: ComplexArray) -> ComplexArray:
        x = np.sqrt(square)
        return np.asarray(2 * x * np.exp(-x) / -np.expm1(-2 * x))

    return _by_size(square, _SHORT, _polynomial(_CSCH), long)
