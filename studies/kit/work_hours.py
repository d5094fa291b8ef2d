"""Hours of work that one array takes, each as minutes a piece times pieces, so that you can count again."""

from __future__ import annotations

import math
from collections import Counter
from dataclasses import dataclass

from geometry.assembly.model import ArrayModel
from geometry.layout.cutting import cutting_list
from geometry.molds import molds_of, plan_mold
from geometry.schema.print_processes import PrintProcess
from studies.kit.jobs import BUILD, CAST, CUT, PRINT
from studies.kit.touch_leak_test import touch_order

#: Source of every figure of minutes below.
COUNTED = "assumed minutes of a practised hand; nobody has timed a build yet, so note your own times in the record"


@dataclass(frozen=True)
class Work:
    """One kind of work on the array."""

    job: str
    """Folder of its job."""
    name: str
    """Name of the work."""
    pieces: int
    """Number of pieces."""
    minutes: float
    """Minutes of work on one piece; assumed."""
    waits: float = 0.0
    """Hours of waiting in all, during which nobody works: printing, curing."""

    @property
    def hours(self) -> float:
        """Hours of work on all pieces."""
        return self.pieces * self.minutes / 60


def count_casts(model: ArrayModel) -> dict[str, int]:
    """Number of casts of each membrane by its name: pieces of the array by cavities of the mold."""
    needed = Counter(part.part for part in model.placed if part.kind == "membrane")
    designs = molds_of(model.design)
    return {name: math.ceil(needed[name] / len(plan_mold(alike).centres)) for name, alike in designs.items()}


def work_of(
    model: ArrayModel, plates: int, process: PrintProcess, cure_hours: float, setting_minutes: float
) -> tuple[Work, ...]:
    """Work that one array takes, in the order of the jobs.

    Args:
        model: the array.
        plates: number of plates to print.
        process: printing process.
        cure_hours: cure of the silicone, h a cast.
        setting_minutes: time until the joint of a tube may be tested, min.
    """
    design, parts = model.design, model.parts
    printed = sum(parts.counts[name] for name in parts if parts.origin(name) == "printed")
    casts = sum(count_casts(model).values())
    cuts = sum(cut.count for cut in cutting_list(design, model.layout))
    springs = sum(cut.count for cut in cutting_list(design, model.layout) if cut.tube.bore != "smooth")
    ports = 2 * cuts
    resin = process.name in ("sla-resin", "dlp-fine")
    laid = 0 if design.layout.frozen is None else design.point_count + len(design.microphones)
    return (
        Work(PRINT, "prepare and clear a plate", plates, 15, waits=3.0 * plates),
        Work(PRINT, "wash and cure a plate" if resin else "clean a plate", plates, 10, waits=plates if resin else 0.0),
        Work(PRINT, "wash, clear and sort a part" if resin else "clean, clear and sort a part", printed, 1.5),
        Work(CAST, "prepare the mold, mix, pour and close", casts, 20, waits=cure_hours * casts),
        Work(CAST, "trim and measure a membrane", design.point_count, 2),
        Work(CUT, "cut a spring", springs, 1),
        Work(CUT, "cut and fit a sheath", cuts, 1.5),
        Work(BUILD, "glue a membrane", design.point_count, 2, waits=24.0),
        Work(BUILD, "glue the end of a tube", ports, 2, waits=round(ports * setting_minutes / 60, 1)),
        Work(BUILD, "test a joint", ports + design.point_count, 1),
        Work(BUILD, "solder a board", len(design.microphones), 15),
        Work(BUILD, "mount and wire a microphone", len(design.microphones), 20, waits=1.0),
        *((Work(BUILD, "lay a shell or a housing into its pocket", laid, 1, waits=1.0),) if laid else ()),
        Work(BUILD, "install the program and set up the data logger", 1, 60),
        Work(BUILD, "first recording of a point", design.point_count, 1),
        Work(BUILD, "touch for the leak test", len(touch_order(design)), 0.25),
        Work(BUILD, "record a point for the calibration", design.point_count, 3),
    )
