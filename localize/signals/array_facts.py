"""Facts of one array that a localizer keeps, so that its results can be read and compared with a library."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from acoustic_fem.library.transfer_functions import MEASURED
from acoustic_fem.network.microphone_output import Equaliser
from acoustic_fem.quantities.local_air import design_air
from acoustic_fem.quantities.medium import Medium
from acoustic_fem.quantities.microphone_signals import LOWEST
from geometry.design.design_file import read_design
from geometry.ground.refusal import Kind, Refusal
from localize.signals.stimulus import SAMPLE_RATE


@dataclass(frozen=True, eq=False)
class ArrayFacts:
    """Facts of one array that a localizer keeps, so that its results can be read and compared with a library."""

    design: str
    """Name of the design."""
    microphones: tuple[str, ...]
    """Names of the microphones, in the order of the signals."""
    line: NDArray[np.int64]
    """Line of each point, as the library numbers it; (n_point,) int64."""
    place: NDArray[np.int64]
    """Place of each point along its line, as the library numbers it; (n_point,) int64."""
    provenance: Mapping[str, Any] = field(default_factory=dict, repr=False)
    """Design, fidelity, air, frequencies and versions."""
    noise_rms: float = 0.0
    """Noise of a microphone that the localizer was made for, Pa rms over 0 to 500 Hz; 0 where none was given."""

    @property
    def point_count(self) -> int:
        """Number of sensing points."""
        return len(self.line)

    def equaliser(self, lowest: float = LOWEST) -> Equaliser:
        """Filter from the outputs of the array's microphones, at 1 kHz, to the pressures in front of them.

        Args:
            lowest: frequency down to which signals are equalised, Hz.

        Raises:
            Refusal: an array whose design is not known, or a frequency out of range.
        """
        design = self.provenance.get("design")
        if not design:
            raise Refusal(
                "of this array is not known, so its microphones cannot be equalised",
                kind=Kind.MISSING,
                field="design",
                remedy="equalise the recordings before, or give a library that has a design",
            )
        stated = read_design(design)
        air = Medium(**self.provenance["medium"]) if "medium" in self.provenance else design_air(stated)
        return Equaliser(stated.microphone, air, SAMPLE_RATE, lowest)

    @property
    def assumptions(self) -> str:
        """Assumptions of a decoder without tolerances about the sensor, in words."""
        if self.provenance.get("fidelity", MEASURED) == MEASURED:
            return f"that the sensor is as its library describes it{self.in_air}"
        return f"that the sensor is exactly as it was designed{self.in_air}, without manufacturing tolerances"

    @property
    def in_air(self) -> str:
        """Air of the library, in words that follow others; empty where it is not known."""
        medium = self.provenance.get("medium")
        return f", in air of {medium['pressure'] / 1e3:.1f} kPa" if medium else ""
