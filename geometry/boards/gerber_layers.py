"""Layers of a circuit board in Gerber format (Ucamco, revision 2021.02) and its holes in Excellon format, in mm."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import pairwise

from geometry.boards.board_pieces import BoardPlan, Layer
from geometry.boards.kicad_board import MASK
from geometry.solids.stroke_font import WIDTH, Point, strokes, text_size

#: Width of the lines of words and of the outline, mm.
_INK, _EDGE = 0.1, 0.05
#: Units of a coordinate per mm.
_UNITS = 1_000_000


class _Gerber:
    """One layer: apertures, each defined once, and what is drawn with them."""

    def __init__(self, function: str) -> None:
        self._function = function
        self._apertures: dict[str, int] = {}
        self._drawn: list[str] = []

    def flash(self, shape: str, place: Point) -> None:
        """Put an aperture at a place."""
        self._take(shape)
        self._drawn.append(f"{_place(place)}D03*")

    def line(self, width: float, places: tuple[Point, ...]) -> None:
        """Draw a line with a round pen."""
        self._take(_disc(width))
        self._drawn.append(f"{_place(places[0])}D02*")
        self._drawn += [f"{_place(place)}D01*" for place in places[1:]]

    def _take(self, shape: str) -> None:
        number = self._apertures.setdefault(shape, 10 + len(self._apertures))
        self._drawn.append(f"D{number}*")

    @property
    def text(self) -> str:
        """The whole file."""
        head = [
            "%TF.GenerationSoftware,acoustic-fem,acoustic-fem*%",
            f"%TF.FileFunction,{self._function}*%",
            "%TF.FilePolarity,Positive*%",
            "%FSLAX46Y46*%",
            "%MOMM*%",
            "%LPD*%",
            "G01*",
        ]
        apertures = [f"%ADD{number}{shape}*%" for shape, number in self._apertures.items()]
        return "\n".join([*head, *apertures, *self._drawn, "M02*"]) + "\n"


def gerber_layers(plan: BoardPlan) -> Mapping[str, str]:
    """Texts of the layers and of the drill files of a board, by the end of their file names."""
    return {
        "F_Cu.gtl": _copper(plan, "top", "Copper,L1,Top"),
        "B_Cu.gbl": _copper(plan, "bottom", "Copper,L2,Bot"),
        "F_Mask.gts": _mask(plan, "Soldermask,Top", "top"),
        "B_Mask.gbs": _mask(plan, "Soldermask,Bot", "bottom"),
        "F_Paste.gtp": _paste(plan),
        "F_Silkscreen.gto": _words(plan),
        "Edge_Cuts.gm1": _outline(plan),
        "PTH.drl": _drills("Plated,1,2,PTH", _plated(plan)),
        "NPTH.drl": _drills(
            "NonPlated,1,2,NPTH", [(bore.diameter, bore.centre) for bore in (plan.sound_hole, plan.tie_hole)]
        ),
    }


def _copper(plan: BoardPlan, layer: Layer, function: str) -> str:
    drawn = _Gerber(function)
    for track in plan.tracks:
        if track.layer == layer:
            drawn.line(track.width, track.places)
    for pad in plan.pads:
        if layer == "top" or pad.drill:
            drawn.flash(_shape(pad.size, pad.is_round), pad.centre)
    if layer == "top":
        drawn.flash(_ring(plan.ring.outer, plan.ring.inner), plan.ring.centre)
    for via in plan.vias:
        drawn.flash(_disc(via.diameter), via.centre)
    return drawn.text


def _mask(plan: BoardPlan, function: str, layer: Layer) -> str:
    """Openings of the solder mask; it covers the vias."""
    drawn, more = _Gerber(function), 2 * MASK
    for pad in plan.pads:
        if layer == "top" or pad.drill:
            drawn.flash(_shape((pad.size[0] + more, pad.size[1] + more), pad.is_round), pad.centre)
    if layer == "top":
        drawn.flash(_ring(plan.ring.outer + more, plan.ring.inner - more), plan.ring.centre)
    for bore in (plan.sound_hole, plan.tie_hole):
        drawn.flash(_disc(bore.diameter), bore.centre)
    return drawn.text


def _paste(plan: BoardPlan) -> str:
    drawn = _Gerber("Paste,Top")
    for pad in plan.pads:
        if not pad.drill:
            drawn.flash(_shape(pad.size, pad.is_round), pad.centre)
    drawn.flash(_ring(plan.ring.outer, plan.ring.inner), plan.ring.centre)
    return drawn.text


def _words(plan: BoardPlan) -> str:
    drawn = _Gerber("Legend,Top")
    for word in plan.words:
        width, height = text_size([word.text], word.height)
        x0, y0 = word.centre[0] - width / 2, word.centre[1] - height / 2
        step = (width - WIDTH * word.height) / max(1, len(word.text) - 1)
        for number, letter in enumerate(word.text):
            for start, end in strokes(letter):
                ends = ((x0 + number * step + WIDTH * word.height * x, y0 + height * y) for x, y in (start, end))
                drawn.line(_INK, tuple(ends))
    if plan.pin_mark is not None:
        drawn.flash(_disc(plan.pin_mark.diameter), plan.pin_mark.centre)
    return drawn.text


def _outline(plan: BoardPlan) -> str:
    drawn = _Gerber("Profile,NP")
    for ends in pairwise((*plan.outline, plan.outline[0])):
        drawn.line(_EDGE, ends)
    return drawn.text


def _plated(plan: BoardPlan) -> Iterator[tuple[float, Point]]:
    for via in plan.vias:
        yield via.drill, via.centre
    for pad in plan.pads:
        if pad.drill:
            yield pad.drill, pad.centre


def _drills(function: str, holes: Iterator[tuple[float, Point]] | list[tuple[float, Point]]) -> str:
    """Excellon file of some holes, each with its diameter."""
    by_size: dict[float, list[Point]] = {}
    for diameter, place in holes:
        by_size.setdefault(diameter, []).append(place)
    lines = ["M48", f"; #@! TF.FileFunction,{function}", "FMAT,2", "METRIC"]
    lines += [f"T{tool}C{diameter:.3f}" for tool, diameter in enumerate(by_size, start=1)]
    lines += ["%", "G05"]
    for tool, places in enumerate(by_size.values(), start=1):
        lines.append(f"T{tool}")
        lines += [f"X{x:.4f}Y{y:.4f}" for x, y in places]
    return "\n".join([*lines, "M30"]) + "\n"


def _shape(size: Point, is_round: bool) -> str:
    return _disc(size[0]) if is_round else f"R,{size[0]:.6f}X{size[1]:.6f}"


def _disc(diameter: float) -> str:
    return f"C,{diameter:.6f}"


def _ring(outer: float, inner: float) -> str:
    return f"C,{outer:.6f}X{inner:.6f}"


def _place(place: Point) -> str:
    return f"X{round(place[0] * _UNITS)}Y{round(place[1] * _UNITS)}"
