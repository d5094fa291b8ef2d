"""The decoder of a sensor that nobody calibrated: it knows what the tolerances of manufacturing may have made of it.

Each point has several hypotheses, :mod:`localize.decoders.hypotheses`. The likelihood of a frame under each is that of
:mod:`localize.decoders.bayes`; what counts of a point is their sum, weighed by their priors.

Between its hypotheses a sensor fits none exactly, so that differences of log-likelihoods are larger than what they
tell: they are divided by a temperature that is higher than that of the decoder of a known sensor.
"""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray
from scipy.special import logsumexp

from acoustic_fem.scatter.tolerances import UNCALIBRATED, UnknownScatterError
from geometry.refusal import Refusal
from localize.decoders.bayes import SURE, Ambient, BayesDecoder, DecoderTables, Screen, ScreenedLevel
from localize.decoders.frame_covariance import SAMPLES, touch_covariances
from localize.decoders.hypotheses import made_hypotheses
from localize.signals.array_response import ArrayResponse
from localize.signals.noise import NoiseChoice

if TYPE_CHECKING:
    from acoustic_fem import Library
    from acoustic_fem.scatter.tolerances import Tolerance

WARMTH = 1.5
"""Temperature over that of the decoder of a known sensor. Tried were 1 to 8: higher ones suit made sensors in quiet,
lower ones a noise of 5 mPa."""


class _BoundedScreen(Screen):
    """Likelihoods of those tables that may be among the best, in double precision; of the others how high they may be.

    What a frame holds in directions in which no touch of a table is heard speaks against the table, whatever the rest:
    a sixth of the numbers leaves a tenth of the tables.
    """

    def __init__(self, tables: DecoderTables, is_one_of_several: bool) -> None:
        self.tables, self.is_one_of_several = tables, is_one_of_several
        self.count, size, self.directions = tables.silent.shape
        self.silent = np.ascontiguousarray(tables.silent.astype(np.float32).transpose(1, 0, 2).reshape(size, -1))
        # The most that a unit of energy may gain, and the least that the size of a touch may cost, of all tables.
        self.gain = -tables.weight.min((0, 1)) / 2
        self.loss = tables.log_determinant.min(0) / 2

    def __call__(self, flat: NDArray[np.float64]) -> ScreenedLevel:
        """Bounds on the scores of (n, n_microphone 250) samples."""
        x = flat @ self.tables.reduce
        power, alone = self.alone(x)
        against = ((x.astype(np.float32) @ self.silent) ** 2).reshape(len(x), self.count, self.directions).sum(2)
        left = power[:, None] - against.astype(np.float64)
        score = (left[..., None] * self.gain - self.loss).max(2) + alone
        best = np.empty(len(x))
        first = score.argmax(1)
        for table in np.unique(first):
            frames = np.flatnonzero(first == table)
            best[frames] = self.exact(x[frames], int(table)) + alone[frames, 0]
        # The decoder leaves out what is 20 nats behind: here the temperature is higher.
        return ScreenedLevel(x, alone, score, np.full(len(x), (WARMTH - 1) * SURE), best)


class TolerantDecoder(BayesDecoder):
    """Maximum likelihood over the points of one array whose parts deviate from the design.

    It takes several times the tables, and the time, of :class:`localize.BayesDecoder`, and some seconds to make.

    Args:
        library: transfer functions of a design, computed; they cover 1 to 100 Hz.
        tolerances: of manufacturing; by default :data:`acoustic_fem.scatter.UNCALIBRATED`.
        microphone_noise: as of :class:`localize.BayesDecoder`.
        ambient: as of :class:`localize.BayesDecoder`.

    Raises:
        Refusal: bare transfer functions, a measured library, a design whose scatter is not known, or as
            :class:`localize.BayesDecoder`.
    """

    def __init__(
        self,
        library: Library,
        tolerances: Sequence[Tolerance] | None = None,
        microphone_noise: NoiseChoice = 1e-3,
        ambient: Ambient = None,
    ) -> None:
        self.tolerances = UNCALIBRATED if tolerances is None else tuple(tolerances)
        super().__init__(library, microphone_noise, ambient)

    def _touched(self, library: Library | ArrayResponse, response: ArrayResponse) -> NDArray[np.float64]:
        """Covariances of the hypotheses, point by point."""
        if isinstance(library, ArrayResponse):
            raise Refusal("library must be one of a design: bare transfer functions do not tell what its parts are")
        if _is_measured(library):
            raise Refusal("library must be computed: a measured one knows its sensor; take localize.BayesDecoder")
        hypotheses = made_hypotheses(library, response, self.tolerances)
        self.log_prior = hypotheses.log_prior
        each = [touch_covariances(one, np.eye(SAMPLES)) for one in hypotheses.responses]
        return np.stack(each, 1).reshape(-1, *each[0].shape[1:])

    def _screen(self, tables: DecoderTables, is_one_of_several: bool) -> Screen:
        """What scores the hypotheses at one level of sound."""
        return _BoundedScreen(tables, is_one_of_several)

    def _of_points(self, score: NDArray[np.float64]) -> NDArray[np.float64]:
        """Log-likelihoods of the points from those of their hypotheses."""
        return np.asarray(logsumexp(score.reshape(len(score), *self.log_prior.shape) / WARMTH + self.log_prior, axis=2))


def tolerant_decoder(
    library: Library, microphone_noise: NoiseChoice = 1e-3, ambient: Ambient = None
) -> TolerantDecoder | None:
    """The decoder of a sensor that nobody calibrated, with the usual tolerances.

    Args:
        library: measured or computed.
        microphone_noise: as of :class:`localize.BayesDecoder`.
        ambient: as of :class:`localize.BayesDecoder`.

    Returns:
        None of a measured library, whose sensor is known, and where it is not known how a design scatters.

    Raises:
        Refusal: as :class:`localize.BayesDecoder`.
    """
    if not _is_measured(library):
        with suppress(UnknownScatterError):
            return TolerantDecoder(library, None, microphone_noise, ambient)
    return None


def _is_measured(library: Library) -> bool:
    from acoustic_fem.library.result import MEASURED

    return library.fidelity == MEASURED
