"""Kit of one design in a folder of its own: the call behind ``acoustic-fem parts``."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from geometry.assembly.bill import Bill
from geometry.assembly.fit import misfits
from geometry.assembly.model import array_model
from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import DesignLike, resolve_design
from geometry.formats.part_files import FORMATS, ExportedFile
from geometry.ground.missing_packages import check_system_libraries
from geometry.ground.refusal import Field
from geometry.ground.shown import Shown
from geometry.ground.stated_times import stopped_time
from geometry.ground.typed import PathLike
from geometry.layout.arrangement import lay_out
from geometry.layout.overlaps import buildability_notes
from geometry.layout.remedies import refuse_unbuildable
from geometry.printing.printability import PrintReport
from geometry.schema.field_errors import DesignError
from geometry.schema.print_processes import PrintProcess, find_process, process_of
from studies.kit.body_files import body_beside
from studies.kit.kit_files import write_kit
from studies.kit.ordering import OrderList
from studies.output.display import Display
from studies.output.folders import FILES, check_folder, claimed_folder, replaced_files

#: Remedy where a design cannot be built.
ALL_THE_SAME = (Field("allow_overlaps"), " draws it all the same")


@dataclass(frozen=True, repr=False)
class MadeParts(Shown):
    """Kit of an array in a folder, and the findings on its parts."""

    design: ArrayDesign
    """Array that the parts are of."""
    folder: Path
    """Folder of the kit."""
    manual: Path
    """Build manual: a page to read or to print."""
    report: Path
    """Page with what the print rules say."""
    files: tuple[ExportedFile, ...]
    """Files that were written."""
    printing: PrintReport
    """Report of the print rules on the parts."""
    bill: Bill
    """Bill of materials."""
    order: OrderList
    """Order list: the bill with spares, tools, consumables and hours of work."""
    too_large: tuple[str, ...]
    """Names of the parts that fit on no plate."""
    notes: tuple[str, ...]
    """Notes on what is drawn but could not be built as drawn, and on the body that the array lies on."""
    misfits: tuple[str, ...]
    """Lines on what keeps the parts, as drawn, from being put together."""

    def shown(self) -> tuple[str, Mapping[str, object]]:
        """Title and facts that a session and a notebook show."""
        return f"Parts of {self.design.name}", {
            "folder": self.folder,
            "manual": self.manual,
            "files": len(self.files),
            "printing": f"{self.printing.process.title}: {self.printing.verdict}",
            "materials": f"{self.bill.cost:.2f} {self.bill.currency}",
            "all with spares and tools": f"{self.order.cost():.2f} {self.bill.currency}",
            "work": f"{self.order.hours:.1f} h",
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
    """Kit of a design: what to buy, print, cast, cut and build, with a manual. Either all files are written or none.

    Args:
        design: the array: a design, the path of its file, or the name of a prototype.
        out: a folder, created if needed. When everything is made, files of an earlier call are replaced. Other files
            stay, unless they have the name of a new file.
        formats: formats of the files of each part.
        process: printing process whose rules are applied: a name or a ``.toml`` file; by default that of the design.
            A mold whose rows and columns the design leaves open fits its machine.
        allow_overlaps: draw the design even if parts overlap; the overlaps are then listed.
        display: shows progress.

    Raises:
        Refusal: parts overlap, a part cannot be built or written, an unknown process or format, or the folder's list of
            files contains a file that is not its own.
        OSError: the folder cannot be written.
    """
    stopped_time()
    check_system_libraries()
    folder, source, design = Path(out), design, resolve_design(design)
    named = None if process is None or isinstance(process, PrintProcess) else process
    check_folder(folder, "parts", FILES, reads=(named,))
    rules = process_of(design.printing) if process is None else find_process(process)
    body = body_beside(source, design)
    design = _for_printer(design, rules)
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
        kit = write_kit(model, fresh, formats, rules, lambda what, done: report(what, 0.1 + 0.9 * done), body)
    return MadeParts(
        design=design,
        folder=folder,
        manual=folder / kit.manual.relative_to(fresh),
        report=folder / kit.report.relative_to(fresh),
        files=tuple(replace(file, path=folder / file.path.relative_to(fresh)) for file in kit.files),
        printing=kit.printing,
        bill=kit.order.bill,
        order=kit.order,
        too_large=kit.too_large,
        notes=(*buildability_notes(design, layout), *kit.body),
        misfits=in_the_way,
    )


def _for_printer(design: ArrayDesign, process: PrintProcess) -> ArrayDesign:
    """The design with the build volume of the machine, if the number of cavities of its molds depends on it."""
    mold, given = design.mold, process_of(design.printing).build_volume
    if process.build_volume == given or (mold.rows is not None and mold.columns is not None):
        return design
    return design.with_values({"printing.rules.build_volume": list(process.build_volume)})
