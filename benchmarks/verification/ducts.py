"""Round bores against Bessel and hyperbolic functions of 50 digits, and their limits."""

from __future__ import annotations

from collections.abc import Callable

import mpmath
import numpy as np

from acoustic_fem.duct import plane_wave
from acoustic_fem.duct.sections import CircularSection
from benchmarks.verification.report import Check, Level, Study, Subject, Table
from tests.support.reference_data import AIR

_DIGITS = 50
_LENGTHS = (1e-4, 0.0125, 0.12, 1.0)
_ENTRIES = ("Z'", "Y'", "Γ", "Zc", "Y11", "Y12")
_TARGET = 1e-12

TEXT = f"""Z', Y', Γ = √(Z'Y'), Zc = √(Z'/Y') and the two-port are compared with the [formulas](theory.md#tubes), which
mpmath evaluates with {_DIGITS} digits, and with the exact limits. The round bores have diameters of 0.05 to 5 mm and
lengths of {1e3 * min(_LENGTHS):g} to {1e3 * max(_LENGTHS):g} mm, and the frequencies are 0.01 Hz to 20 kHz. The sum Y11
+ Y12 is not an output. At low frequency it is smaller than its terms by the factor |ΓL|²/2, so it loses many digits."""


def exact_per_length(radius: float, frequency: float) -> tuple[mpmath.mpc, mpmath.mpc]:
    """Z' and Y' of a round bore in the precision set in mpmath."""
    a, omega = mpmath.mpf(radius), 2 * mpmath.pi * mpmath.mpf(frequency)
    area, density, gamma = mpmath.pi * a**2, mpmath.mpf(AIR.density), mpmath.mpf(AIR.gamma)

    def mean(diffusivity: mpmath.mpf) -> mpmath.mpc:
        argument = a * mpmath.sqrt(-1j * omega / diffusivity)
        return 1 - 2 * mpmath.besselj(1, argument) / (argument * mpmath.besselj(0, argument))

    viscous = mean(mpmath.mpf(AIR.viscosity) / density)
    thermal = mean(mpmath.mpf(AIR.conductivity) / (density * mpmath.mpf(AIR.heat_capacity)))
    stored = gamma - (gamma - 1) * thermal
    return 1j * omega * density / (area * viscous), 1j * omega * area / (gamma * AIR.pressure) * stored


def run(quick: bool) -> Subject:
    """Errors over a grid of bores, frequencies and lengths."""
    count = (4, 7) if quick else (11, 22)
    worst: dict[str, tuple[float, str]] = dict.fromkeys((*_ENTRIES, "Y11 + Y12"), (0.0, ""))
    finite = True
    with mpmath.workdps(_DIGITS):
        for radius in np.geomspace(2.5e-5, 2.5e-3, count[0]):
            for frequency in np.geomspace(0.01, 2e4, count[1]):
                for name, value, exact, length in _pairs(radius, frequency):
                    finite = finite and bool(np.isfinite(value))
                    error = float(abs(mpmath.mpmathify(complex(value)) - exact) / abs(exact))
                    where = f"{2e3 * radius:.3g} mm, {frequency:.3g} Hz" + (f", {1e3 * length:g} mm" if length else "")
                    if error > worst[name][0]:
                        worst[name] = (error, where)
    checks = [
        Check(f"duct {name}", name, f"{_DIGITS} digits", worst[name][0], _TARGET, note=worst[name][1])
        for name in _ENTRIES
    ]
    checks.append(
        Check("duct overflow", "values that are not finite", "none", float(not finite), 0.0, unit="yes = 1"),
    )
    total, where = worst["Y11 + Y12"]
    rows = (("Y11 + Y12", f"{total:.1e}", where),)
    return Subject(
        "ducts",
        "Ducts",
        TEXT,
        _limits(quick),
        tuple(checks),
        (Table("Loss of the sum of two stored entries", ("sum", "largest relative error", "where"), rows),),
    )


def _pairs(radius: float, frequency: float) -> list[tuple[str, np.complex128, mpmath.mpc, float]]:
    """Name, computed value, exact value and length (0 where there is none)."""
    bore = CircularSection(radius)
    z, y = exact_per_length(radius, frequency)
    pairs = [
        ("Z'", plane_wave.series_impedance(radius, frequency, AIR), z, 0.0),
        ("Y'", plane_wave.shunt_admittance(radius, frequency, AIR), y, 0.0),
        ("Γ", bore.propagation(frequency, AIR), mpmath.sqrt(z * y), 0.0),
        ("Zc", bore.characteristic_impedance(frequency, AIR), mpmath.sqrt(z / y), 0.0),
    ]
    for length in _LENGTHS:
        x, zc = mpmath.sqrt(z * y) * mpmath.mpf(length), mpmath.sqrt(z / y)
        port = plane_wave.port_admittance(radius, length, frequency, AIR)
        pairs.append(("Y11", port[0, 0], mpmath.coth(x) / zc, length))
        transfer = -1 / (mpmath.sinh(x) * zc)
        if abs(transfer) > 1e-290:  # below, double precision has no normal numbers
            pairs.append(("Y12", port[0, 1], transfer, length))
        pairs.append(("Y11 + Y12", port[0, 0] + port[0, 1], mpmath.tanh(x / 2) / zc, length))
    return [(name, np.complex128(value), exact, length) for name, value, exact, length in pairs]


def _limits(quick: bool) -> tuple[Study, ...]:
    """Distance from the limits against the ratio of radius and layer, and against its inverse."""
    radius = 2.5e-4
    area = np.pi * radius**2
    narrow = np.geomspace(0.4, 0.025, 3 if quick else 5)
    wide = np.geomspace(400, 1e5, 3 if quick else 5)

    def study(
        key: str,
        title: str,
        limit: str,
        ratio: np.ndarray,
        distance: Callable[[np.ndarray], np.ndarray],
        expected: float,
    ) -> Study:
        frequency = ratio**2 * AIR.kinematic_viscosity / (2 * np.pi * radius**2)
        errors = distance(frequency)
        small = ratio if ratio[0] > ratio[-1] else 1 / ratio
        levels = [Level(f"{f:.3g} Hz", float(s), 0, float(e)) for f, s, e in zip(frequency, small, errors, strict=True)]
        unit = "a√(ω/ν)" if ratio is narrow else "1/(a√(ω/ν))"
        return Study(key, title, limit, unit, tuple(levels), expected, 0.1)

    def series(frequency: np.ndarray) -> np.ndarray:
        return plane_wave.series_impedance(radius, frequency, AIR)

    def shunt(frequency: np.ndarray) -> np.ndarray:
        return plane_wave.shunt_admittance(radius, frequency, AIR)

    poiseuille, mass = 8 * AIR.viscosity / (np.pi * radius**4), 4 * AIR.density / (3 * np.pi * radius**2)
    isothermal, adiabatic = area / AIR.pressure, area / (AIR.gamma * AIR.pressure)
    return (
        study(
            "limit R", "Re Z', narrow", "8μ/(πa⁴)", narrow, lambda f: np.abs(series(f).real / poiseuille - 1), 4
        ),
        study(
            "limit M", "Im Z', narrow", "ω 4ρ/(3πa²)", narrow,
            lambda f: np.abs(series(f).imag / (2 * np.pi * f * mass) - 1), 4,
        ),
        study(
            "limit C", "Im Y', narrow", "ωS/p₀", narrow,
            lambda f: np.abs(shunt(f).imag / (2 * np.pi * f * isothermal) - 1), 4,
        ),
        study(
            "limit wide Z", "Z', wide", "jωρ/S", wide,
            lambda f: np.abs(series(f) / (2j * np.pi * f * AIR.density / area) - 1), 1,
        ),
        study(
            "limit wide Y", "Y', wide", "jωS/(γp₀)", wide,
            lambda f: np.abs(shunt(f) / (2j * np.pi * f * adiabatic) - 1), 1,
        ),
    )  # fmt: skip
