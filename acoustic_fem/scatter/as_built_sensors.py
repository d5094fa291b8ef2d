"""As-built sensors: transfer functions of sensors that are drawn about a design by its tolerances."""

from __future__ import annotations

import warnings
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import product

import numpy as np

from acoustic_fem.atlas.fidelity_choice import QuickFidelity, quick_fidelity_by
from acoustic_fem.batch.network import batch_transfer_function
from acoustic_fem.batch.openings import check_openings
from acoustic_fem.batch.parameters import ArrayParameters, MediumParameters, joined_rows
from acoustic_fem.library.solving import solve
from acoustic_fem.network.microphone import vent_ratio
from acoustic_fem.quantities.audible import audible_ratio
from acoustic_fem.quantities.checks import FrequencyLike, frequency_grid
from acoustic_fem.quantities.fidelity import CLOSED_FORMS
from acoustic_fem.quantities.local_air import AirLike, medium_of
from acoustic_fem.quantities.medium import Medium
from acoustic_fem.quantities.model_limit_warning import ModelLimitWarning
from acoustic_fem.scatter.air_and_rubber import AirAndRubber, DrawnAirAndRubber
from acoustic_fem.scatter.tolerances import CUT, QUANTITIES, ScatteredDesign
from geometry.ground.typed import Array, ComplexArray

#: Scatter that counts in the bounds of the atlas.
_BOUNDED = ("bore", "cavity_diameter", "cavity_height", "chamber_height", "ovality")


def as_built_fidelity(scattered: ScatteredDesign, frequency: FrequencyLike, air: AirLike = None) -> QuickFidelity:
    """The fidelity of a quick answer for a design and all sensors that can be drawn about it.

    It is the atlas if that covers the design with every size at either end of its scatter: each ratio that is bounded
    rises or falls with each of them.

    Args:
        scattered: the nominal design and what scatters.
        frequency: (n_freq,) Hz, ascending.
        air: a :class:`acoustic_fem.LocalAir`, or a gas of its own.
    """
    medium = medium_of(air, scattered.design)
    named = {tolerance.quantity for tolerance in scattered.tolerances}
    ends = np.array(list(product(*((-CUT, CUT) if name in named else (0.0,) for name in _BOUNDED))))
    draws = {name: np.zeros((len(ends), 1)) for name in QUANTITIES} | dict(
        zip(_BOUNDED, ends.T[..., None], strict=True)
    )
    draws["ovality"] = np.maximum(draws["ovality"], 0.0)  # either sign flattens a bore

    grid = frequency_grid(frequency)

    def check() -> None:
        check_openings(scattered.nominal, scattered.topology, grid, medium)
        check_openings(scattered.parameters(draws), scattered.topology, grid, medium)

    return quick_fidelity_by(check)


@dataclass(frozen=True, eq=False)
class AsBuiltSensors:
    """Transfer functions of sensors with the scatter of manufacturing about one design.

    Sensors are computed in closed form. At a 3-D fidelity the transfer functions of the nominal design are solved in
    3-D, and the factor between 3-D and closed forms is taken to be the same for all sensors.

    Raises:
        Refusal: a frequency out of range.
        OutsideAtlas: at fidelity ``atlas``, a sensor that the atlas does not cover; see :func:`as_built_fidelity`.
    """

    scattered: ScatteredDesign
    """The nominal design and what scatters."""
    frequency: FrequencyLike
    """(n_freq,) Hz, ascending."""
    air: AirLike = None
    """The air of the place, or a gas of its own; by default the air of the design."""
    fidelity: str = "lumped"
    """Fidelity of all transfer functions, one of :data:`acoustic_fem.FIDELITIES`."""

    @cached_property
    def _medium(self) -> Medium:
        return medium_of(self.air, self.scattered.design)

    @cached_property
    def nominal(self) -> ComplexArray:
        """Transfer functions of the nominal design, (1, n_point, n_microphone, n_freq) complex128, Pa/Pa."""
        return self._in_closed_form(self.scattered.nominal, self._medium) * self._correction

    def transfer_functions(
        self, draws: Mapping[str, Array], air_and_rubber: DrawnAirAndRubber | None = None
    ) -> ComplexArray:
        """Transfer functions of sensors, as their own microphones report them.

        Args:
            draws: by quantity (count, n_part) float64, in standard deviations, as
                :meth:`acoustic_fem.scatter.ScatteredDesign.parameters` takes them.
            air_and_rubber: air of each sensor and slope of its rubber, of :meth:`AirAndRubber.draws`; by default all
                have those of the design in :attr:`air`. Diaphragms, vents and leaks stay those of the design's air.

        Returns:
            (count, n_point, n_microphone, n_freq) complex128, Pa/Pa, by the response of the nominal microphone.
        """
        return batch_of_sensors([DrawnSensors(self, draws, air_and_rubber)])[0]

    def _in_closed_form(self, parameters: ArrayParameters, medium: Medium | MediumParameters) -> ComplexArray:
        closed = next((name for name in CLOSED_FORMS if name == self.fidelity), CLOSED_FORMS[0])
        found = batch_transfer_function(parameters, self.scattered.topology, self.frequency, medium, closed)
        return np.asarray(found)

    @cached_property
    def _correction(self) -> ComplexArray | float:
        if self.fidelity in CLOSED_FORMS:
            return 1.0
        solid = solve(self.scattered.design, self.frequency, self.fidelity, self._medium).transfer_function.values
        return np.asarray(solid / self._in_closed_form(self.scattered.nominal, self._medium))


@dataclass(frozen=True, eq=False)
class DrawnSensors:
    """Deviations of sensors about one design."""

    sensors: AsBuiltSensors
    """Design and frequencies of the sensors."""
    draws: Mapping[str, Array]
    """Deviations by quantity, (count, n_part) float64 each, in standard deviations."""
    air_and_rubber: DrawnAirAndRubber | None = None
    """Air of each sensor and slope of its rubber, as :meth:`AsBuiltSensors.transfer_functions` takes them."""

    @property
    def count(self) -> int:
        """Number of the sensors."""
        return max(map(len, self.draws.values()))

    def parameters(self) -> tuple[ArrayParameters, Medium | MediumParameters]:
        """Numbers and air of the sensors."""
        parameters = self.sensors.scattered.parameters(self.draws)
        if self.air_and_rubber is None:
            return parameters, self.sensors._medium
        return self.air_and_rubber.changed(parameters), self.air_and_rubber.medium

    def microphones(self) -> Array | float:
        """Response of the sensors' microphones by that of the nominal ones, (count, 1, n_microphone, n_freq)."""
        own = self.sensors
        gain, corner = np.moveaxis(own.scattered.microphones(self.draws), 1, 0)[:, :, None, :, None]
        if (gain == 1).all() and (corner == 1).all():
            return 1.0
        vent = vent_ratio(own.scattered.design.microphone, own.frequency, own._medium)
        return np.asarray(gain * (1 + 1 / vent) / (1 + corner / vent))


def batch_of_sensors(sets: Sequence[DrawnSensors]) -> list[ComplexArray]:
    """Transfer functions of sensors of several designs that are computed at once.

    A batch of several sets takes up to half of the time of the sets one by one, if these have few sensors.

    Args:
        sets: sensors of designs of one topology, at the same frequencies and fidelity, and with equally many terms in
            the laws of their rubber.

    Returns:
        Transfer functions of each set, (count, n_point, n_microphone, n_freq) complex128, Pa/Pa, by the response of the
        nominal microphone.
    """
    numbers, air = zip(*(one.parameters() for one in sets), strict=True)
    counts = [one.count for one in sets]
    parameters: ArrayParameters = numbers[0]
    medium: Medium | MediumParameters = air[0]
    if len(sets) > 1:
        parameters = joined_rows(numbers, counts)
        of_each = [MediumParameters.from_media([gas]) if isinstance(gas, Medium) else gas for gas in air]
        is_one = isinstance(medium, Medium) and all(gas == medium for gas in air)
        medium = medium if is_one else joined_rows(of_each, counts)
    found = sets[0].sensors._in_closed_form(parameters, medium)
    parts = np.split(found, np.cumsum(counts)[:-1])
    return [
        np.asarray(part * one.sensors._correction * one.microphones()) for part, one in zip(parts, sets, strict=True)
    ]


def scatter_factors(
    scattered: ScatteredDesign,
    air: AirLike,
    frequency: FrequencyLike,
    count: int,
    seed: int,
    *,
    first: int = 0,
    fraction: float = 1.0,
    air_and_rubber: AirAndRubber | None = None,
) -> ComplexArray:
    """Transfer functions of as-built sensors over those of the nominal one, both computed with the lumped network.

    Multiplied with the transfer functions of a library of any fidelity they give those of sensors built about it: the
    difference between fidelities is taken to be the same for all sensors. Warnings of closed forms are left out,
    because they concern none of the numbers of the library.

    Args:
        scattered: the nominal design and what scatters.
        air: a :class:`acoustic_fem.LocalAir`, or a gas of its own.
        frequency: (n_freq,) Hz, ascending.
        count: sensors.
        seed: seed of the random deviations.
        first: number of the first sensor.
        fraction: of the deviations of the parts that are drawn, of one.
        air_and_rubber: ranges from which the air of the sensors and the slope of their rubber are drawn too; by default
            all sensors have the given air and the rubber of the design.

    Returns:
        (count, n_point, n_microphone, n_freq) complex128, ratios.

    Raises:
        Refusal: a frequency out of range.
    """
    draws = {name: fraction * values for name, values in scattered.draws(first, count, seed).items()}
    sensors = AsBuiltSensors(scattered, frequency, air)
    drawn = None
    if air_and_rubber is not None:
        drawn = air_and_rubber.draws(first, count, seed, scattered.design, air)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ModelLimitWarning)
        return audible_ratio(sensors.transfer_functions(draws, drawn), sensors.nominal)
