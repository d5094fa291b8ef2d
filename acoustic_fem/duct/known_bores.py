"""Round bores that were worked out before: an array has many tubes and cells, and few bores that differ."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from acoustic_fem.duct.plane_wave import port_admittance, series_impedance, shunt_admittance, two_port
from acoustic_fem.quantities.medium import Medium

#: Longer grids are worked out anew: what is kept stays below 10 MB.
_LONGEST_GRID = 1024


def known_port_admittance(
    radius: float, length: float, frequency: NDArray[np.float64], medium: Medium
) -> NDArray[np.complex128]:
    """What :func:`acoustic_fem.duct.plane_wave.port_admittance` gives for one duct, from memory where it is there.

    Args:
        radius: of the bore, m.
        length: of the duct, m.
        frequency: (n_freq,) Hz.
        medium: the gas.

    Returns:
        (n_freq, 2, 2) complex128, m^3/(Pa s), not to be written to.

    Raises:
        Refusal: as there.
    """
    if frequency.size > _LONGEST_GRID:
        return port_admittance(radius, length, frequency, medium)
    return _duct(float(radius), float(length), frequency.tobytes(), medium)


@lru_cache(maxsize=64)
def _duct(radius: float, length: float, grid: bytes, medium: Medium) -> NDArray[np.complex128]:
    nodal = two_port(*_line(radius, grid, medium), length)
    nodal.flags.writeable = False
    return nodal


@lru_cache(maxsize=32)
def _line(radius: float, grid: bytes, medium: Medium) -> tuple[NDArray[np.complex128], NDArray[np.complex128]]:
    """Series impedance and shunt admittance per length."""
    frequency = np.frombuffer(grid)
    return series_impedance(radius, frequency, medium), shunt_admittance(radius, frequency, medium)
