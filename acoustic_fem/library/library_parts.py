"""A library from the texts and arrays that a file of another format holds."""

from __future__ import annotations

from typing import Any

import xarray as xr

from acoustic_fem.library.netcdf_file import ATTRIBUTES, CHECKSUMS, coordinates_of, real_variables
from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import read_completed
from geometry.ground.argument_checks import check_shape, wrong_type
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array

TEXTS = (*ATTRIBUTES, CHECKSUMS)
"""Texts that a file holds."""


def units_of(dataset: xr.Dataset) -> dict[str, str]:
    """Unit of each variable of a library, and of its frequencies."""
    return {"frequency": "Hz", **{str(name): values.attrs["units"] for name, values in dataset.data_vars.items()}}


def data_set(attributes: dict[str, Any], frequency: Array, variables: dict[str, Array]) -> xr.Dataset:
    """The texts and real variables of a library, as :func:`acoustic_fem.library.netcdf_file.library_of` takes them.

    Args:
        attributes: texts of the file, by name.
        frequency: (n_freq,) Hz.
        variables: by name, shaped as :func:`acoustic_fem.library.netcdf_file.real_variables` lists them.

    Raises:
        Refusal: an attribute is missing or the design is not valid.
    """
    design = stated_design(attributes)
    if frequency.ndim != 1 or frequency.dtype.kind not in "fiu":
        raise wrong_type("frequency", f"is {frequency.dtype} of shape {frequency.shape}; it must be numbers in one row")
    known = coordinates_of(design)
    coordinates: dict[str, tuple[str, Any]] = {name: ("point", known[name]) for name in ("point", "line", "place")}
    coordinates |= {name: (name, known["microphone"]) for name in ("microphone", "microphone_2")}
    coordinates["frequency"] = ("frequency", frequency)
    sizes = {name: len(values) for name, (_, values) in coordinates.items()}
    dimensions = real_variables()
    for name, values in variables.items():
        shape = tuple(sizes[dimension] for dimension in dimensions[name])
        check_shape(name, values, shape, "that of its design and frequencies")
    return xr.Dataset({name: (dimensions[name], values) for name, values in variables.items()}, coordinates, attributes)


def stated_design(attributes: dict[str, Any]) -> ArrayDesign:
    """The design in the texts of a file.

    Raises:
        Refusal: a text of a library is missing, or the design is not valid.
    """
    missing = [name for name in ATTRIBUTES if not isinstance(attributes.get(name), str)]
    if missing:
        raise Refusal("is missing: this program did not write it", kind=Kind.MISSING, field=missing[0])
    return read_completed(attributes["design_toml"], "design_toml")
