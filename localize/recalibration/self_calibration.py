"""A library brought to the sensor as it is now, from touches of which nobody knows the points.

The parameters are those of :mod:`acoustic_fem.calibration.model_updating`, with their priors, about the present
library: the nominal one or the last calibration. The most probable ones given the touches
(:mod:`localize.recalibration.parameter_search`) are accepted only where touches that were held out of the search
speak for them; otherwise the present library stays.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable
from dataclasses import asdict, dataclass, replace
from itertools import combinations
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from acoustic_fem.calibration.fitted_model import Posterior, Priors, UpdatedModel
from acoustic_fem.library.transfer_functions import Library, described, measured_library
from acoustic_fem.quantities.model_limit_warning import ModelLimitWarning
from geometry.ground.argument_checks import check_range
from geometry.ground.refusal import Kind, Refusal, counted
from geometry.ground.typed import Array
from localize.decoders.judgement import ResidualTest
from localize.live.stream_options import StreamOptions
from localize.recalibration.marginal_likelihood import MarginalLikelihood
from localize.recalibration.parameter_search import TimeLimit, ascend, distinct, search
from localize.recalibration.recalibration_options import RecalibrationOptions
from localize.recalibration.rejections import NEEDED, RejectionTests, likeliest_order
from localize.signals.array_response import ArrayResponse, response_of
from localize.signals.frames import FRAME, checked_signals
from localize.signals.noise_model import NoiseChoice, NoiseSpectrum
from localize.signals.stimulus import SAMPLE_RATE
from localize.signals.threads import one_thread

Complex = NDArray[np.complex128]


class SelfCalibrationError(Refusal):
    """Refusal of touches that nothing can be learned from."""


@dataclass(frozen=True, eq=False, kw_only=True)
class SelfCalibration(RejectionTests):
    """Sensor that most probably made unlabelled touches, and the reasons against it."""

    present: Library
    """Library that the search began from, and that stays where the sensor is refused."""
    frames: int
    """Number of frames with a touch."""
    held_out: int
    """Number of these frames that the search did not see."""
    seed: int
    """Seed of the choice of the frames that are held out."""
    microphone_noise: float
    """Noise that was assumed in the end, Pa rms over 0 to 500 Hz."""
    high_pass: float | None
    """Corner of the high-pass that the frames had passed, Hz; None for none."""

    def library(self) -> Library:
        """Calibrated library; the present library if the calibration is rejected."""
        if not self.accepted:
            return self.present
        return measured_library(
            self.present.design,
            self.present,
            self.posterior.transfer_function,
            self.posterior.deviation,
            ("numpy", "scipy", "torch", "xarray"),
            {"self_calibration": self.summary(), "present": described(self.present)},
        )

    def summary(self) -> dict[str, Any]:
        """Figures of the calibration as plain values, for a report."""
        return {
            "frames": self.frames,
            "held_out": self.held_out,
            "seed": self.seed,
            "noise": self.microphone_noise,
            "high_pass": self.high_pass,
            "gain_per_frame": self.gain,
            "gain_error": self.gain_error,
            "rival": None if np.isinf(self.rival) else self.rival,
            "rival_held_out": None if np.isinf(self.rival_held_out) else self.rival_held_out,
            "explained": self.explained,
            "agreement": self.agreement,
            "finished": self.finished,
            "size": self.size,
            "expected_size": self.expected_size,
            "likeliest_order": list(self.order.likeliest),
            "order_gain_per_frame": self.order.gain,
            "order_gain_error": self.order.error,
            "touches_per_point": self.touches.tolist(),
            "objection": self.objection,
            "options": asdict(self.options),
            **self.posterior.summary(),
        }


@one_thread()
def self_calibrate(
    library: Library,
    frames: ArrayLike,
    microphone_noise: NoiseChoice = "design",
    priors: Priors | None = None,
    seed: int = 0,
    progress: Callable[[str, float], None] | None = None,
    high_pass: float | None = None,
    options: RecalibrationOptions = RecalibrationOptions(),
) -> SelfCalibration:
    """Library fitted to the sensor that made unlabelled touches.

    Args:
        library: the nominal one, or the last calibration, of the sensor's design, covering 1 to 100 Hz.
        frames: (n, n_microphone, 250), Pa, at 1 kHz; those without a touch are passed over.
        microphone_noise: of the microphones, Pa rms over 0 to 500 Hz, 1e-9 to 10; or "design" for that of the design's
            microphone.
        priors: prior deviations of the sensor from the library; by default those of a sensor that was never calibrated.
        seed: of the choice of the frames that are held out.
        progress: function that is called with the name of the step and the fraction done.
        high_pass: corner of the high-pass that the frames have passed, that of
            :class:`localize.live.front_end.HighPass`, 0.5 to 20 Hz; None for none.
        options: numbers that tune the search and the tests of its result.

    Raises:
        SelfCalibrationError: fewer than 100 frames with a touch, or touches of a level that cannot be pascals; a frame
            given twice, which could lie on both sides of the hold-out; two channels of one signal.
        Refusal: frames of a wrong shape, a silent channel, values that are not finite; a noise or a corner out of
            range; a library without the band, or of a design that the lumped batch does not take.
    """
    StreamOptions(high_pass)
    response = response_of(library)
    spectrum = response.noise(microphone_noise)
    noise = check_range(
        "microphone_noise", spectrum.rms if isinstance(spectrum, NoiseSpectrum) else spectrum, 1e-9, 10.0, "Pa"
    )
    heard = _usable(np.asarray(frames, np.float64), response, noise, options)
    _check_channels(heard, response.microphones, options.one_signal)
    level = float(np.median(heard.std(2).max(1)))
    if not options.levels[0] <= level <= options.levels[1]:
        raise SelfCalibrationError(
            f"the touches have a median level of {level:.3g} Pa rms at their loudest microphone; it must be between "
            f"{options.levels[0]:g} and {options.levels[1]:g} Pa",
            kind=Kind.UNSUITABLE,
            remedy=f"check that the samples are pascals; a calibration needs {NEEDED}",
        )
    noises = [max(share * level, 2 * noise) for share in options.noise_stages]
    heard = heard[np.random.default_rng(seed).permutation(len(heard))]
    # the errors of the model grow with the touch: louder ones say no more than half of them do
    heard *= np.minimum(1.0, level / heard.std(2).max(1))[:, None, None]
    kept, held_out = np.split(heard, [round((1 - options.held_out_fraction) * len(heard))])
    with warnings.catch_warnings():
        # a search also passes through sensors for which these are right; for the one it ends at they are given
        # when its library is made, outside of here
        warnings.simplefilter("ignore", ModelLimitWarning)
        warnings.filterwarnings("ignore", "membrane: ", UserWarning)
        return _calibrated(
            UpdatedModel(library, priors),
            response,
            kept,
            held_out,
            noises,
            level,
            seed,
            progress or _silent,
            high_pass,
            options,
        )


def touched(frames: Array, microphone_noise: float, quiet: float = RecalibrationOptions.quiet) -> NDArray[np.bool_]:
    """Mask of the frames that hold a touch; one that is not finite counts as one.

    Args:
        frames: (n, n_microphone, 250) float64, Pa, at 1 kHz.
        microphone_noise: of the microphones, Pa rms over 0 to 500 Hz.
        quiet: multiple of the noise that frames with a touch exceed at one microphone.

    Returns:
        (n,) bool.
    """
    return np.asarray(~(frames.std(2).max(1, initial=0) <= quiet * microphone_noise))


def _usable(frames: Array, response: ArrayResponse, microphone_noise: float, options: RecalibrationOptions) -> Array:
    """Frames that hold a touch, each once."""
    if frames.ndim != 3 or frames.shape[2] != FRAME:
        raise Refusal(
            f"has shape {frames.shape}, must be (n, n_microphone, {FRAME})", kind=Kind.WRONG_TYPE, field="frames"
        )
    number = np.flatnonzero(touched(frames, microphone_noise, options.quiet))
    heard = frames[number]
    if len(heard):
        checked_signals(heard, response.microphones)
        _check_copies(heard, number)
    fewest = options.fewest_frames
    if len(heard) < fewest:
        raise SelfCalibrationError(
            f"{len(heard)} of {counted(len(frames), 'frame')} hold a touch; a calibration needs at least {fewest} "
            f"({fewest * FRAME / SAMPLE_RATE:g} s of touches)",
            kind=Kind.UNSUITABLE,
        )
    return heard


def _check_copies(frames: Array, number: NDArray[np.int64]) -> None:
    """Refuse frames, of these numbers, that are there twice."""
    seen: dict[bytes, int] = {}
    earlier = [seen.setdefault(frame.tobytes(), k) for k, frame in zip(number.tolist(), frames, strict=True)]
    copies = np.flatnonzero(earlier != number)
    if len(copies):
        raise SelfCalibrationError(
            f"{len(copies)} of {counted(len(frames), 'frame')} with a touch are copies of others, such as frame "
            f"{number[copies[0]] + 1} of frame {earlier[copies[0]] + 1}, so that held-out frames would not be new to "
            "the search",
            kind=Kind.UNSUITABLE,
            remedy="give each touch once",
        )


def _check_channels(frames: Array, microphones: tuple[str, ...], one_signal: float) -> None:
    """Refuse channels that hold one signal, at whatever gain and sign."""
    channels = (frames - frames.mean(2, keepdims=True)).transpose(1, 0, 2).reshape(len(microphones), -1)
    product = channels @ channels.T
    for one, other in combinations(range(len(microphones)), 2):
        correlation = product[one, other] / np.sqrt(product[one, one] * product[other, other])
        if 1 - correlation**2 < one_signal:
            raise SelfCalibrationError(
                f"channels {microphones[one]} and {microphones[other]} hold one signal: in the frames with a touch "
                f"{microphones[other]} is {product[one, other] / product[one, one]:.3g} times {microphones[one]}, "
                f"with a correlation of {correlation:.4f}",
                kind=Kind.UNSUITABLE,
                remedy="record each microphone on a channel of its own",
            )


def _silent(message: str, fraction: float) -> None:
    """Nobody is told."""


def _calibrated(
    model: UpdatedModel,
    response: ArrayResponse,
    kept: Array,
    held_out: Array,
    noises: list[float],
    level: float,
    seed: int,
    report: Callable[[str, float], None],
    high_pass: float | None,
    options: RecalibrationOptions,
) -> SelfCalibration:
    def likelihood_of(frames: Array, noise: float) -> MarginalLikelihood:
        return MarginalLikelihood(grid, frames, noise, options.slopes, high_pass, options)

    def responses(u: Array) -> Complex:
        return np.asarray(model.transfer_function(u[None])[0])

    grid, noise = response.frequency, noises[-1]
    report("search", 0.0)
    searched = kept[: options.searched_frames]
    limit = TimeLimit(options.seconds)
    found = search(model, tuple(likelihood_of(searched, each) for each in noises), response.line, options, limit)
    report("judgement", 0.7)
    if len(kept) > options.searched_frames:
        likelihood = likelihood_of(kept, noise)
        fine = (options.fine_gain, options, limit)
        found = distinct([ascend(model, likelihood, one.parameters, one.start, *fine) for one in found], options)
    unseen = likelihood_of(held_out, noise)
    best, *rivals = (unseen.evidence(responses(one.parameters)) for one in found)
    named = best.probability.argmax(1)
    present = responses(np.zeros(model.count))
    difference = best.frames - unseen.evidence(present).frames
    order = likeliest_order(unseen, present, response.microphones)
    test = ResidualTest(
        replace(response, transfer_function=responses(found[0].parameters)),
        max(options.unexplained_fraction * level, noise / 2),
        options.loudest_ratio * level,
    )
    report("all frames", 0.8)
    whole = likelihood_of(np.concatenate([kept, held_out]), noise)
    u = ascend(model, whole, found[0].parameters, found[0].start, options.fine_gain, options, limit).parameters
    information = whole.information(responses(u), model.jacobian(u))
    report("done", 1.0)
    return SelfCalibration(
        present=model.library,
        posterior=Posterior.of(model, u, information),
        frames=len(kept) + len(held_out),
        held_out=len(held_out),
        seed=seed,
        microphone_noise=noise,
        high_pass=high_pass,
        gain=float(difference.mean()),
        gain_error=float(difference.std(ddof=1) / np.sqrt(len(held_out))),
        rival=min((found[0].value - one.value for one in found[1:]), default=np.inf),
        rival_held_out=min((float((best.frames - one.frames).sum()) for one in rivals), default=np.inf),
        explained=float((test.p_value(held_out, named + 1) >= options.false_alarm).mean()),
        agreement=float((unseen.evidence(responses(u)).probability.argmax(1) == named).mean()),
        order=order,
        touches=np.bincount(whole.evidence(responses(u)).probability.argmax(1), minlength=response.point_count),
        line=response.line,
        finished=not limit.ended_a_search,
        options=options,
    )
