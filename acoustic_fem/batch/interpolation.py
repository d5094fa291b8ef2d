"""The means of closed forms at many sizes and the same few frequencies: interpolated between exact values.

At a fixed frequency <Psi> is a smooth function of the logarithms of the sizes: its singularities lie where
t = w R^2 / diffusivity is imaginary, pi/2 away, and where the aspect ratio has an argument of pi/4 or more. So on
a tile of the logarithms a Chebyshev series of n terms errs by rho^-n, rho = r + sqrt(1 + r^2), r that distance
per half width of the tile (Trefethen, Approximation Theory and Approximation Practice (2013), theorem 8.2). All
frequencies share the polynomials, which makes the means of a tile one product of real matrices. Tiles are fixed:
what a size gives does not depend on the rest of the batch, but for tiles with too few sizes to be worth it.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from acoustic_fem.batch.means import ball_mean, cylinder_mean
from acoustic_fem.batch.numpy_or_torch import namespace
from geometry.ground.typed import Array, ComplexArray, NumpyOrTorch


@dataclass(frozen=True)
class _Mean:
    """A mean of t = scale w and further sizes."""

    exact: Callable[..., NumpyOrTorch]
    """The mean as a function of t and the further sizes."""
    width: tuple[float, ...]
    """Width of a tile per size, in logarithms."""
    terms: tuple[int, ...]
    """Terms of the Chebyshev series per size."""
    fewest: int
    """Number of sizes in a tile from which on it is interpolated."""


def _disc(t: NumpyOrTorch) -> NumpyOrTorch:
    return ball_mean(0, t)


#: Singular values of the normalised coefficients below this part of the largest are rounding errors.
_RANK = 1e-15


def _sphere(t: NumpyOrTorch) -> NumpyOrTorch:
    return ball_mean(0.5, t)


# Relative errors on a tile, measured: 8e-15 and 7e-14. Spheres, the back volumes of microphones, are few.
_DISC = _Mean(_disc, (np.log(4),), (22,), 11)
_CYLINDER = _Mean(cylinder_mean, (np.log(2), np.log(2)), (14, 20), 140)
_SPHERE = _Mean(_sphere, (), (), 0)


def disc_means(scale: NumpyOrTorch, omega: NumpyOrTorch, blocks: int = 1) -> NumpyOrTorch:
    """Interpolated :func:`acoustic_fem.batch.means.ball_mean` of order 0 at t = scale omega.

    Args:
        scale: (n_design, n_column, 1) float64, R^2 / diffusivity, s.
        omega: (n_freq,) float64, rad/s.
        blocks: number of calls that are alike, one after the other: the more, the sooner interpolation is worth it. 0:
            nothing is interpolated, and every size has what it has alone, to the last bit; NumPy only.

    Returns:
        (n_design, n_column, n_freq) complex128.
    """
    return _means(_DISC, [scale], omega, blocks)


def cylinder_means(scale: NumpyOrTorch, aspect: NumpyOrTorch, omega: NumpyOrTorch, blocks: int = 1) -> NumpyOrTorch:
    """Interpolated :func:`acoustic_fem.batch.means.cylinder_mean` at t = scale omega.

    Args:
        scale: (n_design, n_column, 1) float64, R^2 / alpha, s.
        aspect: H/(2 R), float64, broadcasts with scale.
        omega: (n_freq,) float64, rad/s.
        blocks: number of calls that are alike, one after the other: the more, the sooner interpolation is worth it. 0:
            nothing is interpolated, and every size has what it has alone, to the last bit; NumPy only.

    Returns:
        (n_design, n_column, n_freq) complex128.
    """
    return _means(_CYLINDER, [scale, aspect], omega, blocks)


def sphere_means(scale: NumpyOrTorch, omega: NumpyOrTorch, blocks: int = 1) -> NumpyOrTorch:
    """Means :func:`acoustic_fem.batch.means.ball_mean` of order 1/2 at t = scale omega, never interpolated.

    Args:
        scale: (n_design, n_column, 1) float64, R^2 / alpha, s.
        omega: (n_freq,) float64, rad/s.
        blocks: 0 if every size must have what it has alone, as :func:`disc_means`.

    Returns:
        (n_design, n_column, n_freq) complex128.
    """
    return _means(_SPHERE, [scale], omega, blocks) if blocks == 0 else _sphere(scale * omega)


def _means(mean: _Mean, sizes: Sequence[NumpyOrTorch], omega: NumpyOrTorch, blocks: int) -> NumpyOrTorch:
    xp = namespace(omega)
    shape = np.broadcast_shapes(*(tuple(size.shape) for size in sizes))
    flat = [xp.broadcast_to(size, shape).reshape(-1) for size in sizes]
    if blocks == 0:
        grid = omega.tobytes()
        alone = [_alone(mean, tuple(map(float, each)), grid) for each in zip(*flat, strict=True)]
        return np.stack(alone).reshape((*shape[:-1], len(omega)))
    places = [xp.log(size) / width for size, width in zip(flat, mean.width, strict=True)]
    tiles = [np.floor(_numbers(place)).astype(np.int64) for place in places]
    code = sum(tile << (16 * axis) for axis, tile in enumerate(tiles))
    _, first, of_tile, counts = np.unique(code, return_index=True, return_inverse=True, return_counts=True)
    enough = counts * blocks >= mean.fewest
    pieces, rows = [], []
    few = np.flatnonzero(~enough[of_tile])
    if few.size:
        chosen = [_chosen(size, few)[:, None] for size in flat]
        pieces.append(mean.exact(chosen[0] * omega, *(xp.broadcast_to(s, (len(few), 1)) for s in chosen[1:])))
        rows.append(few)
    grid = _numbers(omega).tobytes()
    for number in np.flatnonzero(enough):
        inside = np.flatnonzero(of_tile == number)
        tile = tuple(int(axis[first[number]]) for axis in tiles)
        weights: Any = None
        for place, low, terms in zip(places, tile, mean.terms, strict=True):
            basis = _chebyshev(2 * (_chosen(place, inside) - low) - 1, terms)
            weights = basis if weights is None else (weights[:, :, None] * basis[:, None]).reshape(len(inside), -1)
        for matrix in _series(mean, tile, grid):
            weights = weights @ (matrix if xp is np else xp.from_numpy(matrix).to(weights.device))
        pieces.append(weights.view(np.complex128) if xp is np else xp.view_as_complex(weights.unflatten(1, (-1, 2))))
        rows.append(inside)
    values = pieces[0] if len(pieces) == 1 else _put_back(pieces, rows)
    return values.reshape((*shape[:-1], omega.shape[0]))


@lru_cache(maxsize=64)  # cavities and sound holes are often those of the design before
def _alone(mean: _Mean, sizes: tuple[float, ...], grid: bytes) -> ComplexArray:
    """Exact mean of one size, (n_freq,) complex128."""
    omega: Array = np.frombuffer(grid)
    values: ComplexArray = mean.exact(sizes[0] * omega, *(np.array([size]) for size in sizes[1:]))
    values.flags.writeable = False
    return values


def _put_back(pieces: Sequence[NumpyOrTorch], rows: Sequence[NDArray[np.int64]]) -> NumpyOrTorch:
    """One array of the pieces, each at its rows."""
    xp = namespace(pieces[0])
    if xp is not np:
        return xp.concatenate(pieces, 0)[np.argsort(np.concatenate(rows))]
    values = np.empty((sum(map(len, rows)), pieces[0].shape[1]), dtype=np.complex128)
    for piece, places in zip(pieces, rows, strict=True):
        values[places] = piece
    return values


@lru_cache(maxsize=48)
def _series(mean: _Mean, tile: tuple[int, ...], grid: bytes) -> tuple[Array, ...]:
    """Chebyshev coefficients on a tile: (product of terms, 2 n_freq), real and imaginary parts in turn.

    As a product of two matrices of the numerical rank where that is less work.
    """
    omega: Array = np.frombuffer(grid)
    nodes = [np.cos(np.pi * (np.arange(terms) + 0.5) / terms) for terms in mean.terms]
    sizes = [np.exp(w * (low + (x + 1) / 2)) for x, low, w in zip(nodes, tile, mean.width, strict=True)]
    every = [size.reshape(-1, 1) for size in np.meshgrid(*sizes, indexing="ij")]
    values = mean.exact(every[0] * omega, *every[1:]).reshape(*mean.terms, len(omega))
    for axis, (x, terms) in enumerate(zip(nodes, mean.terms, strict=True)):
        # discrete orthogonality of the polynomials at their roots
        transform = _chebyshev(x, terms).T * (2 / terms)
        transform[0] /= 2
        values = np.moveaxis(np.tensordot(transform, values, (1, axis)), 0, axis)
    series: Array = np.ascontiguousarray(values.reshape(-1, len(omega))).view(np.float64)
    size = np.abs(series).max(0)  # each part of each frequency keeps its digits
    left, singular, right = np.linalg.svd(series / size, full_matrices=False)
    rank = int(np.count_nonzero(singular > _RANK * singular[0]))
    if rank * sum(series.shape) >= series.size:
        return (series,)
    return np.ascontiguousarray(left[:, :rank] * singular[:rank]), right[:rank] * size


def _chebyshev(x: NumpyOrTorch, terms: int) -> NumpyOrTorch:
    """(n, terms) polynomials of x, (n,)."""
    polynomials = [x * 0 + 1, x]
    for _ in range(terms - 2):
        polynomials.append(2 * x * polynomials[-1] - polynomials[-2])
    return namespace(x).stack(polynomials, 1)


def _chosen(values: NumpyOrTorch, rows: NDArray[np.int64]) -> NumpyOrTorch:
    return values if len(rows) == values.shape[0] else values[rows]


def _numbers(values: NumpyOrTorch) -> Array:
    """The values as a NumPy array, outside any graph of torch."""
    array: Array = values if isinstance(values, np.ndarray) else values.detach().cpu().numpy()
    return array
