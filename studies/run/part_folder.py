"""Everything that it takes to make an array, in one folder."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import geometry
from geometry import export, print_report
from geometry.assembly.bill import Bill, bill_of_materials, write_bill
from geometry.assembly.fit import misfits
from geometry.assembly.model import ArrayModel, array_model
from geometry.assembly.order_table import write_assembly_table
from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import DesignLike, resolve_design
from geometry.formats.part_files import FORMATS, ExportedFile, tessellate_distinct
from geometry.ground.missing_packages import check_system_libraries
from geometry.ground.refusal import Field
from geometry.ground.shown import Shown
from geometry.ground.stated_times import stopped_time
from geometry.ground.typed import PathLike
from geometry.layout.arrangement import lay_out
from geometry.layout.overlaps import buildability_notes
from geometry.layout.remedies import refuse_unbuildable
from geometry.printing.plates import export_plates
from geometry.printing.printability import PrintReport
from geometry.printing.report_files import write_report
from geometry.schema.field_errors import DesignError
from geometry.schema.print_processes import PrintProcess, find_process, process_of
from studies.output.display import Display, Report
from studies.output.folders import FILES, check_folder, claimed_folder, replaced_files

#: Remedy where a design cannot be built.
ALL_THE_SAME = (Field("allow_overlaps"), " draws it all the same")


@dataclass(frozen=True, repr=False)
class MadeParts(Shown):
    """Part files of an array in a folder, and the findings on them."""

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

    def shown(self) -> tuple[str, Mapping[str, object]]:
        """Title and facts that a session and a notebook show."""
        return f"Parts of {self.design.name}", {
            "folder": self.report.parent,
            "files": len(self.files),
            "printing": f"{self.printing.process.title}: {self.printing.verdict}",
            "materials": f"{self.bill.cost:.2f} {self.bill.currency}",
            "molds": f"{self.bill.tooling_cost:.2f} {self.bill.currency}",
            "on no plate": ", ".join(self.too_large),
            "misfits": "; ".join(self.misfits),
        }


def export_parts(
    design: DesignLike,
    out: PathLike,
    *,
    formats: Sequence[str] = FORMATS,
    process: PrintProcess | PathLike | None = None,
    allow_overlaps: bool = False,
    display: Display | None = None,
) -> MadeParts:
    """Parts of a design, drawn, exported and compared with the print rules, and the assembled array. Either all files
    are written or none.

    Args:
        design: the array: a design, the path of its file, or the name of a prototype.
        out: a folder, created if needed. When everything is made, files of an earlier call are replaced. Other files
            stay, unless they have the name of a new file.
        formats: formats of the files of each part.
        process: printing process whose rules are applied: a name or a ``.toml`` file; by default that of the design.
        allow_overlaps: draw the design even if parts overlap; the overlaps are then listed.
        display: shows progress.

    Raises:
        Refusal: parts overlap, a part cannot be built or written, an unknown process or format, or the folder's list of
            files contains a file that is not its own.
        OSError: the folder cannot be written.
    """
    stopped_time()
    check_system_libraries()
    folder, design = Path(out), resolve_design(design)
    named = None if process is None or isinstance(process, PrintProcess) else process
    check_folder(folder, "parts", FILES, reads=(named,))
    rules = process_of(design.printing) if process is None else find_process(process)
    layout = lay_out(design)
    if not allow_overlaps:
        refuse_unbuildable(design, layout, ALL_THE_SAME)
    with (
        claimed_folder(folder, "parts", FILES, reads=(named,)),
        (display or Display()).stage("Parts") as report,
        replaced_files(folder) as fresh,
    ):
        report("drawing the parts", 0.0)
        model = array_model(design, layout=layout)
        report("fit", 0.05)
        in_the_way = misfits(model)
        if in_the_way and not allow_overlaps:
            raise DesignError.of_notes(design.name, in_the_way, remedy=ALL_THE_SAME)
        made = _make(model, fresh, formats, rules, in_the_way, report)
    files = tuple(replace(file, path=folder / file.path.name) for file in made.files)
    return replace(made, report=folder / made.report.name, files=files)


def _make(
    model: ArrayModel,
    folder: Path,
    formats: Sequence[str],
    process: PrintProcess,
    in_the_way: tuple[str, ...],
    report: Report,
) -> MadeParts:
    design, parts = model.design, model.parts
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
    geometry.formats.write_step(model, folder / "assembly.step")
    report("array.glb", 0.78)
    geometry.pictures.write_gltf(model, folder / "array.glb")
    report("array.html", 0.82)
    geometry.pictures.write_viewer(model, folder / "array.html")
    report("top-view.png", 0.87)
    geometry.pictures.top_view(model, folder / "top-view.png")
    report("exploded-view.png", 0.91)
    geometry.pictures.exploded_view(model, folder / "exploded-view.png")
    report("mold-section.png", 0.96)
    geometry.pictures.mold_section(model, folder / "mold-section.png")
    report("done", 1.0)
    notes = buildability_notes(design, model.layout)
    return MadeParts(design, page, files, printing, bill, plates.too_large, notes, in_the_way)
