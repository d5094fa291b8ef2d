"""Membranes on coarser meshes, for what holds on any mesh."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import pytest

from acoustic_fem.membrane import disc
from acoustic_fem.membrane.elasticity import MODES, REFINEMENT, solve_dimensionless
from acoustic_fem.membrane.solved_discs import solved_disc


@contextmanager
def coarse_discs() -> Iterator[None]:
    """Solve discs, in this process, with a step less per thickness, at half the cost: three times further off."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(solve_dimensionless, "__defaults__", (REFINEMENT - 1, MODES))
        patch.setattr(disc, "solved_disc", lambda shape: solved_disc(shape, REFINEMENT - 1))
        yield
