"""The build manual: one HTML page that needs no network, to read on a screen or to print on A4 and Letter."""

from __future__ import annotations

import base64
import math
from collections import Counter
from collections.abc import Callable, Sequence
from importlib import resources
from pathlib import Path
from typing import Any, TypeVar

import studies
from geometry.assembly.model import ArrayModel
from geometry.assembly.order_table import AssemblyStep, assembly_steps
from geometry.boards import board_drawing
from geometry.formats.part_files import SharedShape
from geometry.ground.whole_files import write_text
from geometry.printing.plates import Plate, Plates
from geometry.printing.pose import find_pose
from geometry.printing.printability import PrintReport
from geometry.schema.print_processes import PrintProcess
from geometry.stock import Silicone, catalogue
from studies.kit import step_drawings, step_pictures
from studies.kit.body_files import BodyFiles
from studies.kit.build_facts import casts_of, dangers_of, glue_of, setting_words
from studies.kit.casting_sheet import casting_words, closing_words, cure_words, opening_words
from studies.kit.cutting_template import SCALE_BAR, template_strips
from studies.kit.electronics_files import BOARD_FOLDER, Electronics, recorded_options
from studies.kit.expected_signals import (
    FREQUENCY,
    HOLE,
    LEAK_FREQUENCY,
    as_built_levels,
    expected_signals,
    microphone_loss,
)
from studies.kit.holding import holding_words
from studies.kit.jobs import BUILD, BUY, CAST, CUT, PRINT
from studies.kit.leak_testing import GAUGE_BORE, WATCHED, leak_tests, needle_words
from studies.kit.logger_levels import FIRM_TAP, two_digits
from studies.kit.lying import lying_words
from studies.kit.ordering import OrderList
from studies.kit.questions import Facts, answers_of
from studies.kit.recording_setup import conversion_line, needs_conversion, told_apart_words
from studies.kit.step_drawings import glued_face_words
from studies.kit.step_tools import HAVE_READY, tools_of
from studies.kit.touch_leak_test import READABLE, TOUCHED_HOLE, leak_signs, touch_order
from studies.kit.tube_order import sheath_orders, spring_orders
from studies.kit.work_hours import COUNTED
from studies.output.display import Report

_T = TypeVar("_T")
#: Rows of a table that surely fit on one page, so that no table is cut.
_ROWS = 22
#: Side of a small label at most, mm, and by the diameter of a shell: a square of 0.71 would reach its edge.
_LABEL, _LABEL_OF_SHELL = 13.0, 0.68
#: Points beside each other in a row of the record sheet.
_ACROSS = 2


def write_manual(
    model: ArrayModel,
    folder: Path,
    plates: Plates,
    shapes: Sequence[SharedShape],
    printing: PrintReport,
    order: OrderList,
    process: PrintProcess,
    electronics: Electronics,
    body: BodyFiles | None,
    report: Report,
) -> Path:
    """Write ``5-build/manual.html`` into the folder of a kit.

    Args:
        model: the array.
        folder: of the kit.
        plates: its plates.
        shapes: facets of its parts.
        printing: report of the print rules.
        order: order list.
        process: printing process.
        electronics: its electronics.
        body: solids for the body that the array lies on.
        report: shows progress.

    Returns:
        Path of the page.
    """
    import jinja2

    environment = jinja2.Environment(
        autoescape=True, undefined=jinja2.StrictUndefined, trim_blocks=True, lstrip_blocks=True
    )
    environment.filters |= {
        "chunks": _chunks,
        "g2": two_digits,
        "g3": _three,
        "signed": _signed,
    }
    text = (resources.files(studies) / "templates" / "manual.html").read_text(encoding="utf-8")
    report("expected signals", 0.0)
    built = as_built_levels(model.design)
    facts = Facts(
        model,
        plates,
        process,
        printing.verdict,
        order,
        casts_of(model, order.bill),
        template_strips(model.design, model.layout),
        leak_tests(model.design),
        expected_signals(model.design, built),
        leak_signs(model.design, built),
        electronics,
        printing.supported,
        body,
    )
    page = environment.from_string(text).render(**_content(facts, shapes, report))
    path = folder / BUILD / "manual.html"
    write_text(path, page)
    return path


def _content(facts: Facts, shapes: Sequence[SharedShape], report: Report) -> dict[str, Any]:
    """Everything that the page shows."""
    model, design, bill = facts.model, facts.model.design, facts.order.bill
    silicone = catalogue().silicone(design).part
    ends = Counter(name for line in design.lines for name in line.between)
    levels = facts.electronics.levels
    tubes = [tube.tube for tube in model.layout.tubes]
    placed = (design, model.layout, facts.order)
    return {
        "design": design,
        "facts": facts,
        "pictures": _pictures(facts, shapes, report),
        "drawings": _drawings(facts),
        "jobs": {"buy": BUY, "print": PRINT, "cast": CAST, "cut": CUT, "build": BUILD},
        "answers": answers_of(facts),
        "dangers": dangers_of(model, bill, facts.process),
        "parts": _part_rows(facts, shapes),
        "silicone": silicone if isinstance(silicone, Silicone) else None,
        "glues": {joint: glue_of(bill, joint) for joint in ("tube", "membrane", "board")},
        "sheaths": sheath_orders(*placed),
        "shared_housings": [name for name in design.microphones if ends[name] > 1],
        "conversion": conversion_line(levels) if needs_conversion(levels) else None,
        "told_apart": told_apart_words(facts.signals),
        "bores": sorted({tube.inner_diameter for tube in tubes}),
        "steps": assembly_steps(model),
        "tube_words": _tube_words,
        "scale_bar": SCALE_BAR,
        "tubes_to_order": any(not each.is_numbered for each in (*spring_orders(*placed), *sheath_orders(*placed))),
        "carved": None if facts.body is None else facts.body.carved,
        "labels": _labels(model),
        "record": _record_rows(model),
        "counted": COUNTED,
        "watched": WATCHED,
        "gauge": 1e3 * GAUGE_BORE,
        "frequency": FREQUENCY,
        "leak_frequency": LEAK_FREQUENCY,
        "hole": 1e3 * HOLE,
        "touched_hole": TOUCHED_HOLE,
        "touches": touch_order(design),
        "readable": READABLE,
        "board_folder": BOARD_FOLDER,
        "firm": FIRM_TAP,
        "needle": list(dict.fromkeys(needle_words(bore) for bore in sorted({tube.inner_diameter for tube in tubes}))),
        "setting": setting_words,
        "tools": tools_of(facts.order, on_body=design.layout.frozen is not None),
        "have_ready": HAVE_READY,
        "microphone_loss": microphone_loss(design),
        "glued_face": glued_face_words(design),
        "holding": holding_words(model),
        "cure_words": cure_words,
        "recorded": recorded_options(facts.electronics),
        "label_side": min(_LABEL, _LABEL_OF_SHELL * design.resonator.outer_diameter),
        "resin": facts.process.name in ("sla-resin", "dlp-fine"),
        "casting_words": casting_words,
        "closing_words": closing_words,
        "opening_words": opening_words,
        "casting": sum(cast.casts for cast in facts.casts),
        "hours": {
            job: math.fsum(w.hours for w in facts.order.work if w.job == job) for job in (PRINT, CAST, CUT, BUILD)
        },
    }


def _pictures(facts: Facts, shapes: Sequence[SharedShape], report: Report) -> dict[str, str]:
    """Pictures of steps as addresses that hold them."""
    model, plates, marks = facts.model, facts.plates.plates, step_pictures.part_marks(facts.model)
    others = [plate for plate in plates if not plate.holds_molds] or plates[-1:]

    def plate_picture(plate: Plate) -> Callable[[], bytes]:
        return lambda: step_pictures.plate_picture(plate, shapes, facts.process, marks)

    drawn: dict[str, Callable[[], bytes]] = {
        "molds": plate_picture(plates[0]),
        **{f"plate-{number}": plate_picture(plate) for number, plate in enumerate(others, start=1)},
        "parts": lambda: step_pictures.parts_picture(model),
        "mold": lambda: step_pictures.mold_picture(model),
        "membrane": lambda: step_pictures.membrane_picture(model),
        "joint": lambda: step_pictures.joint_picture(model),
        "order": lambda: step_pictures.order_picture(model),
        "microphone": lambda: step_pictures.microphone_picture(model),
        "array": lambda: step_pictures.array_picture(model),
    }
    shown = {} if facts.body is None else facts.body.shown
    if shown:
        drawn["body"] = lambda: step_pictures.body_picture(model, shown)
    pictures = {}
    for number, (name, draw) in enumerate(drawn.items()):
        report(f"picture of the {name}", 0.1 + 0.9 * number / len(drawn))
        pictures[name] = "data:image/png;base64," + base64.b64encode(draw()).decode("ascii")
    return pictures


def _drawings(facts: Facts) -> dict[str, str]:
    """Drawings of steps as SVG."""
    design, board = facts.model.design, facts.electronics.wiring.board
    drawings = {} if board is None else {"board": board_drawing(board, f"Board of microphone {board.microphone}")}
    return drawings | {
        "membrane": step_drawings.membrane_drawing(design),
        "cutting": step_drawings.cutting_drawing(facts.strips),
        "socket": step_drawings.socket_drawing(
            facts.model.layout.tubes[0].tube, design.printing.port_lip, design.printing.glue_gap
        ),
        "leak": step_drawings.leak_drawing(facts.leaks[0]),
        "signals": step_drawings.signal_drawing(facts.signals),
    }


def _part_rows(facts: Facts, shapes: Sequence[SharedShape]) -> list[dict[str, Any]]:
    """Printed parts with their number, and how they lie when they are printed."""
    parts, rows, marks = facts.model.parts, [], step_pictures.part_marks(facts.model)
    for shape in shapes:
        if parts.origin(shape.names[0]) != "printed":
            continue
        pose = lying_words(parts.kinds[shape.names[0]], find_pose(shape.facets, facts.process))
        about = parts.parameters.get(shape.names[0], {}).get("ports", "")
        count = sum(parts.counts[name] for name in shape.names)
        mark = " ".join(marks[name] for name in shape.names if name in marks)
        spare = facts.plates.spares.get(shape.names[0], 0)
        rows.append(
            {
                "mark": mark,
                "name": ", ".join(shape.names),
                "count": count,
                "spare": spare,
                "pose": pose,
                "ports": about,
            }
        )
    return rows


def _tube_words(step: AssemblyStep) -> str:
    """Tube from a place to the next in words; empty at the end of a line."""
    tube = step.tube
    if tube is None:
        return ""
    bent = "" if tube.bend_radius == math.inf or tube.schematic else f", bent to {tube.bend_radius:.3g} mm"
    return f"{tube.name}: sheath {tube.sheath_length:g} mm, spring {tube.spring_length:g} mm{bent}"


def _labels(model: ArrayModel) -> list[str]:
    """Words of the labels: points, microphones, and bags of parts."""
    parts = model.parts
    labels = [f"{point.number}" for point in model.layout.points]
    labels += [f"mic {microphone.name}" for microphone in model.layout.microphones]
    labels += [
        f"{parts.counts[name]} x {name}" for name in parts if parts.origin(name) == "printed" and parts.counts[name]
    ]
    return labels


def _record_rows(model: ArrayModel) -> list[list[tuple[int, float]]]:
    """Rows of the record sheet: number and designed thickness (mm) of points beside each other."""
    design = model.design
    points = [
        (number, design.of_kind(design.kinds[kind]).membrane.thickness)
        for number, kind in enumerate(design.kind_of_point, start=1)
    ]
    return [points[first : first + _ACROSS] for first in range(0, len(points), _ACROSS)]


def _chunks(rows: Sequence[_T], size: int = _ROWS) -> list[Sequence[_T]]:
    """Rows in tables that fit on a page each."""
    count = max(1, math.ceil(len(rows) / size))
    length = math.ceil(len(rows) / count)
    return [rows[first : first + length] for first in range(0, len(rows), length)] if rows else []


def _three(value: float) -> str:
    """Three digits, without a power of ten for large numbers."""
    return f"{value:.0f}" if value >= 1000 else f"{value:.3g}"


def _signed(value: float) -> str:
    return f"{value:.1f}".replace("-", "\N{MINUS SIGN}")
