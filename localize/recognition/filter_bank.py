"""A recognizer put to work: touches of a recording, the waveform at the point of each, and its kind."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view

from acoustic_fem import Library
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array
from localize.decoders.reconstruct import Reconstructor
from localize.live.front_end import HighPass
from localize.live.stream_options import HIGH_PASS
from localize.recognition.handwriting import WRITTEN, LineReader
from localize.recognition.power_maps import WINDOW
from localize.recognition.recognition_options import CutOptions
from localize.recognition.recognizer import Recognizer
from localize.recognition.recorded_takes import (
    Stretch,
    cut,
    detected_frames,
    stretched_waveform,
    stretches,
    written_maps,
)
from localize.signals.array_response import ArrayResponse, response_of
from localize.signals.frames import FRAME
from localize.signals.locator import Locator
from localize.signals.noise_model import NoiseChoice, NoiseSpectrum
from localize.signals.stimulus import SAMPLE_RATE
from localize.tracking.sliding import straight_slide


@dataclass(frozen=True, eq=False)
class ClassifiedTouch:
    """Touch and the probabilities of its kind."""

    start: float
    """Time at which the signal rises above the noise, s."""
    end: float
    """Time at which the signal falls below the noise, s."""
    point: int
    """Point that is touched, from 1."""
    probability: Array
    """Probability of each kind; (n_label,) float64."""


class FilterBank:
    """Recognizer with the filters of its array: signals in, kinds of touch out.

    Args:
        library: of the array.
        recognizer: for it.
        microphone_noise: noise above which a signal is detected; by default that of the training. Waveforms are made by
            the filters of the training in any case.
        options: how touches are cut out of a recording.
    """

    def __init__(
        self,
        library: Library | ArrayResponse,
        recognizer: Recognizer,
        microphone_noise: NoiseChoice | None = None,
        options: CutOptions = CutOptions(),
    ) -> None:
        self._cuts = options
        self._response = response = response_of(library)
        self._noise: NoiseChoice = recognizer.plan["microphone_noise"] if microphone_noise is None else microphone_noise
        level = response.noise(self._noise)
        self._rms = level.rms if isinstance(level, NoiseSpectrum) else level
        self._recognizer = recognizer
        self._reconstructor = Reconstructor(response, recognizer.plan["microphone_noise"] or 1e-5)

    def touches(
        self, signals: Array, point: int | None, speed: float | None, locator: Locator
    ) -> tuple[ClassifiedTouch, ...]:
        """Touches of a recording in the order of time; one that is too short at an end of it is left out.

        Args:
            signals: (n_microphone, n_sample) float64, Pa at 1 kHz.
            point: that is touched, from 1; None to have it classified for each touch.
            speed: of the slide, mm/s; None to have it estimated from the points that a straight slide passes.
            locator: classifies points.

        Raises:
            Refusal: a recognizer of slides, no speed, and a detected touch that is not a straight slide.
        """
        if self._recognizer.subject == WRITTEN:
            return self._letters(signals)
        found = []
        slides = self._recognizer.at_usual_speed and speed is None
        frames = detected_frames(signals, self._recognizer.microphones, self._rms)
        for each in stretches(frames, self._cuts.letters_apart if slides else self._cuts.apart):
            if slides:
                touched, windows = self._passing(locator, signals, each)
            else:
                touched = self._named(locator, signals, each) if point is None else point
                waveform, stretched = stretched_waveform(self._reconstructor, signals, touched, speed)
                windows = cut(waveform, each.stretched(stretched), options=self._cuts)
            if not len(windows):
                continue
            # windows of one touch overlap, and are hardly independent: their mean is reported
            probability = self._recognizer.recognize(windows[:, -WINDOW:]).mean(0)
            found.append(ClassifiedTouch(each.begin / SAMPLE_RATE, each.end / SAMPLE_RATE, touched, probability))
        return tuple(found)

    def _letters(self, signals: Array) -> tuple[ClassifiedTouch, ...]:
        """Letters of a recording, each with the point at which it begins."""
        reader = LineReader(self._response, self._noise)
        frames = detected_frames(signals, self._recognizer.microphones, self._rms)
        maps, found = written_maps(reader, signals, frames, options=self._cuts)
        if not found:
            return ()
        told = self._recognizer.of_maps(maps)
        return tuple(
            ClassifiedTouch(
                each.begin / SAMPLE_RATE, each.end / SAMPLE_RATE, reader.begins(signals, each.begin), probability
            )
            for each, probability in zip(found, told, strict=True)
        )

    def _passing(self, locator: Locator, signals: Array, each: Stretch) -> tuple[int, Array]:
        """The point in the middle of a slide, and windows (n, 1024) about the times at which points are passed."""
        begin = max(0, each.begin - FRAME)
        slide = straight_slide(self._response, locator.locate, signals[:, begin : each.end + FRAME])
        if slide is None:
            raise Refusal(
                f"must be given: the touch from {each.begin / SAMPLE_RATE:.2f} to {each.end / SAMPLE_RATE:.2f} s is "
                "not a straight slide over three points, so that its speed cannot be measured",
                kind=Kind.MISSING,
                field="speed",
            )
        found = [np.zeros((0, WINDOW))]
        for touched, time in zip(slide.point, slide.time, strict=True):
            waveform, stretched = stretched_waveform(self._reconstructor, signals, int(touched), slide.speed)
            # A contact that comes down or is lifted is a step.
            first, last = (round(stretched * edge) for edge in (each.begin + FRAME, each.end - FRAME))
            middle = round(stretched * (begin + SAMPLE_RATE * time)) - WINDOW // 2
            starts = np.clip(
                [middle - self._cuts.hop, middle, middle + self._cuts.hop], first, max(first, last - WINDOW)
            )
            windows = sliding_window_view(waveform, WINDOW)[np.unique(starts[starts <= len(waveform) - WINDOW])]
            found.append(windows[np.isfinite(windows).all(1)])
        return int(slide.point[len(slide.point) // 2]), np.concatenate(found)

    @staticmethod
    def _named(locator: Locator, signals: Array, each: Stretch) -> int:
        """Most probable point over the frames of a touch, which are filtered as in a stream."""
        begin = max(0, min(each.begin - FRAME // 5, signals.shape[1] - FRAME))
        heard = HighPass(len(signals), HIGH_PASS).begin(signals)[:, begin : max(each.end + FRAME // 5, begin + FRAME)]
        return int(locator.locate(heard).argmax()) + 1
