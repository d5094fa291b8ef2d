"""Worth of a decision: the best points, how far they are apart, and whether any point explains the signal.

A touch of point i, whatever its waveform between 1 and 100 Hz, moves the microphones' samples almost only along those
eigenvectors of its covariance C_i whose eigenvalue, for the loudest touch to be expected, stands above the noise. The
other directions hold noise of the microphones: if it is white of variance 1, the energy in the m other directions
follows the chi-squared distribution of m degrees of freedom (the noise subspace of Schmidt 1986; the test is Wald's).
If the probability that noise exceeds a residual is below the stated rate of false alarms, the signal is not one of
these touches. It may be two touches at once, sound from outside, or a touch on a sensor that differs from the library.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import scipy.stats
from numpy.typing import ArrayLike, NDArray

from acoustic_fem import Library
from geometry.ground.argument_checks import check_range
from geometry.ground.refusal import Field, Kind, Refusal
from geometry.ground.typed import Array
from localize.decoders.decoder_options import ResidualOptions
from localize.decoders.frame_covariance import (
    ambient_covariance,
    check_level,
    check_noise,
    low_pass,
    touch_covariances,
    whitening,
)
from localize.decoders.library_decoder import LibraryDecoder
from localize.signals.array_response import ArrayResponse, response_of
from localize.signals.frames import checked_signals, cut_frames
from localize.signals.noise_model import NoiseChoice
from localize.signals.stimulus import BAND, NOISE, SAMPLE_RATE
from localize.signals.threads import one_thread

if TYPE_CHECKING:
    from torch import Tensor


@dataclass(frozen=True, eq=False)
class Judgement:
    """Decisions on n signals."""

    points: NDArray[np.int64]
    """Most probable points, from 1, best first; (n, top) int64."""
    probability: Array
    """Probabilities of these points; (n, top) float64."""
    margin: Array
    """Logarithm of the ratio of the two highest probabilities; (n,) float64, nats."""
    p_value: Array
    """Probability that noise leaves as large a residual under the best point; (n,) float64."""
    explained: NDArray[np.bool_]
    """True if the p-value is at least the rate of false alarms; where not, "none of these"; (n,) bool."""


class ResidualTest:
    """Test of whether a touch of a given point can have made a signal.

    Args:
        library: transfer functions of the as-built array. If they are wrong by 1 %, the residual is 40 dB below the
            signal, which may be far above the noise.
        microphone_noise: the noise there is, as of :class:`localize.BayesDecoder`.
        loudest_touch_pa: pressure in the touched cavity up to which a true touch passes, Pa rms, 1e-3 to 1e3.
        ambient: level of room sound in dB SPL, 0 to 140, up to which a touch in that sound passes; None for a quiet
            room. With two microphones, next to nothing is then left to test. Needs a library with a design.
        options: numbers that tune it.

    Raises:
        Refusal: an argument out of range; touches too far above the noise for double precision; or as
            :func:`localize.signals.array_response.response_of`.
    """

    @one_thread()
    def __init__(
        self,
        library: Library | ArrayResponse,
        microphone_noise: NoiseChoice = "design",
        loudest_touch_pa: float = 1.0,
        ambient: float | None = None,
        options: ResidualOptions = ResidualOptions(),
    ) -> None:
        check_range("loudest_touch_pa", loudest_touch_pa, 1e-3, 1e3, "Pa")
        check_noise(microphone_noise)
        response = response_of(library)
        check_level(response, ambient)
        self.microphones, self.options = response.microphones, options
        self._response, self._given = response, (microphone_noise, loudest_touch_pa, ambient, options)
        whiten = whitening(response.noise(microphone_noise))
        self._reduce = (whiten @ low_pass()).T.copy()
        inside, above = loudest_touch_pa**2 / (BAND[1] - BAND[0]), options.tail * NOISE**2 / (SAMPLE_RATE / 2)
        covariance = touch_covariances(response, whiten, lambda f: np.where(f <= BAND[1], inside, above))
        if ambient is not None:
            each = np.kron(np.eye(len(response.microphones)), whiten)
            covariance += each @ ambient_covariance(response, ambient) @ each.T
        values, vectors = np.linalg.eigh(covariance)
        if values.max() * np.finfo(np.float64).eps > options.leak:
            raise too_loud(
                "loudest_touch_pa",
                loudest_touch_pa,
                "Pa",
                ("expect more noise, a quieter touch or less ", Field("ambient")),
            )
        held = values > options.leak
        self.freedom = (~held).sum(1)
        """(n_point,) degrees of freedom of one frame's residual."""
        rank = int(held.sum(1).max())
        self._vectors = np.ascontiguousarray(vectors[:, :, values.shape[1] - rank :])
        self._held = held[:, values.shape[1] - rank :].astype(np.float64)

    def heard_by(self, microphones: tuple[str, ...]) -> ResidualTest:
        """The test for some of the microphones, names of two or more."""
        return ResidualTest(self._response.heard_by(microphones), *self._given)

    @one_thread()
    def p_value(self, signals: ArrayLike | Tensor, point: ArrayLike) -> Array:
        """Probability that noise leaves a residual as large as the signal's.

        Args:
            signals: (n, n_microphone, n_sample), Pa, at 1 kHz, at least 250 samples; cut into frames that do not
                overlap, whose residuals are added.
            point: (n,) int64, from 1.

        Returns:
            (n,) float64.

        Raises:
            Refusal: as :meth:`localize.BayesDecoder.locate`, or points of another number than signals.
        """
        batch, _ = checked_signals(signals, self.microphones)
        points = np.asarray(point, np.int64)
        if points.shape != (len(batch),) or not ((points >= 1) & (points <= len(self.freedom))).all():
            allowed = f"{len(batch)} values from 1 to {len(self.freedom)}, one per signal"
            raise Refusal(kind=Kind.OUT_OF_RANGE, field="point", value=points.tolist(), allowed=allowed)
        frames = cut_frames(batch)
        x = (frames @ self._reduce).reshape(*frames.shape[:2], -1)
        residual = np.empty(len(x))
        for here in np.unique(points):
            of_point = points == here
            energy = (x[of_point] @ self._vectors[here - 1]) ** 2 @ self._held[here - 1]
            residual[of_point] = ((x[of_point] ** 2).sum(2) - energy).sum(1)
        freedom = self.freedom[points - 1] * frames.shape[1]
        # Where no direction is left to the noise, nothing can be refused.
        return np.where(freedom > 0, scipy.stats.chi2.sf(residual, np.maximum(freedom, 1)), 1.0)


def too_loud(field: str, value: float, unit: str, remedy: tuple[str, ...]) -> Refusal:
    """Refusal of touches or sound so loud that rounding in double precision exceeds the noise."""
    problem = "is too far above microphone_noise: rounding in double precision would hide the noise"
    return Refusal(problem, kind=Kind.CONFLICT, field=field, value=value, unit=unit, remedy=remedy)


def judge(
    decoder: LibraryDecoder,
    test: ResidualTest,
    signals: ArrayLike | Tensor,
    top: int = 3,
    false_alarm: float = 1e-3,
) -> Judgement:
    """Best points of signals, and whether any of them explains the signal.

    Args:
        decoder: of the array.
        test: of the same array, with the noise that there is.
        signals: (n, n_microphone, n_sample), Pa, at 1 kHz, at least 250 samples.
        top: number of points to return, from 1 to the number of points.
        false_alarm: fraction of true touches that may be rejected, above 0, below 1.

    Raises:
        Refusal: an argument out of range, or as :meth:`localize.BayesDecoder.locate`.
    """
    check_range("top", top, 1, decoder.point_count, whole=True, why="the number of points")
    check_range("false_alarm", false_alarm, 0, 1, excluded="both")
    batch, _ = checked_signals(signals, decoder.microphones)
    score = decoder.log_probability(batch)
    order = np.argsort(-score, axis=1, kind="stable")
    ranked = np.take_along_axis(score, order, 1)
    points = order + 1
    p_value = test.p_value(batch, points[:, 0])
    return Judgement(
        points=points[:, :top],
        probability=np.exp(ranked[:, :top]),
        margin=ranked[:, 0] - ranked[:, 1],
        p_value=p_value,
        explained=p_value >= false_alarm,
    )
