"""Proposed designs as drawn: whether their parts go together and can be printed, as ``check`` finds."""

from __future__ import annotations

from geometry.assembly.fit import misfits
from geometry.assembly.model import array_model
from geometry.design.array_design import ArrayDesign
from geometry.ground.extras import is_installed
from geometry.ground.refusal import Refusal
from geometry.printing.printability import print_report
from geometry.schema.print_processes import process_of
from studies.verdict import Drawn

#: Findings on the designs that were drawn, by the text of the design.
_FOUND: dict[str, Drawn] = {}


def drawn_findings(design: ArrayDesign) -> Drawn:
    """Misfits of the drawn parts of a design, and failed print rules of its shells and housings.

    Drawing takes seconds, so each design is drawn once. There are no findings where the extra ``cad`` is not installed,
    because no part can be drawn without it.
    """
    if not is_installed("cad"):
        return Drawn()
    key = design.model_dump_json()
    if key not in _FOUND:
        _FOUND[key] = _findings(design)
    return _FOUND[key]


def _findings(design: ArrayDesign) -> Drawn:
    try:
        model = array_model(design)
        lines = misfits(model)
    except Refusal as error:  # a tube that bends into itself is no solid
        return Drawn((str(error),))
    printed = model.parts.only(*(name for name, kind in model.parts.kinds.items() if kind in ("shell", "housing")))
    report = print_report(printed, process_of(design.printing))
    return Drawn(lines, tuple(each for each in report.findings if each.verdict == "fail"))
