"""3-D finite elements where the answer is known: straight tubes and the thermal field of closed cavities."""

from __future__ import annotations

from collections.abc import Callable

import cadquery as cq
import numpy as np

from acoustic_fem.cavity.closed_forms import closed_cylinder_compliance, closed_sphere_compliance
from acoustic_fem.cell.condensed import AirModel, BodyFaces, condense
from acoustic_fem.cell.solid import port_admittance
from acoustic_fem.duct import plane_wave
from acoustic_fem.fields.diffusion import diffusion_field, field_coefficients
from acoustic_fem.quantities.fidelity import Physics
from benchmarks.verification.report import Check, Level, Study, Subject
from geometry.air.mesh import MeshSizes, SolidMesh, mesh_solid
from tests.support.reference_data import AIR

TUBE_TEXT = """A tube of radius a = 0.25 mm and length 1 mm is solved by both 3-D models with uniform curved tetrahedra
(edge of the mean volume). The error is the largest of Y₁₁ and Y₁₂ relative to |Y₁₁|. At low frequency only the curved
wall causes errors, with order 4. At 2 kHz the layer √(2ν/ω) is a fifth of the radius, so the order is fitted
only to meshes finer than 2.5 layers. The points scatter, because the meshes are not refinements of each other."""

HEAT_TEXT = """The compliance of closed cavities with isothermal walls is compared with closed forms for a cylinder (6 x
2.5 mm), a
sphere (4 mm) and a box (4 x 3 x 2 mm; triple sine series). The compliance is an energy, so the order is 4, apart from a
logarithm along edges. This holds if the mesh resolves the layer √(2α/ω), which is 0.26 mm thick at 100 Hz. So the order
is fitted only to meshes finer than 2.5 layers."""

SUM_TEXT = """If all ports have the same pressure, the inflow at low frequency is that of isothermal gas, jω V/p₀.
Tetrahedra with
three faces on walls would not contribute their volume here, so the mesher splits them. The meshes are those for
`accuracy=2e-3`."""

_RADIUS, _LENGTH = 0.25, 1.0
_SUM_ACCURACY = 2e-3


def _element_size(mesh: SolidMesh) -> float:
    """Edge of a regular tetrahedron of the mean volume, mm."""
    return float((6 * np.sqrt(2) * mesh.mesh_volume / len(mesh.tetrahedra)) ** (1 / 3))


def _layer(diffusivity: float, frequency: float) -> float:
    """Thickness of the layer along the walls, mm."""
    return float(1e3 * np.sqrt(diffusivity / (np.pi * frequency)))


def tubes(quick: bool) -> Subject:
    """Straight tube by both models."""
    shape = cq.Workplane("YZ").circle(_RADIUS).extrude(_LENGTH).val()
    steps = (1.0, 0.707, 0.5) if quick else (1.0, 0.707, 0.5, 0.354, 0.25)
    models: tuple[tuple[Physics, str], ...] = (("navier-stokes", "Navier-Stokes"), ("helmholtz", "lossy Helmholtz"))
    frequency = np.array([1.0, 100.0, 2000.0])
    exact = plane_wave.port_admittance(_RADIUS * 1e-3, _LENGTH * 1e-3, frequency, AIR)
    studies = []
    for physics, name in models:
        levels: dict[str, list[Level]] = {"1 and 100 Hz": [], "2 kHz": []}
        for step in steps:
            sizes = MeshSizes(mouth_edge=step, tube=step, growth=1.0, largest=step * _RADIUS)
            mesh = mesh_solid(shape, {"a": (0, 0, 0), "b": (_LENGTH, 0, 0)}, ("a", "b"), sizes)
            body = condense(mesh, mesh, BodyFaces(("a", "b")), AirModel(AIR, (1.0, 2000.0), physics), tolerance=1e-7)
            error = (np.abs(body.nodal_admittance(frequency) - exact) / np.abs(exact[:, :1, :1])).max(axis=(1, 2))
            for label, value in (("1 and 100 Hz", error[:2].max()), ("2 kHz", error[2])):
                levels[label].append(Level(f"h = {step:g} a", _element_size(mesh), body.unknowns, float(value)))
        for label, found in levels.items():
            resolved = 2.5 * _layer(AIR.kinematic_viscosity, 2000.0) if label == "2 kHz" else None
            if not (quick and resolved):
                key, title = f"tube {physics} {label}", f"{name}, {label}"
                studies.append(Study(key, title, "exact duct", "mm", tuple(found), 4.0, 0.8, resolved=resolved))
    return Subject("tubes", "Straight tube in 3-D", TUBE_TEXT, tuple(studies))


def _box_compliance(sides: tuple[float, float, float], frequency: float, terms: int = 400) -> complex:
    """Compliance of a closed box (mm), m^3/Pa: triple sine series, the third sum in closed form."""
    rate = 2j * np.pi * frequency / AIR.thermal_diffusivity
    a, b, c = (1e-3 * side for side in sorted(sides, reverse=True))
    odd = np.arange(1, 2 * terms, 2)
    first, second = np.meshgrid(odd, odd, indexing="ij")
    wave = (first * np.pi / a) ** 2 + (second * np.pi / b) ** 2 + rate
    half = np.sqrt(wave) * c / 2
    # 400 terms along the two longer sides: 8e-9
    mean = np.sum(64 / (np.pi**4 * first**2 * second**2) * rate / wave * (1 - np.tanh(half) / half))
    return complex(a * b * c * (AIR.gamma - (AIR.gamma - 1) * mean) / (AIR.gamma * AIR.pressure))


def heat(quick: bool) -> Subject:
    """Compliance of closed cavities from the thermal field."""
    cavities: tuple[tuple[str, cq.Shape, Callable[[float], complex]], ...] = (
        (
            "cylinder", cq.Workplane().cylinder(2.5, 3.0).val(),
            lambda f: complex(closed_cylinder_compliance(3e-3, 2.5e-3, f, AIR)),
        ),
        ("sphere", cq.Workplane().sphere(2.0).val(), lambda f: complex(closed_sphere_compliance(2e-3, f, AIR))),
        ("box", cq.Workplane().box(4, 3, 2).val(), lambda f: _box_compliance((4, 3, 2), f)),
    )  # fmt: skip
    sizes = (1.0, 0.707, 0.5) if quick else (1.0, 0.707, 0.5, 0.354, 0.25)
    studies = []
    for name, solid, exact in cavities:
        levels: dict[float, list[Level]] = {10.0: [], 100.0: []}
        for size in sizes:
            mesh = mesh_solid(solid, {}, (), MeshSizes(mouth_edge=1.0, tube=size / 2, growth=1.0, largest=size))
            for frequency, found in levels.items():
                field = diffusion_field(mesh, [], AIR.thermal_diffusivity, (frequency, frequency))
                weights = field_coefficients(field.model, np.array([frequency]), AIR.thermal_diffusivity)[0]
                integral = (field.at_quadrature() * field.basis.dx).sum(axis=(1, 2)) @ weights
                stored = AIR.gamma * field.basis.dx.sum() - (AIR.gamma - 1) * integral
                compliance = 1e-9 * stored / (AIR.gamma * AIR.pressure)
                error = float(abs(compliance / exact(frequency) - 1))
                found.append(Level(f"h = {size:g} mm", _element_size(mesh), field.basis.N, error))
        for frequency, found in levels.items():
            resolved = 2.5 * _layer(AIR.thermal_diffusivity, frequency) if frequency > 50 else None
            if not (quick and resolved):
                key, title = f"heat {name} {frequency:g}", f"{name}, {frequency:g} Hz"
                studies.append(Study(key, title, "closed form", "mm", tuple(found), 4.0, 0.8, resolved=resolved))
    return Subject("heat", "Thermal field", HEAT_TEXT, tuple(studies))


def sums(_: bool) -> Subject:
    """Low-frequency inflow of cavities with corners and without; the full page only."""
    radius, frequency = 0.25, 0.1
    tube = cq.Workplane("YZ").circle(radius).extrude(6, both=True)
    solids = {
        "box 4 x 3 x 2 mm, two tubes": cq.Workplane().box(4, 3, 2).union(tube),
        "cylinder 6 x 2.5 mm, two tubes": cq.Workplane().cylinder(2.5, 3).union(tube),
        "box with one tube beside an edge": cq.Workplane()
        .box(4, 3, 2)
        .union(cq.Workplane("YZ").center(-1.2, -0.7).circle(radius).extrude(6)),
    }
    checks = []
    for name, solid in solids.items():
        x, y, z = (6.0, -1.2, -0.7) if "one tube" in name else (6.0, 0.0, 0.0)
        ports = {"a": (x, y, z)} if "one tube" in name else {"a": (x, y, z), "b": (-x, y, z)}
        admittance = port_admittance(solid, ports, [frequency], AIR, accuracy=_SUM_ACCURACY)[0]
        compliance = admittance.sum() / (2j * np.pi * frequency)
        volume = solid.val().Volume() * 1e-9
        error = float(abs(compliance.real * AIR.pressure / volume - 1))
        checks.append(Check(f"sum {name}", name, "V/p₀ at 0.1 Hz", error, 1e-4))
    return Subject("sums", "Inflow at low frequency", SUM_TEXT, (), tuple(checks))
