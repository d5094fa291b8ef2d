"""Cubic splines of responses over frequency, whose values at -f are the conjugates of those at f."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline


def interpolated(
    values: NDArray[np.complex128], grid: NDArray[np.float64], frequency: NDArray[np.float64]
) -> NDArray[np.complex128]:
    """Values of a real system, whose response at -f is the conjugate of that at f, by a cubic spline through them.

    Few values on many frequencies take a hundredth of the time of the matrices of :func:`interpolation`.

    Args:
        values: (..., n_freq) complex128, in any unit.
        grid: (n_freq,) float64, Hz, increasing, zero or above.
        frequency: (n,) float64, Hz.

    Returns:
        (..., n) complex128, in the unit of the values.
    """
    mirrored = grid > 0
    both = np.concatenate([-grid[mirrored][::-1], grid])
    mirror = np.conj(values[..., mirrored][..., ::-1])
    return np.asarray(CubicSpline(both, np.concatenate([mirror, values], -1), axis=-1)(frequency))


def interpolated_from_zero(
    values: NDArray[np.complex128], grid: NDArray[np.float64], frequency: NDArray[np.float64], sealed: bool
) -> NDArray[np.complex128]:
    """Values by the spline of :func:`interpolated`; where an array is sealed, its value at 0 Hz counts below the grid.

    Args:
        values: (..., n_freq) complex128, Pa/Pa.
        grid: (n_freq,) float64, Hz, increasing, above zero.
        frequency: (n,) float64, Hz.
        sealed: whether all pressures are equal at 0 Hz.

    Returns:
        (..., n) complex128, Pa/Pa.
    """
    found = interpolated(values, grid, frequency)
    is_below = frequency < grid[0]
    if sealed and is_below.any():
        found[..., is_below] = interpolated(
            from_zero(values, sealed), np.concatenate([[0.0], grid]), frequency[is_below]
        )
    return found


def interpolation(
    grid: NDArray[np.float64], frequency: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Matrices of the spline of :func:`interpolated`: of real parts, which are even about 0 Hz, and of imaginary ones,
    odd.

    Args:
        grid: (n_freq,) float64, Hz, increasing, zero or above.
        frequency: (n,) float64, Hz.

    Returns:
        Two of (n, n_freq) float64: values on ``frequency`` are either times values on the grid.
    """
    # Continued to negative frequencies, where the response of a real system is the conjugate: the spline then
    # needs no end condition near 0 Hz, where the response bends most.
    unit, mirrored = np.eye(len(grid)), grid > 0
    both = np.concatenate([-grid[mirrored][::-1], grid])
    even, odd = (CubicSpline(both, np.concatenate([sign * unit[mirrored][::-1], unit]))(frequency) for sign in (1, -1))
    return even, odd


def interpolation_from_zero(
    grid: NDArray[np.float64], frequency: NDArray[np.float64], sealed: bool
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Matrices as of :func:`interpolation`, for values to which :func:`from_zero` has prepended the value at 0 Hz.

    The value at 0 Hz counts only below the grid.

    Args:
        grid: (n_freq,) float64, Hz, increasing, above zero.
        frequency: (n,) float64, Hz.
        sealed: whether the value at 0 Hz is there.

    Returns:
        Two of (n, n_freq) float64, or of (n, n_freq + 1) where an array is sealed: of real and of imaginary parts.
    """
    even, odd = interpolation(grid, frequency)
    if not sealed:
        return even, odd
    below = interpolation(np.concatenate([[0.0], grid]), frequency)
    widened = (np.pad(matrix, ((0, 0), (1, 0))) for matrix in (even, odd))
    is_below = frequency[:, None] < grid[0]
    even, odd = (np.where(is_below, low, high) for low, high in zip(below, widened, strict=True))
    return even, odd


def from_zero(transfer_function: NDArray[np.complex128], sealed: bool) -> NDArray[np.complex128]:
    """Transfer functions with the one at 0 Hz before them where it is known.

    Args:
        transfer_function: (..., n_freq) complex128, Pa/Pa.
        sealed: whether all pressures are equal at 0 Hz.

    Returns:
        (..., n_freq + 1) complex128 where the array is sealed, else the same, (..., n_freq); Pa/Pa.
    """
    if not sealed:
        return transfer_function
    return np.concatenate([np.ones_like(transfer_function[..., :1]), transfer_function], -1)
