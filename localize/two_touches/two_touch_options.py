"""Numbers that tune the decoder of several touches at once, with their units and what they do."""

from __future__ import annotations

from dataclasses import dataclass

from acoustic_fem.scatter.air_and_rubber import UNKNOWN_AIR_AND_RUBBER, AirAndRubber
from geometry.ground.argument_checks import check_range


@dataclass(frozen=True)
class TwoTouchOptions:
    """Numbers that tune the decoder of several touches at once."""

    most: int = 2
    """Largest number of touches that are looked for, 1 to 3."""
    most_points: int = 16
    """Largest number of points of an array. On virtual rigs of line-2, which has 36 points, the search finds two taps
    nearly as often as on array-2x6, but two presses less often."""
    threshold: float = 50.0
    """Gain in evidence, nats, from which there is one more touch."""
    relative_error: float = 1e-2
    """Part of a frame that no stroke explains, rms over the rms of the frame. Fingers do not move exactly as strokes
    do, and no library is right to better than this."""
    calibrated_error: float = 0.01
    """Standard deviation by which a measured transfer function may differ from that of the sensor, as a fraction."""
    draws: int = 300
    """Number of drawn sensors from which the components of the deviations are found."""
    seed: int = 20462
    """Seed of the drawn sensors."""
    air_and_rubber: AirAndRubber | None = UNKNOWN_AIR_AND_RUBBER
    """Ranges of air and of the rubber's slope of the drawn sensors; None: all have those of the library."""

    rises: tuple[float, ...] = (0.004, 0.0065, 0.0105, 0.017, 0.028, 0.045)
    """Rises of the taps of the grid, s; each falls as fast."""
    press_rises: tuple[float, ...] = (0.03, 0.06, 0.1, 0.17)
    """Rises of the presses of the grid, s."""
    few_rises: int = 2
    """Step through these rises for an array with more points than :attr:`few_points`: 2 leaves out every second one."""
    few_points: int = 16
    """Number of points up to which the grid holds all rises."""
    last_onset: float = 0.13
    """Latest onset of the grid, s after the beginning of a frame."""
    most_atoms: int = 2400
    """Largest number of atoms. If there are more, only every so many-th point of a line has atoms of its own, and the
    points beside it are tried once it fits."""
    screened_pairs: tuple[int, ...] = (12, 40)
    """Number of pairs of points that are fitted after the grid was screened: at first, and if nothing fits then."""
    fits: float = 0.9
    """Mean square of the residual over the expected one, up to which strokes fit, and no more pairs are tried."""
    starts: int = 3
    """Number of starts of each pair, each with other rises."""
    widened: int = 3
    """Number of hypotheses around whose points the neighbours are tried."""
    another: int = 8
    """Number of further strokes that are tried beside those of a hypothesis."""
    exchanges: int = 2
    """Largest number of times that each stroke of the best hypotheses is sought anew beside the others."""
    moves: int = 4
    """Largest number of times that points are moved by the same number of places."""
    stages: tuple[tuple[int, int, float, int, int], ...] = (
        (12, 2, 0.1, 6, 4),
        (6, 1, 0.03, 8, 12),
        (4, 1, 0.0, 16, 12),
    )
    """Stages of a fit: the number of hypotheses that are kept, how many of them may be about the same points, the error
    as of :attr:`relative_error` at least, the number of steps, and the number of components of the deviations."""
    missed: float = 0.05
    """Probability that the search misses the best fit of two touches, by which probabilities of points are lowered."""
    likely: float = 0.5
    """Probability of a point below which its touch is reported without a point."""

    @property
    def most_components(self) -> int:
        """Largest number of components of the deviations in any stage."""
        return max(stage[-1] for stage in self.stages)

    def __post_init__(self) -> None:
        check_range("most", self.most, 1, 3, whole=True)
        check_range("threshold", self.threshold, 0, unit="nats")
