"""Settings shared by all tests."""

from __future__ import annotations

import os
import sys
import tempfile

# Before NumPy, torch or VTK are imported. The tests run in parallel processes: one thread each.
for _variable in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ.setdefault(_variable, "1")
os.environ.setdefault("MPLBACKEND", "Agg")
os.environ.setdefault("PYVISTA_OFF_SCREEN", "true")
if sys.platform == "linux" and not os.environ.get("DISPLAY"):
    os.environ.setdefault("VTK_DEFAULT_OPENGL_WINDOW", "vtkEGLRenderWindow")  # not X first, which warns

# One cache of cells for all processes of a test run, apart from the user's own, and one of what else they share.
if "ACOUSTIC_FEM_TESTS" not in os.environ:
    _folder = tempfile.TemporaryDirectory(prefix="acoustic-fem-tests-")
    os.environ["ACOUSTIC_FEM_TESTS"] = _folder.name
os.environ.setdefault("ACOUSTIC_FEM_CACHE", os.path.join(os.environ["ACOUSTIC_FEM_TESTS"], "cells"))

import pytest
import threadpoolctl
from hypothesis import settings

# Where a plugin has loaded NumPy already, its BLAS has not read the variables.
threadpoolctl.threadpool_limits(1)

# Times on a shared machine say nothing; the same examples every time make a failure repeatable.
settings.register_profile("acoustic-fem", deadline=None, derandomize=True, max_examples=50)
settings.load_profile("acoustic-fem")


@pytest.hookimpl(tryfirst=True)  # before -m chooses
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Marks as ``unit`` whatever has no other mark of ours."""
    for item in items:
        if not any(item.get_closest_marker(name) for name in ("physics", "end_to_end", "slow")):
            item.add_marker(pytest.mark.unit)
