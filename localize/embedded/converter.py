"""Pressure of a sample, from the microphone of the design and the converter behind it."""

from __future__ import annotations

from dataclasses import dataclass

from geometry.design.design_file import read_design
from geometry.ground.argument_checks import check_range
from geometry.ground.refusal import Kind, Refusal
from geometry.schema.part_fields import Microphone
from localize.signals.array_response import ArrayResponse

#: Numbers of bits that fit the samples of the firmware.
BITS = (8, 16)
#: Voltages and pressures of a full scale.
VOLTS = (1e-4, 100.0)
FULL_SCALES = (1e-3, 1e6)


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
            problem = "is not allowed beside volts, because the microphone's sensitivity already gives the pressure"
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

    @property
    def pascals_per_step(self) -> float:
        """Pressure of one step of the converter, Pa."""
        return self.full_scale / self.largest


#: Converter whose full scale is the pressure at which the design's microphone overloads.
AT_OVERLOAD = Converter()


def sample_scale(response: ArrayResponse, converter: Converter = AT_OVERLOAD) -> SampleScale:
    """Pressures of samples of an array.

    Args:
        response: of the array, with a design unless the converter has a pressure.
        converter: that samples its microphones.

    Raises:
        Refusal: a voltage, of an array whose design is not known.
    """
    stated = response.provenance.get("design")
    largest = 2 ** (converter.bits - 1) - 1
    if converter.full_scale is not None:
        overload = read_design(stated).microphone.overload if stated else converter.full_scale
        return SampleScale(converter.full_scale, overload, largest, "as given")
    if not stated:
        if converter.volts is not None:
            raise Refusal(
                "needs the microphone's sensitivity, and the library has no design",
                kind=Kind.MISSING,
                field="volts",
                value=converter.volts,
                remedy="give full_scale, the pressure of the largest sample in Pa",
            )
        usual = float(Microphone.model_fields["overload"].default)
        source = "assumed, because the library has no design: the peak of a sine of 120 dB SPL"
        return SampleScale(usual, usual, largest, source)
    microphone = read_design(stated).microphone
    sensitivity = 10 ** (microphone.sensitivity / 20)
    about = f"{microphone.model}, {microphone.sensitivity:g} dB re 1 V per Pa"
    if converter.volts is not None:
        full_scale = converter.volts / sensitivity
        source = f"{converter.volts:g} V at the microphone, {about}"
        return SampleScale(full_scale, microphone.overload, largest, source)
    volts = microphone.overload * sensitivity
    source = f"the overload of the microphone, {about}: amplify its {1e3 * volts:.3g} mV to the converter's full scale"
    return SampleScale(microphone.overload, microphone.overload, largest, source)
