"""One rule applied to one part: what was measured, the limit, the place, the verdict."""

from __future__ import annotations

from dataclasses import dataclass, replace

from geometry.schema.print_processes import Relation, Rule, Verdict

#: Names of the rules on layers that hang in the air.
_HANGING = ("islands", "widest overhang", "reach of overhang")


@dataclass(frozen=True)
class Finding:
    """One rule applied to one part."""

    part: str
    """Name of the part."""
    rule: str
    """Name of the rule."""
    value: float
    """The measured value, in ``unit``."""
    limit: float
    """Limit of the value, in ``unit``."""
    unit: str
    """Unit of value and limit."""
    verdict: Verdict
    """How the value stands to the rule."""
    reason: str
    """Source of the limit, or a remark on the measure."""
    place: tuple[float, float, float] | None = None
    """Place of the worst spot, in the part's own coordinates, mm; None where the rule has no one place."""
    relation: Relation = "at least"
    """How the value must stand to the limit."""

    @property
    def needs_support(self) -> bool:
        """True if a layer of the part hangs in the air more than is advised without supports."""
        return self.verdict != "ok" and self.rule in _HANGING


def by_rule(
    part: str, name: str, value: float, unit: str, rule: Rule, place: tuple[float, float, float] | None
) -> Finding:
    """Finding of a measure by a rule; its limit is what it fails by, or what is advised."""
    verdict = rule.verdict(value)
    limit = rule.limit if verdict == "fail" else rule.advised
    return Finding(part, name, value, limit, unit, verdict, rule.source, place, rule.relation)


def with_note(finding: Finding, note: str) -> Finding:
    """Finding with a remark added to its reason."""
    return replace(finding, reason=f"{finding.reason}; {note}")
