"""From recordings of a made sensor to a library: transfer functions with their uncertainty, bad recordings by name."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from acoustic_fem.calibration.clock_drift import at_nominal_times, clock_difference
from acoustic_fem.calibration.manifest import REFERENCE, Manifest
from acoustic_fem.calibration.model_updating import Update
from acoustic_fem.calibration.recording_checks import (
    RecordingFault,
    RecordingMisfit,
    check_against_model,
    check_estimate,
    check_output,
    check_signals,
    check_steady,
    largest_changes,
)
from acoustic_fem.library.transfer_functions import Library, described, measured_library
from acoustic_fem.network.microphone_output import output_response
from acoustic_fem.quantities.local_air import design_air
from acoustic_fem.sound.estimate import TransferEstimate, shortest_record, transfer_estimate
from acoustic_fem.sound.sound_file import Sound, SoundFileError, read_sound
from geometry.ground.argument_checks import check_shape
from geometry.ground.file_checks import MOST_NUMBERS
from geometry.ground.refusal import Kind, Refusal, counted
from geometry.ground.typed import Array, ComplexArray

#: Mains frequencies, Hz, whose hum is looked for, and removed where it is found.
MAINS = (50.0, 60.0)
#: dB by which hum must stand out of its neighbourhood.
_HUM = 15.0
#: Half width of what is taken away around the mains and its harmonics, Hz.
_HUM_WIDTH = 0.1
#: Largest change of the delay that is left after clocks were brought together, s. Good recordings of the virtual rig
#: change by less than 0.25 ms.
_STEADY = 4e-4


class CalibrationError(Refusal):
    """Recordings of which none can be used."""


@dataclass(frozen=True)
class RecordingNote:
    """A finding on the recording of a point."""

    point: int
    """Number of the point, from 1."""
    text: str
    """The finding in words."""
    excluded: bool
    """True if the recording was left out for it."""


@dataclass(frozen=True, eq=False)
class Calibration:
    """Transfer functions estimated from the recordings of a sensor, and findings on the recordings."""

    manifest: Manifest
    """Recordings of the sensor."""
    frequency: Array
    """Grid of frequencies, (n_freq,) float64, Hz."""
    estimates: Mapping[int, TransferEstimate]
    """Estimate of every good recording by number of the point, ascending."""
    findings: tuple[RecordingNote, ...]
    """Findings on the recordings."""
    misfits: Mapping[int, TransferEstimate] = field(default_factory=dict)
    """Estimate of every recording that was left out because it contradicts the design, by number of the point."""

    @property
    def missing(self) -> tuple[int, ...]:
        """Numbers of the points without a good recording."""
        return tuple(n for n in range(1, self.manifest.design.point_count + 1) if n not in self.estimates)

    def library(self, model: Library, model_deviation: Array | None = None, fit: Update | None = None) -> Library:
        """A library like any other: what was measured, and what is known in other ways where it was not.

        Without a fit, points without a good recording are those of the model. With one all points are the fitted
        sensor's, those that were measured too: measured values are rougher than fitted ones, and a decoder that has
        some of each prefers points of one kind.
        Impedances were not measured: the point impedance is the model's, and the source response that times the
        transfer function. The source of each point is in ``provenance["calibration"]``.

        Args:
            model: of the same design, on the same frequencies.
            model_deviation: (n_point, n_microphone, n_freq) float64, standard deviation of the real part, and of the
                imaginary part, of the model's transfer functions, Pa/Pa; needed where points are missing and there is
                no fit.
            fit: of :func:`acoustic_fem.calibration.model_updating.update`, on the estimates of this calibration.

        Raises:
            Refusal: a model of another design or other frequencies, a fit with an objection, or points without a
                recording, a fit and a deviation.
        """
        _check_model(model, self.manifest, self.frequency)
        if fit is not None and fit.objection is not None:
            raise Refusal(f"was rejected: {fit.objection}", kind=Kind.UNSUITABLE, field="fit")
        h = model.transfer_function.transpose("point", "microphone", "frequency").values.copy()
        if fit is not None:
            h, deviation = fit.transfer_function.copy(), fit.deviation.copy()
        elif model_deviation is not None:
            deviation = np.array(model_deviation, dtype=np.float64)
            check_shape("model_deviation", deviation, h.shape)
        elif self.missing:
            raise Refusal(
                f"must be given: point {self.missing[0]} has no recording", kind=Kind.MISSING, field="model_deviation"
            )
        else:
            deviation = np.empty(h.shape)
        if fit is None:
            for number, estimate in self.estimates.items():
                h[number - 1], deviation[number - 1] = estimate.transfer_function, estimate.deviation
        return measured_library(
            self.manifest.design,
            model,
            h,
            deviation,
            ("numpy", "scipy", "xarray"),
            {
                "calibration": {
                    **self._provenance(),
                    "other_points": "model" if fit is None else "fitted model, as the measured ones",
                },
                "fit": None if fit is None else fit.summary(),
                "model": described(model),
            },
        )

    def _provenance(self) -> dict[str, Any]:
        return {
            "estimator": self.manifest.estimator,
            "output": self.manifest.output,
            "measured_points": list(self.estimates),
            "segments": {str(number): estimate.segments for number, estimate in self.estimates.items()},
            "findings": [[finding.point, finding.text, finding.excluded] for finding in self.findings],
        }


def calibrate(manifest: Manifest, model: Library, progress: Callable[[str, float], None] | None = None) -> Calibration:
    """Estimate the transfer functions of all recordings of a manifest; bad ones are left out and named.

    Args:
        manifest: what was recorded.
        model: a library of the design on the frequencies that are wanted, against which exchanged channels, reversed
            polarity and delays are noticed.
        progress: function that is called with the name of the step and the fraction done.

    Raises:
        Refusal: a model of another design, or a response of the reference that does not cover the frequencies.
        CalibrationError: no recording can be used; says why the first cannot.
    """
    frequency = model.frequency
    _check_model(model, manifest, frequency)
    if manifest.response is not None:
        manifest.response.at(frequency)  # refused before any work if it does not cover them
    report = progress or (lambda message, fraction: None)
    expected = model.transfer_function.transpose("point", "microphone", "frequency").values
    estimates: dict[int, TransferEstimate] = {}
    findings: list[RecordingNote] = []
    misfits: dict[int, TransferEstimate] = {}
    digests: dict[str, int] = {}
    for done, number in enumerate(sorted(manifest.points)):
        report(f"point {number} ({done + 1} of {len(manifest.points)})", done / len(manifest.points))
        try:
            estimate, notes, digest = _point(manifest, number, expected, frequency)
            findings += [RecordingNote(number, note, excluded=False) for note in notes]
            if digest in digests:  # nobody knows of which of the two points it is
                same = digests[digest]
                estimates.pop(same, None)
                findings += [
                    RecordingNote(one, f"is the same recording as that of point {other}", excluded=True)
                    for one, other in ((same, number), (number, same))
                ]
            else:
                estimates[number], digests[digest] = estimate, number
        except RecordingMisfit as error:
            misfits[number] = error.estimate
            findings.append(RecordingNote(number, str(error), excluded=True))
        except (RecordingFault, SoundFileError) as error:
            findings.append(RecordingNote(number, str(error), excluded=True))
    report("done", 1.0)
    if not estimates:
        first = findings[0]
        raise CalibrationError(
            f"cannot be used, and no other recording can: {first.text}",
            kind=Kind.UNSUITABLE,
            field=f"points.{first.point}",
        )
    return Calibration(manifest, frequency, estimates, tuple(findings), misfits)


def _point(
    manifest: Manifest, number: int, expected: ComplexArray, frequency: Array
) -> tuple[TransferEstimate, tuple[str, ...], str]:
    """Estimate and notes of a point, and a hash of its signals.

    Raises:
        RecordingFault: or SoundFileError, with the reason.
    """
    channels, rate, limits = read_point(manifest, number)
    check_signals(channels, rate, limits, float(frequency[-1]))
    channels = {name: at_nominal_times(values, manifest.clock_ppm.get(name, 0.0)) for name, values in channels.items()}
    channels, rest = _together(channels, rate, manifest.started_late)
    samples = min(len(values) for values in channels.values())
    signals = np.stack([manifest.pascals[name] * values[:samples] for name, values in channels.items()])
    digest = hashlib.sha256(signals.tobytes()).hexdigest()
    signals, notes = _without_hum(signals, rate)
    signals, drifted = _without_drift(signals, rate, frequency, manifest, number)
    notes += drifted
    phasor = np.exp(-2j * np.pi * frequency * (rest[1:] - rest[0])[:, None])
    microphones = tuple(manifest.design.microphones)
    check_steady(signals, rate, frequency, microphones)
    found = transfer_estimate(signals[0], signals[1:], rate, frequency, manifest.estimator)
    deviation = found.deviation
    if manifest.response is not None:
        known = manifest.response.at(frequency)
        phasor, deviation = phasor * known, deviation * np.abs(known)
    of_microphone = output_response(manifest.design.microphone, frequency, design_air(manifest.design))
    divided_by = of_microphone if manifest.output == "voltage" else np.ones_like(of_microphone)
    phasor, deviation = phasor / divided_by, deviation / np.abs(divided_by)
    whole = TransferEstimate(found.transfer_function * phasor, deviation, found.coherence, found.segments)
    check_estimate(whole, microphones, manifest.least_coherence)
    check_output(whole, expected[number - 1], of_microphone, manifest.output)
    pascals = tuple(manifest.pascals.values())
    try:
        notes += check_against_model(whole, expected, number - 1, frequency, microphones, pascals, divided_by)
    except RecordingFault as error:
        misfit = RecordingMisfit.of(error)
        misfit.estimate = whole
        raise misfit from None
    weak = [name for name, row in zip(microphones, whole.coherence, strict=True) if np.median(row) < 0.5]
    if weak:
        notes += (f"coherence of microphone {', '.join(weak)} is below 0.5 at half of the frequencies",)
    return whole, notes, digest


def _without_drift(
    signals: Array, rate: float, frequency: Array, manifest: Manifest, number: int
) -> tuple[Array, tuple[str, ...]]:
    """Signals at the times of the reference's clock, and notes on recorders whose clocks differ from it.

    Channels of one file are of one recorder. Where the manifest states a channel's clock, nothing is estimated for it.
    """
    files, names = manifest.points[number], list(manifest.design.microphones)
    notes: tuple[str, ...] = ()
    corrected = list(signals)
    for file in dict.fromkeys(files[name] for name in names):
        own = [name for name in names if files[name] == file and name not in manifest.clock_ppm]
        rows = [1 + names.index(name) for name in own]
        drift = clock_difference(signals[[0, *rows]], rate, frequency) if own else 0.0
        if not drift:
            continue
        own_rows = [at_nominal_times(signals[row], drift) for row in rows]
        shortest = min(len(signals[0]), *map(len, own_rows))
        together = np.stack([row[:shortest] for row in (signals[0], *own_rows)])
        # Lost samples are a step, which no difference of clocks takes away.
        if largest_changes(together, rate, frequency)[1].max() <= _STEADY:
            for row, values in zip(rows, own_rows, strict=True):
                corrected[row] = values
            notes += (
                f"the clock of {', '.join(own)} is {abs(drift):.1f} ppm {'faster' if drift > 0 else 'slower'} than "
                "that of the reference; this was corrected, or give it as clock_ppm",
            )
    shortest = min(len(row) for row in corrected)
    return np.stack([row[:shortest] for row in corrected]), notes


def _together(
    channels: dict[str, Array], rate: float, started_late: Mapping[str, float]
) -> tuple[dict[str, Array], Array]:
    """Channels from the moment at which the last recorder had started, to the nearest sample.

    Returns:
        The channels, and the residual of their lateness, (n_channel,) float64, s.

    Raises:
        RecordingFault: what all channels share is too short.
    """
    latest = max(started_late[name] for name in channels)
    skipped = {name: round((latest - started_late[name]) * rate) for name in channels}
    for name, values in channels.items():
        left = max(len(values) - skipped[name], 0) / rate
        if left < shortest_record():
            raise RecordingFault(
                f"leaves {left:.3g} s of channel {name}; it must leave at least {shortest_record():g} s",
                kind=Kind.UNSUITABLE,
                field="started_late",
                value=latest,
                unit="s",
            )
    rest = np.array([started_late[name] + skipped[name] / rate - latest for name in channels])
    return {name: values[skipped[name] :] for name, values in channels.items()}, rest


def read_point(manifest: Manifest, number: int) -> tuple[dict[str, Array], float, dict[str, float | None]]:
    """Channels of a point as they are in its files.

    Returns:
        The channels by name, (n_sample,) float64 each; their rate, Hz; and the largest values of their formats by name,
        None where there is none.

    Raises:
        RecordingFault: a channel that is not there, a file of one channel given for two, files of different rates
            or lengths, or above 2^26 samples in all.
        SoundFileError: a file that cannot be read.
    """
    files = manifest.points[number]
    sounds: dict[Path, Sound] = {file: read_sound(file) for file in dict.fromkeys(files.values())}
    alone = len(sounds) > 1
    for file, sound in sounds.items():
        given = [f"points.{number}.{name}" for name, one in files.items() if one == file]
        if alone and len(sound.channels) == 1 and len(given) > 1:
            raise RecordingFault(
                f"and {' and '.join(given[1:])} are {file.name}, which has one channel; each must be its own",
                kind=Kind.CONFLICT,
                field=given[0],
            )
    count = sum(sounds[file].length for file in files.values())
    if count > MOST_NUMBERS:
        raise RecordingFault(
            f"has channels of {count} samples in all; they must have at most {MOST_NUMBERS}", kind=Kind.OUT_OF_RANGE
        )
    channels = {
        name: _channel(file, sounds[file], name, manifest.channels[name], alone) for name, file in files.items()
    }
    rates = {sounds[file].rate for file in files.values()}
    if max(rates) > 1.001 * min(rates):
        stated = ", ".join(f"{name} {sounds[file].rate:g} Hz" for name, file in files.items())
        raise RecordingFault(f"has files of different sample rates: {stated}", kind=Kind.MISMATCH)
    lengths = {name: len(values) for name, values in channels.items()}
    if max(lengths.values()) > 1.05 * min(lengths.values()):
        stated = ", ".join(f"{name} {length}" for name, length in lengths.items())
        raise RecordingFault(f"has files of different numbers of samples: {stated}", kind=Kind.MISMATCH)
    return channels, sounds[files[REFERENCE]].rate, {name: sounds[file].full_scale for name, file in files.items()}


def _channel(file: Path, sound: Sound, name: str, number: int, alone: bool) -> Array:
    """A channel of a file, by its name, or by its number if channels have no names; a file of one channel is that."""
    if alone and len(sound.channels) == 1:
        return next(iter(sound.channels.values()))
    key = str(number) if sound.numbered else name
    if key not in sound.channels:
        raise RecordingFault(
            f"is not in {file.name}, which has {', '.join(sound.channels)}", kind=Kind.MISSING, field=f"channels.{key}"
        )
    return sound.channels[key]


def _without_hum(signals: Array, rate: float) -> tuple[Array, tuple[str, ...]]:
    """Signals without the mains where it is audible: the same narrow bands are taken from all channels, so that their
    ratios elsewhere stay as they were.
    """
    spectrum = np.fft.rfft(signals)
    grid = np.fft.rfftfreq(signals.shape[1], 1 / rate)
    notes: tuple[str, ...] = ()
    for mains in MAINS:
        line = np.abs(grid - mains) <= _HUM_WIDTH
        beside = (np.abs(grid - mains) <= 20 * _HUM_WIDTH) & ~(np.abs(grid - mains) <= 2 * _HUM_WIDTH)
        if not line.any() or not beside.any():
            continue
        power = np.abs(spectrum) ** 2
        excess = 10 * np.log10(power[:, line].max(1) / np.maximum(power[:, beside].mean(1), 1e-300))
        if excess.max() > _HUM:
            harmonics = np.round(grid / mains)
            spectrum[:, (harmonics >= 1) & (np.abs(grid - harmonics * mains) <= _HUM_WIDTH)] = 0
            notes += (f"hum of {mains:g} Hz, {excess.max():.0f} dB above its neighbourhood, was removed",)
    return (np.fft.irfft(spectrum, signals.shape[1]) if notes else signals), notes


def _check_model(model: Library, manifest: Manifest, frequency: Array) -> None:
    design = manifest.design
    if (model.design.point_count, model.design.microphones) != (design.point_count, design.microphones):
        raise Refusal(
            f"of {model.design.name} with {counted(model.design.point_count, 'point')} must be of {design.name} with "
            f"{design.point_count}",
            kind=Kind.MISMATCH,
            field="model",
        )
    if not np.array_equal(model.frequency, frequency):
        raise Refusal("must have the frequencies of the calibration", kind=Kind.MISMATCH, field="model")
