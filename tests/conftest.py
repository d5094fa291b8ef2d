"""Settings shared by all tests."""

from __future__ import annotations

import os
import sys

# Before NumPy, torch or VTK are imported. The tests run in parallel processes: one thread each.
for _variable in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ.setdefault(_variable, "1")
os.environ.setdefault("MPLBACKEND", "Agg")
os.environ.setdefault("PYVISTA_OFF_SCREEN", "true")
if sys.platform == "linux" and not os.environ.get("DISPLAY"):
    os.environ.setdefault("VTK_DEFAULT_OPENGL_WINDOW", "vtkEGLRenderWindow")  # not X first, which warns

from hypothesis import settings

# Times on a shared machine say nothing; the same examples every time make a failure repeatable.
settings.register_profile("acoustic-fem", deadline=None, derandomize=True)
settings.load_profile("acoustic-fem")
