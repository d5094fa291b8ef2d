"""Membranes that are mounted with strain or on soft glue: how much softer or stiffer they are for small signals.

A disc that was too small for its rim is stretched in its plane, because silicone shrinks as it cures or because it was
glued warm. A layer of silicone glue yields under the rim. Both are solved with the elasticity of finite strain
(:mod:`acoustic_fem.membrane.finite_elasticity`). The free disc is a body of its own size, so its stress is uniform
neither at the edge of the glue nor through the thickness. The layer of glue is thin against its width: it resists by
G / t along it and by its constrained modulus M / t across it.
"""

from __future__ import annotations

from dataclasses import asdict
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

from acoustic_fem.membrane.half_section import FITTING, DiscShape, Mounting
from acoustic_fem.numerics import disk_cache
from geometry.ground.refusal import Kind, Refusal

if TYPE_CHECKING:
    from acoustic_fem.membrane.equilibrium import Equilibrium

MOUNTING_MODEL_VERSION = 1
"""To be raised with every change of this model that changes a number."""
BUCKLING = 3.0
"""Compliance by that of the disc that fits at which a disc that is pressed together all but buckles, a ratio."""
#: Refinement of the section, as for tables of presses.
_REFINEMENT = 2


@lru_cache(maxsize=1024)
def mounting_ratio(shape: DiscShape, mounting: Mounting) -> float:
    """Compliance of a mounted disc for small signals, by that of the disc that fits on rigid glue.

    Args:
        shape: the disc, flat and without prestress.
        mounting: its strain and its glue.

    Raises:
        Refusal: a disc that is pressed together until it all but buckles.
    """
    if mounting == FITTING:
        return 1.0
    ratio = _compliance(shape, mounting) / _compliance(shape, FITTING)
    if not 0 < ratio < BUCKLING:
        raise Refusal(
            kind=Kind.OUT_OF_RANGE,
            field="prestrain",
            value=mounting.prestrain,
            allowed="larger, because a disc that is pressed together so far buckles",
        )
    return ratio


def _compliance(shape: DiscShape, mounting: Mounting) -> float:
    about = {"mounting": MOUNTING_MODEL_VERSION, "refinement": _REFINEMENT, "disc": asdict(shape)}
    key = disk_cache.key_of({**about, **asdict(mounting)})
    kept = disk_cache.fetch(key)
    if kept is not None:
        return float(kept[0]["compliance"])
    found = solve_mounted(shape, mounting, _REFINEMENT)
    compliance = np.inf if found is None else found.compliance
    disk_cache.store(key, {"compliance": np.array(compliance)}, {})
    return compliance


def solve_mounted(shape: DiscShape, mounting: Mounting, refinement: int) -> Equilibrium | None:
    """Mounted disc at rest; None if it has no equilibrium that Newton's method finds.

    Args:
        shape: the disc, flat and without prestress.
        mounting: its strain and its glue.
        refinement: of the section.
    """
    # Here, because membranes that fit, which every command has, need no finite elements at finite strain.
    from acoustic_fem.membrane.equilibrium import LoadedDisc, Setup
    from acoustic_fem.membrane.finite_elasticity import Section

    disc = LoadedDisc(Section(shape, refinement, mounting), Setup("pressure"))
    return disc.solve(0.0, disc.relaxed)
