"""As-built sensors of one design as a source of data sets: drawn about it by its tolerances."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from acoustic_fem.library.solving import solve
from acoustic_fem.quantities.checks import FrequencyLike, frequency_grid
from acoustic_fem.quantities.local_air import AirLike, LocalAir, checked_air, medium_of
from acoustic_fem.scatter.as_built_sensors import AsBuiltSensors, as_built_fidelity
from acoustic_fem.scatter.tolerances import QUANTITIES, ScatteredDesign, Tolerance, tolerances_of
from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import DesignLike, resolve_design
from geometry.ground.argument_checks import check_range
from geometry.ground.typed import PathLike
from localize.signals.array_response import ArrayResponse, response_of
from studies.output.frequencies import FREQUENCIES


class AsBuiltArrays:
    """As-built sensors of one design: an :class:`localize.datasets.ArraySource`, whose cases are numbered from 0.

    Sensor k depends only on design, tolerances, frequencies, seed and k. Sensors are computed when you use them. Room
    sound reaches their microphones as in the nominal array.
    """

    def __init__(
        self,
        scattered: ScatteredDesign,
        count: int,
        seed: int,
        sensors: AsBuiltSensors,
        nominal: ArrayResponse,
    ) -> None:
        self._scattered, self._count, self._sensors = scattered, count, sensors
        #: Seed of the draws.
        self.seed = seed
        #: The array as designed.
        self.nominal = nominal
        self._named = [name for name in QUANTITIES if name in {each.quantity for each in scattered.tolerances}]
        #: Names of the deviations: quantity and number of the part, from 1.
        self.parameter_names = tuple(
            f"{name} {part}" for name in self._named for part in range(1, 1 + scattered.draws(0, 1, 0)[name].shape[1])
        )

    def __repr__(self) -> str:
        """Design, number of sensors and seed."""
        return f"AsBuiltArrays({self.design.name}, {self._count} sensors, seed {self.seed}, {self.fidelity})"

    @property
    def design(self) -> ArrayDesign:
        """Nominal design."""
        return self._scattered.design

    @property
    def tolerances(self) -> tuple[Tolerance, ...]:
        """Tolerances that the sensors are drawn by."""
        return self._scattered.tolerances

    @property
    def fidelity(self) -> str:
        """Fidelity of all transfer functions, one of :data:`acoustic_fem.FIDELITIES`."""
        return self._sensors.fidelity

    @property
    def case_numbers(self) -> NDArray[np.int64]:
        """Numbers of the sensors, from 0; (n_case,) int64."""
        return np.arange(self._count)

    @property
    def case_keys(self) -> tuple[str, ...]:
        """Number of each sensor as a text."""
        return tuple(map(str, range(self._count)))

    @property
    def parameter_units(self) -> tuple[str, ...]:
        """Units of the parameters; each is a standard deviation."""
        return ("standard deviations",) * len(self.parameter_names)

    @property
    def array_sizes(self) -> NDArray[np.int64]:
        """Number of points and of microphones, equal for all cases; (n_case, 2) int64."""
        return np.tile((self.nominal.point_count, len(self.nominal.microphones)), (self._count, 1))

    def parameter_values(self, case: int) -> NDArray[np.float64]:
        """Deviations of a sensor in standard deviations, as ``parameter_names`` has them; (n_parameter,) float64.

        Raises:
            Refusal: no such sensor.
        """
        draws = self._draws([case])
        return np.concatenate([draws[name][0] for name in self._named])

    def arrays(self, cases: Sequence[int], sound: bool = True) -> list[ArrayResponse]:
        """Arrays with the transfer functions of some sensors; the response to sound is that of the nominal array.

        Raises:
            Refusal: no such sensor.
        """
        made = self._sensors.transfer_functions(self._draws(cases))
        return [replace(self.nominal, transfer_function=each) for each in made]

    def _draws(self, cases: Sequence[int]) -> dict[str, NDArray[np.float64]]:
        for case in cases:
            check_range("case", case, 0, self._count - 1)
        each = [self._scattered.draws(case, 1, self.seed) for case in cases]
        return {name: np.concatenate([drawn[name] for drawn in each]) for name in QUANTITIES}


def as_built(
    design: DesignLike,
    count: int,
    seed: int = 0,
    *,
    tolerances: PathLike | Sequence[Tolerance] | None = None,
    frequency: FrequencyLike = FREQUENCIES,
    fidelity: str | None = None,
    air: AirLike = None,
) -> AsBuiltArrays:
    """As-built sensors of a design, generated at random from manufacturing tolerances, for
    :class:`localize.TouchDataset` and others.

    Args:
        design: the nominal array: a design, the path of its file, or the name of a prototype.
        count: number of sensors, 1 to a million.
        seed: seed of the random deviations.
        tolerances: tolerances of the parts, or a TOML file of them; by default those of a careful workshop.
        frequency: (n_freq,) Hz, ascending, or FIRST:LAST:COUNT.
        fidelity: one of :data:`acoustic_fem.FIDELITIES`; by default ``atlas`` if it covers the design and all its
            as-built sensors, otherwise 3-D.
        air: air of the place where the sensors are used, or any other gas; by default the design's air.

    Raises:
        Refusal: a count, a frequency or a tolerance out of range; a design that cannot be built; at fidelity
            ``atlas`` a sensor that the atlas does not cover.
    """
    design = resolve_design(design)
    check_range("count", count, 1, 1_000_000, whole=True)
    check_range("seed", seed, 0, 2**63 - 1, whole=True)
    grid = frequency_grid(frequency)
    checked_air(air, gas=True)
    if isinstance(air, LocalAir):
        design = design.with_values(air.design_values)
    medium = medium_of(air, design)
    scattered = ScatteredDesign(design, tolerances_of(tolerances))
    name = as_built_fidelity(scattered, grid, medium).name if fidelity is None else fidelity
    nominal = response_of(solve(design, grid, name, medium))
    return AsBuiltArrays(scattered, count, seed, AsBuiltSensors(scattered, grid, medium, name), nominal)
