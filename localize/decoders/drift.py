"""The decoder of a calibrated sensor that drifts: what changes slowly is followed over touches of which nobody knows
the points.

Silicone hardens, air has another pressure elsewhere: both change how stiff the nodes of the array are, and with it the
transfer functions of all points together. The states of a drift are some stiffnesses of all membranes about those of
the calibration, each with a library of its own. Which of them it is, is believed by a hidden Markov chain: every touch
multiplies the belief by how likely it is in each state, its point summed out, and between touches the state may move
to its neighbours. The likelihood of a point is that of :mod:`localize.decoders.bayes` in the state that is believed
most: summed over states, a touch may choose the neighbour in which it is at another point, which costs 1 % of 36 points
in line.

About a library that was only computed it would do harm: there a touch at the next place on a sensor of other stiffness
explains what parts that differ from the design do.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.special import logsumexp

from geometry.ground.refusal import Refusal
from localize.decoders.bayes import Ambient, BayesDecoder
from localize.decoders.frame_covariance import SAMPLES, touch_covariances
from localize.decoders.likelihood import CHUNK
from localize.signals.array_response import ArrayResponse, response_of
from localize.signals.frames import checked_signals, cut_frames
from localize.signals.noise_model import NoiseChoice
from localize.signals.threads import one_thread

if TYPE_CHECKING:
    from torch import Tensor

    from acoustic_fem import Library

STATES = 11
"""Number of stiffnesses, that of the calibration in the middle; 7.5 % apart, 15 that are 5 % apart do no better."""
FARTHEST = 0.375
"""Largest distance of a stiffness from that of the calibration, in its logarithm: at 2000 m it seems 30 % lower."""
USUAL = 0.15
"""Standard deviation of the logarithm of the stiffness before any touch was heard."""
MOVES = 1e-3
"""Probability with which the state moves to a neighbour from one touch to the next; 1e-4 to 1e-2 do alike."""
LEAST = -4.0
"""Logarithm of the least likelihood that one touch gives a state, against the best: none is excluded by one touch,
which may be none."""


@dataclass
class _Belief:
    """What is believed of a drift."""

    log: NDArray[np.float64]
    """Logarithm of the probability of each state, (n_state,)."""


class DriftDecoder(BayesDecoder):
    """Maximum likelihood over the points of a calibrated array whose stiffness drifts.

    Frames that are located are taken as touches in the order in which they come, and each moves what is believed of the
    drift; whatever else a decoder is asked takes the belief as it is. It takes eleven times the tables, and several
    times the time, of :class:`localize.BayesDecoder`.

    Args:
        library: of a calibrated sensor, measured at all points or fitted, and of a design that the lumped batch takes;
            it covers 1 to 100 Hz.
        microphone_noise: as of :class:`localize.BayesDecoder`.
        ambient: as of :class:`localize.BayesDecoder`.
        new: share of a frame that the frame before it does not hold, above 0, at most 1: 16 / 250 in a stream.
        microphones: names of two or more that are listened to; by default all.

    Raises:
        Refusal: a library that is not calibrated, or in which points are still those of the design; a share out of
            range; a design that the lumped batch does not take; a microphone that the library does not have; or as
            :class:`localize.BayesDecoder`.
    """

    bounds_scores = False

    def __init__(
        self,
        library: Library,
        microphone_noise: NoiseChoice = 1e-3,
        ambient: Ambient = None,
        new: float = 1.0,
        microphones: tuple[str, ...] | None = None,
    ) -> None:
        if not 0 < new <= 1:
            raise Refusal(f"new = {new} must be above 0 and at most 1")
        objection = objection_to_drift(library)
        if objection is not None:
            raise Refusal(f"library {objection}")
        self._listened_to = microphones
        super().__init__(library, microphone_noise, ambient)
        self._library, self._new = library, new
        apart = np.log(self.stiffness)
        self._usual = -0.5 * (apart / USUAL) ** 2
        moves = new * MOVES / 2 * (np.eye(STATES, k=1) + np.eye(STATES, k=-1))
        self._transition = moves + np.diag(1 - moves.sum(1))
        self._belief = _Belief(self._usual - logsumexp(self._usual))

    def heard_by(self, microphones: tuple[str, ...]) -> DriftDecoder:
        """The same sensor by some of its microphones: what either hears of the drift both believe.

        Args:
            microphones: names, two or more.

        Raises:
            Refusal: a microphone that the library does not have, or fewer than two.
        """
        rest = DriftDecoder(self._library, self.microphone_noise, self.ambient, self._new, microphones)
        rest._belief = self._belief
        return rest

    @property
    def assumes(self) -> str:
        """What is taken for granted of the sensor, in words."""
        return "that the sensor is as its library has it, but for a stiffness that is followed"

    @property
    def stiffness(self) -> NDArray[np.float64]:
        """Stiffnesses of the states over that of the calibration; (n_state,) float64."""
        return np.exp(np.linspace(-FARTHEST, FARTHEST, STATES))

    @property
    def belief(self) -> NDArray[np.float64]:
        """Probability of each state after the touches so far; (n_state,) float64."""
        return np.exp(self._belief.log)

    def reset(self) -> None:
        """Forget the touches so far."""
        self._belief.log = self._usual - logsumexp(self._usual)

    def _heard(self, library: Library | ArrayResponse) -> ArrayResponse:
        """The array, as the microphones hear it that are listened to."""
        response = super()._heard(library)
        return response if self._listened_to is None else response.heard_by(self._listened_to)

    def _touched(self, library: Library | ArrayResponse, response: ArrayResponse) -> NDArray[np.float64]:
        """Covariances of the states, point by point."""
        from acoustic_fem.calibration.fitted_model import UpdatedModel

        assert not isinstance(library, ArrayResponse)
        model = UpdatedModel(library)
        u = np.zeros((STATES, model.count))
        modulus = model.groups.index("modulus")
        u[:, modulus] = np.log(self.stiffness) / model.scale[modulus]
        names = list(response_of(library).microphones)
        heard = model.transfer_function(u)[:, :, [names.index(name) for name in response.microphones]]
        each = [touch_covariances(replace(response, transfer_function=h), np.eye(SAMPLES)) for h in heard]
        return np.stack(each, 1).reshape(-1, *each[0].shape[1:])

    @one_thread()
    def locate(self, signals: ArrayLike | Tensor) -> NDArray[np.float64]:
        """Where the array was touched, one touch after the other, all points equally likely beforehand.

        Args:
            signals: (n_microphone, n_sample) or (n, n_microphone, n_sample), Pa, as of
                :meth:`localize.BayesDecoder.locate`.

        Returns:
            (n_point,) or (n, n_point) float64: probability per point in the state believed most after this touch.

        Raises:
            Refusal: as :meth:`localize.BayesDecoder.locate`.
        """
        batch, batched = checked_signals(signals, self.microphones)
        score = np.empty((len(batch), self.point_count))
        for number, by_state in enumerate(self._of_touches(batch)):
            self._hear(by_state)
            score[number] = by_state[:, self._belief.log.argmax()]
        probability = np.exp(score - logsumexp(score, axis=1, keepdims=True))
        return probability if batched else probability[0]

    def log_likelihood(self, frames: NDArray[np.float64]) -> NDArray[np.float64]:
        """Log-likelihood of every point in the state believed most; as of :meth:`localize.BayesDecoder.log_likelihood`.

        Args:
            frames: (n, n_microphone, 250) float64, Pa.

        Returns:
            (n, n_point) float64, nats, up to a constant per frame.
        """
        return self._by_state(frames)[..., self._belief.log.argmax()]

    def _by_state(self, frames: NDArray[np.float64]) -> NDArray[np.float64]:
        """Log-likelihoods of frames in all states, (n, n_point, n_state), nats."""
        return super().log_likelihood(frames).reshape(len(frames), self.point_count, STATES)

    def _of_touches(self, batch: NDArray[np.float64]) -> NDArray[np.float64]:
        """Log-likelihoods of touches, (n, n_point, n_state), nats, all frames of each together."""
        frames = cut_frames(batch)
        flat = frames.reshape(-1, *frames.shape[2:])
        score = np.concatenate([self._by_state(flat[k : k + CHUNK]) for k in range(0, len(flat), CHUNK)])
        return np.asarray(score.reshape(*frames.shape[:2], *score.shape[1:]).sum(1))

    def _hear(self, by_state: NDArray[np.float64]) -> None:
        """Take in what a touch of log-likelihoods (n_point, n_state) says of the state."""
        told = logsumexp(by_state, axis=0)
        told = self._new * np.maximum(told - told.max(), LEAST)
        before = np.log(self.belief @ self._transition)
        self._belief.log = before + told - logsumexp(before + told)


def objection_to_drift(library: Library | ArrayResponse) -> str | None:
    """Reason why a drift cannot be followed about a library; None where it can.

    Args:
        library: of a sensor.
    """
    from acoustic_fem.library.transfer_functions import MEASURED

    if isinstance(library, ArrayResponse):
        return "must be one of a design: bare transfer functions do not tell what a drift changes"
    if library.fidelity != MEASURED:
        return (
            f"must be calibrated to follow a drift, was computed ({library.fidelity}): about parts that the sensor "
            "does not have, more touches are named wrong so; make a library with calibrate or recalibrate"
        )
    made = library.provenance.get("calibration", {})
    measured = len(made.get("measured_points", ()))
    if made.get("other_points") == "model" and measured < library.design.point_count:
        return (
            f"must be calibrated at all points to follow a drift: {measured} of {library.design.point_count} were "
            "measured, and the others are those of the design"
        )
    return None
