"""Numbers that tune a calibration from unlabelled touches, with their units, where they come from and their effect."""

from __future__ import annotations

from dataclasses import dataclass

from localize.decoders.decoder_options import DecoderOptions


@dataclass(frozen=True)
class RecalibrationOptions:
    """Numbers that tune a calibration from unlabelled touches; stored with its result."""

    seconds: float | None = None
    """Processor time after which the search ends with the best sensor so far, s; None for no limit. Such a sensor is
    rejected, because the search for others was not finished."""
    fewest_frames: int = 100
    """Number of frames with a touch that are needed."""
    noise_stages: tuple[float, ...] = (0.5, 0.25, 0.12, 0.03)
    """Noise that is assumed in each stage, over the level of the touches: half of the frames are louder at their
    loudest microphone. Fingers leave several maxima at 0.25, of which the wrong one was followed on one sensor of
    ten."""
    quiet: float = 4.0
    """Multiple of the microphones' noise that frames with a touch exceed at one microphone."""
    one_signal: float = 1e-2
    """Fraction of a channel's energy that another one, at the best gain, must leave unexplained to be another
    microphone. Copies differ by rounding and by the noise of two inputs; microphones of arrays and of a glove leave
    0.36 or more."""
    searched_frames: int = 300
    """Largest number of frames that a search is made with; the last ascent takes all."""
    held_out_fraction: float = 0.25
    """Fraction of the frames that the search does not see."""
    unexplained_fraction: float = 0.05
    """Noise that the residual test takes for granted, over the level of the touches: recordings of rigs hold that much
    that no point explains though the sensor is known exactly, slow pressure and wander among it."""
    loudest_ratio: float = 8.0
    """Level of the loudest touch that the residual test passes, over the level of the touches."""
    slopes: tuple[float, ...] = (0.0, -1.0, -2.0)
    """Slopes of the amplitude of touches over frequency that are tried, as exponents: a short tap, the residual of a
    step, and a slow press."""
    frequency_step: float = 1.0
    """Step of the integral over frequency, Hz: covariances then repeat after 1 s, four frames."""
    information_steps: int = 2
    """Number of steps of the integral over frequency that the information takes as one."""
    near_points: float = 25.0
    """Lead of the best point of a frame, nats, beyond which other points add nothing to it."""
    held_fraction: float = 1e-2
    """Fraction of the noise that an eigenvector must hold at the loudest touch to count in the information."""
    moved_fraction: float = 1e-4
    """Fraction of the noise that a touch of power 1 must reach in a direction for it to count, where H = 1."""
    power_steps: int = 4
    """Number of Newton steps by which the power of a touch is found."""
    distinct_fraction: float = 0.02
    """Fraction of the frames that two sensors must assign to different points to be two."""
    far_behind: float = 30.0
    """Lead of the best sensor of a stage, nats, beyond which another one is given up."""
    farthest: float = 8.0
    """Distance from the prior, in its standard deviations, beyond which no sensor is looked for."""
    coarse_gain: float = 1e-5
    """Gain of a step, as a fraction of the objective, below which an ascent ends. It may leave a point in ten
    unsettled."""
    fine_gain: float = 1e-6
    """The same for the last ascent."""
    most_steps: int = 30
    """Largest number of steps of an ascent."""
    moduli: tuple[float, ...] = (-1.0, 1.0)
    """Deviations of the modulus of all membranes from which sensors are looked for too, in standard deviations."""
    shift_error: float = 0.1
    """Error to which the logarithms of ratios between microphones are to meet those of the next point, where a search
    begins at a sensor whose points are shifted."""
    gain_errors: float = 2.0
    """Number of standard errors by which held-out frames must be likelier than with the present library."""
    least_gain: float = 0.1
    """Lead, nats per held-out frame, below which the present library is as good: as-built sensors gained 3 or more, and
    one that was right already 0.04 by the edges of its frames."""
    rival_lead: float = 10.0
    """Lead, nats, that is needed over a sensor that names other points."""
    explained_fraction: float = 0.85
    """Fraction of the held-out frames that must pass a residual test that takes a twentieth of their level for noise:
    it detects touches of another kind, not whether the sensor is the right one."""
    agreement_fraction: float = 0.95
    """Fraction of the held-out frames that must keep their points when they join the fit."""
    false_alarm: float = 1e-3
    """Rate of false alarms of the residual test."""
    unlikely: float = 1e-6
    """Probability below which the size of the parameters speaks against them. It is that low because model errors move
    them too: on the 33 parameters of 2 x 6 points right sensors lay at 9 to 60, wrong ones at 105 or more."""
    exchanged_errors: float = 3.0
    """Number of standard errors by which another order of the microphones must be likelier to be called so."""
    exchanged_lead: float = 0.1
    """Lead of another order of the microphones, nats per frame, that rounding does not reach."""
    regained_fraction: float = 0.6
    """Fraction of the gain of the fit that the order alone must reach: else a gain or a part has changed, not the
    order. With channels exchanged it was 0.9 or more, with a gain 6 dB higher at most 0.43."""
    gap_fraction: float = 1 / 12
    """Fraction of the points of a line that may follow each other without a touch inside of it. There one always may,
    and one at each end, where a shift of all points by one place begins."""
    untouched_fraction: float = 1 / 4
    """Fraction of the points of a line that may be without a touch."""

    decoder: DecoderOptions = DecoderOptions()
    """Options of the likelihood of a frame: the powers that are tried, and the temperature."""

    @property
    def levels(self) -> tuple[float, float]:
        """Lowest and highest level at the loudest microphone that half of the touches may be above, Pa rms."""
        return 1e-3 / self.loudest_ratio, 1e3 / self.loudest_ratio


@dataclass(frozen=True)
class AccuracyOptions:
    """Numbers of the accuracy that is expected of a fitted library."""

    draws: int = 20
    """Number of sensors that are drawn."""
    touches_per_point: int = 5
    """Number of touches of each of their points."""
    enough: float = 0.95
    """Top-1 accuracy that the worst of these sensors must reach, else another point should be measured. One in ten
    would be fairer, were the posterior exact."""
    fewest_points: int = 2
    """Number of measured points that a fit needs at least: what fewer of them say of all others rests on the priors,
    and so does what is expected of them."""
