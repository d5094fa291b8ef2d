"""Values and slopes of the means of diffusion fields over balls and cylinders, from series and tails."""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache

import numpy as np
from scipy.special import binom, zeta

from acoustic_fem.batch.numpy_or_torch import joined, largest, namespace
from acoustic_fem.cavity.closed_forms import bessel_zeros
from geometry.ground.typed import Array, NumpyOrTorch

#: Powers of s kept in the tail of the cylinder's series, and how far past sqrt(|s|) it begins: 1.7^-48 = 9e-12
#: of what is a hundredth of the whole.
_TAIL_ORDERS = 24


_TAIL_START = 1.7


#: Terms with tanh(x) = 1 - 2 exp(-2 x): past this x, where terms are below 1e-3 of the whole, it is taken for 1.
_LARGEST_TANH = 11.0


#: Elements worked on at once, so that the loop stays in the processor's cache.
_BLOCK = 16384


def ball_mean_values(order: float, t: NumpyOrTorch) -> NumpyOrTorch:
    """Values of :func:`acoustic_fem.batch.means.ball_mean`, without derivatives.

    Args:
        order: 0 or 0.5.
        t: w R^2 / diffusivity, above 0, any shape, float64.

    Returns:
        Shape of t, complex128.
    """
    (mean,) = _in_blocks(lambda block, _: (_ball_mean_block(order, block),), t, t)
    return mean


def _ball_mean_block(order: float, t: NumpyOrTorch) -> NumpyOrTorch:
    depth = 4 + int(np.ceil(6.3 * largest(t) ** 0.25))
    real, imag = 1 / (2 * (order + depth + 1)) + 0 * t, 0 * t
    for level in range(depth - 1, -1, -1):
        previous = real, imag
        a, b = 2 * (order + level + 1) - t * imag, t * real
        scale = 1 / (a * a + b * b)
        real, imag = a * scale, -b * scale
    first, second = joined(real, imag), joined(-t * previous[1], t * previous[0])
    return first * second


def ball_mean_slope(order: float, t: NumpyOrTorch, mean: NumpyOrTorch) -> NumpyOrTorch:
    """Slope d <Psi> / dt, from the Riccati equation d Psi / ds = (1-Psi)^2 / (4 (n+1)) - (n+1) Psi / s at s = j t.

    Args:
        order: 0 or 0.5.
        t: above 0, any shape, float64.
        mean: <Psi> at t, shape of t, complex128.

    Returns:
        Shape of t, complex128.
    """
    return 1j * (1 - mean) ** 2 / (4 * (order + 1)) - (order + 1) * mean / t


def cylinder_mean_values(t: NumpyOrTorch, aspect: NumpyOrTorch, slopes: bool) -> tuple[NumpyOrTorch, ...]:
    """Values of :func:`acoustic_fem.batch.means.cylinder_mean` and, where asked for, its derivatives.

    Args:
        t: w R^2 / alpha, above 0, any shape, float64.
        aspect: H/(2 R), float64, broadcasts with t.
        slopes: whether the derivatives by t and by the aspect ratio are wanted.

    Returns:
        The values, and the two derivatives after them, of the broadcast shape, complex128.
    """
    return _in_blocks(lambda rate, ratio: _cylinder_block(rate, ratio, slopes), t, aspect)


def _cylinder_block(t: NumpyOrTorch, aspect: NumpyOrTorch, slopes: bool) -> tuple[NumpyOrTorch, ...]:
    reach = max(_TAIL_START * largest(t) ** 0.5, _LARGEST_TANH / float(aspect.min()))
    count = max(4, int(np.ceil(reach / np.pi + 0.25)))
    xp, twice, square_t = namespace(t), 2 * aspect, t * t
    real_sum, imag_sum, by_s, by_aspect = 0 * t, 0 * t, 0, 0
    for square in (bessel_zeros(count) ** 2).tolist():
        # q = sqrt(l^2 + j t) and tanh(q h) in real arithmetic
        squared_size = square_t + square * square  # |q|^4
        size = xp.sqrt(squared_size)
        real = xp.sqrt((size + square) * 0.5)
        imag = 0.5 * t / real
        shrink, angle = xp.exp(-twice * real), twice * imag
        below = 1 / (shrink * (2 * xp.cos(angle) + shrink) + 1)
        tanh_real, tanh_imag = (1 - shrink * shrink) * below, 2 * shrink * xp.sin(angle) * below
        scale = 1 / (aspect * size)
        rest_real = 1 - (tanh_real * real + tanh_imag * imag) * scale  # 1 - tanh(q h) / (q h)
        rest_imag = (tanh_real * imag - tanh_imag * real) * scale
        # 4/l^2 s/q^2 = left + j across
        weight = t * (4 / square) / squared_size
        left, across = weight * t, weight * square
        real_sum += left * rest_real - across * rest_imag
        imag_sum += left * rest_imag + across * rest_real
        if slopes:
            tanh, rest = joined(tanh_real, tanh_imag), joined(rest_real, rest_imag)
            change = tanh * tanh - rest  # of the rest by log h
            by_aspect = by_aspect + joined(left, across) * change
            ratio = joined(square / squared_size, -t / squared_size)
            by_s = by_s + ratio * ratio * (rest * 4 + joined(0 * t, t * (2 / square)) * change)
    value, tail_by_s, tail_by_aspect = _cylinder_tail(count, t, aspect, slopes)
    value = value + joined(real_sum, imag_sum)
    return (value, 1j * (by_s + tail_by_s), by_aspect / aspect + tail_by_aspect) if slopes else (value,)


def _in_blocks(
    function: Callable[[NumpyOrTorch, NumpyOrTorch], tuple[NumpyOrTorch, ...]], t: NumpyOrTorch, other: NumpyOrTorch
) -> tuple[NumpyOrTorch, ...]:
    """Pointwise functions of two arrays that broadcast, so many elements at once that they stay in the cache."""
    xp = namespace(t)
    shape = np.broadcast_shapes(tuple(t.shape), tuple(other.shape))
    flat = [xp.broadcast_to(array, shape).reshape(-1) for array in (t, other)]
    pieces = [function(*(array[k : k + _BLOCK] for array in flat)) for k in range(0, flat[0].shape[0], _BLOCK)]
    return tuple(xp.concatenate(parts, 0).reshape(shape) for parts in zip(*pieces, strict=True))


def _cylinder_tail(
    count: int, t: NumpyOrTorch, aspect: NumpyOrTorch, slopes: bool
) -> tuple[NumpyOrTorch, NumpyOrTorch, NumpyOrTorch]:
    """Terms past ``count``, tanh = 1: 4 s / (l^2 (l^2 + s)) - 4 s / (h l^2 (l^2 + s)^(3/2)), expanded in s = j t."""
    disc, ends = _tail_coefficients(count)
    flat, square = 1 / aspect, -t * t
    wall, caps = (_polynomial((0.0, *terms), t, square) for terms in (disc, ends))
    value = joined(wall[0] - flat * caps[0], wall[1] - flat * caps[1])
    if not slopes:
        return value, 0, 0
    rising = [tuple((k + 1) * value for k, value in enumerate(terms)) for terms in (disc, ends)]
    wall_slope, caps_slope = (_polynomial(terms, t, square) for terms in rising)
    by_s = joined(wall_slope[0] - flat * caps_slope[0], wall_slope[1] - flat * caps_slope[1])
    return value, by_s, joined(caps[0] * flat * flat, caps[1] * flat * flat)


def _polynomial(
    coefficients: tuple[float, ...], t: NumpyOrTorch, square: NumpyOrTorch
) -> tuple[NumpyOrTorch, NumpyOrTorch]:
    """Real and imaginary part of a real polynomial at j t; ``square`` is -t^2."""

    def horner(terms: tuple[float, ...]) -> NumpyOrTorch:
        result = terms[-1] * square + terms[-2]
        for term in terms[-3::-1]:
            result = result * square + term
        return result

    return horner(coefficients[::2]), t * horner(coefficients[1::2])


@lru_cache(maxsize=256)
def _tail_coefficients(count: int) -> tuple[tuple[float, ...], tuple[float, ...]]:
    orders = range(_TAIL_ORDERS)
    disc = tuple(4 * (-1.0) ** k * _inverse_powers(count, 4 + 2 * k) for k in orders)
    ends = tuple(4 * float(binom(-1.5, k)) * _inverse_powers(count, 5 + 2 * k) for k in orders)
    return disc, ends


def _inverse_powers(count: int, power: int) -> float:
    """Sum of l^-power over the zeros l of J0 past ``count``: 400 one by one, then l = b + 1/(8 b), b = pi (n - 1/4)."""
    explicit: Array = bessel_zeros(count + 400)[count:] ** -float(power)
    start = count + 400.75

    def powers(exponent: int) -> float:
        return float(zeta(exponent, start)) / np.pi**exponent

    return float(explicit[::-1].sum()) + powers(power) - power / 8 * powers(power + 2)
