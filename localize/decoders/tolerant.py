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

from acoustic_fem.scatter.tolerances import UNCALIBRATED, UnknownScatterError
from geometry.ground.refusal import Refusal
from localize.decoders.bayes import Ambient, BayesDecoder, air_of
from localize.decoders.deviations import DeviatingTables
from localize.decoders.frame_covariance import SAMPLES, touch_covariances
from localize.decoders.hypotheses import made_hypotheses
from localize.decoders.likelihood import FAR, TEMPERATURE, Bounds, Screen
from localize.signals.array_response import ArrayResponse
from localize.signals.frames import cut_frames
from localize.signals.noise_model import NoiseChoice

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

    bounds_scores = False  # of points: hypotheses have bounds

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
        self._bounds = tuple(Bounds(tables) for tables in self.tables)
        self._deviating = tuple(
            DeviatingTables(tables, self.hypotheses, each, WARMTH)
            for tables, each in zip(self.tables, whitening, strict=True)
        )

    def joint_log_likelihood(self, batch: NDArray[np.float64]) -> NDArray[np.float64]:
        """Log-likelihood of every point, all frames of each signal together: they are of one sensor.

        Args:
            batch: (n, n_microphone, n_sample) float64, Pa, as :func:`localize.signals.checked_signals` gives it.

        Returns:
            (n, n_point) float64, nats, up to a constant per signal.
        """
        frames = cut_frames(batch)
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

    def _leading(self, batch: NDArray[np.float64]) -> NDArray[np.float64]:
        """Log-likelihoods of points: which hypotheses are scored is decided there."""
        return self.joint_log_likelihood(batch)

    def misfit(self, frames: NDArray[np.float64]) -> NDArray[np.float64]:
        """What the best hypothesis leaves of frames (n, n_microphone, 250), Pa: (n,) float64, as
        :meth:`localize.BayesDecoder.misfit`.
        """
        heard = _Heard(self._screens, self._bounds, frames[:, None])
        return self._misfit(self._fitted(heard), heard)

    def _of_recordings(self, frames: NDArray[np.float64]) -> NDArray[np.float64]:
        """(n, n_frame, n_microphone, 250) to (n, n_point), the log-likelihoods, nats."""
        heard = _Heard(self._screens, self._bounds, frames)
        found = self._fitted(heard)
        fitted = np.isfinite(found)
        doubt = np.maximum(1.0, self._misfit(found, heard) / MISFIT)[:, None] ** 2
        # The others can be no better than the worst of these.
        least = np.where(fitted, found, np.inf).min(1, keepdims=True)
        prior = np.tile(self.log_prior.ravel(), len(self.tables))
        heard.know(np.minimum(heard.score, least) + prior > (found + prior).max(1, keepdims=True) - FAR * doubt)
        score = np.where(fitted, found, np.minimum(heard.score, least))
        best = score.reshape(len(score), len(self.tables), *self.log_prior.shape).max(1)
        return np.asarray(np.logaddexp.reduce(best + self.log_prior, axis=2) / doubt)

    def _fitted(self, heard: _Heard) -> NDArray[np.float64]:
        """Scores of the likeliest hypotheses of recordings with their deviations; (n, n_level n_table) nats, of the
        others -inf.
        """
        likeliest = heard.likeliest(min(CANDIDATES, heard.score.shape[1]))
        fitted = np.zeros(heard.score.shape, bool)
        np.put_along_axis(fitted, likeliest, True, axis=1)
        found = np.full(heard.score.shape, -np.inf)
        for columns in self._together(likeliest):
            level, tables = int(columns[0]) // self.log_prior.size, columns % self.log_prior.size
            chosen = fitted[:, columns[0]]
            score = self._deviating[level].scores(heard.white[level][chosen], tables) + heard.alone[level][chosen]
            found[np.ix_(chosen, columns)] = score.T
        return found

    def _misfit(self, found: NDArray[np.float64], heard: _Heard) -> NDArray[np.float64]:
        """What the best hypothesis leaves of each recording, by what the noise that was told leaves; (n,)."""
        recording, column = np.arange(len(found)), found.argmax(1)
        level = column // self.log_prior.size
        fit = found[recording, column] - np.stack(heard.alone)[level, recording]
        power = np.stack([(each**2).sum((1, 2)) for each in heard.white])[level, recording]
        empty = heard.white[0][0].size * (1 - 1 / len(self.microphones))
        return (power / TEMPERATURE - 2 * WARMTH * fit) / empty

    def _together(self, likeliest: NDArray[np.int64]) -> list[NDArray[np.int64]]:
        """Columns of scores that are found in one go: of several recordings each, of a single one those of a level."""
        columns = np.unique(likeliest)
        if len(likeliest) > 1:
            return np.split(columns, len(columns))
        if len(self.tables) == 1:
            return [columns]
        return np.split(columns, np.flatnonzero(np.diff(columns // self.log_prior.size)) + 1)

    @property
    def assumes(self) -> str:
        """What is taken for granted of the sensor, in words."""
        air = air_of(self.provenance)
        return (
            f"that the sensor was made from its design within the tolerances of manufacturing, and not calibrated{air}"
        )

    @property
    def shapes(self) -> int:
        """Number of shapes in which a hypothesis deviates."""
        return self._deviating[0].shapes

    @property
    def log_prior(self) -> NDArray[np.float64]:
        """Logarithm of the prior of each hypothesis of a point; (n_point, n_hypothesis) float64."""
        return self.hypotheses.log_prior


SPARE = 6
"""Hypotheses that are scored at once beyond those that are wanted: with them the best are found in one go mostly."""


class _Heard:
    """Recordings with the scores of hypotheses, level by level: each what it is at most, until it is known.

    Args:
        screens: of the levels of sound.
        bounds: of the same.
        frames: (n, n_frame, n_microphone, 250) float64, Pa.
    """

    def __init__(self, screens: Sequence[Screen], bounds: Sequence[Bounds], frames: NDArray[np.float64]) -> None:
        self._screens, self._shape = tuple(screens), frames.shape[:2]
        flat = frames.reshape(len(frames) * frames.shape[1], -1)
        white = [flat @ screen.tables.reduce for screen in screens]
        alone = [screen.alone(x)[1] for screen, x in zip(screens, white, strict=True)]
        self.white = [x.reshape(*self._shape, -1) for x in white]
        """Frames where noise and sound are white, of each level (n, n_frame, size)."""
        self.alone = [each.reshape(self._shape).sum(1) / WARMTH for each in alone]
        """Scores of noise and sound without a touch, of each level (n,) nats."""
        self.score = self._joint([bound(x) for bound, x in zip(bounds, white, strict=True)])
        """Scores of the hypotheses, one level after the other, without deviations; (n, n_level n_table) nats."""
        self._known = np.zeros(self.score.shape, bool)

    def likeliest(self, count: int) -> NDArray[np.int64]:
        """So many of the hypotheses that score highest; (n, count)."""
        first = min(count + SPARE, self.score.shape[1])
        self.know(self.score >= -np.partition(-self.score, first - 1, axis=1)[:, [first - 1]])
        least = -np.partition(np.where(self._known, -self.score, np.inf), count - 1, axis=1)[:, [count - 1]]
        self.know(self.score > least)
        chosen = np.argpartition(-self.score, count - 1, axis=1)[:, :count]
        lowest = np.take_along_axis(self.score, chosen, 1).min(1, keepdims=True)
        self.score = np.where(self._known, self.score, np.minimum(self.score, lowest))
        return chosen

    def know(self, wanted: NDArray[np.bool_]) -> None:
        """Find the scores that are wanted, (n, n_level n_table) bool, and are not known yet."""
        wanted = wanted & ~self._known
        if not wanted.any():
            return
        of_levels = np.split(np.repeat(wanted, self._shape[1], 0), len(self._screens), axis=1)
        white = [x.reshape(-1, x.shape[2]) for x in self.white]
        each = zip(self._screens, white, of_levels, strict=True)
        scores = [screen.some(x, chosen) for screen, x, chosen in each]
        self.score[wanted] = self._joint(scores)[wanted]
        self._known |= wanted

    def _joint(self, scores: list[NDArray[np.float64]]) -> NDArray[np.float64]:
        """Of all frames of a recording together, from those of frames by levels, (n n_frame, n_table) each."""
        together = [score.reshape(*self._shape, -1).sum(1) / WARMTH for score in scores]
        return np.concatenate([score + own[:, None] for score, own in zip(together, self.alone, strict=True)], axis=1)


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


def objection_to_tolerances(library: Library) -> str | None:
    """Reason why tolerances of manufacturing cannot be reckoned with; None where they can, or the sensor is known.

    Args:
        library: measured or computed.
    """
    from acoustic_fem.scatter.tolerances import ScatteredDesign

    if not _is_measured(library):
        try:
            ScatteredDesign(library.design, UNCALIBRATED)
        except UnknownScatterError as error:
            return str(error)
    return None


def _is_measured(library: Library) -> bool:
    from acoustic_fem.library.transfer_functions import MEASURED

    return library.fidelity == MEASURED
