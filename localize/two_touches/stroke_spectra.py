"""Spectra of strokes: how a finger moves a membrane over time, in closed form.

A stroke rises as sin^2, is held, and falls as sin^2. A Gaussian smooths its edges, so that a stroke without edges of
its own is a Gaussian. Its derivative consists of two half sines, so its spectrum has a closed form:

    S(w) = (E(w rise) exp(-j w t) - E(w fall) exp(-j w (t + rise / 2 + hold + fall / 2))) exp(-(w blur)^2 / 2) / (j w),

in which t is the time of half the rise and E(x) = cos(x / 2) / (1 - (x / pi)^2) the spectrum of a half sine of area
one.
"""

from __future__ import annotations

import numpy as np

from geometry.ground.typed import Array, ComplexArray

PARAMETERS = ("middle", "rise", "hold", "fall", "blur")
"""Parameters of a stroke in their order: the time of half the rise, s, and the natural logarithms of the times, s, of
the rise, the hold, the fall and the standard deviation of the smoothing."""


def stroke_spectra(strokes: Array, frequency: Array) -> tuple[ComplexArray, ComplexArray]:
    """Spectra of strokes of height one, and their derivatives.

    Args:
        strokes: (..., 5) float64, :data:`PARAMETERS` of each.
        frequency: (n_freq,) float64, Hz, above 0.

    Returns:
        (..., n_freq) complex128, s, and (..., 5, n_freq) complex128, their derivatives by the parameters.
    """
    turn = 2 * np.pi * frequency
    middle = strokes[..., :1]
    rise, hold, fall, blur = (np.exp(strokes[..., k : k + 1]) for k in range(1, 5))
    up, up_slope = _edge(turn * rise)
    down, down_slope = _edge(turn * fall)
    smooth = np.exp(-0.5 * (turn * blur) ** 2) / (1j * turn)
    begin = smooth * np.exp(-1j * turn * middle)
    end = smooth * np.exp(-1j * turn * (middle + rise / 2 + hold + fall / 2))
    rising, falling = up * begin, down * end
    spectrum = rising - falling
    later = 1j * turn * falling
    derivatives = (
        -1j * turn * spectrum,
        turn * rise * up_slope * begin + later * rise / 2,
        later * hold,
        -turn * fall * down_slope * end + later * fall / 2,
        -((turn * blur) ** 2) * spectrum,
    )
    return spectrum, np.stack(derivatives, axis=-2)


def _edge(angle: Array) -> tuple[Array, Array]:
    """Spectrum of a half sine of area one at angular frequency times length, and its derivative."""
    beyond = angle / np.pi - 1
    half = beyond / 2
    sinc = np.sinc(half)
    near = np.abs(half) < 1e-4
    safe = np.where(near, 1.0, half)
    slope = np.where(near, -(np.pi**2) * half / 3, (np.cos(np.pi * half) - sinc) / safe)
    value = np.pi / 2 * sinc / (2 + beyond)
    return value, (np.pi / 2 * slope / 2 - value) / (2 + beyond) / np.pi
