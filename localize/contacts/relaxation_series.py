"""Slow part of responses in time: a Prony series of a few exponentials, which never forgets a press.

A held press, a leak, creeping rubber and the diffusion of air along a line relax: below some hertz their responses are
sums of terms r / (j w + p) with real, positive rates p. Rates that stand five to a decade serve all of them,
because such a sum comes within exp(-pi^2 / h) of a relaxation at any rate, h being the distance of the rates in natural
logarithms. Only the weights are fitted, which is a linear problem. (R. A. Schapery, "A simple collocation method for
fitting viscoelastic models to experimental data", GALCIT SM 61-23A (1961), has rates that are chosen beforehand in the
same way.)
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import scipy.signal

from geometry.ground.typed import Array, ComplexArray

SLOWEST, FASTEST = 3e-4, 300.0
"""Corner frequencies of the slowest and the fastest exponential, Hz."""
BY_DECADE = 5
"""Number of exponentials in a decade."""
FITTED_TO = 30.0
"""Frequency up to which the weights are fitted, Hz."""
SLOW = 1.0
"""Corner frequency up to which an exponential counts as slow, Hz: what is faster dies out within two seconds."""
_RCOND = 1e-12


@dataclass(frozen=True, eq=False)
class RelaxationSeries:
    """Exponentials of many responses, with the same rates for all."""

    rate: Array
    """Rates; (n_rate,) float64, 1/s."""
    weight: Array
    """Weights r of r / (j w + p); (..., n_rate) float64, in the unit of the responses times 1/s."""
    constant: Array
    """Part without memory; (n_point, n_microphone) float64, or of any other shape, in the unit of the responses."""

    @classmethod
    def of(cls, values: ComplexArray, frequency: Array) -> RelaxationSeries:
        """Series that follows responses up to :data:`FITTED_TO`, with errors relative to each value.

        Args:
            values: (..., n_freq) complex128, not 0.
            frequency: (n_freq,) float64, Hz, from about 1 mHz on.
        """
        kept = frequency <= FITTED_TO
        rate = 2 * np.pi * np.geomspace(SLOWEST, FASTEST, round(np.log10(FASTEST / SLOWEST) * BY_DECADE) + 1)
        terms = rate / (2j * np.pi * frequency[kept, None] + rate)
        terms = np.concatenate([terms, np.ones((len(terms), 1))], axis=1)
        rows = values[..., kept].reshape(-1, int(kept.sum()))
        found = np.empty((len(rows), terms.shape[1]))
        for number, row in enumerate(rows):
            relative = terms / row[:, None]
            matrix = np.concatenate([relative.real, relative.imag])
            wanted = np.repeat([1.0, 0.0], len(row))
            found[number] = np.linalg.lstsq(matrix, wanted, rcond=_RCOND)[0]
        found = found.reshape(*values.shape[:-1], -1)
        return cls(rate, found[..., :-1] * rate, found[..., -1])

    def at(self, frequency: Array) -> ComplexArray:
        """Values of the series.

        Args:
            frequency: (n,) float64, Hz, 0 Hz included.

        Returns:
            (..., n) complex128, in the unit of the responses.
        """
        terms = 1 / (2j * np.pi * frequency + self.rate[:, None])
        return np.asarray(self.weight @ terms + self.constant[..., None])

    def slow(self) -> RelaxationSeries:
        """The slow exponentials alone, without the constant."""
        kept = self.rate <= 2 * np.pi * SLOW
        return RelaxationSeries(self.rate[kept], self.weight[..., kept], np.zeros_like(self.constant))

    def sampled_at(self, frequency: Array, sample_rate: float) -> ComplexArray:
        """Values of the recursion of :meth:`through`, which differ from :meth:`at` by the sampling.

        Args:
            frequency: (n,) float64, Hz.
            sample_rate: Hz.

        Returns:
            (..., n) complex128, in the unit of the responses.
        """
        step = 1 / sample_rate
        kept = np.exp(-self.rate * step)[:, None]
        delay = np.exp(-2j * np.pi * frequency * step)
        return np.asarray(self.weight @ (step * (1 / (1 - kept * delay) - 0.5)))

    def through(self, signals: Array, sample_rate: float) -> Array:
        """Outputs for signals that were zero before their first sample; the constant is left out.

        Args:
            signals: (n_input, n_sample) float64; the weights must be (n_input, n_output, n_rate).
            sample_rate: Hz.

        Returns:
            (n_output, n_sample) float64, the sum over the inputs.
        """
        step = 1 / sample_rate
        total = np.zeros((self.weight.shape[1], signals.shape[1]))
        for number, rate in enumerate(self.rate):
            drive = step * self.weight[..., number].T @ signals
            kept = float(np.exp(-rate * step))
            total += scipy.signal.lfilter([1.0], [1.0, -kept], drive, axis=-1) - 0.5 * drive
        return total
