"""Pressure of a sample, from the microphone of the design and the converter behind it."""

from __future__ import annotations

import warnings
from dataclasses import dataclass

import numpy as np

from acoustic_fem import network
from geometry.design.design_file import read_design
from geometry.ground.argument_checks import check_range
from geometry.ground.refusal import Field, Kind, Refusal
from geometry.schema.part_fields import Microphone
from localize.embedded.decimator import FACTOR
from localize.signals.array_response import ArrayResponse
from localize.signals.noise_model import NOISE_BAND
from localize.signals.stimulus import SAMPLE_RATE

#: Numbers of bits that fit the samples of the firmware.
BITS = (8, 16)
#: Voltages and pressures of a full scale.
VOLTS = (1e-4, 100.0)
FULL_SCALES = (1e-3, 1e6)
#: Largest step over the rms noise of the microphone at the converter. Up to here the noise of the samples is right
#: within a factor of 1.4, wherever the level at rest lies between two steps. With larger steps it may vanish.
LARGEST_STEP = 3.0


class CoarseConverterWarning(UserWarning):
    """Warning of a converter whose steps are so large that the noise of the microphone does not reach its samples."""


@dataclass(frozen=True)
class Converter:
    """Converter that samples the microphones. Without a voltage or a pressure, its full scale is the pressure at which
    the design's microphone overloads.
    """

    volts: float | None = None
    """Voltage of the microphone, before any amplifier, that gives the largest sample, V."""
    full_scale: float | None = None
    """Pressure that gives the largest sample, Pa: for digital microphones, or where it was measured."""
    bits: int = 16
    """Number of bits of a sample, its sign among them."""

    def __post_init__(self) -> None:
        if self.volts is not None and self.full_scale is not None:
            beside = ", because the microphone's sensitivity already gives the pressure"
            problem = ("is not allowed beside ", Field("volts"), beside)
            raise Refusal(problem, kind=Kind.MISMATCH, field="full_scale", value=self.full_scale)
        if self.volts is not None:
            check_range("volts", self.volts, *VOLTS, "V")
        if self.full_scale is not None:
            check_range("full_scale", self.full_scale, *FULL_SCALES, "Pa")
        check_range("bits", self.bits, *BITS, whole=True)


@dataclass(frozen=True)
class SampleScale:
    """Pressures of the samples of a firmware."""

    full_scale: float
    """Pressure of the largest sample, Pa."""
    overload: float
    """Pressure at which the microphone is clipped, Pa."""
    largest: int
    """Largest sample."""
    source: str
    """Where the full scale comes from, in words."""
    noise: float | None
    """Noise of the design's microphone at the converter, from 1 Hz to half its rate, Pa rms; None without a design."""

    @property
    def pascals_per_step(self) -> float:
        """Pressure of one step of the converter, Pa."""
        return self.full_scale / self.largest


#: Converter whose full scale is the pressure at which the design's microphone overloads.
AT_OVERLOAD = Converter()


def sample_scale(response: ArrayResponse, converter: Converter = AT_OVERLOAD, *, digital: bool = False) -> SampleScale:
    """Pressures of samples of an array.

    Args:
        response: of the array, with a design unless the converter has a pressure.
        converter: that samples its microphones.
        digital: True for PDM microphones, which no amplifier can bring to a full scale.

    Raises:
        Refusal: a voltage, of an array whose design is not known.
    """
    stated = response.provenance.get("design")
    largest = 2 ** (converter.bits - 1) - 1
    if converter.full_scale is not None:
        if not stated:
            return SampleScale(converter.full_scale, converter.full_scale, largest, "as given", None)
        microphone = read_design(stated).microphone
        return SampleScale(converter.full_scale, microphone.overload, largest, "as given", noise_at(microphone))
    if not stated:
        if converter.volts is not None:
            raise Refusal(
                "needs the microphone's sensitivity, and the library has no design",
                kind=Kind.MISSING,
                field="volts",
                value=converter.volts,
                remedy=("give ", Field("full_scale"), ", the pressure of the largest sample in Pa"),
            )
        usual = float(Microphone.model_fields["overload"].default)
        source = "assumed, because the library has no design: the peak of a sine of 120 dB SPL"
        return SampleScale(usual, usual, largest, source, None)
    microphone = read_design(stated).microphone
    sensitivity = 10 ** (microphone.sensitivity / 20)
    about = f"{microphone.model}, {microphone.sensitivity:g} dB re 1 V per Pa"
    if converter.volts is not None:
        full_scale = converter.volts / sensitivity
        source = f"{converter.volts:g} V at the microphone, {about}"
        return SampleScale(full_scale, microphone.overload, largest, source, noise_at(microphone))
    if digital:
        source = (
            f"the overload of {microphone.model}, assumed; that of your PDM microphone follows from its sensitivity in "
            "dBFS: give it with --full-scale"
        )
        return SampleScale(microphone.overload, microphone.overload, largest, source, noise_at(microphone))
    volts = microphone.overload * sensitivity
    source = f"the overload of the microphone, {about}: amplify its {1e3 * volts:.3g} mV to the converter's full scale"
    return SampleScale(microphone.overload, microphone.overload, largest, source, noise_at(microphone))


def noise_at(microphone: Microphone) -> float:
    """Noise of a microphone at the converter, from 1 Hz to half the converter's rate, Pa rms.

    Its density is that of :func:`acoustic_fem.network.noise_density`, since the vent does not filter noise of the
    output.
    """
    frequency = np.geomspace(NOISE_BAND[0], FACTOR * SAMPLE_RATE / 2, 400)
    return float(np.sqrt(np.trapezoid(network.noise_density(microphone, frequency) ** 2, frequency)))


def warn_of_coarse(scale: SampleScale, converter: Converter, *, digital: bool = False) -> None:
    """Warn of a converter whose step is more than :data:`LARGEST_STEP` times the noise of the microphone.

    Between two steps, a quiet microphone then gives equal samples, and the decoder calls it dead.

    Args:
        scale: pressures of its samples.
        converter: that samples the microphones.
        digital: True for PDM microphones, which have no gain and 16 bits.
    """
    if scale.noise is None or scale.pascals_per_step <= LARGEST_STEP * scale.noise:
        return
    finest = LARGEST_STEP * scale.noise
    fixes = [_smaller_scale(converter.bits, finest, scale.full_scale, converter, digital=digital)]
    if converter.bits < BITS[1]:
        fixes.append(_more_bits(finest, scale.full_scale, converter))
    warnings.warn(
        f"one step of the converter is {1e3 * scale.pascals_per_step:.3g} mPa, and the microphone's noise is "
        f"{1e3 * scale.noise:.3g} mPa rms: in silence a channel may not change, and then counts as dead. A step of at "
        f"most {1e3 * finest:.3g} mPa needs {', or '.join(fixes)}",
        CoarseConverterWarning,
        stacklevel=3,
    )


def _smaller_scale(bits: int, finest: float, full_scale: float, converter: Converter, *, digital: bool) -> str:
    """Change of the circuit, and its option, by which a converter of so many bits has a step in Pa."""
    largest = finest * (2 ** (bits - 1) - 1)
    if digital:
        least = 20 * np.log10(np.sqrt(2) / largest)
        return f"a microphone of at least {np.ceil(least):g} dBFS at 94 dB SPL, and --full-scale {_below(largest)}"
    gain = f"{np.ceil(10 * full_scale / largest) / 10:.3g} times the gain"
    if converter.volts is not None:
        return f"{gain} and --converter-volts {_below(converter.volts * largest / full_scale)}"
    return f"{gain} and --full-scale {_below(largest)}"


def _more_bits(finest: float, full_scale: float, converter: Converter) -> str:
    """Least number of bits that has a step in Pa, at the same full scale where 16 bits suffice for it."""
    for bits in range(converter.bits + 1, BITS[1] + 1):
        if full_scale <= finest * (2 ** (bits - 1) - 1):
            return f"a converter with --converter-bits {bits}"
    smaller = _smaller_scale(BITS[1], finest, full_scale, converter, digital=False)
    return f"a converter with --converter-bits {BITS[1]}, together with {smaller}"


def _below(value: float) -> str:
    """A number in two digits, rounded down."""
    digits = 1 - int(np.floor(np.log10(value)))
    return f"{np.floor(value * 10.0**digits) / 10.0**digits:g}"
