"""The reference numbers of the tests, and the gas they were computed for."""

from __future__ import annotations

import sys
from pathlib import Path

ROOT = Path(__file__).parents[2]
if str(ROOT / "tests") not in sys.path:
    sys.path.append(str(ROOT / "tests"))

from reference_data import AIR, column, rows  # noqa: E402

__all__ = ["AIR", "ROOT", "column", "rows"]
