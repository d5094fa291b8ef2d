"""Eight ridged profiles under a point that slides over them: what their ridges do to the pressure in its cavity.

A profile is a train of ridges of a period, a duty and a height. A contact of radius a feels its heights averaged by
the Hertz pressure, whose transform over a ridge's wave number k is 3 (sin z - z cos z) / z^3, z = k a (Johnson 1985,
Contact Mechanics, 3.4); its force goes with the 3/2 power of the indentation, and ends where it loses touch.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from geometry.ground.argument_checks import check_range
from geometry.ground.typed import Array
from localize.contacts.contact import hertz_fraction
from localize.recognition.event_kinds import band_noise
from localize.recognition.letter_classifier import PAD
from localize.signals.stimulus import SAMPLE_RATE

SPEED = 12.0
"""Speed at which textures are classified, mm/s: that of the paper, 1.2 cm/s."""
RADIUS = (0.27, 0.33)
"""Smallest and largest radius of the contact, mm."""
INDENTATION = 0.2
"""Indentation by which the contact is pressed, mm."""
PADS = PAD.contact_radius_mm
"""Smallest and largest radius of a finger's pad that passes points, mm: that of one that writes."""
BESIDE = (0.0, 2.0)
"""Smallest and largest distance at which it passes their middles, mm."""
_HARMONICS = 24


@dataclass(frozen=True)
class Profile:
    """Train of ridges."""

    period: float
    """Distance from ridge to ridge, mm."""
    duty: float
    """Share of the period that is ridge."""
    height: float
    """Height of the ridges, mm."""

    @property
    def name(self) -> str:
        """Name of the profile, by which textures are classified."""
        return f"{self.period:g} mm, {100 * self.duty:.0f} %, {self.height:g} mm"


PROFILES = (
    Profile(0.5, 0.5, 0.1),
    Profile(0.75, 0.5, 0.1),
    Profile(1.0, 0.3, 0.1),
    Profile(1.0, 0.6, 0.1),
    Profile(1.4, 0.5, 0.1),
    Profile(1.4, 0.5, 0.3),
    Profile(2.0, 0.25, 0.2),
    Profile(2.0, 0.7, 0.2),
)
"""The eight profiles."""


def felt_height(profile: Profile, place: Array, contact_radius_mm: float) -> Array:
    """Height of a profile as a contact feels it, about its mean.

    Args:
        profile: the ridges.
        place: (n,) float64, where the contact's middle is, mm.
        contact_radius_mm: radius of the contact, mm.

    Returns:
        (n,) float64, mm.
    """
    harmonic = np.arange(1, _HARMONICS + 1)
    wave = 2 * np.pi * harmonic / profile.period
    z = wave * contact_radius_mm
    felt = 3 * (np.sin(z) - z * np.cos(z)) / z**3
    strength = 2 * profile.height * np.sin(np.pi * harmonic * profile.duty) / (np.pi * harmonic) * felt
    return np.asarray(strength @ np.cos(wave[:, None] * place))


def texture_pressure(
    profile: Profile, count: int, speed: float, random: np.random.Generator, blunter: float = 1.0
) -> Array:
    """Pressure in the cavity of a point that slides over a profile.

    Args:
        profile: the ridges.
        count: samples at 1 kHz.
        speed: mean speed, mm/s; it wanders by 1 %.
        random: draws the contact, its friction and its level.
        blunter: radius of the contact over that of :data:`RADIUS`.

    Returns:
        (count,) float64, Pa.

    Raises:
        Refusal: a speed that is not between 1 and 100 mm/s.
    """
    felt, _ = _felt(profile, count, speed, random, blunter)
    return np.asarray(np.exp(random.uniform(np.log(0.05), np.log(1.0))) * felt)


def texture_force(
    profile: Profile, count: int, speed: float, random: np.random.Generator, blunter: float = 1.0
) -> Array:
    """Force of a contact that slides over a profile, over its mean: that of which :func:`texture_pressure` is felt.

    At a speed in mm/s, by a finger ``blunter`` by that ratio; args and errors as there.

    Returns:
        (count,) float64, zero or above.
    """
    felt, share = _felt(profile, count, speed, random, blunter)
    return np.maximum(1 + share * felt, 0.0)


def passing_pressure(
    profile: Profile, count: int, speed: float, random: np.random.Generator, membrane: float, middle: float
) -> Array:
    """Pressure in the cavity of a point that a finger's pad passes, which slides over a profile: it comes, presses with
    what :func:`texture_force` says while it is over the membrane, and goes.

    Args:
        profile: the ridges.
        count: samples at 1 kHz.
        speed: mean speed, mm/s.
        random: draws the pad, its way past the middle of the membrane, the contact and its level.
        membrane: radius of the membrane, mm.
        middle: sample at which the pad is nearest.

    Returns:
        (count,) float64, Pa.

    Raises:
        Refusal: a speed that is not between 1 and 100 mm/s.
    """
    felt, share = _felt(profile, count, speed, random, 1.0)
    along = (np.arange(count) - middle) * speed / SAMPLE_RATE
    covered = hertz_fraction(np.hypot(along, random.uniform(*BESIDE)), random.uniform(*PADS), membrane)
    level = np.exp(random.uniform(np.log(0.05), np.log(1.0)))
    return np.asarray(level / share * covered / covered.max() * np.maximum(1 + share * felt, 0.0))


def _felt(
    profile: Profile, count: int, speed: float, random: np.random.Generator, blunter: float
) -> tuple[Array, float]:
    """Change of the force, (count,), over the rms of the part of the ridges; and that rms over the mean force."""
    check_range("speed", speed, 1.0, 100.0, "mm/s")
    wander = 1 + 0.01 * band_noise(count, 0.2, 2.0, random)
    place = np.cumsum(speed * wander) / SAMPLE_RATE + random.uniform(0.0, 10.0)
    height = felt_height(profile, place, blunter * random.uniform(*RADIUS))
    pressed = INDENTATION * random.uniform(0.85, 1.15) * (1 + 0.05 * band_noise(count, 0.3, 3.0, random))
    force = np.maximum(pressed + height, 0.0) ** 1.5
    mean = float(force.mean())
    force -= mean
    rms = max(float(force.std()), 1e-9)
    friction = random.uniform(0.05, 0.2) * band_noise(count, 5.0, 100.0, random)
    return force / rms + friction, rms / mean
