"""Path of a pen that writes on an array: detected over a membrane, guessed between two, lifted.

In each hop, the signals give the loudest point and its level relative to the loudest of the whole line: a pad presses a
membrane the less the farther its middle is. Between rows the pad presses no membrane and the microphones detect
nothing, which shows where the pen is not. A hidden Markov model estimates the path there. The pen is in a cell of a
grid finer than the pitch and moves in one of sixteen directions at the speed of the line, turns little by little or at
a corner, or is lifted and put down anywhere. All hops together give the place of the pen in each (Rabiner 1989,
Proceedings of the IEEE 77, 257).
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
from localize.recognition.recognition_options import PenOptions
from localize.signals.array_response import ArrayResponse
from localize.signals.frames import FRAME
from localize.signals.stimulus import SAMPLE_RATE
from localize.tracking.footprints import fractions_at, pitch_of

Single = NDArray[np.float32]


@dataclass(frozen=True, eq=False)
class _Moves:
    """Steps of a pen of one speed in a hop."""

    on: scipy.sparse.csr_array
    """From cells and directions before to those behind; (n, n), n = n_direction n_cell, float32."""
    back: scipy.sparse.csr_array
    """Its transpose."""
    turned: Single
    """From directions before to those behind; (n_direction, n_direction) float32."""
    lifted: float
    """Probability that the pen is lifted."""


class PenTracker:
    """Tracker of a pen over an array.

    Args:
        response: of a library with a design.
        options: numbers that tune the model of the pen.

    Raises:
        Refusal: bare transfer functions.
    """

    def __init__(self, response: ArrayResponse, options: PenOptions = PenOptions()) -> None:
        self.options = options
        place, _ = surface_of(response)
        self._pitch = pitch = pitch_of(response)
        room = np.ptp(place, axis=0)
        self._step = step = max(pitch / options.cells, float(np.sqrt(np.prod(room + pitch / 2) / options.most_cells)))
        self.hop = 16 * round(np.clip(step / 1.1, 1, 4))
        """Samples from hop to hop: a pen goes about a cell."""
        ends = zip(place.min(0) - step, place.max(0) + step, strict=True)
        axes = [np.arange(low, high + 1e-9, step) for low, high in ends]
        self._shape = (len(axes[0]), len(axes[1]))
        self.place = np.stack(np.meshgrid(*axes, indexing="ij"), -1).reshape(-1, 2)
        """Middles of the cells; (n_cell, 2) float64, mm."""
        share = fractions_at(response, options.pad_radius_mm, self.place) ** 2
        self._power = share / share.max()
        self._landed = float(1 - np.exp(-options.land * self.hop / SAMPLE_RATE))
        self._moves = cache(self._moves_at)
        self._loudness = cache(self._loudness_at)

    def probability(self, point: NDArray[np.int64], level: Array, floor: float) -> Single:
        """Probability of the place of the pen, hop by hop.

        Args:
            point: loudest in the frame about each hop, from 0; (n_hop,) int64.
            level: level of a touch of that point that would give these signals, dB over the loudest of the line;
                (n_hop,) float64.
            floor: level of the noise, dB over the loudest of the line.

        Returns:
            (n_hop, n_cell) float32: probability of each cell; the remainder to one is the probability that the pen is
            lifted.
        """
        longest, floor = self.options.longest, max(self.options.floor, floor)
        parts = [slice(k, k + longest) for k in range(0, len(point), longest)]
        return np.concatenate([self._probability(point[each], level[each], floor) for each in parts])

    def _probability(self, point: NDArray[np.int64], level: Array, floor: float) -> Single:
        speeds = self.options.speeds

        @cache
        def tried(number: int) -> tuple[float, Single, Single, Array]:
            down, lifted = self._judged(point, level, floor, speeds[number])
            return *self._forward(down, lifted, self._moves(speeds[number])), down, lifted

        best, around = -1, len(speeds) // 2 - 1
        while around != best:  # uphill from the middle: the likelihood has one maximum
            best = around
            near = range(max(0, best - 1), min(len(speeds), best + 2))
            around = max(near, key=lambda number: tried(number)[0])
        _, belief, down, lifted = tried(best)
        return self._backward(down, lifted, self._moves(speeds[best]), belief)

    def _judged(self, point: NDArray[np.int64], level: Array, floor: float, speed: float) -> tuple[Single, Array]:
        """Log-likelihoods of the cells, (n_hop, n_cell), and of a lifted pen, (n_hop,), by frames that overlap."""
        power = self._loudness(speed)
        rest = 10 ** (floor / 10)
        whole = power.sum(1) + rest
        count = power.shape[1]
        level = np.maximum(level, floor)
        off = (level[:, None] - 10 * np.log10(whole)) / self.options.scatter
        astray = self.options.astray_points
        named = (1 - astray) * ((power + rest / count) / whole[:, None])[:, point].T + astray / count
        down = _robust(off, self.options.astray) + np.log(named)
        after = np.maximum(level - floor - self.options.fading[0], 0.0) / self.options.fading[1]
        newest = self.hop / FRAME
        return (newest * down).astype(np.float32), newest * (_robust(after, self.options.astray) - np.log(count))

    def _loudness_at(self, speed: float) -> Array:
        """Relative power of each point if the pen is in each cell, at most 1; (n_cell, n_point)."""
        wide = self.options.smear * speed / self._step
        each = [scipy.ndimage.gaussian_filter(of.reshape(self._shape), wide, mode="nearest") for of in self._power.T]
        return np.stack([of.ravel() for of in each], 1)

    def _moves_at(self, speed: float) -> _Moves:
        rows, columns = self._shape
        directions = self.options.directions
        number = np.arange(rows * columns).reshape(self._shape)
        before, behind, values = [], [], []
        for direction in range(directions):
            angle = 2 * np.pi * direction / directions
            way = np.array([np.cos(angle), np.sin(angle)]) * speed * self.hop / SAMPLE_RATE / self._step
            for uneven, often in self.options.uneven:
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
        shape = (directions * number.size, directions * number.size)
        on, back = (scipy.sparse.csr_array((weights, each), shape) for each in (ends, ends[::-1]))
        pitches = speed * self.hop / SAMPLE_RATE / self._pitch
        same = np.eye(directions)
        rate = self.options.turn * (np.roll(same, 1, 1) + np.roll(same, -1, 1) - 2 * same)
        rate += self.options.corner * (1 / directions - same)
        turned = scipy.linalg.expm(pitches * rate).astype(np.float32)
        return _Moves(on, back, turned, float(1 - np.exp(-self.options.lift * pitches)))

    def _forward(self, down: Single, lifted: Array, moves: _Moves) -> tuple[float, Single]:
        """Log-likelihood of a line, and probabilities by the hops so far, (n_hop, n_direction, n_cell)."""
        belief = np.empty((len(down), self.options.directions, len(self.place)), np.float32)
        top = np.maximum(down.max(1), lifted)
        near, apart = np.exp(down - top[:, None].astype(np.float32)), np.exp(lifted - top)
        state = np.zeros((self.options.directions, len(self.place)), np.float32)
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


def _robust(off: Array, astray: float) -> Array:
    """Logarithm of how likely deviations are, in their standard deviations, of which some say nothing."""
    return np.asarray(np.log((1 - astray) * np.exp(-0.5 * off**2) + astray))
