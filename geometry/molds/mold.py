"""The casting mold of the membranes: what parts it has, and how a membrane lies in it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

import geometry
from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import DesignLike, resolve_design
from geometry.molds.mold_plan import MoldPlan, plan_mold
from geometry.solids.membrane import membranes_of

if TYPE_CHECKING:
    import cadquery as cq


#: Kind of a part of a mold.
MoldKind = Literal["mold-base", "mold-lid", "mold-shim", "mold-scraper", "mold-plugs"]


@dataclass(frozen=True)
class Mold:
    """The parts of a mold as they lie when it is closed, mm; shims lie at the origin."""

    parts: Mapping[str, cq.Workplane]
    """Workplane with one solid by name: ``mold-base`` and, of a two-part mold, ``mold-lid`` and ``mold-shim-1``, ...
    for one step, two steps, ...; of an open-face mold ``mold-scraper``; with ejector pins ``mold-plugs``.
    """
    counts: Mapping[str, int]
    """How many of each part one mold has; a set of shims has one per pin."""
    plan: MoldPlan
    """The numbers of the mold."""

    def cast(self, membrane: cq.Workplane) -> list[cq.Workplane]:
        """Copies of the membrane as they fill the cavities: turned over, and larger by the shrinkage.

        A trim makes the cavities deeper or shallower than these copies.
        """
        import cadquery as cq

        solid = membrane.val()
        turned_over = solid.scale(self.plan.mold.scale).rotate(cq.Vector(0, 0, 0), cq.Vector(1, 0, 0), 180)
        return [cq.Workplane(turned_over.moved(cq.Location(cq.Vector(x, y, 0)))) for x, y in self.plan.centres]


def molds_of(design: DesignLike) -> dict[str, ArrayDesign]:
    """Distinct membranes of a design by the names of their parts, each as the design of its mold.

    All points of such a design have the membrane. Its ``mold.rows`` and ``mold.columns`` are what the membranes of the
    whole array need.
    """
    design = resolve_design(design)
    needed = Counter(design.of_kind(design.kinds[kind]).membrane for kind in design.kind_of_point)
    found = {}
    for name, alike in membranes_of(design).items():
        plan = plan_mold(alike, needed[alike.membrane])
        grid = {"rows": plan.rows, "columns": plan.columns}
        found[name] = alike.model_copy(update={"mold": alike.mold.model_copy(update=grid)})
    return found


def mold_kinds(design: DesignLike) -> dict[str, MoldKind]:
    """Kind of each part of the mold, by the names of :func:`build_mold`."""
    design = resolve_design(design)
    if design.mold.kind == "open-face":
        kinds: dict[str, MoldKind] = {"mold-base": "mold-base", "mold-scraper": "mold-scraper"}
    else:
        shims = [f"mold-shim-{step}" for step in range(1, design.mold.shim_count + 1)]
        kinds = {"mold-base": "mold-base", "mold-lid": "mold-lid", **dict.fromkeys(shims, "mold-shim")}
    return kinds | ({"mold-plugs": "mold-plugs"} if plan_mold(design).ejector else {})


def mold_counts(design: DesignLike) -> dict[str, int]:
    """How many of each part one mold has, by the names of :func:`build_mold`."""
    design = resolve_design(design)
    pins = len(plan_mold(design).pins)
    return {name: pins if kind == "mold-shim" else 1 for name, kind in mold_kinds(design).items()}


def build_mold(design: DesignLike) -> Mold:
    """Draw the mold of a design's membranes, two-part or open-face as ``mold.kind`` says.

    Raises:
        Refusal: a part is not one valid solid.
    """
    design = resolve_design(design)
    from geometry.molds.mold_parts import base_block, lid, mark, mark_text, plugs, scraper, shim, with_pins, with_rails

    plan, shapes = plan_mold(design), {}
    base = base_block(plan)
    if plan.ejector:
        # The plate lies below the base, so it bears the mark.
        shapes["mold-plugs"] = mark(plugs(plan), plan, mark_text(design))
    else:
        base = mark(base, plan, mark_text(design))
    if design.mold.kind == "open-face":
        shapes |= {"mold-base": with_rails(base, plan), "mold-scraper": scraper(plan)}
    else:
        shapes |= {"mold-base": with_pins(base, plan), "mold-lid": lid(plan)}
        for step in range(1, design.mold.shim_count + 1):
            shapes[f"mold-shim-{step}"] = shim(plan, step)
    parts = {name: geometry.solids.one_solid(shapes[name], name) for name in mold_kinds(design)}
    return Mold(parts, mold_counts(design), plan)
