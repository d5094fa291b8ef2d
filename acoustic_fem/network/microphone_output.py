"""Output of a microphone and the pressure in front of it: the one place where one is converted to the other.

A microphone gives a voltage, or a fraction of full scale. Divided by the sensitivity that is stated at 1 kHz it is an
*output* in Pa, which equals the pressure in front of the microphone at 1 kHz, and below the corner of its vent is less.
Transfer functions are of pressures; recordings are outputs unless somebody has equalised them.

Over frequency, both are converted by :func:`output_response`. Samples are converted by :class:`Equaliser`, a causal
filter: the inverse of that response behind a high-pass, without which the wander of an amplifier would grow without
limit.
"""

from __future__ import annotations

from functools import reduce
from operator import add, mul

import numpy as np
import scipy.signal
from numpy.polynomial import Polynomial

from acoustic_fem.network.microphone import circuit_elements, noise_density, response
from acoustic_fem.quantities.checks import FrequencyLike
from acoustic_fem.quantities.local_air import AirLike, medium_of
from acoustic_fem.quantities.microphone_signals import LOWEST, LOWEST_RANGE
from acoustic_fem.quantities.units import cubic_metres
from geometry.ground.argument_checks import check_range
from geometry.ground.typed import Array, ComplexArray
from geometry.schema.part_fields import Microphone

#: Frequency at which data sheets state the sensitivity, Hz.
STATED_AT = 1000.0
#: Order of the high-pass there, a Butterworth.
ORDER = 2
#: Relaxations of the heat in the back volume that are kept; four give its compliance to 1e-3.
_RELAXATIONS = 4


def output_response(microphone: Microphone, frequency: FrequencyLike, air: AirLike) -> ComplexArray:
    """Output of a microphone over the pressure in front of it, against the sensitivity stated at 1 kHz.

    Args:
        microphone: from the design.
        frequency: Hz, any shape.
        air: a :class:`acoustic_fem.LocalAir`, or a gas of its own.

    Returns:
        Shape of frequency, complex128, a ratio: :func:`acoustic_fem.network.response` over its modulus at 1 kHz.

    Raises:
        Refusal: a frequency that is not finite and positive.
    """
    stated = np.abs(response(microphone, STATED_AT, air))
    return np.asarray(response(microphone, frequency, air) / stated)


class Equaliser:
    """Filter from the output of a microphone to the pressure in front of it, down to a lowest frequency.

    The compliance of the back volume is a sum of relaxations of heat (a sphere with isothermal walls), so that the
    response is rational in s with real poles and zeros; its inverse times a Butterworth high-pass is brought to
    samples by the bilinear transform. At 1 kHz, the result is within 0.1 % up to 20 Hz and within 1 % up to 125 Hz,
    alike for all microphones.

    Args:
        microphone: from the design.
        air: a :class:`acoustic_fem.LocalAir`, or a gas of its own.
        rate: of the samples, Hz.
        lowest: frequency down to which signals are equalised, Hz; there the high-pass is 3 dB down.

    Raises:
        Refusal: a lowest frequency outside :data:`LOWEST_RANGE`.
    """

    def __init__(self, microphone: Microphone, air: AirLike, rate: float, lowest: float = LOWEST) -> None:
        self.lowest = check_range("lowest", lowest, *LOWEST_RANGE, "Hz")
        self.microphone, self.air, self.rate = microphone, medium_of(air), rate
        self.sections = self._sections()
        """Sections of second order, (n, 6) float64."""
        self._state = np.zeros((len(self.sections), 1, 2))

    def begin(self, samples: Array) -> Array:
        """First samples, or all, (n_microphone, n) float64, Pa, as pressures; before them stood the first value."""
        self._state = scipy.signal.sosfilt_zi(self.sections)[:, None, :] * samples[None, :, :1]
        return self(samples)

    def __call__(self, samples: Array) -> Array:
        """Samples that follow those before, (n_microphone, n) float64, Pa, as pressures."""
        filtered, self._state = scipy.signal.sosfilt(self.sections, samples, axis=1, zi=self._state)
        return np.asarray(filtered)

    def gain(self, frequency: FrequencyLike) -> ComplexArray:
        """Response of the filter, output over input.

        Args:
            frequency: Hz, any shape, below half the rate.

        Returns:
            Shape of frequency, complex128, a ratio.
        """
        return np.asarray(scipy.signal.sosfreqz(self.sections, np.asarray(frequency), fs=self.rate)[1])

    def noise(self, highest: float) -> tuple[float, float]:
        """Noise of the microphone before and behind the filter, Pa rms, from the lowest frequency to a highest one.

        Before: as an output, n. Behind: as a pressure in front, n over the modulus of the response, behind the
        high-pass. The second over the first is what equalising costs.

        Args:
            highest: Hz.
        """
        frequency = np.geomspace(self.lowest, highest, 400)
        density = noise_density(self.microphone, frequency)
        before, behind = (
            float(np.sqrt(np.trapezoid(each**2, frequency)))
            for each in (density, density * np.abs(self.gain(frequency)))
        )
        return before, behind

    def _sections(self) -> Array:
        zeros, poles = _zeros_and_poles(self.microphone, self.air)
        passed_zeros, passed_poles, _ = scipy.signal.butter(
            ORDER, 2 * np.pi * self.lowest, "highpass", analog=True, output="zpk"
        )
        # The zero of the response at s = 0 is a pole of its inverse, which a zero of the high-pass takes away.
        digital = scipy.signal.bilinear_zpk(
            np.concatenate([passed_zeros[1:], poles]), np.concatenate([passed_poles, zeros]), 1.0, self.rate
        )
        sections = np.asarray(scipy.signal.zpk2sos(*digital))
        at = np.array([np.clip(self.microphone.vent_corner, 2 * self.lowest, self.rate / 50)])
        s = 2j * np.pi * at
        passed = s**ORDER / np.prod(s - passed_poles)
        exact = np.abs(passed / output_response(self.microphone, at, self.air))
        sections[0, :3] *= exact / np.abs(scipy.signal.sosfreqz(sections, at, fs=self.rate)[1])
        return sections


def _zeros_and_poles(microphone: Microphone, air: AirLike) -> tuple[Array, Array]:
    """Zeros other than s = 0, and poles, of the response, rad/s, real.

    C_b = V/(gamma p) (1 + (gamma - 1) sum_n 6/(n pi)^2 / (1 + s t_n)), t_n = R^2/(alpha (n pi)^2); relaxations that are
    left out count with the last.
    """
    medium = medium_of(air)
    diaphragm, _, leak = circuit_elements(microphone, STATED_AT, medium)
    volume = cubic_metres(microphone.back_volume)
    number = np.arange(1, _RELAXATIONS + 1)
    weight = 6 / (number * np.pi) ** 2
    weight[-1] += 1 - weight.sum()
    radius = (3 * volume / (4 * np.pi)) ** (1 / 3)
    unit = 2 * np.pi * microphone.vent_corner  # of s, so that coefficients are of one size
    times = unit * radius**2 / (medium.thermal_diffusivity * (number * np.pi) ** 2)
    one = Polynomial([1.0])
    factors = [Polynomial([1.0, each]) for each in times]
    whole = reduce(mul, factors, one)
    relaxing = [part * reduce(mul, factors[:n] + factors[n + 1 :], one) for n, part in enumerate(weight.tolist())]
    back = volume / (medium.gamma * medium.pressure) * (whole + (medium.gamma - 1) * reduce(add, relaxing))
    rising = Polynomial([0.0, unit])
    zeros, poles = back.roots(), (rising * (back + diaphragm * whole) + leak * whole).roots()
    return np.real(zeros) * unit, np.real(poles) * unit
