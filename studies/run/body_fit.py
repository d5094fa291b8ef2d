"""An array laid on a body by the design file that names both."""

from __future__ import annotations

import os
from pathlib import Path

from geometry.surface import FittedSurface, fit_design as fitted_design
from studies.output.display import Display


def fit_design(design: str | os.PathLike[str], *, display: Display | None = None) -> tuple[FittedSurface, Path]:
    """Lay an array on a body from CAD, and write the places that its design file names.

    Args:
        design: design file with a table ``[surface]`` and ``layout.kind = "surface"``.
        display: shows progress.

    Returns:
        The array with its findings, and the file of places.

    Raises:
        Refusal: the design, the body or the region does not do, or parts overlap in every try.
    """
    with display or Display() as display, display.stage("Fit") as report:
        return fitted_design(design, report)
