"""Libraries as CSV tables: a row for each point, microphone and frequency.

Ahead of the rows, behind ``#``, stand the texts of a library, its units and its time convention as JSON. A value that
does not depend on the point, or on the microphone, is repeated in their rows. The impedance between microphones has a
column for each second microphone, such as ``microphone_impedance_B_real``.
"""

from __future__ import annotations

import csv
import json
from array import array
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr

from acoustic_fem.library.library_parts import TEXTS, data_set, stated_design, units_of
from acoustic_fem.library.netcdf_file import TIME_CONVENTION, LibraryError, dataset_of, real_variables
from acoustic_fem.library.transfer_functions import Library
from geometry.design.array_design import ArrayDesign
from geometry.ground.csv_files import read_csv
from geometry.ground.file_checks import MOST_NUMBERS
from geometry.ground.refusal import Kind, Refusal, counted
from geometry.ground.text_files import parse_json
from geometry.ground.typed import Array
from geometry.ground.whole_files import whole_file

#: The first columns, and the order of the rows.
_ORDER = ("point", "microphone", "frequency")


def _columns(design: ArrayDesign) -> dict[str, tuple[str, str]]:
    """Columns that a table may have: variable, and second microphone where it depends on one."""
    found = {}
    for name, dimensions in real_variables().items():
        if "microphone_2" not in dimensions:
            found[name] = (name, "")
            continue
        stem, _, part = name.rpartition("_")
        found |= {f"{stem}_{second}_{part}": (name, second) for second in design.microphones}
    return found


def write_table(library: Library, path: Path) -> None:
    """Write a library over whatever is there; whole or not there.

    Raises:
        OSError: it cannot be written.
    """
    dataset = dataset_of(library)
    held = {
        column: dataset[name].sel(microphone_2=second, drop=True) if second else dataset[name]
        for column, (name, second) in _columns(library.design).items()
        if name in dataset
    }
    table = xr.broadcast(*(values.drop_vars(["line", "place"], errors="ignore") for values in held.values()))
    columns = [values.transpose(*_ORDER).values.ravel() for values in table]
    places = [values.ravel() for values in np.meshgrid(*(dataset[name].values for name in _ORDER), indexing="ij")]
    texts = {name: dataset.attrs[name] for name in TEXTS}
    texts |= {"units": units_of(dataset), "time_convention": TIME_CONVENTION}
    with whole_file(path) as beside, beside.open("w", encoding="utf-8", newline="") as file:
        for name, text in texts.items():
            file.write(f"# {name}: {json.dumps(text)}\n")
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow([*_ORDER, *held])
        # tolist() gives Python's numbers, whose texts read back as the same number
        writer.writerows(zip(*(values.tolist() for values in (*places, *columns)), strict=True))


def read_table(path: Path) -> xr.Dataset:
    """The content of a file that :func:`write_table` wrote.

    Raises:
        LibraryError: no CSV file.
        Refusal: a part that is missing, damaged, or not of a library.
    """
    table = read_csv(path, "a CSV file", LibraryError)
    attributes: dict[str, Any] = {}
    for remark in table.remarks:
        name, _, text = remark.partition(": ")
        attributes[name] = parse_json(text, name, Refusal)
    if table.head[:3] != _ORDER:
        raise _other_columns(table.head, _ORDER)
    attributes = {name: text for name, text in attributes.items() if name in TEXTS}
    design, width, names = stated_design(attributes), len(table.head), table.head[3:]
    known = _columns(design)
    if not set(names) <= set(known) or len(set(names)) < len(names):
        raise _other_columns(table.head, (*_ORDER, *known))
    places = [(str(point + 1), name) for point in range(design.point_count) for name in design.microphones]
    columns = _numbers(table.rows, width, places).reshape(design.point_count, len(design.microphones), -1, width - 2)
    variables: dict[str, Any] = {}
    for k, column in enumerate(names, 1):
        name, second = known[column]
        values = _without_repeats(column, columns[..., k], real_variables()[name])
        if second:
            variables.setdefault(name, {})[second] = values
        else:
            variables[name] = values
    for name, of_second in variables.items():
        if isinstance(of_second, dict):
            if set(of_second) < set(design.microphones):
                raise Refusal("has no column of each microphone", kind=Kind.MISSING, field=name)
            variables[name] = np.stack([of_second[second] for second in design.microphones], axis=1)
    return data_set(attributes, columns[0, 0, :, 0], variables)


def _other_columns(found: tuple[str, ...], wanted: tuple[str, ...]) -> Refusal:
    problem = f"its columns are {', '.join(found) or 'none'}; they must be {', '.join(wanted)}"
    return Refusal(problem, kind=Kind.UNREADABLE)


def _without_repeats(column: str, values: Array, dimensions: tuple[str, ...]) -> Array:
    """A column, (n_point, n_mic, n_freq), without the axes of which its variable does not depend.

    Raises:
        Refusal: it differs along such an axis.
    """
    for axis, name in ((1, "microphone"), (0, "point")):
        if name in dimensions:
            continue
        first = values.take([0], axis=axis)
        if not (values == first).all():
            raise Refusal(f"is not the same in the rows of all {name}s", kind=Kind.DAMAGED, field=column)
        values = first.squeeze(axis)
    return values


def _numbers(rows: Iterable[list[str]], width: int, places: list[tuple[str, str]]) -> Array:
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
