"""A virtual rig: a sensor with hidden deviations that writes recordings as a real one would.

The hidden sensor is computed by the lumped batch, and at any other fidelity multiplied by what that changes in
the nominal design. Beside what a fit of the usual parameters knows (bores, compliances, modulus, loss, gains, corners,
chambers) it has deviations that such a fit lacks: lengths of tubes, cavities apart from their membranes, a loss factor
of each membrane with the slope that it asks for, a rubber that relaxes more than that, temperature and pressure of the
place, and the change of fidelity.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields, replace
from functools import cached_property
from pathlib import Path
from typing import Literal

import numpy as np
import scipy.interpolate
import scipy.signal
import tomlkit
from numpy.typing import NDArray

from acoustic_fem.batch.network import batch_transfer_function
from acoustic_fem.batch.parameters import ArrayParameters
from acoustic_fem.batch.topology import Topology
from acoustic_fem.calibration.fitted_model import PartScatter
from acoustic_fem.calibration.manifest import REFERENCE
from acoustic_fem.library.solving import solve
from acoustic_fem.network.microphone import noise_density_behind_vent, response
from acoustic_fem.network.microphone_output import output_response
from acoustic_fem.quantities.checks import FrequencyLike, frequencies
from acoustic_fem.quantities.fidelity import FIDELITIES, ONE_DESIGN
from acoustic_fem.quantities.local_air import LocalAir, design_air, medium_of, standard_pressure
from acoustic_fem.quantities.microphone_signals import OUTPUTS, Output
from acoustic_fem.quantities.units import metres
from acoustic_fem.sound.sound_file import write_wav
from geometry.design.design_file import DesignLike, resolve_design, write_design
from geometry.ground.argument_checks import check_choice, check_range
from geometry.ground.typed import Array
from geometry.ground.whole_files import write_text
from studies.output.folders import check_folder, make_folder
from studies.test_rig.hidden_membranes import bulged_sensor, mounted_sensor, relaxing_sensor

Complex = NDArray[np.complex128]

#: Marks a folder as one of recordings of a rig.
RIG_MARK = ".acoustic-fem-rig"
#: Band of the excitation, Hz.
EXCITATION_BAND = (0.8, 125.0)
#: Length of a recording, s.
LENGTHS = (4.0, 86400.0)
#: Band in which the hidden sensor is solved, Hz, and where in it; between these frequencies it is interpolated.
HEARD = (1e-3, 160.0)
_SLOW = 0.4
_NODES = np.concatenate([np.geomspace(HEARD[0], _SLOW, 32)[:-1], np.geomspace(_SLOW, HEARD[1], 72)])
#: Seconds of a recording that are played before it begins, so that the sensor has settled.
_BEFORE = 3.0
#: Frequency that stands for 0 Hz in responses that fall to zero there, Hz.
_LEAST = 1e-3
#: File of the response of the calibration microphone, and its frequencies, Hz.
_REFERENCE_FILE, _REFERENCE_TABLE = "reference.csv", np.geomspace(0.1, 1000.0, 201)
#: Of the random numbers of the place and the batch, beside those of the parts.
_PLACE = 3
#: Ranges of what is no fraction of at most 0.3.
_RANGES = {
    "modulus": (0.1, 10.0),
    "rubber": (0.0, 10.0),
    "temperature": (0.0, 10.0),
    "pressure": (0.0, 5e3),
    "altitude": (-1e3, 4e3),
    "slope": (0.0, 0.1),
    "warming": (-40.0, 30.0),
    "climb": (-1e3, 3e3),
    "humidity": (0.0, 1.0),
    "hours": (0.0, 1e4),
    "prestrain": (-0.02, 0.05),
    "glue": (0.0, 1.0),
}


@dataclass(frozen=True)
class HiddenScatter(PartScatter):
    """Standard deviations of the hidden parameters, as fractions unless stated otherwise. They have a normal
    distribution that is cut off at three standard deviations.
    """

    volume: float = 0.05
    """Deviation, of one, of the volume of each cavity, by its height."""
    membrane: float = 0.10
    """Deviation, of one, of the compliance of each membrane."""
    batch: float = 0.15
    """Deviation, of one, of the modulus of the batch of rubber, that of all membranes: what a hardness leaves
    open.
    """
    modulus: float = 1.0
    """Modulus of all membranes against that of its batch: a factor, not a deviation."""
    rubber: float = 1.0
    """Loss factor of all membranes against the nominal one, and with it the slope of their modulus: a factor."""
    length: float = 0.01
    """Deviation, of one, of the length of each tube; not known to a fit."""
    loss: float = 0.2
    """Deviation, of one, of the loss factor of each membrane; a fit knows the mean only."""
    temperature: float = 3.0
    """Deviation of the temperature of the room, K; not known to a fit."""
    pressure: float = 1e3
    """Deviation of the pressure of the place, by its weather, Pa; not known to a fit."""
    altitude: float = 0.0
    """Height of the place above that whose pressure the design states, m: a shift, not a deviation. Standard
    atmosphere."""
    slope: float = 0.01
    """Deviation of the exponent by which the modulus of a batch rises with frequency around 10 Hz, beyond what its loss
    factor asks for; half-normal, by relaxations over four decades, with the loss that belongs to them; not known to a
    fit. The modulus at 10 Hz stays."""
    warming: float = 0.0
    """Temperature above that of the room, in which the enclosed air was at rest, K: a shift. A worn sensor has 12 K."""
    climb: float = 0.0
    """Height above the place where the enclosed air was at rest, m: a shift. Standard atmosphere."""
    humidity: float | None = None
    """Relative humidity of the air at the membranes, 0 to 1; sweat has 0.85. None: that of the design."""
    prestrain: float = 0.0
    """Strain with which all membranes are mounted beyond that of the design, a ratio: a shift. Silicone that was glued
    at 60 degC has 0.009."""
    glue: float = 0.0
    """Thickness of the glue under the rims beyond that of the design, mm: a shift."""
    hours: float = 0.25
    """Time since the warming and the climb, h: vapour is through the membranes in minutes, air in hours."""

    def __post_init__(self) -> None:
        for field in fields(self):
            value = getattr(self, field.name)
            if value is not None:
                check_range(field.name, value, *_RANGES.get(field.name, (0.0, 0.3)))

    @property
    def is_moved(self) -> bool:
        """True if the enclosed air is not at rest: the sensor is warmed, carried up or in other humidity."""
        return bool(self.warming or self.climb) or self.humidity is not None


@dataclass(frozen=True)
class Recorder:
    """Settings of the recordings."""

    seconds: float = 60.0
    """Length of each recording, s."""
    rate: int = 1000
    """Sample rate, Hz."""
    bits: int = 16
    """Bits of a sample of the WAV files."""
    full_scale: float = 2.0
    """Pressure at full scale of the array's microphones at 1 kHz, Pa; the calibration microphone has five times that.
    Louder signals are clipped."""
    output: Output = "voltage"
    """Content of the channels of the array's microphones. ``voltage``: their outputs, with the high-pass of their
    vents, clipped at their overload. ``pressure``: the pressures in front of them, as an equaliser gives them."""
    reference_corner: float = 1.0
    """High-pass corner of the calibration microphone, first order, Hz; its response is written as a table. 0 for a flat
    one without a table."""
    level: float = 0.35
    """Level in the touched cavity, Pa rms."""
    excitation: Literal["noise", "sweep"] = "noise"
    """Kind of the excitation: noise of flat spectrum, or exponential sweeps of 20 s, over :data:`EXCITATION_BAND`."""
    reference_noise: float = 5e-4
    """Noise of the calibration microphone over half the sample rate, white, Pa rms."""
    late: float = 0.0123
    """Time by which the calibration microphone's recorder starts after the array's, s; the manifest states it."""
    hum: float = 2e-3
    """Amplitude of the mains in every channel, with its third harmonic at a third of it, Pa."""
    drift: float = 5e-3
    """Level of a wander of the zero over the recording, Pa rms."""
    separate: bool = False
    """True if there is a file for each channel instead of one for all."""

    def __post_init__(self) -> None:
        check_range("seconds", self.seconds, *LENGTHS, "s")
        check_range("reference_corner", self.reference_corner, 0.0, 10.0, "Hz")
        check_choice("output", self.output, OUTPUTS)

    def reference_response(self, frequency: Array) -> Complex:
        """Signal of the calibration microphone over the pressure at it.

        Args:
            frequency: (n_freq,) float64, Hz.

        Returns:
            (n_freq,) complex128, a ratio.
        """
        return np.asarray(1 / (1 - 1j * self.reference_corner / np.maximum(frequency, _LEAST)))


class Rig:
    """Virtual rig: a simulated as-built sensor whose parameters are hidden.

    Args:
        design: the nominal array: a design, the path of its file, or the name of a prototype.
        seed: seed of the hidden parameters, from which the seeds of recordings are derived.
        scatter: standard deviations of the hidden parameters.
        fidelity: fidelity of the transfer functions of the nominal design, see :func:`acoustic_fem.solve`.

    Raises:
        Refusal: a negative seed, or a design that the lumped batch does not take.
    """

    def __init__(
        self,
        design: DesignLike,
        seed: int,
        scatter: HiddenScatter | None = None,
        fidelity: str = ONE_DESIGN,
    ) -> None:
        check_range("seed", seed, 0, whole=True)
        design = resolve_design(design)
        check_choice("fidelity", fidelity, FIDELITIES)
        self.design, self.seed, self.fidelity = design, seed, fidelity
        self.scatter = scatter or HiddenScatter()
        shared = Topology.of(design)
        self.topology = shared.individual()
        self._draw(ArrayParameters.from_design(design).individual(shared))

    def _draw(self, nominal: ArrayParameters) -> None:
        random = np.random.default_rng(np.random.SeedSequence(self.seed, spawn_key=(0,)))
        scatter = self.scatter

        def factor(like: Array, deviation: float) -> Array:
            draw = random.standard_normal(like.shape)
            return np.asarray(1 + deviation * np.clip(draw, -3, 3))

        self.hidden = replace(
            nominal,
            tube_radius=nominal.tube_radius * factor(nominal.tube_radius, scatter.bore),
            cavity_height=nominal.cavity_height * factor(nominal.cavity_height, scatter.volume),
            membrane_compliance=nominal.membrane_compliance * factor(nominal.membrane_compliance, scatter.membrane),
            tube_length=nominal.tube_length * factor(nominal.tube_length, scatter.length),
            membrane_loss=nominal.membrane_loss
            * (loss := scatter.rubber * factor(nominal.membrane_loss, scatter.loss)),
            membrane_relaxation=nominal.membrane_relaxation * loss[:, :, None],
            chamber_height=nominal.chamber_height * factor(nominal.chamber_height, scatter.chamber),
        )
        self.gain = factor(np.ones(len(self.design.microphones)), scatter.gain)
        self.corner = factor(np.ones(len(self.design.microphones)), scatter.corner)
        self.hidden = replace(self.hidden, vent_admittance=self.hidden.vent_admittance * self.corner)
        air = self.design.air
        warmer = float(np.clip(random.standard_normal(), -3, 3)) * scatter.temperature
        around = np.random.default_rng(np.random.SeedSequence(self.seed, spawn_key=(_PLACE,)))
        weather, steeper, batch = np.clip(around.standard_normal(3), -3, 3)
        pressure = air.pressure * standard_pressure(scatter.altitude) / standard_pressure(0.0)
        pressure += float(weather) * scatter.pressure
        stiffer = scatter.modulus * (1 + scatter.batch * float(batch))
        self.hidden = replace(
            self.hidden,
            membrane_compliance=self.hidden.membrane_compliance / stiffer,
            membrane_frequency=self.hidden.membrane_frequency * np.sqrt(stiffer),
        )
        self.hidden = relaxing_sensor(self.hidden, abs(float(steeper)) * scatter.slope)
        self.hidden = mounted_sensor(self.hidden, self.design, scatter.prestrain, metres(scatter.glue))
        rested = LocalAir(pressure, None, air.temperature + warmer)
        self.overpressure = 0.0
        """Static pressure of the enclosed air above that outside, Pa."""
        if scatter.is_moved:
            present = LocalAir(
                pressure * standard_pressure(scatter.climb) / standard_pressure(0.0),
                None,
                air.temperature + warmer + scatter.warming,
                scatter.humidity,
            )
            self.hidden, self.overpressure = bulged_sensor(
                self.hidden, self.design.with_values(rested.design_values), present, scatter.hours, stiffer
            )
            rested = replace(present, overpressure=self.overpressure)
        self.medium = medium_of(rested, self.design)

    def transfer_function(self, frequency: FrequencyLike) -> Complex:
        """Transfer functions that recordings without noise give: microphones with their gains and high-passes.

        Args:
            frequency: (n_freq,) Hz, 0.001 to 160, or FIRST:LAST:COUNT.

        Returns:
            (n_point, n_microphone, n_freq) complex128, Pa/Pa, by the nominal microphone's response.
        """
        grid = frequencies(frequency)
        for value in (grid.min(), grid.max()):
            check_range("frequency", float(value), _NODES[0], _NODES[-1], "Hz")
        level, phase = self._curves(np.log(grid))
        return np.asarray(np.exp(level + 1j * phase))

    @cached_property
    def _curves(self) -> scipy.interpolate.CubicSpline:
        h = batch_transfer_function(self.hidden, self.topology, _NODES, self.medium)[0]
        if self.fidelity != "lumped":
            h = h * self._of_fidelity
        microphone, air = self.design.microphone, design_air(self.design)
        for k, (gain, corner) in enumerate(zip(self.gain, self.corner, strict=True)):
            made = microphone.model_copy(update={"vent_corner": microphone.vent_corner * corner})
            h[:, k] *= gain * response(made, _NODES, self.medium) / response(microphone, _NODES, air)
        logarithm = np.stack([np.log(np.abs(h)), np.unwrap(np.angle(h), axis=-1)])
        return scipy.interpolate.CubicSpline(np.log(_NODES), logarithm, axis=-1)

    @cached_property
    def _of_fidelity(self) -> Complex:
        """Transfer functions of the nominal design by those of the closed forms, (n_point, n_microphone, n_node); below
        the slowest excitation, where air only pushes back, the ratio no longer changes.
        """
        faster = _NODES[_NODES >= _SLOW]
        solved, closed = (
            solve(self.design, faster, name).transfer_function.values for name in (self.fidelity, "lumped")
        )
        ratio = solved / closed
        before = np.repeat(ratio[..., :1], len(_NODES) - len(faster), axis=-1)
        return np.asarray(np.concatenate([before, ratio], axis=-1))

    def record(self, folder: Path, points: Sequence[int], recorder: Recorder | None = None) -> Path:
        """Write a WAV recording of each point, the nominal design and a manifest.

        Args:
            folder: a new or empty folder, or one to which a rig recorded before.
            points: numbers of the points, from 1.
            recorder: how.

        Returns:
            Path of the manifest.

        Raises:
            Refusal: a point that the design does not have, or a folder that holds recordings of others.
        """
        recorder = recorder or Recorder()
        for point in points:
            check_range("points", point, 1, self.design.point_count)
        check_folder(folder, "rig", RIG_MARK)
        make_folder(folder, "rig", RIG_MARK)
        write_text(folder / "design.toml", write_design(self.design))
        names = (REFERENCE, *self.design.microphones)
        scale = np.array([5 * recorder.full_scale, *[recorder.full_scale] * len(self.design.microphones)])
        manifest = tomlkit.document()
        manifest["design"] = "design.toml"
        manifest["output"] = recorder.output
        if recorder.reference_corner:
            manifest["response"] = _REFERENCE_FILE
            write_text(folder / _REFERENCE_FILE, _response_table(recorder))
        manifest["pascals"] = dict(zip(names, scale.tolist(), strict=True))
        manifest["started_late"] = {REFERENCE: recorder.late}
        files: dict[str, str | dict[str, str]] = {}
        for point in points:
            samples = self.signals(point, recorder) / scale[:, None]
            if recorder.separate:
                files[str(point)] = {name: f"point-{point}-{name}.wav" for name in names}
                for name, row in zip(names, samples, strict=True):
                    write_wav(folder / f"point-{point}-{name}.wav", row[None], recorder.rate, recorder.bits)
            else:
                files[str(point)] = f"point-{point}.wav"
                write_wav(folder / f"point-{point}.wav", samples, recorder.rate, recorder.bits)
        manifest["points"] = files
        path = folder / "calibration.toml"
        write_text(path, tomlkit.dumps(manifest))
        return path

    def signals(self, point: int, recorder: Recorder) -> Array:
        """Signals of a recording, the reference first, before they are clipped and rounded; (1 + n_microphone,
        n_sample) float64, Pa.
        """
        random = np.random.default_rng(np.random.SeedSequence(self.seed, spawn_key=(1, point)))
        before = round(_BEFORE * recorder.rate)
        count = round(recorder.seconds * recorder.rate)
        total = before + count + round(abs(recorder.late) * recorder.rate) + 1
        grid = np.fft.rfftfreq(total, 1 / recorder.rate).astype(np.float64)
        inside = (grid >= EXCITATION_BAND[0]) & (grid <= EXCITATION_BAND[1])
        drive = _excitation(recorder, total, random)
        drive[~inside] = 0
        drive *= recorder.level / np.sqrt(2 * (np.abs(drive[inside]) ** 2).sum()) * total
        return self.recorded({point: drive}, total, before, count, recorder, random)

    def recorded(
        self,
        drives: Mapping[int, Complex],
        total: int,
        before: int,
        count: int,
        recorder: Recorder,
        random: np.random.Generator,
        beside: Array | None = None,
    ) -> Array:
        """Signals that are recorded of pressures in cavities, with all that a recorder adds.

        Args:
            drives: by the number of the point, from 1: (n_line,) complex128, spectrum of the pressure in its cavity,
                Pa, as of np.fft.rfft, n_line = total // 2 + 1; lines above 125 Hz are ignored. The reference channel
                records the first, if there is one.
            total: number of samples of the pressure, at the rate of the recorder.
            before: number of them that come before the recording.
            count: number of samples of the recording.
            recorder: how.
            random: draws what the recorder adds.
            beside: further pressures in front of the microphones, of a contact or a motion, (n_microphone, n_sample)
                float64, Pa, already with the gains and high-passes of :meth:`transfer_function`.

        Returns:
            (1 + n_microphone, count) float64, Pa, the reference first, before the recorder clips and rounds them.
        """
        grid = np.fft.rfftfreq(total, 1 / recorder.rate).astype(np.float64)
        inside = grid <= EXCITATION_BAND[1]
        spectra = np.zeros((1 + len(self.design.microphones), len(grid)), np.complex128)
        if beside is not None:
            spectra[1:] += np.fft.rfft(beside)
        if drives:
            spectra[0] = next(iter(drives.values())) * np.exp(2j * np.pi * grid * recorder.late)
            spectra[0] *= recorder.reference_response(grid)
            heard_at = self.transfer_function(np.maximum(grid[inside], HEARD[0]))
        for point, drive in drives.items():
            spectra[1:, inside] += drive[inside] * heard_at[point - 1]
        # noise of the microphones as a pressure in their chambers, above 0.5 Hz
        heard = np.maximum(grid, 0.5)
        medium = design_air(self.design)
        density = noise_density_behind_vent(self.design.microphone, heard, medium)
        white = np.fft.rfft(random.standard_normal((len(spectra), total)))
        spectra[1:] += white[1:] * density * np.sqrt(recorder.rate / 2)
        spectra[0] += white[0] * recorder.reference_noise
        if recorder.output == "voltage":
            spectra[1:] *= output_response(self.design.microphone, np.maximum(grid, _LEAST), medium)
        samples = np.fft.irfft(spectra, total)[:, before : before + count]
        if recorder.output == "voltage":
            loudest = self.design.microphone.overload
            samples[1:] = np.clip(samples[1:], -loudest, loudest)
        time = np.arange(count) / recorder.rate
        mains = 50.0 + random.uniform(-0.03, 0.03)
        phase = random.uniform(0, 2 * np.pi, 2)
        hum = np.sin(2 * np.pi * mains * time + phase[0]) + np.sin(6 * np.pi * mains * time + phase[1]) / 3
        wander = np.cumsum(random.standard_normal((len(samples), count)), axis=1)
        wander *= recorder.drift / np.maximum(wander.std(axis=1, keepdims=True), 1e-300)
        slow = scipy.interpolate.make_interp_spline(time[:: recorder.rate], wander[:, :: recorder.rate], k=3, axis=1)
        return np.asarray(samples + recorder.hum * hum + slow(np.minimum(time, time[:: recorder.rate][-1])))


def _response_table(recorder: Recorder) -> str:
    """Response of the calibration microphone, as :mod:`acoustic_fem.calibration.reference_response` reads it."""
    known = recorder.reference_response(_REFERENCE_TABLE)
    columns = _REFERENCE_TABLE, 20 * np.log10(np.abs(known)), np.degrees(np.angle(known))
    rows = (",".join(f"{value:.6g}" for value in row) for row in zip(*columns, strict=True))
    return "\n".join(("frequency,dB,degrees", *rows, ""))


def _excitation(recorder: Recorder, total: int, random: np.random.Generator) -> Complex:
    """Spectrum of what is played, before it is scaled and cut to its band."""
    if recorder.excitation == "noise":
        return np.asarray(np.fft.rfft(random.standard_normal(total)))
    time = np.arange(total) / recorder.rate
    return np.asarray(
        np.fft.rfft(scipy.signal.chirp(time % 20.0, EXCITATION_BAND[0], 20.0, EXCITATION_BAND[1], method="logarithmic"))
    )
