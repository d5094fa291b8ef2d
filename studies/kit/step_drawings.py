"""Drawings of the steps of a build that no solid shows, made from the numbers of the design; each SVG as text."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape

from geometry.design.array_design import ArrayDesign
from geometry.ground.refusal import counted
from geometry.molds import plan_mold
from geometry.schema.part_fields import Tube
from geometry.solids.membrane import membrane_profile
from studies.kit.cutting_template import SPARE_PIECES, Strip
from studies.kit.expected_signals import ExpectedSignal
from studies.kit.leak_testing import LeakTest

#: Width of a drawing, in its own units.
_WIDTH = 720.0
_INK, _SILICONE, _SHELL, _SPRING, _SHEATH, _WATER = "#1d2730", "#e39a7b", "#9fb8cc", "#c9a227", "#4a4a4a", "#7fb4dd"


class _Drawing:
    """Shapes and words of one drawing."""

    def __init__(self, height: float, words: str) -> None:
        self._head = (
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {_WIDTH:g} {height:g}" role="img" '
            f'aria-label="{escape(words, quote=True)}">'
        )
        self._shapes: list[str] = []

    def box(self, x: float, y: float, width: float, height: float, fill: str, stroke: str = "none") -> None:
        self._shapes.append(
            f'<rect x="{x:.1f}" y="{y:.1f}" width="{width:.1f}" height="{height:.1f}" fill="{fill}" stroke="{stroke}"/>'
        )

    def outline(self, corners: Sequence[tuple[float, float]], fill: str) -> None:
        points = " ".join(f"{x:.1f},{y:.1f}" for x, y in corners)
        self._shapes.append(f'<polygon points="{points}" fill="{fill}" stroke="{_INK}" stroke-width="0.8"/>')

    def line(self, *places: tuple[float, float], width: float = 1.0, colour: str = _INK) -> None:
        points = " ".join(f"{x:.1f},{y:.1f}" for x, y in places)
        self._shapes.append(
            f'<polyline points="{points}" fill="none" stroke="{colour}" stroke-width="{width:g}" '
            'stroke-linejoin="round"/>'
        )

    def words(self, x: float, y: float, text: str, anchor: str = "start", size: float = 13) -> None:
        self._shapes.append(
            f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" font-size="{size:g}" fill="{_INK}">'
            f"{escape(text)}</text>"
        )

    def span(self, x0: float, x1: float, y: float, text: str) -> None:
        """Dimension along x with its words below."""
        self.line((x0, y), (x1, y))
        for x in (x0, x1):
            self.line((x, y - 5), (x, y + 5))
        self.words((x0 + x1) / 2, y + 18, text, "middle")

    @property
    def text(self) -> str:
        """The drawing as SVG."""
        return "".join((self._head, *self._shapes, "</svg>"))


def membrane_drawing(design: ArrayDesign) -> str:
    """Section of a membrane as it lies on its shell, glued face downwards, with the place to measure."""
    profile = membrane_profile(design)
    radius, top = max(r for r, _ in profile), max(z for _, z in profile)
    scale = min(430 / (2 * radius), 90 / top)
    thickness = design.membrane.thickness
    drawing = _Drawing(200, f"membrane in section: diameter {2 * radius:.3g} mm, thickness {thickness:g} mm")
    middle, floor = _WIDTH / 2, 110.0
    right = [(middle + r * scale, floor - z * scale) for r, z in profile]
    left = [(2 * middle - x, y) for x, y in right]
    drawing.outline([*left[::-1], *right], _SILICONE)
    drawing.span(middle - radius * scale, middle + radius * scale, floor + 22, f"{2 * radius:.4g} mm")
    height = floor - thickness * scale
    drawing.line((middle, height - 32), (middle, height - 2), width=1.5)
    drawing.line((middle - 5, height - 10), (middle, height - 2), (middle + 5, height - 10), width=1.5)
    drawing.words(middle, height - 38, f"measure here: {thickness:g} mm by design", "middle")
    drawing.words(middle, floor + 70, f"glued face: {glued_face_words(design)}", "middle")
    return drawing.text


def glued_face_words(design: ArrayDesign) -> str:
    """Sign by which the glued face of a membrane is seen, because it is wider by too little to be seen."""
    ejector = plan_mold(design).ejector
    if ejector is None:
        return "the one that lay towards the lid, at the top of the mold"
    return f"the one without the {counted(len(ejector.spots), 'mark')} of the plugs; it lay towards the lid of the mold"


def cutting_drawing(strips: Sequence[Strip]) -> str:
    """Every row of the template with its letter, to no scale."""
    shown = strips[:8]
    drawing = _Drawing(24 + 44 * len(shown), f"{len(strips)} rows of pieces to cut, with number and length of each")
    for number, strip in enumerate(shown):
        y = 18 + 44 * number
        colour = _SPRING if strip.what == "spring" else _SHEATH
        drawing.words(8, y + 12, strip.name, size=16)
        drawing.box(36, y, 150, 12, colour)
        for x in (36.0, 186.0):
            drawing.line((x, y - 5), (x, y + 18), width=0.8)
        drawing.words(111, y + 27, f"{strip.length:g} mm", "middle")
        pieces = f"{strip.count} + {SPARE_PIECES} spare x {strip.what}, {strip.diameter:g} mm outside"
        drawing.words(200, y + 3, pieces, size=12)
        rough = "" if strip.rough is None else f"cut {strip.rough:g} mm before shrinking; "
        drawing.words(200, y + 19, f"{rough}{strip.place}", size=12)
    return drawing.text


def socket_drawing(tube: Tube, lip: float, gap: float) -> str:
    """Section of a tube in its socket: spring, sheath, glue, and the lip at which both stop."""
    smooth = tube.bore == "smooth"
    bore, outer = tube.inner_diameter, tube.outer_diameter
    spring = bore if smooth else tube.spring_outer_diameter
    scale = 62 / outer
    axis, face, stop, end = 110.0, 330.0, 180.0, 640.0
    drawing = _Drawing(226, f"tube in its socket: bore {bore:g} mm, outside {outer:g} mm, lip {lip:g} mm")
    drawing.box(60, 20, face - 60, 180, _SHELL)
    hole = (outer / 2 + gap) * scale
    drawing.box(stop, axis - hole, face - stop, 2 * hole, "#fff")
    drawing.box(60, axis - bore / 2 * scale, stop - 60, bore * scale, "#fff")
    for side in (-1, 1):
        wall = (outer - spring) / 2 * scale
        drawing.box(stop, axis + (spring / 2 * scale if side > 0 else -outer / 2 * scale), end - stop, wall, _SHEATH)
        if not smooth:
            wire = (spring - bore) / 2 * scale
            drawing.box(stop, axis + (bore / 2 * scale if side > 0 else -spring / 2 * scale), end - stop, wire, _SPRING)
        edge = axis + side * hole
        drawing.outline([(face, edge + side * 14), (face, edge - side * gap * scale), (face + 22, edge)], "#f2d16b")
    drawing.line((120, 56), (120, axis - bore / 2 * scale - 3))
    drawing.words(66, 36, "cavity side: the lip", size=12)
    drawing.words(66, 51, "carries on the bore", size=12)
    drawing.line((face + 14, axis + hole + 8), (face + 60, 190))
    drawing.words(face + 64, 196, f"bead of glue; it creeps into the gap of {gap:g} mm", size=12)
    drawing.words(end - 8, axis - outer / 2 * scale - 8, "tubing" if smooth else "sheath over spring", "end", 12)
    drawing.words(stop + 6, axis + hole + 16, "stop", size=12)
    drawing.words(end - 8, axis + 4, f"bore {bore:g} mm", "end", 12)
    return drawing.text


def leak_drawing(test: LeakTest) -> str:
    """Set-up of a leak test: syringe, tee and water gauge at one port, clay on the other."""
    drawing = _Drawing(290, f"leak test: water gauge of {test.water:.0f} mm at one port, the other port closed")
    drawing.box(60, 190, 110, 26, "#fff", _INK)
    drawing.box(20, 199, 40, 8, _INK)
    drawing.box(110, 193, 56, 20, "#e8ebee")
    drawing.words(115, 240, "syringe of 1 ml", "middle")
    drawing.line((170, 203), (250, 203), (430, 203), width=4, colour="#8a97a3")
    drawing.words(250, 192, "tee", "middle")
    drawing.line((250, 203), (250, 262), (310, 262), (310, 24), width=6, colour="#cfd8df")
    drawing.line((250, 232), (250, 262), (310, 262), (310, 60), width=4, colour=_WATER)
    drawing.line((330, 60), (330, 232))
    drawing.line((244, 232), (336, 232), width=0.7)
    for y in (60.0, 232.0):
        drawing.line((325, y), (335, y))
    drawing.words(296, 104, f"{test.water:.0f} mm of water", "end")
    drawing.words(296, 122, f"= {test.pressure:.0f} Pa", "end")
    drawing.words(322, 283, "hose of 2 mm", size=12)
    drawing.box(430, 168, 130, 62, _SHELL, _INK)
    drawing.box(455, 168, 80, 44, "#fff")
    drawing.box(430, 199, 25, 8, "#fff")
    drawing.box(535, 199, 25, 8, "#fff")
    drawing.outline([(440, 168), (470, 158), (495, 155), (520, 158), (550, 168)], _SILICONE)
    drawing.words(495, 138, f"rises by {test.bulge:.2g} mm in the middle", "middle")
    drawing.box(560, 190, 22, 26, "#b08fc7")
    drawing.words(590, 208, "modelling clay", size=12)
    return drawing.text


def signal_drawing(signals: Sequence[ExpectedSignal], most: int = 72) -> str:
    """Expected difference of the two loudest microphones, a bar for every point."""
    shown = signals[:most]
    largest = max([abs(each.difference) for each in shown] + [1.0])
    drawing = _Drawing(230, "expected level difference of the two loudest microphones for every point, dB")
    step = 640 / len(shown)
    names = sorted({each.louder for each in shown})
    tints = {name: ("#2a6f97", "#b5651d", "#4f7f6b", "#7a5195", "#9c211a")[k % 5] for k, name in enumerate(names)}
    for number, each in enumerate(shown):
        height = 150 * each.difference / largest
        x = 60 + number * step
        drawing.box(x + 0.1 * step, 180 - height, 0.8 * step, max(height, 1.0), tints[each.louder])
        if len(shown) <= 24 or each.point % 8 == 0:
            drawing.words(x + step / 2, 198, str(each.point), "middle", 12)
    drawing.line((60, 180), (700, 180))
    drawing.words(56, 34, f"{largest:.1f} dB", "end", 12)
    drawing.line((58, 30), (64, 30))
    drawing.words(56, 184, "0", "end", 12)
    drawing.words(
        380, 220, "point; colour: " + ", ".join(f"microphone {name} louder" for name in names[:4]), "middle", 12
    )
    return drawing.text
