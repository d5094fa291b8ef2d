"""Transfer functions of a whole array: ``solve`` and its labelled result."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
import xarray as xr
from numpy.typing import ArrayLike, NDArray

from acoustic_fem.checks import frequency_grid
from acoustic_fem.medium import Medium
from acoustic_fem.provenance import versions
from geometry.cells import Cell, cell_catalogue
from geometry.design import ArrayDesign
from geometry.layout import ArrayLayout, place
from geometry.refusal import Refusal

#: What the air of a cell may be computed with; the last is the one to trust.
FIDELITIES = ("lumped", "helmholtz", "navier-stokes")
#: What stands in place of a fidelity in a library made from recordings (:mod:`acoustic_fem.calibration`).
MEASURED = "measured"

#: Name -> dimensions, units and description of the results.
VARIABLES = {
    "transfer_function": (
        ("point", "microphone", "frequency"),
        "Pa/Pa",
        "pressure at the microphone per pressure in the touched cavity",
    ),
    "source_response": (
        ("point", "microphone", "frequency"),
        "Pa s/m^3",
        "pressure at the microphone per volume velocity injected at the membrane of the point",
    ),
    "point_impedance": (
        ("point", "frequency"),
        "Pa s/m^3",
        "pressure in the cavity per volume velocity injected at its membrane",
    ),
    "microphone_impedance": (
        ("microphone", "microphone_2", "frequency"),
        "Pa s/m^3",
        "pressure at the microphone per volume velocity injected at the front of the second microphone",
    ),
}

#: Attributes of the response per newton, which follows from the source response and the design.
FORCE_RESPONSE = {
    "units": "Pa/N",
    "long_name": "pressure at the microphone per force on the middle quarter of the membrane's radius",
}

#: Real, unlike the others: what is known of the errors of measured transfer functions.
DEVIATION = (
    ("point", "microphone", "frequency"),
    "Pa/Pa",
    "standard deviation of the real part, and of the imaginary part, of the transfer function",
)

#: Those of them that older files and measured libraries may lack.
OPTIONAL = frozenset({"microphone_impedance"})


@dataclass(frozen=True, eq=False)
class Library:
    """Responses of one array at a grid of frequencies, with everything needed to make them again.

    The volume velocity is injected in parallel with the membrane's own compliance, which stays part of
    the array: a touch that would sweep the volume q of a membrane in vacuo injects j w q.

    Attributes:
        transfer_function: (point, microphone, frequency) complex128, microphone pressure / pressure in the
            touched cavity, Pa/Pa. Microphone pressure: on the diaphragm, behind the sound hole.
        source_response: (point, microphone, frequency) complex128, microphone pressure per injected
            volume velocity, Pa s/m^3.
        point_impedance: (point, frequency) complex128, cavity pressure per injected volume velocity, Pa s/m^3.
        microphone_impedance: (microphone, microphone_2, frequency) complex128, pressure at a microphone per
            volume velocity injected at the front of another, Pa s/m^3, the microphones' own load included:
            what thermal noise needs. None in files of older versions and in measured libraries.
        transfer_function_deviation: (point, microphone, frequency) float64, one standard deviation of the real part
            and of the imaginary part of the transfer function, Pa/Pa. None where it was computed.
        design: the array.
        fidelity: how the cells were computed, one of :data:`FIDELITIES`, or :data:`MEASURED`.
        medium: the air.
        provenance: code and library versions, creation time, seed, hash of the frequency grid, and how each
            distinct cell was solved.
    """

    transfer_function: xr.DataArray
    source_response: xr.DataArray
    point_impedance: xr.DataArray
    design: ArrayDesign
    fidelity: str
    medium: Medium
    provenance: Mapping[str, Any]
    microphone_impedance: xr.DataArray | None = None
    transfer_function_deviation: xr.DataArray | None = None

    @property
    def frequency(self) -> NDArray[np.float64]:
        """The grid of frequencies, Hz."""
        return np.asarray(self.transfer_function["frequency"].values)

    @property
    def force_response(self) -> xr.DataArray:
        """(point, microphone, frequency) complex128, microphone pressure per force on the membrane, Pa/N.

        The force is spread over a patch of a quarter of the opening's radius in the middle of the membrane and
        pushes inwards; it injects j w V(w) per newton, V from the elastic solution of the design's membrane.
        Other patches, and responses per displacement and per outside pressure:
        :func:`acoustic_fem.noise.touch_response`.
        """
        from acoustic_fem.noise import touch_response

        return touch_response(self, "force").rename("force_response").assign_attrs(FORCE_RESPONSE)


def solve(
    design: ArrayDesign,
    frequency: ArrayLike,
    fidelity: str = "navier-stokes",
    medium: Medium | None = None,
    progress: Callable[[str, float], None] | None = None,
) -> Library:
    """Transfer functions of an array from every point to every microphone.

    Args:
        design: the array.
        frequency: (n_freq,) ascending, 1e-3 to 2e3 Hz.
        fidelity: "lumped" (closed forms), "helmholtz" (scalar 3-D cells, a cross-check that is wrong at openings)
            or "navier-stokes" (3-D cells, the one to trust).
        medium: the air; by default that of the design.
        progress: called with what is being done and the fraction done, 0 to 1.

    Raises:
        Refusal: a bad frequency grid or an unknown fidelity.
    """
    grid = frequency_grid(frequency)
    if fidelity not in FIDELITIES:
        raise Refusal(f"fidelity = {fidelity!r} must be one of: {', '.join(FIDELITIES)}")
    report = progress or (lambda message, fraction: None)
    if medium is None:
        medium = Medium.at(design.air.temperature, design.air.humidity, design.air.pressure)
    layout = place(design)
    cells = cell_catalogue(design, layout).distinct
    admittances, solved = _cell_admittances(cells, grid, fidelity, medium, report)

    from acoustic_fem.network import solve_network

    report("network", 0.95)
    response = solve_network(design, layout, admittances, grid, medium)
    library = labelled(
        design,
        layout,
        grid,
        {
            "transfer_function": response.source_response / response.point_impedance[:, None, :],
            "source_response": response.source_response,
            "point_impedance": response.point_impedance,
            "microphone_impedance": response.microphone_impedance,
        },
        fidelity,
        medium,
        {
            **versions(None, ("gmsh", "numpy", "scikit-fem", "scipy", "xarray")),
            "frequency_sha256": hashlib.sha256(grid.tobytes()).hexdigest(),
            "cells": solved,
        },
    )
    report("done", 1.0)
    return library


def _cell_admittances(
    cells: tuple[Cell, ...],
    frequency: NDArray[np.float64],
    fidelity: str,
    medium: Medium,
    report: Callable[[str, float], None],
) -> tuple[dict[Cell, NDArray[np.complex128]], list[dict[str, Any]]]:
    """Nodal admittances of the cells, and how each was obtained."""
    if fidelity == "lumped":
        from acoustic_fem.lumped_cell import lumped_admittance

        return (
            {cell: lumped_admittance(cell, frequency, medium) for cell in cells},
            [{"cell": cell.label, "method": "closed form"} for cell in cells],
        )
    from acoustic_fem.design_cells import solve_cells

    solutions = solve_cells(
        cells, frequency, medium, fidelity, progress=lambda label, fraction: report(label, 0.95 * fraction)
    )
    admittances = {cell: solution.admittance for cell, solution in solutions.items()}
    solved = [{"cell": cell.label, **solution.summary()} for cell, solution in solutions.items()]
    return admittances, solved


def labelled(
    design: ArrayDesign,
    layout: ArrayLayout,
    frequency: NDArray[np.float64],
    values: Mapping[str, NDArray[np.complex128]],
    fidelity: str,
    medium: Medium,
    provenance: Mapping[str, Any],
    deviation: NDArray[np.float64] | None = None,
) -> Library:
    """A library from bare arrays, one per name of :data:`VARIABLES` and shaped as listed there.

    Those of :data:`OPTIONAL` may be missing; ``deviation`` is that of the transfer function, where it was measured.
    """
    coordinates = {
        "point": ("point", [point.number for point in layout.points], {"long_name": "sensing point, from 1"}),
        "line": ("point", [point.line for point in layout.points], {"long_name": "index of its line, from 0"}),
        "place": ("point", [point.place for point in layout.points], {"long_name": "index along its line, from 0"}),
        "microphone": ("microphone", list(design.microphones), {"long_name": "microphone"}),
        "microphone_2": ("microphone_2", list(design.microphones), {"long_name": "second microphone"}),
        "frequency": ("frequency", frequency, {"units": "Hz", "long_name": "frequency"}),
    }
    rows: dict[str, NDArray[Any]] = {name: values[name] for name in VARIABLES if name in values or name not in OPTIONAL}
    if deviation is not None:
        rows["transfer_function_deviation"] = deviation
    described = {**VARIABLES, "transfer_function_deviation": DEVIATION}
    arrays = {}
    for name, row in rows.items():
        dimensions, units, description = described[name]
        arrays[name] = xr.DataArray(
            row,
            dims=dimensions,
            coords={key: value for key, value in coordinates.items() if value[0] in dimensions},
            name=name,
            attrs={"units": units, "long_name": description},
        )
    return Library(**arrays, design=design, fidelity=fidelity, medium=medium, provenance=dict(provenance))
