"""The published rig: a tube wound on a cylinder, by 3-D finite elements of the bent bore."""

from __future__ import annotations

import numpy as np

from benchmarks.verification.report import Check, Subject, Table
from studies.bending import BendingRig, solve_bending

TEXT = """In the rig of the publication, {length:g} mm of tube with a bore of {bore:g} mm are wound on a cylinder of
{diameter:g} mm. A quarter turn changes the transfer admittance of the wound part. This change is compared with that of
an independent 3-D program. The target is the last digit of that program."""

#: Frequency (Hz) -> change of the transfer admittance of a quarter turn by an independent solver (physics of the bend).
_OTHER = {1.0: 4e-5, 100.0: 1.3e-4}


def run(_: bool) -> Subject:
    """Largest differences over the angles; the full page only."""
    rig, frequency = BendingRig(), np.array([1.0, 10.0, 100.0])
    result = solve_bending(rig, frequency)
    quarter = list(rig.angles).index(90)
    rows = [
        (f"{angle:g}°", f"{level:.1e}", f"{phase:.1e}", *(f"{change:.2e}" for change in np.abs(changes)))
        for angle, (level, phase), changes in zip(
            rig.angles, result.largest_differences, result.bend_change, strict=True
        )
    ]
    header = ("wound", "level, dB", "phase, °", *(f"Y₁₂ at {f:g} Hz" for f in frequency))
    checks = [
        Check(
            f"bend {f:g}", f"change of Y₁₂ by a quarter turn, {f:g} Hz", f"{100 * other:g} % by an independent solver",
            float(abs(abs(result.bend_change[quarter, list(frequency).index(f)]) - other)), 1e-5,
        )
        for f, other in _OTHER.items()
    ]  # fmt: skip
    text = TEXT.format(length=rig.length, bore=rig.bore, diameter=rig.diameter)
    table = Table("Largest change from the straight tube", header, tuple(rows), detail=True)
    return Subject("bends", "Bends", text, (), tuple(checks), (table,))
