"""Faults by which microphones reach a decoder otherwise than its library has them: level, sign, order, time."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, TypeAlias

import numpy as np

from geometry.ground.typed import Array
from localize.signals.stimulus import SAMPLE_RATE

FaultOfConnection: TypeAlias = Literal["level", "reversed", "exchanged", "late"]


@dataclass(frozen=True)
class ConnectionFault:
    """Fault in how microphones are connected or recorded, as the touches show it."""

    kind: FaultOfConnection
    """Kind: a level that is far off, a reversed sign, two exchanged channels, or a late channel."""
    microphones: tuple[str, ...]
    """Name of the microphone; two names if they are exchanged."""
    amount: float = 0.0
    """Level over that of the library, dB, or lateness, s, below 0 if the microphone is early; else 0."""

    def corrected(self, signals: Array, order: tuple[str, ...]) -> Array:
        """Signals as they would be without the fault.

        Args:
            signals: (..., n_microphone, n_sample) float64, Pa, at 1 kHz.
            order: names of the microphones of the signals.
        """
        found = signals.copy()
        index = [order.index(name) for name in self.microphones]
        if self.kind == "exchanged":
            found[..., index, :] = signals[..., index[::-1], :]
        elif self.kind == "reversed":
            found[..., index, :] *= -1
        elif self.kind == "level":
            found[..., index, :] /= 10 ** (self.amount / 20)
        else:
            found[..., index[0], :] = earlier(signals[..., index[0], :], self.amount * SAMPLE_RATE)
        return found

    def described(self, order: tuple[str, ...]) -> str:
        """Fault as a clause.

        Args:
            order: names of all microphones. With two, only the difference between them shows, so both are named.
        """
        name = self.microphones[0]
        other = next(each for each in order if each != name)
        two = len(order) == 2
        if self.kind == "exchanged":
            return f"microphones {name} and {self.microphones[1]} are exchanged"
        if self.kind == "reversed":
            return f"microphone {name}{f' or {other}' if two else ''} is reversed, so its signal has the wrong sign"
        if self.kind == "level":
            louder, quieter = ("louder", "quieter") if self.amount > 0 else ("quieter", "louder")
            either = f", or {other} {quieter}," if two else ""
            return f"microphone {name} is {abs(self.amount):.0f} dB {louder}{either} than the library has it"
        if two and self.amount < 0:
            name, other = other, name
        late = "late" if two or self.amount > 0 else "early"
        beside = f"microphone {other}" if two else "the other microphones"
        return f"microphone {name} is {1e3 * abs(self.amount):.1f} ms {late} against {beside}"


def earlier(signals: Array, samples: float) -> Array:
    """Signals moved to an earlier time by some samples, which need not be whole; zeros come in at the end.

    Args:
        signals: (..., n_sample) float64.
        samples: number of samples; below 0 for a later time.
    """
    whole = int(np.floor(samples))
    part, count = samples - whole, signals.shape[-1]
    moved = signals
    if part:
        # The signal and its mirror image join smoothly, so that nothing comes in from the other end.
        both = np.fft.rfft(np.concatenate([signals, signals[..., ::-1]], axis=-1))
        phasor = np.exp(2j * np.pi * part * np.fft.rfftfreq(2 * count))
        moved = np.fft.irfft(both * phasor, 2 * count)[..., :count]
    result = np.zeros_like(signals)
    if abs(whole) < count:
        if whole >= 0:
            result[..., : count - whole] = moved[..., whole:]
        else:
            result[..., -whole:] = moved[..., :whole]
    return result
