"""Plan of the circuit board of a microphone, made from the design and from the land pattern of its package.

The board lies in the seat of the housing and closes the chamber. A neck leads the tracks through the slot of the seat
to a head outside, with the connector and the capacitor. All signals run on the top but ground, which runs below.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import NoReturn

from geometry.boards.board_pieces import BoardPad, BoardPlan, BoardWord, Bore, PinMark, Ring, Track, Via
from geometry.boards.board_rules import BoardRules, closest
from geometry.design.array_design import ArrayDesign
from geometry.ground.refusal import Kind, Refusal
from geometry.schema.part_fields import SEAT_SLOT, Microphone
from geometry.solids.stroke_font import Point, text_size
from geometry.stock import LandPad, LandPattern, StockMicrophone, catalogue, find_land_pattern

#: Widths of the tracks of signals and of ground, and the distance of two tracks in the neck, mm.
_TRACK, _GROUND, _LANE = 0.15, 0.4, 0.375
#: Distance of the edge of the sound hole to the wall of the chamber where the board has room for it, so that no glue on
#: the seat creeps into the hole, and of the package to the edge of the board, mm.
IN_CHAMBER, _PACKAGE_EDGE = 0.3, 0.05
#: Largest and smallest diameter of the mark of pin 1, and its distance to the package and to the edge of the board, mm.
_MARK, _LEAST_MARK, _BESIDE_MARK = 0.3, 0.15, 0.1
#: Copper and hole of a via, mm.
_VIA, _VIA_DRILL = 0.6, 0.3
#: Distance of the middle of a track that leads around a pad to this pad, mm.
_AROUND = BoardRules().spacing + _TRACK / 2
#: What the bend of such a track into the neck needs beside the corner there, mm.
_BEND_ROOM = 0.01
#: Connector: pitch, copper and hole of a pin, mm. Headers of 1.27 mm fit, and so do single wires.
_PITCH, _PIN, _PIN_DRILL = 1.27, 1.0, 0.65
#: Capacitor 0402: distance and sizes of its pads along and across it, mm; IPC-7351, nominal.
_CAPACITOR, _CAPACITOR_PAD = 0.96, (0.62, 0.56)
#: Distances in the head, mm: to the housing, from the neck to the first bend, between bends, from connector to
#: capacitor, from capacitor to words, from words to the tie hole, from the tie hole and from the pins to the edge.
_OUTSIDE, _FIRST_BEND, _BEND, _BEHIND, _TO_WORDS, _TO_TIE, _END, _BESIDE = 0.3, 0.4, 0.1, 1.1, 0.45, 0.2, 0.5, 0.3
#: Height of the words, their number of letters, and the diameter of the tie hole, mm.
_WORD, _LETTERS, _TIE = 0.7, 3, 1.2
_GND = "GND"
_LARGER = "set microphone.board_length and microphone.board_width larger"
_SMALLER_HOLE = "set microphone.sound_hole_diameter smaller"


def plan_board(design: ArrayDesign) -> BoardPlan:
    """Plan of the board of the microphones of a design.

    The package lies as near to the middle of the seat as its sound hole, which is beside its middle, can lie 0.3 mm
    within the chamber. If the board has no room for that, the hole lies as far within as there is room, and at least as
    far as the rules of boards say.

    Args:
        design: the array.

    Raises:
        Refusal: the catalogue does not have the microphone or its land pattern, its sound hole is at the top, or the
            board of the design has no room for package, hole or tracks.
    """
    microphone = design.microphone
    part = catalogue().microphone(microphone.model)
    if not isinstance(part, StockMicrophone):
        raise Refusal(
            "is not in the catalogue, so no board is drawn",
            kind=Kind.MISSING,
            field="microphone.model",
            value=microphone.model,
            remedy="add it to a file of parts with its land_pattern and its pins",
        )
    if part.port != "bottom":
        problem = "has its sound hole at the top, so no board with a hole is drawn"
        raise Refusal(problem, kind=Kind.UNSUITABLE, field="microphone.model", value=microphone.model)
    if part.land_pattern is None:
        raise Refusal(
            "has no land pattern in the catalogue, so no board is drawn",
            kind=Kind.MISSING,
            field="microphone.model",
            value=microphone.model,
            remedy="add land_pattern and pins after its data sheet to a file of parts, or choose one of: "
            + ", ".join(each.part_number for each in catalogue().of(StockMicrophone) if each.land_pattern),
        )
    return _kept_plan(microphone, part, find_land_pattern(part.land_pattern))


@lru_cache(maxsize=256)
def _kept_plan(microphone: Microphone, part: StockMicrophone, pattern: LandPattern) -> BoardPlan:
    """Plan that keeps the rules of boards; studies ask for that of one microphone thousands of times."""
    plan = _Planning(microphone, part, pattern).plan()
    for spacing in closest(plan):
        if not spacing.kept:
            _refuse_size(
                microphone,
                f"leaves {spacing.where} with {spacing.value:.2f} mm, and boards need {spacing.allowed:g} mm there "
                f"({spacing.rule})",
                _SMALLER_HOLE if spacing.rule == "hole" else _LARGER,
            )
    return plan


def board_or_reason(design: ArrayDesign) -> tuple[BoardPlan | None, str]:
    """Board of the microphones of a design, or None and the reason why none is drawn."""
    try:
        return plan_board(design), ""
    except Refusal as refusal:
        return None, str(refusal)


def shown_board(design: ArrayDesign) -> BoardPlan | None:
    """Board that the solids of an array show whole.

    None if none is drawn, and on a body, where the neck is bent outwards: then the solids show what lies in the seat.
    """
    return None if design.layout.frozen is not None else board_or_reason(design)[0]


def _refuse_size(microphone: Microphone, problem: str, remedy: str = _LARGER) -> NoReturn:
    length, width = microphone.board_size
    raise Refusal(
        problem,
        kind=Kind.UNSUITABLE,
        field="microphone board",
        value=f"{length:g} x {width:g} mm",
        remedy=f"no board is drawn; {remedy}",
    )


@dataclass(frozen=True)
class _Lane:
    """Way of a signal from its pad to the neck."""

    net: str
    places: tuple[Point, ...]


@dataclass(frozen=True)
class _Planning:
    """Sizes of one board, each computed once."""

    microphone: Microphone
    part: StockMicrophone
    pattern: LandPattern

    def plan(self) -> BoardPlan:
        lanes, half, ring, ends = self._lanes, self._half_head, self._ring, self._corners
        wires = (*(lane.net for lane in lanes), _GND)
        (left, bottom), (right, top) = self._package
        outline = (
            (-ends[0], -ends[1]), (ends[0], -ends[1]), (ends[0], ends[1]), (-ends[0], ends[1]),
            (-ends[0], self._half_neck), (self._head_right, self._half_neck), (self._head_right, half),
            (self._head_left, half), (self._head_left, -half), (self._head_right, -half),
            (self._head_right, -self._half_neck), (-ends[0], -self._half_neck),
        )  # fmt: skip
        return BoardPlan(
            microphone=self.part.part_number,
            title=self.pattern.title,
            source="; ".join(filter(None, (self.part.pins_source, self.pattern.source))),
            outline=outline,
            thickness=self.microphone.sound_hole_length,
            sound_hole=Bore("sound hole", ring.centre, self.microphone.sound_hole_diameter),
            tie_hole=Bore("tie hole", (self._tie_x, 0.0), _TIE),
            chamber=self.microphone.chamber_diameter,
            ring=ring,
            pads=tuple(self._all_pads(wires)),
            tracks=tuple(self._tracks(wires)),
            vias=(Via(_GND, self._via, _VIA, _VIA_DRILL),),
            words=tuple(
                BoardWord(net[:_LETTERS], (self._word_x, y), _WORD)
                for net, y in zip(wires, self._pin_places, strict=True)
            ),
            pin_mark=self._pin_mark,
            package=((left, bottom), (right, top)),
            head=((self._head_left, -half), (self._head_right, half)),
            pins=self.part.pins,
            wires=wires,
        )

    # -- in the seat --------------------------------------------------------------------------------------
    @cached_property
    def _corners(self) -> Point:
        """Half the sizes of the board in the seat."""
        length, width = self.microphone.board_size
        return length / 2, width / 2

    @cached_property
    def _middle(self) -> float:
        """Middle of the package along x."""
        microphone, (length, width) = self.microphone, self._corners
        room = length - self.part.length / 2 - _PACKAGE_EDGE
        if room < 0 or width < self.part.width / 2:
            _refuse_size(microphone, f"is smaller than the package of {self.part.length:g} x {self.part.width:g} mm")
        reach, least = (microphone.chamber_diameter - microphone.sound_hole_diameter) / 2, BoardRules().chamber
        if reach < least:
            problem = f"has a sound hole that is too wide for the chamber of {microphone.chamber_diameter:g} mm"
            _refuse_size(microphone, problem, _SMALLER_HOLE)
        most = max(0.0, min(room, length - self._left_of_middle))
        shift = min(max(0.0, self.pattern.port - reach + IN_CHAMBER), most)
        lacking = self.pattern.port - shift - reach + least
        if lacking > 1e-9:
            _refuse_size(
                microphone,
                f"leaves the sound hole outside the chamber of {microphone.chamber_diameter:g} mm, or less than "
                f"{least:g} mm within it; it must be {2 * (length + lacking):.2f} mm long",
            )
        return -shift

    @cached_property
    def _left_of_middle(self) -> float:
        """Length from the edge of the board to the middle of the package that pads and tracks beside them need."""
        rules = BoardRules()
        left = max(each.length / 2 - each.x for each in self.pattern.pads)
        around = any(around for _, around, _ in self._order)
        return left + rules.edge + (_AROUND + _TRACK / 2 + _BEND_ROOM if around else 0.0)

    @cached_property
    def _pin_mark(self) -> PinMark | None:
        """Dot beside pin 1, between the package and the edge of the board."""
        pin = next((pad for pad in self.pattern.pads if pad.number == "1"), None)
        if pin is None:
            return None
        x, y = self._place(pin)
        package, edge = self.part.width / 2, self._corners[1]
        diameter = min(_MARK, edge - package - 2 * _BESIDE_MARK)
        if diameter < _LEAST_MARK:
            return None
        return PinMark((x, math.copysign((package + edge) / 2, y)), diameter)

    @cached_property
    def _package(self) -> tuple[Point, Point]:
        half, width = self.part.length / 2, self.part.width / 2
        return (self._middle - half, -width), (self._middle + half, width)

    @cached_property
    def _ring(self) -> Ring:
        pattern = self.pattern
        centre = (self._middle + pattern.port, 0.0)
        return Ring(pattern.ring, self._net(pattern.ring), centre, pattern.ring_inner, pattern.ring_outer)

    @cached_property
    def _via(self) -> Point:
        """Via that joins the ring to the ground below, in a corner of the seat, outside the chamber."""
        inside = _VIA / 2 + BoardRules().edge
        length, width = self._corners
        return length - inside, -min(width - inside, self._ring.outer / 2 + 0.4)

    def _net(self, number: str) -> str:
        return self.part.pins[int(number) - 1]

    def _place(self, pad: LandPad) -> Point:
        return self._middle + pad.x, pad.y

    @cached_property
    def _order(self) -> tuple[tuple[LandPad, bool, int], ...]:
        """Pads of the signals but ground in the order of their lanes, from +y to -y.

        With each, whether its track leads past another pad, and on which side of the package.
        """
        sides = {sign: [pad for pad in self.pattern.pads if pad.y * sign > 0] for sign in (1, -1)}
        order: list[tuple[LandPad, bool, int]] = []
        above = sorted(sides[1], key=lambda pad: -pad.x)
        order += [(pad, pad is not above[-1], 1) for pad in above]
        order += [(pad, False, 0) for pad in self.pattern.pads if pad.y == 0]
        below = sorted(sides[-1], key=lambda pad: pad.x)
        order += [(pad, pad is not below[0], -1) for pad in below]
        return tuple(each for each in order if self._net(each[0].number) != _GND)

    @cached_property
    def _lanes(self) -> tuple[_Lane, ...]:
        """Ways of all signals to the neck, from +y to -y; ground goes below the board."""
        middle = (len(self._order) - 1) / 2
        return tuple(
            _Lane(self._net(pad.number), tuple(self._way(pad, around, sign, _LANE * (middle - number))))
            for number, (pad, around, sign) in enumerate(self._order)
        )

    def _way(self, pad: LandPad, around: bool, sign: int, lane: float) -> Iterator[Point]:
        """Places of the track of a pad; ``around`` leads it past the pad between it and the neck."""
        rules, (x, y) = BoardRules(), self._place(pad)
        left = min(self._middle + each.x - each.length / 2 for each in self.pattern.pads)
        if around:
            side = max(abs(each.y) + each.width / 2 for each in self.pattern.pads) + rules.spacing + _TRACK / 2
            turn = left - _AROUND
            yield x, y
            yield x, sign * side
            yield turn, sign * side
            yield turn, sign * (abs(lane) + 0.2)
            yield turn - 0.2, lane
        else:
            start = left + 0.1
            yield start, sign * max(abs(y) - pad.width / 2 + 0.09, min(abs(y), abs(lane)))
            yield left - 0.35, lane
        yield self._head_right - _FIRST_BEND, lane

    # -- in the head --------------------------------------------------------------------------------------
    @cached_property
    def _half_neck(self) -> float:
        microphone = self.microphone
        return (SEAT_SLOT * (2 * self._corners[1] + 2 * microphone.board_gap)) / 2 - microphone.board_gap

    @cached_property
    def _head_right(self) -> float:
        microphone = self.microphone
        return -(self._corners[0] + microphone.board_gap + microphone.wall_thickness + _OUTSIDE)

    @cached_property
    def _pin_places(self) -> tuple[float, ...]:
        """Y of each pin of the connector, pin 1 first."""
        count = len(self._lanes) + 1
        return tuple(_PITCH * ((count - 1) / 2 - number) for number in range(count))

    @cached_property
    def _half_head(self) -> float:
        return max(self._pin_places[0] + _PIN / 2 + _BESIDE, self._half_neck + _BESIDE)

    @cached_property
    def _pin_x(self) -> float:
        climbs = [abs(pin - lane.places[-1][1]) for pin, lane in zip(self._pin_places[:-1], self._lanes, strict=True)]
        return self._head_right - _FIRST_BEND - max(climbs) - len(climbs) * _BEND - 0.2

    @cached_property
    def _capacitor_x(self) -> float:
        return self._pin_x - _BEHIND

    @cached_property
    def _word_x(self) -> float:
        """Middle of the words."""
        return self._capacitor_x - _TO_WORDS - text_size(["X" * _LETTERS], _WORD)[0] / 2

    @cached_property
    def _tie_x(self) -> float:
        return self._word_x - text_size(["X" * _LETTERS], _WORD)[0] / 2 - _TO_TIE - _TIE / 2

    @cached_property
    def _head_left(self) -> float:
        return self._tie_x - _TIE / 2 - _END

    def _all_pads(self, wires: Sequence[str]) -> Iterator[BoardPad]:
        for pad in self.pattern.pads:
            net = self._net(pad.number)
            yield BoardPad("MK1", pad.number, net, self._place(pad), (pad.length, pad.width))
        for number, (net, y) in enumerate(zip(wires, self._pin_places, strict=True), start=1):
            yield BoardPad("J1", str(number), net, (self._pin_x, y), (_PIN, _PIN), _PIN_DRILL, number > 1)
        supply = self._supply
        yield BoardPad("C1", "1", "VDD", (self._capacitor_x, supply), _CAPACITOR_PAD)
        yield BoardPad("C1", "2", _GND, (self._capacitor_x, supply - _CAPACITOR), _CAPACITOR_PAD)

    @cached_property
    def _supply(self) -> float:
        """Y of the pin of the supply."""
        return self._pin_places[[lane.net for lane in self._lanes].index("VDD")]

    def _tracks(self, wires: Sequence[str]) -> Iterator[Track]:
        lanes = self._lanes
        climbs = [pin - lane.places[-1][1] for pin, lane in zip(self._pin_places[:-1], lanes, strict=True)]
        rising, falling = (
            [k for k, climb in enumerate(climbs) if climb > 0],
            [k for k, c in enumerate(climbs) if c <= 0],
        )
        bends = {k: number for number, k in enumerate(rising)} | {k: n for n, k in enumerate(reversed(falling))}
        for number, (lane, climb) in enumerate(zip(lanes, climbs, strict=True)):
            x, y = lane.places[-1]
            bend = x - _BEND * bends[number]
            pin = (self._pin_x, self._pin_places[number])
            yield Track(lane.net, "top", (*lane.places, (bend, y), (bend - abs(climb), pin[1]), pin), _TRACK)
        yield from self._ground()
        yield Track("VDD", "top", ((self._pin_x, self._supply), (self._capacitor_x, self._supply)), 0.3)

    def _ground(self) -> Iterator[Track]:
        """Tracks of ground: pads beside the ring, the ring to the via, below to the connector, and the capacitor."""
        for pad in self.pattern.pads:
            if self._net(pad.number) == _GND:
                yield Track(_GND, "top", (self._place(pad), self._on_ring(self._place(pad))), _TRACK + 0.05)
        yield Track(_GND, "top", (self._on_ring(self._via), self._via), _TRACK + 0.05)
        length = self._corners[0]
        via_x, via_y = self._via
        pin = (self._pin_x, self._pin_places[-1])
        below = ((via_x, via_y), (min(via_x, -length - via_y), via_y), (-length, 0.0))
        bend = self._head_right - _FIRST_BEND
        yield Track(_GND, "bottom", (*below, (bend, 0.0), (pin[0] + 0.9, pin[1]), pin), _GROUND)
        start = (self._capacitor_x, self._supply - _CAPACITOR)
        yield Track(_GND, "top", (start, (self._capacitor_x, pin[1]), pin), 0.3)

    def _on_ring(self, place: Point) -> Point:
        """Middle of the copper of the ring in the direction of a place."""
        (x, y), mean = self._ring.centre, (self._ring.inner + self._ring.outer) / 4
        far = ((place[0] - x) ** 2 + (place[1] - y) ** 2) ** 0.5
        return x + mean * (place[0] - x) / far, y + mean * (place[1] - y) / far
