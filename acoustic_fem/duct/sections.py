r"""Uniform sections: round, slit, rectangle and equilateral triangle in closed form, any other by finite elements.

Every section gives its area and the mean of the diffusion field :math:`\nabla^2 \Psi = s(\Psi - 1)`, zero on
its wall; series impedance and shunt admittance follow as in :mod:`acoustic_fem.duct`. The mean is
:math:`\langle\Psi\rangle = s\,f^T(K + sM)^{-1}f / S` with f = M 1, which Galerkin's method gives to twice the
order of the field.
"""

from __future__ import annotations

from abc import abstractmethod
from dataclasses import dataclass

import numpy as np
from scipy.special import zeta

from acoustic_fem.duct.plane_wave import Line, diffusion_rate, round_mean, series_from_mean, shunt_from_mean
from acoustic_fem.quantities.checks import FrequencyLike
from acoustic_fem.quantities.local_air import AirLike, medium_of
from geometry.ground.argument_checks import positive_numbers
from geometry.ground.typed import ComplexArray


class Section(Line):
    """A rigid, no-slip, isothermal uniform duct of any section: a line whose Z' and Y' follow from its shape."""

    @property
    @abstractmethod
    def area(self) -> float:
        """Area of the section, m^2."""

    @abstractmethod
    def mean_field(self, rate: ComplexArray) -> ComplexArray:
        """Mean <Psi> of the field at the rate s = j w / diffusivity (1/m^2): shape of the rate, complex128."""

    def series_impedance(self, frequency: FrequencyLike, air: AirLike) -> ComplexArray:
        """Series impedance per length Z' = j w rho / (S <Psi_v>), Pa s/m^4: shape of frequency (Hz), complex128."""
        medium = medium_of(air)
        mean = self.mean_field(diffusion_rate(frequency, medium.kinematic_viscosity))
        return series_from_mean(self.area, mean, frequency, medium)

    def shunt_admittance(self, frequency: FrequencyLike, air: AirLike) -> ComplexArray:
        """Shunt admittance per length, m^2/(Pa s): shape of frequency (Hz), complex128.

        Y' = j w S / (gamma p) (gamma - (gamma - 1) <Psi_h>).
        """
        medium = medium_of(air)
        mean = self.mean_field(diffusion_rate(frequency, medium.thermal_diffusivity))
        return shunt_from_mean(self.area, mean, frequency, medium)


@dataclass(frozen=True)
class CircularSection(Section):
    """A round bore, exact: :func:`acoustic_fem.duct.plane_wave.series_impedance`."""

    radius: float
    """Radius of the bore, m."""

    def __post_init__(self) -> None:
        positive_numbers("radius", self.radius, "m")

    @property
    def area(self) -> float:
        """Area of the section, m^2."""
        return np.pi * self.radius**2

    def mean_field(self, rate: ComplexArray) -> ComplexArray:
        """Mean <Psi> = 1 - 2 I1(x)/(x I0(x)), x^2 = a^2 s: shape of the rate s (1/m^2), complex128."""
        return round_mean(2, self.radius, rate)


@dataclass(frozen=True)
class SlitSection(Section):
    """A slit much wider than its gap; the side walls are neglected (relative error 0.63 gap / width).

    Stinson and Champoux, J. Acoust. Soc. Am. 91 (1992) 685. Low frequency: Z' -> 12 mu / (w h^3).
    """

    gap: float
    """Distance h of the walls, m."""
    width: float
    """Width w, m."""

    def __post_init__(self) -> None:
        positive_numbers("gap", self.gap, "m")
        positive_numbers("width", self.width, "m")

    @property
    def area(self) -> float:
        """Area of the section, m^2."""
        return self.gap * self.width

    def mean_field(self, rate: ComplexArray) -> ComplexArray:
        """Mean <Psi> = 1 - tanh(x)/x, x = h sqrt(s) / 2: shape of the rate s (1/m^2), complex128."""
        return round_mean(1, self.gap / 2, rate)


@dataclass(frozen=True)
class RectangularSection(Section):
    """A rectangular duct: the slit of the shorter side less the drag of the other two walls, as a series.

    The double series of Roe, J. Acoust. Soc. Am. 31 (1959) 62, and Stinson, J. Acoust. Soc. Am. 89 (1991)
    550, summed over the longer side; the terms fall as m^-5 and their tail is added by Hurwitz zeta
    functions. Relative error below 1e-12 (tests/acoustic_fem/duct/test_sections.py).
    """

    width: float
    """Length of one side, m."""
    height: float
    """Length of the other side, m."""

    def __post_init__(self) -> None:
        positive_numbers("width", self.width, "m")
        positive_numbers("height", self.height, "m")

    @property
    def area(self) -> float:
        """Area of the section, m^2."""
        return self.width * self.height

    def mean_field(self, rate: ComplexArray) -> ComplexArray:
        """Mean <Psi>: shape of the rate s (1/m^2), complex128.

        The mean of the slit less the sum over odd m of 8/(pi m)^2 s/q^2 tanh(q w/2)/(q w/2), q^2 = (m pi/h)^2 + s,
        w >= h.
        """
        long, short = max(self.width, self.height), min(self.width, self.height)
        sigma = np.asarray(rate * (short / np.pi) ** 2, dtype=np.complex128)
        count = int(np.ceil(max(32.0, 4 * np.sqrt(np.abs(sigma).max(initial=0.0)))))
        odd = 2.0 * np.arange(count) + 1
        square = odd**2 + sigma[..., None]
        wave = np.sqrt(square)
        half = np.pi * long / (2 * short)  # q w/2 per unit of the wave number, at least pi/2
        terms = np.tanh(half * wave) / (odd**2 * square * wave)
        # tanh = 1 here: m^-2 (m^2 + sigma)^(-3/2) expanded in sigma / m^2, below 1/16
        rest, factor = np.zeros_like(sigma), 1.0
        for k in range(12):
            power = 5 + 2 * k
            rest = rest + factor * sigma**k * float(zeta(power, count + 0.5)) / 2.0**power
            factor *= -(1.5 + k) / (k + 1)
        return round_mean(1, short / 2, rate) - 8 / (np.pi**2 * half) * sigma * (terms.sum(-1) + rest)


@dataclass(frozen=True)
class TriangularSection(Section):
    """A duct with an equilateral triangle as section, exact; other triangles: :meth:`MeshedSection.triangle`.

    1 - 3 (x coth x - 1)/x^2 with x = sqrt(3) d sqrt(s) / 4 (Stinson and Champoux, J. Acoust. Soc. Am. 91
    (1992) 685). Low frequency: Z' -> 320 mu / (sqrt(3) d^4).
    """

    side: float
    """Length d of a side, m."""

    def __post_init__(self) -> None:
        positive_numbers("side", self.side, "m")

    @property
    def area(self) -> float:
        """Area of the section, m^2."""
        return np.sqrt(3) / 4 * self.side**2

    def mean_field(self, rate: ComplexArray) -> ComplexArray:
        """Mean <Psi>, that of a sphere of radius sqrt(3) d / 4: shape of the rate (1/m^2), complex128."""
        return round_mean(3, np.sqrt(3) / 4 * self.side, rate)
