"""Drawing of a circuit board from above, as SVG: outline, copper, holes, words and the axis of the chamber."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from html import escape

from geometry.boards.board_pieces import BoardPad, BoardPlan
from geometry.solids.stroke_font import Point

#: Width of the drawing in its own units, and the space around the board, mm.
_WIDTH, _AROUND = 720.0, 1.0
_BOARD, _TOP, _BOTTOM, _PAD, _HOLE, _INK = "#1f5f3f", "#b5893a", "#4d7fa8", "#e3c26b", "#ffffff", "#1d2730"


def board_drawing(plan: BoardPlan, words: str) -> str:
    """Board from the side of the microphone, with its slot to the left.

    Args:
        plan: the board.
        words: description for people who do not see it.

    Returns:
        SVG, with a legend below the board.
    """
    length, width = plan.size
    scale = _WIDTH / (length + 2 * _AROUND)
    left = min(x for x, _ in plan.outline) - _AROUND
    top = max(y for _, y in plan.outline) + _AROUND
    height = (width + 2 * _AROUND) * scale + 44
    head = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {_WIDTH:g} {height:.0f}" role="img" aria-label='
    shapes = _shapes(plan, lambda place: ((place[0] - left) * scale, (top - place[1]) * scale), scale)
    legend = (("copper above", _TOP), ("copper below", _BOTTOM), ("pad", _PAD), ("hole", _HOLE))
    marks = []
    for number, (name, colour) in enumerate(legend):
        x = 12 + 170 * number
        marks.append(f'<rect x="{x}" y="{height - 26:.0f}" width="14" height="14" fill="{colour}" stroke="{_INK}"/>')
        marks.append(f'<text x="{x + 20}" y="{height - 14:.0f}" font-size="14" fill="{_INK}">{name}</text>')
    return "\n".join([f'{head}"{escape(words, quote=True)}">', *shapes, *marks, "</svg>"])


def _shapes(plan: BoardPlan, at: Callable[[Point], Point], scale: float) -> Iterator[str]:
    yield _polygon([at(corner) for corner in plan.outline], _BOARD)
    for layer, colour in (("bottom", _BOTTOM), ("top", _TOP)):
        for track in plan.tracks:
            if track.layer == layer:
                yield _line([at(place) for place in track.places], colour, track.width * scale)
    ring, hole, tie = plan.ring, plan.sound_hole, plan.tie_hole
    mean, broad = (ring.inner + ring.outer) / 4 * scale, (ring.outer - ring.inner) / 2 * scale
    x, y = at(ring.centre)
    yield f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{mean:.1f}" fill="none" stroke="{_PAD}" stroke-width="{broad:.1f}"/>'
    for via in plan.vias:
        yield _disc(at(via.centre), via.diameter * scale / 2, _TOP)
        yield _disc(at(via.centre), via.drill * scale / 2, _HOLE)
    for pad in plan.pads:
        yield from _pad(pad, at(pad.centre), scale)
    for bore in (hole, tie):
        yield _disc(at(bore.centre), bore.diameter * scale / 2, _HOLE)
    (x0, y1), (x1, y0) = at(plan.package[0]), at(plan.package[1])
    yield (
        f'<rect x="{x0:.1f}" y="{y0:.1f}" width="{x1 - x0:.1f}" height="{y1 - y0:.1f}" fill="none" stroke="#ffffff" '
        'stroke-dasharray="5 4"/>'
    )
    if plan.pin_mark is not None:
        x, y = at(plan.pin_mark.centre)
        yield f'<g class="pin-mark">{_disc((x, y), plan.pin_mark.diameter * scale / 2, "#ffffff")}</g>'
        yield (
            f'<text x="{x + 0.3 * scale:.1f}" y="{y + 5:.1f}" font-size="14" fill="#ffffff">'
            f"pin 1 of {plan.pads[0].part}</text>"
        )
    for word in plan.words:
        x, y = at(word.centre)
        yield (
            f'<text x="{x:.1f}" y="{y + 0.36 * word.height * scale:.1f}" text-anchor="middle" '
            f'font-size="{1.05 * word.height * scale:.1f}" fill="#ffffff">{escape(word.text)}</text>'
        )
    x, y = at((0.0, 0.0))
    yield (
        f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{plan.chamber / 2 * scale:.1f}" fill="none" stroke="#ffffff" '
        'stroke-width="1.5" stroke-dasharray="2 4"/>'
    )
    yield _line([(x - 7, y), (x + 7, y)], "#ffffff", 1.0)
    yield _line([(x, y - 7), (x, y + 7)], "#ffffff", 1.0)


def _pad(pad: BoardPad, place: Point, scale: float) -> Iterator[str]:
    (x, y), (length, width) = place, (pad.size[0] * scale, pad.size[1] * scale)
    if pad.is_round:
        yield _disc(place, length / 2, _PAD)
    else:
        yield (
            f'<rect x="{x - length / 2:.1f}" y="{y - width / 2:.1f}" width="{length:.1f}" height="{width:.1f}" '
            f'fill="{_PAD}"/>'
        )
    if pad.drill:
        yield _disc(place, pad.drill * scale / 2, _HOLE)
    if pad.part != "C1":
        yield (
            f'<text x="{x:.1f}" y="{y + 5:.1f}" text-anchor="middle" font-size="14" fill="{_INK}">'
            f"{escape(pad.number)}</text>"
        )


def _polygon(corners: list[Point], fill: str) -> str:
    points = " ".join(f"{x:.1f},{y:.1f}" for x, y in corners)
    return f'<polygon points="{points}" fill="{fill}" stroke="{_INK}"/>'


def _line(places: list[Point], colour: str, width: float) -> str:
    points = " ".join(f"{x:.1f},{y:.1f}" for x, y in dict.fromkeys(places))
    shape = f'<polyline points="{points}" fill="none" stroke="{colour}" stroke-width="{width:.1f}"'
    return f'{shape} stroke-linejoin="round" stroke-linecap="round"/>'


def _disc(place: Point, radius: float, fill: str) -> str:
    return f'<circle cx="{place[0]:.1f}" cy="{place[1]:.1f}" r="{radius:.1f}" fill="{fill}"/>'
