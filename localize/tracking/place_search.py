"""Likeliest place of a contact, searched from many starting places.

The likelihood of a loud tap is a curved ridge, a thousandth of a pitch wide and tenths of one long, and no grid meets
it. So noise is first taken to be a thousandth of the frame's level, where the ridge is wide, and less from stage to
stage; in each every place follows the slope (Levenberg 1944, Marquardt 1963), and the best go on. In the end places
along the ridge are tried. If the library does not match the sensor, the residual of the best place is taken as the
noise. Samples of that residual are not independent as those of noise are, so the uncertainty of the place grows by the
same factor once more.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from geometry.ground.typed import Array
from localize.tracking.place_likelihood import PlaceLikelihood


@dataclass(frozen=True)
class _Candidate:
    """A place that may be the likeliest."""

    place: Array
    score: float
    covariance: Array


def found_place(likelihood: PlaceLikelihood, x: Array, start: Array, wide: Array) -> tuple[Array, Array]:
    """Most likely place and its covariance.

    Args:
        likelihood: of places.
        x: white frames of one contact, (n_frame, size).
        start: places to start from, (n, 2) mm.
        wide: covariances of those that stand for all places of one footprint, (n, 2, 2) mm^2; else not a number.

    Returns:
        Place, (2,) mm, and covariance about it, (2, 2) mm^2.
    """
    search, options = _Search(likelihood, x), likelihood.options
    loudness = np.sqrt((x**2).mean(1))
    scale = np.maximum(1.0, options.first_noise * loudness)
    still = ~np.isnan(wide).any((1, 2))
    moving = start[~still]
    stages = 1 + int(np.ceil(np.log(scale.max()) / np.log(options.noise_ratio) - 1e-9))
    for stage in range(stages if len(moving) else 0):
        last = stage == stages - 1
        now = np.maximum(1.0, scale / options.noise_ratio**stage)
        each = [search.climbed(place, now, options.last_steps if last else options.steps) for place in moving]
        best = search.distinct(each)[: options.kept_places[min(stage, len(options.kept_places) - 1)]]
        moving = np.array([one.place for one in best])
    none = np.ones(len(x))
    ends = [search.climbed(place, none, 0) for place in moving]
    if ends:
        ends.append(search.along_ridge(max(ends, key=lambda one: one.score)))
    shared = [search.still(*each, none) for each in zip(start[still], wide[still], strict=True)]
    top = max([*ends, *shared], key=lambda one: one.score)
    noise = likelihood.noise_scale(top.place, x)
    final = [search.climbed(one.place, noise, options.steps) for one in ends]
    final += [search.still(one.place, one.covariance, noise) for one in shared]
    place, covariance = _mixed(search.distinct(final))
    return place, _widened(covariance, float(noise.max()), likelihood.pitch)


def _widened(covariance: Array, misfit: float, pitch: float) -> Array:
    """Covariance (2, 2) mm^2 where so many times the noise is left: deviations are as many times as large, up to a
    pitch.
    """
    size, axes = np.linalg.eigh(covariance)
    size = np.maximum(size, np.minimum(misfit**2 * size, pitch**2))
    return np.asarray((axes * size) @ axes.T)


class _Search:
    """Steps towards more likely places."""

    def __init__(self, likelihood: PlaceLikelihood, x: Array) -> None:
        self._likelihood, self._x, self._pitch = likelihood, x, likelihood.pitch
        self._options = likelihood.options

    def climbed(self, place: Array, noise: Array, steps: int) -> _Candidate:
        """Place to which the slope leads from a place, with so many times the noise in each frame, (n_frame,)."""
        x = self._x / noise[:, None]
        _, power = self._likelihood.likeliest(place, x)
        now = self._likelihood.slope(place, x, power)
        assert now is not None  # places to start from reach a membrane
        damping = 1e-3
        for _ in range(steps):
            diagonal = np.diag(now.information)
            damped = now.information + np.diag(damping * np.maximum(diagonal, 1e-9 * diagonal.max()) + 1e-9)
            step = np.linalg.solve(damped, now.gradient)
            length = float(np.linalg.norm(step))
            step *= min(1.0, self._options.longest_step * self._pitch / max(length, 1e-300))
            after = self._likelihood.slope(place + step, x, power)
            if after is None or after.value <= now.value:
                damping = max(10 * damping, 1e-2)
                if length < 1e-5 * self._pitch or damping > 1e5:
                    break
                continue
            gained = after.value - now.value
            place, now, damping = place + step, after, max(damping / 10, 1e-6)
            if gained < 0.01:
                break
        # Of a place no more is unknown than a pitch.
        size, axes = np.linalg.eigh(now.information)
        covariance = (axes / np.maximum(size, self._pitch**-2)) @ axes.T
        return _Candidate(place, self._likelihood.likeliest(place, x)[0], covariance)

    def still(self, place: Array, covariance: Array, noise: Array) -> _Candidate:
        """A place that stands for all of one footprint."""
        scaled = self._x / noise[:, None]
        return _Candidate(place, self._likelihood.likeliest(place, scaled)[0], covariance)

    def distinct(self, found: list[_Candidate]) -> list[_Candidate]:
        """The best first, without those that are nearly the same."""
        kept: list[_Candidate] = []
        for one in sorted(found, key=lambda one: -one.score):
            if all(np.linalg.norm(one.place - other.place) > self._options.same_place * self._pitch for other in kept):
                kept.append(one)
        return kept

    def along_ridge(self, best: _Candidate) -> _Candidate:
        """The best place on the ridge that a maximum lies on."""
        told = np.ones(len(self._x))
        for _ in range(self._options.ridge_rounds):
            way = np.linalg.eigh(best.covariance)[1][:, 1]
            found = [best]
            for far in self._options.along_ridge:
                place = best.place + far * self._pitch * way
                if not self._likelihood.reaches(place):
                    continue
                back = self.climbed(place, self._options.wider_noise * told, self._options.steps)
                found.append(self.climbed(back.place, told, self._options.last_steps))
            better = max(found, key=lambda one: one.score)
            if better.score < best.score + 0.5:
                return better
            best = better
        return best


def _mixed(found: list[_Candidate]) -> tuple[Array, Array]:
    """The most likely place, and the covariance about it of a mixture of normal distributions."""
    best = max(found, key=lambda each: each.score)
    covariance, total = np.zeros((2, 2)), 0.0
    for each in found:
        away = each.place - best.place
        weight = float(np.exp(each.score - best.score) * np.sqrt(np.linalg.det(each.covariance)))
        covariance += weight * (each.covariance + np.outer(away, away))
        total += weight
    return best.place, covariance / total
