"""Parts that can be bought, looked up: sizes of a field of a design, and the part nearest to a value."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple, TypeVar

from geometry.design.array_design import ArrayDesign
from geometry.ground.argument_checks import check_choice
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.shown import Shown
from geometry.schema.array_fields import StatedArray
from geometry.schema.materials import MATERIALS
from geometry.schema.part_fields import Microphone, Tube
from geometry.stock.stock_rows import (
    KINDS,
    Glue,
    Resin,
    Sheath,
    Sheet,
    Silicone,
    Spring,
    StockMicrophone,
    StockPart,
    Sundry,
)
from geometry.stock.tube_stock import SAME, TUBE_FIELDS, TubePart, TubeStock

_Part = TypeVar("_Part", bound=StockPart)
#: Most tubes whose parts are remembered.
_REMEMBERED = 10_000
#: Names of tables that hold a tube.
_TUBES = ("tube", "microphone_tube")
#: Fields that name a part.
_NAMES = ("membrane.material", "microphone.model")


class Found(NamedTuple):
    """Part that a role of a design takes."""

    part: StockPart | None
    """The part; None if the catalogue lacks the kind."""
    exact: bool
    """True if it is what the design states; otherwise it is the nearest, and that is made to order."""


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

    def bought_values(self, field: str, value: float, design: ArrayDesign) -> dict[str, float]:
        """Values by dotted name that give a field of a design the nearest size that can be bought.

        The fields that go with it are among them: the wire and the sheath that go with a bore.

        Args:
            field: dotted name of a field with sizes.
            value: wished value, mm.
            design: the design.

        Raises:
            Refusal: the field is not a size of bought parts, or nothing can be bought.
        """
        found = _tube_field(field)
        if found is None:
            part = self.nearest(field, value, design)
            size = part.thickness if isinstance(part, Sheet) else None
            values = None if size is None else {field: size}
        else:
            table, name = found
            tube = _tube_of(design, table)
            fitting = None if tube is None else self.tubes.bought(tube, {name: value})
            values = None if fitting is None else {f"{table}.{each}": size for each, size in fitting.items()}
        if values is None:
            problem = "cannot be bought: the catalogue has no such part"
            raise Refusal(problem, kind=Kind.MISSING, field=field, value=value, unit="mm")
        return values

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
        return self._microphones.get(model.lower())

    @cached_property
    def _microphones(self) -> dict[str, StockMicrophone]:
        return {each.part_number.lower(): each for each in reversed(self.of(StockMicrophone))}

    # -- the part of each role of a design ----------------------------------------------------------------
    def tube_part(self, tube: Tube) -> TubePart | None:
        """Spring and sheath nearest to a tube, whatever the rest of the design; None without a sheath to buy."""
        known: dict[Tube, TubePart | None] = self._tube_parts
        if tube not in known:
            if len(known) > _REMEMBERED:
                known.clear()
            known[tube] = next(self.tubes.nearest(tube), None)
        return known[tube]

    @cached_property
    def _tube_parts(self) -> dict[Tube, TubePart | None]:
        return {}

    def spring(self, tube: Tube) -> Found | None:
        """Spring of a tube; None for a smooth bore."""
        if tube.bore == "smooth":
            return None
        part = self.tube_part(tube)
        if part is None or part.spring is None:
            return Found(None, False)
        sizes = (part.inner_diameter - tube.inner_diameter, part.wire_diameter - tube.wire_diameter)
        return Found(part.spring, max(map(abs, sizes)) <= SAME)

    def sheath(self, tube: Tube) -> Found:
        """Sheath of a tube, or the tubing that is one of smooth bore."""
        part = self.tube_part(tube)
        if part is None:
            return Found(None, False)
        same = abs(part.outer_diameter - tube.outer_diameter) <= SAME
        return Found(part.sheath, same and abs(part.inner_diameter - tube.inner_diameter) <= SAME)

    def silicone(self, design: StatedArray) -> Found:
        """Casting silicone that makes the membranes, else the one of the nearest modulus."""
        name = design.membrane.material
        if name in self._silicones:
            return Found(self._silicones[name], True)
        wished = design.material(name).youngs_modulus
        near = [(abs(math.log(design.material(each).youngs_modulus / wished)), each) for each in self.materials]
        return Found(self._silicones[min(near)[1]] if near else None, False)

    @cached_property
    def _silicones(self) -> dict[str, Silicone]:
        """Cheapest casting silicone of each material."""
        ordered = sorted(self.of(Silicone), key=lambda each: each.price, reverse=True)
        return {name: each for each in ordered for name in each.materials}

    def resin(self, design: StatedArray) -> Found:
        """Cheapest material that the design's process prints, of its material if there is one."""
        process, material = design.printing.process, design.printing.material
        return self._resins.get((process, material)) or Found(self._any_resin.get(process), False)

    @cached_property
    def _resins(self) -> dict[tuple[str, str], Found]:
        ordered = sorted(self.of(Resin), key=lambda each: each.price, reverse=True)
        return {
            (process, name): Found(each, True)
            for each in ordered
            for process in each.processes
            for name in each.materials
        }

    @cached_property
    def _any_resin(self) -> dict[str, Resin]:
        ordered = sorted(self.of(Resin), key=lambda each: each.price, reverse=True)
        return {process: each for each in ordered for process in each.processes}

    def microphone_part(self, microphone: Microphone) -> Found:
        """The microphone of a design by its part number, else the one of the nearest noise."""
        part = self.microphone(microphone.model)
        if part is not None:
            return Found(part, True)
        return Found(self.nearest("microphone.model", microphone.noise_density), False)

    def sundry(self, role: str) -> Found:
        """The cheapest small part of a name in the bill."""
        part = self._sundries.get(role)
        return Found(part, part is not None)

    @cached_property
    def _sundries(self) -> dict[str, Sundry]:
        ordered = sorted(self.of(Sundry), key=lambda each: each.price, reverse=True)
        return {each.role: each for each in ordered}

    def glues(self, joint: str) -> tuple[Glue, ...]:
        """Glues for a joint, the cheapest of one joint first."""
        return tuple(each for each in self._glues if joint in each.joins)

    @cached_property
    def _glues(self) -> tuple[Glue, ...]:
        return tuple(sorted(self.of(Glue), key=lambda each: each.price * each.joint_volume))


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
