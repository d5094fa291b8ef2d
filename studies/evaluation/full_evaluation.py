"""Evaluation of a localizer beside the Bayes decoder, under conditions that are not those of training."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass
from datetime import datetime
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

import acoustic_fem
import localize
from acoustic_fem import Library
from acoustic_fem.library.provenance import versions
from acoustic_fem.quantities.local_air import design_air
from acoustic_fem.scatter.as_built_sensors import scatter_factors
from acoustic_fem.scatter.tolerances import ScatteredDesign
from geometry.ground.refusal import Refusal
from geometry.ground.stated_times import stated_time
from localize.signals.array_response import ArrayResponse
from localize.signals.locator import Locator
from localize.signals.noise_model import NoiseChoice
from studies.test_rig.virtual_rig import HEARD, Rig

if TYPE_CHECKING:
    from localize.evaluation.accuracy import Evaluation
    from localize.evaluation.conditions import Outcome

Progress = Callable[[str, float], None]
#: Shares of the workshop's tolerances that sensors are made with.
SCATTER = (0.25, 0.5, 1.0)
#: Sensors that are made with each.
SENSORS = 12
#: Virtual rigs, and the group of what is found on them.
RIGS, RIG_GROUP = 8, "virtual rigs"
#: Touches per point in a condition, as a share of those of the whole evaluation.
SHARE = 0.1
#: Touches in a condition, if the whole evaluation has as many: their interval is then at most 4 points either way.
LEAST = 600


@dataclass(frozen=True)
class LocalizerResult:
    """Results of one localizer."""

    name: str
    """Name of the localizer."""
    overall: Evaluation
    """Results on the library as it is."""
    outcomes: tuple[Outcome, ...]
    """Results under each condition."""

    def to_dict(self) -> dict[str, Any]:
        """Results as JSON can hold them."""
        return {**self.overall.to_dict(), "conditions": [asdict(outcome) for outcome in self.outcomes]}


@dataclass(frozen=True)
class FullEvaluation:
    """Results of all localizers: what the report shows."""

    design: str
    """Name of the design."""
    points: tuple[int, ...]
    """Numbers of the points."""
    results: tuple[LocalizerResult, ...]
    """Results of each localizer, in the order in which they were given."""
    created: datetime
    """Time at which the evaluation was made."""
    provenance: dict[str, Any]
    """Design, fidelity, library, seed and versions."""
    unscattered: str = ""
    """Reason for which as-built sensors are left out; empty if they are evaluated."""

    def to_dict(self) -> dict[str, Any]:
        """Results as JSON can hold them."""
        return {
            "design": self.design,
            "created": self.created.isoformat(timespec="seconds"),
            "provenance": self.provenance,
            **{each.name: each.to_dict() for each in self.results},
        }


def evaluate_fully(
    locators: dict[str, Locator],
    library: Library,
    response: ArrayResponse,
    touches: int,
    microphone_noise: NoiseChoice,
    seed: int,
    progress: Progress,
) -> FullEvaluation:
    """Results of localizers on a library, then under each condition that it allows, then on as-built sensors.

    Args:
        locators: by name.
        library: of a design.
        response: of that library.
        touches: held-out touches per point; in a condition a tenth as many, at least 600 of all points together, but
            never more.
        microphone_noise: of the microphones, where the condition is not the noise.
        seed: of touches and of as-built sensors.
        progress: function that is called with the name of the step and the fraction done.
    """
    few = min(touches, max(round(SHARE * touches), math.ceil(LEAST / response.point_count)))
    progress("as-built sensors", 0.0)
    made, unscattered = scattered_sensors(library, response, seed, SENSORS, SCATTER)
    rigs = [] if unscattered else rig_sensors(library, response, seed, RIGS)
    found = []
    for number, (name, locator) in enumerate(locators.items()):
        stage = _stage(progress, name, number / len(locators), 1 / len(locators))
        stage("all touches", 0.0)
        overall = localize.evaluate(locator, response, touches, microphone_noise, seed=seed)
        outcomes = localize.evaluation.evaluate_conditions(locator, response, few, microphone_noise, seed, stage)
        stage("as-built sensors", 1.0)
        outcomes += localize.evaluation.evaluate_sensors(
            locator, response, made, max(1, few // 5), microphone_noise, seed
        )
        outcomes += localize.evaluation.evaluate_sensors(
            locator, response, rigs, max(1, few // RIGS), microphone_noise, seed, RIG_GROUP
        )
        found.append(LocalizerResult(name, overall, tuple(outcomes)))
    return FullEvaluation(
        design=response.name,
        points=tuple(range(1, response.point_count + 1)),
        results=tuple(found),
        created=stated_time(),
        provenance={
            **versions(seed, ("numpy", "scipy", "torch", "onnxruntime")),
            "design": response.provenance["design"],
            "fidelity": library.fidelity,
            "library": dict(library.provenance),
        },
        unscattered=unscattered,
    )


def _stage(
    progress: Callable[[str, float], None], name: str, begin: float, size: float
) -> Callable[[str, float], None]:
    """Progress of one localizer as part of the whole."""
    return lambda what, share: progress(f"{name}: {what}", begin + size * share)


def rig_sensors(
    library: Library, response: ArrayResponse, seed: int, count: int
) -> list[tuple[str, float | None, NDArray[np.complex128]]]:
    """Set of virtual rigs, uncalibrated: made sensors with what no decoder knows, :class:`studies.HiddenScatter`.

    The changes by the rigs are computed with closed forms and applied to a library of any fidelity; above 160 Hz it
    stays as it is there.

    Args:
        library: of a design whose scatter is known.
        response: of that library.
        seed: of the first rig.
        count: of rigs.

    Returns:
        Name, no share, and (count, n_point, n_microphone, n_freq) complex128 transfer functions, Pa/Pa.
    """
    grid = np.unique(np.clip(response.frequency, *HEARD))
    place = np.minimum(np.searchsorted(grid, response.frequency), len(grid) - 1)
    nominal = acoustic_fem.solve(library.design, grid, "lumped").transfer_function.values
    rigs = [Rig(library.design, seed + k, fidelity="lumped").transfer_function(grid) / nominal for k in range(count)]
    return [("uncalibrated", None, response.transfer_function * np.stack(rigs)[..., place])]


def scattered_sensors(
    library: Library, response: ArrayResponse, seed: int, count: int, shares: Sequence[float]
) -> tuple[list[tuple[str, float, NDArray[np.complex128]]], str]:
    """Sets of :func:`sensor_sets` and an empty text; none, and the reason, where the scatter of a design is not known.

    Arguments as there, shapes too: (count, n_point, n_microphone, n_freq) complex128 transfer functions, Pa/Pa.
    """
    try:
        return sensor_sets(library, response, seed, count, shares), ""
    except Refusal as error:
        return [], str(error)


def sensor_sets(
    library: Library, response: ArrayResponse, seed: int, count: int = SENSORS, shares: Sequence[float] = SCATTER
) -> list[tuple[str, float, NDArray[np.complex128]]]:
    """Sets of sensors with shares of the workshop's tolerances.

    A library of any fidelity is scattered around itself, see :func:`acoustic_fem.scatter.scatter_factors`.

    Args:
        library: of a design.
        response: of that library.
        seed: of the sensors.
        count: sensors of each set.
        shares: of the tolerances, one for each set.

    Returns:
        Name and share of each set, and (count, n_point, n_microphone, n_freq) complex128 transfer functions, Pa/Pa.
    """
    scattered, air = ScatteredDesign(library.design), design_air(library.design)

    def made(share: float) -> NDArray[np.complex128]:
        factors = scatter_factors(scattered, air, response.frequency, count, seed, fraction=share)
        return response.transfer_function * factors

    return [(f"{share:g} of the tolerances", share, made(share)) for share in shares]
