"""Tolerance-aware decoder of a sensor that nobody calibrated.

It models what manufacturing, the air of the place and the batch of rubber may have changed.

Each point has several hypotheses, :mod:`localize.decoders.hypotheses`. The likelihood of a frame under each is that of
:mod:`localize.decoders.bayes`; the likelihood of a point is their sum, weighted by their priors.

The best of them are fitted with deviations, :mod:`localize.decoders.deviations`. The residual fits no sensor exactly,
so differences of log-likelihoods overstate the evidence. They are therefore divided by a temperature that is higher
than that of the decoder of a calibrated sensor, and by a higher one still if even the best hypothesis does not fit.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Self

import numpy as np
from numpy.typing import NDArray

from acoustic_fem import Library
from acoustic_fem.library.transfer_functions import MEASURED
from acoustic_fem.scatter.tolerances import UNCALIBRATED, Tolerance, unknown_scatter
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array
from localize.decoders.bayes import BayesDecoder
from localize.decoders.decoder_options import TolerantOptions
from localize.decoders.deviations import DeviatingTables
from localize.decoders.frame_covariance import SAMPLES, touch_covariances
from localize.decoders.hypotheses import as_built_hypotheses, bare_library
from localize.decoders.level_likelihood import LevelLikelihood
from localize.decoders.library_decoder import LibraryDecoder
from localize.decoders.likelihood import Bounds, Screen
from localize.decoders.surroundings import Ambient, Surroundings
from localize.signals.array_response import response_of
from localize.signals.frames import cut_frames
from localize.signals.noise_model import NoiseChoice
from localize.signals.threads import one_thread


class TolerantDecoder(LibraryDecoder):
    """Maximum likelihood over the points of one array whose parts deviate from the design, in air that is not known.

    It takes several times the tables, and the time, of :class:`localize.BayesDecoder`, and some seconds to make.

    Args:
        library: transfer functions of a design, computed; they cover 1 to 100 Hz.
        tolerances: of manufacturing; by default :data:`acoustic_fem.scatter.UNCALIBRATED`.
        microphone_noise: as of :class:`localize.BayesDecoder`.
        ambient: as of :class:`localize.BayesDecoder`.
        microphones: names of two or more that are used; by default all.
        options: numbers that tune it.

    Raises:
        Refusal: bare transfer functions, a measured library, a design whose scatter is not known, a microphone that
            the library does not have, or as :class:`localize.BayesDecoder`.
    """

    options: TolerantOptions

    @one_thread()
    def __init__(
        self,
        library: Library,
        tolerances: Sequence[Tolerance] | None = None,
        microphone_noise: NoiseChoice = "design",
        ambient: Ambient = None,
        microphones: tuple[str, ...] | None = None,
        options: TolerantOptions = TolerantOptions(),
    ) -> None:
        if not hasattr(library, "fidelity"):
            raise bare_library()
        if library.fidelity == MEASURED:
            problem = "must be computed, because a measured one knows its sensor; take localize.BayesDecoder"
            raise Refusal(problem, kind=Kind.UNSUITABLE, field="library")
        response = response_of(library)
        response = response if microphones is None else response.heard_by(microphones)
        around = Surroundings.of(response, microphone_noise, ambient)
        self.tolerances = UNCALIBRATED if tolerances is None else tuple(tolerances)
        self.hypotheses = as_built_hypotheses(library, response, self.tolerances, options.hypotheses)
        each = [touch_covariances(one, np.eye(SAMPLES)) for one in self.hypotheses.responses]
        touched = np.stack(each, 1).reshape(-1, *each[0].shape[1:])
        super().__init__(response, around, touched, options)
        self._library = library
        self._bounds = tuple(Bounds(tables) for tables in self.tables)
        self.deviating = tuple(
            DeviatingTables(tables, self.hypotheses, each, options)
            for tables, each in zip(self.tables, self.likelihood.whitening, strict=True)
        )
        """Tables with their deviations, of each level of the sound around."""

    def heard_by(self, microphones: tuple[str, ...]) -> TolerantDecoder:
        """The decoder of the same sensor by some of its microphones; as of :class:`localize.Locator`."""
        return TolerantDecoder(
            self._library, self.tolerances, self.microphone_noise, self.ambient, microphones, self.options
        )

    def _decided_by(self, likelihood: LevelLikelihood) -> Self:
        found = super()._decided_by(likelihood)
        found._bounds = tuple(Bounds(tables) for tables in found.tables)
        found.deviating = tuple(
            DeviatingTables(tables, self.hypotheses, each, self.options, at_once=False)
            for tables, each in zip(found.tables, likelihood.whitening, strict=True)
        )
        return found

    def joint_log_likelihood(self, batch: Array) -> Array:
        """Log-likelihood of every point, all frames of each signal together: they are of one sensor.

        Args:
            batch: (n, n_microphone, n_sample) float64, Pa, as :func:`localize.signals.checked_signals` gives it.

        Returns:
            (n, n_point) float64, nats, up to a constant per signal.
        """
        frames = cut_frames(batch)
        several = max(1, self.options.frames_together // frames.shape[1])
        return np.concatenate([self._of_recordings(frames[k : k + several]) for k in range(0, len(frames), several)])

    def log_likelihood(self, frames: Array) -> Array:
        """Log-likelihood of every point.

        Args:
            frames: (n, n_microphone, 250) float64, Pa.

        Returns:
            (n, n_point) float64, nats, up to a constant per frame.
        """
        return self._of_recordings(frames[:, None])

    def misfit(self, frames: Array) -> Array:
        """Residual that the best hypothesis leaves of each frame, over that of the assumed noise.

        Args:
            frames: (n, n_microphone, 250) float64, Pa.

        Returns:
            (n,) float64.
        """
        heard = _ScoredRecordings(self.likelihood.screens, self._bounds, frames[:, None], self.options)
        return self._misfit(self._fitted(heard), heard)

    def _of_recordings(self, frames: Array) -> Array:
        """(n, n_frame, n_microphone, 250) to (n, n_point), the log-likelihoods, nats."""
        frames = self._attenuated(frames)
        heard = _ScoredRecordings(self.likelihood.screens, self._bounds, frames, self.options)
        found = self._fitted(heard)
        fitted = np.isfinite(found)
        distrust = np.maximum(1.0, self._misfit(found, heard) / self.options.explained_misfit)[:, None] ** 2
        # The others can be no better than the worst of these.
        least = np.where(fitted, found, np.inf).min(1, keepdims=True)
        prior = np.tile(self.log_prior.ravel(), len(self.tables))
        heard.know(
            np.minimum(heard.score, least) + prior
            > (found + prior).max(1, keepdims=True) - self.options.far_lead * distrust
        )
        score = np.where(fitted, found, np.minimum(heard.score, least))
        best = score.reshape(len(score), len(self.tables), *self.log_prior.shape).max(1)
        return np.asarray(np.logaddexp.reduce(best + self.log_prior, axis=2) / distrust)

    def _attenuated(self, frames: Array) -> Array:
        """Frames (n, n_frame, n_microphone, 250), those that are louder than is believed brought to that level."""
        white = frames.reshape(*frames.shape[:2], -1) @ self.tables[0].reduce
        level = (white * white).mean(2) / self.options.temperature
        gain = np.sqrt(np.minimum(1.0, 10 ** (self.options.believed_level / 10) / np.maximum(level, 1e-30)))
        return np.asarray(frames * gain[:, :, None, None])

    def _fitted(self, heard: _ScoredRecordings) -> Array:
        """Scores of the likeliest hypotheses of recordings with their deviations; (n, n_level n_table) nats, of the
        others -inf.
        """
        likeliest = heard.likeliest(min(self.options.candidates, heard.score.shape[1]))
        fitted = np.zeros(heard.score.shape, bool)
        np.put_along_axis(fitted, likeliest, True, axis=1)
        found = np.full(heard.score.shape, -np.inf)
        for columns in self._together(likeliest):
            level, tables = int(columns[0]) // self.log_prior.size, columns % self.log_prior.size
            chosen = fitted[:, columns[0]]
            score = self.deviating[level].scores(heard.white[level][chosen], tables) + heard.alone[level][chosen]
            found[np.ix_(chosen, columns)] = score.T
        return found

    def _misfit(self, found: Array, heard: _ScoredRecordings) -> Array:
        """Residual of each recording under its best hypothesis, over the residual of the given noise alone; (n,)."""
        recording, column = np.arange(len(found)), found.argmax(1)
        level = column // self.log_prior.size
        fit = found[recording, column] - np.stack(heard.alone)[level, recording]
        power = np.stack([(each**2).sum((1, 2)) for each in heard.white])[level, recording]
        empty = heard.white[0][0].size * (1 - 1 / len(self.microphones))
        return (power / self.options.temperature - 2 * self.options.relative_temperature * fit) / empty

    def _together(self, likeliest: NDArray[np.int64]) -> list[NDArray[np.int64]]:
        """Columns of scores that are found in one go: of several recordings each, of a single one those of a level."""
        columns = np.unique(likeliest)
        if len(likeliest) > 1:
            return np.split(columns, len(columns))
        if len(self.tables) == 1:
            return [columns]
        return np.split(columns, np.flatnonzero(np.diff(columns // self.log_prior.size)) + 1)

    @property
    def no_graph(self) -> str:
        """Reason why no ONNX graph can hold this localizer, as a clause."""
        return "it fits deviations to each frame"

    @property
    def largest_misfit(self) -> float | None:
        """Largest median misfit of a sensor within its tolerances."""
        return self.options.misfit_of_two if len(self.microphones) == 2 else self.options.misfit_of_more

    @property
    def assumptions(self) -> str:
        """Assumptions about the sensor, in words."""
        built = "that the sensor was built from its design within manufacturing tolerances and not calibrated"
        given, drawn = self.array.in_air, self.options.hypotheses.air_and_rubber
        if drawn is None:
            return built + given
        lowest, highest = (f"{pressure / 1e3:g}" for pressure in drawn.pressure)
        return f"{built}{f'{given} or' if given else ', in air'} of {lowest} to {highest} kPa"

    @property
    def shapes(self) -> int:
        """Number of shapes in which a hypothesis deviates."""
        return self.deviating[0].shapes

    @property
    def log_prior(self) -> Array:
        """Logarithm of the prior of each hypothesis of a point; (n_point, n_hypothesis) float64."""
        return self.hypotheses.log_prior


class _ScoredRecordings:
    """Recordings with the scores of hypotheses, level by level: each what it is at most, until it is known.

    Args:
        screens: of the levels of sound.
        bounds: of the same.
        frames: (n, n_frame, n_microphone, 250) float64, Pa.
        options: of the decoder.
    """

    def __init__(
        self, screens: Sequence[Screen], bounds: Sequence[Bounds], frames: Array, options: TolerantOptions
    ) -> None:
        self._screens, self._shape = tuple(screens), frames.shape[:2]
        self._options = options
        flat = frames.reshape(len(frames) * frames.shape[1], -1)
        white = [flat @ screen.tables.reduce for screen in screens]
        alone = [screen.alone(x)[1] for screen, x in zip(screens, white, strict=True)]
        self.white = [x.reshape(*self._shape, -1) for x in white]
        """Frames where noise and sound are white, of each level (n, n_frame, size)."""
        self.alone = [each.reshape(self._shape).sum(1) / self._options.relative_temperature for each in alone]
        """Scores of noise and sound without a touch, of each level (n,) nats."""
        self.score = self._joint([bound(x) for bound, x in zip(bounds, white, strict=True)])
        """Scores of the hypotheses, one level after the other, without deviations; (n, n_level n_table) nats."""
        self._known = np.zeros(self.score.shape, bool)

    def likeliest(self, count: int) -> NDArray[np.int64]:
        """So many of the hypotheses that score highest; (n, count)."""
        first = min(count + self._options.extra_candidates, self.score.shape[1])
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

    def _joint(self, scores: list[Array]) -> Array:
        """Scores of all frames of a recording together, from those of frames by levels, (n n_frame, n_table)."""
        together = [score.reshape(*self._shape, -1).sum(1) / self._options.relative_temperature for score in scores]
        return np.concatenate([score + own[:, None] for score, own in zip(together, self.alone, strict=True)], axis=1)


def decoder_of(
    library: Library, microphone_noise: NoiseChoice = "design", ambient: Ambient = None
) -> TolerantDecoder | BayesDecoder:
    """Decoder that a sensor asks for: of a computed library the one that models manufacturing tolerances.

    Args:
        library: measured or computed.
        microphone_noise: as of :class:`localize.BayesDecoder`.
        ambient: as of :class:`localize.BayesDecoder`.

    Returns:
        :class:`localize.BayesDecoder` for a measured library, whose sensor is known, and where it is not known how a
        design scatters.

    Raises:
        Refusal: as :class:`localize.BayesDecoder`.
    """
    return tolerant_decoder(library, microphone_noise, ambient) or BayesDecoder(library, microphone_noise, ambient)


def tolerant_decoder(
    library: Library, microphone_noise: NoiseChoice = "design", ambient: Ambient = None
) -> TolerantDecoder | None:
    """Decoder of a sensor that nobody calibrated, with the usual tolerances; arguments as of :func:`decoder_of`.

    Returns:
        None for a measured library, and where it is not known how a design scatters.

    Raises:
        Refusal: as :class:`localize.BayesDecoder`.
    """
    if library.fidelity == MEASURED or unknown_scatter(library.design) is not None:
        return None
    return TolerantDecoder(library, None, microphone_noise, ambient)


def unknown_tolerances(library: Library) -> str | None:
    """Reason why manufacturing tolerances cannot be modelled; None where they can, or where the sensor is known.

    Args:
        library: measured or computed.
    """
    unknown = None if library.fidelity == MEASURED else unknown_scatter(library.design)
    return None if unknown is None else str(unknown)
