"""The membrane: mixed elasticity against thin plates, an independent solver's rows and its own finest mesh."""

from __future__ import annotations

from functools import cache

import numpy as np

from acoustic_fem.membrane.disc import solve_disc
from acoustic_fem.membrane.elasticity import ElasticDisc, solve_dimensionless
from acoustic_fem.membrane.half_section import DiscShape
from benchmarks.verification.report import Check, Level, Study, Subject, Table
from tests.support.reference_data import rows

TEXT = """Meshes of elements of size h/n are compared with the finest mesh (refinement {finest}; the default is 4). The
order of an energy is 4 if the solution is smooth, but the singular stress at the edge of the clamp lowers it. The
reference values of an independent solver are accurate to 5e-4. For small h/a, the membrane is a Kirchhoff plate."""

_POISSON = 0.49
_FINEST = 7


@cache
def _disc(shape: DiscShape, refinement: int) -> ElasticDisc:
    return solve_dimensionless(shape, refinement)


def _plate_compliance(thickness: float) -> float:
    """Compliance of a clamped Kirchhoff plate, in a^3 / E."""
    return float(np.pi / 192 * 12 * (1 - _POISSON**2) / thickness**3)


def run(quick: bool) -> Subject:
    """Orders, rows of an independent solver and the ratios to the thin plate."""
    studies = []
    for name, shape in (
        ("clamped, h/a = 0.1", DiscShape(0.1, _POISSON, 0.0, 0.0, 0.0, 0.25)),
        ("glued on a rim, h/a = 1/6", DiscShape(1 / 6, _POISSON, 0.5, 0.5, 0.0, 0.25)),
    ):
        if quick and shape.rim == 0:
            continue
        last = _disc(shape, _FINEST)
        solved = {n: _disc(shape, n) for n in ((2, 3, 4) if quick else (2, 3, 4, 5))}
        for quantity, read in (
            ("compliance", lambda disc: disc.compliance),
            ("eigenvalue", lambda disc: disc.eigenvalues[0]),
        ):
            levels = [
                Level(f"n = {n}", 1 / n, disc.unknowns, float(abs(read(disc) / read(last) - 1)))
                for n, disc in solved.items()
            ]
            studies.append(
                Study(
                    f"disc {name} {quantity}", f"{name}: {quantity}", "finest mesh", "step / h", tuple(levels), 4.0, 1.0
                )
            )
    thicknesses = (0.02,) if quick else (0.02, 0.05, 0.1, 0.2, 0.33)
    ratios = {h: _disc(DiscShape(h, _POISSON, 0.0, 0.0, 0.0, 0.25), 4).compliance for h in thicknesses}
    table = Table(
        "Compliance of a clamped disc over Kirchhoff's plate, ν = 0.49",
        ("h/a", *(f"{h:g}" for h in ratios)),
        (("ratio", *(f"{value / _plate_compliance(h):.4f}" for h, value in ratios.items())),),
    )
    return Subject(
        "membranes", "Membranes", TEXT.format(finest=_FINEST), tuple(studies), _against_rows(ratios), (table,)
    )


def _against_rows(compliance: dict[float, float]) -> tuple[Check, ...]:
    """Other program's discs; the thin plate."""
    volume = frequency = 0.0
    for row in rows("clamped_disc"):
        disc = solve_disc(row["a"], row["h"], row["E"], row["nu"], density=row["rho"])
        volume = max(volume, abs(disc.static_compliance / row["Cvol"] - 1))
        frequency = max(frequency, abs(disc.first_frequency / row["f1"] - 1))
    thin = abs(compliance[0.02] / _plate_compliance(0.02) - 1)
    return (
        Check("disc compliance", "compliance of three clamped discs", "reference rows", volume, 5e-4),
        Check("disc frequency", "their first frequency", "reference rows", frequency, 5e-4),
        Check("disc thin", "compliance at h/a = 0.02", "Kirchhoff plate", thin, 3e-3),
    )
