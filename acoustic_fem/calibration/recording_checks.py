"""Checks of a recording for calibration: by the signals themselves, and against the model."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from acoustic_fem.calibration.manifest import REFERENCE
from acoustic_fem.quantities.microphone_signals import Output
from acoustic_fem.sound.clipping import first_clipped
from acoustic_fem.sound.estimate import TransferEstimate, amplitudes, shortest_record
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array, ComplexArray

#: Seconds of equal samples that show a gap, and how many they must be at least.
GAP, GAP_SAMPLES = 0.05, 8
#: Fewer different values than that are too coarse for a transfer function.
LEAST_LEVELS = 32
#: dB by which a recording misses the model before another explanation is looked for. Sensors made with the usual
#: tolerances miss it by 1 to 4 dB.
MISFIT = 5.0
#: dB by which a recording misses the model before the other kind of signals is looked for; it misses by 4 to 10 dB.
OTHER_OUTPUT = 3.0
#: The other explanation must miss by less than this share of it.
BETTER = 0.4
#: Coherence at the quarter of frequencies with the largest transfer function, below which a microphone is deaf.
DEAF = 0.2
#: Largest delay between two recorders that goes without saying, s.
DELAY = 2e-3
#: Largest changes between two parts of a recording: of the delay, s, less than a sample at 1 kHz, and of the level, dB.
#: Good recordings of the virtual rig, with ten times its hum and drift too, change by less than 0.25 ms and 0.1 dB.
DRIFT, LEVEL_CHANGE = 8e-4, 1.0
#: Share of a channel that is not another one, below which both are the same signal; beside what rounding adds. On the
#: virtual rig it is 9 % and more.
SAME = 1e-3
#: Largest value of a channel, in units of its file.
SMALLEST, LARGEST = 1e-12, 1e12
#: Seconds of a segment: short, so that a part of 5 s has many; rough, since only changes are looked for.
_SEGMENT = 1.0
#: Segments of a part, and the largest number of parts.
_PER_PART, _MOST_PARTS = 18, 8
#: Coherence, and share of its power in the whole recording, from which a frequency of a part says something.
_COHERENCE, _DRIVEN = 0.9, 0.1
#: Share of the frequencies that two parts must have in common to be compared.
_SHARED = 0.25
#: Delays that are tried, s.
_DELAYS = np.linspace(-0.25, 0.25, 2001)


class RecordingFault(Refusal):
    """A recording that cannot be used: the reason, without its file."""


class RecordingMisfit(RecordingFault):
    """A recording that contradicts the design, with the transfer functions that it gives."""

    estimate: TransferEstimate
    """Transfer functions of the recording."""


def _fault(channel: str, problem: str) -> RecordingFault:
    return RecordingFault(problem, kind=Kind.UNSUITABLE, field=f"channels.{channel}")


def check_signals(
    channels: Mapping[str, Array], rate: float, limits: Mapping[str, float | None], highest: float
) -> None:
    """Refuse signals without looking at what they say.

    Args:
        channels: (n_sample,) float64 each, by name, in the units of the files.
        rate: Hz.
        limits: largest value of each channel's format, None where there is none.
        highest: highest frequency that is wanted, Hz.

    Raises:
        RecordingFault: a rate too low, a record too short, a channel that is not finite, out of range, silent, coarse,
            clipped or interrupted, or two that are the same.
    """
    if rate < 2.5 * highest:
        allowed = f"at least {2.5 * highest:g} Hz, 2.5 x {highest:g} Hz"
        raise RecordingFault(kind=Kind.UNSUITABLE, field="sample_rate", value=rate, unit="Hz", allowed=allowed)
    seconds = min(len(values) for values in channels.values()) / rate
    if seconds < shortest_record():
        raise RecordingFault(
            f"is {seconds:.3g} s long; it must be at least {shortest_record():g} s", kind=Kind.UNSUITABLE
        )
    for name, values in channels.items():
        bad = np.flatnonzero(~np.isfinite(values))
        if len(bad):
            raise _fault(name, f"is not finite at {bad[0] / rate:.3f} s")
        largest = float(np.abs(values).max())
        if largest > LARGEST or 0 < largest < SMALLEST:
            raise _fault(name, f"has a largest value of {largest:g}; it must be between {SMALLEST:g} and {LARGEST:g}")
        if values.max() == values.min():
            raise _fault(name, "is silent: its value never changes")
        levels = len(np.unique(values))
        if levels < LEAST_LEVELS:
            raise _fault(name, f"is too weak: it takes {levels} different values only")
        clipped = first_clipped(values, limits[name])
        if clipped is not None:
            raise _fault(name, f"is clipped, first at {clipped / rate:.3f} s")
        held = _longest_hold(values)
        if held[1] >= max(GAP * rate, GAP_SAMPLES) and levels > len(values) / 100:
            raise _fault(name, f"is interrupted for {held[1] / rate:.3f} s from {held[0] / rate:.3f} s on")
    for one, other in combinations(channels, 2):
        if _are_same(channels[one], channels[other]):
            raise _fault(one, f"is the same signal as channels.{other}: one was recorded or copied twice")


def check_steady(signals: Array, rate: float, frequency: Array, microphones: tuple[str, ...]) -> None:
    """Refuse what is not of one piece: each microphone against the reference, in all parts of the recording.

    Args:
        signals: (1 + n_microphone, n_sample) float64, Pa, the reference first.
        rate: Hz.
        frequency: (n_freq,) Hz.
        microphones: their names.

    Raises:
        RecordingFault: a level or a delay that changes.
    """
    levels, delays = largest_changes(signals, rate, frequency)
    for name, level, delay in zip(microphones, levels, delays, strict=True):
        if delay > DRIFT:
            raise _fault(
                name,
                f"and the reference drift apart by {1e3 * delay:.1f} ms in the recording: samples were lost, or the "
                "clocks of their recorders differ",
            )
        if level > LEVEL_CHANGE:
            raise _fault(name, f"changes its level against the reference by {level:.1f} dB in the recording")


def largest_changes(signals: Array, rate: float, frequency: Array) -> tuple[Array, Array]:
    """Largest changes between two parts of a recording.

    Args:
        signals: (1 + n_microphone, n_sample) float64, Pa, the reference first, of at least 19 s.
        rate: Hz.
        frequency: (n_freq,) Hz, at which they are compared.

    Returns:
        (n_microphone,) float64 of the level in dB, and of the delay in s, both >= 0; 0 of microphones whose parts
        cannot be
        compared: too much noise, or a slow sweep, of which each part holds other frequencies.
    """
    found = amplitudes(signals, rate, frequency, _SEGMENT)
    count = found.shape[1]
    parts = min(max(count // _PER_PART, 1), _MOST_PARTS)
    found = found[:, : count // parts * parts].reshape(len(found), parts, -1, len(frequency))
    x, y = found[0], found[1:]
    power, of_output = (np.abs(x) ** 2).sum(1), (np.abs(y) ** 2).sum(2)
    cross = (x.conj() * y).sum(2)  # (microphone, part, frequency)
    tiny = np.finfo(np.float64).tiny
    known = np.abs(cross) ** 2 > _COHERENCE * power * of_output
    known &= (power > _DRIVEN * power.mean(0)) & (np.abs(cross) > tiny)
    level = 20 * np.log10(np.maximum(np.abs(cross), tiny) / np.maximum(power, tiny))
    unit = cross / np.maximum(np.abs(cross), tiny)
    turns = np.exp(2j * np.pi * _DELAYS * frequency[:, None])
    levels, delays = np.zeros(len(y)), np.zeros(len(y))
    for a, b in combinations(range(parts), 2):
        shared = known[:, a] & known[:, b]
        enough = shared.mean(1) >= _SHARED
        if enough.any():
            difference = np.where(shared, level[:, b] - level[:, a], np.nan)[enough]
            levels[enough] = np.maximum(levels[enough], np.abs(np.nanmedian(difference, axis=1)))
            fit = ((unit[:, b] * unit[:, a].conj() * shared)[enough] @ turns).real
            delays[enough] = np.maximum(delays[enough], np.abs(_DELAYS[fit.argmax(1)]))
    return levels, delays


def check_estimate(estimate: TransferEstimate, microphones: tuple[str, ...], least_coherence: float) -> None:
    """Refuse a reference that none of the microphones follows.

    Raises:
        RecordingFault: with the coherence of the best.
    """
    median = np.median(np.nan_to_num(estimate.coherence), axis=1)
    best = int(np.argmax(median))
    if median[best] < least_coherence:
        raise _fault(
            microphones[best],
            f"is the best microphone, and its coherence is {median[best]:.2f} (median over frequency); it must be at "
            f"least {least_coherence:g}: not driven, too much noise, or not recorded together",
        )


def check_output(estimate: TransferEstimate, model: ComplexArray, of_microphone: ComplexArray, output: Output) -> None:
    """Refuse a recording that would fit the design if its channels held the other kind of signals.

    Args:
        estimate: of the point, of pressures if the channels hold what the manifest says.
        model: (n_microphone, n_freq) complex128, Pa/Pa, of the design at the point.
        of_microphone: (n_freq,) complex128, output of the design's microphone over the pressure in front of it.
        output: what the manifest says.

    Raises:
        RecordingFault: with the value of ``output`` that would explain it.
    """
    measured = estimate.transfer_function
    known = estimate.deviation < 0.3 * np.abs(measured)
    misfit = _misfit(measured, model, known)
    other = measured * of_microphone if output == "voltage" else measured / of_microphone
    if misfit > OTHER_OUTPUT and _misfit(other, model, known) < BETTER * misfit:
        has, needed = ("no", "pressure") if output == "voltage" else ("the", "voltage")
        raise RecordingFault(
            f"is {misfit:.0f} dB off the design, because its microphones show {has} high-pass of their vents",
            kind=Kind.MISMATCH,
            field="output",
            value=output,
            remedy=f'give output = "{needed}" in the manifest',
        )


def check_against_model(
    estimate: TransferEstimate,
    model: ComplexArray,
    point: int,
    frequency: Array,
    microphones: tuple[str, ...],
    pascals: tuple[float, ...],
    divided_by: ComplexArray | float = 1.0,
) -> tuple[str, ...]:
    """Compare a recording with the transfer functions of the design.

    Args:
        estimate: of the point.
        model: (n_point, n_microphone, n_freq) complex128, Pa/Pa, of the design.
        point: index of the point, from 0.
        frequency: (n_freq,) Hz.
        microphones: their names.
        pascals: of one unit of the reference and of each microphone, by which exchanged channels were scaled too.
        divided_by: (n_freq,) complex128, response of the microphones that was divided out of their channels, 1 if they
            held pressures.

    Returns:
        Notes on a recording that can be used.

    Raises:
        RecordingFault: a microphone that follows nothing, channels that look exchanged, a recording that looks like
            that of another point, or a polarity that is reversed.
    """
    measured = estimate.transfer_function
    for name, row, expected in zip(microphones, estimate.coherence, np.abs(model[point]), strict=True):
        loudest = row[expected >= np.quantile(expected, 0.75)]
        if np.median(np.nan_to_num(loudest)) < DEAF:
            raise _fault(
                name,
                f"has nothing in common with the reference: coherence {np.median(loudest):.2f} where the response of "
                "the design is largest",
            )
    known = estimate.deviation < 0.3 * np.abs(measured)
    misfit = _misfit(measured, model[point], known)
    if misfit > MISFIT:
        for text, changed, other in _explanations(measured, model, point, microphones, pascals, divided_by):
            if _misfit(changed, other, known) < BETTER * misfit:
                raise RecordingFault(
                    f"is {misfit:.0f} dB off the design; {text} would explain it", kind=Kind.UNSUITABLE
                )
    delay = common_delay(measured, model[point], frequency)
    # a late reference turns phases; polarity is what turns them alike at all frequencies
    late = delay if abs(delay) > DELAY else 0.0
    low = frequency <= max(10.0, float(frequency[0]))
    in_phase = measured * model[point].conj() * np.exp(2j * np.pi * frequency * late)
    turned = in_phase[:, low].sum(1).real < 0
    if turned.any() and not turned.all():
        names = ", ".join(name for name, is_turned in zip(microphones, turned, strict=True) if is_turned)
        raise RecordingFault(
            f"has the polarity of microphone {names} reversed against the others", kind=Kind.UNSUITABLE
        )
    if turned.all():
        raise RecordingFault("has the polarity of the reference reversed against all microphones", kind=Kind.UNSUITABLE)
    notes = []
    if misfit > MISFIT:
        notes.append(f"is {misfit:.0f} dB off the design: another sensitivity, or a sensor far from it")
    if late:
        notes.append(
            f"microphones lag by {1e3 * delay:.1f} ms against the design: were the recorders started together? "
            "started_late corrects it"
        )
    return tuple(notes)


def common_delay(measured: ComplexArray, model: ComplexArray, frequency: Array) -> float:
    """Delay tau, s, within 0.25 s, that turns the model best into what was measured, whatever the polarity of each
    microphone: H = +- model exp(-2 pi j f tau).

    Args:
        measured: (n_microphone, n_freq) complex128, Pa/Pa.
        model: (n_microphone, n_freq) complex128, Pa/Pa.
        frequency: (n_freq,) float64, Hz.
    """
    ratio = measured * model.conj()
    unit = ratio / np.maximum(np.abs(ratio), 1e-300)
    delays = np.linspace(-0.25, 0.25, 5001)
    fit = np.abs((unit @ np.exp(2j * np.pi * delays * frequency[:, None])).real).sum(0)
    return float(delays[np.argmax(fit)])


def _misfit(measured: ComplexArray, model: ComplexArray, known: NDArray[np.bool_]) -> float:
    """Root mean square difference of levels in dB, where the measured ones are known; one gain per channel is free
    within 3 dB, which is what uncalibrated microphones differ by.
    """
    total = 0.0
    for values, expected, use in zip(measured, model, known, strict=True):
        if use.any():
            level = 20 * np.log10(np.abs(values[use]) / np.abs(expected[use]))
            total += float(np.mean((level - np.clip(level.mean(), -3, 3)) ** 2))
    return float(np.sqrt(total / max(known.any(1).sum(), 1)))


def _explanations(
    measured: ComplexArray,
    model: ComplexArray,
    point: int,
    microphones: tuple[str, ...],
    pascals: tuple[float, ...],
    divided_by: ComplexArray | float,
) -> Iterator[tuple[str, ComplexArray, ComplexArray]]:
    """Texts with the measured values they would change, and those to compare with."""
    of_reference, *scale = pascals
    for a, b in combinations(range(len(microphones)), 2):
        changed = measured.copy()
        changed[a], changed[b] = measured[b] * scale[a] / scale[b], measured[a] * scale[b] / scale[a]
        yield f"channels {microphones[a]} and {microphones[b]} exchanged", changed, model[point]
    for k, name in enumerate(microphones):
        # The reference was taken for an output, and an output for the reference.
        changed = measured / measured[k] * scale[k] / of_reference / divided_by
        changed[k] = (scale[k] / of_reference / divided_by) ** 2 / measured[k]
        yield f"channels {REFERENCE} and {name} exchanged", changed, model[point]
    for other in range(len(model)):
        if other != point:
            yield f"point {other + 1} touched instead", measured, model[other]


def _longest_hold(values: Array) -> tuple[int, int]:
    """Index and length of the longest run of equal samples."""
    ends = np.flatnonzero(np.concatenate([[True], np.diff(values) != 0, [True]]))
    runs = np.diff(ends)
    longest = int(np.argmax(runs))
    return int(ends[longest]), int(runs[longest])


def _are_same(one: Array, other: Array) -> bool:
    """True if two channels are one signal at two gains, each rounded."""
    count = min(len(one), len(other))
    a, b = one[:count] - one[:count].mean(), other[:count] - other[:count].mean()
    gain = float(a @ b / (a @ a))
    steps = [float(np.diff(np.unique(values)).min()) for values in (one, other)]
    rounding = np.hypot(gain * steps[0], steps[1]) / np.sqrt(12)
    return bool(np.std(b - gain * a) < 2 * rounding + SAME * np.std(b))
