"""Numbers that tune trackers of contacts over the surface, with their units, where they come from and their effect."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from geometry.ground.typed import Array
from localize.decoders.frame_covariance import DECIMATION, SAMPLES, TAPS
from localize.live.events import HOP
from localize.signals.frames import FRAME
from localize.signals.stimulus import SAMPLE_RATE


@dataclass(frozen=True)
class FootprintOptions:
    """Numbers of the grid of footprints of a contact."""

    grid_step: float = 0.1
    """Least distance of two places of a grid, in pitches: at 0.2 half as many taps of a wide finger are assigned to the
    correct point."""
    alike: float = 1e-3
    """Difference of the ratios of force fractions up to which footprints are one."""
    top_frequency: float = 150.0
    """Frequency up to which footprints are distinguished, Hz: above it the decoders' low-pass leaves nothing."""


@dataclass(frozen=True)
class TrackingOptions:
    """Numbers that tune a tracker of paths."""

    most_footprints: int = 100
    """Number of footprints at most, unless points are more: their number makes the time of a frame."""
    pause: float = 1.0
    """Silence after which a path has ended, s."""
    detection_lead: float = 10.0
    """Log-likelihood over that of no new source from which on a contact is detected in a hop, nats."""
    faint: float = 0.05
    """Amplitude over the largest within a quarter of a second below which a contact is not detected."""
    faintest: float = 0.08
    """The same within a whole second."""
    place_deviation: float = 0.1
    """Standard deviation of the place in the loudest hop on a membrane, in pitches."""
    force_band: tuple[float, float] = (5.0, 50.0)
    """Frequencies over which the pressure of a force is averaged, Hz."""
    fewest_hops: int = 3
    """Least number of hops of a path in which the contact is detected."""
    fastest: float = 200.0
    """Speed to which steps from hop to hop are likely, mm/s: three times that is still followed."""
    near: float = 0.17
    """Distance of a step that is likely at any speed, in pitches."""
    jump_weight: float = 1e-5
    """Weight of a step to anywhere, over that of none."""
    agility: float = 3.0
    """Acceleration of a contact over its speed, 1/s."""
    speeds: tuple[float, float] = (30.0, 300.0)
    """Lowest and highest speed that accelerations are taken from, mm/s."""
    ahead: int = 24
    """Number of decimated samples, 96 ms, over which a footprint is taken to be pressed: of half as many it is detected
    too rarely, of twice as many a fast finger has left."""
    heard_samples: int = 100
    """Number of decimated samples, 0.4 s, for which a hop still counts."""
    misfit: float = 1e-2
    """Fraction of a frame's level that is noise at least: libraries are not exact."""
    forgotten: float = 1e-3
    """Power below which a past hop is not counted, in terms of the noise and sound in a sample, hum apart."""
    powers: tuple[float, float, float] = (-60.0, 40.0, 5.0)
    """Lowest, highest and step of the powers of a source that are tried, dB over 1 Pa^2 in a cavity."""
    footprints: FootprintOptions = FootprintOptions()
    """Options of the footprints."""

    @cached_property
    def tried_powers(self) -> Array:
        """Powers of a source that are tried; (n_power,) float64, Pa^2 in a cavity."""
        lowest, highest, step = self.powers
        return np.asarray(10 ** np.arange(lowest / 10, highest / 10 + 0.01, step / 10))

    @property
    def before(self) -> int:
        """Number of a frame's decimated samples before those over which a footprint is pressed."""
        return SAMPLES - self.ahead

    @property
    def latency(self) -> float:
        """Time from the middle of the hop that is scored to the end of its frame, s."""
        return (TAPS // 2 + DECIMATION * (self.ahead - 1) - (HOP - DECIMATION) / 2) / SAMPLE_RATE


@dataclass(frozen=True)
class PositionOptions:
    """Numbers that tune the search for the place of a contact that stands still."""

    most_numbers: float = 3e7
    """Largest size of the covariances of all footprints together, which bounds memory."""
    unfit: float = 0.03
    """Fraction of a frame's level that places a pitch apart leave unexplained."""
    starts: int = 60
    """Number of places of the grid from which the most likely one is looked for."""
    starts_apart: float = 0.25
    """Least distance of two of them, in pitches."""
    lowest_frequency: float = 0.25
    """Lowest frequency of a contact, Hz: fingers come down and stay."""
    top_frequency: float = 250.0
    """Highest frequency that is looked at, Hz."""
    fall: float = 6.0
    """Exponent of the frequency with which the power density of a contact falls above 100 Hz, as that of a tap's
    sin^2."""
    faintest: float = 1e-6
    """Energy over that of the noise below which a source of power 1 is left out."""
    slope_step: float = 1e-3
    """Distance of places from which slopes are taken, in pitches."""
    powers: tuple[float, float, float] = (-40.0, 60.0, 1.0)
    """Lowest, highest and step of the powers of a contact that are tried, dB."""
    scales: tuple[float, float, float] = (0.0, 80.0, 1.0)
    """Lowest, highest and step of the factors by which noise may exceed the given one, dB."""
    first_noise: float = 1e-3
    """Fraction of a frame's level that is noise in the first stage of the search."""
    noise_ratio: float = 3.0
    """Factor by which noise is less from stage to stage."""
    kept_places: tuple[int, ...] = (24, 12, 6, 4, 3)
    """Number of places that go on after each stage."""
    steps: int = 6
    """Steps along the slope in a stage."""
    last_steps: int = 12
    """Steps along the slope in the last stage."""
    longest_step: float = 0.3
    """Longest step, in pitches."""
    same_place: float = 5e-3
    """Distance up to which places are one, in pitches."""
    along_ridge: tuple[float, ...] = (0.1, -0.1, 0.25, -0.25)
    """Distances along the ridge at which better places are looked for, in pitches."""
    wider_noise: float = 4.0
    """Factor of the noise with which they go back to the ridge."""
    ridge_rounds: int = 3
    """Largest number of rounds of looking along the ridge."""

    @cached_property
    def tried_powers(self) -> Array:
        """Powers of a contact that are tried; (n_power,) float64."""
        lowest, highest, step = self.powers
        return np.asarray(10 ** np.arange(lowest / 10, highest / 10 + 0.01, step / 10))

    @cached_property
    def noise_scales(self) -> Array:
        """Factors by which noise may exceed the given one; (n_scale,) float64."""
        lowest, highest, step = self.scales
        return np.asarray(10 ** np.arange(lowest / 20, highest / 20 + 0.01, step / 20))


@dataclass(frozen=True)
class SlideOptions:
    """Numbers that tune the search for a straight slide."""

    hop: int = 32
    """Samples from frame to frame."""
    radii: tuple[float, ...] = (3.0, 4.5, 6.5, 9.0)
    """Radii of a contact that are tried, mm."""
    loudest_quantile: float = 0.9
    """Fraction of the frames that are not louder than the level taken as the loudest: a contact that comes down is a
    step."""
    faster: tuple[float, ...] = (0.8, 1.1, 1.5, 2.0)
    """Speeds that are tried first, over that of a line through the points that are named: they wait for the contact."""
    explained_fraction: float = 0.6
    """Fraction of the levels that a slide must explain."""
    fewest_points: int = 3
    """Least number of points that a slide passes: the times of two do not say whether it was even."""
    edge: float = 0.25
    """Time before the first and after the last sample at which a point may still be passed, s."""
    speeds: tuple[float, float] = (1.0, 100.0)
    """Lowest and highest speed of a slide, mm/s."""
    within: tuple[float, ...] = tuple(np.linspace(-0.5, 0.5, 5) * 0.8 * FRAME / SAMPLE_RATE)
    """Times about the middle of a frame at which its level is averaged, s."""


@dataclass(frozen=True)
class GestureOptions:
    """Numbers that tell gestures from the path of a contact."""

    still: float = 0.75
    """Distance from its first place, in pitches, up to which a contact stays where it is."""
    apart: tuple[float, float] = (0.08, 0.5)
    """Shortest and longest time from one tap of two to the other, s: a contact that stays for longer is a hold."""
    quiet: float = 0.2
    """Fraction of its largest amplitude below which a contact that stays has come to rest."""
    aside: float = 0.2
    """Distance from the line between its ends up to which a path is a swipe, over the distance of the ends."""
    turned: float = 270.0
    """Least angle that a circle turns by, degrees."""
    closed: float = 0.5
    """Largest distance of the ends of a circle, over its width."""
