"""A MEMS microphone: what it loads its chamber with, how it responds, and its noise.

A compliant diaphragm in front of a closed back volume, with a vent through it. The vent makes the
high-pass corner: below it the pressures on both sides become equal.
"""

from __future__ import annotations

import numpy as np

from acoustic_fem.cavity.closed_forms import closed_sphere_compliance
from acoustic_fem.quantities.checks import FrequencyLike, frequencies
from acoustic_fem.quantities.local_air import AirLike, medium_of
from acoustic_fem.quantities.units import cubic_metres
from geometry.ground.typed import Array, ComplexArray
from geometry.schema.part_fields import Microphone


def load_admittance(microphone: Microphone, frequency: FrequencyLike, air: AirLike) -> ComplexArray:
    """Volume velocity into the microphone per pressure on its front, in m^3/(Pa s).

    Y = j w Cb (j w Cd + 1/R) / (j w (Cb + Cd) + 1/R): diaphragm Cd and vent R side by side, in series with
    the back volume Cb. Cd is the adiabatic compliance of the diaphragm's equivalent volume; Cb that of a
    sphere of the back volume with isothermal walls.

    Args:
        microphone: from the design.
        frequency: Hz, any shape.
        air: a :class:`acoustic_fem.LocalAir`, or a gas of its own.

    Returns:
        Shape of frequency, complex128, m^3/(Pa s).

    Raises:
        Refusal: a frequency that is not finite and positive.
    """
    diaphragm, back, leak = circuit_elements(microphone, frequency, air)
    omega = 2 * np.pi * frequencies(frequency)
    return 1j * omega * back * (1j * omega * diaphragm + leak) / (1j * omega * (back + diaphragm) + leak)


def response(microphone: Microphone, frequency: FrequencyLike, air: AirLike) -> ComplexArray:
    """Pressure across the diaphragm per pressure in front, (p - p_back) / p: what the electrical output follows.

    Frequency in Hz; arguments, errors and model as :func:`load_admittance`; the resonance of the diaphragm (above
    10 kHz) is left out.

    Returns:
        Shape of frequency, complex128, Pa/Pa.
    """
    diaphragm, back, leak = circuit_elements(microphone, frequency, air)
    omega = 2 * np.pi * frequencies(frequency)
    return 1j * omega * back / (1j * omega * (back + diaphragm) + leak)


def vent_ratio(microphone: Microphone, frequency: FrequencyLike, air: AirLike) -> ComplexArray:
    """Admittance of the compliances over that of the vent R that discharges them, v = j w R (Cb + Cd).

    The response is Cb / (Cb + Cd) v / (1 + v); a vent that conducts s times as well makes v / s of it.

    Frequency in Hz; arguments and errors as :func:`response`.

    Returns:
        Shape of frequency, complex128, a ratio.
    """
    diaphragm, back, leak = circuit_elements(microphone, frequency, air)
    omega = 2 * np.pi * frequencies(frequency)
    return 1j * omega * (back + diaphragm) / leak


def noise_density(microphone: Microphone, frequency: FrequencyLike) -> Array:
    """Equivalent input noise n sqrt(1 + fc / f) in Pa/sqrt(Hz): white, and 1/f in power below fc.

    Args:
        microphone: from the design.
        frequency: Hz, any shape.

    Returns:
        Shape of frequency, float64, Pa/sqrt(Hz).

    Raises:
        Refusal: a frequency that is not finite and positive.
    """
    ratio = microphone.noise_corner / frequencies(frequency)
    return microphone.noise_density * np.sqrt(1 + ratio)


def noise_density_behind_vent(microphone: Microphone, frequency: FrequencyLike, air: AirLike) -> Array:
    """Equivalent input noise of the figures read as noise of the output, referred to the pressure in front.

    n sqrt(1 + fc / f) / |response|, Pa/sqrt(Hz). A data sheet states noise at the output divided by the
    sensitivity above the vent's corner; since the vent takes signal away below its corner but not noise of
    the electronics, the pressure in front that such noise is worth rises there by 20 dB per decade more.

    Frequency in Hz; arguments and errors as :func:`response`.

    Returns:
        Shape of frequency, float64, Pa/sqrt(Hz).
    """
    return noise_density(microphone, frequency) / np.abs(response(microphone, frequency, air))


def circuit_elements(
    microphone: Microphone, frequency: FrequencyLike, air: AirLike
) -> tuple[float, ComplexArray, float]:
    """The microphone as a circuit at a frequency, Hz; arguments and errors as :func:`response`.

    Returns:
        Compliance of the diaphragm, m^3/Pa; compliance of the back volume, shape of frequency, complex128, m^3/Pa;
        and admittance 1/R of the vent, m^3/(Pa s).
    """
    medium = medium_of(air)
    diaphragm = cubic_metres(microphone.diaphragm_equivalent_volume) / (medium.gamma * medium.pressure)
    radius = (3 * cubic_metres(microphone.back_volume) / (4 * np.pi)) ** (1 / 3)
    corner = microphone.vent_corner
    # the response is 3 dB down where 1/R = w (Cb + Cd)
    leak = 2 * np.pi * corner * (float(closed_sphere_compliance(radius, corner, medium).real) + diaphragm)
    return diaphragm, closed_sphere_compliance(radius, frequency, medium), leak
