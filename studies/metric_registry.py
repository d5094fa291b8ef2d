"""The figures of merit of a design by name: unit, definition, and how they are computed for many designs at once.

A study names them (``metrics = ["distance_smallest", "predicted_top1"]``); docs/metrics.md explains each.
"""

from __future__ import annotations

import difflib
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from studies.responses import Responses
from studies.separation import PairDistances, pair_distances

if TYPE_CHECKING:
    from acoustic_fem import Library

Values = NDArray[np.float64]


@dataclass(frozen=True)
class Metric:
    """One figure of merit."""

    name: str
    """As a study names it."""
    unit: str
    """"1" for ratios."""
    long_name: str
    """A few words for axes and tables."""
    definition: str
    """One or two sentences."""
    compute: Callable[[Responses], Values]
    """(n_design,) float64 from the responses of a batch."""
    needs: frozenset[str] = frozenset()
    """Fields of :class:`studies.responses.Responses` beside frequency and transfer function that must not be None."""
    better: str = "larger"
    """"larger" or "smaller": which values a designer wants."""

    def of_batch(self, responses: Responses) -> Values:
        """(n_design,) float64, one value per design.

        Raises:
            ValueError: something the metric needs is missing, or the grid does not reach over its band.
        """
        missing = sorted(name for name in self.needs if getattr(responses, name) is None)
        if missing:
            raise ValueError(f"metric {self.name} needs {', '.join(missing)}")
        return np.asarray(self.compute(responses), np.float64)

    def of_library(self, library: Library) -> float:
        """The value of one design.

        Raises:
            ValueError: as :meth:`of_batch`.
        """
        return float(self.of_batch(Responses.of_library(library))[0])


def metrics_named(names: Iterable[str]) -> tuple[Metric, ...]:
    """The metrics of these names, in their order.

    Raises:
        ValueError: a name that is none, with the nearest one that is.
    """
    found = []
    for name in names:
        if name not in METRICS:
            near = difflib.get_close_matches(str(name), METRICS, 1)
            hint = f"; did you mean {near[0]}?" if near else ""
            raise ValueError(f"metrics: {name!r} must be one of: {', '.join(METRICS)}{hint}")
        found.append(METRICS[name])
    return tuple(found)


@lru_cache(maxsize=1)
def _distances(responses: Responses) -> PairDistances:
    """Of the batch that was asked for last: several metrics share them."""
    return pair_distances(responses)


_RATIO = "r_i = H_ia / H_ib; root mean square over 1 to 100 Hz and all pairs a, b of microphones"


def _separation() -> Iterable[Metric]:
    for kind, field, unit, what in (
        ("ild", "level", "dB", "level difference 20 log10 |r_i / r_j|"),
        ("ipd", "phase", "degree", "phase difference arg(r_i / r_j), the short way round"),
        ("distance", "combined", "1", "distance |log(r_i / r_j)|, level in nepers and phase in radians,"),
    ):
        for extent, reduce in (("smallest", np.min), ("mean", np.mean)):
            yield Metric(
                name=f"{kind}_{extent}",
                unit=unit,
                long_name=f"{extent} {what.split(' ')[0]} {what.split(' ')[1] if kind != 'distance' else ''}".strip()
                + " of two points",
                definition=f"The {extent} over all pairs of points i, j of the {what} of {_RATIO}.",
                compute=lambda responses, field=field, reduce=reduce: reduce(
                    getattr(_distances(responses), field), axis=1
                ),
            )


#: All metrics by name.
METRICS: dict[str, Metric] = {metric.name: metric for metric in _separation()}
