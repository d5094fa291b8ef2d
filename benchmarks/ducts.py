"""Ducts: accuracy of the closed forms and of the elements, and the effective bore of coil springs.

Run from the checkout: ``python -m benchmarks.ducts``; needs ``mpmath``.
"""

from __future__ import annotations

import time
import warnings
from collections.abc import Callable

import mpmath
import numpy as np

from acoustic_fem.duct import plane_wave, tapered
from acoustic_fem.duct.coil_bore import CoilBore
from acoustic_fem.duct.meshed_section import MeshedSection
from acoustic_fem.duct.sections import CircularSection, RectangularSection, Section, TriangularSection
from tests.support.reference_data import AIR


def round_bore() -> None:
    """Largest relative errors against 40 digits, bores 0.05 to 5 mm, 0.01 Hz to 20 kHz."""
    mpmath.mp.dps = 40
    lengths = [1e-6, 1e-3, 0.0125, 0.12, 1.0]
    series, shunt, own, transfer = 0.0, 0.0, 0.0, 0.0
    for radius in np.geomspace(2.5e-5, 2.5e-3, 11):
        for frequency in np.geomspace(0.01, 2e4, 16):
            a, omega = mpmath.mpf(radius), 2 * mpmath.pi * mpmath.mpf(frequency)
            rates = (AIR.viscosity, AIR.density), (AIR.conductivity, mpmath.mpf(AIR.density) * AIR.heat_capacity)
            arguments = [a * mpmath.sqrt(-1j * omega * mpmath.mpf(d) / mpmath.mpf(n)) for n, d in rates]
            viscous, thermal = (-mpmath.besselj(2, z) / mpmath.besselj(0, z) for z in arguments)
            z = 1j * omega * mpmath.mpf(AIR.density) / (mpmath.pi * a**2 * viscous)
            gamma = mpmath.mpf(AIR.gamma)
            y = 1j * omega * mpmath.pi * a**2 / (gamma * AIR.pressure) * (gamma - (gamma - 1) * thermal)
            series = max(series, relative(plane_wave.series_impedance(radius, frequency, AIR), z))
            shunt = max(shunt, relative(plane_wave.shunt_admittance(radius, frequency, AIR), y))
            for length in lengths:
                x, zc = mpmath.sqrt(z * y) * mpmath.mpf(length), mpmath.sqrt(z / y)
                port = plane_wave.port_admittance(radius, length, frequency, AIR)
                own = max(own, relative(port[0, 0], mpmath.coth(x) / zc))
                exact = -1 / (mpmath.sinh(x) * zc)
                if abs(exact) > 1e-290:
                    transfer = max(transfer, relative(port[0, 1], exact))
    print("Round bore against 40 digits (bores 0.05 to 5 mm, 0.01 Hz to 20 kHz, lengths up to 1 m)")
    print(f"  Z' {series:.1e}   Y' {shunt:.1e}   Y11 {own:.1e}   Y12 {transfer:.1e}\n")


def relative(value: np.ndarray, exact: mpmath.mpc) -> float:
    return float(abs(mpmath.mpmathify(complex(value)) - exact) / abs(exact))


def meshed_sections() -> None:
    rows: list[tuple[str, Callable[[int], MeshedSection], Section]] = [
        ("circle", lambda n: MeshedSection.circle(1.0, n), CircularSection(1.0)),
        ("rectangle 2:1", lambda n: MeshedSection.rectangle(2.0, 1.0, 2 * n, n), RectangularSection(2.0, 1.0)),
        (
            "triangle",
            lambda n: MeshedSection.triangle([[0, 0], [1, 0], [0.5, 0.75**0.5]], n),
            TriangularSection(1.0),
        ),
    ]
    rates = np.array([1e-3j, 10j, 100j])
    print("Meshed sections: relative error of <Psi> at size^2 omega/nu = 0.001, 10, 100, and order")
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", "the wall layer of", UserWarning)  # the coarse meshes are meant to be coarse
        for name, make, exact in rows:
            last = None
            for count in (2, 4, 8, 16, 32):
                start = time.perf_counter()
                section = make(count)
                errors = np.abs(section.mean_field(rates) / exact.mean_field(rates) - 1)
                spent = time.perf_counter() - start
                order = "" if last is None else "   order " + " ".join(f"{o:5.2f}" for o in np.log2(last / errors))
                shown = " ".join(f"{e:.1e}" for e in errors)
                print(f"  {name:14s} {len(section.triangles):5d} triangles   {shown}   {1e3 * spent:6.1f} ms{order}")
                last = errors
    print()


def cone() -> None:
    frequency = np.geomspace(0.1, 2e3, 64)
    start = time.perf_counter()
    result = tapered.solve(lambda x: CircularSection(2e-4 + 0.02 * x), 0.0125, frequency, AIR)
    spent = time.perf_counter() - start
    print("Cone 0.4 to 0.9 x 12.5 mm, 64 frequencies")
    print(f"  {result.elements} elements, error {result.error:.1e}, {spent:.2f} s\n")


def springs() -> None:
    print("Effective bore of close-wound springs (outer diameter x wire, mm)")
    for outer, wire in ((0.6e-3, 0.08e-3), (0.28e-3, 0.05e-3)):
        for refinement in (4, 8, 12, 16, 24):
            start = time.perf_counter()
            spring = CoilBore(outer, wire, refinement)
            radius = spring.effective_radius
            spent = time.perf_counter() - start
            crest = spring.crest_radius
            print(
                f"  {1e3 * outer:g} x {1e3 * wire:g}  refinement {refinement:2d}:  {2e3 * radius:.6f} mm instead of "
                f"{2e3 * crest:g} mm, resistance {100 * ((crest / radius) ** 4 - 1):+.3f} %, gas per length "
                f"{100 * (spring.volume_per_length / (np.pi * crest**2) - 1):+.2f} %, {spent:.2f} s"
            )


if __name__ == "__main__":
    round_bore()
    meshed_sections()
    cone()
    springs()
