"""Where a pen goes that writes on an array: heard over a membrane, guessed between two, lifted.

What is heard of a line tells in each hop the point that is loudest and how loud it is, against the loudest of the whole
line: a pad presses a membrane the less the farther its middle is. Between rows it presses none and nothing is heard,
which says where it is not. Which way it goes there, a hidden Markov model knows: the pen is in a cell of a grid finer
than the pitch and moves in one of sixteen directions at the speed of the line, turns little by little or at a corner,
or is lifted and put down anywhere. All hops together say where it is in each (Rabiner 1989, Proceedings of the IEEE 77,
257).
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import numpy as np
import scipy.linalg
import scipy.ndimage
import scipy.sparse
from numpy.typing import NDArray

from geometry.ground.typed import Array
from localize.contacts.contact import surface_of
from localize.signals.array_response import ArrayResponse
from localize.signals.frames import FRAME
from localize.signals.stimulus import SAMPLE_RATE
from localize.tracking.footprints import pitch_of, shares_at

Single = NDArray[np.float32]

PAD = 6.5
"""Radius of what writes, mm: the middle of that of pads that are laid flat."""
CELLS = 4
"""Number of cells from point to point."""
MOST = 4000
"""Number of cells at most: of sparser arrays they are larger."""
DIRECTIONS = 16
"""Number of directions."""
SPEEDS = (25.0, 35.0, 50.0, 70.0, 100.0, 140.0, 200.0)
"""Speeds of a line that are tried, mm/s."""
UNEVEN = ((0.85, 0.25), (1.0, 0.5), (1.15, 0.25))
"""Steps of a hop over those of the line's speed, and how often they are taken."""
TURN, CORNER, LIFT = 0.75, 0.12, 0.065
"""How often, in each pitch of its way, a pen turns by one direction to either side, turns to any, and is lifted: what
is written has its shape at any speed."""
LAND = 1.9
"""How often it is put down again, 1/s."""
FLOOR = -50.0
"""Level to which what was heard before fades at least, dB over the loudest."""
SCATTER = 8.0
"""Standard deviation of a level, dB."""
ASTRAY = 0.05
"""Share of levels that say nothing."""
ASTRAY_POINTS = 0.03
"""Share of named points that say nothing."""
FADING = (12.0, 8.0)
"""Level over the floor up to which a lifted pen may be heard, and standard deviation above it, dB."""
SMEAR = 0.07
"""Time over which a frame smears what it hears, standard deviation, s."""
LONGEST = 600
"""Number of hops that are judged together: what is kept of them takes memory."""


@dataclass(frozen=True, eq=False)
class _Moves:
    """Where a hop takes a pen of one speed."""

    on: scipy.sparse.csr_array
    """From cells and directions before to those behind; (n, n), n = DIRECTIONS n_cell, float32."""
    back: scipy.sparse.csr_array
    """Its transpose."""
    turned: Single
    """From directions before to those behind; (DIRECTIONS, DIRECTIONS) float32."""
    lifted: float
    """Probability that the pen is lifted."""


class PenTracker:
    """Tracker of a pen over an array.

    Args:
        response: of a library with a design.

    Raises:
        Refusal: bare transfer functions.
    """

    def __init__(self, response: ArrayResponse) -> None:
        place, _ = surface_of(response)
        self._pitch = pitch = pitch_of(response)
        room = np.ptp(place, axis=0)
        self._step = step = max(pitch / CELLS, float(np.sqrt(np.prod(room + pitch / 2) / MOST)))
        self.hop = 16 * round(np.clip(step / 1.1, 1, 4))
        """Samples from hop to hop: a pen goes about a cell."""
        ends = zip(place.min(0) - step, place.max(0) + step, strict=True)
        axes = [np.arange(low, high + 1e-9, step) for low, high in ends]
        self._shape = (len(axes[0]), len(axes[1]))
        self.place = np.stack(np.meshgrid(*axes, indexing="ij"), -1).reshape(-1, 2)
        """Middles of the cells; (n_cell, 2) float64, mm."""
        share = shares_at(response, PAD, self.place) ** 2
        self._power = share / share.max()
        self._landed = float(1 - np.exp(-LAND * self.hop / SAMPLE_RATE))
        self._moves = cache(self._moves_at)
        self._loudness = cache(self._loudness_at)

    def probability(self, point: NDArray[np.int64], level: Array, floor: float) -> Single:
        """Where the pen is, hop by hop.

        Args:
            point: that is heard in the frame about each hop, from 0; (n_hop,) int64.
            level: how loud a touch of that point would be heard so, dB over the loudest of the line; (n_hop,) float64.
            floor: level of the noise, dB over the same.

        Returns:
            (n_hop, n_cell) float32: probability of each cell; what is missing to one is that the pen is lifted.
        """
        parts = [slice(k, k + LONGEST) for k in range(0, len(point), LONGEST)]
        return np.concatenate([self._probability(point[each], level[each], max(FLOOR, floor)) for each in parts])

    def _probability(self, point: NDArray[np.int64], level: Array, floor: float) -> Single:
        @cache
        def tried(number: int) -> tuple[float, Single, Single, Array]:
            down, lifted = self._judged(point, level, floor, SPEEDS[number])
            return *self._forward(down, lifted, self._moves(SPEEDS[number])), down, lifted

        best, around = -1, len(SPEEDS) // 2 - 1
        while around != best:  # uphill from the middle: the likelihood has one maximum
            best = around
            near = range(max(0, best - 1), min(len(SPEEDS), best + 2))
            around = max(near, key=lambda number: tried(number)[0])
        _, belief, down, lifted = tried(best)
        return self._backward(down, lifted, self._moves(SPEEDS[best]), belief)

    def _judged(self, point: NDArray[np.int64], level: Array, floor: float, speed: float) -> tuple[Single, Array]:
        """Log-likelihoods of the cells, (n_hop, n_cell), and of a lifted pen, (n_hop,), by frames that overlap."""
        power = self._loudness(speed)
        rest = 10 ** (floor / 10)
        whole = power.sum(1) + rest
        count = power.shape[1]
        level = np.maximum(level, floor)
        off = (level[:, None] - 10 * np.log10(whole)) / SCATTER
        named = (1 - ASTRAY_POINTS) * ((power + rest / count) / whole[:, None])[:, point].T + ASTRAY_POINTS / count
        down = _robust(off) + np.log(named)
        after = np.maximum(level - floor - FADING[0], 0.0) / FADING[1]
        newest = self.hop / FRAME
        return (newest * down).astype(np.float32), newest * (_robust(after) - np.log(count))

    def _loudness_at(self, speed: float) -> Array:
        """Power with which each point is heard of each cell, at most 1; (n_cell, n_point)."""
        wide = SMEAR * speed / self._step
        each = [scipy.ndimage.gaussian_filter(of.reshape(self._shape), wide, mode="nearest") for of in self._power.T]
        return np.stack([of.ravel() for of in each], 1)

    def _moves_at(self, speed: float) -> _Moves:
        rows, columns = self._shape
        number = np.arange(rows * columns).reshape(self._shape)
        before, behind, values = [], [], []
        for direction in range(DIRECTIONS):
            angle = 2 * np.pi * direction / DIRECTIONS
            way = np.array([np.cos(angle), np.sin(angle)]) * speed * self.hop / SAMPLE_RATE / self._step
            for uneven, often in UNEVEN:
                whole = np.floor(uneven * way).astype(int)
                part = uneven * way - whole
                for i, j in np.ndindex(2, 2):
                    weight = often * abs(1 - i - part[0]) * abs(1 - j - part[1])
                    down, right = int(whole[0]) + i, int(whole[1]) + j
                    if weight < 1e-9 or abs(down) >= rows or abs(right) >= columns:
                        continue
                    # Who leaves the surface is not there any more.
                    left = number[max(0, -down) : rows - max(0, down), max(0, -right) : columns - max(0, right)]
                    came = number[max(0, down) : rows + min(0, down), max(0, right) : columns + min(0, right)]
                    before.append(left.ravel() + direction * number.size)
                    behind.append(came.ravel() + direction * number.size)
                    values.append(np.full(left.size, weight, np.float32))
        ends, weights = (np.concatenate(behind), np.concatenate(before)), np.concatenate(values)
        shape = (DIRECTIONS * number.size, DIRECTIONS * number.size)
        on, back = (scipy.sparse.csr_array((weights, each), shape) for each in (ends, ends[::-1]))
        pitches = speed * self.hop / SAMPLE_RATE / self._pitch
        same = np.eye(DIRECTIONS)
        rate = TURN * (np.roll(same, 1, 1) + np.roll(same, -1, 1) - 2 * same) + CORNER * (1 / DIRECTIONS - same)
        turned = scipy.linalg.expm(pitches * rate).astype(np.float32)
        return _Moves(on, back, turned, float(1 - np.exp(-LIFT * pitches)))

    def _forward(self, down: Single, lifted: Array, moves: _Moves) -> tuple[float, Single]:
        """Log-likelihood of a line, and probabilities by the hops so far, (n_hop, DIRECTIONS, n_cell)."""
        belief = np.empty((len(down), DIRECTIONS, len(self.place)), np.float32)
        top = np.maximum(down.max(1), lifted)
        near, apart = np.exp(down - top[:, None].astype(np.float32)), np.exp(lifted - top)
        state = np.zeros((DIRECTIONS, len(self.place)), np.float32)
        up, total = 1.0, float(top.sum())
        for k in range(len(down)):
            landed = up * self._landed / state.size
            up, drawn = up * (1 - self._landed) + moves.lifted * float(state.sum()), moves.turned.T @ state
            state = (moves.on @ drawn.ravel()).reshape(state.shape) * np.float32(1 - moves.lifted) + np.float32(landed)
            state *= near[k]
            up *= apart[k]
            whole = float(state.sum()) + up
            state /= np.float32(whole)
            up /= whole
            total += float(np.log(whole))
            belief[k] = state
        return total, belief

    def _backward(self, down: Single, lifted: Array, moves: _Moves, belief: Single) -> Single:
        """Probabilities of the cells by all hops, (n_hop, n_cell)."""
        top = np.maximum(down.max(1), lifted)
        near, apart = np.exp(down - top[:, None].astype(np.float32)), np.exp(lifted - top)
        found = np.empty_like(down)
        after, up = np.ones(belief.shape[1:], np.float32), 1.0
        for k in range(len(down) - 1, -1, -1):
            both = belief[k] * after
            lift = max(0.0, 1.0 - float(belief[k].sum())) * up
            found[k] = both.sum(0) / (float(both.sum()) + lift)
            after *= near[k]
            up *= apart[k]
            landed = float(after.mean())
            came = (moves.back @ after.ravel()).reshape(after.shape)
            after = moves.turned @ came * np.float32(1 - moves.lifted) + np.float32(moves.lifted * up)
            up = (1 - self._landed) * up + self._landed * landed
            most = max(float(after.max()), up)
            after /= np.float32(most)
            up /= most
        return found


def _robust(off: Array) -> Array:
    """Logarithm of how likely deviations are, in their standard deviations, of which some say nothing."""
    return np.asarray(np.log((1 - ASTRAY) * np.exp(-0.5 * off**2) + ASTRAY))
