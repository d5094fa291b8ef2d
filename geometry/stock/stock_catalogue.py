"""Catalogue of parts that can be bought, as it stands on this machine, and designs fitted to it."""

from __future__ import annotations

import os
from collections.abc import Sequence
from functools import lru_cache
from pathlib import Path

from geometry.design.design_file import DesignLike, resolve_design
from geometry.stock.fitting import Fitting, StockFit
from geometry.stock.stock_files import parts_of, stock_files, stock_places
from geometry.stock.stock_parts import StockParts


class Catalogue(StockParts):
    """Parts that can be bought, of which designs are made. Lengths in mm, prices in USD per unit of the part."""

    def fit(self, design: DesignLike) -> StockFit:
        """The design made of parts that can be bought.

        Bores, walls and thicknesses become those of the nearest parts with which the design is valid, if they change by
        less than a third. Otherwise they stay and are listed as missing, with the nearest part.

        Args:
            design: the array: a design, the path of its file, or the name of a prototype.
        """
        return Fitting(self, resolve_design(design)).result()


def catalogue(*places: str | os.PathLike[str]) -> Catalogue:
    """The parts that come with the package, with a user's own.

    Args:
        places: files or folders of a user's own parts; by default those that the environment variable
            ``ACOUSTIC_FEM_STOCK`` names.

    Raises:
        Refusal: no such file, or one that is not a file of parts: the message names the file, the field and its value.
    """
    chosen = tuple(Path(each) for each in places) or stock_places()
    files = tuple(stock_files(chosen))
    return _read(files, tuple(_state(path) for path in files))


@lru_cache(maxsize=8)
def _read(files: Sequence[Path], states: Sequence[tuple[int, int]]) -> Catalogue:
    """The catalogue with some files, read again where one was changed."""
    return Catalogue(parts_of(files))


def _state(path: Path) -> tuple[int, int]:
    try:
        found = path.stat()
    except OSError:
        return 0, 0  # what is wrong with it is said where it is read
    return found.st_mtime_ns, found.st_size
