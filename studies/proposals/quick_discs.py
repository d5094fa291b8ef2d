"""Membranes of many drawn designs in little time, for a search whose best designs are then solved as usual."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

from acoustic_fem.membrane.design_discs import design_shape
from acoustic_fem.membrane.disc_table import DiscTables, disc_tables
from acoustic_fem.membrane.elasticity import ElasticDisc, solve_dimensionless
from acoustic_fem.membrane.half_section import DiscShape
from geometry.design.array_design import ArrayDesign

#: Refinement of a quick disc. Its statics and first mode differ by 0.2 % from those of the usual one for 40 discs.
_REFINEMENT = 2
#: Largest relative error of the interpolation, about that of the refinement.
_ACCURACY = 2e-3


class QuickDiscs:
    """Discs of the membranes of some designs, as :class:`acoustic_fem.membrane.disc.KnownDiscs`.

    They are solved on a coarser mesh and interpolated where many are alike. They are not kept on disk.

    Args:
        designs: the designs.
    """

    def __init__(self, designs: Sequence[ArrayDesign]) -> None:
        shapes = [design_shape(design.of_kind(kind)) for design in designs for kind in design.kinds]
        self._tables = DiscTables(disc_tables(shapes, lambda several: [_solved(each) for each in several],
                                              accuracy=_ACCURACY))  # fmt: skip

    def find(self, shape: DiscShape) -> ElasticDisc:
        """Disc of a shape."""
        return self._tables.find(shape) or _solved(shape)


@lru_cache(maxsize=1024)
def _solved(shape: DiscShape) -> ElasticDisc:
    return solve_dimensionless(shape, _REFINEMENT)
