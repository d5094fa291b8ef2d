"""Result of a comparison: fields, figures and curves of several subjects side by side."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import groupby
from typing import TYPE_CHECKING, Any

from geometry.ground.shown import Shown
from studies.comparison.compared_rows import ComparedFigure, DifferingField
from studies.comparison.level_curves import LevelCurves, ResponseDifference, draw_levels
from studies.comparison.quantities import OVERVIEW
from studies.comparison.subjects import Subject

if TYPE_CHECKING:
    import pandas as pd
    from matplotlib.figure import Figure


@dataclass(frozen=True, eq=False, repr=False)
class Comparison(Shown):
    """Comparison of several designs, runs, libraries or cases."""

    subjects: tuple[Subject, ...]
    """Subjects in the order of their columns."""
    fields: tuple[DifferingField, ...]
    """Fields of the designs that differ; name and description are left out."""
    figures: tuple[ComparedFigure, ...]
    """Figures side by side, those that a designer asks first at the beginning."""
    curves: tuple[LevelCurves, ...]
    """Level curves of each subject."""
    differences: tuple[ResponseDifference, ...]
    """Largest differences of the transfer functions of each other subject from those of the first."""

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the subjects."""
        return tuple(each.name for each in self.subjects)

    @property
    def groups(self) -> dict[str, tuple[ComparedFigure, ...]]:
        """Figures that some subject has, by the title of their group."""
        known = [each for each in self.figures if any(value is not None for value in each.values)]
        return {name: tuple(rows) for name, rows in groupby(known, lambda row: row.quantity.group)}

    @property
    def verdicts(self) -> tuple[tuple[str, str], ...]:
        """Outcome of the verdict on each subject, and the rule that it breaks worst in words; empty where not known."""
        rows = {each.quantity.name: each.values for each in self.figures}
        nothing = (None,) * len(self.subjects)
        pairs = zip(rows.get("verdict", nothing), rows.get("reason", nothing), strict=True)
        return tuple((str(outcome or ""), str(reason or "")) for outcome, reason in pairs)

    @property
    def mark(self) -> str:
        """Word that marks a better value: "better" of two subjects, "best" of more."""
        return "better" if len(self.subjects) == 2 else "best"

    @property
    def notes(self) -> tuple[str, ...]:
        """Notes on figures and curves that are not compared, each with the reason."""
        return (*_of_reasons(self), *_of_models(self), *_of_differences(self))

    def shown(self) -> tuple[str, Mapping[str, object]]:
        """Title and facts that a session and a notebook show."""
        facts: dict[str, object] = {"fields that differ": ", ".join(each.name for each in self.fields) or "none"}
        for row in self.groups.get(OVERVIEW, ()):
            facts[row.quantity.title] = " | ".join(_marked(row, self.mark))
        return f"Comparison of {', '.join(self.names)}", facts

    def plot(self) -> Figure:
        """Figure of the levels of the strongest and the weakest point of each subject, over each other.

        Raises:
            MissingExtra: matplotlib is not installed.
        """
        return draw_levels(self.curves)

    def to_dataframe(self) -> pd.DataFrame:
        """Table with a row for each field that differs and each figure, and a column for each subject.

        The index is the name of the field or figure. Further columns are ``title``, ``group`` ("Fields" for fields),
        ``unit``, and ``better``, the names of the better subjects. Accuracies are fractions.
        """
        import pandas as pd

        rows: list[dict[str, Any]] = [
            {"name": each.name, "title": each.name, "group": "Fields", "unit": each.unit,
             **dict(zip(self.names, each.values, strict=True)), "better": ""}
            for each in self.fields
        ]  # fmt: skip
        rows += [
            {"name": each.quantity.name, "title": each.quantity.title, "group": each.quantity.group,
             "unit": each.quantity.unit, **dict(zip(self.names, each.values, strict=True)),
             "better": ", ".join(self.names[place] for place in each.best)}
            for each in self.figures
        ]  # fmt: skip
        return pd.DataFrame(rows).set_index("name")

    def to_dict(self) -> dict[str, Any]:
        """Comparison as JSON can hold it, with values in the units that it states."""
        return {
            "program": "acoustic-fem compare",
            "subjects": [
                {"name": each.name, "kind": each.kind, "source": each.source, "design": each.design.name}
                for each in self.subjects
            ],
            "fields": [{"name": each.name, "unit": each.unit, "values": list(each.values)} for each in self.fields],
            "figures": [each.to_dict() for each in self.figures],
            "curves": [each.to_dict() for each in self.curves],
            "transfer_function_differences": [each.to_dict() for each in self.differences],
            "notes": list(self.notes),
        }


def _marked(row: ComparedFigure, word: str) -> list[str]:
    """Cells of a row, the better ones marked by a word."""
    return [f"{text} {word}" if place in row.best else text or "-" for place, text in enumerate(row.written)]


def _of_reasons(found: Comparison) -> Iterator[str]:
    """Lines on figures that some subject does not have: the subjects, the figures and the reason."""
    grouped: dict[tuple[str, str], list[str]] = {}
    for row in found.figures:
        for name, why in zip(found.names, row.reasons, strict=True):
            if why:
                grouped.setdefault((name, why), []).append(row.quantity.title)
    merged: dict[tuple[str, tuple[str, ...]], list[str]] = {}
    for (name, why), titles in grouped.items():
        merged.setdefault((why, tuple(titles)), []).append(name)
    for (why, quantities), names in merged.items():
        yield f"{', '.join(names)}: {', '.join(quantities)} not known, because {why}"


def _of_models(found: Comparison) -> Iterator[str]:
    """Line on subjects whose transfer functions come from different models."""
    row = next((each for each in found.figures if each.quantity.name == "fidelity"), None)
    models = [] if row is None else [str(value).partition(":")[0] for value in row.values]
    if len(set(models)) > 1:
        whose = ", ".join(f"{name} {model}" for name, model in zip(found.names, models, strict=True))
        yield f"transfer functions come from different models ({whose}), so small differences of figures may be theirs"


def _of_differences(found: Comparison) -> Iterator[str]:
    """Lines on transfer functions that are not compared with those of the first subject."""
    for each in found.differences:
        if each.why:
            yield f"{each.name}: transfer functions are not compared with those of {found.names[0]}, because {each.why}"
