"""Tables of the fields of files, from the models that read them, of the metrics and of the rooms.

``{fields} SECTION``, or names of single fields, of a design file; ``{study-fields} study``, ``range`` or ``optimize``;
``{part-fields} KIND`` of a file of parts; ``{metrics}``; ``{rooms} PACKAGE``; ``{verdict-rules}``.
"""

from __future__ import annotations

from dataclasses import replace

from docutils import nodes
from make_architecture import read_rooms, room_table
from pydantic import BaseModel
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective

from geometry.design.array_design import ArrayDesign
from geometry.schema.declared_fields import DesignField, fields_of
from geometry.stock import (
    Glue,
    Logger,
    Resin,
    Sheet,
    Silicone,
    Sleeve,
    Spring,
    StockMicrophone,
    StockPart,
    Sundry,
    Tubing,
)
from studies.optimization.problem import OptimizeFields
from studies.study.fields import RangeFields, StudyFields
from studies.study.metric_registry import METRICS
from studies.verdict import rule_rows

#: What has the fields of ``[tube]`` all over again, as the page says.
_ALIKE = ("microphone_tube.", "lines.*.tube.", "lines.*.micro", "tube_kinds.")
#: Models of the sections of a study file.
_STUDY: dict[str, type[BaseModel]] = {"study": StudyFields, "range": RangeFields, "optimize": OptimizeFields}
#: Models of the parts of a file of parts.
_PARTS: dict[str, type[StockPart]] = {
    "part": StockPart,
    **{
        model.kind: model
        for model in (Spring, Sleeve, Tubing, Sheet, Silicone, Resin, Glue, Sundry, StockMicrophone, Logger)
    },
}
_HEAD = "| field | allowed | default | what it is |\n|---|---|---|---|\n"


def stated_fields() -> dict[str, DesignField]:
    """Fields that the page lists, by name, in the order of the file."""
    return {
        field.name: field
        for field in fields_of(ArrayDesign)
        if field.kind != "a table" and not field.name.startswith(_ALIKE)
    }


def fields_named(words: list[str]) -> list[DesignField]:
    """Fields of sections, each with all of its own, and single ones by name.

    Raises:
        ValueError: a word that is neither.
    """
    known, found = stated_fields(), []
    for word in words:
        own = [known[word]] if word in known else [f for f in known.values() if f.name.rpartition(".")[0] == word]
        if not own:
            raise ValueError(f"{word!r} is neither a field nor a section of a design file")
        found += own
    return found


def field_table(words: list[str]) -> str:
    """Markdown table of fields: name, range with unit, default, words."""
    return _table(fields_named(words))


def study_table(section: str) -> str:
    """Markdown table of the fields of a study file.

    Raises:
        ValueError: no such section.
    """
    if section not in _STUDY:
        raise ValueError(f"{section!r} must be one of: {', '.join(_STUDY)}")
    model = _STUDY[section]
    named = {name: info.alias or name for name, info in model.model_fields.items()}
    return _table([replace(field, name=named.get(field.name, field.name)) for field in fields_of(model)])


def part_table(kind: str) -> str:
    """Markdown table of the fields of a kind of part, or of ``part`` for those that all kinds have.

    Raises:
        ValueError: no such kind.
    """
    if kind not in _PARTS:
        raise ValueError(f"{kind!r} must be one of: {', '.join(_PARTS)}")
    common = set() if kind == "part" else set(StockPart.model_fields)
    return _table([field for field in fields_of(_PARTS[kind]) if field.name not in common])


def metric_table() -> str:
    """Markdown table of all metrics: name, unit, what is wanted, definition."""
    return "| name | unit | better | definition |\n|---|---|---|---|\n" + "".join(
        "| `{}` | {} | {} | {} |\n".format(*(text.replace("|", "\\|") for text in row))
        for row in ((metric.name, metric.unit, metric.better, metric.definition) for metric in METRICS.values())
    )


def _table(fields: list[DesignField]) -> str:
    return _HEAD + "".join(
        f"| `{field.name}` | {allowed(field)} | {default(field)} | {field.description} |\n" for field in fields
    )


def allowed(field: DesignField) -> str:
    """Range with unit, or kind and choices."""
    if field.kind in ("a number", "true or false"):
        return field.allowed if field.kind == "a number" else field.kind
    return f"{field.kind.split(' ', 1)[1]} {field.allowed}".strip()


def default(field: DesignField) -> str:
    """Default as code; empty where it is nothing."""
    if field.required:
        return "required"
    if field.default in (None, "", (), {}):
        return ""
    return f"`{str(field.default).lower() if isinstance(field.default, bool) else field.default}`"


class Fields(SphinxDirective):
    """The directive."""

    required_arguments = 1
    optional_arguments = 9

    def run(self) -> list[nodes.Node]:
        """The table as nodes."""
        try:
            return self.parse_text_to_nodes(field_table(self.arguments))
        except ValueError as error:
            raise self.error(str(error)) from None


class StudyFieldsTable(SphinxDirective):
    """The directive of study files."""

    required_arguments = 1

    def run(self) -> list[nodes.Node]:
        """The table as nodes."""
        try:
            return self.parse_text_to_nodes(study_table(self.arguments[0]))
        except ValueError as error:
            raise self.error(str(error)) from None


class PartFieldsTable(SphinxDirective):
    """The directive of files of parts."""

    required_arguments = 1

    def run(self) -> list[nodes.Node]:
        """The table as nodes."""
        try:
            return self.parse_text_to_nodes(part_table(self.arguments[0]))
        except ValueError as error:
            raise self.error(str(error)) from None


class Metrics(SphinxDirective):
    """The directive of metrics."""

    def run(self) -> list[nodes.Node]:
        """The table as nodes."""
        return self.parse_text_to_nodes(metric_table())


def rule_table() -> str:
    """Markdown table of the rules of the verdict: name, figure, limits, needs, reason."""
    head = "| rule | figure | works | marginal | needs | why |\n|---|---|---|---|---|---|\n"
    return head + "".join(
        "| `{}` | {} | {} | {} | {} | {} |\n".format(*(text.replace("|", "\\|") for text in row)) for row in rule_rows()
    )


class VerdictRules(SphinxDirective):
    """The directive of the rules of the verdict."""

    def run(self) -> list[nodes.Node]:
        """The table as nodes."""
        return self.parse_text_to_nodes(rule_table())


class Rooms(SphinxDirective):
    """The directive of the rooms of a package."""

    required_arguments = 1

    def run(self) -> list[nodes.Node]:
        """The table as nodes."""
        return self.parse_text_to_nodes(room_table(read_rooms(), self.arguments[0]))


def setup(app: Sphinx) -> dict[str, bool]:
    """Register the directives."""
    app.add_directive("fields", Fields)
    app.add_directive("metrics", Metrics)
    app.add_directive("rooms", Rooms)
    app.add_directive("study-fields", StudyFieldsTable)
    app.add_directive("part-fields", PartFieldsTable)
    app.add_directive("verdict-rules", VerdictRules)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
