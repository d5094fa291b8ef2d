"""Texts that every report shares: percentages, and the rows of a table of provenance."""

from __future__ import annotations

from collections.abc import Iterator, Mapping


def percent(fraction: float) -> str:
    """Percentage with one decimal; only a fraction of exactly 1 is shown as 100 %."""
    return "100 %" if fraction == 1 else f"{100 * min(fraction, 0.9995):.1f} %"


def record_rows(name: str, value: object) -> Iterator[tuple[str, str]]:
    """Rows of a nested record, each a dotted name with its value."""
    if isinstance(value, Mapping):
        for key, part in value.items():
            yield from record_rows(f"{name}.{key}", part)
    elif isinstance(value, (list, tuple)):
        yield name, ", ".join(map(str, value))
    else:
        yield name, "" if value is None else str(value)
