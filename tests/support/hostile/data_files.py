"""Libraries, stores and recordings whose contents are wrong."""

from __future__ import annotations

import json
import random
import struct
import zipfile
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import scipy.io
import scipy.io.wavfile
import xarray as xr

from hostile.damage import Change, written


# -- libraries ------------------------------------------------------------------------------------------------
def _npz(edit: Callable[[dict[str, Any]], None], **options: Any) -> Change:
    """Loads all arrays of the library, hands them to be edited, and writes them back."""

    def change(folder: Path, draw: random.Random) -> None:
        path = folder / "library.npz"
        with np.load(path) as stored:
            arrays = dict(stored)
        edit(arrays)
        np.savez(path, **arrays, **options)

    return change


def _set(name: str, value: Any) -> Callable[[dict[str, Any]], None]:
    def edit(arrays: dict[str, Any]) -> None:
        arrays[name] = value(arrays[name]) if callable(value) else np.asarray(value)

    return edit


def _all_complex(value: Callable[[np.ndarray], np.ndarray]) -> Callable[[dict[str, Any]], None]:
    def edit(arrays: dict[str, Any]) -> None:
        for name in arrays:
            if name.endswith(("_real", "_imag")):
                arrays[name] = value(arrays[name])

    return edit


def _claims(shape: str) -> Change:
    """An archive with a member whose header claims a shape that the file does not hold."""

    def change(folder: Path, draw: random.Random) -> None:
        head = f"{{'descr': '<f8', 'fortran_order': False, 'shape': {shape}, }}".ljust(117) + "\n"
        member = b"\x93NUMPY\x01\x00" + struct.pack("<H", len(head)) + head.encode()
        path = folder / "library.npz"
        with zipfile.ZipFile(path) as archive:
            kept = {entry: archive.read(entry) for entry in archive.namelist()}
        with zipfile.ZipFile(path, "w") as archive:
            for entry, data in kept.items():
                archive.writestr(entry, member if entry == "transfer_function_real.npy" else data)

    return change


def _encrypted(folder: Path, draw: random.Random) -> None:
    path = folder / "library.npz"
    data = bytearray(path.read_bytes())
    for signature, offset in ((b"PK\x03\x04", 6), (b"PK\x01\x02", 8)):
        place = data.find(signature)
        data[place + offset] |= 1
    path.write_bytes(data)


def _unknown_compression(folder: Path, draw: random.Random) -> None:
    path = folder / "library.npz"
    data = bytearray(path.read_bytes())
    for signature, offset in ((b"PK\x03\x04", 8), (b"PK\x01\x02", 10)):
        place = data.find(signature)
        data[place + offset : place + offset + 2] = struct.pack("<H", 77)
    path.write_bytes(data)


def _bomb(folder: Path, draw: random.Random) -> None:
    """4 GB of zeros in 4 MB."""
    head = "{'descr': '<f8', 'fortran_order': False, 'shape': (536870912,), }".ljust(117) + "\n"
    with (
        zipfile.ZipFile(folder / "library.npz", "w", zipfile.ZIP_DEFLATED) as archive,
        archive.open("transfer_function_real.npy", "w", force_zip64=True) as member,
    ):
        member.write(b"\x93NUMPY\x01\x00" + struct.pack("<H", len(head)) + head.encode())
        for _ in range(256):
            member.write(bytes(2**24))


NPZ_CHANGES: tuple[tuple[str, Change], ...] = (
    ("8 PB claimed", _claims("(1000000000000000,)")),
    ("64 GB claimed", _claims("(8000000000,)")),
    ("a negative shape", _claims("(-5, 3)")),
    ("a shape that is none", _claims("('a', 3)")),
    ("encrypted", _encrypted),
    ("unknown compression", _unknown_compression),
    ("4 GB of zeros", _bomb),
    ("scalar frequency", _npz(_set("frequency", 5.0))),
    ("frequencies the wrong way round", _npz(_set("frequency", lambda f: f[::-1].copy()))),
    ("frequencies of no number", _npz(_set("frequency", lambda f: f * np.nan))),
    ("negative frequencies", _npz(_set("frequency", lambda f: -f[::-1]))),
    ("texts for frequencies", _npz(_set("frequency", lambda f: f.astype(str)))),
    ("objects for frequencies", _npz(_set("frequency", lambda f: f.astype(object)))),
    ("a frequency less", _npz(_set("frequency", lambda f: f[:-1]))),
    ("all zero", _npz(_all_complex(np.zeros_like))),
    ("constant", _npz(_all_complex(np.ones_like))),
    ("not finite", _npz(_all_complex(lambda a: a * np.inf))),
    (
        "one value not finite",
        _npz(_set("transfer_function_real", lambda a: np.where(np.arange(a.size).reshape(a.shape), a, np.nan))),
    ),
    ("of another shape", _npz(_set("transfer_function_real", lambda a: a[:, :1]))),
    ("of another sign", _npz(_set("transfer_function_real", lambda a: -a))),
    ("points exchanged", _npz(_set("transfer_function_real", lambda a: a[::-1].copy()))),
    ("a design that is none", _npz(_set("design_toml", "nonsense = 1"))),
    ("a number for the design", _npz(_set("design_toml", 1.0))),
    ("a fidelity that is none", _npz(_set("fidelity", "exact"))),
    ("a medium that is none", _npz(_set("medium", "{}"))),
    ("a medium of texts", _npz(_set("medium", '{"density": "a"}'))),
    ("a provenance that is none", _npz(_set("provenance", "[1, 2"))),
)


def _csv(edit: Callable[[list[str]], list[str]]) -> Change:
    def change(folder: Path, draw: random.Random) -> None:
        path = folder / "library.csv"
        path.write_text("\n".join(edit(path.read_text(encoding="utf-8").splitlines())) + "\n", encoding="utf-8")

    return change


def _rows_swapped(lines: list[str]) -> list[str]:
    return [*lines[:-40], lines[-30], *lines[-39:-30], lines[-40], *lines[-29:]]


def _cells(change: Callable[[list[str]], list[str]]) -> Callable[[list[str]], list[str]]:
    def edit(lines: list[str]) -> list[str]:
        return [",".join(change(line.split(","))) if line[:1].isdigit() else line for line in lines]

    return edit


CSV_CHANGES: tuple[tuple[str, Change], ...] = (
    ("rows exchanged", _csv(_rows_swapped)),
    ("a row twice", _csv(lambda lines: [*lines, lines[-1]])),
    ("a row less", _csv(lambda lines: lines[:-1])),
    ("a cell less", _csv(lambda lines: [*lines[:-1], lines[-1].rpartition(",")[0]])),
    ("a text for a number", _csv(lambda lines: [*lines[:-1], lines[-1].rpartition(",")[0] + ",abc"])),
    ("the last number changed", _csv(lambda lines: [*lines[:-1], lines[-1].rpartition(",")[0] + ",1e9"])),
    ("a header nested deep", _csv(lambda lines: ["# fidelity: " + "[" * 5000 + "]" * 5000, *lines[1:]])),
    ("a header of 5,000 digits", _csv(lambda lines: ["# fidelity: " + "1" * 5000, *lines[1:]])),
    ("no header", _csv(lambda lines: [line for line in lines if not line.startswith("#")])),
    ("only the header", _csv(lambda lines: [line for line in lines if line.startswith("#")])),
    ("a renamed microphone", _csv(lambda lines: [line.replace(",A,", ",C,") for line in lines])),
    ("columns exchanged", _csv(_cells(lambda cells: [*cells[:-2], cells[-1], cells[-2]]))),
    ("a million commas", _csv(lambda lines: [*lines, "," * 1_000_000])),
)


def _netcdf(edit: Callable[[xr.Dataset], xr.Dataset]) -> Change:
    def change(folder: Path, draw: random.Random) -> None:
        path = folder / "library.nc"
        with xr.open_dataset(path) as stored:
            data = stored.load()
        edit(data).to_netcdf(path)

    return change


def _times(factor: float) -> Callable[[xr.Dataset], xr.Dataset]:
    return lambda data: data.map(lambda array: array * factor if array.dtype.kind == "f" else array, keep_attrs=True)


NETCDF_CHANGES: tuple[tuple[str, Change], ...] = (
    ("all zero", _netcdf(_times(0.0))),
    ("all infinite", _netcdf(_times(np.inf))),
    ("no attributes", _netcdf(lambda data: data.drop_attrs())),
    *((f"without {k}", _netcdf(lambda data, k=k: data.drop_vars(list(data.data_vars)[k]))) for k in range(3)),
    ("without frequencies", _netcdf(lambda data: data.drop_vars("frequency"))),
    ("every second frequency twice", _netcdf(lambda data: data.isel(frequency=[0, 0, *range(2, 500)]))),
    ("another table", _netcdf(lambda data: xr.Dataset({"temperature": ("time", np.arange(5.0))}))),
)


# -- stores of sweeps -----------------------------------------------------------------------------------------
def _attribute(name: str, value: Any) -> Change:
    """Puts a value in the place of an attribute of the store; None takes it away."""

    def change(folder: Path, draw: random.Random) -> None:
        path = folder / "results.zarr" / "zarr.json"
        held = json.loads(path.read_text(encoding="utf-8"))
        assert name in held["attributes"], sorted(held["attributes"])
        if value is None:
            del held["attributes"][name]
        else:
            held["attributes"][name] = value
        path.write_text(json.dumps(held), encoding="utf-8")

    return change


def _metadata(edit: Callable[[dict[str, Any]], None], member: str = "") -> Change:
    def change(folder: Path, draw: random.Random) -> None:
        path = folder / "results.zarr" / member / "zarr.json"
        held = json.loads(path.read_text(encoding="utf-8"))
        edit(held)
        path.write_text(json.dumps(held), encoding="utf-8")

    return change


def _gone(member: str) -> Change:
    def change(folder: Path, draw: random.Random) -> None:
        import shutil

        path = folder / "results.zarr" / member
        shutil.rmtree(path) if path.is_dir() else path.unlink()

    return change


_STORE_ATTRIBUTES = ("study", "study_content", "base_design", "fidelity", "acoustic_fem_sweep")
#: Changes to what is kept of a sweep, and to the Zarr store that is written from it, which changes no result.
RECORD_CHANGES: tuple[tuple[str, Change], ...] = (
    *((f"{name} gone", _gone(f"records/{name}")) for name in ("study", "000000.metrics", "000011.metrics")),
    ("records gone", _gone("records")),
    ("a text for the study", written("results.zarr/records/study", "study")),
    ("a text for the metrics", written("results.zarr/records/000000.metrics", "acoustic-fem sweep 99\n")),
)
STORE_CHANGES: tuple[tuple[str, Change], ...] = (
    *((f"{name} gone", _attribute(name, None)) for name in _STORE_ATTRIBUTES),
    *(
        (f"{name} = {value!r}", _attribute(name, value))
        for name in _STORE_ATTRIBUTES
        for value in (7, "nonsense", [], {})
    ),
    ("a later format", _attribute("acoustic_fem_sweep", 99)),
    *(
        (f"{name} gone", _gone(name))
        for name in (
            "case",
            "state",
            "reason",
            "distance_smallest",
            "tube.length",
            "responses/frequency",
            "zarr.json",
            "state/zarr.json",
            "responses/transfer_function_real",
        )
    ),
    ("another type of node", _metadata(lambda held: held.update(node_type="array"))),
    ("a later Zarr", _metadata(lambda held: held.update(zarr_format=9))),
    ("a huge array", _metadata(lambda held: held.update(shape=[10**12]), "distance_smallest")),
    ("a negative shape", _metadata(lambda held: held.update(shape=[-3]), "distance_smallest")),
    ("another type of number", _metadata(lambda held: held.update(data_type="int8"), "distance_smallest")),
    ("an unknown codec", _metadata(lambda held: held.update(codecs=[{"name": "rot13"}]), "distance_smallest")),
    ("a list for the metadata", written("results.zarr/zarr.json", "[]")),
)


# -- recordings -----------------------------------------------------------------------------------------------
def _wav_fields(**fields: int) -> Change:
    """Sets fields of a WAV header; the file of the good files has its ``fmt`` chunk first."""
    places = {
        "riff": (4, "<I"),
        "fmt_length": (16, "<I"),
        "format": (20, "<H"),
        "channels": (22, "<H"),
        "rate": (24, "<I"),
        "byte_rate": (28, "<I"),
        "align": (32, "<H"),
        "bits": (34, "<H"),
    }

    def change(folder: Path, draw: random.Random) -> None:
        path = folder / "touches.wav"
        data = bytearray(path.read_bytes())
        for name, value in fields.items():
            place, kind = places[name]
            struct.pack_into(kind, data, place, value)
        path.write_bytes(data)

    return change


def _silence(folder: Path, draw: random.Random) -> None:
    """Nearly 4 GB of silence, as a file with a hole."""
    path = folder / "touches.wav"
    path.unlink()
    size = 2**32 - 60
    head = struct.pack(
        "<4sI4s4sIHHIIHH4sI", b"RIFF", size + 36, b"WAVE", b"fmt ", 16, 1, 2, 1000, 2000, 2, 8, b"data", size
    )
    with path.open("wb") as file:
        file.write(head)
        file.truncate(size + 44)


def _wave(signals: Callable[[np.ndarray], np.ndarray], rate: int = 1000) -> Change:
    def change(folder: Path, draw: random.Random) -> None:
        _, data = scipy.io.wavfile.read(folder / "touches.wav")
        scipy.io.wavfile.write(folder / "touches.wav", rate, np.ascontiguousarray(signals(data)))

    return change


def _one_late(data: np.ndarray) -> np.ndarray:
    late = np.tile(data, (20, 1))
    late[:59_000, 1] = 0
    return late


WAV_CHANGES: tuple[tuple[str, Change], ...] = (
    ("block align 0", _wav_fields(align=0)),
    ("no channels", _wav_fields(channels=0)),
    ("65535 channels", _wav_fields(channels=65535, align=65535)),
    ("rate 0", _wav_fields(rate=0)),
    ("rate of 4 GHz", _wav_fields(rate=2**32 - 1)),
    ("bits 0", _wav_fields(bits=0)),
    ("bits 7", _wav_fields(bits=7)),
    ("an unknown format", _wav_fields(format=999)),
    ("a format chunk of 4 GB", _wav_fields(fmt_length=2**32 - 2)),
    ("4 GB of silence", _silence),
)
#: Of a header that is as it should be; played in real time they are named frame by frame.
WAVE_CHANGES: tuple[tuple[str, Change], ...] = (
    ("one channel", _wave(lambda data: data[:, 0])),
    ("three channels", _wave(lambda data: np.column_stack([data, data[::-1, 0]]))),
    ("no samples", _wave(lambda data: data[:0])),
    ("one sample", _wave(lambda data: data[:1])),
    ("samples that are no numbers", _wave(lambda data: data * np.float32(np.nan))),
    ("a rate of 50 Hz", _wave(lambda data: data, 50)),
    ("one channel 59 s late", _wave(_one_late)),
    ("one channel twice", _wave(lambda data: data[:, [0, 0]])),
    ("a dead channel", _wave(lambda data: data * np.float32([1, 0]))),
)


def _table(edit: Callable[[list[str]], list[str]]) -> Change:
    def change(folder: Path, draw: random.Random) -> None:
        path = folder / "touches.csv"
        path.write_text("\n".join(edit(path.read_text().splitlines())), encoding="utf-8")

    return change


TABLE_CHANGES: tuple[tuple[str, Change], ...] = (
    ("no names", _table(lambda lines: lines[1:])),
    ("other names", _table(lambda lines: ["time,C,D", *lines[1:]])),
    ("a name twice", _table(lambda lines: ["time,A,A", *lines[1:]])),
    ("a text", _table(lambda lines: [*lines[:9], "abc,1,2", *lines[10:]])),
    ("a cell less", _table(lambda lines: [*lines[:9], "0.009,1", *lines[10:]])),
    ("not a number", _table(lambda lines: [*lines[:9], "0.008,nan,2", *lines[10:]])),
    ("time backwards", _table(lambda lines: [lines[0], *lines[:0:-1]])),
    ("time that stands", _table(lambda lines: [lines[0], *["0," + line.split(",", 1)[1] for line in lines[1:]]])),
    ("ten million columns", written("touches.csv", "," * 10_000_000)),
    ("only names", _table(lambda lines: lines[:1])),
)


def _signals(suffix: str, edit: Callable[[dict[str, Any]], dict[str, Any]]) -> Change:
    def change(folder: Path, draw: random.Random) -> None:
        with np.load(folder / "touches.npz") as stored:
            arrays = edit(dict(stored))
        if suffix == "npz":
            np.savez(folder / "touches.npz", **arrays)
        else:
            scipy.io.savemat(folder / "touches.mat", arrays)

    return change


def _edits() -> Iterator[tuple[str, Callable[[dict[str, Any]], dict[str, Any]]]]:
    yield "no signals", lambda held: {"sample_rate": held["sample_rate"]}
    yield "rate 0", lambda held: {**held, "sample_rate": 0.0}
    yield "rate of no number", lambda held: {**held, "sample_rate": np.nan}
    yield "many rates", lambda held: {**held, "sample_rate": np.ones(5)}
    yield "a text for a rate", lambda held: {**held, "sample_rate": "fast"}
    yield "three dimensions", lambda held: {**held, "signals": held["signals"][None]}
    yield "one number", lambda held: {**held, "signals": 1.0}
    yield "complex numbers", lambda held: {**held, "signals": held["signals"] * 1j}
    yield "texts", lambda held: {**held, "signals": held["signals"][:, :50].astype(str)}
    yield "infinite", lambda held: {**held, "signals": held["signals"] * np.inf}
    yield "three channels", lambda held: {**held, "signals": held["signals"][[0, 1, 0]]}


SIGNAL_CHANGES = tuple((what, _signals("npz", edit)) for what, edit in _edits())


def _sparse(folder: Path, draw: random.Random) -> None:
    from scipy.sparse import coo_array

    held = {"signals": coo_array(np.eye(2, 5000)), "sample_rate": 1000.0}
    scipy.io.savemat(folder / "touches.mat", held)


MAT_CHANGES: tuple[tuple[str, Change], ...] = (
    *((what, _signals("mat", edit)) for what, edit in _edits()),
    ("100 bytes", written("touches.mat", b"MATLAB 5.0 MAT-file".ljust(100))),
    ("sparse", _sparse),
    ("version 7.3", written("touches.mat", b"MATLAB 7.3 MAT-file".ljust(124) + b"\x00\x02IM" + bytes(400))),
)
