"""Check of a design before it is solved: counts, wiring, print findings, validity of the models."""

from __future__ import annotations

import warnings
from collections import Counter
from collections.abc import Mapping, Sequence
from contextlib import AbstractContextManager
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any, Literal

import numpy as np

import acoustic_fem
from acoustic_fem.atlas.cell_in_atlas import check_cell
from acoustic_fem.atlas.cell_table import OutsideAtlas, cell_atlas
from acoustic_fem.atlas.fidelity_choice import QuickFidelity, quick_fidelity
from acoustic_fem.cell.design_cells import SECONDS_PER_CELL
from acoustic_fem.quantities.local_air import design_air
from acoustic_fem.quantities.model_limit_warning import ModelLimitWarning
from geometry import build_parts, print_report
from geometry.air.cells import Cell, cell_catalogue
from geometry.assembly.fit import misfits
from geometry.assembly.model import array_model
from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import DesignLike, resolve_design
from geometry.ground.extras import check_extras, is_installed
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.shown import Shown
from geometry.ground.typed import PathLike
from geometry.layout.arrangement import lay_out
from geometry.layout.overlaps import overlaps, schematic_notes
from geometry.layout.placement import ArrayLayout
from geometry.layout.remedies import fix_for
from geometry.layout.size import array_size
from geometry.plan.wiring_graph import WiringCounts, wiring_counts
from geometry.printing.printability import PrintReport
from geometry.printing.report_files import report_content
from geometry.schema.field_errors import DesignError
from geometry.schema.part_fields import Tube
from geometry.stock import StockFit, catalogue
from localize.signals.stimulus import BAND
from studies.metrics.covered_area import Uncovered, coverage, most_uncovered
from studies.metrics.pairs import worst_heard
from studies.output.display import Display, Report
from studies.output.folders import check_new_file, new_picture, write_json
from studies.run.enclosed_air import EnclosedFindings, enclosed_findings
from studies.run.quality import DesignQuality, design_quality, draw_quality
from studies.run.shaking import ShakenFindings, shaken_findings
from studies.run.validity import Validity, model_validity
from studies.verdict.measuring import Drawn
from studies.verdict.verdict import Verdict

#: Warnings on limits that the check lists under validity.
_LISTED = "membrane: "
#: Frequencies of the estimated attenuation, Hz.
ATTENUATION_AT = (1.0, 10.0, 100.0)
#: Largest difference of lumped from Navier-Stokes transfer functions as `run` measured it: percent, degrees.
LUMPED_IS_OFF = (("array-2x6", 0.3, 0.2), ("line-3", 1.7, 0.6))
#: The same for the scalar model, which is wrong where a tube opens into a cavity.
HELMHOLTZ_IS_OFF = (("array-2x6", 6.2, 1.2), ("fingertip-3x4", 9.8, 2.0))


@dataclass(frozen=True)
class KindUse:
    """Kind of point or of tube that the patterns of a design name, and how many of it there are."""

    name: str
    """Name of the kind; empty for points and tubes of lines without a pattern."""
    what: Literal["point", "tube"]
    """Kind of what it is: of a sensing point, or of a tube between two."""
    sizes: str
    """Sizes that tell it from others, in words."""
    count: int
    """Number of places of all lines that have it."""


@dataclass(frozen=True, repr=False)
class DesignCheck(Shown):
    """Findings on a design before it is solved: everything that ``acoustic-fem check`` prints."""

    design: ArrayDesign
    """Design that was checked."""
    wiring: WiringCounts
    """Number of points, lines and transducers, against the usual wirings."""
    size: tuple[float, float, float]
    """Extent along x, y and z, mm: that of :func:`geometry.layout.size.array_size`."""
    coverage: float
    """Fraction of its area in which the target's contact touches a membrane, see :func:`studies.metrics.coverage`."""
    cells: tuple[tuple[Cell, int], ...]
    """Distinct cells and how many places of the array each fills."""
    kinds: tuple[KindUse, ...]
    """Kinds of points and tubes with their numbers; empty where no line has a pattern."""
    notes: tuple[str, ...]
    """Notes on microphones whose tubes are drawn for the eye only."""
    overlaps: tuple[str, ...]
    """Lines on what of the layout cannot be built: parts in each other's way, tubes bent too far."""
    mend: str
    """Change that would remove the overlaps; empty where there are none, or none is known."""
    part_counts: Mapping[str, int]
    """Number of each part; empty where none was drawn, for nothing is installed that draws."""
    misfits: tuple[str, ...]
    """Lines on what keeps the parts, as drawn, from being put together."""
    printing: PrintReport | None
    """Report of the print rules on the parts; None where none was drawn."""
    validity: tuple[Validity, ...]
    """Assumptions of the models, each against its limit."""
    attenuation: tuple[tuple[float, float, int], ...]
    """Frequency (Hz), then of the point with the weakest response: level at its second-loudest microphone (dB; a ratio
    needs two) and number."""
    fidelity: QuickFidelity
    """Fidelity of the attenuation: the atlas, or another one and why."""
    enclosed: EnclosedFindings
    """Effect of the air that the sensor encloses when it is worn or carried up, and the vent that would help."""
    shaken: ShakenFindings
    """Effect of motion: a waved hand and a knock on the table, against the target's touch."""
    stock: StockFit
    """Parts that the design is bought as, and what the catalogue lacks."""
    quality: DesignQuality | None = None
    """How good it is; None where that was not asked, there is nothing to tell apart, or nothing to judge it with."""
    verdict: Verdict | None = None
    """Verdict with its reasons and remedies; None where the quality was not asked."""

    def shown(self) -> tuple[str, Mapping[str, object]]:
        """Title and facts that a session and a notebook show."""
        quality = self.quality
        return f"Check of {self.design.name}", {
            "verdict": "" if self.verdict is None else self.verdict.outcome,
            "size": f"{self.size[0]:.4g} x {self.size[1]:.4g} x {self.size[2]:.4g} mm",
            "points": self.design.point_count,
            "coverage": f"{self.coverage:.0%}",
            "cells": f"{len(self.cells)} distinct",
            "not in the catalogue": ", ".join((*(each.field for each in self.stock.changes), *self.stock.missing)),
            "predicted top-1 accuracy": "" if quality is None else quality.accuracy,
            "problems": f"{len(self.problems)}, the first: {self.problems[0]}" if self.problems else "none",
            "fix": self.mend,
        }

    @property
    def covered(self) -> str:
        """Line on the fraction of the area in which a finger reaches a membrane."""
        radius = self.design.target.contact_radius
        share = f"coverage {self.coverage:.0%}: area where a contact of {radius:g} mm radius touches a membrane"
        return share if self.uncovered is None else f"{share}; {self.uncovered.words}"

    @property
    def uncovered(self) -> Uncovered | None:
        """Place of the body that is furthest from a membrane; None unless a fit laid the array on one."""
        return most_uncovered(self.design)

    @property
    def fidelities(self) -> tuple[str, ...]:
        """Lines on the cost of each fidelity and its difference from the default."""
        return fidelity_lines(self.design, [cell for cell, _ in self.cells], self.fidelity.too_large)

    @property
    def failures(self) -> tuple[str, ...]:
        """Lines on the problems that prevent the array from being made."""
        return tuple(
            f"{f.part}: {f.rule} {f.value:.3g} {f.unit} must be {f.relation} {f.limit:.3g} {f.unit}".replace(
                "  ", " "
            ).rstrip()
            for f in (() if self.printing is None else self.printing.findings)
            if f.verdict == "fail"
        )

    @property
    def drawn(self) -> Drawn | None:
        """Findings on the drawn parts that a verdict needs; None if no part was drawn."""
        if self.printing is None:
            return None
        return Drawn(self.misfits, tuple(each for each in self.printing.findings if each.verdict == "fail"))

    @property
    def problems(self) -> tuple[str, ...]:
        """Lines on the reasons why the array cannot be made; empty if it can be made.

        If a layout cannot be built, its parts also overlap in the drawing. Such a problem is listed once, for the
        layout.
        """
        return self.overlaps or self.misfits or self.failures

    @property
    def buildability(self) -> str:
        """Words on making the array: valid as far as it was checked, or impossible to build or to print."""
        if self.overlaps or self.misfits:
            return "cannot be built"
        if self.printing is None:
            return "can be laid out; its parts were not drawn"
        return "cannot be printed" if self.failures else "can be built: layout, parts and fit are checked"

    @property
    def error(self) -> DesignError | None:
        """Error with all problems of a design that cannot be made; None if it can be made."""
        if not self.problems:
            return None
        return DesignError.of_notes(self.design.name, self.problems, self.buildability, self.mend)

    def to_dict(self) -> dict[str, Any]:
        """Findings as JSON can hold them."""
        return {
            "design": self.design.name,
            "wiring": asdict(self.wiring),
            "size_mm": list(self.size),
            "coverage": self.coverage,
            "uncovered": None if self.uncovered is None else asdict(self.uncovered),
            "cells": [{"cell": cell.label, "places": count} for cell, count in self.cells],
            "kinds": [asdict(kind) for kind in self.kinds],
            "layout_notes": list(self.notes),
            "overlaps": list(self.overlaps),
            "mend": self.mend,
            "fidelities": list(self.fidelities),
            "parts": dict(self.part_counts),
            "misfits": list(self.misfits),
            "printing": None if self.printing is None else report_content(self.printing),
            "validity": [{**asdict(item), "holds": item.holds} for item in self.validity],
            "attenuation": [
                {"frequency_hz": f, "second_microphone_db": level, "point": point}
                for f, level, point in self.attenuation
            ],
            "fidelity": self.fidelity.words,
            "enclosed": self.enclosed.to_dict(),
            "shaken": self.shaken.to_dict(),
            "stock": self.stock.to_dict(),
            "quality": None if self.quality is None else self.quality.to_dict(),
            "verdict": None if self.verdict is None else self.verdict.to_dict(),
        }


def check_design(
    design: DesignLike,
    out: PathLike | None = None,
    *,
    picture: PathLike | None = None,
    quality: bool = True,
    display: Display | None = None,
) -> DesignCheck:
    """Findings on a design: its layout, its parts compared with the print rules, and the assumptions of the models
    compared with their limits.

    Without the extra ``cad`` the parts are not checked, and without ``train`` the accuracy is not predicted. The
    findings say so.

    Args:
        design: the array: a design, the path of its file, or the name of a prototype.
        out: a JSON file for all findings; an earlier one is replaced.
        picture: a file, ``.png`` by default, for a plan view of the array with each point coloured by its predicted
            accuracy.
        quality: whether to give the verdict and predict the accuracy with :func:`studies.run.design_quality`. For a
            picture the accuracy is always predicted.
        display: shows progress.

    Raises:
        Refusal: no such design, a part cannot be built, the membrane's proportions are outside what can be solved, a
            file cannot be written, or a picture is asked for of a design with one point or microphone.
    """
    path = None if out is None else Path(out)
    design = resolve_design(design)
    check_new_file(path, ".json")
    drawn = new_picture(picture, option="picture")
    if drawn is not None:
        check_extras("what judges points", "train")
    judge = drawn is not None or (quality and is_installed("train"))
    catalogue()  # before any work: a file of own parts may be wrong
    steps = _Steps(display or Display(), 3 + 3 * is_installed("cad") + judge + quality)
    found = _judged(design, steps)
    if quality:
        with steps("Verdict and remedies") as report:
            found = replace(found, verdict=_verdict(found, report))
    if judge:
        with steps("How good it is") as report, warnings.catch_warnings():
            warnings.simplefilter("ignore", ModelLimitWarning)
            warnings.filterwarnings("ignore", _LISTED, UserWarning)
            found = replace(found, quality=design_quality(design, report))
    if path is not None:
        write_json(path, found.to_dict())
    if drawn is not None:
        if found.quality is None:
            problem = "needs a design of at least two points and two microphones"
            raise Refusal(problem, kind=Kind.UNSUITABLE, field="picture")
        draw_quality(design, found.quality, drawn)
    return found


def _verdict(found: DesignCheck, report: Report) -> Verdict:
    """The verdict with what the drawn parts show; its remedies are computed now."""
    verdict = Verdict(found.design, drawn=found.drawn)
    verdict.compute(report)
    return verdict


@dataclass(frozen=True)
class _Steps:
    """Stages of a display, of which it is known how many there are."""

    display: Display
    count: int

    def __call__(self, name: str) -> AbstractContextManager[Report]:
        return self.display.stage(name, of=self.count)


def _judged(design: ArrayDesign, steps: _Steps) -> DesignCheck:
    with steps("Layout"):
        layout = lay_out(design)
        found = overlaps(design, layout)
    with steps("Attenuation") as report, warnings.catch_warnings():
        warnings.simplefilter("ignore", ModelLimitWarning)
        warnings.filterwarnings("ignore", _LISTED, UserWarning)
        fidelity = quick_fidelity(design, ATTENUATION_AT)
        library = acoustic_fem.solve(design, ATTENUATION_AT, fidelity.name, progress=report)
    levels = [(frequency, *worst_heard(library.transfer_function, frequency)) for frequency in ATTENUATION_AT]
    with steps("Enclosed air"):
        enclosed = enclosed_findings(design, library)
        shaken = shaken_findings(design, library)
    counts, in_the_way, printing = _drawn(design, layout, steps) if is_installed("cad") else ({}, (), None)
    return DesignCheck(
        design=design,
        wiring=wiring_counts(len(design.microphones), [line.points for line in design.lines]),
        size=array_size(design, layout),
        coverage=coverage(design, design.target.contact_radius, layout),
        cells=cell_uses(design, layout),
        kinds=kind_uses(design),
        notes=schematic_notes(design, layout),
        overlaps=found,
        mend=fix_for(design) if found else "",
        part_counts=counts,
        misfits=in_the_way,
        printing=printing,
        validity=model_validity(design, library.medium, levels[-1][1]),
        attenuation=tuple(levels),
        fidelity=fidelity,
        enclosed=enclosed,
        shaken=shaken,
        stock=catalogue().fit(design),
    )


def _drawn(
    design: ArrayDesign, layout: ArrayLayout, steps: _Steps
) -> tuple[Mapping[str, int], tuple[str, ...], PrintReport]:
    """Numbers of the parts, what keeps them from being put together, and what the print rules say of them."""
    with steps("Parts"):
        parts = build_parts(design, layout)
    with steps("Fit"):
        try:
            in_the_way = misfits(array_model(design, parts, layout))
        except Refusal as error:  # a tube that bends into itself is no solid
            in_the_way = (str(error),)
    with steps("Print rules") as report:
        printing = print_report(parts, design=design, progress=report)
    return parts.counts, in_the_way, printing


def fidelity_lines(design: ArrayDesign, cells: Sequence[Cell], too_large: str = "") -> tuple[str, ...]:
    """Lines on what each fidelity costs for the distinct cells of a design, and how far from the default it was.

    Args:
        design: the design.
        cells: its distinct cells.
        too_large: why a cell cannot be solved in 3-D; empty where each can.
    """
    lumped, helmholtz = (
        ", ".join(f"{percent:g} % and {degrees:g} degrees on {name}" for name, percent, degrees in measured)
        for measured in (LUMPED_IS_OFF, HELMHOLTZ_IS_OFF)
    )
    seconds = SECONDS_PER_CELL * len(cells)
    in_3d = f"about {SECONDS_PER_CELL:g} s of one processor per distinct cell, {seconds:g} s for the {len(cells)} of "
    in_3d += "this design; later from the cache"
    return (
        f"lumped: milliseconds; differs from navier-stokes by up to {lumped} ({BAND[0]:g} to {BAND[1]:g} Hz)",
        f"atlas: milliseconds; {_of_atlas(design, cells)}",
        f"helmholtz, a cross-check: as long as navier-stokes; differs from it by up to {helmholtz}",
        f"navier-stokes, the default: {f'not for this design: {too_large}' if too_large else in_3d}",
    )


def _of_atlas(design: ArrayDesign, cells: Sequence[Cell]) -> str:
    """How far the atlas of cells is from the default, or why it has not the cells of this design."""
    atlas, air = cell_atlas(), design_air(design)
    try:
        for cell in cells:
            check_cell(atlas, cell, np.array(BAND), air)
    except OutsideAtlas as error:
        return f"not for this design: {OutsideAtlas.of(error, remedy='').sentence()}"
    off = 100 * atlas.errors["transfer function by 1 + |ln H|"]
    band = f"1 to {atlas.known_up_to:g} Hz"
    return f"differs from navier-stokes by up to {off:.2g} % x (1 + |ln H|) on 40 random designs ({band})"


def cell_uses(design: ArrayDesign, layout: ArrayLayout) -> tuple[tuple[Cell, int], ...]:
    """Distinct cells of a design whose parts lie as the layout says, and how many places each fills."""
    catalogue = cell_catalogue(design, layout)
    uses = Counter(use.cell for use in catalogue.points + catalogue.microphones)
    return tuple((cell, uses[cell]) for cell in catalogue.distinct)


def kind_uses(design: ArrayDesign) -> tuple[KindUse, ...]:
    """Kinds of points and tubes that a design uses, in order of first use; none where no line has a pattern."""
    if all(line.pattern is None for line in design.lines):
        return ()
    found = []
    points = Counter(design.kind_of_point)
    for index, kind in enumerate(design.kinds):
        alike = design.of_kind(kind)
        sizes = f"cavity {alike.resonator.cavity_height:g} mm high, membrane {alike.membrane.thickness:g} mm"
        if alike.resonator.leak_diameter:
            sizes += f", leak {alike.resonator.leak_diameter:g} mm"
        found.append(KindUse(kind, "point", sizes, points[index]))
    tubes: dict[tuple[str, Tube], int] = {}
    for line in design.lines:
        for segment in range(1, line.points):
            key = design.tube_kind_at(line, segment), design.tube_at(line, segment)
            tubes[key] = tubes.get(key, 0) + 1
    for (kind, tube), count in tubes.items():
        found.append(KindUse(kind, "tube", f"{tube.length:g} mm long, bore {tube.inner_diameter:g} mm", count))
    return tuple(found)
