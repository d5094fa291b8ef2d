"""A design made of parts that can be bought: what must change, which part each role takes, and what nothing fits."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field as default
from itertools import islice
from typing import Any, NamedTuple

from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import value_of
from geometry.ground.shown import Shown
from geometry.schema.field_errors import DesignError
from geometry.schema.part_fields import Tube
from geometry.stock.stock_parts import Found, StockParts
from geometry.stock.stock_rows import Silicone, StockPart
from geometry.stock.tube_stock import LARGEST_STEP, SAME, TubePart

#: Difference of hardness within which a sheet replaces what is cast, Shore A; the tolerance of most makers.
_SAME_SHORE = 5.0
#: Sets of parts for a tube that are tried in a design.
_TRIED = 40


class StockChange(NamedTuple):
    """Change of one field to the size of a part."""

    field: str
    """Dotted name of the field."""
    old: Any
    """Value of the design, in the unit of the field."""
    new: Any
    """Value of the part."""
    part: StockPart
    """The part."""


@dataclass(frozen=True, repr=False)
class StockFit(Shown):
    """A design against the catalogue."""

    design: ArrayDesign
    """Design with the changes made; fields that nothing fits are left as they are."""
    changes: tuple[StockChange, ...]
    """Changes of fields to sizes that can be bought."""
    parts: Mapping[str, StockPart]
    """Part of each role: ``tube.spring``, ``tube.sheath``, ``membrane``, ``membrane.sheet``, ``microphone``, ``resin``,
    ``glue.tube`` and so on."""
    missing: tuple[str, ...]
    """Dotted names of fields that nothing in the catalogue fits: made to order, or changed by hand."""
    nearest: Mapping[str, StockPart] = default(default_factory=dict)
    """For each of these the nearest part that can be bought, if there is one."""

    def shown(self) -> tuple[str, Mapping[str, object]]:
        """Title and facts that a session and a notebook show."""
        return f"Parts of {self.design.name}", {
            **{role: part.name for role, part in self.parts.items()},
            "changes": "; ".join(f"{each.field} {each.old} to {each.new}" for each in self.changes),
            "not in the catalogue": ", ".join(self.missing),
        }

    @property
    def bought(self) -> bool:
        """True where every part of the design as it was given is in the catalogue."""
        return not self.changes and not self.missing

    def to_dict(self) -> dict[str, Any]:
        """The same as JSON can hold it."""
        return {
            "parts": {role: part.to_dict() for role, part in self.parts.items()},
            "changes": [
                {"field": each.field, "old": each.old, "new": each.new, "part": each.part.name} for each in self.changes
            ],
            "missing": [
                {"field": name, "nearest": self.nearest[name].name if name in self.nearest else None}
                for name in self.missing
            ],
        }


class Fitting:
    """One design that becomes one of stock parts, role by role."""

    def __init__(self, stock: StockParts, design: ArrayDesign) -> None:
        self.stock, self.design = stock, design
        self.changes: list[StockChange] = []
        self.parts: dict[str, StockPart] = {}
        self.missing: list[str] = []
        self.nearest: dict[str, StockPart] = {}

    def result(self) -> StockFit:
        """All roles, one after the other."""
        self._tubes()
        self._membranes()
        self._microphone()
        self._resin()
        self._small_parts()
        return StockFit(self.design, tuple(self.changes), self.parts, tuple(self.missing), self.nearest)

    def _take(self, values: Mapping[str, tuple[Any, StockPart]]) -> bool:
        """Change fields to the sizes of parts if the design stays valid; what is so already counts as no change."""
        old = {name: value_of(self.design, name) for name in values}
        changed = {name: pair for name, pair in values.items() if not _same(old[name], pair[0])}
        if not changed:
            return True
        try:
            self.design = self.design.with_values({name: value for name, (value, _) in changed.items()})
        except DesignError:
            return False
        self.changes += [StockChange(name, old[name], value, part) for name, (value, part) in changed.items()]
        return True

    def _lack(self, field: str, nearest: StockPart | None) -> None:
        self.missing.append(field)
        if nearest is not None:
            self.nearest[field] = nearest

    # -- tubes -------------------------------------------------------------------------------------------
    def _tubes(self) -> None:
        following = self.design.followers
        for field, tube, _ in list(self.design.stated_tubes()):
            if field not in following:
                self._tube(field, tube)

    def _tube(self, field: str, tube: Tube) -> None:
        near = list(islice(self.stock.tubes.nearest(tube), _TRIED))
        for part in near:
            if abs(math.log(part.inner_diameter / tube.inner_diameter)) > LARGEST_STEP:
                continue
            inside = part.spring or part.sheath
            wire = (part.wire_diameter, inside)
            values: dict[str, tuple[Any, StockPart]] = {
                f"{field}.inner_diameter": (part.inner_diameter, inside),
                f"{field}.wire_diameter": wire,
                f"{field}.outer_diameter": (part.outer_diameter, part.sheath),
            }
            if self._take(values):
                self._tube_parts(field, part)
                return
        self._lack(f"{field}.{'inner_diameter' if tube.bore == 'smooth' else 'spring_outer_diameter'}", _of(near))

    def _tube_parts(self, field: str, part: TubePart) -> None:
        if part.spring is not None:
            self.parts[f"{field}.spring"] = part.spring
        self.parts[f"{field}.{'tubing' if part.spring is None else 'sheath'}"] = part.sheath

    # -- membranes ---------------------------------------------------------------------------------------
    def _membranes(self) -> None:
        cast = self.stock.silicone(self.design)
        self._found("membrane", "membrane.material", cast)
        shore = cast.part.shore_a if cast.exact and isinstance(cast.part, Silicone) else None
        for field, thickness in self._thicknesses():
            sheets = self.stock.sheets_near(thickness)
            size = sheets[0].thickness if sheets else math.inf
            near = sheets and abs(math.log(size / thickness)) <= LARGEST_STEP
            if not near or not self._take({field: (size, sheets[0])}):
                self._lack(field, sheets[0] if sheets else None)
                continue
            alike = [
                each
                for each in sheets
                if _same(each.thickness, size) and shore is not None and abs(each.shore_a - shore) <= _SAME_SHORE
            ]
            if alike:
                role = field.removesuffix("thickness").rstrip("._")
                self.parts[f"{role}.sheet" if role == "membrane" else f"{role}_sheet"] = _cheapest(alike)

    def _thicknesses(self) -> Iterator[tuple[str, float]]:
        yield "membrane.thickness", self.design.membrane.thickness
        for name, kind in self.design.point_kinds.items():
            if kind.membrane_thickness is not None:
                yield f"point_kinds.{name}.membrane_thickness", kind.membrane_thickness

    def _found(self, role: str, field: str, found: Found) -> None:
        if found.exact and found.part is not None:
            self.parts[role] = found.part
        else:
            self._lack(field, found.part)

    # -- the rest ----------------------------------------------------------------------------------------
    def _microphone(self) -> None:
        self._found("microphone", "microphone.model", self.stock.microphone_part(self.design.microphone))

    def _resin(self) -> None:
        self._found("resin", "printing.material", self.stock.resin(self.design))

    def _small_parts(self) -> None:
        sealed = self.design.microphone.gasket_width is not None
        for joint in ("tube", "membrane") if sealed else ("tube", "membrane", "board"):
            glues = self.stock.glues(joint)
            if glues:
                self.parts[f"glue.{joint}"] = glues[0]
        for role in ("microphone-board", "gasket") if sealed else ("microphone-board",):
            part = self.stock.sundry(role).part
            if part is not None:
                self.parts[role] = part


def _same(old: Any, new: Any) -> bool:
    if isinstance(old, float) and isinstance(new, float):
        return abs(old - new) <= SAME
    return bool(old == new)


def _cheapest(parts: Iterable[Any]) -> Any:
    return min(parts, key=lambda each: each.price)


def _of(near: list[TubePart]) -> StockPart | None:
    return (near[0].spring or near[0].sheath) if near else None
