"""Damaged libraries: whatever happened to a file, it is refused by its name, or holds the numbers that were written."""

from __future__ import annotations

import os
import signal
import time
from pathlib import Path

import netCDF4
import numpy as np
import pytest
import scipy.io
from damage import damaged

import acoustic_fem
import geometry
from acoustic_fem.library import sealed_netcdf
from acoustic_fem.library.exchange import FORMATS, export, load
from acoustic_fem.library.netcdf_file import LibraryError
from acoustic_fem.library.transfer_functions import VARIABLES, Library
from geometry.ground.refusal import Kind


@pytest.fixture(scope="module")
def library() -> Library:
    design = geometry.prototype("array-2x6").with_values({"lines.0.points": 3, "layout.columns": 3})
    return acoustic_fem.solve(design, np.linspace(1.0, 100.0, 7), "lumped")


def assert_refused_or_the_same(path: Path, library: Library, done: str) -> bool:
    """True if it was refused."""
    refused = ""
    try:
        found = load(path)
    except LibraryError as error:
        refused = str(error)
    if refused:
        assert refused.startswith(f"{path}: "), done
        assert "\n" not in refused, done
        assert len(refused) < 1000, done
        return True
    assert np.array_equal(found.frequency, library.frequency), done
    assert (found.design, found.medium) == (library.design, library.medium), done
    for name in VARIABLES:
        if getattr(found, name) is None:  # the CSV file has no place for it
            assert (path.suffix, name) == (".csv", "microphone_impedance"), done
        else:
            assert np.array_equal(getattr(found, name).values, getattr(library, name).values), done
    return False


def check_damage(library: Library, folder: Path, suffix: str, count: int, seed: int) -> None:
    path = folder / f"library{suffix}"
    export(library, path)
    assert not assert_refused_or_the_same(path, library, "nothing")
    refused = [assert_refused_or_the_same(path, library, done) for done in damaged(folder, count, seed)]
    assert sum(refused) > count / 2


@pytest.mark.parametrize("suffix", FORMATS)
def test_a_damaged_library_is_refused_or_is_the_same(library: Library, tmp_path: Path, suffix: str) -> None:
    check_damage(library, tmp_path, suffix, 12, 1)


@pytest.mark.slow
@pytest.mark.parametrize("suffix", FORMATS)
def test_many_damaged_libraries_are_refused_or_are_the_same(library: Library, tmp_path: Path, suffix: str) -> None:
    check_damage(library, tmp_path, suffix, 300, 2)


def unsealed(path: Path) -> None:
    """Take the seal away, as a program does that changes the file."""
    content = path.read_bytes()
    path.write_bytes(content[: content.rindex(b"\nacoustic-fem sha256 ")])


@pytest.mark.slow
@pytest.mark.parametrize("suffix", [".nc", ".sofa"])
def test_many_damaged_files_without_a_seal_are_refused_or_are_the_same(
    library: Library, tmp_path: Path, suffix: str
) -> None:
    path = tmp_path / f"library{suffix}"
    export(library, path)
    unsealed(path)
    for done in damaged(tmp_path, 40, 3):
        assert_refused_or_the_same(path, library, done)


@pytest.mark.parametrize("suffix", [".nc", ".sofa"])
def test_a_file_that_another_program_changed_has_no_seal_and_still_its_checksums(
    library: Library, tmp_path: Path, suffix: str
) -> None:
    path = tmp_path / f"library{suffix}"
    export(library, path)
    with netCDF4.Dataset(path, "a") as file:
        file.remark = "seen"
    assert not assert_refused_or_the_same(path, library, "an attribute more")
    with netCDF4.Dataset(path, "a") as file:
        file["point_impedance_real" if suffix == ".nc" else "PointImpedanceReal"][1, 2] *= 1.01
    with pytest.raises(LibraryError, match=r"point_impedance_real is not what was written"):
        load(path)


def test_a_seal_tells_any_damage_before_hdf5_looks(
    library: Library, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "library.nc"
    export(library, path)
    monkeypatch.setattr(netCDF4, "Dataset", None)
    for done in damaged(tmp_path, 3, 4):
        if "bit" in done:
            with pytest.raises(LibraryError, match="is damaged: its bytes are not those"):
                load(path)


def read_for_ever(path: str) -> bytes:
    while True:
        time.sleep(1)


def crash(path: str) -> bytes:
    os.kill(os.getpid(), signal.SIGSEGV)
    return b""


def test_what_takes_too_long_or_ends_the_process_is_refused(
    library: Library, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "library.sofa"
    export(library, path)
    unsealed(path)
    monkeypatch.setattr(sealed_netcdf, "_trial", read_for_ever)
    monkeypatch.setattr(sealed_netcdf, "PATIENCE", 0.2)
    with pytest.raises(LibraryError, match=r"library.sofa: cannot be read in 0.2 s; it is damaged, or not a library"):
        load(path)
    monkeypatch.setattr(sealed_netcdf, "_trial", crash)
    monkeypatch.setattr(sealed_netcdf, "PATIENCE", 60)
    with pytest.raises(
        LibraryError, match=r"library.sofa: cut short, damaged or not .*: the process that reads it crashed"
    ):
        load(path)


def test_arrays_that_would_fill_the_memory_are_refused_before_they_are_read(tmp_path: Path) -> None:
    path = tmp_path / "library.nc"
    with netCDF4.Dataset(path, "w") as file:
        file.createDimension("x", 10**12)
        file.createVariable("a", "f8", ("x",), chunksizes=(1000,))
    with pytest.raises(LibraryError, match="its arrays would take 8000000000000 bytes, and must take at most"):
        load(path)


@pytest.mark.parametrize("suffix", FORMATS)
def test_a_file_without_checksums_is_refused_by_name(
    library: Library, tmp_path: Path, suffix: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / f"library{suffix}"
    export(library, path)
    if suffix == ".csv":
        lines = path.read_text().splitlines(keepends=True)
        path.write_text("".join(line for line in lines if not line.startswith("# checksums")))
    elif suffix == ".npz":
        with np.load(path) as content:
            arrays = {name: content[name] for name in content.files if name != "checksums"}
        np.savez(path, **arrays)
    elif suffix == ".mat":
        content = scipy.io.loadmat(path)
        arrays = {name: values for name, values in content.items() if not name.startswith("__") and name != "checksums"}
        scipy.io.savemat(path, arrays, long_field_names=True)
    else:
        with netCDF4.Dataset(path, "a") as file:
            file.delncattr("checksums" if suffix == ".nc" else "Checksums")
        monkeypatch.setattr(sealed_netcdf, "_try_apart", lambda *_: None)
    with pytest.raises(LibraryError) as refused:
        load(path)
    assert (refused.value.kind, refused.value.field) == (Kind.MISSING, "checksums")
    assert str(refused.value).startswith(f"{path}: checksums are missing")


# -- rows of a table ----------------------------------------------------------------------------------
def exchanged(rows: list[list[str]], one: int, other: int) -> list[list[str]]:
    rows[one], rows[other] = rows[other], rows[one]
    return rows


def renamed(rows: list[list[str]], column: int, old: str, new: str) -> list[list[str]]:
    return [[*row[:column], new if row[column] == old else row[column], *row[column + 1 :]] for row in rows]


ROWS = {  # 3 points, 2 microphones, 7 frequencies
    "rows-exchanged": (lambda rows: exchanged(rows, 0, 20), Kind.MISMATCH, "row 1"),
    "frequencies-exchanged": (lambda rows: exchanged(rows, 1, 2), Kind.MISMATCH, "row 9"),
    "points-renumbered": (lambda rows: renamed(rows, 0, "2", "4"), Kind.MISMATCH, "row 15"),
    "points-doubled": (lambda rows: renamed(rows, 0, "2", "1"), Kind.MISMATCH, "row 15"),
    "microphone-renamed": (lambda rows: renamed(rows, 1, "B", "C"), Kind.MISMATCH, "row 8"),
    "microphones-exchanged": (
        lambda rows: renamed(renamed(renamed(rows, 1, "B", "C"), 1, "A", "B"), 1, "C", "A"), Kind.MISMATCH, "row 1",
    ),
    "frequencies-descending": (lambda rows: [rows[7 * (k // 7) + 6 - k % 7] for k in range(len(rows))], None, ""),
    "row-lost": (lambda rows: rows[:-1], Kind.MISMATCH, ""),
    "no-rows": (lambda rows: [], Kind.MISMATCH, ""),
    "a-text": (lambda rows: renamed(rows, 2, "17.5", "x"), Kind.WRONG_TYPE, "row 2"),
    "value-changed": (
        lambda rows: [[*rows[0][:3], "1.5", *rows[0][4:]], *rows[1:]], Kind.DAMAGED, "transfer_function_real",
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", ROWS)
def test_rows_that_are_not_those_of_the_design_in_its_order_are_refused(
    library: Library, tmp_path: Path, name: str
) -> None:
    change, kind, field = ROWS[name]
    path = tmp_path / "library.csv"
    export(library, path)
    lines = path.read_text().splitlines()
    first = next(number for number, line in enumerate(lines) if line.startswith("point,")) + 1
    rows = change([line.split(",") for line in lines[first:]])
    path.write_text("\n".join([*lines[:first], *(",".join(row) for row in rows)]) + "\n")
    with pytest.raises(LibraryError) as refused:
        load(path)
    assert refused.value.file == str(path)
    assert kind is None or (refused.value.kind, refused.value.field) == (kind, field)
