"""Number of cavities of a mold: one for every membrane of the array, as far as the printer has room."""

from __future__ import annotations

import math
from collections.abc import Callable
from itertools import product

from geometry.design.array_design import ArrayDesign
from geometry.molds.mold_forces import OpeningForces
from geometry.schema.print_processes import process_of

#: Margin beside the mold on the plate of the printer, mm, for a brim and supports.
PLATE_MARGIN = 5.0
#: Most rows or columns.
_MOST = 20
#: One cavity in so many may stay empty for shorter sides.
_SPARE = 8


def cavity_grid(
    design: ArrayDesign,
    needed: int,
    block: Callable[[int, int], tuple[float, float]],
    forces: Callable[[int, int], OpeningForces],
) -> tuple[int, int]:
    """Rows and columns of cavities.

    As many as membranes are needed if they fit the printer of the design, and if a blade can lift the lid off so many.
    If they do not, all casts have about the same number. The grid with about this number and the shortest sides is
    taken.

    Args:
        design: states rows, columns or both, or leaves them open.
        needed: membranes to cast.
        block: length of a block of rows and columns along x and y, mm.
        forces: forces that open a mold of rows and columns.
    """
    mold = design.mold
    if mold.rows is not None and mold.columns is not None:
        return mold.rows, mold.columns
    width, depth = (side - 2 * PLATE_MARGIN for side in process_of(design.printing).build_volume[:2])
    rows = range(1, _MOST + 1) if mold.rows is None else (mold.rows,)
    columns = range(1, _MOST + 1) if mold.columns is None else (mold.columns,)

    def fits(grid: tuple[int, int]) -> bool:
        x, y = block(*grid)
        return x <= width and y <= depth and (mold.kind == "open-face" or forces(*grid).holds)

    fitting = [grid for grid in product(rows, columns) if fits(grid)] or [(rows[0], columns[0])]
    casts = math.ceil(needed / max(r * c for r, c in fitting))
    each = math.ceil(needed / casts)
    enough = [grid for grid in fitting if math.prod(grid) >= each]
    few = min(math.prod(grid) for grid in enough) + each // _SPARE
    return min((grid for grid in enough if math.prod(grid) <= few), key=lambda grid: (sum(block(*grid)), grid))
