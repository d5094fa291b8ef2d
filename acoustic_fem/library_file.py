"""Libraries as netCDF-4 files that plain netCDF tools open: real and imaginary variables, CF attributes."""

from __future__ import annotations

import contextlib
import json
import os
import tempfile
from dataclasses import asdict
from pathlib import Path

import numpy as np
import xarray as xr

from acoustic_fem.library import OPTIONAL, VARIABLES, Library
from acoustic_fem.medium import Medium

#: Global attributes of every library file.
_TITLE = "acoustic-fem library"
_LAYOUT_VERSION = 1


class LibraryError(ValueError):
    """A library file that cannot be read or written: one line that names the file and the reason."""


def save(library: Library, path: str | os.PathLike[str]) -> None:
    """Write a library; the file is whole or not there (written beside, then renamed).

    Complex variables become NAME_real and NAME_imag; the design (TOML), the air and the provenance (JSON)
    are global attributes.

    Raises:
        LibraryError: the file cannot be written.
    """
    from geometry.design_file import write_design

    path = Path(path)
    variables = {}
    for name in VARIABLES:
        array = getattr(library, name)
        if array is None and name in OPTIONAL:
            continue
        for part, values in (("real", array.real), ("imag", array.imag)):
            attributes = {"units": array.attrs["units"], "long_name": f"{array.attrs['long_name']}, {part} part"}
            variables[f"{name}_{part}"] = values.assign_attrs(attributes)
    dataset = xr.Dataset(
        variables,
        attrs={
            "Conventions": "CF-1.11",
            "title": _TITLE,
            "layout_version": _LAYOUT_VERSION,
            "fidelity": library.fidelity,
            "time_convention": "exp(+j omega t)",
            "design_toml": write_design(library.design),
            "medium": json.dumps(asdict(library.medium)),
            "provenance": json.dumps(dict(library.provenance)),
        },
    )
    try:
        descriptor, beside = tempfile.mkstemp(prefix=f".{path.name}.", suffix=".nc", dir=path.parent)
        os.close(descriptor)
        try:
            dataset.to_netcdf(beside, engine="netcdf4", format="NETCDF4")
            os.chmod(beside, 0o644)
            os.replace(beside, path)
        except BaseException:
            with contextlib.suppress(OSError):
                os.unlink(beside)
            raise
    except OSError as error:
        raise LibraryError(f"{path}: cannot be written: {error.strerror or error}") from None


def load(path: str | os.PathLike[str]) -> Library:
    """Read a library that :func:`save` wrote; every number is the one that was saved.

    Raises:
        LibraryError: no such file, cut short, or not a library.
    """
    from geometry.design_file import read_design

    path = Path(path)
    if not path.is_file():
        raise LibraryError(f"{path}: {'is a folder, not a library' if path.is_dir() else 'no such file'}")
    try:
        with xr.open_dataset(path, engine="netcdf4", decode_times=False) as opened:
            dataset = opened.load()
    except (OSError, RuntimeError, ValueError) as error:
        raise LibraryError(f"{path}: is no netCDF file or is cut short ({error})") from None
    if dataset.attrs.get("title") != _TITLE:
        raise LibraryError(f"{path}: is a netCDF file but no library (title is not {_TITLE!r})")
    if dataset.attrs.get("layout_version") != _LAYOUT_VERSION:
        found = dataset.attrs.get("layout_version")
        raise LibraryError(f"{path}: layout_version = {found} must be {_LAYOUT_VERSION}")
    absent = {name for name in OPTIONAL if f"{name}_real" not in dataset and f"{name}_imag" not in dataset}
    present = [name for name in VARIABLES if name not in absent]
    missing = [f"{name}_{part}" for name in present for part in ("real", "imag") if f"{name}_{part}" not in dataset]
    missing += [name for name in ("fidelity", "design_toml", "medium", "provenance") if name not in dataset.attrs]
    if missing:
        raise LibraryError(f"{path}: is no complete library, {missing[0]} is missing")
    return Library(
        **{name: _complex(dataset, name) for name in present},
        design=read_design(dataset.attrs["design_toml"], f"{path}, attribute design_toml"),
        fidelity=dataset.attrs["fidelity"],
        medium=Medium(**json.loads(dataset.attrs["medium"])),
        provenance=json.loads(dataset.attrs["provenance"]),
    )


def _complex(dataset: xr.Dataset, name: str) -> xr.DataArray:
    dimensions, units, description = VARIABLES[name]
    real = dataset[f"{name}_real"].transpose(*dimensions)
    values = np.empty(real.shape, dtype=np.complex128)
    values.real = real.values
    values.imag = dataset[f"{name}_imag"].transpose(*dimensions).values
    return real.copy(data=values).rename(name).assign_attrs({"units": units, "long_name": description})
