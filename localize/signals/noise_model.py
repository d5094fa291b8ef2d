"""Noise of the microphones, as a pressure in front of them.

A microphone records its response times the pressure in its chamber, plus noise of its own. The vent makes the
response fall below its corner, the noise does not fall with it: as a pressure in the chamber the noise has the
density of :func:`acoustic_fem.network.noise_density_behind_vent`. :mod:`acoustic_fem.library.noise_floor` takes it from
there too, with ``noise_at="output"``. Signals in this package are pressures in the chambers, and all microphones are
alike, so that ratios of recorded signals are those of the pressures.

Below 1 Hz, the lowest frequency of the stimuli, such a noise grows without limit; a recording is taken as high-passed
there.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from acoustic_fem import network
from acoustic_fem.quantities.local_air import AirLike
from geometry.ground.refusal import Kind, Refusal
from geometry.schema.part_fields import Microphone

#: White noise of so many Pa rms over 0 to 500 Hz, or the noise of the design's microphone.
NoiseChoice = float | Literal["design"]

NOISE_BAND = (1.0, 500.0)
"""Band in which a microphone's noise is taken, Hz: from the lowest frequency of the stimuli to half the sample rate."""
_STEPS_PER_HERTZ = 20


def check_noise_choice(
    choice: object,
    field: str = "microphone_noise",
    low: float = 0.0,
    high: float = np.inf,
    allowed: str = "'design' or a finite number of Pa rms, zero or above",
) -> None:
    """Refuse a noise of the microphones that is neither "design" nor a number of Pa in a range.

    Args:
        choice: the argument.
        field: name of the argument.
        low: least noise, Pa rms.
        high: largest noise, Pa rms, which must be finite.
        allowed: both in words.

    Raises:
        Refusal: another text, no single number, or a number outside the range.
    """
    if isinstance(choice, str) and choice == "design":
        return
    if isinstance(choice, bool) or not isinstance(choice, (int, float, np.number)):
        raise Refusal(kind=Kind.WRONG_TYPE, field=field, value=choice, unit="Pa", allowed=allowed)
    if not (low <= choice <= high and choice < np.inf):
        raise Refusal(kind=Kind.OUT_OF_RANGE, field=field, value=float(choice), unit="Pa", allowed=allowed)


@dataclass(frozen=True, eq=False)
class NoiseSpectrum:
    """Coloured Gaussian noise, independent for each microphone."""

    power: NDArray[np.float64]
    """Mean square of the noise in the hertz around 0, 1, ..., 499 Hz; (500,) float64, Pa^2."""
    source: str
    """Name of what makes the noise, and where its figures come from."""

    @property
    def rms(self) -> float:
        """Root mean square of the noise over 1 to 500 Hz, Pa."""
        return float(np.sqrt(self.power.sum()))


@lru_cache(maxsize=16)
def microphone_noise(microphone: Microphone, air: AirLike) -> NoiseSpectrum:
    """Noise of a design's microphone over 1 to 500 Hz, as a pressure in its chamber.

    Args:
        microphone: from the design.
        air: a :class:`acoustic_fem.LocalAir`, or a gas of its own.
    """
    low, high = NOISE_BAND
    frequency = low + (np.arange(round((high - low) * _STEPS_PER_HERTZ)) + 0.5) / _STEPS_PER_HERTZ
    lines = round(high)
    power = np.bincount(
        np.clip(np.rint(frequency), 1, lines - 1).astype(np.int64),
        weights=network.noise_density_behind_vent(microphone, frequency, air) ** 2 / _STEPS_PER_HERTZ,
        minlength=lines,
    )
    return NoiseSpectrum(power.astype(np.float64), f"microphone {microphone.model}: {microphone.source}")
