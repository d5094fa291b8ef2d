"""Loaded into a dask worker (``--preload``): it can be held in a block, and tells what it does, by files in a folder.

Environment: ``HELD_FOLDER``, ``HELD_NAME``. While ``hold-NAME`` is there a block waits; ``at-NAME`` says that it has
come to one, ``asked-NAME`` that it was asked what is installed, ``solved-NAME-...`` that it solved a cell.
"""

from __future__ import annotations

import os
import time
import uuid
from pathlib import Path
from typing import Any

from acoustic_fem.cell import design_cells
from studies.sweep import block, cluster

FOLDER, NAME = Path(os.environ["HELD_FOLDER"]), os.environ["HELD_NAME"]


def dask_setup(worker: object) -> None:
    """Called once by dask, which loads this module twice."""
    solve, ask, cells = block.solve_block, cluster.installed, design_cells.solve_side_by_side

    def solve_block(*arguments: Any) -> Any:
        held = since()
        (FOLDER / f"at-{NAME}").touch()
        while held is not None and since() == held:
            time.sleep(0.02)
        return solve(*arguments)

    def since() -> int | None:
        """Since when blocks are held: a hold that was lifted and laid again is another one."""
        try:
            return (FOLDER / f"hold-{NAME}").stat().st_mtime_ns
        except FileNotFoundError:
            return None

    def installed() -> dict[str, str]:
        found = ask()
        (FOLDER / f"asked-{NAME}").touch()
        return found

    def solve_side_by_side(tasks: Any, *arguments: Any) -> None:
        cells(tasks, *arguments)
        for _ in tasks:
            (FOLDER / f"solved-{NAME}-{uuid.uuid4()}").touch()

    block.solve_block, cluster.installed = solve_block, installed
    design_cells.solve_side_by_side = solve_side_by_side
