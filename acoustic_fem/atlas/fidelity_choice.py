"""The fidelity of a quick answer: the atlas where it covers a design, 3-D where it does not."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from acoustic_fem.atlas.cell_in_atlas import check_cell
from acoustic_fem.atlas.cell_table import OutsideAtlas, cell_atlas
from acoustic_fem.quantities.checks import FrequencyLike, frequency_grid
from acoustic_fem.quantities.fidelity import MANY_DESIGNS, ONE_DESIGN, Fidelity
from acoustic_fem.quantities.local_air import design_air
from geometry.air.cells import cell_catalogue
from geometry.design.design_file import DesignLike, resolve_design
from geometry.layout.arrangement import place_housings


@dataclass(frozen=True)
class QuickFidelity:
    """The fidelity of a quick answer, and why it is not the atlas."""

    name: Fidelity
    """Fidelity, as :func:`acoustic_fem.solve` takes it."""
    outside: str = ""
    """Why the atlas does not cover the design; empty where it does."""

    @property
    def words(self) -> str:
        """The fidelity, and why it is not the atlas, in one line."""
        return f"{self.name}: {self.outside}" if self.outside else self.name


def quick_fidelity(design: DesignLike, frequency: FrequencyLike) -> QuickFidelity:
    """The fidelity of a quick answer for a design in its air.

    Args:
        design: the array: a design, the path of its file, or the name of a prototype.
        frequency: (n_freq,) Hz, at which it is solved, or FIRST:LAST:COUNT.

    Raises:
        Refusal: a bad frequency grid.
    """
    design, grid = resolve_design(design), frequency_grid(frequency)
    air = design_air(design)

    def check() -> None:
        for cell in cell_catalogue(design, place_housings(design)).distinct:
            check_cell(cell_atlas(), cell, grid, air)

    return quick_fidelity_by(check)


def quick_fidelity_by(check: Callable[[], None]) -> QuickFidelity:
    """The fidelity of a quick answer for anything that the atlas covers unless ``check`` raises OutsideAtlas."""
    try:
        check()
    except OutsideAtlas as error:
        return QuickFidelity(ONE_DESIGN, OutsideAtlas.of(error, remedy="").sentence())
    return QuickFidelity(MANY_DESIGNS)
