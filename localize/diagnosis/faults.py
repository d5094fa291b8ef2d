"""Single faults of a built sensor as data: what is broken, by how much, and what that does to its parts."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import combinations, pairwise
from typing import Literal, TypeAlias, get_args

import numpy as np

from acoustic_fem.batch.parameters import ArrayParameters
from acoustic_fem.duct.leak import leak_conductance
from acoustic_fem.quantities.local_air import AirLike
from acoustic_fem.quantities.units import metres
from geometry.design.array_design import ArrayDesign
from geometry.ground.argument_checks import check_choice, check_range
from geometry.ground.typed import Array, ComplexArray

FaultKind: TypeAlias = Literal[
    "blocked tube", "leak", "quiet microphone", "reversed microphone", "exchanged microphones"
]

AMOUNTS: dict[FaultKind, tuple[float, ...]] = {
    "blocked tube": (0.55, 0.4, 0.28, 0.1),
    "leak": (0.12, 0.2, 0.32, 0.6),
    "quiet microphone": (-6.0, -12.0, -20.0, -60.0),
    "reversed microphone": (0.0,),
    "exchanged microphones": (0.0,),
}
"""Amounts of each kind that are tried: bore over the designed bore; diameter of a hole to the outside, mm; level, dB.
The last level stands for a dead microphone."""
SPREAD: dict[FaultKind, float] = {"blocked tube": 0.22, "leak": 0.3, "quiet microphone": 0.35}
"""Standard deviation of the logarithm of an amount (of a level: of its dB) about each amount that is tried."""
RANGES: dict[FaultKind, tuple[float, float, str]] = {
    "blocked tube": (0.02, 1.0, ""),
    "leak": (0.0, 5.0, "mm"),
    "quiet microphone": (-120.0, 0.0, "dB"),
    "reversed microphone": (0.0, 0.0, ""),
    "exchanged microphones": (0.0, 0.0, ""),
}
"""Smallest and largest amount of each kind, and its unit."""
HOLE_LENGTH = 1.0
"""Length of the hole through which a cavity leaks, mm: the wall of a shell, or a glued rim."""
DEAD = -40.0
"""Level from which on a quiet microphone is called dead, dB."""


@dataclass(frozen=True)
class SensorFault:
    """Fault of one part of a sensor.

    Raises:
        Refusal: a kind that is not known, or an amount out of its range.
    """

    kind: FaultKind
    """Kind of the fault."""
    part: tuple[int, ...]
    """Number of the part from 1: the tube, line by line from the first microphone of each line; the point; the
    microphone, or two exchanged ones, in the order of the design."""
    amount: float = 0.0
    """Bore of a blocked tube over the designed bore; diameter of a leak, mm; level of a quiet microphone, dB; else
    0."""

    def __post_init__(self) -> None:
        check_choice("kind", self.kind, get_args(FaultKind))
        low, high, unit = RANGES[self.kind]
        check_range("amount", self.amount, low, high, unit)

    def same_part(self, other: SensorFault) -> bool:
        """True if the other fault is of the same kind and part, whatever its amount."""
        return (self.kind, self.part) == (other.kind, other.part)

    def with_amount(self, deviation: float) -> SensorFault:
        """Fault whose amount is so many standard deviations of :data:`SPREAD` larger; those without one stay."""
        if not deviation or self.kind not in SPREAD:
            return self
        low, high, _ = RANGES[self.kind]
        amount = self.amount * float(np.exp(SPREAD[self.kind] * deviation))
        return replace(self, amount=min(max(amount, low), high))

    def of_parts(self, parameters: ArrayParameters, air: AirLike) -> ArrayParameters:
        """Parameters of sensors with the fault; those of microphones stay.

        Args:
            parameters: of sensors without it, with a column for every part, as NumPy arrays.
            air: on its viscosity the flow through a leak depends.
        """
        own = np.arange(max(parameters.tube_radius.shape[1], parameters.leak_conductance.shape[1])) + 1 == self.part[0]
        if self.kind == "blocked tube":
            count = parameters.tube_radius.shape[1]
            return replace(parameters, tube_radius=parameters.tube_radius * np.where(own[:count], self.amount, 1.0))
        if self.kind == "leak":
            count = parameters.leak_conductance.shape[1]
            added = leak_conductance(metres(self.amount) / 2, metres(HOLE_LENGTH), air)
            return replace(parameters, leak_conductance=parameters.leak_conductance + added * own[:count])
        return parameters

    def of_microphones(self, transfer_function: ComplexArray) -> ComplexArray:
        """Transfer functions (..., n_microphone, n_freq) with the fault; those of other parts stay."""
        index = [number - 1 for number in self.part]
        found = transfer_function
        if self.kind in ("quiet microphone", "reversed microphone"):
            found = transfer_function.copy()
            found[..., index, :] *= -1 if self.kind == "reversed microphone" else 10 ** (self.amount / 20)
        elif self.kind == "exchanged microphones":
            found = transfer_function.copy()
            found[..., index, :] = transfer_function[..., index[::-1], :]
        return found

    def described(self, design: ArrayDesign) -> str:
        """Fault as a clause, such as "tube 6 (between points 5 and 6) is narrowed or blocked"."""
        if self.kind == "blocked tube":
            return f"{tube_name(design, self.part[0])} is narrowed or blocked"
        if self.kind == "leak":
            return f"point {self.part[0]} leaks"
        names = [design.microphones[number - 1] for number in self.part]
        if self.kind == "quiet microphone":
            how = "dead" if self.amount <= DEAD else f"about {-self.amount:.0f} dB too quiet"
            return f"microphone {names[0]} is {how}"
        if self.kind == "reversed microphone":
            # With two microphones only the sign of their ratio shows.
            either = " or ".join(design.microphones) if len(design.microphones) == 2 else names[0]
            return f"microphone {either} is reversed, so its signal has the wrong sign"
        return f"microphones {' and '.join(names)} are exchanged"


def single_faults(design: ArrayDesign) -> tuple[tuple[SensorFault, ...], ...]:
    """All single faults of a design that are looked for: for each part, its fault by the amounts of :data:`AMOUNTS`."""
    microphones = range(1, len(design.microphones) + 1)
    reversible = list(microphones)[: 1 if len(design.microphones) == 2 else None]
    parts: list[tuple[FaultKind, Sequence[tuple[int, ...]]]] = [
        ("blocked tube", [(number,) for number in range(1, len(tube_ends(design)) + 1)]),
        ("leak", [(number,) for number in range(1, design.point_count + 1)]),
        ("quiet microphone", [(number,) for number in microphones]),
        ("reversed microphone", [(number,) for number in reversible]),
        ("exchanged microphones", list(combinations(microphones, 2))),
    ]
    return tuple(
        tuple(SensorFault(kind, part, amount) for amount in AMOUNTS[kind]) for kind, each in parts for part in each
    )


def tube_ends(design: ArrayDesign) -> list[tuple[str, str]]:
    """Ends of every tube, such as ("microphone A", "point 1"), line by line from the first microphone of each."""
    found, start = [], 0
    for line in design.lines:
        points = [f"point {start + place + 1}" for place in range(line.points)]
        nodes = [f"microphone {line.between[0]}", *points, f"microphone {line.between[1]}"]
        found += list(pairwise(nodes))
        start += line.points
    return found


def tube_lines(design: ArrayDesign) -> list[int]:
    """Index of the line of every tube."""
    return [number for number, line in enumerate(design.lines) for _ in range(line.points + 1)]


def tube_name(design: ArrayDesign, number: int) -> str:
    """Name of a tube with its ends, such as "tube 6 (between points 5 and 6)"."""
    first, last = tube_ends(design)[number - 1]
    ends = f"points {first.split()[1]} and {last.split()[1]}" if first[0] == last[0] == "p" else f"{first} and {last}"
    return f"tube {number} (between {ends})"


def level(values: ComplexArray) -> Array:
    """Mean level of values (..., n_freq) over the frequencies, (...) float64, dB."""
    return np.asarray(10 * np.log10(np.maximum((np.abs(values) ** 2).mean(-1), 1e-30)))
