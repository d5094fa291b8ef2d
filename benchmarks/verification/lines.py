"""Sections by finite elements against closed forms; ducts that vary along the axis against exact horns; springs."""

from __future__ import annotations

import warnings
from collections.abc import Callable
from dataclasses import dataclass

import mpmath
import numpy as np
from numpy.typing import ArrayLike, NDArray

from acoustic_fem.duct import plane_wave, tapered
from acoustic_fem.duct.coil_bore import CoilBore, flow_system, half_pitch_mesh
from acoustic_fem.duct.meshed_section import MeshedSection
from acoustic_fem.duct.sections import CircularSection, RectangularSection, Section, SlitSection, TriangularSection
from acoustic_fem.quantities.medium import Medium
from benchmarks.verification.report import Check, Level, Study, Subject, Table
from tests.support.reference_data import AIR

SECTION_TEXT = """The means ⟨Ψ⟩ of meshed sections are computed with quadratic elements on curved triangles. Such a mean
is an energy, so the order of its error is 4, which is twice that of the field. This holds if the mesh resolves the
layer along the wall. At d²ω/ν = 100 this layer is thin. Here d is the diameter, or the longer or only side."""

TAPER_TEXT = """For an exponential horn, the error of elements of degree p in one dimension has the order 2p. A lossy
cone has no exact
solution. It is therefore also solved as a staircase of cylinders, whose error has the order 2, at 1, 100 and 1000
Hz."""

_RATES = {"slow": 1e-3, "fast": 100.0}


def sections(quick: bool) -> Subject:
    """Orders of the meshed sections and checks of the closed forms."""
    shapes: list[tuple[str, Callable[[int], MeshedSection], Section]] = [
        ("circle", lambda n: MeshedSection.circle(0.5, n), CircularSection(0.5)),
        ("rectangle 2:1", lambda n: MeshedSection.rectangle(1.0, 0.5, 2 * n, n), RectangularSection(1.0, 0.5)),
        (
            "triangle",
            lambda n: MeshedSection.triangle([[0, 0], [1, 0], [0.5, 0.75**0.5]], n),
            TriangularSection(1.0),
        ),
    ]
    counts = (4, 8, 16) if quick else (4, 8, 16, 32)
    studies = []
    for name, make, exact in shapes:
        meshes = [make(count) for count in counts]
        for speed, rate in _RATES.items():
            levels = []
            for count, mesh in zip(counts, meshes, strict=True):
                with warnings.catch_warnings():
                    # the coarse meshes are meant to be too coarse
                    warnings.filterwarnings("ignore", "the wall layer of", UserWarning)
                    value = mesh.mean_field(np.array([1j * rate]))
                error = np.abs(value / exact.mean_field(np.array([1j * rate])) - 1).max()
                unknowns = len(mesh.points)
                levels.append(Level(f"{len(mesh.triangles)} triangles", 1 / count, unknowns, float(error)))
            title = f"{name}, d²ω/ν = {rate:g}"
            studies.append(Study(f"section {name} {speed}", title, "closed form", "side / d", tuple(levels), 4.0, 0.7))
    return Subject("sections", "Sections", SECTION_TEXT, tuple(studies), _closed_forms())


def _closed_forms() -> tuple[Check, ...]:
    worst = 0.0
    rates = (1e-3, 1.0, 30.0, 1e4)
    for width, height in ((1.0, 1.0), (2.0, 1.0), (20.0, 1.0)):
        for rate in rates:
            with mpmath.workdps(30):
                exact = complex(_rectangle(width, height, rate))
            value = RectangularSection(width, height).mean_field(np.array(1j * rate))
            worst = max(worst, float(abs(value / exact - 1)))
    slit = max(
        float(
            abs(
                RectangularSection(1000.0, 1.0).mean_field(np.array(1j * rate))
                / SlitSection(1.0, 1000.0).mean_field(np.array(1j * rate))
                - 1
            )
        )
        for rate in rates
    )
    return (
        Check("rectangle", "rectangle, closed form", "series of 30 digits", worst, 1e-12),
        Check("slit", "slit against a rectangle 1000:1", "side walls neglected: 0.63 gap/width", slit, 0.63e-3 * 1.01),
    )


def _rectangle(width: float, height: float, rate: float) -> mpmath.mpc:
    long, short, s = mpmath.mpf(width), mpmath.mpf(height), mpmath.mpc(0, rate)

    def term(k: int) -> mpmath.mpc:
        wave = mpmath.sqrt(((2 * k + 1) * mpmath.pi / short) ** 2 + s)
        drag = mpmath.tanh(wave * long / 2) / (wave * long / 2)
        return 8 / (mpmath.pi * (2 * k + 1)) ** 2 * s / wave**2 * drag

    half = mpmath.sqrt(s) * short / 2
    return 1 - mpmath.tanh(half) / half - mpmath.nsum(term, [0, mpmath.inf])


# -- ducts that vary along the axis --------------------------------------------------------------------------

_SERIES, _SHUNT, _FLARE, _HORN = 3e11 + 1e12j, 2e-7 + 5e-6j, 80.0, 0.002


@dataclass(frozen=True)
class _HornSlice(plane_wave.Line):
    """Z' falls and Y' grows with the section, exp(2 m x)."""

    place: float

    def series_impedance(self, frequency: ArrayLike, medium: Medium) -> NDArray[np.complex128]:
        return np.full(np.shape(frequency), _SERIES * np.exp(-2 * _FLARE * self.place))

    def shunt_admittance(self, frequency: ArrayLike, medium: Medium) -> NDArray[np.complex128]:
        return np.full(np.shape(frequency), _SHUNT * np.exp(2 * _FLARE * self.place))


def _exact_horn() -> NDArray[np.complex128]:
    """Two-port by p = exp(-m x) (A exp(k x) + B exp(-k x)), k^2 = m^2 + Z'Y'; Kinsler et al. (2000), section 14.8."""
    k = np.sqrt(_FLARE**2 + _SERIES * _SHUNT)
    rates = np.array([k - _FLARE, -k - _FLARE])
    far = np.exp(rates * _HORN)
    pressure = np.array([[1, 1], far])
    flow = np.array([-rates / _SERIES, rates * far / (_SERIES * np.exp(-2 * _FLARE * _HORN))])
    return np.asarray(flow @ np.linalg.inv(pressure))


def tapers(quick: bool) -> Subject:
    """Orders of the elements in one dimension."""
    exact, studies = _exact_horn(), []
    for degree, counts in ((1, (16, 32, 64, 128)), (2, (8, 16, 32, 64)), (3, (4, 8, 16, 32)), (4, (2, 4, 8))):
        levels = []
        for count in counts[:3] if quick else counts:
            nodes = np.linspace(0, _HORN, count + 1)
            transfer, first, last = tapered.assemble(_HornSlice, nodes, np.array([1.0]), AIR, degree)[:, 0]
            admittance = np.array([[first + transfer, -transfer], [-transfer, last + transfer]])
            error = float(np.abs(admittance / exact - 1).max())
            levels.append(Level(f"{count} elements", 1 / count, degree * count + 1, error))
        title, order = f"horn, degree {degree}", 2.0 * degree
        studies.append(Study(f"horn {degree}", title, "exact horn", "element / L", tuple(levels), order, 0.3))
    staircase, cone = _cone(quick)
    return Subject("tapers", "Ducts of varying section", TAPER_TEXT, (*studies, staircase), cone)


def _cone(quick: bool) -> tuple[Study, tuple[Check, ...]]:
    first, last, length = 2e-4, 4.5e-4, 0.0125
    frequency = np.array([1.0, 100.0, 1000.0])
    solved = tapered.solve(
        lambda x: CircularSection(first + (last - first) * x / length), length, frequency, AIR, accuracy=1e-11
    )
    levels = []
    for count in (8, 16, 32) if quick else (8, 16, 32, 64, 128):
        middles = (np.arange(count) + 0.5) / count
        pieces = plane_wave.port_admittance(
            (first + (last - first) * middles)[:, None], length / count, frequency, AIR
        )  # (count, n_freq, 2, 2)
        whole = pieces[0]
        for piece in pieces[1:]:
            between = whole[:, 1, 1] + piece[:, 0, 0]
            transfer = -whole[:, 0, 1] * piece[:, 0, 1] / between
            own = whole[:, 0, 0] - whole[:, 0, 1] ** 2 / between
            far = piece[:, 1, 1] - piece[:, 0, 1] ** 2 / between
            whole = np.stack([np.stack([own, transfer], -1), np.stack([transfer, far], -1)], -2)
        error = float(np.abs(whole / solved.admittance - 1).max())
        levels.append(Level(f"{count} cylinders", 1 / count, count, error))
    slope = (last - first) / length
    resistance = 8 * AIR.viscosity / np.pi * (first**-3 - last**-3) / (3 * slope)
    slow = tapered.port_admittance(lambda x: CircularSection(first + slope * x), length, [1e-3], AIR, accuracy=1e-11)
    error = abs(float((1 / slow[0, 0, 0]).real) / resistance - 1)
    return (
        Study("cone", "staircase of cylinders", "elements of degree 4", "step / L", tuple(levels), 2.0, 0.2),
        (Check("cone resistance", "resistance of a cone at 0.001 Hz", "∫ 8μ/(πa⁴) dx", error, 1e-9),),
    )


# -- the ribbed bore of a spring -----------------------------------------------------------------------------

SPRING_TEXT = """The effective bore follows from an axisymmetric Navier-Stokes solution in half a pitch
([theory](theory.md#tubes)). Meshes
of quadratic elements on curved quadrilaterals are compared with a mesh of 24 columns."""


def springs(quick: bool) -> Subject:
    """The effective bore of the two springs of the prototypes."""
    refinements = (4, 6, 8) if quick else (4, 6, 8, 12, 16)
    studies, rows = [], []
    for outer, wire in ((0.6e-3, 0.08e-3), (0.28e-3, 0.05e-3)):
        finest = CoilBore(outer, wire, 24).effective_radius
        levels = []
        depth = wire / 2 / (outer / 2 - wire)
        for refinement in refinements:
            error = abs(CoilBore(outer, wire, refinement).effective_radius / finest - 1)
            unknowns = len(flow_system(half_pitch_mesh(depth, depth, refinement))[1])
            levels.append(Level(f"{refinement} columns", 1 / refinement, unknowns, error))
        name = f"{1e3 * outer:g} mm, wire {1e3 * wire:g} mm"
        studies.append(
            Study(f"spring {1e3 * outer:g}", f"spring {name}", "24 columns", "column / arc", tuple(levels), 4.0, 0.8)
        )
        crest = CoilBore(outer, wire).crest_radius
        rows.append(
            (
                name, f"{2e3 * crest:.2f} mm", f"{2e3 * finest:.4f} mm", f"{100 * ((crest / finest) ** 4 - 1):+.2f} %",
            )
        )  # fmt: skip
    header = ("spring", "outer diameter - 2 wire", "effective bore", "resistance against the first")
    table = Table("Effective bore", header, tuple(rows))
    return Subject("springs", "The bore of a spring", SPRING_TEXT, tuple(studies), (), (table,))
