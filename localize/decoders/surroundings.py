"""Noise of the microphones and sound around that a decoder assumes beside touches."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeAlias

import numpy as np

from geometry.ground.refusal import Kind, Refusal
from localize.decoders.frame_covariance import check_level, check_noise
from localize.signals.array_response import ArrayResponse, warn_of_uncovered
from localize.signals.disturbances import SOUND_LEVELS, check_sound_level
from localize.signals.noise_model import NoiseChoice, NoiseSpectrum

Ambient: TypeAlias = float | list[float | None] | tuple[float | None, ...] | None
"""Sound around: none, a level in dB SPL, or several, of which each frame takes the likeliest."""


def sound_levels(loudest_db: float | None) -> tuple[float | None, ...]:
    """Levels that cover sound up to the loudest, dB SPL, quiet (None) among them; quiet alone where none is given.

    15 dB apart from 40 on: 10 apart was tried on line-2, better at some levels and worse at others by up to 1.7 %.

    Raises:
        Refusal: not one number, or outside 0 to 140 dB SPL.
    """
    check_sound_level(loudest_db)
    if loudest_db is None:
        return (None,)
    return (None, *(min(float(level), SOUND_LEVELS[1]) for level in np.arange(40.0, loudest_db + 7.5, 15.0)))


ROOM = sound_levels(90.0)
"""Levels among which the sound of a room is looked for, dB SPL; None is quiet."""


@dataclass(frozen=True, eq=False)
class Surroundings:
    """Noise and sound that a decoder assumes."""

    microphone_noise: NoiseChoice
    """Noise as it was given: white, Pa rms over 0 to 500 Hz, or "design"."""
    noise: float | NoiseSpectrum
    """Noise of a microphone: white, Pa rms, or a spectrum."""
    ambient: tuple[float | None, ...]
    """Levels of the sound around from quiet to loud, dB SPL; None is quiet."""

    @classmethod
    def of(cls, response: ArrayResponse, microphone_noise: NoiseChoice, ambient: Ambient = None) -> Surroundings:
        """Surroundings of an array; warns of a library that ends below the frequencies that touches reach.

        Raises:
            Refusal: no level, a level or noise out of range, or sound around an array without a design.
        """
        check_noise(microphone_noise)
        warn_of_uncovered(response)
        levels = tuple(ambient) if isinstance(ambient, (list, tuple)) else (ambient,)
        if not levels:
            raise Refusal(kind=Kind.MISSING, field="ambient", allowed="one or more levels, dB SPL, or None for quiet")
        for level in levels:
            check_level(response, level)
        ordered = sorted(set(levels), key=lambda level: -1.0 if level is None else level)
        return cls(microphone_noise, response.noise(microphone_noise), tuple(ordered))

    @property
    def noise_rms(self) -> float:
        """Noise of a microphone, Pa rms over 0 to 500 Hz."""
        return self.noise.rms if isinstance(self.noise, NoiseSpectrum) else self.noise
