"""Presses by spheres of any radius, from spheres that were solved: for many fingers of random size.

A sphere takes some seconds to solve. Solved ones have the radii a r^k, with the radius a of the opening, the ratio r
and whole numbers k, so all membranes of one shape share them. Between two of them the logarithm of the volume is linear
in the logarithm of the radius.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from acoustic_fem.membrane.large_deflection import SPHERES, MountedMembrane, PressCurve, Sphere, press_curve
from geometry.ground.argument_checks import check_range, real_numbers
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array

RATIO = 1.25
"""Ratio of the radii of neighbouring solved spheres."""


class SpherePresses:
    """Volume displaced by rigid spheres as a function of force and radius; spheres are solved when first needed.

    Args:
        membrane: the mounted membrane.
    """

    def __init__(self, membrane: MountedMembrane) -> None:
        self.membrane = membrane
        self._curves: dict[int, PressCurve] = {}

    def volume(self, force: ArrayLike, radius: ArrayLike) -> Array:
        """Volume displaced into the cavity.

        Args:
            force: any shape, from 0, N.
            radius: of the sphere, any shape that is broadcast with the force, 0.1 to 50 radii of the opening, m.

        Returns:
            Broadcast shape, float64, m^3; within 1 % of :func:`acoustic_fem.membrane.press`, and monotone in the force.

        Raises:
            Refusal: a radius out of range, or a force that one of the two next spheres does not cover.
        """
        return self._between(force, radius)[0]

    def volume_per_force(self, force: ArrayLike, radius: ArrayLike) -> Array:
        """Volume that a small further force displaces, dV/dF, the derivative of :meth:`volume` in the force.

        Args:
            force: any shape, from 0, N.
            radius: of the sphere, any shape that is broadcast with the force, m.

        Raises:
            Refusal: as for :meth:`volume`.

        Returns:
            Broadcast shape, float64, m^3/N.
        """
        return self._between(force, radius)[1]

    def _between(self, force: ArrayLike, radius: ArrayLike) -> tuple[Array, Array]:
        try:
            forces, radii = np.broadcast_arrays(real_numbers("force", force), real_numbers("radius", radius))
        except ValueError:
            raise Refusal(
                f"has shape {np.shape(radius)}, which does not fit that of force, {np.shape(force)}",
                kind=Kind.MISMATCH,
                field="radius",
            ) from None
        volume, slope = np.zeros(forces.shape), np.zeros(forces.shape)
        if forces.size == 0:
            return volume, slope
        low, high = (bound * self.membrane.radius for bound in SPHERES)
        for each in (radii.min(), radii.max()):
            check_range("radius", float(each), low, high, "m")
        place = np.log(radii / self.membrane.radius) / math.log(RATIO)
        below = np.clip(np.floor(place), *_bounds()).astype(np.int64)
        for number in np.unique(below):
            here = below == number
            own, next_own = (self._curve(int(number) + k).response(forces[here]) for k in (0, 1))
            weight = place[here] - number
            pressed = forces[here] > 0
            lower = np.where(pressed, own.volume, own.volume_per_force)
            upper = np.where(pressed, next_own.volume, next_own.volume_per_force)
            found = lower ** (1 - weight) * upper**weight
            rate = (1 - weight) * own.volume_per_force / lower + weight * next_own.volume_per_force / upper
            volume[here] = np.where(pressed, found, 0.0)
            slope[here] = found * rate
        return volume, slope

    def _curve(self, number: int) -> PressCurve:
        if number not in self._curves:
            radius = self.membrane.radius * RATIO**number
            self._curves[number] = press_curve(self.membrane, Sphere(radius))
        return self._curves[number]


def _bounds() -> tuple[int, int]:
    """Numbers of the first and the last but one sphere that can be solved."""
    first, last = (math.log(bound) / math.log(RATIO) for bound in SPHERES)
    return math.ceil(first), math.floor(last) - 1
