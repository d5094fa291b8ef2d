"""Designs that may answer a question: a layout, drawn sizes of the shells, and parts of the catalogue."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from geometry.design.array_design import ArrayDesign, validated
from geometry.design.design_file import prototype
from geometry.ground.refusal import Refusal
from geometry.layout.size import array_size
from geometry.plan.cylinder import wound_length
from geometry.plan.tube_descent import CLEARANCE, usual_depth
from geometry.schema.field_errors import DesignError
from geometry.schema.part_fields import SOCKET_COVER
from geometry.schema.print_processes import find_process
from geometry.stock import Resin, Silicone, catalogue
from studies.proposals.designer_question import PLACES, Question
from studies.proposals.grids import Grid

#: Prototype whose remaining values are taken.
_BASE = "array-2x6"
#: Microphones that are tried: the usual one, and one of less noise.
_MICROPHONES = ("SPH1878LR5H-C", "IM73A135V01")
#: Silicones that are tried, Shore A.
_SHORE = (10, 20, 30, 50)
#: Ranges of the sizes that are drawn: cavity by the space between two axes, membrane by cavity, cavity's height.
_CAVITY, _MEMBRANE, _HEIGHT = (0.3, 0.95), (0.06, 0.35), (2.0, 6.0)
#: Height of a cavity by its radius, which the atlas of 3-D cells covers with scatter: nobody waits for a solution.
_SLENDER = (0.36, 1.9)
#: Walls of the shells, mm, and widest glued rim.
_WALLS, _RIM = (0.8, 1.0, 1.5), 1.5
#: Lengths of the microphone tubes that are tried, mm; tubes that meet beside an area are longer if they must.
_MICROPHONE_TUBES = (8.0, 10.0, 12.0, 15.0, 20.0, 30.0)
#: Widest bore that is tried by the pitch: tubes are slim, and bend.
_BORE = 0.12
#: Fraction of the sizes that stay where others are drawn near to them.
_KEPT = 0.7
#: Chambers of larger microphone housings, by the smallest one, where the sockets of the tubes need them.
_CHAMBERS = (1.0, 1.5, 2.2)

#: Designs that are drawn to learn what keeps others from being drawn.
_LOOKED = 40

#: Sizes and parts of one design, by name.
Sizes = dict[str, Any]


class Candidates:
    """Designs that are drawn for one layout of a question, from a fixed seed."""

    def __init__(self, asked: Question, name: str, grid: Grid) -> None:
        self.asked, self.grid = asked, grid
        stock, process = catalogue(), find_process(asked.printer)
        self._walls = [wall for wall in _WALLS if wall >= process.wall.advised] or [process.wall.advised]
        least = process.hole.limit
        #: Material over and under a socket, mm.
        self._cover = max(process.wall.limit, SOCKET_COVER) + 0.03
        widest = _BORE * self._widest_pitch()
        self._bores = least, widest
        self._springs = [spring for spring in stock.tubes.enclosed if least <= spring.bore <= widest]
        self._sheaths = stock.tubes
        cast = {material for part in stock.of(Silicone) for material in part.materials}
        self._rubbers = [each for each in (f"silicone-shore-a-{shore}" for shore in _SHORE) if each in cast]
        sheets = [size for size in stock.sizes("membrane.thickness") if isinstance(size, float)]
        self._thicknesses = [size for size in sheets if size >= process.cast_thickness.limit]
        known = (stock.microphone(model) for model in _MICROPHONES)
        self._microphones = [
            {name.removeprefix("microphone."): value for name, value in part.values.items()}
            for part in known
            if part is not None
        ] or [{}]
        resins = [part for part in stock.of(Resin) if asked.printer in part.processes and part.materials]
        names = [chr(ord("A") + k) for k in range(asked.microphones)]
        base = prototype(_BASE).model_dump()
        base.update(
            name=name, microphones=names, lines=grid.lines(names), layout=grid.layout(asked),
            target=asked.target.model_dump(),
            description=f"{grid.points} points {_where(asked)}",
        )  # fmt: skip
        base["printing"] |= {"process": process.name, "glue_gap": max(process.clearance.limit, 0.05)}
        if resins and base["printing"]["material"] not in {each for part in resins for each in part.materials}:
            base["printing"]["material"] = resins[0].materials[0]
        self._base = base

    @property
    def obstacle(self) -> str:
        """Reason in words why no design of the layout can be drawn, as far as one is known."""
        asked, points = self.asked, self.grid.points
        if not self._springs:
            least, widest = self._bores
            return (
                f"no tube of the catalogue has a bore of {least:.2g} mm or more, which {asked.printer} leaves open, "
                f"and of {widest:.2g} mm or less, which points {self._widest_pitch():.3g} mm apart have room for"
            )
        if asked.tubes_below is not None:
            free = Candidates(replace(asked, tubes_below=None), "free", self.grid)
            depths = [depth_below(design) for design, _ in free.drawn(_LOOKED)]
            if depths:
                least = math.ceil(10 * min(depths)) / 10
                return f"microphones take {least:g} mm below the shells, and there are {asked.tubes_below:g} mm"
        if asked.pitch is not None:
            return f"the parts of points {asked.pitch:g} mm apart are in each other's way"
        if asked.size is not None:
            return f"{points} points with their walls and tubes do not fit on {asked.size[0]:g} x {asked.size[1]:g} mm"
        if asked.around is not None:
            return f"{points} points with their walls and tubes do not fit around {asked.around:g} mm"
        return f"the parts of {points} points are in each other's way"

    def _widest_pitch(self) -> float:
        """Distance of neighbours that no design of the layout exceeds, mm."""
        asked, grid = self.asked, self.grid
        if asked.pitch is not None:
            return asked.pitch
        if grid.side == "front":
            return 1.5 * (asked.around or 0.0) / grid.points
        if asked.size is None:
            return PLACES[asked.place].pitch
        return max(asked.size) / max(max(grid.columns, grid.rows) - 1, 1)

    def drawn(self, count: int, near: Sequence[Sizes] = ()) -> list[tuple[ArrayDesign, Sizes]]:
        """Valid designs of so many that are drawn, with the sizes that were drawn.

        Args:
            count: number of draws.
            near: sizes that are taken in turn, a few of them drawn anew; by default all are.
        """
        if not self._springs or not self._rubbers or not self._thicknesses:
            return []
        random = np.random.default_rng([len(near), count, self.grid.points, self.grid.columns])
        found = []
        for number in range(count):
            sizes = self._draw(random)
            if near:
                own = near[number % len(near)]
                sizes |= {name: value for name, value in own.items() if random.random() < _KEPT}
            design = self._of(sizes)
            if design is not None:
                found.append((design, sizes))
        return found

    def _draw(self, random: np.random.Generator) -> Sizes:
        return {
            "wall": random.choice(self._walls),
            "cavity": random.uniform(*_CAVITY),
            "membrane": math.exp(random.uniform(math.log(_MEMBRANE[0]), math.log(_MEMBRANE[1]))),
            "height": random.uniform(*_HEIGHT),
            "spring": self._springs[int(random.integers(len(self._springs)))],
            "sheath": random.random(),
            "rubber": random.choice(self._rubbers),
            "microphone": self._microphones[int(random.integers(len(self._microphones)))],
            "chamber": int(random.integers(len(_CHAMBERS) - 1)),
            "microphone_tube": random.choice(_MICROPHONE_TUBES),
        }

    def _of(self, sizes: Sizes) -> ArrayDesign | None:
        """The design of drawn sizes; None where they do not go together."""
        pitch = self._first_pitch(sizes)
        for _ in range(3):
            if pitch is None:
                return None
            design = self._with_pitch(sizes, pitch)
            if design is None or not self._has_room_below(design):
                return None
            beyond = self._beyond(design)
            if beyond <= 1e-3:
                return design
            if math.isinf(beyond):
                return None
            pitch -= beyond
        return None

    # -- pitch ----------------------------------------------------------------------------------------
    def _first_pitch(self, sizes: Sizes) -> float | None:
        """Distance of neighbouring axes, mm; around a limb the length along the arc, to be refined."""
        asked, grid = self.asked, self.grid
        if grid.side == "front":
            return asked.around / grid.points if asked.around else None
        if asked.pitch is not None:
            return asked.pitch
        if asked.size is None:
            usual = PLACES[asked.place].pitch
            # a row goes around once at most, and the microphones lie between its ends
            return usual if asked.around is None else min(usual, asked.around / (grid.columns + 1))
        gaps = [max(count - 1, 1) for count in (grid.columns, grid.rows)]
        # the shells take what the cavities and walls do; the longer side goes with more points
        sides = sorted(asked.size), sorted(gaps)
        shell = 2 * float(sizes["wall"])
        fits = []
        for side, gap in zip(*sides, strict=True):
            # side = gap p + cavity + 2 walls, cavity = fraction of p - 2 walls
            fits.append((side - shell + float(sizes["cavity"]) * shell) / (gap + float(sizes["cavity"])))
        return min(fits)

    def _beyond(self, design: ArrayDesign) -> float:
        """Length by which the pitch must become smaller for the array to fit its room, mm."""
        asked = self.asked
        if asked.size is None or asked.pitch is not None:
            return 0.0
        try:
            length, width, _ = array_size(design)
        except Refusal:
            return math.inf
        over = []
        for sides in ((length, width), (width, length)):
            each = [
                (side - room) / max(gaps, 1)
                for side, room, gaps in zip(sides, asked.size, self._gaps(design, sides[0] == length), strict=True)
            ]
            over.append(max(each))
        return max(min(over), 0.0)

    def _has_room_below(self, design: ArrayDesign) -> bool:
        """True where the housings of the microphones take no more room below the shells than there is."""
        room = self.asked.tubes_below
        return room is None or depth_below(design) <= room

    def _gaps(self, design: ArrayDesign, along: bool) -> tuple[int, int]:
        columns, rows = min(design.layout.columns, design.point_count), self.grid.rows
        turned = design.layout.microphone_side in ("front", "back")
        gaps = (rows - 1, columns - 1) if turned else (columns - 1, rows - 1)
        return gaps if along else (gaps[1], gaps[0])

    def _with_pitch(self, sizes: Sizes, pitch: float) -> ArrayDesign | None:
        grid = self.grid
        wall, spring = float(sizes["wall"]), sizes["spring"]
        cavity = math.floor(10 * min(float(sizes["cavity"]) * (pitch - 2 * wall), 50.0)) / 10
        if cavity < 0.8 or spring.bore > _BORE * pitch:
            return None
        around = self._sheaths.sheaths_over(spring.outer_diameter)
        outside = around[int(len(around) * sizes["sheath"])][0]
        gap = self._base["printing"]["glue_gap"]
        height = round(max(float(sizes["height"]), outside + 2 * (gap + self._cover), 0.19 * cavity) + 0.05, 1)
        if not _SLENDER[0] <= 2 * height / cavity <= _SLENDER[1]:
            return None
        thickness = min(self._thicknesses, key=lambda each: abs(math.log(each / (sizes["membrane"] * cavity))))
        length = self._length(pitch, cavity, wall, height)
        if length is None or length <= 2 * wall or length < 4 * spring.bore:
            return None
        tube = {
            "length": length, "inner_diameter": spring.bore, "wire_diameter": spring.wire_diameter,
            "outer_diameter": outside,
        }  # fmt: skip
        least = self._least_to_microphone(pitch, cavity, wall, height, spring.outer_diameter, outside)
        to_microphone = {**tube, "length": round(max(float(sizes["microphone_tube"]), least), 1)}
        resonator = {**self._base["resonator"], "cavity_diameter": cavity, "cavity_height": height}
        values: dict[str, Any] = {
            **self._base,
            "resonator": {**resonator, "wall_thickness": wall},
            "membrane": {
                **self._base["membrane"], "material": str(sizes["rubber"]), "thickness": thickness,
                "rim_width": min(wall, _RIM),
            },
            "tube": {**self._base["tube"], **tube},
            "microphone_tube": {**self._base["tube"], **to_microphone},
        }  # fmt: skip
        values["layout"] = {key: value for key, value in values["layout"].items() if value is not None}
        chamber = self._base["microphone"]
        own = {
            "chamber_diameter": max(chamber["chamber_diameter"], 2.1 * spring.bore),
            "chamber_height": round(max(chamber["chamber_height"], outside + 2 * (gap + self._cover)) + 0.005, 2),
        }
        # A socket of a wide tube is wholly in the wall, and the seat of the board begins no thin wall below a socket.
        above = own["chamber_height"] / 2 + outside / 2 + gap - SOCKET_COVER - 0.01
        wall_of_housing = min(chamber["wall_thickness"] * (1 if outside < 1.6 else 2), above)
        own["wall_thickness"] = math.floor(100 * wall_of_housing + 1e-6) / 100
        for factor in _CHAMBERS[sizes["chamber"] if grid.kind in ("area", "hand") else 0 :]:
            wider = {**own, "chamber_diameter": round(factor * own["chamber_diameter"], 2)}
            values["microphone"] = {**chamber, **sizes["microphone"], **wider}
            try:
                return validated(values, str(self._base["name"]))
            except DesignError as error:
                if error.field != "microphone.chamber_diameter":
                    return None
        return None

    def _least_to_microphone(
        self, pitch: float, cavity: float, wall: float, height: float, spring: float, outside: float
    ) -> float:
        """Length with which a microphone tube reaches, mm: beside an area, where two meet, or down below the shells."""
        microphone = self._base["microphone"]
        if self.grid.kind == "area":
            return 0.62 * pitch - cavity / 2 + 2.0
        if self.grid.side != "below":
            return 0.0
        radius = max(1.5 * spring, outside)
        above = microphone["sound_hole_length"] + 1.2 + max(microphone["chamber_height"], outside + 0.5) / 2
        depth = max(height / 2 + self._base["resonator"]["floor_thickness"] + CLEARANCE + above, 2 * radius)
        return wall + math.pi * radius + depth - 2 * radius + float(microphone["wall_thickness"]) + 1.0

    def _length(self, pitch: float, cavity: float, wall: float, height: float) -> float | None:
        """Length of the tubes between points, mm."""
        if self.grid.side != "front":
            return round(pitch - cavity, 3)
        inner, outer = cavity / 2, cavity / 2 + wall
        floor = self._base["resonator"]["floor_thickness"]
        radius = (self.asked.around or 0.0) / (2 * math.pi) + floor + height / 2
        turn = 2 * math.pi / self.grid.points
        if turn <= 2 * math.atan(outer / radius) or turn >= math.pi:
            return None
        return round(wound_length(turn, (inner, inner), (outer, outer), radius), 3)


def depth_below(design: ArrayDesign) -> float:
    """Room that the housings of the microphones take below the shells, mm."""
    microphone, resonator = design.microphone, design.resonator
    housing = microphone.chamber_height / 2 + microphone.wall_thickness
    return usual_depth(design) - resonator.port_axis_height - resonator.floor_thickness + housing


def _where(asked: Question) -> str:
    if asked.kind == "around":
        return f"around {asked.around:g} mm"
    if asked.size is not None:
        return f"within {asked.size[0]:g} x {asked.size[1]:g} mm"
    return PLACES[asked.place].words
