"""Libraries as SOFA files: AES69-2022, convention GeneralTF-E.

Emitters are the sensing points, receivers the microphones, both at their places in the laid-out array. The other
contents of a library are in variables and attributes of its own.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr
from numpy.typing import NDArray

from acoustic_fem.library.library_parts import TEXTS, data_set
from acoustic_fem.library.netcdf_file import TIME_CONVENTION, LibraryError, coordinates_of, dataset_of, real_variables
from acoustic_fem.library.sealed_netcdf import read_netcdf
from acoustic_fem.library.transfer_functions import Library
from acoustic_fem.quantities.units import metres
from geometry.design.array_design import ArrayDesign
from geometry.ground.argument_checks import wrong_type
from geometry.ground.extras import check_extras
from geometry.ground.record import seal_file
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array
from geometry.ground.whole_files import whole_file
from geometry.layout.arrangement import place_housings

#: Dimension of a library -> letter of SOFA's: emitters, receivers, frequencies.
_LETTERS = {"point": "E", "microphone": "R", "microphone_2": "R", "frequency": "N"}
#: Convention of transfer functions -> its type of data, and the dimensions of the data.
CONVENTIONS = {"GeneralTF": ("TF", ("M", "R", "N")), "GeneralTF-E": ("TF-E", ("M", "R", "N", "E"))}
#: The convention's own variables.
_DATA = ("transfer_function_real", "transfer_function_imag")
#: Unit of a library -> the same in words, since SOFA allows lower-case letters only.
_UNITS = {"Pa/Pa": "1", "Pa s/m^3": "pascal second / metre^3"}


def _sofa_name(name: str) -> str:
    return "".join(word.capitalize() for word in name.split("_"))


def write_sofa(library: Library, path: Path) -> None:
    """Write a library over whatever is there; whole or not there.

    Raises:
        OSError: it cannot be written.
        Refusal: the extra that writes SOFA is not installed.
    """
    check_extras("what writes SOFA", "sofa")
    import sofar

    dataset = dataset_of(library)
    sofa = sofar.Sofa("GeneralTF-E")
    sofa.N = library.frequency
    emitters, receivers = _places(library.design)
    sofa.EmitterPosition, sofa.ReceiverPosition = emitters, receivers
    sofa.GLOBAL_Title = library.design.name
    sofa.GLOBAL_Comment = f"emitters: sensing points; receivers: microphones; {TIME_CONVENTION}"
    # as attributes: sofar 1.2 writes no variables of texts with netCDF4 1.7
    names = coordinates_of(library.design)
    for what, held in (("Emitter", "point"), ("Receiver", "microphone")):
        described = f"{held}s in this order: {', '.join(map(str, names[held]))}"
        sofa.add_attribute(f"GLOBAL_{what}Description", described)
    for name, dimensions in real_variables().items():
        if name not in dataset:
            continue
        values = dataset[name].transpose(*dimensions)
        if set(dimensions) == {"point", "microphone", "frequency"}:
            shaped = values.transpose("microphone", "frequency", "point").values[None]
            if name in ("transfer_function_real", "transfer_function_imag"):
                setattr(sofa, f"Data_{name.rsplit('_', 1)[1].capitalize()}", shaped)
            else:
                _add(sofa, name, shaped, "MRNE", values.attrs)
        else:
            letters = "".join(_LETTERS[dimension] for dimension in dimensions)
            _add(sofa, name, values.values, letters, values.attrs)
    for name in TEXTS:
        sofa.add_attribute(f"GLOBAL_{_sofa_name(name)}", dataset.attrs[name])
    with whole_file(path) as beside:
        sofar.write_sofa(str(beside), sofa)
        seal_file(beside)


def _add(sofa: Any, name: str, values: Array, letters: str, attributes: dict[str, str]) -> None:
    """Add a variable that the convention does not know, with its unit and what it is."""
    own = _sofa_name(name)
    sofa.add_variable(own, values, "double", letters)
    sofa.add_attribute(f"{own}_Units", _UNITS[attributes["units"]])
    sofa.add_attribute(f"{own}_LongName", attributes["long_name"])


def _places(design: ArrayDesign) -> tuple[Array, Array]:
    """(n_point, 3) and (n_microphone, 3), m."""
    layout = place_housings(design)
    points = [layout.frame(point).origin for point in layout.points]
    by_name = {microphone.name: layout.frame(microphone).origin for microphone in layout.microphones}
    microphones = [by_name[name] for name in design.microphones]
    return np.array(points) * metres(1.0), np.array(microphones) * metres(1.0)


def read_sofa(path: Path) -> xr.Dataset:
    """The content of a file that :func:`write_sofa` wrote.

    Raises:
        LibraryError: no SOFA file, damaged, of another convention, or of another program, see
            :mod:`acoustic_fem.library.foreign_sofa`.
        Refusal: a part that is missing or not of a library.
    """
    texts, arrays = read_netcdf(path, "a library in SOFA", LibraryError, _sofa_content)
    if texts.get("SOFAConventions") in CONVENTIONS and not any(_sofa_name(name) in texts for name in TEXTS):
        raise LibraryError(
            "is missing, because another program wrote this file",
            kind=Kind.MISSING,
            file=path,
            field="design",
            remedy="run acoustic-fem convert with --design, see docs/formats.md",
        )
    if texts.get("SOFAConventions") != "GeneralTF-E":
        raise LibraryError("is SOFA of another convention than GeneralTF-E", kind=Kind.UNREADABLE, file=path)
    attributes = {name: texts[_sofa_name(name)] for name in TEXTS if _sofa_name(name) in texts}
    frequency = arrays.pop("N", np.empty(0))
    variables = {}
    for name, dimensions in real_variables().items():
        own = f"Data.{name.rsplit('_', 1)[1].capitalize()}" if name in _DATA else _sofa_name(name)
        if own not in arrays:
            continue
        values = arrays[own]
        if values.dtype.kind != "f":
            raise Refusal(f"holds {values.dtype}, not floating-point numbers", kind=Kind.WRONG_TYPE, field=own)
        if set(dimensions) == {"point", "microphone", "frequency"}:
            if values.ndim != 4 or len(values) != 1:
                raise wrong_type(own, f"has shape {values.shape}; it must be (1, receivers, frequencies, emitters)")
            values = values[0].transpose(2, 0, 1)
        variables[name] = values
    return data_set(attributes, frequency, variables)


def _sofa_content(file: Any) -> tuple[dict[str, Any], dict[str, NDArray[Any]]]:
    return dict(file.attrs), {name: np.asarray(one[...]) for name, one in file.variables.items()}
