r"""Vector fitting: many responses as sums of the same few poles, real in time and stable.

    H_k(s) = sum_n R_kn / (s - p_n) + D_k,    s = j 2 pi f,

by relaxed vector fitting with common poles (B. Gustavsen and A. Semlyen, "Rational approximation of frequency domain
responses by vector fitting", IEEE Trans. Power Delivery 14 (1999) 1052; B. Gustavsen, "Improving the pole relocating
properties of vector fitting", ibid. 21 (2006) 1587), in the form that eliminates the residues of each response by a QR
decomposition of its own (D. Deschrijver et al., "Macromodeling of multiport systems using a fast implementation of the
vector fitting method", IEEE Microw. Wirel. Compon. Lett. 18 (2008) 383). Errors are relative to the magnitude of each
value, so a response that is a thousandth of another one is fitted as well. A pole that comes out unstable is reflected
into the left half plane.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
import scipy.linalg
import scipy.signal

from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array, ComplexArray

#: Relocations of the poles; they hardly move after ten.
ITERATIONS = 12
#: Part of the imaginary part below which a starting pole is damped.
_DAMPING = 0.01
#: Imaginary part by magnitude below which a pole counts as real.
_REAL = 1e-9


class VectorFitError(Refusal):
    """No sum of poles of the allowed order reaches the error asked for."""


@dataclass(frozen=True, eq=False)
class RationalFit:
    """Responses as sums of common poles."""

    poles: ComplexArray
    """Poles with negative real parts, those that are not real in pairs; (n_pole,) complex128, rad/s."""
    residues: ComplexArray
    """Residues; (..., n_pole) complex128, in the unit of the responses times rad/s."""
    constant: Array
    """Value at infinite frequency; shape of one response, (n_point, n_microphone) for instance, float64, in the unit of
    the responses."""

    @property
    def order(self) -> int:
        """Number of poles."""
        return len(self.poles)

    def at(self, frequency: Array) -> ComplexArray:
        """Values of the sum.

        Args:
            frequency: (n,) float64, Hz.

        Returns:
            (..., n) complex128, in the unit of the responses.
        """
        terms = 1 / (2j * np.pi * frequency - self.poles[:, None])
        return np.asarray(self.residues @ terms + self.constant[..., None])

    def error(self, values: ComplexArray, frequency: Array) -> float:
        """Largest difference to responses, relative to the magnitude of each value.

        Args:
            values: (..., n) complex128.
            frequency: (n,) float64, Hz.
        """
        return float(np.abs(self.at(frequency) / values - 1).max())

    def of_responses(self, values: ComplexArray, frequency: Array, constant: bool = True) -> RationalFit:
        """The same poles with the residues of other responses.

        Args:
            values: (..., n) complex128, not 0.
            frequency: (n,) float64, Hz.
            constant: False: their values at infinite frequency are 0.
        """
        rows = values.reshape(-1, values.shape[-1])
        basis = _basis(self.poles, frequency)
        if constant:
            basis = np.concatenate([basis, np.ones((len(frequency), 1))], axis=1)
        found = np.zeros((len(rows), self.order + 1))
        for number, row in enumerate(rows):
            matrix, wanted = _real(basis / row[:, None]), np.repeat([1.0, 0.0], len(row))
            scale = np.linalg.norm(matrix, axis=0)
            found[number, : basis.shape[1]] = np.linalg.lstsq(matrix / scale, wanted, rcond=None)[0] / scale
        shape = values.shape[:-1]
        residues = _residues(self.poles, found[:, :-1]).reshape(*shape, self.order)
        return replace(self, residues=residues, constant=found[:, -1].reshape(shape))

    def through(self, signals: Array, sample_rate: float) -> Array:
        """Outputs for signals that are straight lines between their samples, and were 0 before the first one.

        Exact at the samples at any rate, and for any length.

        Args:
            signals: (n_input, n_sample) float64; the responses must be (n_input, n_output).
            sample_rate: Hz.

        Returns:
            (n_output, n_sample) float64, the sum over the inputs.
        """
        step = 1 / sample_rate
        total = self.constant.T @ signals
        for number, pole in enumerate(self.poles):
            if pole.imag < 0:
                continue
            drive = self.residues[..., number].T @ signals
            z = pole * step
            # A line from a to b over the step: weights of its ends, by series where the pole is slow.
            early, late = _line_weights(z)
            kept = np.exp(z)
            state = scipy.signal.lfilter([late * step, early * step], [1.0, -kept], drive, axis=-1)
            total = total + (state.real if pole.imag == 0 else 2 * state.real)
        return np.asarray(total)


def _line_weights(z: complex) -> tuple[complex, complex]:
    """Integrals of exp(z (1 - t)) (1 - t) and exp(z (1 - t)) t over t from 0 to 1."""
    if abs(z) < 1e-3:
        return 1 / 2 + z / 3 + z**2 / 8, 1 / 2 + z / 6 + z**2 / 24
    growth = np.exp(z)
    late = (growth - 1 - z) / z**2
    return (growth - 1) / z - late, late


def fit_poles(values: ComplexArray, frequency: Array, order: int) -> RationalFit:
    """Fit of responses with a given number of common poles.

    Args:
        values: (..., n_freq) complex128, not 0, of real and stable systems.
        frequency: (n_freq,) float64, ascending, Hz.
        order: number of poles, 2 to half of the number of frequencies.

    Raises:
        VectorFitError: an order out of range.
    """
    if not 2 <= order <= len(frequency) // 2:
        allowed = f"2 to half of the {len(frequency)} frequencies"
        raise VectorFitError(kind=Kind.OUT_OF_RANGE, field="order", value=order, allowed=allowed)
    rows = values.reshape(-1, values.shape[-1])
    # Real poles at first: air in narrow tubes and rubber relax, and poles of resonances part from them by themselves.
    corners = np.geomspace(float(frequency[0]), float(frequency[-1]), order)
    poles = np.asarray(-2 * np.pi * corners, np.complex128)
    for _ in range(ITERATIONS):
        poles = _relocated(poles, rows, frequency)
    start = RationalFit(poles, np.zeros((0, order), np.complex128), np.zeros(0))
    return start.of_responses(values, frequency)


def _relocated(poles: ComplexArray, rows: ComplexArray, frequency: Array) -> ComplexArray:
    """Poles after one step: the zeros of the weighting function sigma."""
    basis, order = _basis(poles, frequency), len(poles)
    with_constant = np.concatenate([basis, np.ones((len(frequency), 1))], axis=1)
    blocks = []
    for row in rows:
        matrix = _real(np.concatenate([with_constant / row[:, None], -with_constant], axis=1))
        upper = scipy.linalg.qr(matrix, mode="r", check_finite=False)[0]
        blocks.append(upper[order + 1 : 2 * order + 2, order + 1 :])
    # Sigma must not vanish: its mean over the frequencies is 1.
    scale = np.sqrt(len(rows) * len(frequency))
    blocks.append(scale / len(frequency) * with_constant.sum(axis=0).real[None])
    matrix = np.concatenate(blocks)
    wanted = np.zeros(len(matrix))
    wanted[-1] = scale
    norm = np.linalg.norm(matrix, axis=0)
    found = np.linalg.lstsq(matrix / norm, wanted, rcond=None)[0] / norm
    weights, constant = found[:-1], found[-1]
    if abs(constant) < 1e-8:
        constant = np.copysign(1e-8, constant)
    system, entry = _real_system(poles)
    moved = np.linalg.eigvals(system - np.outer(entry, weights) / constant)
    return _sorted(np.where(moved.real > 0, -moved.conj(), moved))


def _sorted(poles: ComplexArray) -> ComplexArray:
    """Stable poles, real ones first, each pair with its positive imaginary part first."""
    is_real = np.abs(poles.imag) <= _REAL * np.abs(poles)
    real = np.sort(poles[is_real].real)
    upper = poles[~is_real & (poles.imag > 0)]
    upper = upper[np.argsort(np.abs(upper))]
    return np.concatenate([real + 0j, np.stack([upper, upper.conj()], axis=1).ravel()])


def _basis(poles: ComplexArray, frequency: Array) -> ComplexArray:
    """(n_freq, n_pole): terms of real poles, and of each pair the two whose weights are real."""
    terms = 1 / (2j * np.pi * frequency[:, None] - poles)
    paired = np.flatnonzero(poles.imag > 0)
    first, second = terms[:, paired].copy(), terms[:, paired + 1].copy()
    terms[:, paired], terms[:, paired + 1] = first + second, 1j * (first - second)
    return terms


def _residues(poles: ComplexArray, weights: Array) -> ComplexArray:
    """(..., n_pole) complex of the real weights of :func:`_basis`."""
    residues = weights.astype(np.complex128)
    paired = np.flatnonzero(poles.imag > 0)
    value = weights[..., paired] + 1j * weights[..., paired + 1]
    residues[..., paired], residues[..., paired + 1] = value, value.conj()
    return residues


def _real_system(poles: ComplexArray) -> tuple[Array, Array]:
    """Real matrix with these poles, and the vector by which one input enters it, to weights as of :func:`_basis`."""
    matrix, entry = np.diag(poles.real), np.ones(len(poles))
    for first in np.flatnonzero(poles.imag > 0):
        matrix[first, first + 1], matrix[first + 1, first] = poles[first].imag, -poles[first].imag
        entry[first : first + 2] = 2.0, 0.0
    return matrix, entry


def _real(matrix: ComplexArray) -> Array:
    return np.concatenate([matrix.real, matrix.imag])
