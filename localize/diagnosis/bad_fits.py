"""Diagnosis where a library does not fit its sensor: the broken part, if one is found, instead of a misfit."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from acoustic_fem import Library
from acoustic_fem.sound.estimate import TransferEstimate
from geometry.ground.refusal import Refusal
from geometry.ground.typed import Array
from localize.diagnosis.diagnosis import Diagnoser, Diagnosis
from localize.signals.noise_model import NoiseChoice

CERTAIN = 1000.0
"""Gain in log-likelihood over a sound sensor, nats, from which on a fault is certain."""
EXPLAINED = 1.0
"""Mean square of the residual over the expected one, up to which touches are explained."""


def fault_of_touches(
    library: Library, recordings: Sequence[Array], microphone_noise: NoiseChoice = "design"
) -> Diagnosis | None:
    """Fault that explains touches of unknown points; None if none is found, or if none can be looked for.

    Args:
        library: of the sensor's design, or its calibrated one.
        recordings: (n_microphone, n_sample) float64 each, Pa, at 1 kHz; their touches are taken together.
        microphone_noise: of the microphones, white, Pa rms over 0 to 500 Hz, or "design".
    """
    try:
        found = Diagnoser(library, microphone_noise).diagnose(np.concatenate(recordings, axis=1))
    except Refusal:  # a design whose scatter is not known, a library without the band, or too few touches
        return None
    return found if _is_certain(found) else None


def fault_of_estimates(library: Library, estimates: Mapping[int, TransferEstimate]) -> Diagnosis | None:
    """Fault that explains measured transfer functions; None if none is found, or if none can be looked for.

    Args:
        library: of the sensor's design, on the frequencies of the estimates.
        estimates: by number of the point, from 1.
    """
    try:
        found = Diagnoser(library).diagnose_measured(library.frequency, estimates)
    except Refusal:  # a design whose scatter is not known, a library without the band, or too few points
        return None
    return found if _is_certain(found) else None


def _is_certain(found: Diagnosis) -> bool:
    """True if a fault explains nearly all and a sound sensor does not, because nobody asked for a diagnosis."""
    return found.names_a_fault and found.gain > CERTAIN and found.misfit < EXPLAINED
