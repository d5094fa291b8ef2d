"""State spaces of the prototypes: ``python -m benchmarks.state_spaces`` prints the table of docs/formats.md."""

from __future__ import annotations

import acoustic_fem
from acoustic_fem.circuit import fit_sensor

DESIGNS = ("array-2x6", "glove", "fingertip-3x4", "line-2", "large-area-64")
"""Prototypes."""
TOLERANCES = (1e-2, 1e-3, 1e-4)
"""Errors that are asked for."""
FREQUENCIES = "1:500:500"
"""Frequencies of the libraries."""


def main() -> None:
    """Print the table."""
    print("| design | responses |" + "".join(f" {tolerance:g} |" for tolerance in TOLERANCES))
    print("|---" * (2 + len(TOLERANCES)) + "|")
    for name in DESIGNS:
        library = acoustic_fem.solve(name, FREQUENCIES, "lumped")
        cells = []
        for tolerance in TOLERANCES:
            try:
                model = fit_sensor(library, tolerance=tolerance)
                cells.append(f"{model.order}: {model.error:.1e}, {model.margin:.1e}")
            except acoustic_fem.numerics.VectorFitError as error:
                cells.append(str(error).partition(": ")[2])
        count = library.transfer_function.sizes["point"] * library.transfer_function.sizes["microphone"]
        print(f"| `{name}` | {count} | " + " | ".join(cells) + " |")


if __name__ == "__main__":
    main()
