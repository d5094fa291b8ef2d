"""Tubes, cavities, membranes and microphones in closed form on batches: (n_design, n_column, n_freq) arrays.

The same models as the lumped fidelity (:mod:`acoustic_fem.duct`, :mod:`acoustic_fem.duct.tube_opening`,
:mod:`acoustic_fem.cavity`, :mod:`acoustic_fem.network.microphone`), with their sources and validity, arranged so that
nothing cancels at low frequency: a tube is a series admittance and a shunt at each end, not a matrix Y.
"""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Any, NamedTuple

import numpy as np

from acoustic_fem.batch.interpolation import cylinder_means, disc_means, sphere_means
from acoustic_fem.batch.means import hyperbolic
from acoustic_fem.batch.numpy_or_torch import inverse, largest
from acoustic_fem.batch.parameters import ArrayParameters, MediumParameters
from acoustic_fem.duct.tube_opening import INERTANCE, LARGEST_SHEAR_NUMBER, RESISTANCE
from acoustic_fem.membrane.rubber import causal_slope, modulus_ratio
from acoustic_fem.quantities.medium import Medium
from acoustic_fem.quantities.model_limit_warning import ModelLimitWarning
from geometry.ground.caller_warnings import warn_caller
from geometry.ground.typed import NumpyOrTorch

#: Largest (f/f_1)^2 at which the membrane's modes are summed as a power series; it has then up to 29 terms.
_SERIES = 0.25


@dataclass(frozen=True, eq=False)
class Conditions:
    """Frequencies and air, shaped to broadcast with (n_design, n_column, n_freq)."""

    omega: NumpyOrTorch
    """Angular frequencies, (n_freq,) float64, rad/s."""
    medium: Any
    """The gas in numbers, or in arrays (n_design, 1, 1), by the fields of :class:`acoustic_fem.quantities.Medium`."""
    blocks: int = 1
    """Number of blocks of designs that are worked on in this way, one after the other; 0 if every design must have
    what it has alone, to the last bit."""

    @classmethod
    def of(cls, omega: NumpyOrTorch, medium: Medium | MediumParameters, blocks: int = 1) -> Conditions:
        """Conditions at angular frequencies, (n_freq,) float64 in rad/s, in the air of all designs or of each."""
        if isinstance(medium, MediumParameters):
            values = {field.name: getattr(medium, field.name).reshape(-1, 1, 1) for field in fields(medium)}
            medium = MediumParameters(**values)
        return cls(omega, medium, blocks)

    @property
    def per_viscosity(self) -> NumpyOrTorch:
        """Inverse of the kinematic viscosity 1 / nu, s/m^2: a scalar, or (n_design, 1, 1) float64."""
        return self.medium.density / self.medium.viscosity

    @property
    def per_diffusivity(self) -> NumpyOrTorch:
        """Inverse of the thermal diffusivity 1 / alpha, s/m^2: a scalar, or (n_design, 1, 1) float64."""
        return self.medium.density * self.medium.heat_capacity / self.medium.conductivity

    def compliance(self, volume: NumpyOrTorch, mean: NumpyOrTorch) -> NumpyOrTorch:
        """Compliance of closed volumes, V (gamma - (gamma - 1) <Psi>) / (gamma p).

        Args:
            volume: V, (n_design, n_column, 1) float64, m^3.
            mean: <Psi> of the thermal field, (n_design, n_column, n_freq) complex128.

        Returns:
            (n_design, n_column, n_freq) complex128, m^3/Pa.
        """
        gamma = self.medium.gamma
        return volume / self.medium.pressure - (volume * ((gamma - 1) / (gamma * self.medium.pressure))) * mean


class Tubes(NamedTuple):
    """Tubes with the losses of both openings: a series admittance between shunts."""

    series: NumpyOrTorch
    """Admittance between both ends, (n_design, n_column, n_freq) complex128, m^3/(Pa s)."""
    first: NumpyOrTorch
    """Admittance to ground at the first end, (n_design, n_column, n_freq) complex128, m^3/(Pa s)."""
    last: NumpyOrTorch
    """The same at the last end, (n_design, n_column, n_freq) complex128, m^3/(Pa s)."""


class Ducts(NamedTuple):
    """Tubes without their openings."""

    series: NumpyOrTorch
    """Impedance of the whole length Z' L, (n_design, n_column, n_freq) complex128, Pa s/m^3."""
    shunt: NumpyOrTorch
    """Admittance of the whole length Y' L, (n_design, n_column, n_freq) complex128, m^3/(Pa s)."""
    rise: NumpyOrTorch
    """cosh(G L) - 1 with G^2 = Z' Y', (n_design, n_column, n_freq) complex128."""
    ratio: NumpyOrTorch
    """sinh(G L) / (G L), (n_design, n_column, n_freq) complex128."""


class Points(NamedTuple):
    """Cavities with all that yields around them, as nodes between tubes."""

    shunt: NumpyOrTorch
    """Admittance of the node to ground, (n_design, n_column, n_freq) complex128, m^3/(Pa s)."""
    ratio: NumpyOrTorch | None = None
    """Pressure at the membrane by that of the node, (n_design, n_column, n_freq) complex128, Pa/Pa; None: the same."""
    own: NumpyOrTorch | None = None
    """Impedance at the membrane while the node is at zero pressure, (n_design, n_column, n_freq) complex128, Pa s/m^3;
    None: zero."""


class Chambers(NamedTuple):
    """Microphone chambers."""

    shunt: NumpyOrTorch
    """Admittance of chamber, sound hole and microphone, (n_design, n_column, n_freq) complex128, m^3/(Pa s)."""
    ratio: NumpyOrTorch
    """Pressure on the microphone per pressure in the chamber, (n_design, n_column, n_freq) complex128, Pa/Pa."""
    own: NumpyOrTorch
    """Pressure on the microphone per volume velocity injected there while the chamber is at zero pressure, (n_design,
    n_column, n_freq) complex128, Pa s/m^3.
    """


def tubes(parameters: ArrayParameters, air: Conditions) -> Tubes:
    """Tubes from cavity wall to cavity wall: Zwikker-Kosten ducts between two entrance impedances."""
    total, across, rise, ratio = ducts(parameters, air)
    entrance = _entrance(parameters.tube_radius[..., None], air)
    # chain matrix [[1 + a, b], [., 1 + a]]: a = cosh - 1 + Ze Y sinh, b = Z sinh + Ze (1 + a + cosh)
    inward = entrance * across * ratio
    excess = rise + inward
    series = inverse(total * ratio + entrance * (2 + rise + excess))
    shunt = excess * series
    return Tubes(series, shunt, shunt)


def ducts(parameters: ArrayParameters, air: Conditions) -> Ducts:
    """Tubes from cavity wall to cavity wall without their openings: Zwikker-Kosten ducts."""
    radius, length = parameters.tube_radius[..., None], parameters.tube_length[..., None]
    wall: NumpyOrTorch | float = 0.0
    if _counts(parameters.sheath_compliance):
        wall = length * parameters.sheath_compliance[..., None] * _softness("sheath", parameters, air)
    return _duct(radius, length, air, wall)


def points(parameters: ArrayParameters, air: Conditions) -> Points:
    """Cavities of uniform pressure and what yields around them, (n_design, n_point_column, n_freq)."""
    cavity, load = yielding(parameters, air)
    return Points(cavity + load)


def yielding(parameters: ArrayParameters, air: Conditions) -> tuple[NumpyOrTorch, NumpyOrTorch]:
    """Admittances of the air of cavities and of all that yields around it.

    Returns:
        Both (n_design, n_point_column, n_freq) complex128, m^3/(Pa s).
    """
    cavity = _cylinder(parameters.cavity_radius[..., None], parameters.cavity_height[..., None], air)
    modes = parameters.membrane_frequency
    kept = max(0, modes.shape[-1] - 3)  # the last two correct the statics
    highest, limit = largest(air.omega) / (2 * np.pi), 1 / largest(1 / modes[..., kept]) / 2
    if highest > limit:
        warn_caller(
            f"membrane: {highest:.4g} Hz is above half of the highest mode that is kept ({2 * limit:.4g} Hz in vacuo)",
        )
    membrane = _modes(parameters, air) * parameters.membrane_compliance[..., None]
    if _counts(parameters.floor_compliance):
        membrane = membrane + parameters.floor_compliance[..., None] * _softness("floor", parameters, air)
    rate = 1j * air.omega
    return rate * cavity, rate * membrane + parameters.leak_conductance[..., None]


def _modes(parameters: ArrayParameters, air: Conditions) -> NumpyOrTorch:
    """Sum of share / (e - (f/f_k)^2) over the modes, (n_design, n_column, n_freq); e is the modulus by the stated one.

    Well below the first mode it is a power series in f^2 / e with moments of the modes.
    """
    modes, shares = parameters.membrane_frequency, parameters.membrane_fraction
    softness = _softness("membrane", parameters, air)
    highest = largest(air.omega) / (2 * np.pi)
    square = (air.omega / (2 * np.pi * highest)) ** 2
    places = (highest / modes) ** 2
    dynamic = square * softness
    ratio = largest(places) * largest(dynamic)
    if ratio > _SERIES:
        return softness * sum(
            shares[..., k, None] * inverse(1 - dynamic * places[..., k, None]) for k in range(modes.shape[-1])
        )
    terms = int(np.ceil(np.log(1e-17) / np.log(max(ratio, 1e-17))))
    moments = [(shares * places**power).sum(-1)[..., None] for power in range(terms + 1)]
    series = moments[-1]
    for moment in reversed(moments[:-1]):
        series = series * dynamic + moment
    return series * softness


def membrane_modulus(parameters: ArrayParameters, frequency: NumpyOrTorch) -> NumpyOrTorch:
    """Complex modulus of the membranes by the stated one.

    Args:
        parameters: of the designs.
        frequency: (n_freq,) float64, Hz, an array or tensor as the parameters are.

    Returns:
        (n_design, n_point_column, n_freq) complex128.
    """
    return _modulus("membrane", parameters, frequency)


def _counts(values: NumpyOrTorch) -> bool:
    """True if any of the values is not 0, or its derivative is asked for."""
    return bool(getattr(values, "requires_grad", False)) or bool((values > 0).any())


def _softness(part: str, parameters: ArrayParameters, air: Conditions) -> NumpyOrTorch:
    return inverse(_modulus(part, parameters, air.omega / (2 * np.pi)))


def _modulus(part: str, parameters: ArrayParameters, frequency: NumpyOrTorch) -> NumpyOrTorch:
    loss, slope, reference, strength, time = (
        getattr(parameters, f"{part}_{name}")
        for name in ("loss", "slope", "reference", "relaxation", "relaxation_time")
    )
    loss, slope, reference = loss[..., None], slope[..., None], reference[..., None]
    slopes = slope * causal_slope(loss)
    return modulus_ratio(frequency, loss, slopes, reference, strength[..., None, :], time[..., None, :])


def chambers(parameters: ArrayParameters, air: Conditions) -> Chambers:
    """Chambers with sound hole, diaphragm, vent and back volume."""
    rate = 1j * air.omega
    chamber = _cylinder(parameters.chamber_radius[..., None], parameters.chamber_height[..., None], air)
    volume = parameters.back_volume[..., None]
    sphere = (3 * volume / (4 * np.pi)) ** (1 / 3)
    back = rate * air.compliance(volume, sphere_means(sphere**2 * air.per_diffusivity, air.omega, air.blocks))
    front = rate * parameters.diaphragm_compliance[..., None] + parameters.vent_admittance[..., None]
    load = back * front / (back + front)

    radius, length = parameters.hole_radius[..., None], parameters.hole_length[..., None]
    total, across, rise, ratio = _duct(radius, length, air)
    entrance = _entrance(radius, air)
    inward = across * ratio
    through = total * ratio + entrance * (1 + rise)
    opening = inverse(1 + rise + entrance * inward + through * load)
    return Chambers(rate * chamber + (inward + (1 + rise) * load) * opening, opening, through * opening)


def _duct(radius: NumpyOrTorch, length: NumpyOrTorch, air: Conditions, wall: NumpyOrTorch | float = 0.0) -> Ducts:
    """Ducts whose wall has a compliance, m^3/Pa."""
    square = radius * radius
    section = np.pi * square
    viscous, thermal = (
        disc_means(square * rate, air.omega, air.blocks) for rate in (air.per_viscosity, air.per_diffusivity)
    )
    impedance = (air.medium.density * length / section) * (1j * air.omega) / viscous
    admittance = (1j * air.omega) * (air.compliance(section * length, thermal) + wall)
    return Ducts(impedance, admittance, *hyperbolic(impedance * admittance))


def _entrance(radius: NumpyOrTorch, air: Conditions) -> NumpyOrTorch:
    """Z = 1.5 mu / a^3 + j w 0.42 rho / a, with the warning of
    :func:`acoustic_fem.duct.tube_opening.entrance_impedance`.
    """
    shear = (largest(radius * radius * air.per_viscosity) * largest(air.omega)) ** 0.5
    if shear > LARGEST_SHEAR_NUMBER:
        warn_caller(
            f"entrance loss of a tube: shear number a sqrt(w/nu) = {shear:.2g} is above {LARGEST_SHEAR_NUMBER:g}, "
            f"the largest it is fit for (bore radius {largest(radius) * 1e3:.3g} mm, up to "
            f"{largest(air.omega) / (2 * np.pi):.4g} Hz)",
            ModelLimitWarning,
        )
    resistance = (RESISTANCE * air.medium.viscosity) / radius**3
    return resistance + (1j * air.omega) * (INERTANCE * air.medium.density / radius)


def _cylinder(radius: NumpyOrTorch, height: NumpyOrTorch, air: Conditions) -> NumpyOrTorch:
    """Compliance of closed cylinders, m^3/Pa."""
    square = radius * radius
    mean = cylinder_means(square * air.per_diffusivity, height / (2 * radius), air.omega, air.blocks)
    return air.compliance(np.pi * square * height, mean)
