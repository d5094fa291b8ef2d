"""Transfer functions of a sensor with each of its faults, and their derivatives by the tolerances and the air."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from acoustic_fem import Library
from acoustic_fem.batch.distinct_parts import transfer_function_of_distinct_parts
from acoustic_fem.batch.parameters import ArrayParameters, MediumParameters
from acoustic_fem.library.transfer_functions import MEASURED
from acoustic_fem.network.microphone import vent_ratio
from acoustic_fem.quantities.audible import audible_ratio
from acoustic_fem.quantities.local_air import LocalAir, medium_of
from acoustic_fem.quantities.medium import Medium
from acoustic_fem.quantities.model_limit_warning import ModelLimitWarning
from acoustic_fem.scatter.air_and_rubber import DrawnAirAndRubber
from acoustic_fem.scatter.tolerances import QUANTITIES, ScatteredDesign
from geometry.ground.typed import Array, ComplexArray
from localize.diagnosis.diagnosis_options import DiagnosisOptions
from localize.diagnosis.faults import SensorFault, single_faults
from localize.signals.array_response import response_of

FITTED = (
    "bore",
    "cavity_height",
    "modulus_of_part",
    "modulus_of_batch",
    "chamber_height",
    "microphone_gain",
    "microphone_corner",
)
"""Quantities whose deviations are fitted, if the tolerances have them."""
AROUND = ("pressure", "temperature", "rubber_slope")
"""Deviations of the air and of the rubber, in the order of their columns."""
_TOGETHER = 8
"""Number of hypotheses whose derivatives are computed in one batch."""


@dataclass(frozen=True, eq=False)
class Derivatives:
    """Derivatives by all deviations but the amount of a fault, of the logarithms of transfer functions over those of
    the first microphone.
    """

    values: ComplexArray
    """(n_deviation - 1, n_point, n_microphone - 1, n_freq) complex128."""

    @cached_property
    def spread(self) -> ComplexArray:
        """Covariance of the logarithms, (n_point, n_microphone - 1, n_microphone - 1, n_freq) complex128."""
        return np.asarray(np.einsum("dpmf,dpnf->pmnf", self.values, self.values.conj()))


@dataclass(frozen=True, eq=False)
class Tables:
    """Transfer functions of one hypothesis about its deviations.

    A touch may have any spectrum, so a factor that all microphones of a point share does not count. Therefore only
    what changes over the first microphone is kept.
    """

    fault: SensorFault | None
    """The fault; None for a sound sensor."""
    deviations: Array
    """Deviations about which the tables are, (n_deviation,) float64, standard deviations."""
    transfer_function: ComplexArray
    """(n_point, n_microphone, n_freq) complex128, Pa/Pa."""
    derivatives: Derivatives
    """Derivatives by all deviations but the last; hypotheses may share them."""
    by_amount: ComplexArray
    """Those by the amount of the fault, the last deviation, (n_point, n_microphone - 1, n_freq) complex128."""

    @property
    def spread(self) -> ComplexArray:
        """Covariance of the logarithms over those of the first microphone, by the deviations.

        (n_point, n_microphone - 1, n_microphone - 1, n_freq) complex128.
        """
        return self.derivatives.spread + self.by_amount[:, :, None] * self.by_amount[:, None].conj()

    def at(self, deviations: Array) -> ComplexArray:
        """Transfer functions with deviations (n_deviation,), to first order in their logarithms.

        The first microphone keeps its own, so all of a point have a factor in common.
        """
        step, values = deviations - self.deviations, self.derivatives.values
        change = (step[:-1] @ values.reshape(len(values), -1).view(np.float64)).view(np.complex128)
        found = self.transfer_function.copy()
        found[:, 1:] *= np.exp(change.reshape(self.by_amount.shape) + step[-1] * self.by_amount)
        return found

    def derivatives_times(self, turned: ComplexArray, out: ComplexArray) -> None:
        """Put products of all derivatives into ``out``, with rows that are turned, summed over the microphones.

        Args:
            turned: (n_point, n_row, n_microphone - 1, n_freq) complex128.
            out: (n_deviation, n_point, n_row, n_freq) complex128.
        """
        for k in range(turned.shape[2]):
            for values, found in ((self.derivatives.values, out[:-1]), (self.by_amount[None], out[-1:])):
                if k:
                    found += values[:, :, None, k] * turned[:, :, k]
                else:
                    np.multiply(values[:, :, None, k], turned[:, :, k], out=found)


class FaultLibraries:
    """Transfer functions of a design with each fault, by the closed forms, times what a library differs from these.

    Args:
        library: of a design whose scatter is known.
        options: of the diagnosis.

    Raises:
        Refusal: a design whose scatter is not known, or frequencies that do not cover 1 to 100 Hz.
    """

    def __init__(self, library: Library, options: DiagnosisOptions) -> None:
        self.design, self.options = library.design, options
        self.medium: Medium = library.medium
        """Air about which the deviations of the air are."""
        self._scattered = ScatteredDesign(library.design, options.tolerances)
        named = {each.quantity for each in options.tolerances}
        sizes = {
            "tube": self._scattered.nominal.tube_radius.shape[1],
            "point": library.design.point_count,
            "array": 1,
            "microphone": len(library.design.microphones),
        }
        self.entries = [(name, part) for name in FITTED if name in named for part in range(sizes[QUANTITIES[name]])]
        """Quantity and index of the part of each deviation but those of the air, of the rubber and of the fault."""
        self.size = len(self.entries) + len(AROUND) + 1
        """Number of deviations; the last is that of the amount of the fault."""
        self._kept: dict[SensorFault | None, Tables] = {}
        self._step = options.calibrated_fraction if library.fidelity == MEASURED else 1.0
        grid = np.unique(np.geomspace(*options.band, options.frequencies).round().astype(np.int64))
        self.frequency: NDArray[np.int64] = grid[~np.isin(grid, options.mains)]
        """Frequencies that are compared, (n_freq,) Hz."""
        response = response_of(library)
        known = response.between(self.frequency.astype(np.float64))[0]
        self._correction = audible_ratio(known, self._closed_forms([None], np.zeros((1, self.size)))[0])

    @property
    def deviation_sizes(self) -> Array:
        """Standard deviation of every deviation, (n_deviation,) float64: of ratios, Pa, K; 1 for the last."""
        size = {each.quantity: each.deviation * self._step for each in self.options.tolerances}
        around = (self.options.pressure, self.options.temperature, self.options.slope, 1.0)
        return np.array([*(size[name] for name, _ in self.entries), *around])

    @cached_property
    def faults(self) -> tuple[tuple[SensorFault, ...], ...]:
        """All faults that are looked for, those of one part together."""
        return single_faults(self.design)

    @cached_property
    def tables(self) -> ComplexArray:
        """Transfer functions of the sound sensor and of every fault, in the order of :attr:`hypotheses`.

        (n_hypothesis, n_point, n_microphone, n_freq) complex128, Pa/Pa.
        """
        return self.with_deviations(self.hypotheses, np.zeros((1, self.size)))

    @cached_property
    def hypotheses(self) -> tuple[SensorFault | None, ...]:
        """The sound sensor, None, and every fault with every amount."""
        return (None, *(fault for part in self.faults for fault in part))

    def about(self, faults: Sequence[SensorFault | None], deviations: Sequence[Array]) -> list[Tables]:
        """Tables of hypotheses about deviations (n_deviation,) each, with derivatives of their own."""
        half = 0.5
        steps = half * np.concatenate([np.zeros((1, self.size)), np.eye(self.size)])
        moved = np.concatenate([own + steps for own in deviations])
        found = self.with_deviations([fault for fault in faults for _ in steps], moved)
        tables = []
        for fault, own, h in zip(faults, deviations, np.split(found, len(faults)), strict=True):
            changed = np.log(h[1:] / h[0])
            changed = (changed[:, :, 1:] - changed[:, :, :1]) / half
            tables.append(Tables(fault, own, h[0], Derivatives(changed[:-1]), changed[-1]))
        return tables

    def nearer(self, tables: Sequence[Tables], deviations: Sequence[Array]) -> list[Tables]:
        """Tables of hypotheses computed about other deviations (n_deviation,) each, whose derivatives stay."""
        found = self.with_deviations([each.fault for each in tables], np.stack(deviations))
        return [
            replace(each, deviations=own, transfer_function=h)
            for each, own, h in zip(tables, deviations, found, strict=True)
        ]

    @property
    def batch_deviation(self) -> Array:
        """Deviations of a sensor whose membranes are all one standard deviation stiffer, (n_deviation,) float64."""
        found = np.zeros(self.size)
        found[: len(self.entries)] = [name == "modulus_of_batch" for name, _ in self.entries]
        return found

    @cached_property
    def screening(self) -> tuple[Tables, ...]:
        """Tables of all hypotheses with the derivatives of the sound sensor, beside those by their own amounts."""
        (sound,) = self.about([None], [np.zeros(self.size)])
        half = 0.5
        moved = self.with_deviations(self.hypotheses, half * np.eye(self.size)[-1:])
        changed = np.log(moved / self.tables)
        by_amount = (changed[:, :, 1:] - changed[:, :, :1]) / half
        return tuple(
            replace(sound, fault=fault, transfer_function=own, by_amount=changed)
            for fault, own, changed in zip(self.hypotheses, self.tables, by_amount, strict=True)
        )

    def of(self, faults: Sequence[SensorFault | None]) -> list[Tables]:
        """Tables of hypotheses about no deviations, with derivatives of their own; kept."""
        missing = [fault for fault in dict.fromkeys(faults) if fault not in self._kept]
        for first in range(0, len(missing), _TOGETHER):
            some = missing[first : first + _TOGETHER]
            self._kept |= zip(some, self.about(some, [np.zeros(self.size)] * len(some)), strict=True)
        return [self._kept[fault] for fault in faults]

    def with_deviations(self, faults: Sequence[SensorFault | None], deviations: Array) -> ComplexArray:
        """Transfer functions of sensors with faults and deviations.

        Args:
            faults: None for none; as many as deviations, or one of the two alone.
            deviations: (n, n_deviation) or (1, n_deviation) float64, in standard deviations.

        Returns:
            (n, n_point, n_microphone, n_freq) complex128, Pa/Pa.
        """
        return np.asarray(self._closed_forms(faults, deviations) * self._correction)

    def _closed_forms(self, faults: Sequence[SensorFault | None], deviations: Array) -> ComplexArray:
        count = max(len(faults), len(deviations))
        faults = list(faults) * (count if len(faults) == 1 else 1)
        steps = np.broadcast_to(deviations * self._step, (count, self.size))
        draws = {name: np.zeros((count, 1)) for name in QUANTITIES}
        for name in {name for name, _ in self.entries}:
            draws[name] = steps[:, [k for k, entry in enumerate(self.entries) if entry[0] == name]]
        around = self._around(np.broadcast_to(deviations, (count, self.size))[:, len(self.entries) : -1])
        amounts = np.broadcast_to(deviations, (count, self.size))[:, -1]
        faults = [None if each is None else each.with_amount(float(z)) for each, z in zip(faults, amounts, strict=True)]
        whole = around.changed(_rows(self._scattered.parameters(draws), count))
        frequency = self.frequency.astype(np.float64)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", ModelLimitWarning)
            broken = self._with_broken_parts(whole, faults)
            h = transfer_function_of_distinct_parts(broken, self._scattered.topology, frequency, around.medium)
        gain, corner = np.moveaxis(self._scattered.microphones(draws), 1, 0)[:, :, None, :, None]
        vent = vent_ratio(self.design.microphone, frequency, self.medium)
        h = h * gain * (1 + 1 / vent) / (1 + corner / vent)
        return np.stack([each if fault is None else fault.of_microphones(each)
                         for each, fault in zip(h, faults, strict=True)])  # fmt: skip

    def _with_broken_parts(self, whole: ArrayParameters, faults: Sequence[SensorFault | None]) -> ArrayParameters:
        """Parameters of sensors, each with its fault; rows of equal faults are changed together."""
        rows: dict[SensorFault, list[int]] = {}
        for number, fault in enumerate(faults):
            if fault is not None:
                rows.setdefault(fault, []).append(number)
        radius, conductance = whole.tube_radius.copy(), whole.leak_conductance.copy()
        for fault, own in rows.items():
            broken = fault.of_parts(_chosen(whole, own), self.medium)
            radius[own], conductance[own] = broken.tube_radius, broken.leak_conductance
        return replace(whole, tube_radius=radius, leak_conductance=conductance)

    def _around(self, steps: Array) -> DrawnAirAndRubber:
        """Air and slope of the rubber of sensors, by deviations (n, 3)."""
        options = self.options
        pairs = [tuple(pair) for pair in steps[:, :2].tolist()]
        by_pair = {pair: self._air(*pair) for pair in set(pairs)}
        media = [by_pair[pair] for pair in pairs]
        slope = np.maximum(1 + options.slope * steps[:, 2], 0.0)
        return DrawnAirAndRubber(MediumParameters.from_media(media), slope, np.ones(len(steps)))

    def _air(self, pressure: float, temperature: float) -> Medium:
        """Air by deviations of its pressure and its temperature."""
        options, air = self.options, self.design.air
        if not pressure and not temperature:
            return self.medium
        exact = medium_of(LocalAir(self.medium.pressure, temperature_c=air.temperature), self.design)
        moved = medium_of(
            LocalAir(
                min(max(self.medium.pressure + pressure * options.pressure, 5e4), 1.2e5),
                temperature_c=min(max(air.temperature + temperature * options.temperature, -19.0), 59.0),
            ),
            self.design,
        )
        ratios = {name: getattr(moved, name) / getattr(exact, name) for name in vars(exact)}
        return Medium(**{name: getattr(self.medium, name) * ratio for name, ratio in ratios.items()})


def _rows(parameters: ArrayParameters, count: int) -> ArrayParameters:
    """Parameters with a row of their own for each of so many sensors."""
    return parameters.map(lambda values: np.broadcast_to(values, (count, *values.shape[1:])))


def _chosen(parameters: ArrayParameters, rows: Sequence[int]) -> ArrayParameters:
    """Parameters of some of the sensors."""
    return parameters.map(lambda values: values[rows])
