"""The decoder of a sensor that nobody calibrated: it knows what the tolerances of manufacturing may have made of it.

Each point has several hypotheses, :mod:`localize.decoders.hypotheses`. The likelihood of a frame under each is that of
:mod:`localize.decoders.bayes`; what counts of a point is their sum, weighed by their priors.

The best of them are fitted with deviations, :mod:`localize.decoders.deviations`. What remains fits no sensor exactly,
so that differences of log-likelihoods are larger than what they tell: they are divided by a temperature that is higher
than that of the decoder of a known sensor; and by a higher one still where not even the best fits.
"""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray
from torch import Tensor

from acoustic_fem.scatter.tolerances import UNCALIBRATED, UnknownScatterError
from geometry.refusal import Refusal
from localize.decoders.bayes import TEMPERATURE, Ambient, BayesDecoder
from localize.decoders.deviations import DeviatingTables
from localize.decoders.frame_covariance import SAMPLES, touch_covariances
from localize.decoders.hypotheses import made_hypotheses
from localize.signals.array_response import ArrayResponse
from localize.signals.frames import cut_frames
from localize.signals.noise import NoiseChoice

if TYPE_CHECKING:
    from acoustic_fem import Library
    from acoustic_fem.scatter.tolerances import Tolerance

WARMTH = 2.0
"""Temperature over that of the decoder of a known sensor; tried were 1 to 5."""
TOGETHER = 256
"""Number of frames that are decoded at once: a hypothesis is fitted in one go to all that it may have made."""
MISFIT = 3.0
"""What the best hypothesis may leave of a frame, by what the noise that was told leaves where nothing else is heard.
Sensors as designed leave 1.2 to 3.2 (its determinants count, and so does what a frame's edges cut off). More says that
the sensor is none of those that were drawn, and log-likelihoods are divided by its square as well."""
CANDIDATES = 10
"""Hypotheses whose deviations are looked for in a frame; 40 name 0.2 % more touches of 36 points in line."""


class TolerantDecoder(BayesDecoder):
    """Maximum likelihood over the points of one array whose parts deviate from the design.

    It takes several times the tables, and the time, of :class:`localize.BayesDecoder`, and some seconds to make.

    Args:
        library: transfer functions of a design, computed; they cover 1 to 100 Hz.
        tolerances: of manufacturing; by default :data:`acoustic_fem.scatter.UNCALIBRATED`.
        microphone_noise: as of :class:`localize.BayesDecoder`.
        ambient: as of :class:`localize.BayesDecoder`.
        microphones: names of two or more that are listened to; by default all.

    Raises:
        Refusal: bare transfer functions, a measured library, a design whose scatter is not known, a microphone that
            the library does not have, or as :class:`localize.BayesDecoder`.
    """

    assumes = "that the sensor was made from its design within the tolerances of manufacturing, and not calibrated"

    def __init__(
        self,
        library: Library,
        tolerances: Sequence[Tolerance] | None = None,
        microphone_noise: NoiseChoice = 1e-3,
        ambient: Ambient = None,
        microphones: tuple[str, ...] | None = None,
    ) -> None:
        self.tolerances = UNCALIBRATED if tolerances is None else tuple(tolerances)
        self._listened_to = microphones
        super().__init__(library, microphone_noise, ambient)

    def _heard(self, library: Library | ArrayResponse) -> ArrayResponse:
        """The array, as the microphones hear it that are listened to."""
        response = super()._heard(library)
        return response if self._listened_to is None else response.heard_by(self._listened_to)

    def _touched(self, library: Library | ArrayResponse, response: ArrayResponse) -> NDArray[np.float64]:
        """Covariances of the hypotheses, point by point."""
        if isinstance(library, ArrayResponse):
            raise Refusal("library must be one of a design: bare transfer functions do not tell what its parts are")
        if _is_measured(library):
            raise Refusal("library must be computed: a measured one knows its sensor; take localize.BayesDecoder")
        self.hypotheses = made_hypotheses(library, response, self.tolerances)
        each = [touch_covariances(one, np.eye(SAMPLES)) for one in self.hypotheses.responses]
        return np.stack(each, 1).reshape(-1, *each[0].shape[1:])

    def _prepare(self, whitening: Sequence[NDArray[np.float64]]) -> None:
        """Levels of sound, with the deviations of the hypotheses."""
        super()._prepare(whitening)
        self._deviating = tuple(
            DeviatingTables(tables, self.hypotheses, each, WARMTH)
            for tables, each in zip(self.tables, whitening, strict=True)
        )

    def joint_log_likelihood(self, batch: Tensor) -> NDArray[np.float64]:
        """Log-likelihood of every point, all frames of each signal together: they are of one sensor.

        Args:
            batch: (n, n_microphone, n_sample) float64, Pa, as :func:`localize.signals.checked_signals` gives it.

        Returns:
            (n, n_point) float64, nats, up to a constant per signal.
        """
        frames = cut_frames(batch).numpy()
        several = max(1, TOGETHER // frames.shape[1])
        return np.concatenate([self._of_recordings(frames[k : k + several]) for k in range(0, len(frames), several)])

    def log_likelihood(self, frames: NDArray[np.float64]) -> NDArray[np.float64]:
        """Log-likelihood of every point.

        Args:
            frames: (n, n_microphone, 250) float64, Pa.

        Returns:
            (n, n_point) float64, nats, up to a constant per frame.
        """
        return self._of_recordings(frames[:, None])

    def _of_recordings(self, frames: NDArray[np.float64]) -> NDArray[np.float64]:
        """(n, n_frame, n_microphone, 250) to (n, n_point), the log-likelihoods, nats."""
        count, each = frames.shape[:2]
        levels = [screen(frames.reshape(count * each, -1)) for screen in self._screens]
        screened = np.concatenate([level.score for level in levels], axis=1).reshape(count, each, -1).sum(1) / WARMTH
        alone = [level.alone.reshape(count, each).sum(1) / WARMTH for level in levels]
        white = [level.x.reshape(count, each, -1) for level in levels]
        score = np.full(screened.shape, np.nan)
        likeliest = np.argpartition(-screened, min(CANDIDATES, screened.shape[1]) - 1, axis=1)[:, :CANDIDATES]
        np.put_along_axis(score, likeliest, 0.0, axis=1)
        for columns in self._together(likeliest):
            level, tables = int(columns[0]) // self.log_prior.size, columns % self.log_prior.size
            chosen = ~np.isnan(score[:, columns[0]])
            found = self._deviating[level].scores(white[level][chosen], tables) + alone[level][chosen]
            score[np.ix_(chosen, columns)] = found.T
        # The others can be no better than the worst of these.
        least = np.nanmin(score, axis=1, keepdims=True)
        score = np.where(np.isnan(score), np.minimum(screened, least), score)
        best = score.reshape(count, len(levels), *self.log_prior.shape).max(1)
        of_point = np.logaddexp.reduce(best + self.log_prior, axis=2)
        return np.asarray(of_point / np.maximum(1.0, self._misfit(score, white, alone) / MISFIT)[:, None] ** 2)

    def _misfit(
        self, score: NDArray[np.float64], white: list[NDArray[np.float64]], alone: list[NDArray[np.float64]]
    ) -> NDArray[np.float64]:
        """What the best hypothesis leaves of each recording, by what the noise that was told leaves; (n,)."""
        recording, column = np.arange(len(score)), score.argmax(1)
        level = column // self.log_prior.size
        fit = score[recording, column] - np.stack(alone)[level, recording]
        power = np.stack([(each**2).sum((1, 2)) for each in white])[level, recording]
        empty = white[0][0].size * (1 - 1 / len(self.microphones))
        return (power / TEMPERATURE - 2 * WARMTH * fit) / empty

    def _together(self, likeliest: NDArray[np.int64]) -> list[NDArray[np.int64]]:
        """Columns of scores that are found in one go: of several recordings each, of a single one those of a level."""
        columns = np.unique(likeliest)
        if len(likeliest) > 1:
            return np.split(columns, len(columns))
        return np.split(columns, np.flatnonzero(np.diff(columns // self.log_prior.size)) + 1)

    @property
    def log_prior(self) -> NDArray[np.float64]:
        """Logarithm of the prior of each hypothesis of a point; (n_point, n_hypothesis) float64."""
        return self.hypotheses.log_prior


def tolerant_decoder(
    library: Library,
    microphone_noise: NoiseChoice = 1e-3,
    ambient: Ambient = None,
    microphones: tuple[str, ...] | None = None,
) -> TolerantDecoder | None:
    """The decoder of a sensor that nobody calibrated, with the usual tolerances.

    Args:
        library: measured or computed.
        microphone_noise: as of :class:`localize.BayesDecoder`.
        ambient: as of :class:`localize.BayesDecoder`.
        microphones: as of :class:`TolerantDecoder`.

    Returns:
        None of a measured library, whose sensor is known, and where it is not known how a design scatters.

    Raises:
        Refusal: as :class:`localize.BayesDecoder`.
    """
    if not _is_measured(library):
        with suppress(UnknownScatterError):
            return TolerantDecoder(library, None, microphone_noise, ambient, microphones)
    return None


def _is_measured(library: Library) -> bool:
    from acoustic_fem.library.result import MEASURED

    return library.fidelity == MEASURED
