"""The thermal and viscous means of closed forms on batches: the same code for NumPy arrays and torch tensors.

Everything depends on real numbers only: t = w R^2 / diffusivity (the square of a shear number) and an aspect
ratio. So the loops below run in real arithmetic, and torch gets its derivatives from closed formulas
(:mod:`acoustic_fem.batch.torch_means`), not from the graph of a loop.
"""

from __future__ import annotations

from math import factorial

import numpy as np

from acoustic_fem.batch.numpy_or_torch import largest
from acoustic_fem.batch.series import ball_mean_values, cylinder_mean_values
from geometry.ground.typed import NumpyOrTorch


def ball_mean(order: float, t: NumpyOrTorch) -> NumpyOrTorch:
    """Mean <Psi> of a disc (order 0) or a ball (order 1/2) of radius R: I_{order+2}(x) / I_{order}(x), x^2 = j t.

    Equal to -J2/J0 of the duct formulas; no cancellation at small t. Continued fraction of Gauss,
    I_{n+1}/(x I_n) = 1 / (2 (n+1) + x^2 I_{n+2}/(x I_{n+1})), to rounding error for t up to 4e4 (measured).

    Args:
        order: 0 or 0.5.
        t: w R^2 / diffusivity, above 0, any shape, float64.

    Returns:
        Shape of t, complex128.
    """
    if isinstance(t, np.ndarray):
        return ball_mean_values(order, t)
    from acoustic_fem.batch.torch_means import BallMean

    return BallMean.apply(order, t)


def cylinder_mean(t: NumpyOrTorch, aspect: NumpyOrTorch) -> NumpyOrTorch:
    """Mean <Psi> of a closed cylinder of radius R and height H with isothermal walls.

    Sum over the zeros l of J0 of 4/l^2 s/q^2 (1 - tanh(q h)/(q h)), q^2 = l^2 + s, s = j t, h = H/(2 R)
    (:func:`acoustic_fem.cavity.closed_forms.closed_cylinder_compliance`). Once q h is so large that tanh is 1 and l is
    well past sqrt(t), the rest is summed as a power series in s. Relative error below 1e-11 for H/(2R) from 0.01 to 30
    and t up to 1e5.

    Args:
        t: w R^2 / alpha, above 0, any shape, float64.
        aspect: H/(2 R), broadcasts with t.

    Returns:
        Broadcast shape, complex128.
    """
    if isinstance(t, np.ndarray):
        return cylinder_mean_values(t, aspect, slopes=False)[0]
    from acoustic_fem.batch.torch_means import CylinderMean

    return CylinderMean.apply(t, aspect)


def hyperbolic(g: NumpyOrTorch) -> tuple[NumpyOrTorch, NumpyOrTorch]:
    """cosh(G) - 1 and sinh(G)/G as functions of g = G^2, entire, so without a root and without cancellation.

    Power series of g / 4^k, then k doublings; rounding error about 2^k 1e-16 (k = 9 at the longest and
    thinnest tube a design allows, |g| = 3e4).

    Args:
        g: complex128, any shape.

    Returns:
        Both of the shape of g, complex128.
    """
    size = largest(g)
    doublings = max(0, int(np.ceil(np.log(max(size, 1e-300) / 0.5) / np.log(4))))
    g, size = g * 0.25**doublings, size * 0.25**doublings
    terms, rest = 1, size / 12
    while rest > 1e-17:
        terms += 1
        rest *= size / ((2 * terms + 1) * (2 * terms + 2))
    # cosh - 1 = g sum of g^k/(2k+2)!, sinh/G = sum of g^k/(2k+1)!
    half, ratio = g * (1 / factorial(2 * terms)), g * (1 / factorial(2 * terms + 1))
    for k in range(terms - 1, 0, -1):
        half, ratio = (half + 1 / factorial(2 * k)) * g, (ratio + 1 / factorial(2 * k + 1)) * g
    rise, ratio = half, ratio + 1
    for _ in range(doublings):
        rise, ratio = 2 * rise * (rise + 2), ratio * (1 + rise)
    return rise, ratio
