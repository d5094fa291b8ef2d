"""Parameters that are not known: several libraries of one array, one for each hypothesis.

A made sensor has one set of parameters (the modulus of its membranes, its tolerances), which of those drawn is not
known. Given hypothesis k with prior p_k, the likelihood of point i is L_ki; what counts is sum_k p_k L_ki. The sensor
is the same in all frames of a recording, so likelihoods are multiplied over frames first and summed over hypotheses
last.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike
from scipy.special import logsumexp, softmax

from acoustic_fem import Library
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array
from localize.decoders.bayes import BayesDecoder
from localize.signals.array_response import ArrayResponse
from localize.signals.frames import checked_signals
from localize.signals.locator import Locator
from localize.signals.noise_model import NoiseChoice
from localize.signals.threads import one_thread

if TYPE_CHECKING:
    from torch import Tensor


class FamilyDecoder(Locator):
    """Maximum likelihood over points, the hypotheses summed out.

    Args:
        libraries: of the same points and microphones, one per hypothesis.
        microphone_noise: as of :class:`localize.BayesDecoder`.
        prior: (n_library,) weights of the hypotheses, ratios above 0; by default all alike.

    Raises:
        Refusal: no library, or libraries of different points or microphones; a wrong prior; as
            :class:`localize.BayesDecoder`.
    """

    def __init__(
        self,
        libraries: Sequence[Library | ArrayResponse],
        microphone_noise: NoiseChoice = "design",
        prior: ArrayLike | None = None,
    ) -> None:
        if not libraries:
            raise Refusal(kind=Kind.MISSING, field="libraries", allowed="one or more, each a hypothesis")
        weight = np.ones(len(libraries)) if prior is None else np.asarray(prior, np.float64)
        if weight.shape != (len(libraries),) or not (np.isfinite(weight) & (weight > 0)).all():
            allowed = f"{len(libraries)} finite values above 0, one per library"
            raise Refusal(kind=Kind.OUT_OF_RANGE, field="prior", value=weight.tolist(), allowed=allowed)
        self.decoders = tuple(BayesDecoder(library, microphone_noise) for library in libraries)
        first = self.decoders[0]
        for k, other in enumerate(self.decoders):
            same = other.point_count == first.point_count and (other.line == first.line).all()
            if not (same and (other.place == first.place).all() and other.microphones == first.microphones):
                problem = "has other points or microphones than the first one"
                raise Refusal(problem, kind=Kind.MISMATCH, field=f"libraries.{k + 1}")
        self.array = first.array
        self._log_prior = np.log(weight / weight.sum())

    @property
    def kind(self) -> str:
        """Kind of localizer."""
        return "model-based decoder"

    @property
    def assumptions(self) -> str:
        """Assumptions about the sensor, in words."""
        return "that the sensor is one of its libraries"

    def _probability(self, batch: Array) -> Array:
        return np.asarray(softmax(logsumexp(self._joint(batch), axis=2), axis=1))

    @one_thread()
    def hypotheses(self, signals: ArrayLike | Tensor) -> Array:
        """Probability of each hypothesis.

        Args:
            signals: (n_microphone, n_sample) or (n, n_microphone, n_sample), Pa, at 1 kHz, at least 250 samples.

        Returns:
            (n_hypothesis,) or (n, n_hypothesis) float64: probability per hypothesis.

        Raises:
            Refusal: as :meth:`localize.BayesDecoder.locate`.
        """
        batch, batched = checked_signals(signals, self.microphones)
        probability = softmax(logsumexp(self._joint(batch), axis=1), axis=1)
        return np.asarray(probability if batched else probability[0])

    def _joint(self, batch: Array) -> Array:
        """Log of likelihood times prior, (n, n_point, n_hypothesis), all frames of each signal together."""
        return np.stack([each.joint_log_likelihood(batch) for each in self.decoders], -1) + self._log_prior
