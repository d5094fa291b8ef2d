"""Rows of a comparison: fields of designs that differ, and figures with the better subject marked."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from geometry.design.array_design import ArrayDesign
from geometry.design.field_values import declared_at, field_values, place_in_file
from geometry.schema.materials import MATERIALS
from studies.comparison.own_figures import OwnFigure
from studies.comparison.quantities import Quantity, Value, in_order, quantity_named
from studies.output.display import number

#: Fields that say what a design is called: columns have its name already.
_NAMES = ("name", "description")
#: Longest list of a field that is written whole.
_LONGEST = 60


@dataclass(frozen=True)
class DifferingField:
    """Field that not all designs have alike."""

    name: str
    """Dotted name of the field."""
    unit: str
    """Unit of the values; empty if it is dimensionless."""
    values: tuple[Any, ...]
    """Value of each design; None where the design does not have the field."""

    @property
    def written(self) -> tuple[str, ...]:
        """Values as people read them, with the unit; a dash where a design does not have the field."""
        return tuple(_written(value, self.unit) for value in self.values)


@dataclass(frozen=True)
class ComparedFigure:
    """Figure of all subjects side by side."""

    quantity: Quantity
    """Quantity of the row."""
    values: tuple[Value | None, ...]
    """Value of each subject in the unit of the quantity; None where it is not known."""
    remarks: tuple[str, ...]
    """Remark on each value, such as the accuracy of the worst sensor; may be empty."""
    reasons: tuple[str, ...]
    """Reason why a value is not known; empty where it is known, or where the quantity does not apply."""

    @property
    def best(self) -> tuple[int, ...]:
        """Places of the subjects that are better than the others, from 0; none if there is no better one."""
        return self.quantity.best(self.values)

    @property
    def written(self) -> tuple[str, ...]:
        """Values as people read them, each with its remark; empty where not known."""
        texts = self.quantity.written(self.values)
        return tuple(
            f"{text} ({remark})" if text and remark else text for text, remark in zip(texts, self.remarks, strict=True)
        )

    def to_dict(self) -> dict[str, Any]:
        """Figure as JSON can hold it."""
        own = self.quantity
        return {
            "name": own.name,
            "title": own.title,
            "group": own.group,
            "unit": own.unit,
            "wanted": own.better or list(own.order),
            "definition": own.definition,
            "values": list(self.values),
            "remarks": list(self.remarks),
            "reasons": list(self.reasons),
            "better": list(self.best),
        }


def differing_fields(designs: Sequence[ArrayDesign]) -> tuple[DifferingField, ...]:
    """Fields that not all designs have alike, in the order of a design file. Name and description are left out.

    Args:
        designs: at least two.
    """
    values = [field_values(_with_own_materials(design)) for design in designs]
    names = {name for own in values for name in own if name not in _NAMES}
    rows = {name: tuple(own.get(name) for own in values) for name in sorted(names, key=place_in_file)}
    return tuple(
        DifferingField(name, declared_at(name).unit, row)
        for name, row in rows.items()
        if any(value != row[0] for value in row[1:])
    )


def _with_own_materials(design: ArrayDesign) -> ArrayDesign:
    """The design without the built-in materials, which the design of a result states and that of a user does not."""
    own = {key: value for key, value in design.materials.items() if MATERIALS.get(key) != value}
    return design.model_copy(update={"materials": own})


def compared_figures(figures: Sequence[Mapping[str, OwnFigure]]) -> tuple[ComparedFigure, ...]:
    """Rows of figures in the order of a table, from the figures of each subject by name.

    A subject without a figure of that name has an unknown value without a reason.

    Args:
        figures: of each subject, by name of quantity.
    """
    rows = []
    missing = OwnFigure(None)
    for name in in_order(name for own in figures for name in own):
        found = [own.get(name, missing) for own in figures]
        rows.append(
            ComparedFigure(
                quantity_named(name),
                tuple(each.value for each in found),
                tuple(each.remark for each in found),
                tuple(each.why for each in found),
            )
        )
    return tuple(rows)


def _written(value: Any, unit: str) -> str:
    unit = unit.replace("^3", "\N{SUPERSCRIPT THREE}")
    match value:
        case None:
            return "\N{EN DASH}"
        case bool():
            return "true" if value else "false"
        case int() | float():
            text = number(value) if float(f"{value:.3g}") == value else f"{value:.6g}"
            return f"{text} {unit}".rstrip()
        case list():
            text = ", ".join(_written(each, "") for each in value)
            return f"{text if len(text) <= _LONGEST else f'{text[: _LONGEST - 3]}...'} {unit}".rstrip()
    return str(value)
