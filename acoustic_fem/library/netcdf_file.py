"""Libraries as netCDF-4 files that plain netCDF tools open: real and imaginary variables, CF attributes."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable
from dataclasses import asdict, fields
from io import BytesIO
from pathlib import Path
from typing import Any

import h5py
import numpy as np
import xarray as xr

from acoustic_fem.library.physics import check_physics
from acoustic_fem.library.sealed_netcdf import read_netcdf
from acoustic_fem.library.transfer_functions import (
    DEVIATION,
    MEASURED,
    OPTIONAL,
    VARIABLES,
    Library,
    library_from_arrays,
)
from acoustic_fem.quantities.checks import frequency_grid
from acoustic_fem.quantities.fidelity import FIDELITIES
from acoustic_fem.quantities.medium import Medium
from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import read_completed, write_design
from geometry.ground.argument_checks import check_choice, mismatch, wrong_type
from geometry.ground.record import seal_file, sha256
from geometry.ground.refusal import Kind, Refusal, counted
from geometry.ground.typed import Array, ComplexArray
from geometry.ground.whole_files import whole_file
from geometry.layout.placement import point_places

#: Global attributes of every library file.
_TITLE = "acoustic-fem library"
_LAYOUT_VERSION = 1
#: Text attributes that every library carries, and its coordinates.
ATTRIBUTES = ("fidelity", "design_toml", "medium", "provenance")
CHECKSUMS = "checksums"
"""Attribute of a data set: SHA-256 of each of its attributes and variables by name, as JSON."""
#: Bytes of an attribute that HDF5 stores in the header of its object, which takes 64 kB.
_LONGEST_TEXT = 60_000
TIME_CONVENTION = "exp(+j omega t)"
"""Sign of the time dependence of every complex number in a file."""
_DEVIATION = "transfer_function_deviation"
_COORDINATES = ("point", "line", "place", "microphone", "frequency")


class LibraryError(Refusal):
    """A library file that cannot be read or written: one line that names the file and the reason."""


def write_netcdf(library: Library, path: Path) -> None:
    """Write a library over whatever is there; the file is whole or not there (written beside, then renamed).

    Complex variables become NAME_real and NAME_imag; the design (TOML), the air and the provenance (JSON)
    are global attributes. The response per newton is written for other tools; :func:`load_netcdf` leaves it to
    :attr:`acoustic_fem.library.transfer_functions.Library.force_response`, since it follows from the rest.

    Raises:
        LibraryError: the file cannot be written.
    """
    dataset = dataset_of(library, (*VARIABLES, "force_response"))
    # CF allows no fill value on a coordinate; Octave reads text as arrays of characters only
    encoding: dict[Any, dict[str, Any]] = {name: {"fletcher32": True} for name in dataset.data_vars}
    encoding |= {name: {"_FillValue": None} for name, values in dataset.coords.items() if values.dtype.kind == "f"}
    encoding |= {name: {"dtype": "S1"} for name, values in dataset.coords.items() if values.dtype.kind in "OU"}
    try:
        with whole_file(path) as beside:
            # in memory: HDF5 ends the process where the disk is full
            content = BytesIO(dataset.to_netcdf(engine="h5netcdf", format="NETCDF4", encoding=encoding))
            _fix_length_of_texts(content)
            beside.write_bytes(content.getbuffer())
            seal_file(beside)
    except OSError as error:
        raise LibraryError(f"cannot be written: {error.strerror or error}", kind=Kind.UNREADABLE, file=path) from None


def _fix_length_of_texts(content: BytesIO) -> None:
    """Make the text attributes of a file arrays of characters, since Octave reads none of variable length.

    A text above :data:`_LONGEST_TEXT` stays as it is: HDF5 keeps a longer attribute only if its length varies.
    """
    with h5py.File(content, "r+") as file:
        for owner in (file, *file.values()):
            for name, text in list(owner.attrs.items()):
                if isinstance(text, str) and 0 < len(encoded := text.encode()) <= _LONGEST_TEXT:
                    owner.attrs.create(name, np.array(encoded, h5py.string_dtype("utf-8", len(encoded))))


def dataset_of(library: Library, names: Iterable[str] = tuple(VARIABLES)) -> xr.Dataset:
    """A library as real variables and text attributes, as files hold it; :func:`library_of` is the way back."""
    variables = {}
    for name in names:
        array = getattr(library, name)
        if array is None and name in OPTIONAL:
            continue
        for part, values in (("real", array.real), ("imag", array.imag)):
            attributes = {"units": array.attrs["units"], "long_name": f"{array.attrs['long_name']}, {part} part"}
            variables[f"{name}_{part}"] = values.assign_attrs(attributes)
    if library.transfer_function_deviation is not None:
        variables[_DEVIATION] = library.transfer_function_deviation
    dataset = xr.Dataset(
        variables,
        attrs={
            "Conventions": "CF-1.11",
            "title": _TITLE,
            "history": _history(library),
            "layout_version": _LAYOUT_VERSION,
            "fidelity": library.fidelity,
            "time_convention": TIME_CONVENTION,
            "design_toml": write_design(library.design.completed()),
            "medium": json.dumps(asdict(library.medium)),
            "provenance": json.dumps(dict(library.provenance)),
        },
    )
    return with_checksums(dataset)


def _history(library: Library) -> str:
    """Line of CF's history: when, and by which program."""
    made = library.provenance
    return f"{made.get('created', 'at an unknown time')}: {library.fidelity}, acoustic-fem {made.get('code_version')}"


def with_checksums(dataset: xr.Dataset) -> xr.Dataset:
    """A library as files hold it, with a hash of each of the members that it has."""
    return dataset.assign_attrs({CHECKSUMS: json.dumps(_checksums(dataset))})


def _checksums(dataset: xr.Dataset) -> dict[str, str]:
    found = {name: sha256(dataset.attrs[name]) for name in ATTRIBUTES}
    for name, dimensions in {"frequency": ("frequency",), **real_variables()}.items():
        if name in dataset.variables:
            values = np.ascontiguousarray(dataset[name].transpose(*dimensions).values, "<f8")
            found[name] = sha256(str(values.shape), values.tobytes())
    return found


def _check_checksums(dataset: xr.Dataset) -> None:
    """Refuse a data set of which a member is not the one that was written."""
    stored, found = _json_object(dataset.attrs[CHECKSUMS], CHECKSUMS), _checksums(dataset)
    for name in dict.fromkeys((*stored, *found)):
        if stored.get(name) != found.get(name):
            how = "is not what was written (its SHA-256 differs)" if name in found else "was written but is missing"
            raise Refusal(
                how, kind=Kind.DAMAGED, field=name, remedy="the file is damaged, or another program changed it"
            )


def real_variables() -> dict[str, tuple[str, ...]]:
    """Names of the real variables that a file may hold, and their dimensions."""
    parts = {f"{name}_{part}": row[0] for name, row in VARIABLES.items() for part in ("real", "imag")}
    return {**parts, _DEVIATION: DEVIATION[0]}


def load_netcdf(path: str | os.PathLike[str]) -> Library:
    """Read a library that :func:`save` wrote; every number is the one that was saved.

    The arrays are compared with the design in the file and with what was written: another number of points, other
    microphones, values that are not finite or that no sensor has, and damage of any kind are refused.

    Raises:
        LibraryError: no such file, cut short, damaged, not a library, or altered; names the attribute or variable.
    """
    path = Path(path)
    dataset = read_netcdf(path, "a library in netCDF", LibraryError, _dataset)
    if dataset.attrs.get("title") != _TITLE:
        raise LibraryError(
            f"is a netCDF file but no library (title is not {_TITLE!r})", kind=Kind.UNREADABLE, file=path
        )
    found = dataset.attrs.get("layout_version")
    found = found.item() if isinstance(found, np.generic) else found
    if found != _LAYOUT_VERSION:
        raise LibraryError(
            kind=Kind.MISMATCH, file=path, field="layout_version", value=found, allowed=str(_LAYOUT_VERSION),
            remedy="another version of this program wrote it",
        )  # fmt: skip
    return library_in(path, dataset)


def _dataset(file: Any) -> xr.Dataset:
    store = xr.backends.H5NetCDFStore(file)
    return xr.open_dataset(store, decode_times=False, mask_and_scale=False).load()


def library_in(path: Path, dataset: xr.Dataset) -> Library:
    """The library that a file holds.

    Raises:
        LibraryError: as :func:`library_of`; names the file.
    """
    try:
        return library_of(dataset)
    except Refusal as error:
        raise refused_in(path, error) from None


def refused_in(path: Path, error: Refusal) -> LibraryError:
    """The refusal of a part of a file, such as its design, as one of the file."""
    return LibraryError.of(error, file=path, field=error.field or error.file or "")


def library_of(dataset: xr.Dataset) -> Library:
    """The library in a data set.

    Raises:
        Refusal: an attribute or variable is not that of a library, not what was written, or no sensor's; says which.
    """
    absent = {name for name in OPTIONAL if f"{name}_real" not in dataset and f"{name}_imag" not in dataset}
    present = [name for name in VARIABLES if name not in absent]
    missing = [f"{name}_{part}" for name in present for part in ("real", "imag")]
    missing = [name for name in (*missing, *_COORDINATES) if name not in dataset.variables]
    missing += [name for name in ATTRIBUTES if name not in dataset.attrs]
    if missing:
        raise Refusal("is missing: the library is not complete", kind=Kind.MISSING, field=missing[0])
    if CHECKSUMS not in dataset.attrs:
        raise Refusal(
            "are missing: an older version wrote this library, or another program removed them",
            kind=Kind.MISSING, field=CHECKSUMS, remedy="make the library again",
        )  # fmt: skip
    for name in (*ATTRIBUTES, CHECKSUMS):
        if not isinstance(dataset.attrs[name], str):
            raise Refusal("must be a text", kind=Kind.WRONG_TYPE, field=name)
    fidelity = dataset.attrs["fidelity"]
    known = (*FIDELITIES, MEASURED)
    check_choice("fidelity", fidelity, known)
    design = read_completed(dataset.attrs["design_toml"], "design_toml")
    for name, expected in coordinates_of(design).items():
        _check_coordinate(dataset[name], expected)
    library = library_from_arrays(
        design,
        _frequency(dataset["frequency"]),
        {name: _complex(dataset, name) for name in present},
        fidelity,
        _medium(dataset.attrs["medium"]),
        _json_object(dataset.attrs["provenance"], "provenance"),
        _deviation(dataset) if _DEVIATION in dataset else None,
    )
    _check_checksums(dataset)
    check_physics(library)
    return library


def coordinates_of(design: ArrayDesign) -> dict[str, list[int] | list[str]]:
    """Numbers and names of the points and microphones of a design, as files hold them."""
    lines, places = zip(*point_places(design), strict=True)
    return {
        "point": list(range(1, len(lines) + 1)),
        "line": list(lines),
        "place": list(places),
        "microphone": list(design.microphones),
    }


def _check_coordinate(found: xr.DataArray, expected: list[int] | list[str]) -> None:
    """A coordinate must be what the design in the same file says."""
    values = found.values.ravel().tolist()
    if len(values) != len(expected):
        raise mismatch(str(found.name), f"has {counted(len(values), 'value')}, its design has {len(expected)}")
    for index, (value, wanted) in enumerate(zip(values, expected, strict=True)):
        if value != wanted:
            allowed = f"{wanted!r} as in its design"
            raise Refusal(kind=Kind.MISMATCH, field=f"{found.name}[{index}]", value=value, allowed=allowed)


def _frequency(found: xr.DataArray) -> Array:
    if found.dtype.kind not in "fiu":
        raise Refusal(f"holds {found.dtype}, not numbers", kind=Kind.WRONG_TYPE, field="frequency")
    return frequency_grid(found.values)


def _complex(dataset: xr.Dataset, name: str) -> ComplexArray:
    dimensions = VARIABLES[name][0]
    parts = [_real(dataset, f"{name}_{part}", dimensions) for part in ("real", "imag")]
    values = np.empty(parts[0].shape, dtype=np.complex128)
    values.real, values.imag = parts
    return values


def _deviation(dataset: xr.Dataset) -> Array:
    values = _real(dataset, _DEVIATION, DEVIATION[0])
    if (values < 0).any():
        raise Refusal(kind=Kind.OUT_OF_RANGE, field=_DEVIATION, value=float(values.min()), allowed="at least 0")
    return values


def _real(dataset: xr.Dataset, variable: str, dimensions: tuple[str, ...]) -> Array:
    array = dataset[variable]
    if sorted(map(str, array.dims)) != sorted(dimensions):
        found = ", ".join(map(str, array.dims))
        raise wrong_type(variable, f"has the dimensions ({found}), must be ({', '.join(dimensions)})")
    if array.dtype.kind != "f":
        raise Refusal(f"holds {array.dtype}, not floating-point numbers", kind=Kind.WRONG_TYPE, field=variable)
    array = array.transpose(*dimensions)
    bad = np.argwhere(~np.isfinite(array.values))
    if len(bad):
        where = ", ".join(f"{key} {dataset[key].values[k]}" for key, k in zip(dimensions, bad[0], strict=True))
        value = float(array.values[tuple(bad[0])])
        raise Refusal(f"at {where} must be finite", kind=Kind.UNSUITABLE, field=variable, value=value)
    return np.asarray(array.values, np.float64)


def _medium(text: str) -> Medium:
    values = _json_object(text, "medium")
    known = [field.name for field in fields(Medium)]
    for name in known:
        if name not in values:
            raise Refusal(kind=Kind.MISSING, field=f"medium.{name}")
    for name, value in values.items():
        check_choice("medium", name, known, kind=Kind.UNKNOWN)
        if not isinstance(value, (int, float)) or isinstance(value, bool):
            raise Refusal(kind=Kind.WRONG_TYPE, field=f"medium.{name}", value=value, allowed="a number")
    try:
        return Medium(**values)
    except Refusal as error:
        raise Refusal.of(error, field=f"medium.{error.field}") from None
    except (ValueError, OverflowError) as error:
        raise Refusal(str(error), kind=Kind.OUT_OF_RANGE, field="medium") from None


def _json_object(text: str, attribute: str) -> dict[str, Any]:
    try:
        values = json.loads(text)
    except (ValueError, RecursionError) as error:
        raise Refusal(f"is not JSON: {error}", kind=Kind.UNREADABLE, field=attribute) from None
    if not isinstance(values, dict):
        raise Refusal("must be a JSON object", kind=Kind.WRONG_TYPE, field=attribute)
    return values
