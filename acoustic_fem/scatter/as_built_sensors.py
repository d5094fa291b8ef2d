"""As-built sensors: transfer functions of sensors that are drawn about a design by its tolerances."""

from __future__ import annotations

import warnings
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from itertools import product

import numpy as np

from acoustic_fem.atlas.fidelity_choice import QuickFidelity, quick_fidelity_by
from acoustic_fem.batch.network import batch_transfer_function
from acoustic_fem.batch.openings import check_openings
from acoustic_fem.batch.parameters import ArrayParameters, MediumParameters
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
        parameters = self.scattered.parameters(draws)
        medium: Medium | MediumParameters = self._medium
        if air_and_rubber is not None:
            parameters, medium = air_and_rubber.changed(parameters), air_and_rubber.medium
        sensors = self._in_closed_form(parameters, medium) * self._correction
        gain, corner = np.moveaxis(self.scattered.microphones(draws), 1, 0)[:, :, None, :, None]
        if (gain == 1).all() and (corner == 1).all():
            return np.asarray(sensors)
        vent = vent_ratio(self.scattered.design.microphone, self.frequency, self._medium)
        return np.asarray(sensors * gain * (1 + 1 / vent) / (1 + corner / vent))

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
