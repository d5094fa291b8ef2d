"""Held-out touches that several localizers are evaluated on, and what each decides about them.

The touches are made once and kept, so that every localizer decides about the same ones, and none waits for them again.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
import scipy.signal
from numpy.typing import NDArray

from localize.evaluation.accuracy import Evaluation, judged
from localize.live.front_end import high_pass_sections
from localize.live.stream_options import HIGH_PASS
from localize.signals.array_response import ArrayResponse
from localize.signals.disturbances import steady_sound
from localize.signals.finger_strokes import press_strokes, tap_strokes
from localize.signals.frames import FRAME
from localize.signals.locator import Locator
from localize.signals.noise_model import NoiseChoice
from localize.signals.stimulus import StimulusSource, multi_sines
from localize.signals.threads import one_thread
from localize.signals.touch_generator import TouchGenerator, TouchSignals


@dataclass(frozen=True)
class TouchKinds:
    """Kinds of touches that an accuracy is of, each as often as the others."""

    name: str
    """Name in the plural, for a sentence."""
    sources: tuple[StimulusSource, ...]
    """Sources of the touches, at least one."""
    high_pass: float | None = None
    """Corner of the high-pass that the signals pass before they are located, Hz; None for none."""


TAPS = TouchKinds("taps", (tap_strokes,), HIGH_PASS)
"""Taps: strokes of 10 to 100 ms, behind the high-pass of a stream."""
PRESSES = TouchKinds("presses", (press_strokes,), HIGH_PASS)
"""Presses: strokes that are held, by a hand that trembles, behind the high-pass of a stream."""
TAPS_AND_PRESSES = TouchKinds("taps and presses", TAPS.sources + PRESSES.sources, HIGH_PASS)
"""Touches of a finger, with which accuracies come first, behind the high-pass of a stream."""
MULTI_SINES = TouchKinds("multi-sine touches", (multi_sines,))
"""Touches of the publication, unfiltered as there."""


@dataclass(frozen=True, eq=False)
class HeldOutTouches:
    """Touches that no localizer was trained on."""

    generator: TouchGenerator
    """Generator of the first sensor, which knows the seed, the noise and the array."""
    signals: NDArray[np.float32]
    """(n, n_microphone, n_sample) float32, Pa."""
    point: NDArray[np.int64]
    """Touched point of each, from 0; (n,)."""
    sensor: NDArray[np.int64]
    """Touched sensor of each, from 0; (n,)."""
    interval: NDArray[np.int64]
    """Index of each into ``stimulus.COMPONENT_INTERVALS``, -1 where it is not multi-sine; (n,)."""
    kind: NDArray[np.int64]
    """Kind of each, an index into :attr:`TouchKinds.sources`; (n,)."""


@dataclass(frozen=True, eq=False)
class Decisions:
    """Probabilities that a localizer states about held-out touches."""

    touches: HeldOutTouches
    """The touches."""
    probability: NDArray[np.float64]
    """Probability of each point; (n, n_point)."""

    def evaluation(self, chosen: NDArray[np.bool_] | None = None) -> Evaluation:
        """Results on the touches that are ``chosen`` by a mask, (n,) bool; by default on all."""
        own = self.touches
        mask = np.ones(len(own.point), dtype=bool) if chosen is None else chosen
        return judged(self.probability[mask], own.point[mask], own.interval[mask], own.generator, own.signals.shape[-1])

    def by_sensor(self, kind: int | None = None) -> list[Evaluation]:
        """Results on each sensor in turn, of one kind of touches if it is given."""
        own = self.touches
        wanted = np.ones(len(own.kind), dtype=bool) if kind is None else own.kind == kind
        return [self.evaluation(wanted & (own.sensor == sensor)) for sensor in range(int(own.sensor.max()) + 1)]


class TouchedSensors:
    """Sensors that are touched, one or several; :meth:`touches` makes held-out touches of them.

    Args:
        response: the array that is touched.
        microphone_noise: as of :func:`localize.evaluate`.
        seed: any non-negative integer.
        sensors: (n_sensor, n_point, n_microphone, n_freq) transfer functions of several sensors in place of those of
            the array, on its frequencies, Pa/Pa.
        ambient: level of the sound outside, dB SPL, for which the library must be of a design.
    """

    def __init__(
        self,
        response: ArrayResponse,
        microphone_noise: NoiseChoice,
        seed: int = 0,
        *,
        sensors: NDArray[np.complex128] | None = None,
        ambient: float | None = None,
    ) -> None:
        arrays = [response] if sensors is None else [replace(response, transfer_function=each) for each in sensors]
        sound = steady_sound(ambient)
        self._point_count = response.point_count
        self._generators = [
            TouchGenerator(array, seed, "evaluation", microphone_noise, ambient=sound) for array in arrays
        ]

    def touches(self, kinds: TouchKinds, touches_per_point: int, samples: int = FRAME) -> HeldOutTouches:
        """Held-out touches, from a stream of their own, so that none was used in training, whatever the seeds are.

        Args:
            kinds: kinds of the touches.
            touches_per_point: number of touches of each kind, of each point of each sensor; no two sensors have the
                same.
            samples: length of each signal, 250 (one frame) to 1000.
        """
        count = touches_per_point * self._point_count
        parts: list[TouchSignals] = []
        for source in kinds.sources:
            for number, generator in enumerate(self._generators):
                parts += generator.with_stimuli(source).stream(number * count, count)
        sensor = np.repeat(np.arange(len(self._generators)), count)
        return HeldOutTouches(
            generator=self._generators[0],
            signals=np.concatenate([_passed(part.signals.numpy(), kinds.high_pass)[..., -samples:] for part in parts]),
            point=np.concatenate([part.point.numpy() - 1 for part in parts]),
            sensor=np.tile(sensor, len(kinds.sources)),
            interval=np.concatenate([part.interval.numpy() for part in parts]),
            kind=np.repeat(np.arange(len(kinds.sources)), len(sensor)),
        )


def _passed(signals: NDArray[np.float32], corner: float | None) -> NDArray[np.float32]:
    """Whole signals behind a high-pass."""
    if corner is None:
        return signals
    return np.asarray(scipy.signal.sosfilt(high_pass_sections(corner), signals, axis=-1), dtype=np.float32)


@one_thread()
def decide(localizer: Locator, touches: HeldOutTouches, shard: int = 256) -> Decisions:
    """Decisions of a localizer about held-out touches, of which it is given ``shard`` at a time."""
    starts = range(0, len(touches.signals), shard)
    return Decisions(
        touches, np.concatenate([localizer.locate(touches.signals[first : first + shard]) for first in starts])
    )
