"""Decoder of a calibrated sensor that drifts: it follows slow changes over touches whose points nobody knows.

Silicone hardens, the pressure of the air differs from place to place, and enclosed air that is warmed bulges the
membranes. All of these change how stiff the nodes of the array are, and with it the transfer functions of all points
together. The states of a drift are several stiffnesses of all
membranes about the calibrated one, each with a library of its own. A hidden Markov chain keeps the probability of each
state: every touch multiplies it by the likelihood of the touch in that state, summed over points, and between touches
the state may move to its neighbours. The likelihood of a point is that of :mod:`localize.decoders.bayes` in the most
probable state. It is not summed over states, because then a touch may choose the neighbouring state in which it is at
another point, which costs 1 % of top-1 accuracy on 36 points in line.

Do not use it with a library that was only computed: a touch at the next place on a sensor of another stiffness then
explains the differences between the built parts and the design.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike
from scipy.special import logsumexp

from acoustic_fem import Library
from acoustic_fem.calibration.fitted_model import UpdatedModel
from acoustic_fem.library.transfer_functions import MEASURED
from geometry.ground.argument_checks import check_range
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array
from localize.decoders.decoder_options import DriftOptions
from localize.decoders.frame_covariance import SAMPLES, touch_covariances
from localize.decoders.library_decoder import LibraryDecoder, in_parts
from localize.decoders.surroundings import Ambient, Surroundings
from localize.signals.array_response import ArrayResponse, response_of
from localize.signals.frames import checked_signals, cut_frames
from localize.signals.noise_model import NoiseChoice
from localize.signals.threads import one_thread

if TYPE_CHECKING:
    from torch import Tensor


class DriftDecoder(LibraryDecoder):
    """Maximum likelihood over the points of a calibrated array whose stiffness drifts.

    :meth:`follow` takes touches in the order in which they come, with the belief about the drift, and gives the next
    belief beside the answer. :meth:`locate` takes every touch as the first one. The decoder itself never changes. It
    takes sixteen times the tables, and several times the time, of :class:`localize.BayesDecoder`.

    Args:
        library: of a calibrated sensor, measured at all points or fitted, and of a design that the lumped batch takes;
            it covers 1 to 100 Hz.
        microphone_noise: as of :class:`localize.BayesDecoder`.
        ambient: as of :class:`localize.BayesDecoder`.
        new: fraction of a frame that the frame before it does not hold, above 0, at most 1: 16 / 250 in a stream.
        microphones: names of two or more that are used; by default all.
        options: numbers that tune it.

    Raises:
        Refusal: a library that is not calibrated, or in which points are still those of the design; a fraction out of
            range; a design that the lumped batch does not take; a microphone that the library does not have; or as
            :class:`localize.BayesDecoder`.
    """

    options: DriftOptions

    @one_thread()
    def __init__(
        self,
        library: Library,
        microphone_noise: NoiseChoice = "design",
        ambient: Ambient = None,
        new: float = 1.0,
        microphones: tuple[str, ...] | None = None,
        options: DriftOptions = DriftOptions(),
    ) -> None:
        check_range("new", new, 0, 1, excluded="low")
        check_drift(library)
        whole = response_of(library)
        response = whole if microphones is None else whole.heard_by(microphones)
        around = Surroundings.of(response, microphone_noise, ambient)
        self.stiffness: Array = np.exp(options.step * np.arange(-options.softer, options.stiffer + 1))
        """Stiffnesses of the states over that of the calibration; (n_state,) float64."""
        kept = [whole.microphones.index(name) for name in response.microphones]
        heard = self._transfer_functions(library)[:, :, kept]
        each = [touch_covariances(replace(response, transfer_function=h), np.eye(SAMPLES)) for h in heard]
        touched = np.stack(each, 1).reshape(-1, *each[0].shape[1:])
        super().__init__(response, around, touched, options)
        self._library, self._new = library, new
        usual = -0.5 * (np.log(self.stiffness) / options.usual_deviation) ** 2
        self.start: Array = usual - logsumexp(usual)
        """Belief before the first touch: logarithm of the probability of each state; (n_state,) float64."""
        count = len(self.stiffness)
        moves = new * options.move_probability / 2 * (np.eye(count, k=1) + np.eye(count, k=-1))
        self._transition = moves + np.diag(1 - moves.sum(1))

    def heard_by(self, microphones: tuple[str, ...]) -> DriftDecoder:
        """The decoder of the same sensor by some of its microphones, whose states are the same; as of
        :class:`localize.Locator`.
        """
        return DriftDecoder(self._library, self.microphone_noise, self.ambient, self._new, microphones, self.options)

    @property
    def no_graph(self) -> str:
        """Reason why no ONNX graph can hold this localizer, as a clause."""
        return "it follows its sensor from touch to touch"

    @property
    def assumptions(self) -> str:
        """Assumptions about the sensor, in words."""
        return "that the sensor is as its library describes it, except for its stiffness, which is followed"

    @one_thread()
    def follow(self, signals: ArrayLike | Tensor, state: Array) -> tuple[Array, Array]:
        """Probability of each point of touches in the order in which they came, and the belief after them.

        Args:
            signals: (n_microphone, n_sample) or (n, n_microphone, n_sample), Pa, as of :meth:`locate`.
            state: belief before them, (n_state,) float64: :attr:`start`, or what the call before gave.

        Returns:
            (n_point,) or (n, n_point) float64, the probability per point in the state that is believed most after each
            touch; and the logarithm of the probability of each state, (n_state,) float64.

        Raises:
            Refusal: as of :meth:`locate`.
        """
        batch, batched = checked_signals(signals, self.microphones)
        score = np.empty((len(batch), self.point_count))
        for number, by_state in enumerate(self._of_touches(batch)):
            state = self._believed(by_state, state)
            score[number] = by_state[:, state.argmax()]
        probability = _probability(score)
        return (probability if batched else probability[0]), state

    def joint_log_likelihood(self, batch: Array) -> Array:
        """Log-likelihood of every point, each signal taken as the first touch, all of its frames together.

        Args:
            batch: (n, n_microphone, n_sample) float64, Pa, as :func:`localize.signals.checked_signals` gives it.

        Returns:
            (n, n_point) float64, nats, up to a constant per signal.
        """
        by_state = self._of_touches(batch)
        return np.stack([each[:, self._believed(each, self.start).argmax()] for each in by_state])

    def log_likelihood(self, frames: Array) -> Array:
        """Log-likelihood of every point, each frame taken as the first touch.

        Args:
            frames: (n, n_microphone, 250) float64, Pa.

        Returns:
            (n, n_point) float64, nats, up to a constant per frame.
        """
        return self.joint_log_likelihood(frames)

    def _probability(self, batch: Array) -> Array:
        return _probability(self.joint_log_likelihood(batch))

    def _transfer_functions(self, library: Library) -> Array:
        """Transfer functions of the states, (n_state, n_point, n_microphone, n_freq) complex128."""
        model = UpdatedModel(library)
        u = np.zeros((len(self.stiffness), model.count))
        modulus = model.groups.index("modulus")
        u[:, modulus] = np.log(self.stiffness) / model.scale[modulus]
        return model.transfer_function(u)

    def _by_state(self, frames: Array) -> Array:
        """Log-likelihoods of frames in all states, (n, n_point, n_state), nats."""
        return self.likelihood.scores(frames).reshape(len(frames), self.point_count, -1)

    def _of_touches(self, batch: Array) -> Array:
        """Log-likelihoods of touches, (n, n_point, n_state), nats, all frames of each together."""
        frames = cut_frames(batch)
        score = in_parts(self._by_state, frames, self.options.frames_at_once)
        return np.asarray(score.reshape(*frames.shape[:2], *score.shape[1:]).sum(1))

    def _believed(self, by_state: Array, state: Array) -> Array:
        """Belief after a touch of log-likelihoods (n_point, n_state)."""
        evidence = logsumexp(by_state, axis=0)
        evidence = self._new * np.maximum(evidence - evidence.max(), self.options.least_log_likelihood)
        before = np.log(np.exp(state) @ self._transition)
        return np.asarray(before + evidence - logsumexp(before + evidence))


def _probability(score: Array) -> Array:
    """Probabilities of points from log-likelihoods, both (n, n_point)."""
    return np.exp(score - logsumexp(score, axis=1, keepdims=True))


def check_drift(library: Library | ArrayResponse) -> None:
    """Refuse a library about which no drift can be followed.

    Args:
        library: of a sensor.

    Raises:
        Refusal: it is not of a design, not calibrated, or not calibrated at all points.
    """
    if isinstance(library, ArrayResponse):
        problem = "must be one of a design, because bare transfer functions do not say what a drift changes"
        raise Refusal(problem, kind=Kind.UNSUITABLE, field="library")
    if library.fidelity != MEASURED:
        problem = (
            f"must be calibrated to follow a drift, but it was computed ({library.fidelity}): parts that differ from "
            "the design would be taken for a drift, and touches would be assigned to wrong points"
        )
        remedy = "make a library with calibrate or recalibrate"
        raise Refusal(problem, kind=Kind.UNSUITABLE, field="library", remedy=remedy)
    made = library.provenance.get("calibration", {})
    measured = len(made.get("measured_points", ()))
    if made.get("other_points") == "model" and measured < library.design.point_count:
        problem = (
            f"must be calibrated at all points to follow a drift, but only {measured} of {library.design.point_count} "
            "were measured"
        )
        raise Refusal(problem, kind=Kind.UNSUITABLE, field="library")
