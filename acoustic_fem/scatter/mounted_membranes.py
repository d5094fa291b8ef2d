"""Membranes whose strain and glue scatter: their stiffness from a few solutions of the mounted disc."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from acoustic_fem.membrane.design_discs import design_mounting_ratio
from acoustic_fem.quantities.units import metres
from geometry.design.array_design import ArrayDesign
from geometry.ground.typed import Array

#: Solutions between which the logarithm of a compliance is a polynomial.
_NODES = 5


class MountedMembranes:
    """Stiffness of the membranes of a design, all points of which are alike, for strains and glues that are drawn.

    Their effects on the logarithm of the compliance are added.

    Args:
        design: the nominal array.
        prestrain: largest deviation of the strain, a ratio; 0 if it does not scatter.
        glue_thickness: largest deviation of the thickness of the glue, m; 0 if it does not scatter.

    Raises:
        Refusal: a strain within that deviation at which a membrane all but buckles.
    """

    def __init__(self, design: ArrayDesign, prestrain: float, glue_thickness: float) -> None:
        thinner = min(glue_thickness, metres(design.membrane.glue_thickness))
        self._by_strain = _law(-prestrain, prestrain, lambda each: design_mounting_ratio(design, prestrain=each))
        self._by_glue = _law(-thinner, glue_thickness, lambda each: design_mounting_ratio(design, glue_thickness=each))

    def stiffness(self, prestrain: Array | float, glue_thickness: Array | float) -> Array | float:
        """Stiffness by that of the nominal membrane, a ratio.

        Args:
            prestrain: deviation of the strain, (count, n_point) float64, ratios.
            glue_thickness: deviation of the thickness of the glue, (count, n_point) float64, m.
        """
        return np.exp(-self._by_strain(prestrain) - self._by_glue(glue_thickness))


def _law(low: float, high: float, ratio: Callable[[float], float]) -> Callable[[Array | float], Array | float]:
    """Logarithm of the compliance by the nominal one, at deviations that are drawn."""
    if high == low:
        return lambda deviation: 0.0
    place = np.cos(np.pi * (np.arange(_NODES) + 0.5) / _NODES)
    values = np.log([ratio((low + high) / 2 + (high - low) / 2 * float(x)) for x in place])
    fit = np.polynomial.Chebyshev.fit(place, values, _NODES - 1, domain=[-1, 1])
    nominal = fit(-(low + high) / (high - low))
    return lambda deviation: fit((2 * np.clip(deviation, low, high) - low - high) / (high - low)) - nominal
