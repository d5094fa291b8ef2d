"""A model fitted to measurements: its priors, its fitted values and their posterior."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields, replace
from functools import cached_property
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from acoustic_fem.batch.network import batch_transfer_function
from acoustic_fem.batch.numpy_or_torch import namespace
from acoustic_fem.batch.parameters import ArrayParameters
from acoustic_fem.batch.topology import Topology
from acoustic_fem.calibration.model_discrepancy import TOTAL
from acoustic_fem.duct.leak import leak_conductance
from acoustic_fem.library.transfer_functions import Library
from acoustic_fem.network.microphone import vent_ratio
from geometry.design.array_design import ArrayDesign
from geometry.ground.argument_checks import check_range
from geometry.ground.typed import Array, ComplexArray

#: A combination of parameters counts as determined where the data say more of it than the prior.
_DETERMINED = 1.0


#: Radius and length of the leak that a tight cavity is given where leaks are fitted, m: 0.1 to 0.3 % of the transfer
#: functions of array-2x6.
_LEAST_LEAK = (10e-6, 1e-3)


_STEP = 1e-3  # of the central differences, in standard deviations


@dataclass(frozen=True)
class PartScatter:
    """Relative standard deviations of parts that a sensor scatters by and a fit looks for."""

    bore: float = 0.05
    """Relative deviation of the bore of each tube."""
    gain: float = 0.05
    """Relative deviation of the gain of each microphone against the reference."""
    corner: float = 0.10
    """Relative deviation of the high-pass corner of each microphone."""
    chamber: float = 0.10
    """Relative deviation of the volume of each microphone's chamber."""


@dataclass(frozen=True)
class Priors(PartScatter):
    """Standard deviations of the logarithms of the parameters before anything was measured."""

    compliance: float = 0.12
    """Deviation, of one, of the compliance of each node: of its membrane, which stands for its cavity too."""
    modulus: float = 0.15
    """Deviation, of one, of the modulus of all membranes together."""
    loss: float = 0.3
    """Deviation of the loss factor of all membranes together; their modulus changes over frequency as it asks for."""
    leak: float = 0.0
    """Deviation of the leak of each cavity, 0 to 5, about the designed one and that of a bore of 20 um, 1 mm long; 0:
    leaks are as designed and not fitted. With 2 a bore of 50 um is 1.6 deviations off."""

    def __post_init__(self) -> None:
        for field in fields(self):
            least, most = (0.0, 5.0) if field.name == "leak" else (1e-6, 1.0)
            check_range(f"priors.{field.name}", getattr(self, field.name), least, most)


@dataclass(frozen=True, eq=False)
class KnownParts:
    """Knowledge of the membranes of one sensor from its build: they differ from nominal, and are known better."""

    compliance: Array
    """Logarithm of the compliance of each membrane by the nominal one at the same modulus, (n_point,) float64."""
    compliance_deviation: Array
    """Standard deviation of that logarithm, what scatters at the point beside included, (n_point,) float64."""
    batch: NDArray[np.int64]
    """Batch of silicone of each membrane, (n_point,), from 0."""
    names: tuple[str, ...]
    """Name of each batch."""
    modulus: Array
    """Logarithm of the modulus of each batch by the nominal one, (n_batch,) float64."""
    modulus_deviation: Array
    """Standard deviation of that logarithm, (n_batch,) float64."""


class UpdatedModel:
    """The family of sensors among which the made one is looked for.

    Args:
        nominal: library of the nominal design, of any fidelity.
        priors: of the parameters.
        known: knowledge of the membranes from the build; by default all are nominal and of one batch.

    Raises:
        Refusal: a design that the lumped batch does not take.
    """

    def __init__(self, nominal: Library, priors: Priors | None = None, known: KnownParts | None = None) -> None:
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
            "modulus": 1 if known is None else len(known.names),
            "loss": 1,
            "gain": microphones,
            "corner": microphones,
            "chamber": microphones,
            "leak": points if self.priors.leak else 0,
        }
        #: Group of each parameter.
        self.groups = tuple(group for group, size in self.sizes.items() for _ in range(size))
        #: Part of the array that each parameter belongs to.
        self.names = (
            *(f"bore of {name}" for name in self.topology.tube_names),
            *(f"compliance of point {number + 1}" for number in range(points)),
            *_modulus_names(known),
            "loss factor of all membranes",
            *(f"gain of microphone {name}" for name in design.microphones),
            *(f"high-pass of microphone {name}" for name in design.microphones),
            *(f"chamber of microphone {name}" for name in design.microphones),
            *(f"leak of point {number + 1}" for number in range(self.sizes["leak"])),
        )
        #: Unit of the leaks that are fitted, (1, n_point or 1) float64, m^3/(Pa s).
        self._leak = self.nominal_parameters.leak_conductance
        if self.priors.leak:
            self._leak = self._leak + leak_conductance(*_LEAST_LEAK, nominal.medium)
        h = nominal.transfer_function.transpose("point", "microphone", "frequency").values
        #: (count,) logarithm of a parameter's factor per standard deviation of its prior.
        self.scale = np.array([getattr(self.priors, group) for group in self.groups], np.float64)
        #: (count,) logarithm of a parameter's factor that is expected before anything was measured.
        self.mean = np.zeros(self.count)
        self._batch = np.zeros(points, np.int64)
        if known is not None:
            of_membranes = {
                "compliance": (known.compliance, known.compliance_deviation),
                "modulus": (known.modulus, known.modulus_deviation),
            }
            for group, (mean, deviation) in of_membranes.items():
                own = [number for number, name in enumerate(self.groups) if name == group]
                self.mean[own], self.scale[own] = mean, deviation
            self._batch = known.batch
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
        xp = namespace(u)
        return self._lumped(xp.asarray(self.mean) + xp.asarray(self.scale) * u) * xp.asarray(self._ratio)

    def _lumped(self, logarithms: Any) -> Any:
        """Transfer functions of the lumped network for logarithms of the factors of its parameters."""
        xp = namespace(logarithms)
        nominal = self.nominal_parameters.map(xp.asarray)
        factor: dict[str, Any] = {}
        first = 0
        for name, size in self.sizes.items():
            if not size:
                continue
            factor[name] = xp.exp(logarithms[:, first : first + size])
            first += size
        stiffness = factor["modulus"][:, self._batch]
        parameters = replace(
            nominal,
            tube_radius=nominal.tube_radius * factor["bore"],
            membrane_compliance=nominal.membrane_compliance * factor["compliance"] / stiffness,
            membrane_frequency=nominal.membrane_frequency * xp.sqrt(stiffness)[:, :, None],
            membrane_loss=nominal.membrane_loss * factor["loss"],
            membrane_relaxation=nominal.membrane_relaxation * factor["loss"][:, :, None],
            chamber_height=nominal.chamber_height * factor["chamber"],
            vent_admittance=nominal.vent_admittance * factor["corner"],
            leak_conductance=xp.asarray(self._leak) * factor.get("leak", 1.0),
        )
        h = batch_transfer_function(parameters, self.topology, self.frequency, self.library.medium)
        vent = xp.asarray(self._vent)
        # the microphone's high-pass by the nominal one
        passed = (1 + vent) / (factor["corner"][:, :, None] + vent)
        return h * (factor["gain"][:, :, None] * passed)[:, None]

    def jacobian(self, u: Array) -> ComplexArray:
        """Derivatives of the transfer functions by the parameters, by central differences of one batch.

        Args:
            u: (count,) float64, in standard deviations of the priors.

        Returns:
            (count, n_point, n_microphone, n_freq) complex128, Pa/Pa.
        """
        steps = _STEP * np.eye(self.count)
        h = self.transfer_function(np.concatenate([u + steps, u - steps]))
        return np.asarray((h[: self.count] - h[self.count :]) / (2 * _STEP))


def _modulus_names(known: KnownParts | None) -> tuple[str, ...]:
    """Names of the moduli: one of all membranes, or one of each batch."""
    if known is None or len(known.names) == 1:
        return ("modulus of all membranes",)
    return tuple(f"modulus of batch {name}" for name in known.names)


@dataclass(frozen=True, eq=False, kw_only=True)
class Posterior:
    """The most probable sensor of a family, and how far it is known."""

    model: UpdatedModel
    """The family."""
    parameters: Array
    """Most probable parameters, (count,) float64, in standard deviations of the priors."""
    covariance: Array
    """Covariance of the parameters after the measurement, (count, count) float64, in the same units."""
    eigenvalues: Array
    """Information of the data on a combination of parameters, relative to the prior, (count,) float64, ascending."""
    directions: Array
    """Those combinations, (count, count) float64, in columns."""

    @classmethod
    def of(cls, model: UpdatedModel, parameters: Array, information: Array, **rest: Any) -> Self:
        """Posterior at the most probable parameters, (count,) in units of their priors.

        From the information of the data on them, (count, count) float64.
        """
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
        """Factor by which each parameter differs from nominal, and the standard deviation of its logarithm."""
        scale = self.model.scale
        known = np.sqrt(np.diag(self.covariance))
        factors = np.exp(self.model.mean + scale * self.parameters)
        values = zip(self.model.names, factors, scale * known, strict=True)
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
    def transfer_function(self) -> ComplexArray:
        """Transfer functions of the most probable sensor, (n_point, n_microphone, n_freq) complex128, Pa/Pa."""
        return np.asarray(self.model.transfer_function(self.parameters[None])[0])

    @cached_property
    def deviation(self) -> Array:
        """Standard deviation of the real part, and of the imaginary part, of those transfer functions,
        (n_point, n_microphone, n_freq) float64, Pa/Pa.

        By the posterior covariance, to first order, and by what the model is trusted to.
        """
        j = self.model.jacobian(self.parameters)
        flat = j.reshape(len(j), -1)
        spread = np.einsum("af,ab,bf->f", flat.conj(), self.covariance, flat, optimize=True).real
        h = np.abs(self.transfer_function)
        return np.asarray(np.sqrt(spread.reshape(h.shape) / 2 + (TOTAL * h) ** 2 / 2))
