"""A model, opened: the decoder that its sensor asks for, its library, and all that listens with it."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from acoustic_fem.library.transfer_functions import MEASURED, Library
from acoustic_fem.quantities.microphone_signals import LOWEST
from acoustic_fem.scatter.tolerances import UNCALIBRATED
from geometry.ground.refusal import Field, Kind, Refusal
from geometry.ground.shown import Shown
from geometry.ground.typed import Array
from localize.decoders.hand_motion import HandMotion
from localize.decoders.judgement import ResidualTest
from localize.decoders.motion_test import MotionTest
from localize.decoders.reconstruct import Reconstructor
from localize.decoders.sound_test import SoundTest
from localize.decoders.tolerant import unknown_tolerances
from localize.evaluation.fit_watch import FitWatch
from localize.evaluation.goodness_of_fit import LoudFrames, SensorFit, sensor_fit
from localize.live.events import Decision, Fault, SeveralTouches
from localize.live.listener import LiveListener
from localize.live.recorder import LiveRecorder
from localize.live.sources import Correction, Source
from localize.live.stream import TouchStream
from localize.live.stream_options import StreamOptions, TouchOptions
from localize.live.touches import TouchTracker, touches_of
from localize.model.decoding import Decoding
from localize.model.located_touches import LocatedTouches, distrusted_event, distrusted_touch, with_several
from localize.recordings.accelerometer import COLUMNS, Acceleration, AccelerationFile, read_acceleration
from localize.recordings.recording import Recording, read_recording
from localize.signals.array_response import ArrayResponse
from localize.signals.locator import Locator
from localize.tracking.path import PathTracker
from localize.tracking.path_gestures import GestureTracker
from localize.two_touches.touch_watch import TwoTouchWatch
from localize.two_touches.two_touch_decoder import TwoTouchDecoder

if TYPE_CHECKING:
    from torch import Tensor

LEAST_NOISE = 1e-6
"""White noise that waveforms are reconstructed with where a localizer knows none, Pa rms."""
LEAST_SOUND_NOISE = 1e-5
"""White noise that the test of sound assumes at least, Pa rms: below it, rounding is all there is."""
CLIPPED = 0.97
"""Fraction of a microphone's overload from which its output is taken for clipped."""
PART = 60_000
"""Number of samples of a recording that are decided at once: a minute."""


@dataclass(frozen=True, eq=False, repr=False)
class Model(Shown):
    """Localizer with everything that it needs; made by :func:`localize.open_model`. Decoding does not change it."""

    def shown(self) -> tuple[str, Mapping[str, object]]:
        """Title and facts that a session and a notebook show."""
        array, decoding, library = self.locator.array, self.decoding, self.library
        noise = decoding.microphone_noise
        return f"Model of {array.design}", {
            "decodes with": self.locator.kind,
            "array": f"{len(array.line)} points, microphones {', '.join(self.locator.microphones)}",
            "library": "none"
            if library is None
            else f"{library.fidelity}, {library.frequency[0]:g} to {library.frequency[-1]:g} Hz",
            "assumes": self.assumptions,
            "noise of the microphones": noise if isinstance(noise, str) else f"{noise:g} Pa rms",
            "sound in the room": "" if decoding.ambient is None else f"up to {decoding.ambient:g} dB SPL",
            "motion of the sensor": "" if decoding.motion is None else f"up to {decoding.motion:g} m/s2",
            "true touches that may be rejected": ""
            if decoding.rejected_fraction is None
            else f"{decoding.rejected_fraction:.2g}",
            "follows drift": "yes" if decoding.follow_drift else "",
            "equalises the microphones": ""
            if decoding.microphone_output == "pressure"
            else f"down to {decoding.lowest or LOWEST:g} Hz",
            "warnings": f"{len(self.warnings)}, the first: {self.warnings[0]}" if self.warnings else "none",
            "files": ", ".join(str(path) for path in self.files),
        }

    locator: Locator
    """Localizer: a network, a graph, or the decoder of a library."""
    library: Library | None
    """Library of the array, in the air of the place; None where none was given."""
    response: ArrayResponse | None
    """Transfer functions of the array, for tests and waveforms; None where nothing has them."""
    decoding: Decoding
    """Choices that it was opened with."""
    assumptions: str
    """Assumptions about the sensor or touches, in words."""
    warnings: tuple[str, ...]
    """Reasons to trust the answers less, in words."""
    files: tuple[Path, ...]
    """Files and folders that it was read from."""

    def locate(self, signals: ArrayLike | Tensor) -> Array:
        """Probability of each point, whatever was located before.

        Args:
            signals: (n_microphone, n_sample) or (n, n_microphone, n_sample), Pa, at 1 kHz, at least 250 samples.

        Returns:
            (n_point,) or (n, n_point) float64.

        Raises:
            Refusal: as of :meth:`localize.Locator.locate`.
        """
        return self.locator.locate(signals)

    def locate_file(
        self,
        path: str | os.PathLike[str],
        full_scale: float | None = None,
        *,
        channels: Mapping[str, int] | None = None,
        correct: bool = False,
        acceleration: AccelerationFile | None = None,
    ) -> LocatedTouches:
        """Touches in a recording, with their points and times.

        Args:
            path: of the recording, see :func:`localize.read_recording`.
            full_scale: pressure at full scale of WAV files, Pa, by default 1 Pa. For other files, the pressure at which
                the recorder clipped; by default clipping is detected by its flat tops.
            channels: microphone -> channel of the file, from 1; as of :func:`localize.read_recording`.
            correct: as of :meth:`locate_recording`.
            acceleration: as of :meth:`read`.

        Raises:
            Refusal: a recording that cannot be read or used.
        """
        return self.locate_recording(self.read(path, full_scale, channels, acceleration), correct=correct)

    def read(
        self,
        path: str | os.PathLike[str],
        full_scale: float | None = None,
        channels: Mapping[str, int] | None = None,
        acceleration: AccelerationFile | None = None,
        *,
        tolerant: bool = True,
    ) -> Recording:
        """Recording of the microphones of the model.

        Args:
            path: as of :meth:`locate_file`.
            full_scale: as of :meth:`locate_file`, Pa.
            channels: as of :meth:`locate_file`.
            acceleration: file of an accelerometer on the housing, whose part is taken out of the signals; it may be the
                recording itself.
            tolerant: whether channels may be clipped, and one of three or more silent, as a stream can do without them.

        Raises:
            Refusal: a recording that cannot be read or used; an acceleration of another rate or length; or a model
                without a library beside an acceleration.
        """
        motion = None if acceleration is None else self._motion(acceleration)
        fallback = tolerant and not self.locator.needs_all_microphones and len(self.locator.microphones) > 2
        recording = read_recording(
            path,
            self.locator.microphones,
            full_scale,
            fallback=fallback,
            clipped=tolerant,
            channels=channels,
            others=() if motion is None else COLUMNS,
        )
        if motion is None:
            return recording
        moved, library = motion
        limit = self._clipped_from(recording.limit)
        signals = moved.taken_out_at_one_kilohertz(
            library, recording.signals, recording.rate, self.decoding.microphone_output, limit
        )
        return replace(recording, signals=signals)

    def motion_correction(self, file: AccelerationFile) -> Correction:
        """Function that takes out of signals what the motion of the sensor adds to them, for a source.

        Raises:
            Refusal: a model without a library; as of :func:`localize.recordings.read_acceleration`.
        """
        moved, library = self._motion(file)

        def correct(signals: Array, rate: float, limit: float | None) -> Array:
            return moved.taken_out(library, signals, rate, self.decoding.microphone_output, self._clipped_from(limit))

        return correct

    def _motion(self, file: AccelerationFile) -> tuple[Acceleration, Library]:
        """Acceleration of the sensor from a file, and the library, which has the responses to it."""
        if self.library is None:
            problem = "needs the library of the array, which says what its motion adds to the signals"
            raise Refusal(problem, kind=Kind.MISSING, field="acceleration", remedy=("give it as ", Field("library")))
        return read_acceleration(file), self.library

    def _clipped_from(self, limit: float | None) -> float | None:
        """Pressure from which samples are taken for clipped, Pa, by the limit of their file; None if none is."""
        if self.decoding.microphone_output == "pressure":
            return limit
        equaliser = self.decoding.equaliser(self.locator.array)
        assert equaliser is not None
        overload = CLIPPED * equaliser.microphone.overload
        return overload if limit is None else min(limit, overload)

    def locate_recording(self, recording: Recording, *, correct: bool = False) -> LocatedTouches:
        """Touches in a recording that was read, with a check that the sensor fits the library.

        A microphone whose level is far off is rescaled first. If the check finds a misfit that stays, the probabilities
        of all decisions and touches are lowered towards those of chance.

        Args:
            recording: of the microphones of the model.
            correct: whether a reversed, exchanged or late microphone is corrected too, if the check finds one.
        """
        stream = self.stream(recording.limit, frames=True)
        watch = self.two_touch_watch()
        decided, fit = _decided(stream, recording.signals, watch)
        fault = None if fit is None or fit.fault is None or not (correct or fit.fault.kind == "level") else fit.fault
        if fault is not None:
            signals = fault.corrected(recording.signals, self.locator.microphones)
            if recording.limit is not None:  # what was clipped stays so
                clipped = (np.abs(recording.signals) >= recording.limit).astype(np.float64)
                if fault.kind != "level":
                    clipped = fault.corrected(clipped, self.locator.microphones)
                signals = np.where(np.abs(clipped) > 0.1, np.copysign(recording.limit, signals), signals)
            watch = self.two_touch_watch()
            decided, _ = _decided(self.stream(recording.limit, frames=True), signals, watch)
        array, touches = self.locator.array, TouchOptions()
        tracker = TouchTracker(array, stream.delay, touches)
        single = [event for event in decided if not isinstance(event, SeveralTouches)]
        events = [each for event in decided for each in (event, *tracker.take(event))]
        events += tracker.finish()
        trust = 1.0 if fit is None else fit.trust_of(fault)
        found = with_several(
            touches_of(single, array, touches), [each for each in decided if isinstance(each, SeveralTouches)]
        )
        return LocatedTouches(
            array=array,
            seconds=recording.seconds,
            assumptions=self.assumptions,
            touches=tuple(distrusted_touch(each, trust, array) for each in found),
            events=tuple(distrusted_event(each, trust, array) for each in events),
            warning=None if fit is None else fit.warning,
            fault=None if fit is None else fit.fault,
            corrected=fault is not None,
            trust=trust,
            options={"decoder": self.locator.options, "stream": stream.options, "touches": touches},
        )

    def stream(self, limit: float | None = None, frames: bool = False) -> TouchStream:
        """New stream that decodes with the model, with the sound test and the other options that it was opened with.

        Args:
            limit: Pa; a sample that reaches it is clipped. By default nothing is; if signals are outputs of the
                microphones, also what reaches their overload.
            frames: whether decisions carry the samples that were classified.

        Raises:
            Refusal: a limit that is not finite and positive.
        """
        given, locator = self.decoding, self.locator
        # A noise that is given is what there is: then nothing is measured.
        options = StreamOptions(follow=given.microphone_noise == "design", frames=frames, fallback=True)
        if given.rejected_fraction is not None:
            options = replace(options, rejected_fraction=given.rejected_fraction)
        equaliser = given.equaliser(locator.array)
        limit = self._clipped_from(limit)
        if self.response is None:
            return TouchStream(locator, limit=limit, options=options, equaliser=equaliser)
        noise, wave, sound, residual, motion = locator.microphone_noise, None, None, None, None
        least = noise if isinstance(noise, str) else max(noise, LEAST_SOUND_NOISE)
        if given.waveform:
            wave = Reconstructor(self.response, max(locator.noise_rms, LEAST_NOISE))
        if given.ambient is not None:
            sound = SoundTest(self.response, noise, given.ambient)
        elif self.response.ambient_response is not None:
            sound = SoundTest(self.response, least)
        if given.motion is not None and self.library is not None:
            moved = HandMotion.of(self.library, given.motion)
            motion = MotionTest(self.response, moved, least, 80.0 if given.ambient is None else given.ambient)
        if given.rejected_fraction is not None:
            residual = ResidualTest(self.response, noise, ambient=given.ambient)
        return TouchStream(locator, None, limit, wave, sound, residual, options, equaliser, motion)

    def tracker(self, contact_radius_mm: float) -> PathTracker:
        """New tracker of the paths of contacts, for the decisions of a stream that carry their frames.

        Args:
            contact_radius_mm: radius of the contact, mm.

        Raises:
            Refusal: a model without a library, or a radius out of range.
        """
        if self.library is None:
            problem = "is not a library; paths need one, because it predicts the signals of a contact at any place"
            raise Refusal(problem, kind=Kind.UNSUITABLE, field="model")
        return PathTracker(self.library, contact_radius_mm, self.decoding.microphone_noise, self.decoding.ambient)

    def two_touch_watch(self, beside: bool = False) -> TwoTouchWatch | None:
        """New watch for touches at once, for the decisions of a stream that carry their frames.

        Args:
            beside: as of :class:`localize.two_touches.TwoTouchWatch`.

        Returns:
            None if the model was opened without ``two_touches``.

        Raises:
            Refusal: a model without a library.
        """
        if not self.decoding.two_touches:
            return None
        if self.library is None:
            problem = "is not a library; two touches at once need one, because it predicts the signals of strokes"
            raise Refusal(problem, kind=Kind.UNSUITABLE, field="model")
        is_known = self.library.fidelity == MEASURED or unknown_tolerances(self.library) is not None
        tolerances = None if is_known or not self.decoding.tolerances else UNCALIBRATED
        decoder = TwoTouchDecoder(self.library, self.decoding.microphone_noise, tolerances)
        return TwoTouchWatch(decoder, beside)

    def listen(
        self, source: Source, recorder: LiveRecorder | None = None, contact_radius_mm: float | None = None
    ) -> LiveListener:
        """Listener that reports touches while they happen; iterate over it for its events.

        It also reports once, as a :class:`localize.live.Notice`, if the sensor does not fit the model.

        Args:
            source: where samples come from, such as :class:`localize.live.ReplaySource`.
            recorder: writes them as they come in.
            contact_radius_mm: of a contact whose place and gestures are reported too, mm; by default neither is.

        Raises:
            Refusal: a radius out of range, or a model that has no library.
        """
        places = () if contact_radius_mm is None else (GestureTracker(self.tracker(contact_radius_mm)),)
        stream = self.stream(source.limit, frames=True)
        watch = self.two_touch_watch(beside=True)
        trackers = (FitWatch(stream), TouchTracker(self.locator.array), *places, *(() if watch is None else (watch,)))
        return LiveListener(source, stream, recorder, trackers=trackers)


def _decided(
    stream: TouchStream, signals: Array, watch: TwoTouchWatch | None
) -> tuple[list[Decision | Fault | SeveralTouches], SensorFit | None]:
    """Decisions of a stream on signals, (n_microphone, n) Pa, and whether they are of the localizer's sensor."""
    loud, decided = LoudFrames(), list[Decision | Fault | SeveralTouches]()
    for first in range(0, signals.shape[1], PART):
        events = stream.push(signals[:, first : first + PART])
        loud.take(events)
        # The samples of all frames take sixteen times the memory of the recording.
        for event in events:
            decided.append(replace(event, frame=None) if isinstance(event, Decision) else event)
            decided += [] if watch is None else watch.take(event)
    decided += [] if watch is None else watch.finish()
    return decided, sensor_fit(stream.locator, loud.frames(), stream.noise)
