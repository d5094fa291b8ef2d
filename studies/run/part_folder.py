"""Everything that it takes to make an array, in one folder."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

from geometry.formats.names import FORMATS
from geometry.layout.overlaps import buildability_notes
from geometry.stated.print_processes import PrintProcess, find_process, process_of
from studies.output.display import Display, Report
from studies.output.folders import check_folder, replaced_files

if TYPE_CHECKING:
    from geometry.assembly.bill import Bill
    from geometry.design.array_design import ArrayDesign
    from geometry.formats.part_files import ExportedFile
    from geometry.printing.report import PrintReport


@dataclass(frozen=True)
class MadeParts:
    """Parts of an array as they lie in a folder, and what was found on them."""

    design: ArrayDesign
    """Array that the parts are of."""
    report: Path
    """Page with what the print rules say."""
    files: tuple[ExportedFile, ...]
    """Files that were written."""
    printing: PrintReport
    """Report of the print rules on the parts."""
    bill: Bill
    """Bill of materials."""
    too_large: tuple[str, ...]
    """Names of the parts that fit on no plate."""
    notes: tuple[str, ...]
    """Notes on what is drawn but could not be built as drawn."""
    misfits: tuple[str, ...]
    """Lines on what keeps the parts, as drawn, from being put together."""


def export_parts(
    design: ArrayDesign,
    out: str | os.PathLike[str],
    *,
    formats: Sequence[str] = FORMATS,
    process: PrintProcess | str | os.PathLike[str] | None = None,
    display: Display | None = None,
) -> MadeParts:
    """Parts of a design, drawn, exported and judged, and the array put together, all of it or nothing.

    Args:
        design: the array.
        out: a folder, made if it does not exist. What it holds of an earlier call is replaced when all is made; files
            of others stay, but for those of the same name.
        formats: of the files of each part.
        process: whose rules are applied: a name or a ``.toml`` file; by default that of the design.
        display: shows what is being made.

    Raises:
        Refusal: a part cannot be built or written, an unknown process or format, or the folder's list of files names
            what is none of its own.
        OSError: the folder cannot be written.
    """
    folder = Path(out)
    check_folder(folder)
    rules = process_of(design.printing) if process is None else find_process(process)
    with (display or Display()).stage("Parts") as report, replaced_files(folder) as fresh:
        made = _make(design, fresh, formats, rules, report)
    files = tuple(replace(file, path=folder / file.path.name) for file in made.files)
    return replace(made, report=folder / made.report.name, files=files)


def _make(
    design: ArrayDesign, folder: Path, formats: Sequence[str], process: PrintProcess, report: Report
) -> MadeParts:
    from geometry import export, print_report
    from geometry.assembly.bill import bill_of_materials, write_bill
    from geometry.assembly.fit import misfits
    from geometry.assembly.model import array_model
    from geometry.assembly.table import write_assembly_table
    from geometry.formats.part_files import tessellate_distinct
    from geometry.formats.step_assembly import write_step
    from geometry.pictures.mold_cut import mold_section
    from geometry.pictures.viewer import write_gltf, write_viewer
    from geometry.pictures.views import exploded_view, top_view
    from geometry.printing.plates import export_plates
    from geometry.printing.report_files import write_report

    report("drawing the parts", 0.0)
    model = array_model(design)
    parts = model.parts
    shapes = tessellate_distinct(parts, progress=lambda part, done: report(part, 0.1 + 0.25 * done))
    files = export(parts, folder, formats, progress=lambda part, done: report(part, 0.1 + 0.25 * done), shapes=shapes)
    report("plates", 0.35)
    plates = export_plates(parts, folder, process, shapes)
    printing = print_report(
        parts, process, design, lambda part, done: report(f"print rules of {part}", 0.45 + 0.2 * done), shapes
    )
    _, page = write_report(printing, folder, design.name, files)
    report("bill of materials", 0.65)
    bill = bill_of_materials(design, parts, layout=model.layout)
    write_bill(bill, folder)
    report("assembly.step", 0.68)
    write_assembly_table(model, folder)
    write_step(model, folder / "assembly.step")
    report("fit", 0.75)
    in_the_way = misfits(model)
    report("array.glb", 0.78)
    write_gltf(model, folder / "array.glb")
    report("array.html", 0.82)
    write_viewer(model, folder / "array.html")
    report("top-view.png", 0.87)
    top_view(model, folder / "top-view.png")
    report("exploded-view.png", 0.91)
    exploded_view(model, folder / "exploded-view.png")
    report("mold-section.png", 0.96)
    mold_section(model, folder / "mold-section.png")
    report("done", 1.0)
    notes = buildability_notes(design, model.layout)
    return MadeParts(design, page, files, printing, bill, plates.too_large, notes, in_the_way)
