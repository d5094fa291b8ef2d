"""Numbers that tune the likelihoods of decoders, with their units, where they come from and what they do."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from acoustic_fem.scatter.air_and_rubber import SEALED_AIR_AND_RUBBER, UNKNOWN_AIR_AND_RUBBER, AirAndRubber
from geometry.ground.typed import Array
from localize.decoders.frame_covariance import SOURCE_RMS


@dataclass(frozen=True)
class DecoderOptions:
    """Numbers that tune a decoder of points; shown by its ``repr`` and stored with what it decides."""

    noise_fraction: float = 0.25
    """Fraction of the given noise, in amplitude, that likelihoods assume: less noise names points better, and the
    temperature keeps probabilities calibrated. On 216 points 1, 1/2, 0.3, 1/5 and 1/10 were tried, see
    docs/decoder.md."""
    powers: tuple[float, float, float] = (-80.0, 40.0, 4.0)
    """Lowest, highest and step of the powers of a touch that are tried, dB over :data:`SOURCE_RMS`; a parabola through
    the best one and its neighbours gives the maximum."""
    weakest_direction: float = 1e-2
    """Fraction of the assumed noise below which an eigenvector of a touch of 0 dB is left out: 1e-4 names the same
    points, 40 dB louder ones as well."""
    quiet_bonus: float = 30.0
    """Advantage of quiet over sound, nats after the temperature: the likelihood assumes less noise than there is, and
    would take the residual for sound. In quiet, sound was preferred by at most 35 nats on line-2 (1 of 100 by 27 or
    more), at 60 dB SPL by at least 90."""
    sure_lead: float = 20.0
    """Lead of the best point, nats, beyond which the others are scored in single precision alone."""
    far_lead: float = 30.0
    """Lead of the best point, nats, beyond which another needs no score: its probability is below 1e-13."""
    leading_points: int = 3
    """Number of points whose scores are found in any case, however far they are behind the best."""
    bound_directions: int = 16
    """Number of directions that bound the score of a table. On 36 points in line 3 to 4 points of a loud frame need a
    score."""
    loud_directions: int = 64
    """Number of directions in which touches are loudest, among which the directions of a bound are chosen."""
    exact_numbers: float = 4e5
    """Size of all eigenvectors together up to which every point is scored in double precision: up to 36 points in line
    choosing takes longer than it saves."""
    many_tables: float = 1 / 5
    """Fraction of the tables from which on all are scored at once in single precision, sooner than one by one."""
    single_error: float = 1e-3
    """Error of a score in single precision, nats, up to which it stands for one in double precision where many are
    needed: in most frames it is a tenth of this."""
    frames_at_once: int = 64
    """Number of frames that are decoded at once; bounds memory, changes no result."""
    calibrated_misfit: float = 2.0
    """Largest median misfit over loud touches that a calibrated sensor leaves, a ratio to the noise. On two rigs of
    three designs 1.0 to 1.5 (1.9 and more after a change of stiffness of 20 %); by libraries of other arrays 2.7 or
    more."""

    fitted_misfit: float = 60.0
    """The same of a sensor whose library was fitted to some of its points, or brought to another air. Fits to three
    or four points of virtual rigs (seeds 7100, 7101, 7400) leave 7.6 to 16, a wrong connection 500 or more."""

    @cached_property
    def temperature(self) -> float:
        """Divisor of log-likelihoods, which counts misfits by the given noise again."""
        return self.noise_fraction**-2

    @cached_property
    def tried_powers(self) -> Array:
        """Powers of a touch that are tried; (n_power,) float64."""
        lowest, highest, step = self.powers
        return np.asarray(10 ** (np.arange(lowest, highest + 0.1, step) / 10))

    @cached_property
    def screen_error(self) -> float:
        """Error that a score in single precision may have, nats, per unit of a white frame's sum of squares."""
        return 8 * float(np.finfo(np.float32).eps) / (2 * self.temperature)


@dataclass(frozen=True)
class HypothesisOptions:
    """Numbers of the hypotheses that represent the possible as-built sensors of a design."""

    draws: int = 1200
    """Number of sensors that are drawn with the tolerances."""
    air_and_rubber: AirAndRubber | None = UNKNOWN_AIR_AND_RUBBER
    """Ranges of air and of the rubber's slope, from which some of the sensors draw theirs; None: all have those of the
    library."""
    groups: int = 12
    """Number of groups of the draws of a point. On 36 points in line at 2000 m, 600 draws in 8 groups lose 3 to 12 % of
    the touches; 16 groups are no better than 12."""
    most_hypotheses: int = 640
    """Largest number of hypotheses of all points together: larger arrays, whose lines are shorter, have fewer groups,
    at least two."""
    prior_as_designed: float = 0.2
    """Prior probability of the sensor as it was designed."""
    solved_frequencies: int = 40
    """Number of frequencies at which drawn sensors are solved, evenly spread on a logarithmic scale."""
    ratio_frequencies: int = 12
    """Number of frequencies of the ratios that draws are grouped by."""
    quiet_ratio: float = 1e-3 / SOURCE_RMS
    """Level over that in the touched cavity below which a microphone tells little of a point."""
    least_spread: float = 1e-6
    """Spread of the ratios, nepers and radians, below which all draws are one."""
    shapes: int = 6
    """Number of shapes in which the draws of a group deviate from their mean. On 36 points in line 3 shapes lose 1 to
    2 % of the touches, 8 are no better."""
    weight_above_band: float = 0.02
    """Weight, in the search for shapes, of frequencies above those of touches."""
    seed: int = 20161
    """Seed of the draws and of their groups."""


@dataclass(frozen=True)
class TolerantOptions(DecoderOptions):
    """Numbers that tune a decoder that models manufacturing tolerances."""

    frames_together: int = 256
    """Number of frames that are decoded at once: a hypothesis is fitted in one go to all frames that may be its own."""
    relative_temperature: float = 2.0
    """Temperature over that of the decoder of a known sensor; 1 to 5 were tried."""
    explained_misfit: float = 3.0
    """Largest misfit of the best hypothesis, a ratio to the noise, at which log-likelihoods are believed as they are;
    above it they are divided by the square of its excess. Sensors as designed leave 1.2 to 3.2: determinants count, and
    so does what a frame's edges cut off."""
    believed_level: float = 60.0
    """Level above the given noise to which louder frames are attenuated, dB, because no hypothesis fits a sensor to
    better than a thousandth of a touch. Without it, 10 % more presses of a finger were wrong on as-built gloves (seeds
    71000 to 71010), and 3 % more slides on 36 points in line. From 50 to 65 dB results are alike."""
    candidates: int = 10
    """Number of hypotheses whose deviations are fitted to a frame; with 40 the accuracy on 36 points in line is 0.2 %
    higher."""
    extra_candidates: int = 6
    """Number of hypotheses that are scored beyond the candidates: with them the best are mostly found in one go."""
    source_steps: int = 2
    """Number of times that the source of a touch is found again without what deviations explain."""
    unexplained_fraction: float = 0.02
    """Fraction of a frame's power that the source need not explain, against 1 for the noise: in directions in which a
    touch hardly reaches the microphones, deviations are far larger than the touch. From 0.005 to 0.05 results are
    alike."""
    shape_numbers: float = 7e7
    """Size of all shapes of all hypotheses together, which bounds memory: 280 MB. Every prototype has all its shapes;
    with four in place of six, 7 % more of the multi-sine touches on three lines of 36 points are wrong."""
    misfit_of_two: float = 4.0
    """Largest median misfit over loud touches that a sensor of two microphones leaves. On virtual rigs of seeds 9110 to
    9112 1.5 to 2.5, on as-built array-2x6 up to 3.4 (also in other air and with other rubber), by libraries of other
    arrays 4.8 and more."""
    misfit_of_more: float = 100.0
    """The same of three or more microphones: three leave 0.8 to 4.1 (22 at 2000 m), 1600 or more by libraries of other
    arrays; four leave 5 to 32 (52 at 2000 m)."""
    hypotheses: HypothesisOptions = HypothesisOptions()
    """Options of the hypotheses."""

    @classmethod
    def sealed(cls) -> TolerantOptions:
        """Options for a sensor without a vent that is worn or carried up: its membranes may be up to twice as stiff.

        See :data:`acoustic_fem.scatter.SEALED_AIR_AND_RUBBER`. A sensor whose membranes are flat loses up to 3 % of
        its touches by it (docs/evidence/large-presses.md), so it is not the default.
        """
        return cls(hypotheses=HypothesisOptions(air_and_rubber=SEALED_AIR_AND_RUBBER))


@dataclass(frozen=True)
class DriftOptions(DecoderOptions):
    """Numbers that tune a decoder that follows the stiffness of its sensor."""

    softer: int = 5
    """Number of stiffnesses below that of the calibration: at 2000 m it seems 30 % lower."""
    stiffer: int = 10
    """Number of stiffnesses above it: enclosed air that bulges the membranes makes them twice as stiff after a fast
    climb of 1000 m."""
    step: float = 0.075
    """Distance of neighbours, in the logarithm; steps of 0.05 do no better."""
    usual_deviation: float = 0.15
    """Standard deviation of the logarithm of the stiffness before the first touch."""
    move_probability: float = 1e-3
    """Probability with which the state moves to a neighbour from one touch to the next; 1e-4 to 1e-2 do alike."""
    least_log_likelihood: float = -4.0
    """Least log-likelihood that one touch gives a state against the best, nats: no single touch, which may be none,
    excludes a state."""


@dataclass(frozen=True)
class ResidualOptions:
    """Numbers that tune the test of whether a touch of a point can have made a signal."""

    tail: float = 10.0
    """Power of what a touch may hold beyond 100 Hz, over that of the stimuli's noise."""
    leak: float = 1e-2
    """Fraction of the noise's variance that the loudest touch may have in a direction that is left to the noise."""


@dataclass(frozen=True)
class SoundOptions:
    """Numbers that tune the test that distinguishes room sound from touches."""

    false_alarm: float = 1e-6
    """Fraction of frames of sound on the library's own sensor that are not recognised: at 62 a second one in four
    hours."""
    gain: float = 0.15
    """Largest fraction by which a microphone's gain may differ from their mean: gains are fitted to each frame."""
    mismatch: float = 0.06
    """Fraction of a frame, in amplitude, that sound may leave beside its directions on an as-built sensor, gains apart;
    see docs/evidence/decoder.md for how many sensors that holds of."""
    leak: float = 1e-2
    """Fraction of the noise's variance that the loudest sound may have in a direction that is left to the noise."""
