"""Numbers that tune streams and the touches that are found in them, with their units and what they do."""

from __future__ import annotations

from dataclasses import dataclass

from geometry.ground.argument_checks import check_range

HIGH_PASS = 3.0
"""Corner of the high-pass of all microphones where none is given, Hz: the lowest at which the rest of a touch is soon
below its noise."""
BAUD = 115200
"""Speed of a serial line where none is given, bit/s."""
MOVING = 5.0
"""Radius of a contact that moves where none is given, mm: a finger."""


@dataclass(frozen=True)
class StreamOptions:
    """Options of a stream: what is done with samples before anything is decided, and the thresholds of decisions."""

    high_pass: float | None = HIGH_PASS
    """Corner of the high-pass of all microphones, 0.5 to 20 Hz; None for none."""
    follow: bool = True
    """True if the noise of each microphone and the hum of mains are measured; if not, noise is that of the locator."""
    fade: bool = True
    """True if frames that hold only the decay of a touch are distinguished from the touch."""
    frames: bool = False
    """True if decisions carry the samples that were classified."""
    fallback: bool = False
    """True if the other microphones go on where one is dead, clipped or hisses; if not, such frames are unreadable."""
    rejected_fraction: float = 1e-6
    """Fraction of the frames of true touches that the residual test may reject, above 0, below 1: at 62 a second one in
    four hours."""

    clipped_rest: int = 128
    """Number of samples since the last clipped one from which on a frame with clipped samples is classified, if signals
    are outputs: until then a press may still be rising. On rigs of seeds 96000 to 96002 a frame names 94 % of presses
    120 ms after the last clipped sample, and 64 % after 80 ms."""
    clipped_hops: int = 3
    """Number of hops from one classification of such a frame to the next, since each takes about 0.1 s."""
    clipped_sure: float = 0.5
    """Probability of the likeliest point below which such a frame is unreadable."""
    silence: float = 2.0
    """Multiple of its noise above which a microphone hears something."""
    least_silence: float = 1e-6
    """Threshold of silence where no noise is given, Pa rms."""
    dead_fraction: float = 0.02
    """Fraction of a microphone's noise below whose level a channel is dead: its converter may still toggle."""
    rough_fraction: float = 0.01
    """Fraction of a frame's level below which a channel's noise is not called a hiss: a finger that slides for long is
    as rough as that."""
    restart: int = 1000
    """Largest step back in the numbers of samples that repeats some, samples; a larger one is a device that was started
    anew."""
    fault_memory: int = 500
    """Time within which a fault that returns still lasts, samples."""
    faded: float = 0.3
    """Fraction of the loudest frame of a touch below which a frame holds only what is left of it."""
    fade_rate: float = 20.0
    """Rate at which what may be left of a touch falls, dB/s."""
    risen: float = 2.0
    """Factor by which the level must rise while a touch fades for another one."""

    harmonics: int = 5
    """Number of multiples of 50 and of 60 Hz at which hum is looked for."""
    hum_rate: float = 0.04
    """Fraction of what a hop shows of a line that is learned: a time constant of 0.4 s."""
    mains_drift: float = 0.3
    """Largest distance of a mains frequency from its nominal value, Hz."""
    weak: float = 20.0
    """Multiple of the threshold of silence up to which energy on the lines of mains alone is hum, not a touch."""
    noise_band: tuple[float, float] = (200.0, 450.0)
    """Band in which noise is measured, Hz: touches hold next to nothing there."""
    noise_subbands: int = 3
    """Number of parts of that band, within each of which the path from one microphone to another is constant."""
    noise_time: float = 4.0
    """Length of the past over which noise is measured, s."""
    noise_quantile: float = 0.3
    """Quantile of the densities of that time that is the noise."""
    hiss: float = 5.0
    """Multiple of the expected noise, and of that of the quietest microphone, from which on one hisses."""
    hiss_time: float = 0.5
    """Time over which noise must have been measured before a microphone is called hissing or dead, s."""
    missing_noise: float = 0.2
    """Multiple of the expected noise, and of that of the quietest other microphone, below which one is dead."""
    hears: float = 5.0
    """Multiple of its own noise from which on a frame shows that a microphone is not dead but too quiet."""

    def __post_init__(self) -> None:
        if self.high_pass is not None:
            check_range("high_pass", self.high_pass, 0.5, 20.0, "Hz", why="or None for none")
        check_range("rejected_fraction", self.rejected_fraction, 0, 1, excluded="both")

    def silence_of(self, noise_rms: float) -> float:
        """Level below which a microphone of a noise, Pa rms, hears nothing, Pa rms."""
        return max(self.silence * noise_rms, self.least_silence)


AS_IT_COMES = StreamOptions(high_pass=None, follow=False, fade=False)
"""Nothing is done with samples: every frame is classified as it is."""


@dataclass(frozen=True)
class TouchOptions:
    """Options of how decisions join into touches."""

    pause: float = 0.05
    """Longest interruption after which a contact goes on, s."""
    held: int = 6
    """Number of frames, 16 ms apart, that a point must be named for: for fewer within a longer contact it is passed
    over."""
    likely: float = 0.5
    """Probability that the point of a shorter contact must reach: sound that rises and falls within one touch makes
    such pieces."""
    stay: float = 0.97
    """Probability of staying at a point from one frame to the next, 16 ms later."""
    jump: float = 1e-3
    """Probability of landing anywhere from one frame to the next."""
    fallen: float = 0.4
    """Fraction of a contact's loudest frame to which its level must fall before a new touch may begin."""
    risen: float = 2.0
    """Factor by which the level must rise from there for a new touch to begin."""
    agree: int = 3
    """Number of frames in a row that must name the same point before it is reported."""
    moved: float = 20.0
    """Ratio of probabilities, by the frames that name a new point, from which on a touch has moved to it."""
    longest: int = 3750
    """Number of frames, a minute, after which a contact is taken for a new one."""

    longest_hold: float = 10.0
    """Longest time after which the release of a press belongs to it, s."""
    held_fraction: float = 0.3
    """Fraction of the largest pressure of a touch below which it is not held any more."""
    tremor: float = 0.3
    """Fraction of that pressure below which a rise while the touch is held belongs to it."""
    before: int = 15
    """Number of frames before a contact from which on its stroke is looked for."""
    surely: float = 1.0
    """Multiple of the level of a contact by which the pressure must change for the sign of its stroke to be known."""
    tail: float = 0.1
    """Fraction of the level of a touch below which a contact without a stroke, before the microphones were quiet, is
    what is left of the touch."""
    other_point: float = 20.0
    """Ratio of probabilities, by the mean of its frames, from which on a contact is at another point."""
    slow: float = 0.064
    """Twice the time from half of its peak to its peak from which on a touch may be a beat of a pulse, s."""
    roundness: float = 0.65
    """Largest ratio of the time that a beat is above nine tenths of its peak to that time: 0.4 of a round wave."""
    rest: float = 0.5
    """Largest fraction of the time from one beat to the next in which the pressure rests."""
    shortest_beat: float = 0.35
    """Shortest time from one beat to the next, s."""
    longest_beat: float = 1.4
    """Longest time from one beat to the next, s."""
    beat_level: float = 0.4
    """Least ratio of the levels of two beats."""
    longest_wait: int = 20
    """Number of frames that are waited for until a contact soon after a beat is known to be the next one."""
    remembered: float = 2.0
    """Time over which the pressure is remembered, s."""


@dataclass(frozen=True)
class ListenerOptions:
    """Options of live input: when a source is lost, and how it is opened again."""

    poll: float = 0.1
    """Time without a block after which a source is asked whether it is well, s."""
    stall: float = 1.0
    """Time without a sample after which a source is lost, whatever it reports, s."""
    waits: tuple[float, ...] = (0.5, 1.0, 2.0, 5.0)
    """Times before each attempt to open a lost source again, s; the last one repeats."""
    recent: int = 1000
    """Number of samples of 1 kHz that are kept to be looked at."""
