"""3-D cells on coarse meshes, for what holds on any mesh."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

# The accuracy is a part of the key of the cache.
_COARSE = {"DESIGN_ACCURACY": 0.03}


@contextmanager
def coarse_cells() -> Iterator[None]:
    """Solve cells, in this process, with a third of the usual unknowns; they are 1 to 3 % off, and say so.

    Of bodies of any shape an ``accuracy`` of up to 0.1 may be asked.
    """
    with pytest.MonkeyPatch.context() as patch:
        for name, value in _COARSE.items():
            patch.setattr(f"acoustic_fem.cell.one_cell.{name}", value)
        patch.setattr("acoustic_fem.cell.solid._ACCURACY_RANGE", (2e-4, 0.1))
        yield


def coarse_in_children(folder: Path) -> None:
    """Let Python programs that find this folder on their path solve cells as coarsely."""
    lines = ["from acoustic_fem.cell import one_cell", *(f"one_cell.{name} = {_COARSE[name]}" for name in _COARSE)]
    (folder / "sitecustomize.py").write_text("\n".join(lines) + "\n")
