"""Results of a diagnosis of many sensors: one for each recording, held against the limits of a production."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal, TypeAlias

from localize.diagnosis.as_built_estimates import AsBuiltEstimate
from localize.diagnosis.faults import SensorFault
from localize.diagnosis.production_limits import ProductionLimits

#: Outcomes for a sensor, as :attr:`DiagnosedSensor.result` has them.
Result: TypeAlias = Literal["pass", "fail", "no diagnosis"]


@dataclass(frozen=True, eq=False)
class DiagnosedSensor:
    """Diagnosis of one sensor of many."""

    sensor: str
    """Name of the sensor: that of its recording without the suffix."""
    recording: Path
    """Recording of its touches."""
    found: Mapping[str, Any] = field(default_factory=dict)
    """Diagnosis as :meth:`localize.diagnosis.Diagnosis.summary` has it; empty if there is none."""
    problem: str = ""
    """Reason why there is no diagnosis; empty if there is one."""
    objections: tuple[str, ...] = ()
    """Reasons why the sensor fails."""

    @property
    def result(self) -> Result:
        """Outcome against the limits."""
        return "no diagnosis" if self.problem else "fail" if self.objections else "pass"

    @property
    def verdict(self) -> str:
        """Verdict of the diagnosis; empty if there is none."""
        return str(self.found.get("verdict", ""))

    @property
    def text(self) -> str:
        """Finding as a sentence, or the reason why there is none."""
        return self.problem or str(self.found["text"])

    @property
    def matching(self) -> str:
        """Sentence about stated points whose touches were missed or doubled; empty if there are none."""
        return str(self.found.get("matching", ""))

    @property
    def reasons(self) -> tuple[str, ...]:
        """Reasons why the sensor does not pass, that of a missing diagnosis among them."""
        return (self.problem,) if self.problem else self.objections

    @property
    def probability(self) -> float | None:
        """Probability that the verdict is right; None if there is no verdict or if nothing explains the touches."""
        value = self.found.get("probability")
        return None if value is None else float(value)

    @property
    def faults(self) -> tuple[SensorFault, ...]:
        """Faults of the diagnosis, the likeliest first."""
        return tuple(
            SensorFault(each["kind"], tuple(each["part"]), each["amount"]) for each in self.found.get("faults", ())
        )

    @property
    def fault_names(self) -> tuple[str, ...]:
        """Faults of the diagnosis as clauses, in their order."""
        return tuple(each["text"] for each in self.found.get("faults", ()))

    @property
    def parameters(self) -> tuple[AsBuiltEstimate, ...]:
        """As-built parameters with 95 % intervals."""
        return tuple(AsBuiltEstimate(**each) for each in self.found.get("parameters", ()))

    @property
    def batch_modulus(self) -> AsBuiltEstimate | None:
        """Modulus of all membranes against that of the library; None if there is no diagnosis."""
        return next((each for each in self.parameters if each.quantity == "modulus_of_batch"), None)

    @property
    def touches(self) -> int:
        """Number of touches."""
        return len(self.found.get("touches", ()))

    def judged(self, limits: ProductionLimits) -> tuple[str, ...]:
        """Reasons why the sensor fails by some limits."""
        if self.problem:
            return ()
        return limits.objections(self.found["verdict"], self.faults, self.parameters, self.touches)

    def summary(self) -> dict[str, Any]:
        """Figures of the sensor as plain values, for a file of JSON."""
        return {
            "sensor": self.sensor,
            "recording": self.recording.name,
            "result": self.result,
            "reasons": list(self.reasons),
            "diagnosis": dict(self.found) or None,
        }


@dataclass(frozen=True, eq=False)
class BatchDiagnosis:
    """Diagnoses of many sensors of one design."""

    design: str
    """Name of the design."""
    sensors: tuple[DiagnosedSensor, ...]
    """The sensors in the order of their names."""
    limits: ProductionLimits
    """Limits within which a sensor passes."""
    folder: Path
    """Folder of the results."""

    @property
    def page(self) -> Path:
        """Page of the results, HTML."""
        return self.folder / "report.html"

    @property
    def counts(self) -> dict[Result, int]:
        """Number of sensors with each result."""
        found = Counter(each.result for each in self.sensors)
        results: tuple[Result, ...] = ("pass", "fail", "no diagnosis")
        return {result: found[result] for result in results}

    @property
    def passed(self) -> bool:
        """True if every sensor passes."""
        return self.counts["pass"] == len(self.sensors)

    @property
    def frequent_faults(self) -> list[tuple[str, int]]:
        """Faults that fail sensors with the number of these sensors, the most frequent first: a step of the
        production goes wrong where one part fails often. Each of several faults
        that cannot be told apart counts.
        """
        found = Counter(name for each in self.sensors if each.result == "fail" for name in each.fault_names)
        return found.most_common()
