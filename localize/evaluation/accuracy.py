"""How well a localizer names the touched point, on touches it has never seen."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
import scipy.stats
from numpy.typing import NDArray

from acoustic_fem import Library
from geometry.ground.argument_checks import check_range
from geometry.ground.figures import new_figure
from geometry.ground.refusal import Kind, Refusal, counted
from geometry.ground.shown import Shown
from localize.signals.array_response import ArrayResponse, response_of
from localize.signals.disturbances import steady_sound
from localize.signals.frames import FRAME
from localize.signals.locator import Locator
from localize.signals.noise_model import NoiseChoice, NoiseSpectrum
from localize.signals.stimulus import COMPONENT_INTERVALS, SAMPLE_LENGTH, StimulusSource, multi_sines
from localize.signals.threads import one_thread
from localize.signals.touch_generator import TouchGenerator

if TYPE_CHECKING:
    from matplotlib.figure import Figure


MOST_TOUCHES = 1_000_000
"""Most touches of a point that are judged."""
RELIABILITY_BINS = 10
"""Number of equal ranges of the stated probability."""


def wilson_interval(share: float, touches: int) -> tuple[float, float]:
    """Interval of 95 % of a share that was counted (Wilson 1927, "Probable inference, the law of succession, and
    statistical inference"): as good near 0 and 1, where the usual one has no width.

    Args:
        share: counted, from 0 to 1.
        touches: of which, at least 1.
    """
    z = scipy.stats.norm.ppf(0.5 + 0.95 / 2)
    middle = share + z**2 / (2 * touches)
    half = z * math.sqrt(share * (1 - share) / touches + (z / (2 * touches)) ** 2)
    low, high = ((middle + sign * half) / (1 + z**2 / touches) for sign in (-1, 1))
    # Rounding must not leave the share itself outside.
    return min(float(low), share), max(float(high), share)


@dataclass(frozen=True)
class ReliabilityBin:
    """Touches whose named point was given a probability within a range."""

    low: float
    """Lower end of the range."""
    high: float
    """Upper end of the range, which belongs to the next one, if there is one."""
    touches: int
    """Number of touches in the range."""
    stated: float | None
    """Mean stated probability; None without any touch."""
    right: float | None
    """Top-1 accuracy: fraction of these touches that are assigned to the correct point; None without any touch."""


@dataclass(frozen=True)
class Reliability:
    """Agreement of stated probabilities with the truth: of touches named with 80 %, four in five should be right."""

    bins: tuple[ReliabilityBin, ...]
    """Equal ranges of the stated probability, from 0 to 1."""

    @classmethod
    def pooled(cls, parts: Sequence[Reliability]) -> Reliability:
        """Reliability over the touches of several, which have equal bins."""

        def mean(bins: Sequence[ReliabilityBin], name: str) -> float | None:
            filled = [each for each in bins if each.touches]
            touches = sum(each.touches for each in filled)
            return sum(each.touches * getattr(each, name) for each in filled) / touches if touches else None

        return cls(
            tuple(
                ReliabilityBin(
                    low=bins[0].low,
                    high=bins[0].high,
                    touches=sum(each.touches for each in bins),
                    stated=mean(bins, "stated"),
                    right=mean(bins, "right"),
                )
                for bins in zip(*(part.bins for part in parts), strict=True)
            )
        )

    @property
    def expected_error(self) -> float:
        """Expected calibration error: mean over all touches of |right - stated| of their bin (Guo et al. 2017, "On
        calibration of modern neural networks", equation 3).
        """
        touches = sum(each.touches for each in self.bins)
        return sum(
            each.touches / touches * abs(each.right - each.stated)
            for each in self.bins
            if each.right is not None and each.stated is not None
        )


@dataclass(frozen=True, eq=False, repr=False)
class Evaluation(Shown):
    """Results of a localizer over a set of touches; fractions run from 0 to 1."""

    top1: float
    """Share of touches whose most probable point is the right one."""
    top2: float
    """Share of touches whose right point is among the two most probable ones."""
    within_one: float
    """Share of touches whose most probable point is the right one or a neighbour on its line."""
    confusion: NDArray[np.int64]
    """Number of touches of the point of the row for which the point of the column was named; (n_point, n_point)
    int64."""
    by_components: dict[str, tuple[float, int]]
    """Top-1 and number of touches per interval of the number of sinusoids."""
    reliability: Reliability
    """Agreement of stated probabilities with the truth."""
    touches: int
    """Number of touches."""
    seed: int
    """Seed of the touches."""
    microphone_noise: float
    """Noise of every microphone, Pa rms: over 0 to 500 Hz where white, over 1 to 500 Hz where that of the design's
    microphone."""
    noise_source: str
    """"white", or what the noise is that of."""
    samples: int
    """Length of each signal, samples at 1 kHz."""

    def shown(self) -> tuple[str, Mapping[str, object]]:
        """Title and facts that a session and a notebook show."""
        low, high = self.interval()
        pair = self.hardest_pair
        return f"Evaluation on {self.touches} touches", {
            "top-1 accuracy": f"{self.top1:.1%} (95 % interval {low:.1%} to {high:.1%})",
            "top-2 accuracy": f"{self.top2:.1%}",
            "correct point or its neighbour": f"{self.within_one:.1%}",
            "expected calibration error": f"{self.reliability.expected_error:.3g}",
            "hardest pair": "" if pair is None else f"points {pair[0]} and {pair[1]}",
            "noise": self.noise_in_words,
            "signals": f"{self.samples} samples at 1 kHz, seed {self.seed}",
        }

    def plot(self) -> Figure:
        """Figure of the confusion: percent of the touches of each point, a row, that each point was given for.

        Raises:
            MissingExtra: matplotlib is not installed.
        """
        figure = new_figure(6.4, 5.4)
        axes = figure.subplots()
        percent = 100 * self.confusion / np.maximum(self.confusion.sum(axis=1, keepdims=True), 1)
        first, last = 0.5, len(percent) + 0.5
        picture = axes.imshow(percent, cmap="Blues", vmin=0, vmax=100, extent=(first, last, last, first))
        figure.colorbar(picture, ax=axes, label="touches of the row's point  (%)")
        axes.set(xlabel="point that was given", ylabel="touched point", title=f"top-1 accuracy {self.top1:.1%}")
        return figure

    def interval(self, name: str = "top1") -> tuple[float, float]:
        """95 % interval of ``top1``, ``top2`` or ``within_one``, by :func:`wilson_interval`."""
        return wilson_interval(getattr(self, name), self.touches)

    @property
    def noise_in_words(self) -> str:
        """Noise of the microphones, as a phrase."""
        if self.noise_source == "white":
            return f"white microphone noise of {self.microphone_noise:.2g} Pa rms over 0 to 500 Hz"
        return f"the noise of the design's microphone, {self.microphone_noise:.2g} Pa rms over 1 to 500 Hz"

    @property
    def hardest_pair(self) -> tuple[int, int, float] | None:
        """Two points that are confused most often, numbered from 1, and the fraction of their touches that is assigned
        to the other point.

        None if no touch was classified wrongly.
        """
        mistaken = self.confusion + self.confusion.T
        np.fill_diagonal(mistaken, 0)
        touches = self.confusion.sum(1)
        share = mistaken / np.maximum(touches[:, None] + touches[None, :], 1)
        a, b = np.unravel_index(int(share.argmax()), share.shape)
        return (int(a) + 1, int(b) + 1, float(share[a, b])) if share[a, b] > 0 else None

    def to_dict(self) -> dict[str, Any]:
        """Results as JSON can hold them."""
        return {
            "top1": self.top1,
            "top2": self.top2,
            "within_one": self.within_one,
            "intervals": {name: list(self.interval(name)) for name in ("top1", "top2", "within_one")},
            "hardest_pair": self.hardest_pair,
            "confusion": self.confusion.tolist(),
            "by_components": {name: list(value) for name, value in self.by_components.items()},
            "reliability": [asdict(each) for each in self.reliability.bins],
            "expected_calibration_error": self.reliability.expected_error,
            "touches": self.touches,
            "seed": self.seed,
            "microphone_noise": self.microphone_noise,
            "noise_source": self.noise_source,
            "samples": self.samples,
        }


@one_thread()
def evaluate(
    localizer: Locator,
    library: Library | ArrayResponse,
    touches_per_point: int = 200,
    microphone_noise: NoiseChoice = "design",
    samples: int = FRAME,
    seed: int = 0,
    *,
    stimuli: StimulusSource = multi_sines,
    ambient: float | None = None,
) -> Evaluation:
    """Results of a localizer for held-out touches.

    The touches come from a stream of their own, so none was used in training, whatever the seeds are.

    Args:
        localizer: network, graph or decoder.
        library: the array that is touched, which need not be the one the localizer was made for, as long as points
            and microphones agree.
        touches_per_point: at least 1.
        microphone_noise: added to every microphone: Pa rms over 0 to 500 Hz, white, or "design" for that of the
            microphone of the library's design, see :mod:`localize.signals.noise_model`.
        samples: length of each signal, 250 (one frame) to 1000.
        seed: any non-negative integer.
        stimuli: what the touches are, see :mod:`localize.signals.finger_stimuli`; by default the paper's sums of
        sinusoids.
        ambient: level of the sound outside, dB SPL, which the library must be of a design for.

    Raises:
        Refusal: points or microphones do not agree, or an argument is outside its range.
    """
    response = response_of(library)
    check_evaluation(localizer, response, touches_per_point, microphone_noise, samples)
    touches = TouchGenerator(
        response, seed, "evaluation", microphone_noise, stimuli=stimuli, ambient=steady_sound(ambient)
    )  # fmt: skip
    probability, point, interval = [], [], []
    for part in touches.stream(0, touches_per_point * response.point_count):
        probability.append(localizer.locate(part.signals[..., -samples:].numpy()))
        point.append(part.point.numpy() - 1)
        interval.append(part.interval.numpy())
    return judged(
        np.concatenate(probability), np.concatenate(point), np.concatenate(interval), touches, samples
    )  # fmt: skip


def check_evaluation(
    localizer: Locator,
    response: ArrayResponse,
    touches_per_point: int,
    microphone_noise: NoiseChoice,
    samples: int = FRAME,
) -> None:
    """Refuse what :func:`evaluate` would, before any work.

    Raises:
        Refusal: points or microphones do not agree, or an argument is outside its range.
    """
    if tuple(localizer.microphones) != response.microphones or localizer.point_count != response.point_count:
        raise Refusal(
            f"the localizer is for {counted(localizer.point_count, 'point')} and microphones "
            f"{', '.join(localizer.microphones)}; the library has {counted(response.point_count, 'point')} and "
            f"microphones {', '.join(response.microphones)}",
            kind=Kind.MISMATCH,
        )
    check_range("touches_per_point", touches_per_point, 1, MOST_TOUCHES, whole=True)
    check_range("samples", samples, FRAME, SAMPLE_LENGTH, whole=True)
    response.noise(microphone_noise)


def judged(
    probability: NDArray[np.float64],
    point: NDArray[np.int64],
    interval: NDArray[np.int64],
    touches: TouchGenerator,
    samples: int,
) -> Evaluation:
    """Results of decisions that are made already.

    Args:
        probability: (n, n_point), that each point was touched.
        point: (n,) touched points, from 0.
        interval: (n,) indices into ``stimulus.COMPONENT_INTERVALS``, -1 for touches that are not multi-sine.
        touches: generator of the touches, which knows their seed, their noise and the array.
        samples: length of each signal.
    """
    response, noise = touches.response, touches.microphone_noise
    order = np.argsort(-probability, axis=1, kind="stable")
    named = order[:, 0]
    right = named == point
    same_line = response.line[named] == response.line[point]
    near = np.abs(response.place[named] - response.place[point]) <= 1
    confusion = np.zeros((response.point_count, response.point_count), np.int64)
    np.add.at(confusion, (point, named), 1)
    return Evaluation(
        top1=float(right.mean()),
        top2=float((order[:, :2] == point[:, None]).any(1).mean()),
        within_one=float((same_line & near).mean()),
        confusion=confusion,
        by_components={
            f"{low} to {high - 1}": (float(right[interval == k].mean()), int((interval == k).sum()))
            for k, (low, high) in enumerate(COMPONENT_INTERVALS)
            if (interval == k).any()
        },
        reliability=_reliability(np.take_along_axis(probability, order[:, :1], 1)[:, 0], right),
        touches=len(point),
        seed=touches.seed,
        microphone_noise=noise.rms if isinstance(noise, NoiseSpectrum) else noise,
        noise_source=noise.source if isinstance(noise, NoiseSpectrum) else "white",
        samples=samples,
    )


def _reliability(stated: NDArray[np.float64], right: NDArray[np.bool_]) -> Reliability:
    edges = np.linspace(0.0, 1.0, RELIABILITY_BINS + 1)
    which = np.clip(np.digitize(stated, edges) - 1, 0, RELIABILITY_BINS - 1)
    bins = []
    for k in range(RELIABILITY_BINS):
        own = which == k
        filled = bool(own.any())
        bins.append(
            ReliabilityBin(
                low=float(edges[k]),
                high=float(edges[k + 1]),
                touches=int(own.sum()),
                stated=float(stated[own].mean()) if filled else None,
                right=float(right[own].mean()) if filled else None,
            )
        )
    return Reliability(tuple(bins))
