"""Samples at which a microphone was clipped, and what they leave unknown of a frame.

A clipped sample is wrong by an amount that nobody knows. The equaliser and the high-pass of a stream spread it over all
samples behind it, as their impulse response: a press that is clipped while it rises leaves pressures of half of its
size for a second, and they point to a wrong place. So a frame with clipped samples holds one unknown amplitude for each
of them, times that response. Decoders leave these signals out and locate the touch by the others.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import scipy.signal
from numpy.typing import NDArray

from acoustic_fem.network.microphone_output import Equaliser
from geometry.ground.typed import Array
from localize.live.events import HOP
from localize.live.front_end import high_pass_sections
from localize.live.stream_options import StreamOptions
from localize.signals.frames import FRAME
from localize.signals.locator import Locator

REMEMBERED = 4 * FRAME
"""Number of samples over which a clipped sample is remembered: the equaliser has all but forgotten it then."""
BEFORE = 1, 2, 4, 8, 16, 32, 64, 128, 256, 512
"""Samples before the beginning of the filters at which pulses stand for what the filters should remember."""
FORGOTTEN = 4 * REMEMBERED
"""Number of samples from the beginning of the filters on after which it does not matter how they began."""
MISSING = 3.0
"""Order of what a clipped sample is short of, by the pressure at which it is clipped."""


class ClippedSamples:
    """Memory of the clipped samples of a stream.

    Args:
        channels: number of microphones.
        limit: Pa; a sample that reaches it is clipped.
        equaliser: of the stream.
        high_pass: corner of the high-pass behind it, Hz; None for none.
    """

    def __init__(self, channels: int, limit: float, equaliser: Equaliser, high_pass: float | None) -> None:
        self._limit = limit
        impulse = np.zeros(FORGOTTEN + REMEMBERED)
        impulse[0] = MISSING * limit
        passed = scipy.signal.sosfilt(equaliser.sections, impulse)
        self._spread = passed if high_pass is None else scipy.signal.sosfilt(high_pass_sections(high_pass), passed)
        self._clipped = np.zeros((channels, REMEMBERED), bool)  # the newest sample last
        self._since = 0  # samples since the filters began
        self._in_signal = False  # True if they began in the middle of a signal
        self._found: Array | None = None  # by the last frame that was decided

    def reset(self) -> None:
        """Forget all: the stream begins anew."""
        self._clipped[:] = False
        self._since, self._in_signal = 0, False

    def begin(self) -> None:
        """Begin with the newest frame, in which nothing is clipped.

        A signal may last in it, so that it is unknown what the filters should remember of the samples before.
        """
        self._clipped[:] = False
        self._since, self._in_signal = FRAME, True

    def take(self, samples: Array) -> None:
        """Take samples as they come, (n_microphone, n) float64, Pa."""
        clipped = np.abs(samples) >= self._limit
        if self._clipped.any() or clipped.any():
            self._clipped = np.concatenate([self._clipped, clipped], axis=1)[:, samples.shape[1] :]
        self._since = min(self._since + samples.shape[1], FORGOTTEN)

    @property
    def channels(self) -> NDArray[np.bool_]:
        """Microphones of which a sample was clipped since the filters began, (n_microphone,)."""
        return np.asarray(self._clipped.any(1))

    @property
    def in_frame(self) -> bool:
        """True if a sample of the newest frame was clipped."""
        return bool(self._clipped[:, -FRAME:].any())

    @property
    def rest(self) -> int:
        """Number of samples since the last one that was clipped."""
        where = np.flatnonzero(self._clipped.any(0))
        return REMEMBERED if len(where) == 0 else REMEMBERED - 1 - int(where[-1])

    @property
    def _began_clipped(self) -> bool:
        """True if a sample was clipped before the filters had begun on a whole frame, so that they began wrongly."""
        begin = max(0, REMEMBERED - self._since)
        return bool(self._clipped[:, begin : max(0, begin + FRAME - max(0, self._since - REMEMBERED))].any())

    def decided(self, locator: Locator, frame: Array, state: Any, options: StreamOptions) -> tuple[Array | None, Any]:
        """Probability of each point by what is known of the newest frame, and the next state of the locator.

        Args:
            locator: classifies frames.
            frame: (n_microphone, 250) float64, Pa, behind the front end.
            state: of the locator, as of :meth:`localize.Locator.follow`.
            options: of the stream.

        Returns:
            (n_point,) float64; None while a press may still be rising, and where too little is known.
        """
        late = self.rest - options.clipped_rest
        if late < 0 or self._began_clipped:
            self._found = None
        elif late % (options.clipped_hops * HOP) < HOP:
            known = locator.without(self.unknown())
            self._found = None
            if known is not None:
                found, followed = known.follow(frame, state)
                if found.max() >= options.clipped_sure:
                    self._found, state = found, followed
        return self._found, state

    def unknown(self) -> Array:
        """Signals in the newest frame whose amplitudes nobody knows, (n, n_microphone, 250) float64, Pa."""
        channel, at = np.nonzero(self._clipped)
        age = REMEMBERED - 1 - at
        if self._in_signal and self._since < FORGOTTEN:
            every = np.arange(len(self._clipped))
            channel = np.concatenate([channel, np.repeat(every, len(BEFORE))])
            age = np.concatenate([age, np.tile(self._since - 1 + np.array(BEFORE), len(every))])
        lag = np.arange(1 - FRAME, 1) + age[:, None]
        signals = np.zeros((len(age), len(self._clipped), FRAME))
        signals[np.arange(len(age)), channel] = np.where(lag >= 0, self._spread[np.maximum(lag, 0)], 0.0)
        return signals
