"""The fidelity of a quick answer: the atlas where it covers a design, 3-D where it does not, lumped for large cells."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from acoustic_fem.atlas.cell_in_atlas import check_cell
from acoustic_fem.atlas.cell_table import OutsideAtlas, cell_atlas
from acoustic_fem.cell.design_cells import too_large_cell
from acoustic_fem.quantities.checks import FrequencyLike, frequency_grid
from acoustic_fem.quantities.fidelity import MANY_DESIGNS, ONE_DESIGN, Fidelity
from acoustic_fem.quantities.local_air import design_air
from geometry.air.cells import Cell, cell_catalogue
from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import DesignLike, resolve_design
from geometry.ground.extras import is_installed
from geometry.ground.typed import Array
from geometry.layout.arrangement import place_housings


@dataclass(frozen=True)
class QuickFidelity:
    """The fidelity of a quick answer, and why it is not the atlas."""

    name: Fidelity
    """Fidelity, as :func:`acoustic_fem.solve` takes it."""
    outside: str = ""
    """Why the atlas does not cover the design; empty where it does."""
    too_large: str = ""
    """Why a cell cannot be solved in 3-D either; empty where it can, or need not."""

    @property
    def why(self) -> str:
        """Why it is not the atlas, and why not 3-D; empty where it is the atlas."""
        return "; ".join(filter(None, (self.outside, self.too_large)))

    @property
    def words(self) -> str:
        """The fidelity, and why it is not the atlas, in one line."""
        return f"{self.name}: {self.why}" if self.why else self.name


def quick_fidelity(design: DesignLike, frequency: FrequencyLike) -> QuickFidelity:
    """The fidelity of a quick answer for a design in its air.

    It is "lumped" where the atlas does not cover the design and the mesh of a cell would be too large for 3-D.

    Args:
        design: the array: a design, the path of its file, or the name of a prototype.
        frequency: (n_freq,) Hz, at which it is solved, or FIRST:LAST:COUNT.

    Raises:
        Refusal: a bad frequency grid.
    """
    design, grid = resolve_design(design), frequency_grid(frequency)
    found = quick_fidelity_by(lambda: _check(design, grid))
    if found.outside and is_installed("fem"):
        large = too_large_cell(_cells(design), grid, design_air(design))
        if large:
            return QuickFidelity("lumped", found.outside, large)
    return found


def outside_atlas(design: DesignLike, frequency: FrequencyLike) -> str:
    """Why the atlas does not cover a design in its air; empty where it does. Arguments as :func:`quick_fidelity`."""
    design, grid = resolve_design(design), frequency_grid(frequency)
    return quick_fidelity_by(lambda: _check(design, grid)).outside


def _check(design: ArrayDesign, grid: Array) -> None:
    air = design_air(design)
    for cell in _cells(design):
        check_cell(cell_atlas(), cell, grid, air)


def _cells(design: ArrayDesign) -> tuple[Cell, ...]:
    return cell_catalogue(design, place_housings(design)).distinct


def quick_fidelity_by(check: Callable[[], None]) -> QuickFidelity:
    """The fidelity of a quick answer for anything that the atlas covers unless ``check`` raises OutsideAtlas."""
    try:
        check()
    except OutsideAtlas as error:
        return QuickFidelity(ONE_DESIGN, OutsideAtlas.of(error, remedy="").sentence())
    return QuickFidelity(MANY_DESIGNS)
