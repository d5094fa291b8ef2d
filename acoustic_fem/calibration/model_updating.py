"""The model brought to the sensor on the table: parameters fitted to measured transfer functions of some points.

Maximum a posteriori with the manufacturing tolerances as priors (Tarantola 2005, ch. 3): parameters u in standard
deviations of their priors minimise |r(u)|^2 + |u|^2, with the residuals r in units of what the measurement and
the model are trusted to. Gauss-Newton with step halving; the posterior covariance is (J^T J + 1)^-1.

The model is the lumped network, relative to a library of the nominal design of any fidelity:
H(u) = H_nominal H_lumped(u) / H_lumped(0). It takes torch tensors and is differentiable, for objectives of one value;
the Jacobian here, a hundred parameters by thousands of residuals, comes from central differences of one batch of
sensors, which cost a small part of as many backward passes.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
import scipy.stats

from acoustic_fem.calibration.fitted_model import Posterior, UpdatedModel
from acoustic_fem.calibration.model_discrepancy import Discrepancy
from acoustic_fem.sound.estimate import TransferEstimate
from geometry.ground.argument_checks import check_given, check_range, check_shape, unsuitable
from geometry.ground.refusal import Kind
from geometry.ground.typed import Array, ComplexArray

#: s, standard deviation of what the stated delay of the reference is off by, alike at all points.
DELAY = 1e-3
#: Probability below which chi-squared, or the size of the parameters, speaks against the fit.
_SIGNIFICANCE = 1e-3
_ITERATIONS = 30
_LONGEST = 2.0  # of the steps of a parameter, in standard deviations: beyond, nothing is linear any more


@dataclass(frozen=True, eq=False, kw_only=True)
class Update(Posterior):
    """The sensor that measured transfer functions speak for; its eigenvalues are those of J^T J."""

    points: tuple[int, ...]
    """Numbers of the measured points."""
    chi_squared: float
    """Minimum |r|^2 + |u|^2 that was found, in units of the noise and of the priors."""
    residuals: int
    """Number of residuals, real and imaginary parts."""
    worst_point: int
    """Number of the measured point that is farthest from the fit."""
    delay: float
    """Time by which the array's microphones came later than stated, against the reference, s."""
    iterations: int
    """Number of steps of the fit."""

    @property
    def objection(self) -> str | None:
        """Why the fit cannot be trusted; None where it can."""
        limit = float(scipy.stats.chi2.isf(_SIGNIFICANCE, self.residuals))
        if self.chi_squared > limit:
            return (
                f"chi-squared = {self.chi_squared:.0f} is above {limit:.0f} for {self.residuals} residuals: no sensor "
                f"of this family is like the measured one; point {self.worst_point} is farthest from the fit"
            )
        size, most = (
            float(self.parameters @ self.parameters),
            float(scipy.stats.chi2.isf(_SIGNIFICANCE, self.model.count)),
        )
        if size > most:
            return (
                f"the parameters lie {size:.0f} off their priors, more than {most:.0f} for {self.model.count} of them: "
                f"the sensor is not one of this tolerance (farthest: {self.farthest})"
            )
        return None

    def summary(self) -> dict[str, Any]:
        """Plain values for a report."""
        return {
            "measured_points": list(self.points),
            "chi_squared": self.chi_squared,
            "residuals": self.residuals,
            "worst_point": self.worst_point,
            "delay": self.delay,
            "objection": self.objection,
            "iterations": self.iterations,
            **super().summary(),
        }


def update(model: UpdatedModel, estimates: Mapping[int, TransferEstimate]) -> Update:
    """Fit a family of sensors to the measured transfer functions of some points.

    Args:
        model: the family, on the frequencies of the estimates.
        estimates: by number of the point, from 1.

    Raises:
        Refusal: no estimate, one of a point that the design does not have, on other frequencies, of 0 or not finite.
    """
    points = sorted(estimates)
    check_given("estimates", points, "a fit needs at least one measured point")
    shape = model._ratio.shape
    for number in points:
        check_range("point", number, 1, shape[0])
        check_shape(f"estimates.{number}", estimates[number].transfer_function, shape[1:], kind=Kind.MISMATCH)
        _check_estimate(number, estimates[number])
    rows = [number - 1 for number in points]
    measured = np.stack([estimates[number].transfer_function for number in points])
    noise = np.stack([estimates[number].deviation for number in points])
    fitted = _Fitted(model, rows, measured)
    first = fitted.most_probable(Discrepancy(model.frequency, measured, noise), np.zeros(model.count + 1))
    trusted = Discrepancy(model.frequency, fitted.expected(first.v), noise)
    found = fitted.most_probable(trusted, first.v)
    j = trusted.residuals(fitted.jacobian(found.v))
    # nobody asks for the delay: what it takes of the information is taken out
    by_parameters, by_delay = j[:-1], j[-1]
    with_delay = by_parameters @ by_delay
    information = by_parameters @ by_parameters.T - np.outer(with_delay, with_delay) / (1 + by_delay @ by_delay)
    return Update.of(
        model,
        found.v[:-1],
        information,
        points=tuple(points),
        chi_squared=found.value,
        residuals=j.shape[1],
        worst_point=points[int(trusted.by_point(fitted.expected(found.v) - measured).argmax())],
        delay=float(DELAY * found.v[-1]),
        iterations=first.iterations + found.iterations,
    )


def _check_estimate(number: int, estimate: TransferEstimate) -> None:
    h, deviation = np.abs(estimate.transfer_function), estimate.deviation
    if not (np.isfinite(h).all() and h.min() > 0):
        raise unsuitable(
            f"estimates.{number}", f"has a transfer function of {h.min()} Pa/Pa; it must be finite and not 0"
        )
    if not (np.isfinite(deviation).all() and deviation.min() >= 0):
        raise unsuitable(
            f"estimates.{number}", f"has a deviation of {deviation.min()} Pa/Pa; it must be finite, 0 or above"
        )


class _Minimum(NamedTuple):
    v: Array
    value: float
    iterations: int


class _Fitted:
    """Predicted measurement of some points: parameters v (count + 1,), the last one the delay of the reference.

    Args:
        model: the family.
        rows: of the points.
        measured: (n_point, n_microphone, n_freq) Pa/Pa.
    """

    def __init__(self, model: UpdatedModel, rows: list[int], measured: ComplexArray) -> None:
        self.model, self.rows, self.measured = model, rows, measured
        self._turn = -2j * np.pi * model.frequency * DELAY

    def expected(self, v: Array) -> ComplexArray:
        h = self.model.transfer_function(v[None, :-1])[0][self.rows]
        return np.asarray(h * np.exp(self._turn * v[-1]))

    def jacobian(self, v: Array) -> ComplexArray:
        """(count + 1, n_point, n_microphone, n_freq)."""
        by_parameters = self.model.jacobian(v[:-1])[:, self.rows] * np.exp(self._turn * v[-1])
        return np.concatenate([by_parameters, (self._turn * self.expected(v))[None]])

    def most_probable(self, trusted: Discrepancy, v: Array) -> _Minimum:
        """Minimum of |r|^2 + |v|^2 near v, by Gauss-Newton with step halving."""

        def objective(v: Array) -> float:
            r = trusted.residuals(self.expected(v) - self.measured)
            return float(r @ r + v @ v)

        value = objective(v)
        iterations = 0
        while iterations < _ITERATIONS:
            iterations += 1
            r = trusted.residuals(self.expected(v) - self.measured)
            j = trusted.residuals(self.jacobian(v))
            step = -np.linalg.solve(j @ j.T + np.eye(len(v)), j @ r + v)
            length = min(1.0, _LONGEST / float(np.abs(step).max()))
            while (smaller := objective(v + length * step)) > value and length > 1e-4:
                length /= 2
            if smaller >= value:
                break
            gain, value, v = value - smaller, smaller, v + length * step
            if gain < 1e-6 * value + 1e-6:
                break
        return _Minimum(v, value, iterations)
