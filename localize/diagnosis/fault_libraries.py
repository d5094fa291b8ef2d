"""Transfer functions of a sensor with each of its faults, and their derivatives by the tolerances and the air."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from acoustic_fem import Library
from acoustic_fem.batch.network import batch_transfer_function
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


@dataclass(frozen=True, eq=False)
class Tables:
    """Transfer functions of one hypothesis about its deviations."""

    fault: SensorFault | None
    """The fault; None for a sound sensor."""
    deviations: Array
    """Deviations about which the tables are, (n_deviation,) float64, standard deviations."""
    transfer_function: ComplexArray
    """(n_point, n_microphone, n_freq) complex128, Pa/Pa."""
    derivatives: ComplexArray
    """Derivatives of their logarithms, (n_deviation, n_point, n_microphone, n_freq) complex128."""

    @cached_property
    def spread(self) -> ComplexArray:
        """Covariance of the logarithms by the deviations, (n_point, n_microphone, n_microphone, n_freq) complex128."""
        return np.asarray(np.einsum("dpmf,dpnf->pmnf", self.derivatives, self.derivatives.conj()))

    @cached_property
    def relative(self) -> ComplexArray:
        """Derivatives over those of the first microphone, (n_deviation, n_point, n_microphone - 1, n_freq)."""
        return np.ascontiguousarray(self.derivatives[:, :, 1:] - self.derivatives[:, :, :1])

    def at(self, deviations: Array) -> ComplexArray:
        """Transfer functions with deviations (n_deviation,), to first order in their logarithms."""
        change = np.tensordot(deviations - self.deviations, self.derivatives, 1)
        return np.asarray(self.transfer_function * np.exp(change))


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

    def about(self, fault: SensorFault | None, deviations: Array) -> Tables:
        """Tables of a hypothesis about deviations (n_deviation,), with derivatives of its own."""
        half = 0.5
        moved = deviations + half * np.concatenate([np.zeros((1, self.size)), np.eye(self.size)])
        found = self.with_deviations([fault], moved)
        return Tables(fault, deviations, found[0], np.asarray(np.log(found[1:] / found[0]) / half))

    def nearer(self, tables: Sequence[Tables], deviations: Sequence[Array]) -> list[Tables]:
        """Tables of hypotheses computed about other deviations (n_deviation,) each, whose derivatives stay."""
        found = self.with_deviations([each.fault for each in tables], np.stack(deviations))
        return [
            Tables(each.fault, own, h, each.derivatives) for each, own, h in zip(tables, deviations, found, strict=True)
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
        sound = self.about(None, np.zeros(self.size))
        half = 0.5
        moved = self.with_deviations(self.hypotheses, half * np.eye(self.size)[-1:])
        found = []
        for fault, own, more in zip(self.hypotheses, self.tables, moved, strict=True):
            derivatives = sound.derivatives.copy()
            derivatives[-1] = np.log(more / own) / half
            found.append(Tables(fault, sound.deviations, own, derivatives))
        return tuple(found)

    def of(self, fault: SensorFault | None) -> Tables:
        """Tables of a hypothesis about no deviations, with derivatives of its own; kept."""
        if fault not in self._kept:
            self._kept[fault] = self.about(fault, np.zeros(self.size))
        return self._kept[fault]

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
        parts: list[ArrayParameters] = [
            _row(whole, k) if fault is None else fault.of_parts(_row(whole, k), self.medium)
            for k, fault in enumerate(faults)
        ]
        joined = ArrayParameters(
            **{name: np.concatenate([getattr(each, name) for each in parts]) for name in vars(parts[0])}
        )
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", ModelLimitWarning)
            h = np.asarray(batch_transfer_function(joined, self._scattered.topology, frequency, around.medium))
        gain, corner = np.moveaxis(self._scattered.microphones(draws), 1, 0)[:, :, None, :, None]
        vent = vent_ratio(self.design.microphone, frequency, self.medium)
        h = h * gain * (1 + 1 / vent) / (1 + corner / vent)
        return np.stack([each if fault is None else fault.of_microphones(each)
                         for each, fault in zip(h, faults, strict=True)])  # fmt: skip

    def _around(self, steps: Array) -> DrawnAirAndRubber:
        """Air and slope of the rubber of sensors, by deviations (n, 3)."""
        options, media = self.options, []
        air = self.design.air
        base = LocalAir(self.medium.pressure, temperature_c=air.temperature)
        exact = medium_of(base, self.design)
        for pressure, temperature, _ in steps:
            if not pressure and not temperature:
                media.append(self.medium)
                continue
            moved = medium_of(
                LocalAir(
                    float(np.clip(self.medium.pressure + pressure * options.pressure, 5e4, 1.2e5)),
                    temperature_c=float(np.clip(air.temperature + temperature * options.temperature, -19.0, 59.0)),
                ),
                self.design,
            )
            media.append(Medium(**{name: getattr(self.medium, name) * getattr(moved, name) / getattr(exact, name)
                                   for name in vars(exact)}))  # fmt: skip
        slope = np.maximum(1 + options.slope * steps[:, 2], 0.0)
        return DrawnAirAndRubber(MediumParameters.from_media(media), slope, np.ones(len(steps)))


def _rows(parameters: ArrayParameters, count: int) -> ArrayParameters:
    """Parameters with a row of their own for each of so many sensors."""
    return parameters.map(lambda values: np.broadcast_to(values, (count, *values.shape[1:])))


def _row(parameters: ArrayParameters, number: int) -> ArrayParameters:
    return parameters.map(lambda values: values[number : number + 1])
