"""Libraries as files of arrays: NPZ for NumPy, MAT for MATLAB and Octave.

Both also name the points, the microphones and the units, and state the time convention. NPZ holds real and imaginary
parts apart, under the names of the netCDF file; MAT holds complex arrays and its units as a structure.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import scipy.io
import xarray as xr
from numpy.typing import NDArray

from acoustic_fem.library.library_parts import TEXTS, data_set, units_of
from acoustic_fem.library.netcdf_file import TIME_CONVENTION, LibraryError, coordinates_of, dataset_of, real_variables
from acoustic_fem.library.other_files import refuse_other_arrays
from acoustic_fem.library.transfer_functions import VARIABLES, Library
from geometry.ground.array_files import read_mat as mat_arrays, read_npz as npz_arrays
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array
from geometry.ground.whole_files import whole_file


def write_npz(library: Library, path: Path) -> None:
    """Write a library over whatever is there; whole or not there.

    Raises:
        OSError: it cannot be written.
    """
    dataset = dataset_of(library)
    arrays: dict[str, Any] = {name: np.array(dataset.attrs[name]) for name in TEXTS}
    arrays |= {name: np.array(values) for name, values in coordinates_of(library.design).items()}
    arrays |= {"frequency": library.frequency, "time_convention": np.array(TIME_CONVENTION)}
    # a row for each, since an archive of arrays has no attributes
    arrays["units"] = np.array([f"{name}: {unit}" for name, unit in units_of(dataset).items()])
    arrays |= _real_arrays(dataset)
    with whole_file(path) as beside:
        np.savez(beside, **arrays)


def _real_arrays(dataset: xr.Dataset) -> dict[str, Array]:
    return {
        name: dataset[name].transpose(*dimensions).values
        for name, dimensions in real_variables().items()
        if name in dataset
    }


def read_npz(path: Path) -> xr.Dataset:
    """The content of a file that :func:`write_npz` wrote.

    Raises:
        LibraryError: no NPZ file, or damaged.
        Refusal: a part that is missing or not of a library.
    """
    return _content(path, npz_arrays(path, "an NPZ file", LibraryError))


def _content(path: Path, arrays: dict[str, NDArray[Any]]) -> xr.Dataset:
    refuse_other_arrays(path, arrays)
    if "frequency" not in arrays:
        raise Refusal("is missing: this program did not write it", kind=Kind.MISSING, field="frequency")
    attributes = {name: str(arrays[name]) for name in TEXTS if name in arrays}
    variables = {name: arrays[name] for name in real_variables() if name in arrays}
    return data_set(attributes, arrays["frequency"], variables)


def write_mat(library: Library, path: Path) -> None:
    """Write a library as MATLAB's version 5 over whatever is there; whole or not there.

    Raises:
        OSError: it cannot be written.
    """
    dataset = dataset_of(library)
    content: dict[str, Any] = {name: dataset.attrs[name] for name in TEXTS}
    for name, values in coordinates_of(library.design).items():
        # names as a cell array, numbers as a row
        content[name] = np.array(values, dtype=object if name == "microphone" else float)
    content |= {"frequency": library.frequency, "time_convention": TIME_CONVENTION}
    units = units_of(dataset)
    for name in VARIABLES:
        if f"{name}_real" in dataset:
            units[name] = units.pop(f"{name}_real")
            del units[f"{name}_imag"]
    arrays = _real_arrays(dataset)
    for name in VARIABLES:
        if f"{name}_real" in arrays:
            complex_array = np.empty(arrays[f"{name}_real"].shape, np.complex128)
            complex_array.real, complex_array.imag = arrays.pop(f"{name}_real"), arrays.pop(f"{name}_imag")
            content[name] = complex_array
    with whole_file(path) as beside:
        scipy.io.savemat(beside, {**content, **arrays, "units": units}, appendmat=False, long_field_names=True)


def read_mat(path: Path) -> xr.Dataset:
    """The content of a file that :func:`write_mat` wrote.

    Raises:
        LibraryError: no MAT file, or damaged.
        Refusal: a part that is missing or not of a library.
    """
    arrays = mat_arrays(path, "a MAT file", LibraryError)
    arrays |= {name: np.array(arrays[name].ravel()[0]) for name in TEXTS if arrays.get(name, np.empty(0)).size == 1}
    if "frequency" in arrays:
        arrays["frequency"] = arrays["frequency"].ravel()
    for name, (dimensions, *_) in VARIABLES.items():
        if name in arrays:
            values = arrays.pop(name)
            # MATLAB drops dimensions of one at the end, and the imaginary part where it is 0
            values = values.reshape(values.shape + (1,) * (len(dimensions) - values.ndim))
            arrays |= {f"{name}_real": np.array(values.real), f"{name}_imag": np.array(values.imag)}
    return _content(path, arrays)
