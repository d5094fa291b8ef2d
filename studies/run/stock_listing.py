"""The catalogue of parts that can be bought, or the parts of one design, as a list and a file."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from geometry.design.design_file import DesignLike
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.shown import Shown
from geometry.ground.typed import PathLike
from geometry.stock import StockFit, StockPart, catalogue
from studies.output.folders import check_new_file, write_json


@dataclass(frozen=True, repr=False)
class StockListing(Shown):
    """Parts that can be bought."""

    parts: tuple[StockPart, ...]
    """Parts of the catalogue, or those that a design takes."""
    fit: StockFit | None = None
    """Fit of the design to the catalogue; None if no design was asked for."""

    def shown(self) -> tuple[str, Mapping[str, object]]:
        """Title and facts that a session and a notebook show."""
        return f"{len(self.parts)} parts that can be bought", {part.name: part.size for part in self.parts}

    def to_dict(self) -> dict[str, Any]:
        """The list as JSON can hold it."""
        return {"parts": [part.to_dict() for part in self.parts]} if self.fit is None else self.fit.to_dict()


def list_stock(
    kind: str | None = None, *, design: DesignLike | None = None, out: PathLike | None = None
) -> StockListing:
    """Parts that can be bought: all, those of a kind, or those that a design takes.

    Args:
        kind: one of :data:`geometry.stock.KINDS`; by default all.
        design: the array whose parts are listed: a design, the path of its file, or the name of a prototype.
        out: a JSON file for the list; an earlier one is replaced.

    Raises:
        Refusal: no such kind or design, both are given, or a file of own parts or the list's cannot be used.
    """
    path = None if out is None else Path(out)
    check_new_file(path, ".json")
    sold = catalogue()
    if kind and design is not None:
        problem = "cannot be given together with a design"
        raise Refusal(problem, kind=Kind.CONFLICT, field="kind", value=kind, remedy="give one of the two")
    if design is None:
        found = StockListing(sold.listed(kind or ""))
    else:
        fit = sold.fit(design)
        found = StockListing(tuple(fit.parts.values()), fit)
    if path is not None:
        write_json(path, found.to_dict())
    return found
