"""Limits of a production: what a diagnosed sensor may have and still pass, as a file of TOML.

::

    touches = 20                  # at least
    leak = 0.15                   # mm, diameter of the largest hole
    blocked_tube = 0.7            # smallest bore, over that of the design
    quiet_microphone = 3.0        # dB, largest lack of level
    [parameters.modulus_of_batch] # interval of the quantity of every part
    low = 0.8
    high = 1.25
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Annotated

from pydantic import BaseModel, ConfigDict, Field

from geometry.ground.argument_checks import check_choice, check_range
from geometry.ground.refusal import Refusal, counted
from geometry.ground.text_files import read_toml
from geometry.schema.field_errors import model_of
from localize.diagnosis.as_built_estimates import AsBuiltEstimate
from localize.diagnosis.diagnosis import Verdict
from localize.diagnosis.diagnosis_options import DiagnosisOptions
from localize.diagnosis.fault_libraries import AROUND, FITTED
from localize.diagnosis.faults import SensorFault

LIMITED = (*FITTED, *AROUND)
"""Names of the as-built parameters that a limit can be for."""

_Number = Annotated[float, Field(allow_inf_nan=False)]


class LimitsError(Refusal):
    """A file of limits that cannot be used: one line that names the file, the field and the reason."""


class _Interval(BaseModel):
    model_config = ConfigDict(extra="forbid", strict=True)

    low: _Number
    high: _Number


class _File(BaseModel):
    model_config = ConfigDict(extra="forbid", strict=True)

    # Ranges and defaults are those of ProductionLimits.
    touches: int | None = None
    leak: _Number | None = None
    blocked_tube: _Number | None = None
    quiet_microphone: _Number | None = None
    parameters: dict[str, _Interval] = {}


@dataclass(frozen=True)
class ProductionLimits:
    """Limits within which a sensor passes; by default no fault does.

    Raises:
        Refusal: a limit out of its range, an unknown parameter, or an interval whose ends are exchanged.
    """

    touches: int = DiagnosisOptions.fewest
    """Least number of touches that a recording must have."""
    leak: float = 0.0
    """Diameter of the largest leak, mm."""
    blocked_tube: float = 1.0
    """Smallest bore of a tube over that of the design."""
    quiet_microphone: float = 0.0
    """Largest lack of level of a microphone, dB."""
    parameters: Mapping[str, tuple[float, float]] = field(default_factory=dict)
    """Lowest and highest value of an as-built parameter by its name, one of :data:`LIMITED`, in the unit of
    :class:`AsBuiltEstimate`; they hold for every part."""

    def __post_init__(self) -> None:
        check_range("touches", self.touches, DiagnosisOptions.fewest, 1000, whole=True)
        check_range("leak", self.leak, 0.0, 5.0, "mm")
        check_range("blocked_tube", self.blocked_tube, 0.02, 1.0)
        check_range("quiet_microphone", self.quiet_microphone, 0.0, 120.0, "dB")
        for name, (low, high) in self.parameters.items():
            check_choice("parameters", name, LIMITED)
            check_range(f"parameters.{name}.low", low, high=high, why="the high end of the interval")

    def objections(
        self, verdict: Verdict, faults: Sequence[SensorFault], parameters: Iterable[AsBuiltEstimate], touches: int
    ) -> tuple[str, ...]:
        """Reasons why a sensor fails, as clauses; none if it passes.

        A fault passes if its amount is within the limit. If one of several faults is there, all of them must be. A
        parameter fails if its whole 95 % interval lies outside of the limits.

        Args:
            verdict: of the diagnosis.
            faults: of the diagnosis.
            parameters: of the diagnosis.
            touches: number of touches.
        """
        found = []
        if touches < self.touches:
            found.append(f"{counted(touches, 'touch')} are fewer than the {self.touches} that are required")
        if verdict == "unexplained":
            found.append("no single fault explains the touches")
        else:
            found += list(dict.fromkeys(self._of_fault(each) for each in faults if not self._passes(each)))
        for each in parameters:
            if each.quantity in self.parameters:
                low, high = self.parameters[each.quantity]
                if each.high < low or each.low > high:
                    found.append(
                        f"{each.quantity} of {each.part} is {each.value:.4g} ({each.low:.4g} to {each.high:.4g}), not "
                        f"{low:g} to {high:g}"
                    )
        return tuple(found)

    def _passes(self, fault: SensorFault) -> bool:
        if fault.kind == "leak":
            return fault.amount <= self.leak
        if fault.kind == "blocked tube":
            return fault.amount >= self.blocked_tube
        return fault.kind == "quiet microphone" and -fault.amount <= self.quiet_microphone

    def _of_fault(self, fault: SensorFault) -> str:
        """Clause about a fault beyond its limit."""
        if fault.kind == "leak":
            return f"a leak of {fault.amount:.2g} mm is more than {self.leak:g} mm"
        if fault.kind == "blocked tube":
            return f"a bore of {fault.amount:.2g} of the design's is less than {self.blocked_tube:g}"
        if fault.kind == "quiet microphone":
            return f"a microphone {-fault.amount:.0f} dB too quiet is more than {self.quiet_microphone:g} dB off"
        return f"a fault of the kind {fault.kind!r} never passes"


def read_limits(path: Path) -> ProductionLimits:
    """Limits of a file.

    Raises:
        LimitsError: it cannot be read, is not TOML, holds an unknown field or parameter, or a value out of range.
    """
    file = model_of(_File, read_toml(path, "a file of limits", LimitsError), str(path), "file of limits", LimitsError)
    given = file.model_dump(exclude_unset=True, exclude={"parameters"})
    parameters = {name: (each.low, each.high) for name, each in file.parameters.items()}
    try:
        return ProductionLimits(**given, parameters=parameters)
    except Refusal as error:
        raise LimitsError.of(error, file=path) from None


def limits_of(given: ProductionLimits | str | Path | None) -> ProductionLimits:
    """Limits as a caller gives them: themselves, the path of a file, or None for the default ones."""
    if given is None:
        return ProductionLimits()
    return given if isinstance(given, ProductionLimits) else read_limits(Path(given))
