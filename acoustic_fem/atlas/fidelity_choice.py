"""The fidelity of a quick answer: the atlas where it has all of a design, closed forms alone where it has not."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from acoustic_fem.atlas.cell_in_atlas import check_cell
from acoustic_fem.atlas.cell_table import OutsideAtlas, cell_atlas
from acoustic_fem.quantities.fidelity import ClosedForm
from acoustic_fem.quantities.local_air import design_air
from geometry.air.cells import cell_catalogue
from geometry.design.array_design import ArrayDesign
from geometry.layout.arrangement import place_housings


@dataclass(frozen=True)
class QuickFidelity:
    """The fidelity of a quick answer, and why it is not the atlas."""

    name: ClosedForm
    """Fidelity, as :func:`acoustic_fem.solve` takes it."""
    outside: str = ""
    """What of the design lies outside the atlas; empty at fidelity ``atlas``."""

    @property
    def words(self) -> str:
        """The fidelity, and why it is not the atlas, in one line."""
        return f"{self.name}: {self.outside}" if self.outside else self.name


def quick_fidelity(design: ArrayDesign, frequency: ArrayLike) -> QuickFidelity:
    """The fidelity of a quick answer for a design in its air.

    Args:
        design: the array.
        frequency: (n_freq,) Hz, at which it is solved.
    """
    grid, air = np.asarray(frequency, np.float64), design_air(design)

    def check() -> None:
        for cell in cell_catalogue(design, place_housings(design)).distinct:
            check_cell(cell_atlas(), cell, grid, air)

    return quick_fidelity_by(check)


def quick_fidelity_by(check: Callable[[], None]) -> QuickFidelity:
    """That of anything that is outside the atlas where ``check`` raises :class:`OutsideAtlas`."""
    try:
        check()
    except OutsideAtlas as error:
        return QuickFidelity("lumped", str(error))
    return QuickFidelity("atlas")
