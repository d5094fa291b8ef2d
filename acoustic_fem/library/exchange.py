"""Libraries in formats of other programs, written and read back to the last digit: SOFA, NPZ and CSV.

- ``.sofa``: AES69-2022, convention GeneralTF-E: emitters are the sensing points, receivers the microphones, both at
  their places in the laid-out array. The other contents of a library are in variables and attributes of its own.
- ``.npz``: one array per variable of the netCDF file, real and imaginary parts apart, and texts.
- ``.csv``: a row per point, microphone and frequency; ahead of it, behind ``#``, the texts as JSON. The impedance
  between microphones, which has no place in such rows, is left out.
"""

from __future__ import annotations

import csv
import json
import os
from array import array
from collections.abc import Iterable
from mmap import ACCESS_READ, mmap
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr
from numpy.typing import NDArray

from acoustic_fem.library.netcdf_file import (
    ATTRIBUTES,
    CHECKSUMS,
    LibraryError,
    dataset_of,
    library_in,
    load_netcdf,
    real_variables,
    refused_in,
    with_checksums,
    write_netcdf,
)
from acoustic_fem.library.sealed_netcdf import read_netcdf
from acoustic_fem.library.transfer_functions import MEASURED, Library
from acoustic_fem.quantities.units import metres
from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import read_completed
from geometry.ground.argument_checks import check_shape, wrong_type
from geometry.ground.array_files import read_npz
from geometry.ground.csv_files import read_csv
from geometry.ground.extras import check_extras
from geometry.ground.file_checks import MOST_NUMBERS, ordinary_file
from geometry.ground.record import seal_file
from geometry.ground.refusal import Kind, Refusal, counted
from geometry.ground.text_files import parse_json
from geometry.ground.typed import Array
from geometry.ground.whole_files import check_own_kind, whole_file
from geometry.layout.arrangement import place_housings
from geometry.layout.placement import point_places

#: Formats of libraries, by the ending of their names: netCDF-4, SOFA, NPZ, CSV.
FORMATS = (".nc", ".sofa", ".npz", ".csv")
#: Texts that a file holds.
_TEXTS = (*ATTRIBUTES, CHECKSUMS)
#: Dimension of a library -> letter of SOFA's: emitters, receivers, frequencies.
_LETTERS = {"point": "E", "microphone": "R", "microphone_2": "R", "frequency": "N"}


def save(library: Library, path: str | os.PathLike[str]) -> None:
    """Write a library in netCDF. The file is never incomplete. An existing file is replaced as by :func:`export`.

    Raises:
        LibraryError: the file cannot be written, or exists and is not netCDF, not a library, or a measured one.
    """
    path = Path(path)
    check_own_kind(path, ".nc", LibraryError)
    check_replaceable(path)
    write_netcdf(library, path)


def export(library: Library, path: str | os.PathLike[str], *, folders: bool = False) -> None:
    """Write a library in the format of the name's suffix; the file is whole or not there.

    Args:
        library: the library.
        path: the file.
        folders: make the folders of the file that are missing.

    Raises:
        LibraryError: another suffix than ``.nc``, ``.sofa``, ``.npz`` and ``.csv``, a file that cannot be written, or
            one that is there and is not a library, or a measured one.
    """
    path = Path(path)
    _suffix(path)
    check_replaceable(path)
    if folders:
        try:
            path.parent.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            problem = f"cannot be made: {error.strerror or error}"
            raise LibraryError(problem, kind=Kind.UNREADABLE, file=path.parent) from None
    write_library(library, path)


def check_replaceable(path: Path) -> None:
    """Refuse to write over a file that cannot be computed again; recordings have some of the suffixes too.

    Raises:
        LibraryError: a file is there, and is not a library, or a measured one.
    """
    if not path.is_file():
        return
    fidelity = fidelity_in(path)
    if fidelity is None or fidelity == MEASURED:
        what = "is not a readable library" if fidelity is None else "a measured library is never overwritten"
        remedy = "name another file, or remove this one"
        raise LibraryError(f"exists, and {what}", kind=Kind.EXISTS, file=path, remedy=remedy)


def fidelity_in(path: Path) -> str | None:
    """Fidelity of the library in a file; None where none can be read."""
    try:
        return load(path).fidelity
    except LibraryError:
        return None


def write_library(library: Library, path: Path) -> None:
    """Write a library as :func:`export` does, over whatever is there: for who has looked at it already.

    Raises:
        LibraryError: another suffix than ``.nc``, ``.sofa``, ``.npz`` and ``.csv``, or a file that cannot be written.
    """
    write = {".nc": write_netcdf, ".sofa": _write_sofa, ".npz": _write_npz, ".csv": _write_csv}[_suffix(path)]
    try:
        write(library, path)
    except OSError as error:
        raise LibraryError(f"cannot be written: {error.strerror or error}", kind=Kind.UNREADABLE, file=path) from None


def load(path: str | os.PathLike[str]) -> Library:
    """Read a library file that :func:`export` or :func:`acoustic_fem.save` wrote, with all digits.

    The format is recognized by the content of the file, whatever its name is.

    Raises:
        LibraryError: no such file, or a file that is cut short, was changed, or is not a library; the message says
            which.
    """
    path = ordinary_file(path, "a library", LibraryError)
    found = _format_of(path)
    if found == ".nc":
        return load_netcdf(path)
    try:
        dataset = {".sofa": _read_sofa, ".npz": _read_npz, ".csv": _read_csv}[found](path)
    except LibraryError:
        raise
    except Refusal as error:
        raise refused_in(path, error) from None
    return library_in(path, dataset)


def _format_of(path: Path) -> str:
    """Format of the content of a file, as the suffix that it should have."""
    with path.open("rb") as file:
        head = file.read(1024)
        if head.startswith(b"\x89HDF\r\n\x1a\n"):
            # By its bytes: HDF5 follows what a damaged file says.
            with mmap(file.fileno(), 0, access=ACCESS_READ) as content:
                return ".nc" if content.find(b"SOFAConventions") < 0 else ".sofa"
    if head.startswith(b"PK"):
        return ".npz"
    if head and b"\0" not in head:
        return ".csv"
    what = "is empty" if not head else "holds neither netCDF, SOFA, NPZ nor CSV"
    raise LibraryError(f"{what}: it is not a library", kind=Kind.UNREADABLE, file=path)


def _suffix(path: Path) -> str:
    suffix = path.suffix.lower()
    if suffix not in FORMATS:
        raise LibraryError(
            f"its name must end with {', '.join(FORMATS[:-1])} or {FORMATS[-1]}", kind=Kind.OUT_OF_RANGE, file=path
        )
    return suffix


def _dataset(attributes: dict[str, Any], frequency: Array, variables: dict[str, Array]) -> xr.Dataset:
    """Variables shaped as :data:`VARIABLES` lists them, as :func:`library_of` takes them.

    Raises:
        Refusal: an attribute is missing or the design is not valid.
    """
    design = _design(attributes)
    if frequency.ndim != 1 or frequency.dtype.kind not in "fiu":
        raise wrong_type("frequency", f"is {frequency.dtype} of shape {frequency.shape}; it must be numbers in one row")
    lines, places = zip(*point_places(design), strict=True)
    coordinates: dict[str, tuple[str, Any]] = {
        "point": ("point", list(range(1, len(lines) + 1))),
        "line": ("point", list(lines)),
        "place": ("point", list(places)),
        "microphone": ("microphone", list(design.microphones)),
        "microphone_2": ("microphone_2", list(design.microphones)),
        "frequency": ("frequency", frequency),
    }
    sizes = {name: len(values) for name, (_, values) in coordinates.items()}
    dimensions = real_variables()
    for name, values in variables.items():
        shape = tuple(sizes[dimension] for dimension in dimensions[name])
        check_shape(name, values, shape, "that of its design and frequencies")
    return xr.Dataset({name: (dimensions[name], values) for name, values in variables.items()}, coordinates, attributes)


def _design(attributes: dict[str, Any]) -> ArrayDesign:
    missing = [name for name in ATTRIBUTES if not isinstance(attributes.get(name), str)]
    if missing:
        raise Refusal("is missing: this program did not write it", kind=Kind.MISSING, field=missing[0])
    return read_completed(attributes["design_toml"], "design_toml")


# -- SOFA -----------------------------------------------------------------------------------------------------------
def _sofa_name(name: str) -> str:
    return "".join(word.capitalize() for word in name.split("_"))


def _write_sofa(library: Library, path: Path) -> None:
    check_extras("what writes SOFA", "sofa")
    import sofar

    dataset = dataset_of(library)
    sofa = sofar.Sofa("GeneralTF-E")
    sofa.N = library.frequency
    emitters, receivers = _places(library.design)
    sofa.EmitterPosition, sofa.ReceiverPosition = emitters, receivers
    sofa.GLOBAL_Title = library.design.name
    sofa.GLOBAL_Comment = "emitters: sensing points; receivers: microphones; exp(+j omega t)"
    for name, dimensions in real_variables().items():
        if name not in dataset:
            continue
        values = dataset[name].transpose(*dimensions)
        if set(dimensions) == {"point", "microphone", "frequency"}:
            shaped = values.transpose("microphone", "frequency", "point").values[None]
            if name in ("transfer_function_real", "transfer_function_imag"):
                setattr(sofa, f"Data_{name.rsplit('_', 1)[1].capitalize()}", shaped)
            else:
                sofa.add_variable(_sofa_name(name), shaped, "double", "MRNE")
        else:
            letters = "".join(_LETTERS[dimension] for dimension in dimensions)
            sofa.add_variable(_sofa_name(name), values.values, "double", letters)
    for name in _TEXTS:
        sofa.add_attribute(f"GLOBAL_{_sofa_name(name)}", dataset.attrs[name])
    with whole_file(path) as beside:
        sofar.write_sofa(str(beside), sofa)
        seal_file(beside)


def _places(design: ArrayDesign) -> tuple[Array, Array]:
    """(n_point, 3) and (n_microphone, 3), m."""
    layout = place_housings(design)
    points = [layout.frame(point).origin for point in layout.points]
    by_name = {microphone.name: layout.frame(microphone).origin for microphone in layout.microphones}
    microphones = [by_name[name] for name in design.microphones]
    return np.array(points) * metres(1.0), np.array(microphones) * metres(1.0)


def _read_sofa(path: Path) -> xr.Dataset:
    texts, arrays = read_netcdf(path, "a library in SOFA", LibraryError, _sofa_content)
    if texts.get("SOFAConventions") != "GeneralTF-E":
        raise LibraryError("is SOFA of another convention than GeneralTF-E", kind=Kind.UNREADABLE, file=path)
    attributes = {name: texts[_sofa_name(name)] for name in _TEXTS if _sofa_name(name) in texts}
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
    return _dataset(attributes, frequency, variables)


def _sofa_content(file: Any) -> tuple[dict[str, Any], dict[str, NDArray[Any]]]:
    return dict(file.attrs), {name: np.asarray(one[...]) for name, one in file.variables.items()}


_DATA = ("transfer_function_real", "transfer_function_imag")


# -- NPZ ------------------------------------------------------------------------------------------------------------
def _write_npz(library: Library, path: Path) -> None:
    dataset = dataset_of(library)
    arrays: dict[str, Any] = {
        name: dataset[name].transpose(*dimensions).values
        for name, dimensions in real_variables().items()
        if name in dataset
    }
    arrays |= {name: np.array(dataset.attrs[name]) for name in _TEXTS} | {"frequency": library.frequency}
    with whole_file(path) as beside:
        np.savez(beside, **arrays)


def _read_npz(path: Path) -> xr.Dataset:
    arrays = read_npz(path, "an NPZ file", LibraryError)
    if "frequency" not in arrays:
        raise Refusal("is missing: this program did not write it", kind=Kind.MISSING, field="frequency")
    attributes = {name: str(arrays[name]) for name in _TEXTS if name in arrays}
    variables = {name: arrays[name] for name in real_variables() if name in arrays}
    return _dataset(attributes, arrays["frequency"], variables)


# -- CSV ------------------------------------------------------------------------------------------------------------
#: The first columns, and the order of the rows.
_ORDER = ("point", "microphone", "frequency")


def _write_csv(library: Library, path: Path) -> None:
    dataset = dataset_of(library)
    rows = with_checksums(dataset.drop_vars(["line", "place"]).drop_dims("microphone_2", errors="ignore"))
    names = [name for name in real_variables() if name in rows]
    table = xr.broadcast(*(rows[name] for name in names))
    columns = [values.transpose(*_ORDER).values.ravel() for values in table]
    places = [values.ravel() for values in np.meshgrid(*(rows[name].values for name in _ORDER), indexing="ij")]
    with whole_file(path) as beside, beside.open("w", encoding="utf-8", newline="") as file:
        for name in _TEXTS:
            file.write(f"# {name}: {json.dumps(rows.attrs[name])}\n")
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow([*_ORDER, *names])
        # tolist() gives Python's numbers, whose texts read back as the same number
        writer.writerows(zip(*(values.tolist() for values in (*places, *columns)), strict=True))


def _read_csv(path: Path) -> xr.Dataset:
    table = read_csv(path, "a CSV file", LibraryError)
    attributes: dict[str, Any] = {}
    for remark in table.remarks:
        name, _, text = remark.partition(": ")
        attributes[name] = parse_json(text, name, Refusal)
    names = table.head[3:]
    known = [name for name, dimensions in real_variables().items() if "microphone_2" not in dimensions]
    if table.head[:3] != _ORDER or not set(names) <= set(known) or len(set(names)) < len(names):
        problem = f"its columns are {', '.join(table.head) or 'none'}; they must be {', '.join((*_ORDER, *known))}"
        raise Refusal(problem, kind=Kind.UNREADABLE)
    design, width = _design(attributes), len(table.head)
    places = [(str(point + 1), name) for point in range(design.point_count) for name in design.microphones]
    columns = _csv_numbers(table.rows, width, places).reshape(
        design.point_count, len(design.microphones), -1, width - 2
    )
    # what does not depend on the microphone stands in the rows of each
    dimensions = real_variables()
    for k, name in enumerate(names, 1):
        if "microphone" not in dimensions[name] and not np.array_equal(columns[:, :-1, :, k], columns[:, 1:, :, k]):
            raise Refusal("is not the same in the rows of all microphones", kind=Kind.DAMAGED, field=name)
    variables = {
        name: columns[..., k] if "microphone" in dimensions[name] else columns[:, 0, :, k]
        for k, name in enumerate(names, 1)
    }
    return _dataset(attributes, columns[0, 0, :, 0], variables)


def _csv_numbers(rows: Iterable[list[str]], width: int, places: list[tuple[str, str]]) -> Array:
    """Numbers of all rows, their frequency first; (n_place n_freq, width - 2) float64.

    Args:
        rows: texts of all rows.
        width: of each.
        places: point and microphone, in the order in which they stand; all have the frequencies of the first.

    Raises:
        Refusal: a row that is not the one that stands there, or no number.
    """
    numbers, done, count = array("d"), 0, 0
    for done, row in enumerate(rows, 1):
        if len(row) != width:
            problem = f"has {counted(len(row), 'value')}, must have {width}; cut short?"
            raise Refusal(problem, kind=Kind.UNREADABLE, field=f"row {done}")
        try:
            numbers.extend(map(float, row[2:]))
        except ValueError as error:
            raise Refusal(str(error), kind=Kind.WRONG_TYPE, field=f"row {done}") from None
        if len(numbers) > MOST_NUMBERS:
            raise Refusal(
                f"holds more than {MOST_NUMBERS} numbers; it must hold at most as many", kind=Kind.OUT_OF_RANGE
            )
        if count == done - 1 and tuple(row[:2]) == places[0]:
            count = done
            continue
        place, k = divmod(done - 1, count or 1)
        wanted = places[min(place, len(places) - 1)]
        frequency = numbers[k * (width - 2)]
        if tuple(row[:2]) != wanted or float(row[2]) != frequency or place >= len(places):
            raise Refusal(
                f"is of point {row[0]}, microphone {row[1]}, {row[2]} Hz; it must be of point {wanted[0]}, "
                f"microphone {wanted[1]}, {frequency:g} Hz as in its design: rows keep their order",
                kind=Kind.MISMATCH, field=f"row {done}",
            )  # fmt: skip
    if not count or done != count * len(places):
        raise Refusal(
            f"has {counted(done, 'row')}; its design has {counted(len(places), 'point')} by microphones, each with "
            f"{counted(count, 'row')}",
            kind=Kind.MISMATCH,
        )
    return np.frombuffer(numbers).reshape(-1, width - 2)
