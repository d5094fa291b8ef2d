"""Origin of a data set: nominal design, tolerances, fidelity, frequencies, air, and texts behind numbers."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict
from typing import Any

import numpy as np

from acoustic_fem.quantities.local_air import design_air
from acoustic_fem.quantities.medium import Medium
from acoustic_fem.scatter.tolerances import QUANTITIES
from geometry.design.design_file import write_design
from geometry.ground.refusal import counted
from localize.datasets.array_source import ArraySource
from studies.datasets.as_built_arrays import AsBuiltArrays
from studies.sweep.results import Sweep

#: Unit of each number of a gas.
_UNITS = {
    "density": "kg/m³",
    "viscosity": "Pa s",
    "conductivity": "W/(m K)",
    "heat_capacity": "J/(kg K)",
    "gamma": "1",
    "pressure": "Pa",
}


def origin_of(arrays: ArraySource) -> dict[str, Any]:
    """Origin of the arrays of a data set as JSON can hold it; what a source does not know is left out.

    Args:
        arrays: source of the arrays.

    Returns:
        ``design`` (TOML of the nominal design, or of the base of a sweep), ``fidelity``, ``air`` (the gas, SI),
        ``frequency`` (Hz), ``tolerances`` (as-built sensors) and ``texts`` (those that each number of a parameter
        stands for, from 0).
    """
    first = arrays.arrays([int(arrays.case_numbers[0])])[0]
    found: dict[str, Any] = {"frequency": [float(value) for value in first.frequency]}
    if isinstance(arrays, Sweep):
        base = arrays.base.completed()
        found |= {
            "design": write_design(base),
            "fidelity": str(arrays.attributes["fidelity"]),
            "air": asdict(design_air(base)),
            "texts": {name: list(arrays.texts(name)) for name in arrays.parameters if arrays.texts(name)},
        }
        if arrays.solid:
            found["fidelity"] += f"; navier-stokes of {counted(len(arrays.solid), 'case')} outside the atlas"
        return found
    known = first.provenance
    found |= {name: known[key] for name, key in _OF_ARRAYS.items() if key in known}
    if isinstance(arrays, AsBuiltArrays):
        found["tolerances"] = [{"part": QUANTITIES[each.quantity], **asdict(each)} for each in arrays.tolerances]
    return found


_OF_ARRAYS = {"design": "design", "fidelity": "fidelity", "air": "medium"}


def origin_lines(origin: Mapping[str, Any], design_file: str) -> list[str]:
    """Lines of Markdown about the origin, for people.

    Args:
        origin: as :func:`origin_of` gives it.
        design_file: name of the file with the design, beside the shards.
    """
    grid = np.array(origin["frequency"])
    facts = {
        "nominal design": f"`{design_file}`, lengths in mm" if "design" in origin else "",
        "fidelity of the transfer functions": origin.get("fidelity", ""),
        "their frequencies": f"{counted(len(grid), 'value')} from {grid[0]:g} to {grid[-1]:g} Hz",
        **({"air": _air(Medium(**origin["air"]))} if "air" in origin else {}),
    }
    lines = [
        "## Sensors", "", "| fact | value |", "|---|---|",
        *(f"| {name} | {value} |" for name, value in facts.items() if value), "",
    ]  # fmt: skip
    if origin.get("tolerances"):
        lines += [
            "Each part of a sensor deviates from the nominal design by a normal draw that is cut off at three standard "
            "deviations. Glue overruns and ovality have the size of the draw alone.",
            "",
            "| quantity | drawn for each | standard deviation | source of the figure |",
            "|---|---|---|---|",
            *(f"| {each['quantity']} | {each['part']} | {_deviation(each)} | {each['source']} |"
              for each in origin["tolerances"]),
            "",
        ]  # fmt: skip
    if origin.get("texts"):
        lines += [
            "Some parameters are texts. `parameters` holds a number for each text:",
            "",
            "| parameter | number and text |",
            "|---|---|",
            *(
                f"| {name} | {', '.join(f'{number}: {text}' for number, text in enumerate(texts))} |"
                for name, texts in origin["texts"].items()
            ),
            "",
        ]
    return lines


def _air(medium: Medium) -> str:
    values = (f"{name.replace('_', ' ')} {value:.5g}" for name, value in asdict(medium).items())
    units = ("" if unit == "1" else f" {unit}" for unit in _UNITS.values())
    return ", ".join(value + unit for value, unit in zip(values, units, strict=True))


def _deviation(tolerance: Mapping[str, Any]) -> str:
    value = tolerance["deviation"]
    return f"{value:g} mm" if tolerance["kind"] == "absolute" else f"{100 * value:g} % of the nominal value"
