"""Motion of the whole sensor, as the disturbance that the motion test models.

A sensor on a hand or a robot is accelerated. The inertia of its membranes, and no touch, then moves the microphones
(:func:`acoustic_fem.library.acceleration.acceleration_response`). A flat array is shaken along one axis, so that its
microphones follow one function of frequency; an array on a curved body may follow two or three.

The acceleration is noise whose density falls as 1/f^4 above a corner: voluntary movements of a hand lie below about
10 Hz, and most of what accelerometers on a body record below 20 Hz (C. V. C. Bouten, K. T. M. Koekkoek, M. Verduin,
R. Kodde and J. D. Janssen, IEEE Trans. Biomed. Eng. 44 (1997) 136).
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from acoustic_fem import Library
from acoustic_fem.numerics.frequency_splines import interpolated
from geometry.ground.argument_checks import check_range
from geometry.ground.typed import Array, ComplexArray
from localize.decoders.frame_covariance import INTEGRATION_STEP, PASSED, random_waves, sampled_waves
from localize.signals.stimulus import SAMPLE_RATE

ACCELERATIONS = (0.01, 1000.0)
"""Least and largest acceleration that can be given, m/s^2."""
CORNER = 5.0
"""Frequency above which the acceleration of a hand falls, Hz; assumed."""
CREST = 3.0
"""Largest acceleration over its rms, of noise within some seconds."""


@dataclass(frozen=True, eq=False)
class HandMotion:
    """Acceleration of a sensor up to a largest one, and what the microphones give for it."""

    largest: float
    """Largest acceleration, gravity left out, m/s^2."""
    response: ComplexArray
    """Pressure at the microphones per acceleration along x, y and z; (n_microphone, 3, n_freq) complex128, Pa s2/m."""
    frequency: Array
    """Frequencies, (n_freq,) float64, Hz."""
    microphones: tuple[str, ...]
    """Names of the microphones."""

    @classmethod
    def of(cls, library: Library, largest: float) -> HandMotion:
        """Motion of a sensor.

        Args:
            library: of the array, with flat membranes.
            largest: largest acceleration, gravity left out, 0.01 to 1000 m/s^2.

        Raises:
            Refusal: an acceleration out of range, or as of
                :func:`acoustic_fem.library.acceleration.acceleration_response`.
        """
        check_range("motion", largest, *ACCELERATIONS, "m/s2")
        response = np.asarray(library.acceleration_response.values, np.complex128)
        return cls(float(largest), response, library.frequency, tuple(library.design.microphones))

    def heard_by(self, microphones: tuple[str, ...]) -> HandMotion:
        """The same at some of the microphones, by their names."""
        kept = [self.microphones.index(name) for name in microphones]
        return replace(self, response=self.response[kept], microphones=microphones)

    @property
    def loudest(self) -> float:
        """Largest pressure at a microphone, at the worst frequency and direction, Pa."""
        return self.largest * float(np.linalg.norm(self.response, axis=1).max())

    @property
    def covariance(self) -> Array:
        """Second moment of the filtered samples of a frame, microphone by microphone, (n, n) float64, Pa^2."""
        top = min(float(self.frequency[-1]), PASSED, SAMPLE_RATE / 2)
        frequency = np.arange(INTEGRATION_STEP, top + 1e-9, INTEGRATION_STEP)
        power = 1 / (1 + (frequency / CORNER) ** 4)
        amplitude = self.largest / CREST * np.sqrt(power / power.sum())
        turn, gain = sampled_waves(frequency)
        known = interpolated(self.response, self.frequency, frequency)
        waves = [random_waves(known[:, axis], amplitude * gain, turn) for axis in range(known.shape[1])]
        together = np.concatenate(waves)
        return np.asarray(together.T @ together)
