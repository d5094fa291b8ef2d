"""What several test files need, made once for all processes of a test run.

The folder is that of the run (conftest.py makes it and takes it away): nothing outlives the code that made it.
"""

from __future__ import annotations

import functools
import os
import pickle
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TypeVar

import numpy as np
from filelock import FileLock

import acoustic_fem
import geometry
from acoustic_fem.library.transfer_functions import Library

T = TypeVar("T")


def shared_folder() -> Path:
    """Where the processes of a run keep what they share."""
    return Path(os.environ["ACOUSTIC_FEM_TESTS"])


def shared(name: str, make: Callable[[], T]) -> T:
    """What was made under this name, by whichever process came first; the others wait for it."""
    path = shared_folder() / f"{name}.pickle"
    with FileLock(path.with_suffix(".lock")):
        if path.exists():
            return pickle.loads(path.read_bytes())
        made = make()
        beside = path.with_suffix(".new")
        beside.write_bytes(pickle.dumps(made))
        beside.replace(path)
    return made


@functools.cache
def _solved(name: str, fidelity: str, grid: tuple[float, ...]) -> Library:
    def solve() -> Library:
        return acoustic_fem.solve(geometry.prototype(name), grid, fidelity)

    if fidelity == "lumped":  # sooner solved than read
        return solve()
    return shared(f"{name} {fidelity} {hash(grid):x}", solve)


def solved(name: str, frequency: Sequence[float] | np.ndarray, fidelity: str = "lumped") -> Library:
    """The library of a prototype; nobody changes it."""
    return _solved(name, fidelity, tuple(map(float, frequency)))
