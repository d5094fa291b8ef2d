"""Numbers that tune the recognition of kinds of touch, with their units, where they come from and their effect."""

from __future__ import annotations

from dataclasses import dataclass

from localize.recognition.power_maps import WINDOW


@dataclass(frozen=True)
class CutOptions:
    """Numbers by which touches are cut out of recordings."""

    apart: float = 0.4
    """Silence from which two touches are two, s: the taps of a double tap lie closer."""
    letters_apart: float = 1.5
    """Silence from which two letters are two, s: a pen is lifted for less between the strokes of one, and over the
    shells between the points nothing is detected."""
    before: tuple[float, ...] = (0.05, 0.2, 0.35, 0.5)
    """Times before a short touch at which windows begin to train on, s; one is named by the second."""
    around: int = 150
    """Samples around a stretch that belong to its touch: a stream detects touches behind a high-pass."""
    within: tuple[float, float] = (0.01, 0.99)
    """Fractions of a touch's energy between which its windows lie."""
    hop: int = WINDOW // 4
    """Samples from window to window of a long touch."""


@dataclass(frozen=True)
class TakeOptions:
    """Numbers of the recorder and of the contacts in simulated takes."""

    corner: float = 1.0
    """Corner of the high-pass of all signals that waveforms are made of, Hz."""
    fade_in: tuple[float, float] = (0.2, 0.5)
    """Frequencies between which the response of a sensor fades in, Hz."""
    hum: tuple[float, float] = (3e-5, 5e-3)
    """Lowest and highest amplitude of the mains in simulated takes, Pa."""
    drift: tuple[float, float] = (1e-3, 2e-2)
    """Lowest and highest amplitude of the slow wander of the zero in simulated takes, Pa."""
    off_middle: float = 100.0
    """Largest number of samples by which a window of a contact that passes a point is off the time at which it is
    nearest."""
    ease: int = 2000
    """Samples before and behind a take in which its pressure comes and goes."""
    top_fraction: float = 0.8
    """Fraction of the band of a response above which it fades out."""


@dataclass(frozen=True)
class PenOptions:
    """Numbers of the hidden Markov model of a pen."""

    pad_radius_mm: float = 6.5
    """Radius of the pad that writes, mm: the middle of that of pads that are laid flat."""
    cells: int = 4
    """Number of cells from point to point."""
    most_cells: int = 4000
    """Largest number of cells: those of sparser arrays are larger."""
    directions: int = 16
    """Number of directions in which a pen moves."""
    speeds: tuple[float, ...] = (25.0, 35.0, 50.0, 70.0, 100.0, 140.0, 200.0)
    """Speeds of a line that are tried, mm/s."""
    uneven: tuple[tuple[float, float], ...] = ((0.85, 0.25), (1.0, 0.5), (1.15, 0.25))
    """Steps of a hop over those of the line's speed, and how often they are taken."""
    turn: float = 0.75
    """Rate, for each pitch of its path, at which a pen turns by one direction to either side: a letter has its shape at
    any speed."""
    corner: float = 0.12
    """Rate, for each pitch of its path, at which a pen turns to any direction."""
    lift: float = 0.065
    """Rate, for each pitch of its path, at which a pen is lifted."""
    land: float = 1.9
    """Rate at which a lifted pen is put down again, 1/s."""
    floor: float = -50.0
    """Level to which earlier sound fades at least, dB over the loudest."""
    scatter: float = 8.0
    """Standard deviation of a level, dB."""
    astray: float = 0.05
    """Fraction of levels that say nothing."""
    astray_points: float = 0.03
    """Fraction of named points that say nothing."""
    fading: tuple[float, float] = (12.0, 8.0)
    """Level over the floor up to which a lifted pen may be detected, and standard deviation above it, dB."""
    smear: float = 0.07
    """Standard deviation of the time over which a frame averages, s."""
    longest: int = 600
    """Number of hops that are decoded together, which bounds memory."""


@dataclass(frozen=True)
class WritingOptions:
    """Numbers that tune the reading of letters."""

    corner: float = 15.0
    """Corner of the high-pass, Hz: below it a membrane is detected long after it was left, above it while it is
    rubbed."""
    quiet: float = 4.0
    """Multiple of the microphones' noise below which a frame is silent at all of them."""
    ends: float = -35.0
    """Level over the loudest from which a line is there, dB: it goes from the first hop that is as loud to the last."""
    loudest_quantile: float = 0.9
    """Fraction of the hops that are not louder than the level taken as the loudest."""
    least_probability: float = 5e-3
    """Probability below which a place is left out."""
    hop: int = 32
    """Samples from frame to frame where a pad covers several points."""
    loud: float = 0.05
    """Fraction of the loudest frames' level from which a frame counts whole, where a pad covers several points."""
    least_count: float = 0.1
    """Weight that such a frame needs to be drawn."""
    pen_width: float = 0.08
    """Standard deviation of the pen that draws a picture, in its heights."""
    pen: PenOptions = PenOptions()
    """Options of the pen between the points."""


@dataclass(frozen=True)
class VariantOptions:
    """Numbers by which the variants of a line differ. The defaults keep what may tell two signs of a user apart."""

    slant: float = 0.06
    """Standard deviation of the slant, width per height."""
    turn: float = 3.0
    """Standard deviation of the turn, degrees."""
    width: float = 0.06
    """Standard deviation of the logarithm of the width."""
    bend: float = 0.01
    """Standard deviation of the waves by which the line is bent, in sizes of the letter."""
    backwards: float = 0.0
    """Fraction of the variants whose times run backwards: a network that relies on one direction fails with others."""
    without_time: float = 0.0
    """Fraction of the variants whose second picture, of the times, is empty."""
    with_gap: float = 0.0
    """Fraction of the variants of which one part is not detected."""
    gap: tuple[float, float] = (0.03, 0.12)
    """Shortest and longest such part, fractions of the line."""


OTHER_HANDS = VariantOptions(slant=0.25, turn=5.0, width=0.12, bend=0.03, backwards=0.1, without_time=0.3, with_gap=0.2)
"""Variants of simulated letters: other people's slant, width, directions and strokes between the rows of points."""


@dataclass(frozen=True)
class PulseOptions:
    """Numbers that tune the reading of pulses."""

    rates: tuple[float, float] = (40.0, 160.0)
    """Lowest and highest heart rate that is looked for, beats a minute."""
    shortest: float = 3.0
    """Shortest recording that a pulse is read from, s: two beats at the lowest rate."""
    force: float = 2e-5
    """Force of a pulse that the filter expects, N rms."""
    pressure: float = 0.05
    """Pressure of a pulse in the cavity that the filter expects of an array without a design, Pa rms."""
    window: int = 250
    """Length of the filter, samples."""
    latency: int = 16
    """Latency of the filter, samples."""
    slower: int = 4
    """Times that frames of the decoder of pulses are longer than those of touches."""
    corner: float = 4.0
    """Corner of the spectrum of a pulse, Hz."""
    slope: float = 6.0
    """Slope of the power of a pulse above the corner: the wave is round."""
    noise_ratio: float = 2.0
    """Noise that the decoder is given, over that of the microphones: it assumes a quarter of it, because touches are
    loud, and a pulse is near the noise."""
    smooth: float = 0.02
    """Standard deviation of the Gaussian in which the second derivative is taken, s."""
    end_apart: float = 0.15
    """Difference of the first or last interval from the median one, as a fraction of it, from which the beat at that
    end is left out."""
    least_bend: float = 0.02
    """Bend of a wave, as a fraction of that of the percussion wave, from which it is there."""
    around: tuple[float, float] = (0.15, 0.35)
    """Time before and after the percussion wave over which beats are compared, s."""
    least_alike: float = 0.88
    """Likeness of the beats from which they are a pulse. Noise, whose peaks are put under each other, reaches 0.6."""
    least_alike_of_few: float = 0.94
    """The same of two or three beats, which noise makes alike now and then."""
    most_uneven: float = 0.4
    """Deviation of the intervals, by their mean, up to which beats are those of a heart: an irregular one has 0.3."""
    tidal: tuple[float, float] = (0.07, 0.22)
    """Time after the percussion wave in which the tidal wave is looked for, at 75 beats a minute, s; it goes with the
    root of the beat's length."""
    dicrotic: tuple[float, float] = (0.24, 0.44)
    """The same of the dicrotic wave."""
