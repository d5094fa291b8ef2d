"""Numbers of a diagnosis, with their units and where they come from."""

from __future__ import annotations

from dataclasses import dataclass

from acoustic_fem.scatter.tolerances import UNCALIBRATED, Tolerance


@dataclass(frozen=True)
class DiagnosisOptions:
    """Numbers that tune a diagnosis."""

    tolerances: tuple[Tolerance, ...] = UNCALIBRATED
    """Scatter of manufacturing, which does not count as a fault."""
    calibrated_fraction: float = 0.3
    """Fraction of that scatter by which a sensor may have changed since its library was measured."""
    pressure: float = 5e3
    """Standard deviation of the static pressure about that of the library, Pa."""
    temperature: float = 7.0
    """Standard deviation of the temperature about that of the library, K."""
    slope: float = 0.6
    """Standard deviation of the exponent of the rubber's modulus over that of its material, a ratio."""
    band: tuple[float, float] = (3.0, 95.0)
    """Lowest and highest frequency that is compared, Hz."""
    frequencies: int = 48
    """Number of frequencies in the band, evenly spread on a logarithmic scale, before they are rounded to whole Hz."""
    mains: tuple[float, ...] = (49.0, 50.0, 51.0, 59.0, 60.0, 61.0)
    """Frequencies that are left out because of mains hum, Hz."""
    mismatch: float = 0.02
    """Fraction of a microphone's signal, in amplitude, that even the correct sensor does not explain: fidelity, lengths
    of tubes, the end of a window."""
    first_mismatches: tuple[float, ...] = (0.3, 0.15, 0.08, 0.04)
    """The same in the first steps of a fit, in which points may still be wrong."""
    first_stiffness: tuple[float, ...] = (-1.5, 0.0, 1.5)
    """Deviations of the modulus of all membranes that a fit begins with, standard deviations: a softer sensor and one
    whose points are one place off look alike."""
    candidates: int = 6
    """Number of parts whose fault is fitted with care, beside microphones."""
    amounts: int = 2
    """Number of amounts of the fault of a part, the likeliest ones, from which its fit begins."""
    assigned_mismatch: float = 0.1
    """The mismatch with which all touches are assigned to points together."""
    assignments: int = 8
    """Number of assignments of the touches so far that are kept while the next touch is assigned."""
    leading: int = 1
    """Number of fits whose points the others try."""
    moves: int = 2
    """Largest number of times in a row that the points of the best fits are moved by one place along their lines."""
    begun: int = 1
    """Number of such points, the likeliest after two steps, from which a fit begins anew."""
    moved: int = 3
    """Number of fits whose points are moved, beside that of the sound sensor."""
    refinements: int = 2
    """Number of times that derivatives are computed anew about the deviations that were found."""
    converged: float = 0.8
    """Mean square of the residual over the expected one, above which there are twice as many refinements."""
    refined: int = 3
    """Number of faults whose derivatives are computed anew."""
    hopeless: float = 5e3
    """Lag behind the best fault, nats, from which on a fault is not refined."""
    believed: float = 150.0
    """Gain in log-likelihood over a sound sensor, nats, from which on a fault is believed."""
    apart: float = 10.0
    """Lead in log-likelihood, nats, within which two faults are not distinguished."""
    evidence_temperature: float = 3.4
    """Divisor of the evidence, in nats, where it becomes a probability: two faults that lie :attr:`apart` then have
    odds of 19 to 1."""
    explained: float = 5.0
    """Mean square of the residual over the expected one, above which no hypothesis explains the touches."""
    widened: float = 1.4
    """Factor by which the errors of as-built parameters are larger than an exact model says: on eight virtual rigs,
    errors of moduli were 1.4 times as large and those of bores 1.2 times."""
    measured: float = 0.7
    """Error of an as-built parameter over its tolerance, below which the touches have measured it."""
    unmatched: int = 2
    """Largest difference between the numbers of stated points and of found touches that is tolerated."""
    matched: float = 0.99
    """Probability above which a touch is assigned one of the stated points, if these numbers differ. Otherwise its
    point counts as unknown."""
    fewest: int = 6
    """Least number of touches."""
