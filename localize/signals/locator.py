"""One interface of networks, graphs and decoders: what a localizer says of itself, and how it is asked."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array
from localize.signals.array_facts import ArrayFacts
from localize.signals.array_response import ArrayResponse
from localize.signals.frames import checked_signals
from localize.signals.noise_model import NoiseChoice
from localize.signals.threads import one_thread

if TYPE_CHECKING:
    from torch import Tensor


class Locator:
    """Localizer of any kind: it classifies signals by the touched point, and keeps nothing of earlier signals.

    A localizer that follows its sensor over the touches hands its next state back: see :meth:`follow`.
    """

    array: ArrayFacts
    """Array that is decoded."""
    response: ArrayResponse | None = None
    """Transfer functions that are decoded; None for a network or graph."""
    options: Any = None
    """Options that tune the localizer, a frozen dataclass; None for a network or graph."""
    start: Any = None
    """State of the sensor before the first touch, for :meth:`follow`; None where nothing is followed."""

    @one_thread()
    def locate(self, signals: ArrayLike | Tensor) -> Array:
        """Probability of each point, all points equally likely beforehand.

        A recording longer than 250 samples is cut into frames, the last one ending with it, which are taken as
        independent observations of one touch.

        Args:
            signals: (n_microphone, n_sample) or (n, n_microphone, n_sample), Pa, at 1 kHz, at least 250 samples.

        Returns:
            (n_point,) or (n, n_point) float64: probability per point.

        Raises:
            Refusal: wrong number of channels, too few samples, a value that is not finite, a silent channel.
        """
        batch, batched = checked_signals(signals, self.microphones)
        probability = self._probability(batch)
        return probability if batched else probability[0]

    def _probability(self, batch: Array) -> Array:
        """Probabilities (n, n_point) of signals (n, n_microphone, n_sample) that were checked."""
        raise NotImplementedError

    def follow(self, signals: ArrayLike | Tensor, state: Any) -> tuple[Array, Any]:
        """Probability of each point of touches in the order in which they came, and the state of the sensor after them.

        Args:
            signals: (n_microphone, n_sample) or (n, n_microphone, n_sample), Pa, as of :meth:`locate`.
            state: :attr:`start`, or what the call before gave.

        Returns:
            Probabilities as of :meth:`locate`, (n_point,) or (n, n_point) float64, and the next state.

        Raises:
            Refusal: as of :meth:`locate`.
        """
        return self.locate(signals), state

    def misfit(self, frames: Array) -> Array:
        """Residual that the best point leaves of each frame, over that of the assumed noise.

        Args:
            frames: (n, n_microphone, 250) float64, Pa.

        Returns:
            (n,) float64; not a number where the localizer knows no residual.
        """
        return np.full(len(frames), np.nan)

    def heard_by(self, microphones: tuple[str, ...]) -> Self:
        """The localizer of the same sensor by some of its microphones.

        Args:
            microphones: names, two or more.

        Raises:
            Refusal: a microphone that the array does not have, fewer than two, or a localizer that needs all.
        """
        raise Refusal("cannot be left out: a network needs all microphones", kind=Kind.UNSUITABLE, field="microphones")

    def without(self, unknown: Array) -> Self | None:
        """The localizer of frames in which signals lie whose amplitudes nobody knows, such as clipped samples.

        Args:
            unknown: signals, (n, n_microphone, 250) float64, Pa, with amplitudes of order 1.

        Returns:
            None if the signals leave too little of a frame, or if the localizer needs whole frames.
        """
        return None

    @property
    def needs_whole_frames(self) -> bool:
        """True if no part of a frame can be left out."""
        return True

    @property
    def needs_all_microphones(self) -> bool:
        """True if nothing can be located without one of the microphones."""
        return True

    @property
    def largest_misfit(self) -> float | None:
        """Largest median of :meth:`misfit` over loud touches of a sensor as it is expected; None if it is not known."""
        return None

    @property
    def microphone_noise(self) -> NoiseChoice:
        """Noise that the localizer was made for, as tests of its signals take it."""
        return self.array.noise_rms or "design"

    @property
    def kind(self) -> str:
        """Kind of localizer, as graphs state theirs."""
        return "network"

    @property
    def assumptions(self) -> str:
        """Assumptions about the sensor or touches, in words."""
        return "that touches are like those of the training"

    @property
    def no_graph(self) -> str:
        """Reason why no ONNX graph can hold this localizer, as a clause; empty where one can."""
        return "no graph holds a localizer of its kind"

    @property
    def design(self) -> str:
        """Name of the design."""
        return self.array.design

    @property
    def microphones(self) -> tuple[str, ...]:
        """Names of the microphones, in the order of the signals."""
        return self.array.microphones

    @property
    def line(self) -> NDArray[np.int64]:
        """Line of each point, as the library numbers it; (n_point,) int64."""
        return self.array.line

    @property
    def place(self) -> NDArray[np.int64]:
        """Place of each point along its line, as the library numbers it; (n_point,) int64."""
        return self.array.place

    @property
    def provenance(self) -> Mapping[str, Any]:
        """Design, fidelity, air, frequencies and versions."""
        return self.array.provenance

    @property
    def noise_rms(self) -> float:
        """Noise of a microphone that the localizer was made for, Pa rms over 0 to 500 Hz."""
        return self.array.noise_rms

    @property
    def point_count(self) -> int:
        """Number of sensing points."""
        return self.array.point_count
