"""Errors of the fidelities in closed form on the prototypes, against the default.

``python -m benchmarks.atlas.prototype_errors NAME ...`` prints a row for each.
"""

from __future__ import annotations

import sys
import warnings

import geometry
from benchmarks.atlas.certify import errors

NAMES = ("array-2x6", "fingertip-3x4", "line-3", "line-4", "large-area-64", "glove")


def main(names: list[str]) -> None:
    """Print a row for each prototype."""
    for name in names:
        design = geometry.prototype(name)
        with warnings.catch_warnings():
            warnings.filterwarnings("ignore", "entrance loss of a tube|membrane: ", UserWarning)
            found = {fidelity: errors(design, fidelity) for fidelity in ("lumped", "atlas")}
        figures = [f"{100 * e.heard:.2f} %, {100 * e.per_log:.2f} %" for e in found.values()]
        print(f"| `{name}` | " + " | ".join(figures) + " |", flush=True)


if __name__ == "__main__":
    main(sys.argv[1:] or list(NAMES))
