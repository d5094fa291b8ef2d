"""A virtual rig with a fault, and a session of taps and presses on it: to practise and to judge a diagnosis."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import scipy.signal
from numpy.typing import NDArray

from acoustic_fem.quantities.checks import FrequencyLike
from acoustic_fem.quantities.fidelity import ONE_DESIGN
from geometry.design.design_file import DesignLike
from geometry.ground.typed import Array, ComplexArray
from localize.diagnosis.faults import SensorFault
from studies.test_rig.virtual_rig import HiddenScatter, Recorder, Rig

#: Stream of the random numbers of a session, beside those of the rig's other recordings.
_PURPOSE = 5
#: Corner of the high-pass by which held presses let go, Hz: a finger gives way.
_LET_GO = 0.5


class FaultyRig(Rig):
    """Virtual rig whose sensor has a fault; arguments as of :class:`Rig`, and the fault, None for a sound sensor."""

    def __init__(
        self,
        design: DesignLike,
        seed: int,
        fault: SensorFault | None,
        scatter: HiddenScatter | None = None,
        fidelity: str = ONE_DESIGN,
    ) -> None:
        super().__init__(design, seed, scatter, fidelity)
        self.fault = fault
        if fault is not None:
            self.hidden = fault.of_parts(self.hidden, self.medium)

    def transfer_function(self, frequency: FrequencyLike) -> ComplexArray:
        """Transfer functions with the fault, (n_point, n_microphone, n_freq) complex128, Pa/Pa; as of :class:`Rig`."""
        found = super().transfer_function(frequency)
        return found if self.fault is None else self.fault.of_microphones(found)


@dataclass(frozen=True, eq=False)
class DiagnosisSession:
    """Recording of taps and presses, one at a time."""

    signals: Array
    """Pressures at the microphones, (n_microphone, n_sample) float64, Pa, at 1 kHz."""
    time: Array
    """Time at which each touch begins, (n_touch,) float64, s."""
    point: NDArray[np.int64]
    """Point of each touch, from 1, (n_touch,) int64."""


def diagnosis_session(rig: Rig, seed: int, count: int = 24, apart: float = 1.6) -> DiagnosisSession:
    """Recording of taps and presses on a rig, every point in turn in a random order, with noise, hum and drift.

    Taps last 8 to 80 ms; presses rise in 30 to 120 ms and are held for 0.2 to 0.7 s. Their peaks are 0.3 to 3 Pa.

    Args:
        rig: the sensor.
        seed: of the touches.
        count: number of touches.
        apart: time between the beginnings of two touches, s, to which up to 0.2 s are added.
    """
    random = np.random.default_rng(np.random.SeedSequence(seed, spawn_key=(_PURPOSE,)))
    recorder, points = Recorder(), rig.design.point_count
    each = np.concatenate([random.permutation(points) for _ in range(-(-count // points))])[:count] + 1
    total = round((count * apart + 2.0) * recorder.rate)
    time = np.arange(total) / recorder.rate
    begin = 1.0 + apart * np.arange(count) + random.uniform(0.0, 0.2, count)
    pressure = np.zeros((points, total))
    for number, (point, at) in enumerate(zip(each, begin, strict=True)):
        height = np.exp(random.uniform(np.log(0.3), np.log(3.0)))
        if number % 2 == 0:
            width = np.exp(random.uniform(np.log(8e-3), np.log(0.08)))
            stroke = np.sin(np.pi * np.clip((time - at) / width, 0, 1)) ** 2
        else:
            rise, hold = np.exp(random.uniform(np.log(0.03), np.log(0.12))), random.uniform(0.2, 0.7)
            stroke = np.sin(np.pi / 2 * np.clip((time - at) / rise, 0, 1)) ** 2
            stroke -= np.sin(np.pi / 2 * np.clip((time - at - hold) / (1.5 * rise), 0, 1)) ** 2
        pressure[point - 1] += height * stroke
    let_go = scipy.signal.butter(1, _LET_GO, "highpass", fs=recorder.rate, output="sos")
    touched = np.unique(each)
    spectra = np.fft.rfft(scipy.signal.sosfilt(let_go, pressure[touched - 1], axis=1))
    drives = {int(point): spectrum for point, spectrum in zip(touched, spectra, strict=True)}
    signals = rig.recorded(drives, total, 0, total, recorder, random)[1:]
    return DiagnosisSession(signals, begin, each)
