"""Options of a model: what it decodes with, what its signals are, and what it reports besides the point."""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import TypeAlias

from acoustic_fem.library.transfer_functions import Library
from acoustic_fem.network.microphone_output import Equaliser
from acoustic_fem.quantities.local_air import LocalAir, checked_air
from acoustic_fem.quantities.microphone_signals import LOWEST, LOWEST_RANGE, OUTPUTS, Output
from geometry.ground.argument_checks import check_choice, check_range, check_unused
from geometry.ground.refusal import Field
from geometry.ground.typed import Array
from localize.decoders.frame_covariance import check_noise
from localize.decoders.hand_motion import ACCELERATIONS
from localize.live.stream_options import StreamOptions
from localize.signals.array_facts import ArrayFacts
from localize.signals.disturbances import check_sound_level
from localize.signals.noise_model import NoiseChoice

LibrarySource: TypeAlias = str | os.PathLike[str] | Library
"""A library, or the path of its file."""


@dataclass(frozen=True)
class Decoding:
    """Options of :func:`localize.open_model`: how a model is opened, and what it reports besides the point."""

    microphone_noise: NoiseChoice = "design"
    """For a library: noise of the microphones, white, Pa rms over 0 to 500 Hz, or "design"."""
    library: LibrarySource | None = None
    """Library of the array, for a network or graph; by default the model, where that is one."""
    waveform: bool = False
    """True if the pressure in the touched cavity is reconstructed."""
    ambient: float | None = None
    """Level of sound in the room up to which touches are named in it, dB SPL; None for a quiet room."""
    rejected_fraction: float | None = None
    """Fraction of the frames of true touches that may be rejected with those that no single point explains; None to
    name the likeliest point."""
    air: LocalAir | None = None
    """Air of the place, to which a library is brought; None for that of the library."""
    follow_drift: bool = False
    """True if the stiffness of a calibrated sensor is followed over the touches."""
    tolerances: bool = True
    """True if a computed library is decoded with manufacturing tolerances."""
    microphone_output: Output = "pressure"
    """Content of the signals that are read or listened to: pressures in front of the microphones, or ``voltage``, the
    outputs of microphones that nobody has equalised."""
    lowest: float | None = None
    """Frequency down to which outputs are equalised to pressures, Hz; None for 1 Hz, and 0.2 Hz for a pulse."""
    two_touches: bool = False
    """True if each contact is searched for two touches at once."""
    motion: float | None = None
    """Largest acceleration of the sensor in use, gravity left out, m/s^2; None for a sensor that lies still."""

    def __post_init__(self) -> None:
        checked_air(self.air)
        check_noise(self.microphone_noise, "microphone_noise")
        check_sound_level(self.ambient)
        if self.motion is not None:
            check_range("motion", self.motion, *ACCELERATIONS, "m/s2")
        check_choice("microphone_output", self.microphone_output, OUTPUTS)
        if self.lowest is not None:
            check_range("lowest", self.lowest, *LOWEST_RANGE, "Hz")
            if self.microphone_output == "pressure":
                why = ": signals that are pressures are not equalised"
                remedy = ("leave it out, or give ", Field("microphone_output"), " voltage")
                check_unused({"lowest": self.lowest}, why, remedy, unit="Hz")
        if self.rejected_fraction is not None:
            StreamOptions(rejected_fraction=self.rejected_fraction)  # which knows the range

    def equaliser(self, array: ArrayFacts, usual: float = LOWEST) -> Equaliser | None:
        """Filter from the outputs of an array's microphones to pressures, new; None where signals are pressures.

        Args:
            array: facts of the array.
            usual: lowest frequency if :attr:`lowest` is not given, Hz.

        Raises:
            Refusal: an array whose design is not known.
        """
        if self.microphone_output == "pressure":
            return None
        return array.equaliser(usual if self.lowest is None else self.lowest)

    def pressures(self, signals: Array, array: ArrayFacts, usual: float = LOWEST) -> Array:
        """Pressures in front of the microphones of an array, from a whole recording.

        Args:
            signals: (n_microphone, n_sample) float64, Pa at 1 kHz, as they were read.
            array: facts of the array.
            usual: lowest frequency if :attr:`lowest` is not given, Hz.

        Raises:
            Refusal: outputs of an array whose design is not known.
        """
        equaliser = self.equaliser(array, usual)
        return signals if equaliser is None else equaliser.begin(signals)
