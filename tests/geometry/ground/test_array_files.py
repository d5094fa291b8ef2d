"""NPZ and MAT files: what they claim is refused before anything is allocated for it, whatever they claim."""

from __future__ import annotations

import io
import struct
import tracemalloc
import zipfile
import zlib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import scipy.io
import scipy.sparse
from numpy.typing import NDArray
from refusals import refused

from geometry.ground.array_files import read_mat, read_npz
from geometry.ground.refusal import Kind, Refusal

ARRAYS = {"a": np.arange(6.0).reshape(2, 3), "rate": np.array(1000), "text": np.array("as it is")}


def member(shape: str, dtype: str = "<f8") -> bytes:
    """An array's file of a header that claims a shape, and eight bytes."""
    header = f"{{'descr': '{dtype}', 'fortran_order': False, 'shape': {shape}, }}\n".encode()
    return b"\x93NUMPY\x01\x00" + struct.pack("<H", len(header)) + header + bytes(8)


def archive(content: bytes) -> bytes:
    made = io.BytesIO()
    with zipfile.ZipFile(made, "w", zipfile.ZIP_DEFLATED) as file:
        file.writestr("a.npy", content)
    return made.getvalue()


def altered(place: int, value: int) -> bytes:
    """An archive in whose two headers a field is another; places are those of the local header."""
    whole = bytearray(archive(member("(1,)")))
    central = whole.index(b"PK\x01\x02")
    whole[place : place + 2] = whole[central + place + 2 : central + place + 4] = struct.pack("<H", value)
    return bytes(whole)


def save_mat(path: Path, **arrays: NDArray[Any]) -> None:
    scipy.io.savemat(path, arrays)


HOSTILE: dict[str, Callable[[], bytes]] = {
    "8 PB": lambda: archive(member("(1000000, 1000000, 1000)")),
    "a shape below zero": lambda: archive(member("(-1, -1)")),
    "a scalar of gigabytes": lambda: archive(member("()", "<U500000000")),
    "objects": lambda: archive(member("(1,)", "|O")),
    "a deep header": lambda: archive(member("(" * 2000)),
    "another version": lambda: archive(member("(1,)").replace(b"\x01\x00", b"\x09\x00", 1)),
    "encrypted": lambda: altered(6, 1),
    "unknown compression": lambda: altered(8, 77),
    "no archive": lambda: b"neither sound nor numbers",
    "nothing": lambda: b"",
}


@pytest.mark.parametrize("kind", HOSTILE)
def test_an_npz_file_that_claims_what_it_does_not_hold_is_refused(kind: str, tmp_path: Path) -> None:
    path = tmp_path / "given.npz"
    path.write_bytes(HOSTILE[kind]())
    tracemalloc.start()
    try:
        with refused(Kind.UNREADABLE, file=path):
            read_npz(path, "an NPZ file", Refusal)
        _, most = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    assert most < 10_000_000


def test_numbers_beyond_the_bound_are_refused_before_they_are_unpacked(tmp_path: Path) -> None:
    for read, name, save in ((read_npz, "a.npz", np.savez_compressed), (read_mat, "a.mat", save_mat)):
        path = tmp_path / name
        save(path, a=np.zeros(40, np.int8), b=np.zeros(60))
        assert read(path, "a file", Refusal, 100)["a"].size == 40
        save(path, a=np.zeros(41, np.int8), b=np.zeros(60))
        with refused(Kind.OUT_OF_RANGE, file=path):
            read(path, "a file", Refusal, 100)


def test_a_mat_file_that_unpacks_to_more_than_the_bound_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "given.mat"
    packed = zlib.compress(bytes(10_000_000))
    head = b"MATLAB 5.0".ljust(124) + b"\x00\x01IM"
    path.write_bytes(head + struct.pack("<II", 15, len(packed)) + packed)
    with refused(Kind.OUT_OF_RANGE, file=path):
        read_mat(path, "a file", Refusal, 1000)


@pytest.mark.parametrize("size", [0, 3, 100, 127, 130, 200])
def test_a_mat_file_of_a_few_bytes_is_refused(size: int, tmp_path: Path) -> None:
    path = tmp_path / "given.mat"
    scipy.io.savemat(path, {"a": np.ones(30)})
    path.write_bytes(path.read_bytes()[:size])
    with refused(Kind.UNREADABLE, file=path):
        read_mat(path, "a MAT file", Refusal)


def test_what_is_no_plain_array_is_passed_over(tmp_path: Path) -> None:
    path = tmp_path / "given.mat"
    thin = scipy.sparse.coo_array(([1.0], ([0], [0])), (10**6, 10**6))
    for packed in (False, True):
        content = {"thin": thin, "a": np.ones(3), "told": {"by": "whom"}, "word": "x", "cells": np.array([1, "a"], "O")}
        scipy.io.savemat(path, content, do_compression=packed)
        assert list(read_mat(path, "a MAT file", Refusal)) == ["a", "word"]


def test_damage_at_any_place_of_a_mat_file_ends_in_a_refusal_or_in_numbers(tmp_path: Path) -> None:
    """SciPy ends the whole program at some of it."""
    path = tmp_path / "given.mat"
    scipy.io.savemat(path, {"rate": 1000.0, "a": np.ones(3) + 1j})
    whole = path.read_bytes()
    found = 0
    for place in range(124, len(whole)):
        for value in (127, 255):
            path.write_bytes(whole[:place] + bytes([value]) + whole[place + 1 :])
            try:
                read_mat(path, "a MAT file", Refusal)
            except Refusal:
                found += 1
    assert found > 50


def test_what_was_saved_is_read(tmp_path: Path) -> None:
    np.savez(tmp_path / "plain.npz", **ARRAYS)  # type: ignore[arg-type]
    np.savez_compressed(tmp_path / "packed.npz", **ARRAYS)  # type: ignore[arg-type]
    for name in ("plain.npz", "packed.npz"):
        found = read_npz(tmp_path / name, "a file", Refusal)
        assert list(found) == list(ARRAYS)
        for key, values in ARRAYS.items():
            np.testing.assert_array_equal(found[key], values)
            assert found[key].dtype == values.dtype
    for version in ("4", "5"):
        for packed in (False, version == "5"):
            saved = {"a": ARRAYS["a"], "small": np.array([[1, 2]], np.int8), "turn": np.array([[1j, 2.0]])}
            scipy.io.savemat(tmp_path / "m.mat", saved, format=version, do_compression=packed)
            found = read_mat(tmp_path / "m.mat", "a file", Refusal)
            for key, values in saved.items():
                np.testing.assert_array_equal(found[key], values)
