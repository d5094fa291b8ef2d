"""Records, sealed descriptions and sealed files: whatever is damaged, moved or of another version is not taken."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from damage import damaged

from geometry.ground.record import (
    file_is_sealed,
    is_sealed,
    packed,
    read_record,
    seal_file,
    sealed,
    sha256,
    unpacked,
    write_record,
)
from geometry.ground.refusal import Kind, Refusal

CONTENT = bytes(range(256)) * 3


def refused(path: Path, kind: str = "cell 2", key: str = "a") -> Kind:
    with pytest.raises(Refusal) as error:
        read_record(path, kind, key, Refusal)
    assert str(error.value).startswith(f"{path}: ")
    return error.value.kind


def test_a_record_gives_back_what_was_written_and_nothing_is_left_beside_it(tmp_path: Path) -> None:
    write_record(tmp_path / "r", "cell 2", "a", b"")
    assert read_record(tmp_path / "r", "cell 2", "a", Refusal) == b""
    write_record(tmp_path / "r", "cell 2", "a", CONTENT)
    assert read_record(tmp_path / "r", "cell 2", "a", Refusal) == CONTENT
    assert [path.name for path in tmp_path.iterdir()] == ["r"]


def test_a_record_under_another_key_or_of_another_version_is_not_taken(tmp_path: Path) -> None:
    write_record(tmp_path / "r", "cell 2", "a", CONTENT)
    assert refused(tmp_path / "r", key="b") is Kind.DAMAGED
    assert refused(tmp_path / "r", kind="disc 2") is Kind.DAMAGED
    with pytest.raises(Refusal, match="is of format 2; this version of the program reads format 3") as error:
        read_record(tmp_path / "r", "cell 3", "a", Refusal)
    assert error.value.kind is Kind.MISMATCH


def test_every_damage_to_a_record_is_noticed(tmp_path: Path) -> None:
    write_record(tmp_path / "r", "cell 2", "a", CONTENT)
    for done in damaged(tmp_path, 200, 1):
        assert refused(tmp_path / "r") in (Kind.DAMAGED, Kind.MISMATCH), done
    assert read_record(tmp_path / "r", "cell 2", "a", Refusal) == CONTENT


def test_arrays_and_values_are_packed_the_same_way_every_time() -> None:
    arrays = {"x": np.array([1.5, np.nan]), "h": np.ones((2, 0, 3), complex)}
    content = packed(arrays, {"name": "point 1 µ"})
    assert content == packed(arrays, {"name": "point 1 µ"})
    found, about = unpacked(content)
    assert about == {"name": "point 1 µ"}
    assert all(np.array_equal(found[name], arrays[name], equal_nan=True) for name in arrays)
    assert found["h"].shape == (2, 0, 3)


def test_a_sealed_description_covers_its_fields_and_what_it_describes() -> None:
    said = json.loads(json.dumps(sealed({"b": 1, "a": [2.5]}, CONTENT)))
    assert is_sealed(said, CONTENT)
    assert not is_sealed(said, CONTENT[1:])
    assert not is_sealed({**said, "b": 2}, CONTENT)
    assert not is_sealed({"b": 1, "a": [2.5]}, CONTENT)
    assert said["sha256"] == sha256('{"a": [2.5], "b": 1}\n', CONTENT)


def test_a_sealed_file_is_intact_damaged_or_of_another_program(tmp_path: Path) -> None:
    path = tmp_path / "f"
    path.write_bytes(CONTENT)
    assert file_is_sealed(path) is None
    seal_file(path)
    assert file_is_sealed(path) is True
    assert path.read_bytes().startswith(CONTENT)
    path.write_bytes(b"x" + path.read_bytes()[1:])
    assert file_is_sealed(path) is False
    path.write_bytes(b"")
    assert file_is_sealed(path) is None
