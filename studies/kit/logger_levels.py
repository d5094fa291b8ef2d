"""Expected levels of touches at a data logger: pressure, voltage, dB of full scale, and noise in steps.

Pressures are linear in the force. A voltage ends where the microphone or the logger is clipped, whichever is first.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

from geometry.design.array_design import ArrayDesign
from geometry.stock import Logger, StockMicrophone, catalogue
from localize.embedded.converter import LARGEST_STEP, noise_at
from studies.verdict.tap_levels import TAP, loudest_taps

#: Force of a firm tap of a finger, N; assumed.
FIRM_TAP = 1.0
#: Lengths of the touches whose largest force is stated, s: a tap, and presses down and up again.
TOUCH_LENGTHS = (TAP, 0.1, 0.2, 0.5)
#: Length of the touches of the first recording, s: short enough for a signal at 10 Hz, longer than a tap.
FIRST_TOUCH = 0.1
#: Largest pressure that a microphone survives, Pa: 160 dB, as data sheets of its class often state; assumed.
SURVIVED = 2000.0
#: Weight of a mass of 1 g, N.
GRAM = 9.81e-3
#: Full scale of a knob per overload of the microphone, so that the microphone is clipped first.
_ABOVE_OVERLOAD = 1.1
#: Highest frequency of the slowest touches that a stream decodes, Hz: a logger must reach it.
SLOWEST = 3.0
#: Sound pressure of a sine at which a sensitivity is stated, peak, Pa.
_STATED_PEAK = math.sqrt(2)
#: Bits of the samples of digital microphones.
_DIGITAL_BITS = 24


def two_digits(value: float) -> str:
    """A number with two digits that count, without a power of ten: 150 and not 1.5e+02."""
    return f"{float(f'{value:.2g}'):.6g}"


@dataclass(frozen=True)
class PointLevel:
    """Levels of a tap on one point at the microphone that it is loudest at."""

    point: int
    """Number of the point, from 1."""
    microphone: str
    """Microphone that it is loudest at."""
    touch: float
    """Largest output during a tap of the target's force, Pa at 1 kHz."""
    firm: float
    """Largest output during a tap of :data:`FIRM_TAP`, Pa at 1 kHz."""


@dataclass(frozen=True)
class LoggerLevels:
    """Levels at one logger, with the range that suits the microphone."""

    name: str
    """Name of the logger, or that the microphone has its own converter."""
    logger: Logger | None
    """Logger; None for the converter of a digital microphone."""
    full_scale: float
    """Pressure of the largest sample, Pa."""
    volts: float | None
    """Voltage of the largest sample, V; None for a digital microphone."""
    step: float
    """Pressure of one step, Pa."""
    microphone_noise: float
    """Noise of the microphone, Pa rms."""
    logger_noise: float
    """Noise of the logger, Pa rms; 0 for a digital microphone, whose noise includes that of its converter."""
    problems: tuple[str, ...]
    """Sentences on what limits the recordings, each with a remedy; empty if nothing does."""

    @property
    def noise_steps(self) -> float:
        """Noise of microphone and logger together in steps of the converter, rms."""
        return math.hypot(self.microphone_noise, self.logger_noise) / self.step

    def decibels(self, pressure: float) -> float:
        """Level of a peak pressure (Pa) that is not clipped, dB of full scale."""
        return 20 * math.log10(max(pressure, 1e-12) / self.full_scale)


@dataclass(frozen=True)
class LongestTouch:
    """Largest force of a touch of one length that is not clipped, on the loudest point."""

    seconds: float
    """Length of the touch, down and up again, s."""
    force: float
    """Force, N."""

    @property
    def grams(self) -> float:
        """Mass that weighs as much, g, as a kitchen scale shows it."""
        return self.force / GRAM


@dataclass(frozen=True)
class ExpectedLevels:
    """Levels of all points at all loggers."""

    force: float
    """Force of the stated touch, N."""
    overload: float
    """Pressure at which the microphone is clipped, Pa."""
    sensitivity: float | None
    """Output of the microphone, V/Pa; None for a digital microphone."""
    points: tuple[PointLevel, ...]
    """Levels of each point."""
    loggers: tuple[LoggerLevels, ...]
    """Loggers with enough inputs, the most suitable first."""
    largest_force: float
    """Largest force of a tap that the microphone does not clip on any point, N."""
    verdict: tuple[str, ...]
    """Sentences on the overload of the microphone, with a remedy where touches reach it."""

    def largest_pressure(self, logger: LoggerLevels) -> float:
        """Pressure above which the microphone or the logger clips, Pa."""
        return min(self.overload, logger.full_scale)

    def recorded(self, pressure: float, logger: LoggerLevels) -> float:
        """Largest sample of a peak pressure (Pa) at a logger, Pa."""
        return min(pressure, self.largest_pressure(logger))

    def is_clipped(self, pressure: float, logger: LoggerLevels) -> bool:
        """True if the microphone or the logger cuts the peak of a pressure (Pa) off."""
        return self.recorded(pressure, logger) < pressure

    def largest_tap(self, point: PointLevel, logger: LoggerLevels) -> float:
        """Largest force of a tap on a point that is clipped neither by the microphone nor by the logger, N."""
        return self.force * self.largest_pressure(logger) / point.touch

    @property
    def largest_voltage(self) -> float | None:
        """Output of the microphone when it is clipped, V peak; None for a digital microphone."""
        return None if self.sensitivity is None else self.overload * self.sensitivity

    def volts_of(self, pressure: float, logger: LoggerLevels) -> float | None:
        """Largest voltage of a peak pressure (Pa) at a logger, V; None for a digital microphone."""
        return None if self.sensitivity is None else self.recorded(pressure, logger) * self.sensitivity

    @property
    def survived_force(self) -> float:
        """Force of a tap at which the loudest point makes :data:`SURVIVED`, N."""
        return self.force * SURVIVED / max(point.touch for point in self.points)


def expected_levels(design: ArrayDesign) -> ExpectedLevels:
    """Levels of the touches of a design at the data loggers of the catalogue.

    Args:
        design: the array.
    """
    force, microphone = design.target.force, design.microphone
    taps = loudest_taps([design])[0]
    points = tuple(
        PointLevel(number, design.microphones[int(row.argmax())], float(row.max()), float(row.max()) * FIRM_TAP / force)
        for number, row in enumerate(taps, start=1)
    )
    part = catalogue().microphone(microphone.model)
    digital = part if isinstance(part, StockMicrophone) and part.output != "analog" else None
    loudest = max(point.touch for point in points)
    if digital is None:
        sensitivity = 10 ** (microphone.sensitivity / 20)
        fitting = [each for each in catalogue().of(Logger) if each.channels >= len(design.microphones)]
        found = sorted((_at_logger(design, each, sensitivity) for each in fitting), key=_suitability)
    else:
        sensitivity, found = None, [_at_digital(design, digital)]
    largest = force * microphone.overload / loudest
    verdict = tuple(_on_overload(design, loudest, largest))
    return ExpectedLevels(force, microphone.overload, sensitivity, points, tuple(found), largest, verdict)


def gentle_touches(design: ArrayDesign, levels: ExpectedLevels) -> tuple[LongestTouch, ...]:
    """Largest forces without clipping of touches of the :data:`TOUCH_LENGTHS`: slow ones may be larger.

    Args:
        design: the array.
        levels: its levels; touches are recorded by the most suitable logger.
    """
    per_newton = [loudest_taps([design], seconds=length)[0].max() / design.target.force for length in TOUCH_LENGTHS]
    largest = levels.largest_pressure(levels.loggers[0]) if levels.loggers else levels.overload
    return tuple(
        LongestTouch(length, largest / float(level)) for length, level in zip(TOUCH_LENGTHS, per_newton, strict=True)
    )


def _suitability(levels: LoggerLevels) -> tuple[int, float]:
    return len(levels.problems), 0.0 if levels.logger is None else levels.logger.price


def _at_logger(design: ArrayDesign, logger: Logger, sensitivity: float) -> LoggerLevels:
    """Levels at a logger: its range is the smallest that the overload of the microphone does not exceed."""
    wanted = design.microphone.overload * sensitivity
    low, high = min(logger.full_scales), max(logger.full_scales)
    if logger.gain == "knob":
        volts = min(high, max(low, _ABOVE_OVERLOAD * wanted))
    else:
        volts = min((each for each in logger.full_scales if each >= wanted), default=high)
    full_scale = volts / sensitivity
    noise = full_scale / math.sqrt(2) / 10 ** (logger.dynamic_range / 20)
    step, own = full_scale / 2 ** (logger.bits - 1), noise_at(design.microphone)
    problems = list(_limits(logger, volts, wanted, math.hypot(own, noise), step))
    return LoggerLevels(logger.name, logger, full_scale, volts, step, own, noise, tuple(problems))


def _at_digital(design: ArrayDesign, part: StockMicrophone) -> LoggerLevels:
    """Levels at the converter of a digital microphone, whose sensitivity is relative to a full-scale sine."""
    full_scale = _STATED_PEAK * 10 ** (-part.sensitivity / 20)
    step = full_scale / 2 ** (_DIGITAL_BITS - 1)
    own = noise_at(design.microphone)
    return LoggerLevels(f"converter of {part.name}", None, full_scale, None, step, own, 0.0, ())


def _limits(logger: Logger, volts: float, wanted: float, noise: float, step: float) -> Iterator[str]:
    if volts < wanted:
        yield (
            f"The largest range of {volts:g} V is below the {wanted:.3g} V of the microphone at its overload, so loud "
            "touches are clipped there. Divide the voltage by two resistors."
        )
    if step > LARGEST_STEP * noise:
        yield (
            f"One step is {1e3 * step:.2g} mPa, more than {LARGEST_STEP:g} times the noise of {1e3 * noise:.2g} mPa, "
            "so a quiet channel does not change. Amplify the microphones."
        )
    if logger.low_corner is not None and logger.low_corner > SLOWEST:
        yield (
            f"Its inputs are not specified below {logger.low_corner:g} Hz, but slow touches reach down to "
            f"{SLOWEST:g} Hz. Measure its response there before you buy it."
        )


def _on_overload(design: ArrayDesign, loudest: float, largest: float) -> Iterator[str]:
    overload, force = design.microphone.overload, design.target.force
    if loudest <= overload:
        yield (
            f"A tap of {force:g} N makes at most {loudest:.3g} Pa, and the microphone is clipped from {overload:.3g} "
            f"Pa. Taps up to {largest:.2g} N stay below."
        )
        return
    yield (
        f"A tap of {force:g} N makes up to {loudest:.3g} Pa, but the microphone is clipped from {overload:.3g} Pa. So "
        f"its taps are clipped above {largest:.2g} N ({two_digits(largest / GRAM)} g) on the loudest point. A clipped "
        "touch loses its peak: a decoder leaves that channel out and uses the other microphones, or reports that it "
        "cannot read the touch. Slow presses are quieter."
    )
    values = [(each, each.values.get("microphone.overload", 0.0)) for each in catalogue().of(StockMicrophone)]
    better = [(each.part_number, value) for each, value in values if value > overload]
    enough = [f"{name} ({value:.3g} Pa)" for name, value in better if value >= loudest]
    if enough:
        yield (
            f"If your touches are harder, set microphone.model before you order: {', '.join(enough)} record it without "
            "clipping."
        )
    elif better:
        name, value = max(better, key=lambda each: each[1])
        chosen = catalogue().microphone(name)
        boardless = " No board is drawn for it." if chosen is not None and chosen.land_pattern is None else ""
        yield (
            f"If your touches are harder, set microphone.model = {name!r} before you order. It reaches {value:.3g} Pa, "
            f"{20 * math.log10(value / overload):.1f} dB more, so taps of up to {largest * value / overload:.2g} N. No "
            f"microphone of the catalogue is specified to record {force:g} N without clipping.{boardless}"
        )
