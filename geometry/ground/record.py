"""Records: bytes under a key whose damage is noticed, because a SHA-256 of key and content stands with them.

Everything that this project writes to read again stands on this one hash, in one of three forms. A *record* is a file
of its own: a line with its kind, a line with the hash, the content; it is written beside and renamed, so that it is
whole or not there. A *sealed description* is a JSON object that carries the hash of its other fields and of what it
describes. A *sealed file* belongs to a format of other programs, which read past the hash at its end.
"""

from __future__ import annotations

import hashlib
import io
import json
import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from geometry.ground.file_checks import read_bytes
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.whole_files import whole_file

SEAL = "sha256"
"""Field of a sealed description that holds its hash."""
_PROGRAM = "acoustic-fem "
_MARK = b"\nacoustic-fem sha256 "
_TAIL = len(_MARK) + 64 + 1


def sha256(*parts: str | bytes | memoryview) -> str:
    """Hexadecimal SHA-256 of texts and bytes one after the other."""
    digest = hashlib.sha256()
    for part in parts:
        digest.update(part.encode() if isinstance(part, str) else part)
    return digest.hexdigest()


# -- records ------------------------------------------------------------------------------------------------
def write_record(path: str | os.PathLike[str], kind: str, key: str, content: bytes) -> None:
    """Write a record, whole or not at all; an earlier one is replaced.

    Args:
        path: the file; its folder must exist.
        kind: what the content is and the version of its format, such as ``cell 2``.
        key: what the content is kept under; the file is refused under any other.
        content: what is kept.

    Raises:
        OSError: the disk is full, or the folder cannot be written.
    """
    digest = sha256(key, b"\n", content)
    with whole_file(path) as beside, beside.open("wb") as file:
        file.writelines((f"{_PROGRAM}{kind}\n{digest}\n".encode(), content))


def read_record(path: str | os.PathLike[str], kind: str, key: str, refusal: type[Refusal]) -> bytes:
    """Content of a record, which is what was written under this key.

    Args:
        path: the file.
        kind: as it was written with.
        key: as it was written with.
        refusal: class of the error.

    Raises:
        Refusal: of that class: no such file, one that cannot be read, one of another version, or one that is damaged.
    """
    raw = read_bytes(path, f"a record ({kind})", refusal)
    first, _, rest = raw.partition(b"\n")
    name, _, version = kind.rpartition(" ")
    found = first.decode("latin-1").removeprefix(f"{_PROGRAM}{name} ")
    if found.isdecimal() and found != version:
        raise refusal(
            f"is of format {found}; this version of the program reads format {version}", kind=Kind.MISMATCH, file=path
        )
    digest, _, content = rest.partition(b"\n")
    if found != version or digest.decode("latin-1") != sha256(key, b"\n", content):
        raise refusal("is damaged: its SHA-256 differs from the recorded one", kind=Kind.DAMAGED, file=path)
    return content


def packed(arrays: Mapping[str, NDArray[Any]], about: Mapping[str, Any]) -> bytes:
    """Arrays of any shape, and plain values, as the content of a record; :func:`unpacked` is the way back."""
    buffer = io.BytesIO()
    named: dict[str, Any] = {**arrays, "about": np.array(json.dumps(about))}
    np.savez(buffer, **named)
    return buffer.getvalue()


def unpacked(content: bytes) -> tuple[dict[str, NDArray[Any]], dict[str, Any]]:
    """Arrays, of the shape of what :func:`packed` took, and plain values."""
    with np.load(io.BytesIO(content), allow_pickle=False) as archive:
        arrays = {name: archive[name] for name in archive.files}
    return arrays, json.loads(str(arrays.pop("about")))


# -- descriptions -------------------------------------------------------------------------------------------
def sealed(description: Mapping[str, Any], content: bytes = b"") -> dict[str, Any]:
    """A description with the hash of its other fields, and of the content that it describes."""
    return {**description, SEAL: _hash(description, content)}


def is_sealed(description: Mapping[str, Any], content: bytes = b"") -> bool:
    """True if a description and its content are as :func:`sealed` left them."""
    own = {name: value for name, value in description.items() if name != SEAL}
    return description.get(SEAL) == _hash(own, content)


def _hash(description: Mapping[str, Any], content: bytes) -> str:
    return sha256(json.dumps(description, sort_keys=True, ensure_ascii=True), b"\n", content)


# -- files of other programs ----------------------------------------------------------------------------------
def seal_file(path: Path) -> None:
    """Put the hash of a complete file at its end."""
    with path.open("r+b") as file:
        digest = hashlib.file_digest(file, "sha256").hexdigest()
        file.seek(0, os.SEEK_END)
        file.write(_MARK + digest.encode() + b"\n")


def file_is_sealed(path: Path) -> bool | None:
    """True if a file is as :func:`seal_file` left it; None where it has no hash, as where another program wrote it."""
    left = path.stat().st_size - _TAIL
    with path.open("rb") as file:
        file.seek(max(left, 0))
        tail = file.read()
        if not tail.startswith(_MARK):
            return None
        file.seek(0)
        digest = hashlib.sha256()
        while left > 0 and (piece := file.read(min(left, 1 << 20))):
            digest.update(piece)
            left -= len(piece)
    return tail[len(_MARK) :].strip() == digest.hexdigest().encode()
