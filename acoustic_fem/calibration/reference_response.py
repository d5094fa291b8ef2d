"""Response of the calibration microphone, from the table that comes with it: what it adds is taken out."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from acoustic_fem.sound.recorded_table import read_table
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array, ComplexArray

COLUMNS = ("frequency", "dB", "degrees")


class ResponseError(Refusal):
    """Refusal of a microphone's response that cannot be used: one line that names the file and the reason."""


@dataclass(frozen=True, eq=False)
class ReferenceResponse:
    """Signal of the calibration microphone over the pressure at it, against the sensitivity that the manifest gives."""

    path: Path
    """File that it was read from."""
    frequency: Array
    """Frequencies, ascending; (n,) float64, Hz."""
    level: Array
    """Level of the response; (n,) float64, dB."""
    phase: Array
    """Phase of the response, without steps of a whole turn; (n,) float64, rad."""

    def at(self, frequency: Array) -> ComplexArray:
        """Response at some frequencies, interpolated over the logarithm of the frequency.

        Args:
            frequency: (n,) float64, Hz.

        Returns:
            (n,) complex128, 1.

        Raises:
            ResponseError: frequencies beyond those of the file.
        """
        low, high = float(frequency.min()), float(frequency.max())
        if low < self.frequency[0] or high > self.frequency[-1]:
            raise ResponseError(
                f"covers {self.frequency[0]:g} to {self.frequency[-1]:g} Hz; it must cover {low:g} to {high:g} Hz, the "
                "frequencies of the calibration",
                kind=Kind.OUT_OF_RANGE,
                file=self.path,
                field=COLUMNS[0],
            )
        at, known = np.log(frequency), np.log(self.frequency)
        level, phase = np.interp(at, known, self.level), np.interp(at, known, self.phase)
        return np.asarray(10 ** (level / 20) * np.exp(1j * phase))


def read_response(path: Path) -> ReferenceResponse:
    """Response of a microphone from a table with the columns ``frequency`` (Hz), ``dB`` and ``degrees``.

    Args:
        path: of a CSV file, with separators and decimals as of :mod:`acoustic_fem.sound.recorded_table`.

    Raises:
        ResponseError: it cannot be read, lacks a column, has fewer than two rows, values that are not finite, or
            frequencies that do not rise from above 0.
    """
    table = read_table(path, ResponseError)
    by_name = {name.lower(): column for name, column in zip(table.names, table.columns.T, strict=True)}
    for name in COLUMNS:
        if name.lower() not in by_name:
            problem = f"is missing; the file has {', '.join(table.names)}"
            raise ResponseError(problem, kind=Kind.MISSING, file=path, field=name)
    frequency, level, degrees = (by_name[name.lower()] for name in COLUMNS)
    if len(frequency) < 2:
        raise ResponseError("must have at least 2 rows", kind=Kind.UNSUITABLE, file=path)
    for name, values in zip(COLUMNS, (frequency, level, degrees), strict=True):
        if not np.isfinite(values).all():
            raise ResponseError("holds a value that is not finite", kind=Kind.OUT_OF_RANGE, file=path, field=name)
    if frequency[0] <= 0 or (np.diff(frequency) <= 0).any():
        raise ResponseError(
            "must rise from row to row, from above 0 Hz", kind=Kind.UNSUITABLE, file=path, field=COLUMNS[0]
        )
    return ReferenceResponse(path, frequency, level, np.unwrap(np.radians(degrees)))
