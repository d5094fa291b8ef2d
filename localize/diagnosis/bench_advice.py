"""Advice for the bench, computed from a fault: what to repair, and which touch shows at which microphone that it is."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations

import numpy as np

from geometry.ground.typed import ComplexArray
from localize.diagnosis.fault_libraries import FaultLibraries
from localize.diagnosis.faults import SensorFault, level, tube_name

AUDIBLE = -55.0
"""Least level at a microphone over that in the touched cavity at which a touch is proposed, dB."""


def bench_advice(libraries: FaultLibraries, fault: SensorFault) -> str:
    """Work at the bench for a fault, and the touch that shows whether it helped, as one or two sentences.

    The level of one microphone relative to another does not depend on how hard a finger touches, so the change of this
    difference is stated.

    Args:
        libraries: of the design.
        fault: with its amount.
    """
    design = libraries.design
    names = [design.microphones[number - 1] for number in fault.part] if "microphone" in fault.kind else []
    if fault.kind == "reversed microphone":
        return f"Invert the signal of microphone {names[0]}, or exchange its two wires if its output is differential."
    if fault.kind == "exchanged microphones":
        return f"Exchange the plugs or the channels of microphones {' and '.join(names)}."
    if fault.kind == "blocked tube":
        work = f"Clear or replace {tube_name(design, fault.part[0])}."
    elif fault.kind == "leak":
        work = f"Seal the rim of the membrane and the tube joints of point {fault.part[0]}, or press them shut to test."
    else:
        work = f"Check the sound hole, the solder joints, the supply and the gain of microphone {names[0]}."
    return f"{work} {_proof(libraries, fault)}".rstrip()


def _proof(libraries: FaultLibraries, fault: SensorFault) -> str:
    """Sentence with the touch whose levels change most when the fault is repaired."""
    sound, broken = libraries.with_deviations([None, fault], np.zeros((1, libraries.size)))
    now, then = level(broken), level(sound)  # (n_point, n_microphone) dB
    names = libraries.design.microphones
    best, found = 0.0, ""
    for point in range(len(now)):
        if fault.kind == "leak" and point == fault.part[0] - 1:
            continue
        for one, other in combinations(range(len(names)), 2):
            change = (then[point, one] - then[point, other]) - (now[point, one] - now[point, other])
            # The microphone whose own level changes more is named.
            changed = max((one, other), key=lambda k: abs(then[point, k] - now[point, k]))
            beside, sign = (other, 1.0) if changed == one else (one, -1.0)
            if abs(change) > best and max(then[point, one], then[point, other]) > AUDIBLE:
                best = abs(change)
                how = "louder" if sign * change > 0 else "quieter"
                found = (
                    f"Then touch point {point + 1}: microphone {names[changed]} should be {best:.0f} dB {how} relative "
                    f"to microphone {names[beside]} than it is now."
                )
    return found


def most_telling_point(explanations: Sequence[ComplexArray], mismatch: float) -> int:
    """Index of the point whose touch, if it is known, best distinguishes explanations of the touches so far.

    For two explanations it is the one at which their transfer functions differ most in the ratios of the microphones;
    of several, the least different pair counts.

    Args:
        explanations: transfer functions (n_point, n_microphone, n_freq) complex128 each, two or more.
        mismatch: fraction of a microphone's signal, in amplitude, that counts as noise.
    """
    pairs = [_distance(one, other, mismatch) for one, other in combinations(explanations, 2)]
    return int(np.min(pairs, axis=0).argmax())


def _distance(one: ComplexArray, other: ComplexArray, mismatch: float) -> ComplexArray:
    """Distance of two explanations at each point, (n_point,) float64."""
    unit = one / np.sqrt((np.abs(one) ** 2).sum(1, keepdims=True))
    whole = np.abs(other) ** 2
    along = (other.conj() * unit).sum(1)
    residual = 1 - np.abs(along) ** 2 / whole.sum(1)
    noise = mismatch**2 * (whole.sum(1) - (whole**2).sum(1) / whole.sum(1)) / whole.sum(1) + 1e-5
    return np.asarray(np.log1p(np.maximum(residual, 0.0) / noise).sum(1))
