"""Points spread evenly over a region: farthest points, then Lloyd's steps with distances by chord and normals."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from geometry.body.samples import Samples
from geometry.ground.typed import Array

#: Steps of Lloyd, how far beyond the mean of its cell a point moves, and the move in edges at which they end.
_STEPS, _BEYOND, _STILL = 120, 1.6, 0.02
#: Rounds in which near points are pushed apart, and the distance that they are pushed to, by the mean of the nearest.
_PUSHES, _WIDER = 40, 1.06
#: Rounds in which steps are made equal, to a fraction of their length; nearest other neighbours, by that length.
_ROUNDS, _EQUAL, _NEAREST = 400, 1e-3, 0.86
#: Factor on the mean move of a point, and the fraction by which it is drawn home in the first round.
_BOLD, _HOME = 1.2, 0.02


def arc_length(first: Array, first_normal: Array, second: Array, second_normal: Array) -> Array:
    """Length of the arc between places (..., 3) whose unit normals are known, mm: chord x (a / 2) / sin(a / 2)."""
    chord = np.linalg.norm(first - second, axis=-1)
    half = np.arccos(np.clip((first_normal * second_normal).sum(axis=-1), -1, 1)) / 2
    return np.asarray(chord * np.where(half > 1e-6, half / np.sin(np.maximum(half, 1e-9)), 1.0))


def arc_lengths(places: Array, normals: Array) -> Array:
    """Lengths of the arcs between all pairs of places, (n, n) float64, mm."""
    return arc_length(places[:, None], normals[:, None], places[None], normals[None])


def nearest_spacing(places: Array, normals: Array) -> Array:
    """Arc from each place to its nearest neighbour, (n,) float64, mm."""
    apart = arc_lengths(places, normals)
    np.fill_diagonal(apart, np.inf)
    return np.asarray(apart.min(axis=1))


def spread(samples: Samples, mask: NDArray[np.bool_], count: int, seed: int) -> Array:
    """Places of samples of a region, moved apart evenly; (count, 3) float64, mm.

    Args:
        samples: of the body.
        mask: samples where points may be, at least ``count``.
        count: number of points.
        seed: of the first place.
    """
    places, normals, areas = samples.places[mask], samples.normals[mask], samples.areas[mask]
    start = int(np.random.default_rng(seed).integers(len(places)))
    apart = np.linalg.norm(places - places[start], axis=1)
    chosen = [int(np.argmax(apart))]
    apart = np.linalg.norm(places - places[chosen[0]], axis=1)
    while len(chosen) < count:
        chosen.append(int(np.argmax(apart)))
        apart = np.minimum(apart, np.linalg.norm(places - places[chosen[-1]], axis=1))
    points, own_normals = places[chosen], normals[chosen]
    tree, near = cKDTree(places), min(8, count)
    for _ in range(_STEPS):
        candidates = cKDTree(points).query(places, k=near)[1].reshape(len(places), -1)
        arcs = arc_length(places[:, None], normals[:, None], points[candidates], own_normals[candidates])
        cell = candidates[np.arange(len(places)), arcs.argmin(axis=1)]
        total = np.bincount(cell, areas, count)
        mean = np.stack([np.bincount(cell, areas * places[:, k], count) for k in range(3)], axis=1)
        mean = np.where(total[:, None] > 0, mean / np.maximum(total, 1e-12)[:, None], points)
        step = mean - points
        step -= np.einsum("nc,nc->n", step, own_normals)[:, None] * own_normals
        moved, _ = samples.projected(points + _BEYOND * step)
        # Points stay within the region, between its samples.
        off, nearest = map(np.asarray, tree.query(moved))
        moved = np.where((off > samples.edge)[:, None], places[nearest], moved)
        change = float(np.linalg.norm(moved - points, axis=1).max())
        points, own_normals = moved, normals[nearest]
        if change < _STILL * samples.edge:
            break
    return points


def relaxed(samples: Samples, mask: NDArray[np.bool_], points: Array) -> Array:
    """Points pushed apart where they are nearer than the usual neighbours; (n, 3) float64, mm.

    Args:
        samples: of the body.
        mask: samples where points may be.
        points: (n, 3) float64, mm.
    """
    allowed = samples.places[mask]
    tree = cKDTree(allowed)
    best, evenness = points, np.inf
    for round_ in range(_PUSHES):
        at, normals = samples.projected(points)
        apart = arc_lengths(at, normals)
        np.fill_diagonal(apart, np.inf)
        nearest = apart.min(axis=1)
        scatter = float(nearest.std() / nearest.mean())
        if scatter < evenness:
            best, evenness = points, scatter
        wanted = _WIDER * float(nearest.mean())
        lack = np.maximum(wanted - apart, 0.0)
        way = at[:, None] - at[None]
        way /= np.maximum(np.linalg.norm(way, axis=2, keepdims=True), 1e-9)
        step = 0.4 * (lack[:, :, None] * way).sum(axis=1) * (1 - round_ / _PUSHES)
        step -= np.einsum("nc,nc->n", step, normals)[:, None] * normals
        points = samples.projected(at + step)[0]
        off, near = map(np.asarray, tree.query(points))
        points = np.where((off > 0.7 * samples.edge)[:, None], allowed[near], points)
    return best


def equalised(
    samples: Samples, mask: NDArray[np.bool_], points: Array, steps: Sequence[tuple[int, int]], least: float
) -> Array:
    """Points moved along the surface until all steps of lines are of one length; (n, 3) float64, mm.

    The length is the median of the steps. In each round, every step and every pair that is too near moves its points by
    half of what is wrong, and a pull that fades draws each point back to where it was.

    Args:
        samples: of the body.
        mask: samples where points may be.
        points: (n, 3) float64, mm.
        steps: pairs of points that follow each other on a line.
        least: smallest distance of neighbours, mm.
    """
    allowed = samples.places[mask]
    tree, joined = cKDTree(allowed), {tuple(sorted(step)) for step in steps}
    first, second = np.array(steps).T
    at, normals = samples.projected(points)
    length = max(float(np.median(arc_length(at[first], normals[first], at[second], normals[second]))), least)
    apart = max(least, _NEAREST * length)
    home = at
    for round_ in range(_ROUNDS):
        near = [pair for pair in cKDTree(at).query_pairs(apart) if pair not in joined]
        i = np.concatenate([first, [a for a, _ in near]]).astype(np.int64)
        j = np.concatenate([second, [b for _, b in near]]).astype(np.int64)
        wrong = arc_length(at[i], normals[i], at[j], normals[j]) - np.repeat([length, apart], [len(first), len(near)])
        wrong[len(first) :] = np.minimum(wrong[len(first) :], 0.0)
        if np.abs(wrong).max() < _EQUAL * length:
            break
        way = at[j] - at[i]
        way *= (0.5 * wrong / np.maximum(np.linalg.norm(way, axis=1), 1e-9))[:, None]
        move, count = np.zeros_like(at), np.bincount(np.concatenate([i, j]), minlength=len(at))
        np.add.at(move, i, way)
        np.add.at(move, j, -way)
        move = _BOLD * move / np.maximum(count, 1)[:, None] + _HOME * (1 - round_ / _ROUNDS) * (home - at)
        move -= np.einsum("nc,nc->n", move, normals)[:, None] * normals
        moved = samples.projected(at + move)[0]
        # Points slide along the edge of the region.
        off, nearest = map(np.asarray, tree.query(moved))
        within = np.minimum(samples.edge / np.maximum(off, 1e-9), 1.0)[:, None]
        at, normals = samples.projected(allowed[nearest] + within * (moved - allowed[nearest]))
    return at
