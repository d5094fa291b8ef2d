"""Cutting list of springs and sheaths, and their template at full scale as DXF and PDF: lay a piece on it and cut."""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from geometry.assembly.bill import Waste
from geometry.design.array_design import ArrayDesign
from geometry.ground.whole_files import whole_file, write_text
from geometry.layout.cutting import Cut, cutting_list
from geometry.layout.placement import ArrayLayout
from geometry.stock import Sleeve, catalogue
from studies.output.figure_style import figure_in_style

if TYPE_CHECKING:
    from matplotlib.axes import Axes

#: Pages that the template is printed on, mm.
PAGES = {"a4": (210.0, 297.0), "letter": (215.9, 279.4)}
#: Margin of a page, and longest piece that is drawn in one stretch, mm.
_MARGIN, LONGEST = 15.0, 170.0
#: Height of a row of the template and of its words, mm, and pieces that a row shows at most.
_ROW, _WORDS, _MOST = 16.0, 3.0, 20
#: Length of the bar by which the scale of a print is checked, mm.
SCALE_BAR = 100.0
#: Fraction of its length that a heat-shrink sleeve may lose while it shrinks: assumed.
SLEEVE_SHORTENS = 0.1
#: Spare pieces of each row.
SPARE_PIECES = 1
#: Height of a piece that is thinner than this in the drawing, mm, so that it can be seen.
_LEAST_HEIGHT = 1.0


@dataclass(frozen=True)
class Strip:
    """Equal pieces beside each other, as one row of the template."""

    name: str
    """Letter by which the row is called."""
    what: str
    """``spring``, ``sheath`` or ``tubing``."""
    length: float
    """Length of a piece, mm."""
    count: int
    """Number of pieces that the array takes."""
    diameter: float
    """Outside diameter of a piece, mm."""
    place: str
    """Words that say where it goes."""
    rough: float | None = None
    """Length to which a heat-shrink sleeve is cut before it is shrunk, mm; None for what does not shrink."""

    @property
    def title(self) -> str:
        """Words beside the row."""
        first = "" if self.rough is None else f" (sleeve: cut {self.rough:g} mm, shrink, then trim here)"
        pieces = f"{self.count} + {SPARE_PIECES} spare"
        return f"{self.name}  {self.what} {self.diameter:g} mm: {pieces} x {self.length:g} mm{first}, {self.place}"

    @property
    def boxes(self) -> tuple[tuple[float, float], ...]:
        """Begin and end of every piece that is drawn, mm from the stop; one that is too long is drawn up to a match
        mark.
        """
        if self.length > LONGEST:
            return ((0.0, LONGEST),)
        pitch = self.length + Waste().cutting_loss
        shown = max(1, min(self.count + SPARE_PIECES, _MOST, int((LONGEST + Waste().cutting_loss) / pitch)))
        return tuple((number * pitch, number * pitch + self.length) for number in range(shown))


def rough_length(length: float) -> float:
    """Length to which a heat-shrink sleeve is cut so that enough is left to trim it to a length, mm, in half mm."""
    return math.ceil(2 * length / (1 - SLEEVE_SHORTENS)) / 2


def template_strips(design: ArrayDesign, layout: ArrayLayout | None = None) -> tuple[Strip, ...]:
    """Rows of the template, springs before the sheaths over them; pieces of one length and diameter share a row."""
    rows: dict[tuple[str, float, float, bool], list[Cut]] = {}
    for cut in cutting_list(design, layout):
        for piece in _pieces(cut):
            rows.setdefault(piece, []).append(cut)
    ordered = sorted(rows.items(), key=lambda row: row[0][0] != "spring")
    return tuple(
        Strip(
            _letter(number), what, length, sum(cut.count for cut in cuts), diameter,
            "; ".join(dict.fromkeys(cut.place for cut in cuts)), rough_length(length) if shrinks else None,
        )
        for number, ((what, length, diameter, shrinks), cuts) in enumerate(ordered)
    )  # fmt: skip


def write_cutting(design: ArrayDesign, layout: ArrayLayout, folder: Path) -> tuple[Strip, ...]:
    """Write ``cutting-list.csv`` and the template as DXF and, for two sizes of paper, PDF into a folder that exists.

    Returns:
        The rows of the template.
    """
    strips = template_strips(design, layout)
    write_text(folder / "cutting-list.csv", _csv(strips))
    with whole_file(folder / "cutting-template.dxf") as beside:
        write_dxf(strips, design.name, beside)
    for page in PAGES:
        with whole_file(folder / f"cutting-template-{page}.pdf") as beside:
            write_pdf(strips, design.name, beside, page)
    return strips


def write_dxf(strips: Sequence[Strip], title: str, path: Path) -> None:
    """Write the template as DXF in mm: a closed outline for every piece, layers for springs, sheaths, words, scale."""
    import ezdxf
    from ezdxf import units

    fixed = ezdxf.options.write_fixed_meta_data_for_testing
    # Dates and identifiers of the file would make two writings of one design differ.
    ezdxf.options.write_fixed_meta_data_for_testing = True
    try:
        drawing = ezdxf.new("R2010", units=units.MM)
        for layer, colour in (("spring", 30), ("sheath", 8), ("tubing", 8), ("words", 7), ("scale", 1)):
            drawing.layers.add(layer, color=colour)
        space: Any = drawing.modelspace()
        for number, strip in enumerate(strips):
            y = -number * _ROW
            height = max(strip.diameter, _LEAST_HEIGHT)
            for begin, end in strip.boxes:
                corners = [(begin, y), (end, y), (end, y + height), (begin, y + height)]
                space.add_lwpolyline(corners, close=True, dxfattribs={"layer": strip.what})
            words = {"layer": "words", "height": _WORDS}
            space.add_text(strip.title, dxfattribs=words).set_placement((0, y + height + 1.5))
        bottom = -len(strips) * _ROW
        space.add_line((0, bottom), (SCALE_BAR, bottom), dxfattribs={"layer": "scale"})
        words = {"layer": "words", "height": _WORDS}
        space.add_text(f"{title}: this bar is {SCALE_BAR:g} mm", dxfattribs=words).set_placement((0, bottom + 1.5))
        # A file lists its classes in the order of a set, which differs from one process to the next.
        drawing.classes.add_required_classes(drawing.dxfversion)
        drawing.classes.classes = dict(sorted(drawing.classes.classes.items()))
        drawing.saveas(path)
    finally:
        ezdxf.options.write_fixed_meta_data_for_testing = fixed


def write_pdf(strips: Sequence[Strip], title: str, path: Path, page: str = "a4") -> int:
    """Write the template as PDF at full scale, with a bar to check the scale on every page.

    Args:
        strips: rows of :func:`template_strips`.
        title: name of the design.
        path: of the file.
        page: size of paper, of :data:`PAGES`.

    Returns:
        Number of pages.
    """
    from matplotlib.backends.backend_pdf import PdfPages

    width, height = PAGES[page]
    rows = int((height - 2 * _MARGIN - 30) / _ROW)
    sheets = [strips[first : first + rows] for first in range(0, max(len(strips), 1), rows)]
    with PdfPages(path, metadata={"Title": f"{title}: cutting template"}) as file:
        for number, sheet in enumerate(sheets, start=1):
            with figure_in_style((width / 25.4, height / 25.4), **{"pdf.fonttype": 42}) as figure:
                figure.set_layout_engine("none")  # a millimetre of the axes is one of the paper
                axes = figure.add_axes((0.0, 0.0, 1.0, 1.0))
                axes.set(xlim=(0, width), ylim=(0, height))
                axes.set_axis_off()
                _draw_page(axes, sheet, f"{title}: cutting template, page {number} of {len(sheets)}", height)
                file.savefig(figure)
    return len(sheets)


def _draw_page(axes: Axes, strips: Sequence[Strip], title: str, height: float) -> None:
    from matplotlib.patches import Rectangle

    left, top = _MARGIN, height - _MARGIN
    axes.text(left, top, title, fontsize=13, va="top")
    words = "Print at 100 %, without fitting to the page. Measure the bar before you cut."
    axes.text(left, top - 10, words, fontsize=9)
    bar = top - 18
    axes.plot([left, left + SCALE_BAR], [bar, bar], color="black", linewidth=0.8)
    for end in (0.0, SCALE_BAR):
        axes.plot([left + end] * 2, [bar - 2, bar + 2], color="black", linewidth=0.8)
    axes.text(left + SCALE_BAR + 3, bar, f"{SCALE_BAR:g} mm", fontsize=9, va="center")
    for number, strip in enumerate(strips):
        y = bar - 12 - number * _ROW
        size = max(strip.diameter, _LEAST_HEIGHT)
        axes.text(left, y + size + 2.5, strip.title, fontsize=8)
        colour = "#c9a227" if strip.what == "spring" else "#d9d9d9"
        for begin, end in strip.boxes:
            axes.add_patch(Rectangle((left + begin, y), end - begin, size, facecolor=colour, edgecolor="none"))
            for x in (begin, end):
                axes.plot([left + x] * 2, [y - 2, y + size + 1], color="black", linewidth=0.4)
        if strip.length > LONGEST:
            rest = strip.length - LONGEST
            words = f"mark at {LONGEST:g} mm, move it to the stop, cut {rest:g} mm further on"
            axes.text(left, y - 3.5, words, fontsize=7)


def _pieces(cut: Cut) -> Iterator[tuple[str, float, float, bool]]:
    """Kind, length and outside diameter of the pieces of a cut, and whether they are sleeves that shrink."""
    tube = cut.tube
    if tube.bore != "smooth":
        yield "spring", cut.spring_length, tube.spring_outer_diameter, False
    what = "tubing" if tube.bore == "smooth" else "sheath"
    yield what, cut.cut_length, tube.outer_diameter, isinstance(catalogue().sheath(tube).part, Sleeve)


def _letter(number: int) -> str:
    """A, B, ... Z, A1, B1, ..."""
    return chr(ord("A") + number % 26) + (str(number // 26) if number >= 26 else "")


def _csv(strips: Sequence[Strip]) -> str:
    text = io.StringIO()
    table = csv.writer(text, lineterminator="\n")
    loss = Waste().cutting_loss
    sizes = ("length (mm)", "cut before shrinking (mm)", "outside (mm)", f"in all with {loss:g} mm lost a cut (m)")
    table.writerow(["row", "what", "pieces", "spare", *sizes, "where it goes"])
    for strip in strips:
        rough = "" if strip.rough is None else f"{strip.rough:g}"
        total = (strip.count + SPARE_PIECES) * ((strip.rough or strip.length) + loss) / 1000
        lengths = (f"{strip.length:g}", rough, f"{strip.diameter:g}", f"{total:.3g}")
        table.writerow([strip.name, strip.what, strip.count, SPARE_PIECES, *lengths, strip.place])
    return text.getvalue()
