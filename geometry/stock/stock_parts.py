"""Parts that can be bought, looked up: sizes of a field of a design, and the part nearest to a value."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import TypeVar

from geometry.design.array_design import ArrayDesign
from geometry.ground.argument_checks import check_choice
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.shown import Shown
from geometry.schema.materials import MATERIALS
from geometry.schema.part_fields import Tube
from geometry.stock.stock_rows import KINDS, Glue, Sheath, Sheet, Silicone, Spring, StockMicrophone, StockPart
from geometry.stock.tube_stock import TUBE_FIELDS, TubeStock

_Part = TypeVar("_Part", bound=StockPart)
#: Names of tables that hold a tube.
_TUBES = ("tube", "microphone_tube")
#: Fields that name a part.
_NAMES = ("membrane.material", "microphone.model")


@dataclass(frozen=True, repr=False)
class StockParts(Shown):
    """Parts that can be bought. Lengths in mm, prices in USD per unit of the part."""

    parts: tuple[StockPart, ...]
    """All parts, a user's own first."""

    def shown(self) -> tuple[str, dict[str, object]]:
        """Title and facts that a session and a notebook show."""
        counts: dict[str, object] = {kind: sum(part.kind == kind for part in self.parts) for kind in KINDS}
        return f"Catalogue of {len(self.parts)} parts", counts

    def of(self, kind: type[_Part]) -> tuple[_Part, ...]:
        """All parts of a kind, by its class."""
        return tuple(part for part in self.parts if isinstance(part, kind))

    def listed(self, kind: str = "") -> tuple[StockPart, ...]:
        """All parts of a kind by its name, or all.

        Raises:
            Refusal: no such kind.
        """
        if kind:
            check_choice("kind", kind, KINDS)
        return tuple(part for part in self.parts if kind in ("", part.kind))

    @cached_property
    def tubes(self) -> TubeStock:
        """Springs and sheaths."""
        springs: dict[tuple[float, float], Spring] = {}
        for each in sorted(self.of(Spring), key=lambda part: part.price):
            springs.setdefault((each.outer_diameter, each.wire_diameter), each)
        return TubeStock(tuple(springs.values()), self.of(Sheath))

    @cached_property
    def materials(self) -> tuple[str, ...]:
        """Built-in materials of membranes that some casting silicone makes."""
        named = {name for each in self.of(Silicone) for name in each.materials}
        return tuple(sorted(named & set(MATERIALS)))

    def has_sizes(self, field: str) -> bool:
        """True for a field of a design that is a size of bought parts, such as ``tube.inner_diameter``."""
        return field == "membrane.thickness" or _kind_thickness(field) or _tube_field(field) is not None

    def sizes(self, field: str, design: ArrayDesign | None = None) -> tuple[float, ...] | tuple[str, ...]:
        """Values of a field that can be bought, ascending, in the unit of the field; empty for a field without stock.

        Args:
            field: dotted name, such as ``tube.inner_diameter``, ``membrane.thickness`` or ``microphone.model``.
            design: the design at hand; sheaths are then those over its spring, and its bore may be smooth.
        """
        if field == "membrane.thickness" or _kind_thickness(field):
            return tuple(sorted({each.thickness for each in self.of(Sheet)}))
        if field == "membrane.material":
            return self.materials
        if field == "microphone.model":
            return tuple(sorted(each.part_number for each in self.of(StockMicrophone)))
        found = _tube_field(field)
        if found is None:
            return ()
        return self.tubes.sizes(found[1], None if design is None else _tube_of(design, found[0]))

    def nearest(self, field: str, value: float, design: ArrayDesign | None = None) -> StockPart | None:
        """The part whose size is nearest to a value of a field, by ratio; None if the catalogue lacks such parts.

        Args:
            field: dotted name of a field with sizes, or ``microphone.model`` for the microphone nearest in noise.
            value: in the unit of the field; the noise density of a microphone in Pa/sqrt(Hz).
            design: the design at hand, as for :meth:`sizes`.

        Raises:
            Refusal: the field is not a size of bought parts.
        """
        if field == "microphone.model":
            known = self.of(StockMicrophone)
            return min(known, key=lambda each: abs(math.log(each.noise_density / value)), default=None)
        if field == "membrane.thickness" or _kind_thickness(field):
            return next(iter(self.sheets_near(value)), None)
        found = _tube_field(field)
        if found is None:
            allowed = f"a field of bought parts: membrane.thickness, or one of a tube: {', '.join(TUBE_FIELDS)}"
            raise Refusal(kind=Kind.UNKNOWN, field="field", value=field, allowed=allowed)
        sizes = self.tubes.sizes(found[1], None if design is None else _tube_of(design, found[0]))
        if not sizes:
            return None
        size = min(sizes, key=lambda each: abs(math.log(each / value)))
        return self._part_of_size(found[1], size, None if design is None else _tube_of(design, found[0]))

    def _part_of_size(self, name: str, size: float, tube: Tube | None) -> StockPart:
        """The cheapest part that gives a field of a tube one of its sizes."""
        tubes = self.tubes
        candidates: list[tuple[float, float, StockPart]] = []
        if tube is not None and tube.bore == "smooth":
            candidates += [(abs(getattr(each, name) - size), each.price, each) for each in tubes.tubings]
        elif name in ("outer_diameter", "sheath_wall"):
            for spring in tubes.enclosed:
                for outer, sheath in tubes.sheaths_over(spring.outer_diameter):
                    own = outer if name == "outer_diameter" else (outer - spring.outer_diameter) / 2
                    candidates.append((abs(own - size), sheath.price, sheath))
        else:
            own_name = {"inner_diameter": "bore", "spring_outer_diameter": "outer_diameter"}.get(name, name)
            candidates += [(abs(getattr(each, own_name) - size), each.price, each) for each in tubes.enclosed]
        return min(candidates, key=lambda each: (round(each[0], 3), each[1]))[2]

    def sheets_near(self, thickness: float) -> list[Sheet]:
        """Sheets, those nearest in thickness (mm) first, then the cheapest."""
        return sorted(
            self.of(Sheet), key=lambda each: (round(abs(math.log(each.thickness / thickness)), 9), each.price)
        )

    def microphone(self, model: str) -> StockMicrophone | None:
        """The microphone of a part number, whatever its letters' case; None where the catalogue lacks it."""
        return next((each for each in self.of(StockMicrophone) if each.part_number.lower() == model.lower()), None)

    def glues(self, joint: str) -> tuple[Glue, ...]:
        """Glues for a joint, the cheapest of one joint first."""
        fitting = (each for each in self.of(Glue) if joint in each.joins)
        return tuple(sorted(fitting, key=lambda each: each.price * each.joint_volume))


# -- names of fields ------------------------------------------------------------------------------------
def _tube_field(field: str) -> tuple[str, str] | None:
    """Table and field of a dotted name of a bought tube's size; None for any other."""
    table, _, name = field.rpartition(".")
    steps = table.split(".")
    of_a_kind = len(steps) == 2 and steps[0] == "tube_kinds"
    of_a_line = len(steps) == 3 and steps[0] == "lines" and steps[2] in _TUBES
    is_tube = table in _TUBES or of_a_kind or of_a_line
    return (table, name) if is_tube and name in TUBE_FIELDS else None


def _kind_thickness(field: str) -> bool:
    steps = field.split(".")
    return len(steps) == 3 and steps[0] == "point_kinds" and steps[2] == "membrane_thickness"


def _tube_of(design: ArrayDesign, table: str) -> Tube | None:
    """The tube at a dotted name; None where the design does not state it."""
    return next((tube for name, tube, _ in design.stated_tubes() if name == table), None)
