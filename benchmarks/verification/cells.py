"""Cells and openings by 3-D Navier-Stokes against the reference rows; a whole array in one mesh."""

from __future__ import annotations

import cadquery as cq
import numpy as np
from numpy.typing import NDArray

from acoustic_fem.cell.condensed import AirModel, BodyFaces, condense
from acoustic_fem.cell.solid import solve_solid
from acoustic_fem.duct import plane_wave
from acoustic_fem.duct.sections import CircularSection
from acoustic_fem.fields.element_sizes import mesh_sizes
from benchmarks.one_mesh import in_one_mesh, in_pieces, transfer_functions
from benchmarks.verification.report import Check, Level, Study, Subject, Table
from geometry.air.mesh import InvertedElementsError, MeshSizes, mesh_solid
from tests.support.reference_data import AIR, column, rows

CELL_TEXT = """The reference cell is a rigid cylinder of 6 x 2.5 mm with two tubes of 0.5 x 6.25 mm opposite each other
at mid height, from 1 to 100 Hz. The reference values come from an independent Taylor-Hood solver
(tests/reference/acoustics.json) and are accurate to 5e-4. Errors are relative to |Y₁₁|, but the error of the sum is
relative to the sum. Because of the thermal layer, the order of the sum is 3 to 4. On meshes that are not graded, the
order of the admittances would be 1.1, because the pressure is singular at the edge of the mouth (Moffatt 1964). The
checks are calls with `accuracy=1e-3`."""

OPENING_TEXT = """A tube of radius a = 0.25 mm, 1 mm long in the mesh, opens into the end of a duct of 5 a or 50 a.
If the exact ducts are subtracted, the impedance of the opening remains, Z a³/μ. It is
compared with the axisymmetric solution of an independent Navier-Stokes solver. This solution is accurate to 2e-3, so
the error levels off there."""

ARRAY_TEXT = """An array of three points and two microphones is solved in one 3-D mesh, with its membranes, tubes and
both ends
(`benchmarks/one_mesh.py`). The result is compared with the usual method, which joins cells by plane waves. The
frequencies are 1, 10 and 100 Hz."""

_FREQUENCY = column("resonator_cell", "frequency")


def _extended(inner: NDArray[np.complex128], extension: NDArray[np.complex128]) -> NDArray[np.complex128]:
    """A duct on each of the two stubs."""
    whole = np.zeros((len(inner), 4, 4), dtype=np.complex128)
    whole[:, :2, :2] = inner
    for k in range(2):
        whole[np.ix_(range(len(inner)), [k, 2 + k], [k, 2 + k])] += extension
    return np.asarray(whole[:, 2:, 2:] - whole[:, 2:, :2] @ np.linalg.solve(whole[:, :2, :2], whole[:, :2, 2:]))


def cell(_: bool) -> Subject:
    """The reference cell; the full page only."""
    solid = cq.Workplane().cylinder(2.5, 3).union(cq.Workplane("YZ").circle(0.25).extrude(4.0, both=True))
    half = solid.intersect(cq.Workplane().box(20, 20, 20).translate((0, 10, 0))).val()
    extension = plane_wave.port_admittance(2.5e-4, 5.25e-3, _FREQUENCY, AIR)
    found: list[tuple[float, int, NDArray[np.complex128]]] = []
    for scale in (2.0, 1.414, 1.0, 0.707, 0.5):
        faces = {"a": (4.0, 0.1, 0.0), "b": (-4.0, 0.1, 0.0), "mirror": (0.0, 0.0, 0.0)}
        try:
            flow, warm = (mesh_solid(half, faces, ("a", "b"), size) for size in mesh_sizes(scale, 2.5, AIR, 100.0))
        except InvertedElementsError:
            continue  # too coarse for the shape, as solve_solid finds too
        body = condense(flow, warm, BodyFaces(("a", "b"), mirror="mirror"), AirModel(AIR, (1.0, 100.0)), tolerance=1e-6)
        found.append((scale, body.unknowns, _extended(body.nodal_admittance(_FREQUENCY), extension)))
    finest = found[-1][2]
    flows, totals = [], []
    for scale, unknowns, y in found[:-1]:
        entries = np.abs(y - finest) / np.abs(finest[:, :1, :1])
        total = np.abs(y[:, 0].sum(axis=1) / finest[:, 0].sum(axis=1) - 1)
        label = f"scale {scale:g}"
        flows.append(Level(label, scale, unknowns, float(entries.max())))
        totals.append(Level(label, scale, unknowns, float(total.max())))
    studies = (
        Study("cell Y", "reference cell, Y₁₁ and Y₁₂", "finest mesh", "scale", tuple(flows), 3.2, 1.0,
              "between 2.2 (edge of the mouth, by the square of the scale) and 4"),
        Study("cell sum", "reference cell, Y₁₁ + Y₁₂", "finest mesh", "scale", tuple(totals), 3.0, 1.0,
              "thermal layer on unresolved meshes"),
    )  # fmt: skip
    table = Table(
        "The same meshes against the reference rows",
        ("mesh", "unknowns", "Y₁₁", "Y₁₂", "Y₁₁ + Y₁₂"),
        tuple(
            (f"scale {scale:g}", str(unknowns), *(f"{error:.1e}" for error in _against_rows(y)))
            for scale, unknowns, y in found
        ),
        detail=True,
    )
    whole = cq.Workplane().cylinder(2.5, 3).union(cq.Workplane("YZ").circle(0.25).extrude(9.25, both=True))
    solved = solve_solid(whole, {"a": (9.25, 0, 0), "b": (-9.25, 0, 0)}, (1.0, 100.0), AIR, accuracy=1e-3)
    errors = _against_rows(solved.body.nodal_admittance(_FREQUENCY))
    note = f"{solved.body.unknowns} unknowns, mesh error said to be {solved.mesh_error:.1e}"
    checks = tuple(
        Check(f"cell {name}", f"reference cell, {name}", "reference rows", error, 1e-3, note=note)
        for name, error in zip(("Y₁₁", "Y₁₂", "Y₁₁ + Y₁₂"), errors, strict=True)
    )
    return Subject("cell", "The reference cell", CELL_TEXT, studies, checks, (table,))


def _against_rows(y: NDArray[np.complex128]) -> tuple[float, float, float]:
    """Largest relative deviations of Y11, Y12 and their sum from the reference rows."""
    own, transfer = column("resonator_cell", "Y11"), column("resonator_cell", "Y12")
    pairs = ((y[:, 0, 0], own), (y[:, 0, 1], transfer), (y[:, 0].sum(axis=1), own + transfer))
    first, second, third = (float(np.abs(value / exact - 1).max()) for value, exact in pairs)
    return first, second, third


# -- openings ---------------------------------------------------------------------------------------------


def _chain(radius: float, length: float, frequency: NDArray[np.float64]) -> NDArray[np.complex128]:
    """Chain matrix of a round duct (mm): pressure and flow at its start from those at its end."""
    bore = CircularSection(1e-3 * radius)
    x = bore.propagation(frequency, AIR) * 1e-3 * length
    zc = bore.characteristic_impedance(frequency, AIR)
    return np.stack(
        [np.stack([np.cosh(x), zc * np.sinh(x)], -1), np.stack([np.sinh(x) / zc, np.cosh(x)], -1)], -2
    )  # fmt: skip


def _opening(
    radius: float, wide: float, length: float, frequency: NDArray[np.float64], sizes: MeshSizes
) -> tuple[NDArray[np.complex128], int]:
    """Series impedance of the opening times a^3/mu, and the unknowns."""
    stub = 4 * radius
    solid = cq.Workplane("YZ").circle(radius).extrude(-stub).union(cq.Workplane("YZ").circle(wide).extrude(length))
    half = solid.intersect(cq.Workplane().box(100, 50, 100).translate((0, 25, 0))).val()
    faces = {"tube": (-stub, radius / 5, 0.0), "wide": (length, radius / 5, 0.0), "mirror": (length / 2, 0.0, 0.0)}
    mesh = mesh_solid(half, faces, ("tube",), sizes)
    band = (float(frequency[0]), float(frequency[-1]))
    body = condense(mesh, mesh, BodyFaces(("tube", "wide"), mirror="mirror"), AirModel(AIR, band), tolerance=1e-7)
    y = body.nodal_admittance(frequency)
    one = np.ones(len(frequency))
    determinant = y[:, 0, 0] * y[:, 1, 1] - y[:, 0, 1] ** 2
    chain = -np.stack([np.stack([y[:, 1, 1], one], -1), np.stack([determinant, y[:, 0, 0]], -1)], -2)
    chain = chain / y[:, 0, 1][:, None, None]
    between = np.linalg.solve(_chain(radius, stub, frequency), chain) @ np.linalg.inv(_chain(wide, length, frequency))
    return between[:, 0, 1] * (1e-3 * radius) ** 3 / AIR.viscosity, body.unknowns


def openings(quick: bool) -> Subject:
    """Entrance losses into wide ducts."""
    studies, checks, table = [], [], []
    for ratio in (5,) if quick else (5, 50):
        given = [row for row in rows("entrance") if abs(row["duct_radius"] / row["radius"] - ratio) < 1e-6]
        radius, wide, length = (1e3 * given[0][name] for name in ("radius", "duct_radius", "duct_length"))
        frequency = np.array([row["frequency"] for row in given], dtype=np.float64)
        expected = np.array([complex(*row["excess"]) for row in given])
        levels, impedance = [], expected
        for edge, tube in ((0.4, 0.8), (0.2, 0.6)) if quick else ((0.4, 0.8), (0.2, 0.6), (0.1, 0.5), (0.05, 0.5)):
            sizes = MeshSizes(mouth_edge=edge, tube=tube, growth=0.4, largest=0.5 * wide)
            impedance, unknowns = _opening(radius, wide, length, frequency, sizes)
            error = float(np.abs(impedance / expected - 1).max())
            levels.append(Level(f"mouth edge {edge:g} a", edge, unknowns, error))
        unit = "size at the edge / a"
        studies.append(
            Study(f"opening {ratio}", f"opening into {ratio} a", "reference rows", unit, tuple(levels), None)
        )
        name = f"opening into a duct of {ratio} a"
        checks.append(Check(name, name, "reference rows", levels[-1].error, 2e-2 if quick else 1e-2))
        table += [
            (f"{ratio} a", f"{f:g} Hz", *(f"{z.real:.4f} + {z.imag:.3g}j" for z in pair))
            for f, *pair in zip(frequency, impedance, expected, strict=True)
        ]
    return Subject(
        "openings", "Openings", OPENING_TEXT, tuple(studies), tuple(checks),
        (Table("Z a³/μ on the finest mesh", ("duct", "frequency", "3-D", "reference row"), tuple(table), detail=True),),
    )  # fmt: skip


def arrays(_: bool) -> Subject:
    """A 1 x 3 array in one mesh against its cells; the full page only."""
    frequency = np.array([1.0, 10.0, 100.0])
    whole = in_one_mesh(3, frequency).nodal_admittance(frequency)
    ratio = transfer_functions(whole, frequency) / transfer_functions(in_pieces(3, frequency)[0], frequency)
    level = float(np.abs(20 * np.log10(np.abs(ratio))).max())
    phase = float(np.abs(np.degrees(np.angle(ratio))).max())
    return Subject(
        "arrays", "A whole array in one mesh", ARRAY_TEXT, (),
        (
            Check("array level", "level of the transfer functions", "cells and plane waves", level, 0.05, "dB"),
            Check("array phase", "their phase", "cells and plane waves", phase, 0.3, "°"),
        ),
    )  # fmt: skip
