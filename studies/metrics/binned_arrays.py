"""Transfer functions of designs, and of as-built sensors about them, in bins: several designs in one batch."""

from __future__ import annotations

import warnings
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from functools import lru_cache
from itertools import islice

import numpy as np

from acoustic_fem.batch.network import batch_response
from acoustic_fem.batch.parameters import joined_rows
from acoustic_fem.library.touch_pressure import membranes_in_vacuo
from acoustic_fem.membrane.design_discs import design_disc, design_rubber
from acoustic_fem.membrane.disc import DiscResponse, KnownDiscs
from acoustic_fem.quantities.local_air import design_air
from acoustic_fem.quantities.model_limit_warning import ModelLimitWarning
from acoustic_fem.scatter.air_and_rubber import DrawnAirAndRubber
from acoustic_fem.scatter.as_built_sensors import AsBuiltSensors, DrawnSensors, batch_of_sensors
from acoustic_fem.scatter.tolerances import UNCALIBRATED, ScatteredDesign, Tolerance
from geometry.design.array_design import ArrayDesign
from geometry.ground.typed import Array, ComplexArray
from geometry.schema.array_fields import Air
from localize.decoders.decoder_options import HypothesisOptions
from localize.signals.stimulus import SCALED_AT
from studies.metrics.binned_decoder import BinnedHypotheses, BinnedOptions, binned_hypotheses
from studies.metrics.touch_bins import BINS, NODES, from_nodes

SILENT = 1e-9
"""Transfer function below which a microphone detects nothing of a point, Pa/Pa."""
_FREQUENCIES = np.sort(np.concatenate([NODES, BINS]))
_AT_NODES, _AT_BINS = np.searchsorted(_FREQUENCIES, NODES), np.searchsorted(_FREQUENCIES, BINS)
_BATCH = 100_000
"""Transfer functions (sensors x points x nodes) that are computed at once."""
_DRAWN: dict[tuple[Air, int], DrawnAirAndRubber] = {}


class BinnedArray:
    """Transfer functions of a design in bins, of :func:`binned_arrays`.

    Args:
        scattered: the design with the tolerances of its sensors.
        unknown: the design with the tolerances that a decoder assumes.
        known: membranes that need not be solved.
        transfer_function: of the design at the nodes and in the bins, (n_point, n_microphone, n), Pa/Pa.
        point_impedance: of the design there, (n_point, n), Pa s/m^3.
    """

    def __init__(
        self,
        scattered: ScatteredDesign,
        unknown: ScatteredDesign,
        known: KnownDiscs | None,
        transfer_function: ComplexArray,
        point_impedance: ComplexArray,
    ) -> None:
        self._scattered, self._unknown, self._known = scattered, unknown, known
        found = _floored(transfer_function)
        self.nominal: ComplexArray = found[..., _AT_BINS]
        """Transfer functions of the design, (n_point, n_microphone, n_bin), Pa/Pa."""
        self._on_nodes, self._point_impedance = found[..., _AT_NODES], point_impedance[:, _AT_NODES]

    @property
    def design(self) -> ArrayDesign:
        """The design."""
        return self._scattered.design

    def built(self, count: int, seed: int) -> DrawnSensors:
        """Deviations of as-built sensors."""
        return DrawnSensors(self._sensors(self._scattered), self._scattered.draws(0, count, seed))

    def assumed(self, options: BinnedOptions) -> DrawnSensors:
        """Deviations of the sensors that the hypotheses of the decoder are made of."""
        draws = self._unknown.draws(0, options.draws, HypothesisOptions().seed)
        return DrawnSensors(self._sensors(self._unknown), draws, _air_and_rubber(self.design, options.draws))

    def sensors(self, sensors: ComplexArray) -> ComplexArray:
        """Transfer functions of sensors in bins, (count, n_point, n_microphone, n_bin), Pa/Pa, from those at nodes."""
        return np.asarray(self.nominal * np.exp(self._factors(sensors) @ to_bins()))

    def hypotheses(self, sensors: ComplexArray, options: BinnedOptions) -> BinnedHypotheses:
        """Hypotheses of the decoder from the transfer functions of :meth:`assumed` sensors at the nodes."""
        return binned_hypotheses(self.nominal, self._factors(sensors), np.abs(self._on_nodes), to_bins(), options)

    def cavity(self, force: float | None) -> tuple[ComplexArray, ComplexArray]:
        """Pressures in the cavities per stroke: at the nodes, and of each point over that in bins.

        (n_node,), and (n_point, n_bin); Pa/N with a force, otherwise over the value at 30 Hz.
        """
        design = self.design

        def of_kind(alike: ArrayDesign) -> DiscResponse:
            return design_disc(alike, known=self._known).response(NODES, design_rubber(alike))

        flow = 2j * np.pi * NODES * membranes_in_vacuo(design, of_kind).volume_per_force
        per_force = flow * self._point_impedance
        level = np.log(np.abs(per_force)) + 1j * np.unwrap(np.angle(per_force))
        if force is None:
            level = level - (level.real @ from_nodes(np.array([SCALED_AT])))
        mean = level.mean(0)
        return np.exp(mean), np.exp((level - mean) @ to_bins())

    def _sensors(self, scattered: ScatteredDesign) -> AsBuiltSensors:
        return AsBuiltSensors(scattered, NODES, design_air(self.design))

    def _factors(self, sensors: ComplexArray) -> ComplexArray:
        """Logarithms of the factors of sensors, (count, n_point, n_microphone, n_node) complex64."""
        ratio = _floored(sensors) / self._on_nodes
        return np.asarray(np.log(np.abs(ratio)) + 1j * np.unwrap(np.angle(ratio)), np.complex64)


def binned_arrays(
    designs: Sequence[ArrayDesign], known: KnownDiscs | None, tolerances: Sequence[Tolerance], rows: int
) -> Iterator[tuple[list[int], list[BinnedArray]]]:
    """Designs in bins, in groups whose sensors :func:`acoustic_fem.scatter.batch_of_sensors` takes at once.

    Args:
        designs: the arrays.
        known: membranes that need not be solved.
        tolerances: of the sensors; decoders assume those of sensors that nobody calibrated.
        rows: number of sensors that will be computed of each design.

    Yields:
        Numbers of designs, and these in bins.
    """
    alike = tuple(tolerances) == UNCALIBRATED
    unknown = [ScatteredDesign(design, UNCALIBRATED, known) for design in designs]
    groups: dict[object, list[int]] = {}
    for number, one in enumerate(unknown):
        shapes = tuple(values.shape for values in vars(one.nominal).values())
        groups.setdefault((one.topology, one.design.air, shapes), []).append(number)
    for numbers in groups.values():
        first = unknown[numbers[0]]
        step = max(1, _BATCH // (rows * first.design.point_count * len(NODES)))
        left = iter(numbers)
        while part := list(islice(left, step)):
            own = [unknown[number] for number in part]
            parameters = joined_rows([each.nominal for each in own], [1] * len(own))
            with _unlimited():
                found = batch_response(parameters, first.topology, _FREQUENCIES, design_air(first.design))
            scattered = own if alike else [ScatteredDesign(each.design, tolerances, known) for each in own]
            of_each = zip(
                scattered, own, np.asarray(found.transfer_function), np.asarray(found.point_impedance), strict=True
            )
            yield part, [BinnedArray(each, assumed, known, h, z) for each, assumed, h, z in of_each]


def drawn_sensors(
    arrays: Sequence[BinnedArray], count: int, seed: int, options: BinnedOptions | None
) -> list[tuple[ComplexArray, BinnedHypotheses | None]]:
    """As-built sensors in bins, (count, n_point, n_microphone, n_bin), Pa/Pa, and hypotheses of each design of a group.

    Args:
        arrays: a group of :func:`binned_arrays`.
        count: number of as-built sensors.
        seed: seed of their deviations.
        options: how finely the decoder is followed; None if each sensor has a library of its own.
    """
    sets = [array.built(count, seed) for array in arrays]
    sets += [array.assumed(options) for array in arrays] if options is not None else []
    with _unlimited():
        found = batch_of_sensors(sets)
    assumed: Sequence[ComplexArray | None] = found[len(arrays) :] or [None] * len(arrays)
    return [
        (array.sensors(built), None if own is None or options is None else array.hypotheses(own, options))
        for array, built, own in zip(arrays, found, assumed, strict=False)
    ]


@contextmanager
def _unlimited() -> Iterator[None]:
    """No warnings of the limits of closed forms, which a check of the design lists."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ModelLimitWarning)
        yield


def _air_and_rubber(design: ArrayDesign, count: int) -> DrawnAirAndRubber | None:
    """Air and rubber that the decoder assumes of its draws; kept, because designs of a batch share their air."""
    assumed, key = HypothesisOptions(), (design.air, count)
    if assumed.air_and_rubber is None:
        return None
    if key not in _DRAWN:
        _DRAWN.clear()
        _DRAWN[key] = assumed.air_and_rubber.draws(0, count, assumed.seed, design, design_air(design))
    return _DRAWN[key]


def _floored(response: ComplexArray) -> ComplexArray:
    """Transfer functions of at least :data:`SILENT`: below, rounding would be all that distinguishes sensors."""
    return np.where(np.abs(response) < SILENT, SILENT, response)


@lru_cache(maxsize=1)
def to_bins() -> Array:
    """Matrix from values at the nodes to those in bins, (n_node, n_bin)."""
    return from_nodes(BINS)
