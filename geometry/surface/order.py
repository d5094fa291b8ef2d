"""Order of points along lines that follow each other from microphone to microphone: short steps that do not cross."""

from __future__ import annotations

import math
import random
from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from geometry.ground.typed import Array

#: Power of a step by the usual one: a step of two counts as eight.
_POWER = 3.0
#: Tries per point, and the temperatures between which they cool.
_TRIES, _HOT, _COLD = 3000, 2.0, 0.02
#: Neighbours of a point to which it may be joined.
_NEAR = 8


class Order:
    """Search for the order of points; costs of steps may be raised between searches."""

    def __init__(self, apart: Array, ends: Array, counts: Sequence[int], spacing: float) -> None:
        """Keep the costs.

        Args:
            apart: distances of all pairs of points, (n, n) float64, mm.
            ends: distance of each point from each microphone beyond the reach of its tube, (lines + 1, n), mm.
            counts: points of each line.
            spacing: usual distance of neighbours, mm.
        """
        self.cost = np.minimum(apart / spacing, 6.0) ** _POWER
        self.ends = 2.0 * (ends / spacing) ** 2
        self.stops = np.cumsum([0, *counts]).tolist()
        near = apart + np.diag(np.full(len(apart), np.inf))
        self.near = np.argsort(near, axis=1, kind="stable")[:, : min(_NEAR, len(apart) - 1)].tolist()

    def dearer(self, pairs: Sequence[tuple[int, int]], factor: float) -> None:
        """Raise the cost of steps between pairs of points."""
        for a, b in pairs:
            self.cost[a, b] = self.cost[b, a] = self.cost[a, b] * factor + 1.0

    def farther(self, microphone: int, point: int) -> None:
        """Raise the cost of a point at the end of a line, by the number of its microphone along the lines."""
        self.ends[microphone, point] += 1.0 + self.ends[microphone].min()

    def found(self, seed: int) -> list[int]:
        """Points in the order of the lines, by annealing over reversals and moved pieces (Kirkpatrick et al. 1983)."""
        count = len(self.cost)
        if count == 1:
            return [0]
        cost, chance = self.cost.tolist(), random.Random(seed).random
        first, last = self.ends[0].tolist(), self.ends[-1].tolist()
        joints = {
            stop - 1: (self.ends[k].tolist(), self.ends[k].tolist()) for k, stop in enumerate(self.stops[1:-1], start=1)
        }
        tour, near = self._greedy(), self.near

        def edge(place: int, a: int, b: int) -> float:
            """Cost of a step from the point at a place of the tour to the next one."""
            if place in joints:
                before, after = joints[place]
                return before[a] + after[b]
            return cost[a][b]

        def change(i: int, j: int) -> float:
            """Change of the whole cost if the tour from i to j is reversed."""
            a, b = tour[i], tour[j]
            change = 0.0
            if i > 0:
                change += edge(i - 1, tour[i - 1], b) - edge(i - 1, tour[i - 1], a)
            else:
                change += first[b] - first[a]
            if j < count - 1:
                change += edge(j, a, tour[j + 1]) - edge(j, b, tour[j + 1])
            else:
                change += last[a] - last[b]
            for place in joints:
                if i <= place < j:
                    mirror = i + j - place - 1
                    change += cost[tour[place]][tour[place + 1]] - edge(place, tour[place], tour[place + 1])
                    change += edge(place, tour[mirror + 1], tour[mirror]) - cost[tour[mirror]][tour[mirror + 1]]
                    if mirror in joints and mirror != place:
                        return math.inf  # two joints would trade places: not needed to reach every order
            return change

        where = [0] * count
        for place, point in enumerate(tour):
            where[point] = place
        now = best = 0.0
        kept = list(tour)
        tries = _TRIES * count
        cooling = math.log(_COLD / _HOT)
        for k in range(tries):
            heat = _HOT * math.exp(cooling * k / tries)
            # By products of random numbers below 1: a third of the time of randrange.
            p = int(chance() * count)
            q = near[p][int(chance() * len(near[p]))]
            i, j = where[p], where[q]
            if i > j:
                i, j = j, i
            kind = chance()
            if kind < 0.35:
                moves = [(i + 1, j)]
            elif kind < 0.7:
                moves = [(i, j - 1)]
            elif kind < 0.95:
                # A piece of one to three points moves along the tour: the reversal of both, then of each.
                long = 1 + int(chance() * 3)
                if chance() < 0.5:
                    moves = [(i, j), (j - long + 1, j)] if j - long > i else []
                else:
                    moves = [(i, j), (i, i + long - 1)] if i + long < j else []
            else:
                moves = [(i, count - 1)] if chance() < 0.5 else [(0, i)]
            done, total = [], 0.0
            for low, high in moves:
                if low >= high:
                    continue
                step = change(low, high)
                if step == math.inf:
                    total = math.inf
                    break
                total += step
                tour[low : high + 1] = tour[low : high + 1][::-1]
                done.append((low, high))
            if not done and total != math.inf:
                continue
            if total <= 0 or (total < 40 * heat and chance() < math.exp(-total / heat)):
                now += total
                for low, high in done:
                    for place in range(low, high + 1):
                        where[tour[place]] = place
                if now < best - 1e-9:
                    best, kept = now, list(tour)
            else:
                for low, high in reversed(done):
                    tour[low : high + 1] = tour[low : high + 1][::-1]
        return kept

    def _greedy(self) -> list[int]:
        """Each point followed by the nearest that is left, from the one nearest to the first microphone."""
        left = set(range(len(self.cost)))
        tour = [int(self.ends[0].argmin())]
        left.remove(tour[0])
        while left:
            after = min(left, key=lambda point: (self.cost[tour[-1], point], point))
            tour.append(after)
            left.remove(after)
        return tour


def steps_of(tour: Sequence[int], counts: Sequence[int]) -> list[tuple[int, int]]:
    """Pairs of points that follow each other on a line."""
    stops = np.cumsum([0, *counts]).tolist()
    return [pair for low, high in pairwise(stops) for pair in pairwise(tour[low:high])]


def crossings(steps: Sequence[tuple[int, int]], places: Array, normals: Array) -> list[tuple[int, int]]:
    """Pairs of steps, by their numbers, that cross each other as seen along the mean of their normals."""
    ends = np.array(steps)
    starts, stops = places[ends[:, 0]], places[ends[:, 1]]
    middles, length = (starts + stops) / 2, np.linalg.norm(stops - starts, axis=1)
    found = []
    for i in range(len(steps)):
        near = np.flatnonzero(np.linalg.norm(middles[i + 1 :] - middles[i], axis=1) < (length[i + 1 :] + length[i]) / 2)
        for j in (near + i + 1).tolist():
            if set(steps[i]) & set(steps[j]):
                continue
            z = normals[list(steps[i] + steps[j])].sum(axis=0)
            a, b, c, d = starts[i], stops[i], starts[j], stops[j]
            if _side(a, b, c, z) * _side(a, b, d, z) < 0 and _side(c, d, a, z) * _side(c, d, b, z) < 0:
                found.append((i, j))
    return found


def _side(start: Array, end: Array, place: Array, normal: Array) -> float:
    return float(np.cross(end - start, place - start) @ normal)
