"""Rejection tests of a sensor that was found from unlabelled touches.

Touches that were held out of the search test it: they must be touches of that sensor, and neither another sensor nor
the present library may explain them as well. No likelihood tells the order of the channels, where a sensor is its own
mirror image, nor points that nobody touched; both have tests of their own.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import combinations

import numpy as np
import scipy.stats
from numpy.typing import NDArray

from acoustic_fem.calibration.fitted_model import Posterior
from localize.recalibration.marginal_likelihood import MarginalLikelihood
from localize.recalibration.recalibration_options import RecalibrationOptions

Complex = NDArray[np.complex128]

NEEDED = (
    "touches of fingers (taps, presses, slides), multi-sines or noise, one at a time, in a quiet room, spread over all "
    "points"
)
"""Touches that a calibration takes, in words."""


@dataclass(frozen=True)
class Order:
    """Order of the microphones, and how much likelier frames are in it than in the one they came in."""

    microphones: tuple[str, ...]
    """Names of the microphones, as the library orders them."""
    likeliest: tuple[str, ...]
    """Most probable microphones of the channels, one for each of these."""
    gain: float
    """Lead of this order over the one that the frames came in, nats per frame."""
    error: float
    """Standard error of the lead, nats per frame."""
    options: RecalibrationOptions = RecalibrationOptions()
    """Options of the calibration."""

    @property
    def differs(self) -> bool:
        """True if this order is clearly likelier than that of the channels."""
        return self.gain > max(self.options.exchanged_errors * self.error, self.options.exchanged_lead)


def likeliest_order(likelihood: MarginalLikelihood, h: Complex, microphones: tuple[str, ...]) -> Order:
    """Order of the microphones by exchanges of two channels, one after the other, as long as frames become likelier.

    Args:
        likelihood: of the frames.
        h: (n_point, n_microphone, n_freq) complex128, transfer functions of the library, Pa/Pa.
        microphones: their names.
    """
    order = tuple(range(len(microphones)))
    first = best = likelihood.evidence(h).frames
    while True:
        tried = {}
        for a, b in combinations(range(len(order)), 2):
            exchanged = list(order)
            exchanged[a], exchanged[b] = order[b], order[a]
            tried[tuple(exchanged)] = likelihood.evidence(h[:, exchanged]).frames
        better = max(tried, key=lambda each: tried[each].sum())
        if tried[better].sum() <= best.sum():
            break
        order, best = better, tried[better]
    difference = best - first
    return Order(
        microphones,
        tuple(microphones[k] for k in order),
        float(difference.mean()),
        float(difference.std(ddof=1) / np.sqrt(len(difference))),
        likelihood.options,
    )


def gaps(
    touches: NDArray[np.int64], line: NDArray[np.int64], options: RecalibrationOptions = RecalibrationOptions()
) -> NDArray[np.int64]:
    """Points without a touch, from 1, where they are too many of a line, or too many that follow each other.

    Args:
        touches: (n_point,) int64, number of touches of each point.
        line: (n_point,) int64, line of each point; points of a line follow each other.
        options: of the calibration.

    Returns:
        (n,) int64, line by line.
    """
    found = [np.empty(0, np.int64)]
    for number in np.unique(line):
        points = np.flatnonzero(line == number)
        is_free = touches[points] == 0
        if is_free.mean() > options.untouched_fraction:
            found.append(points[is_free] + 1)
            continue
        for run in np.split(points, np.flatnonzero(np.diff(is_free)) + 1):
            at_end = run[0] == points[0] or run[-1] == points[-1]
            if touches[run[0]] == 0 and len(run) > (1 if at_end else max(1, options.gap_fraction * len(points))):
                found.append(run + 1)
    return np.concatenate(found)


def numbers(points: NDArray[np.int64]) -> str:
    """Points in words: "3, 13-24".

    Args:
        points: (n,) int64, from 1, ascending.
    """
    runs = np.split(points, np.flatnonzero(np.diff(points) > 1) + 1)
    return ", ".join(f"{run[0]}" if len(run) == 1 else f"{run[0]}-{run[-1]}" for run in runs if len(run))


@dataclass(frozen=True, eq=False, kw_only=True)
class RejectionTests:
    """Figures by which a sensor is accepted or refused."""

    posterior: Posterior
    """Posterior of the parameters, about the present library."""
    gain: float
    """Lead of a held-out frame over the present library on average, nats."""
    gain_error: float
    """Standard error of that lead, nats."""
    rival: float
    """Lead over the next sensor, one that names other points, nats; infinite where all fall back."""
    rival_held_out: float
    """Lead over that sensor on the held-out frames alone, nats."""
    explained: float
    """Share of the held-out frames that pass the residual test."""
    agreement: float
    """Share of the held-out frames whose point stays the same when they join the fit."""
    order: Order
    """Order of the microphones in which the held-out frames are likeliest with the present library."""
    touches: NDArray[np.int64]
    """Number of frames that name each point; (n_point,) int64."""
    line: NDArray[np.int64]
    """Line of each point, as the library numbers it; (n_point,) int64."""
    finished: bool = True
    """True if the search was not ended by its limit of time."""
    options: RecalibrationOptions = RecalibrationOptions()
    """Options of the calibration."""

    @property
    def size(self) -> float:
        """Squared distance |u|^2 of the parameters from their priors, in standard deviations of these."""
        return float(self.posterior.parameters @ self.posterior.parameters)

    @property
    def expected_size(self) -> float:
        """Mean of :attr:`size` over sensors of these priors: the number of combinations that the touches determine."""
        return float((self.posterior.eigenvalues / (1 + self.posterior.eigenvalues)).sum())

    @property
    def largest_size(self) -> float:
        """Limit of :attr:`size` above which fewer than one sensor of these priors in a million lies.

        All parameters count, though the touches determine fewer: what the model lacks moves the others as well.
        """
        return float(scipy.stats.chi2.isf(self.options.unlikely, self.posterior.model.count))

    @property
    def untouched(self) -> NDArray[np.int64]:
        """Points that no frame is assigned to, from 1; (n,) int64."""
        return np.flatnonzero(self.touches == 0) + 1

    @property
    def objection(self) -> str | None:
        """Reason why the sensor is rejected; None where it is accepted."""
        untouched = gaps(self.touches, self.line, self.options)
        # an exchange looks like a bad fit too, and is the simpler reason
        if self.order.differs and self.order.gain > self.options.regained_fraction * self.gain:
            return (
                f"the channels look exchanged: {', '.join(self.order.microphones)} are likelier "
                f"{', '.join(self.order.likeliest)}, by {self.order.gain:.2f} +- {self.order.error:.2f} nats per "
                "held-out frame; or it is another sensor"
            )
        if not self.finished:
            farthest = self.posterior.farthest
            found = f". Its parts farthest off: {farthest}" if farthest else ""
            return (
                f"the search was ended after {self.options.seconds:g} s of processor time, before all sensors were "
                f"compared. The best sensor so far explains {100 * self.explained:.0f} % of the held-out frames, and "
                f"{100 * self.options.explained_fraction:.0f} % are needed. All held-out frames are {self.gain:.2f} +- "
                f"{self.gain_error:.2f} nats likelier on average than with the present library{found}"
            )
        if self.explained < self.options.explained_fraction:
            found = f"; farthest off: {self.posterior.farthest}" if self.size > self.largest_size else ""
            if len(untouched):
                found += f"; no touch is named point {numbers(untouched)}"
            return (
                f"{100 * self.explained:.0f} % of the held-out frames are touches of the sensor found, fewer than "
                f"{100 * self.options.explained_fraction:.0f} %: touches of another kind, such as two at a time, sound "
                f"from outside, a damaged or another sensor, or parts beyond their tolerances{found}; needed are "
                f"{NEEDED}"
            )
        if self.size > self.largest_size:
            return (
                f"the parameters lie {self.size:.0f} off their priors, more than {self.largest_size:.0f}: the sensor "
                f"is not one of this tolerance ({self.posterior.farthest})"
            )
        if len(untouched):
            return (
                f"no touch is named point {numbers(untouched)}: where touches are not spread over all points, a sensor "
                "whose points are shifted by a place explains them as well; touch all points of the line"
            )
        if self.rival < self.options.rival_lead or self.rival_held_out <= 0:
            return (
                f"a sensor that names other points is only {self.rival:.1f} nats less probable, and "
                f"{self.rival_held_out:.1f} less likely on held-out frames: the touches do not tell which it is"
            )
        if self.agreement < self.options.agreement_fraction:
            return (
                f"only {100 * self.agreement:.0f} % of the held-out frames keep their points when they join the fit: "
                "it is not settled yet"
            )
        if self.gain < max(self.options.gain_errors * self.gain_error, self.options.least_gain):
            return (
                f"held-out frames are {self.gain:.3f} +- {self.gain_error:.3f} nats likelier than with the present "
                "library, which is as good"
            )
        return None

    @property
    def accepted(self) -> bool:
        """True if no test rejects the sensor, so that its library is a new one."""
        return self.objection is None
