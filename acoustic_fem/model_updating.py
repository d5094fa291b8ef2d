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
from dataclasses import dataclass, fields, replace
from functools import cached_property
from typing import Any, NamedTuple, Self

import numpy as np
import scipy.stats
from numpy.typing import NDArray

from acoustic_fem.batch_functions import namespace
from acoustic_fem.batch_network import batch_transfer_function
from acoustic_fem.batch_parameters import ArrayParameters, Topology
from acoustic_fem.checks import in_range
from acoustic_fem.library import Library
from acoustic_fem.microphone import vent_ratio
from acoustic_fem.model_discrepancy import TOTAL, Discrepancy
from acoustic_fem.transfer_estimate import TransferEstimate
from geometry.design import ArrayDesign
from geometry.refusal import Refusal

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

#: s, standard deviation of what the stated delay of the reference is off by, alike at all points.
DELAY = 1e-3
#: Probability below which chi-squared, or the size of the parameters, speaks against the fit.
_SIGNIFICANCE = 1e-3
#: A combination of parameters counts as determined where the data say more of it than the prior.
_DETERMINED = 1.0
_ITERATIONS = 30
_LONGEST = 2.0  # of the steps of a parameter, in standard deviations: beyond, nothing is linear any more
_STEP = 1e-3  # of the central differences, in standard deviations


@dataclass(frozen=True)
class Priors:
    """Standard deviations of the logarithms of the parameters before anything was measured."""

    bore: float = 0.05
    """Of each tube."""
    compliance: float = 0.12
    """Of each node: of its membrane, which stands for its cavity too."""
    modulus: float = 0.15
    """Of all membranes together."""
    loss: float = 0.3
    """Of the loss factor of all membranes."""
    gain: float = 0.05
    """Of each microphone against the reference."""
    corner: float = 0.10
    """Of the high-pass of each microphone."""
    chamber: float = 0.10
    """Of the volume of each microphone's chamber."""

    def __post_init__(self) -> None:
        for field in fields(self):
            in_range(f"priors.{field.name}", getattr(self, field.name), 1e-6, 1.0)


class UpdatedModel:
    """The family of sensors among which the made one is looked for.

    Args:
        nominal: library of the nominal design, of any fidelity.
        priors: of the parameters.

    Raises:
        Refusal: a design that the lumped batch does not take.
    """

    def __init__(self, nominal: Library, priors: Priors | None = None) -> None:
        design: ArrayDesign = nominal.design
        self.library, self.priors = nominal, priors or Priors()
        self.frequency = nominal.frequency
        shared = Topology.of(design)
        self.topology = shared.individual()
        self.nominal_parameters = ArrayParameters.from_design(design, nominal.medium).individual(shared)
        self._vent = vent_ratio(design.microphone, self.frequency, nominal.medium)
        tubes, points = self.nominal_parameters.tube_radius.shape[1], self.nominal_parameters.cavity_radius.shape[1]
        microphones = len(design.microphones)
        #: Group -> how many parameters it has, in the order of the vector.
        self.sizes: Mapping[str, int] = {
            "bore": tubes,
            "compliance": points,
            "modulus": 1,
            "loss": 1,
            "gain": microphones,
            "corner": microphones,
            "chamber": microphones,
        }
        #: What each parameter is of.
        self.names = (
            *(f"bore of {name}" for name in self.topology.tube_names),
            *(f"compliance of point {number + 1}" for number in range(points)),
            "modulus of all membranes",
            "loss factor of all membranes",
            *(f"gain of microphone {name}" for name in design.microphones),
            *(f"high-pass of microphone {name}" for name in design.microphones),
            *(f"chamber of microphone {name}" for name in design.microphones),
        )
        h = nominal.transfer_function.transpose("point", "microphone", "frequency").values
        #: (count,) logarithm of a parameter's factor per standard deviation of its prior.
        self.scale = np.repeat([getattr(self.priors, name) for name in self.sizes], list(self.sizes.values()))
        self._ratio = h / self._lumped(np.zeros((1, self.count)))[0]

    @property
    def count(self) -> int:
        """Number of parameters."""
        return sum(self.sizes.values())

    def transfer_function(self, u: Any) -> Any:
        """Transfer functions of sensors with parameters u; NumPy arrays, or torch tensors that can be differentiated.

        Args:
            u: (n_sensor, count) float64, in standard deviations of the priors.

        Returns:
            (n_sensor, n_point, n_microphone, n_freq) complex128, Pa/Pa.
        """
        return self._lumped(u) * namespace(u).asarray(self._ratio)

    def _lumped(self, u: Any) -> Any:
        xp = namespace(u)
        nominal = self.nominal_parameters.map(xp.asarray)
        factor: dict[str, Any] = {}
        first = 0
        for name, size in self.sizes.items():
            factor[name] = xp.exp(getattr(self.priors, name) * u[:, first : first + size])
            first += size
        stiffness = factor["modulus"]
        parameters = replace(
            nominal,
            tube_radius=nominal.tube_radius * factor["bore"],
            membrane_compliance=nominal.membrane_compliance * factor["compliance"] / stiffness,
            membrane_frequency=nominal.membrane_frequency * xp.sqrt(stiffness)[:, :, None],
            membrane_loss=nominal.membrane_loss * factor["loss"],
            chamber_height=nominal.chamber_height * factor["chamber"],
            vent_admittance=nominal.vent_admittance * factor["corner"],
        )
        h = batch_transfer_function(parameters, self.topology, self.frequency, self.library.medium)
        vent = xp.asarray(self._vent)
        # the microphone's high-pass by the nominal one
        passed = (1 + vent) / (factor["corner"][:, :, None] + vent)
        return h * (factor["gain"][:, :, None] * passed)[:, None]

    def jacobian(self, u: Array) -> Complex:
        """(count, n_point, n_microphone, n_freq) derivatives at u, by central differences of one batch."""
        steps = _STEP * np.eye(self.count)
        h = self.transfer_function(np.concatenate([u + steps, u - steps]))
        return np.asarray((h[: self.count] - h[self.count :]) / (2 * _STEP))


@dataclass(frozen=True, eq=False, kw_only=True)
class Posterior:
    """The most probable sensor of a family, and how far it is known."""

    model: UpdatedModel
    parameters: Array
    """(count,) in standard deviations of the priors."""
    covariance: Array
    """(count, count) of them after the measurement."""
    eigenvalues: Array
    """(count,) ascending: what the data say of a combination, by what the prior says."""
    directions: Array
    """(count, count) those combinations, in columns."""

    @classmethod
    def of(cls, model: UpdatedModel, parameters: Array, information: Array, **rest: Any) -> Self:
        """At the most probable parameters, from what the data say of them, (count, count), by what the priors say."""
        eigenvalues, directions = np.linalg.eigh(information)
        return cls(
            model=model,
            parameters=parameters,
            covariance=np.asarray(np.linalg.inv(information + np.eye(model.count)), np.float64),
            eigenvalues=np.maximum(eigenvalues, 0),
            directions=np.asarray(directions, np.float64),
            **rest,
        )

    @property
    def ratios(self) -> dict[str, tuple[float, float]]:
        """Parameter -> factor by which it differs from nominal, and the standard deviation of its logarithm."""
        scale = self.model.scale
        known = np.sqrt(np.diag(self.covariance))
        values = zip(self.model.names, np.exp(scale * self.parameters), scale * known, strict=True)
        return {name: (float(value), float(deviation)) for name, value, deviation in values}

    @property
    def farthest(self) -> str:
        """The parameters farthest off, at most three: "gain of microphone A x 1.41, 6.9 deviations"."""
        order = np.argsort(-np.abs(self.parameters))[:3]
        names, ratios = self.model.names, self.ratios
        return "; ".join(
            f"{names[k]} x {ratios[names[k]][0]:.2f}, {abs(self.parameters[k]):.1f} deviations"
            for k in order
            if abs(self.parameters[k]) > abs(self.parameters[order[0]]) / 2
        )

    @property
    def undetermined(self) -> tuple[str, ...]:
        """Combinations of parameters of which the data say less than the priors, the least known first.

        Each names its parts with a weight of at least a third of the largest, at most six.
        """
        texts = []
        for value, direction in zip(self.eigenvalues, self.directions.T, strict=True):
            if value >= _DETERMINED:
                break
            order = np.argsort(-np.abs(direction))[:6]
            kept = [k for k in order if abs(direction[k]) >= abs(direction[order[0]]) / 3]
            sign = np.sign(direction[kept[0]])
            terms = [f"{sign * direction[k]:+.2f} {self.model.names[k]}" for k in kept]
            texts.append(" ".join(terms))
        return tuple(texts)

    def summary(self) -> dict[str, Any]:
        """Plain values for a report."""
        return {
            "parameters": {
                name: {"ratio": ratio, "log_deviation": known} for name, (ratio, known) in self.ratios.items()
            },
            "determined_combinations": int((self.eigenvalues >= _DETERMINED).sum()),
            "undetermined_combinations": list(self.undetermined),
        }

    @cached_property
    def transfer_function(self) -> Complex:
        """(n_point, n_microphone, n_freq) of the most probable sensor, Pa/Pa."""
        return np.asarray(self.model.transfer_function(self.parameters[None])[0])

    @cached_property
    def deviation(self) -> Array:
        """(n_point, n_microphone, n_freq) standard deviation of its real part, and of its imaginary part.

        By the posterior covariance, to first order, and by what the model is trusted to.
        """
        j = self.model.jacobian(self.parameters)
        flat = j.reshape(len(j), -1)
        spread = np.einsum("af,ab,bf->f", flat.conj(), self.covariance, flat, optimize=True).real
        h = np.abs(self.transfer_function)
        return np.asarray(np.sqrt(spread.reshape(h.shape) / 2 + (TOTAL * h) ** 2 / 2))


@dataclass(frozen=True, eq=False, kw_only=True)
class Update(Posterior):
    """The sensor that measured transfer functions speak for; its eigenvalues are those of J^T J."""

    points: tuple[int, ...]
    """Numbers of the measured points."""
    chi_squared: float
    """|r|^2 + |u|^2 at the solution."""
    residuals: int
    """Number of residuals, real and imaginary parts."""
    worst_point: int
    """Number of the measured point that is farthest from the fit."""
    delay: float
    """s that the array's microphones came later than stated, against the reference."""
    iterations: int

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
    if not points:
        raise Refusal("estimates is empty; a fit needs at least one measured point")
    shape = model._ratio.shape
    for number in points:
        in_range("point", number, 1, shape[0])
        found = estimates[number].transfer_function.shape
        if found != shape[1:]:
            raise Refusal(f"point {number} has an estimate of shape {found}; it must be {shape[1:]}")
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
        raise Refusal(f"point {number} has a transfer function of {h.min()} Pa/Pa; it must be finite and not 0")
    if not (np.isfinite(deviation).all() and deviation.min() >= 0):
        raise Refusal(f"point {number} has a deviation of {deviation.min()} Pa/Pa; it must be finite, 0 or above")


class _Minimum(NamedTuple):
    v: Array
    value: float
    iterations: int


class _Fitted:
    """What would be measured of some points: parameters v (count + 1,), the last one the delay of the reference.

    Args:
        model: the family.
        rows: of the points.
        measured: (n_point, n_microphone, n_freq) Pa/Pa.
    """

    def __init__(self, model: UpdatedModel, rows: list[int], measured: Complex) -> None:
        self.model, self.rows, self.measured = model, rows, measured
        self._turn = -2j * np.pi * model.frequency * DELAY

    def expected(self, v: Array) -> Complex:
        h = self.model.transfer_function(v[None, :-1])[0][self.rows]
        return np.asarray(h * np.exp(self._turn * v[-1]))

    def jacobian(self, v: Array) -> Complex:
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
