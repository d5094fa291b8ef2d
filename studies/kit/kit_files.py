"""Files of a kit: a folder per job, written into an empty folder; what ``parts`` and ``run`` both write."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import geometry
from geometry import export, print_report
from geometry.assembly.bill import bill_of_materials, write_bill
from geometry.assembly.model import ArrayModel
from geometry.assembly.order_table import write_assembly_table
from geometry.assembly.part_list import Origin
from geometry.body.reading import Body as SolidBody
from geometry.formats.part_files import ExportedFile, SharedShape, tessellate_distinct
from geometry.ground.extras import installed_version
from geometry.ground.whole_files import write_text
from geometry.printing.plates import export_plates
from geometry.printing.printability import PrintReport
from geometry.printing.report_files import write_report
from geometry.schema.print_processes import PrintProcess
from geometry.stock import Silicone, catalogue
from studies.kit.body_files import BodyFiles, write_body
from studies.kit.build_facts import casts_of, glue_of, minutes_to_set
from studies.kit.casting_sheet import write_casting
from studies.kit.cutting_template import write_cutting
from studies.kit.electronics_files import electronics_of, write_electronics
from studies.kit.jobs import BUILD, BUY, CAST, CUT, PRINT
from studies.kit.manual import write_manual
from studies.kit.ordering import OrderList, order_list, printed_spares
from studies.kit.record_sheet import write_record
from studies.kit.tube_order import sheath_orders, spring_orders, write_tube_order
from studies.kit.work_hours import work_of
from studies.output.display import Report

#: Folder of the files of each part, by where it comes from.
_PLACES: dict[Origin, str] = {
    "printed": f"{PRINT}/parts",
    "cast": f"{CAST}/reference",
    "bought": f"{BUILD}/reference",
}


#: Name of the file that a maker opens first.
FIRST = "READ-ME-FIRST.txt"


@dataclass(frozen=True)
class KitFiles:
    """A kit that was written, and the findings on its parts."""

    manual: Path
    """Build manual."""
    report: Path
    """Page with what the print rules say."""
    files: tuple[ExportedFile, ...]
    """Files of single parts."""
    printing: PrintReport
    """Report of the print rules."""
    order: OrderList
    """Order list with the bill and the hours of work."""
    too_large: tuple[str, ...]
    """Names of the parts that fit on no plate."""
    body: tuple[str, ...]
    """Sentences on the body that the array lies on; empty for other arrays."""


def write_kit(
    model: ArrayModel,
    folder: Path,
    formats: Sequence[str],
    process: PrintProcess,
    report: Report,
    body: SolidBody | None = None,
) -> KitFiles:
    """Write the kit of an array.

    Args:
        model: the array.
        folder: an empty folder that exists.
        formats: formats of the files of each part.
        process: printing process.
        report: shows progress.
        body: that the array was fitted to; files of the body are written if it is given.
    """
    design, parts = model.design, model.parts
    report("body", 0.0)
    on_body = None
    if body is not None:
        on_body = write_body(model, body, folder, formats, process, lambda what, done: report(what, 0.0))
    shown = {} if on_body is None else on_body.shown
    shapes = tessellate_distinct(parts, progress=lambda part, done: report(part, 0.25 * done))
    files = _export_parts(model, folder, formats, shapes, report)
    report("plates", 0.3)
    plates = export_plates(parts, folder / PRINT, process, shapes, printed_spares(parts))
    printing = print_report(
        parts, process, design, lambda part, done: report(f"print rules of {part}", 0.35 + 0.15 * done), shapes
    )
    _, page = write_report(printing, folder / PRINT, design.name, files)
    report("order list", 0.5)
    order = order_of(model, len(plates.plates), process)
    _write_orders(order, folder / BUY)
    placed = (design, model.layout, order)
    write_tube_order(spring_orders(*placed), sheath_orders(*placed), folder / BUY)
    report("cutting template", 0.52)
    write_cutting(design, model.layout, _made(folder / CUT))
    report("assembly.step", 0.55)
    build = _made(folder / BUILD)
    write_assembly_table(model, build)
    geometry.formats.write_step(model, build / "assembly.step")
    report("array.glb", 0.62)
    geometry.pictures.write_gltf(model, build / "array.glb", shown)
    report("array.html", 0.64)
    geometry.pictures.write_viewer(model, build / "array.html", shown)
    electronics = electronics_of(model)
    write_record(design, order.bill, electronics, build)
    write_electronics(electronics, folder)
    report("pictures", 0.68)
    geometry.pictures.top_view(model, build / "top-view.png")
    geometry.pictures.exploded_view(model, build / "exploded-view.png")
    geometry.pictures.mold_section(model, _made(folder / CAST) / "mold-section.png")
    geometry.pictures.open_mold(model, folder / CAST / "mold-open.png")
    write_casting(model, order.bill, folder / CAST)
    manual = write_manual(
        model,
        folder,
        plates,
        shapes,
        printing,
        order,
        process,
        electronics,
        on_body,
        lambda what, done: report(what, 0.75 + 0.25 * done),
    )
    write_text(folder / FIRST, _first_words(design.name, on_body is not None))
    report("done", 1.0)
    return KitFiles(manual, page, files, printing, order, plates.too_large, _on_body(model, on_body))


def _on_body(model: ArrayModel, made: BodyFiles | None) -> tuple[str, ...]:
    """Sentences on the body of an array, and on files that are not made for want of it."""
    stated = model.design.surface
    if stated is None or model.design.layout.frozen is None:
        return ()
    if made is None:
        return (f"the host, the skin and the template are not made, because {stated.body} is not beside the design",)
    return made.findings


def _export_parts(
    model: ArrayModel, folder: Path, formats: Sequence[str], shapes: Sequence[SharedShape], report: Report
) -> tuple[ExportedFile, ...]:
    """Files of all parts, each in the folder of where it comes from."""
    parts, files = model.parts, list[ExportedFile]()
    for origin, place in _PLACES.items():
        own = [shape for shape in shapes if parts.origin(shape.names[0]) == origin]
        if own:
            names = [name for shape in own for name in shape.names]
            files += export(
                parts.only(*names),
                folder / place,
                formats,
                progress=lambda part, done: report(part, 0.25 * done),
                shapes=own,
            )
    return tuple(files)


def order_of(model: ArrayModel, plates: int, process: PrintProcess) -> OrderList:
    """Order list of an array, with the bill and the hours of work that it stands on.

    Args:
        model: the array.
        plates: number of plates that its printed parts take.
        process: printing process.
    """
    bill = bill_of_materials(model.design, model.parts, layout=model.layout)
    silicone = catalogue().silicone(model.design).part
    cure = silicone.cure_time if isinstance(silicone, Silicone) else 16.0
    work = work_of(model, plates, process, cure, minutes_to_set(glue_of(bill, "tube")))
    return order_list(model.design, bill, work, process, casts_of(model, bill))


def _write_orders(order: OrderList, folder: Path) -> None:
    """Write the order list, its costs, the hours of work and the bill."""
    _made(folder)
    write_text(folder / "order-list.csv", order.to_csv())
    write_text(folder / "costs.csv", order.costs_csv())
    write_text(folder / "work-hours.csv", order.work_csv())
    write_bill(order.bill, folder)


def _first_words(name: str, has_body: bool) -> str:
    """Text of the file that a maker opens first."""
    jobs = {
        BUY: "order parts, consumables and tools: order-list.csv",
        PRINT: "print the plates in the order of their numbers, molds first",
        CAST: "cast the membranes while the array is printed",
        CUT: "cut springs and sheaths on the template",
        BUILD: "glue, test, mount, record and calibrate",
    }
    lines = [
        f"Kit of {name}",
        "",
        f"Open {BUILD}/manual.html in a browser. It explains all steps. Jobs in order:",
        "",
    ]
    lines += [f"{job}  {words}" for job, words in jobs.items()]
    lines += [
        "",
        f"Recording and calibrating need acoustic-fem {installed_version('acoustic-fem')}, which wrote this kit, on a",
        "computer with Python 3.11 or newer. Install it from its source: in the folder with its pyproject.toml type",
        "pip install '.[fem,live]'. Then make the library of the sensor, which every recording is compared with:",
        f"acoustic-fem solve {BUILD}/design.toml --out {BUILD}/library.nc",
    ]
    if has_body:
        lines += ["", f"{BUILD}/body.txt says how the array goes onto the body, whose files are in {PRINT}/body."]
    return "\n".join(lines) + "\n"


def _made(folder: Path) -> Path:
    folder.mkdir(parents=True, exist_ok=True)
    return folder
