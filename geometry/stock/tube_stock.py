"""Springs and sheaths of a tube that can be bought, and the ones nearest to what is wished."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

from geometry.schema.part_fields import Tube
from geometry.stock.stock_rows import Sheath, Spring, Tubing

#: Fields of a tube that its parts determine.
TUBE_FIELDS = ("inner_diameter", "spring_outer_diameter", "wire_diameter", "outer_diameter", "sheath_wall")
#: Those of them that the spring determines.
SPRING_FIELDS = ("inner_diameter", "spring_outer_diameter", "wire_diameter")
#: Largest change of a bore or a thickness that still leaves the sensor much the same: logarithm of the ratio.
LARGEST_STEP = 0.3
#: Difference of sizes that are the same, mm.
SAME = 1e-3
#: Weight of the wire beside the bore where a spring is looked for: sound hardly depends on it.
_WIRE = 0.25


@dataclass(frozen=True)
class TubePart:
    """Parts of a tube: a sheath, with the spring in it unless the bore is smooth. Lengths in mm."""

    spring: Spring | None
    """Spring; None where the tubing alone is the tube."""
    sheath: Sheath
    """Sheath."""
    inner_diameter: float
    """Bore."""
    wire_diameter: float
    """Wire of the spring; of a smooth bore what the design states, at most the wall."""
    outer_diameter: float
    """Outside diameter."""

    @property
    def values(self) -> dict[str, float]:
        """Fields of :class:`geometry.schema.Tube`, and those that a file may give in their place."""
        outer = self.inner_diameter + 2 * self.wire_diameter if self.spring is None else self.spring.outer_diameter
        return {
            "inner_diameter": self.inner_diameter,
            "spring_outer_diameter": round(outer, 9),
            "wire_diameter": self.wire_diameter,
            "outer_diameter": self.outer_diameter,
            "sheath_wall": round((self.outer_diameter - outer) / 2, 6),
        }


@dataclass(frozen=True)
class TubeStock:
    """Springs and sheaths that can be bought."""

    springs: tuple[Spring, ...]
    """All springs; of several of one size the cheapest comes first."""
    sheaths: tuple[Sheath, ...]
    """All sleeves and tubings."""

    @cached_property
    def tubings(self) -> tuple[Tubing, ...]:
        """Tubings, which also serve alone."""
        return tuple(each for each in self.sheaths if isinstance(each, Tubing))

    @cached_property
    def _over(self) -> Mapping[float, tuple[tuple[float, Sheath], ...]]:
        """Outside diameters over each spring's outside diameter, the narrowest first."""
        found = {}
        for spring in {each.outer_diameter for each in self.springs}:
            outsides = ((each.outside_over(spring), each) for each in self.sheaths)
            known = [(outside, each) for outside, each in outsides if outside is not None]
            found[spring] = tuple(sorted(known, key=lambda pair: (pair[0], pair[1].price)))
        return found

    def sheaths_over(self, spring: float) -> tuple[tuple[float, Sheath], ...]:
        """Outside diameters (mm) and sheaths over a spring of the catalogue, by its outside diameter in mm."""
        return self._over.get(spring, ())

    @cached_property
    def enclosed(self) -> tuple[Spring, ...]:
        """Springs that some sheath goes over."""
        return tuple(spring for spring in self.springs if self.sheaths_over(spring.outer_diameter))

    def sizes(self, name: str, tube: Tube | None = None) -> tuple[float, ...]:
        """Values of a field of a tube that can be bought, ascending, mm.

        Args:
            name: one of :data:`TUBE_FIELDS`.
            tube: the tube at hand: sheaths are those over the spring nearest to its own, and its bore may be smooth.
        """
        smooth = tube is not None and tube.bore == "smooth"
        if name == "inner_diameter" and smooth:
            return _unique(each.inner_diameter for each in self.tubings)
        if name == "inner_diameter":
            return _unique(each.bore for each in self.enclosed)
        if name == "spring_outer_diameter":
            return () if smooth else _unique(each.outer_diameter for each in self.enclosed)
        if name == "wire_diameter":
            return () if smooth else _unique(each.wire_diameter for each in self.enclosed)
        if tube is not None and smooth:
            nearest = self.smooth(tube)[0]
            same = (each for each in self.tubings if abs(each.inner_diameter - nearest.inner_diameter) < SAME)
            return () if name == "sheath_wall" else _unique(each.outer_diameter for each in same)
        if tube is None:
            pairs = [
                (each.outer_diameter, outer) for each in self.enclosed for outer, _ in self._over[each.outer_diameter]
            ]
        else:
            near = self._near_spring(tube)
            diameter = tube.spring_outer_diameter if near is None else near.outer_diameter
            pairs = [(diameter, outer) for outer, _ in self._outsides(tube)]
        if name == "sheath_wall":
            return _unique((outer - spring) / 2 for spring, outer in pairs)
        return _unique(outer for _, outer in pairs)

    def _outsides(self, tube: Tube) -> list[tuple[float, Sheath]]:
        """Outside diameters over the spring of a tube, sold or not, with the sheath that gives each."""
        spring = self._near_spring(tube)
        if spring is not None:
            return list(self.sheaths_over(spring.outer_diameter))
        found = ((each.outside_over(tube.spring_outer_diameter), each) for each in self.sheaths)
        return [(outside, each) for outside, each in found if outside is not None]

    def _near_spring(self, tube: Tube) -> Spring | None:
        """The spring that a tube takes; None if all that are sold have quite another bore."""
        near = self.nearest_springs(tube.inner_diameter, tube.wire_diameter)[:1]
        return next((each for each in near if _apart(each.bore, tube.inner_diameter) <= LARGEST_STEP), None)

    def nearest_springs(
        self, inner: float, wire: float, held: Sequence[str] = ("inner_diameter", "wire_diameter")
    ) -> list[Spring]:
        """Springs that a sheath goes over, those nearest to a wish first.

        Args:
            inner: bore that is wished, mm.
            wire: wire that is wished, mm.
            held: fields of the tube whose wish comes first, the wire's as well as the bore's where both are.
        """
        outer = inner + 2 * wire
        wished = {"inner_diameter": inner, "spring_outer_diameter": outer, "wire_diameter": wire}

        def rank(each: Spring) -> tuple[float, float, float]:
            own = {
                "inner_diameter": each.bore,
                "spring_outer_diameter": each.outer_diameter,
                "wire_diameter": each.wire_diameter,
            }
            near = _apart(each.bore, inner) + _WIRE * _apart(each.wire_diameter, wire)
            thin = _apart(each.wire_diameter, wire)
            if set(held) == {"inner_diameter", "wire_diameter"}:
                return round(near, 9), 0.0, each.price
            first = sum(_apart(own[name], wished[name]) for name in held if name in own)
            return round(first, 9), round(thin if "spring_outer_diameter" in held else near, 9), each.price

        return sorted(self.enclosed, key=rank)

    def coiled(self, tube: Tube, held: Sequence[str] = ("inner_diameter", "wire_diameter")) -> Iterator[TubePart]:
        """Parts for a tube with a spring, those nearest to it first.

        A sheath whose wall is the tube's within its tolerance leaves it as it is.

        Args:
            tube: what is wished.
            held: see :meth:`nearest_springs`.
        """
        for spring in self.nearest_springs(tube.inner_diameter, tube.wire_diameter, held):
            yield from self.around(spring, tube.sheath_wall)

    def around(self, spring: Spring, wall: float) -> list[TubePart]:
        """A spring in each of the sheaths that go over it, those of a wall nearest to the wished one (mm) first."""
        diameter, bore = spring.outer_diameter, spring.bore

        def part(outside: float, sheath: Sheath) -> TubePart:
            own = (outside - diameter) / 2
            kept = round(diameter + 2 * wall, 9) if abs(own - wall) <= sheath.tolerance and wall > 0 else outside
            return TubePart(spring, sheath, bore, spring.wire_diameter, kept)

        by_wall = sorted(
            self.sheaths_over(diameter),
            key=lambda pair: (round(abs((pair[0] - diameter) / 2 - wall), 4), pair[1].price),
        )
        return [part(outside, sheath) for outside, sheath in by_wall]

    def over(self, tube: Tube, wall: float | None = None) -> list[TubePart]:
        """Sheaths that go over the spring of a tube, those of a wall nearest to its own first.

        A spring that nobody sells is replaced by the nearest one, or stays if that has quite another bore.

        Args:
            tube: the tube.
            wall: wall that is wished, mm; by default that which gives the outside of the tube.
        """
        spring = self._near_spring(tube)
        if spring is not None:
            return self.around(spring, (tube.outer_diameter - spring.outer_diameter) / 2 if wall is None else wall)
        wished, outer = tube.sheath_wall if wall is None else wall, tube.spring_outer_diameter
        known = self._outsides(tube)
        known.sort(key=lambda pair: (round(abs((pair[0] - outer) / 2 - wished), 4), pair[1].price))
        return [TubePart(None, sheath, tube.inner_diameter, tube.wire_diameter, outside) for outside, sheath in known]

    def smooth(self, tube: Tube) -> list[TubePart]:
        """Tubings that are a tube of smooth bore, those nearest to it first."""
        found = []
        for each in self.tubings:
            wall = (each.outer_diameter - each.inner_diameter) / 2
            wire = min(tube.wire_diameter, math.floor(wall * 1e6) / 1e6)
            found.append(TubePart(None, each, each.inner_diameter, wire, each.outer_diameter))
        return sorted(
            found,
            key=lambda part: (
                round(_apart(part.inner_diameter, tube.inner_diameter), 9),
                round(_apart(part.outer_diameter, tube.outer_diameter), 9),
                part.sheath.price,
            ),
        )

    def bought(self, tube: Tube, wished: Mapping[str, float]) -> dict[str, float] | None:
        """Values of a tube of which some fields become the sizes of the nearest parts, with the fields that follow.

        Wire and sheath follow a bore, and the wall of the sheath stays where its tolerance allows that.

        Args:
            tube: the tube.
            wished: values of some of :data:`TUBE_FIELDS`, mm.

        Returns:
            The wished fields, then those that follow, in mm; None if nothing can be bought.
        """
        part = self.wished_part(tube, wished)
        if part is None:
            return None
        held = [name for name in wished if name in SPRING_FIELDS]
        follow = ["wire_diameter"] if {"inner_diameter", "spring_outer_diameter"} & set(held) else []
        follow = follow or ["inner_diameter", "wire_diameter"]
        follow += [] if {"outer_diameter", "sheath_wall"} & set(wished) else ["outer_diameter"]
        return {name: part.values[name] for name in dict.fromkeys((*wished, *follow))}

    def wished_part(self, tube: Tube, wished: Mapping[str, float]) -> TubePart | None:
        """Parts nearest to a tube with some of its fields changed; a sold spring stays if no field of it is wished."""
        held = [name for name in wished if name in SPRING_FIELDS]
        changed = _changed(tube, wished)
        if held or tube.bore == "smooth":
            return next(self.nearest(changed, held), None)
        return next(iter(self.over(changed, wished.get("sheath_wall"))), None)

    def nearest(self, tube: Tube, held: Sequence[str] = ("inner_diameter", "wire_diameter")) -> Iterator[TubePart]:
        """Parts for a tube, those nearest to it first, whatever its bore."""
        return iter(self.smooth(tube)) if tube.bore == "smooth" else self.coiled(tube, held)


def _changed(tube: Tube, fields: Mapping[str, float]) -> Tube:
    """A tube with other sizes, unchecked; the wall of its sheath stays unless it is one of them."""
    wire = fields.get("wire_diameter", tube.wire_diameter)
    inner = fields.get("inner_diameter", tube.inner_diameter)
    if "spring_outer_diameter" in fields:
        inner = fields["spring_outer_diameter"] - 2 * wire
    inner = max(inner, SAME)
    outer = inner + 2 * wire + 2 * fields.get("sheath_wall", tube.sheath_wall)
    outer = fields.get("outer_diameter", outer)
    return tube.model_copy(update={"inner_diameter": inner, "wire_diameter": wire, "outer_diameter": outer})


def _apart(one: float, other: float) -> float:
    """Distance of two sizes: the logarithm of their ratio."""
    return abs(math.log(one / other))


def _unique(values: Iterator[float]) -> tuple[float, ...]:
    """Values ascending, each once; of two that differ by less than :data:`SAME` the smaller."""
    found: list[float] = []
    for value in sorted(values):
        if not found or value - found[-1] > SAME / 2:
            found.append(round(value, 4))
    return tuple(found)
